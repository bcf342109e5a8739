//! Lights of scenes that a photometric file beside the scene shapes.

use luminaire::dynamic::AnyLight;
use luminaire_exchange::{Lamp, Lamps, Reading, read_beside};

/// A file that shines down and up: 1,000 cd on the axis, 100 cd up.
const BOTH: &str =
    "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 5 1 1 2 0 0 0\n1 1 0\n0 45 90 135 180\n0\n1000 500 0 50 100\n";
/// A file of LM-63-1986, which begins with its tilt and ends with its last intensity.
const EDGED: &str = "TILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 0\n0 20 40\n0\n1000 500 100";
const UNEVEN: &str =
    "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 2 1 2 0 0 0\n1 1 0\n0 90\n0 180\n1000 0 1000 500\n";

fn beside(name: &str) -> Result<Vec<u8>, String> {
    match name {
        "spot.ies" => Ok(include_bytes!("files/spot.ies").to_vec()),
        "both.ies" => Ok(BOTH.into()),
        "uneven.ies" => Ok(UNEVEN.into()),
        "fine.ies" => {
            let angles: String = (0..=20_000).map(|i| format!("{}\n", f64::from(i) * 0.002)).collect();
            let head = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 20001 1 1 2 0 0 0\n1 1 0\n";
            Ok(format!("{head}{angles}0\n{}", "9\n".repeat(20_001)).into())
        }
        "none.ies" => Ok(b"no photometry".to_vec()),
        "edged.ies" => Ok(EDGED.into()),
        "all.bin" => Ok([b"before", EDGED.as_bytes(), b"after"].concat()),
        "short.bin" => Ok(b"before".to_vec()),
        other => Err(format!("no file {other}")),
    }
}

fn scene(name: &str, text: &str) -> Lamps {
    read_beside(name, text.as_bytes(), None, Reading::default(), &beside).expect("a scene")
}

/// Returns the lights of prims of USD, each a sphere of 1 candela times its values.
fn stage(prims: &[&str]) -> Lamps {
    let prim = |values| {
        format!("def SphereLight \"a\" {{ bool inputs:normalize = 1 float inputs:intensity = 4 {values} }}\n")
    };
    scene("a.usda", &format!("#usda 1.0\n{}", prims.iter().map(prim).collect::<String>()))
}

fn spot(lamp: &Lamp) -> ([f32; 3], [f32; 3], f32) {
    let AnyLight::Spot(spot) = &lamp.light else { panic!("{}: expected a spotlight", lamp.name) };
    (spot.position().into(), spot.axis().into(), spot.intensity())
}

/// Light over 90 degrees off the axis is a second light along the opposite axis, where the node is.
#[test]
fn profile_in_both_directions_is_two_lights_of_the_node() {
    let node = "matrix4d xformOp:transform = ((0,0,-1,0), (0,1,0,0), (1,0,0,0), (1,2,3,1)) \
                token[] xformOpOrder = [\"xformOp:transform\"] float inputs:exposure = 1 color3f inputs:color = (1, 0.5, 0)";
    let lamps = stage(&[&format!("asset inputs:shaping:ies:file = @both.ies@ {node}")]).lamps;
    let found: Vec<_> = lamps.iter().map(|lamp| (lamp.name.as_str(), spot(lamp))).collect();
    let [down, up] =
        [([1.0, 2.0, 3.0], [-1.0, 0.0, 0.0], 2_000.0), ([1.0, 2.0, 3.0], [1.0, 0.0, 0.0], 200.0)];
    assert_eq!(found, [("a", down), ("a (upward)", up)]);
    assert!(lamps.iter().all(|lamp| lamp.light.color().green == 0.5));
    let measured = lamps[0].measured.as_ref().expect("intensities");
    assert_eq!((measured.at(45.0), measured.peak()), (1_000.0, (2_000.0, 0.0)));
}

