//! Lights chosen at run time: their loops are bit-identical to the single-point call, and a plan
//! has their required effects.

use fastrand::Rng;
use luminaire::{
    AmbientLight, Angle, Cone, DirectionalLight, Error, Fx16, Fx32, Length, Material, MeasuredLight,
    PointLight, Rgb, SpotLight, Vec3,
    attenuation::{
        AnyAttenuation, CutAt, Decay, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial,
        SmoothRange, Windowed,
    },
    dynamic::{AnyLight, CompiledAnyLight, Effect, Effects, RenderPlan},
    falloff::{
        AnyFalloff, Falloff, FalloffVisitor, FittedFalloff, InvertedPower, Linear, ListedFalloff, Power,
        Soft, SoftOrHard,
    },
    haze::{Haze, ViewRay, ViewRays},
    light::{Distribution, Incident, LightModel, SurfacePoint, SurfacePoints, Symmetry},
    projector::{Fixture, Gobo, Projection},
    specular::{NoSpecular, Phong, SpecularLobe},
};
use support::{
    arbitrary::vector,
    assert_in,
    falloffs::{self, AnyShape},
    format::Format,
    sweep,
};

const COUNT: usize = 32;
const LOBES: Distribution<'static> =
    Distribution::from_parts(&[65_535, 1, 40_000, 0, 7, 300, 9_000, 0, 60_000], 5, Symmetry::Quadrant);

/// Every attenuation, as a variant of `AnyAttenuation`.
fn distances() -> Result<Vec<AnyAttenuation>, Error> {
    let polynomial = Polynomial::new(0.5, 0.25, 0.125)?;
    Ok(vec![
        NoAttenuation.into(),
        InverseSquare.into(),
        polynomial.into(),
        CutAt::new(NoAttenuation, Some(6.0))?.into(),
        CutAt::new(InverseSquare, Some(6.0))?.into(),
        CutAt::new(polynomial, Some(6.0))?.into(),
        GltfRange::new(InverseSquare, Some(6.0))?.into(),
        FilamentRange::new(InverseSquare, Some(6.0))?.into(),
        Windowed::new(NoAttenuation, Some(6.0))?.into(),
        Windowed::new(polynomial, Some(6.0))?.into(),
        SmoothRange::new(6.0)?.into(),
        Decay::new(1.5, 100.0)?.into(),
        Windowed::new(Decay::new(3.0, 10.0)?, Some(6.0))?.into(),
    ])
}

/// Lights of every kind: a spotlight of each falloff, and a spotlight and a point light of each
/// attenuation. A falloff sees nothing of the attenuation. Each spotlight has a new random position
/// and axis.
fn any_lights(rng: &mut Rng) -> Result<Vec<AnyLight>, Error> {
    let mut lights: Vec<AnyLight> = vec![DirectionalLight::new(Vec3::new(0.3, -1.0, 0.2))?.into()];
    for falloff in AnyFalloff::samples() {
        let cone = Cone::from_outer(falloff, sweep::half(35.0))?;
        lights.push(sweep::spot(rng, cone).with_intensity(3.0)?.into());
    }
    for distance in distances()? {
        let cone = Cone::from_outer(Soft, sweep::half(35.0))?;
        lights.push(sweep::spot(rng, cone).with_attenuation(distance).with_intensity(3.0)?.into());
        let point = PointLight::new(Vec3::new(0.5, 1.0, -1.0))?.with_attenuation(distance);
        lights.push(point.with_intensity(2.0)?.into());
        let axes = [(); 2].map(|()| sweep::single(sweep::direction(rng)));
        let measured = MeasuredLight::new(Vec3::new(-0.5, 1.0, 2.0), axes[0], axes[1], LOBES);
        // Two directions that are one have no frame.
        if let Ok(measured) = measured {
            lights.push(measured.with_attenuation(distance).with_intensity(2.0)?.into());
        }
    }
    Ok(lights)
}

