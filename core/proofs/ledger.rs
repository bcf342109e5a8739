//! The list of all numbers that the stages state: by which machine each is shown, and that half of it is too little.

extern crate std;

use core::fmt::{self, Display};
use std::collections::BTreeSet;
use std::string::String;
use std::vec::Vec;
use std::{format, fs, println, vec};

use super::model::Constants;
use super::real::INVERSE_POWER;
use super::{
    Evaluation, FINE_STEP, Kind, RANGE, STEP, evaluations, folder, gappa, geometry, is_required, scripts,
};
use crate::number::{
    Directions, Errors, Fraction, Fx16, Fx32, InversePower, Offset, Quick, Ray, Rounding, Scalar, Share,
    Stages, Types,
    fx16::{self, Fraction16},
    fx32, root,
};
use crate::vec3::Vec3;

/// How a number is shown.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Shown {
    /// It is 0: the operation loses nothing.
    Exact,
    /// By Gappa and Coq, by boxes of intervals, or as a sum of numbers that are.
    Proved,
    /// For every argument.
    Exhausted,
    /// For arguments from the whole domain, some of which come near it.
    Searched,
}

impl Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Exact => "exact",
            Self::Proved => "proved",
            Self::Exhausted => "exhausted",
            Self::Searched => "searched",
        })
    }
}

/// Whether an evaluation keeps what its stages state, as far as a machine looks at it.
type Witness = fn(&Evaluation) -> Result<(), String>;

/// Returns each number of the stages with its name.
fn numbers(stages: &mut Stages) -> Vec<(&'static str, &mut f64)> {
    // All of them, so that one that is added is listed, too.
    let Stages {
        length,
        turn,
        difference,
        versine,
        set_up,
        ramp,
        complement,
        product,
        value,
        lift,
        weight,
        smooth,
        pair,
        place,
        sample,
        power,
        cosine,
        incidence,
        share,
        near,
        gain,
        inverse_square,
        given,
        inverse_polynomial,
        inverse_power: [constant, growth],
        light,
    } = stages;
    let mut numbers = vec![
        ("length", length),
        ("turn", turn),
        ("difference", difference),
        ("set-up", set_up),
        ("weight", weight),
        ("gain", gain),
        ("inverse square", inverse_square),
        ("given", given),
        ("inverse polynomial", inverse_polynomial),
        ("inverse power", constant),
        ("inverse power, per exponent", growth),
    ];
    let roundings: [([&str; 2], &mut Rounding); 16] = [
        (["versine", "versine, relative"], versine),
        (["ramp", "ramp, relative"], ramp),
        (["complement", "complement, relative"], complement),
        (["product", "product, relative"], product),
        (["value", "value, relative"], value),
        (["lift, absolute", "lift"], lift),
        (["smooth", "smooth, relative"], smooth),
        (["pair", "pair, relative"], pair),
        (["place", "place, relative"], place),
        (["sample", "sample, relative"], sample),
        (["power", "power, relative"], power),
        (["cosine", "cosine, relative"], cosine),
        (["incidence", "incidence, relative"], incidence),
        (["share", "share, relative"], share),
        (["near", "near, relative"], near),
        (["light", "light, relative"], light),
    ];
    for ([of_absolute, of_relative], Rounding { absolute, relative }) in roundings {
        numbers.extend([(of_absolute, absolute), (of_relative, relative)]);
    }
    numbers
}

/// Returns how a number other than 0 is shown.
fn shown(kind: Kind, name: &str) -> (Shown, Witness) {
    use Shown::{Exhausted, Proved, Searched};
    let is_coarse = matches!(kind, Kind::Coarse(_) | Kind::Quick(_));
    // Boxes of directions for a coarse evaluation, and sums of what scripts prove for a fine one.
    let by_vectors: (Shown, Witness) = (Proved, if is_coarse { intervals } else { sums });
    match name {
        "inverse power" => (Searched, powers),
        "incidence, relative" => (Proved, sums),
        "inverse polynomial" => (Proved, intervals),
        "length" | "turn" | "near, relative" | "inverse power, per exponent" => by_vectors,
        "cosine" | "inverse square" if is_coarse => by_vectors,
        "cosine, relative" if is_coarse => (Exhausted, roots),
        "sample" if is_coarse => (Exhausted, samples),
        _ if kind == Kind::Far16 => (Proved, sums),
        _ => (Proved, by_scripts),
    }
}

