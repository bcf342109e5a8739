//! Materials: how a surface reflects and emits light.

use crate::{
    color::{Rgb, checked_color},
    display::clip,
    error::{Error, Expected, Parameter},
    number::Scalar,
    points::SurfacePoint,
    shade::LightModel,
    specular::{NoSpecular, SpecularLobe},
};

/// A material: the ambient, diffuse and specular reflectance of a surface, and its emission.
///
/// The material describes the surface in the classic lighting equation. The sum is over all lights:
///
/// `I = emissive + ambient Ia + sum of f(d) spot [diffuse Is max(0, N.L) + specular Is lobe]`
///
/// The type selects the specular lobe; [`NoSpecular`] costs nothing.
///
/// ```
/// use luminaire::{Angle, Cone, Material, Rgb, SpotLight, Vec3, falloff::Soft, light::SurfacePoint, specular::BlinnPhong};
/// let red = Material::new(Rgb::new(0.8, 0.1, 0.1))?;
/// let glazed = red.with_highlight(BlinnPhong, Rgb::new(0.5, 0.5, 0.5), 64)?.compile::<f32>();
/// let cone = Cone::from_field(Soft, Angle::degrees(30.0))?;
/// let spot = SpotLight::new(Vec3::new(0.0, 2.0, 0.0), Vec3::new(0.0, -1.0, 0.0), cone)?.with_intensity(4.0)?;
/// let (floor, up) = (Vec3::new(0.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
/// let surface = SurfacePoint::seen_from(Vec3::new(0.0, 3.0, 0.0), floor, up);
/// let light = glazed.reflect(&surface, &spot.compile()?);
/// assert!((light.red - 1.3).abs() < 1e-5 && (light.green - 0.6).abs() < 1e-5);
/// # Ok::<(), luminaire::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Material<H = NoSpecular> {
    ambient: Rgb<f32>,
    diffuse: Rgb<f32>,
    emissive: Rgb<f32>,
    specular: Rgb<f32>,
    shininess: u32,
    highlight: H,
}

/// The largest shininess. At a shininess of 1024, half the light of the lobe is within four
/// degrees.
const SHINIEST: u32 = 1024;

impl Material {
    /// Creates a matte material with this diffuse and ambient reflectance and without emission.
    ///
    /// # Errors
    /// A channel outside [0, 1].
    pub fn new(diffuse: Rgb<f32>) -> Result<Self, Error> {
        checked_color(diffuse)?;
        let dark = Rgb::default();
        let (ambient, emissive, specular) = (diffuse, dark, dark);
        Ok(Self { ambient, diffuse, emissive, specular, shininess: 0, highlight: NoSpecular })
    }
}

impl<H: SpecularLobe> Material<H> {
    /// Returns the material with a specular lobe, its linear colour and its shininess (the
    /// exponent).
    ///
    /// # Errors
    /// A channel outside [0, 1]; a shininess over 1024 or under the minimum of the lobe. This
    /// minimum is 1, except for [`DifferenceForm`](crate::specular::DifferenceForm).
    pub fn with_highlight<K: SpecularLobe>(
        &self,
        highlight: K,
        specular: Rgb<f32>,
        shininess: u32,
    ) -> Result<Material<K>, Error> {
        checked_color(specular)?;
        if !(K::LEAST_SHININESS..=SHINIEST).contains(&shininess) {
            return Err(Error {
                parameter: Parameter::Shininess,
                value: shininess as f32,
                accepted: Expected::WholeBetween(K::LEAST_SHININESS, SHINIEST),
            });
        }
        let Self { ambient, diffuse, emissive, .. } = *self;
        Ok(Material { ambient, diffuse, emissive, specular, shininess, highlight })
    }

    /// Returns the material with another ambient reflectance.
    ///
    /// # Errors
    /// A channel outside [0, 1].
    pub fn with_ambient(self, ambient: Rgb<f32>) -> Result<Self, Error> {
        Ok(Self { ambient: checked_color(ambient)?, ..self })
    }

    /// Returns the material with this emission: linear, 1 is full scale.
    ///
    /// # Errors
    /// A channel outside [0, 1].
    pub fn with_emissive(self, emissive: Rgb<f32>) -> Result<Self, Error> {
        Ok(Self { emissive: checked_color(emissive)?, ..self })
    }

    /// Returns the ambient reflectance, linear.
    pub fn ambient(&self) -> Rgb<f32> {
        self.ambient
    }

