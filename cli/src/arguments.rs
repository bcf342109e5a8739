//! The command line.

use luminaire_pick::{Attenuation, Chip, Display, Edge, Light, Tolerance};

/// The commands.
#[derive(Debug, clap::Parser)]
#[command(name = "luminaire", disable_help_subcommand = true, arg_required_else_help = true)]
pub(crate) enum Command {
    /// Pick the cheapest evaluation of a spotlight whose error is small enough for a display
    Pick(Box<Pick>),
}

/// The options of `pick`. Angles are full angles in degrees.
#[derive(Debug, clap::Args)]
pub(crate) struct Pick {
    /// cortex-m0, cortex-m3, cortex-m4f or rv32imc
    #[arg(long)]
    pub(crate) chip: Chip,
    /// rgb565 or rgb888
    #[arg(long)]
    pub(crate) display: Display,
    /// Largest error in steps of the display, after encoding in sRGB [default: 1]
    #[arg(long, conflicts_with = "codes")]
    steps: Option<f64>,
    /// Largest error in linear codes, 1/255 of full scale
    #[arg(long)]
    codes: Option<f64>,
    /// soft or hard [default: soft]
    #[arg(long)]
    edge: Option<Edge>,
    /// The angle of 50 % intensity; with --field, the falloff is fitted to both
    #[arg(long)]
    beam: Option<f32>,
    /// The angle of 10 % intensity [default: 36]
    #[arg(long)]
    field: Option<f32>,
    /// The angle at which the light ends
    #[arg(long)]
    outer: Option<f32>,
    /// The angle of a hotspot of full intensity
    #[arg(long)]
    inner: Option<f32>,
    /// none or inverse-square [default: inverse-square]
    #[arg(long)]
    attenuation: Option<Attenuation>,
    /// The intensity; 1 is full scale on the axis, at a distance of 1 [default: 16, or 1 without
    /// attenuation]
    #[arg(long)]
    intensity: Option<f32>,
    /// The nearest surface [default: 1, or the farthest if that is nearer]
    #[arg(long)]
    near: Option<f32>,
    /// The farthest surface [default: 7, or the nearest if that is farther]
    #[arg(long)]
    far: Option<f32>,
    /// The position of the light [default: 0,0,0]
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    position: Option<[f32; 3]>,
    /// The axis of the light [default: 0,-1,0]
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    axis: Option<[f32; 3]>,
    /// The lights of a JSON file, or of the example scene `show`, in place of one light
    #[arg(long, value_name = "FILE", conflicts_with_all = ["edge", "beam", "field", "outer", "inner"])]
    pub(crate) scene: Option<String>,
    /// Pick each light of the scene by itself: the tolerance is that of each light
    #[arg(long, requires = "scene")]
    pub(crate) each: bool,
    /// Write JSON
    #[arg(long)]
    pub(crate) json: bool,
}

fn vector(text: &str) -> Result<[f32; 3], String> {
    let numbers: Result<Vec<f32>, _> = text.split(',').map(|number| number.trim().parse()).collect();
    let numbers = numbers.map_err(|error| error.to_string())?;
    numbers.try_into().map_err(|_| "expected three numbers".to_owned())
}

impl Pick {
    /// The tolerance.
    pub(crate) fn tolerance(&self) -> Tolerance {
        self.codes.map_or(Tolerance::Steps(self.steps.unwrap_or(1.0)), Tolerance::Codes)
    }

    /// The light.
    pub(crate) fn light(&self) -> Light {
        let standard = Light::default();
        let attenuation = self.attenuation.unwrap_or(standard.attenuation);
        let intensity = if attenuation == Attenuation::None { 1.0 } else { standard.intensity };
        Light {
            position: self.position.unwrap_or(standard.position),
            axis: self.axis.unwrap_or(standard.axis),
            edge: self.edge.unwrap_or(standard.edge),
            beam: self.beam,
            field: self.field,
            outer: self.outer,
            inner: self.inner,
            attenuation,
            intensity: self.intensity.unwrap_or(intensity),
            near: self.near.unwrap_or(self.far.map_or(standard.near, |far| far.min(standard.near))),
            far: self.far.unwrap_or(self.near.map_or(standard.far, |near| near.max(standard.far))),
            ..standard
        }
    }
}
