//! The description of a light, and the distances of the surfaces that it lights.

use luminaire::attenuation::{InverseSquare, NoAttenuation};
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Cubic, Hard, Quadratic, Soft};
use luminaire::{Angle, Cone, MeasuredLight, PointLight, Rgb, SpotLight, Vec3};
use luminaire_export::check_text;
use luminaire_export::json::{self, Lights, NamedLight};
use luminaire_oracle as oracle;
use serde::de::Error as _;
use serde::ser::{Error as _, SerializeMap};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Value, json};

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

impl Edge {
    /// The falloff of the edge.
    pub fn falloff(self) -> AnyFalloff {
        match self {
            Self::Soft => Soft.into(),
            Self::Hard => Hard.into(),
        }
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

/// A light, and the distances at which surfaces receive its light: a spotlight by its angles, or with
/// [`light`](Self::light) any.
///
/// Angles are full angles in degrees. One of beam, field and outer angle determines the cone. If
/// both beam and field angle are given, the falloff is fitted to both angles, and `edge` has no
/// effect. Without any of these angles, the field angle is 36 degrees.
#[derive(Clone, PartialEq, Debug, Deserialize)]
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
    /// The light itself, in place of all fields above but the name and the distances: a light of any kind, with any
    /// falloff and any attenuation. In JSON it is a light as [`luminaire_export`] describes it.
    #[serde(deserialize_with = "from_document")]
    pub light: Option<AnyLight>,
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
            light: None,
        }
    }
}

/// Writes the fields that have an effect.
impl Serialize for Light {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        // All fields by name: one that is added does not compile until it is written.
        let Self { name, position, axis, color, edge, slopes, beam, field, outer, inner, .. } = self;
        let Self { attenuation, intensity, near, far, light, .. } = self;
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("name", name)?;
        match light {
            Some(light) => {
                map.serialize_entry("light", &document(light).map_err(S::Error::custom)?)?;
            }
            None => {
                map.serialize_entry("position", position)?;
                map.serialize_entry("axis", axis)?;
                map.serialize_entry("color", color)?;
                map.serialize_entry("edge", edge)?;
                map.serialize_entry("slopes", slopes)?;
                map.serialize_entry("beam", beam)?;
                map.serialize_entry("field", field)?;
                map.serialize_entry("outer", outer)?;
                map.serialize_entry("inner", inner)?;
                map.serialize_entry("attenuation", attenuation)?;
                map.serialize_entry("intensity", intensity)?;
            }
        }
        map.serialize_entry("near", near)?;
        map.serialize_entry("far", far)?;
        map.end()
    }
}

/// Returns a light as a document has it, without a name.
fn document(light: &AnyLight) -> Result<Value, String> {
    let named = NamedLight { name: String::new(), light: *light, surfaces: None, about: None };
    let lights = Lights { lights: vec![named], ambient: Vec::new() };
    let text = json::write(&lights).map_err(|error| error.to_string())?;
    let mut document: Value = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    let mut light = document["lights"][0].take();
    if let Some(members) = light.as_object_mut() {
        members.remove("name");
    }
    Ok(light)
}

/// Reads a light of a document.
fn from_document<'de, D: Deserializer<'de>>(from: D) -> Result<Option<AnyLight>, D::Error> {
    let Some(light) = Option::<Value>::deserialize(from)? else { return Ok(None) };
    let document = json!({ "format": "luminaire-lights-1", "lights": [light] });
    let read = json::read(&document.to_string()).map_err(D::Error::custom)?;
    Ok(read.lights.first().map(|named| named.light))
}

impl Light {
    /// Returns a light of any kind, with surfaces at distances from 1 to 7.
    pub fn of(name: &str, light: &AnyLight) -> Self {
        Self { name: name.to_owned(), light: Some(*light), ..Self::default() }
    }

    /// Returns the distance at which the light is full scale on its axis, with four digits, and from which on it is at most
    /// that; `None` of a light that is never so, or always.
    ///
    /// # Errors
    /// A parameter of the light that is invalid.
    pub fn full_scale(&self) -> Result<Option<f32>, Refusal> {
        let distance = match self.any()? {
            AnyLight::Spot(spot) => spot.range_above(1.0),
            AnyLight::Point(point) => point.range_above(1.0),
            AnyLight::Measured(own) => own.range_above(1.0),
            AnyLight::Directional(_) => return Ok(None),
        };
        let short: f32 = format!("{distance:.3e}").parse().unwrap_or(distance);
        Ok(Some(short).filter(|short| (1e-3..=1e6).contains(short)))
    }

