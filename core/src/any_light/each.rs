//! Evaluation of one light at many points.
//!
//! In `f32` the kind, the falloff and the attenuation of the light are matched once, so that the loop over
//! the points has no branch on these three. Each falloff has one loop for the inverse-square law, and one
//! loop for no attenuation. Any other attenuation takes two loops: the first loop evaluates the cone, the
//! second the attenuation. The number of compiled loops therefore grows with the sum of the numbers of
//! falloffs and attenuations, instead of their product.
//!
//! Fixed point computes the points one by one, and would lose bits between two loops. Its loops match the
//! falloff at every point, and the attenuation, too, unless it is the inverse-square law: a loop for each
//! falloff would be a hundredth faster on x86-64, and a tenth of the demo's module (both measured).

use super::CompiledAnyLight;
use crate::{
    attenuation::{AnyAttenuation, Attenuation, CompiledAnyAttenuation, NoAttenuation, WithConstants},
    cone::CompiledCone,
    falloff::{AnyFalloff, Falloff, WithFalloff, with_falloff},
    number::{Offset, Scalar, Share},
    shade::{CompiledPointLight, CompiledSpotLight, Incident, LightModel, SurfacePoint},
    specular::SpecularLobe,
    vec3::{Vec3, nth},
};

/// Surface points as a structure of arrays: see [`SurfacePoint`].
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoints<'a, S: Scalar, const N: usize> {
    /// The positions of the points.
    pub point: Vec3<&'a [S::Length; N]>,
    /// The normals, of unit length.
    pub normal: Vec3<&'a [S; N]>,
    /// The directions from the points to the eye, of unit length. Unused for matte surfaces.
    pub view: Vec3<&'a [S::Unit; N]>,
}

impl<S: Scalar, const N: usize> SurfacePoints<'_, S, N> {
    /// Returns point `i`; for `i >= N`, a point with all components 0.
    #[inline]
    pub fn at(&self, i: usize) -> SurfacePoint<S> {
        SurfacePoint {
            point: self.point.map(|column| nth(column, i)),
            normal: self.normal.map(|column| nth(column, i)),
            view: self.view.map(|column| nth(column, i)),
        }
    }
}

/// The inputs and outputs of a loop.
struct Loop<'a, S: Scalar, H: SpecularLobe, const N: usize> {
    surfaces: &'a SurfacePoints<'a, S, N>,
    highlight: &'a H::Constants<S>,
    arrivals: &'a mut Incident<[S::Irradiance; N]>,
}

impl<S: Scalar> CompiledAnyLight<S> {
    /// Evaluates the light at `N` points with the specular lobe `H`, bit-identical to
    /// [`evaluate`](Self::evaluate). A lobe of [`NoSpecular`](crate::specular::NoSpecular) leaves
    /// `arrivals.specular` unchanged.
    ///
    /// Fixed point computes the points one by one and returns 0 for unreachable points before the
    /// square root; the result is bit-identical. `f32` has no such early-out, because a branch
    /// would prevent vector instructions.
    pub fn evaluate_each<H: SpecularLobe, const N: usize>(
        &self,
        surfaces: &SurfacePoints<'_, S, N>,
        highlight: &H::Constants<S>,
        arrivals: &mut Incident<[S::Irradiance; N]>,
    ) {
        let mut each = Loop::<S, H, N> { surfaces, highlight, arrivals };
        match self {
            Self::Directional(light) => each.light(light),
            Self::Point(light) => each.point(light),
            Self::Spot(light) => each.spot(light),
        }
    }
}

/// Returns the plain attenuation that equals a compiled attenuation; `None` if no plain attenuation
/// does.
fn plain<S: Scalar>(distance: &CompiledAnyAttenuation<S>) -> Option<Plain> {
    let none = S::gain(0.0);
    match distance {
        CompiledAnyAttenuation::Constant((range, ())) if *range == none => Some(Plain::Unattenuated),
        distance if AnyAttenuation::is_inverse_square::<S>(distance) => Some(Plain::InverseSquare),
        _ => None,
    }
}

/// The plain attenuations, which are evaluated in the same loop as the falloff.
enum Plain {
    Unattenuated,
    InverseSquare,
}

