//! The visitor's settings of one light, over the light as the scene has it.

use crate::{
    fixture,
    format::Format,
    light::{LightState, Mark, edge_name, edge_named},
    refusal::Refusal,
};
use luminaire::{
    Angle, Cone, Error, PointLight, Rgb, SpotLight, Vec3,
    attenuation::AnyAttenuation,
    display::decode_srgb,
    dynamic::AnyLight,
    falloff::{AnyFalloff, SoftOrHard},
};
use luminaire_fixtures::Fixture;
use luminaire_render::scenes::MovingLight;

/// The angle that a cone is designed from. The kernel computes the others.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Design {
    pub(crate) mark: Mark,
    pub(crate) degrees: f32,
}

/// What the visitor has changed of a light. `None` is as the scene has it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Setting {
    /// The number of the light in the scene. Copies of a light share it.
    pub(crate) of: usize,
    pub(crate) is_on: bool,
    pub(crate) design: Option<Design>,
    pub(crate) edge: Option<SoftOrHard>,
    /// The fixture whose published angle is the angle of the design.
    pub(crate) fixture: Option<&'static Fixture>,
    /// The colour in sRGB.
    pub(crate) color: Option<[u8; 3]>,
    pub(crate) intensity: Option<f32>,
    pub(crate) position: Option<Vec3<f32>>,
    /// The point at which the light aims. It makes a light that moves stand still.
    pub(crate) target: Option<Vec3<f32>>,
}

impl Setting {
    /// A light as the scene has it.
    pub(crate) fn of(light: usize) -> Self {
        Self {
            of: light,
            is_on: true,
            design: None,
            edge: None,
            fixture: None,
            color: None,
            intensity: None,
            position: None,
            target: None,
        }
    }

    /// Sets a value by its name: the `beam`, `field` or `zoom` angle in degrees, or the `intensity`.
    pub(crate) fn set_number(&mut self, name: &str, value: f32) -> Result<(), Refusal> {
        match name {
            "beam" => self.set_angle(Mark::Beam, value),
            "field" => self.set_angle(Mark::Field, value),
            "zoom" => return self.set_zoom(value),
            "intensity" => self.intensity = Some(value),
            _ => return Err(Refusal::name("number of a light", name, "beam, field, zoom or intensity")),
        }
        Ok(())
    }

    /// Sets a choice by its name: the `edge`, `color`, `fixture`, or `reading` of its angle.
    pub(crate) fn set_choice(&mut self, name: &str, value: &str) -> Result<(), Refusal> {
        match name {
            "edge" => self.edge = edge_named(value)?,
            "color" => self.color = Some(channels_of(value)?),
            "fixture" => self.set_fixture(value)?,
            "reading" => self.set_reading(Mark::named(value)?),
            _ => return Err(Refusal::name("choice of a light", name, "edge, color, fixture or reading")),
        }
        Ok(())
    }

    /// Sets one angle of the cone, which determines the other two. This removes the fixture.
    fn set_angle(&mut self, mark: Mark, degrees: f32) {
        (self.design, self.fixture) = (Some(Design { mark, degrees }), None);
    }

    /// Zooms the fixture to an angle within its published range.
    fn set_zoom(&mut self, degrees: f32) -> Result<(), Refusal> {
        let Some(fixture) = self.fixture else {
            return Err(Refusal::name("zoom", &degrees.to_string(), "a fixture to be chosen first"));
        };
        let (narrow, wide) = (fixture.narrowest, fixture.widest);
        if !(narrow..=wide).contains(&degrees) {
            return Err(Refusal::Zoom { value: degrees, narrow, wide });
        }
        self.design = Some(Design { mark: self.reading(), degrees });
        Ok(())
    }

    /// Sets the fixture by name, zoomed to the middle of its range. The empty name removes the
    /// fixture and keeps the angle.
    fn set_fixture(&mut self, name: &str) -> Result<(), Refusal> {
        if name.is_empty() {
            self.fixture = None;
            return Ok(());
        }
        let expected = "one of the list, or set the angles by hand";
        let fixture = fixture::find(name).ok_or_else(|| Refusal::name("fixture", name, expected))?;
        self.design = Some(Design { mark: self.reading(), degrees: fixture::middle(fixture) });
        self.fixture = Some(fixture);
        Ok(())
    }

    /// Sets whether the angle is interpreted as beam or as field angle.
    fn set_reading(&mut self, mark: Mark) {
        self.design = self.design.map(|design| Design { mark, ..design });
    }

    /// Whether the angle of the design is the beam angle or the field angle.
    fn reading(&self) -> Mark {
        self.design.map_or(Mark::Field, |design| design.mark)
    }

