//! One light at one point has the same bits by every entry.

use super::format::Format;
use super::scene;
use super::words::Words;
use core::array;
use luminaire::{
    DirectionalLight, Fx16, MeasuredLight, PointLight, Vec3,
    dynamic::AnyLight,
    light::{Distribution, LightModel, SurfacePoint, Symmetry},
    specular::NoSpecular,
};

const LOBES: Distribution<'static> =
    Distribution::from_parts(&[65_535, 1, 40_000, 0, 7, 300, 9_000, 0, 60_000], 5, Symmetry::Quadrant);

/// Number of different points.
const COUNT: usize = 3;

/// Number of points that are lit together: a block of vectors, and a point by itself.
const MANY: usize = 33;

/// The light of a light of each kind, at one point, at many, without early-outs, and as one of any kind.
pub fn entries_agree<S: Format>(words: &[u32]) {
    let _: Option<()> = entries::<S>(&mut Words::new(words));
}

fn entries<S: Format>(words: &mut Words<'_>) -> Option<()> {
    let falloff = scene::falloff(words)?;
    let cone = scene::cone::<S, _>(words, falloff)?;
    let places = scene::places::<S>(words);
    let model = scene::attenuation(words)?;
    let spot = scene::spot(words, cone, places)?.with_attenuation(model);
    let point =
        PointLight::new(places[0]).ok()?.with_intensity(spot.intensity()).ok()?.with_attenuation(model);
    let sun = DirectionalLight::new(words.direction()).ok()?.with_intensity(spot.intensity()).ok()?;
    let axes = [(); 2].map(|()| words.direction());
    let measured = MeasuredLight::new(places[0], axes[0], axes[1], LOBES).ok();
    let measured = measured.and_then(|light| light.with_intensity(spot.intensity()).ok());
    let surfaces = [(); COUNT].map(|()| words.surface::<S>(places[1]));
    if let Some(light) = measured.map(|light| light.with_attenuation(model))
        && let Ok(lit) = light.compile::<S>()
    {
        agree(&lit, Some(light.into()), &surfaces);
    }
    if let Ok(light) = spot.compile::<S>() {
        agree(&light, Some(spot.into()), &surfaces);
    }
    if let Ok(light) = point.compile::<S>() {
        agree(&light, Some(point.into()), &surfaces);
    }
    agree(&sun.compile::<S>(), Some(sun.into()), &surfaces);
    Some(())
}

/// The same of the quick evaluation, which lights of any kind do not have.
pub fn quick_entries_agree(words: &[u32]) {
    let _: Option<()> = quick_entries(&mut Words::new(words));
}

fn quick_entries(words: &mut Words<'_>) -> Option<()> {
    let falloff = scene::falloff(words)?;
    let cone = scene::cone::<Fx16, _>(words, falloff)?;
    let places = scene::places::<Fx16>(words);
    let spot = scene::spot(words, cone, places)?.with_attenuation(scene::attenuation(words)?);
    let surfaces = [(); COUNT].map(|()| words.surface::<Fx16>(places[1]));
    agree(&spot.compile_quick::<Fx16>().ok()?, None, &surfaces);
    Some(())
}

fn agree<S: Format, L: LightModel<S>>(light: &L, any: Option<AnyLight>, surfaces: &[SurfacePoint<S>; COUNT]) {
    let bits = |light: S::Irradiance| S::exact_light(light).to_bits();
    let single = |surface: &SurfacePoint<S>, is_unskipped| {
        light.evaluate::<NoSpecular>(surface, &(), is_unskipped).diffuse
    };
    let surface = |i: usize| surfaces[i % COUNT];
    let points = columns(array::from_fn(|i| surface(i).point));
    let normals = columns(array::from_fn(|i| surface(i).normal));
    let any = any.and_then(|any| any.compile::<S>().ok());
    let mut together = [[S::Irradiance::default(); MANY]; 2];
    light.irradiance_each(slices(&points), slices(&normals), &mut together[0]);
    if let Some(any) = &any {
        any.irradiance_each(slices(&points), slices(&normals), &mut together[1]);
    }
    let [typed, chosen] = together;
    for (i, (typed, chosen)) in typed.into_iter().zip(chosen).enumerate() {
        let surface = surface(i);
        let one = bits(single(&surface, false));
        assert_eq!(one, bits(single(&surface, true)), "without early-outs: {light:?} at {surface:?}");
        assert_eq!(one, bits(typed), "at many points: {light:?} at {surface:?}");
        if let Some(any) = &any {
            let found = any.evaluate::<NoSpecular>(&surface, &(), false).diffuse;
            assert_eq!(one, bits(found), "of any kind: {light:?} at {surface:?}");
            assert_eq!(one, bits(chosen), "of any kind at many points: {light:?} at {surface:?}");
        }
    }
}

/// Three columns of the components of vectors.
fn columns<T: Copy>(vectors: [Vec3<T>; MANY]) -> Vec3<[T; MANY]> {
    Vec3::new(vectors.map(|v| v.x), vectors.map(|v| v.y), vectors.map(|v| v.z))
}

fn slices<T>(columns: &Vec3<[T; MANY]>) -> Vec3<&[T]> {
    Vec3::new(&columns.x, &columns.y, &columns.z)
}
