//! Real powers of a fraction: a logarithm, a product and an exponential in integers.
//!
//! The results are bit-identical in every format. The logarithm and the exponential each use a
//! table of 64 segments and a series of three terms about the middle of a segment.

/// An exponent `p >= 0`, not necessarily an integer, and a floor `f` of the base `x`, for the power
/// `(x^p - f^p) / (1 - f^p)`.
///
/// The power is 0 for `x <= f`. With a floor of 0 the power is `x^p`.
/// [`Fraction::real_power`](super::Fraction::real_power) uses this type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RealExponent {
    /// The exponent `p` is `mantissa / 2^shift`, exactly as the given f32.
    mantissa: u32,
    shift: u32,
    /// Power of the floor, `f^p`, with 31 fraction bits.
    least: u32,
    /// `1 / (1 - least)`, with 27 fraction bits.
    gain: u32,
}

/// Number of bits of a table index.
const BITS: u32 = 6;
const SEGMENTS: usize = 1 << BITS;
const ONE: u64 = 1 << 31;
const GAIN_BITS: u32 = 27;

/// Returns the middle of a segment of [0, 1).
const fn middle(segment: usize) -> f64 {
    (segment as f64 + 0.5) / SEGMENTS as f64
}

/// `1 / c` with 31 fraction bits and `log2 c` with 32, for the middles `c` of segments of `[1, 2)`.
pub(crate) const LOGARITHMS: [(u32, u32); SEGMENTS] = {
    let (mut table, mut i) = ([(0, 0); SEGMENTS], 0);
    while i < SEGMENTS {
        let c = 1.0 + middle(i);
        // ln c = 2 (a + a^3 / 3 + a^5 / 5 + ...), with a <= 1/3.
        let a = (c - 1.0) / (c + 1.0);
        let (mut sum, mut power, mut n) = (0.0, a, 1.0);
        while n < 40.0 {
            sum += 2.0 * power / n;
            power *= a * a;
            n += 2.0;
        }
        let log2 = sum * core::f64::consts::LOG2_E;
        table[i] = ((2_147_483_648.0 / c + 0.5) as u32, (4_294_967_296.0 * log2 + 0.5) as u32);
        i += 1;
    }
    table
};

/// `2^-c` with 32 fraction bits, where `c` is the middle of a segment of [0, 1).
pub(crate) const POWERS: [u32; SEGMENTS] = {
    let (mut table, mut i) = ([0; SEGMENTS], 0);
    while i < SEGMENTS {
        let x = -middle(i) * core::f64::consts::LN_2;
        let (mut sum, mut term, mut n) = (0.0, 1.0, 1.0);
        while n < 24.0 {
            sum += term;
            term *= x / n;
            n += 1.0;
        }
        table[i] = (4_294_967_296.0 * sum + 0.5) as u32;
        i += 1;
    }
    table
};

/// Converts a constant to an integer with 32 fraction bits.
const fn fine(value: f64) -> i64 {
    (value * 4_294_967_296.0 + 0.5) as i64
}

/// Returns the product of two numbers with 32 fraction bits.
///
/// The product of the two integers must fit 64 bits.
fn times(a: i64, b: i64) -> i64 {
    (a * b) >> 32
}

/// Returns `log2 (significand / 2^31)` with 32 fraction bits, for a significand of at least 2^31.
///
/// The error is under 2e-9.
fn logarithm(significand: u32) -> i64 {
    const FIRST: i64 = fine(core::f64::consts::LOG2_E);
    const SECOND: i64 = fine(core::f64::consts::LOG2_E / 2.0);
    const THIRD: i64 = fine(core::f64::consts::LOG2_E / 3.0);
    let (reciprocal, logarithm) = LOGARITHMS[(significand >> (31 - BITS)) as usize % SEGMENTS];
    // significand = c (1 + z)
    let product = u64::from(significand) * u64::from(reciprocal);
    let z = (product as i64).wrapping_sub(1 << 62) >> 30;
    i64::from(logarithm) + times(z, FIRST - times(z, SECOND - times(z, THIRD)))
}

/// Returns `-log2 x` with 32 fraction bits, for `x = significand / 2^31 / 2^octaves` in `[0, 1]`.
///
/// The significand is at least 2^31, and there are at most 160 octaves, so that a product with an exponent fits 64
/// bits. The error is under 2e-9.
fn octaves_below_one(significand: u32, octaves: u32) -> u64 {
    let above = logarithm(significand);
    if octaves == 0 {
        return 0;
    }
    ((i64::from(octaves) << 32) - above).max(0) as u64
}

