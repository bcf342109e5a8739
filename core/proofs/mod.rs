//! Proofs of the errors of the fixed-point stages.
//!
//! The bound of a light ([`bound`](crate::bound)) is a sum of the errors that [`Stages`] states. Here each
//! of them is proved, for every ramp, offset, normal and gain, by one of three machines:
//!
//! - **Gappa** proves bounds of integer operations: products, shifts and roundings. The operations are those
//!   of [`model`], which the tests compare with the kernel, bit by bit; the same functions write the scripts.
//!   Each script also shows that every word fits 32 bits, so that nothing wraps. **Coq** checks Gappa's
//!   proofs, and proves the equations that Gappa takes for granted and the lemma of `versine.v`.
//! - **Boxes**, halved until intervals show the bound: what truncations do to the length and the direction of
//!   a vector depends on the direction, which Gappa loses.
//! - **Exhaustion**: square roots, reciprocals and samples, in the tests of `root.rs` and here.
//!
//! `cargo xtask prove` runs all of them; a plain `cargo test` leaves out Coq, and Gappa where it is not
//! installed. [`ledger`] has the list: how each number that the stages state is shown, and that half of it is too
//! little. Searched are the powers of real exponents, of which `real.rs` states the error, and the errors of axes.

mod boxes;
mod gappa;
mod geometry;
mod ledger;
pub(super) mod model;
mod scripts;

extern crate std;

use std::collections::BTreeSet;
use std::env;
use std::path::{Path, PathBuf};
use std::string::{String, ToString};
use std::vec::Vec;
use std::{format, fs, println, thread};

use self::gappa::{Script, checked, coq, proved};
use self::model::Constants;
use crate::{Angle, Cone, SpotLight, vec3::Vec3};

use super::{Errors, Fx16, Fx32, Quick, Scalar, Stages, float, fx16, fx32, real, stages::RANGE};

/// A step of a fraction and of a scalar of 16 bits, and of 32 bits.
const FINER: f64 = 1.0 / 32_768.0;
const STEP: f64 = 1.0 / 16_384.0;
const FINE_STEP: f64 = 1.0 / 1_073_741_824.0;

/// An evaluation in fixed point, of which the stages are proved.
struct Evaluation {
    name: String,
    stages: Stages,
    /// The relative error of its reciprocal square root (exhaustive: see `root.rs`).
    root: f64,
    kind: Kind,
}

impl Evaluation {
    /// The relative error of the estimate of a reciprocal length, of 15 bits of an offset.
    fn estimate(&self) -> f64 {
        if self.kind == Kind::Fine16 { 1.75e-4 } else { 2.85e-4 }
    }

    /// The relative error of the length of a direction after a step of Newton.
    fn newton(&self) -> f64 {
        self.stages.cosine.relative
    }

    /// The relative error of a distance.
    fn length(&self) -> f64 {
        self.newton() + 2.1e-8
    }

