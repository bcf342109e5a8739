//! The falloff over every input that it can have, in all three formats, row by row of
//! `tests/bounds.csv`.
//!
//! A plain run visits one input in a thousand; `LUMINAIRE_FULL=1 cargo test --test slow
//! exhaustive:: -- --nocapture` visits every one, some nine minutes on two processors, and prints
//! the rows.

use luminaire::falloff::{Cubic, Falloff, Hard, InvertedPower, Power, Smooth, Soft};
use luminaire::number::{Ramps, Versine};
use luminaire::{
    Cone, Fx16, Fx32, Rgb, Scalar,
    display::{Rgb565, encode_srgb},
    light::CompiledCone,
};
use support::{
    bounds::{self, REFUSE},
    every::{self, Seen},
    falloffs::{self, STRICT, Shape},
    format::Format,
    oracle, sweep,
};

/// The half angles in degrees of the cones.
const CONES: [f32; 4] = [0.01, 1.0, 15.0, 89.0];

/// A format whose versines can all be visited.
trait Countable: Format<Versine: Sync, Ramp: Sync> {
    /// The versines from the axis to beyond the edge in rising order, each with its exact value, by
    /// their index up to a last one.
    fn versines<P: Falloff>(
        falloff: &CompiledCone<Self, P>,
        outer: f32,
    ) -> (u64, impl Fn(u64) -> (Self::Versine, f64) + Sync);
}

impl Countable for f32 {
    /// Every bit pattern without the sign, infinity and NaN included.
    fn versines<P: Falloff>(_: &CompiledCone<f32, P>, _: f32) -> (u64, impl Fn(u64) -> (f32, f64) + Sync) {
        let versine = |bits: u64| {
            let versine = f32::from_bits(bits as u32);
            (versine, versine.into())
        };
        (0x7fff_ffff, versine)
    }
}

/// Every bit pattern up to an eighth beyond the edge.
macro_rules! countable {
    ($($format:ty),*) => {$(
        impl Countable for $format {
            fn versines<P: Falloff>(
                falloff: &CompiledCone<Self, P>,
                outer: f32,
            ) -> (u64, impl Fn(u64) -> (Versine, f64) + Sync) {
                let edge = u64::from(falloff.versine(outer).to_bits());
                let step = Self::exact_versine(falloff, Self::versine_from_bits(edge)) / edge as f64;
                (edge + edge / 8, move |bits| (Self::versine_from_bits(bits), bits as f64 * step))
            }
        }
    )*};
}

countable!(Fx16, Fx32);

/// What is seen of a shape in one cone, in steps of the format; nothing where the format refuses
/// the cone.
fn seen<S: Countable, P: Falloff>(shape: &Shape<P>, half_degrees: f32) -> Option<Seen>
where
    CompiledCone<S, P>: Sync,
{
    let falloff = shape.at(half_degrees).compile::<S>().ok()?;
    let exact = shape.stored_at(half_degrees);
    let (last, versine) = S::versines(&falloff, exact.outer as f32);
    assert_eq!(falloff.at(versine(0).0), S::ONE, "{} on the axis", shape.name);
    let steps = f64::from(S::STEP).recip();
    let name = format!("{} {} at {half_degrees} degrees", shape.name, S::NAME);
    let [seen] = every::inputs(&name, 0..=last, |index| {
        let (versine, value) = versine(index);
        let found = falloff.at(versine).exact();
        // At the edge, beyond it, and for NaN.
        if value.is_nan() || value >= exact.outer {
            assert!(found == 0.0, "{name}: {found} at {value}");
            return [(0.0, [0.0])];
        }
        [(found * steps, [exact.falloff(value) * steps])]
    });
    Some(seen)
}

/// The number of steps by which an intensity may rise towards the edge. `Fx32` computes with 31
/// fraction bits and rounds every product down.
fn may_turn<S: Scalar>(shape: &str) -> f64 {
    match S::NAME {
        _ if STRICT.contains(&shape) => 0.0,
        "fx32" => 7.0,
        _ => 1.0,
    }
}