/// Returns `2^-octaves` with 31 fraction bits. `octaves` has 32 fraction bits. The error is under
/// 1e-9.
fn power_of_two(octaves: u64) -> u64 {
    let (whole, part) = (octaves >> 32, octaves & 0xffff_ffff);
    if octaves == 0 || whole > 31 {
        return if octaves == 0 { ONE } else { 0 };
    }
    const HALF_SEGMENT: i64 = 1 << (31 - BITS);
    let beyond = (part & ((1 << (32 - BITS)) - 1)) as i64 - HALF_SEGMENT;
    let x = times(beyond, fine(core::f64::consts::LN_2));
    let lost = x - times(x, x) / 2 + times(times(x, x), x) / 6;
    let middle = i64::from(POWERS[(part >> (32 - BITS)) as usize % SEGMENTS]);
    let power = (middle - times(middle, lost)) as u64;
    ((power >> whole) + 1) >> 1
}

/// The error of a real power of a number in `[0, 1]`: a constant and a multiple of the exponent.
const POWER_ERROR: [f64; 2] = [2e-9, 6.5e-10];

/// The relative error of an inverse power: a constant, which is that of the cap, and a multiple of the exponent.
#[cfg(feature = "fixed")]
pub(super) const INVERSE_POWER: [f64; 2] = [2e-8, 1.4e-9];

/// The power `min(x^-k, most)` of a number `x >= 0`, with an exponent `k` in `(0, 16]`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct InversePower {
    /// The exponent `k` is `mantissa / 2^shift`, exactly as the given f32.
    mantissa: u32,
    shift: u32,
    /// `log2 most`, with 24 fraction bits.
    most: i32,
}

impl InversePower {
    /// The octaves around 1 in which a number has a power of its own. With an exponent of 24 bits the
    /// product of exponent and logarithm fits 63 bits.
    const OCTAVES: i64 = 64;

    /// Precomputes an exponent in `(0, 16]`, and a cap in `[1, 2^64]`.
    pub(crate) fn new(exponent: f32, most: f32) -> Self {
        let RealExponent { mantissa, shift, .. } = RealExponent::new(exponent, 0.0);
        let bits = most.to_bits();
        let octaves = (i64::from(bits >> 23) - 127) << 32;
        let most = octaves + logarithm(bits << 8 | 1 << 31);
        Self { mantissa, shift, most: (most >> 8) as i32 }
    }

    /// Restores a power from its bits: any bits give a number with 31 bits.
    pub const fn from_bits([mantissa, shift, most]: [u32; 3]) -> Self {
        Self { mantissa: mantissa & ((1 << 24) - 1), shift: shift % 64, most: most as i32 }
    }

    /// Returns the mantissa and the shift of the exponent, and the logarithm of the cap.
    pub const fn to_bits(self) -> [u32; 3] {
        [self.mantissa, self.shift, self.most as u32]
    }

    /// Returns the exponent and the cap.
    pub(crate) fn parts(self) -> (f64, f64) {
        let octaves = f64::from(self.most) / f64::from(1 << 24);
        (f64::from(self.mantissa) / (1_u64 << self.shift) as f64, crate::trig::real_power(2.0, octaves))
    }

    /// Returns the power of `significand / 2^31 * 2^octaves`, as a number `n / 2^shift` with `n` in
    /// `(2^30, 2^31]`.
    ///
    /// The significand is at least 2^31, or 0 for the number 0. The relative error is under 1e-9
    /// plus 1.4e-9 times the exponent, and that of the cap under 2e-8.
    pub(super) fn of(self, significand: u32, octaves: i32) -> (u32, i32) {
        let most = i64::from(self.most) << 8;
        let power = if significand == 0 {
            most
        } else {
            // The logarithm of a power of two is exact.
            let above = if significand << 1 == 0 { 0 } else { logarithm(significand) };
            let octaves = i64::from(octaves).clamp(-Self::OCTAVES, Self::OCTAVES - 1);
            ((-((octaves << 32) + above) * i64::from(self.mantissa)) >> self.shift).min(most)
        };
        // 2^power = 2^-below / 2^whole, with `below` in [0, 1).
        let (whole, below) = (-power >> 32, -power & 0xffff_ffff);
        (power_of_two(below as u64) as u32, 31 + whole as i32)
    }
}

