//! The pictures of an exhibit and their errors.

use luminaire::{Error, Fx16, Fx32, Scalar, Vec3, dynamic::AnyLight};
use luminaire_oracle::{DVec3, linear_codes};

use crate::{
    beam::Beam,
    seen::{Seen, dot},
    view::{Place, narrowed},
};

/// The light of a beam at the pixels of a square picture, row by row from the top: 1 is full scale.
#[derive(Clone, PartialEq, Debug)]
pub struct Picture {
    /// The light in f64.
    pub exact: Vec<f64>,
    /// By the faulty formula.
    pub faulty: Vec<f32>,
    /// By the crate.
    pub ours: Vec<f32>,
    /// The narrowest number format of the crate that holds the light.
    pub format: &'static str,
}

/// Which of the two pictures.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    /// By the faulty formula.
    Faulty,
    /// By the crate.
    Ours,
}

/// The errors of a picture in linear codes: 1/255 of full scale, or of the light itself where that
/// is more.
#[derive(Clone, PartialEq, Debug)]
pub struct Errors {
    /// The error of each pixel; NaN where the picture is NaN.
    pub codes: Vec<f32>,
    /// The largest number among them.
    pub largest: f64,
    /// The pixel of the largest error, the first if there are several.
    pub place: usize,
    /// How many pixels are NaN.
    pub undefined: usize,
}

impl Picture {
    /// Evaluates a beam at `pixels` x `pixels` points.
    ///
    /// # Errors
    /// A light that no number format holds.
    pub fn of(beam: &Beam, pixels: u32) -> Result<Self, Error> {
        let places: Vec<_> = (0..pixels)
            .flat_map(|row| (0..pixels).map(move |column| [column, row]))
            .map(|[column, row]| beam.view.place(column, row, pixels))
            .collect();
        let (format, ours) = ours(&beam.ours, &places)?;
        let (position, axis) = (beam.view.position(), beam.view.axis().normalize());
        Ok(Self {
            exact: places.iter().map(|place| exact(beam, [position, axis], place)).collect(),
            faulty: places.iter().map(|place| faulty(beam, [position, axis].map(narrowed), place)).collect(),
            ours,
            format,
        })
    }

    /// Compares one of the pictures with the exact one.
    pub fn errors(&self, side: Side) -> Errors {
        let lights = match side {
            Side::Faulty => &self.faulty,
            Side::Ours => &self.ours,
        };
        let mut errors =
            Errors { codes: Vec::with_capacity(lights.len()), largest: 0.0, place: 0, undefined: 0 };
        for (place, (&light, &exact)) in lights.iter().zip(&self.exact).enumerate() {
            let error = if light.is_nan() { f64::NAN } else { linear_codes(light.into(), exact) };
            if error > errors.largest {
                (errors.largest, errors.place) = (error, place);
            }
            errors.undefined += usize::from(error.is_nan());
            errors.codes.push(error as f32);
        }
        errors
    }
}

/// Evaluates the light in the narrowest format that holds it.
fn ours(light: &AnyLight, places: &[Place]) -> Result<(&'static str, Vec<f32>), Error> {
    if let Ok(lights) = in_format::<Fx16>(light, places) {
        return Ok(("16-bit fixed point", lights));
    }
    if let Ok(lights) = in_format::<Fx32>(light, places) {
        return Ok(("32-bit fixed point", lights));
    }
    Ok(("32-bit float", in_format::<f32>(light, places)?))
}

fn in_format<S: Scalar>(light: &AnyLight, places: &[Place]) -> Result<Vec<f32>, Error> {
    let light = light.compile::<S>()?;
    let at =
        |place: &Place| light.irradiance(S::point(narrowed(place.point)), S::normal(narrowed(place.normal)));
    Ok(places.iter().map(|place| S::light_to_f32(at(place))).collect())
}

fn exact(beam: &Beam, [position, axis]: [DVec3; 2], place: &Place) -> f64 {
    let way = place.point - position;
    let distance = way.length();
    let direction = way / distance;
    let versine = 0.5 * direction.distance_squared(axis);
    (beam.exact)(versine, distance) * -direction.dot(place.normal).min(0.0)
}

/// Lambert's cosine is not at fault: it is taken in f32 from a correctly rounded distance.
fn faulty(beam: &Beam, [position, axis]: [Vec3<f32>; 2], place: &Place) -> f32 {
    let (point, normal) = (narrowed(place.point), narrowed(place.normal));
    let way = [point.x - position.x, point.y - position.y, point.z - position.z];
    let seen = Seen { way, axis: [axis.x, axis.y, axis.z] };
    let facing = -dot(way.map(|c| c / seen.distance()), [normal.x, normal.y, normal.z]);
    (beam.faulty)(&seen) * facing.clamp(0.0, 1.0)
}
