//! The worst case of calls: a search that climbs on instructions, which the counter counts exactly.

use std::cmp::Reverse;
use std::fs;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use luminaire_kernels::oracle::SplitMix64;
use tools::progress::Progress;
use tools::{command, project};

use crate::c::{Machine, SMALLEST, compiled, figure, machine};
use crate::counted::Firmware;
use crate::documents::kernels;
use crate::effects::{self, F32, FORMATS, Format, SUITED};
use crate::qemu::{Qemu, prints_the_same};
use crate::record::{Group, Line, MOST};
use crate::target::Board;

/// The program of calls in C, their number, and its light.
const IN_C: &str = "benches/firmware/src/worst.c";
const CALLS_IN_C: usize = 8;
const LIGHT_IN_C: Aim = Aim { position: [0.0, 4.0, 0.0], axis: [0.12, -0.963, 0.24] };

/// The programs of effects, the file of their points, and their light.
const IN_RUST: [&str; 3] = ["worst_effects", "worst_evaluations", "worst_choices"];
const POINTS: &str = "worst-inputs";
const LIGHT_IN_RUST: Aim = Aim { position: [1.5, 4.0, -0.75], axis: [0.36, -0.8, 0.48] };

/// A light at points that it does not reach: at the points of a search it is a lit point.
const OUTSIDE: &str = "outside";

/// Inputs of a call in each generation, and how many of the worst the next one begins with.
const COUNT: usize = 256;
const KEPT: usize = 32;
const GENERATIONS: usize = 8;

/// Where a light is, and along what.
#[derive(Clone, Copy)]
struct Aim {
    position: [f64; 3],
    axis: [f64; 3],
}

/// A point in steps of 2^-16 and a normal in steps of 2^-14, or the channels of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Input {
    point: [i32; 3],
    normal: [i16; 3],
}

impl Input {
    /// A point at any distance near the axis, as many in narrow cones as in wide ones, or any words: as many of each
    /// size.
    fn random(light: Aim, random: &mut SplitMix64) -> Self {
        let mut size = |bits| 2_f64.powf(random.between(0.0, bits));
        let (distance, aside, sizes) = (size(13.0) / 128.0, 0.5 / size(8.0), [(); 3].map(|()| size(24.0)));
        let is_near = random.below(2) == 0;
        let point = [0, 1, 2].map(|i| {
            let share = random.between(-1.0, 1.0);
            let near = light.position[i] + distance * (light.axis[i] + aside * share);
            (if is_near { 65_536.0 * near } else { sizes[i] * share }) as i32
        });
        Self { point, normal: [(); 3].map(|()| random.between(-16_384.0, 16_385.0) as i16) }
    }

    /// The same with one word moved by a step of any size.
    fn moved(mut self, random: &mut SplitMix64) -> Self {
        let (place, is_point) = (random.below(3) as usize, random.below(2) == 0);
        let bits = if is_point { 20.0 } else { 13.0 };
        let step = 2_f64.powf(random.between(0.0, bits)) as i32;
        let step = if random.below(2) == 0 { step } else { -step };
        if is_point {
            self.point[place] = self.point[place].saturating_add(step);
        } else {
            self.normal[place] = self.normal[place].saturating_add(step as i16).clamp(-16_384, 16_384);
        }
        self
    }

    fn in_c(self) -> String {
        let ([x, y, z], [a, b, c]) = (self.point, self.normal);
        format!("{{ {{ {x}, {y}, {z} }}, {{ {a}, {b}, {c} }} }},\n")
    }

    fn bytes(self) -> Vec<u8> {
        let point = self.point.map(|c| c as f32 / 65_536.0);
        let normal = self.normal.map(|c| f32::from(c) / 16_384.0);
        [point, normal].as_flattened().iter().flat_map(|c| c.to_le_bytes()).collect()
    }
}

/// Climbs from random inputs to the most expensive of each call. `count` returns the instructions of each call at each
/// of its inputs. Returns the most of each call.
fn climbed(
    calls: usize,
    light: Aim,
    mut count: impl FnMut(&[Vec<Input>]) -> Result<Vec<u64>>,
) -> Result<Vec<u64>> {
    let mut random = SplitMix64(1999);
    let mut set = || (0..COUNT).map(|_| Input::random(light, &mut random)).collect();
    let mut sets: Vec<Vec<_>> = (0..calls).map(|_| set()).collect();
    let mut most = vec![0; calls];
    for _ in 0..GENERATIONS {
        let counts = count(&sets)?;
        ensure!(counts.len() == calls * COUNT, "{} counts of {calls} calls at {COUNT} inputs", counts.len());
        for ((set, counts), most) in sets.iter_mut().zip(counts.chunks(COUNT)).zip(&mut most) {
            let mut order: Vec<_> = (0..COUNT).collect();
            order.sort_by_key(|place| Reverse(counts[*place]));
            *most = counts[order[0]].max(*most);
            let worst: Vec<_> = order[..KEPT].iter().map(|place| set[*place]).collect();
            let next = (KEPT..COUNT).map(|place| match place % 4 {
                0 => Input::random(light, &mut random),
                _ => worst[random.below(KEPT as u64) as usize].moved(&mut random),
            });
            *set = worst.iter().copied().chain(next.collect::<Vec<_>>()).collect();
        }
    }
    Ok(most)
}

