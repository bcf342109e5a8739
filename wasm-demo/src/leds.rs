//! The LEDs of a file on the tree, and as part of a job.

use luminaire::Vec3;
use luminaire_render::{Strip, scenes::tree};
use std::fmt::Write;

/// The most LEDs: each is a small sphere of the picture.
pub(crate) const MOST: usize = 2_000;

/// What stands for the scene's own LEDs in a job.
const OWN: &str = "-";

/// Returns LEDs at places in metres with the ways that they face, of which there may be none: three numbers for each LED.
/// `None` for numbers that are no such list.
pub(crate) fn strip(places: &[f32], facing: &[f32]) -> Option<Strip> {
    let vectors = |all: &[f32]| {
        let (vectors, []) = all.as_chunks() else { return None };
        all.iter().all(|c| c.is_finite()).then(|| vectors.iter().map(|&own| Vec3::from(own)).collect())
    };
    let (places, facing): (Vec<_>, Vec<_>) = vectors(places).zip(vectors(facing))?;
    let is_whole = (1..=MOST).contains(&places.len()) && [0, places.len()].contains(&facing.len());
    is_whole.then(|| Strip::new(places, tree::LIMIT).facing(facing))
}

/// Writes LEDs as a word of a job: the bits of their numbers, with a comma between places and ways.
pub(crate) fn written(strip: Option<&Strip>) -> String {
    let Some(strip) = strip else { return OWN.to_owned() };
    let mut text = String::new();
    for (i, vectors) in [strip.places(), strip.ways()].into_iter().enumerate() {
        text.extend((i > 0).then_some(','));
        for number in vectors.iter().flat_map(|own| [own.x, own.y, own.z]) {
            let _ = write!(text, "{:08x}", number.to_bits());
        }
    }
    text
}

/// Reads that word: `Some(None)` for the scene's own LEDs.
pub(crate) fn read(word: &str) -> Option<Option<Strip>> {
    if word == OWN {
        return Some(None);
    }
    let numbers = |text: &str| -> Option<Vec<f32>> {
        let (numbers, []) = text.as_bytes().as_chunks::<8>() else { return None };
        let number =
            |digits| Some(f32::from_bits(u32::from_str_radix(str::from_utf8(digits).ok()?, 16).ok()?));
        numbers.iter().map(|digits| number(digits)).collect()
    };
    let (places, facing) = word.split_once(',')?;
    strip(&numbers(places)?, &numbers(facing)?).map(Some)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::Stage;
    use luminaire_render::scenes::Example;

    /// LEDs can be undone, and what can't be drawn is refused and changes nothing.
    #[test]
    fn leds_are_a_step_of_the_stage() {
        let mut stage = Stage::of(Example::Tree).unwrap();
        stage.set_number(1, "beam", 9.0).unwrap();
        stage.begin();
        let lights = stage.state().lights.clone();
        stage.put_leds(&[0.0, 1.0, 0.0], &[]).unwrap();
        assert_eq!(stage.state().lights, lights, "the visitor's lights stay");
        stage.undo().unwrap();
        assert!(stage.state().leds.is_none());
        stage.redo().unwrap();
        let leds = stage.state().leds.clone();
        assert!(leds.is_some());
        for (places, facing) in [
            (&[][..], &[][..]),
            (&[0.0; 4], &[]),
            (&[0.0; 6], &[0.0; 3]),
            (&[0.0, f32::NAN, 0.0], &[]),
            (&[0.0; 3 * MOST + 3], &[]),
        ] {
            assert!(stage.put_leds(places, facing).is_err(), "{} numbers", places.len());
            assert_eq!(stage.state().leds, leds);
        }
        let refusal = stage.put_leds(&[0.0; 3 * MOST + 3], &[]).unwrap_err().to_string();
        assert_eq!(refusal, "LEDs = 2001: expected 1 to 2000 on the page");
    }
}
