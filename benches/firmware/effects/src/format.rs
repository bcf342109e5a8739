//! The number format of this build, and what is in it.

/// The number format.
#[cfg(feature = "f32")]
pub type Format = f32;
/// The number format.
#[cfg(all(feature = "fx32", not(feature = "f32")))]
pub type Format = luminaire::Fx32;
/// The number format.
#[cfg(not(any(feature = "fx32", feature = "f32")))]
pub type Format = luminaire::Fx16;

/// Irradiance in the format.
pub type Irradiance = <Format as luminaire::Scalar>::Irradiance;
/// Light in the format, before it is fitted to a display.
pub type Light = luminaire::Rgb<Irradiance>;
/// A colour in the format.
pub type Color = luminaire::Rgb<Format>;
/// A surface point in the format.
pub type Surface = luminaire::light::SurfacePoint<Format>;
