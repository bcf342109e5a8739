//! Gradients, pools of light and sprites: each pixel against f64, or against the kernel pixel by pixel; and
//! the ramps of every pixel.

use std::fmt::Debug;

use fastrand::Rng;
use luminaire::{
    Angle, Cone, Fx16, Fx32, Length, PointLight, Rgb, Scalar, SpotLight, Vec3,
    attenuation::{
        Attenuation, CutAt, Decay, FilamentRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
    },
    display::{
        Gray1, Gray2, Gray4, Gray8, Pixel, Ramp, Rgb332, Rgb444, Rgb555, Rgb565, Rgb666, Rgb888, threshold,
    },
    draw::{Gradient, Pool, Shape, Sprite},
    error::{Expected, Parameter},
    falloff::Soft,
};
use support::{
    format::Format,
    in_every_format,
    oracle::{srgb_code, srgb_linear},
};

/// A pixel with the widths of its channels; a grey one has a single channel.
trait Channels: Pixel + Debug + PartialEq {
    const CHANNELS: &'static [u32];
}

macro_rules! channels {
    ($($pixel:ident: $($width:literal)*;)*) => {
        $(impl Channels for $pixel { const CHANNELS: &'static [u32] = &[$($width),*]; })*

        macro_rules! with_every_pixel {
            ($function:ident) => { $($function::<$pixel>();)* };
        }
    };
}

channels! {
    Gray1: 1; Gray2: 2; Gray4: 4; Gray8: 8;
    Rgb332: 3 3 2; Rgb444: 4 4 4; Rgb555: 5 5 5; Rgb565: 5 6 5; Rgb666: 6 6 6; Rgb888: 8 8 8;
}

/// A linear value between two codes of a channel, in steps: the share between the codes is that in
/// linear light.
pub(crate) fn steps(linear: f64, last: u32) -> f64 {
    let light = |code: u32| srgb_linear(f64::from(code) / f64::from(last) * 255.0);
    let linear = linear.clamp(0.0, 1.0);
    // An error of this code is an error of the formula below of the same size.
    let code = ((srgb_code(linear) / 255.0 * f64::from(last)) as u32).min(last - 1);
    f64::from(code) + (linear - light(code)) / (light(code + 1) - light(code))
}

fn fraction<P: Channels>() -> u32 {
    ((32 - P::BITS) / 3).min(5)
}

/// Asserts that a pixel shows a colour between two in linear light, dithered, by a table with the stated
/// rounding.
fn assert_shown<P: Channels>(pixel: P, [x, y]: [i32; 2], low: [f64; 3], high: [f64; 3], what: &dyn Debug) {
    let parts = f64::from(1 << fraction::<P>());
    let offset = f64::from((127 - threshold(x as u32, y as u32)) >> (7 - fraction::<P>())) / parts;
    let mut bits = pixel.to_bits();
    for (width, (low, high)) in P::CHANNELS.iter().zip(low.into_iter().zip(high)).rev() {
        let last = (1 << width) - 1;
        let (code, rounding) = (bits & last, 0.501 / parts);
        bits >>= width;
        let least = (steps(low - 3e-6, last) - rounding + offset).floor();
        let most = (steps(high + 3e-6, last) + rounding + offset).floor().min(last.into());
        assert!(
            (least..=most).contains(&f64::from(code)),
            "{what:?}: {code} of {last} at ({x}, {y}), expected {least} to {most}"
        );
    }
}

/// The least and the greatest channels of a gradient within half a level of a place in `[0, 1]`.
fn around(colors: &[Rgb<u8>], place: f64, levels: usize) -> [[f64; 3]; 2] {
    let half = (0.5 + 1.0 / 32.0) / (levels - 1) as f64;
    let spaces = (colors.len() - 1) as f64;
    let ends = [place - half, place + half].map(|place| place.clamp(0.0, 1.0) * spaces);
    let knots = (0..colors.len()).map(|knot| knot as f64).filter(|knot| (ends[0]..ends[1]).contains(knot));
    let [mut low, mut high] = [[f64::MAX; 3], [f64::MIN; 3]];
    for place in knots.chain(ends) {
        let from = (place as usize).min(colors.len() - 2);
        let mixed = colors[from].zip(colors[from + 1], |from, to| [f64::from(from), f64::from(to)]);
        for (i, [a, b]) in <[_; 3]>::from(mixed).into_iter().enumerate() {
            let light = srgb_linear(a + (place - from as f64) * (b - a));
            (low[i], high[i]) = (low[i].min(light), high[i].max(light));
        }
    }
    [low, high]
}

const SKY: [Rgb<u8>; 3] = [Rgb::new(12, 18, 60), Rgb::new(255, 90, 81), Rgb::new(0, 255, 150)];
const GRAYS: [Rgb<u8>; 2] = [Rgb::new(0, 0, 0), Rgb::new(255, 255, 255)];

/// Exhaustive over a picture, whose rows are drawn in two pieces.
fn assert_picture<P: Channels, const N: usize>(
    gradient: &Gradient<P, N>,
    colors: &[Rgb<u8>],
    place: impl Fn(f64, f64) -> f64,
) {
    const WIDTH: i32 = 150;
    for y in -20..100 {
        let mut row = vec![P::nearest(Rgb::default() as Rgb<f32>); WIDTH as usize];
        let (left, right) = row.split_at_mut(67);
        gradient.row(y, -30, left);
        gradient.row(y, -30 + 67, right);
        for (x, pixel) in (-30..).zip(row) {
            let [low, high] = around(colors, place(x.into(), y.into()), N);
            assert_shown(pixel, [x, y], low, high, &gradient.parts().1);
        }
    }
}

fn assert_linear<P: Channels>([from, to]: [[f32; 2]; 2]) {
    let colors: &[Rgb<u8>] = if P::CHANNELS.len() == 1 { &GRAYS } else { &SKY };
    let gradient: Gradient<P> = Gradient::linear(colors, from, to).expect("a gradient");
    let [[x0, y0], [x1, y1]] = [from, to].map(|place| place.map(f64::from));
    let (dx, dy) = (x1 - x0, y1 - y0);
    assert_picture(&gradient, colors, |x, y| ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy));
}

fn assert_slanted<P: Channels>() {
    assert_linear::<P>([[100.25, 3.5], [-7.0, 60.0]]);
}

#[test]
fn each_pixel_of_a_gradient_is_within_half_a_level() {
    with_every_pixel!(assert_slanted);
    assert_linear::<Rgb565>([[0.0, 0.0], [0.0, 79.0]]);
    assert_linear::<Rgb565>([[50.0, 9.0], [51.0, 9.0]]);
    for (center, radius) in [([40.0, 30.0], 45.0), ([17.25, -80.5], 150.0), ([60.5, 40.0], 8.5)] {
        let gradient: Gradient<Rgb565> = Gradient::radial(&SKY, center, radius).expect("a gradient");
        let [cx, cy] = center.map(f64::from);
        assert_picture(&gradient, &SKY, |x, y| (x - cx).hypot(y - cy) / f64::from(radius));
    }
}

/// The largest circle, past the ends of its rows, and the fewest levels.
#[test]
fn a_gradient_keeps_its_place_over_the_largest_distances() {
    let wide: Gradient<Rgb565> = Gradient::radial(&SKY, [4_000.5, -17.25], 8_191.0).expect("a gradient");
    let few: Gradient<Rgb565, 5> = Gradient::radial(&SKY, [4_000.5, -17.25], 8_191.0).expect("a gradient");
    let far: Gradient<Rgb565> =
        Gradient::linear(&SKY, [-4_500.0, 1.0], [12_000.0, 300.5]).expect("a gradient");
    let mut row = vec![Rgb565(0); 17_000];
    for y in [-8_210, -8_000, -17, 0, 3_000] {
        let radial = |x: f64| (x - 4_000.5).hypot(f64::from(y) + 17.25) / 8_191.0;
        let (dx, dy) = (16_500.0, 299.5);
        let linear = |x: f64| ((x + 4_500.0) * dx + (f64::from(y) - 1.0) * dy) / (dx * dx + dy * dy);
        let mut check = |paint: &dyn Fn(&mut [Rgb565]), place: &dyn Fn(f64) -> f64, levels| {
            paint(&mut row);
            for (x, pixel) in (-4_400..).zip(&row) {
                let [low, high] = around(&SKY, place(x.into()), levels);
                assert_shown(*pixel, [x, y], low, high, &levels);
            }
        };
        check(&|row| wide.row(y, -4_400, row), &radial, 256);
        check(&|row| few.row(y, -4_400, row), &radial, 5);
        check(&|row| far.row(y, -4_400, row), &linear, 256);
    }
}

/// Exhaustive over greys: the mean light of a cell is that of the colour.
#[test]
fn a_gradient_keeps_the_mean_light() {
    for code in 0..=255 {
        let color = [Rgb::new(code, code, code); 2];
        let gradient: Gradient<Rgb565, 2> =
            Gradient::linear(&color, [0.0, 0.0], [9.0, 0.0]).expect("a gradient");
        let mut mean = 0.0;
        for y in 0..8 {
            let mut row = [Rgb565(0); 8];
            gradient.row(y, 0, &mut row);
            let green = |pixel: &Rgb565| srgb_linear(f64::from(pixel.0 >> 5 & 63) / 63.0 * 255.0);
            mean += row.iter().map(green).sum::<f64>() / 64.0;
        }
        // The widest step of green is 0.0352.
        let error = (mean - srgb_linear(code.into())).abs();
        assert!(error <= 0.0352 / 64.0, "code {code}: {error}");
    }
}

fn assert_ramp<P: Channels>() {
    let gray = |value| Rgb::new(value, value, value);
    let (base, reflected) = if P::CHANNELS.len() == 1 {
        (gray(0.02), gray(0.7))
    } else {
        (Rgb::new(0.0, 0.02, 0.3), Rgb::new(0.9, 0.5, 0.1))
    };
    let ramp: Ramp<P> = Ramp::new(base, reflected).expect("a ramp");
    for (light, x) in (0..1 << 16).step_by(13).zip(0..) {
        // Half the width of the level, in steps of 2^-14.
        let half = [8, 32, 128][usize::from(light + 8 >= 1 << 12) + usize::from(light + 8 >= 1 << 14)];
        let sum = |light: u32| {
            <[f64; 3]>::from(
                base.zip(reflected, |a, b| f64::from(a) + f64::from(light) / 16_384.0 * f64::from(b)),
            )
        };
        let pixel = ramp.pixel::<f32>(light as f32 / 16_384.0, x, x / 8);
        let low = sum(if light < 8 { 0 } else { light - half });
        assert_shown(
            pixel,
            [x as i32, x as i32 / 8],
            low,
            sum(if light < 8 { 0 } else { light + half }),
            &light,
        );
    }
}

#[test]
fn a_ramp_of_every_pixel_is_within_half_a_level() {
    with_every_pixel!(assert_ramp);
}

fn assert_first_step<P: Channels>() {
    let gray = |light: f32| Rgb::new(light, light, light);
    let black = P::nearest(gray(0.0_f32));
    assert_eq!(P::nearest(gray(P::FIRST_STEP)), black);
    assert_ne!(P::nearest(gray(P::FIRST_STEP * 1.000_001)), black);
    let below = |step: f32| gray((P::FIRST_STEP / step).floor() * step);
    assert_eq!(P::nearest(below(Fx16::STEP).map(Fx16::from_f32)), black);
    assert_eq!(P::nearest(below(Fx32::STEP).map(Fx32::from_f32)), black);
}

#[test]
fn light_below_the_first_step_is_black() {
    with_every_pixel!(assert_first_step);
}

fn spot<S: Scalar>(x: f32) -> luminaire::light::CompiledSpotLight<S, Soft> {
    let cone = Cone::from_field(Soft, Angle::degrees(50.0)).expect("a cone");
    let spot = SpotLight::new([x, 1.0, 1.5], [0.1, 0.05, -1.0], cone).expect("a light");
    spot.with_intensity(3.0).expect("a light").compile().expect("a light")
}

fn ramp(green: f32) -> Ramp<Rgb565> {
    Ramp::new(Rgb::new(0.0, 0.01, 0.05), Rgb::new(0.9, green, 0.3)).expect("a ramp")
}

fn at<S: Scalar>(x: i32, y: i32) -> Vec3<S::Length> {
    // Exact: 32 pixels to the unit.
    S::point([x as f32 / 32.0, y as f32 / 32.0, 0.0])
}

fn assert_pool<S: Format>() {
    let (ramp, light, facing) = (ramp(0.5), spot::<S>(2.0), Vec3::new(S::ZERO, S::ZERO, S::ONE));
    let pool = Pool::new(&ramp, S::length(1.0 / 32.0));
    let mut lit = 0;
    for (y, x, length) in (-30..90).map(|y| (y, 3 * y - 100, 290)).chain([(40, 0, 0), (40, 60, 1)]) {
        let mut row = vec![Rgb565(0xffff); length];
        pool.row(&light, y, x, &mut row);
        for (x, pixel) in (x..).zip(row) {
            let arrived = light.irradiance(at::<S>(x, y), facing);
            assert_eq!(pixel, ramp.pixel::<S>(arrived, x as u32, y as u32), "{} at ({x}, {y})", S::NAME);
            lit += u32::from(arrived != S::Irradiance::default());
        }
    }
    assert!((1_000..30_000).contains(&lit), "{lit} lit pixels");
}

#[test]
fn a_pool_has_the_pixels_of_single_calls() {
    in_every_format!(assert_pool);
}

fn assert_sprite<S: Format>() {
    const WIDTH: usize = 150;
    let mut rng = Rng::with_seed(40);
    let mut byte = || rng.i8(..);
    // Holes of several widths, and runs longer than a block.
    let normals: Vec<_> = (0..WIDTH * 40)
        .map(|i| if i % 97 < i / WIDTH / 8 { [0; 3] } else { [byte(), byte(), byte() | 1] })
        .collect();
    let materials: Vec<_> = (0..WIDTH * 40).map(|i| (i / 7 % 4) as u8).collect();
    let ramps = [ramp(0.3), ramp(0.9)];
    let lights = [spot::<S>(2.0), spot::<S>(3.0)];
    let plain = Sprite::new(WIDTH, &normals, &ramps, S::length(1.0 / 32.0)).expect("a sprite").at(10, 20);
    let sprite = plain.with_materials(&materials).expect("as many materials");
    for (y, left, length) in
        (15..65).flat_map(|y| [(y, -20, 200), (y, 40, 90), (y, 10, 150), (y, 159, 9), (y, 160, 9)])
    {
        let mut rows = [(); 2].map(|()| vec![Rgb565(0xffff); length]);
        plain.row(&lights[..1], y, left, &mut rows[0]);
        sprite.row(&lights, y, left, &mut rows[1]);
        for (i, x) in (left..).take(length).enumerate() {
            let [row, column] = [y - 20, x - 10].map(|place| usize::try_from(place).ok());
            let place =
                row.zip(column.filter(|column| *column < WIDTH)).map(|(row, column)| row * WIDTH + column);
            let place = place.filter(|place| normals.get(*place).is_some_and(|normal| *normal != [0; 3]));
            let expected = place.map_or([Rgb565(0xffff); 2], |place| {
                let normal = S::normal_from_unit_bytes(normals[place]);
                let [a, b] = lights.map(|light| light.irradiance(at::<S>(x, y), normal));
                let sum = (Rgb::new(a, a, a) + Rgb::new(b, b, b)).red;
                let material = usize::from(materials[place]).min(1);
                [
                    ramps[0].pixel::<S>(a, x as u32, y as u32),
                    ramps[material].pixel::<S>(sum, x as u32, y as u32),
                ]
            });
            assert_eq!([rows[0][i], rows[1][i]], expected, "{} at ({x}, {y})", S::NAME);
        }
    }
}

#[test]
fn a_sprite_has_the_pixels_of_single_calls() {
    in_every_format!(assert_sprite);
}

#[test]
fn any_places_and_any_parts_give_pixels() {
    let mut rng = Rng::with_seed(41);
    let (normals, ramps, light) = ([[1; 3]; 6], [ramp(0.5)], spot::<Fx16>(0.0));
    let ends = [i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX];
    let mut row = [Rgb565(0); 70];
    for _ in 0..20_000 {
        let mut place = || if rng.bool() { ends[rng.usize(..7)] } else { rng.i32(..) };
        let [x, y, left, top] = [place(), place(), place(), place()];
        let mut word = || rng.i64(..) >> rng.u32(..64);
        let shapes = [
            Shape::Linear { start: word(), across: word(), down: word() },
            Shape::Radial { center: [word(), word()], radius: word(), square: word(), bits: word() as u32 },
        ];
        for shape in shapes {
            Gradient::from_parts([0x1234_5678; 256], shape).row(y, x, &mut row);
            Gradient::from_parts([7; 3], shape).row(y, x, &mut row);
            Gradient::from_parts([7; 1], shape).row(y, x, &mut row);
            Gradient::from_parts([], shape).row(y, x, &mut row);
        }
        let pixel = Length::from_bits(rng.i32(..));
        Pool::new(&ramps[0], pixel).row(&light, y, x, &mut row);
        let sprite = Sprite::new(3, &normals, &ramps, pixel).expect("a sprite");
        sprite.at(left, top).row(&[light], y, x, &mut row);
        sprite.at(x.wrapping_add(1), y).row(&[light], y, x, &mut row);
    }
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    type Sky = Gradient<Rgb565>;
    let parameter = |gradient: Result<Sky, luminaire::Error>| gradient.expect_err("a refusal").parameter;
    for (from, refused) in
        [(0.0, Parameter::GradientLength), (f32::NAN, Parameter::Place), (4e4, Parameter::Place)]
    {
        assert_eq!(parameter(Sky::linear(&SKY, [from, 5.0], [0.5, 5.0])), refused);
    }
    for radius in [0.5, 8_192.0, f32::NAN] {
        assert_eq!(parameter(Sky::radial(&SKY, [0.0, 0.0], radius)), Parameter::GradientRadius);
    }
    assert_eq!(parameter(Sky::radial(&SKY[..1], [0.0, 0.0], 9.0)), Parameter::ColorCount);
    assert_eq!(parameter(Sky::radial(&SKY, [0.0, f32::INFINITY], 9.0)), Parameter::Place);
    let ramps = [ramp(0.5)];
    let sprite = |width, normals, ramps| Sprite::<_, f32>::new(width, normals, ramps, 1.0);
    let refused = sprite(4, &[[1; 3]; 6], &ramps).expect_err("no whole rows");
    assert_eq!((refused.parameter, refused.accepted), (Parameter::NormalCount, Expected::RowsOf(4)));
    assert_eq!(refused.to_string(), "number of normals = 6: expected whole rows, a multiple of the width 4");
    assert_eq!(sprite(0, &[], &ramps).expect_err("no width").parameter, Parameter::Width);
    assert_eq!(sprite(3, &[[1; 3]; 6], &[]).expect_err("no ramp").parameter, Parameter::RampCount);
    let refused = sprite(3, &[[1; 3]; 6], &ramps).and_then(|sprite| sprite.with_materials(&[0; 5]));
    assert_eq!(refused.expect_err("too few").to_string(), "number of materials = 5: expected 6");
}

fn assert_range<A: Attenuation>(attenuation: A) {
    let mut rng = Rng::with_seed(42);
    for _ in 0..500 {
        let [intensity, light] = [(); 2].map(|()| 10_f32.powf(12.0 * rng.f32() - 8.0));
        let bulb =
            PointLight::new([0.0; 3]).and_then(|bulb| bulb.with_intensity(intensity)).expect("a light");
        let range = bulb.with_attenuation(attenuation).range_above(light);
        let exact = |distance: f64| f64::from(intensity) * attenuation.exact(distance);
        let least = f64::from(range);
        if range.is_finite() {
            assert!(exact(least) < f64::from(light), "{attenuation:?}, {intensity}, {light}: {range}");
        }
        let before = if range.is_finite() { least * (1.0 - 2e-6) } else { f64::from(f32::MAX) };
        assert!(
            range < 1e-40 || exact(before) >= f64::from(light),
            "{attenuation:?}, {intensity}, {light}: {range}"
        );
    }
    let bulb = PointLight::new([0.0; 3]).expect("a light").with_attenuation(attenuation);
    assert!([0.0, -1.0, f32::NAN].iter().all(|light| bulb.range_above(*light) == f32::INFINITY));
}

#[test]
fn the_range_of_a_light_ends_where_it_falls_below() {
    assert_range(InverseSquare);
    assert_range(NoAttenuation);
    assert_range(SmoothRange::new(9.0).expect("a range"));
    assert_range(FilamentRange::new(InverseSquare, Some(12.0)).expect("a range"));
    assert_range(CutAt::new(Decay::new(1.5, 100.0).expect("a decay"), None).expect("a range"));
    assert_range(Polynomial::new(0.5, 0.25, 0.125).expect("coefficients"));
}
