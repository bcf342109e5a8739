//! Where the lights of a command come from: a file, the numbers of another tool, or a data sheet.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io::{self, IsTerminal, Read, Write, stderr};
use std::path::{Component, Path, PathBuf};

use luminaire::SpotLight;
use luminaire::attenuation::AnyAttenuation;
use luminaire::dynamic::AnyLight;
use luminaire::falloff::AnyFalloff;
use luminaire_exchange::{
    Lamp, Lamps, Place, Reading, Refusal, Sheet, System, Use, fixture, largest, numbers, placed, read_beside,
};
use luminaire_export::json::NamedAmbient;

use crate::text::say;
use crate::words::{self, Law};

/// The options and words by which a light comes from elsewhere. An option of its shape beside one
/// of these would have no effect.
pub(crate) const ELSEWHERE: [&str; 6] = ["from", "values", "fixture", "lumens", "candela", "lux"];

/// A spotlight: its angles, how it falls off over the angle and the distance, its intensity and its place.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Spot {
    /// The full angle of 50 % intensity in degrees; with --field, the falloff is fitted to both
    #[arg(long, conflicts_with_all = ["from", "values", "fixture"])]
    pub(crate) beam: Option<f32>,
    /// The full angle of 10 % intensity in degrees [default: 36]
    #[arg(long, conflicts_with_all = ["from", "values", "fixture"])]
    pub(crate) field: Option<f32>,
    /// The full angle in degrees at which the light ends
    #[arg(long, conflicts_with_all = ELSEWHERE)]
    pub(crate) outer: Option<f32>,
    /// The full angle in degrees of a hotspot of full intensity
    #[arg(long, conflicts_with_all = ELSEWHERE)]
    pub(crate) inner: Option<f32>,
    #[arg(long, value_parser = words::falloff, conflicts_with_all = ["from", "values"], help = words::falloffs())]
    pub(crate) falloff: Option<AnyFalloff>,
    /// A full angle in degrees that ends the light before its falloff does
    #[arg(long, conflicts_with_all = ELSEWHERE)]
    pub(crate) cutoff: Option<f32>,
    #[arg(long, conflicts_with_all = ELSEWHERE, help = words::laws())]
    pub(crate) attenuation: Option<Law>,
    /// The distance at which the light ends
    #[arg(long, conflicts_with_all = ELSEWHERE)]
    pub(crate) range: Option<f32>,
    /// How the light ends at its range: cut, gltf or square [default: cut]
    #[arg(long, requires = "range")]
    pub(crate) window: Option<String>,
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
    /// A file (gltf, glb, json, tscn, usda, x3d, wrl, pbrt, unity, prefab, t3d, babylon, ies, ldt, gdtf, mvr),
    /// or a tool whose numbers follow as KEY=VALUE: gltf, three, godot, opengl, direct3d, blender, usd, x3d, pbrt,
    /// unreal, unity, bevy or babylon
    #[arg(long, value_name = "FILE|TOOL")]
    pub(crate) from: Option<OsString>,
    /// Numbers in the names and units of the tool, and kind=point, position=X,Y,Z and axis=X,Y,Z;
    /// or files, and folders, whose files are read
    #[arg(value_name = "KEY=VALUE|FILE")]
    pub(crate) values: Vec<OsString>,
    /// One light of each file, by its name or its number from 1 [default: all]
    #[arg(long, value_name = "NAME")]
    pub(crate) light: Option<String>,
    /// A stage light of the built-in table, by a part of its name
    #[arg(long, value_name = "NAME", conflicts_with_all = ["from", "values"])]
    pub(crate) fixture: Option<String>,
    /// The luminous flux of a data sheet, beside --beam and --field
    #[arg(long, conflicts_with_all = ["from", "values"])]
    pub(crate) lumens: Option<f64>,
    /// The peak of a data sheet in candela, beside --beam and --field
    #[arg(long, conflicts_with_all = ["from", "values"])]
    pub(crate) candela: Option<f64>,
    /// The illuminance on the axis at the throw, in place of --lumens or --candela
    #[arg(long, conflicts_with_all = ["from", "values"])]
    pub(crate) lux: Option<f64>,
    /// The distance of the surface that counts [default: 4]
    #[arg(long, value_name = "DISTANCE")]
    pub(crate) throw: Option<f64>,
    /// The illuminance that is full scale [default: 1, and for photometry what the brightest light gives on
    /// its axis at the throw]
    #[arg(long, value_name = "LUX")]
    pub(crate) full_scale: Option<f64>,
    /// Largest difference of a cheaper cone from a measured light, in linear codes; beyond it the light is
    /// a table. As large a difference of a plane from the mean of all is taken, too [default: 1]
    #[arg(long, value_name = "CODES")]
    pub(crate) fit: Option<f64>,
    /// The correlated colour temperature, in place of a light's colour; its luminance stays
    #[arg(long, value_name = "KELVIN")]
    pub(crate) kelvin: Option<f32>,
    /// Take the mean of a measured light's planes, however they differ
    #[arg(long)]
    pub(crate) round: bool,
    /// The size of the table of a photometric light that is not round: 3, 5, 9, 17, 33, 65, 129 or 257 samples along a
    /// side [default: the smallest that is within --fit of the file, at most 65]
    #[arg(long, value_name = "SAMPLES", conflicts_with = "round")]
    pub(crate) size: Option<u32>,
}

