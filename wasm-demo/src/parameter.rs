//! The parameters of the state: one table. A row gives its parameter of an address, the check and the
//! refusal of its values, and its control on the page.

use crate::{
    decimal::{numbers, read, read_numbers},
    format::Format,
    map::Subject,
    plain::plain,
    quantity::SHININESS,
    refusal::{Refusal, choose, one_of},
    state::{EXPOSURE_STEP, EXPOSURES, SWITCHABLE, State, switch_of, switchable},
    viewpoint::Viewpoint,
};
use luminaire::dynamic::Effect;
use luminaire_render::Output;
use wasm_bindgen::JsValue;

/// The parameters in the order of an address.
pub(crate) const PARAMETERS: [Parameter; 18] = [
    Parameter { name: "v", kind: Kind::Opening },
    Parameter { name: "scene", kind: Kind::Opening },
    choice(
        "format",
        &[["fx16", "16 bits, as on a chip"], ["fx32", "32-bit fixed point"], ["f32", "32-bit float"]],
        |state| state.format.name(),
        |state, name| Format::named(name.unwrap_or("")).map(|format| state.format = format),
    ),
    // The format of the other half of a divided picture.
    choice(
        "with",
        &[
            ["", "nothing"],
            ["fx16", "16-bit fixed point"],
            ["fx32", "32-bit fixed point"],
            ["f32", "32-bit float"],
        ],
        |state| state.other.map_or("", Format::name),
        |state, name| name.map(Format::named).transpose().map(|format| state.other = format),
    ),
    // Whether the difference between both formats covers the picture.
    flag("difference", ("1", true), |state| state.is_difference, |state, on| state.is_difference = on),
    text("view", |state| numbers(&state.viewpoint.parts()), set_view),
    // The times of lights and camera.
    text("at", |state| numbers(&state.seconds), set_times),
    text("play", plays, set_plays),
    Parameter { name: "lights", kind: Kind::Lights },
    text("effects", switched, set_switched),
    // What is shown over the picture.
    choice(
        "map",
        &[
            ["nothing", "nothing"],
            ["lights", "lights evaluated"],
            ["cost", "lighting time"],
            ["tiles", "tiles lit again"],
        ],
        |state| state.map.name(),
        |state, name| Subject::named(name.unwrap_or("")).map(|map| state.map = map),
    ),
    // Whether every effect is evaluated.
    flag("all", ("1", true), |state| state.is_everything, |state, on| state.is_everything = on),
    Parameter {
        name: "exposure",
        kind: Kind::Number {
            range: EXPOSURES,
            step: EXPOSURE_STEP,
            unit: "stops",
            symbol: "EV",
            get: |state| state.exposure,
            set: |state, stops| state.exposure = stops,
        },
    },
    // The highlights of all surfaces.
    choice(
        "highlight",
        &HIGHLIGHTS,
        |state| state.highlight,
        |state, name| {
            choose("highlight", name.unwrap_or(""), &HIGHLIGHTS, |[name, _]| name)
                .map(|[level, _]| state.highlight = level)
        },
    ),
    choice(
        SHININESS.name,
        &SHININESSES,
        |state| state.shininess,
        |state, name| {
            choose(SHININESS.name, name.unwrap_or(""), &SHININESSES, |[name, _]| name)
                .map(|[level, _]| state.shininess = level)
        },
    ),
    choice(
        "display",
        &OUTPUTS,
        |state| state.output.name(),
        |state, name| {
            choose("display", name.unwrap_or(""), Output::ALL, Output::name)
                .map(|output| state.output = output)
        },
    ),
    // Whether overexposed light keeps its hue.
    flag("tone", ("hue", true), |state| state.keeps_hue, |state, on| state.keeps_hue = on),
    // Whether the lights are drawn over the picture.
    flag("handles", ("0", false), |state| state.shows_handles, |state, on| state.shows_handles = on),
];

