//! The imports between the files of a crate, from its syntax trees.
//!
//! An import is a path, in a `use`, an expression, a type or the tokens of a macro, that leads to an
//! item of another file. A re-export (`pub use`) is no import of the file that states it: whoever
//! uses the name imports from the file that defines it. Tests are left out.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Attribute, Ident, Item, ItemUse, UseTree, Visibility};

/// A path within a crate: its segments from the root.
type Name = Vec<String>;

/// A module: its file, and what its names stand for.
#[derive(Default)]
struct Module {
    file: PathBuf,
    /// Names that are defined here.
    items: BTreeSet<String>,
    /// Names that a `use` brings here, with their paths as written.
    aliases: BTreeMap<String, Name>,
    /// The paths, as written, of the modules whose names a `use` with a star brings here.
    globs: Vec<Name>,
    /// The paths, as written, that the module's code follows.
    followed: BTreeSet<Name>,
}

/// The files of a crate and the imports between them.
pub(crate) struct Graph {
    root: PathBuf,
    modules: BTreeMap<Name, Module>,
}

impl Graph {
    /// Reads a crate by the file of its root.
    pub(crate) fn of(root: &Path) -> Self {
        let mut graph = Self { root: root.to_owned(), modules: BTreeMap::new() };
        let folder = root.parent().expect("a file is in a folder").to_owned();
        graph.read(vec![], root, &folder);
        graph
    }

    /// Reads the file of a module, whose modules in files of their own are in `folder`.
    fn read(&mut self, name: Name, file: &Path, folder: &Path) {
        let text = fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        let tree = syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        self.add(name, file, folder, tree.items);
    }

    fn add(&mut self, name: Name, file: &Path, folder: &Path, items: Vec<Item>) {
        let mut module = Module { file: file.to_owned(), ..Module::default() };
        for item in items {
            let (attributes, defined) = parts(&item);
            if is_test(attributes) {
                continue;
            }
            module.items.extend(defined.map(Ident::to_string));
            match item {
                Item::Mod(inner) => {
                    let ident = inner.ident.to_string();
                    let child = [name.clone(), vec![ident.clone()]].concat();
                    let inside = folder.join(&ident);
                    match (inner.content, path_of(&inner.attrs)) {
                        (Some((_, items)), _) => self.add(child, file, &inside, items),
                        (None, Some(path)) => {
                            let other = file.parent().expect("a file is in a folder").join(path);
                            self.read(child, &other, other.parent().expect("a file is in a folder"));
                        }
                        (None, None) => {
                            let beside = folder.join(format!("{ident}.rs"));
                            let own = if beside.exists() { beside } else { inside.join("mod.rs") };
                            self.read(child, &own, &inside);
                        }
                    }
                }
                Item::Use(item) => module.brings(&item),
                item => Follower(&mut module.followed).visit_item(&item),
            }
        }
        self.modules.insert(name, module);
    }

    /// The module in whose file a path ends that is written in the module `at`; nothing if the path
    /// leads out of the crate or to a module itself.
    fn resolve(&self, at: &Name, path: &[String], depth: usize) -> Option<&Name> {
        let (at, module) = self.modules.get_key_value(at)?;
        let (first, rest) = path.split_first()?;
        // Aliases and stars may lead back to where they began. A star is tried for every name, so that it
        // counts as several steps.
        if depth > 20 {
            return None;
        }
        match first.as_str() {
            "crate" | "$crate" => return self.resolve(&vec![], rest, depth + 1),
            "self" => return self.resolve(at, rest, depth + 1),
            "super" => return self.resolve(&at[..at.len().checked_sub(1)?].to_vec(), rest, depth + 1),
            _ => {}
        }
        let child = [at.clone(), vec![first.clone()]].concat();
        if self.modules.contains_key(&child) && !rest.is_empty() {
            return self.resolve(&child, rest, depth + 1);
        }
        if module.items.contains(first) && !self.modules.contains_key(&child) {
            return Some(at);
        }
        if let Some(alias) = module.aliases.get(first).filter(|alias| *alias != path) {
            return self.resolve(at, &[alias, rest].concat(), depth + 1);
        }
        module.globs.iter().find_map(|glob| self.resolve(at, &[glob, path].concat(), depth + 5))
    }

    /// Each path that code follows to a module of the crate: the module that it is in, and the other.
    fn followed(&self) -> impl Iterator<Item = (&Name, &Name, &Name)> {
        let paths =
            self.modules.iter().flat_map(|(at, module)| module.followed.iter().map(move |path| (at, path)));
        paths.filter_map(|(at, path)| Some((at, path, self.resolve(at, path, 0)?)))
    }

    /// All imports: a file, the file from which it imports, and a path that does so.
    fn imports(&self) -> BTreeMap<&Path, BTreeMap<&Path, String>> {
        let mut found = BTreeMap::<_, BTreeMap<_, _>>::new();
        for (at, path, target) in self.followed() {
            let [from, to] = [at, target].map(|module| self.modules[module].file.as_path());
            if from != to {
                found.entry(from).or_default().entry(to).or_insert_with(|| path.join("::"));
            }
        }
        found
    }

