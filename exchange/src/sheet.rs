//! A light from the numbers of its data sheet.

use std::cmp::Reverse;
use std::f32::consts::PI;

use luminaire::falloff::{AnyFalloff, Hard, Soft};
use luminaire::{Angle, Cone, PointLight, SpotLight, dynamic::AnyLight};
use luminaire_export::json;
use luminaire_fixtures::{FIXTURES, Kind};

use crate::difference::Difference;
use crate::lamp::Lamp;
use crate::limits::within;
use crate::refusal::Refusal;
use crate::versine::of_versine;

/// The edge of a light of which one angle is known.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Edge {
    /// The soft quadratic: a wash, a Fresnel, a PAR.
    #[default]
    Soft,
    /// The hard quadratic: a profile or a spot, which project gobos.
    Hard,
}

/// The numbers of a data sheet.
///
/// Equal beam and field angles are one published angle of unknown kind: the beam angle, unless it is
/// too wide for one. The Open Fixture Library documents its angles as beam angles, GDTF describes
/// `Zoom` as what adjusts the beam angle, and the lower peak is the safer error, because many published
/// lumens are those of the lamp without its optics. A note has the peak of the field angle.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Sheet {
    /// The name of the light.
    pub name: String,
    /// The full beam angle (50 %) in degrees.
    pub beam: Option<f64>,
    /// The full field angle (10 %) in degrees.
    pub field: Option<f64>,
    /// The luminous flux in lumens.
    pub lumens: Option<f64>,
    /// The intensity on the axis in candela.
    pub candela: Option<f64>,
    /// The correlated colour temperature in kelvin. Outside [1000, 25,000], the light is white, with a note.
    pub kelvin: Option<f64>,
    /// The distance of `lux` in metres.
    pub throw: Option<f64>,
    /// The illuminance on the axis in lux.
    pub lux: Option<f64>,
    /// The edge, if one angle is known. Two angles determine it.
    pub edge: Edge,
    /// The falloff, in place of that edge. Beside two angles only [`Soft`] is possible: the soft edge that has both,
    /// that of [`Cone::soft_from_beam_and_field`].
    pub falloff: Option<AnyFalloff>,
    /// Beam and field angle of the widest zoom. `beam` and `field` are those of the narrowest.
    pub widest: Option<[Option<f64>; 2]>,
    /// What was assumed or left out so far.
    pub notes: Vec<String>,
}

