//! What holds for every beam in haze and every view ray.

use fastrand::Rng;
use luminaire::codegen::FloatRamp;
use luminaire::{
    Angle, Cone, SpotLight, Vec3,
    attenuation::{Attenuation, FilamentRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange},
    falloff::Soft,
    haze::{BeamScattering, Haze, RayBundle, ViewRay},
    light::CompiledCone,
};
use support::{
    arbitrary::bits,
    bounds,
    in_scattering::Beam,
    oracle, sweep,
    views::{exact, near_beam, place, view},
};

const HALF_ANGLES: [f32; 5] = [0.5, 5.0, 22.0, 60.0, 90.0];

fn haze(density: f32) -> Haze {
    Haze::new(density).expect("a sound density")
}

fn spot(rng: &mut Rng) -> SpotLight<Soft> {
    let half = HALF_ANGLES[rng.usize(..HALF_ANGLES.len())];
    sweep::spot(rng, Cone::from_outer(Soft, sweep::half(half)).expect("a sound cone"))
}

fn in_haze<A: Attenuation>(spot: &SpotLight<Soft, A>, density: f32) -> BeamScattering<Soft, A> {
    spot.compile::<f32>().expect("held").in_haze(&haze(density))
}

/// What a spotlight stands for.
fn oracle(spot: &SpotLight<Soft>) -> Beam {
    let cone = oracle::Cone::new(oracle::soft, spot.cone().outer_versine().into());
    Beam {
        spot: oracle::SpotLight::new(exact(spot.position()), exact(spot.axis()), cone),
        range: f64::INFINITY,
        density: 1.0,
        source_radius: haze(1.0).source_radius().into(),
    }
}

/// Tests a law on many lights and rays, the same in every run, and counts the lit ones, because a
/// law tested only in the dark would prove nothing.
fn on_many(mut law: impl FnMut(&mut Rng, &SpotLight<Soft>, &ViewRay) -> bool) {
    let mut rng = Rng::with_seed(1910);
    let mut lit = 0;
    for _ in 0..40_000 {
        let spot = spot(&mut rng);
        let view = view(&mut rng, &oracle(&spot));
        lit += usize::from(law(&mut rng, &spot, &view));
    }
    assert!(lit > 10_000, "only {lit} rays are lit");
}

#[test]
fn clear_air_gives_exactly_no_light() {
    on_many(|_, spot, view| {
        assert_eq!(in_haze(spot, 0.0).in_scattering(view), 0.0);
        assert_eq!(in_haze(spot, 0.0).in_scattering_through(view, 8, |_| 1.0), 0.0);
        let beam = in_haze(spot, 1.0);
        assert_eq!(beam.in_scattering_through(view, 0, |_| 1.0), 0.0, "without samples");
        assert_eq!(beam.in_scattering_through(view, 16, |_| 0.0), 0.0, "behind something opaque");
        beam.in_scattering(view) > 0.0
    });
}

#[test]
fn twice_the_density_is_exactly_twice_the_light() {
    on_many(|_, spot, view| {
        let light = in_haze(spot, 0.125).in_scattering(view);
        assert_eq!(in_haze(spot, 0.25).in_scattering(view), 2.0 * light);
        light > 0.0
    });
}

/// Both sides of a beam contain the eye and the light, and touch the cone: the sine of their angle
/// to the axis is that of the outer angle.
#[test]
fn sides_touch_the_beam() {
    on_many(|_, spot, view| {
        let beam = in_haze(spot, 1.0);
        let sides = beam.sides(view.eye);
        if sides == [Vec3::default(); 2] {
            return false;
        }
        let (versine, light) = (f64::from(beam.outer_versine()), exact(spot.position()) - exact(view.eye));
        for normal in sides.map(exact) {
            let off = [
                normal.length() - 1.0,
                normal.dot(light.normalize()),
                normal.dot(exact(spot.axis())) - (versine * (2.0 - versine)).sqrt(),
            ];
            assert!(off.iter().all(|off| off.abs() < 1e-5), "{off:?} for {spot:?} from {:?}", view.eye);
        }
        assert!(sides[0] != sides[1]);
        true
    });
}

fn assert_within(name: &str, measured: f64) {
    bounds::assert_figure("haze law", name, measured);
}

#[test]
fn a_ray_between_two_points_has_their_direction_and_distance() {
    let mut rng = Rng::with_seed(7);
    let mut worst = [0.0_f64; 2];
    for _ in 0..100_000 {
        let [eye, surface] = [(); 2].map(|()| Vec3::new((), (), ()).map(|()| 16.0 * rng.f32() - 8.0));
        let found = ViewRay::between(eye, surface);
        let way = exact(surface) - exact(eye);
        let distance = way.length();
        let off = exact(found.direction) - way.normalize();
        worst[0] = worst[0].max(off.length());
        worst[1] = worst[1].max((f64::from(found.length) / distance - 1.0).abs());
        assert_eq!(ViewRay::endless(eye, found.direction).length, f32::INFINITY);
    }
    assert_within("direction", worst[0]);
    assert_within("distance", worst[1]);
    let nowhere = ViewRay::between(Vec3::new(1.0, 2.0, 3.0), Vec3::new(1.0, 2.0, 3.0));
    assert_eq!((nowhere.direction, nowhere.length), (Vec3::new(0.0, 0.0, 0.0), 0.0));
}

