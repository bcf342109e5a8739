//! The systems whose lights are read.

use std::fmt;
use std::str::FromStr;

use crate::refusal::Refusal;
use crate::tool::{
    Tool, Writer, babylon::Babylon, bevy::Bevy, blender::Blender, direct3d::Direct3d, gltf::Gltf,
    godot::Godot, opengl::OpenGl, pbrt::Pbrt, three::Three, unity::Unity, unreal::Unreal, usd::Usd, x3d::X3d,
};

/// Declares the systems: variant, for a tool with numbers its type, name of the command line, files, and what is
/// read.
macro_rules! systems {
    ($($(#[doc = $doc:literal])* $variant:ident $(($tool:ident))? = $name:literal, $extensions:expr, $what:literal;)*) => {
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

            /// Returns what is known of a tool with numbers.
            pub(crate) fn tool(self) -> Option<&'static dyn Tool> {
                match self { $(Self::$variant => systems!(@tool $($tool)?),)* }
            }
        }
    };
    (@tool) => { None };
    (@tool $tool:ident) => { Some(&$tool) };
}

systems! {
    /// glTF 2.0 with `KHR_lights_punctual`.
    Gltf(Gltf) = "gltf", ["gltf", "glb"], "spot, point and directional lights of a file, or numbers";
    /// three.js.
    Three(Three) = "three", ["json"], "lights of an object, a scene or a project in JSON, or numbers";
    /// Godot 3 and 4.
    Godot(Godot) = "godot", ["tscn", "scn"], "lights of a scene as text, or numbers";
    /// OpenGL 1 and 2.
    OpenGl(OpenGl) = "opengl", [], "the numbers of glLight";
    /// Direct3D 9.
    Direct3d(Direct3d) = "direct3d", [], "the numbers of D3DLIGHT9";
    /// Blender.
    Blender(Blender) = "blender", [], "the numbers of a lamp";
    /// UsdLux.
    Usd(Usd) = "usd", ["usda", "usd", "usdc", "usdz"], "lights of a stage as text, or numbers";
    /// X3D and VRML97.
    X3d(X3d) = "x3d", ["x3d", "x3dv", "wrl"], "lights of a world, or numbers";
    /// pbrt versions 3 and 4.
    Pbrt(Pbrt) = "pbrt", ["pbrt"], "lights of a scene, or numbers";
    /// Unreal Engine; not checked against a running engine.
    Unreal(Unreal) = "unreal", ["t3d", "copy"], "copied actors as text, or numbers; unchecked";
    /// Unity with its Universal Render Pipeline; not checked against a running engine.
    Unity(Unity) = "unity", ["unity", "prefab"], "lights of a scene as text, or numbers; unchecked";
    /// Bevy.
    Bevy(Bevy) = "bevy", [], "the numbers of a light";
    /// Babylon.js.
    Babylon(Babylon) = "babylon", ["babylon"], "lights of a scene, or numbers";
    /// IES LM-63.
    Ies = "ies", ["ies"], "photometry of the types C, B and A of 1986 to 2019";
    /// EULUMDAT.
    Eulumdat = "eulumdat", ["ldt"], "photometry of any symmetry";
    /// The General Device Type Format.
    Gdtf = "gdtf", ["gdtf"], "the beams of a fixture, its zoom and its gobos";
    /// My Virtual Rig.
    Mvr = "mvr", ["mvr"], "the fixtures of a rig, by the GDTF files in it";
    /// The Open Fixture Library.
    Ofl = "ofl", ["json"], "a fixture in JSON";
    /// This project's own JSON.
    Luminaire = "luminaire", ["json"], "what `luminaire export --to json` writes";
}

impl System {
    /// Returns whether intensities are in candela, or in lumens that become candela.
    pub fn is_photometric(self) -> bool {
        self.tool().map_or(self != Self::Luminaire, |tool| tool.is_photometric())
    }

    /// The tools that parameters of a light can be written for.
    pub fn writable() -> impl Iterator<Item = Self> {
        Self::ALL.iter().copied().filter(|system| system.writer().is_some())
    }

    /// Returns what writes the parameters of a light.
    pub(crate) fn writer(self) -> Option<&'static dyn Writer> {
        self.tool()?.writer()
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