    /// Returns the light that this describes. Its position is rounded to multiples of 2^-16, which every format can
    /// represent.
    ///
    /// # Errors
    /// A parameter of the light that is invalid.
    pub fn any(&self) -> Result<AnyLight, Refusal> {
        let Some(light) = self.light else {
            let [red, green, blue] = self.color;
            let spot = SpotLight::new(on_grid(self.position), self.axis, self.cone()?)?
                .with_color(Rgb::new(red, green, blue))?
                .with_intensity(self.intensity)?;
            return Ok(match self.attenuation {
                Attenuation::None => spot.with_attenuation(NoAttenuation).into(),
                Attenuation::InverseSquare => spot.with_attenuation(InverseSquare).into(),
            });
        };
        let placed = |position: Vec3<f32>| on_grid(position.into());
        let moved: AnyLight = match light {
            AnyLight::Spot(spot) => SpotLight::new(placed(spot.position()), spot.given_axis(), spot.cone())?
                .with_attenuation(spot.attenuation())
                .into(),
            AnyLight::Point(point) => {
                PointLight::new(placed(point.position()))?.with_attenuation(point.attenuation()).into()
            }
            AnyLight::Measured(own) => {
                let axes = (own.given_axis(), own.given_side());
                MeasuredLight::new(placed(own.position()), axes.0, axes.1, own.distribution())?
                    .with_attenuation(own.attenuation())
                    .into()
            }
            AnyLight::Directional(_) => light,
        };
        let moved = moved.with_color(light.color())?.with_specular_color(light.specular_color())?;
        Ok(moved.with_intensity(light.intensity())?)
    }

    /// Returns the cone of the angles.
    fn cone(&self) -> Result<Cone<AnyFalloff>, Refusal> {
        let falloff: AnyFalloff = match (self.slopes, self.edge) {
            (Some([edge, full]), _) if edge + full == 2.0 => Quadratic::new(edge)?.into(),
            (Some([edge, full]), _) => Cubic::with_slopes(edge, full)?.into(),
            (None, edge) => edge.falloff(),
        };
        let mut angles = [self.beam, self.field, self.outer].map(|angle| angle.map(Angle::degrees));
        if angles.iter().all(Option::is_none) {
            angles[1] = Some(Angle::degrees(36.0));
        }
        // Beam and field angle together determine the falloff.
        let falloff = (self.beam.is_none() || self.field.is_none()).then_some(falloff);
        let cone = json::from_angles(falloff, angles, self.inner, None)?;
        // The inner angle is converted to degrees and back. The conversion may change the last bits
        // of the angle.
        if cone.inner().versine() / cone.outer_versine() > 1.0 - 1e-6 {
            return Err(Refusal::parameter(
                "inner angle",
                cone.inner().to_degrees().to_string(),
                format!(
                    "less than {} degrees: a step has an error of its position",
                    cone.outer().to_degrees()
                ),
            ));
        }
        Ok(cone)
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
        if let Some(light) = &self.light {
            let alone = Self { near: self.near, far: self.far, ..Self::of(&self.name, light) };
            if *self != alone {
                let expected =
                    "the name, near and far alone beside it: it has its own angles, place and intensity";
                return Err(Refusal::parameter("light", json::kind(light).to_owned(), expected.to_owned()));
            }
        }
        match self.light {
            Some(AnyLight::Spot(spot)) => self.check_grid(spot.position().into()),
            Some(AnyLight::Point(point)) => self.check_grid(point.position().into()),
            Some(AnyLight::Measured(light)) => self.check_grid(light.position().into()),
            Some(AnyLight::Directional(_)) => Ok(()),
            None => self.check_grid(self.position),
        }
    }

    /// Returns an error if the coordinates of the nearest points have steps of more than a 16th of
    /// their distance. Their steps are 2^-16, or those of `f32` where these are larger.
    fn check_grid(&self, position: [f32; 3]) -> Result<(), Refusal> {
        const LEAST: f32 = 16.0 / 65_536.0;
        if self.near < LEAST {
            let expected = format!("at least {LEAST}: points have steps of 2^-16; use a smaller unit");
            return Err(Refusal::parameter("near", self.near.to_string(), expected));
        }
        // The power of two at or below `near`: a 16th of it times the 24 bits of `f32`.
        let limit = f32::from_bits(self.near.to_bits() & 0x7f80_0000) * 1_048_576.0 - self.near;
        match position.into_iter().find(|c| c.abs() > limit) {
            None => Ok(()),
            Some(c) => Err(Refusal::parameter(
                "position",
                c.to_string(),
                format!("coordinates of at most {limit}, or a larger near distance: f32 is too coarse there"),
            )),
        }
    }
}

/// Returns a position, rounded to multiples of 2^-16.
fn on_grid(position: [f32; 3]) -> [f32; 3] {
    oracle::on_grid(oracle::DVec3::from_array(position.map(f64::from))).as_vec3().to_array()
}
