//! What stands on the stage: meshes, their materials, and the light that is everywhere.

use crate::mesh::{Mesh, check_channels};
use alloc::vec::Vec;
use luminaire::{
    Error, Rgb,
    display::decode_srgb,
    dynamic::{Effect, RenderPlan},
    error::Parameter,
    haze::Haze,
    specular::{DifferenceForm, MirroredPhong, SpecularLobe},
};

/// The kind of highlight that surfaces have: Phong's, in the form that takes the same few steps whatever the shininess.
pub type Highlight = DifferenceForm<MirroredPhong, 3>;

/// How a surface answers to light.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub struct Material {
    albedo: Rgb<f32>,
    specular: Rgb<f32>,
    shininess: u32,
}

impl Material {
    /// A matt surface of this linear albedo.
    ///
    /// # Errors
    /// A channel outside [0, 1].
    pub fn new(albedo: Rgb<f32>) -> Result<Self, Error> {
        check_color(Parameter::Albedo, albedo, 1.0)?;
        Ok(Self::matt(albedo))
    }

    fn matt(albedo: Rgb<f32>) -> Self {
        Self { albedo, specular: Rgb::default(), shininess: Highlight::LEAST_SHININESS }
    }

    /// The same surface without a highlight.
    pub fn without_highlight(self) -> Self {
        Self::matt(self.albedo)
    }

    /// The part of the light that the surface sends back, linear, in [0, 1].
    pub fn albedo(&self) -> Rgb<f32> {
        self.albedo
    }

    /// The same surface with a highlight of this linear colour and shininess.
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

    /// The linear colour of the highlight.
    pub fn specular(&self) -> Rgb<f32> {
        self.specular
    }

    /// The exponent of the highlight.
    pub fn shininess(&self) -> u32 {
        self.shininess
    }

    /// Whether there is a highlight.
    pub fn shines(&self) -> bool {
        self.specular != Rgb::default()
    }

    /// A matt surface that shows these sRGB codes under white light of full scale.
    pub fn srgb(red: u8, green: u8, blue: u8) -> Self {
        Self::matt(Rgb::new(red, green, blue).map(decode_srgb))
    }
}

fn check_color(parameter: Parameter, color: Rgb<f32>, most: f32) -> Result<(), Error> {
    check_channels(parameter, [color.red, color.green, color.blue], 0.0, most)
}

/// Black and matt.
impl Default for Material {
    fn default() -> Self {
        Self::matt(Rgb::default())
    }
}

/// Meshes with their materials, and a colour of ambient light.
#[derive(Clone, PartialEq, Debug)]
pub struct Scene {
    objects: Vec<Object>,
    ambient: Rgb<f32>,
    haze: Option<Haze>,
    fingerprint: Fingerprint,
}

/// A mesh of one material.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Object {
    pub(crate) mesh: Mesh,
    pub(crate) material: Material,
}

/// What tells the meshes of two scenes apart without a look at their vertices: FNV-1a, 64 bits of it, over all that
/// was added.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Fingerprint(u64);

impl Scene {
    /// An empty scene without ambient light.
    pub fn new() -> Self {
        let fingerprint = Fingerprint(0xcbf2_9ce4_8422_2325);
        Self { objects: Vec::new(), ambient: Rgb::default(), haze: None, fingerprint }
    }

    /// Adds a mesh of one material.
    ///
    /// # Errors
    /// A coordinate of a vertex beyond [`Mesh::FARTHEST`], or NaN; more vertices than [`Mesh::MOST_VERTICES`], or segments
    /// or lines that would make as many. The scene stays as it was.
    pub fn add(&mut self, mesh: Mesh, material: Material) -> Result<(), Error> {
        mesh.check()?;
        // Where an object ends is part of the picture: materials go by objects.
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

    /// Sets the ambient light: the linear colour that reaches every surface from everywhere, 1 being full scale.
    ///
    /// # Errors
    /// A channel outside [0, 1e9]. The scene stays as it was.
    pub fn set_ambient(&mut self, color: Rgb<f32>) -> Result<(), Error> {
        check_color(Parameter::AmbientLight, color, 1e9)?;
        self.ambient = color;
        Ok(())
    }

    /// The ambient light.
    pub fn ambient(&self) -> Rgb<f32> {
        self.ambient
    }

    /// Gives each object the material that `paint` makes of its own.
    pub fn repaint(&mut self, paint: impl Fn(&Material) -> Material) {
        for object in &mut self.objects {
            object.material = paint(&object.material);
        }
    }

    /// Fills the scene with haze, or with clear air.
    pub fn set_haze(&mut self, haze: Option<Haze>) {
        self.haze = haze;
    }

    /// The haze; nothing in clear air.
    pub fn haze(&self) -> Option<Haze> {
        self.haze
    }

    /// The plan of a picture of the scene before there is a light in it: ambient light, highlights and haze, where it has any.
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

    /// How many triangles the meshes have together.
    pub fn triangle_count(&self) -> usize {
        self.objects.iter().map(|object| object.mesh.triangle_count()).sum()
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