/// Points that a light reaches, points that it does not reach, and points of any bits.
fn surfaces<S: Format>(rng: &mut Rng, light: &AnyLight) -> [SurfacePoint<S>; COUNT] {
    let (position, axis) = match light {
        AnyLight::Spot(spot) => (spot.position(), spot.axis()),
        AnyLight::Point(point) => (point.position(), Vec3::new(0.0, 1.0, 0.0)),
        AnyLight::Measured(light) => (light.position(), light.frame()[2]),
        AnyLight::Directional(sun) => (Vec3::default(), sun.direction()),
    };
    let stored = S::exact_point(position.map(S::length));
    let axis = S::exact_direction(S::axis(axis)).normalize();
    std::array::from_fn(|_| {
        let distance = sweep::distance(rng);
        let site = sweep::site::<S>(rng, stored, axis, 35.0, distance);
        let mut surface =
            SurfacePoint::seen_from(Vec3::new(3.0, 1.0, 2.0).map(S::length), site.point, site.normal);
        match rng.u8(..8) {
            0 => surface.point = vector(rng, S::length_from_bits),
            1 => surface.normal = vector(rng, S::scalar_from_bits),
            2 => surface.point = position.map(S::length),
            _ => {}
        }
        surface
    })
}

fn columns<T: Copy, const N: usize>(of: impl Fn(usize) -> Vec3<T>) -> Vec3<[T; N]> {
    let column = |component: fn(Vec3<T>) -> T| std::array::from_fn(|i| component(of(i)));
    Vec3::new(column(|v| v.x), column(|v| v.y), column(|v| v.z))
}

fn borrowed<T>(columns: &Vec3<T>) -> Vec3<&T> {
    Vec3::new(&columns.x, &columns.y, &columns.z)
}

/// Returns how many points were lit, and how many have a highlight.
fn assert_each<S: Format, H: SpecularLobe>(
    light: &CompiledAnyLight<S>,
    surfaces: &[SurfacePoint<S>; COUNT],
    highlight: H::Constants<S>,
) -> [usize; 2] {
    let (point, normal) = (columns(|i| surfaces[i].point), columns(|i| surfaces[i].normal));
    let view = columns(|i| surfaces[i].view);
    let columns = SurfacePoints::<S, COUNT> {
        point: borrowed(&point),
        normal: borrowed(&normal),
        view: borrowed(&view),
    };
    let stale = S::ONE.light(S::gain(0.5));
    assert_eq!(columns.at(COUNT), SurfacePoint::matte(Vec3::default(), Vec3::default()), "beyond the last");
    let mut found = Incident { diffuse: [stale; COUNT], specular: [stale; COUNT] };
    light.evaluate_each::<H, COUNT>(&columns, &highlight, &mut found);
    let mut lit = [0; 2];
    let bits = |arrived| S::exact_light(arrived).to_bits();
    for (i, surface) in surfaces.iter().enumerate() {
        let expected = light.evaluate::<H>(surface, &highlight, false);
        let specular = if H::SHINES { expected.specular } else { stale };
        assert_eq!(bits(found.diffuse[i]), bits(expected.diffuse), "{light:?} at {surface:?}");
        assert_eq!(bits(found.specular[i]), bits(specular), "{light:?} at {surface:?}");
        assert_eq!(light.evaluate::<H>(surface, &highlight, true), expected, "{light:?} at {surface:?}");
        lit[0] += usize::from(expected.diffuse > S::Irradiance::default());
        lit[1] += usize::from(expected.specular > S::Irradiance::default());
    }
    lit
}