/// By the proofs of Gappa: that of each script whose text is not one of those that are proved in any case.
fn by_scripts(evaluation: &Evaluation) -> Result<(), String> {
    let kernel = Constants::KERNEL;
    let known: BTreeSet<_> =
        evaluations().iter().flat_map(|it| scripts::of(it, &kernel)).map(|(_, text)| text).collect();
    let folder = folder().join("halved");
    let mut changed = scripts::of(evaluation, &kernel).into_iter().filter(|(_, text)| !known.contains(text));
    changed.try_for_each(|(script, text)| gappa::proved(&script.name, &text, &folder).map(drop))
}

/// By boxes and intervals.
fn intervals(evaluation: &Evaluation) -> Result<(), String> {
    geometry::prove(evaluation, &Constants::KERNEL)
}

/// As sums of what others prove, and of the errors of axes.
fn sums(evaluation: &Evaluation) -> Result<(), String> {
    let Evaluation { stages, kind, .. } = evaluation;
    let at_least = |stated: f64, sum: f64, name: &str| {
        if stated >= sum { Ok(()) } else { Err(format!("{name}: {stated:e} of {sum:e}")) }
    };
    // A component of a direction is within 1.001 steps.
    let (newton, turned) = (evaluation.newton(), 1.001 * 3_f64.sqrt() * FINE_STEP);
    let halved = evaluation.halved();
    let (axis_length, axis_turn, mantissas) = match kind {
        // Two products are rounded to a mantissa.
        Kind::Fine32 => (fx32::errors::AXIS_LENGTH, fx32::errors::AXIS_TURN, 2.0 * FINE_STEP * 4.0),
        // A product of 29 bits is rounded down.
        _ => (fx16::errors::AXIS_LENGTH, fx16::errors::AXIS_TURN, FINE_STEP * 2.0),
    };
    if *kind == Kind::Fine32 {
        at_least(stages.incidence.relative, axis_length, "incidence")?;
    }
    at_least(stages.length, newton + axis_length, "length")?;
    at_least(stages.turn, turned + axis_turn + halved, "turn")?;
    let near = evaluation.length() + 2.0 * halved + RANGE + mantissas + 1e-12;
    at_least(stages.near.relative, near, "near")?;
    let mantissa = if *kind == Kind::Fine32 { FINE_STEP * 4.0 } else { STEP / 4.0 };
    let growth = evaluation.length() + halved + mantissa + INVERSE_POWER[1];
    at_least(stages.inverse_power[1], growth, "inverse power")?;
    if *kind != Kind::Far16 {
        return Ok(());
    }
    // What an offset that is halved adds to the evaluation near the light. All else is the same there.
    let mut all = [Fx16::fine_stages(1.0), *stages];
    let [near, far] = &mut all;
    for ((name, near), (_, far)) in numbers(near).into_iter().zip(numbers(far)) {
        let more = match name {
            "length" | "turn" | "near, relative" | "inverse polynomial" | "inverse power, per exponent" => {
                continue;
            }
            "cosine" => halved,
            "inverse square" => 2.0 * halved + 3.0 * halved * halved,
            _ => 0.0,
        };
        at_least(*far, *near + more, name)?;
    }
    Ok(())
}

