//! The languages.

use std::fmt;
use std::str::FromStr;

use crate::error::ExportError;

/// Declares the languages and their names.
macro_rules! languages {
    ($($(#[$doc:meta])* $variant:ident = $name:literal,)*) => {
        /// A language, and where it matters a number format.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        #[non_exhaustive]
        pub enum Language {
            $($(#[$doc])* $variant,)*
        }

        impl Language {
            /// All languages.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// Returns the name, as [`FromStr`] reads it.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }
        }
    };
}

languages! {
    /// The parameters of the light, without code.
    Json = "json",
    /// GLSL ES 3.00, the shaders of WebGL 2.
    Glsl = "glsl",
    /// The same with uniforms in place of constants, for a light that moves.
    GlslUniforms = "glsl-uniforms",
    /// WGSL, the shaders of WebGPU.
    Wgsl = "wgsl",
    /// C99 and C++11 in `float`.
    CFloat = "c-f32",
    /// C99 and C++11 in the integers of the format `Fx16`.
    CFixed = "c-fx16",
    /// A build script of Rust that describes lights and writes their constants in the 16-bit
    /// fixed-point format `Fx16`.
    RustBuild = "rust-build",
    /// A program of Rust that prints the pools of spotlights. It makes a cone from the beam and the
    /// field angle where these two determine it.
    RustProgram = "rust-program",
    /// A constant of Rust in `f32`.
    RustFloat = "rust-f32",
    /// A constant of Rust in the 32-bit fixed-point format `Fx32`.
    RustFixed32 = "rust-fx32",
    /// A constant of Rust in the 16-bit fixed-point format `Fx16`.
    RustFixed16 = "rust-fx16",
}

impl Language {
    /// Returns whether the language has a function that lights by all lights of a source.
    pub fn has_scenes(self) -> bool {
        match self {
            Self::Json | Self::RustProgram => false,
            Self::Glsl | Self::GlslUniforms | Self::Wgsl | Self::CFloat | Self::CFixed => true,
            Self::RustBuild | Self::RustFloat | Self::RustFixed32 | Self::RustFixed16 => true,
        }
    }

    /// Returns whether the language has the channels by which a console controls a fixture.
    pub fn has_channels(self) -> bool {
        match self {
            Self::CFixed | Self::RustFloat | Self::RustFixed32 | Self::RustFixed16 => true,
            Self::Json | Self::Glsl | Self::GlslUniforms | Self::Wgsl => false,
            Self::CFloat | Self::RustBuild | Self::RustProgram => false,
        }
    }

    /// Returns the languages that may take a light which this one refuses, the nearest first.
    pub(crate) fn wider(self) -> &'static [Self] {
        match self {
            Self::CFloat => &[Self::CFixed],
            Self::CFixed => &[Self::CFloat],
            Self::RustProgram => &[Self::RustBuild, Self::RustFixed32, Self::RustFloat],
            Self::RustBuild | Self::RustFixed16 => &[Self::RustFixed32, Self::RustFloat],
            Self::RustFixed32 => &[Self::RustFloat],
            Self::Json | Self::Glsl | Self::GlslUniforms | Self::Wgsl | Self::RustFloat => &[],
        }
    }
}

impl fmt::Display for Language {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.pad(self.name())
    }
}

impl FromStr for Language {
    type Err = ExportError;

    fn from_str(name: &str) -> Result<Self, ExportError> {
        let found = Self::ALL.iter().copied().find(|language| language.name() == name);
        let names: Vec<_> = Self::ALL.iter().map(|language| language.name()).collect();
        found.ok_or_else(|| ExportError::new("language", name, format!("one of {}", names.join(", "))))
    }
}
