//! Lights of other tools, in and out, against the published formulas of the tools.

mod formulas;

use std::fs;

use fastrand::Rng;
use formulas::{FORMULAS, Formula, Kind};
use luminaire::attenuation::Attenuation;
use luminaire::dynamic::AnyLight;
use luminaire_exchange::{Lamp, System, Use, numbers, parameters, share};

/// The lights that are drawn: tool, kind, and for each number its value, or the range that it is drawn
/// from, which may be that of a part of another one. The last ones have the defaults of their tools.
const ROWS: &str = "\
gltf spot outerConeAngle=0.05..1.57 innerConeAngle=0..0.95*outerConeAngle intensity=0.1..900 range=4..60
gltf point intensity=0.1..900 range=4..60
gltf directional intensity=0.1..9
three spot angle=0.05..1.57 penumbra=0..1 distance=4..60 decay=0..3 intensity=0.1..900
three point distance=4..60 decay=0..3
godot spot spot_angle=3..90 spot_angle_attenuation=0.1..8 spot_range=4..60 spot_attenuation=0..3 light_energy=0.1..16
godot point omni_range=4..60 omni_attenuation=0..3
opengl spot spot_cutoff=3..90 spot_exponent=0..128 constant_attenuation=0.1..3 linear_attenuation=0..1 quadratic_attenuation=0..1
direct3d spot phi=0.1..3.1 theta=0..0.95*phi falloff=1..20 attenuation0=0.1..3 attenuation1=0..1 attenuation2=0..1 range=90..99
blender spot spot_size=0.1..3.1 spot_blend=0..1 energy=1..900
blender directional energy=1..9 exposure=-2..2
usd spot shaping:cone:angle=3..90 shaping:cone:softness=0..1 intensity=0.1..90 exposure=-2..4 radius=0.01..0.2
usd spot shaping:cone:angle=3..90 shaping:focus=0.5..30 intensity=0.1..90 normalize=1
usd directional angle=0.1..20 intensity=0.1..90
x3d spot cutOffAngle=0.05..1.57 beamWidth=0..1.2*cutOffAngle attenuation=0..1 radius=90..99 intensity=0.1..1
pbrt spot coneangle=3..90 conedeltaangle=0.05..1*coneangle scale=0.1..9 I=0.1..9
pbrt spot coneangle=3..90 conedeltaangle=0.05..1*coneangle power=1..900
pbrt spot coneangle=3..90 conedeltaangle=0.05..1*coneangle version=3
pbrt directional scale=0.1..9 illuminance=1..900
unreal spot OuterConeAngle=3..80 InnerConeAngle=0..1.1*OuterConeAngle AttenuationRadius=400..6000 Intensity=1..9000
unreal spot OuterConeAngle=80..90
unity spot spotAngle=3..179 innerSpotAngle=0..0.9*spotAngle range=4..60
bevy spot outer_angle=0.05..1.57 inner_angle=0..0.9*outer_angle range=4..60 intensity=1000..1000000
babylon spot angle=0.1..3.1 innerAngle=0..0.9*angle range=4..60 falloffType=2 exponent=0
babylon spot angle=0.1..1.5 falloffType=1 exponent=0
babylon spot angle=0.1..3.1 exponent=0..60 falloffType=3
gltf spot
gltf point
three spot
three point
godot spot
godot point
blender spot
blender directional
usd spot shaping:cone:angle=40
usd directional
x3d spot
x3d spot version=2
x3d spot version=3.2
x3d point
pbrt spot
unreal spot
unreal directional
unity spot
unity point
bevy spot
bevy point
bevy directional
direct3d spot phi=1 falloff=1 attenuation0=1 range=90
opengl spot spot_cutoff=40";

/// A drawn light: its tool, its kind, and its values.
type Drawn = (&'static str, Kind, Vec<(&'static str, f64)>);

