//! Out and in again: each kind of light through each text that is written and read.

use luminaire::attenuation::{
    AnyAttenuation, Attenuation, CutAt, Decay, FilamentRange, InverseSquare, SmoothRange,
};
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Hard, Linear, Smooth, Soft, Step};
use luminaire::{Angle, Cone, DirectionalLight, PointLight, Rgb, SpotLight, Vec3};
use luminaire_exchange::{Lamp, Reading, Refusal, System, Use, parameters, read, read_beside, share, write};
use luminaire_export::{json, printable};

const USE: Use = Use { throw: 4.0, full_scale: 1.0, is_photometric: false };

/// A cone by its falloff and its full angles in degrees: outer, inner and cutoff, 0 for none.
fn spot(falloff: impl Into<AnyFalloff>, [outer, inner, cutoff]: [f32; 3]) -> AnyLight {
    let cone = Cone::from_outer(falloff.into(), Angle::degrees(outer)).expect("a cone");
    let cone = if inner > 0.0 { cone.with_inner(Angle::degrees(inner)).expect("a cone") } else { cone };
    let cone = if cutoff > 0.0 { cone.with_cutoff(Angle::degrees(cutoff)).expect("a cone") } else { cone };
    SpotLight::new([1.0, -2.5, 3.0], [0.25, -1.0, 0.5], cone).expect("a light").into()
}

fn with(light: AnyLight, attenuation: impl Into<AnyAttenuation>) -> AnyLight {
    match light {
        AnyLight::Spot(spot) => spot.with_attenuation(attenuation.into()).into(),
        AnyLight::Point(point) => point.with_attenuation(attenuation.into()).into(),
        AnyLight::Measured(light) => light.with_attenuation(attenuation.into()).into(),
        sun @ AnyLight::Directional(_) => sun,
    }
}

/// The kinds of lights, and the ends of what is a light.
fn lights() -> Vec<(&'static str, AnyLight)> {
    let point: AnyLight = PointLight::new([1.0, -2.5, 3.0]).expect("a light").into();
    let sun = DirectionalLight::new([0.25, -1.0, 0.5]).expect("a light").into();
    let window = |range| FilamentRange::new(InverseSquare, Some(range)).expect("a range");
    let cut = |range| CutAt::new(Decay::new(2.0, 1e9).expect("a decay"), Some(range)).expect("a range");
    vec![
        ("spot", spot(Smooth, [40.0, 0.0, 0.0])),
        ("hotspot", spot(Soft, [40.0, 20.0, 0.0])),
        ("hotspot and cutoff", spot(Hard, [16.0, 9.0, 14.5])),
        ("cutoff in the hotspot", spot(Soft, [40.0, 30.0, 20.0])),
        ("step", spot(Step, [30.0, 0.0, 0.0])),
        ("narrowest", spot(Soft, [0.01, 0.0, 0.0])),
        ("thread", spot(Soft, [0.0005, 0.0, 0.0])),
        ("dark", spot(Soft, [40.0, 0.0, 0.0])),
        ("a name\u{202e}\non two lines", spot(Hard, [40.0, 0.0, 0.0])),
        ("narrow hotspot", spot(Linear, [0.5, 0.49, 0.0])),
        ("widest", spot(Soft, [180.0, 0.0, 0.0])),
        ("widest step", spot(Step, [180.0, 0.0, 0.0])),
        ("range", with(spot(Soft, [40.0, 0.0, 0.0]), window(9.0))),
        ("short", with(spot(Soft, [40.0, 0.0, 0.0]), window(0.001))),
        ("long", with(spot(Soft, [40.0, 0.0, 0.0]), window(1e9))),
        ("smooth range", with(spot(Soft, [40.0, 0.0, 0.0]), SmoothRange::new(3.0).expect("a range"))),
        ("point", point),
        ("short point", with(point, window(2.0))),
        ("cut point", with(point, cut(9.0))),
        ("sun", sun),
    ]
}

/// Writes lamps in each text that holds several; a refusal is that of the text.
fn written(lamp: &Lamp, to: System) -> Result<(String, [f64; 2]), Refusal> {
    match to {
        System::Luminaire => {
            let named = lamp.named(USE)?;
            Ok((
                json::write(&json::Lights { lights: vec![named.clone(), named], ambient: Vec::new() })?,
                [0.0; 2],
            ))
        }
        System::Ies => Ok((write::ies(lamp)?, [1.0, 0.0])),
        tool => {
            let found = parameters(lamp, tool, USE.within(lamp))?;
            Ok((found.text(lamp).repeat(2), [found.angle.bound, found.distance]))
        }
    }
}

