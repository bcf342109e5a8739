//! The surfaces that rays meet: what a visitor points at, and where a beam ends.

use crate::{
    scene::{Object, Scene},
    space::bounds::Bounds,
};
use alloc::vec::Vec;
use glam::Vec3;

/// The triangles of a scene, prepared for rays.
///
/// ```
/// use luminaire::Vec3;
/// use luminaire_render::{Surfaces, scenes::Example};
/// let setup = Example::ThreePoint.setup()?;
/// let surfaces = Surfaces::of(&setup.scene);
/// // From above onto the boards.
/// let distance = surfaces.first(Vec3::new(0.0, 3.0, 2.5), Vec3::new(0.0, -1.0, 0.0));
/// assert!(distance.is_some_and(|metres| (metres - 3.0).abs() < 1e-5));
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Debug)]
pub struct Surfaces<'a> {
    objects: Vec<(Bounds, &'a Object)>,
}

impl<'a> Surfaces<'a> {
    /// Finds the bounding sphere of each object.
    pub fn of(scene: &'a Scene) -> Self {
        let bounds = |object: &'a Object| {
            (Bounds::of(object.mesh.vertices().iter().map(|vertex| vertex.position)), object)
        };
        Self { objects: scene.objects().iter().map(bounds).collect() }
    }

    /// Returns how often `direction` must be added to `origin` to get to the nearest surface whose
    /// front faces the origin: the distance if `direction` has unit length. `None` if there is no
    /// such surface. Back faces let a ray pass, as in the picture.
    pub fn first(&self, origin: luminaire::Vec3<f32>, direction: luminaire::Vec3<f32>) -> Option<f32> {
        let (origin, direction) = (Vec3::from(origin), Vec3::from(direction));
        let passes = |bounds: &Bounds| {
            let across = (bounds.center - origin).cross(direction).length_squared();
            across > 1.001 * bounds.radius * bounds.radius * direction.length_squared()
        };
        let near = self.objects.iter().filter(|(bounds, _)| !passes(bounds));
        let met = near.flat_map(|(_, object)| {
            let corners = object.mesh.vertices();
            let triangle = |triangle: &[u32; 3]| triangle.map(|corner| corners[corner as usize].position);
            object
                .mesh
                .triangles()
                .iter()
                .filter_map(move |corners| meeting(origin, direction, triangle(corners)))
        });
        met.reduce(f32::min)
    }
}

/// Returns where a ray meets the front of a triangle (Moeller and Trumbore 1997).
fn meeting(origin: Vec3, direction: Vec3, [a, b, c]: [Vec3; 3]) -> Option<f32> {
    let (to_b, to_c) = (b - a, c - a);
    let across = direction.cross(to_c);
    let facing = to_b.dot(across);
    if facing <= 0.0 {
        return None;
    }
    let way = origin - a;
    let along_b = way.dot(across);
    let turned = way.cross(to_b);
    let along_c = direction.dot(turned);
    let distance = to_c.dot(turned);
    let is_inside = along_b >= 0.0 && along_c >= 0.0 && along_b + along_c <= facing;
    (is_inside && distance > 0.0).then(|| distance / facing)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Material, mesh::Mesh};

    /// A cube of 2 metres on the floor, and a floor of 20 metres.
    fn scene() -> Scene {
        let mut scene = Scene::new();
        scene.add(Mesh::cuboid(2.0, 2.0, 2.0), Material::default()).unwrap();
        let floor = Mesh::cuboid(20.0, 1.0, 20.0).moved(luminaire::Vec3::new(0.0, -1.0, 0.0));
        scene.add(floor, Material::default()).unwrap();
        scene
    }

    fn first(origin: [f32; 3], direction: [f32; 3]) -> Option<f32> {
        Surfaces::of(&scene()).first(origin.into(), direction.into())
    }

    #[test]
    fn the_nearest_front_is_met() {
        assert_eq!(first([0.2, 5.0, 0.3], [0.0, -1.0, 0.0]), Some(3.0));
        assert_eq!(first([0.2, 5.0, 0.3], [0.0, -0.5, 0.0]), Some(6.0));
        assert_eq!(first([4.0, 5.0, 0.3], [0.0, -1.0, 0.0]), Some(5.0));
        assert_eq!(first([5.0, 1.0, 0.3], [-1.0, 0.0, 0.0]), Some(4.0));
    }

    #[test]
    fn backs_and_what_lies_behind_are_not_met() {
        assert_eq!(first([0.2, 5.0, 0.3], [0.0, 1.0, 0.0]), None);
        assert_eq!(first([5.0, 1.0, 0.3], [1.0, 0.0, 0.0]), None);
        // From within the cube its walls are backs, and so is the underside of the floor.
        assert_eq!(first([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]), None);
        assert_eq!(first([0.2, 5.0, 0.3], [0.0, 0.0, 0.0]), None);
        assert_eq!(first([f32::NAN, 5.0, 0.3], [0.0, -1.0, 0.0]), None);
    }
}
