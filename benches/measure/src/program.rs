//! A linked program: its bytes of flash, its functions, and what calls what.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use object::elf::{SHF_ALLOC, SHT_NOBITS};
use object::{
    File, Object, ObjectSection, ObjectSymbol, RelocationTarget, SectionFlags, SectionKind, SymbolKind,
    SymbolSection,
};

use crate::qemu::Region;

/// The instructions of a region, by name and bytes of the function.
pub(crate) type Split = BTreeMap<(String, u64), u64>;

/// A program as the linker has left it.
#[derive(Debug)]
pub struct Program {
    /// The bytes of code, constants and initial values of variables, section by section.
    pub flash: Vec<u8>,
    /// The names of its functions and variables, demangled. Those at an address that the linker's
    /// script sets, such as in a boot ROM, are here if the linker has left relocations to them.
    pub names: Vec<String>,
    /// The compiler, as in `rustc 1.96.0`; empty if the program does not name it.
    pub compiler: String,
    /// The functions by their first address: name and bytes.
    pub(crate) functions: BTreeMap<u64, (String, u64)>,
    /// The functions that call a function, by its first address.
    callers: BTreeMap<u64, Vec<u64>>,
    /// The addresses of all names.
    addresses: HashMap<String, u64>,
}

/// The address of a function in Thumb code has bit 0 set; its first instruction is at the even address.
fn even(address: u64) -> u64 {
    address & !1
}

fn demangled(name: &str) -> String {
    format!("{:#}", rustc_demangle::demangle(name))
}

impl Program {
    /// Reads a program's file.
    pub fn read(file: &Path) -> Result<Self> {
        let content = fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
        Self::parse(&content).with_context(|| format!("cannot read the program {}", file.display()))
    }

    fn parse(content: &[u8]) -> Result<Self> {
        let object = File::parse(content)?;
        let mut flash = Vec::new();
        for section in object.sections().filter(|section| is_in_flash(section.flags())) {
            flash.extend_from_slice(section.data()?);
        }
        let relocations = object.sections().flat_map(|section| section.relocations());
        let used: HashSet<_> = relocations.map(|(_, relocation)| relocation.target()).collect();
        let symbols = object.symbols().filter(|symbol| {
            symbol.section() != SymbolSection::Absolute
                || used.contains(&RelocationTarget::Symbol(symbol.index()))
        });
        let names = symbols.filter_map(|symbol| symbol.name().ok()).filter(|name| !name.is_empty());
        let functions = object.symbols().filter(|of| of.kind() == SymbolKind::Text && of.size() > 0);
        let functions: BTreeMap<_, _> = functions
            .filter_map(|of| Some((even(of.address()), (demangled(of.name().ok()?), of.size()))))
            .collect();
        let comment = object.section_by_name(".comment").and_then(|section| section.data().ok());
        Ok(Self {
            flash,
            names: names.map(demangled).collect(),
            compiler: compiler(comment.unwrap_or_default()).unwrap_or_default(),
            callers: callers(&object, &functions)?,
            addresses: object
                .symbols()
                .filter_map(|of| Some((demangled(of.name().ok()?), even(of.address()))))
                .collect(),
            functions,
        })
    }

    /// The number of bytes of flash.
    pub fn bytes(&self) -> u64 {
        self.flash.len() as u64
    }

    /// The instructions of a region, by name and bytes of the function. Instructions outside every
    /// function are counted as `?`.
    pub(crate) fn split(&self, region: &Region) -> Split {
        let mut split = Split::new();
        for (&address, &count) in region {
            let function = self.functions.range(..=address).next_back();
            let function = function.filter(|(start, (_, bytes))| address < *start + bytes);
            let function = function.map_or(("?".to_owned(), 0), |(_, function)| function.clone());
            *split.entry(function).or_default() += count;
        }
        split
    }

    /// The names of the functions that call a function, directly or indirectly. The linker must have
    /// left relocations.
    pub(crate) fn callers(&self, callee: &str) -> BTreeSet<&str> {
        let mut found: Vec<_> = self.addresses.get(callee).copied().into_iter().collect();
        let mut names = BTreeSet::new();
        while let Some(address) = found.pop() {
            for caller in self.callers.get(&address).into_iter().flatten() {
                if names.insert(self.functions[caller].0.as_str()) {
                    found.push(*caller);
                }
            }
        }
        names
    }

