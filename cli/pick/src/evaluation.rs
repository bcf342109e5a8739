//! The evaluations of a spotlight, and a light compiled for one evaluation.

use std::marker::PhantomData;

use luminaire::attenuation::{Attenuation as Law, NoAttenuation};
use luminaire::bound::Lit;
use luminaire::codegen::{Source, as_source};
use luminaire::falloff::Falloff;
use luminaire::light::{CompiledSpotLight, QuickSpotLight};
use luminaire::number::Quick;
use luminaire::{Error, Fx16, Fx32, Scalar, Vec3};
use luminaire_oracle::DVec3;
use luminaire_oracle::sweep::SurfacePoint;

use crate::light::{Attenuation, Light, Shaped, shaped};
use crate::target::named;

/// Calls a macro with the given arguments, followed by the list of evaluations. A row is
/// `doc variant = name, type, format, constructor, bound;`.
macro_rules! evaluations {
    ($consumer:ident $(; $($arguments:tt)*)?) => {
        $consumer! {
            $($($arguments)*)?
            /// The quick evaluation of `Fx16`.
            Fx16Quick = "fx16-quick", QuickSpotLight, Fx16, compile_quick, quick_error_bound_by;
            /// 16-bit fixed point.
            Fx16 = "fx16", CompiledSpotLight, Fx16, compile, error_bound_by;
            /// 32-bit fixed point.
            Fx32 = "fx32", CompiledSpotLight, Fx32, compile, error_bound_by;
            /// Floating point.
            F32 = "f32", CompiledSpotLight, f32, compile, error_bound_by;
        }
    };
}

macro_rules! declare {
    ($($(#[$doc:meta])* $variant:ident = $name:literal, $type:ident, $format:ident, $compile:ident, $bound:ident;)*) => {
        named! {
            /// An evaluation of a spotlight: a number format, and how much of its precision is used.
            Evaluation {
                $($(#[$doc])* $variant = $name,)*
            }
        }

        impl Evaluation {
            /// Returns the type of the compiled light, for the generated code.
            pub(crate) fn type_of(self, light: &Light, cone: &Shaped) -> String {
                let (kind, format) = match self {
                    $(Self::$variant => (stringify!($type), stringify!($format)),)*
                };
                let format = if format == "f32" { format.to_owned() } else { format!("luminaire::{format}") };
                let falloff = cone.type_name();
                let attenuation = match light.attenuation {
                    Attenuation::None => "NoAttenuation",
                    Attenuation::InverseSquare => "InverseSquare",
                };
                format!(
                    "luminaire::light::{kind}<{format}, luminaire::falloff::{falloff}, \
                     luminaire::attenuation::{attenuation}>"
                )
            }

            /// Returns the largest coordinate of a light in the format of the evaluation.
            pub(crate) fn farthest(self) -> f32 {
                match self {
                    $(Self::$variant => <$format as Scalar>::FARTHEST,)*
                }
            }
        }
    };
}
evaluations!(declare);

/// A light compiled for an evaluation.
pub(crate) trait Kernel {
    /// Returns the irradiance at a surface point.
    fn light(&self, at: &SurfacePoint) -> f64;
    /// Returns a normal as the format stores it.
    fn normal(&self, normal: [f32; 3]) -> DVec3;
    /// Returns whether the evaluation at the point is the fine evaluation.
    fn is_fine(&self, point: [f32; 3]) -> bool;
    /// Returns the light as a constant expression of Rust.
    fn source(&self) -> String;
}

/// A compiled light: a [`CompiledSpotLight`] or a [`QuickSpotLight`].
trait Evaluated<S: Scalar> {
    fn irradiance_at(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance;

    fn is_fine_at(&self, _point: Vec3<S::Length>) -> bool {
        false
    }
}

impl<S: Scalar, P: Falloff, A: Law> Evaluated<S> for CompiledSpotLight<S, P, A> {
    fn irradiance_at(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.irradiance(point, normal)
    }

    fn is_fine_at(&self, point: Vec3<S::Length>) -> bool {
        self.is_fine(point)
    }
}

impl<S: Quick, P: Falloff, A: Law> Evaluated<S> for QuickSpotLight<S, P, A> {
    fn irradiance_at(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.irradiance(point, normal)
    }
}

struct Compiled<S, L>(L, PhantomData<S>);

impl<S: Scalar, L: Evaluated<S> + Source> Kernel for Compiled<S, L> {
    fn light(&self, &SurfacePoint { point, normal }: &SurfacePoint) -> f64 {
        S::light_to_f32(self.0.irradiance_at(S::point(point), S::normal(normal))).into()
    }

    fn normal(&self, normal: [f32; 3]) -> DVec3 {
        DVec3::from_array(<[S; 3]>::from(S::normal(normal)).map(|c| c.to_f32().into()))
    }

    fn is_fine(&self, point: [f32; 3]) -> bool {
        self.0.is_fine_at(S::point(point))
    }

    fn source(&self) -> String {
        as_source(&self.0).to_string()
    }
}

/// Compiles a light for the evaluation of a variant.
macro_rules! compiled {
    ($evaluation:expr, $spot:ident;
     $($(#[$doc:meta])* $variant:ident = $name:literal, $type:ident, $format:ident, $compile:ident, $bound:ident;)*) => {
        match $evaluation {
            $(Evaluation::$variant => boxed::<$format, _>($spot.$compile::<$format>()?),)*
        }
    };
}

/// Derives the bound of a light for the evaluation of a variant.
macro_rules! bounded {
    ($evaluation:expr, $spot:ident, $distances:expr, $measure:expr;
     $($(#[$doc:meta])* $variant:ident = $name:literal, $type:ident, $format:ident, $compile:ident, $bound:ident;)*) => {
        match $evaluation {
            $(Evaluation::$variant => $spot.$bound::<$format>($distances, $measure)?,)*
        }
    };
}

/// Evaluates an expression with the spotlight of a light, by its cone and its attenuation.
macro_rules! spotlight {
    ($light:expr, $cone:expr, $spot:ident => $answer:expr) => {
        shaped!($cone, cone => {
            let $spot = $light.spot(*cone)?;
            match $light.attenuation {
                Attenuation::None => {
                    let $spot = $spot.with_attenuation(NoAttenuation);
                    $answer
                }
                Attenuation::InverseSquare => $answer,
            }
        })
    };
}

impl Evaluation {
    /// Compiles a light.
    pub(crate) fn compile(self, light: &Light, cone: &Shaped) -> Result<Box<dyn Kernel>, Error> {
        Ok(spotlight!(light, cone, spot => evaluations!(compiled; self, spot;)))
    }

    /// Returns the bound of the error of a light between its distances, by a measure of an error.
    pub(crate) fn bound(
        self,
        light: &Light,
        cone: &Shaped,
        measure: &dyn Fn(Lit) -> f64,
    ) -> Result<f64, Error> {
        let distances = light.near..=light.far;
        let bound = spotlight!(light, cone, spot => evaluations!(bounded; self, spot, distances, measure;));
        Ok(bound.light.into())
    }
}

fn boxed<S: Scalar + 'static, L: Evaluated<S> + Source + 'static>(light: L) -> Box<dyn Kernel> {
    Box::new(Compiled(light, PhantomData))
}
