//! What a change returns is used: a light that is moved, and dropped, does not move.

use std::fs;

use syn::{Attribute, FnArg, ImplItem, ImplItemFn, Item, ReturnType, Visibility, visit::Visit};

use crate::listing::files;

/// Whether a type names `Self`, and whether it is a `Result`, which rustc does not let anyone drop.
#[derive(Default)]
struct Names {
    own: bool,
    result: bool,
}

impl Visit<'_> for Names {
    fn visit_path(&mut self, path: &syn::Path) {
        let name = path.segments.last().map(|segment| segment.ident.to_string());
        self.own |= name.as_deref() == Some("Self");
        self.result |= name.as_deref() == Some("Result");
        syn::visit::visit_path(self, path);
    }
}

/// Whether the method makes another value of the type from one: from `self`, or from a reference to it.
fn is_change(method: &ImplItemFn) -> bool {
    let ReturnType::Type(_, output) = &method.sig.output else { return false };
    let mut names = Names::default();
    names.visit_type(output);
    let is_public = matches!(method.vis, Visibility::Public(_));
    let takes_self =
        matches!(method.sig.inputs.first(), Some(FnArg::Receiver(own)) if own.mutability.is_none());
    is_public && takes_self && names.own && !names.result
}

fn must_use(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| attribute.path().is_ident("must_use"))
}

#[test]
fn no_change_of_a_value_is_dropped_in_silence() {
    let (mut changes, mut dropped) = (0, Vec::new());
    for file in files(&["core/src/*.rs", "render/src/*.rs"]) {
        let text = fs::read_to_string(&file).expect("a listed file can be read");
        let items = syn::parse_file(&text).expect("Rust").items;
        let own = items.iter().filter_map(|item| if let Item::Impl(own) = item { Some(own) } else { None });
        for method in own.filter(|own| own.trait_.is_none()).flat_map(|own| &own.items) {
            let ImplItem::Fn(method) = method else { continue };
            if is_change(method) {
                changes += 1;
                if !must_use(&method.attrs) {
                    dropped.push(format!("{}: {}", file.display(), method.sig.ident));
                }
            }
        }
    }
    assert!(changes > 30, "{changes} changes");
    assert!(dropped.is_empty(), "expected `#[must_use]`:\n{}", dropped.join("\n"));
}