impl RealExponent {
    /// Precomputes an exponent in `[0, 1024]` and a floor of at least 0.
    ///
    /// The power of the floor must be at most 15/16.
    pub(crate) fn new(exponent: f32, floor: f32) -> Self {
        let bits = exponent.to_bits();
        let plain = Self {
            mantissa: bits & 0x7f_ffff | 0x80_0000,
            shift: (150 - (bits >> 23 & 0xff)).min(63),
            least: 0,
            gain: 1 << GAIN_BITS,
        };
        let (bits, zeros) = (floor.to_bits(), floor.to_bits().leading_zeros());
        // With a small exponent even a subnormal floor has a power near 1.
        let is_subnormal = floor > 0.0 && floor < f32::MIN_POSITIVE;
        let least = if is_subnormal { plain.of(bits << zeros, 118 + zeros) } else { plain.of_f32(floor) };
        // The gain is rounded up, so that the power of 1 is 1.
        let gain = (ONE << GAIN_BITS).div_ceil(ONE - least.min(ONE / 16 * 15));
        Self { least: least as u32, gain: gain as u32, ..plain }
    }

    /// Restores an exponent from its bits: any bits give powers in `[0, 1]`.
    pub(crate) const fn from_bits([mantissa, shift, least, gain]: [u32; 4]) -> Self {
        Self { mantissa: mantissa & ((1 << 24) - 1), shift: shift % 64, least, gain }
    }

    /// Returns the mantissa, the shift, the power of the floor and `1 / (1 - that power)`.
    pub const fn to_bits(self) -> [u32; 4] {
        [self.mantissa, self.shift, self.least, self.gain]
    }

    /// Returns the exponent, the power of the floor, and `1 / (1 - that power)`.
    pub(crate) fn parts(self) -> (f64, f64, f64) {
        let power = |n: u32, bits: u32| f64::from(n) / (1_u64 << bits) as f64;
        (power(self.mantissa, self.shift), power(self.least, 31), power(self.gain, GAIN_BITS))
    }

    /// Returns an upper bound of the error of a power, with the exact power of the floor.
    pub(crate) fn error(self) -> f64 {
        const STEP: f64 = 1.0 / ONE as f64;
        let (exponent, least, gain) = self.parts();
        let of_power = POWER_ERROR[0] + POWER_ERROR[1] * exponent;
        if least > 0.0 {
            // The error of the floor's power, too. The gain has 27 fraction bits, and multiplies up to its
            // reciprocal; the product is rounded down.
            2.0 * gain * of_power + 16.0 * STEP + STEP
        } else {
            // A power of the floor that is less than half a step is left out.
            of_power + STEP
        }
    }

    /// Returns the power of an f32 in `[0, 1]`, with 31 fraction bits.
    pub(super) fn of_f32(self, x: f32) -> u64 {
        let bits = x.to_bits();
        // A subnormal number is below the resolution of every format.
        if x < f32::MIN_POSITIVE {
            return 0;
        }
        self.of(bits << 8 | 1 << 31, 127_u32.saturating_sub(bits >> 23))
    }

    /// Returns the power of a number in `[0, 1]`; the number and its power have 31 fraction bits.
    #[cfg(feature = "fixed")]
    pub(super) fn of_bits(self, x: u32) -> u64 {
        let octaves = x.leading_zeros();
        if x == 0 { 0 } else { self.of(x << octaves, octaves) }
    }

    fn of(self, significand: u32, octaves: u32) -> u64 {
        let below = octaves_below_one(significand, octaves);
        let power = power_of_two((below * u64::from(self.mantissa)) >> self.shift);
        let above = power.saturating_sub(self.least.into());
        ((above * u64::from(self.gain)) >> GAIN_BITS).min(ONE)
    }
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use super::*;

    extern crate std;

    const EXPONENTS: [f32; 14] = [
        1e-30,
        1e-6,
        0.007_812_5,
        0.1,
        0.333_333_34,
        0.5,
        0.999_999,
        1.0,
        1.5,
        2.2,
        33.3,
        127.99,
        268.0,
        1_024.0,
    ];

