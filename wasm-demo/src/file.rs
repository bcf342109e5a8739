//! The JavaScript class of a file of another tool: its lights, for the page.

mod measured;

use crate::{light::hex_of, name::Name, own_cone, refusal::Refusal};
use luminaire::{Cone, dynamic::AnyLight, falloff::AnyFalloff, projector::Projection};
use luminaire_exchange::{
    Curve, Definition, Lamp, Lamps, Reading, Residual, Use, fits,
    leds::{Facing, LedMap, PlacedLeds, Up},
    number, parameters, read, share,
};
use luminaire_render::scenes::tree;
use serde_json::{Value, json};
use wasm_bindgen::{Clamped, prelude::*};

/// A file of another tool with its lights.
#[wasm_bindgen]
#[derive(Debug)]
pub struct LightFile(Lamps, Use);

#[wasm_bindgen]
impl LightFile {
    /// Reads a file. `throw` is the distance in metres of the surface that counts, and `is_round` whether a measured
    /// light is the mean of its planes whatever their difference. Throws what the reader refuses, in its words.
    #[wasm_bindgen(constructor)]
    pub fn new(name: &str, bytes: &[u8], throw: f64, is_round: bool) -> Result<Self, Refusal> {
        let reading = Reading { is_round, ..Reading::default() };
        let lamps = read(name, bytes, None, reading)?;
        let usage = lamps.usage(throw);
        Ok(Self(lamps, usage))
    }

    /// Returns the lights and the notes of the file as JSON.
    pub fn told(&self) -> String {
        let refused = self.0.refused.iter().map(|refusal| format!("Refused: {refusal}"));
        let ambient =
            self.0.ambient.iter().map(|ambient| format!("Ambient light is left out: {}", ambient.name));
        let notes: Vec<_> = refused.chain(self.0.notes.iter().cloned()).chain(ambient).collect();
        let lights: Vec<_> = self.0.lamps.iter().map(|lamp| told(lamp, self.1)).collect();
        json!({ "lights": lights, "notes": notes }).to_string()
    }

    /// Returns the pixels, RGBA in rows of 440, of a picture of a light that is not round: of a room in its light, or of its
    /// directions. Throws in words that the light is another.
    pub fn picture(&self, light: usize, is_room: bool) -> Result<Clamped<Vec<u8>>, Refusal> {
        let AnyLight::Measured(light) = self.lamp(light)?.light else {
            return Err(Refusal::name("light", "round", "one that is not round"));
        };
        Ok(Clamped(if is_room { measured::room(&light)? } else { measured::sphere(&light) }))
    }

    /// Returns the parameters of a light in a tool as a text that is a file itself, and after it
    /// sentences about their difference and about the tool. Throws in words that there are none.
    pub fn parameters(&self, light: usize, tool: &str) -> Result<Vec<String>, Refusal> {
        let lamp = self.lamp(light)?;
        let found = parameters(lamp, tool.parse()?, self.1.within(lamp))?;
        let Residual { bound, degrees, .. } = found.angle;
        let told = format!(
            "Within {bound:.2} of 255 codes over the angle, most at {degrees:.1}°, and {:.2} over the distance.",
            found.distance
        );
        let told = [found.text(lamp), told];
        Ok(told.into_iter().chain(found.notes.into_iter().map(String::from)).collect())
    }
}

/// LEDs at the places of a map, for the scene of the tree.
#[wasm_bindgen(getter_with_clone)]
#[derive(Debug)]
pub struct LedFile {
    /// The places in metres: three numbers for each LED.
    pub places: Vec<f32>,
    /// The ways that the LEDs face: as many numbers.
    pub facing: Vec<f32>,
    /// What the LEDs are, in a sentence.
    pub told: String,
}

#[wasm_bindgen]
impl LedFile {
    /// Reads a map of LEDs, with the numbers that `luminaire leds --height 2` puts into a program. Returns nothing for a
    /// file that is no map. Throws what the reader refuses, in its words.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Option<Self>, Refusal> {
        let map = str::from_utf8(bytes).ok().filter(|text| LedMap::is_map(name, text));
        let Some(map) = map.map(LedMap::read).transpose()? else { return Ok(None) };
        // A plane that lies in the map stands on the stage.
        let is_upright = map.places.iter().any(|place| place[2] != map.places[0][2]);
        let height = f64::from(tree::HEIGHT);
        let up = if is_upright { Up::Z } else { Up::Y };
        if !is_upright && map.places.iter().all(|place| place[1] == map.places[0][1]) {
            let expected = "at least two heights: LEDs stand upright on the stage";
            return Err(Refusal(format!("LEDs = {} at one height: expected {expected}", map.places.len())));
        }
        let leds = PlacedLeds::new(map, up, Facing::Map, Some(height))?;
        let takes = match leds.side {
            Facing::Map => "of the side that it faces, as the map says",
            _ => "of the side away from the upright axis through their middle",
        };
        let numbers =
            |all: &[[f64; 3]]| all.as_flattened().iter().map(|number| *number as f32).collect::<Vec<_>>();
        let count = leds.places.len();
        let told = format!("{count} LEDs, {height} m high: each takes the light {takes}.");
        let facing = leds.facing.as_deref().map_or_else(Vec::new, numbers);
        Ok(Some(Self { places: numbers(&leds.places), facing, told }))
    }
}

