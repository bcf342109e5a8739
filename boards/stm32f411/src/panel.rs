//! The display at SPI1.

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use luminaire_panel::Row;
use stm32f4xx_hal::pac::SPI1;
use stm32f4xx_hal::spi::Spi;

/// The display, started.
///
/// The processor writes the rows to the bus. The HAL's DMA keeps the bus for ever, but commands are
/// sent between the pictures.
pub(crate) struct Panel<Output> {
    bus: Spi<SPI1, false, u16>,
    is_data: Output,
}

impl<Output: OutputPin> Panel<Output> {
    /// Starts the display. `None` if its driver refuses the options.
    pub(crate) fn start(
        mut bus: Spi<SPI1>,
        mut is_data: Output,
        mut select: impl OutputPin,
        reset: impl OutputPin,
        delay: &mut impl DelayNs,
    ) -> Option<Self> {
        luminaire_panel::start(&mut bus, &mut is_data, &mut select, reset, delay)?;
        let bus = bus.frame_size_16bit();
        select.set_low().ok()?;
        Some(Self { bus, is_data })
    }
}

impl<Output: OutputPin> luminaire_panel::Panel for Panel<Output> {
    fn write(&mut self, is_data: bool, words: &[u16]) -> Option<()> {
        self.is_data.set_state(is_data.into()).ok()?;
        // Returns when the last bit has been sent, because the bus then has received as many.
        self.bus.write(words).ok()
    }

    fn send<const WIDTH: usize>(&mut self, row: Row<WIDTH>, meanwhile: impl FnOnce()) -> Option<Row<WIDTH>> {
        self.bus.write(row).ok()?;
        meanwhile();
        Some(row)
    }
}
