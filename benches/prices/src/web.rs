//! The measurements in a browser.

use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::Performance;

use crate::time::Clock;

/// `performance.now()`, whose resolution is 5 microseconds if the page is cross-origin isolated.
struct PageClock(Performance);

impl Clock for PageClock {
    fn now(&self) -> f64 {
        self.0.now() * 1e6
    }

    fn shortest(&self) -> f64 {
        500_000.0
    }
}

/// Times the kernel of this number. Returns its lines, as the host prints them; empty if there is no
/// such kernel.
#[wasm_bindgen]
pub fn time(number: usize) -> Option<String> {
    let clock = PageClock(web_sys::window()?.performance()?);
    Some(crate::time(number, &clock))
}
