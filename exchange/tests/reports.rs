//! Faults that other projects had, each beside what is read here, and the real lights.

use std::fs;
use std::path::Path;

use luminaire::attenuation::Attenuation;
use luminaire::dynamic::AnyLight;
use luminaire_exchange::{
    Curve, Definition, Lamp, Reading, Sheet, System, Use, numbers, parameters, read, share,
};

fn of(system: System, words: &str) -> Lamp {
    numbers(system, [words]).expect("a light").lamps.remove(0)
}

/// The irradiance on a surface that faces a spotlight.
fn lit(lamp: &Lamp, half_degrees: f64, distance: f64) -> f64 {
    let AnyLight::Spot(spot) = &lamp.light else { panic!("{}: expected a spotlight", lamp.name) };
    f64::from(spot.intensity()) * share(&spot.cone(), half_degrees) * spot.attenuation().exact(distance)
}

fn is_near(found: f64, expected: f64, relative: f64) {
    assert!((found / expected - 1.0).abs() <= relative, "{found}: expected {expected}");
}

/// three.js 34554 and Babylon.js 15949 squared the candela: a half beam of 15.5 degrees in place of 20.
#[test]
fn candela_of_a_photometric_file_is_not_squared() {
    let file =
        "IESNA:LM-63-2002\nTILT=NONE\n1 -1 2 5 1 1 2 0 0 0\n1 1 0\n0 10 20 30 40\n0\n1000 900 500 100 0\n";
    let lamp = read("spot.ies", file.as_bytes(), None, Reading::default()).expect("a light").lamps.remove(0);
    let curve = lamp.measured.expect("intensities");
    assert_eq!(curve.at(10.0), 1_800.0);
    let angle = |share| curve.angle(share, Definition::Ies).expect("light");
    assert_eq!([angle(0.5), angle(0.1)], [40.0, 60.0]);
    let squared = 10.0 + 10.0 * (0.81 - 0.5) / (0.81 - 0.25);
    assert!(angle(0.5) - 2.0 * squared > 8.9);
    is_near(f64::from(lamp.light.intensity()), 2_000.0, 1e-6);
}

/// Light over 90 degrees off the axis is a second light along the opposite axis, and none is lost.
#[test]
fn upward_light_is_a_light_of_its_own() {
    let file =
        "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 5 1 1 2 0 0 0\n1 1 0\n0 45 90 135 180\n0\n1000 500 0 100 400\n";
    let lamps = read("pendant.ies", file.as_bytes(), None, Reading::default()).expect("lights").lamps;
    let axes = lamps.iter().map(|lamp| match &lamp.light {
        AnyLight::Spot(spot) => (spot.axis().y, spot.intensity()),
        _ => panic!("{}: expected a spotlight", lamp.name),
    });
    assert_eq!(axes.collect::<Vec<_>>(), [(-1.0, 1_000.0), (1.0, 400.0)]);
    assert!((lit(&lamps[1], 45.0, 1.0) / 100.0 - 1.0).abs() < 0.02);
    let points = vec![(0.0, 1_000.0), (45.0, 500.0), (90.0, 0.0), (135.0, 100.0), (180.0, 400.0)];
    let flux = |lamp: &Lamp| lamp.measured.as_ref().expect("intensities").lumens();
    let whole = Curve::new(points).expect("a curve").lumens();
    is_near(lamps.iter().map(flux).sum::<f64>(), whole, 1e-12);
}

/// QLC+ 2077: lumens over a level cone; the falloff of a real one makes its peak three times as bright.
#[test]
fn lumens_are_those_of_the_falloff_not_of_a_level_cone() {
    let lamp = of(System::Unreal, "OuterConeAngle=20 Intensity=10000 IntensityUnits=Lumens");
    let AnyLight::Spot(spot) = &lamp.light else { panic!("a spotlight") };
    is_near(f64::from(spot.intensity()), 26_390.6, 1e-5);
    is_near(f64::from(spot.cone().candela(10_000.0)), 79_171.9, 1e-5);
    let sheet = Sheet { lumens: Some(10_000.0), field: Some(30.0), ..Sheet::default() };
    let AnyLight::Spot(spot) = sheet.lamp().expect("a light").light else { panic!("a spotlight") };
    is_near(f64::from(spot.cone().lumens(spot.intensity())), 10_000.0, 1e-4);
}

/// Open Fixture Library 3701: the field angle as beam angle makes the light 2.5 times too dark, and a note
/// says so.
#[test]
fn beam_for_field_is_told_with_its_factor() {
    let sheet = |beam| Sheet { beam: Some(beam), lumens: Some(1_000.0), ..Sheet::default() };
    let [right, wrong] = [30.0, 48.0].map(|beam| sheet(beam).lamp().expect("a light"));
    is_near(f64::from(right.light.intensity() / wrong.light.intensity()), 2.537, 1e-3);
    let zoom = br#"{"name":"Zoom","categories":["Moving Head"],"physical":{"bulb":{"lumens":1000},"lens":{"degreesMinMax":[8,30]}},"modes":[]}"#;
    let lamps = read("zoom.json", zoom, Some(System::Ofl), Reading::default()).expect("a fixture").lamps;
    assert_eq!(lamps.len(), 2, "the narrowest and the widest");
    assert!(
        lamps[0].notes.iter().any(|note| note.contains("if 8 degrees is the field angle")),
        "{:?}",
        lamps[0].notes
    );
}