    /// Applies the settings to the light of the scene, whose intensity is multiplied by `gain`.
    pub(crate) fn applied(&self, original: &MovingLight, gain: f32) -> Result<MovingLight, Refusal> {
        let light: AnyLight = match *original.light() {
            AnyLight::Spot(spot) => self.spot(&spot)?.into(),
            AnyLight::Point(point) => match self.position {
                Some(position) => PointLight::new(position)?
                    .with_color(point.color())?
                    .with_specular_color(point.specular_color())?
                    .with_intensity(point.intensity())?
                    .with_attenuation(point.attenuation())
                    .into(),
                None => point.into(),
            },
            AnyLight::Directional(sun) => sun.into(),
        };
        let intensity = if self.is_on { self.intensity.unwrap_or(light.intensity()) } else { 0.0 };
        let fixture = original.with_light(self.emitting(light, gain * intensity)?);
        Ok(if self.target.is_some() { fixture.still() } else { fixture })
    }

    fn spot(
        &self,
        spot: &SpotLight<AnyFalloff, AnyAttenuation>,
    ) -> Result<SpotLight<AnyFalloff, AnyAttenuation>, Error> {
        let cone = self.cone(spot.cone())?;
        let position = self.position.unwrap_or(spot.position());
        let axis = self.target.map_or(spot.axis(), |target| target.zip(position, |to, from| to - from));
        if (self.position, self.target) == (None, None) {
            return Ok(spot.with_cone(cone));
        }
        SpotLight::new(position, axis, cone)?
            .with_attenuation(spot.attenuation())
            .with_color(spot.color())?
            .with_specular_color(spot.specular_color())?
            .with_intensity(spot.intensity())
    }

    fn cone(&self, original: Cone<AnyFalloff>) -> Result<Cone<AnyFalloff>, Error> {
        let profile = self.edge.map_or(original.profile(), AnyFalloff::from);
        match (self.design, self.edge) {
            (Some(Design { mark: Mark::Beam, degrees }), _) => {
                Cone::from_beam(profile, Angle::degrees(degrees))
            }
            (Some(Design { mark: Mark::Field, degrees }), _) => {
                Cone::from_field(profile, Angle::degrees(degrees))
            }
            (None, Some(_)) => Cone::from_field(profile, original.field()),
            (None, None) => Ok(original),
        }
    }

    fn emitting(&self, light: AnyLight, intensity: f32) -> Result<AnyLight, Error> {
        let color = self.color.map(|[red, green, blue]| Rgb::new(red, green, blue).map(decode_srgb));
        Ok(match light {
            AnyLight::Directional(sun) => {
                color.map_or(Ok(sun), |color| sun.with_color(color))?.with_intensity(intensity)?.into()
            }
            AnyLight::Point(point) => {
                color.map_or(Ok(point), |color| point.with_color(color))?.with_intensity(intensity)?.into()
            }
            AnyLight::Spot(spot) => {
                color.map_or(Ok(spot), |color| spot.with_color(color))?.with_intensity(intensity)?.into()
            }
        })
    }

    /// Returns the state for the page.
    pub(crate) fn state(&self, original: &MovingLight, format: Format) -> Result<LightState, Refusal> {
        let lit = Self { is_on: true, ..*self }.applied(original, 1.0)?;
        let own_edge = match original.light() {
            AnyLight::Spot(spot) => spot.cone().profile().effect().name(),
            _ => "",
        };
        Ok(LightState {
            name: original.name.to_owned(),
            on: self.is_on,
            fixture: self.fixture.map(|fixture| fixture.name.to_owned()).unwrap_or_default(),
            reading: self.reading().name().to_owned(),
            zoom: self.fixture.and(self.design).map(|design| design.degrees),
            edge: edge_name(self.edge).to_owned(),
            own_edge: own_edge.to_owned(),
            own_intensity: original.light().intensity(),
            ..LightState::of(lit.light(), format)
        })
    }
}

/// The channels of `#rrggbb`.
fn channels_of(hex: &str) -> Result<[u8; 3], Refusal> {
    let channels = || channels(hex.strip_prefix('#')?);
    channels().ok_or_else(|| Refusal::name("color", hex, "#rrggbb, each channel from 00 to ff"))
}

/// The channels of `rrggbb`.
pub(crate) fn channels(digits: &str) -> Option<[u8; 3]> {
    let channel = |i: usize| u8::from_str_radix(digits.get(i..i + 2)?, 16).ok();
    let is_plain = digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    if is_plain { Some([channel(0)?, channel(2)?, channel(4)?]) } else { None }
}
