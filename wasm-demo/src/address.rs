//! The state as text, for the part of the page's address after the `#`.
//!
//! It begins with the version and the scene, and has only what differs from the scene as it opens, in
//! the order of [`PARAMETERS`]. Numbers of one value are separated by `/`, and lights by `_`: most programs that find
//! addresses in a text end them at a `;`, which older addresses have. A name that is no parameter is
//! ignored, because trackers add some. A light is its number in the scene, or a range of lights without
//! settings, as in `3-7`; the number after the last one is a light that the visitor has added. Its [`SETTINGS`] follow, each with `:`, a letter and a value.

use crate::{
    decimal::{numbers, read, read_numbers},
    design::Design,
    fixture,
    kind::KINDS,
    model::Chosen,
    name::Name,
    own_cone,
    parameter::{self, Kind, PARAMETERS},
    refusal::Refusal,
    setting::{Setting, channels},
    state::{LIGHTS, State},
};
use luminaire::{
    attenuation::{AnyAttenuation, Polynomial},
    falloff::AnyFalloff,
};
use luminaire_fixtures::Fixture;
use luminaire_render::scenes::Example;

/// The version of this format of addresses.
const VERSION: &str = "1";

/// A setting of a light: its letter, how it is written, and how it is read into a light. `None` is a text that
/// is no such setting.
type Letter = (char, fn(&Setting) -> Option<String>, fn(&str, &mut Setting) -> Option<()>);

/// The settings of a light: `x` off, `n` name, `k` kind, `a` law of distance and `e` edge, by their names and numbers,
/// `o` own cone, `b` and `f` beam and field angle, `l` fixture, `c` colour, `w` white of a colour temperature, `i`
/// intensity as a multiple of full scale at 1 metre, `p` position, `t` target. Three numbers without a name are a
/// polynomial of the distance, as in older addresses. The edge is before the angles, because a soft one has pairs of
/// angles that no other has.
const SETTINGS: [Letter; 14] = [
    (
        'x',
        |light| (!light.is_on).then(String::new),
        |text, light| text.is_empty().then(|| light.is_on = false),
    ),
    (
        'n',
        |light| Some(light.name?.to_string()),
        |text, light| Name::of(text).map(|name| light.name = Some(name)),
    ),
    (
        'k',
        |light| Some(light.kind?.name().to_owned()),
        |text, light| KINDS.iter().find(|kind| kind.name() == text).map(|kind| light.kind = Some(*kind)),
    ),
    (
        'a',
        |light| Some(light.law?.written()),
        |text, light| {
            let older = read_numbers(text).and_then(|[a, b, c]| Some(Polynomial::new(a, b, c).ok()?.into()));
            older.or_else(|| AnyAttenuation::read(text)).map(|law| light.law = Some(law))
        },
    ),
    (
        'o',
        |light| Some(own_cone::write(&light.own?)),
        |text, light| own_cone::read(text).map(|cone| light.own = Some(cone)),
    ),
    (
        'e',
        |light| Some(light.edge?.written()),
        |text, light| AnyFalloff::read(text).map(|edge| light.edge = Some(edge)),
    ),
    (
        'b',
        |light| Some(light.design.beam?.to_string()),
        |text, light| read(text).map(|degrees| light.design.beam = Some(degrees)),
    ),
    (
        'f',
        |light| Some(light.design.field?.to_string()),
        |text, light| read(text).map(|degrees| light.design.field = Some(degrees)),
    ),
    (
        'l',
        |light| Some(fixture::slug(light.fixture?)),
        |text, light| fixture::with_slug(text).map(|fixture| light.fixture = Some(fixture)),
    ),
    (
        'c',
        |light| light.color.map(|[red, green, blue]| format!("{red:02x}{green:02x}{blue:02x}")),
        |text, light| channels(text).map(|color| light.color = Some(color)),
    ),
    (
        'w',
        |light| Some(light.kelvin?.to_string()),
        |text, light| read(text).map(|kelvin| (light.kelvin, light.color) = (Some(kelvin), None)),
    ),
    (
        'i',
        |light| Some(light.intensity?.to_string()),
        |text, light| read(text).map(|intensity| light.intensity = Some(intensity)),
    ),
    (
        'p',
        |light| Some(numbers(&<[f32; 3]>::from(light.position?))),
        |text, light| read_numbers(text).map(|point: [f32; 3]| light.position = Some(point.into())),
    ),
    (
        't',
        |light| Some(numbers(&<[f32; 3]>::from(light.target?))),
        |text, light| read_numbers(text).map(|point: [f32; 3]| light.target = Some(point.into())),
    ),
];