/// A beam of any bits, evaluated for rays of any bits.
fn assert_total<A: Attenuation>(rng: &mut Rng, constants: impl Fn(&mut Rng) -> A::Constants<f32>) {
    let any = |rng: &mut Rng| f32::from_bits(bits(rng) as u32);
    let tame = rng.bool();
    let number = move |rng: &mut Rng| if tame && rng.u8(..8) > 0 { 4.0 * rng.f32() - 2.0 } else { any(rng) };
    let place = |rng: &mut Rng| Vec3::new((), (), ()).map(|()| number(rng));
    let ramp = FloatRamp::from_bits([(); 4].map(|()| number(rng).to_bits()));
    let falloff = CompiledCone::from_parts(ramp, Soft, Soft);
    let (position, axis, gain) = (place(rng), place(rng), number(rng));
    let (cone, reach) = ([number(rng), number(rng)], [number(rng), number(rng)]);
    let constants = constants(rng);
    let beam = BeamScattering::<Soft, A>::from_parts(position, axis, falloff, constants, gain, cone, reach);
    let view = ViewRay { eye: place(rng), direction: place(rng), length: number(rng) };
    let through = number(rng);
    for light in [beam.in_scattering(&view), beam.in_scattering_through(&view, 3, |_| through)] {
        assert!((0.0..=f32::MAX).contains(&light), "{light} from {view:?} of {beam:?}");
    }
    let bundle =
        RayBundle { eye: view.eye, direction: view.direction, versine: number(rng), length: view.length };
    beam.can_meet(&bundle);
}

#[test]
fn any_bits_have_an_air_light() {
    let mut rng = Rng::with_seed(0xa1e);
    let any = |rng: &mut Rng| f32::from_bits(bits(rng) as u32);
    for _ in 0..20_000 * sweep::effort() {
        assert_total::<InverseSquare>(&mut rng, |_| ());
        assert_total::<NoAttenuation>(&mut rng, |_| ());
        assert_total::<Polynomial>(&mut rng, |rng| [(); 3].map(|()| any(rng)));
        assert_total::<SmoothRange>(&mut rng, |rng| [(); 2].map(|()| any(rng)));
        assert_total::<FilamentRange>(&mut rng, |rng| (any(rng), ()));
    }
}

/// A bundle of rays at a beam, and a ray of it.
fn bundle(rng: &mut Rng, oracle: &Beam) -> (RayBundle, Vec<ViewRay>) {
    let target = near_beam(rng, &oracle.spot, 3.0);
    let eye = sweep::single(place(target, sweep::direction(rng), 0.3 * 30.0_f64.powf(rng.f64())));
    let middle = (target - exact(eye)).normalize();
    let spread = 0.5 * 0.002_f64.powf(rng.f64());
    let length = if rng.bool() { f32::INFINITY } else { 0.2 * 100.0_f32.powf(rng.f32()) };
    let rays: Vec<_> = (0..24)
        .map(|i| {
            let angle = if i < 8 { spread } else { spread * rng.f64().sqrt() };
            let direction = sweep::single(sweep::direction_off(rng, middle, angle));
            ViewRay { eye, direction, length: if i < 8 { length } else { length * rng.f32() } }
        })
        .collect();
    let corners: Vec<_> = rays.iter().map(|ray| ray.direction).collect();
    (RayBundle::around(eye, sweep::single(middle), &corners, length), rays)
}

/// No light is lost: if one ray of a bundle has light, `can_meet` returns true. Of the bundles that
/// are dark most are rejected.
fn assert_meets<A: Attenuation>(attenuation: A, least_rejected: f64) {
    let mut rng = Rng::with_seed(12);
    let (mut dark, mut rejected, mut lit) = (0, 0, 0);
    for _ in 0..10_000 * sweep::effort() {
        let spot = spot(&mut rng);
        let beam = in_haze(&spot.with_attenuation(attenuation), 1.0);
        let (bundle, rays) = bundle(&mut rng, &oracle(&spot));
        let can_meet = beam.can_meet(&bundle);
        let is_lit = rays.iter().any(|ray| beam.in_scattering(ray) > 0.0);
        assert!(can_meet || !is_lit, "{beam:?} lights a ray of {bundle:?}");
        dark += u32::from(!is_lit);
        rejected += u32::from(!can_meet);
        lit += u32::from(is_lit);
    }
    let share = f64::from(rejected) / f64::from(dark);
    println!("{lit} bundles are lit, {:.1} % of {dark} dark ones rejected", 100.0 * share);
    assert!(
        (least_rejected..least_rejected + 0.1).contains(&share),
        "{rejected} of {dark} dark bundles are rejected"
    );
}

#[test]
fn no_bundle_with_a_lit_ray_is_rejected() {
    assert_meets(InverseSquare, 0.72);
    assert_meets(FilamentRange::new(InverseSquare, Some(3.0)).expect("a sound range"), 0.65);
}

/// How tight the test is: rays that lead away from the light a degree outside of the beam are
/// rejected, however wide it is, and a degree inside of it they are not.
#[test]
fn rays_just_outside_the_beam_are_rejected() {
    for half in [5.0_f32, 20.0, 45.0, 60.0, 75.0] {
        let cone = Cone::from_outer(Soft, Angle::degrees(2.0 * half)).expect("sound");
        let beam = in_haze(&SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone).expect("sound"), 0.1);
        for (beside, meets) in [(1.0, false), (-1.0, true)] {
            let (sine, cosine) = (half + beside).to_radians().sin_cos();
            let direction = Vec3::new(sine, -cosine, 0.0);
            let eye = direction.map(|c| 2.0 * c);
            let bundle = RayBundle { eye, direction, versine: 0.0, length: 10.0 };
            assert_eq!(beam.can_meet(&bundle), meets, "{half} {beside}");
        }
    }
}
