//! Errors of the stages, over every argument where that is possible.

use super::{set_up::inner, *};
use crate::number::{Arithmetic, Directions, Fx16, Scalar, fx16::Gain16, proofs::model::Constants};

extern crate std;

/// Every sample converts to the nearest fraction, and 65,535 converts to exactly 1.
#[test]
fn the_share_of_a_sample_is_the_nearest() {
    for value in 0..=65_535_u32 {
        let exact = f64::from(value) / 65_535.0 * 2_147_483_648.0;
        let found = Fine::of_value(value << 15);
        assert!(
            (f64::from(found.0) - exact).abs() <= 0.5,
            "sample {value}: {found:?}, expected the nearest to {exact}"
        );
    }
    assert_eq!(Fine::of_value(65_535 << 15), Fine::ONE);
}

/// A product of distance and slope has up to 46 bits, of which the lower 15 are dropped.
#[test]
fn a_line_keeps_all_its_bits() {
    for slope in [-32_768, -12_345, -1, 1, 7_777, 32_767] {
        let knot = Knot::from_bits(0, if slope < 0 { 65_535 } else { 0 }, slope);
        for t in (0..1 << 31).step_by(10_000_019) {
            let beyond = f64::from((1_u32 << 31) - t) / 32_768.0;
            let line = f64::from(knot.value) + f64::from(slope) * beyond / 32_768.0;
            let exact = line.clamp(0.0, 65_535.0) / 65_535.0 * 2_147_483_648.0;
            let found = Fraction::<Fx16>::sample_knots(Fine(t), &[knot]);
            assert!((f64::from(found.0) - exact).abs() <= 2.0, "{slope} {t}: {found:?} for {exact}");
        }
    }
}

#[test]
fn light_is_shifted_as_in_64_bits() {
    for product in [0, 1, 2, 3, 0x8000_0001, 0x9e37_79b9, u32::MAX] {
        for shift in (-70..70).chain([i32::MIN, i32::MAX]) {
            assert_eq!(
                Light32::shifted_32(product, shift),
                Light32::shifted(product.into(), shift),
                "{product} {shift}"
            );
        }
    }
}

#[test]
fn a_scalar_outside_of_0_to_1_is_the_nearest_share() {
    let share = |bits| <Fine as Share<Fx16>>::of_scalar(Fx16::from_bits(bits));
    assert_eq!([i16::MIN, -1, 0].map(share), [Fine(0); 3]);
    assert_eq!([1 << 14, (1 << 14) + 1, i16::MAX].map(share), [Fine::ONE; 3]);
    assert_eq!(share(1), Fine(1 << 17));
}

/// Compares with the same products in 128 bits, truncated to 64 and to 32 bits.
#[test]
fn vectors_that_are_not_of_unit_length_wrap() {
    let components = [i32::MIN, -(1 << 30), -12_345, 0, 1 << 30, i32::MAX];
    let vectors = || (0..216).map(|i| Vec3::new(i / 36, i / 6 % 6, i % 6).map(|at: usize| components[at]));
    for (d, n) in vectors().flat_map(|d| vectors().map(move |n| (d, n))) {
        let [direction, normal] = [d, n].map(|vector| vector.map(Fx32::from_bits));
        let cosine = i128::from((inner(direction, normal) + (1 << 27)) >> 28);
        let exact = d.zip(n, |d, n| {
            let twice_along = (cosine * i128::from(n) + (1 << 28)) as i64 >> 29;
            (i128::from(d) - i128::from(twice_along)) as i32
        });
        assert_eq!(Fx32::mirror(direction, normal).map(Fx32::to_bits), exact, "{d:?} {n:?}");
    }
}

/// Between opposite corners of the coordinate range, even half the difference does not fit 32
/// bits.
#[test]
fn the_longest_offset_keeps_its_direction() {
    let corner = |bits| Vec3::new(bits, bits, bits).map(Length::from_bits);
    let offset = Offset32::between(corner(i32::MIN), corner(i32::MAX));
    assert_eq!((offset.way, offset.bits), (Vec3::new(i32::MAX, i32::MAX, i32::MAX), 32));
    let offset = Offset32::between(corner(i32::MAX), corner(i32::MIN));
    assert!(
        offset.way.x < -(1 << 30) && offset.bits == 32,
        "{offset:?}, expected offset.way.x < -(1 << 30) and offset.bits == 32"
    );
}

