//! Accuracy of set-up against f64: angles, cones, flux and the properties of falloffs, row by row
//! of `tests/bounds.csv`. Set-up computes in f32, whatever the format of the light.

use fastrand::Rng;
use luminaire::{
    Angle, Cone, Error, HalfAngle, PointLight, SpotLight, Vec3,
    attenuation::{Attenuation, CutAt, FilamentRange, GltfRange, InverseSquare, SmoothRange},
    falloff::{Falloff, Formula, Step},
};
use support::{
    assert_that, bounds,
    falloffs::Shape,
    format::Format,
    oracle::{self, half_degrees},
    sweep, with_every_shape,
};

fn assert_figure(name: &str, measured: f64) {
    bounds::assert_figure("set-up", name, measured);
}

pub(crate) fn relative(found: f32, exact: f64) -> f64 {
    (f64::from(found) / exact - 1.0).abs()
}

/// The largest error over full angles from 0.01 to 179.99 degrees.
fn over_angles(error: impl Fn(f32) -> f64) -> f64 {
    let count = 20_000 * sweep::effort();
    let angles = (0..count).map(|i| 0.01 * 17_999.0_f32.powf(i as f32 / (count - 1) as f32));
    angles.map(error).fold(0.0, f64::max)
}

#[test]
fn angles_keep_their_figures() {
    let radians = |degrees: f32| f64::from(degrees).to_radians();
    assert_figure("angle in radians", over_angles(|d| relative(Angle::degrees(d).to_radians(), radians(d))));
    assert_figure(
        "angle from radians",
        over_angles(|d| relative(Angle::radians(d / 57.0).to_degrees(), f64::from(d / 57.0).to_degrees())),
    );
    assert_figure(
        "half angle in radians",
        over_angles(|d| relative(HalfAngle::degrees(d).to_radians(), radians(d))),
    );
    assert_figure(
        "half angle from radians",
        over_angles(|d| {
            relative(HalfAngle::radians(d / 57.0).to_degrees(), f64::from(d / 57.0).to_degrees())
        }),
    );
    let versine = |d: f32| relative(Angle::degrees(d).versine(), oracle::versine(f64::from(d) / 2.0));
    assert_figure("versine of an angle", over_angles(versine));
    let angle = |d: f32| {
        let versine = oracle::versine(f64::from(d) / 2.0) as f32;
        relative(Angle::from_versine(versine).to_degrees(), 2.0 * half_degrees(versine.into()))
    };
    assert_figure("angle of a versine", over_angles(angle));
}

/// The last `u` at which a falloff has at least the given intensity, by bisection in f64.
pub(crate) fn last_u(oracle: impl Fn(f64) -> f64, intensity: f64) -> f64 {
    let (mut light, mut dark) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = (light + dark) / 2.0;
        if oracle(1.0 - middle) >= intensity { light = middle } else { dark = middle }
    }
    light
}

/// The integral of a falloff over `u` from 0, by the midpoint rule.
fn integral(oracle: oracle::Falloff, to: f64) -> f64 {
    let steps = 20_000;
    let width = to / f64::from(steps);
    (0..steps).map(|i| oracle(1.0 - (f64::from(i) + 0.5) * width)).sum::<f64>() * width
}

/// The function of a falloff in the list of models agrees with its formula.
#[test]
fn the_f64_form_of_a_falloff_is_its_formula() {
    fn assert_formula<P: Falloff>(shape: &Shape<P>) {
        for i in 0..=1_000 {
            let t = f64::from(i) / 1_000.0;
            let (found, expected) = ((shape.oracle)(t), shape.falloff.formula().exact(t));
            assert_that!((found - expected).abs() < 1e-15, shape.name, t, found, expected);
        }
    }
    with_every_shape!(assert_formula);
}

fn profile_errors<P: Falloff>(shape: &Shape<P>) -> [f64; 3] {
    let beam = relative(shape.falloff.beam_versine(), last_u(shape.oracle, 0.5));
    let field = relative(shape.falloff.field_versine(), last_u(shape.oracle, 0.1));
    let at = |u: f32| relative(shape.falloff.integral(u), integral(shape.oracle, u.into()));
    [beam, field, (1..=20_u8).map(|i| at(f32::from(i) / 20.0)).fold(0.0, f64::max)]
}

fn largest<const N: usize>(errors: impl IntoIterator<Item = [f64; N]>) -> [f64; N] {
    errors.into_iter().fold([0.0; N], |worst, errors| std::array::from_fn(|i| worst[i].max(errors[i])))
}

