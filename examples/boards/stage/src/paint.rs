//! The stages from a visible point to its pixel: light and display.

use core::ops::Range;

use luminaire::number::Light16;
use luminaire::{Fx16, display::Rgb565Ramp, falloff::Soft, light::QuickSpotLight};

use super::backdrop::{Backdrop, OBJECTS, Seen, TILES};
use super::site::{Material, Site};

/// The kind of the light: a soft spotlight in 16 bits, by the quick evaluation.
pub(super) type Key = QuickSpotLight<Fx16, Soft>;

/// The light, compiled by the build script.
pub(super) const KEY: Key = include!(concat!(env!("OUT_DIR"), "/key.rs"));
/// The pixels of each material by the light's irradiance, with the ambient light that it reflects.
pub(super) static RAMPS: [Rgb565Ramp; 5] = include!(concat!(env!("OUT_DIR"), "/ramps.rs"));

/// The pixels of surfaces that receive ambient light only: for each material, a cell of the dither.
#[derive(Debug)]
pub(super) struct Ambient([[[u16; 8]; 8]; 5]);

impl Ambient {
    pub(super) fn new() -> Self {
        let mut pixels = [[[0; 8]; 8]; 5];
        for (cell, ramp) in pixels.iter_mut().zip(&RAMPS) {
            for (y, row) in (0..).zip(cell) {
                for (x, pixel) in (0..).zip(row) {
                    *pixel = ramp.pixel::<Fx16>(Light16::ZERO, x, y).0;
                }
            }
        }
        Self(pixels)
    }

    /// The cells of a material in a row.
    #[inline(always)]
    fn row(&self, material: Material, row: i32) -> &[u16; 8] {
        &self.0[material as usize][row.cast_unsigned() as usize % 8]
    }
}

/// Sets the irradiance from the spotlight, before its colour, where the backdrop may be lit and where pixels of
/// objects are marked.
#[inline(never)]
pub(super) fn light(key: &Key, seen: &mut Seen, sites: &[Site], lights: &mut [Light16]) {
    let points = seen.backdrop.points();
    seen.reach = points.reach(key, lights.len());
    for gap in seen.gaps(lights.len()) {
        for lit in seen.lit(&gap) {
            points.fill(key, lit.start, lights.get_mut(lit).unwrap_or_default());
        }
    }
    for object in &seen.objects {
        let sites = sites.get(object.clone()).unwrap_or_default();
        objects(key, sites, lights.get_mut(object.clone()).unwrap_or_default());
    }
}

/// The irradiance at the sites that are marked, before the colour.
#[inline(never)]
pub(super) fn objects(key: &Key, sites: &[Site], lights: &mut [Light16]) {
    for (site, light) in sites.iter().zip(lights) {
        if *light != Light16::ZERO {
            *light = key.irradiance(site.point, site.normal);
        }
    }
}

/// Paints all pixels of a row: those that the spotlight reaches by its light, the others by ambient light.
#[inline(never)]
pub(super) fn display<const WIDTH: usize>(
    (seen, lights): (&Seen, &[Light16; WIDTH]),
    (row, ambient): (i32, &Ambient),
    pixels: &mut [u16; WIDTH],
) {
    let backdrop = &seen.backdrop;
    let mut paint = |materials, columns: Range<usize>, is_lit: bool| {
        let span = Span { backdrop, materials, first: columns.start, row };
        let lights = if is_lit { lights.get(columns.clone()) } else { None };
        let pixels = pixels.get_mut(columns).unwrap_or_default();
        if materials == TILES {
            span.paint::<true>(ambient, lights, pixels)
        } else {
            span.paint::<false>(ambient, lights, pixels)
        }
    };
    let materials = backdrop.materials();
    for gap in seen.gaps(WIDTH) {
        let mut start = gap.start;
        for lit in seen.lit(&gap).into_iter().filter(|lit| !lit.is_empty()) {
            paint(materials, start..lit.start, false);
            start = lit.end;
            paint(materials, lit, true);
        }
        paint(materials, start..gap.end, false);
    }
    for (object, material) in seen.objects.iter().zip(OBJECTS) {
        paint([material; 2], object.clone(), true);
    }
}

/// Neighbouring pixels of a row that show the same object.
struct Span<'a> {
    backdrop: &'a Backdrop,
    /// Those of the tiles, or one of them twice.
    materials: [Material; 2],
    first: usize,
    row: i32,
}

impl Span<'_> {
    /// Paints the pixels. Without `lights` they have ambient light only.
    #[inline(never)]
    fn paint<const IS_TILED: bool>(&self, ambient: &Ambient, lights: Option<&[Light16]>, pixels: &mut [u16]) {
        let &Self { backdrop, materials, first, row } = self;
        let tile = |column| if IS_TILED { backdrop.tile(column) } else { 0 };
        if let Some(lights) = lights {
            let ramps = materials.map(|material| &RAMPS[material as usize]);
            for (i, (pixel, &light)) in pixels.iter_mut().zip(lights).enumerate() {
                let column = first + i;
                *pixel = ramps[tile(column)].pixel::<Fx16>(light, column as u32, row as u32).0;
            }
        } else {
            let cells = materials.map(|material| ambient.row(material, row));
            for (i, pixel) in pixels.iter_mut().enumerate() {
                let column = first + i;
                *pixel = cells[tile(column)][column % 8];
            }
        }
    }
}