/// The cone of a light is a factor, and so is the flux that it keeps.
#[test]
fn profile_is_multiplied_by_the_cone_or_keeps_the_flux() {
    let file = "asset inputs:shaping:ies:file = @spot.ies@";
    let lamps = stage(&[
        &format!("{file} float inputs:shaping:cone:angle = 10"),
        &format!("{file} float inputs:shaping:cone:angle = 20 float inputs:shaping:cone:softness = 1"),
        &format!("{file} bool inputs:shaping:ies:normalize = 1"),
        &format!("{file} float inputs:shaping:cone:angle = 90"),
    ])
    .lamps;
    let curve = |at: usize| lamps[at].measured.as_ref().expect("intensities");
    let whole = curve(3);
    assert!(whole.at(7.0) == 500.0 && (whole.at(13.5) - 252.5).abs() < 1e-9, "{}", whole.at(13.5));
    assert_eq!((curve(0).at(9.0), curve(0).end(), curve(0).at(10.1)), (whole.at(9.0), 10.0, 0.0));
    // Half of smoothstep at half of the cone.
    assert!((curve(1).at(10.0) / whole.at(10.0) - 0.5).abs() < 1e-4, "{}", curve(1).at(10.0));
    assert!((curve(2).lumens() / (4.0 * std::f64::consts::PI) - 1.0).abs() < 1e-6, "{}", curve(2).lumens());
    let peak = curve(2).peak().0 as f32;
    assert!((spot(&lamps[2]).2 / peak - 1.0).abs() < 1e-6 && lamps.iter().all(|lamp| lamp.name == "a"));
}

/// A light whose file cannot be read stays with its own numbers, where it has any; it says so.
#[test]
fn profile_that_cannot_be_read_is_named_with_its_remedy() {
    for (file, told) in [
        (
            "far.ies",
            "its IES profile is left out: file = far.ies: expected a file beside this one: no file far.ies",
        ),
        ("none.ies", "its IES profile is left out: TILT = no such line"),
        (
            "uneven.ies",
            "its IES profile is left out: symmetry = bilateral: expected a light with rotational symmetry",
        ),
    ] {
        let lamps = stage(&[&format!("asset inputs:shaping:ies:file = @{file}@"), ""]).lamps;
        assert!(matches!(lamps[0].light, AnyLight::Point(_)) && lamps.len() == 2);
        assert!(lamps[0].notes.iter().any(|note| note.starts_with(told)), "{:?}", lamps[0].notes);
        let node = |punctual: &str| {
            format!(
                r#"{{"asset":{{"version":"2.0"}},"extensions":{{"KHR_lights_punctual":{{"lights":[{{"type":"spot","intensity":7}}]}},
                "EXT_lights_ies":{{"lights":[{{"uri":"{file}"}}]}}}},"nodes":[
                {{"name":"a","translation":[1,2,3],"extensions":{{{punctual}"EXT_lights_ies":{{"light":0,"multiplier":2}}}}}}]}}"#
            )
        };
        let both = scene("a.gltf", &node("\"KHR_lights_punctual\":{\"light\":0},"));
        assert_eq!(spot(&both.lamps[0]), ([1.0, 2.0, 3.0], [0.0, 0.0, -1.0], 7.0));
        assert!(both.lamps[0].notes.iter().any(|note| note.starts_with(told)), "{:?}", both.lamps[0].notes);
        let alone = scene("a.gltf", &node(""));
        let refused = alone.refused[0].to_string();
        let reason = told.trim_start_matches("its IES profile is left out: ");
        assert!(refused.contains(reason) && refused.starts_with("EXT_lights_ies.lights[0]"), "{refused}");
        let has_remedy = refused.contains("; put it there, or give the node a light of KHR_lights_punctual");
        assert_eq!(has_remedy, file == "far.ies", "{refused}");
    }
}

/// A node with a profile of a file of glTF, which has these members beside it.
fn node(profile: &str, members: &str) -> String {
    format!(
        r#"{{"asset":{{"version":"2.0"}},"extensions":{{"EXT_lights_ies":{{"lights":[{profile}]}}}},
        "nodes":[{{"name":"a","extensions":{{"EXT_lights_ies":{{"light":0}}}}}}]{members}}}"#
    )
}

/// Returns bytes in base64.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for group in bytes.chunks(3) {
        let bits = group.iter().chain(&[0, 0]).take(3).fold(0, |bits, byte| bits << 8 | usize::from(*byte));
        let digit = |place: usize| char::from(DIGITS[bits >> (18 - 6 * place) & 63]);
        text.extend((0..4).map(|place| if place <= group.len() { digit(place) } else { '=' }));
    }
    text
}

