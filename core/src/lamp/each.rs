//! The loop for a lamp: its kind, profile and distance model are told apart once for many points, and the loop over them
//! has no branch on what is the same for all.
//!
//! There is a loop for each profile under the inverse-square law, and one for each without a fall. Under another
//! distance model the light is found in two loops, the cone's and then the distance's: together as many as there are
//! profiles and models, and not one for each pair.

use super::CompiledLamp;
use crate::{
    attenuation::{Attenuation, CompiledDistance, Distance, Unattenuated, with_attenuation},
    cone::Falloff,
    profile::{Matched, Profile, with_profile},
    scalar::{Offset, Scalar},
    shade::{Arrival, CompiledPoint, CompiledSpot, Light, Surface},
    specular::Specular,
    vec3::Vec3,
};

/// Points of surfaces, each quantity in an array of its own: see [`Surface`].
#[derive(Clone, Copy, Debug)]
pub struct Surfaces<'a, S: Scalar, const N: usize> {
    /// Where the points are.
    pub point: Vec3<&'a [S::Length; N]>,
    /// The normals, of unit length.
    pub normal: Vec3<&'a [S; N]>,
    /// The directions from the points to the eye, of unit length. Matt surfaces do not ask for them.
    pub view: Vec3<&'a [S::Unit; N]>,
}

impl<S: Scalar, const N: usize> Surfaces<'_, S, N> {
    /// One of the points; beyond the last a point that faces nowhere.
    #[inline(always)]
    pub fn at(&self, i: usize) -> Surface<S> {
        Surface {
            point: self.point.map(|column| nth(column, i)),
            normal: self.normal.map(|column| nth(column, i)),
            view: self.view.map(|column| nth(column, i)),
        }
    }
}

/// A value of a column, or the default beyond its end: within a loop over the column the compiler leaves the question out.
#[inline(always)]
pub(super) fn nth<T: Copy + Default, const N: usize>(column: &[T; N], i: usize) -> T {
    column.get(i).copied().unwrap_or_default()
}

/// What is given and taken by a loop.
struct Loop<'a, S: Scalar, H: Specular, const N: usize> {
    surfaces: &'a Surfaces<'a, S, N>,
    highlight: &'a H::Constants<S>,
    arrivals: &'a mut Arrival<[S::Irradiance; N]>,
}

impl<S: Scalar> CompiledLamp<S> {
    /// What arrives at each of many points whose highlights are of the kind `H`: to the bit what
    /// [`arrive`](Light::arrive) of the lamp's own type gives for one. The arrivals of a matt surface have no specular
    /// part; what was there stays.
    ///
    /// In fixed point, where points are computed one by one, those where nothing can arrive are left before their root is
    /// paid for, with the same bits. In `f32` that would be in the way of vector instructions.
    pub fn arrive_each<H: Specular, const N: usize>(
        &self,
        surfaces: &Surfaces<'_, S, N>,
        highlight: &H::Constants<S>,
        arrivals: &mut Arrival<[S::Irradiance; N]>,
    ) {
        let mut each = Loop::<S, H, N> { surfaces, highlight, arrivals };
        match self {
            Self::Directional(light) => each.light(light),
            Self::Point(light) => each.point(light),
            Self::Spot(light) => each.spot(light),
        }
    }
}

/// A compiled distance model without a range is the plain one.
fn plain<S: Scalar>(distance: &CompiledDistance<S>) -> Option<Plain> {
    let none = S::gain(0.0);
    match distance {
        CompiledDistance::Constant((range, ())) if *range == none => Some(Plain::Unattenuated),
        distance if Distance::is_inverse_square::<S>(distance) => Some(Plain::InverseSquare),
        _ => None,
    }
}

/// The distance models that have a loop with every profile.
enum Plain {
    Unattenuated,
    InverseSquare,
}

