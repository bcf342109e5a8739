//! Lights and points to compare. The tests in a browser use this file, too.

use fastrand::Rng;
use luminaire::attenuation::{AnyAttenuation, Attenuation};
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Falloff, Formula, Table};
use luminaire::number::Knot;
use luminaire::{Angle, Cone, DirectionalLight, Error, PointLight, Rgb, Scalar, SpotLight, Vec3};
use luminaire_oracle::{DVec3, versine_between};

/// A spotlight of any models.
pub(crate) type Spot = SpotLight<AnyFalloff, AnyAttenuation>;

/// Returns a random direction, not of unit length.
pub(crate) fn direction(rng: &mut Rng) -> [f32; 3] {
    loop {
        let v = [0; 3].map(|_| rng.f32() * 2.0 - 1.0);
        let squared = v.iter().map(|c| c * c).sum::<f32>();
        if (0.05..=1.0).contains(&squared) {
            return v;
        }
    }
}

/// Returns a table of knots: a measured light.
pub(crate) fn knots() -> AnyFalloff {
    let measured: Vec<f32> = (0..=30).map(|i| (i as f32 / 10.0).cos() / 2.0 + 0.5).collect();
    let knots: &'static mut [Knot] = Vec::leak(vec![Knot::default(); 12]);
    Table::from_angles(&measured, Angle::degrees(50.0), knots).expect("a sound table").0.into()
}

/// Returns `variants` lights of each falloff, the first with its sample, and as many with knots.
///
/// The lights go through all attenuations. Half of them have usual numbers, the others any that the constructors take,
/// the ends among them. Each is accepted by the format `S`.
pub(crate) fn spots<S: Scalar>(rng: &mut Rng, variants: usize) -> Vec<Spot> {
    let mut spots = Vec::new();
    for index in 0..=AnyFalloff::COUNT {
        for variant in 0..variants {
            let light = (0..100_000).find_map(|_| {
                let falloff = match (index, variant) {
                    (AnyFalloff::COUNT, _) => knots(),
                    (_, 0) => AnyFalloff::samples().nth(index)?,
                    _ => AnyFalloff::anywhere(index, || rng.f32()).ok()?,
                };
                let spot = spot::<S>(rng, falloff, index + variant).ok()?;
                spot.compile::<S>().is_ok().then_some(spot)
            });
            spots.push(light.expect("a light that the format holds"));
        }
    }
    spots
}

fn spot<S: Scalar>(rng: &mut Rng, falloff: AnyFalloff, index: usize) -> Result<Spot, Error> {
    let outer = match rng.u8(..8) {
        0 => 180.0,
        1 => Cone::narrowest::<S>(falloff).to_degrees() * 1.000_01,
        _ => 180.0 * rng.f32() * rng.f32(),
    };
    let mut cone = Cone::from_outer(falloff, Angle::degrees(outer))?;
    if rng.u8(..3) == 0 {
        cone = cone.with_inner(Angle::degrees(outer * part(rng)))?;
    }
    if rng.u8(..4) == 0 {
        cone = cone.with_cutoff(Angle::degrees(outer * part(rng)))?;
    }
    let attenuation = AnyAttenuation::anywhere(index, || rng.f32())?;
    let color = Rgb::new(rng.f32(), rng.f32(), rng.f32());
    let light = SpotLight::new(position::<S>(rng), direction(rng), cone)?.with_color(color)?;
    Ok(light.with_intensity(intensity(rng))?.with_attenuation(attenuation))
}

/// Returns the part of an outer angle that an inner angle or a cutoff is.
fn part(rng: &mut Rng) -> f32 {
    match rng.u8(..8) {
        0 => rng.choice([0.0, 1.0]).unwrap_or_default(),
        1 => 1.0 - 1e-6_f32.powf(rng.f32()),
        _ => 0.3 + 0.7 * rng.f32(),
    }
}

/// Returns a position within 10 of the origin, or at any coordinates that the format takes.
pub(crate) fn position<S: Scalar>(rng: &mut Rng) -> [f32; 3] {
    // In `f32` little is lit at the farthest coordinates, because points are farther apart there.
    let (is_near, farthest) = (rng.bool(), S::FARTHEST.min(1e6));
    let reach = if is_near { 10.0 } else { farthest * 1e-4_f32.powf(rng.f32()) };
    let end = if rng.u8(..4) == 0 { S::FARTHEST } else { farthest };
    [0; 3].map(|_| match rng.u8(..4) {
        0 if !is_near => rng.choice([-end, end]).unwrap_or_default(),
        _ => reach * (2.0 * rng.f32() - 1.0),
    })
}

/// Returns an intensity from 0 to the largest that lights take.
pub(crate) fn intensity(rng: &mut Rng) -> f32 {
    match rng.u8(..8) {
        0 => rng.choice([0.0, f32::from_bits(1), 1e9, 1e9]).unwrap_or_default(),
        1 => 10.0_f32.powf(18.0 * rng.f32() - 9.0),
        2 => 1e9 * rng.f32(),
        3 => 1e4 * rng.f32(),
        4 => 16.0,
        5 => 1.0,
        _ => 100.0 * rng.f32(),
    }
}