impl<S: Scalar, H: SpecularLobe, const N: usize> Loop<'_, S, H, N> {
    fn light<L: LightModel<S>>(&mut self, light: &L) {
        let Incident { diffuse, specular } = self.arrivals;
        light_each::<S, H, L, N>(light, self.surfaces, self.highlight, diffuse, specular);
    }

    fn point(&mut self, light: &CompiledPointLight<S, AnyAttenuation>) {
        let CompiledPointLight { position, intensity, fine_below, color, specular_color, .. } = *light;
        let colors = [color, specular_color];
        match plain(&light.attenuation) {
            Some(Plain::InverseSquare) => {
                self.light(&CompiledPointLight::<S>::from_parts(position, (), intensity, fine_below, colors));
            }
            _ if !S::Offset::ROOTS_FIRST => self.light(light),
            Some(Plain::Unattenuated) => {
                let light = CompiledPointLight::<S, NoAttenuation>::from_parts(
                    position,
                    (),
                    intensity,
                    fine_below,
                    colors,
                );
                self.light(&light);
            }
            None => {
                let one = S::gain(1.0);
                self.light(&CompiledPointLight::<S, NoAttenuation>::from_parts(position, (), one, 0, colors));
                self.fall(position, &light.attenuation, intensity);
            }
        }
    }

    fn spot(&mut self, light: &CompiledSpotLight<S, AnyFalloff, AnyAttenuation>) {
        if S::Offset::ROOTS_FIRST {
            return with_falloff(light.cone.falloff, light.cone.curve, Spot { each: self, light });
        }
        let Some(Plain::InverseSquare) = plain(&light.attenuation) else { return self.light(light) };
        self.light(&CompiledSpotLight::<S, AnyFalloff>::from_parts(
            light.position,
            light.axis,
            light.cone,
            light.outside,
            (),
            light.intensity,
            light.fine_below,
            [light.color, light.specular_color],
        ));
    }

    fn cone<P: Falloff>(
        &mut self,
        light: &CompiledSpotLight<S, AnyFalloff, AnyAttenuation>,
        falloff: P,
        curve: P::Compiled<S>,
    ) {
        let CompiledSpotLight {
            position, axis, outside, intensity, fine_below, color, specular_color, ..
        } = *light;
        let colors = [color, specular_color];
        let cone = CompiledCone::from_parts(light.cone.ramp, falloff, curve);
        match plain(&light.attenuation) {
            Some(Plain::InverseSquare) => self.light(&CompiledSpotLight::<S, P>::from_parts(
                position,
                axis,
                cone,
                outside,
                (),
                intensity,
                fine_below,
                colors,
            )),
            plain => {
                let (gain, below) = if plain.is_some() { (intensity, fine_below) } else { (S::gain(1.0), 0) };
                self.light(&CompiledSpotLight::<S, P, NoAttenuation>::from_parts(
                    position,
                    axis,
                    cone,
                    outside,
                    (),
                    gain,
                    below,
                    colors,
                ));
                if plain.is_none() {
                    self.fall(position, &light.attenuation, intensity);
                }
            }
        }
    }

    fn fall(&mut self, position: Vec3<S::Length>, distance: &CompiledAnyAttenuation<S>, intensity: S::Gain) {
        distance.typed(Fall { each: self, position, intensity });
    }
}

/// A loop over the points of a spotlight, with the types of its cone.
struct Spot<'a, 'b, S: Scalar, H: SpecularLobe, const N: usize> {
    each: &'a mut Loop<'b, S, H, N>,
    light: &'a CompiledSpotLight<S, AnyFalloff, AnyAttenuation>,
}

impl<S: Scalar, H: SpecularLobe, const N: usize> WithFalloff<S> for Spot<'_, '_, S, H, N> {
    type Output = ();

    #[inline]
    fn falloff<P: Falloff>(self, falloff: P, curve: P::Compiled<S>) {
        self.each.cone(self.light, falloff, curve);
    }
}

/// A loop that attenuates what the cone alone gave.
struct Fall<'a, 'b, S: Scalar, H: SpecularLobe, const N: usize> {
    each: &'a mut Loop<'b, S, H, N>,
    position: Vec3<S::Length>,
    intensity: S::Gain,
}

impl<S: Scalar, H: SpecularLobe, const N: usize> WithConstants<S> for Fall<'_, '_, S, H, N> {
    #[inline]
    fn constants<A: Attenuation>(self, constants: &A::Constants<S>) {
        let (Loop { surfaces, arrivals, .. }, position) = (self.each, self.position);
        let Incident { diffuse, specular } = arrivals;
        attenuate_each::<S, A, N>(position, constants, self.intensity, surfaces.point, diffuse);
        if H::SHINES {
            attenuate_each::<S, A, N>(position, constants, self.intensity, surfaces.point, specular);
        }
    }
}

/// Evaluates the light at each point. The outputs are separate arguments, so that the compiler
/// knows that the outputs do not alias the inputs.
#[inline(never)]
fn light_each<S: Scalar, H: SpecularLobe, L: LightModel<S>, const N: usize>(
    light: &L,
    surfaces: &SurfacePoints<'_, S, N>,
    highlight: &H::Constants<S>,
    diffuse: &mut [S::Irradiance; N],
    specular: &mut [S::Irradiance; N],
) {
    let (surfaces, highlight) = (*surfaces, *highlight);
    for i in 0..N {
        let arrival = light.evaluate::<H>(&surfaces.at(i), &highlight, !S::Offset::ROOTS_FIRST);
        diffuse[i] = arrival.diffuse;
        if H::SHINES {
            specular[i] = arrival.specular;
        }
    }
}

/// Attenuates irradiances that were computed with an intensity of 1 and without attenuation.
#[inline(never)]
fn attenuate_each<S: Scalar, A: Attenuation, const N: usize>(
    position: Vec3<S::Length>,
    constants: &A::Constants<S>,
    intensity: S::Gain,
    points: Vec3<&[S::Length; N]>,
    lights: &mut [S::Irradiance; N],
) {
    let constants = *constants;
    for (i, light) in lights.iter_mut().enumerate() {
        let offset = S::Offset::between(position, points.map(|column| nth(column, i)));
        let share = Share::of_scalar(S::clip(*light));
        *light = A::light(&constants, &offset, &offset.ray(), share, intensity);
    }
}