fn drawn(rng: &mut Rng, row: &'static str) -> Drawn {
    let number = |text: &str| text.parse::<f64>().expect("a number");
    let mut words = row.split(' ');
    let (tool, kind) = (words.next().expect("a tool"), words.next().expect("a kind"));
    let kind = match kind {
        "spot" => Kind::Spot,
        "point" => Kind::Point,
        _ => Kind::Directional,
    };
    let mut values: Vec<(&str, f64)> = Vec::new();
    for word in words {
        let (key, range) = word.split_once('=').expect("a range");
        let (range, of) = range.split_once('*').unwrap_or((range, ""));
        let (least, most) = range.split_once("..").unwrap_or((range, range));
        let whole = values.iter().find(|value| value.0 == of).map_or(1.0, |value| value.1);
        values.push((key, (number(least) + (number(most) - number(least)) * rng.f64()) * whole));
    }
    (tool, kind, values)
}

fn read(tool: &str, kind: Kind, values: &[(&str, f64)]) -> Lamp {
    let mut words: Vec<_> = values.iter().map(|(key, value)| format!("{key}={value}")).collect();
    words.push(format!("kind={}", ["spot", "point", "directional"][kind as usize]));
    let lamps = numbers(tool.parse().expect("a tool"), words.iter().map(String::as_str));
    lamps.unwrap_or_else(|refusal| panic!("{words:?}: {refusal}")).lamps.remove(0)
}

