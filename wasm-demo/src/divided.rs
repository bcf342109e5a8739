//! The difference between two pictures of one scene, in displayed codes.

use crate::{
    false_colour::{Palette, Scale, rgba},
    refusal::Refusal,
};
use wasm_bindgen::{Clamped, prelude::*};

/// Two pictures of one scene, camera and time in two number formats, compared pixel by pixel. The
/// difference of a pixel is the largest of its channels, in sRGB codes as displayed.
#[wasm_bindgen]
#[derive(Clone, PartialEq, Debug)]
pub struct Divided {
    /// The largest difference.
    pub largest: u8,
    /// Index of the pixel with the largest difference, the first if there are several, counted row
    /// by row.
    pub place: usize,
    /// How many pixels differ.
    pub differing: usize,
    /// How many pixels differ by more than one code.
    pub beyond: usize,
    /// The end of the scale of the false colours.
    pub end: f64,
    differences: Vec<u8>,
}

#[wasm_bindgen]
impl Divided {
    /// Compares two pictures: RGBA, sRGB, eight bits.
    #[wasm_bindgen(constructor)]
    pub fn new(one: &[u8], other: &[u8]) -> Result<Self, Refusal> {
        if one.len() != other.len() {
            let lengths = format!("{} and {} bytes", one.len(), other.len());
            return Err(Refusal::name("pictures", &lengths, "two pictures of one size"));
        }
        let pixels = |picture| <[u8]>::as_chunks::<4>(picture).0.iter();
        let difference = |(one, other): (&[u8; 4], &[u8; 4])| {
            one.iter().zip(other).map(|(one, other)| one.abs_diff(*other)).max().unwrap_or_default()
        };
        let differences: Vec<u8> = pixels(one).zip(pixels(other)).map(difference).collect();
        let largest = differences.iter().copied().max().unwrap_or_default();
        Ok(Self {
            largest,
            place: differences.iter().position(|&difference| difference == largest).unwrap_or_default(),
            differing: differences.iter().filter(|&&difference| difference > 0).count(),
            beyond: differences.iter().filter(|&&difference| difference > 1).count(),
            end: Scale::holding(f64::from(largest).max(1.0)).end,
            differences,
        })
    }

    /// The differences in false colours: RGBA. The same differences have the same colours in each
    /// picture with the same end of the scale.
    pub fn pixels(&self) -> Clamped<Vec<u8>> {
        let (palette, scale) = (Palette::new(), Scale { end: self.end });
        let colours: Vec<_> = (0..=u8::MAX).map(|code| palette.colour(scale, code.into())).collect();
        Clamped(rgba(self.differences.iter().map(|&difference| colours[usize::from(difference)])))
    }

    /// The colours of the scale from no difference to its end: red, green, blue of each.
    pub fn palette() -> Clamped<Vec<u8>> {
        Clamped(Palette::new().colours().concat())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_that_differ_are_counted_and_the_largest_is_found() {
        let one = [[10, 20, 30, 255], [0, 0, 0, 255], [9, 9, 9, 255], [200, 0, 0, 255]].concat();
        let other = [[10, 20, 30, 255], [0, 3, 1, 255], [9, 9, 8, 255], [203, 0, 0, 255]].concat();
        let divided = Divided::new(&one, &other).unwrap();
        assert_eq!((divided.largest, divided.place, divided.end), (3, 1, 5.0));
        assert_eq!((divided.differing, divided.beyond), (3, 2));
        let pixels = divided.pixels();
        let [first, .., last] = pixels.as_chunks::<4>().0 else { panic!("no pixels") };
        assert_eq!(first[..3], Palette::new().colours()[0]);
        assert_ne!(first, last);
        let same = Divided::new(&one, &one).unwrap();
        assert_eq!((same.largest, same.differing, same.end), (0, 0, 1.0));
    }

    #[test]
    fn pictures_of_two_sizes_are_refused() {
        let refusal = Divided::new(&[0; 8], &[0; 4]).unwrap_err().to_string();
        assert!(refusal.contains("8 and 4 bytes"), "{refusal}");
    }
}
