//! A pool of light that is baked: no light is evaluated, a table of the lit floor is read.

use luminaire::{Fx16, number::Light16};

use super::values::{lit, nearest, root};
use crate::scene::{AXIS, INTENSITY, POSITION};

/// Texels along a side.
const SIDE: usize = 64;

/// The pool on the floor `y = 0` in a square whose side is a power of two, as irradiance in steps of 2^-14.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pool {
    /// The least `x` and `z`, in steps of 2^-16.
    corner: [i32; 2],
    /// The bits of the side, in the same steps.
    bits: u32,
    texels: [[u16; SIDE]; SIDE],
}

impl Pool {
    pub(crate) const fn new(outer: f32) -> Self {
        let outer = outer as f64;
        let height = POSITION.y as f64;
        // The nearest and the farthest lit point, along the direction in which the axis is tilted.
        let across = root((AXIS.x * AXIS.x + AXIS.z * AXIS.z) as f64);
        let tilt = across / -(AXIS.y as f64);
        let half = root(outer * (2.0 - outer)) / (1.0 - outer);
        let ends =
            [height * (tilt - half) / (1.0 + tilt * half), height * (tilt + half) / (1.0 - tilt * half)];
        let mut bits = 8;
        while (1_u64 << bits) as f64 <= 1.1 * 65_536.0 * (ends[1] - ends[0]) {
            bits += 1;
        }
        let side = (1_u64 << bits) as f64 / 65_536.0;
        let middle = (ends[0] + ends[1]) / 2.0 / across;
        let corner = [
            POSITION.x as f64 + middle * AXIS.x as f64 - side / 2.0,
            POSITION.z as f64 + middle * AXIS.z as f64 - side / 2.0,
        ];
        let corner = [nearest(65_536.0 * corner[0]), nearest(65_536.0 * corner[1])];
        let mut texels = [[0; SIDE]; SIDE];
        let mut place = 0;
        while place < SIDE * SIDE {
            let (row, column) = (place / SIDE, place % SIDE);
            let x = corner[0] as f64 / 65_536.0 + side * column as f64 / SIDE as f64 - POSITION.x as f64;
            let z = corner[1] as f64 / 65_536.0 + side * row as f64 / SIDE as f64 - POSITION.z as f64;
            let squared = x * x + height * height + z * z;
            let along = x * AXIS.x as f64 - height * AXIS.y as f64 + z * AXIS.z as f64;
            let t = 1.0 - (1.0 - along / root(squared)) / outer;
            if t > 0.0 {
                let light = INTENSITY as f64 * t * t * height / (squared * root(squared));
                texels[row][column] = nearest(16_384.0 * light) as u16;
            }
            place += 1;
        }
        Self { corner, bits, texels }
    }

    #[inline(always)]
    fn at(&self, point: [i32; 3], _: [i16; 3]) -> Light16 {
        let [u, v] =
            [(point[0], 0), (point[2], 1)].map(|(c, i)| c.wrapping_sub(self.corner[i]).cast_unsigned());
        if (u | v) >> self.bits != 0 {
            return Light16::ZERO;
        }
        // The square is dark along its sides, so that the next texel may be that of the other side.
        let [(column, right, x), (row, below, y)] = [u, v].map(|place| {
            let place = place >> (self.bits - 14);
            let texel = (place >> 8) as usize % SIDE;
            (texel, (texel + 1) % SIDE, (place & 255).cast_signed())
        });
        let along = |row: usize| {
            let [from, to] = [column, right].map(|column| i32::from(self.texels[row][column]));
            (from << 8) + (to - from) * x
        };
        let (from, to) = (along(row), along(below));
        Light16::from_bits((((from << 8) + (to - from) * y + 0x8000) >> 16).cast_unsigned())
    }
}

lit!(Pool: Fx16 => Light16);
