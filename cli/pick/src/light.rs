//! The description of a spotlight: its cone, and the distances of the surfaces that it lights.

use luminaire::attenuation::AnyAttenuation;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Cubic, Falloff, Formula, Hard, Quadratic, Soft};
use luminaire::{Angle, Cone, Error, Rgb, SpotLight};
use luminaire_export::{check_text, json};
use luminaire_oracle as oracle;
use serde::{Deserialize, Serialize};

use crate::refusal::Refusal;
use crate::target::named;

named! {
    /// The edge of a cone.
    Edge {
        /// The soft quadratic of Hast 2004.
        Soft = "soft",
        /// The hard quadratic of Hast 2004.
        Hard = "hard",
    }
}

named! {
    /// The attenuation: the intensity as a function of the distance.
    Attenuation {
        /// The same light at every distance.
        None = "none",
        /// The inverse-square law.
        InverseSquare = "inverse-square",
    }
}

/// A spotlight, and the distances at which surfaces receive its light.
///
/// Angles are full angles in degrees. One of beam, field and outer angle determines the cone. If
/// both beam and field angle are given, the falloff is fitted to both angles, and `edge` has no
/// effect. Without any of these angles, the field angle is 36 degrees.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Light {
    /// The name in texts and in the comment of the code: what [`check_text`] accepts.
    pub name: String,
    /// The position, in the unit of the distances. Each coordinate is rounded to a multiple of
    /// 2^-16.
    pub position: [f32; 3],
    /// The axis, of any length.
    pub axis: [f32; 3],
    /// The linear colour.
    pub color: [f32; 3],
    /// The edge of the cone: soft or hard.
    pub edge: Edge,
    /// The derivatives of the falloff with respect to `t` at the edge and at full intensity, in place of
    /// `edge`: a cubic, or a quadratic if their sum is 2.
    pub slopes: Option<[f32; 2]>,
    /// The beam angle, at which the intensity is 50 % of the maximum.
    pub beam: Option<f32>,
    /// The field angle, at which the intensity is 10 % of the maximum.
    pub field: Option<f32>,
    /// The outer angle, at which the light ends.
    pub outer: Option<f32>,
    /// The inner angle: the edge of a hotspot with full intensity.
    pub inner: Option<f32>,
    /// The attenuation.
    pub attenuation: Attenuation,
    /// The intensity: 1 gives full scale on the axis, with attenuation at a distance of 1.
    pub intensity: f32,
    /// The distance of the nearest surface.
    pub near: f32,
    /// The distance of the farthest surface.
    pub far: f32,
}

impl Default for Light {
    /// Returns a soft light with a field angle of 36 degrees and surfaces at distances from 1 to 7.
    ///
    /// On the axis at a distance of 4, the light is full scale.
    fn default() -> Self {
        Self {
            name: "light".to_owned(),
            position: [0.0; 3],
            axis: [0.0, -1.0, 0.0],
            color: [1.0; 3],
            edge: Edge::Soft,
            slopes: None,
            beam: None,
            field: None,
            outer: None,
            inner: None,
            attenuation: Attenuation::InverseSquare,
            intensity: 16.0,
            near: 1.0,
            far: 7.0,
        }
    }
}

/// A cone, with one variant per falloff type.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shaped {
    Soft(Cone<Soft>),
    Hard(Cone<Hard>),
    Quadratic(Cone<Quadratic>),
    Cubic(Cone<Cubic>),
}

/// Evaluates an expression with the cone of the variant.
macro_rules! shaped {
    ($shaped:expr, $cone:ident => $answer:expr) => {
        match $shaped {
            $crate::light::Shaped::Soft($cone) => $answer,
            $crate::light::Shaped::Hard($cone) => $answer,
            $crate::light::Shaped::Quadratic($cone) => $answer,
            $crate::light::Shaped::Cubic($cone) => $answer,
        }
    };
}
pub(crate) use shaped;

impl Shaped {
    /// Returns the name of the falloff's type.
    pub(crate) fn type_name(&self) -> &'static str {
        match self {
            Self::Soft(_) => "Soft",
            Self::Hard(_) => "Hard",
            Self::Quadratic(_) => "Quadratic",
            Self::Cubic(_) => "Cubic",
        }
    }

    /// Returns the full outer angle in degrees.
    pub(crate) fn outer(&self) -> f32 {
        shaped!(self, cone => cone.outer().to_degrees())
    }
}

