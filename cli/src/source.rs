//! Where the lights of a command come from: a file, the numbers of another tool, or a data sheet.

use std::fs;

use luminaire_exchange::{Lamps, Refusal, Sheet, System, Use, fixture, numbers, read};

/// The angles, the intensity and the place of a spotlight.
#[derive(Debug, clap::Args)]
pub(crate) struct Spot {
    /// The angle of 50 % intensity; with --field, the falloff is fitted to both
    #[arg(long)]
    pub(crate) beam: Option<f32>,
    /// The angle of 10 % intensity [default: 36]
    #[arg(long)]
    pub(crate) field: Option<f32>,
    /// The angle at which the light ends
    #[arg(long)]
    pub(crate) outer: Option<f32>,
    /// The angle of a hotspot of full intensity
    #[arg(long)]
    pub(crate) inner: Option<f32>,
    /// The intensity; 1 is full scale on the axis, at a distance of 1 [default: 16, or 1 without
    /// attenuation]
    #[arg(long)]
    pub(crate) intensity: Option<f32>,
    /// The position of the light [default: 0,0,0]
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub(crate) position: Option<[f32; 3]>,
    /// The axis of the light [default: 0,-1,0]
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub(crate) axis: Option<[f32; 3]>,
}

/// The source of lights.
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Lights from elsewhere")]
pub(crate) struct Source {
    /// A file (gltf, glb, json, tscn, usda, x3d, wrl, pbrt, unity, prefab, t3d, babylon, ies, ldt, gdtf), or a
    /// tool whose numbers follow as KEY=VALUE: gltf, three, godot, opengl, direct3d, blender, usd, x3d, pbrt,
    /// unreal, unity, bevy or babylon
    #[arg(long, value_name = "FILE|TOOL")]
    pub(crate) from: Option<String>,
    /// Numbers in the names and units of the tool, and kind=point, position=X,Y,Z and axis=X,Y,Z; or for
    /// `import` files
    #[arg(value_name = "KEY=VALUE")]
    pub(crate) values: Vec<String>,
    /// One light of the file, by its name or its number from 1 [default: all]
    #[arg(long, value_name = "NAME", requires = "from")]
    pub(crate) light: Option<String>,
    /// A stage light of the built-in table, by a part of its name
    #[arg(long, value_name = "NAME", conflicts_with = "from")]
    pub(crate) fixture: Option<String>,
    /// The luminous flux of a data sheet, beside --beam and --field
    #[arg(long, conflicts_with = "from")]
    pub(crate) lumens: Option<f64>,
    /// The peak of a data sheet in candela, beside --beam and --field
    #[arg(long, conflicts_with = "from")]
    pub(crate) candela: Option<f64>,
    /// The illuminance on the axis at the throw, in place of --lumens or --candela
    #[arg(long, conflicts_with = "from")]
    pub(crate) lux: Option<f64>,
    /// The distance of the surface that counts [default: 4]
    #[arg(long, value_name = "DISTANCE")]
    pub(crate) throw: Option<f64>,
    /// The illuminance that is full scale [default: 1, and for photometry what the brightest light gives on
    /// its axis at the throw]
    #[arg(long, value_name = "LUX")]
    pub(crate) full_scale: Option<f64>,
    /// Largest difference of a cheaper cone from a measured light, in linear codes; beyond it the light is
    /// a table
    #[arg(long, value_name = "CODES", default_value_t = 1.0)]
    pub(crate) fit: f64,
}

/// Lights with the scale of their intensities.
pub(crate) struct Loaded {
    pub(crate) lamps: Lamps,
    pub(crate) usage: Use,
}

impl Source {
    /// Returns the lights; `None` if the command describes its light by other options.
    pub(crate) fn load(&self, spot: &Spot) -> Result<Option<Loaded>, Refusal> {
        if let (None, Some(word)) = (&self.from, self.values.first()) {
            return Err(Refusal::new(
                "word",
                word,
                "an option, or --from with a file or with a tool before its numbers",
            ));
        }
        let is_sheet = self.lumens.or(self.candela).or(self.lux).is_some();
        let mut lamps = match (&self.from, &self.fixture) {
            (Some(from), _) => self.file(from)?,
            (None, None) if !is_sheet => return Ok(None),
            (None, name) => {
                let wide = |angle: Option<f32>| angle.map(f64::from);
                let own = Sheet { beam: wide(spot.beam), field: wide(spot.field), ..Sheet::default() };
                let sheet = name.as_ref().map_or(Ok(own), |name| fixture(name))?;
                let sheet = Sheet {
                    lumens: self.lumens.or(sheet.lumens),
                    candela: self.candela.or(sheet.candela),
                    lux: self.lux,
                    throw: self.throw,
                    ..sheet
                };
                Lamps { lamps: sheet.lamp()?.ends().collect(), ..Lamps::new(System::Gdtf) }
            }
        };
        if let Some(chosen) = &self.light {
            let names: Vec<_> = lamps.lamps.iter().map(|lamp| lamp.name.clone()).collect();
            let number = chosen.parse().ok().and_then(|number: usize| number.checked_sub(1));
            let index = names
                .iter()
                .position(|name| name == chosen)
                .or(number.filter(|&number| number < names.len()));
            let Some(index) = index else {
                return Err(Refusal::new(
                    "light",
                    chosen,
                    format_args!("a number from 1 to {}, or one of {}", names.len(), names.join(", ")),
                ));
            };
            lamps.lamps = vec![lamps.lamps.swap_remove(index)];
        }
        if let (true, Some(refusal)) = (lamps.lamps.is_empty(), lamps.refused.first()) {
            return Err(refusal.clone());
        }
        let usage = self.usage(&lamps)?;
        Ok(Some(Loaded { lamps, usage }))
    }

    fn file(&self, from: &str) -> Result<Lamps, Refusal> {
        match from.parse::<System>() {
            Ok(system) => numbers(system, self.values.iter().map(String::as_str)),
            Err(_) if !self.values.is_empty() => Err(Refusal::new(
                "values",
                self.values.join(" "),
                "no values beside a file, or a tool in place of it",
            )),
            Err(_) => open(from, None, self.fit),
        }
    }

    /// Returns how the lights are used, with the illuminance of full scale.
    pub(crate) fn usage(&self, lamps: &Lamps) -> Result<Use, Refusal> {
        let positive = |name, value: f64| {
            if value > 0.0 && value <= 1e9 {
                Ok(value)
            } else {
                Err(Refusal::new(name, value, "a number over 0 and at most 1e9"))
            }
        };
        let throw = positive("throw", self.throw.unwrap_or(4.0))?;
        let usage = lamps.usage(throw);
        let lux = self.full_scale.map(|lux| positive("full-scale", lux)).transpose()?;
        Ok(Use { full_scale: lux.unwrap_or(usage.full_scale), ..usage })
    }
}

/// Reads a file.
pub(crate) fn open(file: &str, system: Option<System>, fit: f64) -> Result<Lamps, Refusal> {
    let bytes = fs::read(file)
        .map_err(|error| Refusal::new("file", file, format_args!("a file that can be read: {error}")))?;
    read(file, &bytes, system, fit)
}

/// Reads three numbers.
pub(crate) fn vector(text: &str) -> Result<[f32; 3], String> {
    let numbers: Result<Vec<f32>, _> = text.split(',').map(|number| number.trim().parse()).collect();
    let numbers = numbers.map_err(|error| error.to_string())?;
    numbers.try_into().map_err(|_| "expected three numbers".to_owned())
}
