//! `defmt` formatting of errors, lights, cones, angles, vectors, colours and numbers. The host builds
//! the text.
//!
//! A fixed-point number is sent as the nearest `f32`; log `to_bits()` if every bit counts. The text
//! has the format of `Debug`:
//!
//! ```
//! fn refused(error: &luminaire::Error, cone: luminaire::Angle) {
//!     // Error { parameter: FieldAngle, value: 400, accepted: AngleUpTo(143.13) } for Angle { degrees: 400 }
//!     defmt::warn!("{} for {}", error, cone);
//! }
//! ```

#[cfg(feature = "fixed")]
use crate::number::{Fx16, Fx32, Length, Light16, Light32, Versine, Weight16, Weight32};
use crate::{
    angle::{Angle, HalfAngle},
    color::Rgb,
    display::Rgb565,
    vec3::Vec3,
};
use defmt::{Format, Formatter, write};

impl Format for Angle {
    fn format(&self, out: Formatter<'_>) {
        write!(out, "Angle {{ degrees: {=f32} }}", self.to_degrees());
    }
}

impl Format for HalfAngle {
    fn format(&self, out: Formatter<'_>) {
        write!(out, "HalfAngle {{ degrees: {=f32} }}", self.to_degrees());
    }
}

impl<T: Format> Format for Vec3<T> {
    fn format(&self, out: Formatter<'_>) {
        write!(out, "Vec3 {{ x: {}, y: {}, z: {} }}", self.x, self.y, self.z);
    }
}

impl<T: Format> Format for Rgb<T> {
    fn format(&self, out: Formatter<'_>) {
        write!(out, "Rgb {{ red: {}, green: {}, blue: {} }}", self.red, self.green, self.blue);
    }
}

impl Format for Rgb565 {
    fn format(&self, out: Formatter<'_>) {
        write!(out, "Rgb565({=u16:#06x})", self.0);
    }
}

/// Implements `Format` for numbers, as the nearest f32.
#[cfg(feature = "fixed")]
macro_rules! float {
    ($($number:ident($bits:ty))*) => {$(
        impl Format for $number {
            fn format(&self, out: Formatter<'_>) {
                write!(out, "{=f32}", self.to_f32());
            }
        }
    )*};
}

#[cfg(feature = "fixed")]
for_numbers!(float);
