//! Compiled spotlights that zoom at run time, compared with the exact cone between the two.

use fastrand::Rng;
use luminaire::{
    Angle, Cone, Error, Fx16, Fx32, SpotLight, Vec3,
    attenuation::NoAttenuation,
    codegen::{FixedRamp, FloatRamp},
    error::{Expected, Parameter},
    falloff::{AnyFalloff, Falloff, Power, Soft, Step},
    number::Quick,
};
use support::{
    assert_that,
    every::is_full,
    format::Format,
    oracle::{
        self, DVec3,
        climb::{self, Search, Worst},
    },
    sweep::{self, half},
};

/// The least share of a hotspot or a cutoff in the outer angle that is drawn.
const LEAST: f32 = 1e-6;

/// A pair of cones by their outer half angles in degrees, the share of the cutoff in the outer
/// angle and of the hotspot in the cutoff, and the part of the way from one cone to the other.
#[derive(Clone, Copy, Debug)]
struct Zoom {
    outer: [f32; 2],
    inner: [f32; 2],
    cutoff: [f32; 2],
    part: f32,
}

impl Zoom {
    /// From narrow to wide, equal, and far apart; half of the cones are open.
    fn somewhere(rng: &mut Rng, narrowest: f32) -> Self {
        let angle = |rng: &mut Rng| narrowest * (89.9 / narrowest).powf(rng.f32());
        let share = |rng: &mut Rng, none: f32| if rng.bool() { none } else { 0.1 + 0.9 * rng.f32() };
        let first = angle(rng);
        Self {
            outer: [first, if rng.u8(..8) == 0 { first } else { angle(rng) }],
            inner: [(); 2].map(|()| 0.9 * share(rng, 0.0)),
            cutoff: [(); 2].map(|()| 0.2 + 0.8 * share(rng, 1.0)),
            part: rng.f32(),
        }
    }

    fn moved(self, rng: &mut Rng, narrowest: f32) -> Self {
        let (mut zoom, step, side) = (self, climb::size(rng), usize::from(rng.bool()));
        match rng.u8(..4) {
            0 => zoom.outer[side] = (zoom.outer[side] * (1.0 + step)).clamp(narrowest, 89.9),
            1 if zoom.inner[side] > 0.0 => {
                zoom.inner[side] = (zoom.inner[side] * (1.0 + step)).clamp(0.1, 0.9)
            }
            2 => zoom.cutoff[side] = (zoom.cutoff[side] * (1.0 + step)).clamp(0.2, 1.0),
            _ => zoom.part = (zoom.part * (1.0 + step)).clamp(0.0, 1.0),
        }
        zoom
    }

    /// With hotspots and cutoffs of any share from [`LEAST`] on.
    fn anywhere(rng: &mut Rng, narrowest: f32) -> Self {
        let mut share = |none: f32| match rng.u8(..4) {
            0 => none,
            1 => rng.f32().max(LEAST),
            2 => LEAST.powf(rng.f32()),
            _ => 1.0 - 1e-6_f32.powf(rng.f32()),
        };
        let (inner, cutoff) = ([(); 2].map(|()| share(0.0)), [(); 2].map(|()| share(1.0)));
        Self { inner, cutoff, ..Self::somewhere(rng, narrowest) }
    }

    fn moved_anywhere(self, rng: &mut Rng, narrowest: f32) -> Self {
        let Self { mut inner, mut cutoff, .. } = self;
        let (step, side) = (climb::size(rng), usize::from(rng.bool()));
        match rng.u8(..4) {
            0 if inner[side] > 0.0 => inner[side] = (inner[side] * (1.0 + step)).clamp(LEAST, 0.999_999),
            1 => cutoff[side] = (cutoff[side] * (1.0 + step)).clamp(LEAST, 1.0),
            _ => return Self { inner, cutoff, ..self.moved(rng, narrowest) },
        }
        Self { inner, cutoff, ..self }
    }

