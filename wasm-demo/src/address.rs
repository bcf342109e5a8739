//! The state as text, for the part of the page's address after the `#`.
//!
//! It begins with the version and the scene, and has only what differs from the scene as it opens:
//!
//! | parameter | value |
//! |---|---|
//! | `format` | `fx16`, `fx32` or `f32` |
//! | `with` | the format of the other half of a divided picture |
//! | `difference` | `1`: the difference between both formats covers the picture |
//! | `view` | yaw, pitch and factor of the visitor's camera |
//! | `at` | the times of lights and camera, in seconds |
//! | `play` | `lights`, `camera`, `both` or `none` |
//! | `lights` | the lights, separated by `;` |
//! | `effects` | switched effects, each with `-` before it if it is off |
//! | `map` | what is shown over the picture |
//! | `all` | `1`: every effect is evaluated |
//! | `exposure` | stops |
//! | `tone` | `hue`: overexposed light keeps its hue |
//! | `handles` | `0`: the lights are not drawn over the picture |
//!
//! Numbers of one value are separated by `/`. A light is its number in the scene, or a range of
//! lights without settings, as in `3-7`; the number after the last one is a light that the visitor has
//! added. Its settings follow, each with `:`, a letter and a value:
//! `x` off, `b` and `f` beam and field angle, `e` edge, `l` fixture, `c` colour, `i` intensity as a
//! multiple of full scale at 1 metre, `p` position, `t` target.

use crate::{
    decimal::read,
    edge, fixture,
    format::Format,
    map::Subject,
    refusal::Refusal,
    setting::{Setting, channels},
    state::{EXPOSURES, LIGHTS, SWITCHABLE, State},
    viewpoint::Viewpoint,
};
use luminaire::Vec3;
use luminaire_fixtures::Fixture;
use luminaire_render::scenes::Example;
use std::fmt::Write;

/// The version of this format of addresses.
const VERSION: &str = "1";

/// The names of what plays.
const PLAYS: [(&str, [bool; 2]); 4] =
    [("none", [false; 2]), ("lights", [true, false]), ("camera", [false, true]), ("both", [true; 2])];

/// Writes a state, for a scene with this number of lights.
pub(crate) fn write(state: &State, lights: usize) -> String {
    let opened = State::of(state.scene, lights);
    let mut text = format!("v={VERSION}&scene={}", state.scene.name());
    let mut put = |name: &str, differs: bool, value: &dyn Fn() -> String| {
        if differs {
            text.extend(["&", name, "=", &value()]);
        }
    };
    put("format", state.format != opened.format, &|| state.format.name().to_owned());
    put("with", state.other != opened.other, &|| state.other.map_or("", Format::name).to_owned());
    put("difference", state.is_difference, &|| "1".to_owned());
    put("view", state.viewpoint != opened.viewpoint, &|| numbers(&state.viewpoint.parts()));
    put("at", state.seconds != opened.seconds, &|| numbers(&state.seconds));
    let plays = PLAYS.iter().find(|(_, plays)| *plays == state.plays).map_or("", |(name, _)| name);
    put("play", state.plays != opened.plays, &|| plays.to_owned());
    put("lights", state.lights != opened.lights, &|| lights_text(&state.lights));
    let switched = SWITCHABLE
        .iter()
        .zip(state.switched)
        .filter_map(|((effect, _), on)| Some(format!("{}{}", if on? { "" } else { "-" }, effect.name())));
    put("effects", state.switched != opened.switched, &|| switched.clone().collect::<Vec<_>>().join("/"));
    put("map", state.map != opened.map, &|| state.map.name().to_owned());
    put("all", state.is_everything != opened.is_everything, &|| "1".to_owned());
    put("exposure", state.exposure != opened.exposure, &|| state.exposure.to_string());
    put("tone", state.keeps_hue != opened.keeps_hue, &|| "hue".to_owned());
    put("handles", state.shows_handles != opened.shows_handles, &|| "0".to_owned());
    text
}