/// For every light, the loop for many points is bit-identical to the evaluation with branches for
/// one.
#[test]
fn any_light_lights_many_points_as_each() {
    fn assert_format<S: Format, H: SpecularLobe>(highlight: H::Constants<S>) {
        let mut rng = Rng::with_seed(17);
        let mut lit = [0; 2];
        let mut count = 0;
        for light in any_lights(&mut rng).expect("sound lights") {
            let compiled = light.compile::<S>().expect("held");
            for _ in 0..8 {
                let surfaces = surfaces::<S>(&mut rng, &light);
                let [diffuse, specular] = assert_each::<S, H>(&compiled, &surfaces, highlight);
                (lit[0], lit[1], count) = (lit[0] + diffuse, lit[1] + specular, count + COUNT);
            }
        }
        let share = lit.map(|lit| lit as f32 / count as f32);
        assert!((0.15..0.8).contains(&share[0]), "{}: {share:?} of the points are lit", S::NAME);
        let is_lit = (0.015..0.8).contains(&share[1]);
        assert_eq!(is_lit, H::SHINES, "{}: {share:?} of the points shine", S::NAME);
    }
    assert_format::<f32, NoSpecular>(());
    assert_format::<f32, Phong>(Phong::constants::<f32>(20));
    assert_format::<Fx16, Phong>(Phong::constants::<Fx16>(20));
}

/// Next to a bright light points are evaluated finely, whatever it attenuates by.
#[test]
fn points_near_a_bright_light_are_as_each() -> Result<(), Error> {
    let mut rng = Rng::with_seed(46);
    for distance in distances()? {
        let light = PointLight::new(Vec3::default())?.with_attenuation(distance).with_intensity(900.0)?;
        let light = AnyLight::from(light).compile::<Fx16>()?;
        for _ in 0..8 {
            let surfaces = std::array::from_fn(|_| {
                let point =
                    Vec3::new(rng.f32(), rng.f32(), rng.f32()).map(|c| Length::from_f32(8.0 * c - 4.0));
                let normal = Vec3::new(0.6, 0.0, 0.8).map(|c| if rng.bool() { c } else { -c });
                SurfacePoint::matte(point, normal.map(Fx16::from_f32))
            });
            assert_each::<Fx16, Phong>(&light, &surfaces, Phong::constants::<Fx16>(20));
        }
    }
    Ok(())
}

/// Number of samples per ray at which the transmittance is evaluated.
const PLACES: usize = 16;

/// The transmittance at a point.
fn stripes(point: Vec3<f32>) -> f32 {
    0.5 + 0.5 * (3.0 * point.x).sin()
}

fn through_stripes(points: &Vec3<[f32; PLACES]>, lights: &mut [f32; PLACES]) {
    for (i, light) in lights.iter_mut().enumerate() {
        *light *= stripes(Vec3::new(points.x[i], points.y[i], points.z[i]));
    }
}

/// The loop for many view rays is bit-identical to the evaluation with branches for one.
#[test]
fn beams_show_in_many_rays_as_in_each() {
    let mut rng = Rng::with_seed(23);
    let haze = Haze::new(0.05).expect("a sound density");
    let (mut seen, mut count) = (0, 0);
    for source in any_lights(&mut rng).expect("sound lights") {
        let beam = source.compile::<f32>().expect("held").in_haze(&haze);
        let AnyLight::Spot(spot) = source else {
            assert_eq!(beam, None, "only spotlights have beams");
            continue;
        };
        let beam = beam.expect("a spotlight has one");
        let eye = spot.position().zip(spot.axis(), |p, a| p + a + 12.0 * (rng.f32() - 0.5));
        let directions: [Vec3<f32>; COUNT] =
            std::array::from_fn(|_| sweep::single(sweep::direction(&mut rng)));
        let mut length = [f32::INFINITY; COUNT];
        length[..8].fill(3.0);
        let rays = ViewRays { eye, direction: columns(|i| directions[i]), length };
        let (mut lights, mut striped) = ([f32::NAN; COUNT], [f32::NAN; COUNT]);
        beam.in_scattering_each(&rays, &mut lights);
        beam.in_scattering_through_each(&rays, &mut through_stripes, &mut striped);
        for (i, light) in lights.into_iter().enumerate() {
            let ray = ViewRay { eye, direction: directions[i], length: length[i] };
            assert_eq!(rays.at(i), ray);
            assert_eq!(light.to_bits(), beam.in_scattering(&ray).to_bits(), "{beam:?} along {ray:?}");
            let through = beam.in_scattering_through(&ray, PLACES as u32, stripes);
            assert_eq!(striped[i].to_bits(), through.to_bits(), "{beam:?} along {ray:?}");
            seen += usize::from(light > 0.0);
            count += 1;
        }
    }
    let none = Vec3::default();
    let rays = ViewRays { eye: none, direction: Vec3::new([1.0], [0.0], [0.0]), length: [2.0] };
    assert_eq!(rays.at(1), ViewRay { eye: none, direction: none, length: 0.0 }, "beyond the last");
    assert!((0.08..0.5).contains(&(seen as f32 / count as f32)), "{seen} of {count} rays show a beam");
}

