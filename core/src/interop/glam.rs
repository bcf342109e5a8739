//! Conversions between [`Vec3`]`<f32>` or [`Rgb`]`<f32>` and `glam::Vec3`.
//!
//! ```
//! use luminaire::{Rgb, Vec3};
//! assert_eq!(Vec3::from(glam::Vec3::X), Vec3::new(1.0, 0.0, 0.0));
//! assert_eq!(Rgb::from(glam::Vec3::X), Rgb::new(1.0, 0.0, 0.0));
//! ```

use crate::{color::Rgb, vec3::Vec3};

/// Implements conversions of a type that converts from and to an array of three.
macro_rules! both_ways {
    ($($ours:ident)*) => {$(
        impl From<glam::Vec3> for $ours<f32> {
            fn from(v: glam::Vec3) -> Self {
                v.to_array().into()
            }
        }

        impl From<$ours<f32>> for glam::Vec3 {
            fn from(ours: $ours<f32>) -> Self {
                Self::from_array(ours.into())
            }
        }
    )*};
}

both_ways!(Vec3 Rgb);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_and_colours_go_there_and_back() {
        let there = glam::Vec3::from(Vec3::new(1.0, -2.0, 3.5));
        assert_eq!(there, glam::Vec3::new(1.0, -2.0, 3.5));
        assert_eq!(
            (Vec3::from(there), Rgb::from(there)),
            (Vec3::new(1.0, -2.0, 3.5), Rgb::new(1.0, -2.0, 3.5))
        );
        assert_eq!(glam::Vec3::from(Rgb::from(there)), there);
    }
}
