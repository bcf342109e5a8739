//! A light that was read.

use glam::{DAffine3, DMat3, DQuat, DVec3};
use luminaire::attenuation::{AnyAttenuation, Attenuation};
use luminaire::dmx::Patch;
use luminaire::dynamic::AnyLight;
use luminaire::{DirectionalLight, MeasuredLight, PointLight, Rgb, SpotLight, Vec3};
use luminaire_export::json::NamedAmbient;

use crate::curve::Curve;
use crate::difference::Difference;
use crate::fit::{Fit, share};
use crate::refusal::Refusal;
use crate::system::System;

/// A light of a file or of a command, as a light of [`luminaire`].
#[derive(Clone, PartialEq, Debug)]
pub struct Lamp {
    /// The name in the file; not unique, and not an identifier.
    pub name: String,
    /// The light. Its intensity is that of the source, with a colour temperature that of its strongest channel:
    /// [`own_intensity`](Self::own_intensity) is in the source's unit.
    pub light: AnyLight,
    /// The correlated colour temperature in kelvin whose white is the light's colour, if the source or the user
    /// states one.
    pub kelvin: Option<f32>,
    /// How many units of the source are one of the light: 1, but for a document, whose intensities are in units of full
    /// scale.
    pub full_scale: f64,
    /// The largest difference between the light and that of the source.
    pub difference: Difference,
    /// Whether the source leaves the falloff open, as one published angle does.
    pub is_assumed: bool,
    /// The measured intensities of a photometric file, over the whole sphere for a point light.
    pub measured: Option<Curve>,
    /// The cones that were tried for the measured intensities, the cheapest first; the last one is that
    /// of the light.
    pub fits: Vec<Fit>,
    /// The light of the widest zoom, of a fixture with one. `light` is that of the narrowest.
    pub widest: Option<AnyLight>,
    /// The channels by which a console controls the light, of a fixture of GDTF.
    pub patch: Option<Patched>,
    /// The nearest and the farthest surface, where the source says so.
    pub surfaces: Option<[f32; 2]>,
    /// What was assumed or left out, a sentence each.
    pub notes: Vec<String>,
}

/// The channels of a DMX mode that control a light.
#[derive(Clone, PartialEq, Debug)]
pub struct Patched {
    /// The channels, at address 1.
    pub patch: Patch,
    /// The name of the mode.
    pub mode: String,
    /// What was left out, a sentence each.
    pub notes: Vec<String>,
}

impl Patched {
    /// Mounts the fixture so that its light at rest, which points down where it hangs, is along an axis: by the shortest turn, or for
    /// an axis that points up by half a turn about x, as of a fixture that stands.
    ///
    /// # Errors
    /// An axis without a direction.
    pub fn mount_along(&mut self, axis: [f32; 3]) -> Result<(), Refusal> {
        let toward = double(DirectionalLight::new(axis)?.direction());
        let turn = if toward.y > 1.0 - 1e-9 {
            DQuat::from_rotation_x(std::f64::consts::PI)
        } else {
            DQuat::from_rotation_arc(DVec3::NEG_Y, toward.normalize())
        };
        let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|own| Vec3::from((turn * own).as_vec3().to_array()));
        self.patch = self.patch.with_mount(axes)?;
        Ok(())
    }
}

impl Lamp {
    /// Creates an exact light without further knowledge of it.
    pub fn new(name: impl Into<String>, light: impl Into<AnyLight>) -> Self {
        Self {
            name: name.into(),
            light: light.into(),
            kelvin: None,
            full_scale: 1.0,
            difference: Difference::default(),
            is_assumed: false,
            measured: None,
            fits: Vec::new(),
            widest: None,
            patch: None,
            surfaces: None,
            notes: Vec::new(),
        }
    }

    /// Returns the light, and for a zoom a second light of the widest cone: the ends of
    /// [`Cone::zoomed`](luminaire::Cone::zoomed).
    pub fn ends(self) -> impl Iterator<Item = Self> {
        let (kelvin, is_assumed) = (self.kelvin, self.is_assumed);
        let widest =
            |light| Self { kelvin, is_assumed, ..Self::new(format!("{}, widest", self.name), light) };
        let widest = self.widest.map(widest);
        std::iter::once(self).chain(widest)
    }

    /// Sets the colour of the light, and of its widest zoom, to white of a correlated colour temperature. The
    /// luminance stays: the intensity of the strongest channel exceeds that of the source.
    ///
    /// # Errors
    /// A temperature outside [1000, 25,000] kelvin, or an intensity that exceeds 1e9. The light stays as it is.
    pub fn set_kelvin(&mut self, kelvin: f32) -> Result<(), Refusal> {
        let light = self.light.with_kelvin(kelvin)?;
        self.widest = self.widest.map(|light| light.with_kelvin(kelvin)).transpose()?;
        (self.light, self.kelvin) = (light, Some(kelvin));
        Ok(())
    }

    /// Returns the light in white of the temperature that its source states, or as it is, with a note why.
    pub(crate) fn in_white(mut self, kelvin: Option<f64>) -> Self {
        if let Some(kelvin) = kelvin
            && let Err(refusal) = self.set_kelvin(kelvin as f32)
        {
            self.notes.push(format!("the white of the file is left out: {refusal}"));
        }
        self
    }

