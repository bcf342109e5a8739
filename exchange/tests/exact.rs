//! The tools whose formulas the kernel has: densely over the angle and over the distance, and with exponents whose
//! slope at the edge has no bound.

mod formulas;

use formulas::{FORMULAS, Kind};
use luminaire::attenuation::{AnyAttenuation, Attenuation};
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Falloff};
use luminaire::{SpotLight, Vec3};
use luminaire_exchange::{Difference, numbers};

type Values = Vec<(&'static str, f64)>;

/// A light as its tool has it, and as the kernel has it.
struct Pair {
    name: String,
    tool: &'static str,
    values: Values,
    light: SpotLight<AnyFalloff, AnyAttenuation>,
    difference: Difference,
    /// The cosines of the half angles between which the falloff is.
    ends: [f64; 2],
}

/// Numbers that f32 has, as the kernel stores most of them.
fn pair(tool: &'static str, values: &[(&'static str, f32)]) -> Pair {
    let values: Values = values.iter().map(|&(key, value)| (key, f64::from(value))).collect();
    let words: Vec<_> = values.iter().map(|(key, value)| format!("{key}={value}")).collect();
    let name = format!("{tool} {}", words.join(" "));
    let lamps = numbers(tool.parse().expect("a tool"), words.iter().map(String::as_str));
    let lamp = lamps.unwrap_or_else(|refusal| panic!("{name}: {refusal}")).lamps.remove(0);
    let AnyLight::Spot(light) = lamp.light else { panic!("{name}: expected a spotlight") };
    let of = |key: &str| values.iter().find(|value| value.0 == key).map_or(0.0, |value| value.1);
    let halves = match tool {
        "opengl" => [0.0, std::f64::consts::FRAC_PI_2],
        "direct3d" => [of("theta") / 2.0, of("phi") / 2.0],
        "gltf" => [of("innerConeAngle"), of("outerConeAngle")],
        "three" => [of("angle") * (1.0 - of("penumbra")), of("angle")],
        _ => [0.0, of("spot_angle").to_radians()],
    };
    Pair { name, tool, light, difference: lamp.difference, ends: halves.map(f64::cos), values }
}

impl Pair {
    /// The light of the tool.
    fn original(&self, angle: f64, distance: f64) -> f64 {
        let formula = FORMULAS.iter().find(|row| row.0 == self.tool).expect("a formula").1;
        formula(&self.values, Kind::Spot, angle, distance)
    }

    fn value(&self, key: &str) -> Option<f64> {
        self.values.iter().find(|value| value.0 == key).map(|value| value.1)
    }

    fn range(&self) -> Option<f64> {
        ["range", "distance", "spot_range"]
            .iter()
            .find_map(|key| self.value(key))
            .filter(|r| *r > 0.0 && *r <= 1e9)
    }

    /// The distance below which the original stops growing.
    fn stop(&self) -> f64 {
        match (self.tool, self.value("decay")) {
            ("godot", _) => 1e-4,
            ("three", Some(decay)) if decay > 0.0 => 0.01_f64.powf(1.0 / decay),
            ("three", None) => 0.1,
            ("opengl" | "direct3d", _) => 1e-3,
            _ => 0.0,
        }
    }

    /// What Godot shows on the axis.
    fn on_axis(&self) -> f64 {
        let power = |attenuation: f64| f64::from(1.0 / attenuation as f32);
        self.value("spot_angle_attenuation")
            .map_or(1.0, |attenuation| 1.0 - 1e-4_f64.powf(power(attenuation)))
    }

    /// The part of it that is in the intensity of the kernel's light.
    fn held(&self) -> f64 {
        let is_real = matches!(self.light.cone().falloff(), AnyFalloff::InvertedRealPower(_));
        if is_real { self.on_axis() } else { 1.0 }
    }

    fn is_step(&self) -> bool {
        self.ends[0] <= self.ends[1] || matches!(self.light.cone().falloff(), AnyFalloff::Step(_))
    }

    /// The falloff of the tool at a cosine, relative to full intensity.
    fn falloff(&self, cosine: f64) -> f64 {
        let (angle, distance) = (cosine.min(1.0).acos(), self.range().map_or(1.0, |range| range / 4.0));
        self.original(angle, distance) / self.original(0.0, distance) * self.on_axis()
    }

