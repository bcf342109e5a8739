//! A moving lit stage on an RP2040 with an ST7789: a still of 240 x 240 pixels, then frames of
//! 160 x 120 pixels in a window in its middle, then the still again.
//!
//! While the processor draws a row, the DMA sends the row before it to the display. After each
//! picture the program prints the checksum of its pixels and the cycles of its drawing on the
//! UART.
#![no_std]
#![no_main]

mod clock;
mod panel;
mod picture;

use core::convert::Infallible;
use core::fmt::Write;

use hal::Clock;
use hal::dma::DMAExt;
use hal::gpio::{FunctionUart, Pins};
use hal::uart::{UartConfig, UartPeripheral};
use hal::{Sio, Timer, pac};
use panic_halt as _;
use rp2040_hal as hal;

use luminaire_stage::FRAMES;
use panel::{Display, Panel};
use picture::Picture;

/// The second stage of the boot, for any flash: the boot ROM runs it.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_GENERIC_03H;

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
    let pins = Pins::new(pac.IO_BANK0, pac.PADS_BANK0, Sio::new(pac.SIO).gpio_bank0, &mut pac.RESETS);

    let tx = pins.gpio0.into_function::<FunctionUart>();
    let rx = pins.gpio1.into_function::<FunctionUart>();
    let uart = UartPeripheral::new(pac.UART0, (tx, rx), &mut pac.RESETS);
    let mut uart = uart.enable(UartConfig::default(), speed).ok()?;

    let display = Display {
        wires: (pins.gpio19.into_function(), pins.gpio18.into_function()),
        is_data: pins.gpio16.into_function(),
        select: pins.gpio17.into_function(),
        reset: pins.gpio20.into_function(),
    };
    let channel = pac.DMA.split(&mut pac.RESETS).ch0;
    let mut panel = Panel::start(display, pac.SPI0, channel, &mut pac.RESETS, speed, &mut timer)?;

    let counter = clock::Counter::new(&mut core.SYST);
    let mut still = Picture::<240>::new(cortex_m::singleton!(: [[u16; 240]; 2] = [[0; 240]; 2])?);
    let mut moving = Picture::<160>::new(cortex_m::singleton!(: [[u16; 160]; 2] = [[0; 160]; 2])?);
    loop {
        let report = still.draw(0, -40..200, &mut panel, &counter)?;
        writeln!(uart, "still: {report}\r").ok()?;
        for frame in 0..FRAMES {
            let report = moving.draw(frame, 0..120, &mut panel, &counter)?;
            writeln!(uart, "frame {frame}: {report}\r").ok()?;
        }
    }
}
