//! The colour temperatures of tools and files.

use luminaire_exchange::{Lamp, Reading, System, numbers, read};

/// Returns the colour of a light times its intensity.
fn shown(lamp: &Lamp) -> [f32; 3] {
    <[f32; 3]>::from(lamp.light.color()).map(|channel| channel * lamp.light.intensity())
}

fn assert_near(found: [f32; 3], expected: [f32; 3], what: &str) {
    let is_near = |at: usize| (found[at] - expected[at]).abs() < 3e-4 * expected[0].max(1.0);
    assert!((0..3).all(is_near), "{what}: found {found:?}, expected {expected:?}");
}

/// What the published code of each tool gives in f64, over its own light without a temperature. Of Blender, the colours
/// of Cycles 5.2, whose fit is within 0.002; of version 3 of pbrt, Planck's law and the table of CIE's observer.
#[test]
fn whites_are_those_that_tools_compute() {
    for (system, words, expected) in [
        (System::Blender, "kind=point use_temperature=1 temperature=1902", [2.637_56, 0.614_06, 0.0]),
        (System::Blender, "kind=point use_temperature=1 temperature=3315", [1.631_80, 0.877_74, 0.355_87]),
        (System::Blender, "kind=point use_temperature=1 temperature=6500", [1.042_55, 0.984_05, 1.035_27]),
        (System::Unreal, "kind=point bUseTemperature=True Temperature=4000", [1.414_45, 0.923_75, 0.534_32]),
        (System::Unreal, "kind=point bUseTemperature=True Temperature=20000", [0.784_49, 0.992_55, 1.708_84]),
        (System::Godot, "kind=point light_temperature=2700", [1.0, 0.415_92, 0.098_38]),
        (System::Unity, "kind=point useColorTemperature=1 colorTemperature=3000", [1.0, 0.457_80, 0.147_84]),
        (System::Unity, "kind=point useColorTemperature=1 colorTemperature=8000", [0.761_65, 0.812_58, 1.0]),
        (System::Usd, "kind=point enableColorTemperature=1 colorTemperature=500", [4.305_50, 0.118_36, 0.0]),
        (System::Usd, "kind=point enableColorTemperature=1 colorTemperature=1300", [3.555_75, 0.341_44, 0.0]),
        (
            System::Usd,
            "kind=point enableColorTemperature=1 colorTemperature=2700",
            [1.935_32, 0.803_57, 0.191_69],
        ),
        (
            System::Usd,
            "kind=point enableColorTemperature=1 colorTemperature=6750",
            [1.024_04, 0.985_60, 1.071_83],
        ),
        (
            System::Usd,
            "kind=point enableColorTemperature=1 colorTemperature=9900",
            [0.873_90, 0.994_65, 1.424_27],
        ),
        (
            System::Usd,
            "kind=point enableColorTemperature=1 colorTemperature=20000",
            [0.871_84, 0.994_69, 1.430_00],
        ),
        (System::Pbrt, "kind=point blackbody=4000", [1.414_45, 0.923_75, 0.534_32]),
    ] {
        let light = |words: &str| numbers(system, words.split(' ')).expect(words).lamps.remove(0);
        let ratio = shown(&light(words)).map(|channel| channel / light("kind=point").light.intensity());
        let tolerance = if system == System::Blender { 7.0 } else { 1.0 };
        assert_near(ratio.map(|r| r / tolerance), expected.map(|r| r / tolerance), words);
    }
    for (kelvin, luminance) in
        [(2000.0, 0.048_48), (3000.0, 0.416_02), (6500.0, 0.885_89), (12_000.0, 0.288_31)]
    {
        let words = format!("version=3 blackbody={kelvin},2");
        let lamp = numbers(System::Pbrt, [&*words]).expect(&words).lamps.remove(0);
        let found = lamp.light.color().luminance() * lamp.light.intensity();
        assert!((found / (2.0 * luminance) - 1.0).abs() < 0.01, "{words}: {found}");
    }
}

