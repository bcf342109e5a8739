//! A light that C patches by a universe has the words of the kernel's.

#[path = "support/compiler.rs"] // alone, because the rest of `support` is not packed
mod compiler;
#[path = "support/words.rs"]
mod words;

use std::fs;

use fastrand::Rng;
use luminaire::dmx::{Channel, Patch};
use luminaire::falloff::SoftOrHard;
use luminaire::light::IntegerCone;
use luminaire::{Fx16, Length, Rgb, Vec3};

use compiler::{compile_in_integers, run, write_headers};
use words::words;

const BUILDS: [(&str, &str); 3] = [
    ("cc", "-std=c99 -Os"),
    ("cc", "-std=c99 -O1 -fsanitize=undefined,address -fno-sanitize-recover=all"),
    ("c++", "-std=c++11 -O2"),
];

/// A channel of any ends and of none, one or two slots, with the ends of both domains.
fn channel(rng: &mut Rng, is_angle: bool) -> Channel {
    let mut end = || match (rng.u8(..4), is_angle) {
        (0, true) => [0.0, 270.0, -270.0, 18_000.0, -18_000.0][rng.usize(..5)],
        (0 | 1, false) => f32::from(rng.u8(..2)),
        (_, true) => 1_000.0 * rng.f32() - 500.0,
        (_, false) => rng.f32(),
    };
    let [from, to] = [end(), end()];
    let channel = if is_angle { Channel::degrees(from, to) } else { Channel::share(from, to) };
    let channel = channel.expect("ends within the domain");
    let slot = |rng: &mut Rng| [1, 512, rng.u16(1..=512), rng.u16(1..=512)][rng.usize(..4)];
    let placed = match rng.u8(..4) {
        0 => Ok(channel),
        1 => channel.at(slot(rng)),
        _ => channel.at_fine(slot(rng), slot(rng)),
    };
    placed.expect("slots of a universe")
}

fn patch(rng: &mut Rng) -> Patch {
    let patch = Patch::new()
        .with_pan(channel(rng, true))
        .with_tilt(channel(rng, true))
        .with_zoom(channel(rng, false))
        .with_dimmer(channel(rng, false))
        .with_color(Rgb::new((), (), ()).map(|()| channel(rng, false)))
        .with_white(channel(rng, false));
    if rng.bool() {
        return patch;
    }
    // Also one that mirrors, or is no rotation: it is not refused.
    let axes = [(); 3].map(|()| Vec3::from([(); 3].map(|()| rng.f32() - 0.5)));
    patch.with_mount(axes).expect("directions")
}

fn universe(rng: &mut Rng) -> Vec<u8> {
    let size = [0, 512, 512, rng.usize(..512)][rng.usize(..4)];
    (0..size).map(|_| [0, 255, rng.u8(..), rng.u8(..)][rng.usize(..4)]).collect()
}

#[test]
fn patched_lights_have_the_words_of_the_kernel() {
    const CASES: u32 = 3_000;
    let folder = tempfile::tempdir().expect("a folder");
    let main = folder.path().join("main.c");
    write_headers(folder.path());
    fs::write(&main, include_str!("dmx.c")).expect("a folder");
    let [position, down] =
        [[65_536, 262_144, -131_072], [0, -65_536, 0]].map(|words| Vec3::from(words.map(Length::from_bits)));
    let color = Rgb::new(16_384, 12_000, 3_000).map(Fx16::from_bits);
    let ends = [12, 50].map(|degrees| {
        let cone = IntegerCone::from_field(SoftOrHard::Soft, degrees << 16).expect("a cone");
        cone.light(position, down, Length::from_bits(16 << 16)).expect("a light").with_color(color)
    });

    let mut rng = Rng::with_seed(512);
    let (mut input, mut expected) = (vec![CASES], Vec::new());
    for _ in 0..CASES {
        let (patch, universe) = (patch(&mut rng), universe(&mut rng));
        for channel in patch.channels() {
            let [coarse, fine] = channel.slots().map(u32::from);
            input.push(fine << 16 | coarse);
            input.extend(channel.ends().map(|end| end as u32));
        }
        input.extend(patch.mount().as_flattened().iter().map(|word| *word as u32));
        input.push(universe.len() as u32);
        input.extend(universe.iter().copied().map(u32::from));
        expected.extend(words(&patch.state(&universe).light(&ends)));
    }
    for (compiler, flags) in BUILDS {
        let flags = format!("{flags} -Wconversion -Wshadow -Wundef -I{}", folder.path().display());
        let Some(found) = run(compiler, &flags, &main, &input) else { continue };
        assert_eq!(found.len(), expected.len(), "{compiler} {flags}");
        for (case, (found, expected)) in found.chunks_exact(22).zip(expected.chunks_exact(22)).enumerate() {
            assert_eq!(found, expected, "{compiler} {flags}: case {case}");
        }
    }
    let header = folder.path().join("header.c");
    fs::write(&header, "#include \"luminaire_dmx.h\"\nvoid (*patch)(luminaire_spot *, const luminaire_spot *, const luminaire_spot *, const luminaire_patch *, const uint8_t *, uint32_t) = luminaire_spot_patch;\n").expect("a folder");
    compile_in_integers(&header);
}
