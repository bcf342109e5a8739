//! Compiled values as Rust source: a light whose figures are known when the firmware is built needs no code to set it up.
//!
//! Compiling a light takes trigonometry, divisions and floats. A build script does it on the host, and writes what came
//! of it as a constant expression of raw bits:
//!
//! ```no_run
//! // build.rs, with luminaire among the build-dependencies
//! use luminaire::{Angle, Cone, Fx16, SpotLight, Vec3, codegen::Source, falloff::Soft};
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     let cone = Cone::from_field(Soft, Angle::degrees(36.0))?;
//!     let key = SpotLight::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?;
//!     let file = std::path::Path::new(&std::env::var("OUT_DIR")?).join("key.rs");
//!     std::fs::write(file, key.compile::<Fx16>()?.as_source().to_string())?;
//!     Ok(())
//! }
//! ```
//!
//! The firmware takes it in, and the compiler compares the types:
//!
//! ```text
//! const KEY: CompiledSpotLight<Fx16, Soft> = include!(concat!(env!("OUT_DIR"), "/key.rs"));
//! ```
//!
//! So are [`Rgb`] of ambient light, [`CompiledPointLight`], [`CompiledDirectionalLight`], [`CompiledMaterial`],
//! [`CompiledExposure`] and [`BeamScattering`]. What the text calls are `const fn`s that take any bits: those that no compiled light has are
//! brought to where every point still has an answer. The bits belong to this version of the crate: they are generated
//! anew with each build, and not kept.
//!
//! The module also names the types that generated text is made of.

mod named;

#[cfg(feature = "arithmetic")]
pub use self::named::{Named, SourceScalar};
#[cfg(not(feature = "arithmetic"))]
use self::named::{Named, SourceScalar};

use core::{
    fmt::{self, Formatter},
    marker::PhantomData,
};

use crate::{
    attenuation::{Attenuation, InverseSquare, NoAttenuation, Polynomial, Ranged, SmoothRange, Window},
    color::Rgb,
    cone::CompiledCone,
    display::CompiledExposure,
    falloff::{
        Cubic, Falloff, FittedFalloff, Hard, InvertedPower, Linear, Power, Quadratic, Smooth, Soft,
        SoftOrHard, Step, Table,
    },
    haze::BeamScattering,
    material::CompiledMaterial,
    projector::{CompiledGobo, CompiledProjection, Gobo, Shadow},
    shade::{CompiledDirectionalLight, CompiledPointLight, CompiledSpotLight},
    specular::{BlinnPhong, DifferenceForm, DualConeLobe, NoSpecular, Phong, SpecularLobe},
    vec3::Vec3,
};

#[cfg(feature = "fixed")]
use crate::number::{Fx16, Fx32, Length, Light16, Light32, Weight16, Weight32};

pub use crate::{
    falloff::{CompiledCubic, CompiledFittedFalloff, CompiledQuadratic},
    number::float::{FloatFrame, FloatRamp},
};
#[cfg(feature = "fixed")]
pub use crate::{
    number::fixed16::{Frame16, Gain16, Ramp16},
    number::fixed32::{Frame32, Gain32, Ramp32},
};

/// A value that can be written as a constant expression of Rust.
pub trait Source {
    /// Writes the expression; its names are those of the crate and of the module [`codegen`](crate::codegen).
    ///
    /// # Errors
    /// Those of the formatter.
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result;

    /// The expression as a block that brings its names with it.
    fn as_source(&self) -> AsSource<'_, Self>
    where
        Self: Sized,
    {
        AsSource(self)
    }
}

impl SourceScalar for f32 {}
#[cfg(feature = "fixed")]
impl SourceScalar for Fx16 {}
#[cfg(feature = "fixed")]
impl SourceScalar for Fx32 {}

/// A value that is displayed as a constant expression. Made by [`Source::as_source`].
#[derive(Clone, Copy, Debug)]
pub struct AsSource<'a, T>(&'a T);

impl<T: Source> fmt::Display for AsSource<'_, T> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let import = "use ::luminaire::{attenuation::*, codegen::*, display::*, falloff::*, haze::*, light::*, number::*, projector::*, specular::*, *};";
        let reason = "an expression need not have names of both kinds";
        write!(
            out,
            "{{\n#[allow(unused_imports, reason = \"{reason}\")]\n{import}\n{:#?}\n}}\n",
            Written(self.0)
        )
    }
}

