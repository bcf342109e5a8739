//! Stated bounds at the ends of lights, limits to which numbers are rounded, and lights that are none.

mod formulas;

use fastrand::Rng;
use formulas::{FORMULAS, Kind};
use luminaire::falloff::{AnyFalloff, Knot, Table};
use luminaire::{Angle, Cone, SpotLight, dynamic::AnyLight};
use luminaire_exchange::{Curve, Lamp, Reading, System, Use, fits, numbers, parameters, read, share, write};

/// A light of a table of lines between places and values in 65,536ths, that ends at a full angle.
fn light(points: &[(u32, u16)], outer: f32) -> Lamp {
    let knot = |pair: &[(u32, u16)]| Knot::line([pair[0].0, pair[1].0], [pair[0].1, pair[1].1]);
    let table = Table::from_knots(points.windows(2).map(knot).collect::<Vec<_>>().leak()).expect("knots");
    let cone = Cone::from_outer(AnyFalloff::from(table), Angle::degrees(outer)).expect("an angle");
    Lamp::new("table", SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone).expect("a light"))
}

/// Lines that rise to their closed end, between drawn places.
fn rising(rng: &mut Rng) -> Vec<(u32, u16)> {
    let mut places: Vec<_> = (0..rng.usize(0..6)).map(|_| rng.u32(1..65_536)).chain([0, 65_536]).collect();
    places.sort_unstable();
    places.dedup();
    let mut points: Vec<_> = places.into_iter().map(|place| (place, rng.u16(..))).collect();
    points.last_mut().expect("a point").1 = u16::MAX - rng.u16(0..2) * rng.u16(0..30_000);
    points
}

/// The parameters of every tool, and the cones of a fit, differ from a light with a step at its end by no
/// more than they state.
#[test]
fn bound_holds_for_lights_that_are_bright_at_their_end() {
    let mut rng = Rng::with_seed(5);
    let mut lamps = vec![light(&[(0, 0), (65_536, u16::MAX)], 180.0)];
    let count = if std::env::var_os("LUMINAIRE_FULL").is_some() { 100 } else { 5 };
    lamps.extend((0..count).map(|_| light(&rising(&mut rng), 20.0 + 160.0 * rng.f32())));
    for end in [90.0, 60.0] {
        let angles = (0..=10).map(|i| (f64::from(i) * end / 10.0, 1_000.0 * rng.f64()));
        let curve =
            Curve::new(angles.chain([(end * 1.000_1, 900.0)]).filter(|point| point.0 <= 90.0).collect());
        let curve = curve.expect("a curve");
        for fit in fits(&curve, 0.0).expect("cones") {
            for i in 0..1_000 {
                let degrees = 89.99 * f64::from(i) / 999.0;
                let own = curve.at(degrees) / curve.peak().0;
                let found = 255.0 * (own - share(&fit.cone, degrees)).abs();
                assert!(found <= fit.residual.bound + 1e-6, "{}: {found} of {:?}", fit.name, fit.residual);
            }
        }
        let light = SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], fits(&curve, 0.0).expect("cones")[0].cone);
        lamps.push(Lamp { measured: Some(curve), ..Lamp::new("measured", light.expect("a light")) });
    }
    let usage = Use { throw: 4.0, full_scale: 1.0, is_photometric: false };
    for lamp in &lamps {
        let AnyLight::Spot(spot) = &lamp.light else { panic!("expected a spotlight") };
        let own = |degrees: f64| match &lamp.measured {
            Some(curve) => curve.at(degrees) / curve.peak().0,
            None => share(&spot.cone(), degrees),
        };
        for tool in System::writable() {
            let found = parameters(lamp, tool, usage).expect("a spotlight");
            let number = |text: &str| text.parse().unwrap_or(1.0);
            let values: Vec<_> = found.values.iter().map(|(key, value)| (*key, number(value))).collect();
            let formula = FORMULAS.iter().find(|row| row.0 == tool.name()).expect("a formula").1;
            let throw = if tool == System::Unreal { 400.0 } else { 4.0 };
            let shown = |degrees: f64| formula(&values, Kind::Spot, degrees.to_radians(), throw);
            let (axis, full) = (shown(0.0), found.angle.measured.max(1.0));
            for i in 0..1_000 {
                let degrees = 89.99 * f64::from(i) / 999.0;
                // The digits of the written angles move a step.
                let near = [-1e-4, 0.0, 1e-4].map(|by| (own(degrees) - shown(degrees + by) / axis).abs());
                let difference = 255.0 / full * near.into_iter().fold(f64::INFINITY, f64::min);
                assert!(
                    difference <= found.angle.bound + 0.2,
                    "{tool}: {difference} of {:?} at {degrees}",
                    found.angle
                );
            }
        }
    }
}