/// A falloff chosen at run time is the given one, in every format. A power with its exponent in the
/// type becomes a power with an exponent as a value, which may round differently.
#[test]
fn any_falloff_is_what_it_was() {
    fn assert_format<S: Format, P: Falloff + Into<AnyFalloff>>(falloff: P, most: f64) {
        let cone = Cone::from_outer(falloff, sweep::half(30.0)).expect("sound");
        let (typed, chosen) = (cone.compile::<S>(), cone.with_falloff(falloff.into()).compile::<S>());
        let (typed, chosen) = (typed.expect("held"), chosen.expect("held"));
        assert_same(cone.outer_versine(), &|versine| {
            let [typed, chosen] = [typed.at(typed.versine(versine)), chosen.at(chosen.versine(versine))];
            assert_in(&(falloff, versine), typed.exact() - chosen.exact(), -most..=most);
        });
    }
    fn assert_same(outer: f32, assert: &dyn Fn(f32)) {
        sweep::versines(outer.into(), 300).for_each(assert);
    }
    fn assert_within<P: Falloff + Into<AnyFalloff>>(falloff: P, most: f32) {
        assert_in(&falloff, falloff.beam_versine() - falloff.into().beam_versine(), -1e-7..=1e-7);
        assert_in(&falloff, falloff.field_versine() - falloff.into().field_versine(), -1e-7..=1e-7);
        assert_format::<f32, P>(falloff, most.into());
        assert_format::<Fx32, P>(falloff, most.into());
        assert_format::<Fx16, P>(falloff, most.into());
    }
    struct AssertSame;
    impl FalloffVisitor for AssertSame {
        fn falloff<P: ListedFalloff>(&mut self) {
            assert_within::<P>(falloffs::sound(P::sample()), 0.0);
        }
    }
    luminaire::falloff::falloffs(&mut AssertSame);
    assert_within(SoftOrHard::Soft, 0.0);
    assert_within(SoftOrHard::Hard, 0.0);
    assert_within(FittedFalloff::Quadratic(falloffs::quadratic()), 0.0);
    assert_within(FittedFalloff::Cubic(falloffs::cubic()), 0.0);
    assert_within(Power::<1>, 6.2e-5);
    assert_within(InvertedPower::<1>, 6.2e-5);
    assert_within(InvertedPower::<2>, 6.2e-5);
}

fn down() -> Vec3<f32> {
    Vec3::new(0.0, -1.0, 0.0)
}

fn spot(falloff: impl Falloff + Into<AnyFalloff>) -> Result<SpotLight<AnyFalloff>, Error> {
    SpotLight::new(Vec3::new(0.0, 4.0, 0.0), down(), Cone::from_outer(falloff.into(), Angle::degrees(40.0))?)
}