/// The expression alone, in the way that the formatter's lists ask for.
struct Written<'a, T: ?Sized>(&'a T);

impl<T: Source + ?Sized> fmt::Debug for Written<'_, T> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        self.0.write(out)
    }
}

/// The name of a type.
struct Name<T>(PhantomData<T>);

impl<T: Named> fmt::Display for Name<T> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        T::write_name(out)
    }
}

fn name<T: Named>() -> Name<T> {
    Name(PhantomData)
}

/// Writes a call, with an argument a line.
fn call(out: &mut Formatter<'_>, function: &str, arguments: &[&dyn Source]) -> fmt::Result {
    let mut call = out.debug_tuple(function);
    for argument in arguments {
        call.field(&Written(*argument));
    }
    call.finish()
}

/// Values that are their bits.
macro_rules! bits {
    ($($name:ident)*) => {$(
        impl Source for $name {
            fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
                write!(out, "{}::from_bits({:?})", stringify!($name), self.to_bits())
            }
        }
    )*};
}

bits!(f32 FloatFrame FloatRamp Quadratic Cubic);
#[cfg(feature = "fixed")]
bits!(Fx16 Fx32 Length Weight16 Weight32 Light16 Light32 Frame16 Frame32 Gain16 Gain32 Ramp16 Ramp32);

/// Types without parameters.
macro_rules! named {
    ($($name:ty),*) => {$(
        impl Named for $name {
            fn write_name(out: &mut Formatter<'_>) -> fmt::Result {
                out.write_str(stringify!($name))
            }
        }
    )*};
}

named!(f32, NoAttenuation, InverseSquare, Polynomial, SmoothRange);
named!(NoSpecular, Phong, BlinnPhong, DualConeLobe);
#[cfg(feature = "fixed")]
named!(Fx16, Fx32);

impl<W: Window, A: Named> Named for Ranged<W, A> {
    fn write_name(out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "Ranged<{}, {}>", W::NAME, name::<A>())
    }
}

impl<H: Named, const N: u32> Named for DifferenceForm<H, N> {
    fn write_name(out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "DifferenceForm<{}, {N}>", name::<H>())
    }
}

/// Profiles without coefficients, which are their own curves.
macro_rules! profiles {
    ($($name:ident)*) => {$(
        impl Source for $name {
            fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
                out.write_str(stringify!($name))
            }
        }
    )*};
}

profiles!(Soft Hard Linear Step Smooth);

impl<const N: u32> Source for Power<N> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "Power::<{N}>")
    }
}

impl<const N: u32> Source for InvertedPower<N> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "InvertedPower::<{N}>")
    }
}

impl Source for Table<'_> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        if self.knots().is_empty() {
            return write!(out, "Table::of(&{:?})", self.samples());
        }
        // A call is no constant that lives on but in a block of one.
        out.write_str("Table::of_knots(const { &[")?;
        for (place, value, slope) in self.knots().iter().map(|knot| knot.to_bits()) {
            write!(out, "Knot::from_bits({place}, {value}, {slope}), ")?;
        }
        out.write_str("] })")
    }
}

impl Source for SoftOrHard {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "SoftOrHard::{self:?}")
    }
}

impl Source for FittedFalloff {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Quadratic(blend) => call(out, "FittedFalloff::Quadratic", &[blend]),
            Self::Cubic(cubic) => call(out, "FittedFalloff::Cubic", &[cubic]),
        }
    }
}

impl<S: SourceScalar> Source for CompiledQuadratic<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledQuadratic::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.g])
    }
}

impl<S: SourceScalar> Source for CompiledCubic<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledCubic::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.g, &self.h])
    }
}

impl<S: SourceScalar> Source for CompiledFittedFalloff<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Quadratic(blend) => call(out, "CompiledFittedFalloff::Quadratic", &[blend]),
            Self::Cubic(cubic) => call(out, "CompiledFittedFalloff::Cubic", &[cubic]),
        }
    }
}