impl Sheet {
    /// Returns the light, at the origin and down along -y.
    ///
    /// Its intensity is `candela`, else that of `lux`, else that of `lumens`, else 1. The widest zoom
    /// has the same flux. A light of 360 degrees is a point light. Without an angle, the cone is the one that has
    /// `lumens` at this intensity.
    ///
    /// # Errors
    /// Angles of no cone or of none with the falloff, more lumens than a cone of 180 degrees has, an intensity outside [0, 1e9] candela, or `lux`
    /// without `throw`.
    pub fn lamp(&self) -> Result<Lamp, Refusal> {
        for (key, value) in [("lumens", self.lumens), ("candela", self.candela), ("lux", self.lux)] {
            if let Some(value) = value.filter(|value| !(0.0..=1e9).contains(value)) {
                return Err(Refusal::new(key, value, "a number from 0 to 1e9"));
            }
        }
        let mut notes = self.notes.clone();
        let (mut angles, mut widest) = ([self.beam, self.field], self.widest);
        if let (true, Some(wide)) = (angles.contains(&Some(0.0)), widest) {
            notes.push("the zoom begins at 0 degrees, which is no cone: the light is the widest zoom".into());
            (angles, widest) = (wide, None);
        }
        let is_full = |angle: &f64| within(*angle, 360.0, 360.0).is_some();
        let is_globe = angles.iter().flatten().count() > 0 && angles.iter().flatten().all(is_full);
        if is_globe {
            notes.push("360 degrees are every direction: it is a point light".into());
            (angles, widest) = ([None; 2], None);
        }
        let mut published = angles[0].filter(|_| angles[0] == angles[1]);
        if published.is_some() && self.cone([widest.unwrap_or(angles)[0], None]).is_err() {
            notes.push("the published angle is too wide for a beam angle: it is the field angle".into());
            (published, angles[0], widest) = (None, None, widest.map(|[_, field]| [None, field]));
        }
        let throw = self.throw.filter(|throw| *throw > 0.0);
        let lux = match (self.lux, throw) {
            (Some(lux), None) => {
                return Err(Refusal::new(
                    "throw",
                    "none",
                    format_args!("over 0 metres, where the light has {lux} lux"),
                ));
            }
            (lux, throw) => lux.zip(throw).map(|(lux, throw)| lux * throw * throw),
        };
        let cone = match (angles, self.lumens.zip(self.candela.or(lux))) {
            _ if is_globe => None,
            ([None, None], Some((lumens, candela))) => Some(self.cone_of_flux(lumens, candela)?),
            _ => Some(self.cone(angles)?),
        };
        if let ([None, None], Some(cone)) = (angles, cone) {
            let [beam, field] = [cone.beam(), cone.field()].map(|angle| angle.to_degrees());
            notes.push(format!(
                "the angles follow from flux and peak: beam {beam:.2}, field {field:.2} degrees"
            ));
        }
        let candela = |lumens: f32| cone.map_or(lumens / (4.0 * PI), |cone| cone.candela(lumens));
        let flux = self.lumens.map(|lumens| f64::from(candela(lumens as f32)));
        let peaks = [("intensity", self.candela), ("illuminance", lux), ("flux", flux)];
        let mut peaks = peaks.into_iter().filter_map(|(source, peak)| Some((source, peak?)));
        let first = peaks.next();
        let intensity = first.map_or(1.0, |(_, peak)| peak as f32);
        let lumens = cone.map_or(intensity * 4.0 * PI, |cone| cone.lumens(intensity));
        let [own_peak, own_flux] = [number(intensity, "cd"), number(lumens, "lm")];
        if intensity > 1e9 {
            let expected =
                format!("at most 1e9 cd: check the angle and the {}", first.map_or("", |own| own.0));
            return Err(Refusal::new("peak", own_peak, expected));
        }
        for (source, peak) in peaks.filter(|(_, peak)| (peak / f64::from(intensity) - 1.0).abs() > 0.1) {
            let peak = number(peak as f32, "cd");
            notes.push(format!("the {source} means a peak of {peak}, but the light has {own_peak}"));
        }
        let lux = |throw: f64| number(intensity / (throw * throw) as f32, "lx");
        let lux = throw.map_or(String::new(), |throw| format!(", {} at {throw} m", lux(throw)));
        notes.push(match first {
            None => "no intensity, illuminance or flux is given: the intensity is 1".into(),
            Some(_) => format!("peak {own_peak}, flux {own_flux}{lux}"),
        });
        if let Some((degrees, Ok(field))) = published.map(|degrees| (degrees, self.cone([None, published]))) {
            let (degrees, peak) = (degrees as f32, field.candela(lumens));
            let other = format!("the peak of this flux is {} in place of {own_peak}", number(peak, "cd"));
            notes.push(format!("if {degrees} degrees is the field angle, not the beam angle, {other}"));
        }
        let wide = widest.filter(|wide| *wide != angles).map(|wide| self.cone(wide));
        let wide = wide.map(|cone| cone.and_then(|cone| lit(Some(cone), cone.candela(lumens))));
        if let Some(Err(refusal)) = &wide {
            notes.push(format!("the widest zoom is left out: {refusal}"));
        }
        let (name, light, difference) = (self.name.clone(), lit(cone, intensity)?, Difference::default());
        let (widest, is_assumed) = (wide.and_then(Result::ok), cone.is_some() && !self.is_known());
        Ok(Lamp { difference, is_assumed, widest, notes, ..Lamp::new(name, light) }.in_white(self.kelvin))
    }

    /// Returns whether the falloff is known, or beam and field angle: two equal ones are one.
    fn is_known(&self) -> bool {
        self.falloff.is_some() || self.beam.is_some() && self.field.is_some() && self.beam != self.field
    }