/// A file, or another source, with its lights.
pub(crate) struct Input {
    pub(crate) name: String,
    pub(crate) is_file: bool,
    pub(crate) loaded: Result<Loaded, Refusal>,
}

/// Lights with the scale of their intensities.
pub(crate) struct Loaded {
    pub(crate) lamps: Lamps,
    pub(crate) usage: Use,
}

/// The lights of all inputs, each with its use, and whether none was refused.
pub(crate) struct Found {
    pub(crate) lamps: Vec<(Lamp, Use)>,
    /// The ambient light, in the unit of full scale.
    pub(crate) ambient: Vec<NamedAmbient>,
    /// Whether the lights shine together: those of a fixture may be the ends of its zoom.
    pub(crate) is_scene: bool,
    pub(crate) is_whole: bool,
}

impl Source {
    /// Returns the lights of all inputs, and says which ones were refused; `None` if the command
    /// describes its light by other options.
    pub(crate) fn load(&self, spot: &Spot, has_throw: bool) -> Result<Option<Found>, Refusal> {
        let inputs = self.inputs(spot)?;
        self.say_idle(spot, has_throw, &inputs);
        if inputs.is_empty() {
            return Ok(None);
        }
        let count = inputs.len();
        let mut found = Found { lamps: Vec::new(), ambient: Vec::new(), is_scene: true, is_whole: true };
        for Input { name, is_file, loaded } in inputs {
            let refused = match loaded {
                Err(refusal) => vec![refusal],
                Ok(Loaded { lamps, usage }) => {
                    found.is_scene &= !matches!(lamps.system, System::Gdtf | System::Ofl);
                    // What is left out of a rig belongs to no light.
                    let notes = lamps.notes.iter().filter(|_| lamps.system == System::Mvr);
                    notes.for_each(|note| say("note", note));
                    for ambient in &lamps.ambient {
                        found.ambient.push(usage.ambient(ambient)?);
                    }
                    found.lamps.extend(lamps.lamps.into_iter().map(|lamp| (lamp, usage)));
                    lamps.refused
                }
            };
            for refusal in refused {
                say("error", if is_file && count > 1 { refusal.at(&name) } else { refusal });
                found.is_whole = false;
            }
        }
        Ok(Some(found))
    }

    /// Returns the light that a command describes by other options, in units of full scale.
    pub(crate) fn own(&self, light: SpotLight<AnyFalloff, AnyAttenuation>) -> Result<Found, Refusal> {
        let usage = Use { throw: self.throw()?, full_scale: 1.0, is_photometric: false };
        let lamps = vec![(Lamp::new("light", light), usage)];
        Ok(Found { lamps, ambient: Vec::new(), is_scene: true, is_whole: true })
    }

