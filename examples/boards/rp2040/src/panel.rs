//! The display at SPI0, fed by DMA.

use rp2040_hal as hal;

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::{MODE_3, SpiBus};
use hal::dma::single_buffer::Config;
use hal::dma::{CH0, Channel};
use hal::fugit::HertzU32;
use hal::gpio::bank0::{Gpio16, Gpio17, Gpio18, Gpio19, Gpio20};
use hal::gpio::{FunctionSio, FunctionSpi, Pin, PullDown, SioOutput};
use hal::pac::{RESETS, SPI0};
use hal::spi::{Enabled, Spi};
use luminaire_panel::Words;

/// The highest clock of the bus: the shortest write cycle of an ST7789 is 16 ns.
const BAUD: HertzU32 = HertzU32::MHz(62);

type Output<Gpio> = Pin<Gpio, FunctionSio<SioOutput>, PullDown>;
type Wire<Gpio> = Pin<Gpio, FunctionSpi, PullDown>;
type Wires = (Wire<Gpio19>, Wire<Gpio18>);
type Bus = Spi<Enabled, SPI0, Wires, 16>;

/// The pins of the display.
pub(crate) struct Pads {
    /// The bus's data and clock.
    pub(crate) wires: Wires,
    /// Low for commands, high for their parameters and for pixels.
    pub(crate) is_data: Output<Gpio16>,
    /// Chip select, which is low while the display is addressed.
    pub(crate) select: Output<Gpio17>,
    /// Low resets the display.
    pub(crate) reset: Output<Gpio20>,
}

/// The display, started.
pub(crate) struct Panel {
    /// The bus and the DMA channel that feeds it; `None` while pixels are being sent.
    idle: Option<(Channel<CH0>, Bus)>,
    is_data: Output<Gpio16>,
}

impl Panel {
    /// Starts the display. `None` if its driver refuses the options.
    pub(crate) fn start(
        pads: Pads,
        device: SPI0,
        channel: Channel<CH0>,
        resets: &mut RESETS,
        speed: HertzU32,
        delay: &mut impl DelayNs,
    ) -> Option<Self> {
        let Pads { wires, mut is_data, mut select, reset } = pads;
        // The driver sends bytes, and the DMA words of 16 bits.
        let mut bytes = Spi::<_, _, _, 8>::new(device, wires).init(resets, speed, BAUD, MODE_3);
        luminaire_panel::start(&mut bytes, &mut is_data, &mut select, reset, delay)?;
        let (device, wires) = bytes.disable().free();
        let bus = Spi::<_, _, _, 16>::new(device, wires).init(resets, speed, BAUD, MODE_3);
        select.set_low().ok()?;
        Some(Self { idle: Some((channel, bus)), is_data })
    }
}

impl luminaire_panel::Panel for Panel {
    fn write(&mut self, is_data: bool, words: &[u16]) -> Option<()> {
        let (_, bus) = self.idle.as_mut()?;
        // The DMA has ended before the bus has sent its last words.
        bus.flush().ok()?;
        self.is_data.set_state(is_data.into()).ok()?;
        bus.write(words).ok()?;
        bus.flush().ok()
    }

    fn send<const COUNT: usize>(
        &mut self,
        pixels: Words<COUNT>,
        meanwhile: impl FnOnce(),
    ) -> Option<Words<COUNT>> {
        let (channel, bus) = self.idle.take()?;
        let transfer = Config::new(channel, pixels, bus).start();
        meanwhile();
        let (channel, pixels, bus) = transfer.wait();
        self.idle = Some((channel, bus));
        Some(pixels)
    }
}
