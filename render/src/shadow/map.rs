//! Shadow maps of spotlights, drawn with the rasteriser of the camera.

mod layer;
mod slope;

use crate::{
    buffer::filled,
    error::DrawError,
    raster::{
        clip::{Sighting, clip_mesh},
        view::View,
    },
    scene::{Fingerprint, Scene},
    size::SizeError,
    space::bounds::Bounds,
};
use alloc::{collections::TryReserveError, vec::Vec};
use layer::Layer;
use luminaire::{
    Error, Scalar,
    projector::{CompiledProjection, Fixture, Projection, Shadow},
};
use slope::{Slope, depth_error};

/// A shadow map of a [`Scene`] on the square that a spotlight projects.
///
/// The number format is that of the light. The depths are those of the surfaces nearest to the
/// light, front or back: an open sheet, such as a curtain, lets no light through. Surfaces within 5
/// centimetres of the light, along its axis, cast no shadow; otherwise the fixture's own housing
/// would cast one.
///
/// **Self-shadowing.** The depth of a texel is compared with the depths of points up to one texel
/// away, where the same surface has another depth. Two steps prevent false shadows. Each triangle is
/// drawn with the largest depth of its plane within one texel, and then each texel gets the largest
/// depth of the 3 x 3 texels around it that belong to the same surface. Points without an occluder
/// are fully lit: on a flat surface at any angle of incidence, on a convex body if the point is more
/// than one texel inside the body's outline as seen from the light. Closer to the outline, a face
/// can be in the shadow of its neighbour.
///
/// These steps cause two errors. The edge of a shadow is wrong by up to two texels. The shadow of a
/// sheet begins up to `b / (1 - b / h)` behind the sheet, measured at right angles to the sheet,
/// where `b = 3 w (|nx| + |ny|)`. The width of a texel `w` is `2 tan(outer half angle) / side` times
/// the depth of the sheet, `nx` and `ny` are the components of the sheet's unit normal along the
/// sides of the map, and `h` is the distance of the light from the plane of the sheet. So `b` is at
/// most `3 sqrt(2) w`: 6 centimetres in a map of 512 texels per side, at 6 metres from a light with
/// a cone of 60 degrees. A sheet with `b >= h`, nearly edge-on, may cast no shadow. Behind a closed
/// solid a shadow begins without a gap if the solid is thicker than that distance.
///
/// ```
/// use luminaire::{Vec3, projector::Projection};
/// use luminaire_render::{ShadowMap, scenes::stage};
/// let key = stage::lights()?[0];
/// let mut map = ShadowMap::<f32>::new(512)?;
/// assert!(map.draw(&stage::scene()?, &Projection::of(&key)?)?);
/// let shadow = map.shadow().expect("drawn");
/// // Behind the sphere that stands in the key light, and on its top.
/// assert_eq!(shadow.visibility(Vec3::new(0.0, 0.001, -0.4)), 0.0);
/// assert_eq!(shadow.visibility(Vec3::new(-0.52, 1.12, 0.3)), 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct ShadowMap<S: Scalar> {
    side: usize,
    /// Scratch memory to draw the map; `None` until it is drawn.
    layer: Option<Layer>,
    depths: Vec<S::Length>,
    drawn: Option<Drawn<S>>,
    /// Bounding sphere of each object of the scene that was drawn last.
    bounds: Vec<Bounds>,
    bounded: Option<Fingerprint>,
    sightings: Vec<Sighting>,
}

/// The scene and the projection that the depths were drawn for.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Drawn<S: Scalar> {
    scene: Fingerprint,
    projection: Projection,
    compiled: CompiledProjection<S>,
}

impl<S: Scalar> Drawn<S> {
    fn new(scene: &Scene, projection: &Projection) -> Result<Self, Error> {
        Ok(Self { scene: scene.fingerprint(), projection: *projection, compiled: projection.compile::<S>()? })
    }
}

