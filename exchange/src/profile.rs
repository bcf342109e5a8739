//! Lights of scenes whose intensities over the angle are those of a photometric file beside the scene.

use std::borrow::Cow;
use std::collections::HashMap;
use std::f64::consts::PI;

use glam::DVec3;
use luminaire::dynamic::AnyLight;

use crate::curve::Curve;
use crate::fit::share;
use crate::lamp::{Lamp, Place, placed};
use crate::measured;
use crate::read::ies;
use crate::reading::Reading;
use crate::record::Profile;
use crate::refusal::Refusal;
use crate::text::decode;
use crate::tool::vector;

/// Returns the bytes of a file by the name that another file has for it, or says why not.
pub type Beside<'a> = &'a dyn Fn(&str) -> Result<Vec<u8>, String>;

/// The most different shapes of a scene's lights, which bounds the time.
const MOST: usize = 256;

/// The most intensities of all lights of a scene, which bounds the memory.
const INTENSITIES: usize = 1 << 20;

/// The photometric files of a scene, each read once, and the lights of each shape.
pub(crate) struct Profiles<'a> {
    beside: Beside<'a>,
    reading: Reading,
    shapes: HashMap<String, Result<Shape, Refusal>>,
    intensities: usize,
}

/// The lights of an intensity of 1, their flux in lumens, and the notes of the file.
struct Shape {
    lamps: Vec<Lamp>,
    lumens: f64,
    notes: Vec<String>,
}

impl<'a> Profiles<'a> {
    pub(crate) fn new(beside: Beside<'a>, reading: Reading) -> Self {
        Self { beside, reading, shapes: HashMap::new(), intensities: 0 }
    }

    /// Returns the lights of a profile, those of [`measured::lamps`], along an axis at the place and in the colour of a
    /// light without it.
    ///
    /// # Errors
    /// A file that is not there or that its reader does not accept, over 256 different shapes, over 1,048,576
    /// intensities of all lights, or one that the kernel cannot hold.
    pub(crate) fn lamps(&mut self, profile: &Profile, own: &Lamp, axis: DVec3) -> Result<Vec<Lamp>, Refusal> {
        let spot = if let AnyLight::Spot(spot) = &own.light { Some(spot) } else { None };
        let Profile { file, part, content, .. } = profile;
        let key = format!("{file} {part:?} {} {:?}", content.is_some(), spot.map(luminaire::SpotLight::cone));
        if self.shapes.len() >= MOST && !self.shapes.contains_key(&key) {
            return Err(Refusal::new("profiles", "more", format_args!("at most {MOST} different ones")));
        }
        let Self { beside, reading, shapes, intensities } = self;
        let shape = shapes.entry(key).or_insert_with(|| shape(*beside, *reading, profile, own));
        let Shape { lamps, lumens, notes } = shape.as_ref().map_err(Clone::clone)?;
        *intensities +=
            lamps.iter().flat_map(|lamp| &lamp.measured).map(|curve| curve.points().len()).sum::<usize>();
        if *intensities > INTENSITIES {
            let expected = format_args!("at most {INTENSITIES} of all lights: export a part of the scene");
            return Err(Refusal::new("intensities of profiles", "more", expected));
        }
        let intensity = f64::from(own.light.intensity());
        let factor = if profile.is_normalized { 4.0 * PI * intensity / lumens } else { intensity };
        let position = match &own.light {
            AnyLight::Spot(spot) => spot.position(),
            AnyLight::Point(point) => point.position(),
            AnyLight::Measured(light) => light.position(),
            AnyLight::Directional(_) => {
                return Err(Refusal::new("light", "directional", "a light with a place"));
            }
        };
        let mut found = Vec::new();
        for lamp in lamps {
            let is_up = matches!(&lamp.light, AnyLight::Spot(spot) if spot.axis().y > 0.0);
            let place = Place {
                position: Some(position.into()),
                axis: Some(vector(if is_up { -axis } else { axis }).into()),
                intensity: Some((f64::from(lamp.light.intensity()) * factor) as f32),
            };
            let points = lamp.measured.iter().flat_map(Curve::points);
            found.push(Lamp {
                name: format!("{}{}", own.name, lamp.name),
                light: placed(lamp.light, place)?.with_color(own.light.color())?,
                measured: Curve::new(points.map(|&(angle, candela)| (angle, candela * factor)).collect()),
                notes: [&own.notes[..], notes, &lamp.notes].concat(),
                ..lamp.clone()
            });
        }
        Ok(found)
    }
}

/// Returns the lights of a file, at the origin and down along -y, with the cone of a light times the file.
fn shape(beside: Beside, reading: Reading, profile: &Profile, own: &Lamp) -> Result<Shape, Refusal> {
    let Profile { file, content, part, .. } = profile;
    let unread =
        |reason: String| Refusal::new("file", file, format_args!("a file beside this one: {reason}"));
    let bytes = match content {
        Some(content) => Cow::Borrowed(&**content),
        None => Cow::Owned(beside(file).map_err(unread)?),
    };
    let own_part = part.clone().unwrap_or(0..bytes.len());
    let bytes = bytes.get(own_part.clone()).ok_or_else(|| {
        unread(format!("it ends after {} bytes, before byte {}", bytes.len(), own_part.end))
    })?;
    let text = decode(bytes)?;
    // How a light with planes is turned about its axis, the scene does not say in a way that tools share.
    let photometry = ies::read(&text, reading)?;
    let (curve, difference) = photometry.round()?;
    let mut curve = curve.clone();
    if let AnyLight::Spot(spot) = own.light
        && let Some(cone) = Lamp::new("", spot.with_intensity(1.0)?).curve()
    {
        // A cone that ends beyond the file's light, and is level up to there, takes none of it.
        let is_open = share(&spot.cone(), curve.end()) == 1.0;
        if !is_open {
            let angles = curve.points().iter().chain(cone.points()).map(|point| point.0);
            let mut points: Vec<_> = angles
                .filter(|&angle| angle <= cone.end())
                .map(|angle| (angle, curve.at(angle) * cone.at(angle)))
                .collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            points.dedup_by_key(|point| point.0);
            curve = Curve::new(points).unwrap_or(curve);
        }
    }
    let lamps = measured::lamps("", &curve, difference, reading.fit)?;
    Ok(Shape { lamps, lumens: curve.lumens(), notes: photometry.notes })
}
