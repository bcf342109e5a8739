//! A scene that belongs together, so that most of its points are lit: the values of every input by
//! name.

use std::collections::BTreeMap;

use super::random::{Random, dot, plus, scaled, unit};

/// The values of a scene, before a format stores them. What has one component has three of the
/// same.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    values: BTreeMap<&'static str, [f64; 3]>,
}

impl Scene {
    /// A surface point in or about the cone of a light, and all else that models ask for.
    pub(crate) fn new(random: &mut Random) -> Self {
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

        let position = [(); 3].map(|()| on_grid(random.between(-8.0, 8.0)));
        let axis = random.direction();
        let distance = libm::exp(random.between(libm::log(0.5), libm::log(16.0)));
        scene.set_vector("position", position);
        scene.set_vector("axis", axis);
        let off = random.between(0.0, 1.1) * half;
        scene.look_at(off, distance, random);
        scene.set("range", distance * random.between(0.8, 3.0));
        scene.set_vector("end", plus(position, scaled(axis, distance * random.between(0.8, 3.0))));
        scene.set("intensity", distance * distance * random.between(0.1, 1.2));
        scene.set_vector("coefficients", [(); 3].map(|()| random.between(0.0, 2.0)));

        for name in ["color", "specular color", "diffuse", "specular", "linear"] {
            scene.set_vector(name, [(); 3].map(|()| random.between(0.0, 1.0)));
        }
        scene.set_vector("light", [(); 3].map(|()| random.between(0.0, 1.0) * random.between(0.0, 3.0)));
        scene.set("factor", random.between(-1.0, 1.0));
        scene.set("exposure", libm::exp(random.between(-3.0, 3.0)));
        scene.set("shininess", libm::floor(libm::exp(random.between(0.0, libm::log(1024.0)))));
        scene.set("code", random.below(256) as f64);
        scene.set("number", random.between(-3.0, 3.0));
        scene.set_beam(&mut Random(random.0 ^ 0x6265_616d));
        scene
    }

    /// What is in the beam, and the pixel that it is seen in.
    fn set_beam(&mut self, random: &mut Random) {
        // Every third one is a quarter of a turn, which is exact.
        let roll = random.between(-180.0, 180.0);
        self.set("roll", if random.below(3) == 0 { 90.0 * libm::floor(roll / 90.0) } else { roll });
        self.set("density", libm::exp(random.between(-6.0, -1.0)));
        self.set("column", random.below(1_000) as f64);
        self.set("row", random.below(1_000) as f64);
    }

    /// A value by its name.
    pub(crate) fn value(&self, name: &str, component: usize) -> f64 {
        self.values.get(name).unwrap_or_else(|| panic!("a scene has no {name}"))[component]
    }

    pub(crate) fn vector(&self, name: &str) -> [f64; 3] {
        [0, 1, 2].map(|component| self.value(name, component))
    }

    pub(crate) fn set(&mut self, name: &'static str, value: f64) {
        self.set_vector(name, [value; 3]);
    }

    pub(crate) fn set_vector(&mut self, name: &'static str, value: [f64; 3]) {
        self.values.insert(name, value);
    }

    /// Moves the surface to `off_axis` degrees off the axis, facing the light more or less, with an
    /// eye near the mirror direction.
    pub(crate) fn look_at(&mut self, off_axis: f64, distance: f64, random: &mut Random) {
        let (position, axis) = (self.vector("position"), self.vector("axis"));
        let across = loop {
            let v = random.direction();
            let v = plus(v, scaled(axis, -dot(v, axis)));
            if dot(v, v) > 0.01 {
                break unit(v);
            }
        };
        let (sine, cosine) = (libm::sin(off_axis.to_radians()), libm::cos(off_axis.to_radians()));
        let way = plus(scaled(axis, cosine), scaled(across, sine));
        let normal = unit(plus(scaled(way, -1.0), scaled(random.direction(), 0.7)));
        let mirror = plus(way, scaled(normal, -2.0 * dot(way, normal)));
        let view = unit(plus(mirror, scaled(random.direction(), 0.3)));
        let point = plus(position, scaled(way, distance)).map(on_grid);
        self.set_vector("point", point);
        self.set_vector("normal", normal);
        self.set_vector("view", view);
        self.set_vector("eye", plus(point, scaled(view, 3.0)).map(on_grid));
    }
}

/// The versine of an angle in degrees.
pub(crate) fn versine(degrees: f64) -> f64 {
    let sine = libm::sin(degrees.to_radians() / 2.0);
    2.0 * sine * sine
}

/// The nearest multiple of 2^-16, which every format has as a length.
pub(crate) fn on_grid(value: f64) -> f64 {
    libm::floor(value * 65_536.0 + 0.5) / 65_536.0
}
