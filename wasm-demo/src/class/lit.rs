//! Pictures that the kernel lights.

use super::figure::{Drawing, Graph, Picture};
use crate::refusal::Refusal;
use luminaire::{
    Cone, SpotLight,
    attenuation::{Attenuation, NoAttenuation},
    display::encode_srgb,
    falloff::Falloff,
};
use luminaire_oracle::{DVec3, versine_between};

/// The axis of beams from the origin. Along an axis of the coordinates a dot product would have one term.
pub(crate) const AXIS: DVec3 = DVec3::new(0.36, 0.48, -0.8);
const ACROSS: [DVec3; 2] = [DVec3::new(0.8, -0.6, 0.0), DVec3::new(0.48, 0.64, 0.6)];

/// A picture of linear light at places: x in [-1, 1] to the right, y up in the same unit, and the pixel's
/// column and row.
pub(crate) fn picture(
    label: &'static str,
    seen: String,
    [width, height]: [usize; 2],
    light: impl Fn(f64, f64, [u32; 2]) -> f64,
) -> Picture {
    let place = |i: usize, count: usize| ((2 * i + 1) as f64 - count as f64) / width as f64;
    let pixel = |i: usize| {
        let [column, row] = [i % width, i / width];
        let light = light(place(column, width), -place(row, height), [column as u32, row as u32]);
        encode_srgb(light as f32)
    };
    Picture { label, seen, width, codes: (0..width * height).map(pixel).collect() }
}

/// The intensity of a spotlight in the directions around its axis.
pub(crate) struct Beam {
    label: &'static str,
    light: Box<dyn Fn([f32; 3]) -> f32>,
}

impl Beam {
    /// The beam of a formula: the intensity at a point at distance 1.
    pub(crate) fn by(label: &'static str, light: impl Fn([f32; 3]) -> f32 + 'static) -> Self {
        Self { label, light: Box::new(light) }
    }

    /// The kernel's beam.
    pub(crate) fn of<P: Falloff + 'static>(label: &'static str, cone: Cone<P>) -> Result<Self, Refusal> {
        Self::spot(label, SpotLight::new([0.0; 3], single(AXIS), cone)?.with_attenuation(NoAttenuation))
    }

    /// The beam of a light at the origin.
    pub(crate) fn spot<P: Falloff + 'static, A: Attenuation + 'static>(
        label: &'static str,
        light: SpotLight<P, A>,
    ) -> Result<Self, Refusal> {
        let light = light.compile::<f32>()?;
        Ok(Self::by(label, move |point| light.falloff_at(point.into())))
    }

    /// The intensity at an angle off the axis in degrees, turned about it in radians.
    pub(crate) fn toward(&self, degrees: f64, turn: f64) -> f64 {
        (self.light)(direction(degrees, turn)).into()
    }

    /// The intensity at an angle off the axis, in degrees.
    pub(crate) fn at(&self, degrees: f64) -> f64 {
        self.toward(degrees, 0.0)
    }

    /// The largest difference from an intensity over the versine, in linear codes, up to an angle.
    pub(crate) fn error(&self, reach: f64, exact: impl Fn(f64) -> f64) -> f64 {
        let places = (0..90_000).map(|i| direction(reach * f64::from(i % 300) / 300.0, f64::from(i / 300)));
        let error = |place: [f32; 3]| {
            let versine = versine_between(DVec3::from(place.map(f64::from)), AXIS);
            luminaire_oracle::linear_codes((self.light)(place).into(), exact(versine))
        };
        places.map(error).fold(0.0, f64::max)
    }
}

fn direction(degrees: f64, turn: f64) -> [f32; 3] {
    let ((sine, cosine), (up, right)) = (degrees.to_radians().sin_cos(), turn.sin_cos());
    single(AXIS * cosine + sine * (right * ACROSS[0] + up * ACROSS[1]))
}

/// Pictures and curves of beams up to an angle off the axis, and labelled angles. In a picture the
/// distance from the middle is the angle.
pub(crate) fn beams(beams: &[Beam], reach: f64, marks: &[(f64, &str)]) -> Drawing {
    let curve = |beam: &Beam| (beam.label, sampled([-reach, reach], |degrees| beam.at(degrees)));
    let mark = |&(degrees, label): &(f64, &str)| ([degrees, beams[0].at(degrees)], label.to_owned());
    let dome = |beam: &Beam| {
        let seen = format!("{}: a round spot of light in a picture {:.1}° wide", beam.label, 2.0 * reach);
        picture(beam.label, seen, [360; 2], |x, y, _| beam.toward(reach * x.hypot(y), y.atan2(x)))
    };
    Drawing {
        pictures: beams.iter().map(dome).collect(),
        graph: Some(Graph {
            across: ("angle off the axis, °", [-reach, reach]),
            up: ("intensity", 1.0),
            curves: beams.iter().map(curve).collect(),
            marks: marks.iter().map(mark).collect(),
        }),
        ..Drawing::default()
    }
}

/// Samples of a curve over an axis.
pub(crate) fn sampled([from, to]: [f64; 2], at: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
    let place = |i| from + (to - from) * f64::from(i) / 240.0;
    (0..=240).map(|i| [place(i), at(place(i))]).collect()
}

/// Components in f32.
pub(crate) fn single(v: DVec3) -> [f32; 3] {
    v.as_vec3().to_array()
}
