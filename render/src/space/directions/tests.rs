//! Bounding spheres of directions enclose their directions, and in no format does a highlight
//! extend beyond its lobe by more than the added distance.

use super::*;
use crate::{Format, Highlight, Material, light::Finish};
use alloc::vec::Vec;
use luminaire::{
    Fx16, Fx32, PointLight, Rgb,
    attenuation::NoAttenuation,
    light::{LightModel, SurfacePoint},
};

/// Random numbers by Knuth's linear congruential generator.
struct Random(u64);

impl Random {
    /// Returns a number in [-1, 1].
    fn share(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f32 / (1 << 23) as f32 - 1.0
    }

    fn vector(&mut self) -> Vec3 {
        Vec3::new(self.share(), self.share(), self.share())
    }

    fn direction(&mut self) -> Vec3 {
        loop {
            let vector = self.vector();
            if (0.01..1.0).contains(&vector.length_squared()) {
                return vector.normalize();
            }
        }
    }
}

/// Returns the distance of a direction from the centre of its sphere, relative to the radius.
fn part(sphere: &Directions, direction: Vec3) -> f32 {
    sphere.center.distance(direction) / (sphere.radius + 1e-6)
}

#[test]
fn spheres_hold_what_they_enclose() {
    let mut random = Random(1);
    let (mut towards, mut mirrored, mut along) = (0.0_f32, 0.0_f32, f32::INFINITY);
    for _ in 0..20_000 {
        let (center, place) = (8.0 * random.vector(), 8.0 * random.vector());
        let radius = 0.5 * center.distance(place) * random.share().abs();
        let reach = |around: Vec3| [center - radius * around, center + radius * around];
        let corners: Vec<_> = [Vec3::X, Vec3::Y, Vec3::Z].into_iter().flat_map(reach).collect();
        let Some(to_place) = Directions::towards(place, &Bounds::of(corners.into_iter())) else { continue };
        let direction = (place - (center + radius * random.direction())).normalize();
        towards = towards.max(part(&to_place, direction));

        let spread = 0.3 * random.share().abs();
        let (facing, normal) = (random.direction(), random.direction());
        let normal = (facing + spread * normal).normalize();
        let normals = Directions::between(facing.min(normal), facing.max(normal));
        let image = 2.0 * direction.dot(normal) * normal - direction;
        mirrored = mirrored.max(part(&to_place.mirrored(&normals), image));
        let way = random.vector();
        along = along.min((normals.most_along(way) - normal.dot(way)) / way.length());
    }
    // For a narrow sphere the chord is about the sine; the radius covers the widest sphere.
    assert!((0.7..1.0).contains(&towards), "{towards}");
    assert!((0.7..1.0).contains(&mirrored), "{mirrored}");
    assert!((-1e-6..1e-3).contains(&along), "{along}");
}

/// Returns by how much the light of a highlight extends beyond its lobe, as a chord; negative if it
/// ends inside. Searched over random positions near the end of a lobe.
fn excess<S: Format>() -> f32 {
    let mut random = Random(2);
    let mut worst = -f32::INFINITY;
    for _ in 0..400_000 {
        let shininess = 8 + (1_000.0 * random.share().powi(4)) as u32;
        let finish = Finish::<S>::new(
            Material::new(Rgb::default())
                .unwrap()
                .with_highlight(Rgb::new(1.0, 1.0, 1.0), shininess)
                .unwrap(),
        );
        let (point, normal) = (8.0 * random.vector(), random.direction());
        let to_eye = (normal + random.vector()).normalize();
        let image = 2.0 * to_eye.dot(normal) * normal - to_eye;
        let aside = image.cross(random.direction()).normalize();
        // The chord is approximately the width of the lobe.
        let chord = finish.lobe * (1.0 + 0.5 * random.share().powi(3));
        let along = 1.0 - 0.5 * chord * chord;
        let to_light = along * image + (1.0 - along * along).max(0.0).sqrt() * aside;
        let [eye, light] = [to_eye, to_light].map(|way| point + (2.0 + 6.0 * random.share().abs()) * way);
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
    // Near the end of a lobe the remaining eighth power is less than a step of these formats.
    assert!((-6e-3..0.0).contains(&fx32) && (-0.025..0.0).contains(&fx16), "{fx32}, {fx16}");
    assert!(float < 1e-3 * MARGIN);
}
