//! The languages with `f32`: shaders are valid, and the C has the bits of the kernel.

mod support;

use std::fmt::Write as _;
use std::fs;

use fastrand::Rng;
use luminaire::dynamic::{AnyLight, Effect};
use luminaire::falloff::AnyFalloff;
use luminaire::light::{Distribution, Symmetry};
use luminaire::{AmbientLight, DirectionalLight, MeasuredLight, Vec3};
use luminaire_export::{Language, Scene, export, export_scene};

use support::compiler::run;
use support::{exact, is_smooth, place, points_of_light, spots};

/// Points of each light.
const POINTS: usize = 4_000;

fn lights() -> Vec<AnyLight> {
    let mut rng = Rng::with_seed(1983);
    let mut lights: Vec<AnyLight> = spots::<f32>(&mut rng, 4).into_iter().map(AnyLight::from).collect();
    lights.extend(points_of_light::<f32>(&mut rng).into_iter().map(AnyLight::from));
    let sun = DirectionalLight::new([0.3, -1.0, 0.2]).and_then(|sun| sun.with_intensity(2.0));
    lights.push(sun.expect("a light").into());
    const SAMPLES: [u16; 65 * 65] = {
        let mut samples = [0; 65 * 65];
        let mut i = 0;
        while i < samples.len() {
            samples[i] = (40_503 * i % 65_536) as u16;
            i += 1;
        }
        samples
    };
    // The samples at the edges of the square need not be those of one direction for the same bits.
    for (index, (size, symmetry)) in
        [(65, Symmetry::None), (17, Symmetry::Bilateral), (33, Symmetry::Quadrant)].into_iter().enumerate()
    {
        let axis = [0.1 * index as f32, -1.0, 0.3];
        let distribution = Distribution::from_parts(&SAMPLES, size, symmetry);
        let [columns, rows] = distribution.shape();
        let distribution = Distribution::from_parts(&SAMPLES[..columns * rows], size, symmetry);
        let light = MeasuredLight::new([0.5, 2.0, -1.0], axis, [0.9, 0.2, 0.1], distribution);
        lights.push(light.and_then(|light| light.with_intensity(3.0)).expect("a light").into());
    }
    lights
}

/// Checks a shader that was parsed.
fn validate(module: &naga::Module, text: &str) {
    let (flags, capabilities) = (naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty());
    if let Err(error) = naga::valid::Validator::new(flags, capabilities).validate(module) {
        panic!("{}", error.emit_to_string(text));
    }
}

#[test]
fn shaders_of_all_lights_are_valid() {
    let lights = lights();
    let names: Vec<_> = (0..lights.len()).map(|index| format!("light_{index}")).collect();
    let ambient = [AmbientLight::new([0.5, 1.0, 0.25].into()).expect("a light"); 2];
    let scene = |language| {
        let lights = names.iter().map(String::as_str).zip(lights.iter().copied());
        let (text, refused) =
            export_scene(&Scene { name: "room", ambient: &ambient }, lights, language).expect("a scene");
        assert!(refused.is_empty(), "{refused:?}");
        text
    };
    let [glsl, uniforms, wgsl] = [Language::Glsl, Language::GlslUniforms, Language::Wgsl].map(scene);
    assert!(
        uniforms
            .contains("uniform highp vec3 room_ambient; // the sum of the ambient light: 1.0, 2.0, 0.5\n")
    );
    let glsl = format!("#version 450\n{glsl}");
    // Fragment shaders of GLSL ES have no default precision of floats. naga reads none of a parameter.
    let mut glsl = glsl
        .replace("highp float ", "float\t")
        .replace("highp vec3 ", "vec3\t")
        .replace("highp int ", "int\t");
    let declares = |word: &str| ["float", "vec3", "int"].contains(&word.rsplit('(').next().unwrap_or(word));
    assert_eq!(glsl.split([' ', '\n']).find(|word| declares(word)), None, "expected highp before it");
    glsl += "layout(location = 0) out vec4 color;\nvoid main() {\n    color = vec4(room_light(vec3(0.0), vec3(1.0)), 1.0);\n}\n";
    let module =
        naga::front::wgsl::parse_str(&wgsl).unwrap_or_else(|error| panic!("{}", error.emit_to_string(&wgsl)));
    assert_eq!(
        module
            .functions
            .iter()
            .filter(|(_, f)| f.name.as_ref().is_some_and(|n| n.ends_with("_irradiance")))
            .count(),
        lights.len()
    );
    assert!(module.functions.iter().any(|(_, f)| f.name.as_deref() == Some("room_light")));
    validate(&module, &wgsl);
    let stage = naga::front::glsl::Options::from(naga::ShaderStage::Fragment);
    let module = naga::front::glsl::Frontend::default().parse(&stage, &glsl);
    let module = module.unwrap_or_else(|error| panic!("{}", error.emit_to_string(&glsl)));
    validate(&module, &glsl);
}

