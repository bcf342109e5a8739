//! The display at SPI2, fed by DMA.

use embedded_hal::delay::DelayNs;
use esp_hal::Blocking;
use esp_hal::dma::DmaTxBuf;
use esp_hal::gpio::Output;
use esp_hal::peripherals::DMA_CH0;
use esp_hal::spi::master::{Spi, SpiDma};
use luminaire_panel::Row;

/// The bytes of the longest row.
const BYTES: usize = 2 * 240;

/// The display, started.
pub(crate) struct Panel {
    /// The bus and the bytes that its DMA sends; `None` while a row is being sent.
    idle: Option<(SpiDma<'static, Blocking>, DmaTxBuf)>,
    is_data: Output<'static>,
    /// Low as long as the display is addressed.
    _select: Output<'static>,
}

impl Panel {
    /// Starts the display. `None` if its driver refuses the options.
    pub(crate) fn start(
        mut bus: Spi<'static, Blocking>,
        channel: DMA_CH0<'static>,
        mut is_data: Output<'static>,
        mut select: Output<'static>,
        reset: Output<'static>,
        delay: &mut impl DelayNs,
    ) -> Option<Self> {
        luminaire_panel::start(&mut bus, &mut is_data, &mut select, reset, delay)?;
        let idle = Some((bus.with_dma(channel), esp_hal::dma_tx_buffer!(BYTES).ok()?));
        select.set_low();
        Some(Self { idle, is_data, _select: select })
    }
}

impl luminaire_panel::Panel for Panel {
    fn write(&mut self, is_data: bool, words: &[u16]) -> Option<()> {
        let (bus, _) = self.idle.as_mut()?;
        self.is_data.set_level(is_data.into());
        words.iter().try_for_each(|word| bus.write(&word.to_be_bytes())).ok()
    }

    fn send<const WIDTH: usize>(&mut self, row: Row<WIDTH>, meanwhile: impl FnOnce()) -> Option<Row<WIDTH>> {
        let (bus, mut bytes) = self.idle.take()?;
        for (two, pixel) in bytes.as_mut_slice().chunks_exact_mut(2).zip(&*row) {
            two.copy_from_slice(&pixel.to_be_bytes());
        }
        bytes.set_length(2 * WIDTH);
        let transfer = bus.write_buffer(2 * WIDTH, bytes).ok()?;
        meanwhile();
        self.idle = Some(transfer.wait());
        Some(row)
    }
}