    /// Each set of files that reach one another by imports, with these imports as lines of text.
    pub(crate) fn cycles(&self) -> Vec<(Vec<PathBuf>, String)> {
        let imports = self.imports();
        let reached = |from: &Path| {
            let (mut seen, mut open) = (BTreeSet::new(), vec![from.to_owned()]);
            while let Some(file) = open.pop() {
                for to in imports.get(file.as_path()).into_iter().flat_map(BTreeMap::keys) {
                    if seen.insert(to.to_path_buf()) {
                        open.push(to.to_path_buf());
                    }
                }
            }
            seen
        };
        let reach: BTreeMap<PathBuf, _> =
            imports.keys().map(|file| (file.to_path_buf(), reached(file))).collect();
        let mut cycles = BTreeSet::new();
        for (file, reached) in reach.iter().filter(|(file, reached)| reached.contains(*file)) {
            let back = |other: &&PathBuf| reach.get(*other).is_some_and(|back| back.contains(file));
            cycles.insert(reached.iter().filter(back).cloned().collect::<Vec<_>>());
        }
        let folder = self.root.parent().expect("a file is in a folder");
        let short = |file: &Path| file.strip_prefix(folder).unwrap_or(file).display().to_string();
        let told = |cycle: Vec<PathBuf>| {
            let mut text = String::new();
            for from in &cycle {
                for (to, path) in
                    imports[from.as_path()].iter().filter(|(to, _)| cycle.iter().any(|f| f == *to))
                {
                    let _ = writeln!(text, "    {} imports {path} of {}", short(from), short(to));
                }
            }
            (cycle, text)
        };
        cycles.into_iter().map(told).collect()
    }

    /// The modules of the root.
    pub(crate) fn top(&self) -> BTreeSet<&str> {
        self.modules.keys().filter(|name| name.len() == 1).map(|name| name[0].as_str()).collect()
    }

    /// Each pair of different modules of the root of which the first imports from the second.
    pub(crate) fn between_top(&self) -> BTreeSet<(&str, &str)> {
        let tops = self
            .followed()
            .filter_map(|(at, _, target)| Some((at.first()?.as_str(), target.first()?.as_str())));
        tops.filter(|(from, to)| from != to).collect()
    }
}

impl Module {
    /// Takes the names that a `use` brings. One that exports nothing is followed, too: the methods
    /// of a trait are called without its name.
    fn brings(&mut self, item: &ItemUse) {
        let mut open = vec![(vec![], &item.tree)];
        while let Some((mut path, tree)) = open.pop() {
            let name = match tree {
                UseTree::Path(part) => {
                    path.push(part.ident.to_string());
                    open.push((path, &part.tree));
                    continue;
                }
                UseTree::Group(group) => {
                    open.extend(group.items.iter().map(|tree| (path.clone(), tree)));
                    continue;
                }
                UseTree::Glob(_) => {
                    self.globs.push(path);
                    continue;
                }
                UseTree::Name(part) if part.ident == "self" => path.last().cloned().unwrap_or_default(),
                UseTree::Name(part) => {
                    path.push(part.ident.to_string());
                    part.ident.to_string()
                }
                UseTree::Rename(part) => {
                    if part.ident != "self" {
                        path.push(part.ident.to_string());
                    }
                    part.rename.to_string()
                }
            };
            if matches!(item.vis, Visibility::Inherited) {
                self.followed.insert(path.clone());
            }
            self.aliases.insert(name, path);
        }
    }
}

/// Collects the paths of code.
struct Follower<'a>(&'a mut BTreeSet<Name>);

impl Follower<'_> {
    /// Collects the paths among tokens: names with `::` between them.
    fn tokens(&mut self, tokens: TokenStream) {
        let mut path: Name = vec![];
        let mut colons = 0;
        for token in tokens {
            match token {
                TokenTree::Punct(mark) if mark.as_char() == ':' => colons += 1,
                TokenTree::Ident(ident) if colons == 2 && !path.is_empty() => {
                    path.push(ident.to_string());
                    colons = 0;
                }
                other => {
                    self.0.insert(std::mem::take(&mut path));
                    colons = 0;
                    match other {
                        TokenTree::Ident(ident) => path.push(ident.to_string()),
                        TokenTree::Group(group) => self.tokens(group.stream()),
                        _ => {}
                    }
                }
            }
        }
        self.0.insert(path);
    }
}

impl<'ast> Visit<'ast> for Follower<'_> {
    fn visit_path(&mut self, path: &'ast syn::Path) {
        self.0.insert(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        self.visit_path(&call.path);
        self.tokens(call.tokens.clone());
    }

    fn visit_attribute(&mut self, _: &'ast Attribute) {}
}

/// The attributes of an item, and the name that it defines in its module.
fn parts(item: &Item) -> (&[Attribute], Option<&Ident>) {
    match item {
        Item::Const(item) => (&item.attrs, Some(&item.ident)),
        Item::Enum(item) => (&item.attrs, Some(&item.ident)),
        Item::Fn(item) => (&item.attrs, Some(&item.sig.ident)),
        Item::Impl(item) => (&item.attrs, None),
        Item::Macro(item) => (&item.attrs, item.ident.as_ref()),
        Item::Mod(item) => (&item.attrs, Some(&item.ident)),
        Item::Static(item) => (&item.attrs, Some(&item.ident)),
        Item::Struct(item) => (&item.attrs, Some(&item.ident)),
        Item::Trait(item) => (&item.attrs, Some(&item.ident)),
        Item::Type(item) => (&item.attrs, Some(&item.ident)),
        Item::Use(item) => (&item.attrs, None),
        _ => (&[], None),
    }
}

/// Whether an item is compiled for tests alone.
fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("test")
            || attribute.path().is_ident("cfg") && {
                let text = attribute.meta.require_list().map(|list| list.tokens.to_string());
                text.is_ok_and(|text| text == "test" || text.starts_with("all (test"))
            }
    })
}

/// The path of `#[path = "..."]`.
fn path_of(attributes: &[Attribute]) -> Option<String> {
    let attribute = attributes.iter().find(|attribute| attribute.path().is_ident("path"))?;
    match &attribute.meta.require_name_value().ok()?.value {
        syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
        _ => None,
    }
}
