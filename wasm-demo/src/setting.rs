//! The visitor's settings of one light, over the light as the scene has it.

use crate::{
    design::{Both, Design, Mark},
    fixture,
    kind::{AnySpot, BRIGHTEST, KINDS, as_bright, kept},
    model::Chosen,
    name::Name,
    refusal::{Refusal, choose},
};
use luminaire::{
    Cone, DirectionalLight, Error, PointLight, Rgb, SpotLight, Vec3,
    attenuation::AnyAttenuation,
    display::decode_srgb,
    dynamic::{AnyLight, Effect},
    falloff::{AnyFalloff, Soft},
};
use luminaire_fixtures::Fixture;
use luminaire_render::scenes::MovingLight;

/// A change of a setting, given the cone before it.
type Reshape<'a> = dyn Fn(&mut Setting, &Cone<AnyFalloff>) -> Result<(), Refusal> + 'a;

/// What the visitor has changed of a light. `None` is as the scene has it.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub(crate) struct Setting {
    /// The number of the light in the scene. Copies of a light share it.
    pub(crate) of: usize,
    pub(crate) is_on: bool,
    /// One of [`KINDS`].
    pub(crate) kind: Option<Effect>,
    /// The law of distance.
    pub(crate) law: Option<AnyAttenuation>,
    /// The name of a light of a file.
    pub(crate) name: Option<Name>,
    /// The cone of a light of a file, in place of that of the scene.
    pub(crate) own: Option<Cone<AnyFalloff>>,
    pub(crate) design: Design,
    pub(crate) edge: Option<AnyFalloff>,
    /// The fixture whose published angle is the angle of the design.
    pub(crate) fixture: Option<&'static Fixture>,
    /// The colour in sRGB.
    pub(crate) color: Option<[u8; 3]>,
    /// The colour temperature in kelvin of a white light, in place of a colour.
    pub(crate) kelvin: Option<f32>,
    /// The intensity on the axis, as a multiple of full scale at 1 metre; of a white light that of its luminance.
    pub(crate) intensity: Option<f32>,
    pub(crate) position: Option<Vec3<f32>>,
    /// The point at which the light aims. It ends the sweep of a light that the scene moves.
    pub(crate) target: Option<Vec3<f32>>,
}

impl Setting {
    /// A light as the scene has it.
    pub(crate) fn of(light: usize) -> Self {
        Self { of: light, is_on: true, ..Self::default() }
    }

    /// The name of the light: that of its file, or of the scene.
    pub(crate) fn name_of(&self, original: &MovingLight) -> String {
        self.name.map_or_else(|| original.name.to_owned(), |name| name.to_string())
    }

    /// Sets a value by its name, for the `original` light of a scene that shows `full_scale` lux as
    /// full scale: the `beam`, `field` or `zoom` angle in degrees, where a light that has both angles
    /// keeps the other one; `fit-beam` or `fit-field`, which keep the other one of every light; `pair-beam` or
    /// `pair-field`, which keep it by whatever edge has both, else by the nearest pair; a number
    /// of the chosen law of distance or edge, by its place behind `law-` or `edge-`; the colour temperature `kelvin`;
    /// or the `intensity` in candela, or in lux for a directional light. Angles and edges conserve the flux.
    pub(crate) fn set_number(
        &mut self,
        name: &str,
        value: f32,
        original: &MovingLight,
        full_scale: f32,
    ) -> Result<(), Refusal> {
        match name {
            "beam" => self.reshape(original, &|setting, _| setting.set_angle(Mark::Beam, value)),
            "field" => self.reshape(original, &|setting, _| setting.set_angle(Mark::Field, value)),
            "fit-beam" => self.reshape(original, &|setting, cone| setting.fit(Mark::Beam, value, cone)),
            "fit-field" => self.reshape(original, &|setting, cone| setting.fit(Mark::Field, value, cone)),
            "pair-beam" => self.reshape(original, &|setting, cone| setting.pair(Mark::Beam, value, cone)),
            "pair-field" => self.reshape(original, &|setting, cone| setting.pair(Mark::Field, value, cone)),
            "zoom" => self.reshape(original, &|setting, _| setting.set_zoom(value)),
            "intensity" => self.set_intensity(value, full_scale),
            "kelvin" => {
                (self.kelvin, self.color) = (Some(value), None);
                Ok(())
            }
            _ => self.set_number_of_model(name, value, original),
        }
    }

