//! The browser demo: a thin layer over `luminaire-render` and `luminaire-kernels`, and a page that
//! shows their results.
//!
//! The page contains no lighting mathematics. It passes the visitor's settings to three classes and
//! gets everything that it displays from them. [`Demo`] supplies dependent angles, the curve, the
//! ranges of the sliders and the texts of refusals. [`Comparison`] lights one wall in two forms and
//! measures the error of each against f64. [`Scenes`] lists the effects that a scene needs and
//! counts the skipped work.
//!
//! The modules, lowest first:
//!
//! - `refusal`: the texts of refusals by this crate and the kernel
//! - `fixture`: the table of stage fixtures
//! - `light`: the settings of one light, which are always valid
//! - `format`: the number format, from a run-time choice to a type
//! - `sweep`: motion of the lights
//! - `clock`, `canvas`, `panic`: the browser's services
//! - `times`: times of the passes of a picture
//! - `demo`: the JavaScript class of the stage
//! - `wall`: the scene of the comparison
//! - `display`: conversion of light to displayed codes
//! - `picture`: the wall lit in one form, behind a trait object
//! - `difference`: error of a picture against f64
//! - `form`: the formats and formulas to compare
//! - `false_colour`: false colours for errors, and their scale
//! - `side`: one side of the comparison
//! - `comparison`: the JavaScript class of the comparison
//! - `scene_state`: state of a scene for the page, as plain values
//! - `rig`: a scene with switches for its lights and effects
//! - `viewpoint`: the visitor's offset from the scene's camera
//! - `map`: false colours of the number of evaluated lights
//! - `equality`: comparison of the scene's picture with the one of all effects
//! - `scenes`: the JavaScript class of the scenes
#![forbid(unsafe_code)]

mod canvas;
mod clock;
mod comparison;
mod demo;
mod difference;
mod display;
mod equality;
mod false_colour;
mod fixture;
mod form;
mod format;
mod light;
mod map;
mod panic;
mod picture;
mod refusal;
mod rig;
mod scene_state;
mod scenes;
mod side;
mod sweep;
mod times;
mod viewpoint;
mod wall;

pub use comparison::Comparison;
pub use demo::Demo;
pub use equality::Equality;
pub use fixture::Fixture;
pub use light::LightState;
pub use scene_state::{AccountState, EffectState, ExampleState, SceneLightState, SwitchState};
pub use scenes::Scenes;
pub use side::{FormState, SideState};
