//! The command line.

use std::ffi::OsString;
use std::path::PathBuf;

use luminaire::Rgb;
use luminaire_pick::{Attenuation, Chip, Display, Edge, Light, Refusal, Tolerance};

use crate::leds::Leds;
use crate::model;
use crate::source::{ELSEWHERE, Source, Spot, vector};
use crate::words::Target;

/// What `luminaire --help` ends with.
const EXAMPLES: &str = "\
A data sheet to a header for C:   luminaire export --beam 15 --field 26 --lumens 8700 --to c-fx16 --name key
A photometric file to Blender:    luminaire export --from spot.ies --to blender
A light of Godot to a shader:     luminaire export --from godot spot_angle=25 spot_attenuation=1.4 --to glsl
What the files of a folder say:   luminaire import lights

With --from and a tool, KEY=VALUE are its numbers. Other words are files, which --from says the kind of if their
extension does not. A file or a light that is refused does not stop the others.

The exit code is 0, or 1 if something was refused, or 2 for a wrong option.";

/// Spotlights from the angles of a data sheet, and lights from the files and numbers of other tools: their
/// cheapest evaluation on a chip, their source in other languages, their parameters in other tools.
#[derive(Debug, clap::Parser)]
#[command(name = "luminaire", version, disable_help_subcommand = true, arg_required_else_help = true, after_help = EXAMPLES)]
pub(crate) enum Command {
    /// Show the lights of files, or of the numbers of another tool or a data sheet
    Import(Box<Import>),
    /// Draw a white wall that lights shine on, as a PNG
    Still(Box<Still>),
    /// Pick the cheapest evaluation of a light whose error is small enough for a display
    Pick(Box<Pick>),
    /// Write lights as source of another language, or as the parameters of another tool
    Export(Box<Export>),
    /// Write a program that lights LEDs at the places of a map, for Arduino, ESP-IDF or Rust
    Leds(Box<Leds>),
}

/// The options of `pick`.
#[derive(Debug, clap::Args)]
pub(crate) struct Pick {
    /// cortex-m0, cortex-m3, cortex-m4f, rv32imc, cortex-m7, cortex-m33 or hazard3; or a part with one of them, such as
    /// rp2040, rp2350, stm32f411, nrf52840 or esp32-c3
    #[arg(long, value_parser = Chip::of_part)]
    pub(crate) chip: Chip,
    /// gray1, gray2, gray4, gray8, rgb332, rgb444, rgb555, rgb565, rgb666, rgb888, ws2812-8, pwm-10, pwm-12 or
    /// pwm-16
    #[arg(long)]
    pub(crate) display: Display,
    /// Largest error in steps of the display, after its encoding [default: 1]
    #[arg(long, conflicts_with = "codes")]
    steps: Option<f64>,
    /// Largest error in linear codes, 1/255 of full scale
    #[arg(long)]
    codes: Option<f64>,
    /// Pick by the worst case of a point in place of the mean
    #[arg(long)]
    pub(crate) worst: bool,
    /// soft or hard [default: soft]
    #[arg(long, conflicts_with_all = ELSEWHERE, conflicts_with = "falloff")]
    edge: Option<Edge>,
    /// The nearest surface [default: where the light is full scale on its axis, or the farthest if that is nearer]
    #[arg(long)]
    pub(crate) near: Option<f32>,
    /// The farthest surface [default: 7, or twice the nearest if that is farther]
    #[arg(long)]
    pub(crate) far: Option<f32>,
    #[command(flatten)]
    pub(crate) spot: Spot,
    #[command(flatten)]
    pub(crate) source: Source,
    /// The lights of a file of any kind, or of the example scene `show`, with one error for all
    #[arg(long, value_name = "FILE", conflicts_with_all = [
        "edge", "beam", "field", "outer", "inner", "attenuation", "intensity", "near", "far", "position", "axis",
        "from", "values", "fixture", "lumens", "candela", "lux", "falloff", "cutoff", "range", "window",
    ])]
    pub(crate) scene: Option<OsString>,
    /// Pick each light of the scene by itself: the tolerance is that of each light
    #[arg(long, requires = "scene")]
    pub(crate) each: bool,
    /// Write JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// The options of `import`.
#[derive(Debug, clap::Args)]
pub(crate) struct Import {
    #[command(flatten)]
    pub(crate) source: Source,
    #[command(flatten)]
    pub(crate) spot: Spot,
    /// Write the lights as JSON, which every command reads, with what is known of them
    #[arg(long)]
    pub(crate) json: bool,
    /// Write charts of the intensities over the angle, measured against fitted
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
}

