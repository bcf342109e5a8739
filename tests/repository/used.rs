//! Every public function and constant of the kernel has a user in a product or in an example.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use syn::{Attribute, ImplItem, Item, Visibility};

use crate::listing::{ROOT, files};

/// The sources of products and examples. Tests, benches and the guide do not count.
const PRODUCTS: [&str; 8] = [
    "render/src/*.rs",
    "export/src/*.rs",
    "exchange/src/*.rs",
    "cli/*.rs",
    "wasm-demo/*.rs",
    "native/src/*.rs",
    "examples/*.rs",
    "core/examples/*.rs",
];

/// What has no user, and why it is there.
const WITHOUT: [(&str, &[&str]); 5] = [
    (
        "what `codegen` writes, and reads back",
        &["KERNEL", "LEVELS", "from_cells", "from_levels", "of_knots", "spacing", "written_by"],
    ),
    ("what the early-outs are compared with", &["irradiance_unskipped", "reflect_unskipped"]),
    ("what a formula and a bound are made of", &["MOST_NUMBERS", "absolute"]),
    (
        "haze in 16 bits, which no product draws",
        &["endless", "in_scattering", "in_scattering_through", "with_source_radius"],
    ),
    ("what a material was given, beside its other colours", &["emissive"]),
];

/// Adds the words of code, and those of its texts, which may be code that it writes. Comments, and what is compiled
/// for tests alone, do not count.
fn words(tokens: TokenStream, found: &mut BTreeSet<String>) {
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Ident(ident) => {
                found.insert(ident.to_string());
            }
            TokenTree::Literal(text) => {
                let text = text.to_string();
                let parts = text.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
                found.extend(parts.map(str::to_owned));
            }
            TokenTree::Group(group) => words(group.stream(), found),
            TokenTree::Punct(mark) if mark.as_char() == '#' => {
                let Some(TokenTree::Group(attribute)) = tokens.peek() else { continue };
                let text = attribute.stream().to_string().replace(' ', "");
                let is_test =
                    ["test", "cfg(test", "cfg(all(test"].iter().any(|start| text.starts_with(start));
                if is_test || text.starts_with("doc") {
                    tokens.next();
                }
                if is_test {
                    // Up to the end of the item.
                    tokens.by_ref().find(|token| match token {
                        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
                        token => token.to_string() == ";",
                    });
                }
            }
            TokenTree::Punct(_) => {}
        }
    }
}

/// Whether an item is for tests, or is no part of the interface that is kept.
fn is_hidden(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let tokens = attribute.meta.require_list().map(|list| list.tokens.to_string()).unwrap_or_default();
        attribute.path().is_ident("cfg") && (tokens.contains("test") || tokens.contains("arithmetic"))
            || attribute.path().is_ident("doc") && tokens == "hidden"
    })
}

/// Adds the public functions and constants of items by their names.
fn defined(items: Vec<Item>, file: &Path, found: &mut BTreeMap<String, String>) {
    for item in items {
        let mut add = |visibility: &Visibility, attributes: &[Attribute], name: String| {
            if matches!(visibility, Visibility::Public(_)) && !is_hidden(attributes) {
                found.insert(name, file.strip_prefix(ROOT).unwrap_or(file).display().to_string());
            }
        };
        match item {
            Item::Fn(own) => add(&own.vis, &own.attrs, own.sig.ident.to_string()),
            Item::Const(own) => add(&own.vis, &own.attrs, own.ident.to_string()),
            Item::Mod(own) if !is_hidden(&own.attrs) => {
                defined(own.content.map_or_else(Vec::new, |(_, items)| items), file, found);
            }
            Item::Impl(own) if own.trait_.is_none() && !is_hidden(&own.attrs) => {
                for item in own.items {
                    match item {
                        ImplItem::Fn(own) => add(&own.vis, &own.attrs, own.sig.ident.to_string()),
                        ImplItem::Const(own) => add(&own.vis, &own.attrs, own.ident.to_string()),
                        _ => {}
                    }
                }
            }
            _ => {}
        }
    }
}

/// A name counts for all items that have it, and for those that other types have.
#[test]
fn every_public_function_of_the_kernel_has_a_user() {
    let text = |file: &Path| fs::read_to_string(file).expect("a listed file can be read");
    let mut used = BTreeSet::new();
    for file in files(&PRODUCTS) {
        if !file.components().any(|part| part.as_os_str() == "tests") {
            words(text(&file).parse().expect("tokens"), &mut used);
        }
    }
    let mut public = BTreeMap::new();
    for file in files(&["core/src/*.rs"]) {
        if file.file_stem().is_some_and(|stem| stem != "tests") {
            defined(syn::parse_file(&text(&file)).expect("Rust").items, &file, &mut public);
        }
    }
    assert!(public.len() > 200 && used.len() > 1_000, "{} of {} names", public.len(), used.len());
    let listed: BTreeSet<_> = WITHOUT.iter().flat_map(|(_, names)| *names).copied().collect();
    let unused: Vec<_> = public.iter().filter(|(name, _)| !used.contains(*name)).collect();
    let new: Vec<_> = unused.iter().filter(|(name, _)| !listed.contains(&***name)).collect();
    assert!(new.is_empty(), "expected a user in a product or an example: {new:#?}");
    let old: Vec<_> = listed.iter().filter(|own| unused.iter().all(|(name, _)| name != *own)).collect();
    assert!(old.is_empty(), "expected no user, as the list says: {old:?}");
}