    /// Returns what the words and options name; nothing if the command describes its light by other
    /// options.
    pub(crate) fn inputs(&self, spot: &Spot) -> Result<Vec<Input>, Refusal> {
        let system = self.from.as_ref().map(|from| shown(from).parse::<System>());
        let number = self.values.iter().find(|word| shown(word).contains('=') && !Path::new(word).exists());
        let other = |name: String, lamps| {
            let loaded = self.loaded(lamps, spot)?;
            Ok(vec![Input { name, is_file: false, loaded: Ok(loaded) }])
        };
        match (system, number) {
            // The words that follow are numbers of a tool.
            (Some(Err(refusal)), Some(_)) => Err(refusal),
            (None, Some(word)) => {
                let expected = "a file, a folder, or --from with a tool before its numbers";
                Err(Refusal::new("word", shown(word), expected))
            }
            (Some(Ok(system)), None) if !self.values.is_empty() => {
                Ok(self.files(&self.values, Some(system), spot))
            }
            (Some(Ok(system)), _) => {
                let words: Vec<_> = self.values.iter().map(|word| shown(word)).collect();
                other(system.name().to_owned(), numbers(system, words.iter().map(String::as_str))?)
            }
            (Some(Err(_)), None) => {
                let files: Vec<_> = self.from.iter().chain(&self.values).cloned().collect();
                Ok(self.files(&files, None, spot))
            }
            (None, None) if !self.values.is_empty() => Ok(self.files(&self.values, None, spot)),
            (None, None) if self.fixture.is_none() && self.lumens.or(self.candela).or(self.lux).is_none() => {
                Ok(Vec::new())
            }
            (None, None) => {
                let [beam, field] = [spot.beam, spot.field].map(|angle| angle.map(f64::from));
                let own = Sheet { name: "light".to_owned(), beam, field, ..Sheet::default() };
                let sheet = self.fixture.as_ref().map_or(Ok(own), |name| fixture(name))?;
                let (lumens, candela) = (self.lumens.or(sheet.lumens), self.candela.or(sheet.candela));
                let (lux, throw, falloff) = (self.lux, self.throw, spot.falloff);
                let sheet = Sheet { lumens, candela, lux, throw, falloff, ..sheet };
                let name = self.fixture.clone().unwrap_or_else(|| "data sheet".to_owned());
                other(name, Lamps { lamps: sheet.lamp()?.ends().collect(), ..Lamps::new(System::Gdtf) })
            }
        }
    }

    /// Reads files, and of folders those that are of a system by their extension or their first
    /// line.
    fn files(&self, words: &[OsString], system: Option<System>, spot: &Spot) -> Vec<Input> {
        let mut paths = Vec::new();
        for word in words {
            match fs::read_dir(word) {
                Ok(entries) => {
                    let files = entries.filter_map(|entry| Some(entry.ok()?.path()));
                    let (mut own, others): (Vec<_>, Vec<_>) =
                        files.filter(|path| path.is_file()).partition(|path| is_of(path, system));
                    if !others.is_empty() {
                        let (folder, kind) = (shown(word), system.map_or("any system", System::name));
                        let count = others.len();
                        say(
                            "note",
                            format_args!("{folder}: left out {count} without an extension of {kind}"),
                        );
                    }
                    own.sort();
                    paths.extend(own);
                }
                Err(_) => paths.push(PathBuf::from(word)),
            }
        }
        let shows_progress = paths.len() > 20 && stderr().is_terminal();
        let mut inputs = Vec::new();
        for (done, path) in paths.iter().enumerate() {
            if shows_progress && done % 16 == 0 {
                let _ = write!(stderr(), "\r{done} of {} files", paths.len());
            }
            let lamps = open(path, system, self.reading());
            let loaded = lamps.and_then(|lamps| self.loaded(lamps, spot));
            inputs.push(Input { name: shown(path.as_os_str()), is_file: true, loaded });
        }
        if shows_progress {
            let _ = write!(stderr(), "\r\x1b[K");
        }
        inputs
    }