/// glTF-Blender-IO 2493: 200 W are 15.9 W/sr in Blender and 10,870 cd in its glTF; the cone of Blender is
/// in the versine, that of its exporter in the angle.
#[test]
fn watts_of_blender_keep_their_factor_and_their_cone() {
    let lamp = of(System::Blender, "energy=200 spot_size=1.0471976 spot_blend=0.5");
    is_near(lit(&lamp, 0.0, 1.0), 15.915_494, 1e-6);
    let AnyLight::Spot(spot) = &lamp.light else { panic!("a spotlight") };
    is_near(f64::from(spot.cone().inner().to_degrees()) / 2.0, 21.09, 1e-3);
    let gltf = of(System::Gltf, "intensity=10870.2826 outerConeAngle=0.5235988 innerConeAngle=0.2617994");
    let usage = Use { throw: 4.0, full_scale: 1.0, is_photometric: true };
    let back = parameters(&gltf, System::Blender, usage).expect("a spotlight");
    let energy = &back.values.iter().find(|value| value.0 == "energy").expect("an energy").1;
    is_near(energy.parse().expect("a number"), 200.0, 1e-5);
}

/// Godot 4046: the full angle of Blender is twice the half angle of Godot.
#[test]
fn full_angle_becomes_half_an_angle() {
    let lamp = of(System::Blender, "spot_size=1.0471976 spot_blend=1");
    let usage = Use { throw: 4.0, full_scale: 1.0, is_photometric: false };
    let found = parameters(&lamp, System::Three, usage).expect("a spotlight");
    let angle: f64 =
        found.values.iter().find(|value| value.0 == "angle").expect("an angle").1.parse().expect("a number");
    is_near(angle.to_degrees(), 30.0, 1e-3);
    let wrong = of(System::Godot, "spot_angle=60");
    assert!(lit(&wrong, 40.0, 1.0) > 0.5 && lit(&of(System::Godot, "spot_angle=30"), 40.0, 1.0) == 0.0);
}

/// The decays of three lights in public scenes of Godot, which a fit of whole powers made up to 76 % darker.
#[test]
fn fractional_decays_of_godot_are_exact() {
    let miner = of(
        System::Godot,
        "light_energy=2.3 spot_range=22 spot_angle=38 spot_angle_attenuation=0.8 spot_attenuation=1.4",
    );
    let bulb = of(
        System::Godot,
        "light_energy=4 spot_range=12 spot_angle=40 spot_angle_attenuation=1.8 spot_attenuation=1.4",
    );
    let stage = of(System::Godot, "light_energy=7.5 spot_range=30 spot_attenuation=0.6");
    // What the floor of Godot's cone leaves on the axis.
    let floor = |exponent: f64| 1.0 - 1e-4_f64.powf(exponent);
    for (distance, expected) in [
        (1.0, [2.299_980, 3.999_614, 7.499_981]),
        (5.0, [0.240_353, 0.395_293, 2.851_076]),
        (10.0, [0.083_914, 0.042_687, 1.837_686]),
    ] {
        for (lamp, (expected, exponent)) in
            [&miner, &bulb, &stage].into_iter().zip(expected.into_iter().zip([1.25, 1.0 / 1.8, 1.0]))
        {
            is_near(lit(lamp, 0.0, distance), expected * floor(exponent), 2e-4);
        }
    }
}

/// The channels of pbrt's `I` are the intensity and the colour, and the `False` of a file of Unreal is no
/// inverse square.
#[test]
fn values_of_files_reach_the_light() {
    let file = br#"LightSource "point" "rgb I" [4 2 1]"#;
    let light = read("a.pbrt", file, None, Reading::default()).expect("a light").lamps.remove(0).light;
    assert_eq!((light.intensity(), light.color().green, light.color().blue), (4.0, 0.5, 0.25));
    let file =
        b"Begin Object Class=PointLightComponent Name=\"a\"\nbUseInverseSquaredFalloff=False\nEnd Object";
    let lamps = read("a.t3d", file, None, Reading::default()).expect("a file");
    assert_eq!((lamps.lamps.len(), &*lamps.refused[0].parameter), (0, "bUseInverseSquaredFalloff"));
}

/// Every light of the folder of real lights is read, but two whose decay grows with the distance.
#[test]
fn real_lights_are_read() {
    let (mut lights, mut refused, mut systems) = (0, Vec::new(), Vec::new());
    for folder in ["real", "files"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(folder);
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("a file").path();
            let name = path.file_name().and_then(|name| name.to_str()).expect("a name").to_owned();
            if ["md", "xml"].iter().any(|own| name.ends_with(own))
                || name.starts_with("expected")
                || ["refused.txt", "bzip2.gdtf"].contains(&&*name)
            {
                continue;
            }
            let lamps = read(&name, &fs::read(&path).expect("a file"), None, Reading::default());
            let lamps = lamps.unwrap_or_else(|refusal| panic!("{name}: {refusal}"));
            let has_unread = |note: &String| {
                // The unit of a sun, which is always lux, and an ambient part.
                note.ends_with("has no effect")
                    && !note.starts_with("`intensityMode")
                    && !note.starts_with("`ambientIntensity")
            };
            assert!(!lamps.lamps.iter().flat_map(|lamp| &lamp.notes).any(has_unread), "{name}: {lamps:?}");
            if path.parent().is_some_and(|parent| parent.ends_with("real")) {
                lights += lamps.lamps.len();
                refused.extend(lamps.refused.iter().map(|refusal| format!("{name}: {refusal}")));
            }
            if !systems.contains(&lamps.system.name()) {
                systems.push(lamps.system.name());
            }
        }
    }
    println!("{lights} real lights; files of {systems:?}");
    assert!(lights >= 38 && systems.len() >= 13, "{lights} lights of {systems:?}");
    assert!(
        refused.len() == 2 && refused.iter().all(|refusal| refusal.contains("spot_attenuation = -2")),
        "{refused:?}"
    );
}
