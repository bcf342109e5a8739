//! A moving lit stage on an RP2040 with an ST7789.
//!
//! While the two cores draw a row each, the DMA sends the two rows before these to the display. After each
//! picture the program prints the checksum of its pixels and the cycles of its drawing on the
//! UART.
#![no_std]
#![no_main]

mod clock;
mod console;
mod panel;
mod second;

use core::arch::asm;
use core::convert::Infallible;
use core::mem::MaybeUninit;

use panic_halt as _;
use rp2040_pac as pac;

use clock::Delay;
use console::Console;
use luminaire_panel::Rows;
use luminaire_stage::Markers;
use panel::Panel;
use second::{Core1, Memory};

/// The second stage of the boot, which the boot ROM runs: it reads the flash four bits at a time. It suits that
/// of a Pico, Winbond's W25Q16JV.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

#[cortex_m_rt::entry]
fn main() -> ! {
    static mut MEMORY: Memory = Memory::new();
    static mut ROWS: MaybeUninit<Rows<Marked>> = MaybeUninit::uninit();
    // The set-up fails only if the display's driver refuses its options.
    let _: Option<Infallible> = show(MEMORY, ROWS.write(Rows::default()));
    loop {
        cortex_m::asm::wfe();
    }
}

/// Shows the pictures for ever.
fn show(memory: &'static mut Memory, rows: &'static mut Rows<Marked>) -> Option<Infallible> {
    // SAFETY: this runs once, on the first core, and nothing else has the peripherals.
    let (chip, mut core) = unsafe { (pac::Peripherals::steal(), cortex_m::Peripherals::steal()) };
    clock::start(&chip);
    let mut console = Console::start(chip.UART0, &chip.IO_BANK0);
    let mut panel = Panel::start(chip.SPI0, chip.DMA, &chip.IO_BANK0, &chip.SIO, &mut Delay(chip.TIMER))?;
    let mut second = Core1::start(&chip.PSM, &chip.SIO, core.SCB.vtor.read(), memory);
    luminaire_panel::show(&mut panel, &mut second, rows, clock::count(&mut core.SYST), &mut console)
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