/// Reads a state, in the scene `otherwise` if none is named. Returns also what was refused, which is
/// as the scene opens.
pub(crate) fn parse(text: &str, otherwise: Example) -> Result<(State, Vec<Refusal>), Refusal> {
    let mut refused = Vec::new();
    let scene = value_of(text, "scene").map_or(Ok(otherwise), scene_named).unwrap_or_else(|refusal| {
        refused.push(refusal);
        otherwise
    });
    let (state, more) = parse_in(scene, scene.setup()?.fixtures.len(), text);
    refused.extend(more);
    Ok((state, refused))
}

/// Reads a state of a scene with this number of lights, like [`parse`].
pub(crate) fn parse_in(scene: Example, lights: usize, text: &str) -> (State, Vec<Refusal>) {
    let (mut state, mut refused) = (State::of(scene, lights), Vec::new());
    if let Some(version) = value_of(text, "v").filter(|version| *version != VERSION) {
        refused.push(Refusal::name("v", version, "1, the version of addresses that this page reads"));
        return (state, refused);
    }
    for (name, value) in pairs(text) {
        if name == "lights" {
            let (read, bad) = read_lights(value, lights);
            state.lights = read.unwrap_or(state.lights);
            refused.extend(bad);
        } else {
            refused.extend(take(&mut state, name, value).err());
        }
    }
    (state, refused)
}

/// The parameters of an address with their values.
fn pairs(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.split('&').filter(|pair| !pair.is_empty()).map(|pair| pair.split_once('=').unwrap_or((pair, "")))
}

/// Returns the value of a parameter of an address.
pub(crate) fn value_of<'a>(text: &'a str, name: &str) -> Option<&'a str> {
    pairs(text).find(|(other, _)| *other == name).map(|(_, value)| value)
}

/// Returns the scene of this name.
pub(crate) fn scene_named(name: &str) -> Result<Example, Refusal> {
    Example::named(name).ok_or_else(|| Refusal::name("scene", name, "one of those on the list"))
}

/// Takes one parameter of an address other than the lights.
fn take(state: &mut State, name: &str, value: &str) -> Result<(), Refusal> {
    let refused = |name, expected| Refusal::name(name, value, expected);
    match name {
        // Both are read first.
        "v" | "scene" => {}
        "format" => state.format = Format::named(value)?,
        "with" => state.other = Some(Format::named(value)?),
        "difference" => state.is_difference = value == "1",
        "view" => {
            let viewpoint = read_numbers(value).and_then(Viewpoint::from_parts);
            state.viewpoint =
                viewpoint.ok_or_else(|| refused("view", "yaw/pitch/factor, as in 0.5/0/1.2"))?;
        }
        "at" => state.seconds = read_numbers(value).ok_or_else(|| refused("at", "seconds/seconds"))?,
        "play" => {
            let plays = PLAYS.iter().find(|(name, _)| *name == value);
            state.plays = plays.ok_or_else(|| refused("play", "none, lights, camera or both"))?.1;
        }
        "effects" => {
            for word in value.split('/') {
                let (name, on) = word.strip_prefix('-').map_or((word, true), |name| (name, false));
                let place = SWITCHABLE.iter().position(|(effect, _)| effect.name() == name);
                let expected = "specular, gobo, shadow, haze or dither, with - before it for off";
                state.switched[place.ok_or_else(|| refused("effects", expected))?] = Some(on);
            }
        }
        "map" => state.map = Subject::named(value)?,
        "all" => state.is_everything = value == "1",
        "exposure" => {
            let [least, most] = EXPOSURES;
            let stops = read(value).filter(|stops| (least..=most).contains(stops));
            state.exposure = stops.ok_or_else(|| refused("exposure", "-14 to 6 stops"))?;
        }
        "tone" => state.keeps_hue = value == "hue",
        "handles" => state.shows_handles = value != "0",
        _ => {
            return Err(Refusal::name(
                "parameter",
                name,
                "v, scene, format, with, difference, view, at, play, lights, effects, map, all, exposure, tone or handles",
            ));
        }
    }
    Ok(())
}

fn numbers(values: &[f32]) -> String {
    values.iter().map(f32::to_string).collect::<Vec<_>>().join("/")
}

fn read_numbers<const N: usize>(text: &str) -> Option<[f32; N]> {
    text.split('/').map(read).collect::<Option<Vec<_>>>()?.try_into().ok()
}

