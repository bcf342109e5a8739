//! Input as WebDriver describes it, which BiDi shares.

use anyhow::{Context, Result};
use serde_json::{Value, json};

/// The keys without a character, and the characters that WebDriver gives them.
const KEYS: [(&str, char); 13] = [
    ("Backspace", '\u{e003}'),
    ("Tab", '\u{e004}'),
    ("Enter", '\u{e007}'),
    ("Escape", '\u{e00c}'),
    ("PageUp", '\u{e00e}'),
    ("PageDown", '\u{e00f}'),
    ("End", '\u{e010}'),
    ("Home", '\u{e011}'),
    ("ArrowLeft", '\u{e012}'),
    ("ArrowUp", '\u{e013}'),
    ("ArrowRight", '\u{e014}'),
    ("ArrowDown", '\u{e015}'),
    ("Delete", '\u{e017}'),
];

/// Presses the mouse's main button at the first point, moves along the others, and lets go.
pub(super) fn drag(along: &[(f64, f64)]) -> Value {
    // WebDriver's points are whole pixels.
    let mut moves = along.iter().map(|(x, y)| {
        json!({ "type": "pointerMove", "x": x.round() as i64, "y": y.round() as i64, "duration": 0 })
    });
    let mut actions: Vec<_> = moves.next().into_iter().collect();
    actions.push(json!({ "type": "pointerDown", "button": 0 }));
    actions.extend(moves);
    actions.push(json!({ "type": "pointerUp", "button": 0 }));
    json!([{ "type": "pointer", "id": "mouse", "parameters": { "pointerType": "mouse" }, "actions": actions }])
}

/// Turns the mouse's wheel over a point.
pub(super) fn wheel((x, y): (f64, f64), by: f64) -> Value {
    let scroll = json!({
        "type": "scroll", "x": x.round() as i64, "y": y.round() as i64, "deltaX": 0, "deltaY": by.round() as i64,
        "duration": 0,
    });
    json!([{ "type": "wheel", "id": "wheel", "actions": [scroll] }])
}

/// Presses and releases a key that has a name and no character.
pub(super) fn press(key: &str) -> Result<Value> {
    let found = KEYS.iter().find(|(name, _)| *name == key);
    let (_, character) = found.with_context(|| format!("key = {key:?}: expected a key of the list"))?;
    Ok(type_text(&character.to_string()))
}

/// Types a text.
pub(super) fn type_text(text: &str) -> Value {
    let keys = text.chars().flat_map(|character| {
        ["keyDown", "keyUp"].map(|kind| json!({ "type": kind, "value": character.to_string() }))
    });
    json!([{ "type": "key", "id": "keyboard", "actions": keys.collect::<Vec<_>>() }])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drag_presses_at_the_first_point_and_releases_at_the_last() {
        let input = drag(&[(1.0, 2.4), (3.0, 4.6)]);
        let kinds: Vec<_> = input[0]["actions"].as_array().unwrap().iter().map(|a| &a["type"]).collect();
        assert_eq!(kinds, ["pointerMove", "pointerDown", "pointerMove", "pointerUp"]);
        assert_eq!((&input[0]["actions"][2]["x"], &input[0]["actions"][2]["y"]), (&json!(3), &json!(5)));
    }

    #[test]
    fn press_sends_the_character_of_the_key() {
        assert_eq!(press("Tab").unwrap()[0]["actions"][0]["value"], "\u{e004}");
        assert!(press("Hyper").unwrap_err().to_string().contains("Hyper"));
    }
}
