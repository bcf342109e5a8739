//! Evaluation of one light at many points.
//!
//! In `f32` the kind, the falloff and the attenuation of the light are matched once, so that the loop over
//! the points has no branch on these three. Each falloff has one loop for the inverse-square law, and one
//! loop for no attenuation. Any other attenuation takes two loops: the first loop evaluates the cone, the
//! second the attenuation. The number of compiled loops therefore grows with the sum of the numbers of
//! falloffs and attenuations, instead of their product.
//!
//! Fixed point computes the points in vectors where the light has this. Else it computes the points one by one, and
//! would lose bits between two loops. Its loops match the falloff at every point, and the attenuation, too,
//! unless it is the inverse-square law: a loop for each falloff would be a hundredth faster on x86-64, and a
//! tenth of the demo's module (both measured).

use crate::{
    attenuation::{AnyAttenuation, Attenuation, CompiledAnyAttenuation, NoAttenuation, WithConstants},
    cone::CompiledCone,
    falloff::{AnyFalloff, Falloff, WithFalloff, with_falloff},
    number::{Offset, Scalar, Share},
    points::SurfacePoints,
    shade::{CompiledMeasuredLight, CompiledPointLight, CompiledSpotLight, Incident, LightModel},
    specular::SpecularLobe,
    vec3::{Vec3, nth},
};

/// The inputs and outputs of a loop.
pub(super) struct Loop<'a, S: Scalar, H: SpecularLobe, const N: usize> {
    pub(super) surfaces: &'a SurfacePoints<'a, S, N>,
    pub(super) highlight: &'a H::Constants<S>,
    pub(super) arrivals: &'a mut Incident<[S::Irradiance; N]>,
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
    pub(super) fn light<L: LightModel<S>>(&mut self, light: &L) {
        light.evaluate_each::<H, N>(self.surfaces, self.highlight, self.arrivals);
    }

    pub(super) fn point(&mut self, light: &CompiledPointLight<S, AnyAttenuation>) {
        let CompiledPointLight { position, intensity, fine_below, color, specular_color, .. } = *light;
        let colors = [color, specular_color];
        match plain(&light.attenuation) {
            Some(Plain::InverseSquare) => {
                self.light(&CompiledPointLight::<S>::from_parts(position, (), intensity, fine_below, colors));
            }
            _ if S::SKIPS => self.light(light),
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

    /// A measured light has one loop for the inverse square, and else one that matches the attenuation at every point.
    pub(super) fn measured(&mut self, light: &CompiledMeasuredLight<'_, S, AnyAttenuation>) {
        let Some(Plain::InverseSquare) = plain(&light.attenuation) else { return self.light(light) };
        self.light(&CompiledMeasuredLight::<S>::from_parts(
            light.position,
            light.frame,
            light.distribution,
            light.outside,
            (),
            light.intensity,
            light.fine_below,
            [light.color, light.specular_color],
        ));
    }

    pub(super) fn spot(&mut self, light: &CompiledSpotLight<S, AnyFalloff, AnyAttenuation>) {
        if !S::SKIPS {
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