    /// Returns the light moved by a transform.
    ///
    /// # Errors
    /// A transform that leaves no axis, or a place that the light cannot have.
    pub(crate) fn moved(mut self, transform: DAffine3) -> Result<Self, Refusal> {
        let moved = |light: AnyLight| {
            let [position, axis] = match &light {
                AnyLight::Spot(spot) => [Some(spot.position()), Some(spot.given_axis())],
                AnyLight::Measured(light) => [Some(light.position()), Some(light.given_axis())],
                AnyLight::Point(point) => [Some(point.position()), None],
                AnyLight::Directional(sun) => [None, Some(sun.given_direction())],
            };
            let position = position.map(|place| transform.transform_point3(double(place)) + 0.0);
            let axis = axis.map(|axis| transform.transform_vector3(double(axis)));
            // Not normalized as it is: its square may overflow. Without a negative zero.
            let axis = axis.map(|axis| (axis / axis.abs().max_element()).normalize() + 0.0);
            let [position, axis] = [position, axis].map(|v| v.map(|v| v.as_vec3().to_array()));
            placed(light, Place { position, axis, intensity: None })
        };
        let widest = self.widest.map(moved).transpose()?;
        (self.light, self.widest) = (moved(self.light)?, widest);
        if !(transform.matrix3.transpose() * transform.matrix3).abs_diff_eq(DMat3::IDENTITY, 1e-4) {
            self.notes.push("its nodes scale: the beam keeps its angles".to_owned());
        }
        Ok(self)
    }

    /// Returns the light aimed at a place, if there is one.
    ///
    /// # Errors
    /// The place of the light itself.
    pub(crate) fn aimed(mut self, at: Option<DVec3>) -> Result<Self, Refusal> {
        if let (Some(at), AnyLight::Spot(spot)) = (at, &self.light) {
            let axis = (at - double(spot.position())).as_vec3().to_array();
            self.light = placed(self.light, Place { axis: Some(axis), ..Place::default() })?;
        }
        Ok(self)
    }

    /// Returns the intensity in the unit of the source: candela, where the source has candela.
    pub fn own_intensity(&self) -> f64 {
        let luminance = self.kelvin.map_or(1.0, |_| self.light.color().luminance());
        f64::from(self.light.intensity() * luminance)
    }

    /// Returns the attenuation; `None` of a directional light.
    pub fn attenuation(&self) -> Option<AnyAttenuation> {
        match &self.light {
            AnyLight::Spot(spot) => Some(spot.attenuation()),
            AnyLight::Point(point) => Some(point.attenuation()),
            AnyLight::Measured(light) => Some(light.attenuation()),
            AnyLight::Directional(_) => None,
        }
    }

    /// Returns the irradiance of the strongest channel on the axis at a distance.
    pub fn at(&self, distance: f64) -> f64 {
        f64::from(self.light.intensity()) * self.share(distance)
    }

    /// Returns the irradiance on the axis at a distance in the unit of the source: lux, where the source has candela.
    pub fn lit(&self, distance: f64) -> f64 {
        self.own_intensity() * self.share(distance)
    }

    fn share(&self, distance: f64) -> f64 {
        self.attenuation().map_or(1.0, |attenuation| attenuation.exact(distance))
    }

    /// Sets the linear colour of the light, which then has the intensity of its source.
    ///
    /// # Errors
    /// A channel outside [0, 1]. The light stays as it is.
    pub fn set_color(&mut self, color: [f32; 3]) -> Result<(), Refusal> {
        self.light = self.light.with_color(color.into())?.with_intensity(self.own_intensity() as f32)?;
        self.kelvin = None;
        Ok(())
    }

    /// Returns the light behind a gel that passes these parts of the channels of linear sRGB.
    ///
    /// # Errors
    /// A gel that passes nothing of the light.
    pub(crate) fn behind(mut self, gel: Rgb<f32>) -> Result<Self, Refusal> {
        if gel == Rgb::new(1.0, 1.0, 1.0) {
            return Ok(self);
        }
        let color = self.light.color().zip(gel, |channel, part| channel * part);
        let strongest = color.strongest();
        let light = self.light.with_intensity(self.light.intensity() * strongest)?;
        if light.intensity() == 0.0 {
            return Err(Refusal::new("Color", "black", "a colour that passes light"));
        }
        self.light = light.with_color(color.map(|channel| channel / strongest))?;
        self.kelvin = None;
        Ok(self)
    }