    /// The largest difference over the angle, relative to the original on the axis. `t` goes from 1 in the middle of
    /// the ramp to 2^-24 at its edge, and with OpenGL only as far as the cutoff.
    fn over_the_angle(&self) -> f64 {
        let [inner, outer] = self.ends;
        let edge = self.value("spot_cutoff").map_or(outer, |cutoff| cutoff.to_radians().cos());
        let least = ((edge - outer) / (inner - outer)).max(0.5_f64.powi(24));
        places(5_000)
            .map(|place| {
                let t = least + (1.0 - least) * place;
                // Slightly inside the jumps, because f64 cannot decide on which side of a jump an angle is.
                let cosine = outer + t * (inner - outer) + if place == 0.0 { 1e-15 } else { 0.0 };
                let exact = self.falloff(cosine) / self.held();
                (self.light.cone().falloff().formula().exact(t) - exact).abs()
            })
            .fold(0.0, f64::max)
    }

    /// The light of the kernel on the axis.
    fn found(&self, distance: f64) -> f64 {
        f64::from(self.light.intensity()) * self.light.attenuation().exact(distance) / self.held()
    }

    /// The largest relative difference between two distances.
    fn over_the_distance(&self, [start, end]: [f64; 2]) -> f64 {
        (0..5_000)
            .map(|i| {
                let d = start * (end / start).powf(f64::from(i) / 5_000.0);
                let (found, exact) = (self.found(d), self.original(0.0, d) / self.on_axis());
                (found - exact).abs() / exact.max(found)
            })
            .fold(0.0, f64::max)
    }

    /// The distances that a difference compares.
    fn compared(&self) -> [f64; 2] {
        let end = self.range().unwrap_or(16.0);
        [self.stop().max(end / 16.0), end]
    }
}

/// Numbers from 0 to 1, denser at both ends.
fn places(count: u32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| {
        let place = f64::from(i) / f64::from(count);
        let (near, far) = (place.powi(4), (1.0 - place).powi(4));
        near / (near + far)
    })
}

fn opengl(cutoff: f32, exponent: f32, [constant, linear, quadratic]: [f32; 3]) -> Pair {
    pair(
        "opengl",
        &[
            ("spot_cutoff", cutoff),
            ("spot_exponent", exponent),
            ("constant_attenuation", constant),
            ("linear_attenuation", linear),
            ("quadratic_attenuation", quadratic),
        ],
    )
}

fn direct3d(theta: f32, phi: f32, falloff: f32, [a0, a1, a2]: [f32; 3], range: f32) -> Pair {
    pair(
        "direct3d",
        &[
            ("theta", theta),
            ("phi", phi),
            ("falloff", falloff),
            ("attenuation0", a0),
            ("attenuation1", a1),
            ("attenuation2", a2),
            ("range", range),
        ],
    )
}

fn gltf(inner: f32, outer: f32, range: f32) -> Pair {
    let values = [("innerConeAngle", inner), ("outerConeAngle", outer), ("range", range)];
    pair("gltf", &values[..if range == 0.0 { 2 } else { 3 }])
}

fn three(angle: f32, penumbra: f32, distance: f32, decay: f32) -> Pair {
    pair("three", &[("angle", angle), ("penumbra", penumbra), ("distance", distance), ("decay", decay)])
}

fn godot(angle: f32, angle_attenuation: f32, range: f32, attenuation: f32) -> Pair {
    let cone = [("spot_angle", angle), ("spot_angle_attenuation", angle_attenuation)];
    pair("godot", &[cone, [("spot_range", range), ("spot_attenuation", attenuation)]].concat())
}

const PLAIN: [f32; 3] = [1.0, 0.0, 0.0];

const EXPONENTS: [f32; 16] =
    [0.02, 0.1, 0.2, 0.25, 0.333_333_34, 0.5, 0.75, 0.9, 1.1, 1.5, 2.5, 3.5, 7.5, 12.5, 31.5, 127.5];

