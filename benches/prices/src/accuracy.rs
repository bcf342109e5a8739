//! The errors of the kernels against f64.

use luminaire_kernels::scene::Site;
use luminaire_kernels::truth::{Point, widened};
use luminaire_kernels::{Kernel, Row, Setting, Value, Visitor, falloffs, points};
use luminaire_oracle::{Cone, half_degrees, linear_codes};

use serde::{Serialize, Serializer};

use crate::{Named, site};

/// Number of versines per cone.
const VERSINES: u32 = 1 << 18;

/// How the largest error was found: by trying every input, or some.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Every input was tried: the error is a bound.
    Exhaustive,
    /// The error is the largest of many inputs.
    Searched,
}

/// The errors of a kernel in a cone, in linear codes: 1/255 of full scale, or of the exact light
/// where that is over full scale.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Accuracy {
    /// The kernel.
    #[serde(flatten)]
    pub kernel: Named,
    /// The outer half angle in degrees.
    pub half_angle: f32,
    /// The errors, or `None` if the kernel's format does not support the cone.
    pub error: Option<Errors>,
    /// The narrowest half angle in degrees that the format supports, if it does not support the
    /// cone.
    pub narrowest: Option<f32>,
}

/// The errors of a kernel in a cone.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Errors {
    /// The largest error in linear codes.
    #[serde(serialize_with = "four_digits")]
    pub codes: f64,
    /// The largest error in steps of the format at 1.
    #[serde(serialize_with = "four_digits")]
    pub lsb: f64,
    /// The input with the largest error. `None` if no input has an error.
    pub at: Option<Place>,
    /// The mean error over the evenly spread inputs, in linear codes.
    #[serde(serialize_with = "four_digits")]
    pub mean_codes: f64,
    /// The 99.9th percentile of the errors of the evenly spread inputs, in linear codes.
    #[serde(serialize_with = "four_digits")]
    pub p999_codes: f64,
    /// How the largest error was found.
    pub kind: Kind,
}

/// The input with the largest error of a kernel.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Place {
    /// The angle off axis.
    pub degrees_off_axis: f64,
    /// The distance of a point.
    pub distance: Option<f64>,
    /// The angle of incidence at a point.
    pub degrees_of_incidence: Option<f64>,
}

impl Accuracy {
    /// The errors of every kernel in a cone.
    pub fn of_all(setting: Setting) -> Vec<Self> {
        let mut search = Search { setting, found: Vec::new() };
        falloffs(setting, &mut search);
        points(setting, &mut search);
        search.found
    }
}

/// Serialises four digits, which are more than any comparison needs.
pub(crate) fn four_digits<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(format!("{value:.3e}").parse().unwrap_or(*value))
}

