//! The functions of a program and its code, by address.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use object::{Object, ObjectSection, ObjectSymbol, SymbolKind};

use super::counts::Region;

/// A function of a program.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Function {
    pub(crate) name: String,
    pub(crate) bytes: u64,
}

/// The functions of a program by their first address, and the compiler that compiled them.
#[derive(Debug)]
pub(crate) struct Symbols {
    functions: BTreeMap<u64, Function>,
    /// The compiler, as in `rustc 1.96.0`. Empty if the program does not name it.
    pub(crate) compiler: String,
}

impl Symbols {
    /// Reads them from the program's file.
    pub(crate) fn read(program: &Path) -> Result<Self> {
        let failed = || format!("cannot read the functions of {}", program.display());
        let bytes = fs::read(program).with_context(failed)?;
        let file = object::File::parse(&*bytes).with_context(failed)?;
        let mut functions = BTreeMap::new();
        for symbol in file.symbols().filter(|symbol| symbol.kind() == SymbolKind::Text && symbol.size() > 0) {
            let name = short(&format!("{:#}", rustc_demangle::demangle(symbol.name().with_context(failed)?)));
            // Bit 0 of a function's address marks Thumb code; its first instruction is at the even
            // address.
            functions.insert(symbol.address() & !1, Function { name, bytes: symbol.size() });
        }
        let comment = file.section_by_name(".comment").and_then(|section| section.data().ok());
        Ok(Self { functions, compiler: compiler(comment.unwrap_or_default()).unwrap_or_default() })
    }

    /// The instructions of a region, by function. Instructions outside every function are counted
    /// as `?`.
    pub(crate) fn split(&self, region: &Region) -> BTreeMap<Function, u64> {
        let mut split = BTreeMap::new();
        for (address, count) in region.iter() {
            let function = self.functions.range(..=address).next_back();
            let function = function.filter(|(start, function)| address < *start + function.bytes);
            let unknown = || Function { name: "?".to_owned(), bytes: 0 };
            *split.entry(function.map_or_else(unknown, |(_, function)| function.clone())).or_default() +=
                count;
        }
        split
    }
}

/// The compiler that a program's `.comment` section names, as in
/// `rustc version 1.96.0 (ac68faa20 2026-05-25)`.
fn compiler(comment: &[u8]) -> Option<String> {
    let mut texts = comment.split(|byte| *byte == 0).filter_map(|text| str::from_utf8(text).ok());
    let version = texts.find_map(|text| text.strip_prefix("rustc version "))?;
    Some(format!("rustc {}", version.split(' ').next()?))
}

/// A function's name without its generic arguments: the types of a number format fill a page.
fn short(name: &str) -> String {
    name.split("::<").next().unwrap_or(name).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_shortened_where_types_begin() {
        assert_eq!(short("cost::pass::<fixed::FixedI16<u8>, {closure#2}>"), "cost::pass");
        assert_eq!(short("__clzsi2"), "__clzsi2");
    }

    #[test]
    fn the_compiler_is_found_among_the_comments() {
        let comment = b"\0Linker: LLD 22.1.2\0rustc version 1.96.0 (ac68faa20 2026-05-25)\0";
        assert_eq!(compiler(comment).unwrap(), "rustc 1.96.0");
        assert_eq!(compiler(b"GCC: 14\0"), None);
    }

    #[test]
    fn instructions_go_to_the_function_that_holds_their_address() {
        let function = |name: &str, bytes| Function { name: name.to_owned(), bytes };
        let functions = BTreeMap::from([(0x100, function("a", 8)), (0x108, function("b", 4))]);
        let region = [(0x0fe, 1), (0x100, 2), (0x106, 3), (0x108, 4), (0x10c, 5)].into_iter().collect();
        let symbols = Symbols { functions, compiler: String::new() };
        let split = symbols.split(&region);
        let expected = [(function("?", 0), 6), (function("a", 8), 5), (function("b", 4), 4)];
        assert_eq!(split, BTreeMap::from(expected));
    }
}
