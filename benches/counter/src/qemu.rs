//! The few functions of QEMU's plugin interface that the counter needs, declared as in QEMU's
//! documentation.

use std::ffi::{c_char, c_int, c_uint, c_void};

/// The version of the interface that the plugin is written for. QEMU refuses to load a plugin of a
/// version that it does not support.
#[cfg(not(feature = "api-3"))]
pub(crate) const VERSION: c_int = 1;
#[cfg(feature = "api-3")]
pub(crate) const VERSION: c_int = 3;

/// The number by which QEMU identifies the plugin.
pub(crate) type Id = u64;

/// The first fields of QEMU's description of itself; the rest is not needed.
#[repr(C)]
#[derive(Debug)]
pub(crate) struct Info {
    /// QEMU's name of the architecture, such as `arm`.
    pub(crate) target_name: *const c_char,
}

/// A block of instructions that is being translated. Only QEMU looks inside.
#[repr(C)]
#[derive(Debug)]
pub(crate) struct Block {
    _opaque: [u8; 0],
}

/// An instruction of a block that is being translated. Only QEMU looks inside.
#[repr(C)]
#[derive(Debug)]
pub(crate) struct Instruction {
    _opaque: [u8; 0],
}

/// A callback that neither reads nor writes the processor's registers.
pub(crate) const NO_REGISTERS: c_int = 0;

unsafe extern "C" {
    pub(crate) fn qemu_plugin_register_vcpu_tb_trans_cb(id: Id, callback: extern "C" fn(Id, *mut Block));
    pub(crate) fn qemu_plugin_register_atexit_cb(
        id: Id,
        callback: extern "C" fn(Id, *mut c_void),
        userdata: *mut c_void,
    );
    pub(crate) fn qemu_plugin_register_vcpu_insn_exec_cb(
        instruction: *mut Instruction,
        callback: extern "C" fn(c_uint, *mut c_void),
        flags: c_int,
        userdata: *mut c_void,
    );
    pub(crate) fn qemu_plugin_tb_n_insns(block: *const Block) -> usize;
    pub(crate) fn qemu_plugin_tb_get_insn(block: *const Block, index: usize) -> *mut Instruction;
    pub(crate) fn qemu_plugin_insn_vaddr(instruction: *const Instruction) -> u64;
    #[cfg(not(feature = "api-3"))]
    fn qemu_plugin_insn_data(instruction: *const Instruction) -> *const c_void;
    #[cfg(feature = "api-3")]
    fn qemu_plugin_insn_data(instruction: *const Instruction, copy: *mut c_void, length: usize) -> usize;
}

/// Reads the halfword of this index from an instruction. All architectures are little-endian.
///
/// # Safety
/// QEMU must be translating the instruction now, and the instruction must be long enough
/// to have this halfword.
pub(crate) unsafe fn halfword(instruction: *const Instruction, index: usize) -> u16 {
    let mut bytes = [0_u8; 4];
    #[cfg(not(feature = "api-3"))]
    {
        // SAFETY: by the caller's promise the instruction is alive and has `2 * index + 2` bytes,
        // and QEMU's pointer is to its bytes, which it keeps until the translation ends.
        unsafe {
            let data = qemu_plugin_insn_data(instruction).cast::<u8>();
            data.add(2 * index).copy_to_nonoverlapping(bytes.as_mut_ptr().add(2 * index), 2);
        }
    }
    #[cfg(feature = "api-3")]
    {
        // SAFETY: by the caller's promise the instruction is alive; QEMU writes at most the four
        // bytes we have.
        unsafe { qemu_plugin_insn_data(instruction, bytes.as_mut_ptr().cast(), bytes.len()) };
    }
    u16::from_le_bytes([bytes[2 * index], bytes[2 * index + 1]])
}