/// The names and titles of the displays.
const OUTPUTS: [[&str; 2]; Output::ALL.len()] = {
    let mut outputs = [[""; 2]; Output::ALL.len()];
    let mut i = 0;
    while i < outputs.len() {
        outputs[i] = [Output::ALL[i].name(), Output::ALL[i].title()];
        i += 1;
    }
    outputs
};

/// The strengths of highlights: shares of the light.
const HIGHLIGHTS: [[&str; 2]; 7] = levels(["own", "0", "0.05", "0.1", "0.25", "0.5", "1"]);

/// The exponents of highlights, each twice the one before, between the ends of [`SHININESS`].
const SHININESSES: [[&str; 2]; 9] = levels(["own", "8", "16", "32", "64", "128", "256", "512", "1024"]);

/// Names as their own labels, but for the first one.
const fn levels<const N: usize>(names: [&'static str; N]) -> [[&'static str; 2]; N] {
    let mut levels = [["own", "as the scene has it"]; N];
    let mut i = 1;
    while i < N {
        levels[i] = [names[i]; 2];
        i += 1;
    }
    levels
}

/// The names of what plays.
const PLAYS: [(&str, [bool; 2]); 4] =
    [("none", [false; 2]), ("lights", [true, false]), ("camera", [false, true]), ("both", [true; 2])];

/// A parameter of the state.
#[derive(Debug)]
pub(crate) struct Parameter {
    /// The name in addresses and for the page.
    pub(crate) name: &'static str,
    pub(crate) kind: Kind,
}

/// The values of a parameter, and where the state has them.
#[derive(Debug)]
pub(crate) enum Kind {
    /// The version or the scene, which are read before everything else.
    Opening,
    /// The lights: see [`address`](crate::address).
    Lights,
    /// On or off. In an address `text` has this meaning, and every other text the opposite one, which
    /// is that of a scene as it opens.
    Flag { text: (&'static str, bool), get: fn(&State) -> bool, set: fn(&mut State, bool) },
    /// A number within a range, which the page shows with a symbol of its unit.
    Number {
        range: [f32; 2],
        step: f32,
        unit: &'static str,
        symbol: &'static str,
        get: fn(&State) -> f32,
        set: fn(&mut State, f32),
    },
    /// One of these names, each with its label. The empty name is that of no value, which an address
    /// leaves out.
    Choice {
        choices: &'static [[&'static str; 2]],
        get: fn(&State) -> &'static str,
        set: fn(&mut State, Option<&str>) -> Result<(), Refusal>,
    },
    /// A text of an address, which no single control sets.
    Text { get: fn(&State) -> String, set: fn(&mut State, &str) -> Result<(), Refusal> },
}

/// The value of a parameter.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Value {
    /// No value: the page has passed nothing.
    Nothing,
    Flag(bool),
    Number(f32),
    Text(String),
}

/// Returns the parameter of this name.
pub(crate) fn named(name: &str) -> Result<&'static Parameter, Refusal> {
    let found = PARAMETERS.iter().find(|parameter| parameter.name == name);
    found.ok_or_else(|| Refusal::name("parameter", name, one_of(PARAMETERS.iter().map(|one| one.name))))
}

impl Parameter {
    /// Returns the value that a state has.
    pub(crate) fn get(&self, state: &State) -> Value {
        match self.kind {
            Kind::Opening | Kind::Lights => Value::Nothing,
            Kind::Flag { get, .. } => Value::Flag(get(state)),
            Kind::Number { get, .. } => Value::Number(get(state)),
            Kind::Choice { get, .. } => get(state).into(),
            Kind::Text { get, .. } => Value::Text(get(state)),
        }
    }

