//! Errors of the stages, over every argument where that is possible.

use super::*;
use crate::{
    falloff::{
        CompiledFalloff, Cubic, Falloff, Hard, InvertedPower, Linear, Power, Quadratic, Smooth, Soft,
        SoftPair,
    },
    number::{Arithmetic, Directions, Errors, HALF_A_CODE, Lights, Scalar, proofs::model::Constants},
};

extern crate std;

/// Light counts as clipped only if it exceeds full scale by more than the error of its share.
#[test]
fn clipped_light_is_past_full_scale() {
    let (share, light) = (Fx16::from_bits((1 << 9) + 1), Light16::from_bits);
    let least = (0..1 << 16).find(|&bits| Fx16::is_clipped(share, light(bits)));
    let least = Fx16::light_to_f32(light(least.expect("some light is clipped")));
    assert!((1.07..1.2).contains(&least), "the least clipped light is {least}, expected 1.07 to 1.2");
    assert!(!Fx16::is_clipped(Fx16::from_bits(1 << 9), light(u32::MAX)));
}

/// `fine_below` encodes the distance of `fine_squared` over all intensities and exponents of a decay, up to
/// that of the farthest points: there it encodes all of them.
#[test]
fn points_are_near_below_the_encoded_distance() {
    const STEP: f64 = 1.0 / 65_536.0;
    let light = Vec3::new(-1.0, -1.0, -1.0).map(|c| Length::from_f32(c * Fx16::FARTHEST));
    let (mut near, mut far, mut all) = (0, 0, 0);
    for (step, growth) in
        (-90..=90).flat_map(|step| [0.25, 0.7, 1.0, 2.0, 3.0, 16.0].map(|growth| (step, growth)))
    {
        let intensity = 10.0_f64.powf(f64::from(step) / 10.0) as f32;
        // For an error of half a linear code, the squared distance is `BRIGHT * MOVING * intensity`.
        let exact = (0.5556 * 1.04 * f64::from(intensity)).powf(1.0 / f64::from(growth));
        let below = Fx16::fine_below(HALF_A_CODE, intensity, growth);
        let within = Fx16::fine_within(HALF_A_CODE, intensity, growth);
        if exact >= 65_536.0 {
            assert_eq!((below, within), (u32::MAX, f64::INFINITY), "{intensity} {growth}");
            all += 1;
            continue;
        }
        let least = (exact * exact * (1.0 - 4e-6) - STEP * STEP).max(0.0).sqrt();
        assert!(
            (least..=exact * (1.0 + 2e-6)).contains(&within),
            "{intensity} {growth}: {within}, not {exact}"
        );
        for i in 0..60_u32 {
            // Beside the distance, and from a few steps on to all of the coordinates.
            let size = [
                exact * (0.999_8 + 0.000_4 * f64::from(i) / 60.0),
                (f64::from(i) / 60.0 * 33.0).exp2() * STEP,
            ];
            let unit =
                [[1.0, 0.0, 0.0], [0.6, 0.8, 0.0], [0.48, 0.6, 0.64], [0.577, 0.577, 0.578]][i as usize % 4];
            for size in size {
                let way = Vec3::from(unit.map(|c: f64| (c * size / STEP) as i64));
                let room = i64::from(i32::MAX) - i64::from(light.x.to_bits());
                if way.x.max(way.y).max(way.z) > room {
                    continue;
                }
                let point = light.zip(way, |l, w| Length::from_bits((i64::from(l.to_bits()) + w) as i32));
                let Vec3 { x, y, z } = way.map(|c| c as f64 * STEP);
                let distance = (x * x + y * y + z * z).sqrt();
                if (distance / within - 1.0).abs() > crate::bound::NEARLY {
                    let is_near = Offset16::between(light, point).is_near(below);
                    assert_eq!(is_near, distance < within, "{intensity} {growth}: {distance} of {within}");
                    near += u32::from(is_near);
                    far += u32::from(!is_near);
                }
            }
        }
    }
    assert!(near > 10_000 && far > 10_000 && all > 50, "{near} near, {far} far, {all} of all points");
}