/// A place in the input of the program: a point and a normal.
type Place = ([f32; 3], [f32; 3]);

/// Returns the irradiance and the falloff of a light by the kernel.
fn by_the_kernel(light: &AnyLight, places: &[Place]) -> Vec<[f32; 2]> {
    let at = |answer: &dyn Fn(Vec3<f32>, Vec3<f32>) -> [f32; 2]| {
        places.iter().map(|&(point, normal)| answer(point.into(), normal.into())).collect()
    };
    match light {
        AnyLight::Spot(spot) => {
            let light = spot.compile::<f32>().expect("a light");
            at(&|point, normal| [light.irradiance(point, normal), light.falloff_at(point)])
        }
        AnyLight::Point(point) => {
            let light = point.compile::<f32>().expect("a light");
            at(&|point, normal| [light.irradiance(point, normal), 0.0])
        }
        AnyLight::Measured(light) => {
            let light = light.compile::<f32>().expect("a light");
            at(&|point, normal| [light.irradiance(point, normal), 0.0])
        }
        AnyLight::Directional(sun) => {
            let light = sun.compile::<f32>();
            at(&|_, normal| [light.irradiance(normal), 0.0])
        }
    }
}

/// Returns by how much the powers of the kernel and of C may differ for a light with a real exponent: the stated error
/// of the kernel's, and a few roundings of C's, both divided by the height above the floor.
fn apart_by_powers(light: &AnyLight) -> Option<f64> {
    let AnyLight::Spot(spot) = light else { return None };
    let (exponent, height) = match spot.cone().falloff() {
        AnyFalloff::RealPower(power) => (power.exponent().into(), 1.0),
        AnyFalloff::InvertedRealPower(power) => {
            let exponent = f64::from(power.exponent());
            (exponent, 1.0 - f64::from(power.floor()).powf(exponent))
        }
        _ => return None,
    };
    Some(2.0 * (2e-9 + 6.5e-10 * exponent + 2.0 * f64::from(f32::EPSILON)) / height)
}

fn is_decay(light: &AnyLight) -> bool {
    light.effects().has(Effect::Decay)
}

/// Writes the program that evaluates each light at [`POINTS`] places.
fn program(lights: &[AnyLight]) -> (tempfile::TempDir, std::path::PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let mut main = "#include <stdio.h>\n".to_owned();
    for (index, light) in lights.iter().enumerate() {
        main += &export(*light, &format!("light{index}"), Language::CFloat).expect("a light");
    }
    main += "int main(void) {\n    float w[6], out[2];\n    int i;\n";
    for (index, light) in lights.iter().enumerate() {
        let (irradiance, falloff) = match light {
            AnyLight::Spot(_) => ("(w, w + 3)", format!("light{index}_falloff(w)")),
            AnyLight::Point(_) | AnyLight::Measured(_) => ("(w, w + 3)", "0.0f".to_owned()),
            AnyLight::Directional(_) => ("(w + 3)", "0.0f".to_owned()),
        };
        let _ = writeln!(
            main,
            "    for (i = 0; i < {POINTS}; ++i) {{\n        \
             if (fread(w, 4, 6, stdin) != 6 || light{index}_color[0] < 0.0f) {{ return 1; }}\n        \
             out[0] = light{index}_irradiance{irradiance};\n        out[1] = {falloff};\n        \
             if (fwrite(out, 4, 2, stdout) != 2) {{ return 1; }}\n    }}"
        );
    }
    main += "    return 0;\n}\n";
    let file = folder.path().join("main.c");
    fs::write(&file, main).expect("a folder");
    (folder, file)
}