    /// Returns the diffuse reflectance, linear.
    pub fn diffuse(&self) -> Rgb<f32> {
        self.diffuse
    }

    /// Returns the emission, linear.
    pub fn emissive(&self) -> Rgb<f32> {
        self.emissive
    }

    /// Returns the specular reflectance, linear.
    pub fn specular(&self) -> Rgb<f32> {
        self.specular
    }

    /// Returns the exponent of the specular lobe.
    pub fn shininess(&self) -> u32 {
        self.shininess
    }

    /// Compiles the material for the format `S`.
    pub fn compile<S: Scalar>(&self) -> CompiledMaterial<S, H> {
        CompiledMaterial {
            ambient: self.ambient.map(S::from_f32),
            diffuse: self.diffuse.map(S::from_f32),
            emissive: self.emissive.map(|channel| S::ONE.light(S::gain(channel))),
            specular: self.specular.map(S::from_f32),
            highlight: H::constants::<S>(self.shininess),
        }
    }
}

/// A material compiled for the format `S`. Made by [`Material::compile`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompiledMaterial<S: Scalar, H: SpecularLobe = NoSpecular> {
    pub(crate) ambient: Rgb<S>,
    pub(crate) diffuse: Rgb<S>,
    pub(crate) emissive: Rgb<S::Irradiance>,
    pub(crate) specular: Rgb<S>,
    pub(crate) highlight: H::Constants<S>,
}

impl<S: Scalar, H: SpecularLobe> CompiledMaterial<S, H> {
    /// Creates the material from its parts, as [`codegen`](crate::codegen) writes them.
    pub const fn from_parts(
        ambient: Rgb<S>,
        diffuse: Rgb<S>,
        emissive: Rgb<S::Irradiance>,
        specular: Rgb<S>,
        highlight: H::Constants<S>,
    ) -> Self {
        Self { ambient, diffuse, emissive, specular, highlight }
    }

    /// Returns the emitted light and the reflected ambient light: `emissive + ambient Ia`, with
    /// `Ia` from [`AmbientLight::compile`](crate::AmbientLight::compile).
    #[inline]
    pub fn glow(&self, ambient: Rgb<S::Irradiance>) -> Rgb<S::Irradiance> {
        self.emissive + ambient.filtered::<S>(self.ambient)
    }

    /// Returns the reflected light of one compiled light:
    /// `f(d) spot [diffuse Is max(0, N.L) + specular Is lobe]`.
    ///
    /// Points that the light cannot reach return 0 before the square root. The result is
    /// bit-identical to that of [`reflect_unskipped`](Self::reflect_unskipped).
    #[inline]
    pub fn reflect<L: LightModel<S>>(&self, surface: &SurfacePoint<S>, light: &L) -> Rgb<S::Irradiance> {
        self.reflected(surface, light, true)
    }

    /// Returns the result of [`reflect`](Self::reflect) without early-outs: every point takes every
    /// step of the computation.
    #[inline]
    pub fn reflect_unskipped<L: LightModel<S>>(
        &self,
        surface: &SurfacePoint<S>,
        light: &L,
    ) -> Rgb<S::Irradiance> {
        self.reflected(surface, light, false)
    }

    /// Returns the linear colour of a surface point under all lights, clipped to [0, 1]: the glow
    /// plus the reflected light of each light.
    #[inline]
    pub fn color<L: LightModel<S>>(
        &self,
        surface: &SurfacePoint<S>,
        lights: &[L],
        ambient: Rgb<S::Irradiance>,
    ) -> Rgb<S> {
        let reflected = lights.iter().map(|light| self.reflect(surface, light));
        clip(reflected.fold(self.glow(ambient), |sum, light| sum + light))
    }

    #[inline]
    fn reflected<L: LightModel<S>>(
        &self,
        surface: &SurfacePoint<S>,
        light: &L,
        skips: bool,
    ) -> Rgb<S::Irradiance> {
        let arrived = light.evaluate::<H>(surface, &self.highlight, skips);
        let [color, specular_color] = light.colors();
        let diffuse = Rgb::lit::<S>(arrived.diffuse, color).filtered::<S>(self.diffuse);
        if !H::SHINES {
            return diffuse;
        }
        let specular = Rgb::lit::<S>(arrived.specular, specular_color).filtered::<S>(self.specular);
        diffuse + specular
    }
}
