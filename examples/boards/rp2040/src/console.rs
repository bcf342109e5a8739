//! The UART that the program prints on: pin 0, 115,200 baud, 8 bits, no parity.

use core::fmt;

use rp2040_pac::{IO_BANK0, UART0};

use crate::clock::SPEED;

/// The divisor of the clock for 16 samples of a bit, in 64ths.
const DIVISOR: u32 = SPEED * 4 / 115_200;

/// UART0, started.
pub(crate) struct Console(UART0);

impl Console {
    pub(crate) fn start(uart: UART0, pins: &IO_BANK0) -> Self {
        // SAFETY: a divisor of 1 to 65535, 64ths of it, and 3 for words of 8 bits are allowed. The divisor is
        // taken over by the write of UARTLCR_H (4.2.7.1).
        unsafe {
            uart.uartibrd().write(|w| w.baud_divint().bits((DIVISOR / 64) as u16));
            uart.uartfbrd().write(|w| w.baud_divfrac().bits((DIVISOR % 64) as u8));
            uart.uartlcr_h().write(|w| w.wlen().bits(3).fen().set_bit());
        }
        uart.uartcr().write(|w| w.uarten().set_bit().txe().set_bit());
        pins.gpio(0).gpio_ctrl().write(|w| w.funcsel().uart());
        Self(uart)
    }
}

impl fmt::Write for Console {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for &byte in text.as_bytes() {
            while self.0.uartfr().read().txff().bit_is_set() {}
            // SAFETY: any byte is allowed.
            self.0.uartdr().write(|w| unsafe { w.data().bits(byte) });
        }
        Ok(())
    }
}
