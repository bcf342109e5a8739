//! Shading of one surface point by one compiled light.

mod directional;
mod point;
mod quick;
mod spot;

// Behind the evaluation: rustdoc shows methods in this order.
mod change;

pub use self::{
    directional::CompiledDirectionalLight, point::CompiledPointLight, quick::QuickSpotLight,
    spot::CompiledSpotLight,
};

use crate::{
    attenuation::Attenuation,
    color::Rgb,
    cone::CompiledCone,
    falloff::Falloff,
    number::{Fraction, Offset, Ray, Scalar, Share},
    specular::{NoSpecular, SpecularLobe},
    vec3::Vec3,
};

/// A surface point, with its normal and the direction to the eye.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfacePoint<S: Scalar> {
    /// The position, in the unit of the lights' positions.
    pub point: Vec3<S::Length>,
    /// The normal, of unit length.
    pub normal: Vec3<S>,
    /// The direction from the point to the eye, of unit length. Unused for a matte surface.
    pub view: Vec3<S::Unit>,
}

impl<S: Scalar> SurfacePoint<S> {
    /// Creates a point of a matte surface, which looks the same from every side.
    #[inline]
    pub fn matte(point: Vec3<S::Length>, normal: Vec3<S>) -> Self {
        Self { point, normal, view: Vec3::default() }
    }

    /// Creates a point that is seen by an eye. The direction to the eye takes one square root per
    /// point, whatever the number of lights.
    #[inline]
    pub fn seen_from(eye: Vec3<S::Length>, point: Vec3<S::Length>, normal: Vec3<S>) -> Self {
        Self { point, normal, view: S::Offset::between(point, eye).ray().direction() }
    }
}

/// Light that arrives at a surface, not yet multiplied by the light's colours; 1 is full scale.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Incident<I> {
    /// The product of intensity, falloff, attenuation and Lambert's cosine.
    pub diffuse: I,
    /// The product of intensity, falloff, attenuation and the specular lobe.
    pub specular: I,
}

/// A compiled light of any kind: what a function takes that lights with all of them.
///
/// The trait is sealed: its types are the compiled lights of this crate.
///
/// ```
/// use luminaire::{Angle, Cone, Fx16, Length, PointLight, Rgb, SpotLight, Vec3, light::LightModel, number::Light16};
///
/// fn shade<L: LightModel<Fx16>>(lights: &[L], point: Vec3<Length>, normal: Vec3<Fx16>) -> Rgb<Light16> {
///     let lit = |light: &L| Rgb::lit(light.irradiance(point, normal), light.color());
///     lights.iter().map(lit).fold(Rgb::default(), |sum, light| sum + light)
/// }
///
/// let cone = Cone::soft(Angle::degrees(20.0))?;
/// let spots = [SpotLight::new([0.0, 2.0, 0.0], [0.0, -1.0, 0.0], cone)?.compile()?];
/// let points = vec![PointLight::new([0.0, 2.0, 0.0])?.compile()?; 2];
/// let (point, normal) = (Fx16::point([0.0, 0.0, 0.0]), Fx16::normal([0.0, 1.0, 0.0]));
/// let [one, two] = [shade(&spots, point, normal), shade(&points, point, normal)];
/// assert_eq!(one + one, two);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no compiled light",
    note = "a described light is compiled for a number format: `light.compile::<Fx16>()`"
)]
pub trait LightModel<S: Scalar>: Copy + core::fmt::Debug + sealed::Sealed {
    /// Returns the irradiance of a matte surface with this normal, of unit length, not yet multiplied by the
    /// light's colour.
    #[inline]
    fn irradiance(&self, point: Vec3<S::Length>, normal: Vec3<S>) -> S::Irradiance {
        self.evaluate::<NoSpecular>(&SurfacePoint::matte(point, normal), &(), true).diffuse
    }
    /// Returns the linear colour of the light.
    #[inline]
    fn color(&self) -> Rgb<S> {
        let [color, _] = self.colors();
        color
    }
    /// Returns the linear colours of the light: the diffuse and the specular colour.
    #[cfg_attr(not(feature = "arithmetic"), doc(hidden))]
    fn colors(&self) -> [Rgb<S>; 2];
    /// Computes the light at a surface whose specular lobe is of the type `H`.
    ///
    /// With `skips`, points that receive no light are rejected before the square root. The result
    /// is bit-identical with and without `skips`.
    #[cfg_attr(not(feature = "arithmetic"), doc(hidden))]
    fn evaluate<H: SpecularLobe>(
        &self,
        surface: &SurfacePoint<S>,
        highlight: &H::Constants<S>,
        skips: bool,
    ) -> Incident<S::Irradiance>;
    /// Sets the diffuse light at points of a matte surface, those of [`evaluate`](Self::evaluate).
    ///
    /// The points have the same y and z. Their x rises or falls with the index.
    #[cfg_attr(not(feature = "arithmetic"), doc(hidden))]
    #[inline]
    fn fill_along(
        &self,
        [y, z]: [S::Length; 2],
        x: impl Fn(usize) -> S::Length,
        normal: impl Fn(usize) -> Vec3<S>,
        arrived: &mut [S::Irradiance],
    ) {
        for (i, arrived) in arrived.iter_mut().enumerate() {
            let surface = SurfacePoint::matte(Vec3 { x: x(i), y, z }, normal(i));
            *arrived = self.evaluate::<NoSpecular>(&surface, &(), true).diffuse;
        }
    }
    /// Returns `false` only if no point within `radius` of `center` receives light.
    fn can_reach(&self, _center: Vec3<S::Length>, _radius: S::Length) -> bool {
        true
    }
}

