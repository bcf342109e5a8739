//! A scene: meshes, their materials, ambient light and haze.

pub(crate) mod camera;
pub(crate) mod mesh;
pub(crate) mod outline;
pub(crate) mod strip;
pub(crate) mod surfaces;

use crate::scene::{
    mesh::{Mesh, check_channels},
    outline::Outline,
    strip::Strip,
};
use alloc::vec::Vec;
use core::f32::consts::PI;
use luminaire::{
    Error, Rgb,
    display::decode_srgb,
    dynamic::{Effect, RenderPlan},
    error::Parameter,
    haze::Haze,
    specular::{DifferenceForm, MirroredPhong, SpecularLobe},
};

/// The specular lobe of all surfaces: Phong's lobe in Lyon's difference form, whose cost does not
/// depend on the shininess.
pub type Highlight = DifferenceForm<MirroredPhong, 3>;

/// The reflectance of a surface.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub struct Material {
    albedo: Rgb<f32>,
    specular: Rgb<f32>,
    shininess: u32,
}

impl Material {
    /// Creates a matte surface of this linear albedo.
    ///
    /// # Errors
    /// A channel outside [0, 1].
    pub fn new(albedo: Rgb<f32>) -> Result<Self, Error> {
        check_color(Parameter::Albedo, albedo, 1.0)?;
        Ok(Self::matte(albedo))
    }

    fn matte(albedo: Rgb<f32>) -> Self {
        Self { albedo, specular: Rgb::default(), shininess: Highlight::LEAST_SHININESS }
    }

    /// Returns the same surface without a highlight.
    #[must_use]
    pub fn without_highlight(self) -> Self {
        Self::matte(self.albedo)
    }

    /// Returns the share of light that the surface reflects, linear, in [0, 1].
    pub fn albedo(&self) -> Rgb<f32> {
        self.albedo
    }

    /// Returns the same surface with a highlight of this linear colour and shininess.
    ///
    /// # Errors
    /// A channel outside [0, 1]; a shininess under 8 or over 1024.
    pub fn with_highlight(self, specular: Rgb<f32>, shininess: u32) -> Result<Self, Error> {
        luminaire::Material::new(Rgb::default())?.with_highlight(
            DifferenceForm::<_, 3>(MirroredPhong),
            specular,
            shininess,
        )?;
        Ok(Self { specular, shininess, ..self })
    }

    /// Returns the linear colour of the highlight.
    pub fn specular(&self) -> Rgb<f32> {
        self.specular
    }

    /// Returns the shininess, the exponent of the highlight.
    pub fn shininess(&self) -> u32 {
        self.shininess
    }

    /// Returns whether the surface has a highlight.
    pub fn shines(&self) -> bool {
        self.specular != Rgb::default()
    }

    /// Creates a matte surface that shows this sRGB colour under white light of full scale.
    pub fn srgb(red: u8, green: u8, blue: u8) -> Self {
        Self::matte(Rgb::new(red, green, blue).map(decode_srgb))
    }
}

fn check_color(parameter: Parameter, color: Rgb<f32>, most: f32) -> Result<(), Error> {
    check_channels(parameter, [color.red, color.green, color.blue], 0.0, most)
}

/// The default material is black and matte.
impl Default for Material {
    fn default() -> Self {
        Self::matte(Rgb::default())
    }
}

/// Meshes with their materials, ambient light and haze.
#[derive(Clone, PartialEq, Debug)]
pub struct Scene {
    objects: Vec<Object>,
    ambient: Rgb<f32>,
    haze: Option<Haze>,
    /// The strip, and the index of the object that is its first LED.
    strip: Option<(usize, Strip)>,
    fingerprint: Fingerprint,
}

/// A mesh of one material.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Object {
    pub(crate) mesh: Mesh,
    pub(crate) material: Material,
}

/// FNV-1a hash of 64 bits over all meshes. Scenes are compared by this hash without reading their
/// vertices.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Fingerprint(u64);

impl Scene {
    /// Creates an empty scene without ambient light.
    pub fn new() -> Self {
        let fingerprint = Fingerprint(0xcbf2_9ce4_8422_2325);
        Self { objects: Vec::new(), ambient: Rgb::default(), haze: None, strip: None, fingerprint }
    }

