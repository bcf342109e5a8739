//! The functions that QEMU calls: at installation, for each translated block and executed
//! instruction, and at the end.

use std::ffi::{CStr, c_char, c_int, c_uint, c_void};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
use std::{fs, ptr};

use crate::counts::Counts;
use crate::marker::{Architecture, Marker};
use crate::qemu;

/// Arguments of the plugin.
#[derive(Debug)]
struct Task {
    architecture: Architecture,
    /// The file to write to.
    out: String,
    /// Whether all addresses count as 0, so that a region has one line.
    is_by_region: bool,
}

static TASK: OnceLock<Task> = OnceLock::new();
static COUNTS: Mutex<Counts> = Mutex::new(Counts::new());

/// QEMU reads this version before it installs the plugin.
#[unsafe(no_mangle)]
static qemu_plugin_version: c_int = qemu::VERSION;

/// Installs the plugin: `-plugin FILE,out=COUNTS`, and `by=region` for one count a region. A result other than 0 makes QEMU stop.
///
/// # Safety
/// Only QEMU may call this: `info` must point to QEMU's description of itself, and `argv`
/// to `argc` strings.
#[unsafe(no_mangle)]
unsafe extern "C" fn qemu_plugin_install(
    id: qemu::Id,
    info: *const qemu::Info,
    argc: c_int,
    argv: *const *const c_char,
) -> c_int {
    // SAFETY: QEMU's description and the string in it live at least as long as this call.
    let target = unsafe { CStr::from_ptr((*info).target_name) }.to_string_lossy();
    let (mut out, mut is_by_region) = (None, false);
    for index in 0..usize::try_from(argc).unwrap_or(0) {
        // SAFETY: QEMU passes `argc` arguments, which live as long as this call.
        let argument = unsafe { CStr::from_ptr(*argv.add(index)) }.to_string_lossy();
        match argument.strip_prefix("out=") {
            Some(file) => out = Some(file.to_owned()),
            None if argument == "by=region" => is_by_region = true,
            None => return refuse(&format!("there is no argument {argument}")),
        }
    }
    let Some(architecture) = Architecture::of_target(&target) else {
        return refuse(&format!("the instructions of {target} are not known"));
    };
    let Some(out) = out else { return refuse("the argument out=FILE is missing") };
    if TASK.set(Task { architecture, out, is_by_region }).is_err() {
        return refuse("it is loaded already");
    }
    // SAFETY: the callbacks are functions of the types that QEMU calls, and live as long as the
    // plugin is loaded.
    unsafe {
        qemu::qemu_plugin_register_vcpu_tb_trans_cb(id, translate);
        qemu::qemu_plugin_register_atexit_cb(id, finish, ptr::null_mut());
    }
    0
}

fn refuse(reason: &str) -> c_int {
    eprintln!("luminaire-counter: {reason}");
    1
}

fn counts() -> MutexGuard<'static, Counts> {
    // Poisoning is ignored: the counts are consistent after each single step, so a panic leaves
    // nothing half done.
    COUNTS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Called when QEMU translates a block: registers callbacks for the execution of its instructions.
extern "C" fn translate(_: qemu::Id, block: *mut qemu::Block) {
    let Some(task) = TASK.get() else { return };
    // SAFETY: QEMU keeps the block and its instructions alive for this call; the indices are below
    // the number of instructions; a second halfword is read only of an instruction that has one.
    unsafe {
        for index in 0..qemu::qemu_plugin_tb_n_insns(block) {
            let instruction = qemu::qemu_plugin_tb_get_insn(block, index);
            let first = qemu::halfword(instruction, 0);
            let mut bits = u32::from(first);
            if task.architecture.is_wide(first) {
                bits |= u32::from(qemu::halfword(instruction, 1)) << 16;
            }
            let (callback, userdata): (extern "C" fn(c_uint, *mut c_void), _) =
                match task.architecture.marker(bits) {
                    Some(Marker::Begin) => (begin, ptr::null_mut()),
                    Some(Marker::End) => (end, ptr::null_mut()),
                    // This pointer is never dereferenced: it carries the address through QEMU to
                    // the callback.
                    None => {
                        let address =
                            if task.is_by_region { 0 } else { qemu::qemu_plugin_insn_vaddr(instruction) };
                        (execute, ptr::without_provenance_mut(address as usize))
                    }
                };
            qemu::qemu_plugin_register_vcpu_insn_exec_cb(instruction, callback, qemu::NO_REGISTERS, userdata);
        }
    }
}

extern "C" fn begin(_: c_uint, _: *mut c_void) {
    counts().mark(Marker::Begin);
}

extern "C" fn end(_: c_uint, _: *mut c_void) {
    counts().mark(Marker::End);
}

extern "C" fn execute(_: c_uint, address: *mut c_void) {
    counts().execute(address.addr() as u64);
}

extern "C" fn finish(_: qemu::Id, _: *mut c_void) {
    let Some(task) = TASK.get() else { return };
    if let Err(error) = fs::write(&task.out, counts().to_string()) {
        eprintln!("luminaire-counter: cannot write {}: {error}", task.out);
    }
}
