//! Pools of light.

use core::array;

use super::{BLOCK, row};
use crate::{
    display::{Pixel, Ramp},
    number::Scalar,
    shade::LightModel,
};

/// A pool of light: the screen as a wall of one colour, under a light in front of it.
///
/// The colour of the wall without the light is the base of the ramp. Pixels that
/// [`Row::reach`](crate::light::Row::reach) excludes have this colour without an evaluation of the light.
///
/// ```
/// use luminaire::{Angle, Cone, Fx16, Length, Rgb, SpotLight, display::{Ramp, Rgb565}, draw::Pool};
/// // A blue wall, 32 pixels to the metre, and a warm light two metres in front of it.
/// let ramp: Ramp<Rgb565> = Ramp::new(Rgb::new(0.0, 0.01, 0.1), Rgb::new(0.9, 0.7, 0.4))?;
/// let pool = Pool::new(&ramp, Length::from_bits(1 << (16 - 5)));
/// let cone = Cone::soft(Angle::degrees(40.0))?;
/// let light = SpotLight::new([2.0, 1.0, 2.0], [0.0, 0.0, -1.0], cone)?.with_intensity(4.0)?;
/// let mut row = [Rgb565(0); 160];
/// pool.row(&light.compile_quick::<Fx16>()?, 32, 0, &mut row);
/// assert!(row[64].to_codes().red > 230 && row[150].to_codes().red == 0);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pool<'a, P, S: Scalar> {
    ramp: &'a Ramp<P>,
    pixel: S::Length,
}

impl<'a, P: Pixel, S: Scalar> Pool<'a, P, S> {
    /// Creates a pool from the wall's pixels by the irradiance and the length of a pixel.
    pub const fn new(ramp: &'a Ramp<P>, pixel: S::Length) -> Self {
        Self { ramp, pixel }
    }

    /// Sets the pixels from `(x, y)` on: each to that of the ramp for the irradiance of its point.
    ///
    /// The irradiance is bit-identical to that of the light's `irradiance`.
    pub fn row<L: LightModel<S>>(&self, light: &L, y: i32, x: i32, pixels: &mut [P]) {
        let points = row::<S>(self.pixel, y, x);
        let pixel =
            |arrived, i: usize| self.ramp.pixel::<S>(arrived, x.wrapping_add(i as i32) as u32, y as u32);
        let dark: [P; 8] = array::from_fn(|i| pixel(S::Irradiance::default(), i));
        for (i, to) in pixels.iter_mut().enumerate() {
            *to = dark[i % 8];
        }
        let lit = points.reach(light, pixels.len());
        let mut first = lit.start;
        for block in pixels.get_mut(lit).unwrap_or_default().chunks_mut(BLOCK) {
            let mut arrived = [S::Irradiance::default(); BLOCK];
            points.fill(light, first, arrived.get_mut(..block.len()).unwrap_or_default());
            for (to, arrived) in block.iter_mut().zip(arrived) {
                *to = pixel(arrived, first);
                first += 1;
            }
        }
    }
}