impl LightFile {
    fn lamp(&self, light: usize) -> Result<&Lamp, Refusal> {
        let lamps = &self.0.lamps;
        lamps.get(light).ok_or_else(|| Refusal::light(light, lamps.len()))
    }
}

/// What the page shows of a light: sentences, curves of angles off the axis in degrees and shares of the
/// largest intensity, and its settings for an address.
fn told(lamp: &Lamp, usage: Use) -> Value {
    let cone = if let AnyLight::Spot(spot) = &lamp.light { Some(spot.cone()) } else { None };
    let (curve, fit, Use { throw, is_photometric, .. }) = (lamp.curve(), lamp.fits.last(), usage);
    let angle = |share| curve.as_ref().and_then(|curve| curve.angle(share, Definition::Ies));
    let Residual { found, bound, degrees, .. } = fit.map(|fit| fit.residual).unwrap_or_default();
    let [off, far] = [255.0 * lamp.difference.angle, 100.0 * lamp.difference.distance];
    let difference = match fit {
        // Of a light whose planes differ, the dots are their mean.
        Some(_) => {
            let planes = f64::from(off) - bound;
            let planes = if planes > 0.005 { format!(", and {off:.2} of each plane") } else { String::new() };
            format!(
                "{bound:.2} of 255 codes of the measured dots{planes}; found {found:.2} at {degrees:.2}°."
            )
        }
        None => format!("{off:.2} of 255 codes over the angle and {far:.1} % over the distance."),
    };
    let [cd, lx] = if is_photometric { ["cd", "lx"] } else { ["of full scale"; 2] };
    let axis = |curve: &Curve| curve.at(0.0) / curve.peak().0.max(f64::MIN_POSITIVE);
    let lux = lamp.lit(throw) * curve.as_ref().map_or(1.0, axis);
    let intensity = lamp.own_intensity();
    let table = if let AnyLight::Measured(light) = &lamp.light { Some(light) } else { None };
    let flux = curve.as_ref().map(Curve::lumens);
    let flux = flux.or(table.map(|light| measured::lumens(light.distribution(), intensity)));
    let flux = flux.filter(|_| is_photometric).map(|lumens| number(lumens as f32, "lm"));
    let cone_angles =
        angle(0.5).zip(angle(0.1)).map(|(beam, field)| format!("beam {beam:.2}°, field {field:.2}°"));
    let peak = format!("Peak {}", number(intensity as f32, cd));
    let white = lamp.kelvin.map(|kelvin| format!("{kelvin} K"));
    let lit = format!("{} at {throw:.2} m", number(lux as f32, lx));
    let photometry: Vec<_> =
        [Some(peak), flux, cone_angles, Some(lit), white].into_iter().flatten().collect();
    // A tail of faint light would make the drawing narrow.
    let end = curve.as_ref().map_or(0.0, Curve::end).min(angle(0.1).unwrap_or(180.0)).max(degrees);
    let angles = (0..=210).map(|i| f64::from(i) / 200.0 * end);
    let points = lamp.measured.iter().flat_map(|curve| {
        curve.points().iter().map(|point| [point.0, point.1 / curve.peak().0]).filter(|point| point[0] <= end)
    });
    let fitted = fit.filter(|fit| fit.name == "table").and(lamp.measured.as_ref());
    let color = match lamp.kelvin {
        Some(kelvin) => format!(":w{kelvin}"),
        None => hex_of(lamp.light.color()).replace('#', ":c"),
    };
    // On the stage a spotlight has a shadow, which ends at the widest projection.
    let widest = Projection::WIDEST;
    let staged = cone.map(|cone| fitted.and_then(ended).unwrap_or(cone));
    let cut = staged.filter(|cone| cone.outer_versine() > widest.versine());
    let cut = cut.and_then(|cone| cone.with_cutoff(widest).ok());
    let name = Name::of(&lamp.name).map_or_else(String::new, |name| format!(":n{name}"));
    let settings = |cone: Cone<_>| format!("{name}:o{}{color}", own_cone::write(&cone));
    json!({
        "name": lamp.name,
        "fit": fit.map(|fit| fit.name),
        "settings": cut.or(staged).map(settings),
        "isCut": cut.is_some(),
        "intensity": intensity,
        "isCandela": is_photometric,
        "beam": angle(0.5),
        "field": angle(0.1),
        "difference": format!("Within {difference}"),
        "photometry": photometry.join(", "),
        "points": points.collect::<Vec<_>>(),
        "planes": table.map(measured::planes),
        "drawn": cone.map(|cone| angles.map(|angle| [angle, share(&cone, angle)]).collect::<Vec<_>>()),
        "notes": lamp.notes,
    })
}

/// Returns the cheapest cone for measured intensities without the tail that is under half a code: a shadow map
/// has the whole cone.
fn ended(curve: &Curve) -> Option<Cone<AnyFalloff>> {
    let end = curve.angle(0.5 / 255.0, Definition::Ies)? / 2.0;
    let lit = curve.points().iter().copied().take_while(|point| point.0 < end);
    let curve = Curve::new(lit.chain([(end, curve.at(end))]).collect())?;
    Some(fits(&curve, Reading::default().fit).ok()?.last()?.cone)
}
