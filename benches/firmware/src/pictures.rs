//! Pictures of the renderer, lit again pixel by pixel by the kernel alone.
//!
//! The build script draws them in `Fx16`. The program has the points, normals and materials of their pixels,
//! their shadow maps and compiled lights, and no float. The renderer has its haze in floats: the pixels of a picture in
//! haze are those that the build script draws with the kernel on the host.

use bytemuck::cast_slice;
use luminaire::{
    Fx16, Length, Rgb, Scalar, Vec3,
    attenuation::AnyAttenuation,
    display::{Pixel as _, Rgb565, clip, compress_keep_hue, encode_srgb},
    falloff::AnyFalloff,
    haze::BeamScattering16,
    light::{CompiledSpotLight, LightModel as _, SurfacePoint},
    number::Light16,
    projector::{CompiledGobo, CompiledProjection, Shadow},
    specular::{DifferenceForm, MirroredPhong, SpecularLobe},
};

use crate::board::{begin, end, println};

/// The highlight of all surfaces.
type Highlight = DifferenceForm<MirroredPhong, 3>;

/// A light with its gobo, its shadow map: projection, side in texels and depths; and its beam in haze.
struct Fixture {
    light: CompiledSpotLight<Fx16, AnyFalloff, AnyAttenuation>,
    gobo: Option<CompiledGobo<'static, Fx16>>,
    shadow: Option<(CompiledProjection<Fx16>, u32, &'static [u8])>,
    beam: Option<BeamScattering16<AnyFalloff>>,
}

/// A material: its albedo, and the colour and the constants of its highlight.
struct Finish {
    albedo: Rgb<Fx16>,
    highlight: Option<(Rgb<Fx16>, <Highlight as SpecularLobe>::Constants<Fx16>)>,
}

/// A picture: how it is lit, its pixels, and the codes of red, green and blue that the renderer has encoded.
struct Picture {
    name: &'static str,
    width: usize,
    eye: Vec3<Length>,
    ambient: Rgb<Light16>,
    fixtures: &'static [Fixture],
    finishes: &'static [Finish],
    keeps_hue: bool,
    encode: fn(Rgb<Fx16>, u32, u32) -> Rgb<u8>,
    points: &'static [u8],
    normals: &'static [u8],
    materials: &'static [u8],
    codes: &'static [u8],
}

/// Bytes that are read as numbers of 32 bits.
#[repr(C, align(4))]
struct Aligned<T: ?Sized>(T);

/// The bytes of a file that the build script has written.
macro_rules! file {
    ($name:literal) => {{
        const FILE: &Aligned<[u8]> = &Aligned(*include_bytes!(concat!(env!("OUT_DIR"), "/", $name)));
        &FILE.0
    }};
}

static PICTURES: [Picture; 8] = include!(concat!(env!("OUT_DIR"), "/pictures.rs"));

/// Lights every pixel of every picture, and prints for each picture the number of pixels, how many of them
/// differ from the renderer's, and the place of the first of these.
pub fn pictures() {
    for picture in &PICTURES {
        begin();
        let (different, first) = picture.compare();
        end();
        println!("{} {} pixels", picture.name, picture.materials.len());
        println!("{} {different} different", picture.name);
        if let Some(pixel) = first {
            println!("{} {}:{} first", picture.name, pixel % picture.width, pixel / picture.width);
        }
    }
}

impl Picture {
    /// Returns the number of pixels that differ from those of the renderer, and the index of the first of these.
    #[inline(never)]
    fn compare(&self) -> (usize, Option<usize>) {
        let pixels = cast_slice(self.points).iter().zip(cast_slice(self.normals)).zip(self.materials);
        let codes = self.codes.chunks_exact(3);
        let (mut different, mut first) = (0, None);
        for (index, (((point, normal), material), expected)) in pixels.zip(codes).enumerate() {
            let light =
                self.light(*point, *normal, &self.finishes[usize::from(*material)]) + self.air(*point);
            let color = if self.keeps_hue { compress_keep_hue(light) } else { clip(light) };
            let place = [index % self.width, index / self.width].map(|place| place as u32);
            let Rgb { red, green, blue } = (self.encode)(color, place[0], place[1]);
            if [red, green, blue] != *expected {
                different += 1;
                first = first.or(Some(index));
            }
        }
        (different, first)
    }

    /// Returns the light that the haze scatters to the eye before a surface point.
    fn air(&self, point: Vec3<Length>) -> Rgb<Light16> {
        let mut light = Rgb::default();
        for fixture in self.fixtures {
            if let Some(beam) = &fixture.beam {
                light += Rgb::lit(beam.in_scattering(self.eye, point), fixture.light.color());
            }
        }
        light
    }

    /// Returns the light that a surface point reflects to the eye.
    fn light(&self, point: Vec3<Length>, normal: Vec3<Fx16>, finish: &Finish) -> Rgb<Light16> {
        let (mut diffuse, mut specular) = (self.ambient, Rgb::default());
        let surface = if finish.highlight.is_some() {
            let SurfacePoint { view, .. } = SurfacePoint::<Fx16>::seen_from(self.eye, point, normal);
            SurfacePoint { point, normal, view: mirrored::<Fx16>(view, normal) }
        } else {
            SurfacePoint::matte(point, normal)
        };
        for fixture in self.fixtures {
            let Some((_, constants)) = &finish.highlight else {
                let arrived = fixture.filter(fixture.light.irradiance(point, normal), point);
                diffuse += Rgb::lit(arrived, fixture.light.color());
                continue;
            };
            let arrived = fixture.light.evaluate::<Highlight>(&surface, constants, true);
            diffuse += Rgb::lit(fixture.filter(arrived.diffuse, point), fixture.light.color());
            specular += Rgb::lit(fixture.filter(arrived.specular, point), fixture.light.specular_color());
        }
        let reflected = diffuse.filtered(finish.albedo);
        finish.highlight.map_or(reflected, |(color, _)| reflected + specular.filtered(color))
    }
}

impl Fixture {
    /// Attenuates light at a point by the gobo and the shadow map.
    fn filter(&self, light: Light16, point: Vec3<Length>) -> Light16 {
        if light == Light16::ZERO {
            return light;
        }
        let light = self.gobo.map_or(light, |gobo| gobo.filter(light, point));
        self.shadow.map_or(light, |(square, side, depths)| {
            Shadow::from_parts(square, side, cast_slice(depths)).filter(light, point)
        })
    }
}

/// Returns a view direction that is mirrored at a surface.
fn mirrored<S: Scalar>(view: Vec3<S::Unit>, normal: Vec3<S>) -> Vec3<S::Unit> {
    S::mirror(view, normal)
}

/// Returns the codes of a display with 24 bits.
fn srgb(color: Rgb<Fx16>, _: u32, _: u32) -> Rgb<u8> {
    color.map(encode_srgb)
}

/// Returns the codes of a display with 16 bits, with dither.
fn rgb565_dithered(color: Rgb<Fx16>, x: u32, y: u32) -> Rgb<u8> {
    Rgb565::dithered(color, x, y).to_codes()
}
