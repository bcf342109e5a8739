//! The places of LEDs, from the maps that people have.

use serde_json::Value;

use crate::refusal::Refusal;

/// The most LEDs of a map: an index of 16 bits sets the phase of each.
const MOST: usize = 65_536;

/// The most bytes of a map of a matrix: a longer text is not parsed to find out whether it is one.
const LONGEST: usize = 1 << 20;

/// What a map of LEDs holds, in the order of the LEDs and in the map's own coordinates and units.
#[derive(Debug, PartialEq)]
pub struct LedMap {
    /// The places.
    pub places: Vec<[f64; 3]>,
    /// The ways that the LEDs face, of any length, if the map says so.
    pub facing: Option<Vec<[f64; 3]>>,
}

impl LedMap {
    /// Returns whether a file is a map: a table by its name (`.csv`), or a text that begins as the maps in JSON or those of
    /// GIFT trees do. No file of lights does.
    pub fn is_map(name: &str, text: &str) -> bool {
        let is_table = name.rsplit_once('.').is_some_and(|(_, kind)| kind.eq_ignore_ascii_case("csv"));
        let is_matrix = |text: &str| {
            text.len() <= LONGEST
                && serde_json::from_str::<Value>(text).is_ok_and(|value| value["map"].is_array())
        };
        match trimmed(text) {
            text if is_table || text.starts_with('[') => true,
            text => text.starts_with('{') && is_matrix(text),
        }
    }

    /// Reads a table of numbers, with or without a line of names, such as those of GIFT trees (`x,y,z` or `[x, y, z]`) and of
    /// marimapper (`index,x,y,z,xn,yn,zn,error`); a Pixelblaze map, `[[x, y, z], ..]`; or a WLED map of a matrix,
    /// `{"width": .., "map": [..]}`, whose LEDs are a unit apart.
    ///
    /// # Errors
    /// A text that is no such map, with the line or the number of the LED; no LED, or more than 65,536.
    pub fn read(text: &str) -> Result<Self, Refusal> {
        let text = trimmed(text);
        let lists = text.strip_prefix('[').is_some_and(|rest| rest.trim_start().starts_with('['));
        let map = if lists || text.starts_with('{') { json(text) } else { table(text) }?;
        let count = map.places.len();
        if count == 0 || count > MOST {
            return Err(Refusal::new(
                "LEDs",
                count,
                format_args!("1 to {MOST}: a line or a list of numbers for each"),
            ));
        }
        Ok(map)
    }
}

/// Returns a text without a byte order mark and the space around it.
fn trimmed(text: &str) -> &str {
    text.trim_start_matches('\u{feff}').trim()
}

fn json(text: &str) -> Result<LedMap, Refusal> {
    let value: Value = serde_json::from_str(text).map_err(|error| Refusal::new("map", error, "JSON"))?;
    let places = match &value {
        Value::Array(places) => {
            (0..).zip(places).map(|(led, own)| place(own).map_err(|own| own.at(format_args!("LED {led}"))))
        }
        _ => return matrix(&value),
    };
    Ok(LedMap { places: places.collect::<Result<_, _>>()?, facing: None })
}

/// A list of two or three numbers; the third is 0 without it.
fn place(own: &Value) -> Result<[f64; 3], Refusal> {
    let numbers: Option<Vec<_>> = own.as_array().and_then(|own| own.iter().map(Value::as_f64).collect());
    match numbers.as_deref() {
        Some(&[x, y]) => Ok([x, y, 0.0]),
        Some(&[x, y, z]) => Ok([x, y, z]),
        _ => Err(Refusal::new("place", own, "two or three numbers, as in [0.5, 0, 1.2]")),
    }
}

/// The places of a matrix that WLED maps: each entry is the LED of a place, row by row from the top, or -1.
fn matrix(value: &Value) -> Result<LedMap, Refusal> {
    let expected = "a whole number of columns, as WLED writes it beside `map`";
    let width = value["width"].as_u64().filter(|width| *width > 0);
    let width = width.ok_or_else(|| Refusal::new("width", &value["width"], expected))? as usize;
    let list = value["map"].as_array();
    let list = list
        .ok_or_else(|| Refusal::new("map", &value["map"], "a list of LEDs: a map of WLED or Pixelblaze"))?;
    let rows = list.len().div_ceil(width);
    let mut found = Vec::new();
    for (at, led) in list.iter().enumerate() {
        match led.as_i64() {
            Some(-1) => {}
            Some(led) if (0..MOST as i64).contains(&led) => {
                found.push((led, [(at % width) as f64, 0.0, (rows - 1 - at / width) as f64]));
            }
            _ => {
                return Err(Refusal::new("LED", led, format_args!("-1, or 0 to {}", MOST - 1))
                    .at(format_args!("map[{at}]")));
            }
        }
    }
    found.sort_by_key(|(led, _)| *led);
    ordered(found.iter().map(|(led, _)| *led as usize))?;
    Ok(LedMap { places: found.into_iter().map(|(_, place)| place).collect(), facing: None })
}

/// Fails unless the sorted LEDs are 0, 1, and so on.
fn ordered(leds: impl Iterator<Item = usize>) -> Result<(), Refusal> {
    let gap = leds.enumerate().find(|(expected, led)| expected != led);
    let refused = |(expected, led)| {
        let expected = format_args!(
            "{expected}: each LED of the strip once; give those that were not found a place by hand"
        );
        Refusal::new("LED", led, expected)
    };
    gap.map_or(Ok(()), |gap| Err(refused(gap)))
}

