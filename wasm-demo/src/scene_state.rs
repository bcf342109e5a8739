//! State of a scene for the page: plain values.

use crate::plain::plain;
use luminaire::dynamic::Effect;
use luminaire_render::{Account, scenes::Example};

plain! {
    /// A scene in the list of scenes: its name for `open`, its title for people, and one sentence about
    /// the effects that it needs.
    fn example(example: Example) -> ExampleState {
        "name": "string" = example.name(),
        "title": "string" = example.title(),
        "summary": "string" = example.summary(),
    }
}

plain! {
    /// An effect with a switch: its title for people, whether the switch is enabled, because the scene has
    /// the effect or it can be added, and whether the effect is on.
    fn switch(effect: Effect, label: &str, offered: bool, on: bool) -> SwitchState {
        "effect": "string" = effect.name(),
        "label": "string" = label,
        "offered": "boolean" = offered,
        "on": "boolean" = on,
    }
}

plain! {
    /// The counts of the work for the last picture: see [`Account`].
    fn account(account: Account) -> AccountState {
        "triangles": "number" = account.triangles as f64,
        "lights": "number" = account.lights,
        "lightsDropped": "number" = account.lights_dropped,
        "leds": "number" = account.leds,
        "ledCurrent": "number" = account.led_current,
        "ledLimit": "number" = account.led_limit,
        "tiles": "number" = account.tiles,
        "tilesRelit": "number" = account.tiles_relit,
        "pairs": "number" = account.pairs() as f64,
        "evaluated": "number" = account.evaluated as f64,
        "evaluatedShining": "number" = account.evaluated_shining as f64,
        "evaluatedThroughGobos": "number" = account.evaluated_through_gobos as f64,
        "evaluatedInShadows": "number" = account.evaluated_in_shadows as f64,
        "evaluatedInAir": "number" = account.evaluated_in_air as f64,
        "dropped": "number" = account.dropped as f64,
        "kept": "number" = account.kept as f64,
        "missedByTile": "number" = account.missed_by_tile as f64,
        "missedByRow": "number" = account.missed_by_row as f64,
    }
}
