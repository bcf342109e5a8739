//! Chips, displays and tolerances.

use std::fmt;

use luminaire::bound::Lit;
use luminaire_oracle::{counted, linear_codes, srgb_code};
use serde::{Deserialize, Serialize};

/// Declares an enum whose variants have names in texts and in JSON.
macro_rules! named {
    ($(#[$meta:meta])* $name:ident { $($(#[$doc:meta])* $variant:ident = $text:literal,)* }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, PartialEq, Eq, Debug, serde::Serialize, serde::Deserialize)]
        pub enum $name {
            $($(#[$doc])* #[serde(rename = $text)] $variant,)*
        }

        impl $name {
            /// All variants.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// Returns the name in texts and in JSON.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $text,)*
                }
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(self.name())
            }
        }

        impl std::str::FromStr for $name {
            type Err = String;

            fn from_str(text: &str) -> Result<Self, String> {
                Self::ALL.iter().copied().find(|each| each.name() == text).ok_or_else(|| {
                    let names: Vec<_> = Self::ALL.iter().map(|each| each.name()).collect();
                    format!("expected {}", names.join(", "))
                })
            }
        }
    };
}
pub(crate) use named;

named! {
    /// A processor whose instructions are counted.
    Chip {
        /// Armv6-M, without a multiplication of 64 bits.
        CortexM0 = "cortex-m0",
        /// Armv7-M.
        CortexM3 = "cortex-m3",
        /// Armv7E-M with a floating point unit.
        CortexM4f = "cortex-m4f",
        /// RISC-V without a floating point unit.
        Rv32imc = "rv32imc",
        /// Armv7E-M with a floating point unit of Armv8, compiled for this processor.
        CortexM7 = "cortex-m7",
        /// Armv8-M with a floating point unit, as in an RP2350.
        CortexM33 = "cortex-m33",
        /// RISC-V with Zba and Zbb, without a floating point unit, as in an RP2350.
        Hazard3 = "hazard3",
    }
}

named! {
    /// A display. Its values are encoded in sRGB, for LEDs in linear light, and then rounded to steps. With
    /// channels of several widths a step is that of the widest.
    Display {
        /// Black and white.
        Gray1 = "gray1",
        /// Four greys.
        Gray2 = "gray2",
        /// 16 greys.
        Gray4 = "gray4",
        /// 256 greys.
        Gray8 = "gray8",
        /// 3, 3 and 2 bits for red, green and blue.
        Rgb332 = "rgb332",
        /// Four bits per channel.
        Rgb444 = "rgb444",
        /// Five bits per channel.
        Rgb555 = "rgb555",
        /// 5, 6 and 5 bits for red, green and blue.
        Rgb565 = "rgb565",
        /// Six bits per channel.
        Rgb666 = "rgb666",
        /// Eight bits per channel.
        Rgb888 = "rgb888",
        /// A strip of LEDs with duties of eight bits.
        Ws2812 = "ws2812-8",
        /// LEDs with duties of ten bits.
        Pwm10 = "pwm-10",
        /// LEDs with duties of twelve bits.
        Pwm12 = "pwm-12",
        /// LEDs with duties of 16 bits.
        Pwm16 = "pwm-16",
    }
}

impl Display {
    /// Returns the number of steps from black to full scale.
    pub fn steps(self) -> f64 {
        let bits = match self {
            Self::Gray1 => 1,
            Self::Gray2 => 2,
            Self::Rgb332 => 3,
            Self::Gray4 | Self::Rgb444 => 4,
            Self::Rgb555 => 5,
            Self::Rgb565 | Self::Rgb666 => 6,
            Self::Gray8 | Self::Rgb888 | Self::Ws2812 => 8,
            Self::Pwm10 => 10,
            Self::Pwm12 => 12,
            Self::Pwm16 => 16,
        };
        f64::from((1 << bits) - 1)
    }

    /// Returns whether the steps are those of linear light.
    pub fn is_linear(self) -> bool {
        matches!(self, Self::Ws2812 | Self::Pwm10 | Self::Pwm12 | Self::Pwm16)
    }

    /// Returns linear light in steps, before the rounding to a step.
    pub(crate) fn encoded(self, light: f64) -> f64 {
        self.steps() * if self.is_linear() { light } else { srgb_code(light) / 255.0 }
    }

    /// Returns the largest derivative of [`encoded`](Self::encoded), in steps of full scale.
    pub(crate) fn slope(self) -> f64 {
        self.steps() * if self.is_linear() { 1.0 } else { 12.92 }
    }
}

/// The largest error that a picture may have.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Tolerance {
    /// In steps of the display, after the encoding and before the rounding to steps.
    Steps(f64),
    /// In linear codes: 1/255 of full scale in linear light.
    Codes(f64),
}

impl Tolerance {
    /// Returns the number of steps or codes.
    pub fn amount(self) -> f64 {
        match self {
            Self::Steps(amount) | Self::Codes(amount) => amount,
        }
    }

    /// Returns the largest error, in the unit of the tolerance, of lights of this size with this linear
    /// error. The encoding is concave, so an error changes the darkest light most.
    pub(crate) fn measure(self, display: Display, Lit { from, to, error }: Lit) -> f64 {
        match self {
            Self::Steps(_) => {
                let lower = error.clamp(from, to);
                let up = display.encoded((from + error).min(1.0)) - display.encoded(from);
                let down = display.encoded(lower) - display.encoded((lower - error).max(0.0));
                up.max(down)
            }
            Self::Codes(_) => 255.0 * error,
        }
    }

    /// Returns the error of a light in the unit of the tolerance. Light over full scale is clipped.
    pub(crate) fn error(self, display: Display, found: f64, exact: f64) -> f64 {
        let [found, exact] = [found, exact].map(|light| light.clamp(0.0, 1.0));
        match self {
            Self::Steps(_) => counted((display.encoded(found) - display.encoded(exact)).abs()),
            Self::Codes(_) => linear_codes(found, exact),
        }
    }

    /// Returns the name of the unit in texts.
    pub(crate) fn unit(self, display: Display) -> String {
        match self {
            Self::Steps(_) => format!("steps of {display}"),
            Self::Codes(_) => "linear codes".to_owned(),
        }
    }
}

impl fmt::Display for Tolerance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Steps(amount) => write!(f, "{amount} steps"),
            Self::Codes(amount) => write!(f, "{amount} linear codes"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nan_is_an_infinite_error() {
        for tolerance in [Tolerance::Steps(1.0), Tolerance::Codes(1.0)] {
            for [found, exact] in [[f64::NAN, 0.5], [0.5, f64::NAN]] {
                assert_eq!(tolerance.error(Display::Rgb565, found, exact), f64::INFINITY);
            }
        }
    }
}