    /// Returns lights with the place and the intensity of the options; without any, that is
    /// refused.
    fn loaded(&self, lamps: Lamps, spot: &Spot) -> Result<Loaded, Refusal> {
        let mut lamps = self.chosen(lamps)?;
        if lamps.is_empty() {
            lamps.refused.push(Refusal::new("lights", "none", "at least one light"));
        }
        if let Some(kelvin) = self.kelvin {
            lamps.lamps.iter_mut().try_for_each(|lamp| lamp.set_kelvin(kelvin))?;
        }
        let usage = self.usage(&lamps)?;
        for lamp in &mut lamps.lamps {
            let intensity = spot.intensity.map(|intensity| intensity * usage.full_scale as f32);
            let place = Place { position: spot.position, axis: spot.axis, intensity };
            lamp.light = placed(lamp.light, place)?;
            if let (Some(patched), Some(axis)) = (&mut lamp.patch, spot.axis) {
                patched.mount_along(axis)?;
            }
        }
        Ok(Loaded { lamps, usage })
    }

    /// Returns the light of the option `--light` alone, or else all.
    fn chosen(&self, mut lamps: Lamps) -> Result<Lamps, Refusal> {
        let Some(chosen) = &self.light else { return Ok(lamps) };
        let ambient = lamps.ambient.iter().map(|ambient| &*ambient.name);
        let names: Vec<_> = lamps.lamps.iter().map(|lamp| &*lamp.name).chain(ambient).collect();
        let number = chosen.parse().ok().and_then(|number: usize| number.checked_sub(1));
        let number = number.filter(|&number| number < names.len());
        let Some(index) = names.iter().position(|name| name == chosen).or(number) else {
            let expected = format_args!("a number from 1 to {}, or one of {}", names.len(), names.join(", "));
            return Err(Refusal::new("light", chosen, expected));
        };
        let count = lamps.lamps.len();
        lamps.lamps = lamps.lamps.into_iter().skip(index).take(1).collect();
        // Behind the other lights.
        let ambient = index.checked_sub(count).map(|index| lamps.ambient.swap_remove(index));
        lamps.ambient = ambient.into_iter().collect();
        lamps.refused.clear();
        Ok(lamps)
    }

    /// Returns how the lights are used, with the illuminance of full scale.
    fn usage(&self, lamps: &Lamps) -> Result<Use, Refusal> {
        let usage = lamps.usage(self.throw()?);
        let lux = self.full_scale.map(|lux| positive("full-scale", lux)).transpose()?;
        Ok(Use { full_scale: lux.unwrap_or(usage.full_scale), ..usage })
    }

    /// The distance of the surface that counts.
    fn throw(&self) -> Result<f64, Refusal> {
        positive("throw", self.throw.unwrap_or(4.0))
    }

    /// How measured intensities are read.
    fn reading(&self) -> Reading {
        let fit = self.fit.unwrap_or(Reading::default().fit);
        Reading { fit, is_round: self.round, size: self.size, remedy: ROUND }
    }

    /// Says which options have no effect on these lights. `has_throw` is whether the command has a
    /// use for the throw of any light.
    pub(crate) fn say_idle(&self, spot: &Spot, has_throw: bool, inputs: &[Input]) {
        let is_own = inputs.is_empty();
        let loaded: Vec<_> = inputs.iter().filter_map(|input| input.loaded.as_ref().ok()).collect();
        let has = |of: &[System]| loaded.iter().any(|loaded| of.contains(&loaded.lamps.system));
        let mut lights =
            loaded.iter().flat_map(|loaded| &loaded.lamps.lamps).map(|lamp| &lamp.light).peekable();
        let is_none = lights.peek().is_none();
        let (mut placed, mut aimed) = (is_none, is_none);
        for light in lights {
            placed |= !matches!(light, AnyLight::Directional(_));
            aimed |= !matches!(light, AnyLight::Point(_));
        }
        use System::{Eulumdat, Gdtf, Ies, Mvr, Ofl};
        let lamps = loaded.iter().flat_map(|loaded| &loaded.lamps.lamps);
        let mut tables = loaded.iter().flat_map(|loaded| &loaded.lamps.lamps);
        let is_table = is_none || tables.any(|lamp| matches!(lamp.light, AnyLight::Measured(_)));
        let is_measured = has(&[Ies, Eulumdat]) || lamps.into_iter().any(|lamp| lamp.measured.is_some());
        for (option, is_idle, why) in [
            ("light", self.light.is_some() && is_own, "there is no file"),
            ("full-scale", self.full_scale.is_some() && is_own, "the intensity is in units of full scale"),
            (
                "throw",
                self.throw.is_some() && !has_throw && !has(&[Ies, Eulumdat, Gdtf, Mvr, Ofl]),
                "only photometry is scaled by the light at a distance",
            ),
            ("fit", self.fit.is_some() && !is_measured, "no light is that of a photometric file"),
            (
                "size",
                self.size.is_some() && (is_own || !is_table),
                "no light of a photometric file is other than round",
            ),
            ("round", self.round && !is_measured, "no light is that of a photometric file"),
            ("position", spot.position.is_some() && !placed, "a directional light has none"),
            ("axis", spot.axis.is_some() && !aimed, "a point light has none"),
        ] {
            if is_idle {
                say("note", format_args!("--{option} has no effect: {why}"));
            }
        }
    }
}

