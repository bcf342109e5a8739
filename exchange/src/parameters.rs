//! The parameters of a light in other tools: those with the least difference.

use std::f64::consts::{FRAC_PI_2, PI};

use luminaire::Rgb;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{Falloff, Formula};
use luminaire_export::json::kind;
use luminaire_export::printable;

use crate::curve::Curve;
use crate::fit;
use crate::lamp::{Lamp, Use};
use crate::refusal::Refusal;
use crate::residual::{Residual, difference, even};
use crate::search;
use crate::system::System;
use crate::versine::{of_versine, versine};

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
    /// What to know of the tool, a sentence each.
    pub notes: Vec<&'static str>,
}

impl Parameters {
    /// Returns the parameters as a text that [`read`](crate::read) reads: a line for each, after
    /// lines such as `# kind: point` with what the tool has in other places. Position and axis are
    /// those of the light, whatever axes the tool has. A text of several lights is theirs one after
    /// the other.
    pub fn text(&self, lamp: &Lamp) -> String {
        let list = |numbers: [f32; 3]| numbers.map(|number| format!("{number:?}")).join(",");
        let Rgb { red, green, blue } = lamp.light.color();
        let (position, axis) = match &lamp.light {
            AnyLight::Spot(spot) => (Some(spot.position()), Some(spot.toward())),
            AnyLight::Point(point) => (Some(point.position()), None),
            AnyLight::Directional(sun) => (None, Some(sun.toward())),
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

/// The tools that parameters can be written for.
pub const TOOLS: [System; 10] = [
    System::Blender,
    System::Three,
    System::Godot,
    System::Unreal,
    System::Unity,
    System::Bevy,
    System::Gltf,
    System::Usd,
    System::OpenGl,
    System::Direct3d,
];

/// The falloffs of the tools over the angle.
#[derive(Clone, Copy, PartialEq)]
enum Family {
    /// Smoothstep in the cosine.
    SmoothCosine,
    /// The square of a line in the cosine, which is divided by at least the first number, between
    /// half angles that are at least the second one apart.
    SquareCosine(f64, f64),
    /// Smoothstep in the angle.
    SmoothAngle,
    /// `1 - u^p` with the versine `u`.
    Inverted,
    /// A power of the cosine, cut off.
    Cosine,
    /// A power of a line in the cosine.
    Power,
}

/// Godot's least part of the versine.
const FLOOR: f64 = 1e-4;

/// The narrowest half angle in radians.
const NARROWEST: f64 = 1e-5;

/// By how much Unreal's outer half angle in radians exceeds the inner one at least.
const APART: f64 = 0.001;

/// Pi, whose seven digits are no more than it.
const HALF_TURN: f64 = PI - 6e-7;

/// Outer and inner half angle in radians, and an exponent.
type Free = [f64; 3];

impl Family {
    fn of(tool: System) -> Self {
        match tool {
            System::Blender | System::Three => Self::SmoothCosine,
            System::Usd => Self::SmoothAngle,
            System::Godot => Self::Inverted,
            System::OpenGl => Self::Cosine,
            System::Direct3d => Self::Power,
            System::Unity => Self::SquareCosine(1e-3, 0.0),
            System::Bevy => Self::SquareCosine(1e-4, 0.0),
            System::Unreal => Self::SquareCosine(0.0, APART),
            _ => Self::SquareCosine(0.0, 0.0),
        }
    }

    fn has_inner(self) -> bool {
        !matches!(self, Self::Inverted | Self::Cosine)
    }

    fn has_exponent(self) -> bool {
        matches!(self, Self::Inverted | Self::Cosine | Self::Power)
    }

    fn accepts(self, [outer, inner, exponent]: Free, widest: f64) -> bool {
        let exponents = match self {
            Self::Inverted => 1.0 / 64.0..=64.0,
            Self::Cosine => 0.0..=128.0,
            _ => 1e-3..=64.0,
        };
        let apart = if let Self::SquareCosine(_, apart) = self { apart } else { 0.0 };
        (NARROWEST..=widest).contains(&outer)
            && (0.0..outer).contains(&inner)
            && outer - inner >= apart
            && exponents.contains(&exponent)
    }

    /// Returns the share of the intensity that the tool shows on the axis.
    fn on_axis(self, [outer, inner, exponent]: Free) -> f64 {
        match self {
            Self::SquareCosine(least, _) => {
                (versine(outer) / (versine(outer) - versine(inner)).max(least)).min(1.0).powi(2)
            }
            Self::Inverted => 1.0 - FLOOR.powf(exponent),
            _ => 1.0,
        }
    }

    /// Returns the intensity at a half angle in radians, as a share of that on the axis.
    fn at(self, free: Free, angle: f64) -> f64 {
        let [outer, inner, exponent] = free;
        if angle >= outer {
            return 0.0;
        }
        let (v, from, to) = (versine(angle), versine(inner), versine(outer));
        let t = ((to - v) / (to - from)).clamp(0.0, 1.0);
        match self {
            Self::SmoothCosine => t * t * (3.0 - 2.0 * t),
            Self::SquareCosine(least, _) => {
                ((to - v) / (to - from).max(least)).min(1.0).powi(2) / self.on_axis(free)
            }
            Self::SmoothAngle => {
                let t = ((outer - angle) / (outer - inner)).clamp(0.0, 1.0);
                t * t * (3.0 - 2.0 * t)
            }
            Self::Inverted => (1.0 - (v / to).max(FLOOR).powf(exponent)) / self.on_axis(free),
            Self::Cosine => angle.cos().powf(exponent),
            Self::Power => t.powf(exponent),
        }
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

    /// Returns the parameters of a family with the least difference.
    fn fitted(&self, tool: System) -> (Free, Residual) {
        let family = Family::of(tool);
        // The widest half angle that the tool does not clamp.
        let widest = match tool {
            System::Unreal => 88.9_f64.to_radians(),
            System::Unity => 89.5_f64.to_radians(),
            _ => FRAC_PI_2,
        };
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
        let least = if tool == System::Unreal { APART } else { NARROWEST };
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
        let fitted = |degrees: f64| family.at(free, degrees.to_radians());
        // The end of the fitted cone is a break of it.
        let end = free[0].to_degrees();
        let breaks = [&self.breaks[..], &even(0.0, end)].concat();
        (free, difference(&self.at, &fitted, breaks, [&self.steps, &[end]]))
    }
}

/// Returns the parameters of a light in a tool.
///
/// # Errors
/// A system without parameters to write, a cone that is narrower than a search finds, or a throw at
/// which the light has ended.
pub fn parameters(lamp: &Lamp, tool: System, usage: Use) -> Result<Parameters, Refusal> {
    if !TOOLS.contains(&tool) {
        let names: Vec<_> = TOOLS.iter().map(|tool| tool.name()).collect();
        return Err(Refusal::new("tool", tool, format_args!("one of {}", names.join(", "))));
    }
    let Some(attenuation) = lamp.attenuation() else {
        let values = sun(tool, lamp.light.intensity().into(), usage);
        let values = values.into_iter().map(|(key, value)| (key, digits(value))).collect();
        let notes = notes(tool, usage);
        return Ok(Parameters { tool, values, angle: Residual::default(), distance: 0.0, notes });
    };
    let law = attenuation.row().law;
    let numbers: Vec<_> = attenuation.numbers().map(f64::from).collect();
    let own_range = attenuation.range().map(f64::from);
    let target = Target::new(lamp);
    if let Some(end) = target.as_ref().map(|target| target.angles[2]).filter(|end| *end < NARROWEST) {
        let least = (2.0 * NARROWEST).to_degrees();
        let expected = format_args!("at least {least:.4} degrees (full angle) in {tool}");
        return Err(Refusal::new("outer angle", (2.0 * end).to_degrees() as f32, expected));
    }
    let is_spot = target.is_some();
    let (free, angle) = target.map_or(([FRAC_PI_2, 0.0, 1.0], Residual::default()), |own| own.fitted(tool));

    // The law of the tool, and the intensity with the same light at the throw.
    let throw = usage.throw;
    let decay = match (tool, law) {
        (System::Three | System::Godot, "constant") => 0.0,
        (System::Three | System::Godot, "decay") => numbers[0],
        _ => 2.0,
    };
    // A tool that cannot do without a range gets one that takes less than 0.1 codes at 2 throws.
    let range = match tool {
        System::Blender | System::Usd | System::OpenGl => None,
        System::Godot | System::Unreal | System::Unity | System::Bevy => own_range.or(Some(throw * 20.0)),
        _ => own_range,
    };
    let polynomial = match (law, tool) {
        ("constant", _) => [1.0, 0.0, 0.0],
        ("polynomial", System::OpenGl | System::Direct3d) => [numbers[0], numbers[1], numbers[2]],
        _ => [0.0, 0.0, 1.0],
    };
    let [constant, linear, quadratic] = polynomial;
    let falls = |d: f64| {
        let window = |power: i32| range.map_or(1.0, |range| (1.0 - (d / range).powi(4)).max(0.0).powi(power));
        match tool {
            System::Direct3d if range.is_some_and(|range| d > range) => 0.0,
            System::OpenGl | System::Direct3d => 1.0 / (constant + d * (linear + d * quadratic)),
            System::Gltf => window(1) / (d * d),
            _ => window(2) * d.powf(-decay),
        }
    };
    let intensity = f64::from(lamp.light.intensity());
    let at_throw = lamp.at(throw);
    if intensity > 0.0 && !(at_throw > 0.0 && falls(throw) > 0.0) {
        let expected = format_args!("a distance below the range, {}", own_range.unwrap_or_default());
        return Err(Refusal::new("throw", throw, expected));
    }
    let candela = at_throw / falls(throw).max(f64::MIN_POSITIVE);
    let codes = |d: f64| 255.0 * (candela * falls(d) - lamp.at(d)).abs() / at_throw.max(f64::MIN_POSITIVE);
    let distances = (0..512).map(|i| throw * 16_f64.powf(f64::from(i) / 511.0));
    let distance = distances.map(codes).fold(0.0, f64::max);

    let peak = candela / if is_spot { Family::of(tool).on_axis(free) } else { 1.0 };
    let (cone, rest) = values(tool, free, peak, usage, [decay, range.unwrap_or_default()], polynomial);
    let cone = cone.into_iter().filter(|_| is_spot);
    let mut values: Vec<_> = cone.chain(rest).map(|(key, value)| (key, digits(value))).collect();
    if tool == System::Unreal {
        values.push(("IntensityUnits", "Candelas".to_owned()));
    }
    if !is_spot {
        let of_points = |key| match key {
            "spot_range" => "omni_range",
            "spot_attenuation" => "omni_attenuation",
            _ => key,
        };
        values.iter_mut().for_each(|(key, _)| *key = of_points(key));
    }
    Ok(Parameters { tool, values, angle, distance, notes: notes(tool, usage) })
}

/// Returns what to know of a tool.
fn notes(tool: System, usage: Use) -> Vec<&'static str> {
    match tool {
        System::Blender if usage.is_photometric => {
            vec!["the energy in watts counts 683 lumens a watt, as Blender's exporter of glTF does"]
        }
        System::Unreal => vec!["from Unreal's shaders as published, not checked against a running engine"],
        System::Unity => {
            vec!["for the Universal Render Pipeline, from its shaders, not checked against a running engine"]
        }
        System::OpenGl => vec!["the intensity is a factor of GL_DIFFUSE, which may be over 1"],
        System::Direct3d => vec!["the intensity is a factor of Diffuse, which may be over 1"],
        _ => Vec::new(),
    }
}

type Rows = Vec<(&'static str, f64)>;

/// The watts of Blender for a number of candela or lux, by the 683 lumens a watt of its exporter of
/// glTF.
fn watts(value: f64, usage: Use) -> f64 {
    value / if usage.is_photometric { 683.0 } else { 1.0 }
}

/// Returns the values of a directional light of this irradiance.
fn sun(tool: System, irradiance: f64, usage: Use) -> Rows {
    let shown = irradiance / usage.full_scale;
    match tool {
        System::Blender => vec![("energy", watts(irradiance, usage))],
        System::Godot => vec![("light_energy", shown)],
        System::Unreal => vec![("Intensity", irradiance)],
        System::Bevy => vec![("illuminance", irradiance)],
        System::Usd => vec![("normalize", 1.0), ("intensity", irradiance)],
        System::Three | System::Gltf => vec![("intensity", irradiance)],
        _ => vec![("intensity", shown)],
    }
}

/// Returns the values of the cone and the other ones, in the names and units of the tool. A range of 0
/// is none.
fn values(
    tool: System,
    [outer, inner, exponent]: Free,
    candela: f64,
    usage: Use,
    [decay, range]: [f64; 2],
    [constant, linear, quadratic]: [f64; 3],
) -> (Rows, Rows) {
    let shown = candela / usage.full_scale;
    match tool {
        System::Blender => (
            vec![
                ("spot_size", (2.0 * outer).min(HALF_TURN)),
                ("spot_blend", 1.0 - versine(inner) / versine(outer)),
            ],
            vec![("energy", watts(4.0 * PI * candela, usage))],
        ),
        System::Three => (
            vec![("angle", outer), ("penumbra", 1.0 - inner / outer)],
            vec![("decay", decay), ("distance", range), ("intensity", candela)],
        ),
        System::Godot => (
            vec![("spot_angle", outer.to_degrees()), ("spot_angle_attenuation", 1.0 / exponent)],
            vec![("spot_range", range), ("spot_attenuation", decay), ("light_energy", shown)],
        ),
        System::Unreal => (
            vec![("InnerConeAngle", inner.to_degrees()), ("OuterConeAngle", outer.to_degrees())],
            // The largest radius that is read stands for none.
            vec![("AttenuationRadius", (100.0 * range).min(1e9)), ("Intensity", candela)],
        ),
        System::Unity => (
            vec![("innerSpotAngle", 2.0 * inner.to_degrees()), ("spotAngle", 2.0 * outer.to_degrees())],
            vec![("range", range), ("intensity", shown)],
        ),
        System::Bevy => (
            vec![("inner_angle", inner), ("outer_angle", outer)],
            vec![("range", range), ("intensity", 4.0 * PI * candela)],
        ),
        System::Gltf => (
            vec![("innerConeAngle", inner), ("outerConeAngle", outer)],
            [("range", range), ("intensity", candela)].into_iter().skip(usize::from(range == 0.0)).collect(),
        ),
        System::Usd => (
            vec![("shaping:cone:angle", outer.to_degrees()), ("shaping:cone:softness", 1.0 - inner / outer)],
            vec![("normalize", 1.0), ("radius", 0.01), ("intensity", 4.0 * candela)],
        ),
        System::OpenGl => (
            vec![("spot_cutoff", outer.to_degrees()), ("spot_exponent", exponent)],
            vec![
                ("constant_attenuation", constant),
                ("linear_attenuation", linear),
                ("quadratic_attenuation", quadratic),
                ("intensity", shown),
            ],
        ),
        _ => (
            vec![
                ("theta", (2.0 * inner).min(HALF_TURN)),
                ("phi", (2.0 * outer).min(HALF_TURN)),
                ("falloff", exponent),
            ],
            vec![
                ("attenuation0", constant),
                ("attenuation1", linear),
                ("attenuation2", quadratic),
                // Direct3D's largest range, for none.
                ("range", if range > 0.0 { range } else { f64::from(f32::MAX).sqrt() }),
                ("intensity", shown),
            ],
        ),
    }
}

/// Returns a number with seven digits, without an exponent and without zeros at the end.
fn digits(value: f64) -> String {
    let digits = (6.0 - value.abs().max(1e-12).log10().floor()).clamp(0.0, 12.0) as usize;
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
