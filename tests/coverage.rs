//! Every public function of the core, and every kind of profile, distance, highlight, light and format, has a
//! test that bounds its error or holds it to be exact: `support/register.rs` names it.

#[path = "support/register.rs"]
mod register;
#[path = "support/source.rs"]
mod source;

use register::{KINDS, REGISTER, UNPROVED};
use source::Declaration;
use std::collections::{BTreeMap, BTreeSet};

/// What the core declares.
fn declarations() -> Vec<Declaration> {
    source::files("core/src").iter().flat_map(|source| source.declarations(&KINDS)).collect()
}

fn declared() -> BTreeSet<String> {
    declarations().into_iter().map(|declaration| declaration.name).collect()
}

/// What the register says, with the test of each item.
fn registered() -> Vec<(&'static str, &'static str)> {
    REGISTER.iter().flat_map(|held| held.items.iter().map(|&item| (item, held.test))).collect()
}

fn assert_none(wrong: &[String], remedy: &str) {
    assert!(wrong.is_empty(), "{}: {remedy}", wrong.join(", "));
}

#[test]
fn every_public_function_is_held_by_a_test() {
    let registered: BTreeSet<_> = registered().into_iter().map(|(item, _)| item.to_string()).collect();
    let missing: Vec<_> = declared().difference(&registered).cloned().collect();
    assert_none(
        &missing,
        "measure it against f64 in a row of tests/operations.rs, tests/setup.rs or tests/accuracy.rs, or compare it \
         exactly where it only stores or gives back, and name that test in tests/support/register.rs",
    );
}

#[test]
fn every_registered_function_is_still_there() {
    let declared = declared();
    let gone = registered().into_iter().filter(|(item, _)| !declared.contains(*item));
    let gone: Vec<_> = gone.map(|(item, _)| item.to_string()).collect();
    assert_none(&gone, "the core has it no longer: take it out of tests/support/register.rs");
}

#[test]
fn no_function_is_registered_twice() {
    let mut times = BTreeMap::new();
    for (item, _) in registered() {
        *times.entry(item).or_insert(0) += 1;
    }
    let twice: Vec<_> = times.into_iter().filter(|(_, n)| *n > 1).map(|(item, _)| item.to_string()).collect();
    assert_none(&twice, "leave it with the one test that would fail first");
}

/// The tests exist, and what they read together with their support names what they are said to hold.
#[test]
fn every_registered_test_names_what_it_holds() {
    let tests = source::files("tests");
    let core = source::files("core/src");
    let support: Vec<_> = tests.iter().filter(|source| source.path.starts_with("tests/support/")).collect();
    let mut wrong = Vec::new();
    for held in REGISTER {
        let path = held.test.split("::").next().unwrap_or_default();
        let Some(source) = tests.iter().chain(&core).find(|source| source.path == path) else {
            wrong.push(format!("{path} is no file"));
            continue;
        };
        if !source.tests().iter().any(|test| test == held.test) {
            wrong.push(format!("{} is no test", held.test));
        }
        for item in held.items {
            let names = |text: &str| words(text).any(|word| Some(word) == words(item).last());
            let is_named = names(&source.text)
                || support.iter().any(|s| s.path != "tests/support/register.rs" && names(&s.text));
            if held.is_named && !is_named {
                wrong.push(format!("{path} does not name {item}"));
            }
        }
    }
    assert_none(&wrong, "name the test that holds it in tests/support/register.rs");
}

/// Every function that computes is called by a program that does not link where anything can panic (see
/// `firmware/README.md`), and every kind of profile, distance, highlight, light and format is named there.
#[test]
fn every_function_that_computes_is_linked_without_a_panic() {
    const VALUES: &str = "firmware/effects/src/raw.rs";
    let is_proof = |of: &source::Source| of.path == VALUES || of.text.contains("luminaire_effects::raw");
    let texts: Vec<_> = source::files("firmware/effects/src").into_iter().filter(is_proof).collect();
    // `S` is the format.
    let calls = texts.iter().flat_map(source::Source::calls);
    let calls: BTreeSet<_> = calls.map(|call| call.replace("S::", "Scalar::")).collect();
    let named: BTreeSet<_> = texts.iter().flat_map(|source| words(&source.text)).collect();
    let declarations = declarations();
    let mut owners = BTreeMap::<_, BTreeSet<_>>::new();
    for Declaration { name, .. } in &declarations {
        owners.entry(words(name).last()).or_default().insert(name);
    }
    let is_called = |name: &String| {
        if let Some((_, of)) = name.split_once(" for ") {
            return named.contains(of);
        }
        // A method that only one type has, or that a macro gives to many, is known by its name.
        let method = words(name).last();
        let is_known = owners[&method].len() == 1 || name.contains('!');
        calls.contains(name) || method.is_some_and(|method| is_known && calls.contains(&format!(".{method}")))
    };
    let excused: BTreeSet<_> = UNPROVED.iter().flat_map(|(_, items)| *items).copied().collect();
    let is_missing = |declaration: &&Declaration| {
        declaration.computes && !is_called(&declaration.name) && !excused.contains(&*declaration.name)
    };
    let missing: Vec<_> = declarations.iter().filter(is_missing).map(|of| of.name.clone()).collect();
    assert_none(
        &missing,
        "call it, as Type::method where two types have one of its name, in a program of firmware/effects/src/bin that \
         cannot panic, or say in UNPROVED of tests/support/register.rs why that proves nothing",
    );
    let idle = excused.iter().filter(|item| !declarations.iter().any(|of| of.name == **item && of.computes));
    let idle: Vec<_> = idle.map(|item| item.to_string()).collect();
    assert_none(&idle, "it is gone or computes nothing: take it out of UNPROVED");
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_')).filter(|word| !word.is_empty())
}
