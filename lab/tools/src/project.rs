//! Where the project's files are.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{env, fs, io, path};

use anyhow::{Context, Result};

/// The workspace's folder.
pub fn root() -> &'static Path {
    let tools = Path::new(env!("CARGO_MANIFEST_DIR"));
    tools.ancestors().nth(2).unwrap_or(tools)
}

/// The folder of everything that is built: `target`, or wherever `CARGO_TARGET_DIR` puts it.
pub fn target() -> PathBuf {
    match env::var_os("CARGO_TARGET_DIR") {
        Some(folder) if !folder.is_empty() => path::absolute(&folder).unwrap_or_else(|_| folder.into()),
        _ => root().join("target"),
    }
}

/// All files below a folder with their content, by their paths in it, without files and folders
/// whose path ends with one of `left_out`.
pub fn files(folder: &Path, left_out: &[&str]) -> Result<BTreeMap<PathBuf, Vec<u8>>> {
    fn list(
        root: &Path,
        folder: &Path,
        left_out: &[&str],
        files: &mut BTreeMap<PathBuf, Vec<u8>>,
    ) -> io::Result<()> {
        for entry in fs::read_dir(root.join(folder))? {
            let entry = entry?;
            let path = folder.join(entry.file_name());
            if left_out.iter().any(|name| path.ends_with(name)) {
                continue;
            }
            if entry.file_type()?.is_dir() {
                list(root, &path, left_out, files)?;
            } else {
                let content = fs::read(root.join(&path))?;
                files.insert(path, content);
            }
        }
        Ok(())
    }
    let mut files = BTreeMap::new();
    list(folder, Path::new(""), left_out, &mut files)
        .with_context(|| format!("cannot read {}", shown(folder)))?;
    Ok(files)
}

/// Displays a path, relative to the workspace if it is below it.
pub fn shown(path: &Path) -> path::Display<'_> {
    path.strip_prefix(root()).unwrap_or(path).display()
}
