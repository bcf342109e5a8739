//! What a point takes when many are evaluated at once, for vector instructions.
//!
//! A processor with vectors computes a stage of several points in one instruction, as long as the stage has
//! no branch, no look-up, and no shift that differs from point to point. Four operations of a single point
//! have one of these, and are replaced; all other stages are the functions that a single point takes.
//!
//! | operation | one point | many points |
//! |---|---|---|
//! | bit length of an offset | an instruction or a table | the exponent of its size as f32, exact for 24 bits |
//! | scaled offset | a shift by the bit length | a product with `2^(31 - bits)`, then constant shifts |
//! | nodes of the root | a look-up within the root | look-ups in a loop of their own |
//! | light | a shift by twice the bit length | a product with the square of that power of two |

use super::root;

/// Number of bits that an offset is scaled to.
pub(super) const BITS: u32 = 31;

/// Returns a node and its difference to the next one.
const fn pair(nodes: &[u16], place: usize) -> u32 {
    if place + 1 < nodes.len() {
        (nodes[place] as u32) << 16 | nodes[place].wrapping_sub(nodes[place + 1]) as u32
    } else {
        0
    }
}

/// Builds a table of pairs of nodes from the place of each number of nine bits.
macro_rules! pairs {
    ($nodes:expr, $bits:ident => $place:expr) => {{
        let mut pairs = [0; 512];
        let mut $bits = 0;
        while $bits < pairs.len() {
            pairs[$bits] = pair(&$nodes, $place);
            $bits += 1;
        }
        pairs
    }};
}

/// The nodes of [`root::inverse_sqrt_16`] by the upper nine bits of its argument: a node in the upper 16 bits, and its
/// difference to the next in the lower ones. The root of a number below 2^30 is that of four times the number.
pub(super) static NODES: [u32; 512] = pairs!(root::NODES, bits => if bits < 128 { bits } else { bits >> 2 });

/// The nodes of [`root::quick_inverse_sqrt_16`] by the upper nine bits of its argument, as [`NODES`] has them.
pub(super) static QUICK_NODES: [u32; 512] = pairs!(root::QUICK_NODES, bits => bits >> 1);

/// Returns the bit length of a number, and `2^(31 - bits)`, for 1 to 24 bits.
///
/// Any other number has a bit length outside this range.
#[inline(always)]
pub(super) fn bits_and_power(number: u32) -> (u32, u32) {
    const BIAS: u32 = 126;
    let exponent = (number as i32 as f32).to_bits() >> 23;
    let bits = exponent.wrapping_sub(BIAS);
    // WebAssembly has no vector shift that differs from lane to lane; LLVM builds this power for x86.
    let power = if cfg!(target_arch = "wasm32") {
        f32::from_bits((2 * BIAS + BITS + 1).wrapping_sub(exponent) << 23) as i32 as u32
    } else {
        1 << (BITS.wrapping_sub(bits) & 31)
    };
    (bits, power)
}
