use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::find;
use crate::list::{LIST, lists, matches, parse};
use crate::rewrite::{Part, Source};
use crate::tree;

fn changes(source: &str) -> Vec<String> {
    let found = find::mutants("a.rs", source).unwrap();
    let mutants = found.sites.into_iter().flat_map(|site| site.mutants);
    mutants.map(|mutant| format!("{}: {}", mutant.function, mutant.change)).collect()
}

#[test]
fn operators_literals_and_methods_have_mutants() {
    assert_eq!(
        changes("fn f(a: u32) -> u32 { a + 2 }"),
        ["f: `a + 2`: `+` to `-`", "f: `a + 2`: `2` to `3`", "f: `a + 2`: `2` to `1`"]
    );
    assert_eq!(
        changes("impl A { fn f(self) -> bool { self.x < 0.5f32 } }"),
        [
            "A::f: `self.x < 0.5f32`: `<` to `<=`",
            "A::f: `self.x < 0.5f32` to `true`",
            "A::f: `self.x < 0.5f32` to `false`",
            "A::f: `self.x < 0.5f32`: `0.5f32` to `0.5005f32`"
        ]
    );
    assert_eq!(
        changes("fn f(a: f32) -> f32 { -a.max(b) }"),
        ["f: `-a.max(b)` to `a.max(b)`", "f: `a.max(b)`: `max` to `min`", "f: `a.max(b)`: `.max` removed"]
    );
    assert_eq!(
        changes("fn f() { x = !y; check(x)?; x += y; }"),
        [
            "f: `x = !y`: deleted",
            "f: `!y` to `y`",
            "f: `check(x)?;`: deleted",
            "f: `x += y`: `+=` to `-=`",
            "f: `x += y`: deleted"
        ]
    );
}

#[test]
fn conditions_are_forced_and_early_returns_deleted() {
    assert_eq!(
        changes("fn f() { if ready() { return; } }"),
        ["f: `ready()` to `true`", "f: `ready()` to `false`"]
    );
    assert_eq!(changes("fn f() { if let Some(x) = y && z { return; } }"), ["f: `return`: deleted"]);
    assert_eq!(changes("fn f() { while more() {} }"), ["f: `more()` to `false`"]);
}

#[test]
fn what_is_no_code_has_no_mutants() {
    for source in [
        "#![doc = \"a + 1\"]\n//! a + 1\n#[repr(align(4))]\n/// 1 + 1\nstruct A([u8; 4 + 4]);",
        "#[cfg(test)]\nmod tests { fn f() -> u32 { 1 + 1 } }",
        "#[cfg(not(feature = \"fixed\"))]\nfn f() -> u32 { 1 + 1 }",
        "fn f(x: [u8; 4]) -> A<{ 1 + 1 }> { match x { [1, ..] => g::<3>(), _ => [x; 5] } }",
        "const TABLE: [u8; 9] = [1, 2, 3, 4, 5, 6, 7, 8, 9];",
        "const TABLE: [u8; 9] = { let mut table = [1; 9]; table[0] += 1; table };",
        "enum A { B = 1 }",
        "trait A { const B: u32 = 1; }",
        "fn f() { assert!(1 + 1 == 2); }",
    ] {
        assert_eq!(changes(source), [""; 0], "{source}");
    }
    assert_eq!(changes("#[cfg(any(test, all(feature = \"a\")))]\nfn f() -> u32 { a + b }").len(), 1);
}

#[test]
fn the_same_change_twice_in_a_function_is_numbered() {
    assert_eq!(
        changes("fn f() { g(!a); h(!a) }"),
        ["f: `g(!a);`: deleted", "f: `!a` to `a`", "f: `!a` to `a` #2"]
    );
}

#[test]
fn the_bodies_of_macros_have_mutants_at_their_places() {
    let source = "macro_rules! m {\n    ($a:ident, $($b:ty),*) => {\n        $(impl $a for $b { fn f() -> u32 { $crate::g() << 1 } })*\n    };\n}";
    let found = find::mutants("a.rs", source).unwrap();
    let site = &found.sites[0];
    assert_eq!(&source[site.range.clone()], "$crate::g() << 1");
    assert_eq!((site.mutants[0].function.as_str(), site.mutants[0].lines), ("m!::_b::f", (3, 3)));
    assert_eq!(changes("macro_rules! m { ($a:expr) => { $a + $b }; }"), ["m!: `$a + $b`: `+` to `-`"]);
    assert_eq!(find::mutants("a.rs", "macro_rules! m { () => { 1 + }; }").unwrap().unparsed, ["m!"]);
}

