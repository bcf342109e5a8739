//! Distributions of intensity over all directions.

use crate::{
    error::{Error, Expected, Parameter},
    trig,
};

/// The planes about which a [`Distribution`] is symmetric. Its samples are those of one side.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Symmetry {
    /// No plane.
    None,
    /// The plane of the axis and the side: what is in front is the mirror image of what is behind.
    Bilateral,
    /// Two planes: that of the axis and the side, and that of the axis and the front.
    Quadrant,
}

/// A distribution of intensity over all directions: a table on an octahedron, unfolded to a square.
///
/// The components `a`, `b` and `c` of a direction along the side, the front and the axis of a light have the
/// place `x = a / s`, `y = b / s` with `s = |a| + |b| + |c|` on the square (Meyer et al., *On Floating-Point
/// Normal Vectors*, 2010). Directions against the axis, where `c < 0`, have the place
/// `x = sign(a) (1 - |y|)`, `y = sign(b) (1 - |x|)` instead: the corners of the square. In photometry of type C the axis is
/// the direction down, `gamma = 0`, the side is the plane C0, and the front is the plane C90.
///
/// The intensity is bilinear between samples, which stand at `size` even places of x and of y from -1 to 1, row by row
/// from `y = -1` on, and in each row from `x = -1` on. A symmetry leaves out the rows of `y < 0`, and that of two planes the
/// columns of `x < 0`, too. 65,535 is full intensity in every number format.
///
/// | symmetry | columns x rows | of size 65, the default of `luminaire import` | bytes |
/// |---|---|---|---|
/// | none | `size` x `size` | 65 x 65 | 8,450 |
/// | bilateral | `size` x `(size + 1) / 2` | 65 x 33 | 4,290 |
/// | quadrant | `(size + 1) / 2` x `(size + 1) / 2` | 33 x 33 | 2,178 |
///
/// ```
/// use luminaire::light::{Distribution, Symmetry};
/// // Brightest to the front and to the back, and dark behind: four cells.
/// let samples = [32_768, 16_384, 0, 65_535, 0, 0, 0, 0, 0];
/// let distribution = Distribution::new(&samples, 5, Symmetry::Quadrant)?;
/// let forward = distribution.exact([0.0, 1.0, 1.0]);
/// assert_eq!(forward, 1.0);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Distribution<'a> {
    samples: &'a [u16],
    symmetry: Symmetry,
    /// The number of cells between 0 and 1 of x, as a power of two.
    fineness: u8,
}

/// The largest power of two of the cells between 0 and 1.
const FINEST: u8 = 7;

/// The sample of full intensity.
pub(crate) const FULL: u16 = 65_535;

/// What keeps samples from being a distribution.
enum Fault {
    Size,
    Count(usize),
    /// The index of a sample on the edge of the square, and of the one for the same direction.
    Edge(usize, usize),
}

/// Returns a sample; 0 if there are not so many.
const fn sample(samples: &[u16], at: usize) -> u16 {
    if at < samples.len() { samples[at] } else { 0 }
}

impl<'a> Distribution<'a> {
    /// Creates a distribution of this symmetry from samples, whose size is that of the whole square: a power of
    /// two and one.
    ///
    /// # Errors
    /// A size other than 3, 5, 9, 17, 33, 65, 129 or 257; too few or too many samples; a sample on an edge of the square that
    /// differs from that of the same direction on the other half of this edge.
    pub const fn new(samples: &'a [u16], size: u32, symmetry: Symmetry) -> Result<Self, Error> {
        let (parameter, value, accepted) = match Self::checked(samples, size, symmetry) {
            Ok(distribution) => return Ok(distribution),
            Err(Fault::Size) => (Parameter::DistributionSize, size as f32, Expected::PowerAndOne(3, 257)),
            Err(Fault::Count(count)) => {
                (Parameter::SampleCount, samples.len() as f32, Expected::Exactly(count as f32))
            }
            Err(Fault::Edge(at, other)) => {
                let expected = Expected::Exactly(sample(samples, other) as f32);
                (Parameter::EdgeSample, sample(samples, at) as f32, expected)
            }
        };
        Err(Error { parameter, value, accepted })
    }