pub(crate) mod sealed {
    /// Keeps other crates from implementing [`LightModel`](super::LightModel).
    pub trait Sealed {}
}

/// Returns the specular lobe if the light hits the front of a surface, else zero.
#[inline]
fn lobe<S: Scalar, H: SpecularLobe>(
    highlight: &H::Constants<S>,
    (normal, view): (Vec3<S>, Vec3<S::Unit>),
    incoming: Vec3<S::Unit>,
    cosine: S,
) -> S {
    if !H::SHINES {
        return S::ZERO;
    }
    let lobe = H::lobe(highlight, incoming, normal, view);
    if cosine > S::ZERO { lobe } else { S::ZERO }
}

/// Returns whether a cone with this position, axis and bound of the test for points outside may reach a
/// sphere.
fn reaches<S: Scalar>(
    position: Vec3<S::Length>,
    (axis, outside): (Vec3<S::Unit>, S),
    center: Vec3<S::Length>,
    radius: S::Length,
) -> bool {
    let tip = S::moved_back(position, axis, outside, radius);
    tip.is_none_or(|tip| !S::Offset::between(tip, center).is_center_outside(axis, outside))
}

/// A compiled cone and its axis.
type Aimed<'a, S, P> = (&'a CompiledCone<S, P>, Vec3<<S as Scalar>::Unit>);

/// Returns the light at a point near a bright light, or in a steep cone, by the fine evaluation.
///
/// Where the coarse evaluation shows that the light is clipped to full scale in any case, its light
/// is returned. `cone` is `None` for a light without a cone.
#[inline(always)]
fn evaluate_finely<S: Scalar, P: Falloff, A: Attenuation, H: SpecularLobe>(
    (attenuation, intensity, fine_below): (&A::Constants<S>, S::Gain, u32),
    cone: Option<Aimed<'_, S, P>>,
    (offset, facing): (&S::Offset, <S::Offset as Offset<S>>::Facing),
    (normal, view): (Vec3<S>, Vec3<S::Unit>),
    highlight: &H::Constants<S>,
) -> Incident<S::Irradiance> {
    let is_always_fine = fine_below == u32::MAX;
    let (mut lobe, mut coarse, mut keeps) = (S::ZERO, Incident::default(), [false; 2]);
    if H::SHINES || !is_always_fine {
        let ray = offset.ray();
        let cosine = ray.cosine(facing, normal);
        lobe = self::lobe::<S, H>(highlight, (normal, view), ray.direction(), cosine.value().scalar());
        let (shares, light) =
            along::<S, P, A, H, _>((attenuation, intensity), cone, (offset, &ray), cosine, lobe);
        let is_enough = |share, light| {
            !is_always_fine && S::is_clipped(A::windowed(attenuation, offset, &ray, share).scalar(), light)
        };
        keeps = [
            is_enough(shares.diffuse, light.diffuse),
            lobe == S::ZERO || is_enough(shares.specular, light.specular),
        ];
        coarse = light;
        if keeps == [true; 2] {
            return light;
        }
    }
    // The specular lobe stays that of the coarse direction: rounding the lobe to a scalar causes a
    // larger error than a finer direction would remove.
    let ray = S::fine_ray(offset);
    let cosine = ray.cosine(facing, normal);
    let (_, fine) = along::<S, P, A, H, _>((attenuation, intensity), cone, (offset, &ray), cosine, lobe);
    let [keeps_diffuse, keeps_specular] = keeps;
    Incident {
        diffuse: if keeps_diffuse { coarse.diffuse } else { fine.diffuse },
        specular: if keeps_specular { coarse.specular } else { fine.specular },
    }
}

/// Returns the light along a ray: as shares of the intensity, and as irradiances.
#[inline(always)] // `lit-table` on Cortex-M0: +29 instructions without.
fn along<S: Scalar, P: Falloff, A: Attenuation, H: SpecularLobe, R: Ray<S>>(
    (attenuation, intensity): (&A::Constants<S>, S::Gain),
    cone: Option<Aimed<'_, S, P>>,
    (offset, ray): (&S::Offset, &R),
    cosine: R::Fraction,
    lobe: S,
) -> (Incident<R::Share>, Incident<S::Irradiance>) {
    let light = |share| A::light(attenuation, offset, ray, share, intensity);
    let falloff = cone.map(|(cone, axis)| cone.toward(ray, axis));
    let share = falloff.map_or(cosine.value(), |falloff| cosine.times_value(falloff));
    let diffuse = Incident { diffuse: share, specular: R::Share::default() };
    let lit = Incident { diffuse: light(share), specular: S::Irradiance::default() };
    if !H::SHINES {
        return (diffuse, lit);
    }
    let lobe = R::Share::of_scalar(lobe);
    let share = falloff.map_or(lobe, |falloff| falloff.times(lobe));
    (Incident { specular: share, ..diffuse }, Incident { specular: light(share), ..lit })
}
