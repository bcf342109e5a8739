//! The largest errors of a lit point by each evaluation, in linear codes and in steps of displays.

use luminaire_kernels::scene::Site;
use luminaire_kernels::truth::Point;
use luminaire_kernels::{Kernel, ListedFalloff, Row, Setting, Value, Visitor, rungs};
use luminaire_oracle::{Cone, counted, linear_codes, srgb_code};

use crate::{Lines, four_digits, site};

/// Returns the largest errors of 65,536 points by every evaluation in a cone with this edge, as lines. The
/// names are those of its lit points without and with an inverse square. The errors are in
/// linear codes, clipped at full scale; and in steps of a display after encoding in sRGB, before the
/// rounding to steps, of RGB565's green channel of 6 bits and of channels of 8 bits.
pub fn steps<P: ListedFalloff>(kernels: [&'static str; 2], setting: Setting) -> String {
    let mut search = Search(Lines::default());
    rungs::<P>(kernels, setting, &mut search);
    search.0.0
}

struct Search(Lines);

impl Visitor for Search {
    fn falloff<K: Kernel<Place = f32>>(&mut self, _: Row, _: K, _: &Cone) {}

    fn point<K: Kernel<Place = Site>>(&mut self, row: Row, kernel: K, truth: &Point) {
        let (mut codes, mut rgb888) = (0.0_f64, 0.0_f64);
        for site in site::about(truth) {
            let lights = [kernel.evaluate(&kernel.input(&site)).exact(), truth.at(&site)];
            let [found, exact] = lights.map(|light| light.clamp(0.0, 1.0));
            codes = codes.max(linear_codes(found, exact));
            rgb888 = rgb888.max(counted((srgb_code(found) - srgb_code(exact)).abs()));
        }
        self.0.add(row, four_digits(codes), "codes");
        self.0.add(row, four_digits(rgb888 * 63.0 / 255.0), "rgb565");
        self.0.add(row, four_digits(rgb888), "rgb888");
    }

    fn refused(&mut self, row: Row, narrowest: f32) {
        self.0.add(row, narrowest, "narrowest_degrees");
    }
}