/// The light on a surface that faces the light; without a distance the intensity.
fn lit(light: &AnyLight, degrees: f64, distance: Option<f64>) -> f64 {
    let (angle, attenuation) = match light {
        AnyLight::Spot(spot) => (share(&spot.cone(), degrees), spot.attenuation()),
        AnyLight::Point(point) => (1.0, point.attenuation()),
        AnyLight::Measured(_) => unreachable!("no tool has one"),
        AnyLight::Directional(sun) => return sun.intensity().into(),
    };
    f64::from(light.intensity()) * angle * distance.map_or(1.0, |distance| attenuation.exact(distance))
}

/// Reads a text and returns what differs from the light of it.
fn differences(lamp: &Lamp, to: System, text: &str, [angle, far]: [f64; 2]) -> Result<(), String> {
    let (light, is_ies) = (&lamp.light, to == System::Ies);
    let file = match to {
        System::Luminaire => "lights.json",
        System::Ies => "lights.ies",
        _ => "lights.txt",
    };
    let back =
        read(file, text.as_bytes(), None, Reading::default()).map_err(|refusal| refusal.to_string())?;
    if !back.refused.is_empty() || back.lamps.len() != if is_ies { 1 } else { 2 } {
        return Err(format!("{} lights, {:?}", back.lamps.len(), back.refused));
    }
    for Lamp { name, light: own, .. } in &back.lamps {
        let told = match to {
            System::Luminaire => lamp.name.clone(),
            System::Ies => lamp.name.replace(['\u{202e}', '\n'], "?"),
            _ => printable(&lamp.name),
        };
        if (name, json::kind(own), own.color()) != (&told, json::kind(light), light.color()) {
            return Err(format!("{name}: {own:?}"));
        }
        if to == System::Luminaire && own != light || !is_ies && place(own) != place(light) {
            return Err(format!("{own:?}"));
        }
        // A file of IES has no law of the distance.
        let throw = (!is_ies).then_some(USE.within(lamp).throw);
        let full = lit(light, 0.0, throw).max(f64::MIN_POSITIVE);
        let off = |other: f64, found: f64| 255.0 * (found - other).abs() / full;
        for degrees in (0..=400).map(|i| f64::from(i) * end(light) * 1.1 / 400.0).filter(|at| *at <= 90.0) {
            // At an edge the place is right to the rounding of the angles.
            let near = [-3e-4, 0.0, 3e-4].map(|by: f64| lit(light, (degrees + by).max(0.0), throw));
            let off = near
                .map(|near| off(near, lit(own, degrees, throw)))
                .into_iter()
                .fold(f64::INFINITY, f64::min);
            if off > angle + 0.3 {
                return Err(format!("{off} of {angle} codes at {degrees} degrees"));
            }
        }
        let distances = throw.map(|throw| (0..=64).map(move |i| throw * 16_f64.powf(f64::from(i) / 64.0)));
        for d in distances.into_iter().flatten() {
            let off = off(lit(light, 0.0, Some(d)), lit(own, 0.0, Some(d)));
            if off > far + 0.5 {
                return Err(format!("{off} of {far} codes at {d}"));
            }
        }
    }
    Ok(())
}

