//! The hard cases: what has broken lights before, each with a name.

use luminaire_conform::{Input, Kind};

use super::scene::Scene;
use luminaire_oracle::{DVec3, SplitMix64, versine};

/// The name of a hard case and the function that makes a scene into it.
pub(crate) type Situation = (&'static str, fn(&mut Scene, &mut SplitMix64));

pub(crate) const SITUATIONS: [Situation; 27] = [
    ("on the axis", |scene, random| {
        scene.look_at(0.0, 2.0, random);
        scene.set("versine", 0.0);
    }),
    ("just off the axis", |scene, random| {
        scene.look_at(0.01, 2.0, random);
        scene.set("versine", 1e-8);
    }),
    ("at the edge", |scene, random| at_edge(scene, random, 1.0)),
    ("just within the edge", |scene, random| at_edge(scene, random, 0.99)),
    ("just outside the edge", |scene, random| at_edge(scene, random, 1.01)),
    ("behind the light", |scene, random| {
        scene.look_at(180.0, 2.0, random);
        scene.set("versine", 2.0);
    }),
    ("a half space", |scene, _| {
        scene.set("design", 0.0);
        scene.set("angle", 180.0);
        scene.set("spot cutoff", 90.0);
    }),
    ("inner is outer", |scene, random| {
        plain(scene, 40.0);
        scene.set("inner", 40.0);
        scene.look_at(19.9, 2.0, random);
    }),
    ("at a step", |scene, random| {
        at_edge(scene, random, 1.0);
        scene.set("inner", 40.0);
    }),
    ("inner beyond outer", |scene, _| {
        plain(scene, 40.0);
        scene.set("inner", 41.0);
    }),
    ("at the rim of a hotspot", |scene, random| {
        plain(scene, 40.0);
        scene.set("inner", 20.0);
        scene.look_at(10.0, 2.0, random);
        scene.set("versine", versine(10.0));
    }),
    ("at a cutoff", |scene, random| {
        plain(scene, 40.0);
        scene.set("cutoff", 20.0);
        scene.look_at(10.0, 2.0, random);
        scene.set("versine", versine(10.0));
    }),
    ("a beam of 0.01 degrees", |scene, _| plain(scene, 0.01)),
    ("no angle", |scene, _| plain(scene, 0.0)),
    ("more than all angles", |scene, _| plain(scene, 400.0)),
    ("on the light", |scene, _| scene.set_vector("point", scene.vector("position"))),
    ("next to the light", |scene, _| {
        let next = scene.vector("position") + DVec3::X / 65_536.0;
        scene.set_vector("point", next);
    }),
    ("at the range", |scene, random| {
        scene.set_vector("position", DVec3::ZERO);
        scene.set_vector("axis", DVec3::NEG_Z);
        scene.look_at(0.0, 4.0, random);
        scene.set("range", 4.0);
    }),
    ("a light at the end of the world", |scene, _| {
        scene.set_vector("position", DVec3::new(32_639.0, -32_639.0, 0.0))
    }),
    ("a light beyond fixed point", |scene, _| scene.set_vector("position", 1e6 * DVec3::X)),
    ("no axis", |scene, _| scene.set_vector("axis", DVec3::ZERO)),
    ("facing away", |scene, _| scene.set_vector("normal", -scene.vector("normal"))),
    ("edge-on", |scene, _| {
        let way = scene.vector("point") - scene.vector("position");
        let normal = scene.vector("normal");
        scene.set_vector("normal", (normal - normal.dot(way) / way.length_squared() * way).normalize());
    }),
    ("no normal", |scene, _| scene.set_vector("normal", DVec3::ZERO)),
    ("the eye at the point", |scene, _| scene.set_vector("eye", scene.vector("point"))),
    ("full scale", |scene, _| {
        for name in ["color", "specular color", "diffuse", "specular", "linear", "light", "factor", "number"]
        {
            scene.set(name, 1.0);
        }
        scene.set("intensity", 1e9);
        scene.set("exposure", 1e9);
        scene.set("shininess", 1024.0);
        scene.set("code", 255.0);
    }),
    ("dark", |scene, _| {
        for name in ["color", "specular color", "diffuse", "specular", "linear", "light", "factor", "number"]
        {
            scene.set(name, 0.0);
        }
        scene.set("intensity", 0.0);
        scene.set("exposure", 0.0);
        scene.set("shininess", 1.0);
        scene.set("code", 0.0);
    }),
];

/// A cone of this outer angle in degrees, without hotspot and cutoff.
fn plain(scene: &mut Scene, angle: f64) {
    for (name, value) in [("design", 0.0), ("angle", angle), ("inner", 0.0), ("cutoff", 0.0)] {
        scene.set(name, value);
    }
    for name in ["beam", "field", "spot cutoff"] {
        scene.set(name, angle / 2.0);
    }
}

/// A cone of 40 degrees and a point at this fraction of its half angle.
fn at_edge(scene: &mut Scene, random: &mut SplitMix64, fraction: f64) {
    plain(scene, 40.0);
    scene.look_at(20.0 * fraction, 2.0, random);
    scene.set("versine", versine(20.0 * fraction));
}

/// Bits that stand in place of a value: of an f32, and of a word with a sign or without.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seam {
    pub(crate) name: &'static str,
    float: u32,
    fixed: fn(u32) -> u64,
}

/// The f32 and, as there are no such things in fixed point, the least, the largest and the smallest
/// word instead.
pub(crate) const SEAMS: [Seam; 8] = [
    Seam { name: "minus zero, or minus one step", float: 0x8000_0000, fixed: |bits| u64::MAX >> (64 - bits) },
    Seam { name: "the smallest", float: 1, fixed: |_| 1 },
    Seam { name: "the largest subnormal, or two steps", float: 0x007f_ffff, fixed: |_| 2 },
    Seam { name: "the largest", float: 0x7f7f_ffff, fixed: |bits| (1 << (bits - 1)) - 1 },
    Seam { name: "the least", float: 0xff7f_ffff, fixed: |bits| 1 << (bits - 1) },
    Seam {
        name: "infinite, or next to the largest",
        float: 0x7f80_0000,
        fixed: |bits| (1 << (bits - 1)) - 2,
    },
    Seam {
        name: "minus infinite, or next to the least",
        float: 0xff80_0000,
        fixed: |bits| (1 << (bits - 1)) + 1,
    },
    Seam { name: "not a number, or zero", float: 0x7fc0_0000, fixed: |_| 0 },
];

/// Which of the inputs a seam takes the place of.
pub(crate) type Part = (&'static str, fn(&Input) -> bool);

pub(crate) const PARTS: [Part; 4] = [
    ("as every word", |input| !matches!(input.kind, Kind::Number | Kind::Whole)),
    ("as each first word", |input| !matches!(input.kind, Kind::Number | Kind::Whole) && input.component == 0),
    ("as every number", |input| input.kind == Kind::Number),
    ("as each first number", |input| input.kind == Kind::Number && input.component == 0),
];

impl Seam {
    /// The word that takes the place of an input's.
    pub(crate) fn word(&self, input: &Input) -> u64 {
        if input.format == "f32" { u64::from(self.float) } else { (self.fixed)(4 * input.digits as u32) }
    }
}