/// Lights whose formulas the kernel has.
fn exact() -> Vec<Pair> {
    let mut lights: Vec<_> = (0..=128_u8).map(|exponent| opengl(35.0, exponent.into(), PLAIN)).collect();
    lights.extend([
        opengl(60.0, 3.0, [0.2, 0.3, 0.4]),
        opengl(20.0, 0.0, [0.0, 0.0, 2.0]),
        opengl(45.0, 2.0, [0.0, 0.5, 0.25]),
        opengl(45.0, 2.0, [0.0, 3.0, 0.0]),
        opengl(90.0, 0.0, [4.0, 0.0, 0.0]),
        direct3d(0.3, 0.9, 1.0, PLAIN, 20.0),
        direct3d(0.0, 3.1, 2.0, [1.0, 0.5, 0.1], 4.0),
        direct3d(0.3, 0.9, 5.0, [0.0, 0.0, 1.0], 1.8e19),
        direct3d(0.3, 0.9, 0.0, PLAIN, 6.0),
        direct3d(0.9, 0.9, 1.5, PLAIN, 6.0),
        direct3d(0.9, 0.9, 0.0, [0.0, 1.0, 0.0], 1e9),
        gltf(0.0, 0.785, 0.0),
        gltf(0.3, 0.5, 7.0),
        gltf(0.5, 0.5, 0.0),
        gltf(1.2, 1.57, 3.0),
        three(1.0, 0.0, 0.0, 2.0),
        three(0.7, 0.4, 6.0, 2.0),
        three(0.7, 1.0, 6.0, 0.0),
        three(1.57, 0.5, 6.0, 1.0),
        three(0.4, 0.3, 0.0, 1.0),
        three(0.4, 0.3, 0.0, 0.0),
    ]);
    for exponent in EXPONENTS {
        lights.push(opengl(90.0, exponent, PLAIN));
        lights.push(opengl(30.0, exponent, PLAIN));
        lights.push(direct3d(0.3, 0.9, exponent, PLAIN, 20.0));
        lights.push(godot(30.0, 1.0 / exponent, 8.0, 2.0));
    }
    lights.extend([0.125, 1.5, 2.0, 3.0, 4.0, 20.0, 128.0].map(|angle| godot(45.0, angle, 5.0, 2.0)));
    // Every combination of coefficients that are zero.
    for some in 1..8_u8 {
        let coefficients = [0, 1, 2].map(|i| if some >> i & 1 == 1 { [1.0, 0.25, 0.5][i] } else { 0.0 });
        lights.push(opengl(90.0, 1.0, coefficients));
        lights.push(direct3d(0.3, 0.9, 1.0, coefficients, 20.0));
    }
    lights
}

/// Lights whose integer power loses Godot's `max`, and decays.
fn near() -> Vec<Pair> {
    let mut lights: Vec<_> = [0.25, 0.5, 1.0].map(|angle| godot(45.0, angle, 5.0, 2.0)).into();
    for decay in [0.1, 0.5, 0.9, 1.0, 1.1, 1.5, 1.9, 2.2, 3.0, 8.0, 16.0] {
        lights.push(godot(45.0, 1.0, 8.0, decay));
        lights.extend([8.0, 0.0, 200.0].map(|distance| three(0.6, 0.3, distance, decay)));
    }
    lights
}

#[test]
fn what_the_kernel_has_is_exact() {
    for own in exact() {
        // An eighth power of Godot's least part of the versine, 1e-4, is not lost by an integer exponent.
        let Difference { angle, distance, .. } = own.difference;
        assert!(angle < 1e-30 && distance == 0.0, "{}: {angle:e} and {distance:e}, expected 0", own.name);
        if !own.is_step() {
            // Where a root is steep, the original formula itself loses digits by cancellation.
            let is_real = matches!(
                own.light.cone().falloff(),
                AnyFalloff::RealPower(_) | AnyFalloff::InvertedRealPower(_)
            );
            let (angle, most) = (own.over_the_angle(), if is_real { 1e-8 } else { 1e-12 });
            assert!(angle < most, "{}: {angle:.1e} over the angle, expected below {most:e}", own.name);
        }
        let distance = own.over_the_distance([own.stop().max(1e-4), own.range().unwrap_or(32_767.0)]);
        // Coefficients are rounded to f32 when they are scaled.
        assert!(distance < 2e-7, "{}: {distance:.1e} over the distance, expected below 2e-7", own.name);
    }
}

/// The stated difference is not smaller than the largest difference, and at most 2 % larger: at most 1/510 over the
/// angle, half a code.
#[test]
fn a_difference_is_what_a_dense_search_finds() {
    for own in near() {
        // Differences under 1e-7 over the distance are only the rounding of coefficients.
        for (found, stated, rounding) in [
            (own.over_the_angle(), own.difference.angle, 1e-8),
            (own.over_the_distance(own.compared()), own.difference.distance, 1e-7),
        ] {
            let stated = f64::from(stated);
            let holds = stated >= found - rounding && stated <= 1.02 * found + rounding;
            assert!(holds, "{}: {found:.5e} is stated as {stated:.5e}", own.name);
        }
        assert!(own.difference.angle <= 1.0 / 510.0, "{}: {:?}", own.name, own.difference);
    }
}

