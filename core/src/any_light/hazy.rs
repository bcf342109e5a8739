//! The beam of a light in haze, for many view rays.

use super::CompiledAnyLight;
use crate::{
    attenuation::{AnyAttenuation, Attenuation, InverseSquare},
    cone::CompiledCone,
    falloff::{AnyFalloff, CompiledAnyFalloff, Falloff},
    haze::{AtNodes, BeamScattering, Haze, TransmittanceFn, ViewRays},
};

impl CompiledAnyLight<f32> {
    /// Returns the beam of the light in haze; `None` if the light is not a spotlight.
    pub fn in_haze(&self, haze: &Haze) -> Option<BeamScattering<AnyFalloff, AnyAttenuation>> {
        match self {
            Self::Spot(spot) => Some(spot.in_haze(haze)),
            Self::Directional(_) | Self::Point(_) | Self::Measured(_) => None,
        }
    }
}

/// Evaluates an expression with the concrete types of these falloffs, and with the enums for all others: a loop
/// for each falloff of the list would fill a module with loops that few beams use.
macro_rules! with_concrete {
    ([$($variant:ident),*], $cone:expr, $falloff:ident, $curve:ident => $answer:expr) => {
        match ($cone.falloff, $cone.curve) {
            $((AnyFalloff::$variant($falloff), CompiledAnyFalloff::$variant($curve)) => $answer,)*
            ($falloff, $curve) => $answer,
        }
    };
}

impl BeamScattering<AnyFalloff, AnyAttenuation> {
    /// Returns whether the light attenuates exactly with the inverse square of the distance.
    pub fn is_inverse_square(&self) -> bool {
        AnyAttenuation::is_inverse_square::<f32>(&self.attenuation)
    }

    /// Computes the in-scattered light of `N` rays. The result is bit-identical to
    /// [`in_scattering`](Self::in_scattering) with the beam's own falloff type.
    ///
    /// For the inverse-square law there is one loop for polynomials without a hotspot, one for two soft falloffs
    /// without one, and one for each of the other falloffs but the step and two soft ones with a hotspot. All other
    /// attenuations share one loop with branches on falloff and attenuation.
    pub fn in_scattering_each<const N: usize>(&self, rays: &ViewRays<N>, lights: &mut [f32; N]) {
        if let Some(curve) = self.polynomial() {
            for (i, light) in lights.iter_mut().enumerate() {
                *light = self.in_closed_form(curve, &rays.at(i));
            }
        } else if let Some(pair) = self.pair() {
            for (i, light) in lights.iter_mut().enumerate() {
                *light = self.in_two_closed_forms(pair, &rays.at(i));
            }
        } else if AnyAttenuation::is_inverse_square::<f32>(&self.attenuation) {
            let ramp = self.falloff.ramp;
            let at_nodes = |versines: &AtNodes<N>, intensities: &mut AtNodes<N>| match self.falloff.curve {
                CompiledAnyFalloff::Power(power) => {
                    let t = |versine| ramp.rise(versine);
                    raised(versines, intensities, power.exponent(), t, |x| x);
                }
                CompiledAnyFalloff::InvertedPower(power) => {
                    let u = |versine| 1.0 - ramp.rise(versine);
                    raised(versines, intensities, power.exponent(), u, |x| 1.0 - x);
                }
                _ => with_concrete!(
                    [Soft, Hard, Linear, Smooth, Quadratic, Cubic, RealPower, InvertedRealPower, Table],
                    self.falloff, falloff, curve => {
                        at_each(&CompiledCone::from_parts(ramp, falloff, curve), versines, intensities);
                    }
                ),
            };
            self.by_nodes_each(rays, at_nodes, lights);
        } else {
            for (i, light) in lights.iter_mut().enumerate() {
                *light = self.by_nodes(&rays.at(i));
            }
        }
    }

    /// Computes the in-scattered light of `N` rays with a transmittance filter. The result is
    /// bit-identical to [`in_scattering_through`](Self::in_scattering_through) with `PARTS` samples
    /// per ray.
    ///
    /// The filter is called once per ray with all samples of that ray. For rays outside the beam
    /// the filter is not called.
    pub fn in_scattering_through_each<const PARTS: usize, const N: usize>(
        &self,
        rays: &ViewRays<N>,
        filter: &mut TransmittanceFn<'_, PARTS>,
        lights: &mut [f32; N],
    ) {
        if AnyAttenuation::is_inverse_square::<f32>(&self.attenuation) {
            with_concrete!([Soft, Hard, Quadratic, Cubic], self.falloff, falloff, curve => {
                each_through(&self.by_square(falloff, curve), rays, filter, lights)
            });
        } else {
            each_through(self, rays, filter, lights);
        }
    }

    /// Returns the beam with the concrete types of its falloff and of the inverse-square law.
    fn by_square<P: Falloff>(&self, falloff: P, curve: P::Compiled<f32>) -> BeamScattering<P, InverseSquare> {
        let falloff = CompiledCone::from_parts(self.falloff.ramp, falloff, curve);
        let Self { position, axis, gain, cone, reach, .. } = *self;
        BeamScattering::from_parts(position, axis, falloff, (), gain, cone, reach)
    }
}

/// Sets the intensities of an integer power at the nodes of rays, from `base` of each versine. The loop over the
/// digits of the exponent is outside that over the rays, so that compilers vectorise it.
fn raised<const N: usize>(
    versines: &AtNodes<N>,
    intensities: &mut AtNodes<N>,
    exponent: u32,
    base: impl Fn(f32) -> f32,
    result: impl Fn(f32) -> f32,
) {
    for (intensities, versines) in intensities.as_flattened_mut().iter_mut().zip(versines.as_flattened()) {
        let bases = versines.map(&base);
        let mut powers = bases;
        for digit in (0..exponent.max(1).ilog2()).rev() {
            powers.iter_mut().for_each(|power| *power *= *power);
            if exponent >> digit & 1 == 1 {
                powers.iter_mut().zip(&bases).for_each(|(power, base)| *power *= base);
            }
        }
        *intensities = powers.map(&result);
    }
}

/// Sets the intensities at the nodes of rays.
fn at_each<P: Falloff, const N: usize>(
    cone: &CompiledCone<f32, P>,
    versines: &AtNodes<N>,
    intensities: &mut AtNodes<N>,
) {
    for (intensities, versines) in intensities.as_flattened_mut().iter_mut().zip(versines.as_flattened()) {
        cone.at_each(versines, intensities);
    }
}

#[inline(never)]
fn each_through<P: Falloff, A: Attenuation, const PARTS: usize, const N: usize>(
    beam: &BeamScattering<P, A>,
    rays: &ViewRays<N>,
    filter: &mut TransmittanceFn<'_, PARTS>,
    lights: &mut [f32; N],
) {
    for (i, light) in lights.iter_mut().enumerate() {
        *light = beam.in_scattering_filtered(&rays.at(i), filter);
    }
}
