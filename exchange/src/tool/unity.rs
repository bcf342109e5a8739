//! Unity with its Universal Render Pipeline, from its shaders: full angles in degrees.

use luminaire::attenuation::{FilamentRange, InverseSquare};

use super::{FULL_DEGREES, Fall, Law, Rows, Scene, Spot, Tool, Writer, Written, half, is_set, row, square};
use crate::family::{Family, Free};
use crate::lamp::Use;
use crate::read;
use crate::record::Record;
use crate::refusal::Refusal;
use crate::text::decode;

pub(crate) struct Unity;

/// What the line in the cosine is divided by at least.
const LEAST: f64 = 0.001;

impl Tool for Unity {
    fn scene(&self) -> Option<Scene> {
        Some(|bytes| read::unity::read(&decode(bytes)?))
    }

    fn prepare(&self, record: &mut Record) {
        record.without_prefix();
    }

    /// The fit of a black body's colours whose strongest channel is 1 (`CorrelatedColorTemperatureToRGB` in the
    /// Scriptable Render Pipelines).
    fn white(&self, record: &mut Record) -> Result<[f64; 3], Refusal> {
        let thousands = record.within("colorTemperature", 6570.0, 0.0, 1e9)?.clamp(1e3, 40e3) / 1e3;
        if !is_set(record, "useColorTemperature", "0")? {
            return Ok([1.0; 3]);
        }
        let ratio = |above: [f64; 3], below: [f64; 3]| {
            let at = |[a, b, c]: [f64; 3]| a + thousands * (b + thousands * c);
            (at(above) / at(below)).clamp(0.0, 1.0)
        };
        Ok(if thousands < 6.57 {
            let green = ratio([-399.809, 414.271, 111.543], [2779.24, 164.143, 84.7356]);
            [1.0, green, ratio([348.963, -523.53, 183.62], [2848.82, -214.52, 78.8614])]
        } else {
            let red = ratio([1.35651, 0.216422, 0.000_633_715], [-3.24223, 0.918711, 0.0]);
            [red, ratio([1370.38, 734.616, 0.689955], [-4625.69, 1699.87, 0.0]), 1.0]
        })
    }

    /// The square of a line in the cosine, and the inverse square with the window `(1 - (d/r)^4)^2`.
    fn spot(&self, record: &mut Record) -> Result<Spot, Refusal> {
        let outer = half(record, "spotAngle", 30.0, FULL_DEGREES)?;
        let inner = record.within("innerSpotAngle", 21.802_08, 0.0, 180.0)?.to_radians() / 2.0;
        let range = record.within("range", 10.0, 0.001, 1e9)? as f32;
        // The unit in which the inspector shows the intensity; the shaders have none.
        record.word("lightUnit", "0");
        let intensity = record.get("intensity", 1.0)?;
        record.note(
            "Unity: from the shaders of its Universal Render Pipeline, not checked against a running engine",
        );
        let attenuation = FilamentRange::new(InverseSquare, Some(range))?;
        let (cone, on_axis) = square(inner, outer, LEAST)?;
        Spot::new(record, cone, intensity * on_axis, attenuation)
    }

    /// The colour, whose channels may be over 1, is the light.
    fn ambient(&self, _: &mut Record) -> Result<f64, Refusal> {
        Ok(1.0)
    }

    fn writer(&self) -> Option<&'static dyn Writer> {
        Some(&Self)
    }
}

impl Writer for Unity {
    fn family(&self) -> Family {
        Family::SquareCosine { least: LEAST, apart: 0.0 }
    }

    fn widest(&self) -> f64 {
        89.5_f64.to_radians()
    }

    fn fall(&self, law: &Law) -> Fall {
        Fall::Decay { decay: 2.0, range: law.always(), window: 2 }
    }

    fn cone(&self, [outer, inner, _]: Free) -> Rows {
        vec![row("innerSpotAngle", 2.0 * inner.to_degrees()), row("spotAngle", 2.0 * outer.to_degrees())]
    }

    fn rest(&self, light: &Written) -> Rows {
        let [_, range] = light.fall.decay();
        vec![row("range", range), row("intensity", light.shown())]
    }

    fn notes(&self, _: Use) -> Vec<&'static str> {
        vec!["for the Universal Render Pipeline, from its shaders, not checked against a running engine"]
    }
}
