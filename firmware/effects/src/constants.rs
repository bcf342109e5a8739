//! The lights and surfaces of the programs, as the build script has written them.

use luminaire::{
    attenuation::{CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange},
    display::CompiledExposure,
    falloff::{Cubic, Hard, InvertedPower, Linear, Power, Quadratic, Smooth, Soft, Step, Table},
    haze::BeamScattering,
    light::{CompiledDirectionalLight, CompiledMaterial, CompiledPointLight, CompiledSpotLight},
    projector::{CompiledGobo, Shadow},
    specular::{BlinnPhong, DifferenceForm, DualConeLobe, NoSpecular, Phong},
};

use crate::{Format, Light};

macro_rules! constants {
    ($($file:literal $name:ident: $type:ty;)*) => {$(
        #[doc = concat!("The constant of the file ", $file, ".")]
        pub const $name: $type = include!(concat!(env!("OUT_DIR"), "/", $file));
    )*};
}

constants! {
    "spot_soft.rs" SPOT_SOFT: CompiledSpotLight<Format, Soft, NoAttenuation>;
    "spot_hard.rs" SPOT_HARD: CompiledSpotLight<Format, Hard, NoAttenuation>;
    "spot_smooth.rs" SPOT_SMOOTH: CompiledSpotLight<Format, Smooth, NoAttenuation>;
    "spot_cubic.rs" SPOT_CUBIC: CompiledSpotLight<Format, Cubic, NoAttenuation>;
    "spot_power.rs" SPOT_POWER: CompiledSpotLight<Format, Power<8>, NoAttenuation>;
    "spot_table.rs" SPOT_TABLE: CompiledSpotLight<Format, Table<'static>, NoAttenuation>;
    "spot_linear.rs" SPOT_LINEAR: CompiledSpotLight<Format, Linear, NoAttenuation>;
    "spot_cut_off.rs" SPOT_CUT_OFF: CompiledSpotLight<Format, Step, NoAttenuation>;
    "spot_blend.rs" SPOT_BLEND: CompiledSpotLight<Format, Quadratic, NoAttenuation>;
    "spot_rim.rs" SPOT_RIM: CompiledSpotLight<Format, InvertedPower<4>, NoAttenuation>;
    "spot_hotspot.rs" SPOT_HOTSPOT: CompiledSpotLight<Format, Soft, NoAttenuation>;
    "spot_delimiter.rs" SPOT_DELIMITER: CompiledSpotLight<Format, Soft, NoAttenuation>;
    "spot_inverse_square.rs" SPOT_INVERSE_SQUARE: CompiledSpotLight<Format, Soft, InverseSquare>;
    "spot_polynomial.rs" SPOT_POLYNOMIAL: CompiledSpotLight<Format, Soft, Polynomial>;
    "spot_smooth_range.rs" SPOT_SMOOTH_RANGE: CompiledSpotLight<Format, Soft, SmoothRange>;
    "spot_windowed.rs" SPOT_WINDOWED: CompiledSpotLight<Format, Soft, GltfRange>;
    "spot_squared_window.rs" SPOT_SQUARED_WINDOW: CompiledSpotLight<Format, Soft, FilamentRange>;
    "spot_hard_range.rs" SPOT_HARD_RANGE: CompiledSpotLight<Format, Soft, CutAt<InverseSquare>>;
    "gobo.rs" GOBO: CompiledGobo<'static, Format>;
    "beam.rs" BEAM: BeamScattering<Soft>;
    "shadow.rs" SHADOW: Shadow<'static, Format>;
    "point.rs" POINT: CompiledPointLight<Format>;
    "directional.rs" DIRECTIONAL: CompiledDirectionalLight<Format>;
    "ambient.rs" AMBIENT: Light;
    "exposure.rs" EXPOSURE: CompiledExposure<Format>;
    "matte.rs" MATTE: CompiledMaterial<Format, NoSpecular>;
    "phong.rs" PHONG: CompiledMaterial<Format, Phong>;
    "blinn_phong.rs" BLINN_PHONG: CompiledMaterial<Format, BlinnPhong>;
    "dual_cone.rs" DUAL_CONE: CompiledMaterial<Format, DualConeLobe>;
    "lyon.rs" LYON: CompiledMaterial<Format, DifferenceForm<Phong, 3>>;
}
