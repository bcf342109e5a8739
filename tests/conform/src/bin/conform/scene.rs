//! A scene that belongs together, so that most of its points are lit: the values of every input by
//! name.

use std::collections::BTreeMap;

use luminaire_oracle::{DVec3, SplitMix64, turned, versine};

/// The values of a scene, before a format stores them. What has one component has three of the
/// same.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    values: BTreeMap<&'static str, DVec3>,
}

impl Scene {
    /// A surface point in or about the cone of a light, and all else that models ask for.
    pub(crate) fn new(random: &mut SplitMix64) -> Self {
        let mut scene = Self { values: BTreeMap::new() };
        // Half angles are evenly spread over the logarithm, from 1 to 80 degrees.
        let half = libm::exp(random.between(0.0, libm::log(80.0)));
        let inner = if random.below(4) == 0 { half * random.between(0.1, 1.2) } else { 0.0 };
        let cutoff = if random.below(4) == 0 { 2.0 * half * random.between(0.3, 1.0) } else { 0.0 };
        scene.set("design", random.below(3) as f64);
        scene.set("angle", 2.0 * half);
        scene.set("inner", inner);
        scene.set("cutoff", cutoff);
        scene.set("beam", half);
        scene.set("field", half * random.between(0.95, 2.4));
        scene.set("spot cutoff", half);
        scene.set("edge slope of a quadratic", random.between(0.0, 2.0));
        scene.set("edge slope", random.between(0.0, 3.0));
        scene.set("middle slope", random.between(0.0, 3.0));
        scene.set("versine", versine(half) * random.between(0.0, 1.1));

        let position = on_grid(random.vector(-8.0, 8.0));
        let axis = direction(random);
        let distance = libm::exp(random.between(libm::log(0.5), libm::log(16.0)));
        scene.set_vector("position", position);
        scene.set_vector("axis", axis);
        let off = random.between(0.0, 1.1) * half;
        scene.look_at(off, distance, random);
        scene.set("range", distance * random.between(0.8, 3.0));
        scene.set_vector("end", position + distance * random.between(0.8, 3.0) * axis);
        scene.set("intensity", distance * distance * random.between(0.1, 1.2));
        scene.set_vector("coefficients", random.vector(0.0, 2.0));

        for name in ["color", "specular color", "diffuse", "specular", "linear"] {
            scene.set_vector(name, random.vector(0.0, 1.0));
        }
        let light = [(); 3].map(|()| random.between(0.0, 1.0) * random.between(0.0, 3.0));
        scene.set_vector("light", light.into());
        scene.set("factor", random.between(-1.0, 1.0));
        scene.set("exposure", libm::exp(random.between(-3.0, 3.0)));
        scene.set("shininess", libm::floor(libm::exp(random.between(0.0, libm::log(1024.0)))));
        scene.set("code", random.below(256) as f64);
        scene.set("number", random.between(-3.0, 3.0));
        scene.set_beam(&mut SplitMix64(random.0 ^ 0x6265_616d));
        scene.set_decay(&mut SplitMix64(random.0 ^ 0x6465_6361));
        scene.set_pair(&mut SplitMix64(random.0 ^ 0x7061_6972));
        scene.set_vector("side", direction(&mut SplitMix64(random.0 ^ 0x7369_6465)));
        scene
    }

    /// What is in the beam, and the pixel that it is seen in.
    fn set_beam(&mut self, random: &mut SplitMix64) {
        // Every third one is a quarter of a turn, which is exact.
        let roll = random.between(-180.0, 180.0);
        self.set("roll", if random.below(3) == 0 { 90.0 * libm::floor(roll / 90.0) } else { roll });
        self.set("density", libm::exp(random.between(-6.0, -1.0)));
        self.set("column", random.below(1_000) as f64);
        self.set("row", random.below(1_000) as f64);
    }

    /// A real power of the distance.
    fn set_decay(&mut self, random: &mut SplitMix64) {
        self.set("exponent", libm::exp(random.between(libm::log(0.1), libm::log(16.0))));
        self.set("cap", libm::exp(random.between(0.0, libm::log(1e4))));
    }

    /// The narrow one of two soft falloffs.
    fn set_pair(&mut self, random: &mut SplitMix64) {
        self.set("share", random.between(0.0, 1.0));
        self.set("ratio", libm::exp(random.between(0.0, libm::log(1024.0))));
    }

    /// A value by its name.
    pub(crate) fn value(&self, name: &str, component: usize) -> f64 {
        self.vector(name)[component]
    }

    pub(crate) fn vector(&self, name: &str) -> DVec3 {
        *self.values.get(name).unwrap_or_else(|| panic!("a scene has no {name}"))
    }

    pub(crate) fn set(&mut self, name: &'static str, value: f64) {
        self.set_vector(name, DVec3::splat(value));
    }

    pub(crate) fn set_vector(&mut self, name: &'static str, value: DVec3) {
        self.values.insert(name, value);
    }

    /// Moves the surface to `off_axis` degrees off the axis, facing the light more or less, with an
    /// eye near the mirror direction.
    pub(crate) fn look_at(&mut self, off_axis: f64, distance: f64, random: &mut SplitMix64) {
        let (position, axis) = (self.vector("position"), self.vector("axis"));
        let across = loop {
            let v = direction(random);
            let v = v - v.dot(axis) * axis;
            if v.length_squared() > 0.01 {
                break v.normalize();
            }
        };
        let way = turned(axis, across, off_axis.to_radians());
        let normal = (0.7 * direction(random) - way).normalize();
        let view = (way.reflect(normal) + 0.3 * direction(random)).normalize();
        let point = on_grid(position + distance * way);
        self.set_vector("point", point);
        self.set_vector("normal", normal);
        self.set_vector("view", view);
        self.set_vector("eye", on_grid(point + 3.0 * view));
    }
}

/// A direction.
fn direction(random: &mut SplitMix64) -> DVec3 {
    loop {
        let v = random.vector(-1.0, 1.0);
        let squared = v.length_squared();
        if squared > 0.01 && squared < 1.0 {
            return v.normalize();
        }
    }
}

/// The nearest point of the grid of 2^-16, which every format has.
fn on_grid(v: DVec3) -> DVec3 {
    (v * 65_536.0 + 0.5).floor() / 65_536.0
}
