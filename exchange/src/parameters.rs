//! The parameters of a light in other tools: those with the least difference.

use luminaire::Rgb;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{Falloff, Formula};
use luminaire_export::json::kind;
use luminaire_export::printable;

use crate::curve::Curve;
use crate::family::{Family, Free, NARROWEST};
use crate::fit;
use crate::lamp::{Lamp, Use};
use crate::refusal::Refusal;
use crate::residual::{Residual, difference, even};
use crate::search;
use crate::system::System;
use crate::tool::{Law, Writer, Written};
use crate::versine::of_versine;

/// A light in the parameters of another tool.
#[derive(Clone, PartialEq, Debug)]
pub struct Parameters {
    /// The tool.
    pub tool: System,
    /// The parameters with the names and units of the tool, such as `spot_angle` and `25`.
    pub values: Vec<(&'static str, String)>,
    /// The difference over the angle, with the light's axis at full scale.
    pub angle: Residual,
    /// The largest difference over the distance in linear codes, from the throw to 16 throws, with the
    /// light on its axis at the throw at full scale; found at 512 distances.
    pub distance: f64,
    /// How the tool reads the intensities over the angle from a photometric file, a sentence, where its parameters do
    /// not hold them.
    pub profile: Option<&'static str>,
    /// What to know of the tool, a sentence each.
    pub notes: Vec<&'static str>,
}

/// The bound of a difference over the angle, in linear codes, up to which parameters are exact: twice the part to
/// which a bound is known.
const EXACT: f64 = 0.1;

impl Parameters {
    /// Returns whether the parameters hold the intensities over the angle, within 0.1 codes.
    pub fn is_exact(&self) -> bool {
        self.angle.bound <= EXACT
    }

    /// Returns the parameters as a text that [`read`](crate::read) reads: a line for each, after
    /// lines such as `# kind: point` with what the tool has in other places. Position and axis are
    /// those of the light, whatever axes the tool has. A text of several lights is theirs one after
    /// the other.
    pub fn text(&self, lamp: &Lamp) -> String {
        let list = |numbers: [f32; 3]| numbers.map(|number| format!("{number:?}")).join(",");
        let Rgb { red, green, blue } = lamp.light.color();
        let (position, axis) = match &lamp.light {
            AnyLight::Spot(spot) => (Some(spot.position()), Some(spot.given_axis())),
            AnyLight::Point(point) => (Some(point.position()), None),
            AnyLight::Measured(light) => (Some(light.position()), Some(light.given_axis())),
            AnyLight::Directional(sun) => (None, Some(sun.given_direction())),
        };
        let mut text = format!("# system: {}\n# name: {}\n", self.tool, printable(&lamp.name));
        text += &format!("# kind: {}\n", kind(&lamp.light));
        for (key, vector) in [("position", position), ("axis", axis)] {
            text.extend(vector.map(|vector| format!("# {key}: {}\n", list(vector.into()))));
        }
        text += &format!("# color: {}\n", list([red, green, blue]));
        text.extend(self.values.iter().map(|(key, value)| format!("{key}={value}\n")));
        text
    }
}

/// The light over the angle that a tool is to show.
struct Target<'a> {
    at: Box<dyn Fn(f64) -> f64 + 'a>,
    /// The half angles in degrees between which the light is monotone.
    breaks: Vec<f64>,
    /// The half angles in degrees at which the light may have a step.
    steps: Vec<f64>,
    /// Half angles in radians: beam, field and end.
    angles: [f64; 3],
}

impl<'a> Target<'a> {
    fn new(lamp: &'a Lamp) -> Option<Self> {
        let AnyLight::Spot(spot) = &lamp.light else { return None };
        if let Some(curve) = &lamp.measured {
            let breaks: Vec<_> = curve.points().iter().map(|point| point.0.min(90.0)).collect();
            let (peak, last) = (curve.peak().0, breaks[breaks.len() - 1]);
            let at = move |degrees: f64| curve.at(degrees) / peak;
            return Some(Self::of(at, breaks, vec![last], curve.end(), curve));
        }
        let cone = spot.cone();
        let end = fit::end(&cone);
        let [inner, outer, _] = cone.versines().map(f64::from);
        let degrees = |u: f64| of_versine(inner + u * (outer - inner)).to_degrees();
        let places: Vec<f64> = match cone.falloff().formula() {
            Formula::Knots(knots) => {
                knots.iter().map(|knot| f64::from(knot.to_bits().0) / 65_536.0).collect()
            }
            Formula::Samples(samples) => {
                (0..samples.len()).map(|i| i as f64 / (samples.len() - 1) as f64).collect()
            }
            _ => Vec::new(),
        };
        // The lines of a table need not meet.
        let steps: Vec<_> = places.into_iter().map(degrees).chain([end]).collect();
        let mut breaks: Vec<_> = steps.iter().copied().chain([0.0, 90.0]).collect();
        breaks.extend((0..=32).map(|i| end * f64::from(i) / 32.0));
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        let curve = Curve::new(breaks.iter().map(|&at| (at, fit::share(&cone, at))).collect())?;
        Some(Self::of(move |degrees: f64| fit::share(&cone, degrees), breaks, steps, end, &curve))
    }

    fn of(at: impl Fn(f64) -> f64 + 'a, breaks: Vec<f64>, steps: Vec<f64>, end: f64, curve: &Curve) -> Self {
        let half = |share| curve.angle(share, crate::Definition::Ies).map_or(end, |full| full / 2.0);
        let angles = [half(0.5), half(0.1), end.min(90.0)].map(f64::to_radians);
        Self { at: Box::new(at), breaks, steps, angles }
    }

