//! An estimate of cycles from counted instructions: Arm's tables, at zero wait states.
//!
//! The tables leave a span open where neighbours or operands decide, and so do the counts: how often a branch was taken
//! is known from how often its target and its successor were executed, exactly only where no other way leads there.

mod instruction;
mod timing;

use anyhow::{Context, Result};

use self::instruction::{Instruction, is_wide};
use self::timing::NOT_TAKEN;
use super::counts::Region;
use super::symbols::Symbols;

pub(crate) use self::timing::{Core, Span};

/// The cycles of a region.
pub(crate) fn estimate(core: Core, symbols: &Symbols, region: &Region) -> Result<Span> {
    let mut total = Span::default();
    for (address, count) in region.iter() {
        total = total + of_address(core, symbols, region, address, count)?;
    }
    Ok(total)
}

/// The cycles of all executions of the instruction at an address.
fn of_address(core: Core, symbols: &Symbols, region: &Region, address: u64, count: u64) -> Result<Span> {
    let no_code = || format!("there is no code at {address:#x}");
    let first = symbols.halfword(address).with_context(no_code)?;
    let second = if is_wide(first) { symbols.halfword(address + 2).with_context(no_code)? } else { 0 };
    let unknown = || format!("no cycles are known for {first:04x} {second:04x} at {address:#x}");
    let instruction = Instruction::decode(first, second).with_context(unknown)?;
    let once = core.cycles(instruction).with_context(unknown)?;
    let Instruction::ConditionalBranch(distance) = instruction else { return Ok(once * count) };
    let successor = region.count(address + if is_wide(first) { 4 } else { 2 });
    let target = region.count(address.wrapping_add_signed(distance.into()));
    let (least, most) = (count - count.min(successor), count.min(target));
    // An end of the region is executed, but not counted.
    let most = most.max(least);
    let cycles = |taken: u64| once * taken + NOT_TAKEN * (count - taken);
    Ok(Span { least: cycles(least).least, most: cycles(most).most })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A program of one section.
    fn program(halfwords: &[u16]) -> Symbols {
        Symbols::of_code(0x100, halfwords.iter().flat_map(|halfword| halfword.to_le_bytes()).collect())
    }

    fn cycles(core: Core, halfwords: &[u16], counts: &[(u64, u64)]) -> Span {
        let region = counts.iter().copied().collect();
        estimate(core, &program(halfwords), &region).unwrap()
    }

    #[test]
    fn a_loop_is_taken_but_once() {
        // subs r0, r0, #1; bne back to it: ten turns.
        let span = cycles(Core::M0, &[0x3801, 0xd1fd, 0xbf00], &[(0x100, 10), (0x102, 10), (0x104, 1)]);
        assert_eq!(span, Span { least: 10 + 9 * 3 + 1 + 1, most: 10 + 10 * 3 + 1 });
    }

    #[test]
    fn a_branch_over_an_instruction_is_known_exactly() {
        // beq over the next: taken three times of eight, on a processor whose branches take 2 to 4 cycles.
        let code = [0xd000, 0x3001, 0x3001];
        let span = cycles(Core::M3, &code, &[(0x100, 8), (0x102, 5), (0x104, 8)]);
        assert_eq!(span.least, 3 * 2 + 5 + 5 + 8);
        let region: Region = [(0x100, 8), (0x102, 5), (0x104, 8)].into_iter().collect();
        assert!(
            estimate(Core::M3, &program(&[0xdf00]), &region).is_err(),
            "a supervisor call has no cycles here"
        );
    }
}