/// The roots of a coarse evaluation, for squared lengths of 15 bits. The tests of `root.rs` visit every one.
fn roots(evaluation: &Evaluation) -> Result<(), String> {
    let root = if matches!(evaluation.kind, Kind::Quick(_)) {
        root::quick_inverse_sqrt_16
    } else {
        root::inverse_sqrt_16
    };
    let stated = evaluation.stages.cosine.relative;
    for squared in (1 << 28..=3_u32 << 30).step_by(1_009) {
        let exact = 1_073_741_824.0 / f64::from(squared).sqrt();
        let error = (f64::from(root(squared)) / exact - 1.0).abs();
        if error > stated {
            return Err(format!("root of {squared}: {error:e} over {stated:e}"));
        }
    }
    Ok(())
}

/// The conversion of every sample of 16 bits to a value, beside the half of a unit by which one that is interpolated
/// is rounded (see the script of samples).
fn samples(evaluation: &Evaluation) -> Result<(), String> {
    let stated = 16_384.0 * evaluation.stages.sample.absolute - 0.125 * 65_536.0 / 65_535.0;
    for value in 0..=u16::MAX {
        let found = Fraction::<Fx16>::sample(Fraction16(0), &[value; 2]);
        let error = (f64::from(found.to_bits()) - f64::from(value) * 16_384.0 / 65_535.0).abs();
        if error > stated {
            return Err(format!("sample {value}: {error} steps over {stated}"));
        }
    }
    Ok(())
}

/// Attenuation by a power of the distance, over all distances, exponents and caps.
fn powers(evaluation: &Evaluation) -> Result<(), String> {
    let [constant, growth] = evaluation.stages.inverse_power;
    let mut random = fastrand::Rng::with_seed(11);
    for step in 0..60_000_u32 {
        let bits = match evaluation.kind {
            Kind::Coarse(bits) | Kind::Quick(bits) if bits < 32 => bits,
            Kind::Coarse(_) | Kind::Quick(_) => random.u32(20..=31),
            Kind::Fine16 => random.u32(8..=24),
            Kind::Far16 => random.u32(25..=31),
            Kind::Fine32 => random.u32(8..=32),
        };
        // The largest component has this many bits.
        let mut way = [0; 3].map(|_: i64| random.i64(-(1 << bits) + 1..1 << bits));
        way[0] = random.i64(1 << (bits - 1)..1 << bits);
        let [light, point] = [[0_i64; 3], way].map(|place| {
            Vec3::from(place.map(|c| crate::number::Length::from_bits((c - way[0] / 2) as i32)))
        });
        let exponent = [0.01, 0.5, 16.0, 16.0 * random.f32().max(1e-6)][step as usize % 4];
        let most = if step % 8 == 0 { 1.0 + random.f32() } else { 1.844e19 };
        let power = InversePower::new(exponent, most);
        let distance =
            point.zip(light, |p, l| (i64::from(p.to_bits()) - i64::from(l.to_bits())) as f64 / 65_536.0);
        let distance = (distance.x.powi(2) + distance.y.powi(2) + distance.z.powi(2)).sqrt();
        let exact = distance.powf(-f64::from(exponent)).min(most.into());
        // A light of 256 and more, so that its last bit is small.
        let gain = ((256.0 + 256.0 * random.f64()) / exact) as f32;
        if !gain.is_normal() {
            continue;
        }
        let offset = <Fx16 as Types>::Offset::between(light, point);
        let found = match evaluation.kind {
            Kind::Coarse(_) => lit16(&offset.ray(), power, gain),
            Kind::Quick(_) => lit16(&<Fx16 as Quick>::QuickOffset::between(light, point).ray(), power, gain),
            Kind::Fine16 | Kind::Far16 => lit16(&Fx16::fine_ray(&offset), power, gain),
            Kind::Fine32 => {
                let ray = <Fx32 as Types>::Offset::between(light, point).ray();
                lit::<Fx32, _>(&ray, power, gain).to_bits() as f64 * FINE_STEP
            }
        };
        let exact = exact * f64::from(gain);
        let stated = constant + growth * f64::from(exponent);
        let allowed = exact * stated * (1.0 + stated)
            + evaluation.stages.light.absolute
            + evaluation.stages.given * exact;
        if (found - exact).abs() > allowed {
            let error = (found / exact - 1.0).abs();
            return Err(format!("{exponent} of {way:?}: {error:e} over {stated:e}"));
        }
    }
    Ok(())
}

