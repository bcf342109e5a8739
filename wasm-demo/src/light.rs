//! One light with the visitor's settings. A setting is either taken or refused as a whole, so the
//! light can always be drawn.

use crate::{
    fixture::{self, Fixture},
    format::Format,
    refusal::Refusal,
};
use luminaire::{
    Angle, Cone, Rgb, SpotLight, Vec3,
    display::{decode_srgb, encode_srgb},
    falloff::SoftOrHard,
};
use wasm_bindgen::prelude::*;

/// The angle that a cone is designed from. The kernel computes the others.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Mark {
    /// Full angle at which the intensity is half of that on the axis.
    Beam,
    /// Full angle at which the intensity is a tenth of that on the axis.
    Field,
}

/// The angle that was set last. If the edge is changed, the new cone has the same angle.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Design {
    mark: Mark,
    degrees: f32,
}

/// A light that its number format can hold.
#[derive(Clone, Debug)]
pub(crate) struct Light {
    name: &'static str,
    spot: SpotLight,
    design: Design,
    /// Whether a fixture's published angle is interpreted as beam or field angle.
    reading: Mark,
    fixture: Option<&'static Fixture>,
    on: bool,
}

/// State of a light for the page, with the values that the kernel computed and not those that the
/// visitor typed.
#[wasm_bindgen(getter_with_clone)]
#[derive(Clone, PartialEq, Debug)]
pub struct LightState {
    /// `key`, `fill` or `back`.
    pub name: String,
    /// The full beam angle in degrees.
    pub beam: f32,
    /// Narrowest beam angle with this edge and this number format.
    #[wasm_bindgen(js_name = narrowestBeam)]
    pub narrowest_beam: f32,
    /// Widest beam angle with this edge.
    #[wasm_bindgen(js_name = widestBeam)]
    pub widest_beam: f32,
    /// The full field angle in degrees.
    pub field: f32,
    /// Narrowest field angle with this edge and this number format.
    #[wasm_bindgen(js_name = narrowestField)]
    pub narrowest_field: f32,
    /// Widest field angle with this edge.
    #[wasm_bindgen(js_name = widestField)]
    pub widest_field: f32,
    /// The full outer angle in degrees.
    pub outer: f32,
    /// `soft` or `hard`.
    pub edge: String,
    /// The colour as `#rrggbb`, sRGB.
    pub color: String,
    /// The intensity on the axis.
    pub intensity: f32,
    /// Whether the light is switched on.
    pub on: bool,
    /// The name of the fixture whose angle the light has; empty if the angle was set by hand.
    pub fixture: String,
    /// How a published angle is interpreted: as `beam` or `field` angle.
    pub reading: String,
    /// The fixture's published angle; nothing without a fixture.
    pub zoom: Option<f32>,
}

impl Mark {
    /// The kind of angle with this name.
    pub(crate) fn named(name: &str) -> Result<Self, Refusal> {
        match name {
            "beam" => Ok(Self::Beam),
            "field" => Ok(Self::Field),
            _ => Err(Refusal::Name {
                parameter: "reading of the published angle",
                value: name.to_owned(),
                expected: "beam or field",
            }),
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Beam => "beam",
            Self::Field => "field",
        }
    }
}

/// The edge with this name.
pub(crate) fn edge_named(name: &str) -> Result<SoftOrHard, Refusal> {
    match name {
        "soft" => Ok(SoftOrHard::Soft),
        "hard" => Ok(SoftOrHard::Hard),
        _ => Err(Refusal::Name { parameter: "edge", value: name.to_owned(), expected: "soft or hard" }),
    }
}

/// The linear colour of `#rrggbb`.
pub(crate) fn color_of(hex: &str) -> Result<Rgb<f32>, Refusal> {
    let channels = || {
        let digits = hex.strip_prefix('#').filter(|digits| digits.len() == 6)?;
        let channel = |i: usize| u8::from_str_radix(digits.get(i..i + 2)?, 16).ok();
        Some(Rgb::new(channel(0)?, channel(2)?, channel(4)?).map(decode_srgb))
    };
    channels().ok_or_else(|| Refusal::Name {
        parameter: "color",
        value: hex.to_owned(),
        expected: "#rrggbb, each channel from 00 to ff",
    })
}

