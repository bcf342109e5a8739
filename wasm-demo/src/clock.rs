//! Times in milliseconds, measured by the browser's clock.

use wasm_bindgen::JsCast;
use web_sys::{
    Performance,
    js_sys::{self, Date, Reflect},
};

/// The browser's `performance`, looked up once. Without it the date is precise enough, because
/// times are only displayed.
#[derive(Clone, Debug)]
pub(crate) struct Clock {
    performance: Option<Performance>,
}

thread_local! {
    static CLOCK: Clock = Clock::new();
}

/// The time in nanoseconds since a fixed but arbitrary moment.
pub(crate) fn nanoseconds() -> f64 {
    CLOCK.with(|clock| 1e6 * clock.now())
}

impl Clock {
    /// The clock of this window or worker.
    pub(crate) fn new() -> Self {
        let performance = Reflect::get(&js_sys::global(), &"performance".into());
        Self { performance: performance.ok().and_then(|found| found.dyn_into().ok()) }
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