/// Returns the light of full share along a ray.
fn lit<S: Scalar, R: Ray<S>>(ray: &R, power: InversePower, gain: f32) -> S::Received {
    ray.light_by_decay(R::Share::of_scalar(S::ONE), power, S::gain(gain))
}

fn lit16(ray: &impl Ray<Fx16>, power: InversePower, gain: f32) -> f64 {
    f64::from(lit(ray, power, gain).to_bits()) * STEP
}

/// The evaluations of the list, with the longest offsets.
fn listed() -> impl Iterator<Item = Evaluation> {
    evaluations().into_iter().filter(|it| !matches!(it.kind, Kind::Coarse(..32) | Kind::Quick(..32)))
}

/// Writes the list as a table of the documentation.
fn table() -> String {
    let mut table = String::from("| number of a stage |");
    for heading in ["`Fx16`", "quick", "fine", "fine, far", "`Fx32`"] {
        table += &format!(" {heading} |");
    }
    table += "\n|---|---|---|---|---|---|\n";
    let mut all: Vec<_> = listed().collect();
    let kinds: Vec<_> = all.iter().map(|it| it.kind).collect();
    let mut rows: Vec<_> = all.iter_mut().map(|it| numbers(&mut it.stages).into_iter()).collect();
    while let Some(row) = rows.iter_mut().map(Iterator::next).collect::<Option<Vec<_>>>() {
        if row.iter().all(|(_, number)| **number == 0.0) {
            continue;
        }
        let how = row.iter().zip(&kinds).map(|((name, number), kind)| {
            let shown = if **number == 0.0 { Shown::Exact } else { shown(*kind, name).0 };
            format!(" {shown} |")
        });
        table += &format!("| {} |{}\n", row[0].0, how.collect::<String>());
    }
    table
}

/// Each number holds by its witness.
#[test]
fn all_numbers_of_the_stages_are_shown() {
    for mut evaluation in listed() {
        let kind = evaluation.kind;
        let names: Vec<_> =
            numbers(&mut evaluation.stages).iter().map(|(name, number)| (*name, **number)).collect();
        let mut done = Vec::new();
        for (name, _) in names.into_iter().filter(|(_, number)| *number != 0.0) {
            let (_, holds) = shown(kind, name);
            if !done.contains(&(holds as usize)) {
                holds(&evaluation).unwrap_or_else(|error| panic!("{}, {name}: {error}", evaluation.name));
                done.push(holds as usize);
            }
        }
    }
}

/// Half of a number is too little for its witness: nothing is stated that nobody looks at. Writes the list.
#[test]
fn half_of_any_number_is_noticed() {
    let (mut unnoticed, mut count) = (Vec::new(), 0);
    for evaluation in listed() {
        let mut stages = evaluation.stages;
        for place in 0..numbers(&mut stages).len() {
            let mut halved = Evaluation { name: evaluation.name.clone(), ..evaluation };
            let (name, number) = numbers(&mut halved.stages).swap_remove(place);
            let (_, holds) = shown(evaluation.kind, name);
            if *number == 0.0 || (!is_required() && core::ptr::fn_addr_eq(holds, by_scripts as Witness)) {
                continue;
            }
            *number *= 0.5;
            count += 1;
            if holds(&halved).is_ok() {
                unnoticed.push(format!("{}, {name}", evaluation.name));
            }
        }
    }
    assert!(unnoticed.is_empty(), "{} of {count} numbers:\n{}", unnoticed.len(), unnoticed.join("\n"));
    let list = format!("{}\nEach of these {count} numbers, halved alone, makes a proof fail.\n", table());
    println!("{list}");
    fs::create_dir_all(folder()).unwrap();
    fs::write(folder().join("stages.md"), list).unwrap();
}
