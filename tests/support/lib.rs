//! What the tests share: the table of error bounds, the sweeps, the exact view of a format. The
//! truth is the crate `luminaire-oracle`.
#![allow(missing_docs, missing_debug_implementations, reason = "tests are read, not published")]

pub mod arbitrary;
pub mod beams;
pub mod bounds;
pub mod critical;
pub mod cubics;
pub mod every;
pub mod falloffs;
pub mod format;
pub mod gobos;
pub mod haze;
pub mod in_scattering;
pub mod limits;
pub mod shadows;
pub mod shapes;
pub mod squares;
pub mod sweep;
pub mod views;

pub use luminaire_oracle as oracle;

/// The examples of the README are tests. They are here because the README is outside of the folder of
/// the crate `luminaire`, which is packed with a copy of it.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;

use std::{fmt::Debug, ops::RangeBounds};

/// Asserts a condition about values. The message has the condition, and each value by its name.
#[macro_export]
macro_rules! assert_that {
    ($condition:expr $(, $found:expr)* $(,)?) => {
        assert!(
            $condition,
            "expected {}{}",
            stringify!($condition),
            [String::new() $(, format!("\nfound {} = {:?}", stringify!($found), $found))*].concat()
        )
    };
}

/// Calls a generic function in every format.
#[macro_export]
macro_rules! in_every_format {
    ($function:ident $(($($argument:expr),* $(,)?))?) => {
        $function::<f32>($($($argument),*)?);
        $function::<::luminaire::Fx32>($($($argument),*)?);
        $function::<::luminaire::Fx16>($($($argument),*)?);
    };
}

/// Asserts that a value is in a range. The message says of what, what was found and what was
/// expected.
#[track_caller]
pub fn assert_in<T: PartialOrd + Debug>(what: &dyn Debug, found: T, range: impl RangeBounds<T> + Debug) {
    assert!(range.contains(&found), "{what:?}: found {found:?}, expected {range:?}");
}