impl Light {
    /// A light that is switched on.
    pub(crate) fn new(name: &'static str, spot: SpotLight) -> Self {
        let design = Design { mark: Mark::Field, degrees: spot.cone().field().to_degrees() };
        Self { name, spot, design, reading: Mark::Field, fixture: None, on: true }
    }

    /// The name of the light on the page.
    pub(crate) fn name(&self) -> &'static str {
        self.name
    }

    /// The light of the kernel, whether the light is switched on or not.
    pub(crate) fn spot(&self) -> &SpotLight {
        &self.spot
    }

    /// Whether it is switched on.
    pub(crate) fn is_on(&self) -> bool {
        self.on
    }

    /// Switches the light on or off. A light that is off is still valid, so that switching never
    /// fails.
    pub(crate) fn switch(&mut self, on: bool) {
        self.on = on;
    }

    /// Sets one angle of the cone, which determines the other two. This removes the fixture.
    pub(crate) fn set_angle(&mut self, mark: Mark, degrees: f32, format: Format) -> Result<(), Refusal> {
        self.design_cone(Design { mark, degrees }, self.spot.cone().profile(), format)?;
        self.fixture = None;
        Ok(())
    }

    /// Sets the edge of the cone and keeps the angle that it was designed from.
    pub(crate) fn set_edge(&mut self, edge: SoftOrHard, format: Format) -> Result<(), Refusal> {
        self.design_cone(self.design, edge, format)
    }

    /// Sets the linear colour.
    pub(crate) fn set_color(&mut self, color: Rgb<f32>, format: Format) -> Result<(), Refusal> {
        self.put(self.spot.with_color(color)?, format)
    }

    /// Sets the intensity.
    pub(crate) fn set_intensity(&mut self, intensity: f32, format: Format) -> Result<(), Refusal> {
        self.put(self.spot.with_intensity(intensity)?, format)
    }

    /// Sets the axis.
    pub(crate) fn aim(&mut self, axis: Vec3<f32>, format: Format) -> Result<(), Refusal> {
        let spot = &self.spot;
        let aimed = SpotLight::new(spot.position(), axis, spot.cone())?;
        self.put(aimed.with_color(spot.color())?.with_intensity(spot.intensity())?, format)
    }

    /// Sets the fixture by name, zoomed to the middle of its range. The empty name removes the
    /// fixture and keeps the angle.
    pub(crate) fn set_fixture(&mut self, name: &str, format: Format) -> Result<(), Refusal> {
        if name.is_empty() {
            self.fixture = None;
            return Ok(());
        }
        let fixture = fixture::find(name).ok_or_else(|| Refusal::Name {
            parameter: "fixture",
            value: name.to_owned(),
            expected: "one of the list, or set the angles by hand",
        })?;
        self.design_cone(
            Design { mark: self.reading, degrees: fixture.middle() },
            self.spot.cone().profile(),
            format,
        )?;
        self.fixture = Some(fixture);
        Ok(())
    }

    /// Sets whether the published angle is interpreted as beam or as field angle.
    pub(crate) fn set_reading(&mut self, reading: Mark, format: Format) -> Result<(), Refusal> {
        if self.fixture.is_some() {
            let design = Design { mark: reading, ..self.design };
            self.design_cone(design, self.spot.cone().profile(), format)?;
        }
        self.reading = reading;
        Ok(())
    }

    /// Zooms the fixture to an angle within its published range.
    pub(crate) fn set_zoom(&mut self, degrees: f32, format: Format) -> Result<(), Refusal> {
        let Some(fixture) = self.fixture else {
            return Err(Refusal::Name {
                parameter: "zoom",
                value: degrees.to_string(),
                expected: "a fixture to be chosen first",
            });
        };
        let (narrow, wide) = (fixture.narrow(), fixture.wide());
        if !(narrow..=wide).contains(&degrees) {
            return Err(Refusal::Zoom { value: degrees, narrow, wide });
        }
        self.design_cone(Design { mark: self.reading, degrees }, self.spot.cone().profile(), format)
    }

    /// Returns the state for the page.
    pub(crate) fn state(&self, format: Format) -> LightState {
        let cone = self.spot.cone();
        let edge = cone.profile();
        // The ends of the sliders are the kernel's narrowest and widest outer angle, converted to
        // the other angles.
        let least = Cone::from_outer(edge, format.narrowest(edge)).unwrap_or(cone);
        let most = Cone::from_outer(edge, Angle::degrees(180.0)).unwrap_or(cone);
        LightState {
            name: self.name.to_owned(),
            beam: cone.beam().to_degrees(),
            narrowest_beam: least.beam().to_degrees(),
            widest_beam: most.beam().to_degrees(),
            field: cone.field().to_degrees(),
            narrowest_field: least.field().to_degrees(),
            widest_field: most.field().to_degrees(),
            outer: cone.outer().to_degrees(),
            edge: match edge {
                SoftOrHard::Soft => "soft",
                SoftOrHard::Hard => "hard",
            }
            .to_owned(),
            color: hex_of(self.spot.color()),
            intensity: self.spot.intensity(),
            on: self.on,
            fixture: self.fixture.map(Fixture::name).unwrap_or_default(),
            reading: self.reading.name().to_owned(),
            zoom: self.fixture.map(|_| self.design.degrees),
        }
    }

    fn design_cone(&mut self, design: Design, edge: SoftOrHard, format: Format) -> Result<(), Refusal> {
        let angle = Angle::degrees(design.degrees);
        let cone = match design.mark {
            Mark::Beam => Cone::from_beam(edge, angle),
            Mark::Field => Cone::from_field(edge, angle),
        }?;
        self.put(self.spot.with_cone(cone), format)?;
        self.design = design;
        Ok(())
    }

    /// Every change of the light is made here.
    fn put(&mut self, spot: SpotLight, format: Format) -> Result<(), Refusal> {
        format.check(&spot)?;
        self.spot = spot;
        Ok(())
    }
}