/// The required effects of each light, by name.
#[test]
fn a_light_calls_for_what_it_is() -> Result<(), Error> {
    let is_sample = |shape: &AnyShape| {
        !shape.name.contains(char::is_numeric) && !["soft-hotspot", "soft-cutoff"].contains(&shape.name)
    };
    let mut count = 0;
    for shape in AnyShape::all().iter().filter(|shape| is_sample(shape)) {
        let light = AnyLight::from(spot(Soft)?.with_cone(shape.at(20.0)));
        assert_eq!(light.effects().to_string(), format!("diffuse, spot, {}, inverse-square", shape.name));
        count += 1;
    }
    assert_eq!(count, AnyFalloff::COUNT);

    let names: Vec<_> = distances()?
        .into_iter()
        .map(|distance| {
            Ok(AnyLight::from(PointLight::new(down())?.with_attenuation(distance)).effects().to_string())
        })
        .collect::<Result<_, Error>>()?;
    let expected = [
        "unattenuated",
        "inverse-square",
        "polynomial",
        "unattenuated, range",
        "inverse-square, range",
        "polynomial, range",
        "inverse-square, window, range",
        "inverse-square, window, range",
        "unattenuated, window, range",
        "polynomial, window, range",
        "smooth-range, range",
        "decay",
        "decay, window, range",
    ];
    assert_eq!(names, expected.map(|distance| format!("diffuse, point, {distance}")));

    let sun = AnyLight::from(DirectionalLight::new(down())?);
    assert_eq!(sun.effects().to_string(), "diffuse, directional");
    let cone = spot(Linear)?.cone().with_inner(Angle::degrees(10.0))?.with_cutoff(Angle::degrees(30.0))?;
    let cut = Fixture::from(spot(Linear)?.with_cone(cone)).with_shadow(64)?;
    assert_eq!(cut.effects().to_string(), "diffuse, spot, linear, hotspot, cutoff, inverse-square, shadow");
    assert_eq!((cut.shadow().map(|(side, _)| side), cut.light().intensity()), (Some(64), 1.0));
    Ok(())
}

/// A light with zero intensity, or with black in both colours, requires no effect and is dropped.
/// Only `RenderPlan::everything` keeps it.
#[test]
fn a_dark_light_is_dropped() -> Result<(), Error> {
    let (black, red) = (Rgb::default(), Rgb::new(1.0, 0.0, 0.0));
    let lit = spot(Soft)?;
    let dark = [lit.with_intensity(0.0)?, lit.with_color(black)?];
    let bright = [lit, lit.with_color(black)?.with_specular_color(red)?, lit.with_specular_color(black)?];
    for (spots, is_dark) in [(&dark[..], true), (&bright[..], false)] {
        for spot in spots {
            let fixture = Fixture::from(*spot).with_shadow(16)?;
            assert_eq!(fixture.light().is_dark(), is_dark);
            assert_eq!(fixture.effects() == Effects::NONE, is_dark);
            assert_eq!(RenderPlan::new().with_fixture(&fixture).effects(), fixture.effects());
            let prepare = |plan: RenderPlan| plan.prepare::<f32>(fixture.light());
            assert_eq!(prepare(RenderPlan::new())?.is_none(), is_dark);
            assert!(prepare(RenderPlan::everything())?.is_some());
        }
    }
    let compiled =
        RenderPlan::new().prepare::<Fx16>(&lit.with_specular_color(red)?.into())?.expect("not dark");
    assert_eq!(compiled.color(), lit.color().map(Fx16::from_f32));
    assert_eq!(compiled.specular_color(), red.map(Fx16::from_f32));
    // A light that the format can't hold is refused, even if it is dark.
    let far = SpotLight::new(Vec3::new(4e4, 0.0, 0.0), down(), lit.cone())?.with_intensity(0.0)?;
    assert!(RenderPlan::new().prepare::<Fx16>(&far.into()).is_err());
    Ok(())
}

