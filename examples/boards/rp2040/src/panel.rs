//! The display at SPI0, fed by DMA.

use core::convert::Infallible;

use cortex_m::asm::dsb;
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::{ErrorKind, Operation, SpiDevice};
use embedded_hal::{digital, spi};
use luminaire_panel::Words;
use rp2040_pac::{DMA, IO_BANK0, SIO, SPI0};

/// Pins of the bus: its clock and its data.
const WIRES: [usize; 2] = [18, 19];
/// Pin that is low for commands, high for their parameters and for pixels.
const IS_DATA: usize = 16;
/// Pin that is low while the display is addressed.
const SELECT: usize = 17;
/// Pin that resets the display when it is low.
const RESET: usize = 20;

/// The display, started.
pub(crate) struct Panel<'a> {
    bus: Bus,
    dma: DMA,
    is_data: Output<'a>,
}

impl<'a> Panel<'a> {
    /// Starts the display. `None` if its driver refuses the options.
    pub(crate) fn start(
        device: SPI0,
        dma: DMA,
        pins: &IO_BANK0,
        levels: &'a SIO,
        delay: &mut impl DelayNs,
    ) -> Option<Self> {
        for wire in WIRES {
            pins.gpio(wire).gpio_ctrl().write(|w| w.funcsel().spi());
        }
        let [mut is_data, mut select, reset] =
            [IS_DATA, SELECT, RESET].map(|pin| Output::new(pin, pins, levels));
        // The driver sends bytes, and the DMA words of 16 bits.
        let mut bus = Bus(device);
        bus.start(8);
        let Ok(()) = select.set_high();
        luminaire_panel::start(Selected(&mut bus, &mut select), &mut is_data, reset, delay)?;
        bus.start(16);
        select.set_low().ok()?;
        Some(Self { bus, dma, is_data })
    }
}

impl luminaire_panel::Panel for Panel<'_> {
    fn write(&mut self, is_data: bool, words: &[u16]) -> Option<()> {
        // The DMA has ended before the bus has sent its last words.
        self.bus.wait();
        self.is_data.set_state(is_data.into()).ok()?;
        words.iter().for_each(|&word| self.bus.send(word));
        self.bus.wait();
        Some(())
    }

    fn send<const COUNT: usize>(
        &mut self,
        pixels: Words<COUNT>,
        meanwhile: impl FnOnce(),
    ) -> Option<Words<COUNT>> {
        let channel = self.dma.ch(0);
        // What was drawn is in the memory before the DMA reads it, and stays until it has been read.
        dsb();
        // SAFETY: the DMA reads the pixels, which nothing changes meanwhile, and writes to the bus.
        unsafe {
            channel.ch_read_addr().write(|w| w.bits(pixels.as_ptr() as u32));
            channel.ch_write_addr().write(|w| w.bits(self.bus.0.sspdr().as_ptr() as u32));
            channel.ch_trans_count().write(|w| w.bits(COUNT as u32));
            channel.ch_ctrl_trig().write(|w| {
                // A channel that is chained to itself starts no other one.
                w.chain_to().bits(0).treq_sel().spi0_tx().data_size().size_halfword();
                w.incr_read().set_bit().en().set_bit()
            });
        }
        meanwhile();
        while channel.ch_ctrl_trig().read().busy().bit_is_set() {}
        dsb();
        Some(pixels)
    }
}

/// The bus, which only sends.
struct Bus(SPI0);

impl Bus {
    /// Starts the bus with words of some bits, in mode 3, at 33 MHz: a write cycle of an ST7789 takes at least
    /// 16 ns, and the clock is 133 MHz by an even number (4.4.3.4).
    fn start(&mut self, bits: u8) {
        let Self(device) = self;
        device.sspcr1().write(|w| w.sse().clear_bit());
        // SAFETY: words of 4 to 16 bits are allowed, less 1, and dividing by an even number times 1 to 256, less 1.
        unsafe {
            device.sspcpsr().write(|w| w.cpsdvsr().bits(2));
            device.sspcr0().write(|w| w.dss().bits(bits - 1).scr().bits(1).spo().set_bit().sph().set_bit());
        }
        device.sspdmacr().write(|w| w.txdmae().set_bit());
        device.sspcr1().write(|w| w.sse().set_bit());
    }

    /// Sends a word after all that were sent before.
    fn send(&self, word: u16) {
        while self.0.sspsr().read().tnf().bit_is_clear() {}
        // SAFETY: any word is allowed.
        self.0.sspdr().write(|w| unsafe { w.data().bits(word) });
    }

    /// Waits until all words are sent.
    fn wait(&self) {
        while self.0.sspsr().read().bsy().bit_is_set() {}
    }
}

/// The bus while the driver starts the display: the pin selects it.
struct Selected<'a, 'b>(&'a mut Bus, &'a mut Output<'b>);

impl spi::ErrorType for Selected<'_, '_> {
    type Error = ErrorKind;
}

impl SpiDevice for Selected<'_, '_> {
    fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), ErrorKind> {
        let Self(bus, select) = self;
        let Ok(()) = select.set_low();
        for operation in operations {
            // No pin is connected to what the display would send.
            let Operation::Write(bytes) = operation else { return Err(ErrorKind::Other) };
            bytes.iter().for_each(|&byte| bus.send(byte.into()));
        }
        bus.wait();
        let Ok(()) = select.set_high();
        Ok(())
    }
}

/// A pin whose level the program sets.
struct Output<'a> {
    mask: u32,
    levels: &'a SIO,
}

impl<'a> Output<'a> {
    fn new(pin: usize, pins: &IO_BANK0, levels: &'a SIO) -> Self {
        let mask = 1 << pin;
        // SAFETY: the pin is an output of the program.
        levels.gpio_oe_set().write(|w| unsafe { w.bits(mask) });
        pins.gpio(pin).gpio_ctrl().write(|w| w.funcsel().sio());
        Self { mask, levels }
    }
}

impl digital::ErrorType for Output<'_> {
    type Error = Infallible;
}

impl OutputPin for Output<'_> {
    fn set_low(&mut self) -> Result<(), Infallible> {
        // SAFETY: the pin is an output of the program.
        self.levels.gpio_out_clr().write(|w| unsafe { w.bits(self.mask) });
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        // SAFETY: the pin is an output of the program.
        self.levels.gpio_out_set().write(|w| unsafe { w.bits(self.mask) });
        Ok(())
    }
}
