//! The clocks, the timer, and the counter of cycles. Sections are those of the RP2040's data sheet.

use cortex_m::peripheral::{SYST, syst::SystClkSource};
use embedded_hal::delay::DelayNs;
use rp2040_pac::{Peripherals, TIMER};

/// Clock of the crystal of a Raspberry Pi Pico in MHz.
const CRYSTAL: u32 = 12;
/// What the crystal's clock is multiplied by.
const MULTIPLIER: u32 = 133;
/// The two numbers that the product is divided by.
const DIVISORS: [u32; 2] = [6, 2];
/// Clock of the processor and of the peripherals in Hz, the highest of the data sheet: 133 MHz.
pub(crate) const SPEED: u32 = CRYSTAL * 1_000_000 / (DIVISORS[0] * DIVISORS[1]) * MULTIPLIER;

/// Starts the clocks, and takes the peripherals that the program needs out of their reset.
pub(crate) fn start(chip: &Peripherals) {
    let Peripherals { XOSC: crystal, CLOCKS: clocks, PLL_SYS: pll, RESETS: resets, .. } = chip;
    // The crystal is stable after a millisecond (2.16.3): 47 times 256 cycles; 64 times that for slow ones.
    // SAFETY: any delay is allowed.
    crystal.startup().write(|w| unsafe { w.delay().bits(47 * 64) });
    crystal.ctrl().write(|w| w.freq_range()._1_15mhz().enable().enable());
    while crystal.status().read().stable().bit_is_clear() {}

    // Nothing may run by the PLL while it changes (2.15.3).
    clocks.clk_sys_ctrl().modify(|_, w| w.src().clk_ref());
    while clocks.clk_sys_selected().read().bits() != 1 << 0 {}
    clocks.clk_ref_ctrl().modify(|_, w| w.src().xosc_clksrc());
    while clocks.clk_ref_selected().read().bits() != 1 << 2 {}
    let hold = |hold| {
        resets.reset().modify(|_, w| {
            w.dma().bit(hold).io_bank0().bit(hold).pads_bank0().bit(hold).pll_sys().bit(hold);
            w.spi0().bit(hold).timer().bit(hold).uart0().bit(hold)
        })
    };
    hold(true);
    hold(false);
    let are_ready = || {
        let done = resets.reset_done().read();
        let ready = [done.dma().bit(), done.io_bank0().bit(), done.pads_bank0().bit(), done.pll_sys().bit()];
        ready == [true; 4] && [done.spi0().bit(), done.timer().bit(), done.uart0().bit()] == [true; 3]
    };
    while !are_ready() {}

    // The PLL is programmed in this order (2.18.3).
    // SAFETY: 16 to 320 times the crystal's clock is allowed, if the product is 750 to 1600 MHz.
    pll.fbdiv_int().write(|w| unsafe { w.fbdiv_int().bits(MULTIPLIER as u16) });
    pll.pwr().modify(|_, w| w.pd().clear_bit().vcopd().clear_bit());
    while pll.cs().read().lock().bit_is_clear() {}
    let [first, second] = DIVISORS.map(|divisor| divisor as u8);
    // SAFETY: 1 to 7 is allowed.
    pll.prim().write(|w| unsafe { w.postdiv1().bits(first).postdiv2().bits(second) });
    pll.pwr().modify(|_, w| w.postdivpd().clear_bit());

    clocks.clk_sys_ctrl().modify(|_, w| w.auxsrc().clksrc_pll_sys());
    clocks.clk_sys_ctrl().modify(|_, w| w.src().clksrc_clk_sys_aux());
    while clocks.clk_sys_selected().read().bits() != 1 << 1 {}
    clocks.clk_peri_ctrl().write(|w| w.auxsrc().clk_sys().enable().set_bit());
    // The timer counts the microseconds that the watchdog's tick generates (4.7.2).
    // SAFETY: any number of cycles is allowed.
    chip.WATCHDOG.tick().write(|w| unsafe { w.cycles().bits(CRYSTAL as u16) }.enable().set_bit());
}

/// Waits by the timer, in whole microseconds.
pub(crate) struct Delay(pub(crate) TIMER);

impl DelayNs for Delay {
    fn delay_ns(&mut self, ns: u32) {
        let now = || self.0.timerawl().read().bits();
        let start = now();
        // A microsecond may be nearly over when the wait begins.
        while now().wrapping_sub(start) <= ns.div_ceil(1_000) {}
    }
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
