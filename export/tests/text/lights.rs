// The light cubic, written by luminaire-export 0.1.0: do not edit.
// A spotlight: falloff cubic, full angles in degrees: beam 17.51, field 37.86, outer 40.00.
// Lengths have the unit of the scene; light is linear, and 1 is full scale.

pub mod cubic {
    #[allow(unused_imports, reason = "not every light names a type of each module")]
    use luminaire::{attenuation::*, falloff::*, light::*, *};

    /// The compiled light.
    pub const LIGHT: CompiledSpotLight<Fx16, Cubic, Windowed<InverseSquare>> = {
const _: () = ::luminaire::codegen::written_by("0.1.0");
#[allow(unused_imports, reason = "an expression need not have names of both kinds")]
use ::luminaire::{attenuation::*, codegen::*, display::*, draw::*, falloff::*, haze::*, light::*, number::*, projector::*, specular::*, *};
CompiledSpotLight::<Fx16, _, Windowed<InverseSquare>>::from_parts(
    Vec3::new(Length::from_bits(65536), Length::from_bits(131072), Length::from_bits(196608)),
    Vec3::new(Fx32::from_bits(0), Fx32::from_bits(-960383872), Fx32::from_bits(480191936)),
    CompiledCone::<Fx16, _>::from_parts(
        FixedRamp::from_bits([2, 0, 518036448, 13, 33959, 2147499439, 0, 29, 2225560593]),
        Cubic::from_bits([1067450368, 1080033280]),
        CompiledCubic::<Fx16>::from_parts(
            Weight16::from_bits(4096),
            Weight16::from_bits(-45056),
        ),
    ),
    Fx16::from_bits(14451),
    (
        Gain16::from_bits([-901412864, 38]),
        (),
    ),
    Gain16::from_bits([-2147483648, 31]),
    1058914388,
    [
        Rgb::new(Fx16::from_bits(16384), Fx16::from_bits(16384), Fx16::from_bits(16384)),
        Rgb::new(Fx16::from_bits(16384), Fx16::from_bits(16384), Fx16::from_bits(16384)),
    ],
)
};
}
// The light point, written by luminaire-export 0.1.0: do not edit.
// Lengths have the unit of the scene; light is linear, and 1 is full scale.

pub mod point {
    #[allow(unused_imports, reason = "not every light names a type of each module")]
    use luminaire::{attenuation::*, falloff::*, light::*, *};

    /// The compiled light.
    pub const LIGHT: CompiledPointLight<Fx32, SmoothRange> = {
const _: () = ::luminaire::codegen::written_by("0.1.0");
#[allow(unused_imports, reason = "an expression need not have names of both kinds")]
use ::luminaire::{attenuation::*, codegen::*, display::*, draw::*, falloff::*, haze::*, light::*, number::*, projector::*, specular::*, *};
CompiledPointLight::<Fx32, SmoothRange>::from_parts(
    Vec3::new(Length::from_bits(65536), Length::from_bits(131072), Length::from_bits(196608)),
    [
        Gain32::from_bits([214748368, 30]),
        Gain32::from_bits([171798688, 32]),
    ],
    Gain32::from_bits([134217728, 27]),
    0,
    [
        Rgb::new(Fx32::from_bits(1073741824), Fx32::from_bits(1073741824), Fx32::from_bits(1073741824)),
        Rgb::new(Fx32::from_bits(1073741824), Fx32::from_bits(1073741824), Fx32::from_bits(1073741824)),
    ],
)
};
}
// The light sun, written by luminaire-export 0.1.0: do not edit.
// Lengths have the unit of the scene; light is linear, and 1 is full scale.

pub mod sun {
    #[allow(unused_imports, reason = "not every light names a type of each module")]
    use luminaire::{attenuation::*, falloff::*, light::*, *};

    /// The compiled light.
    pub const LIGHT: CompiledDirectionalLight<f32> = {
const _: () = ::luminaire::codegen::written_by("0.1.0");
#[allow(unused_imports, reason = "an expression need not have names of both kinds")]
use ::luminaire::{attenuation::*, codegen::*, display::*, draw::*, falloff::*, haze::*, light::*, number::*, projector::*, specular::*, *};
CompiledDirectionalLight::<f32>::from_parts(
    Vec3::new(f32::from_bits(0), f32::from_bits(3211065646), f32::from_bits(1055193390)),
    f32::from_bits(1065353216),
    [
        Rgb::new(f32::from_bits(1065353216), f32::from_bits(1065353216), f32::from_bits(1065353216)),
        Rgb::new(f32::from_bits(1065353216), f32::from_bits(1065353216), f32::from_bits(1065353216)),
    ],
)
};
}
