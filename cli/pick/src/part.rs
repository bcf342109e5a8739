//! Chips by the names under which they are sold.

use crate::target::Chip;

/// How the names of parts begin, in small letters, and their processors. Of a part with two kinds it is that with a
/// floating point unit.
const PARTS: [(&str, Chip); 39] = [
    ("rp2040", Chip::CortexM0),
    ("stm32c0", Chip::CortexM0),
    ("stm32f0", Chip::CortexM0),
    ("stm32g0", Chip::CortexM0),
    ("stm32l0", Chip::CortexM0),
    ("stm32u0", Chip::CortexM0),
    ("samd21", Chip::CortexM0),
    ("nrf51", Chip::CortexM0),
    ("stm32f1", Chip::CortexM3),
    ("stm32f2", Chip::CortexM3),
    ("stm32l1", Chip::CortexM3),
    ("sam3x", Chip::CortexM3),
    ("lpc17", Chip::CortexM3),
    ("stm32f3", Chip::CortexM4f),
    ("stm32f4", Chip::CortexM4f),
    ("stm32g4", Chip::CortexM4f),
    ("stm32l4", Chip::CortexM4f),
    ("stm32wb", Chip::CortexM4f),
    ("samd51", Chip::CortexM4f),
    ("same5", Chip::CortexM4f),
    ("nrf52832", Chip::CortexM4f),
    ("nrf52833", Chip::CortexM4f),
    ("nrf52840", Chip::CortexM4f),
    ("esp32-c2", Chip::Rv32imc),
    ("esp32-c3", Chip::Rv32imc),
    ("esp32-c6", Chip::Rv32imc),
    ("esp32-h2", Chip::Rv32imc),
    ("gd32vf103", Chip::Rv32imc),
    ("stm32f7", Chip::CortexM7),
    ("stm32h7", Chip::CortexM7),
    ("imxrt10", Chip::CortexM7),
    ("teensy4", Chip::CortexM7),
    ("rp2350", Chip::CortexM33),
    ("stm32h5", Chip::CortexM33),
    ("stm32l5", Chip::CortexM33),
    ("stm32u5", Chip::CortexM33),
    ("nrf53", Chip::CortexM33),
    ("nrf91", Chip::CortexM33),
    ("lpc55", Chip::CortexM33),
];

/// How the names of parts begin whose processors are not counted, and what is known of them.
const UNCOUNTED: [(&str, &str); 3] = [
    (
        "esp32",
        "the Xtensa of an ESP32, ESP32-S2 and -S3 is not counted; the calls of C are, on the Xtensa of an ESP8266 \
         (export/c/README.md), and rv32imc is an ESP32-C3",
    ),
    ("esp8266", "of the Xtensa of an ESP8266 the calls of C alone are counted (export/c/README.md)"),
    ("atmega", "of an AVR the cycles of C alone are counted (export/c/README.md)"),
];

impl Chip {
    /// Returns the processor of a name, or of a part such as `rp2040`, `stm32f411` or `ESP32-C3`.
    ///
    /// # Errors
    /// A name of neither, with the processors, or with what is known of a part that is not counted.
    pub fn of_part(text: &str) -> Result<Self, String> {
        let name = text.to_ascii_lowercase();
        // The longest first: an ESP32-C3 is no ESP32.
        let part = PARTS.iter().find(|(part, _)| name.starts_with(part));
        let uncounted = || UNCOUNTED.iter().find(|(part, _)| name.starts_with(part));
        match (name.parse(), part) {
            (Ok(chip), _) | (_, Some(&(_, chip))) => Ok(chip),
            (Err(names), None) => Err(uncounted().map_or_else(
                || format!("{names}, or a part such as rp2040, rp2350, stm32f411, nrf52840 or esp32-c3"),
                |(_, known)| format!("{names}: {known}"),
            )),
        }
    }
}