/// Evaluates a falloff at every `t`, and checks that both ends are exact and all values in
/// `[0, 1]`.
///
/// Returns the largest error and the largest decrease towards the axis, both in steps of `Fx16`
/// (2^-14).
fn over_all_t<P: Falloff>(falloff: P, exact: impl Fn(f64) -> f64) -> (f64, i32) {
    let curve = falloff.compile::<Fx16>();
    let at = |t: u16| i32::from(curve.intensity(Fraction16(t.into())).to_bits());
    assert_eq!((at(0), at(1 << 15)), (0, 1 << 14), "{falloff:?}");
    (0..=1 << 15).fold((0.0, 0), |(error, fall), t: u16| {
        let (here, next) = (at(t), at((t + 1).min(1 << 15)));
        assert!((0..=1 << 14).contains(&here), "{falloff:?} {t}: {here}, expected here in 0..=1 << 14");
        let difference = f64::from(here) - 16_384.0 * exact(f64::from(t) / 32_768.0);
        (f64::max(error, difference.abs()), fall.max(here - next))
    })
}

/// Exhaustive. The last rounding contributes half a step to the error; the rest of the error
/// comes from the products before the last rounding.
#[test]
fn sixteen_bits_are_monotone_and_keep_their_errors() {
    let within = |(error, fall): (f64, i32), bound: f64, most_fall: i32| {
        assert!(
            error <= bound && error > bound / 2.0,
            "error {error}, expected at most {bound} and more than half of it"
        );
        assert!(fall <= most_fall, "falls by {fall}, expected at most {most_fall}");
    };
    within(over_all_t(Linear, |t| t), 0.5, 0);
    within(over_all_t(Soft, |t| t * t), 0.5, 0);
    within(over_all_t(Hard, |t| 1.0 - (1.0 - t) * (1.0 - t)), 0.5, 0);
    within(over_all_t(Power::<4>, |t| t.powi(4)), 1.0, 0);
    within(over_all_t(Power::<15>, |t| t.powi(15)), 3.5, 0);
    within(over_all_t(Power::<16>, |t| t.powi(16)), 4.0, 0);
    within(over_all_t(InvertedPower::<4>, |t| 1.0 - (1.0 - t).powi(4)), 1.0, 0);
    within(over_all_t(Smooth, |t| t * t * (3.0 - 2.0 * t)), 1.3, 1);
}

/// Tests, at every `t`, quadratics with slopes in steps of 1/32 and monotone cubics with slopes
/// in steps of 1/8.
#[test]
fn all_blends_and_cubics_fall_by_a_step_at_most() {
    let (mut worst, mut fall) = (0.0_f64, 0);
    for slope in 0..=64_u8 {
        let a = f64::from(slope) / 32.0;
        let quadratic = Quadratic::new(a as f32).expect("sound");
        let (error, falls) = over_all_t(quadratic, |t| t * (a + (1.0 - a) * t));
        (worst, fall) = (worst.max(error), fall.max(falls));
    }
    assert!((0.5..=0.8).contains(&worst) && fall <= 1, "quadratics: {worst}, fall by {fall}");
    (worst, fall) = (0.0, 0);
    let mut count = 0;
    for (edge, middle) in (0..=32_u8).flat_map(|edge| (0..=32_u8).map(move |middle| (edge, middle))) {
        let slopes = (f32::from(edge) / 8.0, f32::from(middle) / 8.0);
        let Ok(cubic) = Cubic::with_slopes(slopes.0, slopes.1) else { continue };
        let [a, b, c] = cubic.coefficients().map(f64::from);
        let (error, falls) = over_all_t(cubic, |t| t * (a + t * (b + t * c)));
        (worst, fall, count) = (worst.max(error), fall.max(falls), count + 1);
    }
    assert!(count > 500, "only {count} cubics are monotone");
    assert!((0.5..=1.1).contains(&worst) && fall <= 1, "cubics: {worst}, fall by {fall}");
}

/// Tests, at every `t`, pairs with shares in steps of 1/8 and ratios up to the limit.
#[test]
fn all_soft_pairs_are_monotone() {
    let mut worst = 0.0_f64;
    for (share, octave) in (0..=8_u8).flat_map(|share| (0..=40_u8).map(move |octave| (share, octave))) {
        let (share, ratio) = (f32::from(share) / 8.0, (f32::from(octave) / 4.0).exp2());
        let (k, g) = (f64::from(share), f64::from(ratio));
        let exact = |t: f64| (1.0 - k) * t * t + k * (1.0 - g * (1.0 - t)).max(0.0).powi(2);
        let (error, falls) = over_all_t(SoftPair::new(share, ratio).expect("sound"), exact);
        assert_eq!(falls, 0, "{share} {ratio}");
        worst = worst.max(error);
    }
    assert!((1.0..=2.3).contains(&worst), "pairs: {worst}");
}

