//! A moving lit stage on an RP2040 with an ST7789.
//!
//! While the two cores draw a row each, the DMA sends the two rows before these to the display. After each
//! picture the program prints the checksum of its pixels and the cycles of its drawing on the
//! UART.
#![no_std]
#![no_main]

mod clock;
mod panel;
mod second;

use core::arch::asm;
use core::convert::Infallible;

use hal::Clock;
use hal::dma::DMAExt;
use hal::gpio::{FunctionUart, Pins};
use hal::uart::{UartConfig, UartPeripheral};
use hal::{Sio, Timer, pac};
use panic_halt as _;
use rp2040_hal as hal;

use luminaire_panel::Rows;
use luminaire_stage::Markers;
use panel::{Pads, Panel};
use second::Core1;

/// The second stage of the boot, which the boot ROM runs: it reads the flash four bits at a time. It suits that
/// of a Pico, Winbond's W25Q16JV.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

#[hal::entry]
fn main() -> ! {
    // The set-up fails only if a clock does not start or the display's driver refuses its options.
    let _: Option<Infallible> = show();
    loop {
        cortex_m::asm::wfe();
    }
}

/// Shows the pictures for ever.
fn show() -> Option<Infallible> {
    let mut pac = pac::Peripherals::take()?;
    let mut core = pac::CorePeripherals::take()?;
    let clocks = clock::start(pac.XOSC, pac.CLOCKS, pac.PLL_SYS, &mut pac.RESETS, pac.WATCHDOG)?;
    let speed = clocks.peripheral_clock.freq();
    let mut timer = Timer::new(pac.TIMER, &mut pac.RESETS, &clocks);
    let mut sio = Sio::new(pac.SIO);
    let pins = Pins::new(pac.IO_BANK0, pac.PADS_BANK0, sio.gpio_bank0, &mut pac.RESETS);

    let tx = pins.gpio0.into_function::<FunctionUart>();
    let rx = pins.gpio1.into_function::<FunctionUart>();
    let uart = UartPeripheral::new(pac.UART0, (tx, rx), &mut pac.RESETS);
    let mut uart = uart.enable(UartConfig::default(), speed).ok()?;

    let pads = Pads {
        wires: (pins.gpio19.into_function(), pins.gpio18.into_function()),
        is_data: pins.gpio16.into_function(),
        select: pins.gpio17.into_function(),
        reset: pins.gpio20.into_function(),
    };
    let channel = pac.DMA.split(&mut pac.RESETS).ch0;
    let mut panel = Panel::start(pads, pac.SPI0, channel, &mut pac.RESETS, speed, &mut timer)?;

    let mut second = Core1::start(&mut pac.PSM, &mut pac.PPB, &mut sio.fifo)?;
    let rows = cortex_m::singleton!(: Rows<Marked> = Rows::default())?;
    luminaire_panel::show(&mut panel, &mut second, rows, clock::count(&mut core.SYST), &mut uart)
}

/// The markers by which emulators count instructions: they do nothing.
#[derive(Debug)]
struct Marked;

impl Markers for Marked {
    #[inline(always)]
    fn begin() {
        // SAFETY: a move of a register to itself changes nothing.
        unsafe { asm!("mov r10, r10", options(nostack, preserves_flags)) };
    }

    #[inline(always)]
    fn end() {
        // SAFETY: a move of a register to itself changes nothing.
        unsafe { asm!("mov r11, r11", options(nostack, preserves_flags)) };
    }
}
