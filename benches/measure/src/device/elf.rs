//! What a linked program loads.

use anyhow::{Context, Result};
use object::LittleEndian;
use object::elf::{FileHeader32, PT_LOAD};
use object::read::elf::{FileHeader, ProgramHeader};

/// The bytes that a program of 32 bits loads, with the address at which a flash or a cartridge has them.
pub(super) fn segments(elf: &[u8]) -> Result<Vec<(u32, &[u8])>> {
    let header = FileHeader32::<LittleEndian>::parse(elf)?;
    let endian = header.endian()?;
    let loaded =
        header.program_headers(endian, elf)?.iter().filter(|segment| segment.p_type(endian) == PT_LOAD);
    let bytes = |segment: &<FileHeader32<LittleEndian> as FileHeader>::ProgramHeader| {
        let data = segment.data(endian, elf).ok().context("a segment is not in the file")?;
        Ok((segment.p_paddr(endian), data))
    };
    loaded.map(bytes).collect()
}