/// Coefficients that no falloff has also give results in `[0, 1]`.
#[test]
fn every_weight_has_an_answer() {
    let weights = [i32::MIN, -65_536, -1, 0, 65_536, i32::MAX].map(Weight16::from_bits);
    for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
        for t in [0, 1, 12_345, 16_384, 32_767, 32_768_u16] {
            let narrow = Fraction16(t.into());
            let gain = Gain16::from_bits([weights[i].to_bits(), weights[j].to_bits()]);
            let pair = narrow.soft_pair(weights[i], gain);
            for value in [narrow.quadratic(weights[i]), narrow.cubic(weights[i], weights[j]), pair] {
                assert!((Fx16::ZERO..=Fx16::ONE).contains(&value));
            }
        }
    }
    assert_eq!((Fx16::weight(f32::NAN), Fx16::weight(9.0)), (Weight16::ZERO, Weight16::from_bits(4 << 14)));
}

/// Evaluates lines of several slopes at every `t`. The rise of a line is rounded to nearest.
#[test]
fn a_line_is_the_nearest_value() {
    for slope in [-32_768, -12_345, -1, 0, 1, 7_777, 32_767] {
        let knot = Knot::from_bits(0, if slope < 0 { 65_535 } else { 0 }, slope);
        for t in 0..=1 << 15_u32 {
            let beyond = f64::from((1 << 15) - t) * 2.0;
            let exact = f64::from(knot.value) + (f64::from(slope) * beyond / 32_768.0 + 0.5).floor();
            let found = Fraction16(t).sample_knots(&[knot]);
            assert_eq!(found, Fraction16::of_sixteen_bits(exact.clamp(0.0, 65_535.0) as i32), "{slope} {t}");
        }
    }
}

#[test]
fn a_step_is_full_just_inside_its_edge() {
    assert_eq!((Fraction16(0).step(), Fraction16(1).step()), (Fx16::ZERO, Fx16::ONE));
}

/// Compares with the same products in 64 bits, truncated to 32 bits.
#[test]
fn vectors_that_are_not_of_unit_length_wrap() {
    let components = [i32::MIN, -(1 << 30), -12_345, 0, 65_536, 1 << 30, i32::MAX];
    let vectors = || (0..343).map(|i| Vec3::new(i / 49, i / 7 % 7, i % 7).map(|at: usize| components[at]));
    for (d, n) in vectors().flat_map(|d| vectors().map(move |n| (d, n.map(|c| c >> 16)))) {
        let normal = n.map(|c| Fx16::from_bits(c as i16));
        let products = d.zip(n, |d, n| i64::from(((d >> 14) + 1) >> 1) * i64::from(n));
        let cosine = (products.x + products.y + products.z + (1 << 13)) as i32 >> 14;
        let exact = d.zip(n, |d, n| (i64::from(d) - 4 * i64::from(cosine) * i64::from(n)) as i32);
        assert_eq!(Fx16::mirror(d.map(Fx32::from_bits), normal).map(Fx32::to_bits), exact, "{d:?} {n:?}");
        let products = d.zip(n, |d, n| i64::from(((d >> 15) + 1) >> 1) * i64::from(n));
        let along = (products.x + products.y + products.z) as i32;
        let expected = (1_i32 << 13).wrapping_sub(along) >> 14;
        assert_eq!(
            Fx16::incidence(d.map(Fx32::from_bits), normal),
            Fx16::from_bits(expected.clamp(0, 1 << 14) as i16)
        );
        let offset = Offset16::new(d.map(|c| c >> 2));
        let products = normal.zip(offset.way(), |n, v| i64::from(n.to_bits()) * i64::from(v >> 2));
        assert_eq!(offset.facing(normal), (products.x + products.y + products.z) as i32, "{d:?} {n:?}");
    }
}