/// Rounds to three decimals.
fn thousandths(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

struct Search {
    setting: Setting,
    found: Vec<Accuracy>,
}

/// The errors found so far at places `P`.
struct Tally<P> {
    errors: Vec<f64>,
    worst: (f64, Option<P>),
}

impl<P: Copy> Tally<P> {
    fn new() -> Self {
        Self { errors: Vec::new(), worst: (-1.0, None) }
    }

    /// Updates only the largest error with an input. Returns the input's error.
    fn glance(&mut self, place: P, result: impl Value, exact: f64) -> f64 {
        let error = linear_codes(result.exact(), exact);
        if error > self.worst.0 {
            self.worst = (error, Some(place));
        }
        error
    }

    /// Records one of the evenly spread inputs, which also count for mean and percentile.
    fn look(&mut self, place: P, result: impl Value, exact: f64) {
        let error = self.glance(place, result, exact);
        self.errors.push(error);
    }

    fn errors<V: Value>(mut self, describe: impl Fn(P) -> Place, kind: Kind) -> Errors {
        let count = self.errors.len();
        let mean = self.errors.iter().sum::<f64>() / count as f64;
        let (_, nearly_all, _) = self.errors.select_nth_unstable_by(count - 1 - count / 1000, f64::total_cmp);
        let (largest, place) = self.worst;
        Errors {
            codes: largest,
            lsb: largest / 255.0 / V::STEP,
            at: place.filter(|_| largest > 0.0).map(describe),
            mean_codes: mean,
            p999_codes: *nearly_all,
            kind,
        }
    }
}

impl Search {
    fn note(&mut self, row: Row, error: Option<Errors>, narrowest: Option<f32>) {
        let half_angle = self.setting.outer().to_degrees() / 2.0;
        self.found.push(Accuracy { kernel: row.into(), half_angle, error, narrowest });
    }
}

impl Visitor for Search {
    fn falloff<K: Kernel<Place = f32>>(&mut self, row: Row, kernel: K, truth: &Cone) {
        let mut tally = Tally::new();
        let outer = self.setting.outer_versine();
        // Next to a jump a kernel may evaluate either side of it: only its position is tested.
        let jump = half_degrees(truth.limit).to_radians() / 510.0;
        let looked_at = |versine: f64| !truth.jumps_near(versine, jump);
        for i in 0..VERSINES {
            let versine = (f64::from(outer) * (f64::from(i) + 0.5) / f64::from(VERSINES)) as f32;
            if looked_at(versine.into()) {
                let result = kernel.evaluate(&kernel.input(&versine));
                tally.look(f64::from(versine), result, truth.falloff(versine.into()));
            }
        }
        for seam in [0.0, f32::MIN_POSITIVE, outer.next_down(), outer, outer.next_up()] {
            if looked_at(seam.into()) {
                tally.glance(seam.into(), kernel.evaluate(&kernel.input(&seam)), truth.falloff(seam.into()));
            }
        }
        let is_whole = kernel.bounds(&mut |input, versine| {
            if looked_at(versine) {
                tally.glance(versine, kernel.evaluate(&input), truth.falloff(versine));
            }
        });
        let kind = if is_whole { Kind::Exhaustive } else { Kind::Searched };
        let describe = |versine| Place {
            degrees_off_axis: thousandths(half_degrees(versine)),
            distance: None,
            degrees_of_incidence: None,
        };
        self.note(row, Some(tally.errors::<K::Output>(describe, kind)), None);
    }

    fn point<K: Kernel<Place = Site>>(&mut self, row: Row, kernel: K, truth: &Point) {
        let mut tally = Tally::new();
        for site in site::about(truth) {
            tally.look(site, kernel.evaluate(&kernel.input(&site)), truth.at(&site));
        }
        let describe = |site: Site| {
            let point = widened(site.point);
            let to_light = truth.light.position - point;
            let incidence = to_light.angle_between(widened(site.normal)).to_degrees();
            Place {
                degrees_off_axis: thousandths(half_degrees(truth.light.versine(point))),
                distance: Some(thousandths(to_light.length())),
                degrees_of_incidence: Some(thousandths(incidence)),
            }
        };
        self.note(row, Some(tally.errors::<K::Output>(describe, Kind::Searched)), None);
    }

    fn refused(&mut self, row: Row, narrowest: f32) {
        self.note(row, None, Some(narrowest));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luminaire_kernels::Stage;

    #[test]
    fn the_largest_error_is_told_with_its_place_and_a_lack_of_one_is_no_error() {
        let mut tally = Tally::new();
        for i in 0..1000 {
            tally.look(i, if i == 7 { 1.5_f32 } else { 1.0 }, 1.0);
        }
        let place = |i| Place { degrees_off_axis: f64::from(i), distance: None, degrees_of_incidence: None };
        let errors = tally.errors::<f32>(place, Kind::Searched);
        assert_eq!((errors.codes, errors.at, errors.p999_codes), (127.5, Some(place(7)), 0.0));
        assert_eq!(errors.mean_codes, 0.1275);
        let mut tally = Tally::new();
        tally.look((), f32::NAN, 0.0);
        assert_eq!(tally.worst.0, f64::INFINITY);
    }

    #[test]
    fn every_number_of_a_small_format_is_looked_at() {
        let all = Accuracy::of_all(Setting::standard());
        for row in &all {
            let is_small = row.kernel.stage == Stage::Falloff.name() && row.kernel.format == "fx16";
            let is_whole = row.error.as_ref().is_some_and(|error| error.kind == Kind::Exhaustive);
            assert_eq!(is_whole, is_small, "{row:?}");
        }
        let soft = all.iter().find(|row| (row.kernel.kernel, row.kernel.format) == ("soft", "fx16")).unwrap();
        let error = soft.error.as_ref().unwrap();
        assert!(error.p999_codes <= error.codes && error.mean_codes < error.p999_codes, "{soft:?}");
    }
}
