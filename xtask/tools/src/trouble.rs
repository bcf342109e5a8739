//! Why a program has failed for a reason that is not its own: a full disk, a folder that cannot be written,
//! no network. The cause may be hundreds of lines above the last one, which names it with the remedy.

use anyhow::Error;

use crate::project;
use crate::system::System;

/// A cause.
struct Trouble {
    /// What programs write of it.
    signs: &'static [&'static str],
    /// Its number on Windows, whose words depend on the language.
    windows: &'static str,
    remedy: &'static str,
    /// Whether the remedy is to build in a different folder.
    is_of_target: bool,
}

const TROUBLES: [Trouble; 3] = [
    Trouble {
        // A linker maps the file that it writes into memory, so that it ends by a signal.
        signs: &["No space left on device", "ENOSPC", "Disk quota exceeded", "Bus error", "SIGBUS"],
        windows: "(os error 112)",
        remedy: "the disk is full: free some room, or name a folder on another disk by CARGO_TARGET_DIR",
        is_of_target: true,
    },
    Trouble {
        signs: &["Read-only file system", "EROFS"],
        windows: "(os error 19)",
        remedy: "it cannot be written: name another folder by CARGO_TARGET_DIR",
        is_of_target: true,
    },
    Trouble {
        signs: &[
            "Could not resolve host",
            "Could not connect to server",
            "Timeout was reached",
            "Temporary failure resolving",
            "Temporary failure in name resolution",
            "Network is unreachable",
            "EAI_AGAIN",
            "ENETUNREACH",
            "ENOTFOUND",
            "ETIMEDOUT",
        ],
        windows: "(os error 11001)",
        remedy: "there is no network: what is missing is downloaded once, so call this again with one",
        is_of_target: false,
    },
];

/// The remedy for the first trouble of which a text has a sign.
pub(crate) fn remedy(text: &str, system: System) -> Option<String> {
    let is_meant = |trouble: &&Trouble| {
        trouble.signs.iter().any(|sign| text.contains(sign))
            || system == System::Windows && text.contains(trouble.windows)
    };
    let Trouble { remedy, is_of_target, .. } = TROUBLES.iter().find(is_meant)?;
    let target = is_of_target.then(|| format!(", now {}", project::target().display()));
    Some(format!("{remedy}{}", target.unwrap_or_default()))
}

/// An error in words, with the remedy for the trouble of which it has a sign.
pub fn explained(error: &Error) -> String {
    let text = format!("{error:#}");
    let remedy = remedy(&text, System::HERE);
    remedy.map_or_else(|| text.clone(), |remedy| format!("{text}: {remedy}"))
}

#[cfg(test)]
mod tests {
    use anyhow::anyhow;

    use super::*;

    #[test]
    fn a_trouble_is_named_with_its_remedy() {
        for (text, words) in [
            (
                "error: failed to build archive at `libcore.rlib`: No space left on device (os error 28)",
                "disk is full",
            ),
            ("collect2: fatal error: ld terminated with signal 7 [Bus error], core dumped", "disk is full"),
            ("npm error code ENOSPC", "disk is full"),
            ("cannot write ../demo.lock: Read-only file system (os error 30)", "cannot be written"),
            ("[6] Could not resolve hostname (Could not resolve host: example.org)", "no network"),
            ("npm error errno EAI_AGAIN", "no network"),
            ("W: Failed to fetch a file  Temporary failure resolving 'example.org'", "no network"),
        ] {
            let found = remedy(text, System::Linux).unwrap_or_default();
            assert!(found.contains(words), "{text}: {found}");
            let told = explained(&anyhow!("{text}"));
            assert!(told.starts_with(text) && told.ends_with(&found), "{told}");
        }
        let windows = "Es steht nicht genug Speicherplatz auf dem Datenträger zur Verfügung. (os error 112)";
        assert!(remedy(windows, System::Windows).unwrap().contains("disk is full"));
        assert_eq!(remedy(windows, System::Linux), None);
        assert_eq!(
            explained(&anyhow!("could not compile `core`").context("cargo failed")),
            "cargo failed: could not compile `core`"
        );
    }
}