/// The values as the formula of the tool has them: of a polynomial, one number stands for three.
fn told(values: &[(&'static str, f64)]) -> Vec<(&'static str, f64)> {
    let each = |&(key, value): &(&'static str, f64)| match key {
        "attenuation" => vec![("attenuation0", value), ("attenuation1", value), ("attenuation2", value)],
        _ => vec![(key, value)],
    };
    values.iter().flat_map(each).collect()
}

/// The irradiance on a surface that faces the light.
fn irradiance(light: &AnyLight, angle: f64, distance: f64) -> f64 {
    let intensity = f64::from(light.intensity());
    match light {
        AnyLight::Spot(spot) => {
            intensity * share(&spot.cone(), angle.to_degrees()) * spot.attenuation().exact(distance)
        }
        AnyLight::Point(point) => intensity * point.attenuation().exact(distance),
        AnyLight::Measured(_) => unreachable!("no tool has one"),
        AnyLight::Directional(_) => intensity,
    }
}

/// The length of a unit of the tool in units of the light.
fn unit(tool: &str) -> f64 {
    if tool == "unreal" { 0.01 } else { 1.0 }
}

/// Checks a light and its stated difference against a formula at angles and at distances from a 16th of its range
/// on, and returns the largest difference in parts of the light on the axis.
fn check(rng: &mut Rng, tool: &str, lamp: &Lamp, formula: &dyn Fn(f64, f64) -> f64, allowed: f64) -> f64 {
    let range = match &lamp.light {
        AnyLight::Spot(spot) => spot.attenuation().range(),
        AnyLight::Point(point) => point.attenuation().range(),
        AnyLight::Measured(_) | AnyLight::Directional(_) => None,
    };
    let range = f64::from(range.unwrap_or(16.0));
    // Over the distance a difference is the largest at the nearest distance that it compares, and no more is stated.
    let (found, exact) =
        (irradiance(&lamp.light, 0.0, range / 16.0), formula(0.0, range / 16.0 / unit(tool)));
    let (stated, nearest) = (f64::from(lamp.difference.distance), (found - exact).abs() / found.max(exact));
    assert!(stated <= 1.02 * nearest + 1e-6, "{tool}: {stated:e} is stated, expected at most {nearest:e}");
    let mut worst = 0.0_f64;
    for _ in 0..64 {
        let (angle, distance) =
            (rng.f64() * std::f64::consts::FRAC_PI_2, range * (1.0 + 14.9 * rng.f64()) / 16.0);
        let full = formula(0.0, distance / unit(tool)).max(irradiance(&lamp.light, 0.0, distance));
        let found = irradiance(&lamp.light, angle, distance);
        // At a jump the place is right to the rounding of the angles in f32.
        let near = [angle - 1e-6, angle, angle + 1e-6]
            .map(|angle| (found - formula(angle, distance / unit(tool))).abs());
        let difference = near.into_iter().fold(f64::INFINITY, f64::min) / full.max(f64::MIN_POSITIVE);
        assert!(difference <= allowed, "{tool}: {difference:e} of {allowed:e} at {angle} and {distance}");
        worst = worst.max(difference);
    }
    worst
}

fn formula(tool: &str) -> Formula {
    FORMULAS.iter().find(|row| row.0 == tool).expect("a formula").1
}

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/LIGHTS.md");

/// The head of the page's table of differences.
const HEAD: &str = "| tool | lights | codes |\n|---|---|---|\n";

/// Every light is within its stated difference, and the page has the largest that is found of each tool. With
/// `LUMINAIRE_BLESS=1` it is written there.
#[test]
fn conversion_is_the_published_formula_within_its_difference() {
    let mut rng = Rng::with_seed(1);
    let mut found: Vec<(&str, u32, f64)> = Vec::new();
    for row in ROWS.lines() {
        let mut worst = 0.0_f64;
        for _ in 0..100 {
            let (tool, kind, values) = drawn(&mut rng, row);
            let lamp = read(tool, kind, &values);
            let told = told(&values);
            let exact = |angle: f64, distance: f64| formula(tool)(&told, kind, angle, distance);
            let allowed = f64::from(lamp.difference.most()) + 3e-5;
            worst = worst.max(check(&mut rng, tool, &lamp, &exact, allowed));
        }
        println!("{:.3} of 255 codes: {row}", 255.0 * worst);
        let tool = row.split(' ').next().expect("a tool");
        match found.iter_mut().find(|own| own.0 == tool) {
            Some(own) => (own.1, own.2) = (own.1 + 100, own.2.max(255.0 * worst)),
            None => found.push((tool, 100, 255.0 * worst)),
        }
    }
    let table: String =
        found.iter().map(|(tool, lights, codes)| format!("| `{tool}` | {lights} | {codes:.2} |\n")).collect();
    let page = fs::read_to_string(PAGE).expect("a page");
    let (before, rest) = page.split_once(HEAD).expect("a table of differences");
    let (stated, after) = rest.split_once("\n\n").expect("an end of the table");
    if std::env::var_os("LUMINAIRE_BLESS").is_some() {
        fs::write(PAGE, format!("{before}{HEAD}{table}\n{after}")).expect("written");
    } else {
        assert_eq!(stated, table.trim_end());
    }
}

/// The parameters of a tool give its own formula the light that they say: within the stated difference
/// over the angle, and that over the distance.
#[test]
fn parameters_give_the_light_within_their_difference() {
    let mut rng = Rng::with_seed(2);
    for row in ROWS.lines().filter(|row| row.contains(" spot ")).step_by(2) {
        let (from, kind, values) = drawn(&mut rng, row);
        let lamp = read(from, kind, &values);
        for tool in System::writable() {
            let usage = Use { throw: 4.0, full_scale: 1.0, is_photometric: tool.is_photometric() };
            let found = parameters(&lamp, tool, usage).expect("a spotlight");
            let number = |key: &str, value: &str| {
                if key == "IntensityUnits" { 1.0 } else { value.parse().expect("a number") }
            };
            let values: Vec<_> = found.values.iter().map(|(key, value)| (*key, number(key, value))).collect();
            let exact = formula(tool.name());
            let throw = usage.throw / unit(tool.name());
            let full = irradiance(&lamp.light, 0.0, usage.throw);
            let on_axis = exact(&values, Kind::Spot, 0.0, throw);
            // The `max(0.001, ..)` that glTF recommends is in the formula alone.
            if tool != System::Gltf || on_axis > 0.99 * full {
                assert!((on_axis / full - 1.0).abs() < 1e-3, "{from} to {tool}: {on_axis} for {full}");
            }
            for _ in 0..32 {
                let angle = rng.f64() * std::f64::consts::FRAC_PI_2;
                let own = |angle: f64| exact(&values, Kind::Spot, angle, throw);
                let original = irradiance(&lamp.light, angle, usage.throw);
                let near = [angle - 2e-6, angle, angle + 2e-6]
                    .map(|angle| 255.0 * (own(angle) - original).abs() / full);
                let difference = near.into_iter().fold(f64::INFINITY, f64::min);
                assert!(
                    difference <= found.angle.bound + 0.1,
                    "{from} to {tool}: {difference} of {:?} at {angle}",
                    found.angle
                );
            }
        }
    }
}