    /// Sets a value.
    pub(crate) fn set(&self, state: &mut State, value: Value) -> Result<(), Refusal> {
        match (&self.kind, value) {
            (Kind::Flag { set, .. }, Value::Flag(on)) => set(state, on),
            (&Kind::Number { range, unit, set, .. }, Value::Number(value)) => {
                let [least, most] = range;
                if !(least..=most).contains(&value) {
                    return Err(Refusal::outside(self.name, value, range, unit));
                }
                set(state, value);
            }
            (Kind::Choice { set, .. }, Value::Nothing) => set(state, None)?,
            (Kind::Choice { set, .. }, Value::Text(name)) => set(state, Some(&name))?,
            (Kind::Text { set, .. }, Value::Text(text)) => set(state, &text)?,
            (_, value) => {
                return Err(Refusal::name(self.name, &value.text(), "a value of the parameter's kind"));
            }
        }
        Ok(())
    }

    /// Writes the value of a state for an address; `None` if the scene opens with it.
    pub(crate) fn write(&self, state: &State, opened: &State) -> Option<String> {
        let value = self.get(state);
        (value != self.get(opened)).then(|| match self.kind {
            Kind::Flag { text: (text, _), .. } => text.to_owned(),
            _ => value.text(),
        })
    }

    /// Takes the value of an address.
    pub(crate) fn read(&self, state: &mut State, text: &str) -> Result<(), Refusal> {
        let value = match self.kind {
            Kind::Opening | Kind::Lights => return Ok(()),
            Kind::Flag { text: (word, meaning), .. } => Value::Flag((text == word) == meaning),
            Kind::Number { range: [least, most], unit, .. } => {
                let within = read(text).filter(|number| (least..=most).contains(number));
                let refused = || Refusal::name(self.name, text, format!("{least} to {most} {unit}"));
                Value::Number(within.ok_or_else(refused)?)
            }
            Kind::Choice { .. } | Kind::Text { .. } => text.into(),
        };
        self.set(state, value)
    }
}

const fn flag(
    name: &'static str,
    text: (&'static str, bool),
    get: fn(&State) -> bool,
    set: fn(&mut State, bool),
) -> Parameter {
    Parameter { name, kind: Kind::Flag { text, get, set } }
}

const fn choice(
    name: &'static str,
    choices: &'static [[&'static str; 2]],
    get: fn(&State) -> &'static str,
    set: fn(&mut State, Option<&str>) -> Result<(), Refusal>,
) -> Parameter {
    Parameter { name, kind: Kind::Choice { choices, get, set } }
}

const fn text(
    name: &'static str,
    get: fn(&State) -> String,
    set: fn(&mut State, &str) -> Result<(), Refusal>,
) -> Parameter {
    Parameter { name, kind: Kind::Text { get, set } }
}

fn set_view(state: &mut State, text: &str) -> Result<(), Refusal> {
    let viewpoint = read_numbers(text).and_then(Viewpoint::from_parts);
    let refused = || Refusal::name("view", text, "yaw/pitch/factor, as in 0.5/0/1.2");
    state.viewpoint = viewpoint.ok_or_else(refused)?;
    Ok(())
}

fn set_times(state: &mut State, text: &str) -> Result<(), Refusal> {
    state.seconds = read_numbers(text).ok_or_else(|| Refusal::name("at", text, "seconds/seconds"))?;
    Ok(())
}

fn plays(state: &State) -> String {
    PLAYS.iter().find(|(_, plays)| *plays == state.plays).map_or("", |(name, _)| name).to_owned()
}

fn set_plays(state: &mut State, text: &str) -> Result<(), Refusal> {
    let plays = PLAYS.iter().find(|(name, _)| *name == text);
    let refused = || Refusal::name("play", text, one_of(PLAYS.iter().map(|(name, _)| *name)));
    state.plays = plays.ok_or_else(refused)?.1;
    Ok(())
}

fn switched(state: &State) -> String {
    let switched = SWITCHABLE.iter().zip(state.switched);
    let name = |effect: &Effect, on| format!("{}{}", if on { "" } else { "-" }, effect.name());
    let names = switched.filter_map(|((effect, _), on)| Some(name(effect, on?)));
    names.collect::<Vec<_>>().join("/")
}

