//! The rows of the catalogue, their visitor, and a macro that declares them.

use luminaire::dynamic::Effects;

use crate::input::{Input, Inputs};
use crate::output::Output;

/// A row of the catalogue.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The name for people.
    pub title: &'static str,
    /// The name of the program with the effect alone.
    pub name: &'static str,
    /// The type of the model, if the effect is that of a row in the library's lists.
    pub listed: Option<&'static str>,
    /// The effects of the library that the program shows.
    pub effects: Effects,
    /// The program that differs only in lacking this effect, if there is one.
    pub over: &'static [&'static str],
    /// What the effect is, and when a scene requires it.
    pub what: &'static str,
}

/// A visitor of the catalogue.
pub trait Visit {
    /// Begins a group of effects. The note is what its programs have in common.
    fn group(&mut self, _title: &'static str, _note: &'static str) {}

    /// Visits a row, the sequence of its inputs, and its function.
    fn effect<I: Input, O: Output>(
        &mut self,
        entry: Entry,
        next: fn(&mut Inputs) -> I,
        effect: impl Fn(I) -> O,
    );

    /// Visits a row whose program is that of another row.
    fn again(&mut self, _entry: Entry) {}
}

/// Declares effects: a row of the catalogue and a function for each, in a function that visits them.
///
/// A row is `doc "title", inputs, [effects] over "name"; fn name(input: type) -> output { … }`.
macro_rules! effects {
    ($each:ident; $(
        $(#[doc = $what:literal])+
        $title:literal, $inputs:ident, [$($effect:ident)*] $(over $over:literal)?;
        fn $function:ident($($input:tt)*) -> $output:ty $body:block
    )*) => {
        $(
            $(#[doc = $what])+
            #[inline(always)]
            pub fn $function($($input)*) -> $output $body
        )*

        pub(super) fn $each(visit: &mut impl $crate::Visit) {
            $(visit.effect(
                $crate::Entry {
                    title: $title,
                    name: stringify!($function),
                    listed: None,
                    effects: luminaire::dynamic::Effects::NONE$(.with(luminaire::dynamic::Effect::$effect))*,
                    over: &[$($over)?],
                    what: concat!($($what),+),
                },
                $crate::Inputs::$inputs,
                $function,
            );)*
        }
    };
}
