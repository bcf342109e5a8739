//! Gobos for spotlights, computed at compile time.
//!
//! Each gobo is a square with any number of texels per side, row by row, for
//! [`Gobo::of`](luminaire::projector::Gobo::of). Texels that pass the light are white. The
//! transition at an edge of the pattern is one texel wide: where a texel covers a pixel or two, edges
//! look smooth.
//!
//! ```
//! use luminaire::projector::Gobo;
//! use luminaire_render::scenes::gobos;
//! const LEAVES: [u8; 32 * 32] = gobos::breakup();
//! assert_eq!(Gobo::of(&LEAVES).side(), 32);
//! ```

/// Half the side of a gobo in the coordinates of the patterns. Coordinates range from -[`HALF`] to
/// [`HALF`].
const HALF: i32 = 1 << 12;

/// Returns a window of two by three panes, taller than wide.
pub const fn window<const COUNT: usize>() -> [u8; COUNT] {
    /// Half the width and half the height of the window; `BAR` is half the width of a bar.
    const FRAME: [i32; 2] = [1_900, 2_700];
    const BAR: i32 = 150;
    let mut parts = [0; COUNT];
    let mut index = 0;
    while index < COUNT {
        let [x, y] = middle::<COUNT>(index);
        let (x, y) = (x.abs(), y.abs());
        let within = least([FRAME[0] - x, FRAME[1] - y]);
        let off_bars = least([x - BAR, (y - FRAME[1] / 3).abs() - BAR]);
        parts[index] = coverage::<COUNT>(least([within, off_bars]));
        index += 1;
    }
    parts
}

/// Returns a star of five points.
pub const fn star<const COUNT: usize>() -> [u8; COUNT] {
    /// The directions in which the five edges of the star face, clockwise from the top, as vectors
    /// of length 1,024.
    const FACING: [[i32; 2]; 5] = [[0, -1_024], [974, -316], [602, 828], [-602, 828], [-974, -316]];
    /// Distance of the five edges from the middle of the star.
    const EDGE: i32 = 1_150;
    let mut parts = [0; COUNT];
    let mut index = 0;
    while index < COUNT {
        let [x, y] = middle::<COUNT>(index);
        // A point is in the star if it is inside at least four of the five edges. So the coverage
        // follows from the second smallest distance to an edge.
        let (mut first, mut second) = (i32::MAX, i32::MAX);
        let mut edge = 0;
        while edge < FACING.len() {
            let left = EDGE - (FACING[edge][0] * x + FACING[edge][1] * y) / 1_024;
            second = least([second, if left > first { left } else { first }]);
            first = least([first, left]);
            edge += 1;
        }
        parts[index] = coverage::<COUNT>(second);
        index += 1;
    }
    parts
}

/// Returns a breakup: light through leaves, with round gaps of many sizes.
pub const fn breakup<const COUNT: usize>() -> [u8; COUNT] {
    let mut parts = [0; COUNT];
    let mut index = 0;
    while index < COUNT {
        let [x, y] = middle::<COUNT>(index);
        let mut deepest = i32::MIN;
        let mut gap = 0;
        while gap < GAPS.len() {
            let [left, top, radius] = GAPS[gap];
            let squared = (x - left) * (x - left) + (y - top) * (y - top);
            // `within` is the distance of the texel inside the circle, to first order.
            let within = (radius * radius - squared) / (2 * radius);
            deepest = if within > deepest { within } else { deepest };
            gap += 1;
        }
        parts[index] = coverage::<COUNT>(deepest);
        index += 1;
    }
    parts
}

/// The gaps between the leaves: centre and radius.
const GAPS: [[i32; 3]; 22] = [
    [-300, -250, 620],
    [820, 300, 480],
    [-900, 760, 540],
    [260, 1_150, 420],
    [900, -900, 560],
    [-1_350, -500, 380],
    [-500, -1_500, 520],
    [1_800, -250, 430],
    [1_500, 1_250, 560],
    [-350, 2_050, 480],
    [-1_900, 1_500, 430],
    [-2_250, 350, 520],
    [-1_800, -1_500, 480],
    [400, -2_350, 440],
    [1_750, -1_800, 500],
    [2_700, 500, 420],
    [850, 2_350, 520],
    [-1_200, 2_850, 380],
    [-3_050, -650, 360],
    [-900, -2_800, 360],
    [2_900, -1_150, 300],
    [2_300, 2_250, 340],
];

/// Returns the coordinates of the centre of a texel: to the right and down from the centre of the
/// square.
const fn middle<const COUNT: usize>(index: usize) -> [i32; 2] {
    let side = const { side(COUNT) };
    let (column, row) = (index as i32 % side, index as i32 / side);
    [(2 * column + 1 - side) * HALF / side, (2 * row + 1 - side) * HALF / side]
}

/// Returns the coverage of a texel whose centre is `within` units inside an edge.
const fn coverage<const COUNT: usize>(within: i32) -> u8 {
    let part = 2 * HALF / const { side(COUNT) };
    let within = least([within + part / 2, part]);
    if within > 0 { (within * 255 / part) as u8 } else { 0 }
}

/// Returns the side of a square of `count` texels.
const fn side(count: usize) -> i32 {
    let side = count.isqrt();
    assert!(side * side == count, "expected the square of a side");
    side as i32
}

const fn least([a, b]: [i32; 2]) -> i32 {
    if a < b { a } else { b }
}