    /// Creates a distribution from samples that [`new`](Self::new) has accepted. Generated source calls this function.
    ///
    /// Any samples and any size are accepted: another size counts as one of the accepted ones, samples that are missing are
    /// 0, and where two samples of one direction differ, the light jumps, which no bound of its error holds.
    pub const fn from_parts(samples: &'a [u16], size: u32, symmetry: Symmetry) -> Self {
        let fineness = size.saturating_sub(1).trailing_zeros().saturating_sub(1);
        Self { samples, symmetry, fineness: if fineness > FINEST as u32 { FINEST } else { fineness as u8 } }
    }

    const fn checked(samples: &'a [u16], size: u32, symmetry: Symmetry) -> Result<Self, Fault> {
        let distribution = Self::from_parts(samples, size, symmetry);
        if size != distribution.size() {
            return Err(Fault::Size);
        }
        let [columns, rows] = distribution.shape();
        if samples.len() != columns * rows {
            return Err(Fault::Count(columns * rows));
        }
        // A direction behind with `b = 0` is on the edges `x = 1` and `x = -1`, at `y` and `-y`, and one with
        // `a = 0` on the edges of `y`. Mirrored samples are equal by themselves.
        let half = 1 << distribution.fineness;
        let mut i = 0;
        while i < half {
            let mirrored = columns - 1 - i;
            let top = columns * (rows - 1);
            let edges = [
                (columns * i, columns * mirrored),
                (columns * i + columns - 1, columns * mirrored + columns - 1),
                (i, mirrored),
                (top + i, top + mirrored),
            ];
            // A folded square has the last of the edges alone, or none.
            let mut edge = match symmetry {
                Symmetry::None => 0,
                Symmetry::Bilateral => edges.len() - 1,
                Symmetry::Quadrant => edges.len(),
            };
            while edge < edges.len() {
                let (at, other) = edges[edge];
                if sample(samples, at) != sample(samples, other) {
                    return Err(Fault::Edge(at, other));
                }
                edge += 1;
            }
            i += 1;
        }
        Ok(distribution)
    }