/// What is written as LM-63 is read again, whatever the rounding of its numbers; a step stays one.
#[test]
fn written_photometry_is_read_again() {
    let mut rng = Rng::with_seed(7);
    for round in 0..40 {
        let outer = if round == 0 { 180.0 } else { 180.0 * rng.f32() };
        let lamp = light(&rising(&mut rng), outer.max(1.0));
        let curve = lamp.curve().expect("a spotlight");
        let text = write::ies(&lamp).expect("a spotlight");
        let lamps = read("a.ies", text.as_bytes(), None, Reading { fit: 255.0, ..Reading::default() })
            .expect("a light")
            .lamps;
        let again = lamps[0].measured.as_ref().expect("intensities");
        assert_eq!(lamps.len(), 1, "{lamps:?}");
        assert!((again.lumens() / curve.lumens() - 1.0).abs() < 1e-3, "{round}: {again:?} of {curve:?}");
    }
    // A line whose end rounding would carry below 0, by many factors.
    for factor in 1..200 {
        let file = format!(
            "IES\nTILT=NONE\n1 -1 {} 3 1 1 2 0 0 0\n1 1 0\n0 60 90\n0\n1000 1 0\n",
            f64::from(factor) / 100.0
        );
        assert!(
            read("a.ies", file.as_bytes(), None, Reading { fit: 255.0, ..Reading::default() }).is_ok(),
            "{file}"
        );
    }
}

/// A number that was rounded across a limit, by a millionth of it, is that limit; more is refused.
#[test]
fn limits_that_writers_round_to_are_accepted() {
    const RIGHT: &str = "1.5707963267948966";
    const HALF_TURN: &str = "3.141592653589793";
    for (words, limit) in [
        ("gltf outerConeAngle=", RIGHT),
        ("gltf outerConeAngle=0.5 innerConeAngle=", "0.5"),
        ("three angle=", RIGHT),
        ("three penumbra=", "1"),
        ("three decay=", "16"),
        ("godot spot_angle=", "90"),
        ("godot spot_angle_attenuation=", "128"),
        ("godot spot_attenuation=", "16"),
        ("opengl spot_cutoff=", "90"),
        ("opengl spot_cutoff=", "180"),
        ("opengl spot_cutoff=40 spot_exponent=", "1024"),
        ("direct3d attenuation0=1 phi=", HALF_TURN),
        ("direct3d attenuation0=1 phi=1 theta=", "1"),
        ("direct3d attenuation0=1 phi=1 falloff=", "1024"),
        ("blender spot_size=", HALF_TURN),
        ("blender spot_blend=", "1"),
        ("usd shaping:cone:angle=", "90"),
        ("usd shaping:cone:angle=40 shaping:cone:softness=", "1"),
        ("x3d cutOffAngle=", RIGHT),
        ("pbrt coneangle=", "90"),
        ("pbrt coneangle=30 conedeltaangle=", "30"),
        ("unreal OuterConeAngle=", "90"),
        ("unreal OuterConeAngle=80 InnerConeAngle=", "89"),
        ("unity spotAngle=", "180"),
        ("unity innerSpotAngle=", "180"),
        ("bevy outer_angle=", RIGHT),
        ("bevy inner_angle=", HALF_TURN),
        ("babylon angle=", HALF_TURN),
    ] {
        let (tool, key) = words.split_once(' ').expect("a tool");
        let number: f64 = limit.parse().expect("a number");
        let [at, near, over] = [1.0, 1.0 + 0.9e-6, 1.0 + 1e-5].map(|by| {
            let words = format!("{key}{}", by * number);
            numbers(tool.parse().expect("a tool"), [&*words]).map(|lamps| lamps.lamps[0].light)
        });
        assert!(at.is_ok() && near == at && over.is_err(), "{words}{limit}: {at:?}, {near:?}, {over:?}");
    }
    // Written by this crate: six digits of pi.
    let lamp = numbers(System::Direct3d, ["phi=3.141593 attenuation0=1"]).expect("a light").lamps.remove(0);
    let AnyLight::Spot(spot) = &lamp.light else { panic!("expected a spotlight") };
    assert_eq!(spot.cone().outer().to_degrees(), 180.0);
    // Angles that differ in f64 alone leave nothing for a falloff.
    assert!(numbers(System::X3d, ["beamWidth=0.785398163 cutOffAngle=0.785398164"]).is_ok());
}

/// A light that takes light away is refused in every tool.
#[test]
fn negative_light_is_refused() {
    for words in [
        "gltf intensity",
        "three intensity",
        "godot light_energy",
        "opengl intensity",
        "direct3d attenuation0=1 phi=1 intensity",
        "blender energy",
        "usd shaping:cone:angle=40 intensity",
        "x3d intensity",
        "pbrt scale",
        "pbrt I",
        "unreal Intensity",
        "unity intensity",
        "bevy intensity",
        "babylon intensity",
        "godot kind=directional light_energy",
        "usd kind=point color",
    ] {
        let (tool, key) = words.split_once(' ').expect("a tool");
        let found = numbers(tool.parse().expect("a tool"), [&*format!("{key}=-1")]);
        assert!(found.is_err(), "{words}=-1: {found:?}");
    }
}

/// A file without a light is refused, with what is known of the reasons.
#[test]
fn file_without_a_light_is_refused_with_the_reasons() {
    for (name, file, expected) in [
        ("a.pbrt", "Shape \"sphere\"", "lights = none: expected at least one light"),
        (
            "a.tscn",
            "[node name=\"a\" type=\"OmniLight3D\"]\nvisible = false",
            "; lights that are off or hidden are left out: 1",
        ),
        ("a.json", r#"{"format":"luminaire-lights-1","lights":[]}"#, "lights = none"),
        (
            "a.json",
            r#"{"metadata":{"type":"Object"},"object":{"name":"sky","type":"HemisphereLight"}}"#,
            "; sky is left out: HemisphereLight",
        ),
    ] {
        let found = read(name, file.as_bytes(), None, Reading::default()).expect_err(file).to_string();
        assert!(found.contains(expected), "{found}: expected {expected}");
    }
}
