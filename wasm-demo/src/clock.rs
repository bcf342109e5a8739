//! Times in milliseconds, measured by the browser's clock.

use web_sys::{Performance, js_sys::Date};

/// The browser's `performance`, looked up once. Without it the date is precise enough, because
/// times are only displayed.
#[derive(Clone, Debug)]
pub(crate) struct Clock {
    performance: Option<Performance>,
}

impl Clock {
    /// The clock of this window.
    pub(crate) fn new() -> Self {
        Self { performance: web_sys::window().and_then(|window| window.performance()) }
    }

    /// Runs `work`. Returns its time in milliseconds and its result.
    pub(crate) fn time<T>(&self, work: impl FnOnce() -> T) -> (f64, T) {
        let start = self.now();
        let done = work();
        (self.now() - start, done)
    }

    fn now(&self) -> f64 {
        self.performance.as_ref().map_or_else(Date::now, Performance::now)
    }
}
