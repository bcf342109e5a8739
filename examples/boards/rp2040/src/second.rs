//! The second core.

use rp2040_hal as hal;

use cortex_m::{asm, singleton};
use hal::multicore::{Multicore, Stack};
use hal::pac::{PPB, PSM};
use hal::sio::SioFifo;
use heapless::spsc::{Consumer, Producer, Queue};
use luminaire_panel::{Job, Second};

/// 4 kB.
static STACK: Stack<1024> = Stack::new();

/// The second core, which draws the rows of a queue.
pub(crate) struct Core1 {
    jobs: Producer<'static, Job>,
    done: Consumer<'static, Job>,
}

impl Core1 {
    /// Starts the core. `None` if it does not answer.
    pub(crate) fn start(psm: &mut PSM, ppb: &mut PPB, fifo: &mut SioFifo) -> Option<Self> {
        let (jobs, mut orders) = singleton!(: Queue<Job, 2> = Queue::new())?.split();
        let (mut finished, done) = singleton!(: Queue<Job, 2> = Queue::new())?.split();
        let mut cores = Multicore::new(psm, ppb, fifo);
        let core1 = cores.cores().get_mut(1)?;
        let draw = move || loop {
            let mut job = wait(|| orders.dequeue());
            job.run();
            // There is one job at a time, and room for it.
            let _: Result<(), Job> = finished.enqueue(job);
            asm::sev();
        };
        core1.spawn(STACK.take()?, draw).ok()?;
        Some(Self { jobs, done })
    }
}

impl Second for Core1 {
    fn start(&mut self, job: Job) -> Option<()> {
        self.jobs.enqueue(job).ok()?;
        asm::sev();
        Some(())
    }

    fn finish(&mut self) -> Option<Job> {
        Some(wait(|| self.done.dequeue()))
    }
}

/// Waits for what the other core sends. It signals an event afterwards.
fn wait<T>(mut received: impl FnMut() -> Option<T>) -> T {
    loop {
        if let Some(received) = received() {
            return received;
        }
        asm::wfe();
    }
}
