//! Cones from the angles of a data sheet, in integers.
//!
//! [`Cone`](crate::Cone) computes in `f32`, which costs a microcontroller without a floating-point unit
//! its library of floats. Here angles have steps of 2^-16 degrees, and the only function of an angle is
//! its chord `sqrt(1 - cos)`, by a polynomial. `export/c/src/luminaire.h` has the same operations in C,
//! with the same bits.

use core::fmt;

use crate::{
    color::Rgb,
    cone::CompiledCone,
    falloff::{CompiledCubic, Cubic, SoftOrHard},
    number::{
        Fraction, Fx16, Length, Weight16,
        fx16::{self, Gain16},
        fx32::Fine,
        ramp::{Chords, FixedRamp, LARGEST, MOST_ZOOM, chord_zoom},
        root::{self, high_half, inverse_32, sqrt_32},
    },
    shade::CompiledSpotLight,
    vec3::Vec3,
};

/// A cone of light from the angles of a data sheet, in integers: for [`Fx16`] on a processor without a
/// floating-point unit.
///
/// The falloff is the [`Cubic`] `t (1 + u (g + h t))` with `g` and `h` in steps of 2^-14, of which the
/// soft and the hard falloff are the cases `-1, 0` and `1, 0`.
///
/// Angles are full angles in steps of 2^-16 degrees.
///
/// ```
/// use luminaire::{Fx16, Length, Vec3, light::IntegerCone};
/// // The Fresnel of Hast 2004: beam angle 7 degrees, field angle 15.
/// let cone = IntegerCone::from_beam_and_field(7 << 16, 15 << 16)?;
/// let [position, down] = [[0, 4, 0], [0, -1, 0]].map(|[x, y, z]| Vec3::new(x, y, z).map(|c| Length::from_bits(c << 16)));
/// let light = cone.light(position, down, Length::from_bits(16 << 16))?;
/// // Half the light at 3.5 degrees off axis: 0.2446 m from the middle of the floor.
/// let half = light.falloff_at(Vec3::new(16_033, 0, 0).map(Length::from_bits));
/// assert!((half.to_f32() - 0.5).abs() < 0.0005);
/// # Ok::<(), luminaire::light::Refusal>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct IntegerCone {
    /// The chords of the inner and of the outer angle, with 31 fraction bits.
    inner: u32,
    outer: u32,
    /// The weights of the falloff, with 14 fraction bits.
    g: i32,
    h: i32,
}

/// Why an [`IntegerCone`] or its light is refused.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Refusal {
    /// An angle of 0, or an outer angle over 180 degrees.
    Angle = 1,
    /// An inner angle over the outer angle, or a beam angle over the field angle.
    Order,
    /// Two angles that no falloff has: the ratio of their versines is over 5.437.
    Ratio,
    /// A cone that is too narrow or an edge that is too steep for the format; see
    /// [`Cone::narrowest`](crate::Cone::narrowest).
    Steepness,
    /// A zero axis.
    Axis,
}

impl fmt::Display for Refusal {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Angle => "angle: expected more than 0, and a cone that ends within 180 degrees",
            Self::Order => "angles: expected inner at most outer, and beam at most field",
            Self::Ratio => "field angle: expected at most about 2.3 times the beam angle",
            Self::Steepness => "cone: expected a wider cone or a smaller inner angle for 16 bits",
            Self::Axis => "axis: expected a vector that is not zero",
        })
    }
}

impl core::error::Error for Refusal {}

/// 1 as a chord or a fraction with 31 fraction bits.
const ONE: u32 = 1 << 31;
/// 1 as a weight.
const UNIT: i32 = 1 << 14;
/// Half and a tenth of the intensity, with 31 fraction bits.
const HALF: u32 = ONE / 2;
const TENTH: u32 = 214_748_365;
/// The ratios of the versines of the hard and of the soft falloff, with 31 and 30 fraction bits.
const HARD_RATIO: u32 = 2_881_151_650;
const SOFT_RATIO: u32 = 2_506_698_000;
/// The weight `g` of the cubics: their edge slope, 1.34, less 1.
const CUBIC: i32 = 5_571;
/// The weights `h` of the monotone cubics with this edge slope: those with the largest and the smallest
/// ratio. Their middle slopes are 3.965 and 0.
const MOST_BENT: i32 = -54_149;
const LEAST_BENT: i32 = 10_813;
/// The number of fraction bits of an error in units of half a linear code.
const ERROR_BITS: u32 = 24;