#[test]
fn profiles_keep_their_figures() {
    let [beam, field, integral] = largest(with_every_shape!(profile_errors -> [f64; 3]));
    assert_figure("beam versine of a falloff", beam);
    assert_figure("field versine of a falloff", field);
    assert_figure("integral of a falloff", integral);
}

/// The largest slope of a falloff over the angle, per outer half angle, by differences: of the
/// versine in a narrow cone, the angle is the square root.
fn largest_slope(formula: Formula<'_>, hotspot: f64) -> f64 {
    const STEPS: u32 = 40_000;
    let at = |i: u32| hotspot.sqrt() + (1.0 - hotspot.sqrt()) * f64::from(i) / f64::from(STEPS);
    let intensity = |angle: f64| formula.exact(((1.0 - angle * angle) / (1.0 - hotspot)).clamp(0.0, 1.0));
    let slope = |i| (intensity(at(i)) - intensity(at(i + 1))) / (at(i + 1) - at(i));
    (0..STEPS).map(slope).fold(0.0, f64::max)
}

/// The narrowest cone of a format follows from the steepness: too small a figure would accept a
/// cone that the format cannot hold, too large a one would refuse more than it must.
#[test]
fn the_steepness_is_the_largest_slope() {
    fn assert_steepness<P: Falloff>(shape: &Shape<P>) {
        for hotspot in [0.0, 0.25, 0.9] {
            let stated = f64::from(shape.falloff.steepness(hotspot));
            let found = largest_slope(shape.falloff.formula(), hotspot.into());
            // The differences of a kink at an end are off by their width.
            let holds = (0.999_999..=1.000_2).contains(&(stated / found));
            let is_step = shape.falloff.formula().exact(1e-9) == 1.0;
            assert!(holds || is_step, "{} {hotspot}: {stated} for {found}", shape.name);
        }
    }
    with_every_shape!(assert_steepness);
}

/// The factors of attenuations in f64, from which all errors are measured, at places of round
/// value.
#[test]
fn the_f64_form_of_an_attenuation_is_its_formula() -> Result<(), Error> {
    let smooth = SmoothRange::new(8.0)?;
    assert_eq!([0.0, 4.0, 6.0, 8.0, 9.0].map(|d| smooth.exact(d)), [1.0, 0.5, 0.15625, 0.0, 0.0]);
    let gltf = GltfRange::new(InverseSquare, Some(8.0))?;
    assert_eq!([4.0, 8.0, 9.0].map(|d| gltf.exact(d)), [0.9375 / 16.0, 0.0, 0.0]);
    let cut = CutAt::new(InverseSquare, Some(8.0))?;
    assert_eq!([4.0, 8.0, 9.0].map(|d| cut.exact(d)), [1.0 / 16.0, 0.0, 0.0]);
    let filament = FilamentRange::new(InverseSquare, Some(8.0))?;
    assert_eq!([4.0, 8.0, 9.0].map(|d| filament.exact(d)), [0.9375 * 0.9375 / 16.0, 0.0, 0.0]);
    Ok(())
}

/// The errors of the outer angle of cones that are designed from their outer, field and beam angle.
fn design_errors<P: Falloff>(shape: &Shape<P>) -> [f64; 3] {
    let (to_field, to_beam) = (last_u(shape.oracle, 0.1), last_u(shape.oracle, 0.5));
    let error = |cone: Result<Cone<P>, _>, degrees: f32, u: f64| {
        let cone = cone.ok()?;
        Some(relative(cone.outer_versine(), oracle::versine(f64::from(degrees) / 2.0) / u))
    };
    largest((1..=300).map(|i| {
        let degrees = 0.01 * 17_000.0_f32.powf(i as f32 / 300.0);
        let (falloff, angle) = (shape.falloff, Angle::degrees(degrees));
        let outer = error(Cone::from_outer(falloff, angle), degrees, 1.0);
        let field = error(Cone::from_field(falloff, angle), degrees, to_field);
        let beam = error(Cone::from_beam(falloff, angle), degrees, to_beam);
        // If the outer angle would exceed 180 degrees, there is no cone.
        [outer, field, beam].map(|error| error.unwrap_or(0.0))
    }))
}