/// Every light of a scene comes back with its name, its kind, its place and its colour, and with its light: within the
/// stated difference of its numbers, or by its profile within the 1 code of a fit. Two lights of one name have a profile
/// each, and one that is not there leaves the numbers beside it, or those of the other scene.
#[test]
fn scenes_bring_lights_back_by_their_profiles() {
    let mut lamps: Vec<_> = Vec::new();
    for (name, light) in lights().into_iter().filter(|(name, _)| *name != "thread") {
        let light = light
            .with_color(Rgb::new(1.0, 0.5, 0.25))
            .and_then(|light| light.with_specular_color(light.color()));
        let light = light.and_then(|light| light.with_intensity(if name == "dark" { 0.0 } else { 12.5 }));
        lamps.extend([Lamp::new(name, light.expect("a light")), Lamp::new(name, light.expect("a light"))]);
    }
    let measured = include_bytes!("files/spot.ies");
    lamps.push(read("spot.ies", measured, None, Reading::default()).expect("a light").lamps.remove(0));
    for (tool, count) in [(System::Usd, 23), (System::Gltf, 13)] {
        let entry = |lamp| {
            let usage = USE.within(lamp);
            let found = parameters(lamp, tool, usage).expect("parameters");
            write::Entry { lamp, found, usage, lines: Vec::new() }
        };
        let entries: Vec<_> = lamps.iter().map(entry).collect();
        let files = write::scene(tool, "a @%b", &entries).expect("a scene");
        assert_eq!(
            files.len(),
            1 + count,
            "{tool}: {:?}",
            files.iter().map(|file| &file.0).collect::<Vec<_>>()
        );
        let beside = |name: &str| {
            let file = files[1..].iter().find(|file| file.0 == name.trim_start_matches("./"));
            file.map(|file| file.1.clone().into_bytes()).ok_or_else(|| "none".to_owned())
        };
        let (name, text) = (&files[0].0, files[0].1.as_bytes());
        let back = read_beside(name, text, None, Reading::default(), &beside).expect("a scene");
        assert!(back.refused.is_empty() && back.lamps.len() == lamps.len(), "{tool}: {back:?}");
        for (entry, own) in entries.iter().zip(&back.lamps) {
            let (light, what) = (&entry.lamp.light, format!("{tool}: {}", entry.lamp.name));
            assert_eq!(own.name, printable(&entry.lamp.name));
            assert_eq!(
                (json::kind(&own.light), own.light.color()),
                (json::kind(light), light.color()),
                "{what}"
            );
            let apart = |(a, b): (Option<Vec3<f32>>, Option<Vec3<f32>>)| match (a, b) {
                (Some(a), Some(b)) => (a.x - b.x).abs().max((a.y - b.y).abs()).max((a.z - b.z).abs()) > 1e-6,
                (a, b) => a != b,
            };
            assert!(!place(light).into_iter().zip(place(&own.light)).any(apart), "{what}: {own:?}");
            let is_shaped = own.measured.is_some();
            assert_eq!(is_shaped, !entry.found.is_exact() && light.intensity() > 0.0, "{what}");
            let (throw, bound) =
                (entry.usage.throw, if is_shaped { 1.3 } else { entry.found.angle.bound + 0.3 });
            let full = lit(light, 0.0, Some(throw)).max(f64::MIN_POSITIVE);
            for degrees in (0..=400).map(|i| f64::from(i) * end(light) * 1.1 / 400.0).filter(|at| *at <= 90.0)
            {
                let near = [-3e-4, 0.0, 3e-4].map(|by: f64| lit(light, (degrees + by).max(0.0), Some(throw)));
                let found = lit(&own.light, degrees, Some(throw));
                let off =
                    near.map(|near| 255.0 * (near - found).abs() / full).into_iter().fold(f64::MAX, f64::min);
                assert!(off <= bound, "{what}: {off} codes at {degrees} degrees\n{}", files[0].1);
            }
        }
        let back = read(name, text, None, Reading::default()).expect("a scene");
        let left_out = |lamp: &Lamp| {
            lamp.notes.iter().any(|note| note.starts_with("its IES profile is left out: file = "))
        };
        assert_eq!(back.lamps.iter().filter(|lamp| left_out(lamp)).count(), count, "{tool}");
        assert!(back.refused.is_empty() && back.lamps.len() == lamps.len(), "{tool}: {:?}", back.refused);
    }
}

/// A step is exact in every tool that has one, and comes back as one.
#[test]
fn step_is_a_step_where_a_tool_has_one() {
    use System::{Blender, Direct3d, OpenGl, Three, Usd};
    for tool in [Blender, Direct3d, OpenGl, Three, Usd] {
        for degrees in [0.05, 1.0, 17.3, 30.0, 64.9, 120.0, 180.0] {
            let lamp = Lamp::new("a", spot(Step, [degrees, 0.0, 0.0]));
            let found = parameters(&lamp, tool, USE).expect("parameters");
            assert!(found.is_exact(), "{tool} at {degrees}: {found:?}");
            let back =
                read("a.txt", found.text(&lamp).as_bytes(), None, Reading::default()).expect("a light");
            let AnyLight::Spot(own) = back.lamps[0].light else { panic!("{tool}: {back:?}") };
            let (falloff, outer) = (own.cone().falloff(), own.cone().outer().to_degrees());
            assert!(matches!(falloff, AnyFalloff::Step(_)), "{tool} at {degrees}: {}", found.text(&lamp));
            assert!((outer / degrees - 1.0).abs() < 1e-5, "{tool} at {degrees}: {outer}");
        }
    }
}

