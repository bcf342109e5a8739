//! The formats and formulas to compare. Each is a kernel of the price list, set up for a wall.

use crate::{
    picture::Picture,
    refusal::{Refusal, choose},
    wall::Wall,
};
use luminaire::{
    Error, Fx16, Fx32, Scalar, SpotLight, attenuation::NoAttenuation, error::Expected, falloff::Soft,
    light::CompiledSpotLight,
};
use luminaire_kernels::{
    CosineFalloff, DoubleFalloff, Gltf, Kernel, Libm, OurPoint, Powf, Row, Stage, Value,
    scene::{Population, Site},
    truth::{Point, widened},
};
use luminaire_oracle as oracle;

/// A number format of `luminaire`, or a formula that a user might choose instead of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Form {
    /// The crate `luminaire` in f32: it computes the versine from a difference of directions.
    F32,
    /// The same in 32-bit fixed point.
    Fx32,
    /// The same in 16-bit fixed point.
    Fx16,
    /// The formula in f32 that computes the versine as `1 - l.s`.
    Cosine,
    /// The power of the cosine with the same field angle: Warn 1983, OpenGL.
    Powf,
    /// glTF's `KHR_lights_punctual` with an inner angle of 0.
    Gltf,
    /// The versine form in f64.
    F64,
}

/// The curve of intensity over angle that a form computes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Curve {
    /// `t^2`.
    Soft,
    /// The cosine to a power.
    CosinePower,
}

impl Form {
    /// Every form, in the order in which they are offered.
    pub(crate) const ALL: [Self; 7] =
        [Self::F32, Self::Fx32, Self::Fx16, Self::Cosine, Self::Powf, Self::Gltf, Self::F64];

    /// Returns the form of this name.
    pub(crate) fn named(name: &str) -> Result<Self, Refusal> {
        choose("form", name, &Self::ALL, Self::name)
    }

    /// The name that [`Form::named`] accepts.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::Fx32 => "fx32",
            Self::Fx16 => "fx16",
            Self::Cosine => "f32-cosine",
            Self::Powf => "powf",
            Self::Gltf => "gltf",
            Self::F64 => "f64",
        }
    }

    /// The name for people.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::F32 => "f32, 32-bit float",
            Self::Fx32 => "Fx32, 32-bit fixed point",
            Self::Fx16 => "Fx16, 16-bit fixed point",
            Self::Cosine => "f32, from the cosine 1 − l·s",
            Self::Powf => "powf, cosine to a power (f32)",
            Self::Gltf => "glTF's formula (f32)",
            Self::F64 => "f64, 64-bit float",
        }
    }

    /// The curve of the f64 reference that the form's picture is compared with.
    pub(crate) fn curve(self) -> Curve {
        match self {
            Self::Powf => Curve::CosinePower,
            _ => Curve::Soft,
        }
    }

    /// Returns whether both forms compute the same curve. Errors against different curves do not
    /// say which form is better.
    pub(crate) fn shares_truth_with(self, other: Self) -> bool {
        self.curve() == other.curve()
    }

    /// The form's rows on the price list: the row for the intensity from the angle, and the row for
    /// a lit point if there is one. The list has no prices of the cosine form.
    pub(crate) fn rows(self) -> (Row, Option<Row>) {
        let row = |kernel, stage, format| Row { kernel, stage, format };
        let format = match self {
            Self::Powf => return (row("powf-libm", Stage::Falloff, "rival"), None),
            Self::Gltf => return (row("gltf", Stage::Falloff, "rival"), None),
            Self::F32 | Self::Fx32 | Self::Fx16 | Self::Cosine | Self::F64 => self.name(),
        };
        (row("soft", Stage::Falloff, format), Some(row("lit", Stage::Lit, format)))
    }

    /// Prepares an unlit picture of the wall.
    ///
    /// # Errors
    /// A beam that is too narrow for the number format.
    pub(crate) fn picture(self, wall: &Wall) -> Result<Picture, Error> {
        let (spot, sites) = (wall.spot(), wall.sites());
        let outer = spot.cone().outer_versine();
        Ok(match self {
            Self::F32 => Picture::of(OurPoint::new(compiled::<f32>(spot)?), sites),
            Self::Fx32 => Picture::of(OurPoint::new(compiled::<Fx32>(spot)?), sites),
            Self::Fx16 => Picture::of(OurPoint::new(compiled::<Fx16>(spot)?), sites),
            Self::Cosine => {
                let falloff = CosineFalloff::<Soft>::new(spot.cone().compile::<f32>()?);
                Picture::of(from_cosine(wall, falloff), sites)
            }
            Self::Powf => Picture::of(from_cosine(wall, Powf::<Libm>::new(exponent(wall))), sites),
            Self::Gltf => {
                let cosine = (1.0 - f64::from(outer)) as f32;
                Picture::of(from_cosine(wall, Gltf::new(cosine)), sites)
            }
            Self::F64 => Picture::of(from_versine(wall, DoubleFalloff::<Soft>::new(outer)), sites),
        })
    }
}