    /// Returns the intensities over the angle: those that were measured, or those of a spotlight at
    /// up to 258 angles, between its inner and its outer angle multiples of 0.0001 degrees, which a
    /// file of IES holds; `None` for a light of another kind. A cone that ends with light has a
    /// curve that does.
    pub fn curve(&self) -> Option<Curve> {
        if self.measured.is_some() {
            return self.measured.clone();
        }
        let AnyLight::Spot(spot) = &self.light else { return None };
        let (cone, candela) = (spot.cone(), self.own_intensity());
        let [start, end] = [cone.inner(), cone.outer()].map(|full| f64::from(full.to_degrees()) / 2.0);
        let cells = ((end - start) / 2e-4).clamp(1.0, 256.0) as u32;
        let even = (1..cells).map(|i| start + (end - start) * f64::from(i) / f64::from(cells));
        let even = even.map(|angle| (angle * 1e4).round() / 1e4);
        let at = |angle: f64| {
            let last = share(&cone, angle.min(end * (1.0 - 1e-6)));
            (angle, candela * if angle < end || last > 1e-3 { last } else { 0.0 })
        };
        let mut points: Vec<_> = [0.0, start].into_iter().chain(even).chain([end]).map(at).collect();
        points.dedup_by_key(|point| point.0);
        Curve::new(points)
    }
}

/// How a light is used.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Use {
    /// The distance of the surface that counts.
    pub throw: f64,
    /// The irradiance that tools without units show as full scale.
    pub full_scale: f64,
    /// Whether the intensity of the light is in candela.
    pub is_photometric: bool,
}

impl Use {
    /// Returns the same use, but for a light that ends before twice the throw with half its range
    /// as the throw.
    #[must_use]
    pub fn within(self, lamp: &Lamp) -> Self {
        let range = lamp.attenuation().and_then(|attenuation| attenuation.range());
        Self { throw: range.map_or(self.throw, |range| self.throw.min(f64::from(range) / 2.0)), ..self }
    }
}

/// A place and an intensity in place of those of a light.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Place {
    /// The position.
    pub position: Option<[f32; 3]>,
    /// The axis of a spotlight, or the direction of a directional light.
    pub axis: Option<[f32; 3]>,
    /// The intensity.
    pub intensity: Option<f32>,
}

/// Returns a light at another place.
///
/// # Errors
/// A value that the constructors of the light reject.
pub fn placed(light: AnyLight, place: Place) -> Result<AnyLight, Refusal> {
    let intensity = place.intensity.unwrap_or(light.intensity());
    let moved: AnyLight = match light {
        AnyLight::Spot(spot) => {
            let position = place.position.map_or(spot.position(), Into::into);
            let axis = place.axis.map_or(spot.given_axis(), Into::into);
            SpotLight::new(position, axis, spot.cone())?.with_attenuation(spot.attenuation()).into()
        }
        AnyLight::Measured(light) => {
            let position = place.position.map_or(light.position(), Into::into);
            let [own, side] = [light.given_axis(), light.given_side()].map(double);
            let axis = place.axis.map_or(own, |axis| double(axis.into()));
            // The side turns with the axis.
            let turn = DQuat::from_rotation_arc(own.normalize(), axis.normalize_or(own.normalize()));
            let [axis, side] = [axis, turn * side].map(|v| v.as_vec3().to_array());
            MeasuredLight::new(position, axis, side, light.distribution())?
                .with_attenuation(light.attenuation())
                .into()
        }
        AnyLight::Point(point) => {
            let position = place.position.map_or(point.position(), Into::into);
            PointLight::new(position)?.with_attenuation(point.attenuation()).into()
        }
        AnyLight::Directional(sun) => {
            DirectionalLight::new(place.axis.map_or(sun.given_direction(), Into::into))?.into()
        }
    };
    let moved = moved.with_color(light.color())?.with_specular_color(light.specular_color())?;
    Ok(moved.with_intensity(intensity)?)
}

fn double(v: Vec3<f32>) -> DVec3 {
    DVec3::from(<[f32; 3]>::from(v).map(f64::from))
}

/// The lights of one input.
#[derive(Clone, PartialEq, Debug)]
pub struct Lamps {
    /// The system of the input.
    pub system: System,
    /// The lights, in the order of the file, but for ambient light.
    pub lamps: Vec<Lamp>,
    /// The ambient light, with the intensities of the source.
    pub ambient: Vec<NamedAmbient>,
    /// The lights of the file that could not be read.
    pub refused: Vec<Refusal>,
    /// What holds for the whole file, a sentence each.
    pub notes: Vec<String>,
}

impl Lamps {
    /// Creates a list without lights.
    pub fn new(system: System) -> Self {
        Self { system, lamps: Vec::new(), ambient: Vec::new(), refused: Vec::new(), notes: Vec::new() }
    }

    /// Returns whether there is no light, not even one that was refused.
    pub fn is_empty(&self) -> bool {
        self.lamps.is_empty() && self.ambient.is_empty() && self.refused.is_empty()
    }

    /// Returns how the lights are used at a throw. Of photometry, what the brightest light gives there on its
    /// axis is full scale.
    pub fn usage(&self, throw: f64) -> Use {
        let brightest = self.lamps.iter().map(|lamp| lamp.at(throw)).fold(0.0, f64::max);
        use System::{Eulumdat, Gdtf, Ies, Mvr, Ofl};
        let is_measured = matches!(self.system, Ies | Eulumdat | Gdtf | Mvr | Ofl);
        let full_scale = if is_measured && brightest > 0.0 { brightest } else { 1.0 };
        Use { throw, full_scale, is_photometric: self.system.is_photometric() }
    }
}