/// What ies does not hold, besides point lights.
const IES: [&str; 3] =
    ["sun to ies: light = directional", "dark to ies: intensity = 0", "thread to ies: outer angle = 0.0005"];

/// Every light comes back from every text with its kind, its name, its place and its colour, and
/// with its light within the difference that is stated; or the refusal names what the text does not
/// hold.
#[test]
fn lights_come_back_from_every_text_that_holds_them() {
    let (mut refused, mut wrong) = (Vec::new(), Vec::new());
    for to in [System::Luminaire, System::Ies].into_iter().chain(System::writable()) {
        for (name, light) in lights() {
            let color = if to == System::Ies { Rgb::new(1.0, 1.0, 1.0) } else { Rgb::new(1.0, 0.5, 0.25) };
            let light = light.with_color(color).and_then(|light| light.with_specular_color(color));
            let intensity = if name == "dark" { 0.0 } else { 12.5 };
            let light = light.and_then(|light| light.with_intensity(intensity)).expect("a light");
            let lamp = Lamp::new(name, light);
            match written(&lamp, to) {
                Ok((text, stated)) => {
                    let found = differences(&lamp, to, &text, stated);
                    wrong.extend(found.err().map(|error| format!("{name} to {to}: {error}\n{text}")));
                }
                Err(refusal) => refused.push(format!("{name} to {to}: {refusal}")),
            }
        }
    }
    assert!(wrong.is_empty(), "{} differ:\n{}", wrong.len(), wrong.join("\n"));
    let kinds = refused.iter().map(|refusal| refusal.split(':').take(2).collect::<Vec<_>>().join(":"));
    let mut expected: Vec<_> = ["point", "short point", "cut point"]
        .map(|name| format!("{name} to ies: light = point"))
        .into_iter()
        .chain(IES.map(str::to_owned))
        .collect();
    expected.extend(System::writable().map(|tool| format!("thread to {tool}: outer angle = 0.0005")));
    expected.sort();
    let mut kinds: Vec<_> = kinds.collect();
    kinds.sort();
    assert_eq!(kinds, expected, "{refused:#?}");
}

fn end(light: &AnyLight) -> f64 {
    if let AnyLight::Spot(spot) = light { f64::from(spot.cone().outer().to_degrees()) / 2.0 } else { 80.0 }
}

/// The position, and the axis or the direction.
fn place(light: &AnyLight) -> [Option<Vec3<f32>>; 2] {
    match light {
        AnyLight::Spot(spot) => [Some(spot.position()), Some(spot.axis())],
        AnyLight::Point(point) => [Some(point.position()), None],
        AnyLight::Measured(light) => [Some(light.position()), Some(light.frame()[2])],
        AnyLight::Directional(sun) => [None, Some(sun.direction())],
    }
}

/// Each light of a text of values is read by itself.
#[test]
fn text_of_values_has_lights_after_each_system() {
    let text = "# system: godot\n# name: a b\nspot_angle=30\n# system: godot\nspot_angel=30\n# system: three\n\
                # system: godot\n# kind: point\n# position: 1,2,3\nomni_range=9";
    let found = read("a.txt", text.as_bytes(), None, Reading::default()).expect("a text");
    let names: Vec<_> =
        found.lamps.iter().map(|lamp| (lamp.name.as_str(), json::kind(&lamp.light))).collect();
    assert_eq!(names, [("a b", "spot"), ("light", "point")]);
    let refused: Vec<_> = found.refused.iter().map(ToString::to_string).collect();
    assert!(refused[0].starts_with("line 4: key = spot_angel: expected a key of godot"), "{refused:?}");
    assert_eq!(refused[1..], ["line 6: system = three: expected godot"]);
    let many = "# system: gltf\n".repeat(10_001);
    let refused = read("a.txt", many.as_bytes(), None, Reading::default()).expect_err("too many lights");
    assert_eq!(refused.to_string(), "lights = 10001: expected at most 10000");
}
