//! A museum of broken beams: faulty spotlights of other projects, each run by the formula that the
//! project published, beside the exact light in f64 and the light of the crate `luminaire`.
//!
//! An [`Exhibit`] names its source and has one control. At a value of the control it is a
//! [`Beam`]: the light that is meant, as a formula in f64 and as a light of the crate, and the
//! faulty formula. A [`Picture`] evaluates all three at the points of a [`View`], and
//! [`Picture::errors`] compares them in linear codes.
//!
//! Formulas of shaders are evaluated in f32 and from the direction that is best for them: divided
//! by a correctly rounded length. A project may have corrected its formula since; the exhibit says
//! so where that is known.
//!
//! `cargo test -p luminaire-museum -- --nocapture` prints the errors of every exhibit.
//!
//! The modules, lowest first: `seen`, `view`, `beam`, `exhibit`, `picture`, `formula`, `exhibits`.
#![forbid(unsafe_code)]

mod beam;
mod exhibit;
mod exhibits;
mod formula;
mod picture;
mod seen;
mod view;

pub use beam::Beam;
pub use exhibit::{Bounds, Control, Exhibit, Source};
pub use exhibits::ALL;
pub use picture::{Errors, Picture, Side};
pub use seen::Seen;
pub use view::{Place, View};
