//! Lit sprites.

use super::{BLOCK, row};
use crate::{
    display::{Pixel, Ramp},
    error::{Error, Expected, Parameter},
    number::Scalar,
    shade::LightModel,
};

/// The normal of a transparent pixel.
const NONE: [i8; 3] = [0; 3];

/// A sprite: a picture of normals, lit by any number of lights of one colour.
///
/// A normal has three signed bytes of length 127, within their rounding:
/// [`normal_from_unit_bytes`](crate::Scalar::normal_from_unit_bytes) converts it. x points to the
/// right, **y down** and z to the viewer. The maps of image editors have bytes from 0 to 255 and a
/// green that points up or down: [`normals_from_opengl`](super::normals_from_opengl) and
/// [`normals_from_directx`](super::normals_from_directx) convert them. A zero normal is transparent:
/// its pixel keeps its value. A material is a [`Ramp`], which knows the colour of the lights.
///
/// ```
/// use luminaire::{Fx16, Length, PointLight, Rgb, display::{Ramp, Rgb565}, draw::{Sprite, normals_from_opengl}};
/// // A ridge, as an editor stores it: its left half faces left. The black corner has no pixel.
/// const MAP: [[u8; 3]; 4] = [[0; 3], [38, 128, 218], [218, 128, 218], [218, 128, 218]];
/// const RIDGE: [[i8; 3]; 4] = normals_from_opengl(&MAP);
/// let normals = RIDGE.repeat(2);
/// let brass: Ramp<Rgb565> = Ramp::new(Rgb::new(0.0, 0.0, 0.0), Rgb::new(0.8, 0.6, 0.2))?;
/// let ramps = [brass];
/// let sprite = Sprite::new(4, &normals, &ramps, Length::from_bits(1 << (16 - 5)))?.at(100, 60);
/// let light = PointLight::new([1.0, 2.0, 2.0])?.with_intensity(8.0)?.compile::<Fx16>()?;
/// let mut row = [Rgb565(0xffff); 160];
/// sprite.row(&[light], 61, 0, &mut row);
/// assert!(row[100] == Rgb565(0xffff) && row[101].to_codes().red > row[102].to_codes().red);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sprite<'a, P, S: Scalar> {
    width: usize,
    normals: &'a [[i8; 3]],
    materials: &'a [u8],
    ramps: &'a [Ramp<P>],
    corner: [i32; 2],
    pixel: S::Length,
}

impl<'a, P: Pixel, S: Scalar> Sprite<'a, P, S> {
    /// Creates a sprite at `(0, 0)` from its width in pixels, its normals row by row, its materials and
    /// the length of a pixel. All pixels have the first material.
    ///
    /// # Errors
    /// A width of 0; normals that are no whole rows of the width; no ramp.
    pub fn new(
        width: usize,
        normals: &'a [[i8; 3]],
        ramps: &'a [Ramp<P>],
        pixel: S::Length,
    ) -> Result<Self, Error> {
        let counts = [(Parameter::Width, width), (Parameter::RampCount, ramps.len())];
        for (parameter, count) in counts {
            if count == 0 {
                return Err(Error { parameter, value: 0.0, accepted: Expected::WholeBetween(1, u32::MAX) });
            }
        }
        if normals.len().checked_rem(width) != Some(0) {
            let accepted = Expected::RowsOf(width.try_into().unwrap_or(u32::MAX));
            return Err(Error { parameter: Parameter::NormalCount, value: normals.len() as f32, accepted });
        }
        Ok(Self { width, normals, materials: &[], ramps, corner: [0, 0], pixel })
    }

    /// Returns the sprite with an index of a ramp for each pixel. An index past the last ramp shows the
    /// last ramp.
    ///
    /// # Errors
    /// A number of indices other than that of the normals.
    pub fn with_materials(self, materials: &'a [u8]) -> Result<Self, Error> {
        if materials.len() != self.normals.len() {
            let accepted = Expected::Exactly(self.normals.len() as f32);
            return Err(Error {
                parameter: Parameter::MaterialCount,
                value: materials.len() as f32,
                accepted,
            });
        }
        Ok(Self { materials, ..self })
    }