/// Returns a number that an option accepts, or its refusal.
fn positive(option: &str, value: f64) -> Result<f64, Refusal> {
    let refusal = || Refusal::new(option, value, "a number over 0 and at most 1e9");
    (value > 0.0 && value <= 1e9).then_some(value).ok_or_else(refusal)
}

/// Returns whether a file is of the system, or of any: by its extension, or by the line that begins
/// a text of numbers.
fn is_of(path: &Path, system: Option<System>) -> bool {
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    let extension = extension.to_ascii_lowercase();
    let mut systems = System::ALL.iter().filter(|own| system.is_none_or(|system| system == **own));
    let begins = || {
        let mut head = [0; 10];
        fs::File::open(path).and_then(|mut file| file.read_exact(&mut head)).is_ok() && head == *b"# system: "
    };
    systems.any(|system| system.extensions().contains(&&*extension)) || begins()
}

/// Reads a file, and the photometric files that it names beside it.
fn open(path: &Path, system: Option<System>, reading: Reading) -> Result<Lamps, Refusal> {
    let (name, bytes) = (shown(path.as_os_str()), content(path)?);
    // A scene of another names no file outside its folder.
    let beside = |file: &str| {
        let is_below = |part| matches!(part, Component::Normal(_) | Component::CurDir);
        if !Path::new(file).components().all(is_below) {
            return Err("it is not in the folder of this file, or below".to_owned());
        }
        content(&path.with_file_name(file)).map_err(|refusal| refusal.expected)
    };
    read_beside(&name, &bytes, system, reading, &beside)
}

/// The remedy of planes that differ.
const ROUND: &str =
    "; --fit takes the mean of planes that differ by up to its codes, and --round that of any";

/// Returns the bytes of a file, but for one that is too large.
fn content(path: &Path) -> Result<Vec<u8>, Refusal> {
    let name = shown(path.as_os_str());
    let unread =
        |error: io::Error| Refusal::new("file", &name, format_args!("a file that can be read: {error}"));
    let file = fs::File::open(path).map_err(unread)?;
    let (mut bytes, size, most) = (Vec::new(), file.metadata().map_err(unread)?.len(), largest(&name));
    if size <= most {
        // A device states no size.
        file.take(most + 1).read_to_end(&mut bytes).map_err(unread)?;
    }
    if size.max(bytes.len() as u64) > most {
        let size = if size > most { size.to_string() } else { format!("more than {most}") };
        return Err(Refusal::new("size", size, format_args!("at most {most} bytes")));
    }
    Ok(bytes)
}

/// Writes the file of an option.
pub(crate) fn save(option: &str, file: &Path, content: impl AsRef<[u8]>) -> Result<(), Refusal> {
    let refused = |error| {
        let expected = format_args!("a file that can be written: {error}");
        Refusal::new(option, shown(file.as_os_str()), expected)
    };
    fs::write(file, content).map_err(refused)
}

/// Returns a word of the command line as text: bytes that are none are escaped.
pub(crate) fn shown(word: &OsStr) -> String {
    word.to_str().map_or_else(|| format!("{word:?}").trim_matches('"').to_owned(), str::to_owned)
}

/// Reads three numbers.
pub(crate) fn vector(text: &str) -> Result<[f32; 3], String> {
    let numbers: Result<Vec<f32>, _> = text.split(',').map(|number| number.trim().parse()).collect();
    let numbers = numbers.map_err(|error| error.to_string())?;
    numbers.try_into().map_err(|_| "expected three numbers".to_owned())
}