fn rewritten(source: &str) -> String {
    Source::new("a.rs", source.into()).unwrap().rewritten(7).text
}

#[test]
fn nested_mutants_are_chosen_one_at_a_time() {
    assert_eq!(
        rewritten("fn f() -> u32 { a * (b - c) }"),
        "fn f() -> u32 { (if !crate::mutant::any(7, 1) { a * ((if !crate::mutant::any(8, 1) { b - c } \
         else { b + c })) } else { a / (b - c) }) }"
    );
    assert_eq!(rewritten("fn f() { g(); }"), "fn f() { if !crate::mutant::any(7, 1) { g(); } else {  } }");
    assert!(rewritten("macro_rules! m { () => { a + b }; }").contains("if !$crate::mutant::any(7, 1)"));
}

#[test]
fn a_constant_is_a_function_where_code_runs() {
    let text = rewritten("const A: u32 = B + C; fn f() -> [u32; A] { [A; A] }");
    let function = "#[allow(dead_code, non_snake_case)] const fn A__() -> u32 { (if !crate::mutant::any(7, 1) { B + C } else { B - C }) }";
    assert_eq!(text, format!("const A: u32 = B + C; {function} fn f() -> [u32; A] {{ [A__(); A] }}"));
}

#[test]
fn what_does_not_compile_is_found_and_taken_out() {
    let mut source = Source::new("a.rs", "const A: u32 = 1; fn f() -> u32 { A % (b + c) }".into()).unwrap();
    let text = source.rewritten(0);
    let at = |part: &str| text.part(text.text.find(part).unwrap());
    // The constant's value is the first site.
    let (remainder, constant) = (at("A__() % ").unwrap(), at("const fn A__").unwrap());
    assert_eq!((remainder, constant), (Part::Name(0), Part::Constant(0)));
    let mutant = at("b - c").unwrap();
    assert_eq!(mutant, Part::Mutant(2, 0));
    source.take_out(BTreeSet::from([mutant, constant]));
    let left: Vec<_> = source.mutants().map(|mutant| mutant.change.as_str()).collect();
    assert_eq!(left, ["`A % (b + c)`: `%` to `*`"]);
}

#[test]
fn a_list_has_a_reason_for_each_mutant() {
    let list =
        parse("# remark\na.rs, f: `a`: deleted\n    one\n    two\n\nb.rs, g: `b` to `c`\n  three\n").unwrap();
    assert_eq!(list["a.rs, f: `a`: deleted"], "one two");
    assert_eq!(list.len(), 2);
    for wrong in ["a.rs, f: x\n", "  reason\n", "a\n b\na\n b\n"] {
        assert!(parse(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn a_rule_matches_whatever_varies() {
    let list = parse("a.rs, f: <any>: `wrapping_<any>` to <any>\n    one\n").unwrap();
    assert!(lists(&list, "a.rs, f: `a`: `wrapping_add` to `saturating_add`"));
    for other in ["a.rs, g: `a`: `wrapping_add` to `b`", "a.rs, f: `a`: `saturating_add` to `b`"] {
        assert!(!lists(&list, other), "{other}");
    }
    assert!(!matches("a.rs, f: `<any>` to `b`", "a.rs, f: `a` to `b` #2"));
    assert!(matches("a.rs, f: `a * b`", "a.rs, f: `a * b`") && !matches("a.rs, f: a", "a.rs, f: a #2"));
}

/// A mutant whose code has changed must be judged again.
#[test]
fn the_list_names_mutants_that_exist() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let list = parse(&fs::read_to_string(root.join(LIST)).unwrap()).unwrap();
    let sources = tree::sources(&root).unwrap();
    let existing: BTreeSet<_> = sources.iter().flat_map(Source::mutants).map(find::Mutant::key).collect();
    let gone: Vec<_> = list.keys().filter(|entry| !existing.iter().any(|key| matches(entry, key))).collect();
    assert!(gone.is_empty(), "expected mutants of the kernel, found {gone:#?}");
}