    /// Sets a choice by its name: the `kind`, `law` of distance, `edge`, `color`, `fixture`, or
    /// `reading` of its angle. A fixture brings its published flux; another cone conserves the flux.
    pub(crate) fn set_choice(
        &mut self,
        name: &str,
        value: &str,
        original: &MovingLight,
        full_scale: f32,
    ) -> Result<(), Refusal> {
        match name {
            "kind" if value == "own" => self.kind = None,
            "kind" => self.kind = Some(choose("kind of light", value, &KINDS, Effect::name)?),
            "law" => self.law = AnyAttenuation::chosen("law", value, &["own"])?,
            "edge" => self.reshape(original, &|setting, cone| setting.set_edge(value, cone))?,
            "color" => (self.color, self.kelvin) = (Some(channels_of(value)?), None),
            "fixture" => {
                self.reshape(original, &|setting, _| setting.set_fixture(value))?;
                self.take_flux(original, full_scale)?;
            }
            "reading" => {
                let mark = Mark::named(value)?;
                self.reshape(original, &|setting, _| setting.set_reading(mark))?;
            }
            _ => return Err(Refusal::name("choice", name, "kind, law, edge, color, fixture or reading")),
        }
        Ok(())
    }

    /// Multiplies the angles by a factor, within the published range of a fixture. This conserves the
    /// flux.
    pub(crate) fn zoom(&mut self, factor: f32, original: &MovingLight) -> Result<(), Refusal> {
        self.reshape(original, &|setting, cone| {
            if let (Some(fixture), Some((_, degrees))) = (setting.fixture, setting.design.one()) {
                let [narrow, wide] = fixture::zooms(fixture);
                return setting.set_zoom((factor * degrees).max(narrow).min(wide));
            }
            let design = match setting.design {
                Design { beam: None, field: None } => Design::of(Mark::Field, cone.field().to_degrees()),
                design => design,
            };
            setting.design = design.times(factor);
            Ok(())
        })
    }

    /// Changes the cone, which the change gets, and conserves the flux. An intensity beyond the largest
    /// is refused when the setting is applied: cut, it would be a flux that no change brings back.
    fn reshape(&mut self, original: &MovingLight, change: &Reshape) -> Result<(), Refusal> {
        let AnyLight::Spot(spot) = original.light() else {
            return Err(Refusal::name("light", original.name, "a spotlight, which has angles and an edge"));
        };
        let before = self.cone(spot.cone())?;
        let flux = before.lumens(self.intensity.unwrap_or(spot.intensity()));
        change(self, &before)?;
        let after = self.cone(spot.cone())?;
        if after != before {
            self.intensity = Some(after.candela(flux));
        }
        Ok(())
    }

    /// Sets one angle of the cone, and removes the fixture. The angle determines the other one, or
    /// leaves it as it is if both are given.
    fn set_angle(&mut self, mark: Mark, degrees: f32) -> Result<(), Refusal> {
        self.fixture = None;
        self.design = if self.design.both().is_some() {
            self.design.with(mark, degrees, Both::of(self.edge))
        } else {
            Design::of(mark, degrees)
        };
        Ok(())
    }

    /// Sets one angle of the cone and keeps the other one, by the edge that both determine.
    fn fit(&mut self, mark: Mark, degrees: f32, cone: &Cone<AnyFalloff>) -> Result<(), Refusal> {
        if self.design.both().is_none() {
            self.set_edge(Both::Fitted.name(), cone)?;
        }
        self.set_angle(mark, degrees)
    }

    /// Sets one angle of the cone beside the other one, by the first edge that has both: that of the design, the
    /// fitted one, or a soft one. If none has, the pair is the nearest one of the first.
    fn pair(&mut self, mark: Mark, degrees: f32, cone: &Cone<AnyFalloff>) -> Result<(), Refusal> {
        let asked = Design { beam: Some(cone.beam().to_degrees()), field: Some(cone.field().to_degrees()) };
        let asked = match mark {
            Mark::Beam => Design { beam: Some(degrees), ..asked },
            Mark::Field => Design { field: Some(degrees), ..asked },
        };
        let first = Both::of(self.edge);
        let nearest = |edge| asked.with(mark, degrees, edge);
        let found = [first, Both::Fitted, Both::Soft].into_iter().find(|&edge| nearest(edge) == asked);
        let edge = found.unwrap_or(first);
        (self.design, self.fixture) = (nearest(edge), None);
        self.edge = (edge == Both::Soft).then(|| Soft.into());
        Ok(())
    }

