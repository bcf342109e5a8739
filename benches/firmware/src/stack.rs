//! The stack of a call of each effect, and the bytes of what a program holds in memory.

use crate::COUNT;
use crate::board::{depth, opaque, println};
use luminaire::Scalar;
use luminaire::{
    Rgb,
    attenuation::NoAttenuation,
    display::{Ramp, Rgb565, TemporalDither},
    dynamic::CompiledAnyLight,
    falloff::Soft,
    light::{CompiledDirectionalLight, CompiledPointLight, CompiledSpotLight, SurfacePoint},
};
use luminaire_effects::{Entry, Format, Input, Inputs, Output, Visit, each, each_evaluation};

/// Prints `name bytes stack` for each effect, the most over its inputs, and `name bytes ram` for types.
///
/// Inlined, because this crate would inline the functions of other programs less if it compiled these effects, too
/// (`falloff-alone` on Cortex-M0: +1 instruction).
#[inline]
pub fn stack() {
    each(&mut Depths);
    each_evaluation(&mut Depths);
    macro_rules! sizes {
        ($($name:literal $type:ty;)*) => {
            $(println!("{}.{} {} ram", $name, Format::NAME, size_of::<$type>());)*
        };
    }
    sizes! {
        "spotlight" CompiledSpotLight<Format, Soft>;
        "spotlight-no-attenuation" CompiledSpotLight<Format, Soft, NoAttenuation>;
        "point-light" CompiledPointLight<Format>;
        "directional-light" CompiledDirectionalLight<Format>;
        "any-light" CompiledAnyLight<Format>;
        "surface-point" SurfacePoint<Format>;
        "ramp-rgb565" Ramp<Rgb565>;
        "led-dither" Rgb<TemporalDither<8>>;
    }
}

struct Depths;

impl Visit for Depths {
    #[inline(never)]
    fn effect<I: Input, O: Output>(
        &mut self,
        entry: Entry,
        next: fn(&mut Inputs) -> I,
        effect: impl Fn(I) -> O,
    ) {
        let mut sequence = Inputs::default();
        let depths = (0..COUNT).map(|_| {
            let input = next(&mut sequence);
            depth(|| effect(*opaque(&input)).fold())
        });
        println!("{}.{} {} stack", entry.name, Format::NAME, depths.max().unwrap_or_default());
    }
}
