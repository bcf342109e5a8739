//! Where the lights of a command come from: a file, the numbers of another tool, or a data sheet.

use std::fs;
use std::io::Read;

use luminaire_exchange::{Lamps, Place, Refusal, Sheet, System, Use, fixture, numbers, placed, read};

/// The options by which a light comes from elsewhere. An option of its shape beside one of these would
/// have no effect.
pub(crate) const ELSEWHERE: [&str; 5] = ["from", "fixture", "lumens", "candela", "lux"];

/// The angles, the intensity and the place of a spotlight.
#[derive(Debug, clap::Args)]
pub(crate) struct Spot {
    /// The full angle of 50 % intensity in degrees; with --field, the falloff is fitted to both
    #[arg(long, conflicts_with_all = ["from", "fixture"])]
    pub(crate) beam: Option<f32>,
    /// The full angle of 10 % intensity in degrees [default: 36]
    #[arg(long, conflicts_with_all = ["from", "fixture"])]
    pub(crate) field: Option<f32>,
    /// The full angle in degrees at which the light ends
    #[arg(long, conflicts_with_all = ELSEWHERE)]
    pub(crate) outer: Option<f32>,
    /// The full angle in degrees of a hotspot of full intensity
    #[arg(long, conflicts_with_all = ELSEWHERE)]
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
#[command(next_help_heading = "Lights from elsewhere", allow_negative_numbers = true)]
pub(crate) struct Source {
    /// A file (gltf, glb, json, tscn, usda, x3d, wrl, pbrt, unity, prefab, t3d, babylon, ies, ldt, gdtf), or a
    /// tool whose numbers follow as KEY=VALUE: gltf, three, godot, opengl, direct3d, blender, usd, x3d, pbrt,
    /// unreal, unity, bevy or babylon
    #[arg(long, value_name = "FILE|TOOL")]
    pub(crate) from: Option<String>,
    /// Numbers in the names and units of the tool, and kind=point, position=X,Y,Z and axis=X,Y,Z; or a file
    /// of the tool, and for `import` any files
    #[arg(value_name = "KEY=VALUE|FILE")]
    pub(crate) values: Vec<String>,
    /// One light of the file, by its name or its number from 1 [default: all]
    #[arg(long, value_name = "NAME")]
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
            let expected = "an option, or --from with a file or with a tool before its numbers";
            return Err(Refusal::new("word", word, expected));
        }
        let lamps = match (&self.from, &self.fixture) {
            (Some(from), _) => match (from.parse::<System>(), &self.values[..]) {
                (Ok(system), [file]) if !file.contains('=') => open(file, Some(system), self.fit)?,
                (Ok(system), values) => numbers(system, values.iter().map(String::as_str))?,
                (Err(_), []) => open(from, None, self.fit)?,
                // The words that follow are numbers of a tool.
                (Err(refusal), _) => return Err(refusal),
            },
            (None, None) if self.lumens.or(self.candela).or(self.lux).is_none() => return Ok(None),
            (None, name) => {
                let [beam, field] = [spot.beam, spot.field].map(|angle| angle.map(f64::from));
                let own = Sheet { name: "light".to_owned(), beam, field, ..Sheet::default() };
                let sheet = name.as_ref().map_or(Ok(own), |name| fixture(name))?;
                let (lumens, candela) = (self.lumens.or(sheet.lumens), self.candela.or(sheet.candela));
                let sheet = Sheet { lumens, candela, lux: self.lux, throw: self.throw, ..sheet };
                Lamps { lamps: sheet.lamp()?.ends().collect(), ..Lamps::new(System::Gdtf) }
            }
        };
        let lamps = self.chosen(lamps)?;
        if let (true, Some(refusal)) = (lamps.lamps.is_empty(), lamps.refused.first()) {
            return Err(refusal.clone());
        }
        self.loaded(lamps, spot).map(Some)
    }

    /// Returns lights with the place and the intensity of the options.
    pub(crate) fn loaded(&self, mut lamps: Lamps, spot: &Spot) -> Result<Loaded, Refusal> {
        let usage = self.usage(&lamps)?;
        for lamp in &mut lamps.lamps {
            let intensity = spot.intensity.map(|intensity| intensity * usage.full_scale as f32);
            let place = Place { position: spot.position, axis: spot.axis, intensity, color: None };
            lamp.light = placed(lamp.light, place)?;
        }
        Ok(Loaded { lamps, usage })
    }

    /// Returns the light of the option `--light` alone, or else all.
    pub(crate) fn chosen(&self, mut lamps: Lamps) -> Result<Lamps, Refusal> {
        let Some(chosen) = &self.light else { return Ok(lamps) };
        let names: Vec<_> = lamps.lamps.iter().map(|lamp| lamp.name.as_str()).collect();
        let number = chosen.parse().ok().and_then(|number: usize| number.checked_sub(1));
        let number = number.filter(|&number| number < names.len());
        let Some(index) = names.iter().position(|name| name == chosen).or(number) else {
            let expected = format_args!("a number from 1 to {}, or one of {}", names.len(), names.join(", "));
            return Err(Refusal::new("light", chosen, expected));
        };
        lamps.lamps = vec![lamps.lamps.swap_remove(index)];
        lamps.refused.clear();
        Ok(lamps)
    }

    /// Returns how the lights are used, with the illuminance of full scale.
    fn usage(&self, lamps: &Lamps) -> Result<Use, Refusal> {
        let positive = |name, value: f64| {
            let refusal = || Refusal::new(name, value, "a number over 0 and at most 1e9");
            (value > 0.0 && value <= 1e9).then_some(value).ok_or_else(refusal)
        };
        let throw = positive("throw", self.throw.unwrap_or(4.0))?;
        let usage = lamps.usage(throw);
        let lux = self.full_scale.map(|lux| positive("full-scale", lux)).transpose()?;
        Ok(Use { full_scale: lux.unwrap_or(usage.full_scale), ..usage })
    }
}

/// The most bytes of a file that are read: more than any reader accepts, and less than a device gives.
const MOST: u64 = 1 << 30;

/// Reads a file.
pub(crate) fn open(file: &str, system: Option<System>, fit: f64) -> Result<Lamps, Refusal> {
    let mut bytes = Vec::new();
    fs::File::open(file)
        .and_then(|open| open.take(MOST).read_to_end(&mut bytes))
        .map_err(|error| Refusal::new("file", file, format_args!("a file that can be read: {error}")))?;
    read(file, &bytes, system, fit)
}

/// Writes the file of an option.
pub(crate) fn save(option: &str, file: &str, content: impl AsRef<[u8]>) -> Result<(), Refusal> {
    fs::write(file, content)
        .map_err(|error| Refusal::new(option, file, format_args!("a file that can be written: {error}")))
}

/// Reads three numbers.
pub(crate) fn vector(text: &str) -> Result<[f32; 3], String> {
    let numbers: Result<Vec<f32>, _> = text.split(',').map(|number| number.trim().parse()).collect();
    let numbers = numbers.map_err(|error| error.to_string())?;
    numbers.try_into().map_err(|_| "expected three numbers".to_owned())
}
