//! The display: its size, the bus of a board, and its commands.

use mipidsi::dcs::{DcsCommand, SetColumnAddress, SetPageAddress, WriteMemoryStart};

/// Width and height of the display in pixels.
pub(crate) const SIZE: u16 = 240;

/// Pixels that a DMA can read.
pub type Words<const COUNT: usize> = &'static mut [u16; COUNT];

/// A started display at a bus that sends words of 16 bits, the most significant bit first.
pub trait Panel {
    /// Sends words after all that were sent before, and waits for their end. `is_data` is the level
    /// of the pin D/C: low for commands, high for their parameters and for pixels.
    ///
    /// Like all functions of a board, it returns `None` if the hardware refuses.
    fn write(&mut self, is_data: bool, words: &[u16]) -> Option<()>;

    /// Sends pixels while a function runs. Returns the pixels.
    fn send<const COUNT: usize>(
        &mut self,
        pixels: Words<COUNT>,
        meanwhile: impl FnOnce(),
    ) -> Option<Words<COUNT>>;
}

/// Opens a window in the middle of the display. The next pixels that are sent fill it row by row.
pub(crate) fn open(panel: &mut impl Panel, width: u16, height: u16) -> Option<()> {
    let [columns, rows] = [width, height].map(|size| {
        let first = SIZE.saturating_sub(size) / 2;
        [first, first + size - 1]
    });
    command(panel, SetColumnAddress::new(columns[0], columns[1]))?;
    command(panel, SetPageAddress::new(rows[0], rows[1]))?;
    command(panel, WriteMemoryStart)
}

/// Sends a command whose parameters are words.
fn command(panel: &mut impl Panel, command: impl DcsCommand) -> Option<()> {
    let mut bytes = [0; 4];
    let count = command.fill_params_buf(&mut bytes);
    let words = [[bytes[0], bytes[1]], [bytes[2], bytes[3]]].map(u16::from_be_bytes);
    // The upper byte is the command 0, which does nothing.
    panel.write(false, &[command.instruction().into()])?;
    panel.write(true, words.get(..count / 2)?)
}
