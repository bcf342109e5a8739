//! A moving lit stage on an STM32F411 with an ST7789.
//!
//! After each picture the program prints the checksum of its pixels and the cycles of its drawing
//! on the UART.
#![no_std]
#![no_main]

mod panel;

use core::convert::Infallible;

use cortex_m::peripheral::DWT;
use cortex_m_rt::entry;
use embedded_hal::spi::MODE_3;
use luminaire_panel::Rows;
use panic_halt as _;
use stm32f4xx_hal::gpio::Speed;
use stm32f4xx_hal::pac::{CorePeripherals, PWR, Peripherals, SPI1};
use stm32f4xx_hal::prelude::*;
use stm32f4xx_hal::rcc::{Config, Enable};

use panel::Panel;

#[entry]
fn main() -> ! {
    // The set-up fails only if the display's driver refuses its options.
    let _: Option<Infallible> = show();
    loop {
        cortex_m::asm::wfe();
    }
}

/// Shows the pictures for ever.
fn show() -> Option<Infallible> {
    let mut device = Peripherals::take()?;
    let mut core = CorePeripherals::take()?;
    // Above 84 MHz the processor needs the regulator's highest voltage, which the HAL does not set.
    PWR::enable(&mut device.RCC);
    // SAFETY: 3 is a value of this field: scale 1, up to 100 MHz.
    device.PWR.cr().modify(|_, w| unsafe { w.vos().bits(3) });
    // The crystal of a Black Pill, and the highest clock of the data sheet.
    let mut rcc = device.RCC.freeze(Config::hse(25.MHz()).sysclk(100.MHz()));
    let mut delay = core.SYST.delay(&rcc.clocks);
    let (a, b) = (device.GPIOA.split(&mut rcc), device.GPIOB.split(&mut rcc));

    let mut uart = device.USART1.tx(a.pa9, 115_200.bps(), &mut rcc).ok()?;

    let clock = a.pa5.into_alternate().speed(Speed::VeryHigh);
    let data = a.pa7.into_alternate().speed(Speed::VeryHigh);
    // Half of the processor's clock. The shortest write cycle of an ST7789 is 16 ns.
    let bus = device.SPI1.spi((Some(clock), SPI1::NoMiso, Some(data)), MODE_3, 50.MHz(), &mut rcc);
    let (select, is_data) = (a.pa4.into_push_pull_output(), b.pb0.into_push_pull_output());
    let mut panel = Panel::start(bus, is_data, select, b.pb1.into_push_pull_output(), &mut delay)?;

    core.DCB.enable_trace();
    core.DWT.enable_cycle_counter();
    let rows = cortex_m::singleton!(: Rows = Rows::BLACK)?;
    luminaire_panel::show::<()>(&mut panel, rows, DWT::cycle_count, &mut uart)
}
