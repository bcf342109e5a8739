//! The renderer. A renderer repeats only the passes whose input has changed.

pub(crate) mod account;
pub(crate) mod display;
pub(crate) mod edges;
pub(crate) mod format;
mod gbuffer;
mod light;
mod reached;
mod tile;

use crate::{
    buffer::{LANES, Radiance, filled},
    error::DrawError,
    light::{Finish, Workspace, air::Scattered},
    raster::{
        Fragments,
        clip::{Sighting, clip_mesh},
        silhouette::Silhouettes,
        view::View,
    },
    renderer::{
        account::Account,
        display::{CHANNELS, Display, Encoder},
        edges::Edges,
        format::Format,
        gbuffer::GBuffer,
        reached::Reached,
        tile::Tiles,
    },
    scene::{Fingerprint, Material, Scene, camera::Camera, strip::Strip},
    shadow::Shadows,
    size::SizeError,
    stripes::Stripes,
};
use alloc::{collections::TryReserveError, vec::Vec};
use luminaire::{Error, Rgb, Vec3, dynamic::RenderPlan, haze::Haze, projector::Fixture};

/// A deferred renderer with a geometry pass, a lighting pass and an encoding pass.
///
/// The lighting pass is in the number format `S`. Each pass is repeated only where its input has
/// changed. A renderer draws a whole picture or a share of it, so that several renderers can share
/// the work: see [`of_stripes`](Self::of_stripes).
#[derive(Clone, Debug)]
pub struct Renderer<S: Format> {
    width: usize,
    height: usize,
    stripes: Stripes,
    fragments: Fragments,
    geometry: GBuffer<S>,
    tiles: Tiles,
    /// The materials by number; number 0 is the background.
    finishes: Vec<Finish<S>>,
    eye: Vec3<S::Length>,
    view: Option<View>,
    haze: Option<Haze>,
    ambient: Rgb<f32>,
    radiance: Vec<Radiance<S>>,
    /// The index of the first LED's material and the strip, and the duties that the LEDs show.
    strip: Option<(usize, Strip)>,
    leds: Vec<Rgb<u8>>,
    /// Number of lights that were evaluated at the pixels of each block.
    evaluated: Vec<u16>,
    encoder: Encoder,
    pixels: Vec<u8>,
    drawn: Option<(Fingerprint, Camera)>,
    /// Number of triangles drawn by the last call of `draw_geometry`.
    triangles: usize,
    /// The lights of the current picture; `None` if the whole picture must be lit.
    lit: Option<Vec<Fixture>>,
    /// Three tables of bits. `near`: which fixtures reach which regions. `reached`: which fixtures
    /// reach the surfaces of which tiles. `seen`: which beams are visible in the air in front of
    /// which tiles.
    near: Reached,
    reached: Reached,
    seen: Reached,
    shadows: Shadows<S>,
    account: Account,
    clock: Option<fn() -> f64>,
    workspace: Workspace<S>,
    /// Scratch memory: the light from the air in front of a tile.
    scattered: Scattered,
    sightings: Vec<Sighting>,
    /// The edges of the view and of the picture; `None` without anti-aliasing.
    silhouettes: Option<Silhouettes>,
    edges: Edges,
}

impl<S: Format> Renderer<S> {
    /// Creates a renderer of pictures of this width and height in pixels. The picture is black
    /// until something is drawn.
    ///
    /// # Errors
    /// A width or height outside 1 to [`LARGEST`](crate::LARGEST), or a picture that does not fit
    /// into memory.
    pub fn new(width: usize, height: usize) -> Result<Self, SizeError> {
        Self::of_stripes(width, height, Stripes::ALL)
    }

    /// Creates a renderer that draws only some stripes of pictures of this width and height in
    /// pixels. It has no memory for the other rows, and spends on them only the projection of the
    /// vertices.
    ///
    /// Coordinates and displays are those of the whole picture. [`encode`](Self::encode) returns
    /// only the rows of the [`Stripes`], and the [`Account`] counts only their pixels.
    ///
    /// # Errors
    /// A width or height outside 1 to [`LARGEST`](crate::LARGEST), or a picture that does not fit
    /// into memory.
    pub fn of_stripes(width: usize, height: usize, stripes: Stripes) -> Result<Self, SizeError> {
        SizeError::check(width, height)?;
        Self::with_memory(width, height, stripes).map_err(|_| SizeError::Memory(width, height))
    }