    /// Returns the samples: row by row, from the smallest y and in a row from the smallest x.
    pub const fn samples(self) -> &'a [u16] {
        self.samples
    }

    /// Returns the number of samples along a whole side of the square.
    pub const fn size(self) -> u32 {
        (2 << self.fineness) + 1
    }

    /// Returns the symmetry.
    pub const fn symmetry(self) -> Symmetry {
        self.symmetry
    }

    /// Returns the number of columns and of rows of the samples.
    pub const fn shape(self) -> [usize; 2] {
        let whole = (2 << self.fineness) + 1;
        let half = (1 << self.fineness) + 1;
        match self.symmetry {
            Symmetry::None => [whole, whole],
            Symmetry::Bilateral => [whole, half],
            Symmetry::Quadrant => [half, half],
        }
    }

    /// Returns the intensity in the direction with these components along side, front and axis, in `[0, 1]`: a
    /// model in f64. The direction has any length; one of length 0 or NaN has no intensity.
    pub fn exact(self, direction: [f64; 3]) -> f64 {
        let size = direction.iter().map(|c| c.abs()).sum::<f64>();
        if !(size > 0.0 && size < f64::INFINITY) {
            return 0.0;
        }
        let [a, b, c] = direction.map(|c| c / size);
        let [x, y] = if c < 0.0 { [1.0 - b.abs(), 1.0 - a.abs()] } else { [a.abs(), b.abs()] };
        let cells = f64::from(1 << self.fineness);
        let place = |folds, is_negative, size: f64| match (folds, is_negative) {
            (true, _) => cells * size,
            (false, true) => cells * (1.0 - size),
            (false, false) => cells * (1.0 + size),
        };
        let (x, y) = (place(self.folds_side(), a < 0.0, x), place(self.folds_front(), b < 0.0, y));
        let Corners { index: [i, j], samples } = self.corners([x as u32, y as u32]);
        let (u, v) = (x - f64::from(i), y - f64::from(j));
        let [near, far] = samples.map(|[from, to]| f64::from(from) + (f64::from(to) - f64::from(from)) * u);
        (near + (far - near) * v) / f64::from(FULL)
    }

    /// Returns whether the samples are those of `x >= 0` alone.
    #[inline]
    pub(crate) fn folds_side(self) -> bool {
        self.symmetry == Symmetry::Quadrant
    }

    /// Returns whether the samples are those of `y >= 0` alone.
    #[inline]
    pub(crate) fn folds_front(self) -> bool {
        self.symmetry != Symmetry::None
    }

    /// Returns the number of cells between 0 and 1 of x, as a power of two of at most 7.
    #[inline]
    pub(crate) fn fineness(self) -> u32 {
        u32::from(self.fineness & 7)
    }

    /// Returns the samples at the corners of the cell of a column and a row; of the last cell, if there are not so many.
    #[inline]
    pub(crate) fn corners(self, [column, row]: [u32; 2]) -> Corners {
        let [columns, rows] = self.shape();
        let index = [column.min(columns as u32 - 2), row.min(rows as u32 - 2)];
        let first = index[1] as usize * columns + index[0] as usize;
        let part = self.samples.get(first..first + columns + 2).unwrap_or_default();
        let samples = match (part.first_chunk(), part.last_chunk()) {
            (Some(near), Some(far)) => [*near, *far],
            _ => [[0; 2]; 2],
        };
        Corners { index, samples }
    }

    /// Calls a function with each cell.
    fn each_cell(self, mut call: impl FnMut(Corners)) {
        let [columns, rows] = self.shape().map(|count| count as u32);
        for row in 0..rows - 1 {
            for column in 0..columns - 1 {
                call(self.corners([column, row]));
            }
        }
    }

    /// Returns the largest sum of the magnitudes of the two derivatives with respect to x and y.
    pub(crate) fn steepness(self) -> f32 {
        let mut steepest = 0;
        self.each_cell(|Corners { samples: [[a, b], [c, d]], .. }| {
            let along = a.abs_diff(b).max(c.abs_diff(d));
            let across = a.abs_diff(c).max(b.abs_diff(d));
            steepest = steepest.max(u32::from(along) + u32::from(across));
        });
        (steepest << self.fineness) as f32 / f32::from(FULL)
    }

    /// Returns the largest sample.
    pub(crate) fn peak(self) -> u16 {
        self.samples.iter().fold(0, |peak, sample| peak.max(*sample))
    }

    /// Returns the versine of the largest angle off the axis with light; `None` where this angle exceeds a right angle,
    /// or if there is no light.
    ///
    /// Within a right angle the directions of a cell are convex, so that one of its corners is farthest from the axis.
    pub(crate) fn end(self) -> Option<f32> {
        let half = (1 << self.fineness) as f32;
        let left = if self.folds_side() { 0.0 } else { half };
        let top = if self.folds_front() { 0.0 } else { half };
        let mut farthest = -1.0_f32;
        self.each_cell(|Corners { index: [column, row], samples }| {
            if samples == [[0; 2]; 2] {
                return;
            }
            for (i, j) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                let (x, y) =
                    (((column + i) as f32 - left).abs() / half, ((row + j) as f32 - top).abs() / half);
                let along = 1.0 - x - y;
                let size = trig::sqrt(x * x + y * y + along * along);
                let versine = if along < 0.0 { f32::INFINITY } else { 1.0 - along / size };
                farthest = if versine > farthest { versine } else { farthest };
            }
        });
        (0.0..=1.0).contains(&farthest).then_some(farthest)
    }
}

/// A cell of a distribution: its column and row, and the samples at its corners, row by row.
pub(crate) struct Corners {
    pub(crate) index: [u32; 2],
    pub(crate) samples: [[u16; 2]; 2],
}
