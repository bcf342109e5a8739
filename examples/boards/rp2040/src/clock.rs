//! The clocks, and the counter of cycles.

use rp2040_hal as hal;

use cortex_m::peripheral::{SYST, syst::SystClkSource};
use hal::Clock;
use hal::clocks::{ClockSource, ClocksManager};
use hal::fugit::HertzU32;
use hal::pac;
use hal::pll::{PLLConfig, setup_pll_blocking};
use hal::watchdog::Watchdog;
use hal::xosc::setup_xosc_blocking;

/// The crystal of a Raspberry Pi Pico.
const CRYSTAL: HertzU32 = HertzU32::MHz(12);

/// 133 MHz: 12 MHz * 133 / 6 / 2.
const FULL_SPEED: PLLConfig =
    PLLConfig { vco_freq: HertzU32::MHz(1596), refdiv: 1, post_div1: 6, post_div2: 2 };

/// Starts the processor's and the peripherals' clock at 133 MHz, the highest of the data sheet.
pub(crate) fn start(
    xosc: pac::XOSC,
    clocks: pac::CLOCKS,
    pll: pac::PLL_SYS,
    resets: &mut pac::RESETS,
    watchdog: pac::WATCHDOG,
) -> Option<ClocksManager> {
    let xosc = setup_xosc_blocking(xosc, CRYSTAL).ok()?;
    // The timer counts the microseconds that the watchdog's tick generates.
    Watchdog::new(watchdog).enable_tick_generation(CRYSTAL.to_MHz() as u8);
    let mut clocks = ClocksManager::new(clocks);
    let pll = setup_pll_blocking(pll, CRYSTAL, FULL_SPEED, &mut clocks, resets).ok()?;
    clocks.reference_clock.configure_clock(&xosc, CRYSTAL).ok()?;
    clocks.system_clock.configure_clock(&pll, pll.get_freq()).ok()?;
    let speed = clocks.system_clock.freq();
    clocks.peripheral_clock.configure_clock(&clocks.system_clock, speed).ok()?;
    Some(clocks)
}

/// Makes SysTick count cycles, modulo 2^24. Returns the counter.
pub(crate) fn count(timer: &mut SYST) -> impl Fn() -> u32 {
    timer.set_clock_source(SystClkSource::Core);
    timer.set_reload((1 << 24) - 1);
    timer.clear_current();
    timer.enable_counter();
    // SysTick counts down.
    || !SYST::get_current()
}
