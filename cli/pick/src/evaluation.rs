//! The evaluations of a light, and a light compiled for one evaluation.

use std::marker::PhantomData;

use luminaire::attenuation::AnyAttenuation;
use luminaire::bound::{ErrorBound, Lit};
use luminaire::dynamic::{AnyLight, CompiledAnyLight};
use luminaire::falloff::AnyFalloff;
use luminaire::light::{
    CompiledDirectionalLight, CompiledMeasuredLight, CompiledPointLight, CompiledSpotLight, QuickSpotLight,
};
use luminaire::number::Quick;
use luminaire::{Error, Fx16, Fx32, Scalar, Vec3};
use luminaire_export::ExportError;
use luminaire_export::rust::{Constant, constant, quick_constant};
use luminaire_oracle::DVec3;
use luminaire_oracle::sweep::SurfacePoint;

use crate::target::named;

named! {
    /// An evaluation of a light: a number format, and how much of its precision is used.
    Evaluation {
        /// The quick evaluation of `Fx16`, which spotlights have.
        Fx16Quick = "fx16-quick",
        /// 16-bit fixed point.
        Fx16 = "fx16",
        /// 32-bit fixed point.
        Fx32 = "fx32",
        /// Floating point.
        F32 = "f32",
    }
}

/// A light compiled for an evaluation.
pub(crate) trait Kernel {
    /// Returns the irradiance at a surface point.
    fn light(&self, at: &SurfacePoint) -> f64;
    /// Returns a normal as the format stores it.
    fn normal(&self, normal: [f32; 3]) -> DVec3;
    /// Returns whether the evaluation at the point is the fine evaluation.
    fn is_fine(&self, point: [f32; 3]) -> bool;
    /// Returns whether all points have the fine evaluation, whose result they keep.
    fn is_always_fine(&self) -> bool;
}

/// A number format whose numbers are converted without a rounding, which `f32` would have of those of `Fx32`.
trait Exact: Scalar + 'static {
    fn exact(self) -> f64;
    fn exact_light(light: Self::Irradiance) -> f64;
}

impl Exact for f32 {
    fn exact(self) -> f64 {
        self.into()
    }

    fn exact_light(light: f32) -> f64 {
        light.into()
    }
}

macro_rules! exact {
    ($($format:ty)*) => {$(
        impl Exact for $format {
            fn exact(self) -> f64 {
                self.to_f64()
            }

            fn exact_light(light: Self::Irradiance) -> f64 {
                light.to_f64()
            }
        }
    )*};
}
exact! { Fx16 Fx32 }

/// A compiled light of one kind. Its falloff and its attenuation are chosen at run time, which changes no bit.
trait Evaluated<S: Scalar> {
    fn irradiance_at(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance;
    fn is_fine_at(&self, point: Vec3<S::Length>) -> bool;
    /// The encoded distance below which points have the fine evaluation.
    fn fine_below(&self) -> u32;
}

/// Implements the evaluation of lights with a place.
macro_rules! placed {
    ($($light:ty)*) => {$(
        impl<S: Scalar> Evaluated<S> for $light {
            fn irradiance_at(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
                self.irradiance(point, normal)
            }

            fn is_fine_at(&self, point: Vec3<S::Length>) -> bool {
                self.is_fine(point)
            }

            fn fine_below(&self) -> u32 {
                self.parts().fine_below
            }
        }
    )*};
}

placed! {
    CompiledSpotLight<S, AnyFalloff, AnyAttenuation>
    CompiledPointLight<S, AnyAttenuation>
    CompiledMeasuredLight<'static, S, AnyAttenuation>
}

impl<S: Quick> Evaluated<S> for QuickSpotLight<S, AnyFalloff, AnyAttenuation> {
    fn irradiance_at(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.irradiance(point, normal)
    }

    fn is_fine_at(&self, _: Vec3<S::Length>) -> bool {
        false
    }

    fn fine_below(&self) -> u32 {
        0
    }
}

impl<S: Scalar> Evaluated<S> for CompiledDirectionalLight<S> {
    fn irradiance_at(&self, _: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.irradiance(normal)
    }

    fn is_fine_at(&self, _: Vec3<S::Length>) -> bool {
        false
    }