    /// Sets the edge by name.
    fn set_edge(&mut self, name: &str, cone: &Cone<AnyFalloff>) -> Result<(), Refusal> {
        if let Some(both) = Both::ALL.into_iter().find(|both| both.name() == name) {
            (self.edge, self.fixture) = ((both == Both::Soft).then(|| Soft.into()), None);
            self.design = self.design.or_both_of(cone, both);
            return Ok(());
        }
        self.edge = AnyFalloff::chosen("edge", name, &["own", Both::Fitted.name(), Both::Soft.name()])?;
        if self.design.both().is_some() {
            self.design.beam = None;
        }
        Ok(())
    }

    /// Zooms the fixture to an angle within its published range.
    fn set_zoom(&mut self, degrees: f32) -> Result<(), Refusal> {
        let Some(fixture) = self.fixture else {
            return Err(Refusal::name("zoom", &degrees.to_string(), "a fixture to be chosen first"));
        };
        let (narrow, wide) = (fixture.narrowest, fixture.widest);
        if !(narrow..=wide).contains(&degrees) {
            return Err(Refusal::outside("zoom", degrees, [narrow, wide], "degrees, as this fixture has"));
        }
        self.design = Design::of(self.reading(), degrees);
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
        self.design = Design::of(self.reading(), fixture::middle(fixture));
        self.fixture = Some(fixture);
        Ok(())
    }

    /// Sets the intensity to that of the fixture's published flux, if there is one.
    fn take_flux(&mut self, original: &MovingLight, full_scale: f32) -> Result<(), Refusal> {
        let lumens = self.fixture.and_then(|fixture| fixture.lumens);
        if let (Some(lumens), AnyLight::Spot(spot)) = (lumens, original.light()) {
            let candela = self.cone(spot.cone())?.candela(lumens);
            self.intensity = Some(candela / full_scale);
        }
        Ok(())
    }

    /// Sets the intensity in candela, or in lux for a directional light.
    fn set_intensity(&mut self, value: f32, full_scale: f32) -> Result<(), Refusal> {
        let most = BRIGHTEST * full_scale;
        if !(0.0..=most).contains(&value) {
            return Err(Refusal::outside("intensity", value, [0.0, most], "candela"));
        }
        self.intensity = Some(value / full_scale);
        Ok(())
    }

    /// Sets a number of the chosen law of distance or of the chosen edge.
    fn set_number_of_model(&mut self, name: &str, value: f32, original: &MovingLight) -> Result<(), Refusal> {
        let place = |name: &str, model| name.strip_prefix(model)?.strip_prefix('-')?.parse().ok();
        let missing =
            |model| Refusal::name(name, &value.to_string(), format!("the {model} to be chosen first"));
        if let Some(place) = place(name, "law") {
            let law = self.law.ok_or_else(|| missing("law of distance"))?;
            self.law = Some(law.with_value(place, value)?);
            return Ok(());
        }
        if let Some(place) = place(name, "edge") {
            return self.reshape(original, &|setting, _| {
                let edge = setting.chosen_edge().ok_or_else(|| missing("edge"))?;
                setting.edge = Some(edge.with_value(place, value)?);
                Ok(())
            });
        }
        let expected = "beam, field, fit- or pair- with one of them, zoom, intensity, kelvin, or law- or edge- with a place";
        Err(Refusal::name("number of a light", name, expected))
    }

    /// Sets whether the angle is interpreted as beam or as field angle.
    fn set_reading(&mut self, mark: Mark) -> Result<(), Refusal> {
        if let Some((_, degrees)) = self.design.one() {
            self.design = Design::of(mark, degrees);
        }
        Ok(())
    }

    /// Whether the angle of the design is the beam angle or the field angle.
    pub(crate) fn reading(&self) -> Mark {
        self.design.one().map_or(Mark::Field, |(mark, _)| mark)
    }

