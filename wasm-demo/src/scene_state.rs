//! State of a scene for the page: plain values.

use luminaire_render::{Account, scenes::Example};
use wasm_bindgen::prelude::*;

/// A scene in the list of scenes.
#[wasm_bindgen(getter_with_clone)]
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ExampleState {
    /// The name that `open` takes.
    pub name: String,
    /// The title for people.
    pub title: String,
    /// One sentence about the effects that it needs.
    pub summary: String,
}

/// An effect of the library.
#[wasm_bindgen(getter_with_clone)]
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct EffectState {
    /// The name of the effect in the price list.
    pub name: String,
    /// Whether the picture needs it.
    #[wasm_bindgen(js_name = isCalledFor)]
    pub is_called_for: bool,
}

/// An effect with a switch.
#[wasm_bindgen(getter_with_clone)]
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SwitchState {
    /// The name of the effect.
    pub effect: String,
    /// The title for people.
    pub label: String,
    /// Whether the switch is enabled: the scene has the effect, or it can be added.
    pub offered: bool,
    /// Whether the effect is on.
    pub on: bool,
}

/// Counts of the work for the last picture: see [`Account`]. They are JavaScript numbers.
#[wasm_bindgen(getter_with_clone)]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct AccountState {
    /// The number of triangles that were drawn.
    pub triangles: f64,
    /// The lights in the scene.
    pub lights: f64,
    /// The dark lights, which were dropped.
    #[wasm_bindgen(js_name = lightsDropped)]
    pub lights_dropped: f64,
    /// The tiles of the picture.
    pub tiles: f64,
    /// The tiles that were lit again.
    #[wasm_bindgen(js_name = tilesRelit)]
    pub tiles_relit: f64,
    /// The number of all pairs of a light and a pixel.
    pub pairs: f64,
    /// The pairs that were evaluated.
    pub evaluated: f64,
    /// The pairs of `evaluated` that were evaluated with a highlight.
    #[wasm_bindgen(js_name = evaluatedShining)]
    pub evaluated_shining: f64,
    /// The pairs of a beam and a pixel whose in-scattering was evaluated, in addition to
    /// `evaluated`.
    #[wasm_bindgen(js_name = evaluatedInAir)]
    pub evaluated_in_air: f64,
    /// The pairs of a dropped light.
    pub dropped: f64,
    /// The pairs in tiles that were not re-lit.
    pub kept: f64,
    /// The pairs skipped because the light does not reach the tile.
    #[wasm_bindgen(js_name = missedByTile)]
    pub missed_by_tile: f64,
    /// The pairs skipped in a tile that the light may reach, because the light does not reach a row
    /// of pixels or the row faces away from the light.
    #[wasm_bindgen(js_name = missedByRow)]
    pub missed_by_row: f64,
}

impl From<Example> for ExampleState {
    fn from(example: Example) -> Self {
        let [name, title, summary] = [example.name(), example.title(), example.summary()].map(str::to_owned);
        Self { name, title, summary }
    }
}

impl From<Account> for AccountState {
    fn from(account: Account) -> Self {
        Self {
            triangles: account.triangles as f64,
            lights: account.lights.into(),
            lights_dropped: account.lights_dropped.into(),
            tiles: account.tiles.into(),
            tiles_relit: account.tiles_relit.into(),
            pairs: account.pairs() as f64,
            evaluated: account.evaluated as f64,
            evaluated_shining: account.evaluated_shining as f64,
            evaluated_in_air: account.evaluated_in_air as f64,
            dropped: account.dropped as f64,
            kept: account.kept as f64,
            missed_by_tile: account.missed_by_tile as f64,
            missed_by_row: account.missed_by_row as f64,
        }
    }
}