/// The columns of a table: of the LED's index, of its place, and of the way it faces.
struct Columns {
    index: Option<usize>,
    place: [usize; 3],
    facing: Option<[usize; 3]>,
}

impl Columns {
    /// The columns by their names.
    fn named(names: &[&str]) -> Result<Self, Refusal> {
        let find = |name: &str| names.iter().position(|own| own.eq_ignore_ascii_case(name));
        let all = |names: [&str; 3]| {
            let found = names.map(find);
            found.iter().all(Option::is_some).then(|| found.map(Option::unwrap_or_default))
        };
        let refused =
            || Refusal::new("columns", names.join(","), "x, y and z among them, or no line of names");
        Ok(Self {
            index: find("index"),
            place: all(["x", "y", "z"]).ok_or_else(refused)?,
            facing: all(["xn", "yn", "zn"]),
        })
    }
}

fn table<'a>(text: &'a str) -> Result<LedMap, Refusal> {
    let words = |line: &'a str| -> Vec<&'a str> {
        let line = line.trim().trim_start_matches('[').trim_end_matches(']');
        line.split([',', ';', '\t']).map(str::trim).collect()
    };
    let mut lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty()).peekable();
    let is_number = |word: &&str| word.parse::<f64>().is_ok();
    let mut columns = Columns { index: None, place: [0, 1, 2], facing: None };
    if let Some((number, line)) = lines.next_if(|(_, line)| !words(line).iter().all(is_number)) {
        columns =
            Columns::named(&words(line)).map_err(|refusal| refusal.at(format_args!("line {number}")))?;
    }
    let mut found = Vec::new();
    for (number, line) in lines {
        let words = words(line);
        let read = |columns: [usize; 3]| {
            let numbers = columns.map(|column| words.get(column).and_then(|word| word.parse::<f64>().ok()));
            let is_whole = numbers.iter().all(|number| number.is_some_and(f64::is_finite));
            let refused = || {
                Refusal::new("place", line, "three finite numbers with commas between them")
                    .at(format_args!("line {number}"))
            };
            is_whole.then(|| numbers.map(Option::unwrap_or_default)).ok_or_else(refused)
        };
        let led = match columns.index.map(|column| words.get(column).copied().unwrap_or_default()) {
            Some(word) => word.parse().map_err(|_| {
                Refusal::new("index", word, "the number of an LED, from 0").at(format_args!("line {number}"))
            })?,
            None => found.len(),
        };
        found.push((led, read(columns.place)?, columns.facing.map(read).transpose()?));
    }
    found.sort_by_key(|(led, ..)| *led);
    ordered(found.iter().map(|(led, ..)| *led))?;
    let facing = found.iter().map(|(.., facing)| *facing).collect::<Option<Vec<_>>>();
    Ok(LedMap {
        places: found.iter().map(|(_, place, _)| *place).collect(),
        facing: facing.filter(|own| !own.is_empty()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_of_four_tools_are_read() {
        let places = vec![[1.0, 2.0, 3.0], [4.0, 5.5, -6.0]];
        let facing = vec![[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
        for text in [
            "1,2,3\n4,5.5,-6\n",
            "\u{feff}1, 2, 3\r\n4, 5.5, -6",
            "[[1,2,3],[4,5.5,-6]]",
            "[1, 2, 3]\n[4, 5.5, -6]\n",
            "x;y;z\n1;2;3\n4;5.5;-6",
        ] {
            assert_eq!(
                LedMap::read(text).unwrap(),
                LedMap { places: places.clone(), facing: None },
                "{text}"
            );
        }
        let text = "index,x,y,z,xn,yn,zn,error\n1,4,5.5,-6,0,0,1,0.1\n0,1,2,3,1,0,0,0.2\n";
        assert_eq!(LedMap::read(text).unwrap(), LedMap { places, facing: Some(facing) });
        let matrix = LedMap::read(r#"{"width": 2, "height": 2, "map": [1, -1, 0, 2]}"#).unwrap();
        assert_eq!(matrix.places, [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]);
    }

    #[test]
    fn refusals_name_the_place_and_the_remedy() {
        for (text, parts) in [
            ("", &["LEDs = 0"][..]),
            ("1,2,3\n4,x,6", &["line 2", "place = 4,x,6", "three finite numbers"]),
            ("1,2,inf", &["line 1", "finite"]),
            ("a,b,c\n1,2,3", &["line 1", "columns = a,b,c", "x, y and z"]),
            ("index,x,y,z\n0,1,2,3\n2,1,2,3", &["LED = 2", "expected 1"]),
            ("index,x,y,z\n-1,1,2,3", &["index = -1", "line 2"]),
            ("[[1]]", &["LED 0", "two or three numbers"]),
            ("[[1", &["map = "]),
            (r#"{"map": [0]}"#, &["width = null"]),
            (r#"{"width": 1, "map": [-2]}"#, &["map[0]", "LED = -2"]),
        ] {
            let refusal = LedMap::read(text).unwrap_err().to_string();
            assert!(parts.iter().all(|part| refusal.contains(part)), "{text}: {refusal}");
        }
    }
}