    fn cones<P: Falloff>(&self, falloff: P) -> Result<[Cone<P>; 2], Error> {
        let cone = |side: usize| {
            let (outer, cutoff) = (self.outer[side], self.cutoff[side]);
            let cone = Cone::from_outer(falloff, half(outer))?
                .with_inner(half(outer * cutoff * self.inner[side]))?;
            if cutoff < 1.0 { cone.with_cutoff(half(outer * cutoff)) } else { Ok(cone) }
        };
        Ok([cone(0)?, cone(1)?])
    }

    /// The exact cone at a part of the way.
    fn exact(&self, falloff: oracle::Falloff, part: f64) -> oracle::Cone {
        let between = |angle: fn(&Self, usize) -> f32| {
            let [from, to] = [0, 1].map(|side| oracle::versine(angle(self, side).into()).sqrt());
            (from + (to - from) * part).powi(2)
        };
        oracle::Cone {
            inner: between(|zoom, side| zoom.outer[side] * zoom.cutoff[side] * zoom.inner[side]),
            limit: between(|zoom, side| zoom.outer[side] * zoom.cutoff[side]),
            ..oracle::Cone::new(falloff, between(|zoom, side| zoom.outer[side]))
        }
    }
}

fn light<P: Falloff>(cone: Cone<P>) -> SpotLight<P> {
    SpotLight::new([0.0; 3], [0.0, 0.0, -1.0], cone).expect("a sound light")
}

/// A pair of cones and a point: its angle off axis over that of the end of the zoomed light, its
/// distance, and its turn about the axis.
type Input = (Zoom, [f32; 3]);

fn somewhere(rng: &mut Rng, narrowest: f32) -> Input {
    (Zoom::somewhere(rng, narrowest), [1.05 * rng.f32(), 0.3 + 15.0 * rng.f32(), 6.3 * rng.f32()])
}

fn moved(rng: &mut Rng, (zoom, point): Input, narrowest: f32) -> Input {
    if rng.bool() {
        return (zoom.moved(rng, narrowest), point);
    }
    let step = climb::size(rng);
    let [off, distance, turn] = climb::one_of(rng, point, |c| c * (1.0 + step));
    (zoom, [off.min(1.1), distance.clamp(0.3, 16.0), turn])
}

/// The error of a zoomed light's falloff at a point. It is 0 if the format refuses one of the
/// cones, and where the falloff jumps.
fn error<S: Format>((zoom, point): Input) -> f64 {
    let Ok([from, to]) = zoom.cones(Soft) else { return 0.0 };
    let Ok([from, to]) = light(from).compile_zoom::<S>(&to) else { return 0.0 };
    let part = S::from_f32(zoom.part);
    let Some((point, expected)) = place::<S>(zoom.exact(oracle::soft, part.exact()), point) else {
        return 0.0;
    };
    (from.zoomed(&to, part).falloff_at(point).exact() - expected).abs()
}

/// The error of a zoomed light of the quick evaluation.
fn quick_error<S: Format + Quick>((zoom, point): Input) -> f64 {
    let Ok([from, to]) = zoom.cones(Soft) else { return 0.0 };
    let part = S::from_f32(zoom.part);
    let exact = zoom.exact(oracle::soft, part.exact());
    let Some((point, expected)) = place::<S>(exact, point) else { return 0.0 };
    let ends = [from, to].map(|cone| light(cone).with_attenuation(NoAttenuation).compile_quick::<S>());
    let [Ok(from), Ok(to)] = ends else { return 0.0 };
    let back = -S::exact_point(point).normalize();
    let normal = sweep::single(back).map(S::from_f32);
    let found = S::exact_light(from.zoomed(&to, part).irradiance(point, normal));
    (found - expected * back.dot(S::exact_normal(normal))).abs()
}