/// Returns point lights of each attenuation, as many at usual places as at any.
pub(crate) fn points_of_light<S: Scalar>(rng: &mut Rng) -> Vec<PointLight<AnyAttenuation>> {
    let light = |index| {
        let attenuation = AnyAttenuation::anywhere(index, || rng.f32()).ok()?;
        let light = PointLight::new(position::<S>(rng)).ok()?;
        light.with_intensity(intensity(rng)).ok().map(|light| light.with_attenuation(attenuation))
    };
    (0..4 * AnyAttenuation::COUNT).filter_map(light).collect()
}

/// Returns directional lights of any intensity.
pub(crate) fn suns(rng: &mut Rng, count: usize) -> Vec<DirectionalLight> {
    let sun = |_| {
        let color = Rgb::new(rng.f32(), rng.f32(), rng.f32());
        DirectionalLight::new(direction(rng))
            .ok()?
            .with_color(color)
            .ok()?
            .with_intensity(intensity(rng))
            .ok()
    };
    (0..count).filter_map(sun).collect()
}

/// Returns a point that a light is likely to reach, and a normal.
///
/// A third of the points is close to the edge of the cone.
pub(crate) fn place(rng: &mut Rng, light: &AnyLight) -> ([f32; 3], [f32; 3]) {
    let (position, axis, half) = match light {
        AnyLight::Spot(spot) => (spot.position(), spot.axis(), spot.cone().outer().to_radians() / 2.0),
        AnyLight::Point(point) => (point.position(), direction(rng).into(), std::f32::consts::PI),
        AnyLight::Measured(light) => (light.position(), light.frame()[2], std::f32::consts::PI),
        AnyLight::Directional(light) => (Vec3::default(), light.direction(), 1.0),
    };
    let angle = match rng.u8(..6) {
        0 => half * (1.0 + 1e-3 * (rng.f32() - 0.5)),
        1 => half * (0.9 + 0.2 * rng.f32()),
        2 => 0.0,
        _ => half * rng.f32(),
    };
    let aside = Vec3::from(direction(rng));
    let along = axis.dot(aside);
    let aside = aside.zip(axis, |a, s| a - along * s).unit();
    let ray = axis.zip(aside, |s, a| s * angle.cos() + a * angle.sin());
    let reach = position.x.abs().max(position.y.abs()).max(position.z.abs());
    let distance = match rng.u8(..6) {
        // As far as the coordinates are large: in `f32` a shorter way there is rounded to few bits or none.
        0 => reach.min(1e18) * rng.f32(),
        1 | 2 => 0.4 * rng.f32() * rng.f32(),
        _ => 40.0 * rng.f32() * rng.f32(),
    };
    let point = position.zip(ray, |p, r| p + distance * r);
    let tilt = Vec3::from(direction(rng));
    let normal = tilt.zip(ray, |t, r| 0.7 * t - r).unit();
    (point.into(), normal.into())
}

/// Returns the versine of a point off the axis in f64.
pub(crate) fn versine(spot: &Spot, point: [f32; 3]) -> f64 {
    versine_between(wide(point) - wide(spot.position().into()), wide(spot.axis().into()))
}

fn wide(vector: [f32; 3]) -> DVec3 {
    DVec3::from_array(vector.map(f64::from))
}

/// Returns the irradiance of a spotlight in f64, and its falloff.
pub(crate) fn exact(spot: &Spot, point: [f32; 3], normal: [f32; 3]) -> [f64; 2] {
    let offset = wide(point) - wide(spot.position().into());
    let [inner, outer, limit] = spot.cone().versines().map(f64::from);
    let versine = versine(spot, point);
    let t = if versine <= inner { 1.0 } else { (outer - versine) / (outer - inner) };
    let falloff = if versine < limit { spot.cone().falloff().formula().exact(t) } else { 0.0 };
    let cosine = (-offset.normalize().dot(wide(normal))).clamp(0.0, 1.0);
    [f64::from(spot.intensity()) * spot.attenuation().exact(offset.length()) * falloff * cosine, falloff]
}

/// Returns whether the falloff has no jump and a moderate slope, so that its difference from f64 is
/// that of the code and not of the inputs. An exponent below 1 makes the slope infinite.
pub(crate) fn is_smooth(spot: &Spot) -> bool {
    let cone = spot.cone();
    let slope = cone.falloff().steepness(cone.inner().versine() / cone.outer_versine());
    let jumps = match cone.falloff().formula() {
        Formula::Step | Formula::Samples(_) | Formula::Knots(_) => true,
        Formula::Power(exponent) | Formula::InvertedPower(exponent, _) => exponent < 1.0,
        _ => false,
    };
    !jumps && !cone.has_cutoff() && cone.outer().to_degrees() > 6.0 && slope < 10.0
}
