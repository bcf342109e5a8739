//! Stripes: the rows of a picture, dealt out to several renderers.

use crate::size::{MOST_SHARES, SizeError};
use core::ops::Range;

/// Every n-th stripe of a picture, for renderers that share the work of a picture.
///
/// A stripe is a row of tiles: 16 rows of pixels. Renderers with the same picture and the shares
/// `0`, `1`, ... `n - 1` of `n` draw every row once, and each pixel is bit-identical to that of a
/// renderer of the whole picture. The stripes of the shares alternate, so that the shares cost
/// about the same wherever the lights are.
///
/// ```
/// use luminaire_render::Stripes;
/// let rows: Vec<_> = Stripes::new(1, 2)?.rows(50).collect();
/// assert_eq!(rows, [16..32, 48..50]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Stripes {
    share: usize,
    count: usize,
}

impl Stripes {
    /// Rows per stripe; the last stripe of a picture may have fewer.
    pub const ROWS: usize = 16;

    /// The largest number of shares.
    pub const MOST: usize = MOST_SHARES;

    /// The whole picture.
    pub const ALL: Self = Self { share: 0, count: 1 };

    /// Returns the share with this index, of `count` shares.
    ///
    /// # Errors
    /// A count outside 1 to [`MOST`](Self::MOST), or an index that is not below the count.
    pub fn new(share: usize, count: usize) -> Result<Self, SizeError> {
        if (1..=Self::MOST).contains(&count) && share < count {
            Ok(Self { share, count })
        } else {
            Err(SizeError::Share(share, count))
        }
    }

    /// Returns the rows of the share in a picture of this height: a range for each stripe, from top
    /// to bottom.
    pub fn rows(self, height: usize) -> impl Iterator<Item = Range<usize>> {
        let starts = (self.share * Self::ROWS..height).step_by(self.count * Self::ROWS);
        starts.map(move |start| start..(start + Self::ROWS).min(height))
    }

    /// Returns the number of the share's rows in a picture of this height.
    pub(crate) fn height(self, height: usize) -> usize {
        self.rows(height).map(|rows| rows.len()).sum()
    }

    /// Returns the row of the picture that is the share's row with this number.
    #[inline]
    pub(crate) fn row(self, number: usize) -> usize {
        if self.count == 1 {
            return number;
        }
        let (stripe, rest) = (number / Self::ROWS, number % Self::ROWS);
        (stripe * self.count + self.share) * Self::ROWS + rest
    }

    /// Returns the number of a row among the share's rows; `None` if the row is in another share.
    #[inline]
    pub(crate) fn number(self, row: usize) -> Option<usize> {
        if self.count == 1 {
            return Some(row);
        }
        let (stripe, rest) = (row / Self::ROWS, row % Self::ROWS);
        (stripe % self.count == self.share).then(|| stripe / self.count * Self::ROWS + rest)
    }

    /// Returns the share's next rows in a range: those of one stripe, or of all stripes if the share
    /// is the whole picture. Returns an empty range if there are none.
    #[inline(always)]
    pub(crate) fn next(self, rows: Range<usize>) -> Range<usize> {
        if self.count == 1 {
            return rows;
        }
        let stripe = (rows.start / Self::ROWS) as u32;
        // Division of 32-bit numbers is several times faster than that of 64-bit numbers.
        let (share, count) = (self.share as u32, self.count as u32);
        let skipped = (share + count - stripe % count) % count;
        let first = (stripe + skipped) as usize * Self::ROWS;
        first.max(rows.start)..(first + Self::ROWS).min(rows.end)
    }

    /// Returns whether something that is dealt out by its number belongs to this share.
    pub(crate) fn has(self, number: usize) -> bool {
        number % self.count == self.share
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::ToString;

    #[test]
    fn a_share_beyond_the_count_is_rejected() {
        for (share, count) in [(0, 0), (1, 1), (2, 2), (0, Stripes::MOST + 1), (usize::MAX, usize::MAX)] {
            assert_eq!(Stripes::new(share, count), Err(SizeError::Share(share, count)));
        }
        let told = SizeError::Share(2, 2).to_string();
        assert_eq!(told, "share = 2 of 2: expected a share below the count, and a count of 1 to 64");
    }
}
