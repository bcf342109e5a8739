//! What the kernels cost on a board.

use std::collections::BTreeMap;

use anyhow::{Context, Result, bail};

use super::counts::Region;
use super::laboratory::{Laboratory, Run};
use super::rp2040::Rp2040;
use super::symbols::{Function, Symbols};

/// A line that the program prints: a kernel that was run in a number format over inputs.
#[derive(Clone, Debug, PartialEq)]
struct Line {
    format: String,
    kernel: String,
    calls: u64,
}

/// The name of the loop that does nothing, which runs before each kernel over the same inputs.
const EMPTY: &str = "empty";

/// What a kernel costs. The empty loop over the same inputs is subtracted from `instructions` and
/// `bytes`.
#[derive(Clone, Debug)]
pub(crate) struct Cost {
    pub(crate) format: String,
    pub(crate) kernel: String,
    /// Instructions of an average call.
    pub(crate) instructions: f64,
    /// Cycles of an average call, if they were counted.
    pub(crate) cycles: Option<f64>,
    /// Bytes of code of all functions that the kernel calls. A function that several kernels call
    /// counts for each of them, although the program holds it once.
    pub(crate) bytes: u64,
    /// Instructions of an average call by function, including the loop around the call.
    pub(crate) split: BTreeMap<Function, f64>,
    /// Instructions of one iteration of the empty loop.
    pub(crate) empty: f64,
}

impl Cost {
    /// The name of the kernel in its format, as the command line gives it.
    pub(crate) fn name(&self) -> String {
        format!("{}.{}", self.kernel, self.format)
    }
}

/// The costs of all kernels on a board, and the compiler that they depend on.
#[derive(Debug)]
pub(crate) struct Costs {
    pub(crate) kernels: Vec<Cost>,
    pub(crate) compiler: String,
    /// The emulator and the board that it emulated.
    pub(crate) emulator: String,
}

/// Runs a program that prints a line for each kernel. Its results must be the host's.
pub(crate) fn measure(
    laboratory: &Laboratory,
    program: &str,
    host: &[String],
    clock: Option<&Rp2040>,
) -> Result<Costs> {
    let run = laboratory.run(program)?;
    compare(&run.lines, host)?;
    let cycles = clock.map(|clock| clock.cycles(&laboratory.program(program), &run)).transpose()?;
    let symbols = Symbols::read(&laboratory.program(program))?;
    let kernels = kernels(&run, cycles.as_deref(), &symbols)?;
    let emulator = match clock {
        Some(_) => format!("{}; cycles by {}", laboratory.emulator(), Rp2040::describe()?),
        None => laboratory.emulator(),
    };
    Ok(Costs { kernels, compiler: symbols.compiler, emulator })
}

/// Compares the results with the host's. An error names the first that differs.
fn compare(lines: &[String], host: &[String]) -> Result<()> {
    if let Some((line, host)) = lines.iter().zip(host).find(|(line, host)| line != host) {
        bail!("not the bits of the host: `{line}`, on the host `{host}`");
    }
    if lines.len() != host.len() {
        bail!("{} results, on the host {}", lines.len(), host.len());
    }
    Ok(())
}

fn kernels(run: &Run, cycles: Option<&[u64]>, symbols: &Symbols) -> Result<Vec<Cost>> {
    let mut kernels = Vec::new();
    let mut empty = None;
    for (index, (line, region)) in run.lines.iter().zip(&run.regions).enumerate() {
        let line = Line::parse(line).with_context(|| format!("not a result: {line}"))?;
        let cycles = cycles.map(|cycles| cycles[index]);
        if line.kernel == EMPTY {
            empty = Some((region, cycles));
        } else {
            let (empty, idle) = empty.take().context("no empty loop")?;
            let calls = line.calls as f64;
            let cycles = cycles.zip(idle).map(|(busy, idle)| (busy as f64 - idle as f64) / calls);
            kernels.push(Cost { cycles, ..cost(line, region, empty, symbols) });
        }
    }
    Ok(kernels)
}

fn cost(line: Line, region: &Region, empty: &Region, symbols: &Symbols) -> Cost {
    let per_call = |count: u64| count as f64 / line.calls as f64;
    let bytes = |region| symbols.split(region).keys().map(|function| function.bytes).sum::<u64>();
    let (instructions, empty_loop) = (per_call(region.instructions()), per_call(empty.instructions()));
    let split = symbols.split(region).into_iter().map(|(function, count)| (function, per_call(count)));
    Cost {
        instructions: instructions - empty_loop,
        cycles: None,
        bytes: bytes(region).saturating_sub(bytes(empty)),
        split: split.collect(),
        empty: empty_loop,
        format: line.format,
        kernel: line.kernel,
    }
}

impl Line {
    /// Reads `falloff fx16 soft 256 9e19f69e`, the last word being the checksum.
    fn parse(line: &str) -> Option<Self> {
        let mut words = line.split(' ').map(str::to_owned);
        let (_stage, format, kernel) = (words.next()?, words.next()?, words.next()?);
        let calls = words.next()?.parse().ok().filter(|calls| *calls > 0)?;
        words.next()?;
        words.next().is_none().then_some(Self { format, kernel, calls })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &[&str]) -> Vec<String> {
        text.iter().map(|line| (*line).to_owned()).collect()
    }

    #[test]
    fn a_result_has_five_words() {
        let line = Line::parse("falloff fx16 soft 256 9e19f69e").unwrap();
        assert_eq!((line.format.as_str(), line.kernel.as_str(), line.calls), ("fx16", "soft", 256));
        for broken in ["", "falloff fx16 soft 256", "falloff fx16 soft 0 9e19f69e", "a b c 1 d e"] {
            assert_eq!(Line::parse(broken), None, "{broken}");
        }
    }

    #[test]
    fn a_result_that_differs_is_named() {
        let host = lines(&["a 1", "b 2"]);
        assert!(compare(&host, &host).is_ok());
        let differs = compare(&lines(&["a 1", "b 3"]), &host).unwrap_err().to_string();
        assert!(differs.contains("b 3") && differs.contains("b 2"), "{differs}");
        assert!(compare(&lines(&["a 1"]), &host).is_err());
    }
}