/// The bound of the error of a light whose cone is the one between. The format may refuse that cone where it
/// accepts the two: then the bound is 1.2 times that of the worse of the two.
fn quick_bound<S: Format + Quick>((zoom, _): Input) -> f64 {
    let [from, to] = zoom.cones(Soft).expect("it has an error");
    let bound = |cone| {
        let light = light(cone).with_attenuation(NoAttenuation);
        Some(f64::from(light.quick_error_bound::<S>(0.3..=16.0).ok()?.light))
    };
    let ends = || [from, to].into_iter().filter_map(bound).fold(0.0, f64::max);
    bound(from.zoomed(&to, zoom.part)).unwrap_or_else(|| 1.2 * ends())
}

/// A point as the format stores it, and the exact falloff there; `None` where the falloff jumps.
fn place<S: Format>(cone: oracle::Cone, [off, distance, turn]: [f32; 3]) -> Option<(Vec3<S::Length>, f64)> {
    let end = oracle::half_degrees(cone.limit).to_radians();
    let ((sine, cosine), (right, up)) = ((f64::from(off) * end).sin_cos(), f64::from(turn).sin_cos());
    let way = f64::from(distance) * DVec3::new(sine * right, sine * up, -cosine);
    let point = sweep::single(way).map(S::length);
    let versine = oracle::versine_between(S::exact_point(point), -DVec3::Z);
    let jumps = cone.limit < cone.outer && (f64::from(off) - 1.0).abs() * end < 3e-4 * end + 3e-4;
    (!jumps).then(|| (point, cone.falloff(versine)))
}

/// The largest error over pairs of cones from a half angle in degrees on, by climbing.
fn worst<S: Format>(narrowest: f32, error: fn(Input) -> f64) -> Worst<Input> {
    let effort = sweep::effort();
    let search = Search { starts: 20_000 * effort, climbs: 8 * effort, steps: 3_000, ..Search::default() };
    let found =
        search.worst(|rng| somewhere(rng, narrowest), |rng, input| moved(rng, input, narrowest), error);
    let found = found.expect("some error");
    println!("{} from {narrowest} degrees: {:.2e} at {:?}", S::NAME, found.error, found.input);
    found
}

#[test]
fn a_zoomed_light_has_the_exact_falloff_between() {
    for (error, bound) in [
        (worst::<Fx16>(0.7, error::<Fx16>), 1.0 / 510.0),
        (worst::<Fx32>(0.01, error::<Fx32>), 2.5e-4),
        (worst::<Fx32>(5.0, error::<Fx32>), 3.5e-6),
        (worst::<f32>(0.1, error::<f32>), 6e-6),
    ] {
        let Worst { error, .. } = error;
        assert_that!((bound / 3.0..=bound).contains(&error), error);
    }
}

#[test]
fn a_zoomed_quick_light_keeps_its_bound() {
    fn part_of_bound<S: Format + Quick>() -> f64 {
        let Worst { input, error } = worst::<S>(1.0, quick_error::<S>);
        error / quick_bound::<S>(input)
    }
    let part = part_of_bound::<Fx16>();
    assert_that!((0.3..=1.0).contains(&part), part);
}

/// A format with the versines that a ramp of it has: the inner one, the outer one and that of the end.
trait Ramped: Format {
    /// By how many radians a half angle between two may be off, by which part of it, and the versine of the inner angle
    /// by which part of the outer versine more.
    const BETWEEN: [f64; 3];

    fn versines(ramp: Self::Ramp) -> [f64; 3];
}

impl Ramped for f32 {
    /// A root, the complement of the part, a product and a sum have a rounding each, and a square doubles them and has one
    /// more: nine in all. A half angle has up to `2 / pi` of that relative error.
    const BETWEEN: [f64; 3] = [0.0, 3.5e-7, 0.0];

    fn versines(ramp: FloatRamp) -> [f64; 3] {
        let [outer, limit, _, inner] = ramp.to_bits().map(|bits| f64::from(f32::from_bits(bits)));
        [inner, outer, limit]
    }
}

