//! The browser demo: a thin shell over `luminaire-render` and `luminaire-kernels`, and a page that shows what they
//! say.
//!
//! The page holds no lighting mathematics. It hands over what the visitor set, and asks [`Demo`] for everything it
//! displays: the angles that follow one another, the curve, the ranges of the sliders, the words of a refusal. The
//! same goes for [`Comparison`], which lights one wall in two forms and says how far each is from f64.
//!
//! In the order in which they depend on one another:
//!
//! - `refusal`: what the shell and the kernel refuse, in words
//! - `fixture`: the table of stage fixtures
//! - `light`: one light's settings, which are always a light that can be drawn
//! - `format`: the number format that was chosen at run time, as types
//! - `sweep`: how the lights move
//! - `clock`, `canvas`, `panic`: what the browser gives
//! - `demo`: the class that the page holds for the stage
//! - `wall`: the scene of the comparison
//! - `display`: from light to displayed codes
//! - `picture`: the wall in one form, whatever the form
//! - `difference`: how far a picture is from f64
//! - `form`: the formats and formulas to compare
//! - `false_colour`: errors as colours, and their scale
//! - `side`: one side of the comparison
//! - `comparison`: the class that the page holds for it
#![forbid(unsafe_code)]

mod canvas;
mod clock;
mod comparison;
mod demo;
mod difference;
mod display;
mod false_colour;
mod fixture;
mod form;
mod format;
mod light;
mod panic;
mod picture;
mod refusal;
mod side;
mod sweep;
mod wall;

pub use comparison::Comparison;
pub use demo::Demo;
pub use fixture::Fixture;
pub use light::LightState;
pub use side::{FormState, SideState};