/// The options of `still`.
#[derive(Debug, clap::Args)]
pub(crate) struct Still {
    /// The PNG to write
    #[arg(long, value_name = "FILE")]
    pub(crate) output: PathBuf,
    #[command(flatten)]
    pub(crate) source: Source,
    #[command(flatten)]
    pub(crate) spot: Spot,
}

/// The options of `export`.
#[derive(Debug, clap::Args)]
pub(crate) struct Export {
    /// json, glsl, glsl-uniforms, wgsl, c-f32, c-fx16, rust-build, rust-program, rust-f32, rust-fx32 or rust-fx16; the
    /// parameters of blender, three, godot, unreal, unity, bevy, gltf, usd, opengl or direct3d; or ies
    #[arg(long, value_name = "LANGUAGE|TOOL")]
    pub(crate) to: Target,
    /// The file to write, in place of the standard output. Of usd it is a stage, FILE.usda, and of gltf a scene,
    /// FILE.gltf, with an IES profile beside it for each light whose intensities its numbers do not hold
    #[arg(long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// The name of the light, which begins all names in a source; of several lights with a number
    /// behind it [default: their own]
    #[arg(long)]
    pub(crate) name: Option<String>,
    /// The name of the function that lights a point by all lights together; a source of one light has one if this is
    /// given [default: the name of the file]
    #[arg(long, value_name = "NAME")]
    pub(crate) scene: Option<String>,
    /// The DMX address of a GDTF fixture, from 1 to 512: c-fx16, rust-f32, rust-fx32 and rust-fx16 also have the channels by
    /// which a console controls it
    #[arg(long, value_name = "SLOT")]
    pub(crate) address: Option<u16>,
    #[command(flatten)]
    pub(crate) spot: Spot,
    #[command(flatten)]
    pub(crate) source: Source,
    /// The linear colour [default: 1,1,1]
    #[arg(long, value_name = "R,G,B", value_parser = vector, conflicts_with = "kelvin")]
    pub(crate) color: Option<[f32; 3]>,
}

impl Pick {
    /// The tolerance.
    pub(crate) fn tolerance(&self) -> Tolerance {
        self.codes.map_or(Tolerance::Steps(self.steps.unwrap_or(1.0)), Tolerance::Codes)
    }

    /// Whether the edge is that of two angles.
    pub(crate) fn has_idle_edge(&self) -> bool {
        self.edge.is_some() && self.spot.beam.is_some() && self.spot.field.is_some()
    }

    /// The light: its angles and edge, or as a whole if these do not tell it.
    pub(crate) fn light(&self) -> Result<Light, Refusal> {
        let standard = Light::default();
        let Spot { beam, field, outer, inner, falloff, cutoff, range, .. } = self.spot;
        let law = self.spot.attenuation.as_ref().map(|law| law.name.as_str());
        let attenuation = law.map_or(Ok(standard.attenuation), str::parse);
        let (Ok(attenuation), None, None, None) = (attenuation, falloff, cutoff, range) else {
            let edge = self.edge.filter(|_| !self.has_idle_edge());
            let falloff = falloff.or(edge.map(Edge::falloff));
            let spot = Spot { falloff, ..self.spot.clone() };
            let light = model::light(&spot, None, self.source.kelvin)?;
            return self.lit(Light::of(&standard.name, &light.into()));
        };
        let intensity = if attenuation == Attenuation::None { 1.0 } else { standard.intensity };
        let (mut color, mut intensity) = (standard.color, self.spot.intensity.unwrap_or(intensity));
        if let Some(kelvin) = self.source.kelvin {
            let white = Rgb::from_kelvin(kelvin)?;
            color = white.map(|channel| channel / white.strongest()).into();
            intensity *= white.strongest();
        }
        self.lit(Light {
            position: self.spot.position.unwrap_or(standard.position),
            axis: self.spot.axis.unwrap_or(standard.axis),
            edge: self.edge.unwrap_or(standard.edge),
            beam,
            field,
            outer,
            inner,
            attenuation,
            intensity,
            color,
            ..standard
        })
    }

    /// Returns a light with the distances of its surfaces.
    pub(crate) fn lit(&self, light: Light) -> Result<Light, Refusal> {
        let most = self.far.unwrap_or(f32::INFINITY);
        let near = match self.near {
            Some(near) => near,
            // Nearer than that, light is clipped, and its error is seen in part.
            None => light.full_scale()?.unwrap_or(light.near).min(most),
        };
        Ok(Light { near, far: self.far.unwrap_or(light.far.max(2.0 * near)), ..light })
    }
}
