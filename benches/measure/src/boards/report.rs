//! The table of costs.

use std::fmt;

use super::board::Board;
use super::cost::{Cost, Costs};

/// The costs on several boards. Each board has the same kernels in the same order.
#[derive(Debug)]
pub(crate) struct Report {
    pub(crate) boards: Vec<(&'static Board, Costs)>,
}

/// The kernel that the others are compared with: the power function that a textbook falloff calls.
const RIVAL: &str = "powf-libm.rival";

/// One line for each kernel and format, three columns for each board: the instructions of an
/// average call, the number of such calls that cost as much as one `powf`, and the bytes of code.
impl fmt::Display for Report {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut heads = [String::new(), String::new(), String::new()];
        for (board, costs) in &self.boards {
            heads[0] += &format!(" | {:^25}", board.name);
            heads[1] += &format!(" | {:^25}", costs.compiler);
            heads[2] += &format!(" | {:>9} {:>8} {:>6}", "instr.", "per powf", "bytes");
        }
        for head in heads {
            writeln!(out, "{:26}{head}", "")?;
        }
        let Some((_, first)) = self.boards.first() else { return Ok(()) };
        for (index, cost) in first.kernels.iter().enumerate() {
            write!(out, "{:26}", cost.name())?;
            for (_, costs) in &self.boards {
                let rival = costs.kernels.iter().find(|cost| cost.name() == RIVAL);
                let Some(cost) = costs.kernels.get(index) else { continue };
                let ratio = rival.map_or(f64::NAN, |rival| rival.instructions / cost.instructions);
                write!(
                    out,
                    " | {:>9.2} {:>7.*}x {:>6}",
                    cost.instructions,
                    decimals(ratio),
                    ratio,
                    cost.bytes
                )?;
            }
            writeln!(out)?;
        }
        Ok(())
    }
}

fn decimals(ratio: f64) -> usize {
    if ratio < 10.0 { 1 } else { 0 }
}

/// The instructions of an average call of one kernel, by function, in descending order.
pub(crate) fn by_symbol(board: &Board, cost: &Cost) -> String {
    let mut functions: Vec<_> = cost.split.iter().collect();
    functions.sort_by(|a, b| b.1.total_cmp(a.1));
    let mut text = format!("{} on {}\n", cost.name(), board.name);
    for (function, instructions) in functions {
        text += &format!("{instructions:10.2}  {:5} bytes  {}\n", function.bytes, function.name);
    }
    text += &format!("{:10.2}  less the empty loop\n", -cost.empty);
    text + &format!("{:10.2}  instructions a call\n", cost.instructions)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::board;
    use super::super::symbols::Function;
    use super::*;

    fn cost(kernel: &str, format: &str, instructions: f64) -> Cost {
        let function = Function { name: "pass".to_owned(), bytes: 64 };
        Cost {
            cycles: None,
            format: format.to_owned(),
            kernel: kernel.to_owned(),
            instructions,
            bytes: 40,
            split: BTreeMap::from([(function, instructions + 8.0)]),
            empty: 8.0,
        }
    }

    #[test]
    fn a_kernel_is_compared_with_the_power() {
        let kernels = vec![cost("soft", "fx16", 20.0), cost("powf-libm", "rival", 9000.0)];
        let costs = Costs { kernels, compiler: "rustc 1.95.0".to_owned(), emulator: String::new() };
        let report = Report { boards: vec![(&board::ALL[0], costs)] }.to_string();
        let lines: Vec<_> = report.lines().collect();
        assert_eq!(
            lines[3].split_whitespace().collect::<Vec<_>>(),
            ["soft.fx16", "|", "20.00", "450x", "40"]
        );
        assert_eq!(
            lines[4].split_whitespace().collect::<Vec<_>>(),
            ["powf-libm.rival", "|", "9000.00", "1.0x", "40"]
        );
    }

    #[test]
    fn the_split_adds_up() {
        let text = by_symbol(&board::ALL[0], &cost("soft", "fx16", 20.0));
        let numbers: Vec<_> =
            text.lines().skip(1).map(|line| line.split_whitespace().next().unwrap()).collect();
        assert_eq!(numbers, ["28.00", "-8.00", "20.00"]);
    }
}