    /// Returns the sprite with its upper left pixel at `(x, y)`.
    #[must_use]
    pub const fn at(self, x: i32, y: i32) -> Self {
        Self { corner: [x, y], ..self }
    }

    /// Sets the pixels of the sprite among those from `(x, y)` on: each to that of its ramp for the sum of
    /// the irradiances of its point. Pixels outside the sprite and transparent pixels keep their values.
    ///
    /// The irradiances are bit-identical to those of the lights' `irradiance`. The sum saturates.
    pub fn row<L: LightModel<S>>(&self, lights: &[L], y: i32, x: i32, pixels: &mut [P]) {
        let [left, top] = self.corner.map(i64::from);
        let start = usize::try_from(i64::from(y) - top).ok().and_then(|row| row.checked_mul(self.width));
        let right = start.and_then(|start| start.checked_add(self.width));
        let (Some(start), Some(right)) = (start, right) else { return };
        // How far the sprite begins after the pixels, or the pixels after the sprite: one is 0.
        let after = usize::try_from(left - i64::from(x)).unwrap_or(0);
        let start = start.saturating_add(usize::try_from(i64::from(x) - left).unwrap_or(0));
        let mut normals = self.normals.get(start..right).unwrap_or_default();
        let mut materials = self.materials.get(start..right).unwrap_or_default();
        let mut pixels = pixels.get_mut(after..).unwrap_or_default();
        let mut x = x.wrapping_add(after as i32);
        while !normals.is_empty() && !pixels.is_empty() {
            let is_shown = |normal: &&[i8; 3]| **normal != NONE;
            let step = if normals.first().is_some_and(|normal| is_shown(&normal)) {
                let run = normals.iter().take(BLOCK).take_while(is_shown).count();
                self.run(lights, [x, y], (normals.get(..run).unwrap_or_default(), materials), pixels);
                run
            } else {
                normals.iter().take_while(|normal| !is_shown(normal)).count()
            };
            normals = normals.get(step..).unwrap_or_default();
            materials = materials.get(step..).unwrap_or_default();
            pixels = pixels.get_mut(step..).unwrap_or_default();
            x = x.wrapping_add(step as i32);
        }
    }

    /// Sets up to [`BLOCK`] pixels without a transparent one.
    #[inline(always)]
    fn run<L: LightModel<S>>(
        &self,
        lights: &[L],
        [x, y]: [i32; 2],
        (bytes, materials): (&[[i8; 3]], &[u8]),
        pixels: &mut [P],
    ) {
        let points = row::<S>(self.pixel, y, x);
        let length = bytes.len().min(pixels.len()).min(BLOCK);
        let normal = |i: usize| S::normal_from_unit_bytes(bytes.get(i).copied().unwrap_or_default());
        let [mut sum, mut arrived] = [[S::Irradiance::default(); BLOCK]; 2];
        for light in lights {
            let lit = points.reach(light, length);
            let (sum, arrived) = (sum.get_mut(lit.clone()), arrived.get_mut(..lit.len()));
            let (sum, arrived) = (sum.unwrap_or_default(), arrived.unwrap_or_default());
            points.fill_facing(light, normal, lit.start, arrived);
            for (sum, arrived) in sum.iter_mut().zip(arrived) {
                *sum += *arrived;
            }
        }
        let materials = materials.iter().map(|material| usize::from(*material)).chain(core::iter::repeat(0));
        for (i, ((to, arrived), material)) in
            pixels.iter_mut().zip(sum).zip(materials).take(length).enumerate()
        {
            if let Some(ramp) = self.ramps.get(material).or(self.ramps.last()) {
                *to = ramp.pixel::<S>(arrived, x.wrapping_add(i as i32) as u32, y as u32);
            }
        }
    }
}