    fn with_memory(width: usize, height: usize, stripes: Stripes) -> Result<Self, TryReserveError> {
        let rows = stripes.height(height);
        let geometry = GBuffer::new(width, rows)?;
        let dark = Rgb::default().map(|()| [S::Irradiance::default(); LANES]);
        let mut renderer = Self {
            width,
            height,
            stripes,
            fragments: Fragments::new(width, height, stripes)?,
            tiles: Tiles::new(width.div_ceil(LANES), rows)?,
            radiance: filled(geometry.blocks.len(), dark)?,
            evaluated: filled(geometry.blocks.len(), 0)?,
            geometry,
            finishes: [Finish::new(Material::default())].into(),
            eye: Vec3::default(),
            view: None,
            strip: None,
            leds: Vec::new(),
            haze: None,
            ambient: Rgb::default(),
            encoder: Encoder::new(Display::default()),
            pixels: filled(width * rows * CHANNELS, 0)?,
            drawn: None,
            triangles: 0,
            lit: None,
            near: Reached::default(),
            reached: Reached::default(),
            seen: Reached::default(),
            shadows: Shadows::new(),
            account: Account::default(),
            clock: None,
            workspace: Workspace::default(),
            scattered: Scattered::none(),
            sightings: Vec::new(),
            silhouettes: None,
            edges: Edges::new(),
        };
        renderer.encode();
        Ok(renderer)
    }

    /// Draws the geometry of a scene into the G-buffer. Returns whether the scene or the camera had
    /// changed; if not, the call is a no-op. If only materials, ambient light or haze had changed,
    /// no triangle is drawn.
    pub fn draw_geometry(&mut self, scene: &Scene, camera: &Camera) -> bool {
        let materials = || scene.objects().iter().map(|object| object.material);
        let is_repainted = !self.finishes[1..].iter().map(Finish::material).copied().eq(materials());
        if is_repainted {
            self.finishes.truncate(1);
            self.finishes.extend(materials().map(Finish::new));
        }
        let before = (self.ambient, self.haze);
        (self.ambient, self.haze) = (scene.ambient(), scene.haze());
        let is_strung = self.strip.as_ref() != scene.led_objects();
        if is_strung {
            self.strip = scene.led_objects().cloned();
        }
        let is_changed = is_repainted || is_strung || before != (self.ambient, self.haze);
        let drawn = Some((scene.fingerprint(), *camera));
        let is_moved = self.drawn != drawn;
        self.triangles = if is_moved { scene.triangle_count() } else { 0 };
        if is_moved {
            self.drawn = drawn;
            self.draw_triangles(scene, &View::new(camera, self.width, self.height, self.stripes));
        }
        if is_changed || is_moved {
            self.lit = None;
        }
        is_changed || is_moved
    }

    fn draw_triangles(&mut self, scene: &Scene, view: &View) {
        self.fragments.clear();
        if let Some(silhouettes) = &mut self.silhouettes {
            silhouettes.begin(scene);
        }
        for (number, object) in (1..).zip(scene.objects()) {
            clip_mesh(view, &object.mesh, &mut self.sightings, |_, visible| {
                self.fragments.draw(visible, number)
            });
            if let Some(silhouettes) = &mut self.silhouettes {
                silhouettes.project(view, number, &self.sightings);
            }
        }
        self.edges.restore(&mut self.pixels);
        if let Some(silhouettes) = &mut self.silhouettes {
            silhouettes.trace(&self.fragments);
            // A neighbour of a pixel may be in another share.
            if self.stripes == Stripes::ALL {
                self.edges.take(silhouettes.marks().iter().map(|mark| mark.0));
            }
        }
        self.geometry.resolve(&self.fragments, view);
        self.tiles.enclose(&self.geometry.bounds);
        self.eye = Vec3::from(view.eye()).map(S::length);
        self.view = Some(*view);
        self.tiles.tiles.iter_mut().for_each(|tile| tile.sight = None);
    }

    /// Draws the shadow maps of all fixtures whose scene or fixture has changed. Returns whether
    /// any map was drawn. If this function is not called, nothing casts shadows. Pass the same
    /// slice of fixtures as to [`draw_light`](Self::draw_light).
    ///
    /// # Errors
    /// A fixture that the format can't hold, or no memory for a map.
    pub fn draw_shadows<L: Copy + Into<Fixture>>(
        &mut self,
        scene: &Scene,
        lights: &[L],
    ) -> Result<bool, DrawError> {
        Ok(!self.shadows.draw(scene, lights, Stripes::ALL)?.is_empty())
    }

