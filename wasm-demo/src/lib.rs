//! The browser demo: a thin shell over `luminaire-render` and `luminaire-kernels`, and a page that shows what they
//! say.
//!
//! The page holds no lighting mathematics. It hands over what the visitor set, and asks [`Demo`] for everything it
//! displays: the angles that follow one another, the curve, the ranges of the sliders, the words of a refusal. The
//! same goes for [`Comparison`], which lights one wall in two forms and says how far each is from f64, and for
//! [`Scenes`], which says what a scene calls for and what was left out of it.
//!
//! In the order in which they depend on one another:
//!
//! - `refusal`: what the shell and the kernel refuse, in words
//! - `fixture`: the table of stage fixtures
//! - `light`: one light's settings, which are always a light that can be drawn
//! - `format`: the number format that was chosen at run time, as types
//! - `sweep`: how the lights move
//! - `clock`, `canvas`, `panic`: what the browser gives
//! - `times`: how long the passes of a picture took
//! - `demo`: the class that the page holds for the stage
//! - `wall`: the scene of the comparison
//! - `display`: from light to displayed codes
//! - `picture`: the wall in one form, whatever the form
//! - `difference`: how far a picture is from f64
//! - `form`: the formats and formulas to compare
//! - `false_colour`: errors as colours, and their scale
//! - `side`: one side of the comparison
//! - `comparison`: the class that the page holds for it
//! - `scene_state`: what the page displays of a scene, as plain values
//! - `rig`: a scene with its switches
//! - `viewpoint`: how far a visitor has moved away from its camera
//! - `map`: where its lights were evaluated, as colours
//! - `equality`: its picture beside the one for which everything was evaluated
//! - `scenes`: the class that the page holds for the scenes
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
