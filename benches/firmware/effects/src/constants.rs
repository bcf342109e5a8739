//! The lights and surfaces of the programs. The build script writes their values.

use luminaire::{
    Rgb, Scalar, Vec3,
    attenuation::NoAttenuation,
    display::{CompiledExposure, LedOrder, LedStrip, Palette, Rgb565Ramp},
    falloff::Soft,
    light::{
        CompiledDirectionalLight, CompiledMaterial, CompiledMeasuredLight, CompiledPointLight,
        CompiledSpotLight,
    },
    projector::{CompiledGobo, Shadow},
    specular::{NoSpecular, Phong, SpecularLobe},
};

use crate::format::{Format, Light};

#[cfg(feature = "f32")]
type Beam = luminaire::haze::BeamScattering<Soft>;
#[cfg(not(feature = "f32"))]
type Beam = luminaire::haze::BeamScattering16<Soft>;

/// The soft spotlight by the quick evaluation; `f32` and `Fx32` have only one evaluation.
#[cfg(any(feature = "f32", feature = "fx32"))]
type Quick = CompiledSpotLight<Format, Soft, NoAttenuation>;
#[cfg(not(any(feature = "f32", feature = "fx32")))]
type Quick = luminaire::light::QuickSpotLight<Format, Soft, NoAttenuation>;

macro_rules! constants {
    ($($file:literal $name:ident: $type:ty;)*) => {$(
        #[doc = concat!("The constant of the file ", $file, ".")]
        pub const $name: $type = include!(concat!(env!("OUT_DIR"), "/", $file));
    )*};
}

constants! {
    "hotspot.rs" HOTSPOT: CompiledSpotLight<Format, Soft, NoAttenuation>;
    "cutoff.rs" CUTOFF: CompiledSpotLight<Format, Soft, NoAttenuation>;
    "quick.rs" QUICK: Quick;
    "bright.rs" BRIGHT: CompiledSpotLight<Format, Soft, NoAttenuation>;
    "wide.rs" WIDE: CompiledSpotLight<Format, Soft, NoAttenuation>;
    "part.rs" PART: Format;
    "narrow.rs" NARROW: f32;
    "position.rs" POSITION: Vec3<<Format as Scalar>::Length>;
    "radius.rs" RADIUS: <Format as Scalar>::Length;
    "axis_back.rs" AXIS_BACK: Vec3<<Format as Scalar>::Unit>;
    "gobo.rs" GOBO: CompiledGobo<'static, Format>;
    "eye.rs" EYE: Vec3<<Format as Scalar>::Length>;
    "beam.rs" BEAM: Beam;
    "shadow.rs" SHADOW: Shadow<'static, Format>;
    "point.rs" POINT: CompiledPointLight<Format>;
    "measured.rs" MEASURED: CompiledMeasuredLight<'static, Format>;
    "directional.rs" DIRECTIONAL: CompiledDirectionalLight<Format>;
    "ambient.rs" AMBIENT: Light;
    "exposure.rs" EXPOSURE: CompiledExposure<Format>;
    "highlight.rs" HIGHLIGHT: <Phong as SpecularLobe>::Constants<Format>;
    "diffuse.rs" DIFFUSE: Format;
    "specular.rs" SPECULAR: Format;
    "matte.rs" MATTE: CompiledMaterial<Format, NoSpecular>;
}

/// A strip of LEDs that a white LED exceeds.
pub const STRIP: LedStrip = LedStrip::new(LedOrder::Grb).with_limit(40, 20, 1);

/// The colours of electronic paper of seven colours.
pub static PALETTE: Palette<'static> =
    Palette::from_cells(&PAPER, include!(concat!(env!("OUT_DIR"), "/cells.rs")), 255);

include!("paper.rs");

/// The constant of the file ramp.rs: the paper in the light, a table that is not copied.
pub static RAMP: Rgb565Ramp = include!(concat!(env!("OUT_DIR"), "/ramp.rs"));
