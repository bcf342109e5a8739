//! No crate of the project has an import cycle between its files, and the modules of a crate whose
//! root states an order of them, lowest first, import only from modules before them.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use crate::graph::Graph;
use crate::listing::files;

/// The root files of all crates of the repository that have more than one file.
fn roots() -> Vec<PathBuf> {
    files(&["*src/lib.rs", "*src/main.rs", "tests/*/main.rs"])
}

#[test]
fn files_of_a_crate_have_no_import_cycle() {
    let roots = roots();
    assert!(roots.len() > 20, "expected all crates, found {}", roots.len());
    let found: String =
        roots.iter().flat_map(|root| Graph::of(root).cycles()).map(|(_, text)| text).collect();
    assert!(found.is_empty(), "expected no import cycle, found\n{found}");
}

/// The order of the modules that a root file states in a comment, or nothing.
fn stated_order(root: &Path) -> Option<Vec<String>> {
    let text = fs::read_to_string(root).expect("a listed file can be read");
    let (_, stated) = text.split_once("Modules, lowest first:")?;
    let stated = stated.split("\n\n").next()?.split("#![").next()?;
    Some(stated.split('`').skip(1).step_by(2).map(str::to_owned).collect())
}

#[test]
fn modules_import_only_from_those_stated_before_them() {
    let mut checked = 0;
    for root in roots() {
        let Some(order) = stated_order(&root) else { continue };
        checked += 1;
        let graph = Graph::of(&root);
        let places: BTreeMap<_, _> = order.iter().enumerate().map(|(i, name)| (name.as_str(), i)).collect();
        let stated: BTreeSet<_> = places.keys().copied().collect();
        assert_eq!(stated, graph.top(), "the order that {} states", root.display());
        for (from, to) in graph.between_top() {
            assert!(
                places[from] > places[to],
                "{}: `{from}` imports `{to}`, stated above it",
                root.display()
            );
        }
    }
    assert!(checked >= 2, "expected at least the kernel and the renderer, found {checked} stated orders");
}
