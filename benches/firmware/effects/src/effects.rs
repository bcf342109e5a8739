//! The effects, each a function of one input. Bytes and instructions are counted for these
//! functions.

/// Writes the function `each`, which shows a visitor the effects of a file, grouped by type of
/// input.
macro_rules! list {
    ($($input:ident: $($effect:ident)*;)*) => {
        pub(super) fn each(visit: &mut impl super::Visit) {
            $($(visit.$input(stringify!($effect), $effect);)*)*
        }
    };
}

mod display;
mod listed;
mod spot;
mod surface;

pub use self::listed::Listed;
pub use self::{display::*, spot::*, surface::*};
use crate::{Color, Light, Output, Place, Surface};

/// A visitor of every effect, with a method for each type of input.
pub trait Visit {
    /// A surface point, and the direction to the eye.
    fn surface<O: Output>(&mut self, name: &str, effect: impl Fn(Surface) -> O);

    /// Light, some of it over full scale.
    fn light<O: Output>(&mut self, name: &str, effect: impl Fn(Light) -> O);

    /// Light, some of it over full scale, and its pixel position in the picture.
    fn lit<O: Output>(&mut self, name: &str, effect: impl Fn((Light, Place)) -> O);

    /// A colour within full scale.
    fn color<O: Output>(&mut self, name: &str, effect: impl Fn(Color) -> O);

    /// A colour and its pixel position in the picture.
    fn pixel<O: Output>(&mut self, name: &str, effect: impl Fn((Color, Place)) -> O);
}

/// Shows a visitor every effect.
pub fn each(visit: &mut impl Visit) {
    surface::each(visit);
    spot::each(visit);
    listed::each(visit);
    display::each(visit);
}
