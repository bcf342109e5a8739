//! Which lamps may reach which tiles.

use alloc::vec::Vec;

/// A bit for each pair of a tile and a lamp.
#[derive(Clone, Default, Debug)]
pub(crate) struct Reached {
    /// Words of a tile.
    words: usize,
    bits: Vec<u64>,
}

impl Reached {
    /// Makes room for so many tiles and lamps. Returns whether what was known had to be forgotten for it.
    pub(crate) fn make_room(&mut self, tiles: usize, lamps: usize) -> bool {
        let words = lamps.div_ceil(64);
        if words == self.words {
            return false;
        }
        self.words = words;
        self.bits.clear();
        self.bits.resize(words * tiles, 0);
        true
    }

    /// Takes every lamp for one that reaches no tile.
    pub(crate) fn forget(&mut self) {
        self.bits.fill(0);
    }

    /// Asks anew whether a tile is reached by the lamps that are others now. Returns whether one of them reaches it or
    /// has reached it, so that its light is another.
    pub(crate) fn update(&mut self, tile: usize, changed: &[usize], reaches: impl Fn(usize) -> bool) -> bool {
        let bits = &mut self.bits[tile * self.words..][..self.words];
        let mut is_another = false;
        for &lamp in changed {
            let (word, bit) = (&mut bits[lamp / 64], 1 << (lamp % 64));
            let (reached, reaches) = (*word & bit != 0, reaches(lamp));
            *word = if reaches { *word | bit } else { *word & !bit };
            is_another |= reached || reaches;
        }
        is_another
    }

    /// The lamps that may reach a tile, in their order.
    pub(crate) fn lamps(&self, tile: usize) -> impl Iterator<Item = usize> + Clone {
        self.bits[tile * self.words..][..self.words].iter().enumerate().flat_map(|(number, &word)| {
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
    fn a_tile_knows_its_lamps() {
        let mut reached = Reached::default();
        assert!(reached.make_room(2, 130));
        assert!(!reached.make_room(2, 190));
        let changed: Vec<_> = (0..130).collect();
        assert!(reached.update(1, &changed, |lamp| lamp % 63 == 0));
        assert!(reached.lamps(1).eq([0, 63, 126]));
        assert_eq!(reached.lamps(0).count(), 0);
    }

    #[test]
    fn what_is_forgotten_reaches_nothing() {
        let mut reached = Reached::default();
        reached.make_room(1, 3);
        reached.update(0, &[0, 1, 2], |_| true);
        reached.forget();
        assert_eq!(reached.lamps(0).count(), 0);
    }

    #[test]
    fn a_lamp_that_leaves_a_tile_changes_its_light_once() {
        let mut reached = Reached::default();
        reached.make_room(1, 1);
        assert!(!reached.update(0, &[0], |_| false));
        assert!(reached.update(0, &[0], |_| true));
        assert!(reached.update(0, &[0], |_| false));
        assert!(!reached.update(0, &[0], |_| false));
    }
}
