//! The lights and surfaces of the programs, as the build script has written them.

use luminaire::{
    Blend, BlinnPhong, CompiledDirectional, CompiledExposure, CompiledGobo, CompiledMaterial, CompiledPoint,
    CompiledSpot, Cubic, CutOff, DualCone, Hard, HardRange, HazyBeam, InverseSquare, Linear, Lyon, Matte,
    Phong, Polynomial, Power, Rim, Shadow, Smooth, SmoothRange, Soft, SquaredWindow, Table, Unattenuated,
    Windowed,
};

use crate::{Format, Light};

macro_rules! constants {
    ($($file:literal $name:ident: $type:ty;)*) => {$(
        #[doc = concat!("The constant of the file ", $file, ".")]
        pub const $name: $type = include!(concat!(env!("OUT_DIR"), "/", $file));
    )*};
}

constants! {
    "spot_soft.rs" SPOT_SOFT: CompiledSpot<Format, Soft, Unattenuated>;
    "spot_hard.rs" SPOT_HARD: CompiledSpot<Format, Hard, Unattenuated>;
    "spot_smooth.rs" SPOT_SMOOTH: CompiledSpot<Format, Smooth, Unattenuated>;
    "spot_cubic.rs" SPOT_CUBIC: CompiledSpot<Format, Cubic, Unattenuated>;
    "spot_power.rs" SPOT_POWER: CompiledSpot<Format, Power<8>, Unattenuated>;
    "spot_table.rs" SPOT_TABLE: CompiledSpot<Format, Table<'static>, Unattenuated>;
    "spot_linear.rs" SPOT_LINEAR: CompiledSpot<Format, Linear, Unattenuated>;
    "spot_cut_off.rs" SPOT_CUT_OFF: CompiledSpot<Format, CutOff, Unattenuated>;
    "spot_blend.rs" SPOT_BLEND: CompiledSpot<Format, Blend, Unattenuated>;
    "spot_rim.rs" SPOT_RIM: CompiledSpot<Format, Rim<4>, Unattenuated>;
    "spot_hotspot.rs" SPOT_HOTSPOT: CompiledSpot<Format, Soft, Unattenuated>;
    "spot_delimiter.rs" SPOT_DELIMITER: CompiledSpot<Format, Soft, Unattenuated>;
    "spot_inverse_square.rs" SPOT_INVERSE_SQUARE: CompiledSpot<Format, Soft, InverseSquare>;
    "spot_polynomial.rs" SPOT_POLYNOMIAL: CompiledSpot<Format, Soft, Polynomial>;
    "spot_smooth_range.rs" SPOT_SMOOTH_RANGE: CompiledSpot<Format, Soft, SmoothRange>;
    "spot_windowed.rs" SPOT_WINDOWED: CompiledSpot<Format, Soft, Windowed>;
    "spot_squared_window.rs" SPOT_SQUARED_WINDOW: CompiledSpot<Format, Soft, SquaredWindow>;
    "spot_hard_range.rs" SPOT_HARD_RANGE: CompiledSpot<Format, Soft, HardRange<InverseSquare>>;
    "gobo.rs" GOBO: CompiledGobo<'static, Format>;
    "beam.rs" BEAM: HazyBeam<Soft>;
    "shadow.rs" SHADOW: Shadow<'static, Format>;
    "point.rs" POINT: CompiledPoint<Format>;
    "directional.rs" DIRECTIONAL: CompiledDirectional<Format>;
    "ambient.rs" AMBIENT: Light;
    "exposure.rs" EXPOSURE: CompiledExposure<Format>;
    "matte.rs" MATTE: CompiledMaterial<Format, Matte>;
    "phong.rs" PHONG: CompiledMaterial<Format, Phong>;
    "blinn_phong.rs" BLINN_PHONG: CompiledMaterial<Format, BlinnPhong>;
    "dual_cone.rs" DUAL_CONE: CompiledMaterial<Format, DualCone>;
    "lyon.rs" LYON: CompiledMaterial<Format, Lyon<Phong, 3>>;
}