    /// Returns a light of a scene in the kind and with the law of this setting. `hung` is the light as a
    /// spotlight, with the distance in metres at which its axis meets a surface. There the irradiance stays
    /// what it was, so that the picture keeps its exposure: see [`kept`].
    pub(crate) fn turned(&self, own: &AnyLight, (hung, throw): (AnySpot, f32)) -> Result<AnyLight, Error> {
        let attenuation = self.law.unwrap_or(hung.attenuation());
        let light = match (self.kind, own) {
            (None | Some(Effect::Directional), AnyLight::Directional(_)) => return Ok(*own),
            (Some(Effect::Directional), _) => {
                let position = self.position.unwrap_or(hung.position());
                let way =
                    self.target.map_or(hung.axis(), |target| target.zip(position, |to, from| to - from));
                DirectionalLight::new(way)?.into()
            }
            (Some(Effect::Point), _) | (None, AnyLight::Point(_)) => {
                PointLight::new(hung.position())?.with_attenuation(attenuation).into()
            }
            _ => hung.with_attenuation(attenuation).into(),
        };
        as_bright(light, own)?.with_intensity(kept(own, &light, throw))
    }

    /// Applies the settings to the light of the scene, whose intensity is multiplied by `gain`.
    pub(crate) fn applied(&self, original: &MovingLight, gain: f32) -> Result<MovingLight, Refusal> {
        let light: AnyLight = match *original.light() {
            AnyLight::Spot(spot) => self.spot(&spot)?,
            AnyLight::Point(point) => {
                let moved = PointLight::new(self.position.unwrap_or(point.position()))?;
                as_bright(moved.with_attenuation(point.attenuation()).into(), original.light())?
            }
            // No scene has a measured light.
            AnyLight::Measured(light) => light.into(),
            AnyLight::Directional(sun) => sun.into(),
        };
        let light = self.emitting(light, self.intensity.unwrap_or(light.intensity()))?;
        // Beyond the largest intensity the exposure changes no displayed code.
        let intensity = if self.is_on { (gain * light.intensity()).min(BRIGHTEST) } else { 0.0 };
        let fixture = original.with_light(light.with_intensity(intensity)?);
        Ok(if self.target.is_some() { fixture.aimed() } else { fixture })
    }

    fn spot(&self, spot: &AnySpot) -> Result<AnyLight, Error> {
        let cone = self.cone(spot.cone())?;
        let position = self.position.unwrap_or(spot.position());
        let axis = self.target.map_or(spot.axis(), |target| target.zip(position, |to, from| to - from));
        if (self.position, self.target) == (None, None) {
            return Ok(spot.with_cone(cone).into());
        }
        let aimed = SpotLight::new(position, axis, cone)?.with_attenuation(spot.attenuation());
        as_bright(aimed.into(), &(*spot).into())
    }

    /// Returns the cone of the light whose own cone is `original`.
    pub(crate) fn cone(&self, original: Cone<AnyFalloff>) -> Result<Cone<AnyFalloff>, Error> {
        let cone = self.design.cone(self.edge, self.own.unwrap_or(original))?;
        let (Some(own), Some((mark, _)), None) = (self.own, self.design.one(), self.edge) else {
            return Ok(cone);
        };
        // Its hotspot and its cutoff grow with its angles.
        let versine = |cone: &Cone<_>| if mark == Mark::Beam { cone.beam() } else { cone.field() }.versine();
        let factor = versine(&cone) / versine(&own);
        Cone::from_versines(own.falloff(), own.versines().map(|versine| factor * versine))
    }

    fn emitting(&self, light: AnyLight, intensity: f32) -> Result<AnyLight, Error> {
        let color = self.color.map(|[red, green, blue]| Rgb::new(red, green, blue).map(decode_srgb));
        let white = self.kelvin.map(Rgb::from_kelvin).transpose()?;
        let strongest = white.map_or(1.0, Rgb::strongest);
        let color = color.or(white.map(|white| white.map(|channel| channel / strongest)));
        let light = color.map_or(Ok(light), |color| light.with_color(color))?.with_intensity(intensity)?;
        // Beyond the largest intensity no displayed code changes.
        light.with_intensity((strongest * intensity).min(BRIGHTEST))
    }

    /// The edge that the visitor has chosen; `None` for the light's own, or one that both angles determine.
    pub(crate) fn chosen_edge(&self) -> Option<AnyFalloff> {
        self.edge.filter(|_| self.design.both().is_none())
    }

    /// The name of the edge: `own`, that of [`Both`], or that of a falloff.
    pub(crate) fn edge_name(&self) -> &'static str {
        if self.design.both().is_some() {
            return Both::of(self.edge).name();
        }
        self.edge.map_or("own", |edge| edge.name())
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
