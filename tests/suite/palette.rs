//! Palettes against the stated distance in f64.

use luminaire::{
    Rgb,
    display::{Palette, decode_srgb},
    error::{Expected, Parameter},
};
use support::oracle;

const BLACK_AND_WHITE: [Rgb<u8>; 2] = [Rgb::new(0, 0, 0), Rgb::new(255, 255, 255)];

fn distance(a: Rgb<f64>, b: Rgb<u8>) -> f64 {
    let Rgb { red, green, blue } = a.zip(b, |a, b| (a - f64::from(b)).powi(2));
    let mean = (a.red + f64::from(b.red)) / 2.0;
    ((2.0 + mean / 256.0) * red + 4.0 * green + (2.0 + (255.0 - mean) / 256.0) * blue).sqrt()
}

/// The middle of each cell has the nearest colour, and in no corner is one farther than stated.
#[test]
fn colors_are_near() {
    let mut rng = fastrand::Rng::with_seed(1);
    let mut worst = 0.0_f64;
    for count in [1, 2, 3, 7, 16, 64, 256] {
        let colors: Vec<_> = (0..count).map(|_| Rgb::new(rng.u8(..), rng.u8(..), rng.u8(..))).collect();
        let palette = Palette::new(&colors).expect("a palette");
        for (cell, corner) in (0..16_u16.pow(3)).flat_map(|cell| (0..9_u16).map(move |corner| (cell, corner)))
        {
            let middle = Rgb::new(cell >> 8, cell >> 4 & 15, cell & 15).map(|part| 17.0 * f64::from(part));
            let sides = Rgb::new(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
            let place = match corner {
                8 => middle,
                _ => middle
                    .zip(sides, |middle, side| (middle + 16.98 * f64::from(side) - 8.49).clamp(0.0, 255.0)),
            };
            let color = palette.color(palette.nearest(place.map(|code| oracle::srgb_linear(code) as f32)));
            let least = colors.iter().map(|color| distance(place, *color)).fold(f64::INFINITY, f64::min);
            let excess = distance(place, color) - 1.009 * least;
            assert!(excess <= if corner == 8 { 0.0 } else { 52.0 }, "{place:?}: {color:?}, nearest {least}");
            worst = worst.max(excess);
        }
    }
    println!("a color of a corner is at most 1.009 d + {worst:.1} away");
    assert!(worst >= 45.0, "{worst}");
}

#[test]
fn zero_and_257_colors_are_refused() {
    for count in [0, 257] {
        let refused = Palette::new(&[Rgb::new(0, 0, 0); 257][..count]).unwrap_err();
        let accepted = Expected::WholeBetween(1, 256);
        assert_eq!((refused.parameter, refused.accepted), (Parameter::ColorCount, accepted));
    }
}

/// With black and white, the share of white pixels is the code's share of 255, within 2.5 pixels of
/// 64; without a spacing the dither changes nothing.
#[test]
fn dither_is_even_in_codes() {
    let palette = Palette::new(&BLACK_AND_WHITE).expect("a palette");
    let still = Palette::from_cells(&BLACK_AND_WHITE, *palette.cells(), 0);
    let one = Palette::new(&BLACK_AND_WHITE[1..]).expect("a palette");
    assert_eq!((palette.spacing(), one.spacing()), (255, 0));
    for code in 0..=255 {
        let color = Rgb::from([decode_srgb::<f32>(code); 3]);
        let white = |of: &Palette| (0..64).map(|i| u32::from(of.dithered(color, i % 8, i / 8))).sum::<u32>();
        let expected = f64::from(code) / 255.0 * 64.0;
        assert!((f64::from(white(&palette)) - expected).abs() <= 2.5, "{code}: {}", white(&palette));
        assert_eq!(white(&still), 64 * u32::from(palette.nearest(color)), "{code}");
    }
}
