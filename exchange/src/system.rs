//! The systems whose lights are read.

use std::fmt;
use std::str::FromStr;

use crate::refusal::Refusal;

/// Declares the systems: variant, name of the command line, files, and what is read.
macro_rules! systems {
    ($($(#[doc = $doc:literal])* $variant:ident = $name:literal, $extensions:expr, $what:literal;)*) => {
        /// A tool or a file format that describes lights.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        #[non_exhaustive]
        pub enum System {
            $($(#[doc = $doc])* $variant,)*
        }

        impl System {
            /// All systems.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// Returns the name on the command line.
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* }
            }

            /// Returns the extensions of its files, in lower case.
            pub fn extensions(self) -> &'static [&'static str] {
                match self { $(Self::$variant => &$extensions,)* }
            }

            /// Returns what is read, in a line.
            pub fn what(self) -> &'static str {
                match self { $(Self::$variant => $what,)* }
            }
        }
    };
}

systems! {
    /// glTF 2.0 with `KHR_lights_punctual`.
    Gltf = "gltf", ["gltf", "glb"], "spot, point and directional lights of a file, or numbers";
    /// three.js.
    Three = "three", ["json"], "lights of an object or scene in JSON, or numbers";
    /// Godot 3 and 4.
    Godot = "godot", ["tscn", "scn"], "lights of a scene as text, or numbers";
    /// OpenGL 1 and 2.
    OpenGl = "opengl", [], "the numbers of glLight";
    /// Direct3D 9.
    Direct3d = "direct3d", [], "the numbers of D3DLIGHT9";
    /// Blender.
    Blender = "blender", [], "the numbers of a lamp";
    /// UsdLux.
    Usd = "usd", ["usda", "usd", "usdc", "usdz"], "lights of a stage as text, or numbers";
    /// X3D and VRML97.
    X3d = "x3d", ["x3d", "x3dv", "wrl"], "lights of a world, or numbers";
    /// pbrt versions 3 and 4.
    Pbrt = "pbrt", ["pbrt"], "lights of a scene, or numbers";
    /// Unreal Engine; not checked against a running engine.
    Unreal = "unreal", ["t3d", "copy"], "copied actors as text, or numbers; unchecked";
    /// Unity with its Universal Render Pipeline; not checked against a running engine.
    Unity = "unity", ["unity", "prefab"], "lights of a scene as text, or numbers; unchecked";
    /// Bevy.
    Bevy = "bevy", [], "the numbers of a light";
    /// Babylon.js.
    Babylon = "babylon", ["babylon"], "lights of a scene, or numbers";
    /// IES LM-63.
    Ies = "ies", ["ies"], "rotational photometry of 1986 to 2019";
    /// EULUMDAT.
    Eulumdat = "eulumdat", ["ldt"], "rotational photometry";
    /// The General Device Type Format.
    Gdtf = "gdtf", ["gdtf"], "the beams of a fixture, its zoom and its gobos";
    /// The Open Fixture Library.
    Ofl = "ofl", ["json"], "a fixture in JSON";
    /// This project's own JSON.
    Luminaire = "luminaire", ["json"], "what `luminaire export --to json` writes";
}

impl System {
    /// Returns whether intensities are in candela, or in lumens that become candela.
    pub fn is_photometric(self) -> bool {
        use System::{Bevy, Eulumdat, Gdtf, Gltf, Ies, Ofl, Three, Unreal};
        matches!(self, Gltf | Three | Bevy | Unreal | Ies | Eulumdat | Gdtf | Ofl)
    }
}

impl fmt::Display for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for System {
    type Err = Refusal;

    fn from_str(text: &str) -> Result<Self, Refusal> {
        Self::ALL.iter().copied().find(|system| system.name() == text).ok_or_else(|| {
            let names: Vec<_> = Self::ALL.iter().map(|system| system.name()).collect();
            Refusal::new("system", text, format_args!("one of {}", names.join(", ")))
        })
    }
}