/// The errors of the inner, beam, field and outer angles that a cone's getters return.
fn angle_errors<P: Falloff>(shape: &Shape<P>) -> [f64; 4] {
    largest((0..=60).map(|i| {
        let half = 0.01 * 9_000.0_f32.powf(i as f32 / 60.0);
        let (cone, exact) = (shape.at(half), shape.exactly_at(half));
        let last = |intensity: f64| {
            let (mut light, mut dark) = (0.0, exact.limit);
            for _ in 0..60 {
                let middle = (light + dark) / 2.0;
                if exact.falloff(middle) >= intensity { light = middle } else { dark = middle }
            }
            2.0 * half_degrees(light)
        };
        let inner = match exact.inner {
            0.0 => cone.inner().to_degrees().into(),
            inner => relative(cone.inner().to_degrees(), 2.0 * half_degrees(inner)),
        };
        let outer = relative(cone.outer().to_degrees(), 2.0 * half_degrees(exact.limit));
        [
            inner,
            relative(cone.beam().to_degrees(), last(0.5)),
            relative(cone.field().to_degrees(), last(0.1)),
            outer,
        ]
    }))
}

fn flux_errors<P: Falloff>(shape: &Shape<P>) -> [f64; 2] {
    largest([0.1_f32, 3.0, 20.0, 90.0].map(|half| {
        let (cone, exact) = (shape.at(half), shape.exactly_at(half));
        let steps = 50_000;
        let width = exact.limit / f64::from(steps);
        let sum: f64 = (0..steps).map(|i| exact.falloff((f64::from(i) + 0.5) * width)).sum();
        let lumens = 1_000.0 * std::f64::consts::TAU * sum * width;
        [relative(cone.lumens(1_000.0), lumens), relative(cone.candela(lumens as f32), 1_000.0)]
    }))
}

#[test]
fn cones_keep_their_figures() {
    let [outer, field, beam] = largest(with_every_shape!(design_errors -> [f64; 3]));
    assert_figure("outer versine from the outer angle", outer);
    assert_figure("outer versine from the field angle", field);
    assert_figure("outer versine from the beam angle", beam);
    let [inner, beam, field, outer] = largest(with_every_shape!(angle_errors -> [f64; 4]));
    assert_figure("inner angle of a cone", inner);
    assert_figure("beam angle of a cone", beam);
    assert_figure("field angle of a cone", field);
    assert_figure("outer angle of a cone", outer);
    let [lumens, candela] = largest(with_every_shape!(flux_errors -> [f64; 2]));
    assert_figure("lumens of a cone", lumens);
    assert_figure("candela of a cone", candela);
}

/// The flux of a point light is `4 pi` times its intensity, and twice the flux of a step cone of
/// 180 degrees. A flux of 1 gives an irradiance of `1 / (4 pi d^2)` at distance d.
#[test]
fn point_lights_keep_their_flux() {
    let point = PointLight::new(Vec3::default()).expect("a sound position");
    let half = Cone::from_outer(Step, Angle::degrees(180.0)).expect("a sound angle");
    for candela in [1e-6_f32, 1.0, 1_000.0] {
        let lumens = point.lumens(candela);
        assert!(relative(lumens, 4.0 * std::f64::consts::PI * f64::from(candela)) < 2e-7);
        assert!(relative(lumens, f64::from(2.0 * half.lumens(candela))) < 2e-7);
        assert!(relative(point.candela(lumens), candela.into()) < 2e-7);
    }
    let energy = point.with_intensity(point.candela(1.0)).expect("a sound intensity");
    let lit = energy.compile::<f32>().expect("held");
    for distance in [0.5_f32, 1.0, 7.0] {
        let area = 4.0 * std::f64::consts::PI * f64::from(distance).powi(2);
        let found = lit.irradiance(Vec3::new(distance, 0.0, 0.0), Vec3::new(-1.0, 0.0, 0.0));
        assert_that!(relative(found, 1.0 / area) < 1e-6, distance, found);
    }
}

#[test]
fn axes_and_ranges_keep_their_figures() {
    let cone = Cone::from_outer(Step, sweep::half(20.0)).expect("sound");
    let mut rng = Rng::with_seed(3);
    let mut worst = [0.0_f64; 3];
    for _ in 0..20_000 * sweep::effort() {
        let from = sweep::position(&mut rng);
        let (way, distance) = (sweep::direction(&mut rng), sweep::distance(&mut rng));
        let to = sweep::on_grid(from + distance * way);
        let spot: SpotLight<_, SmoothRange> =
            SpotLight::between(sweep::single(from), sweep::single(to), cone).expect("sound");
        let (axis, exact) = (f32::exact_direction(spot.axis()), to - from);
        let length = axis.length();
        let errors = [
            (2.0 * oracle::versine_between(axis.normalize(), exact)).sqrt(),
            (length - 1.0).abs(),
            relative(spot.attenuation().range(), exact.length()),
        ];
        worst = std::array::from_fn(|i| worst[i].max(errors[i]));
    }
    assert_figure("direction of an axis radians", worst[0]);
    assert_figure("length of an axis", worst[1]);
    assert_figure("range of a spotlight between points", worst[2]);
}