    /// Returns the parameters of a tool's falloff with the least difference.
    fn fitted(&self, tool: &dyn Writer) -> (Free, Residual) {
        let (family, widest) = (tool.family(), tool.widest());
        let middles = self.breaks.windows(2).map(|pair| (pair[0] + pair[1]) / 2.0);
        // At most 1,024 places, so that the search takes no longer for a table of many.
        let grid = self.breaks.iter().copied().chain(middles).step_by(self.breaks.len().div_ceil(512));
        let grid: Vec<_> = grid.map(|degrees| (degrees.to_radians(), (self.at)(degrees))).collect();
        let cost = |free: Free| {
            if !family.accepts(free, widest) {
                return f64::INFINITY;
            }
            grid.iter().map(|&(angle, share)| (family.at(free, angle) - share).abs()).fold(0.0, f64::max)
        };
        let [beam, field, end] = self.angles;
        let least = family.apart().max(NARROWEST);
        let inner = if family.has_inner() { 0.7 * beam } else { 0.0 };
        // Of a power of the cosine: half of the light at the beam angle.
        let exponent = if family == Family::Cosine {
            (0.5_f64.ln() / beam.cos().max(1e-9).ln()).clamp(0.0, 128.0)
        } else {
            1.0
        };
        let starts = [end, field * 1.1, beam * 1.2]
            .map(|outer| outer.clamp(least, widest))
            .into_iter()
            .flat_map(|outer| {
                [[outer, inner, exponent], [outer, 0.0, exponent], [outer, inner.max(0.98 * outer), exponent]]
            });
        let found = starts.filter(|&start| family.accepts(start, widest)).map(|start| {
            let steps = [
                start[0] / 4.0,
                if family.has_inner() { start[0] / 4.0 } else { 0.0 },
                if family.has_exponent() { start[2] / 2.0 + 0.25 } else { 0.0 },
            ];
            search::least(start, steps, cost)
        });
        let (free, _) =
            found.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or(([end.min(widest), 0.0, 1.0], 1.0));
        let residual = |free: Free| {
            let fitted = |degrees: f64| family.at(free, degrees.to_radians());
            // The end of the fitted cone is a break of it.
            let end = free[0].to_degrees();
            let breaks = [&self.breaks[..], &even(0.0, end)].concat();
            difference(&self.at, &fitted, breaks, [&self.steps, &[end]])
        };
        let found = (free, residual(free));
        // A search that compares places does not end at a step between two of them.
        let step = family.step(end).filter(|&step| family.accepts(step, widest));
        step.map(|step| (step, residual(step))).filter(|(_, own)| own.bound <= found.1.bound).unwrap_or(found)
    }
}

/// Returns the parameters of a light in a tool.
///
/// # Errors
/// A system without parameters to write, a measured light, a cone that is narrower than a search finds, or a throw at
/// which the light has ended.
pub fn parameters(lamp: &Lamp, tool: System, usage: Use) -> Result<Parameters, Refusal> {
    let writer = tool.writer().ok_or_else(|| {
        let names: Vec<_> = System::writable().map(System::name).collect();
        Refusal::new("tool", tool, format_args!("one of {}", names.join(", ")))
    })?;
    if let AnyLight::Measured(_) = lamp.light {
        let expected = format_args!(
            "a light that is round: {tool} has no parameters of a distribution over all directions; \
             `--round` takes the mean of the planes"
        );
        return Err(Refusal::new("light", "measured", expected));
    }
    let notes = writer.notes(usage);
    let Some(attenuation) = lamp.attenuation() else {
        let values = writer.sun(lamp.light.intensity().into(), usage);
        return Ok(Parameters {
            tool,
            values,
            angle: Residual::default(),
            distance: 0.0,
            profile: None,
            notes,
        });
    };
    let target = Target::new(lamp);
    if let Some(end) = target.as_ref().map(|target| target.angles[2]).filter(|end| *end < NARROWEST) {
        let least = (2.0 * NARROWEST).to_degrees();
        let expected = format_args!("at least {least:.4} degrees (full angle) in {tool}");
        return Err(Refusal::new("outer angle", (2.0 * end).to_degrees() as f32, expected));
    }
    let cone = target.map(|target| target.fitted(writer));

    // The law of the tool, and the intensity with the same light at the throw.
    let throw = usage.throw;
    let range = attenuation.range().map(f64::from);
    let numbers = attenuation.numbers().map(f64::from).collect();
    let fall = writer.fall(&Law { name: attenuation.row().law, numbers, range, throw });
    let at_throw = lamp.at(throw);
    if lamp.light.intensity() > 0.0 && !(at_throw > 0.0 && fall.at(throw) > 0.0) {
        let expected = format_args!("a distance below the range, {}", range.unwrap_or_default());
        return Err(Refusal::new("throw", throw, expected));
    }
    let candela = at_throw / fall.at(throw).max(f64::MIN_POSITIVE);
    let codes = |d: f64| 255.0 * (candela * fall.at(d) - lamp.at(d)).abs() / at_throw.max(f64::MIN_POSITIVE);
    let distances = (0..512).map(|i| throw * 16_f64.powf(f64::from(i) / 511.0));
    let distance = distances.map(codes).fold(0.0, f64::max);

    let on_axis = cone.map_or(1.0, |(free, _)| writer.family().on_axis(free));
    let light = Written { candela: candela / on_axis, fall, usage, is_point: cone.is_none() };
    let mut values = cone.map(|(free, _)| writer.cone(free)).unwrap_or_default();
    values.extend(writer.rest(&light));
    let angle = cone.map(|(_, angle)| angle).unwrap_or_default();
    let profile = writer.profile().filter(|_| angle.bound > EXACT);
    Ok(Parameters { tool, values, angle, distance, profile, notes })
}