/// What a shape breaks of its row, and of the law that intensities do not rise towards the edge.
fn broken<S: Countable, P: Falloff>(shape: &Shape<P>) -> Vec<String>
where
    CompiledCone<S, P>: Sync,
{
    // A jump is where it is within the rounding of a versine, which no error of an intensity
    // measures.
    if bounds::is_left_out(shape.name) || shape.exactly_at(1.0).jumps_near(shape.exactly_at(1.0).limit, 1.0) {
        return Vec::new();
    }
    let name = format!("{} {}", shape.name, S::NAME);
    let found = CONES.map(|half_degrees| seen::<S, P>(shape, half_degrees));
    let errors = found.map(|seen| seen.map_or(REFUSE, |seen| seen.error));
    println!("{name}: {}", errors.map(|error| format!("{error:.2}")).join(", "));
    let mut broken = bounds::broken("exhaustive", shape.name, S::NAME, &errors);
    let may_rise = may_turn::<S>(shape.name);
    for (seen, half_degrees) in found.into_iter().zip(CONES) {
        let rise = seen.map_or(0.0, |seen| seen.rise);
        if rise > may_rise {
            broken.push(format!("{name} at {half_degrees} degrees: rises by {rise} steps towards the edge"));
        }
    }
    broken
}

/// Checks the four falloffs that the 32-bit formats are tested with over every versine.
fn four<S: Countable>() -> Vec<String>
where
    CompiledCone<S, Soft>: Sync,
    CompiledCone<S, Hard>: Sync,
    CompiledCone<S, Smooth>: Sync,
    CompiledCone<S, Cubic>: Sync,
{
    [
        broken::<S, _>(&Shape::plain("soft", Soft, oracle::soft)),
        broken::<S, _>(&Shape::plain("hard", Hard, oracle::hard)),
        broken::<S, _>(&Shape::plain("smooth", Smooth, oracle::smooth)),
        broken::<S, _>(&Shape::plain("cubic", falloffs::cubic(), oracle::cubic)),
    ]
    .concat()
}

#[test]
fn f32_keeps_its_rows_over_every_bit_pattern() {
    bounds::assert_kept(&four::<f32>());
}

#[test]
fn fx32_keeps_its_rows_over_every_versine() {
    bounds::assert_kept(&four::<Fx32>());
}

#[test]
fn fx16_keeps_its_rows_over_every_versine() {
    let mut found: Vec<_> = falloffs::listed().iter().flat_map(broken::<Fx16, _>).collect();
    found.extend(broken::<Fx16, _>(&Shape::<Power<4>>::listed()));
    found.extend(broken::<Fx16, _>(&Shape::<InvertedPower<4>>::listed()));
    found.extend(broken::<Fx16, _>(&Shape::plain("power-15", Power::<15>, oracle::power_15)));
    found.extend(broken::<Fx16, _>(&Shape::hotspot("soft-hotspot", Soft, oracle::soft)));
    found.extend(broken::<Fx16, _>(&Shape::with_cutoff("soft-cutoff", Soft, oracle::soft)));
    found.extend(broken::<Fx16, _>(&Shape::<Power<15>>::opengl("opengl-15", oracle::power_15)));
    bounds::assert_kept(&found);
}

/// A versine below zero, which rounding may make of a point on the axis, is on the axis.
#[test]
fn every_negative_versine_of_f32_is_on_the_axis() {
    let falloff = Cone::from_outer(Soft, sweep::half(1.0)).and_then(|cone| cone.compile::<f32>());
    let falloff = falloff.expect("held");
    let seen = every::input("negative versines", 0x8000_0000..=0xffff_ffff, |bits| {
        let versine = f32::from_bits(bits as u32);
        [falloff.at(versine).into(), f64::from(u8::from(!versine.is_nan()))]
    });
    assert_eq!(seen.error, 0.0);
}

/// Every fraction of 30 bits: this ramp gives each of them, and no ramp has more versines.
fn fraction_error<P: Falloff + Sync>(shape: &Shape<P>) -> Vec<String>
where
    P::Compiled<Fx32>: Sync,
{
    if bounds::is_left_out(shape.name) {
        return Vec::new();
    }
    let (ramp, oracle) = (Fx32::ramp(0.0, 0.5, 0.5), shape.oracle);
    let falloff = CompiledCone::<Fx32, P>::from_parts(ramp, shape.falloff, shape.falloff.compile::<Fx32>());
    let name = format!("{} fx32, every fraction", shape.name);
    let seen = every::input(&name, 0..=1 << 30, |fraction| {
        let versine = Fx32::versine_from_bits((1 << 30) - fraction);
        let found = falloff.at(versine).exact();
        [found, oracle(fraction as f64 * 0.5_f64.powi(30))].map(|f| f * f64::from(1 << 30))
    });
    assert_eq!(falloff.at(Fx32::versine_from_bits(0)), Fx32::ONE, "{name}");
    let may_fall = may_turn::<Fx32>(shape.name);
    assert!(seen.fall <= may_fall, "{name}: falls by {} steps towards the middle", seen.fall);
    println!("{name}: {:.3}", seen.error);
    bounds::broken("fractions", shape.name, "fx32", &[seen.error])
}