/// The slope is infinite exactly where the light states it. The slope counts as infinite if more than 1.1 % of the
/// original's rise over the last ten-thousandth of the angle is in the last hundredth of that strip.
#[test]
fn a_difference_of_the_place_is_a_boundless_slope() {
    let mut boundless = 0;
    for own in exact() {
        let end = own.value("spot_cutoff").map_or(own.ends[1].acos(), f64::to_radians);
        let at = |within: f64| own.falloff((end * (1.0 - within)).cos());
        let [edge, near, far] = [1e-10, 1e-6, 1e-4].map(at);
        let is_boundless = !own.is_step() && near - edge > 0.011 * (far - edge);
        assert_eq!(own.difference.place > 0.0, is_boundless, "{}: {edge:e} {near:e} {far:e}", own.name);
        boundless += u32::from(is_boundless);
    }
    assert!(boundless >= 16, "only {boundless} lights have a boundless slope");
}

/// Without a constant coefficient the light grows without a bound towards itself: nearer than 0.001 it is that of
/// 0.001.
#[test]
fn a_polynomial_without_a_constant_stops_growing() {
    for [linear, quadratic] in [[1.0, 1_000.0], [2.0, 0.0], [0.5, 4.0e5]] {
        let own = opengl(30.0, 1.0, [0.0, linear, quadratic]);
        assert!(matches!(own.light.attenuation(), AnyAttenuation::Polynomial(_)));
        let stopped = 1.0 / f64::from(1e-3 * (linear + 1e-3 * quadratic));
        for distance in [0.0, 0.000_9, 0.001_1, 2.0] {
            let (found, exact) = (own.found(distance), own.original(0.0, distance).min(stopped));
            assert!(
                (found / exact - 1.0).abs() < 1e-6,
                "{}: {found} at {distance}, expected {exact}",
                own.name
            );
        }
    }
    assert!(matches!(
        opengl(30.0, 1.0, [0.0, 0.0, 2.0]).light.attenuation(),
        AnyAttenuation::InverseSquare(_)
    ));
    // A constant is the light at the light itself.
    assert_eq!(opengl(30.0, 1.0, [0.25, 3.0, 4.0]).found(0.0), 4.0);
    // A constant so small that the others would exceed 1e9 in units of it.
    assert!((opengl(30.0, 1.0, [1e-6, 0.0, 1e4]).found(1.0) * 1e4 - 1.0).abs() < 1e-6);
}

/// Near to the light a decay stops growing where the original does: also one of so small an exponent that three.js
/// stops at a distance of 0.
#[test]
fn a_decay_stops_growing_where_its_original_does() {
    let mut lights = vec![three(0.6, 0.3, 8.0, 0.001), three(0.6, 0.3, 8.0, 1e-30)];
    for decay in [1.1, 1.5, 1.9, 3.0] {
        lights.extend([three(0.6, 0.3, 8.0, decay), godot(45.0, 2.0, 8.0, decay.min(1.9))]);
    }
    for own in lights {
        let (found, exact) = (own.found(1e-30), own.original(0.0, 1e-30) / own.on_axis());
        assert!((found / exact - 1.0).abs() < 1e-5, "{}: {found} at the light, expected {exact}", own.name);
    }
}

/// Godot's factor exceeds 2^64 next to a light with a steep decay and a short range.
#[test]
fn the_difference_of_a_very_bright_light_is_that_of_its_cap() {
    for (decay, range) in [(5.0, 0.002), (5.5, 0.003), (16.0, 0.01)] {
        let own = godot(45.0, 0.5, range, decay);
        let (found, stated) = (own.over_the_distance(own.compared()), f64::from(own.difference.distance));
        let holds = found > 0.01 && stated >= found - 1e-6 && stated <= 1.02 * found + 1e-6;
        assert!(holds, "{}: {found:.5e} is stated as {stated:.5e}", own.name);
    }
}

/// A light of OpenGL with a cutoff of 180 degrees shines in all directions, whatever its exponent.
#[test]
fn a_cutoff_of_half_a_turn_is_a_point_light() {
    let lamps = numbers("opengl".parse().expect("a tool"), ["spot_exponent=7", "linear_attenuation=0.5"]);
    let lamp = lamps.expect("a light").lamps.remove(0);
    let AnyLight::Point(point) = lamp.light else { panic!("{lamp:?}") };
    assert_eq!(lamp.difference, Difference::default());
    let lit = point.compile::<f32>().expect("held");
    for (x, expected) in [(2.0, 0.5), (-8.0, 0.2)] {
        let normal = Vec3::new(-x / f32::abs(x), 0.0, 0.0);
        let light = lit.irradiance(Vec3::new(x, 0.0, 0.0), normal);
        assert!((light - expected).abs() < 1e-6, "{light}, expected {expected}");
    }
}

