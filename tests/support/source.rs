//! What Rust source declares: its public functions, its implementations of traits, and its tests.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use syn::visit::{self, Visit};
use syn::{Block, Expr, ExprMethodCall, ExprPath, ImplItem, Item, TraitItem, Type, Visibility};

/// A Rust file and where it is, from the root of the workspace.
pub(crate) struct Source {
    pub(crate) path: String,
    pub(crate) text: String,
    items: Vec<Item>,
}

/// Something that is declared for others.
pub(crate) struct Declaration {
    /// `function`, `Type::method` or `Trait::method`; of a method that a macro writes `macro!::method`, and of an
    /// implementation of a trait `Trait for Type`.
    pub(crate) name: String,
    /// Whether it does more than to store and to give back.
    pub(crate) computes: bool,
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
    /// Every public function and method, and every implementation of one of the traits `kinds`.
    pub(crate) fn declarations(&self, kinds: &[&str]) -> Vec<Declaration> {
        let mut found = Vec::new();
        declared(&self.items, kinds, &mut found);
        found
    }

    /// What the file calls or names as a value: `function`, `Type::method` where the type is named, and `.method`.
    pub(crate) fn calls(&self) -> BTreeSet<String> {
        let mut calls = Calls::default();
        self.items.iter().for_each(|item| calls.visit_item(item));
        calls.0
    }

    /// Every test, as `path::name`.
    pub(crate) fn tests(&self) -> Vec<String> {
        let mut found = Vec::new();
        tests(&self.items, &mut found);
        found.into_iter().map(|name| format!("{}::{name}", self.path)).collect()
    }
}

fn declare(found: &mut Vec<Declaration>, name: String, computes: bool) {
    found.push(Declaration { name, computes });
}

fn declared(items: &[Item], kinds: &[&str], found: &mut Vec<Declaration>) {
    for item in items {
        match item {
            Item::Fn(function) if is_public(&function.vis) => {
                declare(found, function.sig.ident.to_string(), computes(&function.block));
            }
            Item::Trait(declaration) if is_public(&declaration.vis) => {
                for item in &declaration.items {
                    let TraitItem::Fn(method) = item else { continue };
                    declare(found, format!("{}::{}", declaration.ident, method.sig.ident), true);
                }
            }
            Item::Impl(implementation) => {
                let of = type_name(&implementation.self_ty);
                if let Some((path, _)) = &implementation.trait_ {
                    let kind = path.segments.last().expect("a path has a name").ident.to_string();
                    if kinds.contains(&kind.as_str()) {
                        declare(found, format!("{kind} for {of}"), true);
                    }
                    continue;
                }
                for item in &implementation.items {
                    match item {
                        ImplItem::Fn(method) if is_public(&method.vis) => {
                            declare(found, format!("{of}::{}", method.sig.ident), computes(&method.block));
                        }
                        _ => {}
                    }
                }
            }
            Item::Macro(definition) => {
                let Some(name) = &definition.ident else { continue };
                for method in public_functions(&definition.mac.tokens.to_string()) {
                    declare(found, format!("{name}!::{method}"), true);
                }
            }
            Item::Mod(module) => {
                declared(module.content.as_ref().map_or(&[], |(_, items)| items), kinds, found);
            }
            _ => {}
        }
    }
}

/// Whether a function does more than to store and to give back: it has an expression of another kind.
fn computes(block: &Block) -> bool {
    struct Computes(bool);
    impl Visit<'_> for Computes {
        fn visit_expr(&mut self, expression: &Expr) {
            match expression {
                Expr::Path(_)
                | Expr::Field(_)
                | Expr::Struct(_)
                | Expr::Array(_)
                | Expr::Reference(_)
                | Expr::Lit(_) => visit::visit_expr(self, expression),
                _ => self.0 = true,
            }
        }

        fn visit_macro(&mut self, _: &syn::Macro) {
            self.0 = true;
        }
    }
    let mut found = Computes(false);
    found.visit_block(block);
    found.0
}

/// What is called.
#[derive(Default)]
struct Calls(BTreeSet<String>);

impl Visit<'_> for Calls {
    fn visit_expr_path(&mut self, named: &ExprPath) {
        let names: Vec<_> = named.path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        self.0.insert(names[names.len().saturating_sub(2)..].join("::"));
        visit::visit_expr_path(self, named);
    }

    fn visit_expr_method_call(&mut self, call: &ExprMethodCall) {
        self.0.insert(format!(".{}", call.method));
        visit::visit_expr_method_call(self, call);
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