    /// Draws only the shadow maps that are dealt to the renderer's share of the picture: the lit
    /// fixtures with shadows take turns. Returns the indices of the fixtures whose map was drawn.
    ///
    /// Before [`draw_light`](Self::draw_light), pass the [`shadow_map`](Self::shadow_map) of each
    /// of these fixtures to [`take_shadow_map`](Self::take_shadow_map) of the renderers of the
    /// other shares. So each map is drawn once for all renderers.
    ///
    /// # Errors
    /// A fixture that the format can't hold, or no memory for a map.
    pub fn draw_own_shadows<L: Copy + Into<Fixture>>(
        &mut self,
        scene: &Scene,
        lights: &[L],
    ) -> Result<Vec<usize>, DrawError> {
        self.shadows.draw(scene, lights, self.stripes)
    }

    /// Returns the shadow map of the fixture with this index: the bits of each depth, row by row.
    /// Returns `None` if the fixture has no map.
    pub fn shadow_map(&self, number: usize) -> Option<impl ExactSizeIterator<Item = u32> + '_> {
        self.shadows.depths(number).map(|depths| depths.iter().map(|&depth| S::depth_to_bits(depth)))
    }

    /// Takes the shadow map of the fixture with this index from a renderer that has drawn it for
    /// the same scene and lights, in the same format.
    ///
    /// # Errors
    /// A fixture that the format can't hold; no memory for the map; or a number of depths that is
    /// not that of the fixture's map, which is 0 for a fixture without shadows.
    pub fn take_shadow_map<L: Copy + Into<Fixture>>(
        &mut self,
        scene: &Scene,
        lights: &[L],
        number: usize,
        depths: &[u32],
    ) -> Result<(), DrawError> {
        let fixture = lights.get(number).map(|&light| light.into());
        let depths = depths.iter().map(|&bits| S::depth_from_bits(bits));
        self.shadows.take(scene, fixture.as_ref(), number, depths)
    }

    /// Lights the tiles that a change affects, and returns whether anything had changed.
    ///
    /// Changed geometry, materials, ambient light or haze affect all tiles. A changed light affects
    /// the tiles that it reaches now or reached before the change. If nothing had changed, the call
    /// is a no-op.
    ///
    /// # Errors
    /// A light that the format can't hold, or in haze one that `f32` can't hold; the picture stays
    /// as it was.
    pub fn draw_light<L: Copy + Into<Fixture>>(&mut self, lights: &[L]) -> Result<bool, Error> {
        self.draw_light_by(RenderPlan::new(), lights)
    }

    /// Lights the whole picture with every effect of every light at every pixel, without skipping.
    ///
    /// The function is meant for tests and comparisons: the picture is bit-identical to that of
    /// [`draw_light`](Self::draw_light).
    ///
    /// # Errors
    /// A light that the format can't hold, or in haze one that `f32` can't hold; the picture stays
    /// as it was.
    pub fn draw_everything<L: Copy + Into<Fixture>>(&mut self, lights: &[L]) -> Result<(), Error> {
        self.lit = None;
        self.draw_light_by(RenderPlan::everything(), lights)?;
        Ok(())
    }

    /// Changes the display format. The next [`encode`](Self::encode) encodes the whole picture
    /// again.
    pub fn set_display(&mut self, display: Display) {
        if self.encoder.display != display {
            self.encoder = Encoder::new(display);
            self.tiles.tiles.iter_mut().for_each(|tile| tile.is_encoded = false);
        }
    }

    /// Gives the renderer a clock, or none, which is the default. With a clock, each lighting pass
    /// measures what each tile [costs](Self::cost), and the next [`draw_light`](Self::draw_light)
    /// after a call that gives the first clock lights the whole picture.
    pub fn set_clock(&mut self, clock: Option<fn() -> f64>) {
        if self.clock.is_none() && clock.is_some() {
            self.lit = None;
        }
        self.clock = clock;
    }

    /// Switches anti-aliasing on or off; it is off at first. The next
    /// [`draw_geometry`](Self::draw_geometry) draws the scene again and finds its visible edges,
    /// and each [`encode`](Self::encode) mixes the codes of the pixels beside them, as [`Edges`]
    /// describes. A renderer of a share of the picture only finds the edges, because mixing needs
    /// the pixels of the other shares.
    pub fn set_antialiased(&mut self, antialiased: bool) {
        if self.silhouettes.is_some() != antialiased {
            self.silhouettes = antialiased.then(Silhouettes::default);
            self.edges.restore(&mut self.pixels);
            self.edges = Edges::new();
            self.drawn = None;
        }
    }

    /// Returns the marks of the pixels beside visible edges, for [`Edges::take`]; none without
    /// anti-aliasing.
    pub fn edge_marks(&self) -> impl ExactSizeIterator<Item = u64> {
        self.silhouettes.as_ref().map_or(&[][..], Silhouettes::marks).iter().map(|mark| mark.0)
    }

    /// Encodes the light for the display, but only where the light has changed. Returns the drawn
    /// rows from top to bottom; each pixel is red, green and blue in sRGB, and alpha 255.
    pub fn encode(&mut self) -> &[u8] {
        self.edges.restore(&mut self.pixels);
        let columns = self.geometry.columns;
        for tile in 0..self.tiles.tiles.len() {
            if core::mem::replace(&mut self.tiles.tiles[tile].is_encoded, true) {
                continue;
            }
            for block in self.tiles.blocks(tile) {
                let (row, first) = (block / columns, block % columns * LANES);
                let last = (first + LANES).min(self.width);
                let pixels = (row * self.width + first) * CHANNELS..(row * self.width + last) * CHANNELS;
                let place = (first as u32, self.stripes.row(row) as u32);
                S::encode(&self.encoder, &self.radiance[block], place, &mut self.pixels[pixels]);
            }
        }
        self.edges.mix_by(&self.encoder, self.width, &mut self.pixels);
        &self.pixels
    }

    /// Returns the last encoded picture: four bytes per pixel, rows from top to bottom.
    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    /// Returns the rows that are drawn.
    pub fn stripes(&self) -> Stripes {
        self.stripes
    }

    /// Returns the width and the height of the whole picture in pixels.
    pub fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    /// Returns the counts of the last geometry pass and the last lighting pass.
    pub fn account(&self) -> Account {
        Account { triangles: self.triangles, ..self.account }
    }

    /// Returns the number of lights evaluated when a pixel was last lit; `None` outside the drawn
    /// rows.
    pub fn lights_evaluated(&self, x: usize, y: usize) -> Option<u16> {
        self.block(x, y).map(|block| self.evaluated[block])
    }

    /// Returns whether the last lighting pass re-lit a pixel; `None` outside the drawn rows.
    pub fn is_relit(&self, x: usize, y: usize) -> Option<bool> {
        self.block(x, y).map(|block| self.tiles.tiles[self.tiles.of_block(block)].is_relit)
    }

    /// Returns what the last lighting pass took for a pixel, in the unit of the clock: the time of
    /// the pixel's tile, divided by the pixels of the tile. The sum over all pixels is the time of
    /// the pass. Returns 0 without a [clock](Self::set_clock), and `None` outside the drawn rows.
    pub fn cost(&self, x: usize, y: usize) -> Option<f64> {
        let tile = self.tiles.of_block(self.block(x, y)?);
        let (rows, column) = self.tiles.place(tile);
        let pixels = rows.len() * LANES.min(self.width - column * LANES);
        Some(self.tiles.tiles[tile].time / pixels as f64)
    }

    /// Returns the linear light from a pixel to the eye, 1 being full scale; `None` outside the
    /// drawn rows.
    pub fn linear(&self, x: usize, y: usize) -> Option<Rgb<f32>> {
        self.block(x, y).map(|block| self.radiance[block].map(|channel| S::light_to_f32(channel[x % LANES])))
    }

    /// Returns the surface point, the unit normal and the material at a pixel, as used for
    /// lighting. Returns `None` outside the drawn rows, and where nothing was drawn.
    pub fn surface(&self, x: usize, y: usize) -> Option<(Vec3<S::Length>, Vec3<S>, Material)> {
        let block = &self.geometry.blocks[self.block(x, y)?];
        let lane = x % LANES;
        let number = block.material[lane] as usize;
        let point = block.point_at(lane);
        let normal = block.normal_at(lane);
        (number > 0).then(|| (point, normal, *self.finishes[number].material()))
    }

    /// Returns the index of the block that contains a pixel.
    fn block(&self, x: usize, y: usize) -> Option<usize> {
        let is_inside = x < self.width && y < self.height;
        let row = self.stripes.number(y).filter(|_| is_inside)?;
        Some(row * self.geometry.columns + x / LANES)
    }
}

#[cfg(test)]
mod tests;
