//! The words of a `luminaire_spot`.

use luminaire::codegen::ConeParts;
use luminaire::falloff::{Cubic, Falloff};
use luminaire::light::CompiledSpotLight;
use luminaire::{Fx16, Fx32, Length, Rgb};

/// The words of a `luminaire_spot`, in their order.
pub(crate) type Words = [u32; 22];

/// Two words of four scalars.
pub(crate) fn of_scalars([a, b, c, d]: [i16; 4]) -> [u32; 2] {
    [[a, b], [c, d]].map(|[low, high]| u32::from(low as u16) | u32::from(high as u16) << 16)
}

/// The words of a light with the cubic that was compiled of it.
pub(crate) fn words(light: &CompiledSpotLight<Fx16, Cubic>) -> Words {
    let (g, h) = light.falloff().compile::<Fx16>().weights();
    words_with_edge(light, [g, h].map(|weight| weight.to_bits() as u32))
}

/// The words of a light with the words of its edge.
pub(crate) fn words_with_edge(light: &CompiledSpotLight<Fx16, Cubic>, edge: [u32; 2]) -> Words {
    let parts = light.parts();
    let ConeParts { axis, ramp, outside } = parts.cone.expect("a cone");
    let Rgb { red, green, blue } = light.color();
    let color = of_scalars([red, green, blue, outside].map(Fx16::to_bits));
    let position = <[Length; 3]>::from(parts.position).map(|c| c.to_bits() as u32);
    let axis = <[Fx32; 3]>::from(axis).map(|c| c.to_bits() as u32);
    let gain = parts.intensity.to_bits().map(|bits| bits as u32);
    let all = [&position[..], &axis, &ramp.to_bits(), &edge, &gain, &[parts.fine_below], &color].concat();
    all.try_into().expect("all words")
}
