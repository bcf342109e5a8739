//! A light that C sets up has the words of [`IntegerCone`], and each refusal its code.

#[path = "support/avr.rs"]
mod avr;
#[path = "support/compiler.rs"] // alone, because the rest of `support` is not packed
mod compiler;
#[path = "support/words.rs"]
mod words;

use std::fs;

use fastrand::Rng;
use luminaire::falloff::SoftOrHard;
use luminaire::light::{IntegerCone, Refusal};
use luminaire::{Length, Vec3};

use compiler::{bytes, run, write_headers};
use words::words;

const BUILDS: [(&str, &str); 5] = [
    ("cc", "-std=c99 -O0"),
    ("cc", "-std=c99 -Os"),
    ("cc", "-std=c99 -O1 -DLUMINAIRE_BY_PARTS -fsanitize=undefined,address -fno-sanitize-recover=all"),
    ("c++", "-std=c++11 -O2"),
    ("clang", "-std=c99 -O2"),
];

/// A way to set a light up, two angles, and the words of position, axis and intensity.
type Input = [u32; 10];

fn three(words: &[u32]) -> Vec3<Length> {
    Vec3::new(words[0], words[1], words[2]).map(|word| Length::from_bits(word as i32))
}

/// The code and the words of a light.
fn expected(input: &Input) -> [u32; 23] {
    let [way, first, second, ..] = *input;
    let edge = if way & 1 == 1 { SoftOrHard::Hard } else { SoftOrHard::Soft };
    let cone = match way >> 1 {
        0 => IntegerCone::from_field(edge, first),
        1 => IntegerCone::from_beam(edge, first),
        2 => IntegerCone::from_inner_and_outer(edge, first, second),
        _ => IntegerCone::from_beam_and_field(first, second),
    };
    let intensity = Length::from_bits(input[9] as i32);
    let light = match cone.and_then(|cone| cone.light(three(&input[3..]), three(&input[6..]), intensity)) {
        Ok(light) => light,
        Err(refusal) => return std::array::from_fn(|i| if i == 0 { refusal as u32 } else { 0 }),
    };
    let words = words(&light);
    std::array::from_fn(|i| if i == 0 { 0 } else { words[i - 1] })
}

fn input(rng: &mut Rng) -> Input {
    let degrees = |rng: &mut Rng| match rng.u8(..8) {
        0 => rng.u32(..),
        1 => [0, 1, 180 << 16, (180 << 16) + 1][rng.usize(..4)],
        2 => rng.u32(..181) << 16,
        _ => (rng.f32() * rng.f32() * 185.0 * 65_536.0) as u32,
    };
    let first = degrees(rng);
    // Most beam and field angles that a data sheet may have.
    let second = if rng.bool() { degrees(rng) } else { (first as f32 * (1.0 + 1.6 * rng.f32())) as u32 };
    let mut word = || match rng.u8(..8) {
        0 => 0,
        _ => (rng.i32(..) >> rng.u8(..32)) as u32,
    };
    let [way, words @ ..] = [(); 8].map(|()| word());
    let [x, y, z, along_x, along_y, along_z, intensity] = words;
    [way % 8, first, second, x, y, z, along_x, along_y, along_z, intensity]
}

#[test]
fn lights_have_the_words_of_the_kernel() {
    const BATCH: usize = 5_000;
    /// The lights that an AVR sets up, where an `int` has 16 bits.
    const AVR: usize = 300;
    let batches = if std::env::var_os("LUMINAIRE_FULL").is_some() { 200 } else { 1 };
    let folder = tempfile::tempdir().expect("a folder");
    let main = folder.path().join("main.c");
    write_headers(folder.path());
    fs::write(&main, include_str!("setup.c")).expect("a folder");
    let mut rng = Rng::with_seed(2027);
    let mut codes = [0; 6];
    for _ in 0..batches {
        let inputs: Vec<_> = (0..BATCH).map(|_| input(&mut rng)).collect();
        let answers: Vec<_> = inputs.iter().map(expected).collect();
        answers.iter().for_each(|answer| codes[answer[0] as usize] += 1);
        for (compiler, flags) in BUILDS {
            let flags = format!("{flags} -Wconversion -Wshadow -Wundef -I{}", folder.path().display());
            let Some(found) = run(compiler, &flags, &main, &inputs.concat()) else { continue };
            assert_eq!(found.len(), 23 * BATCH);
            for ((found, expected), input) in found.chunks_exact(23).zip(&answers).zip(&inputs) {
                assert_eq!(found, expected, "{compiler} {flags}: {input:?}");
            }
        }
    }
    let inputs: Vec<_> = (0..AVR).map(|_| input(&mut rng)).collect();
    let answers: Vec<_> = inputs.iter().map(expected).collect();
    avr::writes(&main, &bytes(&inputs.concat()), &bytes(&answers.concat()));
    println!("{codes:?} lights by their codes");
    assert!(codes.iter().all(|count| *count > 5) && codes[0] > BATCH / 8, "{codes:?}");
    assert_eq!(Refusal::Axis as u32, 5);
}

/// The angles that the README says are accepted, in hundredths of a degree.
#[test]
fn the_readme_states_the_accepted_angles() {
    type Made = Result<IntegerCone, Refusal>;
    let [place, down] = [0, -65_536].map(|y| Vec3::new(0, y, 0).map(Length::from_bits));
    let is_accepted = |cone: Made| cone.is_ok_and(|cone| cone.light(place, down, Length::ONE).is_ok());
    let degrees = |hundredths: u32| hundredths * 65_536 / 100;
    let row = |name: &str, cone: &dyn Fn(SoftOrHard, u32) -> Made| {
        let range = [SoftOrHard::Soft, SoftOrHard::Hard].map(|edge| {
            let accepted = (1..=18_000).filter(|angle| is_accepted(cone(edge, degrees(*angle))));
            let [least, most] =
                accepted.fold([18_000, 0], |[least, most], angle| [least.min(angle), most.max(angle)]);
            [least, most].map(|angle| format!("{:.2}", f64::from(angle) / 100.0)).join(" to ")
        });
        format!("| {name} | {} |", range.join(" | "))
    };
    let readme = include_str!("../c/README.md");
    for row in [
        row("field angle", &IntegerCone::from_field),
        row("beam angle", &IntegerCone::from_beam),
        row("outer angle, with an inner angle of 0", &|edge, outer| {
            IntegerCone::from_inner_and_outer(edge, 0, outer)
        }),
    ] {
        assert!(readme.contains(&row), "{row}");
    }
    let widest = [SoftOrHard::Soft, SoftOrHard::Hard].map(|edge| {
        let inner = |inner: &u32| {
            is_accepted(IntegerCone::from_inner_and_outer(edge, degrees(*inner), degrees(4_000)))
        };
        let widest = (0..4_000).rev().find(inner).expect("a cone");
        assert!(inner(&4_000));
        format!("to {:.2}, and 40", f64::from(widest) / 100.0)
    });
    let row = format!("| inner angle, with an outer angle of 40 | {} |", widest.join(" | "));
    assert!(readme.contains(&row), "{row}");
}
