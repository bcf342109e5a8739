//! Compiled values as Rust source, so that firmware needs no set-up code for constant lights.
//!
//! Compiling a light needs trigonometry, divisions and floats. A build script compiles the light on
//! the host and writes the result as a constant expression of raw bits:
//!
//! ```no_run
//! // build.rs, with luminaire among the build-dependencies
//! use luminaire::{Angle, Cone, Fx16, SpotLight, Vec3, codegen::as_source, falloff::Soft};
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     let cone = Cone::from_field(Soft, Angle::degrees(36.0))?;
//!     let key = SpotLight::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?;
//!     let file = std::path::Path::new(&std::env::var("OUT_DIR")?).join("key.rs");
//!     std::fs::write(file, as_source(&key.compile::<Fx16>()?).to_string())?;
//!     Ok(())
//! }
//! ```
//!
//! The firmware includes the file, and the compiler checks the type:
//!
//! ```text
//! use luminaire::{Fx16, falloff::Soft, light::CompiledSpotLight};
//!
//! const KEY: CompiledSpotLight<Fx16, Soft> = include!(concat!(env!("OUT_DIR"), "/key.rs"));
//! ```
//!
//! All compiled lights can be written, including those of another system, except
//! [`CompiledAnyLight`](crate::dynamic::CompiledAnyLight). Other values that can be written are the
//! [`Rgb`] of ambient light, [`CompiledMaterial`], [`CompiledExposure`], [`Ramp`], [`Gradient`],
//! [`CompiledGobo`], [`Shadow`], [`BeamScattering`] and [`BeamScattering16`]. The generated text
//! calls `const` functions that accept any bits, and evaluation is defined for any bits. The bits
//! are specific to this version of the crate, and the text does not compile with another one:
//! generate it in each build and do not store it.
//!
//! The module also exports types that only the generated text needs to name.

mod formats;
#[cfg(feature = "arithmetic")]
mod parts;

use core::fmt::{self, Formatter};

#[cfg(feature = "fixed")]
use crate::haze::BeamScattering16;
pub use crate::{
    attenuation::CompiledAnyAttenuation,
    falloff::{
        CompiledAnyFalloff, CompiledCubic, CompiledFittedFalloff, CompiledInvertedRealPower,
        CompiledQuadratic, CompiledRealPower, CompiledSoftEdged, CompiledSoftPair,
    },
    number::float::{FloatFrame, FloatRamp},
    source::{AsSource, as_source, written_by},
};
#[cfg(feature = "fixed")]
pub use crate::{
    number::fx16::{Frame16, Gain16},
    number::fx32::{Frame32, Gain32},
    number::ramp::FixedRamp,
};

use crate::{
    attenuation::Attenuation,
    color::Rgb,
    cone::CompiledCone,
    display::{CompiledExposure, Pixel, Ramp},
    distribution::Distribution,
    draw::Gradient,
    falloff::Falloff,
    haze::BeamScattering,
    material::CompiledMaterial,
    number::{Quick, Scalar},
    projector::{CompiledGobo, CompiledProjection, Gobo, Shadow},
    shade::{
        CompiledDirectionalLight, CompiledMeasuredLight, CompiledPointLight, CompiledSpotLight,
        QuickSpotLight,
    },
    source::{Written, call},
    specular::SpecularLobe,
    vec3::Vec3,
};

#[cfg(all(feature = "arithmetic", feature = "fixed"))]
pub use self::parts::{CodeTables, Tables};
#[cfg(feature = "arithmetic")]
pub use self::parts::{ConeParts, Parts};
#[cfg(feature = "arithmetic")]
pub use crate::source::{Name, Named, Source, name};
#[cfg(not(feature = "arithmetic"))]
use crate::source::{Named, Source, name};

impl<T: Source> Source for Vec3<T> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let Self { x, y, z } = self;
        write!(out, "Vec3::new({:?}, {:?}, {:?})", Written(x), Written(y), Written(z))
    }
}

impl<T: Source> Source for Rgb<T> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let Self { red, green, blue } = self;
        write!(out, "Rgb::new({:?}, {:?}, {:?})", Written(red), Written(green), Written(blue))
    }
}

impl<S: Scalar, P: Falloff> Source for CompiledCone<S, P> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledCone::<{}, _>::", name::<S>())?;
        call(out, "from_parts", &[&self.ramp, &self.falloff, &self.curve])
    }
}