impl Light {
    /// Returns a light of any kind, with surfaces at distances from 1 to 7.
    ///
    /// Smoothstep is a cubic, and a line a quadratic.
    ///
    /// # Errors
    /// A light whose instructions are not on record: another kind than a spotlight, a falloff that is no
    /// polynomial up to the third degree, a cutoff, another attenuation than the inverse square, or a range.
    pub fn of(name: &str, light: &AnyLight) -> Result<Self, Refusal> {
        let refused = |parameter: &str, value: &str, priced: &str| {
            let expected =
                format!("{priced}, of which instructions are on record; `luminaire export` takes any light");
            Refusal::parameter(&format!("{name}: {parameter}"), value.to_owned(), expected)
        };
        let AnyLight::Spot(spot) = light else {
            return Err(refused("kind", "no spotlight", "a spotlight"));
        };
        let cone = spot.cone();
        let (edge, slopes) = match cone.falloff() {
            AnyFalloff::Soft(_) => (Edge::Soft, None),
            AnyFalloff::Hard(_) => (Edge::Hard, None),
            AnyFalloff::Linear(_) => (Edge::Soft, Some([1.0, 1.0])),
            AnyFalloff::Smooth(_) => (Edge::Soft, Some([0.0, 0.0])),
            AnyFalloff::Quadratic(own) => (Edge::Soft, Some([own.edge_slope(), 2.0 - own.edge_slope()])),
            AnyFalloff::Cubic(own) => (Edge::Soft, Some([own.edge_slope(), own.middle_slope()])),
            other => {
                return Err(refused(
                    "falloff",
                    other.effect().name(),
                    "a polynomial up to the third degree (of a measured light by a larger --fit)",
                ));
            }
        };
        if cone.has_cutoff() {
            return Err(refused("cutoff", &cone.outer().to_degrees().to_string(), "no cutoff"));
        }
        let attenuation = match spot.attenuation() {
            // Without a range, a window is none.
            law if law.range().is_none()
                && matches!(law, AnyAttenuation::Constant(_) | AnyAttenuation::WindowedConstant(_)) =>
            {
                Attenuation::None
            }
            law if law.range().is_none()
                && matches!(
                    law,
                    AnyAttenuation::InverseSquare(_)
                        | AnyAttenuation::GltfRange(_)
                        | AnyAttenuation::FilamentRange(_)
                ) =>
            {
                Attenuation::InverseSquare
            }
            law => {
                let range = law.range().map_or_else(|| "none".to_owned(), |range| range.to_string());
                let value = format!("{}, range {range}", luminaire::attenuation::Attenuation::effects(&law));
                return Err(refused("attenuation", &value, "the inverse square or none, without a range"));
            }
        };
        let color = spot.color();
        Ok(Self {
            name: name.to_owned(),
            position: spot.position().into(),
            axis: spot.axis().into(),
            color: [color.red, color.green, color.blue],
            edge,
            slopes,
            outer: Some(cone.outer().to_degrees()),
            inner: cone.has_hotspot().then(|| cone.inner().to_degrees()),
            attenuation,
            intensity: spot.intensity(),
            ..Self::default()
        })
    }

    /// Returns the cone.
    pub(crate) fn cone(&self) -> Result<Shaped, Refusal> {
        let falloff: AnyFalloff = match (self.slopes, self.edge) {
            (Some([edge, full]), _) if edge + full == 2.0 => Quadratic::new(edge)?.into(),
            (Some([edge, full]), _) => Cubic::with_slopes(edge, full)?.into(),
            (None, Edge::Soft) => Soft.into(),
            (None, Edge::Hard) => Hard.into(),
        };
        let mut angles = [self.beam, self.field, self.outer].map(|angle| angle.map(Angle::degrees));
        if angles.iter().all(Option::is_none) {
            angles[1] = Some(Angle::degrees(36.0));
        }
        // Beam and field angle together determine the falloff.
        let falloff = (self.beam.is_none() || self.field.is_none()).then_some(falloff);
        let cone = json::from_angles(falloff, angles, self.inner, None)?;
        let cone = match cone.falloff() {
            AnyFalloff::Hard(own) => Shaped::Hard(cone.with_falloff(own)),
            AnyFalloff::Quadratic(own) => Shaped::Quadratic(cone.with_falloff(own)),
            AnyFalloff::Cubic(own) => Shaped::Cubic(cone.with_falloff(own)),
            AnyFalloff::Soft(own) => Shaped::Soft(cone.with_falloff(own)),
            other => {
                let expected = "soft, hard, a quadratic or a cubic".to_owned();
                return Err(Refusal::parameter("falloff", other.effect().name().to_owned(), expected));
            }
        };
        let (inner, hotspot) = shaped!(cone, cone => {
            (cone.inner().to_degrees(), cone.inner().versine() / cone.outer_versine())
        });
        // The inner angle is converted to degrees and back. The conversion may change the last bits
        // of the angle.
        if hotspot > 1.0 - 1e-6 {
            return Err(Refusal::parameter(
                "inner angle",
                inner.to_string(),
                format!("less than {} degrees: a step has an error of its position", cone.outer()),
            ));
        }
        Ok(cone)
    }