fn set_switched(state: &mut State, text: &str) -> Result<(), Refusal> {
    for word in text.split('/') {
        let (name, on) = word.strip_prefix('-').map_or((word, true), |name| (name, false));
        let refused = || Refusal::name("effects", text, switchable() + ", with - before it for off");
        state.switched[switch_of(name).ok_or_else(refused)?] = Some(on);
    }
    Ok(())
}

impl Value {
    /// The value in words and in addresses.
    fn text(self) -> String {
        match self {
            Self::Nothing => String::new(),
            Self::Flag(on) => on.to_string(),
            Self::Number(number) => number.to_string(),
            Self::Text(text) => text,
        }
    }
}

impl From<bool> for Value {
    fn from(on: bool) -> Self {
        Self::Flag(on)
    }
}

impl From<f32> for Value {
    fn from(number: f32) -> Self {
        Self::Number(number)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

plain! {
    /// What the control of a parameter offers: the least and the largest number and the step between two,
    /// with the symbol of its unit; or the name of each choice, followed by its label. Empty for other values.
    fn offer(parameter: &Parameter) -> ParameterState {
        "name": "string" = parameter.name,
        "range": "number[]" = match parameter.kind {
            Kind::Number { range: [least, most], step, .. } => vec![JsValue::from(least), most.into(), step.into()],
            _ => Vec::new(),
        },
        "symbol": "string" = match parameter.kind {
            Kind::Number { symbol, .. } => symbol,
            _ => "",
        },
        "choices": "string[]" = match parameter.kind {
            Kind::Choice { choices, .. } => choices.concat().into_iter().map(JsValue::from).collect(),
            _ => Vec::new(),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luminaire_render::scenes::Example;

    #[test]
    fn every_control_of_the_page_sets_what_it_offers() {
        let opened = State::of(Example::Show, 0);
        for parameter in &PARAMETERS {
            let values: Vec<Value> = match parameter.kind {
                Kind::Opening | Kind::Lights | Kind::Text { .. } => continue,
                Kind::Flag { .. } => vec![true.into(), false.into()],
                Kind::Number { range, .. } => range.map(Value::from).into(),
                Kind::Choice { choices, .. } => choices.iter().map(|[name, _]| Value::from(*name)).collect(),
            };
            for value in values {
                let mut state = opened.clone();
                let set = if value == "".into() { Value::Nothing } else { value.clone() };
                parameter.set(&mut state, set).unwrap();
                assert_eq!(parameter.get(&state), value, "{}", parameter.name);
            }
        }
    }

    #[test]
    fn values_of_another_range_or_kind_are_refused_and_change_nothing() {
        let mut state = State::of(Example::Show, 0);
        let opened = state.clone();
        for (name, value, words) in [
            ("exposure", Value::Number(7.0), "exposure = 7: expected -14 to 6 stops"),
            ("exposure", Value::Number(f32::NAN), "exposure = NaN"),
            ("exposure", Value::Flag(true), "exposure = \"true\""),
            ("format", Value::Nothing, "number format = \"\": expected fx16, fx32 or f32"),
            ("map", "heat".into(), "subject of the map = \"heat\": expected nothing, lights, cost or tiles"),
            ("display", "gray3".into(), "display = \"gray3\": expected gray1, gray2, gray4"),
            ("lights", "0".into(), "lights = "),
        ] {
            let refusal = named(name).unwrap().set(&mut state, value).unwrap_err().to_string();
            assert!(refusal.contains(words), "{refusal}");
        }
        assert_eq!(state, opened);
        let refusal = named("constructor").unwrap_err().to_string();
        assert!(refusal.ends_with("v, scene, format, with, difference, view, at, play, lights, effects, map, all, exposure, highlight, shininess, display, tone or handles"), "{refusal}");
    }
}