/// A colour as `#rrggbb` in sRGB.
pub(crate) fn hex_of(color: Rgb<f32>) -> String {
    let Rgb { red, green, blue } = color.map(encode_srgb);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORMAT: Format = Format::F32;

    fn light() -> Light {
        let cone = Cone::from_field(SoftOrHard::Soft, Angle::degrees(15.0)).unwrap();
        Light::new("key", SpotLight::new(Vec3::new(0.0, 4.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone).unwrap())
    }

    #[test]
    fn the_angles_follow_one_another() {
        let mut light = light();
        let state = light.state(FORMAT);
        assert!((state.beam - 9.81).abs() < 0.005 && (state.outer - 18.15).abs() < 0.005);
        light.set_angle(Mark::Beam, state.beam, FORMAT).unwrap();
        assert!((light.state(FORMAT).field - 15.0).abs() < 1e-3);
    }

    #[test]
    fn an_edge_keeps_the_angle_that_was_given() {
        let mut light = light();
        light.set_edge(SoftOrHard::Hard, FORMAT).unwrap();
        let state = light.state(FORMAT);
        assert!((state.field - 15.0).abs() < 1e-3 && (state.beam - 12.95).abs() < 0.005);
        light.set_angle(Mark::Beam, 9.0, FORMAT).unwrap();
        light.set_edge(SoftOrHard::Soft, FORMAT).unwrap();
        assert!((light.state(FORMAT).beam - 9.0).abs() < 1e-3);
    }

    #[test]
    fn a_refused_value_leaves_the_light_as_it_was() {
        let mut light = light();
        let before = light.state(FORMAT);
        let refused = |outcome: Result<(), Refusal>, words: &str| {
            let message = outcome.unwrap_err().to_string();
            assert!(message.contains(words), "{message}");
        };
        for degrees in [0.0, -10.0, 400.0, 150.0, f32::NAN, f32::INFINITY] {
            refused(light.set_angle(Mark::Field, degrees, FORMAT), "field angle");
            refused(light.set_angle(Mark::Beam, degrees, FORMAT), "beam angle");
        }
        let needle = Format::Fx16.narrowest(SoftOrHard::Soft).to_degrees() / 2.0;
        refused(light.set_angle(Mark::Field, needle, Format::Fx16), "outer angle");
        refused(light.set_intensity(-1.0, FORMAT), "intensity");
        refused(light.set_intensity(f32::NAN, FORMAT), "intensity");
        refused(light.set_fixture("Nobody's lamp", FORMAT), "fixture = \"Nobody's lamp\"");
        refused(light.set_zoom(20.0, FORMAT), "fixture");
        refused(light.aim(Vec3::new(0.0, 0.0, 0.0), FORMAT), "axis");
        refused(edge_named("").map(drop), "edge");
        refused(Mark::named("outer").map(drop), "beam or field");
        for color in ["", "#fff", "ffffff", "#gggggg", "#ffffff0", "#ééé"] {
            refused(color_of(color).map(drop), "color");
        }
        assert_eq!(light.state(FORMAT), before);
    }

    #[test]
    fn every_fixture_is_a_light() {
        let mut light = light();
        for fixture in fixture::all() {
            light.set_fixture(&fixture.name(), FORMAT).unwrap();
            let state = light.state(FORMAT);
            assert_eq!(state.fixture, fixture.name());
            assert!((state.field - fixture.middle()).abs() < 1e-3 * fixture.middle(), "{}", fixture.name());
            assert_eq!(state.zoom, Some(fixture.middle()));
        }
    }

    #[test]
    fn a_fixture_is_read_as_told_and_zooms_within_its_range() {
        let mut light = light();
        let zoom = fixture::find("ARRI L7-C").unwrap();
        light.set_fixture(&zoom.name(), FORMAT).unwrap();
        light.set_reading(Mark::Beam, FORMAT).unwrap();
        assert!((light.state(FORMAT).beam - zoom.middle()).abs() < 1e-3);
        light.set_zoom(zoom.wide(), FORMAT).unwrap();
        assert!((light.state(FORMAT).beam - zoom.wide()).abs() < 1e-3);
        let message = light.set_zoom(zoom.wide() + 1.0, FORMAT).unwrap_err().to_string();
        assert!(message.contains("expected 15 to 50"), "{message}");
        light.set_angle(Mark::Field, 20.0, FORMAT).unwrap();
        assert_eq!(light.state(FORMAT).fixture, "");
    }

    #[test]
    fn the_ends_of_the_sliders_are_taken() {
        for edge in [SoftOrHard::Soft, SoftOrHard::Hard] {
            for format in Format::ALL {
                let mut light = light();
                light.set_edge(edge, FORMAT).unwrap();
                let ends = light.state(format);
                // The test stays as far within the ends as the page does, whose slider positions
                // are decimal fractions.
                for (mark, narrow, wide) in [
                    (Mark::Beam, ends.narrowest_beam, ends.widest_beam),
                    (Mark::Field, ends.narrowest_field, ends.widest_field),
                ] {
                    light.set_angle(mark, narrow * 1.001, format).unwrap();
                    light.set_angle(mark, wide - 0.01, format).unwrap();
                }
            }
        }
    }

    #[test]
    fn a_color_comes_back() {
        let mut light = light();
        for color in ["#000000", "#ffffff", "#ffd9b3", "#010a7f"] {
            light.set_color(color_of(color).unwrap(), FORMAT).unwrap();
            assert_eq!(light.state(FORMAT).color, color);
        }
    }
}