fn lights_text(lights: &[Setting]) -> String {
    let is_own = |setting: &Setting| *setting == Setting::of(setting.of);
    // Consecutive lights without settings are one range.
    let follows = |one: &Setting, next: &Setting| is_own(one) && is_own(next) && one.of + 1 == next.of;
    let run = |run: &[Setting]| match run {
        [one] => light_text(one),
        [first, .., last] => format!("{}-{}", first.of, last.of),
        [] => String::new(),
    };
    lights.chunk_by(follows).map(run).collect::<Vec<_>>().join(";")
}

fn light_text(setting: &Setting) -> String {
    let mut text = setting.of.to_string();
    let mut put = |letter: char, value: Option<String>| {
        if let Some(value) = value {
            // Writing to a string does not fail.
            let _ = write!(text, ":{letter}{value}");
        }
    };
    let vector = |v: Vec3<f32>| numbers(&[v.x, v.y, v.z]);
    put('x', (!setting.is_on).then(String::new));
    put('b', setting.design.beam.map(|degrees| degrees.to_string()));
    put('f', setting.design.field.map(|degrees| degrees.to_string()));
    put('e', setting.edge.map(|edge| edge.effect().name().to_owned()));
    put('l', setting.fixture.map(fixture::slug));
    put('c', setting.color.map(|[red, green, blue]| format!("{red:02x}{green:02x}{blue:02x}")));
    put('i', setting.intensity.map(|intensity| intensity.to_string()));
    put('p', setting.position.map(vector));
    put('t', setting.target.map(vector));
    text
}

/// Reads the lights. A bad light is as the scene has it, or left out if the scene has no such light. If
/// all are left out, the scene keeps its own lights.
fn read_lights(text: &str, count: usize) -> (Option<Vec<Setting>>, Vec<Refusal>) {
    let (mut lights, mut refused) = (Vec::new(), Vec::new());
    // No light at all is an empty text. A light that was added follows those of the scene.
    for word in text.split(';').filter(|word| !word.is_empty()) {
        if let Some(read) = read_light(word).filter(|read| read.iter().all(|setting| setting.of <= count)) {
            lights.extend(read);
        } else {
            refused.push(Refusal::name("lights", word, "a light of the scene and its settings"));
            let number = word.split(':').next().and_then(|number| number.parse().ok());
            lights.extend(number.filter(|&number| number <= count).map(Setting::of));
        }
    }
    if lights.len() > LIGHTS {
        let range = [0.0, LIGHTS as f32];
        refused.push(Refusal::outside("number of lights", lights.len() as f32, range, "lights"));
        lights.truncate(LIGHTS);
    }
    let is_kept = lights.is_empty() && !refused.is_empty();
    ((!is_kept).then_some(lights), refused)
}