    /// Numbers with 31 fraction bits: both ends, all powers of two with their neighbours, and a
    /// million others.
    fn numbers() -> impl Iterator<Item = u32> {
        let ends = (0..31).flat_map(|shift| [0, 1, 2].map(|i| (1_u32 << shift) + i - 1));
        ends.chain((0..1 << 20).map(|i| (i << 11) + (i * 1_667) % 2_048)).chain([(1 << 31) - 1, 1 << 31])
    }

    fn exact(x: u32) -> f64 {
        f64::from(x) / 2_147_483_648.0
    }

    #[test]
    fn real_powers_keep_their_error() {
        for exponent in EXPONENTS {
            let power = RealExponent::new(exponent, 0.0);
            assert_eq!((power.of_bits(0), power.of_bits(1 << 31)), (0, ONE), "{exponent}");
            let worst = numbers()
                .map(|x| (power.of_bits(x) as f64 / 2_147_483_648.0 - exact(x).powf(exponent.into())).abs())
                .fold(0.0, f64::max);
            std::println!("{exponent}: {worst:.1e}");
            let bound = POWER_ERROR[0] + POWER_ERROR[1] * f64::from(exponent);
            assert!(worst <= bound, "{exponent}: {worst:.1e}, expected at most {bound:.1e}");
        }
    }

    /// The power rises with its argument, or falls by at most one step of 2^-31.
    ///
    /// Tests the values around every boundary of the tables, and next to 1.
    #[test]
    fn real_powers_rise() {
        let seams =
            (0..64_u32).map(|i| (1 << 30) + (i << 24)).chain([(1 << 31) - 20_000, 1 << 20, 1 << 11, 3 << 4]);
        for exponent in EXPONENTS {
            let power = RealExponent::new(exponent, 0.0);
            let mut worst = 0;
            for seam in seams.clone() {
                let mut before = 0_u64;
                for x in seam.saturating_sub(1_000)..=(seam + 20_000).min(1 << 31) {
                    let here = power.of_bits(x);
                    worst = worst.max(before.saturating_sub(here));
                    before = here;
                }
            }
            std::println!("{exponent}: falls by {worst}");
            assert!(worst <= 1, "{exponent}: falls by {worst}");
        }
    }

    #[test]
    fn a_float_has_the_power_of_its_bits() {
        for exponent in EXPONENTS {
            let power = RealExponent::new(exponent, 0.0);
            for x in numbers().map(|x| x >> 7 << 7) {
                assert_eq!(power.of_f32(exact(x) as f32), power.of_bits(x), "{x} to {exponent}");
            }
            for tiny in [0.0, f32::MIN_POSITIVE, 1e-20] {
                assert!(power.of_f32(tiny) <= ONE);
            }
        }
    }

    #[test]
    fn any_bits_have_a_power_from_0_to_1() {
        let words = [0, 1, 0x80_0000, 0xff_ffff, 0x7fff_ffff, 1 << 31, u32::MAX];
        let bits = |i: usize| std::array::from_fn(|word| words[i / 7_usize.pow(word as u32) % 7]);
        for i in 0..7_usize.pow(4) {
            let power = RealExponent::from_bits(bits(i));
            for x in [0, 1, 12_345, 1 << 30, (1 << 31) - 1, 1 << 31] {
                assert!(power.of_bits(x) <= ONE, "{power:?} of {x}, expected power.of_bits(x) <= ONE");
            }
        }
    }

    #[test]
    fn a_floor_is_none_and_one_is_one() {
        for exponent in [0.007_812_5, 0.5, 1.5, 100.5] {
            let (floor, power) = (1e-4, RealExponent::new(exponent, 1e-4));
            assert_eq!((power.of_f32(floor), power.of_f32(0.0), power.of_f32(1.0)), (0, 0, ONE));
        }
    }

    /// For floors up to that whose power is 15/16, where the powers above it are magnified 16 times.
    #[test]
    fn real_powers_above_a_floor_keep_their_error() {
        let mut closest = 0.0_f64;
        for exponent in EXPONENTS.into_iter().filter(|exponent| *exponent >= 0.007) {
            for least in [1e-12, 1e-6, 0.01, 0.5, 0.9, 0.937] {
                let floor = least_f32(least, exponent);
                let (power, least) =
                    (RealExponent::new(exponent, floor), f64::from(floor).powf(exponent.into()));
                let error = |x: u32| {
                    let raised = exact(x).powf(exponent.into()).max(least);
                    (power.of_bits(x) as f64 / 2_147_483_648.0 - (raised - least) / (1.0 - least)).abs()
                };
                let worst = numbers().step_by(7).map(error).fold(0.0, f64::max);
                let bound = power.error();
                assert!(
                    worst <= bound,
                    "{exponent} above {floor}: {worst:.1e}, expected at most {bound:.1e}"
                );
                closest = closest.max(worst / bound);
            }
        }
        assert!(closest > 0.3, "at most {closest} of the bound");
    }