    /// Returns the falloff of one angle.
    fn falloff(&self) -> AnyFalloff {
        self.falloff.unwrap_or(match self.edge {
            Edge::Soft => Soft.into(),
            Edge::Hard => Hard.into(),
        })
    }

    /// Returns the cone that has a flux at a peak. Of a falloff, the flux is in proportion to the versine of the edge.
    fn cone_of_flux(&self, lumens: f64, candela: f64) -> Result<Cone<AnyFalloff>, Refusal> {
        let widest = Cone::from_outer(self.falloff(), Angle::degrees(180.0))?;
        let most = candela * f64::from(widest.lumens(1.0));
        if !(lumens > 0.0 && lumens <= most) {
            let [most, peak] = [number(most as f32, "lm"), number(candela as f32, "cd")];
            let expected = format_args!(
                "over 0 and at most {most}, those of {peak} in a cone of 180 degrees; or an angle"
            );
            return Err(Refusal::new("lumens", lumens, expected));
        }
        let outer = 2.0 * of_versine(lumens / most).to_degrees();
        Ok(Cone::from_outer(self.falloff(), Angle::degrees(outer as f32))?)
    }

    /// Returns the cone of one angle or of two different ones.
    fn cone(&self, [beam, field]: [Option<f64>; 2]) -> Result<Cone<AnyFalloff>, Refusal> {
        let field = field.filter(|_| beam != field);
        let is_one = beam.is_none() || field.is_none();
        let falloff = if is_one { Some(self.falloff()) } else { self.falloff };
        let [beam, field] = [beam, field].map(|angle| angle.map(|degrees| Angle::degrees(degrees as f32)));
        Ok(json::from_angles(falloff, [beam, field, None], None, None)?)
    }
}

fn lit(cone: Option<Cone<AnyFalloff>>, intensity: f32) -> Result<AnyLight, Refusal> {
    let Some(cone) = cone else { return Ok(PointLight::new([0.0; 3])?.with_intensity(intensity)?.into()) };
    Ok(SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone)?.with_intensity(intensity)?.into())
}

/// Returns a value with its unit, at least three digits, and commas between the thousands.
pub fn number(value: f32, unit: &str) -> String {
    let decimals = usize::from(value < 100.0) + usize::from(value < 10.0);
    let digits = format!("{value:.decimals$}");
    let (whole, rest) = digits.split_at(digits.find('.').unwrap_or(digits.len()));
    let groups: Vec<_> = whole.as_bytes().rchunks(3).rev().map(String::from_utf8_lossy).collect();
    format!("{}{rest} {unit}", groups.join(","))
}