/// A chord is within a relative 7.5e-9 and two units of 2^-31, of which a half angle has up to twice and `4 / pi` times
/// as much. A versine between is rounded by up to a unit of 2^-30 of at least a half, and the reciprocal of the
/// edge gives an outer versine back within 1e-9.
macro_rules! fixed_ramp {
    ($($format:ty)*) => {$(
        impl Ramped for $format {
            const BETWEEN: [f64; 3] = [1.9e-9, 1.3e-8, 2e-9];

            fn versines(ramp: FixedRamp) -> [f64; 3] {
                let [zoom, inner, width, .., fine, fine_shift, fine_mantissa] = ramp.to_bits();
                let span = (f64::from(fine_shift) + 31.0).exp2() / f64::from(fine_mantissa);
                let inner = f64::from(inner);
                let limit = inner + f64::from(width.max(fine));
                [inner, inner + span, limit].map(|versine| versine * (-29.0 - 2.0 * f64::from(zoom)).exp2())
            }
        }
    )*};
}

fixed_ramp!(Fx32 Fx16);

/// The errors of the angles of a zoomed ramp are at most the stated ones, and the largest is not much less.
#[test]
fn a_zoomed_ramp_has_the_angles_between() {
    /// The largest error of the inner versine, the outer versine and that of the end, in units of its bound.
    fn part_of_bound<S: Ramped>(zoom: Zoom) -> f64 {
        let is_held = |cones: &[Cone<Step>; 2]| cones.iter().all(|cone| cone.compile::<S>().is_ok());
        let Some(cones) = zoom.cones(Step).ok().filter(is_held) else { return 0.0 };
        let ramps = cones.map(|cone| {
            let [inner, outer, limit] = cone.versines();
            S::ramp(inner, outer, limit)
        });
        let part = S::from_f32(zoom.part);
        // The ends are exact.
        if part >= S::ONE {
            return 0.0;
        }
        let [from, to] = ramps.map(S::versines);
        let found = S::versines(S::zoomed(ramps[0], ramps[1], part).0);
        let exact = [0, 1, 2].map(|i| {
            let [from, to] = [from, to].map(|versines| versines[i].sqrt());
            (from + (to - from) * part.exact()).powi(2)
        });
        let [absolute, relative, of_inner] = S::BETWEEN;
        let parts = [0, 1, 2].map(|i| {
            let versine = exact[i].min(1.0);
            let angle = (1.0 - versine).acos().max((2.0 * versine).sqrt());
            let off = absolute + relative * angle;
            let bound = off * angle.sin() + off * off + if i == 0 { of_inner * exact[1] } else { 0.0 };
            let off = (found[i] - exact[i]).abs();
            if off > 0.0 { oracle::counted(off / bound) } else { oracle::counted(off) }
        });
        parts.into_iter().fold(0.0, f64::max)
    }
    fn assert_between<S: Ramped>(narrowest: f32) {
        let (starts, climbs, steps) = if is_full() { (1_000_000, 600, 50_000) } else { (20_000, 8, 3_000) };
        let search = Search { starts, climbs, steps, ..Search::default() };
        let anywhere = |rng: &mut Rng| Zoom::anywhere(rng, narrowest);
        let moved = |rng: &mut Rng, zoom: Zoom| zoom.moved_anywhere(rng, narrowest);
        let worst = search.worst(anywhere, moved, part_of_bound::<S>).expect("some error");
        println!("{}: {:.3} of the bound at {:?}", S::NAME, worst.error, worst.input);
        assert_that!((0.3..=1.0).contains(&worst.error), worst);
    }
    assert_between::<Fx16>(0.3);
    assert_between::<Fx32>(1e-4);
    assert_between::<f32>(1e-3);
}