    /// Returns a floor with this power.
    fn least_f32(power: f64, exponent: f32) -> f32 {
        power.powf(1.0 / f64::from(exponent)) as f32
    }

    /// Tests the ends of the range: the smallest power above 0, and a float below all fractions.
    #[test]
    fn the_smallest_numbers_have_their_powers() {
        // The exact powers are 2^-31, 2^-31.62 and 2^-32.55, before rounding to 31 fraction bits.
        assert_eq!([1.0, 1.02, 1.05].map(|exponent| RealExponent::new(exponent, 0.0).of_bits(1)), [1, 1, 0]);
        // The largest number below 1 has a logarithm: 2.9 in units of 2^-32, and not 0.
        assert!((1..12).contains(&octaves_below_one(u32::MAX - 1, 1)));
        for exponent in [0.1, 0.5, 0.9] {
            for octaves in [30, 31, 32] {
                let exact = 0.5_f64.powf(f64::from(octaves) * f64::from(exponent));
                let found = RealExponent::new(exponent, 0.0).of_f32(0.5_f32.powi(octaves)) as f64;
                assert!(
                    (found / 2_147_483_648.0 - exact).abs() < 3e-9,
                    "2^-{octaves} to {exponent}: {found} / 2^31, expected {exact}"
                );
            }
        }
    }

    #[test]
    fn inverse_powers_keep_their_error() {
        for exponent in [0.01, 0.25, 0.5, 1.0, 1.7, 2.0, 3.3, 8.0, 16.0_f32] {
            let power = InversePower::new(exponent, 100.0);
            let mut worst = 0.0_f64;
            for x in numbers().filter(|x| *x > 0) {
                for octaves in [-20, -1, 0, 3, 40] {
                    let (zeros, number) = (x.leading_zeros(), exact(x) * 2.0_f64.powi(octaves));
                    let (n, shift) = power.of(x << zeros, octaves - zeros as i32);
                    assert!((1 << 30..=1 << 31).contains(&n), "{number} to {exponent}: {n}");
                    let found = f64::from(n) * 2.0_f64.powi(-shift);
                    let expected = number.powf(-f64::from(exponent)).min(100.0);
                    worst = worst.max((found / expected - 1.0).abs());
                }
            }
            let bound = INVERSE_POWER[0].max(1e-9 + INVERSE_POWER[1] * f64::from(exponent));
            assert!(worst <= bound, "{exponent}: {worst:.2e}, expected at most {bound:.2e}");
        }
    }

    #[test]
    fn inverse_powers_of_powers_of_two_are_exact() {
        for octaves in -30..30 {
            assert_eq!(InversePower::new(2.0, 1.8e19).of(1 << 31, octaves), (1 << 31, 31 + 2 * octaves));
        }
        assert_eq!(InversePower::new(2.0, 64.0).of(0, 0), (1 << 31, 31 - 6));
    }

    #[test]
    fn any_bits_have_an_inverse_power() {
        let words = [0, 1, 0x80_0000, 0xff_ffff, 0x7fff_ffff, 1 << 31, u32::MAX];
        for i in 0..7_usize.pow(3) {
            let power =
                InversePower::from_bits(std::array::from_fn(|word| words[i / 7_usize.pow(word as u32) % 7]));
            for (significand, octaves) in [(0, 0), (1 << 31, i32::MIN), (u32::MAX, i32::MAX), (3 << 30, -64)]
            {
                let (n, _) = power.of(significand, octaves);
                assert!((1 << 30..=1 << 31).contains(&n), "{power:?}: {n}");
            }
        }
    }

    #[test]
    fn bits_keep_a_mantissa_of_24_bits() {
        assert_eq!(RealExponent::from_bits([u32::MAX; 4]).to_bits(), [0xff_ffff, 63, u32::MAX, u32::MAX]);
    }
}
