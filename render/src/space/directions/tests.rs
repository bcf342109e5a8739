//! Test of the margin: no highlight may extend beyond its lobe by more than [`MARGIN`] in any format.

use super::*;
use crate::{Format, Highlight, Material, light::Finish};
use fastrand::Rng;
use luminaire::{
    Fx16, Fx32, PointLight, Rgb,
    attenuation::NoAttenuation,
    light::{LightModel, SurfacePoint},
};

/// Returns a number in [-1, 1).
fn share(rng: &mut Rng) -> f32 {
    2.0 * rng.f32() - 1.0
}

fn vector(rng: &mut Rng) -> Vec3 {
    Vec3::new(share(rng), share(rng), share(rng))
}

fn direction(rng: &mut Rng) -> Vec3 {
    loop {
        let vector = vector(rng);
        if (0.01..1.0).contains(&vector.length_squared()) {
            return vector.normalize();
        }
    }
}

/// Returns the largest chord by which the light of a highlight extends beyond its lobe.
///
/// The result is negative if the light ends inside the lobe. The maximum is searched over random
/// positions near the end of a lobe.
fn excess<S: Format>() -> f32 {
    let mut rng = Rng::with_seed(2);
    let mut worst = -f32::INFINITY;
    for _ in 0..400_000 {
        let shininess = 8 + (1_000.0 * share(&mut rng).powi(4)) as u32;
        let finish = Finish::<S>::new(
            Material::new(Rgb::default())
                .unwrap()
                .with_highlight(Rgb::new(1.0, 1.0, 1.0), shininess)
                .unwrap(),
        );
        let (point, normal) = (8.0 * vector(&mut rng), direction(&mut rng));
        let to_eye = (normal + vector(&mut rng)).normalize();
        let image = 2.0 * to_eye.dot(normal) * normal - to_eye;
        let aside = image.cross(direction(&mut rng)).normalize();
        // The chord is approximately the width of the lobe.
        let chord = finish.lobe * (1.0 + 0.5 * share(&mut rng).powi(3));
        let along = 1.0 - 0.5 * chord * chord;
        let to_light = along * image + (1.0 - along * along).max(0.0).sqrt() * aside;
        let [eye, light] = [to_eye, to_light].map(|way| point + (2.0 + 6.0 * share(&mut rng).abs()) * way);
        let light = PointLight::new(light).unwrap().with_attenuation(NoAttenuation).compile::<S>().unwrap();
        let [eye, point] = [eye, point].map(|place| luminaire::Vec3::from(place).map(S::length));
        let normal = luminaire::Vec3::from(normal).map(S::from_f32);
        let surface = SurfacePoint::<S>::seen_from(eye, point, normal);
        let surface = SurfacePoint { view: S::mirror(surface.view, normal), ..surface };
        let shines = light.evaluate::<Highlight>(&surface, &finish.highlight, false).specular
            > S::Irradiance::default();
        worst = if shines { worst.max(chord - finish.lobe) } else { worst };
    }
    worst
}

#[test]
fn no_highlight_is_beyond_the_margin_in_any_format() {
    let [float, fx32, fx16] = [excess::<f32>(), excess::<Fx32>(), excess::<Fx16>()];
    assert!((0.0..1e-6).contains(&float), "{float}");
    // Near the end of a lobe, the eighth power of the lobe is less than a step of these formats, so
    // the light ends inside the lobe.
    assert!((-6e-3..0.0).contains(&fx32) && (-0.025..0.0).contains(&fx16), "{fx32}, {fx16}");
    assert!(float < 1e-3 * MARGIN);
}