/// A light without numbers is the tool's own: of UsdLux a sphere of radius 0.5 without shaping, and of Direct3D the
/// white directional light that `LightEnable` makes. A cone makes a spotlight of either.
#[test]
fn a_light_without_numbers_is_that_of_the_tool() {
    let light = |tool: &str, words: &[&str]| {
        numbers(tool.parse().expect("a tool"), words.iter().copied()).expect(tool).lamps.remove(0).light
    };
    let usd = light("usd", &[]);
    assert!(matches!(usd, AnyLight::Point(_)), "{usd:?}");
    assert!((f64::from(usd.intensity()) - std::f64::consts::PI / 4.0).abs() < 1e-6, "{usd:?}");
    assert_eq!(light("usd", &["kind=spot"]), usd);
    let direct3d = light("direct3d", &[]);
    assert!(matches!(direct3d, AnyLight::Directional(_)) && direct3d.intensity() == 1.0, "{direct3d:?}");
    for (tool, words) in [
        ("usd", &["shaping:cone:angle=90"][..]),
        ("usd", &["shaping:focus=2"]),
        ("usd", &["disk=1"]),
        ("direct3d", &["phi=1", "attenuation0=1"]),
    ] {
        assert!(matches!(light(tool, words), AnyLight::Spot(_)), "{tool} {words:?}");
    }
}

/// A tool refuses a number by its own name, with what it takes.
#[test]
fn numbers_are_refused_by_the_names_of_their_tools() {
    for (tool, words, message) in [
        (
            "opengl",
            "spot_cutoff=120",
            "spot_cutoff = 120: expected over 0 and at most 90 degrees (half angle), or 180",
        ),
        ("opengl", "spot_exponent=-1", "spot_exponent = -1: expected a number from 0 to 1024"),
        (
            "opengl",
            "linear_attenuation=-1",
            "linear_attenuation = -1: expected a number from 0 to 1000000000",
        ),
        (
            "opengl",
            "constant_attenuation=0",
            "constant_attenuation, linear_attenuation, quadratic_attenuation = 0, 0, 0",
        ),
        ("opengl", "intensity=-1", "intensity = -1: expected a finite number from 0 to 1000000000"),
        (
            "direct3d",
            "phi=3.2 attenuation0=1",
            "phi = 3.2: expected over 0 and at most 3.141593 radians (full angle)",
        ),
        ("direct3d", "kind=spot", "attenuation0, attenuation1, attenuation2 = 0, 0, 0"),
        ("direct3d", "range=9", "attenuation0, attenuation1, attenuation2 = 0, 0, 0"),
        ("usd", "shaping:cone:angle=120", "shaping:cone:angle = 120: expected over 0 and at most 90 degrees"),
        ("direct3d", "phi=0 attenuation0=1", "phi = 0: expected the full outer angle in radians"),
        ("direct3d", "phi=0.6 theta=0.7 attenuation0=1", "theta = 0.7: expected a number from 0 to 0.6"),
        ("direct3d", "phi=0.6 falloff=-1 attenuation0=1", "falloff = -1: expected a number from 0 to 1024"),
        (
            "direct3d",
            "phi=0.6 range=0 attenuation0=1",
            "range = 0: expected a distance from 0.001 to 1000000000",
        ),
        (
            "gltf",
            "outerConeAngle=1.6",
            "outerConeAngle = 1.6: expected over 0 and at most 1.570796 radians (half angle)",
        ),
        ("gltf", "innerConeAngle=0.8", "innerConeAngle = 0.8: expected a number from 0 to 0.785"),
        ("gltf", "range=0", "range = 0: expected a distance from 0.001 to 1000000000"),
        ("three", "penumbra=1.5", "penumbra = 1.5: expected a number from 0 to 1"),
        ("three", "decay=-1", "decay = -1: expected a number from 0 to 16"),
        ("three", "distance=-3", "distance = -3: expected a number from 0 to 1000000000"),
        ("godot", "spot_angle=120", "spot_angle = 120: expected over 0 and at most 90 degrees (half angle)"),
        (
            "godot",
            "spot_angle_attenuation=0",
            "spot_angle_attenuation = 0: expected a number from 0.0078125 to 128",
        ),
        ("godot", "light_energy=-1", "light_energy = -1: expected a number from 0 to 1000000000"),
    ] {
        let refused = numbers(tool.parse().expect("a tool"), [words]).expect_err(message).to_string();
        assert!(refused.starts_with(message), "{tool}: {refused}, expected {message}");
    }
}
