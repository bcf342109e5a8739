//! A strip of addressable LEDs in a scene.

use alloc::{vec, vec::Vec};
use luminaire::{
    Error, Rgb, Scalar, Vec3,
    display::{LedChip, LedOrder, LedStrip, clip},
    dynamic::{AnyLight, CompiledAnyLight},
};

/// Currents in milliamperes that are on the safe side for a WS2812B: of one channel at full duty, and
/// of an LED that is dark.
const CHANNEL: u16 = 20;
const IDLE: u16 = 1;

/// LEDs at places of a scene, which show the bytes of a strip and not the shading of a surface.
///
/// An LED has the irradiance of all spotlights at its place, without gobos and shadows: on the side that it faces, or
/// of [all sides](luminaire::light::CompiledSpotLight::irradiance_facing). A [`LedStrip`] converts the light of all
/// LEDs to bytes.
#[derive(Clone, PartialEq, Debug)]
pub struct Strip {
    places: Vec<Vec3<f32>>,
    /// The ways that the LEDs face; none for LEDs that take light from all sides.
    facing: Vec<Vec3<f32>>,
    limit: u32,
}

impl Strip {
    /// Creates a strip with LEDs at these places in metres, whose current has a limit in milliamperes. They take light
    /// from all sides.
    pub fn new(places: impl IntoIterator<Item = Vec3<f32>>, limit: u32) -> Self {
        Self { places: places.into_iter().collect(), facing: Vec::new(), limit }
    }

    /// Returns the strip with LEDs that face these ways, which are unit vectors: one for each, in the order of the
    /// places. LEDs without one take light from all sides.
    #[must_use]
    pub fn facing(self, facing: impl IntoIterator<Item = Vec3<f32>>) -> Self {
        Self { facing: facing.into_iter().collect(), ..self }
    }

    /// Returns the places of the LEDs in metres.
    pub fn places(&self) -> &[Vec3<f32>] {
        &self.places
    }

    /// Returns the ways that the LEDs face; none if they take light from all sides.
    pub fn ways(&self) -> &[Vec3<f32>] {
        &self.facing
    }

    /// Returns the limit of the current in milliamperes.
    pub fn limit(&self) -> u32 {
        self.limit
    }

    /// Returns the duties of the LEDs in one frame under these lights, computed in the format `S`: the
    /// bytes of the strip. The temporal dither of each frame begins in the same state, so that equal
    /// lights have equal frames.
    ///
    /// # Errors
    /// A light that the format can't hold.
    pub fn frame<'a, S: Scalar>(
        &self,
        lights: impl IntoIterator<Item = &'a AnyLight>,
    ) -> Result<Vec<Rgb<u8>>, Error> {
        let lights = lights.into_iter().map(AnyLight::compile::<S>).collect::<Result<Vec<_>, Error>>()?;
        let arrived = (0..).zip(&self.places).map(|(led, &place)| {
            let (place, facing) = (place.map(S::length), self.facing.get::<usize>(led));
            let facing = facing.map(|&facing| S::normal(facing));
            let add = |sum: Rgb<S::Irradiance>, light: &CompiledAnyLight<S>| match light {
                CompiledAnyLight::Spot(spot) => {
                    let light = match facing {
                        Some(facing) => spot.irradiance(place, facing),
                        None => spot.irradiance_facing(place),
                    };
                    sum + Rgb::lit(light, spot.color())
                }
                _ => sum,
            };
            clip(lights.iter().fold(Rgb::default(), add))
        });
        let arrived: Vec<_> = arrived.collect();
        let mut dithers: Vec<_> = (0..arrived.len()).map(|led| LedOrder::dither(led as u16)).collect();
        let mut bytes = vec![0; 3 * arrived.len()];
        let strip = LedStrip::new(LedOrder::Rgb).with_limit(self.limit, CHANNEL, IDLE);
        strip.write(&arrived, &mut dithers, &mut bytes);
        Ok(bytes.chunks_exact(3).map(|led| Rgb::new(led[0], led[1], led[2])).collect())
    }

    /// Returns the current of a frame in milliamperes, rounded up.
    pub fn current(frame: &[Rgb<u8>]) -> u32 {
        let duties = frame.iter().flat_map(|led| [led.red, led.green, led.blue]).map(u32::from);
        frame.len() as u32 * u32::from(IDLE) + (duties.sum::<u32>() * u32::from(CHANNEL)).div_ceil(255)
    }
}