/// Between two cones the width of an edge may fall faster than its slope rises: the bound of a quick light is larger there.
#[test]
fn a_quick_cone_between_may_have_a_larger_bound() {
    fn times<P: Falloff>(falloff: P, outer: [f32; 2], inner: [f32; 2]) -> f32 {
        let [from, to] =
            Zoom { outer, inner, cutoff: [1.0; 2], part: 0.0 }.cones(falloff).expect("sound angles");
        let bound = |cone| {
            let light = light(cone).with_attenuation(NoAttenuation);
            light.quick_error_bound::<Fx16>(0.3..=16.0).expect("held").light
        };
        let between = (1..24).map(|k| bound(from.zoomed(&to, 1.0 - 0.7_f32.powi(k))));
        between.fold(0.0, f32::max) / bound(from).max(bound(to))
    }
    let soft = times(Soft, [88.872_246, 1.538_514_1], [0.944_174_5, 0.212_701_17]);
    let power = times(Power::<8>, [33.738_77, 2.223_590_6], [0.751_046_9, 0.0]);
    assert_that!((1.09..=1.11).contains(&soft) && (1.45..=1.47).contains(&power), soft, power);
}

/// The cones with an angle as the error of their zoom expects it, if the error names one of theirs.
fn mended<P: Falloff>(rng: &mut Rng, cones: [Cone<P>; 2], error: Error) -> Option<[Cone<P>; 2]> {
    let Error { parameter, value, accepted } = error;
    let degrees = match accepted {
        Expected::AngleBetween(least, most) => match rng.u8(..4) {
            0 => least,
            1 => most,
            _ => (least + (most - least) * rng.f32()).clamp(least, most),
        },
        Expected::AngleFrom(least) => (least * 1.000_001 * if rng.bool() { 1.0 } else { 1.3 }).min(180.0),
        _ => return None,
    };
    let angle = Angle::degrees(degrees);
    let side = [0, 1].into_iter().find(|&side| {
        let [inner, outer, limit] = cones[side].versines();
        let versine = match parameter {
            Parameter::InnerAngle => inner,
            Parameter::OuterAngle => outer,
            Parameter::CutoffAngle => limit,
            _ => return false,
        };
        Angle::from_versine(versine).to_degrees() == value
    })?;
    let [inner, outer, limit] = cones[side].versines();
    let mended = match parameter {
        Parameter::InnerAngle => cones[side].with_inner(angle),
        Parameter::CutoffAngle => cones[side].with_cutoff(angle),
        _ => {
            let wide = angle.versine().min(1.0);
            let [inner, limit] = [inner, limit].map(|versine| (versine / outer * wide).min(wide));
            Cone::from_versines(cones[side].falloff(), [inner, wide, limit])
        }
    };
    let mut cones = cones;
    cones[side] = mended.ok()?;
    Some(cones)
}

/// An error names an angle of one of the two cones, and with an accepted angle the zoom compiles: if one angle is enough,
/// at once.
#[test]
fn a_refused_zoom_says_what_it_takes() {
    fn assert_mended<S: Format>(narrowest: f32) {
        let mut rng = Rng::with_seed(6);
        let mut after = [0; 5];
        for falloff in AnyFalloff::samples() {
            for _ in 0..if is_full() { 20_000 } else { 300 } {
                let mut zoom = Zoom::anywhere(&mut rng, narrowest);
                if rng.bool() {
                    // Next to the narrowest, alone or both.
                    let least = Cone::narrowest::<S>(falloff).to_degrees() / 2.0;
                    let beside = |rng: &mut Rng| (least * (1.0 + 3.0 * rng.f32().powi(2))).min(89.9);
                    zoom.outer =
                        [beside(&mut rng), if rng.bool() { beside(&mut rng) } else { zoom.outer[1] }];
                }
                let Ok(mut cones) = zoom.cones(falloff) else { continue };
                if rng.u8(..16) == 0 {
                    cones[0] = cones[0].with_inner(cones[0].outer()).unwrap_or(cones[0]);
                }
                if cones.iter().any(|cone| cone.compile::<S>().is_err()) {
                    continue;
                }
                let first = cones;
                let mut steps = 0;
                while let Err(error) = light(cones[0]).compile_zoom::<S>(&cones[1]) {
                    steps += 1;
                    let next = mended(&mut rng, cones, error).filter(|_| steps < after.len());
                    cones = next.unwrap_or_else(|| panic!("{} {error}: {first:?} {cones:?}", S::NAME));
                }
                after[steps] += 1;
            }
        }
        println!("{}: {after:?}", S::NAME);
        let [at_once, after_one, ..] = after;
        assert_that!(
            at_once > 100 && after_one > 20 && 4 * after[2..].iter().sum::<u32>() < after_one,
            after
        );
    }
    assert_mended::<f32>(0.004);
    assert_mended::<Fx32>(1e-4);
    assert_mended::<Fx16>(0.6);
}