impl IntegerCone {
    /// Creates the cone with this field angle, at which the intensity is 10 %.
    ///
    /// # Errors
    /// An angle of 0, or over 143.13 degrees for a soft and 174.11 for a hard falloff.
    pub fn from_field(edge: SoftOrHard, field: u32) -> Result<Self, Refusal> {
        // 1 / sqrt(u) at the field angle, with 31 fraction bits.
        let wider = match edge {
            SoftOrHard::Soft => 2_597_013_068,
            SoftOrHard::Hard => 2_204_800_193,
        };
        Self::open(edge, chord(field)?, wider)
    }

    /// Creates the cone with this beam angle, at which the intensity is 50 %.
    ///
    /// # Errors
    /// An angle of 0, or over 90 degrees for a soft and 145.93 for a hard falloff.
    pub fn from_beam(edge: SoftOrHard, beam: u32) -> Result<Self, Refusal> {
        // 1 / sqrt(u) at the beam angle, with 31 fraction bits.
        let wider = match edge {
            SoftOrHard::Soft => 3_968_032_378,
            SoftOrHard::Hard => 2_553_802_834,
        };
        Self::open(edge, chord(beam)?, wider)
    }

    /// Creates the cone with full intensity up to the inner angle, and no light from the outer angle on.
    ///
    /// # Errors
    /// An outer angle of 0 or over 180 degrees, or an inner angle over the outer angle.
    pub fn from_inner_and_outer(edge: SoftOrHard, inner: u32, outer: u32) -> Result<Self, Refusal> {
        if inner > outer {
            return Err(Refusal::Order);
        }
        let inner = if inner == 0 { 0 } else { chord(inner)? };
        Ok(Self { inner, outer: chord(outer)?, g: weight(edge), h: 0 })
    }

    /// Creates the cone with this beam angle (50 %) and this field angle (10 %), with the falloff of
    /// [`Cone::from_beam_and_field`](crate::Cone::from_beam_and_field).
    ///
    /// The weights of the falloff are rounded to their steps, which moves the intensities at the two
    /// angles by less than 0.0001 (derived from a step of a weight; a test of this module).
    ///
    /// # Errors
    /// A beam angle of 0 or over the field angle; a ratio of the versines over 5.437; an outer angle over
    /// 180 degrees.
    pub fn from_beam_and_field(beam: u32, field: u32) -> Result<Self, Refusal> {
        if beam > field {
            return Err(Refusal::Order);
        }
        let (beam, field) = (chord(beam)?, chord(field)?);
        // The two versines in the same unit, in which that of the field angle has 29 or 30 bits.
        let up = 31_u32.saturating_sub(root::bit_length(field));
        let versines = [beam, field].map(|chord| high_half(chord << up, chord << up));
        let [near, far] = versines;
        if far <= high_half(near << 1, HARD_RATIO) {
            // The hard falloff with a hotspot. With `b` and `f` as its versines at half and at a tenth,
            // the inner versine is lower by b / (f - b) and the outer one higher by (1 - f) / (f - b).
            let apart = far - near;
            let inner = near.saturating_sub(high_half(apart, 3_142_897_062) << 2);
            let outer = far + high_half(apart, 912_355_056);
            let [inner, outer] = [inner, outer].map(|versine| sqrt_32(versine) >> up);
            return Self { inner, outer, g: UNIT, h: 0 }.within(outer / 2);
        }
        if far <= high_half(near << 2, SOFT_RATIO) {
            let g = solve(versines, [-UNIT, UNIT], |g| [g, 0]);
            if let Ok(cone) = Self::fitted(field, [g, 0]) {
                return Ok(cone);
            }
        }
        let cubic = |h| [CUBIC, h];
        if !is_over(versines, cubic(MOST_BENT)) {
            return Err(Refusal::Ratio);
        }
        Self::fitted(field, cubic(solve(versines, [MOST_BENT, LEAST_BENT], cubic)))
    }

    /// Returns the cone with these weights and this chord of its field angle.
    fn fitted(field: u32, [g, h]: [i32; 2]) -> Result<Self, Refusal> {
        // `u` is over a quarter for all weights in use.
        let root = sqrt_32(versine_of([g, h], TENTH) << 1);
        let half = high_half(field, inverse_32(root | ONE));
        Self { inner: 0, outer: half << 1, g, h }.within(half)
    }