    /// What an offset that is halved loses, relative to its length: half a unit of a component of 2^23, or of 2^31.
    fn halved(&self) -> f64 {
        match self.kind {
            Kind::Far16 => 3_f64.sqrt() / 16_777_216.0,
            Kind::Fine32 => 0.71 * FINE_STEP,
            _ => 0.0,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Kind {
    /// 15 bits of an offset, and 17 for the direction; of offsets of this bit length.
    Coarse(u32),
    /// 15 bits of an offset of this bit length.
    Quick(u32),
    /// All bits of an offset of `Fx16`.
    Fine16,
    /// All but one bit of an offset of `Fx16` from 256 units on.
    Far16,
    /// All bits of an offset of `Fx32`.
    Fine32,
}

/// Returns all evaluations: a coarse offset has up to 32 bits, of which those beyond 20 change little.
fn evaluations() -> Vec<Evaluation> {
    // A distance at which an offset has this bit length.
    let at = |bits: u32| 1.5 * (f64::from(bits) - 17.0).exp2();
    let lengths = || (14..=20).chain([32]);
    let coarse = lengths().map(|bits| Evaluation {
        name: format!("fx16_coarse_{bits}"),
        stages: Fx16::stages(at(bits)),
        root: 9.0e-5,
        kind: Kind::Coarse(bits),
    });
    let quick = lengths().map(|bits| Evaluation {
        name: format!("fx16_quick_{bits}"),
        stages: Fx16::quick_stages(at(bits)),
        root: 2.0e-4,
        kind: Kind::Quick(bits),
    });
    let fine = [
        ("fx16_fine", Fx16::fine_stages(at(17)), 9.0e-5, Kind::Fine16),
        ("fx16_far", Fx16::fine_stages(at(32)), 9.0e-5, Kind::Far16),
        ("fx32", Fx32::stages(1.0), 2.0e-4, Kind::Fine32),
    ];
    let fine =
        fine.map(|(name, stages, root, kind)| Evaluation { name: name.to_string(), stages, root, kind });
    coarse.chain(quick).chain(fine).collect()
}

/// Returns the folder of the scripts and proofs.
fn folder() -> PathBuf {
    let target = env::var_os("CARGO_TARGET_DIR")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../target"), PathBuf::from);
    target.join("proofs")
}

/// The scripts of all evaluations. The bit length of an offset changes none of them.
fn all_scripts(constants: &Constants) -> Vec<(Script, String)> {
    let is_one =
        |evaluation: &Evaluation| !matches!(evaluation.kind, Kind::Coarse(14..32) | Kind::Quick(14..32));
    let mut known = BTreeSet::new();
    let scripts = evaluations().into_iter().filter(is_one).flat_map(|it| scripts::of(&it, constants));
    scripts.filter(|(_, text)| known.insert(text.clone())).collect()
}

/// Whether `cargo xtask prove` runs the tests, and has installed both programs.
fn is_required() -> bool {
    env::var_os("LUMINAIRE_COQ").is_some()
}

/// Runs Gappa, and with `LUMINAIRE_COQ` also Coq, over all scripts.
#[test]
fn scripts_are_proved() {
    let folder = folder();
    let mut failed = Vec::new();
    let scripts = all_scripts(&Constants::KERNEL);
    assert!(scripts.len() > 20, "{} scripts", scripts.len());
    if !is_required() && !gappa::is_installed() {
        return;
    }
    let mut proofs = Vec::new();
    for (script, text) in &scripts {
        match proved(&script.name, text, &folder) {
            Ok(path) => proofs.push(path),
            Err(error) => failed.push(format!("{}: {error}", script.name)),
        }
    }
    assert!(failed.is_empty(), "{} of {} scripts:\n{}", failed.len(), scripts.len(), failed.join("\n"));
    if is_required() {
        let path = folder.join("versine.v");
        fs::write(&path, include_str!("versine.v")).unwrap();
        coq(&path).unwrap();
        let processors = thread::available_parallelism().map_or(1, usize::from);
        thread::scope(|scope| {
            for part in 0..processors {
                let file = folder.join(format!("part{part}.v"));
                let proofs = proofs.iter().skip(part).step_by(processors);
                scope.spawn(move || checked(proofs, &file).unwrap());
            }
        });
    }
    println!("{} scripts proved", scripts.len());
}

/// Each of these changes, of one constant alone, makes a proof fail: `cargo xtask prove` tries them.
#[test]
fn a_constant_that_is_changed_is_noticed() {
    if !is_required() {
        return;
    }
    let folder = folder().join("changed");
    let kernel = Constants::KERNEL;
    let changed = [
        ("reciprocal_half", Constants { reciprocal_half: 0, ..kernel }),
        ("cut_off", Constants { cut_off: 4_096, ..kernel }),
        ("quick_cut_off", Constants { quick_cut_off: 16_384, ..kernel }),
        ("difference_half", Constants { difference_half: 0, ..kernel }),
        ("mantissa_bits", Constants { mantissa_bits: 17, ..kernel }),
        ("ramp_half", Constants { ramp_half: 0, ..kernel }),
        ("value_half", Constants { value_half: 0, ..kernel }),
        ("fraction_half", Constants { fraction_half: 0, ..kernel }),
        ("along", Constants { along: 14, ..kernel }),
        ("squared", Constants { squared: 15, ..kernel }),
        ("mantissa", Constants { mantissa: 13, ..kernel }),
        ("gain_half", Constants { gain_half: 0, ..kernel }),
        ("newton", Constants { newton: 2, ..kernel }),
        ("newton_bits", Constants { newton_bits: 24, ..kernel }),
        ("excess_bits", Constants { excess_bits: 4, ..kernel }),
        ("nearly_bits", Constants { nearly_bits: 18, ..kernel }),
    ];
    for (name, constants) in changed {
        let is_proved =
            all_scripts(&constants).iter().all(|(script, text)| proved(&script.name, text, &folder).is_ok())
                && evaluations().iter().all(|it| geometry::prove(it, &constants).is_ok());
        assert!(!is_proved, "with another {name} all is proved");
    }
}

#[test]
fn boxes_show_what_truncation_does_to_a_vector() {
    for evaluation in evaluations() {
        geometry::prove(&evaluation, &Constants::KERNEL)
            .unwrap_or_else(|error| panic!("{}: {error}", evaluation.name));
    }
}

/// The error of an axis, along and across it: of the length, and of the direction in radians.
fn axis_error<S: Scalar>(way: [f32; 3], to_f64: impl Fn(S::Unit) -> f64) -> [f64; 2] {
    let cone = Cone::soft(Angle::degrees(40.0)).expect("a cone");
    let light = SpotLight::new([0.0; 3], way, cone).and_then(|light| light.compile::<S>()).expect("a light");
    let length = |v: Vec3<f64>| (v.x * v.x + v.y * v.y + v.z * v.z).sqrt();
    let (found, way) = (light.axis().map(to_f64), Vec3::from(way).map(f64::from));
    let exact = way.map(|c| c / length(way));
    let Vec3 { x, y, z } = found.zip(exact, |found, exact| found - exact);
    let across = Vec3::new(y * exact.z - z * exact.y, z * exact.x - x * exact.z, x * exact.y - y * exact.x);
    [(length(found) - 1.0).abs(), length(across)]
}

/// The set-up of an axis has no script. Every other axis is random, each component with a scale of its own, and the
/// others climb from the worst of these by units of the last place.
#[test]
fn axes_keep_their_stated_errors() {
    type Errors = fn([f32; 3]) -> [f64; 2];
    let formats: [(&str, Errors, [f64; 2]); 3] = [
        (
            "f32",
            |way| axis_error::<f32>(way, f64::from),
            [float::errors::AXIS_LENGTH, float::errors::AXIS_TURN],
        ),
        (
            "fx16",
            |way| axis_error::<Fx16>(way, |c| f64::from(c.to_bits()) * FINE_STEP),
            [fx16::errors::AXIS_LENGTH, fx16::errors::AXIS_TURN],
        ),
        (
            "fx32",
            |way| axis_error::<Fx32>(way, |c| f64::from(c.to_bits()) * FINE_STEP),
            [fx32::errors::AXIS_LENGTH, fx32::errors::AXIS_TURN],
        ),
    ];
    for (name, errors, stated) in formats {
        let mut random = fastrand::Rng::with_seed(7);
        for (part, stated) in stated.into_iter().enumerate() {
            let mut worst = (0.0, [1.0; 3]);
            for step in 0..60_000 {
                let way = if step % 2 == 0 {
                    [0; 3].map(|_| (random.f32() - 0.5) * (-16.0 * random.f32() * random.f32()).exp2())
                } else {
                    worst
                        .1
                        .map(|c: f32| f32::from_bits(c.to_bits().wrapping_add_signed(random.i32(-40..=40))))
                };
                if way.iter().all(|c| c.abs() < 1e-3) {
                    continue;
                }
                let found = errors(way)[part];
                assert!(found <= stated, "{name}: {found:e} of {stated:e} for {way:?}");
                worst = if found > worst.0 { (found, way) } else { worst };
            }
            println!("{name}: {:e} of {stated:e} for {:?}", worst.0, worst.1);
            assert!(worst.0 > stated / 2.0, "{name}: only {:e} of {stated:e}", worst.0);
        }
    }
}