    /// Fails if the program contains soft-float functions, and names them.
    pub fn has_no_float(&self) -> Result<()> {
        let floats = self.names_of(is_float);
        ensure!(floats.is_empty(), "there are floats: {}", floats.join(", "));
        Ok(())
    }

    /// The names for which `kind` returns true.
    pub fn names_of(&self, kind: impl Fn(&str) -> bool) -> Vec<&str> {
        self.names.iter().map(String::as_str).filter(|name| kind(name)).collect()
    }
}

/// The functions that call a function, by its first address.
fn callers(object: &File<'_>, functions: &BTreeMap<u64, (String, u64)>) -> Result<BTreeMap<u64, Vec<u64>>> {
    let mut callers = BTreeMap::<_, Vec<_>>::new();
    for section in object.sections().filter(|section| section.kind() == SectionKind::Text) {
        for (place, relocation) in section.relocations() {
            let RelocationTarget::Symbol(target) = relocation.target() else { continue };
            let Some((&caller, (_, bytes))) = functions.range(..=place).next_back() else { continue };
            let target = object.symbol_by_index(target)?;
            // Jump tables refer to the start of their section, where some other function begins.
            if place < caller + bytes && target.kind() != SymbolKind::Section {
                callers.entry(even(target.address())).or_default().push(caller);
            }
        }
    }
    Ok(callers)
}

/// The compiler that a program's `.comment` section names, as in
/// `rustc version 1.96.0 (ac68faa20 2026-05-25)`.
fn compiler(comment: &[u8]) -> Option<String> {
    let mut texts = comment.split(|byte| *byte == 0).filter_map(|text| str::from_utf8(text).ok());
    let version = texts.find_map(|text| text.strip_prefix("rustc version "))?;
    Some(format!("rustc {}", version.split(' ').next()?))
}

/// Whether a section takes flash: it is loaded and has content, unlike memory that is only zeroed.
fn is_in_flash(flags: SectionFlags) -> bool {
    matches!(flags, SectionFlags::Elf { sh_type, sh_flags } if sh_flags.contains(SHF_ALLOC) && sh_type != SHT_NOBITS)
}

/// Whether this is one of the compiler's soft-float functions: in Arm's run-time ABI
/// (`__aeabi_fadd`, `__aeabi_i2f`, `__aeabi_cdcmple`) or in GCC's (`__addsf3`, `__floatsisf`), or a
/// function that these call.
fn is_float(name: &str) -> bool {
    if let Some(arm) = name.strip_prefix("__aeabi_") {
        return arm.starts_with(['f', 'd'])
            || ["cf", "cd"].iter().any(|compare| arm.starts_with(compare))
            || ["2f", "2d", "2h"].iter().any(|conversion| arm.ends_with(conversion));
    }
    let gcc = name.strip_prefix("__").filter(|gcc| !gcc.contains("::"));
    gcc.is_some_and(|gcc| ["sf", "df", "hf", "tf"].iter().any(|mode| gcc.contains(mode)))
        || name.contains("compiler_builtins::float")
        || name.starts_with("libm::")
}

/// Whether this is a function of a heap allocator.
pub fn is_heap(name: &str) -> bool {
    ["__rust_alloc", "__rust_dealloc", "__rust_realloc", "__rg_alloc", "alloc::"]
        .iter()
        .any(|heap| name.contains(heap))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn function_for_floats_is_told_from_one_for_integers() {
        for name in [
            "__aeabi_fadd __aeabi_dmul __aeabi_i2f __aeabi_ul2d __aeabi_f2iz __aeabi_cfcmple",
            "__addsf3 __floatsisf __fixsfsi __ltsf2 __muldf3 __extendsfdf2",
            "compiler_builtins::float::add::add libm::math::sqrtf",
        ]
        .iter()
        .flat_map(|names| names.split(' '))
        {
            assert!(is_float(name), "{name}");
        }
        for name in "__aeabi_lmul __aeabi_uidiv __aeabi_memcpy __muldi3 __clzsi2 __sheap main".split(' ') {
            assert!(!is_float(name), "{name}");
        }
    }

    #[test]
    fn compiler_is_found_among_the_comments() {
        let comment = b"\0Linker: LLD 22.1.2\0rustc version 1.96.0 (ac68faa20 2026-05-25)\0";
        assert_eq!(compiler(comment).unwrap(), "rustc 1.96.0");
        assert_eq!(compiler(b"GCC: 14\0"), None);
    }
}
