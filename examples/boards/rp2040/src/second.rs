//! The second core. Sections are those of the RP2040's data sheet.

use cortex_m::asm;
use luminaire_panel::{Job, Second};
use rp2040_pac::{PSM, SIO};

/// What the second core needs.
pub(crate) struct Memory {
    job: Option<Job>,
    /// 4 kB. Stacks are aligned to 8 bytes.
    stack: [u64; 512],
}

impl Memory {
    pub(crate) const fn new() -> Self {
        Self { job: None, stack: [0; 512] }
    }
}

/// The second core, which draws one row after the other.
pub(crate) struct Core1<'a> {
    /// The FIFOs to and from the second core: an address sent gives it a job, and sent back ends the job.
    fifo: &'a SIO,
    job: &'static mut Option<Job>,
}

impl<'a> Core1<'a> {
    /// Starts the core. `vectors` is the address of the table of interrupts.
    pub(crate) fn start(power: &PSM, fifo: &'a SIO, vectors: u32, memory: &'static mut Memory) -> Self {
        power.frce_off().modify(|_, w| w.proc1().set_bit());
        while power.frce_off().read().proc1().bit_is_clear() {}
        power.frce_off().modify(|_, w| w.proc1().clear_bit());

        // The boot ROM of the second core sends each word back that it expects (2.8.2).
        let Memory { job, stack } = memory;
        let stack = stack.as_mut_ptr_range().end as u32;
        let words = [0, 0, 1, vectors, stack, draw as extern "C" fn() -> ! as usize as u32];
        let mut sent = 0;
        while let Some(&word) = words.get(sent) {
            if word == 0 {
                while fifo.fifo_st().read().vld().bit_is_set() {
                    fifo.fifo_rd().read();
                }
                asm::sev();
            }
            send(fifo, word);
            sent = if receive(fifo) == word { sent + 1 } else { 0 };
        }
        Self { fifo, job }
    }
}

impl Second for Core1<'_> {
    fn start(&mut self, job: Job) -> Option<()> {
        if self.job.is_some() {
            return None;
        }
        let job: *mut Job = self.job.insert(job);
        send(self.fifo, job as u32);
        Some(())
    }

    fn finish(&mut self) -> Option<Job> {
        if self.job.is_some() {
            receive(self.fifo);
        }
        self.job.take()
    }
}

/// What the second core does.
extern "C" fn draw() -> ! {
    // SAFETY: each core has a FIFO of its own at this address, and the second core uses nothing else there.
    let fifo = unsafe { SIO::steal() };
    loop {
        let job = receive(&fifo);
        // SAFETY: the first core sends the address of a job, and does not touch the job until it is sent back.
        unsafe { (*(job as *mut Job)).run() };
        send(&fifo, job);
    }
}

/// Sends a word to the other core, after all that this core has written.
fn send(fifo: &SIO, word: u32) {
    while fifo.fifo_st().read().rdy().bit_is_clear() {}
    asm::dmb();
    // SAFETY: any word is allowed.
    fifo.fifo_wr().write(|w| unsafe { w.bits(word) });
    asm::sev();
}

/// Waits for a word of the other core.
fn receive(fifo: &SIO) -> u32 {
    while fifo.fifo_st().read().vld().bit_is_clear() {
        asm::wfe();
    }
    let word = fifo.fifo_rd().read().bits();
    asm::dmb();
    word
}
