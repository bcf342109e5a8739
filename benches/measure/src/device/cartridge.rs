//! The cartridge of a Game Boy Advance: the bytes from the first on, with a header in the first 192.
//!
//! GBATEK, "GBA Cartridge Header", describes the header.

use std::fs;
use std::ops::Range;
use std::path::Path;

use anyhow::{Context, Result, ensure};

use super::elf::segments;

/// The address of its first byte.
const START: u32 = 0x0800_0000;
/// The bytes of the header that its check is of, and the place of the check.
const CHECKED: Range<usize> = 0xa0..0xbd;
const CHECK: usize = 0xbd;
/// The byte that every header has, and its place.
const FIXED: (usize, u8) = (0xb2, 0x96);

/// Converts a program to the bytes of a cartridge, and writes the check of the header.
pub(super) fn image(file: &Path) -> Result<Vec<u8>> {
    let content = fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
    let loaded = segments(&content).and_then(|segments| place(&segments));
    let mut bytes = loaded.with_context(|| format!("cannot read the program {}", file.display()))?;
    let fixed = bytes.get(FIXED.0).copied();
    ensure!(
        fixed == Some(FIXED.1),
        "{}: no header of a cartridge: {fixed:?} at {:#x}",
        file.display(),
        FIXED.0
    );
    bytes[CHECK] = check(&bytes[CHECKED]);
    Ok(bytes)
}

/// The bytes of segments at their places from [`START`] on.
fn place(segments: &[(u32, &[u8])]) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    for (address, data) in segments.iter().filter(|(_, data)| !data.is_empty()) {
        let from =
            address.checked_sub(START).with_context(|| format!("{address:#x} is before the cartridge"))?;
        let range = from as usize..from as usize + data.len();
        if bytes.len() < range.end {
            bytes.resize(range.end, 0);
        }
        bytes[range].copy_from_slice(data);
    }
    Ok(bytes)
}

/// The check of a header: with the bytes and 0x19 its sum is 0, modulo 256.
fn check(header: &[u8]) -> u8 {
    header.iter().fold(0x19_u8, |sum, byte| sum.wrapping_add(*byte)).wrapping_neg()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_check_makes_the_sum_zero() {
        // A header of zeros but for the fixed byte.
        let mut header = [0; 29];
        header[FIXED.0 - CHECKED.start] = FIXED.1;
        assert_eq!(check(&header), 0x51);
        assert_eq!(check(&[0xe7]), 0);
    }

    #[test]
    fn segments_are_placed_by_their_addresses_and_empty_ones_left_out() {
        let segments: [(u32, &[u8]); 3] =
            [(0x0800_0003, &[3, 4]), (0x0800_0000, &[1, 2]), (0x0200_0000, &[])];
        assert_eq!(place(&segments).unwrap(), [1, 2, 0, 3, 4]);
        assert!(place(&[(0x0200_0000, &[1])]).unwrap_err().to_string().contains("0x2000000"));
    }
}
