//! The renderer: what has changed, and so what must be done again.

use crate::{
    camera::Camera,
    clip::{Sighting, clip},
    display::{self, CHANNELS},
    format::Format,
    gbuffer::{GBuffer, LANES},
    lighting::{self, Light, Radiance},
    memory::filled,
    raster::Fragments,
    scene::{Fingerprint, Material, Scene},
    size::SizeError,
    view::View,
};
use alloc::{collections::TryReserveError, vec::Vec};
use luminaire::{Error, Rgb, Spot, Vec3};

/// A deferred renderer: geometry once into a buffer, then light over that buffer in the number format `S`,
/// then the codes of a display. Each step is done again only if something before it has changed.
#[derive(Clone, Debug)]
pub struct Renderer<S: Format> {
    width: usize,
    height: usize,
    fragments: Fragments,
    geometry: GBuffer<S>,
    /// The materials by number; number 0 is the background.
    materials: Vec<Material>,
    ambient: Rgb<f32>,
    radiance: Vec<Radiance>,
    pixels: Vec<u8>,
    drawn: Option<(Fingerprint, Camera)>,
    lit: Option<Vec<Spot>>,
    is_encoded: bool,
    sightings: Vec<Sighting>,
}

impl<S: Format> Renderer<S> {
    /// A renderer of pictures of this width and height in pixels. The picture is black until something is
    /// drawn.
    ///
    /// # Errors
    /// A width or height that is not from 1 to [`LARGEST`](crate::LARGEST), or for which there is no memory.
    pub fn new(width: usize, height: usize) -> Result<Self, SizeError> {
        SizeError::check(width, height)?;
        Self::with_memory(width, height).map_err(|_| SizeError::Memory(width, height))
    }

    fn with_memory(width: usize, height: usize) -> Result<Self, TryReserveError> {
        let geometry = GBuffer::new(width, height)?;
        let dark = Rgb::default().map(|()| [0.0; LANES]);
        let mut renderer = Self {
            width,
            height,
            fragments: Fragments::new(width, height)?,
            radiance: filled(geometry.blocks.len(), dark)?,
            geometry,
            materials: Vec::new(),
            ambient: Rgb::default(),
            pixels: filled(width * height * CHANNELS, 0)?,
            drawn: None,
            lit: None,
            is_encoded: false,
            sightings: Vec::new(),
        };
        renderer.encode();
        Ok(renderer)
    }

    /// Draws the geometry of a scene into the buffer. Returns whether anything of scene or camera had
    /// changed: if not, nothing was done.
    pub fn draw_geometry(&mut self, scene: &Scene, camera: &Camera) -> bool {
        let is_relit = self.ambient != scene.ambient();
        if is_relit {
            self.ambient = scene.ambient();
            self.lit = None;
        }
        let drawn = Some((scene.fingerprint(), *camera));
        if self.drawn == drawn {
            return is_relit;
        }
        self.drawn = drawn;
        self.lit = None;
        self.materials.clear();
        self.materials.push(Material::default());
        self.materials.extend(scene.objects().iter().map(|object| object.material));
        let view = View::new(camera, self.width, self.height);
        self.fragments.clear();
        for (number, object) in (1..).zip(scene.objects()) {
            self.sightings.clear();
            self.sightings.extend(object.mesh.vertices().iter().map(|vertex| Sighting::new(&view, vertex)));
            for triangle in object.mesh.triangles() {
                let corners = triangle.map(|corner| &self.sightings[corner as usize]);
                clip(&view, corners, |visible| self.fragments.draw(visible, number));
            }
        }
        self.geometry.resolve(&self.fragments, &view);
        true
    }

    /// Lights the geometry. Returns whether lights or geometry had changed: if not, nothing was done.
    ///
    /// # Errors
    /// A light that the format can't hold; the picture stays as it was.
    pub fn draw_light(&mut self, lights: &[Spot]) -> Result<bool, Error> {
        if self.lit.as_deref() == Some(lights) {
            return Ok(false);
        }
        let compiled = lights.iter().map(Light::new).collect::<Result<Vec<_>, _>>()?;
        for (radiance, block) in self.radiance.iter_mut().zip(&self.geometry.blocks) {
            *radiance = lighting::light(block, &compiled, self.ambient, &self.materials);
        }
        self.lit = Some(lights.into());
        self.is_encoded = false;
        Ok(true)
    }

    /// Encodes the light for a display, if it has changed: rows from top to bottom, each pixel red, green,
    /// blue in sRGB and alpha 255.
    pub fn encode(&mut self) -> &[u8] {
        if !self.is_encoded {
            let columns = self.width.div_ceil(LANES);
            let rows = self.pixels.chunks_exact_mut(self.width * CHANNELS);
            for (row, blocks) in rows.zip(self.radiance.chunks_exact(columns)) {
                for (pixels, radiance) in row.chunks_mut(LANES * CHANNELS).zip(blocks) {
                    display::encode(radiance, pixels);
                }
            }
            self.is_encoded = true;
        }
        &self.pixels
    }

    /// The picture as it was last encoded: four bytes to a pixel, rows from top to bottom.
    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    /// Width and height in pixels.
    pub fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    /// The linear light that a pixel sends to the eye, 1 being full scale; none outside the picture.
    pub fn linear(&self, x: usize, y: usize) -> Option<Rgb<f32>> {
        let inside = x < self.width && y < self.height;
        inside.then(|| {
            let block = &self.radiance[y * self.width.div_ceil(LANES) + x / LANES];
            Rgb::new(block.red[x % LANES], block.green[x % LANES], block.blue[x % LANES])
        })
    }

    /// The surface that a pixel shows, as the lights see it: a point of it, its unit normal there and its
    /// material; none outside the picture, and none where nothing was drawn.
    pub fn surface(&self, x: usize, y: usize) -> Option<(Vec3<S::Length>, Vec3<S>, Material)> {
        if x >= self.width || y >= self.height {
            return None;
        }
        let block = &self.geometry.blocks[y * self.width.div_ceil(LANES) + x / LANES];
        let lane = x % LANES;
        let number = block.material[lane] as usize;
        let point = Vec3::new(block.point.x[lane], block.point.y[lane], block.point.z[lane]);
        let normal = Vec3::new(block.normal.x[lane], block.normal.y[lane], block.normal.z[lane]);
        (number > 0).then(|| (point, normal, self.materials[number]))
    }
}

#[cfg(test)]
mod tests;
