//! What Rust source declares: its public functions, its implementations of traits, and its tests.

use std::fs;
use std::path::{Path, PathBuf};

use syn::{ImplItem, Item, TraitItem, Type, Visibility};

/// A Rust file and where it is, from the root of the workspace.
pub(crate) struct Source {
    pub(crate) path: String,
    pub(crate) text: String,
    items: Vec<Item>,
}

/// Every Rust file of a folder and of the folders in it, in the order of their paths.
pub(crate) fn files(folder: &str) -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths = Vec::new();
    collect(&root.join(folder), &mut paths);
    paths.sort();
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).expect("a file that is listed can be read");
        let items =
            syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display())).items;
        let within = path.strip_prefix(root).expect("it was found within the root");
        let names: Vec<_> = within.iter().map(|name| name.to_string_lossy()).collect();
        Source { path: names.join("/"), text, items }
    };
    paths.into_iter().map(read).collect()
}

fn collect(folder: &Path, paths: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
        let path = entry.expect("a folder that opens can be listed").path();
        if path.is_dir() {
            collect(&path, paths);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            paths.push(path);
        }
    }
}

impl Source {
    /// Every public function and method, as `function`, `Type::method` or `Trait::method`; the methods that a
    /// macro writes as `macro!::method`. Every implementation of one of the traits `kinds`, as `Trait for
    /// Type`.
    pub(crate) fn declarations(&self, kinds: &[&str]) -> Vec<String> {
        let mut found = Vec::new();
        declared(&self.items, kinds, &mut found);
        found
    }

    /// Every test, as `path::name`.
    pub(crate) fn tests(&self) -> Vec<String> {
        let mut found = Vec::new();
        tests(&self.items, &mut found);
        found.into_iter().map(|name| format!("{}::{name}", self.path)).collect()
    }
}

fn declared(items: &[Item], kinds: &[&str], found: &mut Vec<String>) {
    for item in items {
        match item {
            Item::Fn(function) if is_public(&function.vis) => found.push(function.sig.ident.to_string()),
            Item::Trait(declaration) if is_public(&declaration.vis) => {
                let methods = declaration.items.iter().filter_map(|item| match item {
                    TraitItem::Fn(method) => Some(format!("{}::{}", declaration.ident, method.sig.ident)),
                    _ => None,
                });
                found.extend(methods);
            }
            Item::Impl(implementation) => {
                let of = type_name(&implementation.self_ty);
                if let Some((path, _)) = &implementation.trait_ {
                    let kind = path.segments.last().expect("a path has a name").ident.to_string();
                    if kinds.contains(&kind.as_str()) {
                        found.push(format!("{kind} for {of}"));
                    }
                    continue;
                }
                let methods = implementation.items.iter().filter_map(|item| match item {
                    ImplItem::Fn(method) if is_public(&method.vis) => {
                        Some(format!("{of}::{}", method.sig.ident))
                    }
                    _ => None,
                });
                found.extend(methods);
            }
            Item::Macro(definition) => {
                let Some(name) = &definition.ident else { continue };
                let methods = public_functions(&definition.mac.tokens.to_string());
                found.extend(methods.into_iter().map(|method| format!("{name}!::{method}")));
            }
            Item::Mod(module) => {
                declared(module.content.as_ref().map_or(&[], |(_, items)| items), kinds, found);
            }
            _ => {}
        }
    }
}

fn tests(items: &[Item], found: &mut Vec<String>) {
    for item in items {
        match item {
            Item::Fn(function)
                if function.attrs.iter().any(|attribute| attribute.path().is_ident("test")) =>
            {
                found.push(function.sig.ident.to_string());
            }
            Item::Mod(module) => {
                tests(module.content.as_ref().map_or(&[], |(_, items)| items), found);
            }
            _ => {}
        }
    }
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// The name of a type without its path and its parameters.
fn type_name(of: &Type) -> String {
    match of {
        Type::Path(path) => path.path.segments.last().expect("a path has a name").ident.to_string(),
        Type::Tuple(_) => "a tuple".into(),
        Type::Array(_) => "an array".into(),
        _ => panic!("an implementation for what has no name"),
    }
}

/// The names after `pub fn` in the text of a macro.
fn public_functions(tokens: &str) -> Vec<String> {
    let words: Vec<_> =
        tokens.split(|c: char| !(c.is_alphanumeric() || c == '_')).filter(|w| !w.is_empty()).collect();
    words.windows(3).filter(|w| w[0] == "pub" && w[1] == "fn").map(|w| w[2].to_string()).collect()
}
