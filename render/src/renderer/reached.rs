//! Bit sets: which lights may reach which tiles or regions of a picture.

use alloc::vec::Vec;

/// One bit for each pair of a place and a light. A place is a tile or a region.
#[derive(Clone, Default, Debug)]
pub(crate) struct Reached {
    /// Words per place.
    words: usize,
    bits: Vec<u64>,
}

impl Reached {
    /// Makes room for `places` places and `lights` lights. Returns true if this cleared the bits.
    pub(crate) fn make_room(&mut self, places: usize, lights: usize) -> bool {
        let words = lights.div_ceil(64);
        if words == self.words {
            return false;
        }
        self.words = words;
        self.bits.clear();
        self.bits.resize(words * places, 0);
        true
    }

    /// Clears all bits: no light reaches any place.
    pub(crate) fn forget(&mut self) {
        self.bits.fill(0);
    }

    /// Records whether a light reaches a place. Returns whether the light reaches the place now or
    /// reached it before the update. If so, the place must be re-lit if this light has changed.
    #[inline(always)]
    pub(crate) fn update(&mut self, place: usize, light: usize, reaches: bool) -> bool {
        let (word, bit) = (&mut self.bits[place * self.words + light / 64], 1 << (light % 64));
        let reached = *word & bit != 0;
        *word = if reaches { *word | bit } else { *word & !bit };
        reached || reaches
    }

    /// Returns the indices of the lights that may reach a place, in ascending order.
    pub(crate) fn lights(&self, place: usize) -> impl Iterator<Item = usize> + Clone {
        self.bits[place * self.words..][..self.words].iter().enumerate().flat_map(|(number, &word)| {
            let mut rest = word;
            core::iter::from_fn(move || {
                let bit = (rest != 0).then(|| rest.trailing_zeros() as usize)?;
                rest &= rest - 1;
                Some(64 * number + bit)
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_knows_its_lights() {
        let mut reached = Reached::default();
        assert!(reached.make_room(2, 130));
        assert!(!reached.make_room(2, 190));
        (0..130).for_each(|light| assert_eq!(reached.update(1, light, light % 63 == 0), light % 63 == 0));
        assert!(reached.lights(1).eq([0, 63, 126]));
        assert_eq!(reached.lights(0).count(), 0);
    }
}