    /// Adds a mesh of one material.
    ///
    /// # Errors
    /// A coordinate of a vertex that is NaN or beyond [`Mesh::FARTHEST`]; more vertices than
    /// [`Mesh::MOST_VERTICES`], or a number of segments or lines that would give more vertices.
    /// After an error the scene is unchanged.
    pub fn add(&mut self, mesh: Mesh, material: Material) -> Result<(), Error> {
        mesh.check()?;
        // The counts separate the objects, because each object has its own material.
        self.fingerprint.add([mesh.vertices().len() as u32, mesh.triangle_count() as u32, 0]);
        for vertex in mesh.vertices() {
            self.fingerprint.add(vertex.position.to_array().map(f32::to_bits));
            self.fingerprint.add(vertex.normal.to_array().map(f32::to_bits));
        }
        for &triangle in mesh.triangles() {
            self.fingerprint.add(triangle);
        }
        self.objects.push(Object { mesh, material });
        Ok(())
    }

    /// Adds a small sphere of this radius in metres for each LED of a strip. Only the LEDs of the strip
    /// that was added last emit light.
    ///
    /// # Errors
    /// A coordinate that is NaN or beyond [`Mesh::FARTHEST`].
    pub fn add_strip(&mut self, strip: Strip, radius: f32) -> Result<(), Error> {
        let first = self.objects.len();
        let sphere = Mesh::lathe(&Outline::start(0.0, -radius).arc(0.0, 0.0, PI, 4), 8);
        for &place in strip.places() {
            self.add(sphere.clone().moved(place), Material::default())?;
        }
        self.strip = Some((first, strip));
        Ok(())
    }

    /// Returns the strip of LEDs that was added last.
    pub fn strip(&self) -> Option<&Strip> {
        self.strip.as_ref().map(|(_, strip)| strip)
    }

    /// Returns the strip, and the index of the object that is its first LED.
    pub(crate) fn led_objects(&self) -> Option<&(usize, Strip)> {
        self.strip.as_ref()
    }

    /// Sets the ambient light: the linear light that reaches every surface from all directions. 1
    /// is full scale.
    ///
    /// # Errors
    /// A channel outside [0, 1e9]. After an error the scene is unchanged.
    pub fn set_ambient(&mut self, color: Rgb<f32>) -> Result<(), Error> {
        check_color(Parameter::AmbientLight, color, 1e9)?;
        self.ambient = color;
        Ok(())
    }

    /// Returns the ambient light.
    pub fn ambient(&self) -> Rgb<f32> {
        self.ambient
    }

    /// Replaces the material of each object by the result of `paint` for the material.
    pub fn repaint(&mut self, paint: impl Fn(&Material) -> Material) {
        for object in &mut self.objects {
            object.material = paint(&object.material);
        }
    }

    /// Sets the haze of the scene; `None` for clear air.
    pub fn set_haze(&mut self, haze: Option<Haze>) {
        self.haze = haze;
    }

    /// Returns the haze; `None` in clear air.
    pub fn haze(&self) -> Option<Haze> {
        self.haze
    }

    /// Returns the plan of the scene without its lights.
    ///
    /// The plan requires ambient light, highlights and haze if the scene has these effects.
    pub fn plan(&self) -> RenderPlan {
        let mut plan = RenderPlan::new();
        if self.ambient != Rgb::default() {
            plan = plan.with(Effect::Ambient);
        }
        if self.objects.iter().any(|object| object.material.shines()) {
            plan = plan.with(Effect::Specular);
        }
        if self.haze.is_some_and(|haze| haze.density() > 0.0) {
            plan = plan.with(Effect::Haze);
        }
        plan
    }

    /// Returns the number of triangles of all meshes.
    pub fn triangle_count(&self) -> usize {
        self.objects.iter().map(|object| object.mesh.triangle_count()).sum()
    }

    /// Returns the meshes with their materials, in the order in which they were added.
    pub fn meshes(&self) -> impl Iterator<Item = (&Mesh, &Material)> {
        self.objects.iter().map(|object| (&object.mesh, &object.material))
    }

    pub(crate) fn objects(&self) -> &[Object] {
        &self.objects
    }

    pub(crate) fn fingerprint(&self) -> Fingerprint {
        self.fingerprint
    }
}

impl Default for Scene {
    fn default() -> Self {
        Self::new()
    }
}

impl Fingerprint {
    fn add(&mut self, words: [u32; 3]) {
        for word in words {
            self.0 = (self.0 ^ u64::from(word)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
}
