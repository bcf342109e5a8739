//! Constants that the build script wrote as Rust source are bit-identical to those that are
//! compiled now.

mod lights;

use luminaire::{
    Angle, Cone, Error, Fx16, SpotLight,
    codegen::{Source, as_source},
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
