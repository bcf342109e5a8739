//! The lighting pass: how much light arrives at each pixel, and how much of it the surface sends to the eye.

use crate::{
    bounds::Beam,
    format::Format,
    gbuffer::{Block, LANES},
    scene::Material,
};
use luminaire::{CompiledSpot, Edge, Error, Hard, Profile, Rgb, Scalar, Soft, Spot, Vec3};

/// The light that the pixels of a block send to the eye: linear, 1 is full scale.
pub(crate) type Radiance = Rgb<[f32; LANES]>;

/// A spotlight compiled for a format, its edge profile chosen once and for all.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Light<S: Scalar> {
    beam: Beam,
    spot: Compiled<S>,
}

#[derive(Clone, Copy, Debug)]
enum Compiled<S: Scalar> {
    Soft(CompiledSpot<S, Soft>),
    Hard(CompiledSpot<S, Hard>),
}

impl<S: Format> Light<S> {
    /// # Errors
    /// A cone that is too narrow for the format.
    pub(crate) fn new(spot: &Spot) -> Result<Self, Error> {
        let compiled = spot.compile()?;
        let spot_of_profile = match compiled.profile() {
            Edge::Soft => Compiled::Soft(compiled.with_profile(Soft)),
            Edge::Hard => Compiled::Hard(compiled.with_profile(Hard)),
        };
        Ok(Self { beam: Beam::new(spot), spot: spot_of_profile })
    }
}

/// Lights the pixels of a block. Their materials are looked up by number.
pub(crate) fn light<S: Format>(
    block: &Block<S>,
    lights: &[Light<S>],
    ambient: Rgb<f32>,
    materials: &[Material],
) -> Radiance {
    let mut sum = ambient.map(|channel| [S::ONE.expose(S::gain(channel)); LANES]);
    if let Some(bounds) = &block.bounds {
        for light in lights.iter().filter(|light| !light.beam.misses(bounds)) {
            match &light.spot {
                Compiled::Soft(spot) => add(&mut sum, block, spot),
                Compiled::Hard(spot) => add(&mut sum, block, spot),
            }
        }
    }
    let mut radiance = sum.map(|channel| channel.map(S::light_to_f32));
    for lane in 0..LANES {
        let albedo = materials.get(block.material[lane] as usize).copied().unwrap_or_default().albedo;
        radiance.red[lane] *= albedo.red;
        radiance.green[lane] *= albedo.green;
        radiance.blue[lane] *= albedo.blue;
    }
    radiance
}

/// Adds the light of a spotlight.
#[inline(always)]
fn add<S: Format, P: Profile>(
    sum: &mut Rgb<[S::Irradiance; LANES]>,
    block: &Block<S>,
    spot: &CompiledSpot<S, P>,
) {
    let color = spot.color();
    for lane in 0..LANES {
        let point = Vec3::new(block.point.x[lane], block.point.y[lane], block.point.z[lane]);
        let normal = Vec3::new(block.normal.x[lane], block.normal.y[lane], block.normal.z[lane]);
        let light = if S::ASKS_EACH_POINT {
            spot.irradiance(point, normal)
        } else {
            spot.irradiance_unskipped(point, normal)
        };
        sum.red[lane] = S::add_light(sum.red[lane], S::filter(light, color.red));
        sum.green[lane] = S::add_light(sum.green[lane], S::filter(light, color.green));
        sum.blue[lane] = S::add_light(sum.blue[lane], S::filter(light, color.blue));
    }
}