/// Adds the most instructions that were found of each lit point with a price for the picker, on the processors of the page of effects, in
/// the formats that are no software floats there; and of calls in C on the smallest processor.
pub(crate) fn add(board: &'static Board, group: &mut Group, progress: &Progress) -> Result<()> {
    let is_here = SUITED.iter().any(|(suited, _)| *suited == board.name);
    // Arm's targets with registers of floats.
    let has_floats = board.target.ends_with("hf");
    for format in FORMATS.into_iter().filter(|format| is_here && (has_floats || *format != F32)) {
        for program in IN_RUST {
            add_rust(program, format, board, group, progress)?;
        }
    }
    machine(board)
        .filter(|_| board.name == SMALLEST)
        .map_or(Ok(()), |machine| add_c(machine, group, progress))
}

/// Adds those of the effects of a program in a format.
fn add_rust(
    program: &str,
    format: Format,
    board: &'static Board,
    group: &mut Group,
    progress: &Progress,
) -> Result<()> {
    let options = [&format.effects[..], &["--features", "worst"]].concat();
    let program = Firmware::new(program, &options).build(board, progress)?;
    let qemu = Qemu::find(board, progress)?;
    let count = |sets: &[Vec<Input>]| -> Result<_> {
        let points: Vec<u8> = sets.iter().flatten().flat_map(|input| input.bytes()).collect();
        fs::write(project::target().join(POINTS), points)?;
        let (found, mut counts) = qemu.totals(&program, progress)?;
        let lines = Line::all(&found)?;
        counts.resize(lines.len() * (COUNT + 1), 0);
        let calls = counts.chunks(COUNT + 1);
        let counts = calls.flat_map(|call| call[1..].iter().map(|count| count.saturating_sub(call[0])));
        Ok((lines, counts.collect::<Vec<_>>()))
    };
    // Without points a program takes those of the mean.
    let (lines, means) = count(&[])?;
    let most = climbed(lines.len(), LIGHT_IN_RUST, |sets| Ok(count(sets)?.1))?;
    for ((line, most), means) in lines.iter().zip(most).zip(means.chunks(COUNT)) {
        let (program, format) = line.name.split_once('.').context("a name has no format")?;
        let name = effects::figure(program, format);
        let kernel = name.split('.').next().unwrap_or_default();
        // It is on record with its mean, whose program may take an instruction or two more.
        if let Some(mean) = group.number(&name, "instructions")
            && kernels().any(|own| own == kernel)
            && kernel != OUTSIDE
        {
            let most = means.iter().copied().chain([most, mean.ceil() as u64]).max();
            group.add(&name, MOST, most);
        }
    }
    Ok(())
}

/// Adds those of the calls in C, whose last results must be the host's.
fn add_c(machine: &'static Machine, group: &mut Group, progress: &Progress) -> Result<()> {
    let (root, target) = (project::root(), project::target());
    let (define, include) = (format!("-DCOUNT={COUNT}"), format!("-I{}", target.display()));
    let common = ["-O3", &define, &include];
    let files: Vec<_> = machine.beside.iter().chain([&IN_C]).map(|file| root.join(file)).collect();
    let qemu = Qemu::find(machine.board, progress)?.with_console();
    let mut found = String::new();
    let most = climbed(CALLS_IN_C, LIGHT_IN_C, |sets| {
        let set = |set: &Vec<Input>| {
            format!("{{\n{}}},\n", set.iter().map(|input| input.in_c()).collect::<String>())
        };
        fs::write(target.join("worst-inputs.h"), sets.iter().map(set).collect::<String>())?;
        let program = compiled(machine.compiler, &[&common, machine.options].concat(), &files)?;
        let (text, counts) = qemu.totals(&program, progress)?;
        found = text;
        Ok(counts)
    })?;
    let host = compiled("cc", &common, &[root.join(IN_C)])?;
    prints_the_same(machine.board, &found, &command::answer(&mut Command::new(host))?)?;
    for (line, most) in Line::all(&found)?.iter().zip(most) {
        group.add(&figure(&line.name), MOST, most);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn climb_finds_what_is_rare_among_random_inputs() {
        let near = |c: &i32| u64::from(c.abs_diff(123_456).leading_zeros());
        let cost = |input: &Input| input.point.iter().map(near).sum();
        let count = |sets: &[Vec<Input>]| Ok(sets.iter().flatten().map(cost).collect());
        let most = climbed(1, LIGHT_IN_C, count).unwrap()[0];
        assert!(most > 57, "{most}");
    }
}