/// With a normal longer than 1 the cosine wraps, like a 64-bit sum truncated to 32 bits.
#[test]
fn the_cosine_of_a_long_normal_wraps() {
    let ways = [Vec3::new(1 << 20, 1 << 20, 1 << 20), Vec3::new(-(1 << 20), 0, 0), Vec3::new(1 << 20, 0, 0)];
    let rays = ways.map(|way| Fx16::fine_ray(&Offset16::new(way)));
    for (ray, n) in
        rays.into_iter().flat_map(|ray| [i16::MIN, -20_000, 1 << 14, 30_000, i16::MAX].map(|n| (ray, n)))
    {
        let product =
            |d: i32| (i64::from(d >> 14) * i64::from(n)) + ((i64::from(d & 0x3fff) * i64::from(n)) >> 14);
        let along = (product(ray.direction.x) + product(ray.direction.y) + product(ray.direction.z)) as i32;
        let normal = Vec3::new(n, n, n).map(Fx16::from_bits);
        assert_eq!(ray.cosine(0, normal), Fine::capped(along.min(0).unsigned_abs(), -1), "{n}");
    }
}

/// The proofs are about a model of the stages. It has the bits of the kernel.
#[test]
fn the_model_of_the_proofs_has_the_bits_of_the_coarse_stages() {
    let model = Constants::KERNEL;
    let mut random = fastrand::Rng::with_seed(1);
    for _ in 0..200_000 {
        let bits = random.u32(1..=32);
        let way = Vec3::new(random.i32(..), random.i32(..), random.i32(..)).map(|c| c >> (32 - bits));
        let offset = Offset16::new(way);
        let ray = offset.ray();
        let reciprocal = i128::from(ray.reciprocal);
        let components = |direction: Vec3<Fx32>, way: Vec3<i32>, multiplier: i128, cut_off: i64| {
            let exact = way.map(|c| i128::from(c) * multiplier + i128::from(cut_off));
            assert_eq!(direction.map(|c| i128::from(c.to_bits())), exact, "{way:?}");
        };
        components(ray.direction(), offset.way(), model.fourteen_bits(reciprocal), model.cut_off);
        let quick = QuickOffset16 { way: offset.coarse(), bits: offset.bits }.ray();
        let multiplier = i128::from(quick.reciprocal);
        components(quick.direction(), offset.coarse(), multiplier, model.quick_cut_off);

        let normal =
            Vec3::new(random.i16(..), random.i16(..), random.i16(..)).map(|c| Fx16::from_bits(c / 2));
        let facing = offset.facing(normal).min(0);
        let cosine = model.cosine(-i128::from(facing), reciprocal).min(1 << 15);
        assert_eq!(i128::from(ray.cosine(facing, normal).0), cosine, "{way:?} {normal:?}");

        let components = ray.direction().map(|c| model.rounded_component(i128::from(c.to_bits())));
        let products = components.zip(normal, |c, n| c * i128::from(n.to_bits()));
        let incidence = model.incidence(products.x + products.y + products.z, 14).clamp(0, 1 << 14);
        assert_eq!(
            i128::from(Fx16::incidence(ray.direction(), normal).to_bits()),
            incidence,
            "{way:?} {normal:?}"
        );

        let mantissa = random.u32(1 << 31..);
        let rounded = model.normalised(i128::from(mantissa));
        let gain = Gain16::normalised(mantissa, 0);
        assert_eq!(i128::from(gain.mantissa) << -gain.shift, rounded << 16, "{mantissa}");
        let share = random.u32(0..=1 << 14);
        let squared = model.squared_reciprocal(reciprocal);
        let product = i128::from(share) * model.attenuated(i128::from(gain.factor()), squared);
        let shift = gain.scale() + 2 * offset.bits as i32 - 32;
        let light = ray.light(Fx16::from_bits(share as i16), gain);
        assert_eq!(light, Light16::shifted(product as u32, shift), "{way:?} {gain:?} {share}");
        let (lit, shift) = (random.u32(..), random.u32(1..=32));
        let exact = model.quotient(i128::from(lit), 1 << shift, 1);
        assert_eq!(i128::from(Light16::shifted(lit, shift as i32).to_bits()), exact, "{lit} {shift}");

        let axis = Vec3::new(random.i32(..), random.i32(..), random.i32(..)).map(|c| c / 3);
        let apart = quick.direction().zip(axis, |d, s| i128::from(d.to_bits()) - i128::from(s));
        let Vec3 { x, y, z } = apart.map(|c| model.difference(c, 1 << 16));
        let ramp = FixedRamp::new(0.0, 2.0, 2.0);
        let t = ramp.rise(Versine::from_bits((x * x + y * y + z * z) as u32));
        assert_eq!(quick.rise(Fx16::quick_axis(axis.map(Fx32::from_bits)), ramp), t, "{way:?} {axis:?}");

        let zoom = random.u32(0..=MOST_ZOOM);
        let ramp = FixedRamp::from_bits([zoom, 0, 0, 0, 0, 0, 0, 0, 0]);
        let apart =
            Vec3::new(random.i32(..), random.i32(..), random.i32(..)).map(|c| c >> random.u32(2..=20));
        let axis = ray.direction().zip(apart, |d, apart| Fx32::from_bits(d.to_bits() - apart));
        let steps = apart.map(|c| model.difference(i128::from(c), 1 << (16 - zoom)));
        let is_near = [steps.x, steps.y, steps.z].iter().all(|c| (-32_768..32_768).contains(c));
        let squared = steps.x * steps.x + steps.y * steps.y + steps.z * steps.z;
        let exact = if is_near { squared } else { Versine::MAX.to_bits().into() };
        assert_eq!(i128::from(versine(ray.direction(), axis, ramp).to_bits()), exact, "{apart:?} {zoom}");
    }
}