    /// Returns the position, rounded to multiples of 2^-16, which every format can represent.
    fn place(&self) -> [f32; 3] {
        oracle::on_grid(oracle::DVec3::from_array(self.position.map(f64::from))).as_vec3().to_array()
    }

    /// Returns the spotlight with this cone.
    pub(crate) fn spot<P: Falloff>(&self, cone: Cone<P>) -> Result<SpotLight<P>, Error> {
        let [red, green, blue] = self.color;
        SpotLight::new(self.place(), self.axis, cone)?
            .with_color(Rgb::new(red, green, blue))?
            .with_intensity(self.intensity)
    }

    /// Returns the exact light with this cone.
    pub(crate) fn truth(&self, cone: &Shaped) -> oracle::SpotLight {
        let (formula, inner, outer) = shaped!(cone, cone => {
            let Formula::Polynomial(coefficients) = cone.falloff().formula() else {
                unreachable!("the falloffs of `Shaped` are polynomials");
            };
            (coefficients, cone.inner().versine(), cone.outer_versine())
        });
        let outer = f64::from(outer);
        let falloff = oracle::Curve::Polynomial(formula.map(f64::from));
        let cone = oracle::Cone { falloff, inner: inner.into(), outer, limit: outer };
        oracle::SpotLight {
            position: oracle::DVec3::from_array(self.place().map(f64::from)),
            axis: oracle::DVec3::from_array(self.axis.map(f64::from)),
            cone,
            intensity: self.intensity.into(),
            attenuation: match self.attenuation {
                Attenuation::None => oracle::Attenuation::None,
                Attenuation::InverseSquare => oracle::Attenuation::InverseSquare,
            },
        }
    }

    /// Returns an error if a parameter of the light is invalid.
    pub(crate) fn check(&self) -> Result<(), Refusal> {
        check_text("name", &self.name)?;
        let distances = self.near > 0.0 && self.far >= self.near && self.far.is_finite();
        if !distances {
            return Err(Refusal::parameter(
                "distances",
                format!("{} to {}", self.near, self.far),
                "more than 0, the near one first".to_owned(),
            ));
        }
        self.check_grid()?;
        let cone = self.cone()?;
        shaped!(cone, cone => self.spot(cone).map(|_| ()))?;
        Ok(())
    }

    /// Returns an error if the coordinates of the nearest points have steps of more than a 16th of
    /// their distance. Their steps are 2^-16, or those of `f32` where these are larger.
    fn check_grid(&self) -> Result<(), Refusal> {
        const LEAST: f32 = 16.0 / 65_536.0;
        if self.near < LEAST {
            let expected = format!("at least {LEAST}: points have steps of 2^-16; use a smaller unit");
            return Err(Refusal::parameter("near", self.near.to_string(), expected));
        }
        // The power of two at or below `near`: a 16th of it times the 24 bits of `f32`.
        let limit = f32::from_bits(self.near.to_bits() & 0x7f80_0000) * 1_048_576.0 - self.near;
        match self.position.into_iter().find(|c| c.abs() > limit) {
            None => Ok(()),
            Some(c) => Err(Refusal::parameter(
                "position",
                c.to_string(),
                format!("coordinates of at most {limit}, or a larger near distance: f32 is too coarse there"),
            )),
        }
    }
}
