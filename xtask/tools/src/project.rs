//! The paths of the project's files.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{env, fs, io, path};

use anyhow::{Context, Result};

/// The workspace's folder.
pub fn root() -> &'static Path {
    let tools = Path::new(env!("CARGO_MANIFEST_DIR"));
    tools.ancestors().nth(2).unwrap_or(tools)
}

/// The folder of everything that is built: `target`, or the folder that `CARGO_TARGET_DIR` names.
pub fn target() -> PathBuf {
    match env::var_os("CARGO_TARGET_DIR") {
        Some(folder) if !folder.is_empty() => path::absolute(&folder).unwrap_or_else(|_| folder.into()),
        _ => root().join("target"),
    }
}

/// All files below a folder, by their path relative to it, with their content. Files and folders
/// whose path ends with one of `left_out` are left out.
pub fn files(folder: &Path, left_out: &[&str]) -> Result<BTreeMap<PathBuf, Vec<u8>>> {
    let (mut files, mut folders) = (BTreeMap::new(), vec![PathBuf::new()]);
    while let Some(inner) = folders.pop() {
        let place = folder.join(&inner);
        for entry in fs::read_dir(&place).with_context(|| format!("cannot read {}", shown(&place)))? {
            let entry = entry?;
            let path = inner.join(entry.file_name());
            if left_out.iter().any(|name| path.ends_with(name)) {
                continue;
            }
            if entry.file_type()?.is_dir() {
                folders.push(path);
            } else {
                let content = fs::read(folder.join(&path));
                files.insert(path, content.with_context(|| format!("cannot read {}", shown(&place)))?);
            }
        }
    }
    Ok(files)
}

/// Makes a folder hold these files and no others. Files that are as they should be are left alone,
/// so that they are not compiled again; so is what `left_out` names.
pub fn mirror(files: &BTreeMap<PathBuf, Vec<u8>>, folder: &Path, left_out: &[&str]) -> Result<()> {
    fs::create_dir_all(folder)?;
    let mut present = self::files(folder, left_out)?;
    for (path, bytes) in files {
        if present.remove(path).as_ref() != Some(bytes) {
            let path = folder.join(path);
            fs::create_dir_all(path.parent().unwrap_or(&path))?;
            fs::write(path, bytes)?;
        }
    }
    present.keys().try_for_each(|stale| fs::remove_file(folder.join(stale)))?;
    Ok(())
}

/// Adds the files of a folder to another, which may have others and be in use.
pub fn add(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    files(from, &[])?.iter().try_for_each(|(name, content)| replace(&to.join(name), content))
}

/// Writes a file in one step, because it may be in use.
pub fn replace(file: &Path, content: &[u8]) -> Result<()> {
    let mut new = file.as_os_str().to_owned();
    new.push(".new");
    fs::write(&new, content)
        .and_then(|()| fs::rename(&new, file))
        .with_context(|| format!("cannot write {}", file.display()))
}

/// Fills a new folder, and replaces `folder` by it once it is complete, because `folder` may be in
/// use.
pub fn renew(folder: &Path, fill: impl FnOnce(&Path) -> Result<()>) -> Result<()> {
    let new = folder.with_extension("new");
    // An interrupted build may have left a new folder.
    remove(&new)?;
    fill(&new)?;
    remove(folder)?;
    fs::rename(&new, folder).with_context(|| format!("cannot replace {}", folder.display()))
}

/// Removes a folder, if it is there.
pub fn remove(folder: &Path) -> Result<()> {
    match fs::remove_dir_all(folder) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => {
            Err(error).with_context(|| format!("cannot remove {}", shown(folder)))
        }
        _ => Ok(()),
    }
}

/// The CRC-32 of files and their names, which is the same on every system.
pub fn checksum(files: &BTreeMap<PathBuf, Vec<u8>>) -> u32 {
    let names = files.keys().map(|path| path.to_string_lossy().replace('\\', "/").into_bytes());
    let mut crc = u32::MAX;
    for byte in names.zip(files.values()).flat_map(|(name, content)| [name, content.clone()].concat()) {
        crc ^= u32::from(byte);
        for _ in 0..8 {
            crc = (crc >> 1) ^ (0xedb8_8320 & (crc & 1).wrapping_neg());
        }
    }
    !crc
}

/// Displays a path, relative to the workspace if it is below it.
pub fn shown(path: &Path) -> path::Display<'_> {
    path.strip_prefix(root()).unwrap_or(path).display()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_renewed_whole_or_not_at_all() {
        let temporary = tempfile::tempdir().unwrap();
        let folder = temporary.path().join("demo");
        let page = || fs::read_to_string(folder.join("index.html")).unwrap();
        let write = |new: &Path, text: &str| {
            fs::create_dir(new)?;
            Ok(fs::write(new.join("index.html"), text)?)
        };
        renew(&folder, |new| write(new, "first")).unwrap();
        let failed = renew(&folder, |new| {
            write(new, "half")?;
            anyhow::bail!("no module")
        });
        assert_eq!((failed.unwrap_err().to_string().as_str(), page().as_str()), ("no module", "first"));
        renew(&folder, |new| write(new, "second")).unwrap();
        assert_eq!(page(), "second");
    }
}
