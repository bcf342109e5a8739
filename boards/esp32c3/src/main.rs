//! A moving lit stage on an ESP32-C3 with an ST7789.
//!
//! While the processor draws a row, the DMA sends the row before it to the display. After each
//! picture the program prints the checksum of its pixels and the cycles of its drawing on the USB
//! serial port, or on the UART if no USB host is connected.
#![no_std]
#![no_main]

mod clock;
mod panel;

use core::convert::Infallible;

use esp_hal::clock::CpuClock;
use esp_hal::delay::Delay;
use esp_hal::gpio::{Level, Output, OutputConfig};
use esp_hal::spi::Mode;
use esp_hal::spi::master::{Config, Spi};
use esp_hal::time::Rate;
use esp_println::Printer;
use luminaire_panel::Rows;
use panic_halt as _;
use static_cell::ConstStaticCell;

use panel::Panel;

esp_bootloader_esp_idf::esp_app_desc!();

#[esp_hal::main]
fn main() -> ! {
    // The set-up fails only if a driver refuses its options.
    let _: Option<Infallible> = show();
    loop {
        core::hint::spin_loop();
    }
}

/// Shows the pictures for ever.
fn show() -> Option<Infallible> {
    static ROWS: ConstStaticCell<Rows> = ConstStaticCell::new(Rows::BLACK);
    // 160 MHz.
    let device = esp_hal::init(esp_hal::Config::default().with_cpu_clock(CpuClock::max()));
    // The next higher clock is 80 MHz, and the shortest write cycle of an ST7789 is 16 ns.
    let config = Config::default().with_frequency(Rate::from_mhz(40)).with_mode(Mode::_3);
    let bus = Spi::new(device.SPI2, config).ok()?.with_sck(device.GPIO6).with_mosi(device.GPIO7);
    let select = Output::new(device.GPIO10, Level::High, OutputConfig::default());
    let is_data = Output::new(device.GPIO4, Level::High, OutputConfig::default());
    let reset = Output::new(device.GPIO5, Level::High, OutputConfig::default());
    let mut panel = Panel::start(bus, device.DMA_CH0, is_data, select, reset, &mut Delay::new())?;
    luminaire_panel::show::<()>(&mut panel, ROWS.take(), clock::count(), &mut Printer)
}