#[test]
fn a_plan_calls_for_what_it_was_given() -> Result<(), Error> {
    let (grey, black) = (Rgb::new(0.5, 0.5, 0.5), Rgb::default());
    let matte = Material::new(grey)?;
    let glazed = matte.with_highlight(Phong, grey, 20)?;
    let dull = matte.with_highlight(Phong, black, 20)?;
    let calls = |plan: RenderPlan| plan.effects().to_string();
    assert_eq!(calls(RenderPlan::new().with_material(&matte).with_material(&dull)), "");
    assert_eq!(calls(RenderPlan::new().with_material(&glazed)), "specular");
    assert_eq!(calls(RenderPlan::new().with_ambient(&AmbientLight::new(grey)?)), "ambient");
    assert_eq!(calls(RenderPlan::new().with_ambient(&AmbientLight::new(black)?)), "");
    assert_eq!(calls(RenderPlan::new().with_ambient(&AmbientLight::new(grey)?.with_intensity(0.0)?)), "");
    let plan = RenderPlan::new().with(Effect::Dither);
    assert!(plan.skips() && plan.requires(Effect::Dither) && !plan.requires(Effect::Haze));
    let everything = RenderPlan::everything();
    assert!(!everything.skips() && Effect::ALL.iter().all(|&effect| everything.requires(effect)));
    Ok(())
}

#[test]
fn effects_are_a_set() {
    let mut sets = Effects::NONE;
    for &effect in Effect::ALL {
        assert!(!sets.has(effect), "{} is there already", effect.name());
        sets = sets.with(effect);
        assert!(sets.has(effect));
    }
    assert_eq!(sets, Effects::ALL);
    assert!(Effects::ALL.iter().eq(Effect::ALL.iter().copied()));
    assert_eq!(Effects::NONE.iter().count(), 0);
    assert_eq!(format!("{:?}", Effects::NONE.with(Effect::Gobo)), "{Gobo}");
}

#[test]
fn a_shadow_map_has_a_side_that_can_be() -> Result<(), Error> {
    for side in [16, 512, 2048] {
        assert_eq!(
            Fixture::from(spot(Soft)?).with_shadow(side)?.shadow(),
            Some((side, Projection::of(&spot(Soft)?)?))
        );
    }
    for side in [0, 15, 2049, u16::MAX] {
        let refused = Fixture::from(spot(Soft)?).with_shadow(side).unwrap_err().to_string();
        let expected = format!("side of the shadow map = {side}: expected a whole number from 16 to 2048");
        assert_eq!(refused, expected);
    }
    Ok(())
}

/// Gobos and shadow maps cover the square around the cone of a spotlight, so a light without such a
/// square has none.
#[test]
fn what_projects_no_square_is_refused() -> Result<(), Error> {
    const BARS: Gobo<'static> = Gobo::of(&[255, 0, 255, 0]);
    let key = Fixture::from(spot(Soft)?).with_gobo(BARS, Angle::degrees(30.0))?;
    let square = Projection::of(&spot(Soft)?)?.turned(Angle::degrees(30.0))?;
    assert_eq!(key.gobo(), Some((BARS, square)));
    assert_eq!(key.compile_gobo::<f32>()?, Some(BARS.on(square.compile()?)));
    assert_eq!(Fixture::from(spot(Soft)?).compile_gobo::<f32>()?, None);
    let wide = spot(Soft)?.with_cone(Cone::from_outer(Soft, Angle::degrees(170.0))?);
    let odd: [(Fixture, u32); 4] = [
        (wide.into(), 170),
        (MeasuredLight::new([0.0; 3], down(), Vec3::new(1.0, 0.0, 0.0), LOBES)?.into(), 360),
        (PointLight::new(down())?.into(), 360),
        (DirectionalLight::new(down())?.into(), 0),
    ];
    for (fixture, angle) in odd {
        let expected =
            format!("outer angle = {angle}: expected more than 0 and at most 160 degrees (full angle)");
        assert_eq!(fixture.with_gobo(BARS, Angle::degrees(0.0)).unwrap_err().to_string(), expected);
        assert_eq!(fixture.with_shadow(64).unwrap_err().to_string(), expected);
    }
    Ok(())
}