/// The offset between two places is that of their difference, or of half of it where that has more than 24 bits. The
/// light is within the farthest coordinates, and the point anywhere.
#[test]
fn an_offset_is_that_of_the_difference() {
    let mut random = fastrand::Rng::with_seed(4);
    let farthest = Length::from_f32(Fx16::FARTHEST).to_bits();
    for step in 0..400_000 {
        let light = [(); 3].map(|()| random.i32(-farthest..=farthest));
        // Nearby in most cases, so that there are offsets of all bit lengths.
        let reach = if step % 4 == 0 { 32 } else { random.u32(1..=25) };
        let point = light.map(|c| c.saturating_add(random.i32(..) >> (32 - reach)));
        let point = if step % 8 == 0 { [(); 3].map(|()| random.i32(..)) } else { point };
        let [way, half] = [0, 1].map(|down| {
            let component = |i: usize| i64::from(point[i] >> down) - i64::from(light[i] >> down);
            [component(0), component(1), component(2)]
        });
        let is_long = way.iter().any(|c| !(-(1 << 24)..1 << 24).contains(c));
        let [light, point] = [light, point].map(|place| Vec3::from(place.map(Length::from_bits)));
        let exact = Offset16::new(Vec3::from((if is_long { half } else { way }).map(|c| c as i32)));
        let (found, quick) = (Offset16::between(light, point), QuickOffset16::between(light, point));
        let bits = exact.bits + u32::from(is_long);
        assert_eq!((found.way(), found.bits), (exact.way(), bits), "{light:?} {point:?}");
        assert_eq!((quick.way, quick.bits), (exact.coarse(), bits), "{light:?} {point:?}");
    }
}

/// Points along x share what they can: on the common path, and only there, a stretch has the point that it was made of.
#[test]
fn a_stretch_has_its_point_and_the_offsets_of_others() {
    let mut random = fastrand::Rng::with_seed(7);
    let mut others = 0;
    for _ in 0..100_000 {
        let light = Vec3::from([(); 3].map(|()| random.i32(-(1 << 29)..1 << 29)));
        let point = light.map(|c| c + (random.i32(..) >> random.u32(2..32)));
        let other = Vec3 { x: point.x.wrapping_add(random.i32(..) >> random.u32(0..32)), ..point };
        let [light, point, other] = [light, point, other].map(|place| place.map(Length::from_bits));
        let (offset, stretch) = (QuickOffset16::between(light, point), QuickOffset16::stretch(light, point));
        let is_common = (COARSE_BITS + 1..COARSE_BITS + 8).contains(&offset.bits);
        assert_eq!(QuickOffset16::is_in(&stretch, point.x), is_common, "{light:?} {point:?}");
        if QuickOffset16::is_in(&stretch, other.x) {
            let (found, expected) =
                (QuickOffset16::on_stretch(&stretch, other.x), QuickOffset16::between(light, other));
            assert_eq!(
                (found.way, found.bits),
                (expected.way, expected.bits),
                "{light:?} {point:?} {other:?}"
            );
            others += 1;
        }
    }
    assert!(others > 5_000, "{others} others");
}