/// The errors of chords leave less room than a single light has: in `Fx32` for narrow cones, in `f32` for steep edges.
#[test]
fn a_zoom_needs_room_for_its_chords() {
    fn least(mut refused: f32, mut held: f32, holds: impl Fn(f32) -> bool) -> f32 {
        for _ in 0..20 {
            let middle = (refused + held) / 2.0;
            if holds(middle) { held = middle } else { refused = middle }
        }
        held
    }
    fn zooms<S: Format>(cone: Cone<Soft>) -> bool {
        light(cone).compile_zoom::<S>(&cone).is_ok()
    }
    let narrowest = Cone::narrowest::<Fx32>(Soft).to_degrees();
    let soft = |degrees: f32| Cone::from_outer(Soft, Angle::degrees(degrees)).expect("a sound angle");
    let wider = least(narrowest, 9.0 * narrowest, |degrees| zooms::<Fx32>(soft(degrees))) / narrowest;
    let edge =
        |width: f32| soft(90.0).with_inner(Angle::degrees(90.0 * (1.0 - width))).expect("a narrower angle");
    let single = least(1e-4, 1.0, |width| edge(width).compile::<f32>().is_ok());
    let steeper = single / least(1e-4, 1.0, |width| zooms::<f32>(edge(width)));
    assert_that!((1.7..=1.75).contains(&wider) && (0.7..=0.73).contains(&steeper), wider, steeper);
}

/// At its ends a zoom has exactly the two cones, also for parts outside [0, 1] and NaN.
fn assert_ends<S: Format>(parts: [&[S]; 2]) {
    let mut rng = Rng::with_seed(1);
    for _ in 0..300 {
        let Ok([from, to]) = Zoom::somewhere(&mut rng, 1.0).cones(Soft) else { continue };
        let Ok([narrow, wide]) = light(from).compile_zoom::<S>(&to) else { continue };
        for &part in parts[0] {
            assert_eq!(narrow.zoomed(&wide, part), narrow);
        }
        for &part in parts[1] {
            assert_eq!(narrow.zoomed(&wide, part), wide);
        }
    }
}

/// The same in the quick evaluation.
fn assert_quick_ends<S: Format + Quick>(parts: [&[S]; 2]) {
    let mut rng = Rng::with_seed(1);
    for _ in 0..300 {
        let Ok(cones) = Zoom::somewhere(&mut rng, 1.0).cones(Soft) else { continue };
        let [Ok(narrow), Ok(wide)] = cones.map(|cone| light(cone).compile_quick::<S>()) else { continue };
        for (parts, end) in parts.into_iter().zip([narrow, wide]) {
            parts.iter().for_each(|&part| assert_eq!(narrow.zoomed(&wide, part), end));
        }
    }
}

#[test]
fn the_ends_of_a_zoom_are_its_cones() {
    let (fx16, fx32) = (Fx16::from_bits, Fx32::from_bits);
    let sixteen: [&[Fx16]; 2] = [&[fx16(0), fx16(-1), fx16(i16::MIN)], &[Fx16::ONE, fx16(i16::MAX)]];
    let single: [&[f32]; 2] = [&[0.0, -0.0, -7.0, f32::NAN], &[1.0, 2.0, f32::INFINITY]];
    assert_ends(sixteen);
    assert_ends([&[fx32(0), fx32(-1), fx32(i32::MIN)], &[Fx32::ONE, fx32(i32::MAX)]]);
    assert_ends(single);
    assert_quick_ends(sixteen);
}