/// Reads a light with its settings, or a range of lights.
fn read_light(word: &str) -> Option<Vec<Setting>> {
    if let Some((first, last)) = word.split_once('-').filter(|_| !word.contains(':')) {
        let (first, last) = (first.parse::<usize>().ok()?, last.parse::<usize>().ok()?);
        let is_range = first < last && last - first < LIGHTS;
        return is_range.then(|| (first..=last).map(Setting::of).collect());
    }
    let mut parts = word.split(':');
    let mut setting = Setting::of(parts.next()?.parse().ok()?);
    let vector = |value| read_numbers(value).map(|[x, y, z]| Vec3::new(x, y, z));
    for part in parts {
        let letter = part.chars().next()?;
        let value = &part[letter.len_utf8()..];
        match letter {
            'x' if value.is_empty() => setting.is_on = false,
            'b' => setting.design.beam = Some(read(value)?),
            'f' => setting.design.field = Some(read(value)?),
            'e' => setting.edge = Some(edge::named(value)?),
            'l' => setting.fixture = Some(fixture::with_slug(value)?),
            'c' => setting.color = Some(channels(value)?),
            'i' => setting.intensity = Some(read(value)?),
            'p' => setting.position = Some(vector(value)?),
            't' => setting.target = Some(vector(value)?),
            _ => return None,
        }
    }
    // The angle of a fixture is one of its zoom.
    let is_zoom = |fixture: &Fixture| {
        setting
            .design
            .one()
            .is_some_and(|(_, degrees)| (fixture.narrowest..=fixture.widest).contains(&degrees))
    };
    setting.fixture.is_none_or(is_zoom).then(|| vec![setting])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        design::Design,
        desk::Desk,
        light::Mark::{Beam, Field},
    };
    use luminaire_fixtures::FIXTURES;

    fn random_setting(random: &mut fastrand::Rng, of: usize) -> Setting {
        let mut setting = Setting::of(of);
        let vector = |random: &mut fastrand::Rng| Vec3::new(number(random), number(random), number(random));
        setting.is_on = random.bool();
        setting.edge = random.bool().then(|| random.choice(edge::all().collect::<Vec<_>>()).unwrap());
        let mark = if random.bool() { Beam } else { Field };
        match random.u8(..5) {
            0 => setting.design = Design::of(mark, number(random)),
            1 => setting.design = Design { beam: Some(number(random)), field: Some(number(random)) },
            2 => {
                let fixture = random.choice(FIXTURES).unwrap();
                let degrees = fixture.narrowest + random.f32() * (fixture.widest - fixture.narrowest);
                setting.fixture = Some(fixture);
                setting.design = Design::of(mark, degrees.min(fixture.widest));
            }
            _ => {}
        }
        setting.color = random.bool().then(|| [random.u8(..), random.u8(..), random.u8(..)]);
        setting.intensity = random.bool().then(|| number(random));
        setting.position = random.bool().then(|| vector(random));
        setting.target = random.bool().then(|| vector(random));
        setting
    }

    /// A number of any size and sign.
    fn number(random: &mut fastrand::Rng) -> f32 {
        std::iter::repeat_with(|| f32::from_bits(random.u32(..))).find(|number| number.is_finite()).unwrap()
    }

    fn random_state(random: &mut fastrand::Rng) -> (State, usize) {
        let scene = *random.choice(Example::ALL).unwrap();
        let count = scene.setup().unwrap().fixtures.len();
        let mut state = State::of(scene, count);
        state.format = random.choice(Format::ALL).unwrap();
        state.other = random.choice([None, Some(Format::Fx16), Some(Format::F32)]).flatten();
        state.is_difference = random.bool();
        state.viewpoint =
            Viewpoint::from_parts([number(random), number(random), number(random).abs().max(1e-30)]).unwrap();
        state.seconds = [number(random), number(random)];
        state.plays = [random.bool(), random.bool()];
        match random.u8(..3) {
            0 => {}
            1 => {
                let light = random.usize(..count);
                state.lights[light] = random_setting(random, light);
            }
            _ => {
                let lights = random.usize(..=LIGHTS);
                let numbers: Vec<_> = (0..lights).map(|_| random.usize(..=count)).collect();
                state.lights = numbers.into_iter().map(|of| random_setting(random, of)).collect();
            }
        }
        for switch in &mut state.switched {
            *switch = random.choice([None, Some(true), Some(false)]).flatten();
        }
        state.map =
            random.choice([Subject::Nothing, Subject::Lights, Subject::Cost, Subject::Tiles]).unwrap();
        state.is_everything = random.bool();
        let [least, most] = EXPOSURES;
        state.exposure = (least + random.f32() * (most - least)).min(most);
        state.keeps_hue = random.bool();
        state.shows_handles = random.bool();
        (state, count)
    }

    #[test]
    fn a_thousand_random_states_come_back() {
        let mut random = fastrand::Rng::with_seed(7);
        for _ in 0..1000 {
            let (state, count) = random_state(&mut random);
            let text = write(&state, count);
            assert!(text.bytes().all(|byte| byte.is_ascii_graphic() && !b"#%\"<>".contains(&byte)), "{text}");
            assert_eq!(parse(&text, Example::Pocket), Ok((state, Vec::new())), "{text}");
        }
    }

    #[test]
    fn a_scene_as_it_opens_is_its_name() {
        for &scene in Example::ALL {
            let count = scene.setup().unwrap().fixtures.len();
            let mut state = State::of(scene, count);
            assert_eq!(write(&state, count), format!("v=1&scene={}", scene.name()));
            state.lights[count / 2].is_on = false;
            assert!(write(&state, count).len() < 60, "{}", write(&state, count));
        }
    }

    #[test]
    fn a_bad_parameter_is_refused_by_its_name_and_the_rest_is_taken() {
        for (text, words) in [
            ("scene=nowhere", "scene = \"nowhere\""),
            ("scene=", "scene = \"\""),
            ("format=f16", "number format = \"f16\""),
            ("view=1/2", "view = \"1/2\""),
            ("view=0/0/-1", "view"),
            ("view=NaN/0/1", "view"),
            ("at=1", "at = \"1\""),
            ("play=all", "play = \"all\""),
            ("lights=999", "lights = \"999\""),
            ("lights=0:q", "lights = \"0:q\""),
            ("lights=0:b", "lights = \"0:b\""),
            ("lights=0:larri-l7-c", "lights"),
            ("lights=0:larri-l7-c:f5", "lights"),
            ("lights=0:larri-l7-c:b20:f25", "lights"),
            ("lights=0:eround", "lights"),
            ("lights=0:é", "lights"),
            ("lights=0:céé", "lights"),
            ("lights=5-1", "lights"),
            ("lights=0-99999999999999999999", "lights"),
            ("effects=spot", "effects = \"spot\""),
            ("map=heat", "subject of the map = \"heat\""),
            ("exposure=17", "exposure = \"17\""),
            ("constructor=1", "parameter = \"constructor\""),
        ] {
            let (state, refused) = parse(&format!("{text}&all=1"), Example::Show).unwrap();
            let refused: Vec<_> = refused.iter().map(ToString::to_string).collect();
            assert!(refused.len() == 1 && refused[0].contains(words), "{text}: {refused:?}");
            assert!(state.is_everything && state.scene == Example::Show);
        }
        let (state, refused) = parse("v=2&scene=grid&all=1", Example::Show).unwrap();
        assert!(refused[0].to_string().contains("v = \"2\"") && !state.is_everything);
    }

    #[test]
    fn one_bad_light_leaves_the_others() {
        let mut desk = Desk::new(Example::ThreePoint).unwrap();
        for (text, bad, words) in [
            ("lights=0:x;1:q;2:c00ff00", 1, "lights = \"1:q\""),
            ("lights=0:x;1:b400;2:c00ff00", 1, "light 2 is as the scene has it: beam angle = 400"),
            ("lights=0:x;1:i1000000000000;2:c00ff00", 1, "light 2 is as the scene has it: intensity"),
            ("format=fx16&lights=0:x;1:b0.1;2:c00ff00", 1, "16-bit fixed point cannot hold light 2"),
        ] {
            let refused: Vec<_> = desk.recall(text).unwrap().iter().map(ToString::to_string).collect();
            assert!(refused.len() == 1 && refused[0].contains(words), "{text}: {refused:?}");
            let lights = &desk.state().lights;
            assert_eq!((lights.len(), lights[bad]), (3, Setting::of(bad)), "{text}");
            assert!(!lights[0].is_on && lights[2].color == Some([0, 255, 0]), "{text}");
        }
        // Lights that the scene does not have are left out.
        for (text, count) in
            [("lights=0;77;2", 2), ("lights=77", 3), ("lights=", 0), ("lights=0-2;0-2;9-1", 6)]
        {
            desk.recall(text).unwrap();
            assert_eq!(desk.state().lights.len(), count, "{text}");
        }
        assert_eq!(desk.recall(&format!("lights={}", "0;".repeat(90))).unwrap().len(), 1);
        assert_eq!(desk.state().lights.len(), LIGHTS);
    }

    /// States that no light or format can have, and texts that are no states.
    #[test]
    fn whatever_the_address_is_there_is_a_picture() {
        let mut random = fastrand::Rng::with_seed(8);
        let mut desk = Desk::new(Example::Pocket).unwrap();
        let mut fallbacks = 0;
        for _ in 0..200 {
            let (state, count) = random_state(&mut random);
            let mut text = write(&state, count).into_bytes();
            if random.bool() {
                let place = random.usize(..text.len());
                text[place] = random.u8(32..127);
            }
            let refused = desk.recall(&String::from_utf8(text).unwrap()).unwrap();
            fallbacks += usize::from(!refused.is_empty());
            assert!(desk.rig().fixtures_at(desk.state().seconds[0]).is_ok());
        }
        assert!((20..200).contains(&fallbacks), "{fallbacks} of 200 are refused");
    }
}
