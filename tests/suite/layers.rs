//! The crates have no import cycle. `lib.rs` states an order of the modules, lowest first, and each
//! module imports only from modules before it in that order.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The code of a file, without comments and tests.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a listed file can be read");
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    code.take_while(|line| !line.starts_with("#[cfg(test)]") && !line.starts_with("#[cfg(all(test"))
        .collect::<Vec<_>>()
        .join("\n")
}

/// The top-level modules that code imports from: the first names of all paths from `crate`.
fn imports(code: &str) -> BTreeSet<String> {
    let name = |text: &str| {
        text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>()
    };
    let mut found = BTreeSet::new();
    for rest in code.split("crate::").skip(1) {
        let Some(list) = rest.strip_prefix('{') else {
            found.insert(name(rest));
            continue;
        };
        // The names at the outermost level of the braces.
        let (mut depth, mut start) = (0, 0);
        for (i, c) in list.char_indices() {
            match c {
                '{' => depth += 1,
                '}' | ',' if depth == 0 => {
                    found.insert(name(&list[start..i]));
                    start = i + 1;
                }
                '}' => depth -= 1,
                _ => {}
            }
            if c == '}' && depth == 0 && start == i + 1 {
                break;
            }
        }
    }
    found
}

/// Every file of a module: `name.rs`, and the files in the folder `name` except `tests.rs` and
/// those in a folder `tests`.
fn files(src: &Path, module: &str) -> Vec<std::path::PathBuf> {
    let mut files = vec![src.join(format!("{module}.rs"))];
    let mut folders = vec![src.join(module)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.extend((!path.ends_with("tests")).then_some(path));
            } else if path.file_name().is_some_and(|name| name != "tests.rs") {
                files.push(path);
            }
        }
    }
    files
}

fn assert_layered(crate_folder: &str) {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join(crate_folder).join("src");
    let root = fs::read_to_string(src.join("lib.rs")).expect("every crate has a root");
    let (_, stated) = root.split_once("Modules, lowest first:").expect("the root states the order");
    let stated = stated.split("\n\n").next().unwrap_or_default().split("#![").next().unwrap_or_default();
    let order: Vec<_> = stated.split('`').skip(1).step_by(2).collect();
    let declared: BTreeSet<_> = root
        .lines()
        .filter_map(|line| line.trim_start_matches("pub ").strip_prefix("mod ")?.strip_suffix(';'))
        .collect();
    assert_eq!(order.iter().copied().collect::<BTreeSet<_>>(), declared, "{crate_folder}: the stated order");
    for (i, module) in order.iter().enumerate() {
        for path in files(&src, module) {
            let upwards: Vec<_> = imports(&code(&path))
                .into_iter()
                .filter(|name| order[i + 1..].contains(&name.as_str()))
                .collect();
            assert!(upwards.is_empty(), "{} imports {upwards:?}, stated above it", path.display());
        }
    }
}

#[test]
fn modules_of_the_kernel_import_only_lower_ones() {
    assert_layered("core");
}

#[test]
fn modules_of_the_renderer_import_only_lower_ones() {
    assert_layered("render");
}

#[test]
fn imports_are_found_in_every_form() {
    let found = imports("use crate::{a::{x, y}, b, c::d};\ncrate::e::f(); $crate::g::h!()");
    assert_eq!(found.into_iter().collect::<Vec<_>>(), ["a", "b", "c", "e", "g"]);
}
