//! UF2, the format of files that a board's boot ROM writes to its flash.
//!
//! The format is described in its repository, `microsoft/uf2`.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

use super::elf::segments;

/// The bytes of flash in a block.
const PAGE: u32 = 256;
/// The number that stands for the RP2040.
const FAMILY: u32 = 0xe48b_ff56;
/// Of the flags of a block: it has a family.
const HAS_FAMILY: u32 = 0x2000;

/// Converts a program to blocks of 512 bytes, one for each page of flash that the program fills.
pub(super) fn image(file: &Path) -> Result<Vec<u8>> {
    let content = fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
    let pages = pages(&content).with_context(|| format!("cannot read the program {}", file.display()))?;
    let count = pages.len() as u32;
    Ok((0..).zip(pages).flat_map(|(number, (address, page))| block(number, count, address, &page)).collect())
}

/// The pages of a program by their addresses. Bytes that the program does not use are zero.
fn pages(elf: &[u8]) -> Result<BTreeMap<u32, [u8; PAGE as usize]>> {
    let mut pages = BTreeMap::new();
    for (start, data) in segments(elf)? {
        for (address, &byte) in (start..).zip(data) {
            let page = pages.entry(address / PAGE * PAGE).or_insert([0; PAGE as usize]);
            page[(address % PAGE) as usize] = byte;
        }
    }
    Ok(pages)
}

/// The block with the number `number` of `count`.
fn block(number: u32, count: u32, address: u32, page: &[u8]) -> [u8; 512] {
    let head = [0x0a32_4655, 0x9e5d_5157, HAS_FAMILY, address, PAGE, number, count, FAMILY];
    let mut block = [0; 512];
    for (four, word) in block.chunks_exact_mut(4).zip(head) {
        four.copy_from_slice(&word.to_le_bytes());
    }
    block[32..32 + page.len()].copy_from_slice(page);
    block[508..].copy_from_slice(&0x0ab1_6f30_u32.to_le_bytes());
    block
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_has_head_page_and_end() {
        let block = block(1, 3, 0x1000_0100, &[7; PAGE as usize]);
        assert_eq!(block[..8], *b"UF2\nWQ]\x9e");
        assert_eq!(block[12..16], [0, 1, 0, 0x10]);
        assert_eq!(block[20..28], [1, 0, 0, 0, 3, 0, 0, 0]);
        assert_eq!((block[31], block[32], block[287], block[288]), (0xe4, 7, 7, 0));
        assert_eq!(block[508..], [0x30, 0x6f, 0xb1, 0x0a]);
    }
}