impl<S: Scalar, P: Falloff, A: Attenuation> Source for CompiledSpotLight<S, P, A> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledSpotLight::<{}, _, {}>::", name::<S>(), name::<A>())?;
        let Self { position, axis, cone, outside, attenuation, intensity, fine_below, .. } = *self;
        let colors = [self.color, self.specular_color];
        let parts: [&dyn Source; 8] =
            [&position, &axis, &cone, &outside, &attenuation, &intensity, &fine_below, &colors];
        call(out, "from_parts", &parts)
    }
}

impl<S: Quick, P: Falloff, A: Attenuation> Source for QuickSpotLight<S, P, A> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "QuickSpotLight::<{}, _, {}>::", name::<S>(), name::<A>())?;
        let Self { position, axis, cone, outside, attenuation, intensity, color, specular_color } = *self;
        let colors = [color, specular_color];
        call(out, "from_parts", &[&position, &axis, &cone, &outside, &attenuation, &intensity, &colors])
    }
}

impl<P: Falloff, A: Attenuation> Source for BeamScattering<P, A> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "BeamScattering::<_, {}>::", name::<A>())?;
        let Self { position, axis, falloff, attenuation, gain, cone, reach } = *self;
        call(out, "from_parts", &[&position, &axis, &falloff, &attenuation, &gain, &cone, &reach])
    }
}

#[cfg(feature = "fixed")]
impl<P: Falloff> Source for BeamScattering16<P> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.write_str("BeamScattering16::")?;
        let Self { position, axis, falloff, gain, cone, radius, nearest } = *self;
        call(out, "from_parts", &[&position, &axis, &falloff, &gain, &cone, &radius, &nearest])
    }
}

impl<S: Scalar, A: Attenuation> Source for CompiledPointLight<S, A> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledPointLight::<{}, {}>::", name::<S>(), name::<A>())?;
        let Self { position, attenuation, intensity, fine_below, color, specular_color } = *self;
        let colors = [color, specular_color];
        call(out, "from_parts", &[&position, &attenuation, &intensity, &fine_below, &colors])
    }
}

impl Source for Distribution<'_> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(
            out,
            "Distribution::from_parts(&{:?}, {}, Symmetry::{:?})",
            self.samples(),
            self.size(),
            self.symmetry()
        )
    }
}

impl<S: Scalar, A: Attenuation> Source for CompiledMeasuredLight<'_, S, A> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledMeasuredLight::<{}, {}>::", name::<S>(), name::<A>())?;
        let Self { position, frame, distribution, outside, attenuation, intensity, fine_below, .. } = *self;
        let colors = [self.color, self.specular_color];
        let parts: [&dyn Source; 8] =
            [&position, &frame, &distribution, &outside, &attenuation, &intensity, &fine_below, &colors];
        call(out, "from_parts", &parts)
    }
}

impl<S: Scalar> Source for CompiledDirectionalLight<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledDirectionalLight::<{}>::", name::<S>())?;
        let Self { direction, intensity, color, specular_color } = *self;
        call(out, "from_parts", &[&direction, &intensity, &[color, specular_color]])
    }
}

impl<S: Scalar, H: SpecularLobe + Named> Source for CompiledMaterial<S, H>
where
    H::Constants<S>: Source,
{
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledMaterial::<{}, {}>::", name::<S>(), name::<H>())?;
        let Self { ambient, diffuse, emissive, specular, highlight } = *self;
        call(out, "from_parts", &[&ambient, &diffuse, &emissive, &specular, &highlight])
    }
}

impl<S: Scalar> Source for CompiledExposure<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledExposure::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.gain])
    }
}

impl<P: Pixel> Source for Ramp<P> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "Ramp::<{}>::from_levels({:?})", name::<P>(), self.levels())
    }
}

impl<P: Pixel, const N: usize> Source for Gradient<P, N> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let (levels, shape) = self.parts();
        write!(out, "Gradient::<{}, {N}>::from_parts({levels:?}, Shape::{shape:?})", name::<P>())
    }
}

impl<S: Scalar> Source for CompiledProjection<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledProjection::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.position, &self.frame])
    }
}

impl Source for Gobo<'_> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "Gobo::of(&{:?})", self.transmissions())
    }
}

impl<S: Scalar> Source for CompiledGobo<'_, S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledGobo::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.projection, &self.gobo])
    }
}

/// A borrowed slice, written as a `const` block so that the reference is `'static`.
struct Borrowed<'a, T>(&'a [T]);

impl<T: Source> Source for Borrowed<'_, T> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.write_str("const { &")?;
        out.debug_list().entries(self.0.iter().map(Written)).finish()?;
        out.write_str(" }")
    }
}

impl<S: Scalar> Source for Shadow<'_, S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "Shadow::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.projection, &self.side, &Borrowed(self.depths)])
    }
}
