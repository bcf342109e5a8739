//! Milliseconds, by the browser's clock.

use crate::refusal::Refusal;
use web_sys::Performance;

/// `performance.now()`, looked up once.
#[derive(Clone, Debug)]
pub(crate) struct Clock {
    performance: Performance,
}

impl Clock {
    /// The clock of this window.
    pub(crate) fn new() -> Result<Self, Refusal> {
        let performance = web_sys::window().and_then(|window| window.performance());
        match performance {
            Some(performance) => Ok(Self { performance }),
            None => Err(Refusal::Browser {
                what: "the clock",
                reason: "window.performance is missing: open the page in a browser window".to_owned(),
            }),
        }
    }

    /// How long something takes, in milliseconds, and what came of it.
    pub(crate) fn time<T>(&self, work: impl FnOnce() -> T) -> (f64, T) {
        let start = self.performance.now();
        let done = work();
        (self.performance.now() - start, done)
    }
}