/// Returns a GLB of a text and of bytes.
fn glb(text: &str, bytes: &[u8]) -> Vec<u8> {
    let mut text = text.as_bytes().to_vec();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut bytes = bytes.to_vec();
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    let words =
        |words: &[usize]| words.iter().flat_map(|word| (*word as u32).to_le_bytes()).collect::<Vec<_>>();
    let head = words(&[2, 28 + text.len() + bytes.len(), text.len()]);
    [b"glTF", &head[..], b"JSON", &text, &words(&[bytes.len()]), b"BIN\0", &bytes].concat()
}

/// Wherever a profile is, its light is that of the same file beside the scene.
#[test]
fn profile_within_a_file_of_gltf_is_that_of_a_file_beside_it() {
    // Without its first or its last byte it is no file, or another one.
    let spot = EDGED.as_bytes();
    let expected = scene("a.gltf", &node(r#"{"uri":"edged.ies"}"#, "")).lamps;
    assert!(expected[0].measured.is_some());
    let (coded, length) = (base64(spot), spot.len());
    let (all, view) = (base64(&[b"before", spot, b"after"].concat()), r#"{"bufferView":1}"#);
    let views = format!(r#","bufferViews":[{{}},{{"buffer":0,"byteOffset":6,"byteLength":{length}}}]"#);
    for (profile, members) in [
        (format!(r#"{{"uri":"data:application/x-ies-lm-63;base64,{coded}"}}"#), String::new()),
        (view.to_owned(), format!(r#"{views},"buffers":[{{"uri":"data:;base64,{all}"}}]"#)),
        (view.to_owned(), format!(r#"{views},"buffers":[{{"uri":"all.bin"}}]"#)),
    ] {
        assert_eq!(scene("a.gltf", &node(&profile, &members)).lamps, expected, "{profile}{members}");
    }
    let text = node(view, &format!(r#"{views},"buffers":[{{}}]"#));
    let binary = glb(&text, &[b"before", spot, b"after"].concat());
    let read =
        |bytes: &[u8]| read_beside("a.glb", bytes, None, Reading::default(), &beside).expect("a scene");
    assert_eq!(read(&binary).lamps, expected);

    for (profile, members, told) in [
        ("{}", String::new(), "uri = none: expected the name of a file, `data:`"),
        (r#"{"uri":"data:;base64,A"}"#, String::new(), "uri = data:: expected a media type, `;base64,`"),
        (view, String::new(), "bufferView = 1: expected a whole number from 0, below 0"),
        (view, views.clone(), "buffer = 0: expected a whole number from 0, below 0"),
        (view, format!(r#"{views},"buffers":[{{}}]"#), "expected a part of the 0 bytes of its buffer"),
        (
            view,
            format!(r#"{views},"buffers":[{{"uri":"short.bin"}}]"#),
            "file = short.bin: expected a file beside",
        ),
    ] {
        let refused = scene("a.gltf", &node(profile, &members)).refused[0].to_string();
        assert!(refused.starts_with("nodes[0], EXT") || refused.starts_with("EXT"), "{refused}");
        assert!(refused.contains(told), "{refused}: expected {told}");
    }
}

#[test]
fn profiles_of_a_scene_are_bounded() {
    let lamps = stage(&["asset inputs:shaping:ies:file = @fine.ies@"; 53]).lamps;
    let shaped: Vec<_> = lamps.iter().filter(|lamp| lamp.measured.is_some()).collect();
    assert_eq!(shaped.len(), 52);
    assert!(
        lamps[52]
            .notes
            .iter()
            .any(|note| note.contains("intensities of profiles = more: expected at most 1048576"))
    );
    let prims: Vec<_> = (0..257).map(|i| format!("asset inputs:shaping:ies:file = @{i}.ies@")).collect();
    let lamps = stage(&prims.iter().map(String::as_str).collect::<Vec<_>>()).lamps;
    let told =
        |at: usize| lamps[at].notes.iter().any(|note| note.contains("profiles = more: expected at most 256"));
    assert_eq!([told(0), told(255), told(256)], [false, false, true]);
}