impl<S: Scalar, H: Specular, const N: usize> Loop<'_, S, H, N> {
    fn light<L: Light<S>>(&mut self, light: &L) {
        let Arrival { diffuse, specular } = self.arrivals;
        light_each::<S, H, L, N>(light, self.surfaces, self.highlight, diffuse, specular);
    }

    fn point(&mut self, light: &CompiledPoint<S, Distance>) {
        let CompiledPoint { position, intensity, fine_below, color, specular_color, .. } = *light;
        let colors = [color, specular_color];
        match plain(&light.attenuation) {
            Some(Plain::InverseSquare) => {
                self.light(&CompiledPoint::<S>::from_parts(position, (), intensity, fine_below, colors));
            }
            Some(Plain::Unattenuated) => {
                let light =
                    CompiledPoint::<S, Unattenuated>::from_parts(position, (), intensity, fine_below, colors);
                self.light(&light);
            }
            None => {
                let one = S::gain(1.0);
                self.light(&CompiledPoint::<S, Unattenuated>::from_parts(position, (), one, 0, colors));
                self.fall(position, &light.attenuation, intensity);
                self.refine(light, position, fine_below);
            }
        }
    }

    fn spot(&mut self, light: &CompiledSpot<S, Matched, Distance>) {
        with_profile!(light.falloff, profile, curve => self.cone(light, profile, curve));
    }

    fn cone<P: Profile>(
        &mut self,
        light: &CompiledSpot<S, Matched, Distance>,
        profile: P,
        curve: P::Compiled<S>,
    ) {
        let CompiledSpot { position, axis, outside, intensity, fine_below, color, specular_color, .. } =
            *light;
        let colors = [color, specular_color];
        let falloff = Falloff::from_parts(light.falloff.ramp, profile, curve);
        match plain(&light.attenuation) {
            Some(Plain::InverseSquare) => self.light(&CompiledSpot::<S, P>::from_parts(
                position,
                axis,
                falloff,
                outside,
                (),
                intensity,
                fine_below,
                colors,
            )),
            plain => {
                let (gain, below) = if plain.is_some() { (intensity, fine_below) } else { (S::gain(1.0), 0) };
                self.light(&CompiledSpot::<S, P, Unattenuated>::from_parts(
                    position,
                    axis,
                    falloff,
                    outside,
                    (),
                    gain,
                    below,
                    colors,
                ));
                if plain.is_none() {
                    self.fall(position, &light.attenuation, intensity);
                    self.refine(light, position, fine_below);
                }
            }
        }
    }

    /// Gives the points so near to the lamp that they want it the fine evaluation, which two loops cannot share.
    fn refine<L: Light<S>>(&mut self, light: &L, position: Vec3<S::Length>, fine_below: u32) {
        for i in 0..N {
            let surface = self.surfaces.at(i);
            if S::offset(position, surface.point).is_near(fine_below) {
                let arrival = light.arrive::<H>(&surface, self.highlight, true);
                self.arrivals.diffuse[i] = arrival.diffuse;
                if H::SHINES {
                    self.arrivals.specular[i] = arrival.specular;
                }
            }
        }
    }

    fn fall(&mut self, position: Vec3<S::Length>, distance: &CompiledDistance<S>, intensity: S::Gain) {
        with_attenuation!(distance, constants: Model => {
            self.attenuate::<Model>(position, constants, intensity);
        });
    }

    fn attenuate<A: Attenuation>(
        &mut self,
        position: Vec3<S::Length>,
        constants: &A::Constants<S>,
        intensity: S::Gain,
    ) {
        let Arrival { diffuse, specular } = self.arrivals;
        attenuate_each::<S, A, N>(position, constants, intensity, self.surfaces.point, diffuse);
        if H::SHINES {
            attenuate_each::<S, A, N>(position, constants, intensity, self.surfaces.point, specular);
        }
    }
}

/// The loop of a light. What it writes to are arguments of their own, which compilers know to be apart from what it reads.
#[inline(never)]
fn light_each<S: Scalar, H: Specular, L: Light<S>, const N: usize>(
    light: &L,
    surfaces: &Surfaces<'_, S, N>,
    highlight: &H::Constants<S>,
    diffuse: &mut [S::Irradiance; N],
    specular: &mut [S::Irradiance; N],
) {
    let (surfaces, highlight) = (*surfaces, *highlight);
    for i in 0..N {
        let arrival = light.arrive::<H>(&surfaces.at(i), &highlight, !S::Offset::ROOTS_FIRST);
        diffuse[i] = arrival.diffuse;
        if H::SHINES {
            specular[i] = arrival.specular;
        }
    }
}

/// Takes fractions of a full intensity to what is left of the intensity at each distance.
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
        if !S::Offset::ROOTS_FIRST && *light == S::Irradiance::default() {
            continue;
        }
        let offset = S::offset(position, points.map(|column| nth(column, i)));
        *light = A::expose(&constants, &offset, &offset.ray(), S::clip(*light), intensity);
    }
}