    /// Returns the cone in which an angle with this chord is at `1 / wider^2` of the outer versine.
    fn open(edge: SoftOrHard, chord: u32, wider: u32) -> Result<Self, Refusal> {
        let half = high_half(chord, wider);
        Self { inner: 0, outer: half << 1, g: weight(edge), h: 0 }.within(half)
    }

    /// Returns the cone, unless half its outer chord is that of more than 180 degrees.
    fn within(self, half: u32) -> Result<Self, Refusal> {
        if half > ONE / 2 { Err(Refusal::Angle) } else { Ok(self) }
    }

    /// Returns a white light with this cone and the inverse square of the distance. The axis may have
    /// any length; an intensity below 0 counts as 0.
    ///
    /// It is the light of [`SpotLight::compile`](crate::SpotLight::compile) but for the roundings of the
    /// angles and weights. It has the fine evaluation as far from its position, or a little farther: the
    /// bound of the steepness is up to 5 % too large.
    ///
    /// # Errors
    /// A cone that the format cannot hold, or a zero axis.
    pub fn light(
        self,
        position: Vec3<Length>,
        axis: Vec3<Length>,
        intensity: Length,
    ) -> Result<CompiledSpotLight<Fx16, Cubic>, Refusal> {
        let Self { inner, outer, g, h } = self;
        let error = self.coarse_error()?;
        let chords = Chords::open(inner, outer);
        let ramp = FixedRamp::of_chords(chords, MOST_ZOOM);
        let ramp = if error >= 1 << ERROR_BITS { ramp.into_fine() } else { ramp };
        let intensity = intensity.max(Length::ZERO).to_bits() as u32;
        let curve = CompiledCubic::from_parts(Weight16::from_bits(g), Weight16::from_bits(h));
        let light = CompiledSpotLight::from_parts(
            position,
            Vec3::default(),
            CompiledCone::from_parts(ramp, Cubic::exactly(slope(UNIT + g), slope(UNIT - g - h)), curve),
            fx16::outside_bound(chords),
            (),
            Gain16::from_bits([intensity as i32, 16]),
            fine_below(error, intensity),
            [Rgb::new(Fx16::ONE, Fx16::ONE, Fx16::ONE); 2],
        );
        light.aimed_along(axis).ok_or(Refusal::Axis)
    }

    /// Returns an upper bound of `Errors::coarse_error` in units of half a linear code, with
    /// [`ERROR_BITS`] fraction bits.
    fn coarse_error(self) -> Result<u32, Refusal> {
        let Self { inner, outer, .. } = self;
        let (steepness, slope) = if inner == outer { (1 << 14, 0) } else { self.slopes()? };
        // The narrowest cone has a chord of 1.55e-5 * 510 / sqrt(2) times the steepness.
        if steepness > 1 << 22 || outer < steepness * 733 {
            return Err(Refusal::Steepness);
        }
        let zoom = chord_zoom(outer, MOST_ZOOM);
        let chord = outer << zoom;
        // The reciprocal of the chord times 2^zoom, with 31 fraction bits.
        let up = 1 - (chord >> 31);
        let inverse = ((inverse_32(chord << up) >> (16 - up)) + 1) << 15;
        // The terms of `Errors::coarse_error`: of the direction, of the length, of its square and of
        // the argument. The last is that of the result, and of all roundings here.
        let direction = high_half(steepness << 8, ((4_629 << zoom) + 18_073) << 8);
        let direction = high_half(direction << 6, inverse) << 1;
        let length = high_half(steepness << 8, 885_588 << 8) << 2;
        let squared =
            high_half(high_half(high_half(slope << 14, 52_144 << (2 * zoom)), inverse), inverse) >> 2;
        let argument = high_half(slope << 14, 352_513 << 8) >> 4;
        Ok(direction + length + squared + argument + 705_032 + 256)
    }

