//! The targets that have prices.

use crate::boards::{BOARDS, Board};

/// A target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// This machine; costs are times.
    Host,
    /// A browser, with or without vector instructions; costs are times.
    Browser {
        /// Whether it may use vector instructions.
        simd: bool,
    },
    /// A microcontroller; costs are instructions.
    Board(&'static Board),
}

impl Target {
    /// Every target, in the order of the page.
    pub fn all() -> Vec<Self> {
        let clocked = [Self::Host, Self::Browser { simd: false }, Self::Browser { simd: true }];
        clocked.into_iter().chain(BOARDS.iter().map(Self::Board)).collect()
    }

    /// The targets whose costs are counted instructions, which are the same in every run.
    pub fn counted() -> Vec<Self> {
        BOARDS.iter().map(Self::Board).collect()
    }

    /// Returns the target of this name, or an error that lists the names.
    pub fn named(name: &str) -> Result<Self, String> {
        Self::all().into_iter().find(|target| target.name() == name).ok_or_else(|| {
            let names: Vec<_> = Self::all().iter().map(Self::name).collect();
            format!("there is no target {name}; there are {}", names.join(", "))
        })
    }

    /// The name on the price list.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Host => "host",
            Self::Browser { simd: false } => "wasm",
            Self::Browser { simd: true } => "wasm-simd",
            Self::Board(board) => board.name,
        }
    }

    /// The name for people.
    pub fn title(&self) -> &'static str {
        match self {
            Self::Host => "Host",
            Self::Browser { simd: false } => "Browser (WebAssembly)",
            Self::Browser { simd: true } => "Browser (WebAssembly with simd128)",
            Self::Board(board) => board.title,
        }
    }

    /// The file name of its picture.
    pub(super) fn picture(&self) -> String {
        format!("accuracy-vs-cost-{}.svg", self.name())
    }

    /// The unit of the costs.
    pub fn unit(&self) -> &'static str {
        match self {
            Self::Board(_) => "instructions",
            _ => "ns",
        }
    }

    /// The power function that a program for the target would call.
    pub fn reference(&self) -> &'static str {
        match self {
            Self::Board(_) => "powf-libm.rival",
            _ => "powf-std.rival",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_target_is_found_by_its_name_or_the_names_are_told() {
        for target in Target::all() {
            assert_eq!(Target::named(target.name()), Ok(target));
        }
        let refused = Target::named("gpu").unwrap_err();
        assert!(refused.contains("gpu") && refused.contains("wasm-simd"), "{refused}");
    }
}