#[test]
fn fx32_keeps_its_roundings_over_every_fraction() {
    // Run-time powers have no row: the powers whose exponent is a type stand for them.
    let listed = falloffs::listed();
    let listed = listed.iter().filter(|shape| !["power", "inverted-power"].contains(&shape.name));
    let mut broken: Vec<_> = listed.flat_map(fraction_error).collect();
    broken.extend(fraction_error(&Shape::<Power<4>>::listed()));
    broken.extend(fraction_error(&Shape::<InvertedPower<4>>::listed()));
    broken.extend(fraction_error(&Shape::plain("power-15", Power::<15>, oracle::power_15)));
    bounds::assert_kept(&broken);
}

/// How far a displayed code is from the exact one before it is rounded, in eight bits, in the five
/// of RGB565 and in its six.
fn display_errors<S: Countable>(domain: u64, linear: impl Fn(u64) -> S + Sync) -> [f64; 3] {
    const LAST: [f64; 3] = [255.0, 31.0, 63.0];
    let seen = every::inputs(&format!("{} to codes", S::NAME), 0..=domain, |bits| {
        let value = linear(bits);
        let Rgb565(pixel) = Rgb565::from_linear(Rgb::new(value, value, value));
        assert_eq!(pixel >> 11, pixel & 31, "red and blue of {value:?}");
        let codes = [encode_srgb(value).into(), pixel & 31, pixel >> 5 & 63];
        let exact = oracle::srgb_code(value.exact()) / 255.0;
        std::array::from_fn(|i| (f64::from(codes[i]), [exact * LAST[i]]))
    });
    for (seen, last) in seen.iter().zip(LAST) {
        assert_eq!(seen.fall, 0.0, "{}: a brighter value has a darker code of {last}", S::NAME);
        println!("{} to {last} codes: {:.5}", S::NAME, seen.error);
    }
    seen.map(|seen| seen.error)
}

/// Every number from 0 to 1: the nearest code, up to the gap of 1e-7 between the standard's two
/// halves.
fn assert_encodes<S: Countable>(domain: u64, linear: impl Fn(u64) -> S + Sync) {
    for error in display_errors(domain, linear) {
        assert!((0.499..=0.500_001).contains(&error), "{error}");
    }
}

#[test]
fn f32_is_encoded_to_the_nearest_code() {
    assert_encodes(1.0_f32.to_bits().into(), |bits| f32::from_bits(bits as u32));
}

#[test]
fn fx32_is_encoded_to_the_nearest_code() {
    assert_encodes(1 << 30, Fx32::scalar_from_bits);
}

/// Every bit pattern of f32 outside [0, 1], NaN included, is clipped.
#[test]
fn every_other_f32_is_clipped() {
    let code = |bits: u64| encode_srgb(f32::from_bits(bits as u32)).into();
    let brighter = every::input("f32 over 1", 0x3f80_0000..=0x7f80_0000, |bits| [code(bits), 255.0]);
    let negative =
        every::input("f32 under 0 and not a number", 0x7f80_0001..=0xffff_ffff, |bits| [code(bits), 0.0]);
    assert_eq!((brighter.error, negative.error), (0.0, 0.0));
}

/// Every colour of three times eight bits: each channel of a pixel is that of its code alone.
#[test]
fn every_color_is_packed_by_its_channels() {
    let grey: Vec<_> = (0..=255).map(|code| Rgb565::from_codes(Rgb::new(code, code, code))).collect();
    for color in 0..1_u32 << 24 {
        let [_, red, green, blue] = color.to_be_bytes();
        let [r, g, b] = [red, green, blue].map(|code| grey[usize::from(code)].0);
        let Rgb565(found) = Rgb565::from_codes(Rgb::new(red, green, blue));
        assert_eq!(found, r & 0xf800 | g & 0x07e0 | b & 0x001f, "{color:#08x}");
    }
}