/// A compiler that fuses products and sums, as C and the languages of shaders permit, changes smooth
/// falloffs of cones over 6 degrees by less than a hundredth of a linear code.
#[test]
fn c_with_fused_operations_is_near_the_kernel() {
    let (lights, mut rng) = (lights(), Rng::with_seed(2005));
    let is_kept = |light: &&AnyLight| matches!(light, AnyLight::Spot(spot) if is_smooth(spot));
    let lights: Vec<AnyLight> = lights.iter().filter(is_kept).copied().collect();
    let places: Vec<Place> =
        lights.iter().flat_map(|light| vec![light; POINTS]).map(|light| place(&mut rng, light)).collect();
    let words: Vec<u32> =
        places.iter().flat_map(|(point, normal)| [*point, *normal]).flatten().map(f32::to_bits).collect();
    let (_folder, file) = program(&lights);
    let Some(found) = run("cc", "-std=c99 -O2 -march=native -ffp-contract=fast", &file, &words) else {
        return;
    };
    let falloffs = found.chunks_exact(2).map(|pair| f32::from_bits(pair[1]));
    let expected =
        lights.iter().zip(places.chunks(POINTS)).flat_map(|(light, places)| by_the_kernel(light, places));
    let worst = falloffs.zip(expected).map(|(found, [_, falloff])| 255.0 * f64::from(found - falloff).abs());
    let worst = worst.fold(0.0, f64::max);
    println!("fused: {} points of smooth lights, falloffs by {worst:.1e} codes", found.len() / 2);
    assert!((1e-4..=1e-2).contains(&worst), "fused: {worst} codes");
}

#[test]
fn c_has_the_bits_of_the_kernel() {
    let (lights, mut rng) = (lights(), Rng::with_seed(2004));
    let places: Vec<Place> =
        lights.iter().flat_map(|light| vec![light; POINTS]).map(|light| place(&mut rng, light)).collect();
    let words: Vec<u32> =
        places.iter().flat_map(|(point, normal)| [*point, *normal]).flatten().map(f32::to_bits).collect();
    let (_folder, file) = program(&lights);
    for (compiler, flags) in
        [("cc", "-std=c99 -O2 -ffp-contract=off"), ("c++", "-std=c++11 -O2 -ffp-contract=off")]
    {
        let Some(found) = run(compiler, flags, &file, &words) else { continue };
        let found: Vec<_> =
            found.chunks_exact(2).map(|pair| [pair[0], pair[1]].map(f32::from_bits)).collect();
        let (mut differ, mut real, mut decays, mut lit) = (0, 0.0_f64, 0.0_f64, 0);
        let (mut smooth, mut oracle) = (0, 0.0_f64);
        for ((light, found), places) in lights.iter().zip(found.chunks(POINTS)).zip(places.chunks(POINTS)) {
            let expected = by_the_kernel(light, places);
            for ((found, expected), place) in found.iter().zip(expected).zip(places) {
                lit += usize::from(expected[0] > 0.0);
                if let Some(apart) = apart_by_powers(light) {
                    real = real.max(f64::from(found[1] - expected[1]).abs() / apart);
                } else if is_decay(light) {
                    let ratio = if expected[0] > 0.0 { found[0] / expected[0] } else { 1.0 + found[0] };
                    decays = decays.max(f64::from(ratio - 1.0).abs());
                } else if *found != expected {
                    differ += 1;
                    assert!(
                        differ < 10,
                        "{compiler}: {found:?}, expected {expected:?} at {place:?} of {light:?}"
                    );
                }
                // At the light itself no direction is exact.
                if let AnyLight::Spot(spot) = light
                    && is_smooth(spot)
                    && spot.position() != place.0.into()
                {
                    smooth += 1;
                    let [_, falloff] = exact(spot, place.0, place.1);
                    oracle = oracle.max(255.0 * (f64::from(found[1]) - falloff).abs());
                }
            }
        }
        println!(
            "{compiler}: {} points, {lit} lit, {differ} differ; real powers by {real:.2} of what is stated, decays by a relative {decays:.1e}; {smooth} of smooth lights by {oracle:.1e} codes from f64",
            found.len()
        );
        assert_eq!(differ, 0);
        assert!((0.05..=1.0).contains(&real), "real powers: {real} of what is stated");
        assert!((1e-8..=1e-5).contains(&decays), "decays: a relative {decays:e}");
        assert!((1e-5..=1e-2).contains(&oracle), "from f64: {oracle:e} codes");
    }
}
