//! The catalogue: every effect, with what it is, and the function that is measured. Instructions and
//! bytes of the documents are of these functions.

use luminaire::dynamic::{Effect, Effects};

use crate::{Input, Inputs, Output};

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

        pub(super) fn $each(visit: &mut impl super::Visit) {
            $(visit.effect(
                super::Entry {
                    title: $title,
                    name: stringify!($function),
                    listed: None,
                    effects: super::Effects::NONE$(.with(super::Effect::$effect))*,
                    over: &[$($over)?],
                    what: concat!($($what),+),
                },
                crate::Inputs::$inputs,
                $function,
            );)*
        }
    };
}

mod display;
mod evaluation;
mod light;
mod listed;
mod surface;
mod way;

pub use self::listed::Listed;
pub use self::{display::*, evaluation::*, light::*, surface::*, way::*};

/// Visits every effect, in the order of the page.
pub fn each(visit: &mut impl Visit) {
    visit.group("Lights", "From a point and a normal to what arrives of one light, before its colour.");
    light::soft(visit);
    light::others(visit);
    visit.group(
        "Edges of the cone",
        "The soft spotlight with another falloff. A scene pays for those that its spotlights have.",
    );
    listed::falloffs(visit);
    light::ramps(visit);
    visit.group(
        "Distance",
        "The soft spotlight with a fall with distance. The window and the range are compared with the inverse square.",
    );
    listed::attenuations(visit);
    visit.group(
        "Evaluation and set-up",
        "The soft spotlight by other evaluations, and what it costs to move it or to compile it again. Both are \
         needed once a light and picture; here they are part of each pixel, so that they can be counted.",
    );
    evaluation::each(visit);
    visit.group(
        "In the way of a spotlight",
        "The soft spotlight through something. A fixture has it or not, and one that has it not knows nothing of it.",
    );
    way::each(visit);
    visit.group(
        "Surfaces",
        "From a point, its normal and the direction to the eye to what a material sends back of one directional \
         light, in colours. The direction to the eye is found once for all lights and not counted. Highlights are \
         of a shininess of 32.",
    );
    surface::matte_alone(visit);
    listed::lobes(visit);
    visit.group(
        "The picture as a whole",
        "Once a pixel, however many lights there are: from the sum of the light, or from a colour, in three channels.",
    );
    surface::sum(visit);
    display::each(visit);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Default)]
    struct Census(Vec<Entry>);

    impl Visit for Census {
        fn effect<I: Input, O: Output>(&mut self, entry: Entry, _: fn(&mut Inputs) -> I, _: impl Fn(I) -> O) {
            self.0.push(entry);
        }

        fn again(&mut self, entry: Entry) {
            self.0.push(entry);
        }
    }

    #[test]
    fn catalogue_has_every_effect_and_the_programs_that_it_compares_with() {
        let mut census = Census::default();
        each(&mut census);
        let priced = census.0.iter().fold(Effects::NONE, |all, entry| all.union(entry.effects));
        assert_eq!(priced, Effects::ALL);
        for entry in &census.0 {
            let known = |over: &&str| census.0.iter().any(|entry| entry.name == *over);
            assert!(entry.over.iter().all(known) && entry.what.ends_with('.'), "{entry:?}");
        }
    }
}
