//! A linked program: its bytes of flash, and its functions and variables.

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use object::elf::{SHF_ALLOC, SHT_NOBITS};
use object::{
    Object, ObjectSection, ObjectSymbol, RelocationTarget, SectionFlags, SectionKind, SymbolKind,
    SymbolSection,
};

/// A program as the linker has left it.
#[derive(Debug)]
pub struct Program {
    /// The bytes of code, constants and initial values of variables.
    pub bytes: u64,
    /// These bytes, section by section.
    pub flash: Vec<u8>,
    /// The names of its functions and variables, demangled. Those at an address that the linker's
    /// script sets, such as in a boot ROM, are here if the linker has left relocations to them.
    pub names: Vec<String>,
}

impl Program {
    /// Reads a program's file.
    pub fn read(file: &Path) -> Result<Self> {
        let failed = || format!("cannot read the program {}", file.display());
        let content = fs::read(file).with_context(failed)?;
        let object = object::File::parse(&*content).with_context(failed)?;
        let mut flash = Vec::new();
        for section in object.sections().filter(|section| is_in_flash(section.flags())) {
            flash.extend_from_slice(section.data().with_context(failed)?);
        }
        let relocations = object.sections().flat_map(|section| section.relocations());
        let used: HashSet<_> = relocations.map(|(_, relocation)| relocation.target()).collect();
        let symbols = object.symbols().filter(|symbol| {
            symbol.section() != SymbolSection::Absolute
                || used.contains(&RelocationTarget::Symbol(symbol.index()))
        });
        let names = symbols.filter_map(|symbol| symbol.name().ok()).filter(|name| !name.is_empty());
        Ok(Self {
            bytes: flash.len() as u64,
            flash,
            names: names.map(|name| format!("{:#}", rustc_demangle::demangle(name))).collect(),
        })
    }

    /// The names of the functions that call a function, directly or indirectly, read from the
    /// relocations that the linker has left in the file.
    pub(crate) fn callers(file: &Path, callee: &str) -> Result<BTreeSet<String>> {
        let failed = || format!("cannot read the relocations of {}", file.display());
        let content = fs::read(file).with_context(failed)?;
        let object = object::File::parse(&*content).with_context(failed)?;
        // The address of a function in Thumb code has bit 0 set; its first byte is at the even
        // address below.
        let even = |address: u64| address & !1;
        let functions = object.symbols().filter(|of| of.kind() == SymbolKind::Text && of.size() > 0);
        let functions = functions.map(|of| (even(of.address()), of)).collect::<BTreeMap<_, _>>();
        let mut callers: BTreeMap<u64, Vec<u64>> = BTreeMap::new();
        let mut found = Vec::new();
        for section in object.sections().filter(|section| section.kind() == SectionKind::Text) {
            for (place, relocation) in section.relocations() {
                let RelocationTarget::Symbol(target) = relocation.target() else { continue };
                let Some((&caller, function)) = functions.range(..=place).next_back() else { continue };
                let target = object.symbol_by_index(target).with_context(failed)?;
                // Jump tables refer to the start of their section, where some other function begins.
                if place < caller + function.size() && target.kind() != SymbolKind::Section {
                    callers.entry(even(target.address())).or_default().push(caller);
                    found.extend((target.name() == Ok(callee)).then_some(caller));
                }
            }
        }
        let mut names = BTreeSet::new();
        while let Some(caller) = found.pop() {
            let name = format!("{:#}", rustc_demangle::demangle(functions[&caller].name()?));
            if names.insert(name) {
                found.extend(callers.get(&caller).into_iter().flatten());
            }
        }
        Ok(names)
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
    use object::elf::{SHF_EXECINSTR, SHF_WRITE, SHT_PROGBITS};

    use super::*;

    #[test]
    fn functions_for_floats_are_told_from_those_for_integers() {
        let floats = [
            "__aeabi_fadd",
            "__aeabi_dmul",
            "__aeabi_i2f",
            "__aeabi_ul2d",
            "__aeabi_f2iz",
            "__aeabi_cfcmple",
        ];
        let gcc = ["__addsf3", "__floatsisf", "__fixsfsi", "__ltsf2", "__muldf3", "__extendsfdf2"];
        let callees = ["compiler_builtins::float::add::add", "libm::math::sqrtf"];
        for name in floats.iter().chain(&gcc).chain(&callees) {
            assert!(is_float(name), "{name}");
        }
        for name in
            ["__aeabi_lmul", "__aeabi_uidiv", "__aeabi_memcpy", "__muldi3", "__clzsi2", "__sheap", "main"]
        {
            assert!(!is_float(name), "{name}");
        }
    }

    #[test]
    fn only_what_has_content_is_in_flash() {
        let section = |sh_type, sh_flags| SectionFlags::Elf { sh_type, sh_flags };
        assert!(is_in_flash(section(SHT_PROGBITS, SHF_ALLOC | SHF_EXECINSTR)));
        assert!(!is_in_flash(section(SHT_NOBITS, SHF_ALLOC | SHF_WRITE)));
        assert!(!is_in_flash(section(SHT_PROGBITS, SHF_WRITE)));
    }
}