/// Writes a state, for a scene with this number of lights.
pub(crate) fn write(state: &State, lights: usize) -> String {
    let opened = State::of(state.scene, lights);
    let mut text = format!("v={VERSION}&scene={}", state.scene.name());
    for parameter in &PARAMETERS {
        let value = match parameter.kind {
            Kind::Lights => (state.lights != opened.lights).then(|| lights_text(&state.lights)),
            _ => parameter.write(state, &opened),
        };
        if let Some(value) = value {
            text.extend(["&", parameter.name, "=", &value]);
        }
    }
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
        match parameter::named(name) {
            Ok(parameter) if matches!(parameter.kind, Kind::Lights) => {
                let (read, bad) = read_lights(value, lights);
                state.lights = read.unwrap_or(state.lights);
                refused.extend(bad);
            }
            Ok(parameter) => refused.extend(parameter.read(&mut state, value).err()),
            Err(_) => {}
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

fn lights_text(lights: &[Setting]) -> String {
    let is_own = |setting: &Setting| *setting == Setting::of(setting.of);
    // Consecutive lights without settings are one range.
    let follows = |one: &Setting, next: &Setting| is_own(one) && is_own(next) && one.of + 1 == next.of;
    let run = |run: &[Setting]| match run {
        [one] => light_text(one),
        [first, .., last] => format!("{}-{}", first.of, last.of),
        [] => String::new(),
    };
    lights.chunk_by(follows).map(run).collect::<Vec<_>>().join("_")
}

/// Writes a light.
pub(crate) fn light_text(light: &Setting) -> String {
    let setting = |(letter, write, _): &Letter| Some(format!(":{letter}{}", write(light)?));
    light.of.to_string() + &SETTINGS.iter().filter_map(setting).collect::<String>()
}

/// Reads the lights. A bad light has its good settings, or is left out if the scene has no such light. If
/// all are left out, the scene keeps its own lights.
fn read_lights(text: &str, count: usize) -> (Option<Vec<Setting>>, Vec<Refusal>) {
    let (mut lights, mut refused) = (Vec::new(), Vec::new());
    // No light at all is an empty text. A light that was added follows those of the scene.
    for word in text.split(['_', ';']).filter(|word| !word.is_empty()) {
        let read = read_light(word, &|_| true);
        let (read, has_all) =
            read.filter(|(read, _)| read.iter().all(|light| light.of <= count)).unwrap_or_default();
        if !has_all {
            refused.push(Refusal::name("lights", word, "a light of the scene and its settings"));
        }
        lights.extend(read);
    }
    if lights.len() > LIGHTS {
        let range = [0.0, LIGHTS as f32];
        refused.push(Refusal::outside("number of lights", lights.len() as f32, range, "lights"));
        lights.truncate(LIGHTS);
    }
    let is_kept = lights.is_empty() && !refused.is_empty();
    ((!is_kept).then_some(lights), refused)
}

/// Reads a light with its settings, or a range of lights. Returns also whether it has all settings:
/// one that is bad, or with which `is_taken` is false, is left out.
pub(crate) fn read_light(word: &str, is_taken: &dyn Fn(&Setting) -> bool) -> Option<(Vec<Setting>, bool)> {
    if let Some((first, last)) = word.split_once('-').filter(|_| !word.contains(':')) {
        let (first, last) = (first.parse::<usize>().ok()?, last.parse::<usize>().ok()?);
        let is_range = first < last && last - first < LIGHTS;
        return is_range.then(|| ((first..=last).map(Setting::of).collect(), true));
    }
    // The angle of a fixture is one of its zoom.
    let is_zoom = |design: &Design, fixture: &Fixture| {
        design.one().is_some_and(|(_, degrees)| (fixture.narrowest..=fixture.widest).contains(&degrees))
    };
    let mut parts = word.split(':');
    let mut setting = Setting::of(parts.next()?.parse().ok()?);
    let mut has_all = true;
    for part in parts {
        let letter = part.chars().next().unwrap_or_default();
        let row = SETTINGS.iter().find(|(other, ..)| *other == letter);
        let mut next = setting;
        let is_read = row.is_some_and(|(_, _, read)| read(&part[letter.len_utf8()..], &mut next).is_some());
        if is_read && next.fixture.is_none_or(|own| is_zoom(&next.design, own)) && is_taken(&next) {
            setting = next;
        } else {
            has_all = false;
        }
    }
    Some((vec![setting], has_all))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        design::Mark::{Beam, Field},
        format::Format,
        map::Subject,
        stage::Stage,
        state::EXPOSURES,
        viewpoint::Viewpoint,
    };
    use luminaire::{Cone, Vec3};
    use luminaire_fixtures::FIXTURES;
    use luminaire_render::Output;

    /// Any model with any numbers that it accepts.
    fn any<M: Chosen>(random: &mut fastrand::Rng) -> M {
        let model = random.choice(M::all()).unwrap();
        let values: Vec<_> = model.list().iter().map(|number| number.anywhere(random.f32())).collect();
        model.with_values(&values).unwrap_or(model)
    }

    fn random_setting(random: &mut fastrand::Rng, of: usize) -> Setting {
        let mut setting = Setting::of(of);
        let vector = |random: &mut fastrand::Rng| Vec3::new(number(random), number(random), number(random));
        setting.is_on = random.bool();
        setting.edge = random.bool().then(|| any(random));
        setting.own = random.bool().then(|| {
            let falloff: AnyFalloff = any(random);
            let outer = random.f32().max(1e-6);
            Cone::from_versines(falloff, [random.f32() * outer, outer, outer]).unwrap()
        });
        setting.name = random.bool().then(|| Name::of(&format!("{:x}", random.u64(..))).unwrap());
        setting.kind = random.bool().then(|| random.choice(KINDS).unwrap());
        setting.law = random.bool().then(|| any(random));
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
        let is_white = setting.color.is_none() && random.bool();
        setting.kelvin = is_white.then(|| 1000.0 + 24_000.0 * random.f32());
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
        state.map = random.choice(Subject::ALL).unwrap();
        state.is_everything = random.bool();
        let [least, most] = EXPOSURES;
        state.exposure = (least + random.f32() * (most - least)).min(most);
        state.output = random.choice(Output::ALL.iter().copied()).unwrap();
        state.highlight = random.choice(["own", "0.25"]).unwrap();
        state.shininess = random.choice(["own", "1024"]).unwrap();
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
    fn a_polynomial_of_an_older_address_is_read() {
        let (state, refused) = parse("scene=three-point&lights=0:a0/2/1", Example::Pocket).unwrap();
        let law = Some(Polynomial::new(0.0, 2.0, 1.0).unwrap().into());
        assert_eq!((&state.lights[..], refused), (&[Setting { law, ..Setting::of(0) }][..], Vec::new()));
        assert!(write(&state, 3).ends_with("lights=0:apolynomial/0/2/1"), "{}", write(&state, 3));
    }

    #[test]
    fn names_of_others_are_ignored_and_older_addresses_are_read() {
        let newer = "scene=three-point&lights=0:x_2:b12";
        let (state, refused) = parse(newer, Example::Pocket).unwrap();
        assert_eq!((state.lights.len(), &refused[..]), (2, &[][..]));
        assert_eq!(write(&state, 3), format!("v=1&{newer}"));
        for other in [
            "scene=three-point&lights=0:x;2:b12",
            "fbclid=a&constructor=1&scene=three-point&lights=0:x_2:b12&=",
        ] {
            assert_eq!(parse(other, Example::Pocket), Ok((state.clone(), Vec::new())), "{other}");
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
            ("lights=0:kround", "lights"),
            ("lights=0:a0/0/-1", "lights = \"0:a0/0/-1\""),
            ("lights=0:apolynomial/0/0", "lights = \"0:apolynomial/0/0\""),
            ("lights=0:epower/9999", "lights = \"0:epower/9999\""),
            ("shininess=100", "shininess = \"100\": expected own, 8, 16, 32"),
            ("lights=0:é", "lights"),
            ("lights=0:céé", "lights"),
            ("lights=5-1", "lights"),
            ("lights=0-99999999999999999999", "lights"),
            ("effects=spot", "effects = \"spot\""),
            ("map=heat", "subject of the map = \"heat\""),
            ("exposure=17", "exposure = \"17\""),
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
        let mut stage = Stage::of(Example::ThreePoint).unwrap();
        for (text, bad, words) in [
            ("lights=0:x;1:q;2:c00ff00", 1, "lights = \"1:q\""),
            ("lights=0:x;1:b400;2:c00ff00", 1, "light 2 is without this setting: beam angle = 400"),
            ("lights=0:x;1:i1000000000000;2:c00ff00", 1, "light 2 is without this setting: intensity"),
            ("format=fx16&lights=0:x;1:b0.1;2:c00ff00", 1, "16-bit fixed point cannot hold light 2"),
        ] {
            let refused: Vec<_> = stage.take_address(text).unwrap().iter().map(ToString::to_string).collect();
            assert!(refused.len() == 1 && refused[0].contains(words), "{text}: {refused:?}");
            let lights = &stage.state().lights;
            assert_eq!((lights.len(), lights[bad]), (3, Setting::of(bad)), "{text}");
            assert!(!lights[0].is_on && lights[2].color == Some([0, 255, 0]), "{text}");
        }
        // Nor does a bad setting take the other ones of its light.
        for bad in ["q", "kround", "a1/2", "a0/0/-3", "b400", "i1000000000000"] {
            let refused = stage.take_address(&format!("lights=0:x:{bad}:c00ff00")).unwrap();
            let good = Setting { is_on: false, color: Some([0, 255, 0]), ..Setting::of(0) };
            assert_eq!((refused.len(), &stage.state().lights[..]), (1, &[good][..]), "{bad}: {refused:?}");
        }
        // Lights that the scene does not have are left out.
        for (text, count) in
            [("lights=0;77;2", 2), ("lights=77", 3), ("lights=", 0), ("lights=0-2;0-2;9-1", 6)]
        {
            stage.take_address(text).unwrap();
            assert_eq!(stage.state().lights.len(), count, "{text}");
        }
        assert_eq!(stage.take_address(&format!("lights={}", "0;".repeat(90))).unwrap().len(), 1);
        assert_eq!(stage.state().lights.len(), LIGHTS);
    }

    /// States that no light or format can have, and texts that are no states.
    #[test]
    fn whatever_the_address_is_there_is_a_picture() {
        let mut random = fastrand::Rng::with_seed(8);
        let mut stage = Stage::of(Example::Pocket).unwrap();
        let mut fallbacks = 0;
        for _ in 0..200 {
            let (state, count) = random_state(&mut random);
            let mut text = write(&state, count).into_bytes();
            if random.bool() {
                let place = random.usize(..text.len());
                text[place] = random.u8(32..127);
            }
            let refused = stage.take_address(&String::from_utf8(text).unwrap()).unwrap();
            fallbacks += usize::from(!refused.is_empty());
            assert!(stage.rig().fixtures_at(stage.state().seconds[0]).is_ok());
        }
        assert!((20..200).contains(&fallbacks), "{fallbacks} of 200 are refused");
    }
}