    /// Returns upper bounds of the derivatives of the intensity with respect to the angle, in units of the
    /// outer half angle, and to the falloff's argument, with 14 fraction bits.
    fn slopes(self) -> Result<(u32, u32), Refusal> {
        /// The number of parts of the argument's range, as a power of two.
        const PARTS: u32 = 6;
        let Self { inner, outer, g, h } = self;
        let up = u32::BITS - root::bit_length(outer);
        let hotspot = high_half(inner << up, inverse_32(outer << up));
        // The difference of the two versines, in units of the outer one, with 31 fraction bits.
        let span = ONE - (high_half(hotspot, hotspot) << 1);
        if span >> 21 == 0 {
            return Err(Refusal::Steepness);
        }
        let derivative =
            |i: i32| UNIT + g + ((2 * (h - g) * i) >> PARTS) - ((3 * h * (i * i)) >> (2 * PARTS));
        // What the derivative, a parabola, rises above the chord of a part, and the roundings.
        let above = (h.unsigned_abs() >> 12) + 4;
        let (mut largest, mut steepest) = (0, 0);
        for i in 0..1 << PARTS {
            let slope = derivative(i).max(derivative(i + 1)).max(0) as u32 + above;
            // The root of the versine at the part's beginning, where it is largest.
            let root = (sqrt_32((ONE - (span >> PARTS) * i as u32) / 2) >> 17) + 1;
            largest = largest.max(slope);
            steepest = steepest.max((slope * root) >> 13);
        }
        let up = u32::BITS - root::bit_length(span);
        Ok((high_half(steepest << up, inverse_32(span << up)) + 1, largest))
    }
}

/// Returns the chord of half a full angle in steps of 2^-16 degrees, with 31 fraction bits: `sqrt(2)` times
/// the sine of a quarter of it. The error is at most 6 units (exhaustive).
fn chord(angle: u32) -> Result<u32, Refusal> {
    if angle == 0 || angle > 180 << 16 {
        return Err(Refusal::Angle);
    }
    // pi / 720 with 39 fraction bits: radians with 31.
    let x = high_half(angle << 8, 2_398_762_259);
    let squared = high_half(x, x) << 1;
    // 1 - x^2 / 6 (1 - x^2 / 20 (1 - x^2 / 42 (1 - x^2 / 72))), by reciprocals with 32 fraction bits.
    let mut series = ONE;
    for part in [59_652_324, 102_261_127, 214_748_365, 715_827_883] {
        series = ONE - high_half(high_half(squared, series) << 1, part);
    }
    Ok(high_half(high_half(x << 1, series) << 1, LARGEST))
}

/// Returns the `u` at which the falloff with these weights has an intensity, with 31 fraction bits: by
/// bisection with the evaluation of the light.
fn versine_of([g, h]: [i32; 2], intensity: u32) -> u32 {
    let [g, h] = [g, h].map(Weight16::from_bits);
    let mut versine = 0;
    for bit in (0..31).rev() {
        let t = Fine(ONE - (versine | 1 << bit));
        if Fraction::<Fx16>::cubic(t, g, h).0 > intensity {
            versine |= 1 << bit;
        }
    }
    versine
}

/// Returns whether the ratio of the versines at a tenth and at half of the intensity is over that of two
/// versines.
fn is_over([near, far]: [u32; 2], weights: [i32; 2]) -> bool {
    let [half, tenth] = [HALF, TENTH].map(|intensity| versine_of(weights, intensity));
    high_half(tenth, near) > high_half(half, far)
}

/// Returns the largest weight from the first to the second for which the ratio of the versines is still
/// over that of two versines; the ratio falls as the weight grows.
fn solve(versines: [u32; 2], [mut least, mut most]: [i32; 2], weights: impl Fn(i32) -> [i32; 2]) -> i32 {
    while most - least > 1 {
        let middle = (least + most) >> 1;
        if is_over(versines, weights(middle)) { least = middle } else { most = middle }
    }
    least
}

fn weight(edge: SoftOrHard) -> i32 {
    match edge {
        SoftOrHard::Soft => -UNIT,
        SoftOrHard::Hard => UNIT,
    }
}

/// Returns a number from 0 to 2^18 in steps of 2^-14 as a float, without a function for floats.
const fn slope(steps: i32) -> f32 {
    let (steps, bits) = (steps as u32, root::bit_length(steps as u32));
    if steps == 0 { 0.0 } else { f32::from_bits(((112 + bits) << 23) | ((steps << (24 - bits)) & 0x7f_ffff)) }
}

