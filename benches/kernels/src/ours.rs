//! The crate `luminaire`, as it is.

use core::marker::PhantomData;

use luminaire::{
    Fx16, Scalar, SpotLight, Vec3,
    falloff::{ListedFalloff, Soft},
    light::{CompiledCone, CompiledSpotLight, LightModel, SurfacePoint},
    number::Length,
    specular::{NoSpecular, Phong, SpecularLobe},
};

use crate::{
    kernel::Kernel,
    scene::{EYE, Site},
    value::Format,
};

/// A compiled cone.
#[derive(Clone, Copy, Debug)]
pub struct OurFalloff<S: Scalar, P: ListedFalloff> {
    falloff: CompiledCone<S, P>,
    outer: f32,
}

impl<S: Scalar, P: ListedFalloff> OurFalloff<S, P> {
    /// The falloff of a cone that ends at this versine.
    pub fn new(falloff: CompiledCone<S, P>, outer: f32) -> Self {
        Self { falloff, outer }
    }
}

impl<S: Format, P: ListedFalloff> Kernel for OurFalloff<S, P> {
    type Place = f32;
    type Input = S::Versine;
    type Output = S;

    fn input(&self, versine: &f32) -> S::Versine {
        self.falloff.versine(*versine)
    }

    #[inline(always)]
    fn evaluate(&self, versine: &S::Versine) -> S {
        self.falloff.at(*versine)
    }

    #[inline(always)]
    fn touch(versine: &S::Versine) -> u32 {
        S::versine_bits(*versine)
    }

    fn bounds(&self, visit: &mut dyn FnMut(S::Versine, f64)) -> bool {
        S::bounds(self.outer, visit);
        S::COUNTABLE
    }
}

/// A site in the types of a format.
#[derive(Clone, Copy, Debug)]
pub struct Stored<S: Scalar> {
    point: Vec3<S::Length>,
    normal: Vec3<S>,
}

impl<S: Format> Stored<S> {
    pub(crate) fn new(site: &Site) -> Self {
        Self { point: site.point.map(S::length), normal: site.normal.map(S::from_f32) }
    }

    #[inline(always)]
    pub(crate) fn touch(&self) -> u32 {
        S::length_bits(self.point.x)
    }
}

impl Stored<Fx16> {
    /// The point in steps of 2^-16 and the normal in steps of 2^-14.
    #[inline(always)]
    pub(crate) fn words(&self) -> ([i32; 3], [i16; 3]) {
        let (point, normal) = (self.point.map(Length::to_bits), self.normal.map(Fx16::to_bits));
        ([point.x, point.y, point.z], [normal.x, normal.y, normal.z])
    }
}

impl Stored<f32> {
    /// The point and the normal.
    #[inline(always)]
    pub(crate) fn words(&self) -> (Vec3<f32>, Vec3<f32>) {
        (self.point, self.normal)
    }
}

/// A compiled light, and Lambert's cosine.
#[derive(Clone, Copy, Debug)]
pub struct OurPoint<S, L> {
    light: L,
    format: PhantomData<S>,
}

impl<S: Format, L: LightModel<S>> OurPoint<S, L> {
    /// The points that this light lights.
    pub fn new(light: L) -> Self {
        Self { light, format: PhantomData }
    }
}

impl<S: Format, L: LightModel<S>> Kernel for OurPoint<S, L> {
    type Place = Site;
    type Input = Stored<S>;
    type Output = S::Irradiance;

    fn input(&self, site: &Site) -> Stored<S> {
        Stored::new(site)
    }

    #[inline(always)]
    fn evaluate(&self, site: &Stored<S>) -> S::Irradiance {
        self.light.evaluate::<NoSpecular>(&SurfacePoint::matte(site.point, site.normal), &(), true).diffuse
    }

    #[inline(always)]
    fn touch(site: &Stored<S>) -> u32 {
        site.touch()
    }
}

/// The same with Phong's specular lobe, in one channel: the direction to the eye, the diffuse and
/// the specular reflection and their colours.
#[derive(Clone, Copy, Debug)]
pub struct Highlit<S: Scalar> {
    light: CompiledSpotLight<S, Soft>,
    highlight: <Phong as SpecularLobe>::Constants<S>,
    eye: Vec3<S::Length>,
    diffuse: S,
    specular: S,
}

impl<S: Format> Highlit<S> {
    /// The diffuse reflectance: the same number in every format.
    pub const DIFFUSE: f32 = 0.625;
    /// The specular reflectance: the same number in every format.
    pub const SPECULAR: f32 = 0.375;
    /// The exponent.
    pub const SHININESS: u32 = 32;

    /// The points that this light lights, seen from the eye of the scene.
    ///
    /// # Errors
    /// A cone that the format cannot hold.
    pub fn new(spot: &SpotLight<Soft>) -> Result<Self, luminaire::Error> {
        Ok(Self {
            light: spot.compile()?,
            highlight: Phong::constants::<S>(Self::SHININESS),
            eye: EYE.map(S::length),
            diffuse: S::from_f32(Self::DIFFUSE),
            specular: S::from_f32(Self::SPECULAR),
        })
    }
}

impl<S: Format> Kernel for Highlit<S> {
    type Place = Site;
    type Input = Stored<S>;
    type Output = S::Irradiance;

    fn input(&self, site: &Site) -> Stored<S> {
        Stored::new(site)
    }

    #[inline(always)]
    fn evaluate(&self, site: &Stored<S>) -> S::Irradiance {
        let surface = SurfacePoint::seen_from(self.eye, site.point, site.normal);
        let arrival = self.light.evaluate::<Phong>(&surface, &self.highlight, true);
        S::filter(arrival.diffuse, self.diffuse) + S::filter(arrival.specular, self.specular)
    }

    #[inline(always)]
    fn touch(site: &Stored<S>) -> u32 {
        site.touch()
    }
}
