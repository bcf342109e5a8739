//! Constants that the build script wrote as Rust source are bit-identical to those that are
//! compiled now.

mod lights;

use fastrand::Rng;
use luminaire::number::Light16;
use luminaire::{
    Angle, Cone, Error, Fx16, Scalar, SpotLight, Vec3,
    codegen::{Source, as_source},
    falloff::Soft,
    light::CompiledSpotLight,
    projector::{Projection, Shadow},
};

/// A generated constant of any type.
trait Constant {
    /// The source text of its bits.
    fn source(&self) -> String;
}

impl<T: Source> Constant for T {
    fn source(&self) -> String {
        as_source(self).to_string()
    }
}

/// The names of the values that are compiled now, each with its text.
struct Compiled(Vec<(String, String)>);

impl lights::Visit for Compiled {
    fn value<T: Source>(&mut self, name: String, value: T) {
        // A path to a type whose name is left out may still compile by inference.
        let path = std::any::type_name::<T>();
        let whole = path.split('<').next().and_then(|path| path.rsplit("::").next()).unwrap_or(path);
        let written = value.source();
        assert!(written.contains(whole), "{name}: {whole} is not in {written}");
        self.0.push((name, written));
    }
}

#[test]
fn a_generated_constant_has_the_bits_of_the_compiled_value() {
    let constants: &[(&str, &dyn Constant)] = &include!(concat!(env!("OUT_DIR"), "/constants.rs"));
    let mut compiled = Compiled(Vec::new());
    lights::all(&mut compiled).expect("sound lights");
    assert_eq!(constants.len(), compiled.0.len());
    assert!(constants.len() > 150, "only {} constants", constants.len());
    for ((name, constant), (compiled_name, compiled)) in constants.iter().zip(&compiled.0) {
        assert_eq!(name, compiled_name);
        assert_eq!(constant.source(), *compiled, "{name}");
    }
}

const KEY: CompiledSpotLight<Fx16, Soft> = include!(concat!(env!("OUT_DIR"), "/key.rs"));

#[test]
fn a_generated_light_lights_as_the_compiled_one() {
    let compiled = lights::key().expect("a sound light");
    assert_eq!(KEY, compiled);
    let mut rng = Rng::with_seed(36);
    let mut lit = 0;
    for _ in 0..100_000 {
        let point = Vec3::new(rng.f32(), rng.f32(), rng.f32()).map(|c| Fx16::length(8.0 * c - 4.0));
        let normal = Vec3::new(Fx16::ZERO, Fx16::ONE, Fx16::ZERO);
        let light = KEY.irradiance(point, normal);
        assert_eq!(light, compiled.irradiance(point, normal));
        lit += u32::from(light > Light16::ZERO);
    }
    assert!(lit > 1_000, "only {lit} points are lit");
}

/// The depths of a shadow map are written as a slice that lives as long as the program.
#[test]
fn a_generated_shadow_has_its_depths() -> Result<(), Error> {
    let spot = SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], Cone::soft(Angle::degrees(20.0))?)?;
    let depths = [3.5, 0.25, 1.0, 7.0].map(Fx16::length);
    let shadow = Shadow::new(Projection::of(&spot)?.compile::<Fx16>()?, 2, &depths)?;
    let written: String = as_source(&shadow).to_string().split_whitespace().collect();
    let depths = depths.map(|depth| format!("Length::from_bits({})", depth.to_bits()));
    let expected = format!("const{{&[{}]}}", depths.join(","));
    assert!(written.replace(",]", "]").contains(&expected), "{expected} is not in {written}");
    Ok(())
}