/// Returns the encoded distance within which points need the fine evaluation, for an error in units of half
/// a linear code and an intensity with 16 fraction bits: see `Errors::fine_below`.
fn fine_below(error: u32, intensity: u32) -> u32 {
    if error >= 1 << ERROR_BITS {
        return u32::MAX;
    }
    // The factors of `fine_squared`: 1.04 and 0.5556, and the least error, that of a cosine.
    let factor = (high_half(error, 2_481_735_183) + 1).max(1_045_869);
    // The product is the squared distance in units of the square of 2^-16, times 2^(up - 16).
    let up = u32::BITS - root::bit_length(intensity);
    let product = high_half(factor << 8, intensity << up);
    let length = (root::bit_length(product) + 16).saturating_sub(up);
    if intensity == 0 || length == 0 {
        return 0;
    }
    let bits = length.div_ceil(2);
    bits << 26 | product >> (2 * bits + up - 42)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Angle, Cone, SpotLight};
    use SoftOrHard::{Hard, Soft};

    extern crate std;

    const STEP: f64 = 1.0 / ONE as f64;

    /// Exhaustive over all angles.
    #[test]
    fn a_chord_is_within_six_units() {
        let mut worst = 0.0_f64;
        for angle in 1..=180 << 16 {
            let exact = core::f64::consts::SQRT_2 * (f64::from(angle) / 65_536.0 / 4.0).to_radians().sin();
            let found = f64::from(chord(angle).expect("an angle"));
            worst = worst.max((found - exact / STEP).abs());
        }
        assert!((5.0..=6.0).contains(&worst), "{worst} units");
        assert_eq!([0, (180 << 16) + 1, u32::MAX].map(chord), [Err(Refusal::Angle); 3]);
    }

    /// Returns the exact intensity of a cone at a full angle in steps.
    fn intensity(cone: IntegerCone, angle: u32) -> f64 {
        let [inner, outer] = [cone.inner, cone.outer].map(|chord| (f64::from(chord) * STEP).powi(2));
        let versine = 2.0 * (f64::from(angle) / 65_536.0 / 4.0).to_radians().sin().powi(2);
        let t = ((outer - versine) / (outer - inner)).clamp(0.0, 1.0);
        let [g, h] = [cone.g, cone.h].map(|weight| f64::from(weight) / f64::from(UNIT));
        t * (1.0 + (1.0 - t) * (g + h * t))
    }

    /// The angles of data sheets in degrees, with some beside the ends of what is accepted.
    fn angles() -> impl Iterator<Item = u32> {
        (0..180).map(|i| ((2 * i + 1) << 15) + 7 * i * i).chain([1, 50, 3_000, 179 << 16, 180 << 16])
    }

    #[test]
    fn a_single_angle_has_its_intensity() {
        for angle in angles() {
            for edge in [Soft, Hard] {
                if let Ok(cone) = IntegerCone::from_field(edge, angle) {
                    assert!((intensity(cone, angle) - 0.1).abs() < 40.0 / f64::from(cone.outer), "{cone:?}");
                }
                if let Ok(cone) = IntegerCone::from_beam(edge, angle) {
                    assert!((intensity(cone, angle) - 0.5).abs() < 40.0 / f64::from(cone.outer), "{cone:?}");
                }
            }
        }
    }

    /// One step of a weight moves the falloff by at most 2^-16 at any `t`, so at the beam angle by less
    /// than four times this: what it moves the place of a tenth is less than three times.
    #[test]
    fn two_angles_have_their_intensities() {
        let (mut worst, mut count) = (0.0_f64, 0);
        for beam in angles().step_by(4) {
            for field in angles().filter(|field| *field >= beam && beam > 1 << 15) {
                let cone = IntegerCone::from_beam_and_field(beam, field);
                let exact = Cone::from_beam_and_field(degrees(beam), degrees(field));
                let Ok(cone) = cone else {
                    assert!(exact.is_err(), "{beam} and {field}: {cone:?}, but {exact:?}");
                    continue;
                };
                if beam == field {
                    assert_eq!(cone.inner, cone.outer);
                    continue;
                }
                let error = (intensity(cone, beam) - 0.5).abs().max((intensity(cone, field) - 0.1).abs());
                count += 1;
                worst = worst.max(error);
            }
        }
        assert!(count > 500 && (1e-6..4.0 / 65_536.0).contains(&worst), "{worst} of {count} cones");
    }

    fn degrees(angle: u32) -> Angle {
        Angle::degrees(angle as f32 / 65_536.0)
    }

    /// The squared distance, in units of the square of 2^-16, within which points are evaluated finely.
    fn squared(fine_below: u32) -> f64 {
        if fine_below == u32::MAX {
            return f64::INFINITY;
        }
        f64::from(fine_below & ((1 << 26) - 1)) * (2.0 * f64::from(fine_below >> 26) - 26.0).exp2()
    }

    #[test]
    fn a_light_is_that_of_floats() {
        let [origin, down] = [[0, 0, 0], [0, -1 << 16, 0]].map(|v| Vec3::from(v).map(Length::from_bits));
        let (mut count, mut most) = (0, 0.0_f64);
        for (i, outer) in angles().enumerate() {
            for (j, share) in [0, 3, 9, 14, 15, 16].into_iter().enumerate() {
                let edge = [Soft, Hard][(i + j) % 2];
                let inner = outer / 16 * share;
                let Ok(cone) = IntegerCone::from_inner_and_outer(edge, inner, outer) else { continue };
                let cubic = Cubic::exactly(slope(UNIT + cone.g), slope(UNIT - cone.g));
                let exact = Cone::from_outer(cubic, degrees(outer)).expect("a cone");
                let exact = exact.with_inner(degrees(inner)).expect("a cone");
                let intensity = Length::from_bits(1 << (i % 31));
                let light = SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], exact).expect("a light");
                let light = light.with_intensity(intensity.to_f32()).expect("a light").compile::<Fx16>();
                let (found, exact) = match (cone.light(origin, down, intensity), light) {
                    (Ok(found), Ok(exact)) => (found, exact),
                    // Only steep edges have a larger bound.
                    (Err(Refusal::Steepness), _) if outer < 13 << 16 || share > 13 => continue,
                    (found, exact) => panic!("{cone:?}: {found:?}, but {exact:?}"),
                };
                count += 1;
                let (ramp, of_floats) = (found.cone.ramp, exact.cone.ramp);
                assert_eq!((found.position, found.intensity), (exact.position, exact.intensity));
                assert_eq!(ramp.zoom, of_floats.zoom, "{cone:?}");
                assert!((found.axis.y.to_bits() + (1 << 30)).abs() < 4, "{:?}", found.axis);
                assert!((0..3).contains(&(exact.outside.to_bits() - found.outside.to_bits())), "{cone:?}");
                let [ends, of_floats] = [ramp, of_floats].map(|ramp| f64::from(ramp.limit()));
                assert!(
                    (ends / of_floats - 1.0).abs() < 3e-7 + 1e-6 * 65_536.0 / f64::from(outer),
                    "{cone:?}"
                );
                let [fine, least] = [found, exact].map(|light| squared(light.fine_below));
                if fine < f64::INFINITY && least > 0.0 {
                    assert!(fine >= 0.999_999 * least, "{cone:?}: {fine}, but {least}");
                    most = most.max(fine / least);
                } else {
                    assert!(fine >= least, "{cone:?}: {fine}, but {least}");
                }
            }
        }
        assert!(count > 400 && most < 1.06, "{most} of {count} lights");
    }

    #[test]
    fn what_has_no_cone_is_refused() {
        type Made = Result<IntegerCone, Refusal>;
        let refused = |cone: Made| cone.expect_err("a refusal");
        let degrees = |degrees: u32| degrees << 16;
        assert_eq!(refused(IntegerCone::from_field(Soft, 0)), Refusal::Angle);
        assert_eq!(refused(IntegerCone::from_field(Soft, degrees(144))), Refusal::Angle);
        assert_eq!(refused(IntegerCone::from_beam(Hard, degrees(146))), Refusal::Angle);
        assert_eq!(refused(IntegerCone::from_inner_and_outer(Soft, 2, 1)), Refusal::Order);
        assert_eq!(refused(IntegerCone::from_beam_and_field(degrees(15), degrees(7))), Refusal::Order);
        assert_eq!(refused(IntegerCone::from_beam_and_field(degrees(5), degrees(12))), Refusal::Ratio);
        assert_eq!(refused(IntegerCone::from_beam_and_field(degrees(100), degrees(179))), Refusal::Angle);
        let cone = IntegerCone::from_field(Soft, degrees(1)).expect("a cone");
        let [down, zero] = [-1, 0].map(|y| Vec3::new(0, y, 0).map(Length::from_bits));
        assert_eq!(cone.light(zero, down, Length::ONE).expect_err("too narrow"), Refusal::Steepness);
        let cone = IntegerCone::from_field(Soft, degrees(9)).expect("a cone");
        assert_eq!(cone.light(zero, zero, Length::ONE).expect_err("no axis"), Refusal::Axis);
        assert!(std::format!("{}", Refusal::Axis).starts_with("axis"));
    }
}