/// A gain is `mantissa / 2^shift`, however many bits the mantissa has.
#[test]
fn a_short_mantissa_is_the_same_gain() {
    for bits in 0..28 {
        assert_eq!(Gain16::from_bits([1 << bits, bits]), Gain16::ONE);
        assert_eq!(Gain32::from_bits([1 << bits, bits]), Gain32::ONE);
        assert_eq!(Gain16::normalised(1 << bits, bits), Gain16::ONE);
        assert_eq!(Gain32::normalised(1 << bits, bits), Gain32::ONE);
    }
}

/// The offset between two places is that of their difference, or of half of it where that does not fit 32 bits.
#[test]
fn an_offset_is_that_of_the_difference() {
    let mut random = fastrand::Rng::with_seed(5);
    let farthest = Length::from_f32(Fx32::FARTHEST).to_bits();
    for step in 0..400_000 {
        let light = [(); 3].map(|()| random.i32(-farthest..=farthest));
        let reach = if step % 4 == 0 { 32 } else { random.u32(1..=24) };
        let point = light.map(|c| c.saturating_add(random.i32(..) >> (32 - reach)));
        let point = if step % 8 == 0 { [(); 3].map(|()| random.i32(..)) } else { point };
        let way: [i64; 3] = core::array::from_fn(|i| i64::from(point[i]) - i64::from(light[i]));
        let is_long = way.iter().any(|c| i32::try_from(*c).is_err());
        let exact = way.map(|c| if is_long { ((c + 1) >> 1).min(i32::MAX.into()) } else { c } as i32);
        let exact = Offset32::new(exact.into());
        let [light, point] = [light, point].map(|place| Vec3::from(place.map(Length::from_bits)));
        let found = Offset32::between(light, point);
        let bits = exact.bits + u32::from(is_long);
        assert_eq!((found.way, found.bits), (exact.way, bits), "{light:?} {point:?}");
    }
}