impl<S: Scalar> ShadowMap<S> {
    /// Allocates a map of `side` x `side` texels; 512 are enough for a stage.
    ///
    /// # Errors
    /// A side outside 16 to 2048, or a map that does not fit into memory.
    pub fn new(side: usize) -> Result<Self, SizeError> {
        if !u16::try_from(side).is_ok_and(|side| Fixture::SHADOW_SIDES.contains(&side)) {
            return Err(SizeError::ShadowSide(side));
        }
        Self::with_memory(side).map_err(|_| SizeError::Memory(side, side))
    }

    fn with_memory(side: usize) -> Result<Self, TryReserveError> {
        Ok(Self {
            side,
            layer: None,
            depths: filled(side * side, S::Length::default())?,
            drawn: None,
            bounds: Vec::new(),
            bounded: None,
            sightings: Vec::new(),
        })
    }

    /// Draws a scene as seen from a light. Returns whether the scene or the projection had changed;
    /// if not, the call is a no-op.
    ///
    /// # Errors
    /// A projection that the format can't hold, or no memory to draw; the map stays as it was.
    pub fn draw(&mut self, scene: &Scene, projection: &Projection) -> Result<bool, DrawError> {
        let drawn = Drawn::new(scene, projection)?;
        if self.drawn == Some(drawn) {
            return Ok(false);
        }
        let layer = match &mut self.layer {
            Some(layer) => layer,
            none => none.insert(Layer::new(self.side).map_err(|_| SizeError::Memory(self.side, self.side))?),
        };
        if self.bounded.replace(drawn.scene) != Some(drawn.scene) {
            let positions = scene.objects().iter().map(|object| object.mesh.vertices());
            self.bounds.clear();
            self.bounds.extend(positions.map(|mesh| Bounds::of(mesh.iter().map(|vertex| vertex.position))));
        }
        let view = View::of_light(projection, self.side);
        let tangent = projection.tangent();
        let slope = Slope::new::<S>(tangent, self.side);
        layer.clear();
        for (object, bounds) in scene.objects().iter().zip(&self.bounds) {
            if view.misses(bounds) {
                continue;
            }
            // A closed mesh has a front face in front of every back face, unless the light is
            // inside the mesh.
            let is_solid = object.mesh.is_closed() && view.is_before(bounds);
            clip_mesh(&view, &object.mesh, &mut self.sightings, |corners, visible| {
                let corners = corners.map(Sighting::seen);
                if !(is_solid && slope.is_turned_away(corners)) {
                    layer.draw(visible, || slope.within_texel(corners));
                }
            });
        }
        let texel = 2.0 * tangent / self.side as f32;
        layer.resolve::<S>(texel, 1.0 + depth_error::<S>(tangent), &mut self.depths);
        self.drawn = Some(drawn);
        Ok(true)
    }

    /// Takes the depths of a map that was drawn for a scene and a projection in this format.
    ///
    /// # Errors
    /// A projection that the format can't hold; the map stays as it was.
    pub(crate) fn take(
        &mut self,
        scene: &Scene,
        projection: &Projection,
        depths: impl Iterator<Item = S::Length>,
    ) -> Result<(), Error> {
        self.drawn = Some(Drawn::new(scene, projection)?);
        self.depths.iter_mut().zip(depths).for_each(|(old, new)| *old = new);
        Ok(())
    }

    /// Returns the depths, row by row.
    pub(crate) fn depths(&self) -> &[S::Length] {
        &self.depths
    }

    /// Returns the map for shadow tests; `None` before the map has been drawn.
    pub fn shadow(&self) -> Option<Shadow<'_, S>> {
        let projection = self.drawn?.compiled;
        Some(Shadow::from_parts(projection, self.side as u32, &self.depths))
    }

    /// Returns the number of texels on a side.
    pub fn side(&self) -> usize {
        self.side
    }
}

#[cfg(test)]
mod tests;