    fn fine_below(&self) -> u32 {
        0
    }
}

struct Compiled<S, L>(L, PhantomData<S>);

impl<S: Exact, L: Evaluated<S>> Kernel for Compiled<S, L> {
    fn light(&self, &SurfacePoint { point, normal }: &SurfacePoint) -> f64 {
        S::exact_light(self.0.irradiance_at(S::point(point), S::normal(normal)))
    }

    fn normal(&self, normal: [f32; 3]) -> DVec3 {
        DVec3::from_array(<[S; 3]>::from(S::normal(normal)).map(S::exact))
    }

    fn is_fine(&self, point: [f32; 3]) -> bool {
        self.0.is_fine_at(S::point(point))
    }

    fn is_always_fine(&self) -> bool {
        self.0.fine_below() == u32::MAX
    }
}

impl Evaluation {
    /// Returns the largest coordinate of a light in the format of the evaluation.
    pub(crate) fn farthest(self) -> f32 {
        match self {
            Self::Fx16Quick | Self::Fx16 => Fx16::FARTHEST,
            Self::Fx32 => Fx32::FARTHEST,
            Self::F32 => f32::FARTHEST,
        }
    }

    /// Compiles a light; `None` for a kind of light that the evaluation does not have.
    pub(crate) fn compile(self, light: &AnyLight) -> Result<Option<Box<dyn Kernel>>, Error> {
        Ok(Some(match self {
            Self::Fx16Quick => match light {
                AnyLight::Spot(spot) => boxed::<Fx16, _>(spot.compile_quick::<Fx16>()?),
                AnyLight::Point(_) | AnyLight::Measured(_) | AnyLight::Directional(_) => return Ok(None),
            },
            Self::Fx16 => compiled::<Fx16>(light)?,
            Self::Fx32 => compiled::<Fx32>(light)?,
            Self::F32 => compiled::<f32>(light)?,
        }))
    }

    /// Returns whether all points of a light have the fine evaluation however dim it is: those of a steep cone.
    pub(crate) fn is_steep(self, light: &AnyLight) -> Result<bool, Error> {
        Ok(self.compile(&light.with_intensity(0.0)?)?.is_some_and(|kernel| kernel.is_always_fine()))
    }

    /// Returns the bound of the error of a light at surfaces within two distances, by a measure of an error.
    pub(crate) fn bound(
        self,
        light: &AnyLight,
        [near, far]: [f32; 2],
        measure: &dyn Fn(Lit) -> f64,
    ) -> Result<ErrorBound, Error> {
        let distances = near..=far;
        match self {
            Self::Fx16Quick => match light {
                AnyLight::Spot(spot) => spot.quick_error_bound_by::<Fx16>(distances, measure),
                AnyLight::Point(_) | AnyLight::Measured(_) | AnyLight::Directional(_) => {
                    light.error_bound_by::<Fx16>(distances, measure)
                }
            },
            Self::Fx16 => light.error_bound_by::<Fx16>(distances, measure),
            Self::Fx32 => light.error_bound_by::<Fx32>(distances, measure),
            Self::F32 => light.error_bound_by::<f32>(distances, measure),
        }
    }

    /// Returns the light compiled for the evaluation as a constant of Rust.
    pub(crate) fn constant(self, light: &AnyLight) -> Result<Constant, ExportError> {
        match self {
            Self::Fx16Quick => match light {
                AnyLight::Spot(spot) => quick_constant::<Fx16>(spot),
                AnyLight::Point(_) | AnyLight::Measured(_) | AnyLight::Directional(_) => {
                    constant::<Fx16>(light)
                }
            },
            Self::Fx16 => constant::<Fx16>(light),
            Self::Fx32 => constant::<Fx32>(light),
            Self::F32 => constant::<f32>(light),
        }
    }
}

fn compiled<S: Exact>(light: &AnyLight) -> Result<Box<dyn Kernel>, Error> {
    Ok(match light.compile::<S>()? {
        CompiledAnyLight::Spot(light) => boxed::<S, _>(light),
        CompiledAnyLight::Point(light) => boxed::<S, _>(light),
        CompiledAnyLight::Measured(light) => boxed::<S, _>(light),
        CompiledAnyLight::Directional(light) => boxed::<S, _>(light),
    })
}

fn boxed<S: Exact, L: Evaluated<S> + 'static>(light: L) -> Box<dyn Kernel> {
    Box::new(Compiled(light, PhantomData))
}
