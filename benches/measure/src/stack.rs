//! Stack and RAM: bounds of each call in C by the compiler's own account, and the stack of each effect as found by
//! painting it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use object::{Object, ObjectSymbol};
use tools::progress::Progress;
use tools::{command, project};

use crate::c::{LEVELS, LIBRARY, Machine, figure, machine};
use crate::counted::Firmware;
use crate::effects::{self, SUITED};
use crate::qemu::Qemu;
use crate::record::{Group, Line};
use crate::target::Board;

/// The file with every function and type of the library for C.
const ALL: &str = "benches/firmware/src/stack.c";

/// The page that lists the functions.
const INTERFACE: &str = "export/c/README.md";

/// Functions of the compiler's library that calls may take, in assembly or C of it.
const HELPERS: [&str; 9] = [
    "__aeabi_llsl",
    "__aeabi_llsr",
    "__aeabi_lasr",
    "__aeabi_lmul",
    "__ashldi3",
    "__lshrdi3",
    "__ashrdi3",
    "memcpy",
    "memset",
];

/// Upper bound of the stack of each, in bytes: `__aeabi_lmul` of a Cortex-M0 pushes seven registers.
const HELPER: u64 = 28;

/// Adds the stack and the bytes that are on record of a board: in C where it has a machine, and of the effects in the
/// format that suits it.
pub(crate) fn add(board: &'static Board, group: &mut Group, progress: &Progress) -> Result<()> {
    for (_, format) in SUITED.iter().filter(|(suited, _)| *suited == board.name) {
        add_rust(&format.effects, board, group, progress)?;
    }
    machine(board).map_or(Ok(()), |machine| add_c(machine, group))
}

/// Adds the stack of each effect, and the bytes of types, in the format of a feature on a board.
fn add_rust(features: &[&str], board: &'static Board, group: &mut Group, progress: &Progress) -> Result<()> {
    let file = Firmware::new("stack", features).build(board, progress)?;
    let printed = command::answer(Qemu::find(board, progress)?.command().arg("-kernel").arg(file))?;
    let lines = Line::all(&printed)?;
    ensure!(
        lines.iter().any(|line| line.unit == "stack"),
        "no stack was measured on {}: {printed}",
        board.name
    );
    for Line { name, value, unit } in lines {
        let (program, format) = name.split_once('.').context("a name has no format")?;
        group.add(&effects::figure(program, format), &unit, value.parse::<u64>()?);
    }
    Ok(())
}

/// Adds a bound of the stack of each call in C, the largest of all levels, and the bytes of the types.
fn add_c(machine: &Machine, group: &mut Group) -> Result<()> {
    let functions = functions()?;
    let mut most = BTreeMap::<_, u64>::new();
    for (level, _) in LEVELS {
        let object = project::target().join(format!("stack-{}.o", machine.board.name));
        let mut compile = Command::new(machine.compiler);
        compile.args(["-std=c99", "-c", level, "-fcallgraph-info=su"]);
        compile.args(["-fkeep-static-functions", "-fkeep-inline-functions", "-fno-ipa-icf"]);
        compile.args(machine.options.iter().filter(|option| !option.starts_with("-Wl,")));
        compile.arg("-I").arg(project::root().join(LIBRARY)).arg(project::root().join(ALL));
        command::answer(compile.arg("-o").arg(&object))?;
        let graph = Graph::read(&fs::read_to_string(object.with_extension("ci"))?)?;
        for name in &functions {
            let stack = most.entry(name.as_str()).or_default();
            *stack = (*stack).max(graph.depth(name, &mut Vec::new())?);
        }
        if level == "-O2" {
            let content = fs::read(&object)?;
            for symbol in object::File::parse(&*content)?.symbols() {
                if let Some(name) = symbol.name()?.strip_prefix("bytes_of_") {
                    group.add(&figure(name), "ram", symbol.size());
                }
            }
        }
    }
    most.into_iter().for_each(|(name, stack)| group.add(&figure(name), "stack", stack));
    Ok(())
}

/// The functions of the interface, as its page names them.
fn functions() -> Result<BTreeSet<String>> {
    let page = fs::read_to_string(project::root().join(INTERFACE)).context(INTERFACE)?;
    let calls = page.split('`').filter_map(|code| Some(code.split_once('(')?.0));
    let is_name = |name: &&str| {
        name.strip_prefix("luminaire_").is_some_and(|rest| {
            rest.chars().all(|c| c.is_ascii_lowercase() || c == '_' || c.is_ascii_digit())
        })
    };
    Ok(calls.filter(is_name).map(str::to_owned).collect())
}

/// What the functions of a file call, and their own bytes of stack, as gcc writes them.
#[derive(Debug, Default)]
struct Graph {
    own: BTreeMap<String, u64>,
    calls: BTreeMap<String, BTreeSet<String>>,
}

impl Graph {
    /// Reads lines such as `node: { title: "a.c:f" label: "f\\na.c:1:2\\n16 bytes (static)" }`, and
    /// `edge: { sourcename: "a.c:f" targetname: "a.c:g" .. }`.
    fn read(text: &str) -> Result<Self> {
        let mut graph = Self::default();
        for line in text.lines() {
            let texts: Vec<_> = line.split('"').skip(1).step_by(2).collect();
            let name = |title: &str| title.rsplit(':').next().unwrap_or(title).to_owned();
            if line.starts_with("edge:") {
                graph.calls.entry(name(texts[0])).or_default().insert(name(texts[1]));
            } else if let Some((_, bytes)) = texts.get(1).and_then(|label| label.rsplit_once("\\n"))
                && let Some(bytes) = bytes.strip_suffix(" bytes (static)")
            {
                graph.own.insert(name(texts[0]), bytes.parse()?);
            }
        }
        ensure!(!graph.own.is_empty(), "gcc has written no stack");
        Ok(graph)
    }

    /// The bytes on the longest way down from a function.
    fn depth(&self, name: &str, above: &mut Vec<String>) -> Result<u64> {
        let Some(own) = self.own.get(name) else {
            ensure!(HELPERS.contains(&name), "the stack of {name} is not known");
            return Ok(HELPER);
        };
        if above.iter().any(|caller| caller == name) {
            bail!("{name} calls itself");
        }
        above.push(name.to_owned());
        let below = self.calls.get(name).into_iter().flatten().map(|callee| self.depth(callee, above));
        let below = below.collect::<Result<Vec<_>>>()?.into_iter().max().unwrap_or_default();
        above.pop();
        Ok(own + below)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GRAPH: &str = "graph: { title: \"a.c\"\n\
        node: { title: \"a.c:f\" label: \"f\\na.c:1:2\\n16 bytes (static)\" }\n\
        node: { title: \"a.c:g\" label: \"g\\na.c:3:4\\n8 bytes (static)\" }\n\
        node: { title: \"memset\" label: \"__builtin_memset\\n<built-in>\" shape : ellipse }\n\
        edge: { sourcename: \"a.c:f\" targetname: \"a.c:g\" label: \"a.c:1:9\" }\n\
        edge: { sourcename: \"a.c:g\" targetname: \"memset\" }\n}\n";

    #[test]
    fn depth_is_that_of_the_longest_way_and_of_known_helpers() {
        let depth = |text: &str| Graph::read(text).unwrap().depth("f", &mut Vec::new());
        assert_eq!(depth(GRAPH).unwrap(), 16 + 8 + HELPER);
        assert!(depth(&GRAPH.replace("memset", "qsort")).unwrap_err().to_string().contains("qsort"));
        assert!(depth(&GRAPH.replace("\"memset\" }\n}", "\"a.c:f\" }\n}")).is_err());
    }
}