impl Source for () {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.write_str("()")
    }
}

impl Source for u32 {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "{self}")
    }
}

impl<A: Source, B: Source> Source for (A, B) {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        call(out, "", &[&self.0, &self.1])
    }
}

impl<T: Source, const N: usize> Source for [T; N] {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.debug_list().entries(self.iter().map(Written)).finish()
    }
}

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

impl<S: SourceScalar, P: Falloff + Source> Source for CompiledCone<S, P>
where
    P::Compiled<S>: Source,
{
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledCone::<{}, _>::", name::<S>())?;
        call(out, "from_parts", &[&self.ramp, &self.profile, &self.curve])
    }
}

impl<S: SourceScalar, P: Falloff + Source, A: Attenuation + Named> Source for CompiledSpotLight<S, P, A>
where
    P::Compiled<S>: Source,
    A::Constants<S>: Source,
{
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledSpotLight::<{}, _, {}>::", name::<S>(), name::<A>())?;
        let Self { position, axis, falloff, outside, attenuation, intensity, fine_below, .. } = *self;
        let colors = [self.color, self.specular_color];
        let parts: [&dyn Source; 8] =
            [&position, &axis, &falloff, &outside, &attenuation, &intensity, &fine_below, &colors];
        call(out, "from_parts", &parts)
    }
}

impl<P: Falloff + Source, A: Attenuation + Named> Source for BeamScattering<P, A>
where
    P::Compiled<f32>: Source,
    A::Constants<f32>: Source,
{
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "BeamScattering::<_, {}>::", name::<A>())?;
        let Self { position, axis, falloff, attenuation, gain, cone, reach } = *self;
        call(out, "from_parts", &[&position, &axis, &falloff, &attenuation, &gain, &cone, &reach])
    }
}

impl<S: SourceScalar, A: Attenuation + Named> Source for CompiledPointLight<S, A>
where
    A::Constants<S>: Source,
{
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledPointLight::<{}, {}>::", name::<S>(), name::<A>())?;
        let Self { position, attenuation, intensity, fine_below, color, specular_color } = *self;
        let colors = [color, specular_color];
        call(out, "from_parts", &[&position, &attenuation, &intensity, &fine_below, &colors])
    }
}

impl<S: SourceScalar> Source for CompiledDirectionalLight<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledDirectionalLight::<{}>::", name::<S>())?;
        let Self { direction, intensity, color, specular_color } = *self;
        call(out, "from_parts", &[&direction, &intensity, &[color, specular_color]])
    }
}

impl<S: SourceScalar, H: SpecularLobe + Named> Source for CompiledMaterial<S, H>
where
    H::Constants<S>: Source,
{
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledMaterial::<{}, {}>::", name::<S>(), name::<H>())?;
        let Self { ambient, diffuse, emissive, specular, highlight } = *self;
        call(out, "from_parts", &[&ambient, &diffuse, &emissive, &specular, &highlight])
    }
}

impl<S: SourceScalar> Source for CompiledExposure<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledExposure::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.gain])
    }
}

impl<S: SourceScalar> Source for CompiledProjection<S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledProjection::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.position, &self.frame])
    }
}

/// The rows of a gobo.
struct Rows<'a>(Gobo<'a>);

impl fmt::Debug for Rows<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.debug_list().entries(self.0.transmissions().chunks(self.0.side())).finish()
    }
}

impl Source for Gobo<'_> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "Gobo::of(&{:?})", Rows(*self))
    }
}

impl<S: SourceScalar> Source for CompiledGobo<'_, S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CompiledGobo::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.projection, &self.gobo])
    }
}

/// Values that are borrowed, as a constant of their own: whoever borrows it may keep it.
struct Borrowed<'a, T>(&'a [T]);

impl<T: Source> Source for Borrowed<'_, T> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.write_str("const { &")?;
        out.debug_list().entries(self.0.iter().map(Written)).finish()?;
        out.write_str(" }")
    }
}

impl<S: SourceScalar> Source for Shadow<'_, S> {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "Shadow::<{}>::", name::<S>())?;
        call(out, "from_parts", &[&self.projection, &self.side, &Borrowed(self.depths)])
    }
}