/// Between two lights that were compiled singly, a point has the fine evaluation if either light has it there.
#[test]
fn a_zoom_is_as_fine_as_its_finer_end() {
    let [narrow, wide] = [8.0, 60.0].map(|degrees| {
        let bright = light(Cone::from_outer(Soft, half(degrees)).expect("a cone")).with_intensity(4.0);
        bright.and_then(|light| light.compile::<Fx16>()).expect("a light")
    });
    let mut apart = 0;
    for (from, to) in [(narrow, wide), (wide, narrow)] {
        let between = from.zoomed(&to, Fx16::from_bits(1 << 13));
        for step in 1..400_u16 {
            let point = Fx16::point([0.0, 0.0, -0.02 * f32::from(step)]);
            let ends = [narrow, wide].map(|light| light.is_fine(point));
            assert_eq!(between.is_fine(point), ends.contains(&true), "{point:?}: {ends:?}");
            apart += u32::from(ends == [true, false]);
        }
    }
    assert_that!(apart > 10, apart);
}

/// The early-outs of a zoomed light change no bit, and outside of the cone is no light.
fn assert_skips<S: Format, P: Falloff>(falloff: P) {
    let mut rng = Rng::with_seed(2);
    let (mut rims, mut lit) = (0, 0);
    for _ in 0..2_000 {
        let zoom = Zoom::somewhere(&mut rng, 1.0);
        let Ok([from, to]) = zoom.cones(falloff) else { continue };
        let Ok([narrow, wide]) = sweep::spot(&mut rng, from).compile_zoom::<S>(&to) else { continue };
        let part = S::from_f32(zoom.part);
        let zoomed = narrow.zoomed(&wide, part);
        let end = oracle::half_degrees(zoom.exact(oracle::step, part.exact()).limit);
        for _ in 0..40 {
            let off = end.to_radians() * (1.0 + 2e-3 * (rng.f64() - 0.6));
            let way = sweep::direction_off(&mut rng, S::exact_direction(zoomed.axis()), off);
            let place = S::exact_point(zoomed.position()) + 5.0 * way;
            let point = sweep::single(place).map(S::length);
            let normal = sweep::single(-way).map(S::from_f32);
            let light = zoomed.irradiance(point, normal);
            assert_eq!(light, zoomed.irradiance_unskipped(point, normal), "{zoom:?}");
            assert_eq!(zoomed.falloff_at(point) > S::ZERO, light > S::Irradiance::default(), "{zoom:?}");
            rims += 1;
            lit += i32::from(light > S::Irradiance::default());
        }
    }
    assert_that!(rims > 20_000 && (rims / 4..rims * 9 / 10).contains(&lit), lit, rims);
}

#[test]
fn a_zoomed_light_skips_only_darkness() {
    assert_skips::<Fx16, _>(Step);
    assert_skips::<Fx32, _>(Step);
    assert_skips::<f32, _>(Step);
}

/// The angle is nearly linear in the part: the largest lack of the full angle, in degrees.
#[test]
fn a_zoom_is_nearly_linear_in_the_angle() {
    let lack = |widest: f32| {
        let cone = |degrees: f32| Cone::from_outer(Soft, Angle::degrees(degrees)).expect("a sound angle");
        let parts = (1..200).map(|part| part as f32 / 200.0);
        let lack = |narrow: f32, part: f32| {
            let linear = narrow + (widest - narrow) * part;
            linear - cone(narrow).zoomed(&cone(widest), part).outer().to_degrees()
        };
        [0.01, 0.1, 0.3, 0.6, 0.9]
            .into_iter()
            .flat_map(|share| parts.clone().map(move |part| lack(share * widest, part)))
            .fold([0.0_f32; 2], |[least, most], lack| [least.min(lack), most.max(lack)])
    };
    for (widest, stated) in [(40.0, 0.08), (60.0, 0.27), (90.0, 0.9), (120.0, 2.2), (180.0, 7.6)] {
        let [least, most] = lack(widest);
        println!("{widest} degrees: {least:e} to {most}");
        assert_that!(least > -1e-4 && (stated / 1.5..=stated).contains(&most), widest, least, most);
    }
}
