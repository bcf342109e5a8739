//! The browser demo: a thin layer over `luminaire-render` and `luminaire-kernels`, and a page that
//! shows their results.
//!
//! The page contains no lighting mathematics and no state of the picture. It passes the visitor's
//! settings to these classes and gets everything that it displays from them. [`Stage`] has a scene
//! under the visitor's settings, and lists the effects that the scene needs. [`Painter`] draws a
//! share of its picture, mostly in a worker, and counts the skipped work. [`Comparison`] lights one
//! wall in two forms and measures the error of each against f64. [`Museum`] shows faulty spotlights
//! of other projects.
//!
//! The modules, lowest first:
//!
//! - `refusal`: the texts of refusals by this crate and the kernel
//! - `decimal`: numbers from text
//! - `fixture`: stage fixtures for the page and for addresses
//! - `edge`: the falloffs to choose from
//! - `format`: the number format, from a run-time choice to a type
//! - `photometry`: lux for full scale
//! - `design`: the angles that a cone is designed from
//! - `light`: a light for the page, as plain values
//! - `curve`: the intensity of a light over the angle, and curves to compare it with
//! - `setting`: the visitor's settings of one light
//! - `clock`, `canvas`, `panic`: the browser's services
//! - `times`: times of the passes of a picture
//! - `display`: conversion of light to displayed codes
//! - `false_colour`: false colours for errors, and their scale
//! - `map`: false colours of the number of evaluated lights
//! - `viewpoint`: the visitor's offset from the scene's camera
//! - `state`: everything that the visitor has set, as one value
//! - `parameter`: the table of the state's parameters
//! - `address`: the state as text
//! - `scene_state`: state of a scene for the page, as plain values
//! - `rig`: a scene with the settings of a state
//! - `desk`: the state, its scene, and earlier states to return to
//! - `aim`: the lights in the picture, and what a pointer moves
//! - `dial`: the ends of a light's dials
//! - `add`: the light that a visitor adds
//! - `job`: a picture to draw, as text for a worker
//! - `equality`: comparison of the scene's picture with the one of all effects
//! - `painter`: the JavaScript class that draws a share of a picture
//! - `code`: the JavaScript class that writes lights as source of other languages
//! - `composite`: the JavaScript class that puts the shares of a picture together
//! - `stage`: the JavaScript class of the stage
//! - `wall`: the scene of the comparison
//! - `picture`: the wall lit in one form, behind a trait object
//! - `difference`: error of a picture against f64
//! - `form`: the formats and formulas to compare
//! - `side`: one side of the comparison
//! - `divided`: the difference between two pictures of one scene
//! - `comparison`: the JavaScript class of the comparison
//! - `museum`: the JavaScript class of the museum
//!
//! The features are parts of the crate. The packages of `modules` compile each as a WebAssembly module
//! of its own, so that the first picture waits only for what it needs:
//!
//! - `stage`: the stage and the painters of pictures in `f32`
//! - `fixed-point`: the painters of pictures in fixed point, loaded with the first such picture
//! - `comparison`: the comparison and the museum, loaded when one of them is first requested
//! - `code`: the exporter of lights, loaded when its drawer is opened
#![forbid(unsafe_code)]
#![cfg_attr(
    not(all(feature = "stage", feature = "fixed-point", feature = "comparison", feature = "code")),
    allow(dead_code, unused_imports, reason = "each part uses some of what they share")
)]

#[cfg(feature = "stage")]
mod add;
#[cfg(feature = "state")]
mod address;
#[cfg(feature = "stage")]
mod aim;
#[cfg(feature = "comparison")]
mod canvas;
mod clock;
#[cfg(feature = "code")]
mod code;
#[cfg(feature = "comparison")]
mod comparison;
#[cfg(feature = "stage")]
mod composite;
#[cfg(feature = "stage")]
mod curve;
#[cfg(feature = "state")]
mod decimal;
#[cfg(feature = "state")]
mod design;
#[cfg(feature = "stage")]
mod desk;
#[cfg(feature = "stage")]
mod dial;
#[cfg(feature = "comparison")]
mod difference;
mod display;
#[cfg(feature = "stage")]
mod divided;
#[cfg(feature = "state")]
mod edge;
#[cfg(feature = "painter")]
mod equality;
mod false_colour;
#[cfg(feature = "state")]
mod fixture;
#[cfg(feature = "comparison")]
mod form;
mod format;
#[cfg(feature = "state")]
mod job;
#[cfg(feature = "state")]
mod light;
#[cfg(feature = "state")]
mod map;
#[cfg(feature = "comparison")]
mod museum;
#[cfg(feature = "painter")]
mod painter;
mod panic;
#[cfg(feature = "state")]
mod parameter;
#[cfg(feature = "stage")]
mod photometry;
#[cfg(feature = "comparison")]
mod picture;
mod refusal;
#[cfg(feature = "state")]
mod rig;
#[cfg(feature = "state")]
mod scene_state;
#[cfg(feature = "state")]
mod setting;
#[cfg(feature = "comparison")]
mod side;
#[cfg(feature = "stage")]
mod stage;
#[cfg(feature = "state")]
mod state;
#[cfg(feature = "painter")]
mod times;
#[cfg(feature = "state")]
mod viewpoint;
#[cfg(feature = "comparison")]
mod wall;

#[cfg(feature = "code")]
pub use code::Code;
#[cfg(feature = "comparison")]
pub use comparison::Comparison;
#[cfg(feature = "stage")]
pub use composite::Composite;
#[cfg(feature = "stage")]
pub use divided::Divided;
#[cfg(feature = "comparison")]
pub use museum::{ExhibitState, Museum, PictureState};
#[cfg(feature = "comparison")]
pub use side::{FormState, SideState};
#[cfg(feature = "stage")]
pub use stage::Stage;
#[cfg(feature = "painter")]
pub use {equality::Equality, painter::Painter, times::Times};
#[cfg(feature = "state")]
pub use {
    fixture::FixtureState,
    light::{DialEnds, LightState},
    parameter::ParameterState,
    scene_state::{AccountState, EffectState, ExampleState, SwitchState},
};