/// Returns the numbers of a stage light of [`luminaire_fixtures`], by its name or by a part of it that
/// no other name has, in any case.
///
/// # Errors
/// Another name; the refusal has the eight names that share the most pairs of letters with it.
pub fn fixture(name: &str) -> Result<Sheet, Refusal> {
    let wanted = name.trim().to_lowercase();
    let mut all: Vec<_> = FIXTURES.iter().map(|fixture| (fixture.name.to_lowercase(), fixture)).collect();
    let parts: Vec<_> = all.iter().filter(|(lower, _)| lower.contains(&wanted)).collect();
    let [(_, found)] = parts[..] else {
        let shared = |lower: &str| {
            let has = |pair: &&[u8]| lower.as_bytes().windows(2).any(|own| own == *pair);
            wanted.as_bytes().windows(2).filter(has).count()
        };
        all.sort_by_cached_key(|(lower, _)| Reverse(shared(lower)));
        let nearest: Vec<_> = all.iter().take(8).map(|(_, fixture)| fixture.name).collect();
        return Err(Refusal::new("fixture", name, format_args!("one name, such as {}", nearest.join("; "))));
    };
    let [narrow, wide] = [found.narrowest, found.widest].map(|angle| Some(f64::from(angle)));
    let edge = if matches!(found.kind, Kind::Profile | Kind::Spot) { Edge::Hard } else { Edge::Soft };
    let (lumens, widest) = (found.lumens.map(f64::from), (narrow != wide).then_some([wide; 2]));
    let name = found.name.into();
    Ok(Sheet { name, beam: narrow, field: narrow, lumens, edge, widest, ..Sheet::default() })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lamp(beam: f64, field: f64) -> Lamp {
        let (beam, field, lumens) = (Some(beam), Some(field), Some(8_700.0));
        Sheet { beam, field, lumens, throw: Some(10.0), ..Sheet::default() }.lamp().expect("angles of a cone")
    }

    #[test]
    fn two_angles_are_those_of_the_cone_and_equal_ones_are_one() {
        let AnyLight::Spot(spot) = lamp(7.0, 15.0).light else { panic!("expected a spotlight") };
        let angles = [spot.cone().beam(), spot.cone().field()].map(|angle| angle.to_degrees().round());
        assert_eq!(angles, [7.0, 15.0]);
        let [peak, other] = &lamp(23.0, 23.0).notes[..] else { panic!("expected two notes") };
        assert_eq!(peak, "peak 60,605 cd, flux 8,700 lm, 606 lx at 10 m");
        assert!(other.ends_with("the peak of this flux is 141,485 cd in place of 60,605 cd"), "{other}");
        assert!(lamp(120.0, 120.0).notes[0].contains("it is the field angle"));
        let refused = Sheet { beam: Some(20.0), field: Some(10.0), ..Sheet::default() }.lamp().unwrap_err();
        assert!(refused.to_string().contains("alone"), "{refused}");
    }

    /// Each limit on both of its sides.
    #[test]
    fn sheets_are_accepted_up_to_their_limits() {
        let sheet = |angle, lumens| {
            let angle = Some(angle);
            Sheet { beam: angle, field: angle, lumens: Some(lumens), ..Sheet::default() }.lamp()
        };
        assert!(sheet(90.0, 1e9).is_ok() && sheet(90.0, 1.001e9).is_err());
        // 1e9 candela.
        let peak = f64::from(sheet(2.0, 1e4).unwrap().light.intensity());
        assert!(sheet(2.0, 0.99e9 / peak * 1e4).is_ok());
        let refused = sheet(2.0, 1.01e9 / peak * 1e4).unwrap_err();
        let words = "at most 1e9 cd: check the angle and the flux";
        assert_eq!((&*refused.parameter, &*refused.expected), ("peak", words));
        for (angle, is_point) in [(359.9, false), (360.0, true), (360.0001, true)] {
            assert_eq!(sheet(angle, 100.0).is_ok(), is_point, "{angle}");
        }
        // Two intensities that differ by a tenth are one.
        let notes = |candela| Sheet {
            beam: Some(20.0),
            candela: Some(candela),
            lux: Some(100.0),
            throw: Some(1.0),
            ..Sheet::default()
        };
        let notes = |candela| notes(candela).lamp().unwrap().notes.len();
        assert_eq!([notes(100.0 / 1.09), notes(100.0 / 1.11)], [1, 2]);
    }

    /// The data of a torch: its lumens and the candela of its beam.
    #[test]
    fn flux_and_peak_give_the_cone_and_back() {
        for edge in [Edge::Soft, Edge::Hard] {
            for degrees in [0.5, 12.0, 179.0] {
                let cone = Sheet { edge, ..Sheet::default() }.cone([Some(degrees / 2.0), None]).unwrap();
                let sheet = |lumens: f32| {
                    let (lumens, candela) = (Some(lumens.into()), Some(3_000.0));
                    Sheet { lumens, candela, edge, ..Sheet::default() }.lamp()
                };
                let lamp = sheet(cone.lumens(3_000.0)).unwrap();
                let AnyLight::Spot(spot) = lamp.light else { panic!("expected a spotlight") };
                let near = spot.cone().beam().to_degrees() / cone.beam().to_degrees() - 1.0;
                assert!(near.abs() < 1e-4 && lamp.is_assumed, "{degrees} degrees: {spot:?}");
                assert_eq!((spot.intensity(), lamp.notes.len()), (3_000.0, 2), "{:?}", lamp.notes);
                let refused = sheet(4.0 * PI * 3_000.0).unwrap_err();
                assert!(refused.expected.contains("3,000 cd in a cone of 180 degrees"), "{refused}");
            }
        }
    }

    /// Two of flux, peak and angles give the third of a soft edge that has both angles, and of any falloff at one angle.
    #[test]
    fn flux_peak_and_angles_of_a_falloff_agree() {
        let soft = Some(AnyFalloff::from(Soft));
        for [beam, field] in [[15.0, 26.0], [15.0, 40.0], [12.0, 22.0], [40.0, 44.0]] {
            let sheet = Sheet { beam: Some(beam), field: Some(field), falloff: soft, ..Sheet::default() };
            let by_flux = Sheet { lumens: Some(8_700.0), ..sheet.clone() }.lamp().unwrap();
            let AnyLight::Spot(spot) = by_flux.light else { panic!("expected a spotlight") };
            let cone = spot.cone();
            for (found, expected) in [(cone.beam(), beam), (cone.field(), field)] {
                assert!(
                    (f64::from(found.to_degrees()) / expected - 1.0).abs() < 1e-4,
                    "{beam} {field}: {cone:?}"
                );
            }
            let [a, b] = [beam, field].map(|angle| Angle::degrees(angle as f32));
            let soft = Cone::soft_from_beam_and_field(a, b).unwrap();
            assert!(cone.versines() == soft.versines() && !by_flux.is_assumed, "{beam} {field}: {cone:?}");
            let peak = f64::from(spot.intensity());
            let by_peak = Sheet { candela: Some(peak), ..sheet.clone() }.lamp().unwrap();
            assert_eq!(by_peak.light, by_flux.light);
            assert!((cone.lumens(spot.intensity()) / 8_700.0 - 1.0).abs() < 1e-5, "{beam} {field}");
        }
        let smooth = Some(AnyFalloff::from(luminaire::falloff::Smooth));
        let (lumens, candela) = (Some(100.0), Some(3_000.0));
        let torch = Sheet { lumens, candela, falloff: smooth, ..Sheet::default() }.lamp().unwrap();
        let AnyLight::Spot(spot) = torch.light else { panic!("expected a spotlight") };
        assert!((spot.cone().lumens(3_000.0) / 100.0 - 1.0).abs() < 1e-4, "{spot:?}");
        assert_eq!(Some(spot.cone().falloff()), smooth);
        let both = Sheet { beam: Some(15.0), field: Some(26.0), falloff: smooth, ..Sheet::default() };
        assert!(both.lamp().unwrap_err().expected.starts_with("soft or no falloff beside both"));
    }

    #[test]
    fn intensity_is_measured_before_it_is_computed() {
        let mut sheet = Sheet { field: Some(20.0), lumens: Some(1_000.0), ..Sheet::default() };
        (sheet.lux, sheet.throw, sheet.widest) = (Some(100.0), Some(5.0), Some([None, Some(40.0)]));
        let lamp = sheet.lamp().expect("a cone");
        assert_eq!(lamp.light.intensity(), 2_500.0);
        assert!(lamp.notes[0].starts_with("the flux means a peak of"), "{:?}", lamp.notes);
        assert!(lamp.widest.is_some_and(|wide| (600.0..660.0).contains(&wide.intensity())));
        sheet.throw = None;
        assert!(sheet.lamp().is_err());
    }

    #[test]
    fn fixtures_have_lights_and_parts_of_names_are_names() {
        for wanted in FIXTURES {
            let sheet = fixture(&wanted.name.to_uppercase()).expect(wanted.name);
            assert_eq!(sheet.name, wanted.name);
            assert!(sheet.lamp().is_ok_and(|lamp| lamp.widest.is_none_or(|wide| wide != lamp.light)));
        }
        assert_eq!(fixture("sharpy").map(|sheet| sheet.name), Ok("Clay Paky Sharpy".into()));
        assert!(fixture("sharpi").unwrap_err().expected.contains("Clay Paky Sharpy;"));
    }
}