/// Compiles the light. The cone is checked first, so that a cone that is too narrow is refused for
/// its angle and not for its large distance.
fn compiled<S: Scalar>(
    spot: &SpotLight<Soft, NoAttenuation>,
) -> Result<CompiledSpotLight<S, Soft, NoAttenuation>, Error> {
    spot.cone().compile::<S>()?;
    spot.compile()
}

impl Curve {
    /// Returns the f64 reference of the wall.
    pub(crate) fn truth(self, wall: &Wall) -> Point {
        let cone = match self {
            Self::Soft => oracle::Cone::new(oracle::soft, wall.spot().cone().outer_versine().into()),
            Self::CosinePower => oracle::Cone::opengl(exponent(wall).into(), 1.0),
        };
        let light = oracle::SpotLight::new(widened(wall.spot().position()), wall.axis(), cone);
        let light = oracle::SpotLight { attenuation: oracle::Attenuation::None, ..light };
        Point { light, highlight: None, population: Population::Lit }
    }
}

/// If the angle was refused, returns the narrowest half angle in degrees that the format accepts,
/// rounded up.
pub(crate) fn accepted_half_angle(error: &Error) -> Option<f32> {
    match error.accepted {
        Expected::AngleFrom(full) => Some(((full * 5e3).floor() + 1.0) / 1e4),
        _ => None,
    }
}

/// Returns the exponent of the cosine power with the field angle of the wall's cone.
fn exponent(wall: &Wall) -> f32 {
    -std::f32::consts::LN_10 / (-wall.spot().cone().field().versine()).ln_1p()
}

/// A function of a site as a kernel.
#[derive(Clone, Copy)]
struct OfSite<F>(F);

impl<O: Value, F: Fn(&Site) -> O + Copy> Kernel for OfSite<F> {
    type Place = Site;
    type Input = Site;
    type Output = O;

    fn input(&self, site: &Site) -> Site {
        *site
    }

    #[inline(always)]
    fn evaluate(&self, site: &Site) -> O {
        (self.0)(site)
    }

    #[inline(always)]
    fn touch(site: &Site) -> u32 {
        site.point.x.to_bits()
    }
}

/// Evaluates a cosine falloff at a point as it is usually written, with one inner product in f32.
fn from_cosine<K: Kernel<Input = f32, Output = f32>>(
    wall: &Wall,
    falloff: K,
) -> OfSite<impl Fn(&Site) -> f32 + Copy + use<K>> {
    let (position, axis) = (wall.spot().position(), wall.spot().axis());
    OfSite(move |site: &Site| {
        let way = site.point.zip(position, |point, light| point - light);
        let facing = -way.dot(site.normal);
        if facing <= 0.0 {
            return 0.0;
        }
        let reciprocal = 1.0 / way.dot(way).sqrt();
        falloff.evaluate(&(way.dot(axis) * reciprocal)) * (facing * reciprocal)
    })
}

/// Evaluates a versine falloff at a point in f64.
fn from_versine<K: Kernel<Input = f64, Output = f64>>(
    wall: &Wall,
    falloff: K,
) -> OfSite<impl Fn(&Site) -> f64 + Copy + use<K>> {
    let (position, axis) = (widened(wall.spot().position()), wall.axis().normalize());
    OfSite(move |site: &Site| {
        let way = widened(site.point) - position;
        let facing = -way.dot(widened(site.normal));
        if facing <= 0.0 {
            return 0.0;
        }
        let reciprocal = 1.0 / way.length();
        let difference = way * reciprocal - axis;
        falloff.evaluate(&(0.5 * difference.length_squared())) * (facing * reciprocal)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forms_share_a_truth_only_where_their_truths_are_equal() {
        let wall = Wall::new(24, 20.0).unwrap();
        let lights = Form::ALL.map(|form| {
            let truth = form.curve().truth(&wall);
            wall.sites().iter().map(|site| truth.at(site)).collect::<Vec<_>>()
        });
        for (one, light) in Form::ALL.iter().zip(&lights) {
            for (other, other_light) in Form::ALL.iter().zip(&lights) {
                let are_equal = light == other_light;
                assert_eq!(one.shares_truth_with(*other), are_equal, "{one:?} and {other:?}");
            }
        }
        assert!(!Form::Fx16.shares_truth_with(Form::Powf) && Form::Fx16.shares_truth_with(Form::Gltf));
    }
}