/// For all fractions, with random second arguments.
#[test]
fn the_model_of_the_proofs_has_the_bits_of_coarse_falloffs() {
    let model = Constants::KERNEL;
    let mut random = fastrand::Rng::with_seed(2);
    let bits = |value: Fx16| i128::from(value.to_bits());
    for t in 0..=1_u32 << 15 {
        let (fraction, t) = (Fraction16(t), i128::from(t));
        let other = random.u32(0..=1 << 15);
        let (b, share) = (i128::from(other), Fx16::from_bits(random.i16(0..=1 << 14)));
        assert_eq!(i128::from(fraction.times(Fraction16(other)).0), model.times(t, b));
        assert_eq!(bits(fraction.times_to_value(Fraction16(other))), model.times_to_value(t, b));
        assert_eq!(bits(fraction.times_value(share)), model.times(t, bits(share)));
        assert_eq!(bits(fraction.value()), model.value(t));
        let [a, b] = [0; 2].map(|_: i16| Fx16::from_bits(random.i16(0..=1 << 14)));
        assert_eq!(bits(a.times(b)), model.share_of(bits(a), bits(b)));
        assert_eq!(bits(fraction.smooth()), model.smooth(t));
        let exponent = RealExponent::new(2.5, 0.0);
        let power = model.power(i128::from(exponent.of_bits((t << 16) as u32)));
        assert_eq!(i128::from(fraction.real_power(exponent).0), power);
        let (g, h) = (random.f32() * 4.0 - 1.0, random.f32() * 6.0 - 4.0);
        if Cubic::with_slopes(1.0 + g, 1.0 - g - h).is_ok() {
            let [g, h] = [g, h].map(Fx16::weight);
            let bend = model.bend(t, g.to_bits().into(), h.to_bits().into());
            let value = model.quadratic(t, (1 << 15) - t, bend);
            assert_eq!(bits(fraction.cubic(g, h)), value.min(1 << 14), "{t} {g:?} {h:?}");
        }
        let (share, ratio) = (Fx16::weight(random.f32()), Fx16::gain((10.0 * random.f32()).exp2()));
        let [mantissa, shift] = ratio.to_bits();
        let narrow = model.narrow((1 << 15) - t, i128::from(mantissa as u32 >> 16), 1 << (shift - 16));
        let value = model.pair(t, (1 << 15) - narrow.min(1 << 15), share.to_bits().into());
        assert_eq!(bits(fraction.soft_pair(share, ratio)), value, "{t} {share:?} {ratio:?}");
        let samples = [random.u16(..), random.u16(..)];
        let [here, next] = samples.map(i128::from);
        if t > 0 {
            let value = model.interpolated(here, next - here, (1 << 15) - t);
            assert_eq!(bits(fraction.sample(&samples)), model.of_sixteen_bits(value), "{t} {samples:?}");
        }
    }
}

/// Lights and values of every size, alone in a block and beside those that take the common way.
#[test]
fn many_lights_are_converted_and_coloured_as_each() {
    let mut rng = fastrand::Rng::with_seed(16);
    for _ in 0..20_000 {
        let most = rng.u32(0..=32);
        let lights = [(); 8].map(|()| Light16::from_bits((rng.u64(..1 << 32) >> most) as u32));
        let color = Fx16::from_bits(rng.i16(..));
        assert_eq!(Fx16::filter_each(&lights, color), lights.map(|light| Fx16::filter(light, color)));
        let most = f32::from(rng.i16(-20..20)).exp2();
        let values =
            [(); 8].map(|()| if rng.u8(..8) == 0 { f32::from_bits(rng.u32(..)) } else { most * rng.f32() });
        assert_eq!(Fx16::lights_from_f32(&values), values.map(Fx16::light_from_f32), "{values:?}");
    }
    // Ties, both ends of the common way, and what is no light.
    let ends = [0.5 / 16_384.0, 1.5 / 16_384.0, 510.999_97, 511.0, 512.0, f32::NAN, -1.0, f32::INFINITY];
    for end in ends {
        assert_eq!(Fx16::lights_from_f32(&[end; 8]), [Fx16::light_from_f32(end); 8], "{end}");
    }
}
