//! The errors of a lit point by each evaluation, in linear codes and in steps of displays.

use luminaire_kernels::scene::Site;
use luminaire_kernels::truth::Point;
use luminaire_kernels::{Kernel, ListedFalloff, Row, Setting, Value, Visitor, rungs};
use luminaire_oracle::{Cone, counted, linear_codes, srgb_code};
use serde::Serialize;

use crate::accuracy::four_digits;
use crate::{Named, site};

/// The errors of an evaluation in a cone.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Rung {
    /// The kernel and the evaluation.
    #[serde(flatten)]
    pub kernel: Named,
    /// The falloff.
    pub edge: &'static str,
    /// The outer half angle in degrees.
    pub half_angle: f32,
    /// The errors, or `None` if the evaluation does not support the cone.
    pub errors: Option<Steps>,
}

/// The largest errors of 65,536 points.
#[derive(Clone, Copy, PartialEq, Default, Debug, Serialize)]
pub struct Steps {
    /// In linear codes, clipped at full scale.
    #[serde(serialize_with = "four_digits")]
    pub codes: f64,
    /// In steps of a display after encoding in sRGB, before the rounding to steps: of RGB565's green
    /// channel of 6 bits.
    #[serde(serialize_with = "four_digits")]
    pub rgb565: f64,
    /// The same for channels of 8 bits.
    #[serde(serialize_with = "four_digits")]
    pub rgb888: f64,
}

impl Rung {
    /// The errors of every evaluation in a cone with this edge.
    pub fn of_all<P: ListedFalloff>(setting: Setting) -> Vec<Self> {
        let mut search = Search { edge: P::NAME, setting, found: Vec::new() };
        rungs::<P>(setting, &mut search);
        search.found
    }
}

struct Search {
    edge: &'static str,
    setting: Setting,
    found: Vec<Rung>,
}

impl Search {
    fn note(&mut self, row: Row, errors: Option<Steps>) {
        let half_angle = self.setting.outer().to_degrees() / 2.0;
        self.found.push(Rung { kernel: row.into(), edge: self.edge, half_angle, errors });
    }
}

impl Visitor for Search {
    fn falloff<K: Kernel<Place = f32>>(&mut self, _: Row, _: K, _: &Cone) {}

    fn point<K: Kernel<Place = Site>>(&mut self, row: Row, kernel: K, truth: &Point) {
        let mut largest = Steps::default();
        for site in site::about(truth) {
            let lights = [kernel.evaluate(&kernel.input(&site)).exact(), truth.at(&site)];
            let [found, exact] = lights.map(|light| light.clamp(0.0, 1.0));
            largest.codes = largest.codes.max(linear_codes(found, exact));
            largest.rgb888 = largest.rgb888.max(counted((srgb_code(found) - srgb_code(exact)).abs()));
        }
        largest.rgb565 = largest.rgb888 * 63.0 / 255.0;
        self.note(row, Some(largest));
    }

    fn refused(&mut self, row: Row, _: f32) {
        self.note(row, None);
    }
}