/// The proofs are about a model of the stages. It has the bits of the kernel.
#[test]
fn the_model_of_the_proofs_has_the_bits_of_the_fine_stages() {
    let model = Constants::KERNEL;
    let mut random = fastrand::Rng::with_seed(3);
    for _ in 0..200_000 {
        let bits = random.u32(1..=32);
        let way = Vec3::new(random.i32(..), random.i32(..), random.i32(..)).map(|c| c >> (32 - bits));
        if way == Vec3::default() {
            continue;
        }
        let Offset32 { way, bits } = Offset32::new(way);
        let ray = Offset32 { way, bits }.ray();
        let (estimate, gain) = (i128::from(ray.estimate), random.u32(1 << 31..));
        let nearly = way.map(|c| (i128::from(c) * estimate) >> 16);
        let squares = nearly.map(|c| model.high_square(c));
        let excess = model.excess(squares.x + squares.y + squares.z - (1 << 28));
        assert_eq!(i128::from(ray.excess), excess, "{way:?}");
        let direction = nearly.map(|c| model.corrected(c, excess));
        assert_eq!(ray.direction.map(i128::from), direction, "{way:?}");
        let here = model.finely_attenuated(gain.into(), estimate, excess);
        assert_eq!(i128::from(ray.attenuated(gain)), here, "{way:?} {gain}");
        let length = model.length(ray.squared.into(), estimate, excess);
        assert_eq!(i128::from(ray.length()), length, "{way:?}");
        let normal = Vec3::new(random.i32(..), random.i32(..), random.i32(..)).map(|c| c / 2);
        let sum = |products: Vec3<i128>| (products.x + products.y + products.z).min(0).unsigned_abs();
        let products = direction.zip(normal, |d, n| model.finest_component(d, n.into()));
        let cosine = Ray::<Fx32>::cosine(&ray, 0, normal.map(Fx32::from_bits));
        assert_eq!(u128::from(cosine.0), sum(products).min(1 << 27) << 4, "{way:?} {normal:?}");
        let normal = normal.map(|c| Fx16::from_bits((c >> 16) as i16));
        let products = direction.zip(normal, |d, n| model.fine_component(d, n.to_bits().into()));
        let cosine = Ray::<Fx16>::cosine(&ray, 0, normal);
        assert_eq!(u128::from(cosine.0), (sum(products) << 1).min(1 << 31), "{way:?} {normal:?}");

        let [t, b] = [0; 2].map(|_: u32| random.u32(0..=1 << 31));
        let (fraction, t, u) = (Fine(t), i128::from(t), i128::from((1 << 31) - t));
        assert_eq!(i128::from(fraction.times(Fine(b)).0), model.fine_times(t, b.into()));
        assert_eq!(i128::from(fraction.smooth().0), model.fine_smooth(t, u).min(1 << 31));
        let samples = [random.u16(..), random.u16(..)];
        let (here, apart) = (samples[0], samples[0].abs_diff(samples[1]));
        let value = model.fine_sample(here.into(), apart.into(), u % (1 << 31), samples[1] < here);
        if t > 0 {
            let found = Fraction::<Fx32>::sample(fraction, &samples);
            assert_eq!(i128::from(found.0), value.min(1 << 31), "{t} {samples:?}");
        }
        let [d, n] = [0; 2].map(|_: i32| {
            let mut component = || Fx32::from_bits(random.i32(-(1 << 29)..1 << 29));
            Vec3::new(component(), component(), component())
        });
        let incidence = model.incidence(i128::from(inner(d, n)), 28).clamp(0, 1 << 30);
        assert_eq!(i128::from(Fx32::incidence(d, n).to_bits()), incidence, "{d:?} {n:?}");
        let (share, ratio) = (Fx32::weight(random.f32()), Fx32::gain((10.0 * random.f32()).exp2()));
        let [mantissa, shift] = ratio.to_bits().map(i128::from);
        let fallen = model.fine_narrow((u << (27 - shift)).min((1 << 32) - 1), mantissa << 4).min(1 << 31);
        let value = model.fine_pair(t, (1 << 31) - fallen, i128::from(share.to_bits() >> 2) << 3);
        assert_eq!(
            i128::from(Fraction::<Fx32>::soft_pair(fraction, share, ratio).0),
            value,
            "{share} {ratio:?}"
        );
        let slope = random.i32(0..=1 << 28);
        assert_eq!(i128::from(fraction.lifted(slope).0), t + model.lift(t, u, slope.into()));
    }
}

/// Exhaustive over all sums, and 3e-4 beyond both ends.
#[test]
fn reciprocal_of_a_sum_has_its_error() {
    let sums = 32_758..=56_774_u32;
    let error = |sum| f64::from(inverse_sum_16(sum)) / 65_536.0 * f64::from(sum) / 32_768.0 - 1.0;
    let worst = sums.map(|sum| error(sum).abs()).fold(0.0, f64::max);
    assert!((3.2e-5..=3.4e-5).contains(&worst), "{worst:.3e}");
    // A sum of any other size has some reciprocal.
    assert!((0..=u32::from(u16::MAX) * 2).chain([u32::MAX]).all(|sum| inverse_sum_16(sum) < 1 << 18));
}

#[test]
fn reciprocal_of_a_finer_sum_has_its_error() {
    let mut worst = 0.0_f64;
    for sum in ((1 << 28)..=464_943_849_u32).step_by(611) {
        let product = f64::from(inverse_sum_32(sum)) / 2_f64.powi(31) * f64::from(sum) / 2_f64.powi(28);
        worst = worst.max((product - 1.0).abs());
    }
    assert!((2e-9..=4e-9).contains(&worst), "{worst:.3e}");
    for sum in [0, 1, 1 << 20, 1 << 29, 1 << 31, u32::MAX] {
        inverse_sum_32(sum);
    }
}
