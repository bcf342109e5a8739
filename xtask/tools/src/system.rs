//! What differs between the systems on which the commands run: how programs are found.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// A family of systems. A parameter of what depends on it, so that tests see all of them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum System {
    /// Linux, and every other one whose programs are found as there.
    Linux,
    /// macOS.
    Mac,
    /// Windows.
    Windows,
}

impl System {
    /// The system of this program.
    pub const HERE: Self = if cfg!(windows) {
        Self::Windows
    } else if cfg!(target_os = "macos") {
        Self::Mac
    } else {
        Self::Linux
    };

    /// The ends of the names of programs. On Windows a file without one is no program: beside `npm.cmd`
    /// is a file `npm`, a script for another system's shell. Of the ends in `PATHEXT` these are what
    /// [`Command`](std::process::Command) starts; it gives the last two to the shell.
    fn suffixes(self) -> &'static [&'static str] {
        match self {
            Self::Linux | Self::Mac => &[""],
            Self::Windows => &[".exe", ".cmd", ".bat"],
        }
    }

    /// The first of these programs that is a file in one of the folders.
    pub(crate) fn program(self, names: &[&str], folders: &[PathBuf]) -> Option<PathBuf> {
        for name in names {
            for folder in folders {
                let mut files = self.suffixes().iter().map(|end| folder.join(format!("{name}{end}")));
                if let Some(file) = files.find(|file| file.is_file()) {
                    return Some(file);
                }
            }
        }
        None
    }

    /// The folders into which installers put programs that they do not put on PATH. `variable` is that of
    /// the environment.
    pub(crate) fn installed(self, variable: impl Fn(&str) -> Option<OsString>) -> Vec<PathBuf> {
        let named = |name: &&str| variable(name).map(PathBuf::from);
        match self {
            Self::Linux => Vec::new(),
            Self::Mac => {
                let own = variable("HOME").map(|home| Path::new(&home).join("Applications"));
                [Some("/Applications".into()), own].into_iter().flatten().collect()
            }
            Self::Windows => {
                ["ProgramFiles", "ProgramFiles(x86)", "LocalAppData"].iter().filter_map(named).collect()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn programs_are_found_by_the_names_that_the_system_starts() {
        let [first, second] = [(); 2].map(|()| tempfile::tempdir().unwrap());
        let folders = [&first, &second].map(|folder| folder.path().to_owned());
        for (folder, name) in [(0, "npm"), (0, "npm.ps1"), (1, "npm.cmd"), (1, "node.exe"), (1, "nodejs")] {
            fs::write(folders[folder].join(name), "").unwrap();
        }
        fs::create_dir(folders[0].join("node.exe")).unwrap();
        let find = |system: System, names: &[&str]| {
            let file = system.program(names, &folders)?;
            Some(file.strip_prefix(file.ancestors().nth(2).unwrap()).unwrap().file_name()?.to_owned())
        };
        for (system, names, file) in [
            (System::Linux, &["npm"][..], Some("npm")),
            (System::Linux, &["node", "nodejs"], Some("nodejs")),
            (System::Windows, &["npm"], Some("npm.cmd")),
            (System::Windows, &["nodejs", "node"], Some("node.exe")),
            (System::Windows, &["nodejs"], None),
            (System::Mac, &["npm.cmd", "npm"], Some("npm.cmd")),
        ] {
            assert_eq!(find(system, names).as_deref(), file.map(AsRef::as_ref), "{system:?}: {names:?}");
        }
    }
}