/// The words of each format, in files as their tools write them.
#[test]
fn whites_of_files_are_read_and_those_that_are_off_are_not() {
    let godot = "[gd_scene format=3]\n\n[node name=\"Spot\" type=\"SpotLight3D\"]\nlight_temperature = 2700.0\nlight_intensity_lumens = 500.0\n";
    let usd = "#usda 1.0\ndef SphereLight \"Spot\" (prepend apiSchemas = [\"ShapingAPI\"])\n{\n  float inputs:shaping:cone:angle = 30\n  \
               bool inputs:enableColorTemperature = true\n  float inputs:colorTemperature = 2700\n}\n";
    let pbrt = "WorldBegin\nLightSource \"spot\" \"blackbody I\" [ 4000 ]\n";
    let unreal = "Begin Actor Class=/Script/Engine.SpotLight Name=Spot\nBegin Object Class=/Script/Engine.SpotLightComponent Name=\"L\"\n\
                  bUseTemperature=True\nTemperature=4000.000000\nEnd Object\nEnd Actor\n";
    let unity = "%YAML 1.1\n--- !u!1 &1\nGameObject:\n  m_Name: Spot\n--- !u!4 &2\nTransform:\n  m_GameObject: {fileID: 1}\n  \
                 m_LocalPosition: {x: 0, y: 0, z: 0}\n  m_Father: {fileID: 0}\n--- !u!108 &3\nLight:\n  m_GameObject: {fileID: 1}\n  \
                 m_Type: 0\n  m_Color: {r: 1, g: 1, b: 1, a: 1}\n  m_ColorTemperature: 3000\n  m_UseColorTemperature: 1\n";
    for (name, text, on, off, expected) in [
        ("a.tscn", godot, "light_temperature", "light_size", [1.0, 0.941_86, 0.992_29]),
        ("a.usda", usd, "enableColorTemperature = true", "enableColorTemperature = false", [1.0; 3]),
        ("a.pbrt", pbrt, "blackbody I\" [ 4000 ]", "rgb I\" [ 1 1 1 ]", [1.0; 3]),
        ("a.t3d", unreal, "bUseTemperature=True", "bUseTemperature=False", [1.0; 3]),
        ("a.unity", unity, "UseColorTemperature: 1", "UseColorTemperature: 0", [1.0; 3]),
    ] {
        let color = |text: &str| {
            let lamps = read(name, text.as_bytes(), None, Reading::default()).expect(name);
            <[f32; 3]>::from(lamps.lamps[0].light.color())
        };
        let warm = color(text);
        assert!(warm[0] == 1.0 && warm[1] < 0.7 && warm[2] < 0.4, "{name}: {warm:?}");
        assert_near(color(&text.replace(on, off)), expected, name);
    }
    let lamps = read("a.tscn", godot.as_bytes(), None, Reading::default()).unwrap();
    let candela = 500.0 / std::f32::consts::PI * (1.0 - 1e-4);
    assert!((lamps.lamps[0].light.intensity() / candela - 1.0).abs() < 1e-3, "{:?}", lamps.lamps[0].light);
}

/// Candela and lux are those of the source, whatever the colour; out and in again, and with another temperature.
#[test]
fn luminance_of_a_white_is_that_of_its_source() {
    let file = include_bytes!("files/spot.ldt");
    let mut lamp = read("spot.ldt", file, None, Reading::default()).unwrap().lamps.remove(0);
    assert_eq!((lamp.kelvin, lamp.own_intensity().round()), (Some(3000.0), 2000.0));
    assert_near(shown(&lamp).map(|channel| channel / 2000.0), [1.769_79, 0.844_79, 0.270_73], "3000 K");
    for kelvin in [1000.0, 2700.0, 25_000.0] {
        let mut other = lamp.clone();
        other.set_kelvin(kelvin).unwrap();
        assert!((other.own_intensity() - 2000.0).abs() < 0.01, "{kelvin} K: {}", other.own_intensity());
        assert!(other.light.intensity() > 2000.0 && other.curve() == lamp.curve());
    }
    let mut red = lamp.clone();
    red.set_color([1.0, 0.0, 0.0]).unwrap();
    assert!((red.light.intensity() - 2000.0).abs() < 0.01 && red.kelvin.is_none());
    assert!(lamp.set_kelvin(999.0).unwrap_err().to_string().contains("from 1000 to 25000 K"));
    let text = String::from_utf8_lossy(file).replace("\n3000\n", "\n60000\n");
    let white = read("spot.ldt", text.as_bytes(), None, Reading::default()).unwrap().lamps.remove(0);
    assert_eq!((white.kelvin, shown(&white)), (None, [2000.0; 3]));
    assert!(
        white.notes[0].starts_with("the white of the file is left out: color temperature = 60000"),
        "{white:?}"
    );
}
