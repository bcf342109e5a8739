//! The display: an ST7789 with 240 x 240 pixels at SPI0, fed by DMA.

use rp2040_hal as hal;

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::{MODE_3, SpiBus};
use embedded_hal_bus::spi::ExclusiveDevice;
use hal::dma::single_buffer::Config;
use hal::dma::{CH0, Channel};
use hal::fugit::HertzU32;
use hal::gpio::bank0::{Gpio16, Gpio17, Gpio18, Gpio19, Gpio20};
use hal::gpio::{FunctionSio, FunctionSpi, Pin, PullDown, SioOutput};
use hal::pac::{RESETS, SPI0};
use hal::spi::{Enabled, Spi};
use mipidsi::Builder;
use mipidsi::dcs::{DcsCommand, SetColumnAddress, SetPageAddress, WriteMemoryStart};
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;
use mipidsi::options::ColorInversion;

/// Width and height of the display in pixels.
pub(crate) const SIZE: u16 = 240;
/// The highest clock of the bus: the shortest write cycle of an ST7789 is 16 ns.
const BAUD: HertzU32 = HertzU32::MHz(62);

type Output<Gpio> = Pin<Gpio, FunctionSio<SioOutput>, PullDown>;
type Wire<Gpio> = Pin<Gpio, FunctionSpi, PullDown>;
type Wires = (Wire<Gpio19>, Wire<Gpio18>);
type Bus = Spi<Enabled, SPI0, Wires, 16>;

/// A row of pixels that the DMA reads.
pub(crate) type Row<const WIDTH: usize> = &'static mut [u16; WIDTH];

/// The pins of the display.
pub(crate) struct Display {
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
    /// The bus and the DMA channel that feeds it; `None` while a row is being sent.
    idle: Option<(Channel<CH0>, Bus)>,
    is_data: Output<Gpio16>,
}

impl Panel {
    /// Starts the display. `None` if its driver refuses the options.
    pub(crate) fn start(
        display: Display,
        device: SPI0,
        channel: Channel<CH0>,
        resets: &mut RESETS,
        speed: HertzU32,
        delay: &mut impl DelayNs,
    ) -> Option<Self> {
        let Display { wires, mut is_data, mut select, reset } = display;
        // The driver sends bytes, and the DMA words of 16 bits.
        let mut bytes = Spi::<_, _, _, 8>::new(device, wires).init(resets, speed, BAUD, MODE_3);
        let device = ExclusiveDevice::new_no_delay(&mut bytes, &mut select).ok()?;
        let mut buffer = [0; 16];
        Builder::new(ST7789, SpiInterface::new(device, &mut is_data, &mut buffer))
            .display_size(SIZE, SIZE)
            .invert_colors(ColorInversion::Inverted)
            .reset_pin(reset)
            .init(delay)
            .ok()?;
        let (device, wires) = bytes.disable().free();
        let bus = Spi::<_, _, _, 16>::new(device, wires).init(resets, speed, BAUD, MODE_3);
        select.set_low().ok()?;
        Some(Self { idle: Some((channel, bus)), is_data })
    }

    /// Opens a window in the middle of the display. The next pixels that are sent fill it row by
    /// row.
    pub(crate) fn open(&mut self, width: u16, height: u16) -> Option<()> {
        let [columns, rows] = [width, height].map(|size| {
            let first = SIZE.saturating_sub(size) / 2;
            [first, first + size - 1]
        });
        self.command(SetColumnAddress::new(columns[0], columns[1]))?;
        self.command(SetPageAddress::new(rows[0], rows[1]))?;
        self.command(WriteMemoryStart)
    }

    /// Sends a row by DMA while a function runs. Returns the row.
    pub(crate) fn send<const WIDTH: usize>(
        &mut self,
        row: Row<WIDTH>,
        meanwhile: impl FnOnce(),
    ) -> Option<Row<WIDTH>> {
        let (channel, bus) = self.idle.take()?;
        let transfer = Config::new(channel, row, bus).start();
        meanwhile();
        let (channel, row, bus) = transfer.wait();
        self.idle = Some((channel, bus));
        Some(row)
    }

    /// Sends a command whose parameters are words of 16 bits.
    fn command(&mut self, command: impl DcsCommand) -> Option<()> {
        let (_, bus) = self.idle.as_mut()?;
        let mut bytes = [0; 4];
        let count = command.fill_params_buf(&mut bytes);
        let words = [[bytes[0], bytes[1]], [bytes[2], bytes[3]]].map(u16::from_be_bytes);
        // The display must have received the last pixel before `is_data` changes.
        bus.flush().ok()?;
        self.is_data.set_low().ok()?;
        // The upper byte is the command 0, which does nothing.
        bus.write(&[command.instruction().into()]).ok()?;
        bus.flush().ok()?;
        self.is_data.set_high().ok()?;
        bus.write(words.get(..count / 2)?).ok()
    }
}
