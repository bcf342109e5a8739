//! Where things are.

use std::path::{Path, PathBuf};
use std::{env, path};

/// The workspace's folder.
pub(crate) fn root() -> &'static Path {
    let xtask = Path::new(env!("CARGO_MANIFEST_DIR"));
    xtask.parent().unwrap_or(xtask)
}

/// The folder of everything that is built: `target`, or wherever `CARGO_TARGET_DIR` puts it.
pub(crate) fn target() -> PathBuf {
    match env::var_os("CARGO_TARGET_DIR") {
        Some(folder) if !folder.is_empty() => path::absolute(&folder).unwrap_or_else(|_| folder.into()),
        _ => root().join("target"),
    }
}

/// Displays a path, relative to the workspace if it is below it.
pub(crate) fn shown(path: &Path) -> path::Display<'_> {
    path.strip_prefix(root()).unwrap_or(path).display()
}
