//! The errors of the kernels against f64.

use std::fmt;

use luminaire_kernels::oracle::{self, dot, minus, unit, widened};
use luminaire_kernels::scene::Site;
use luminaire_kernels::{Kernel, Row, Setting, Value, Visitor, falloffs, points};

use crate::site::{self, half_angle};

/// Number of versines per cone.
const VERSINES: u32 = 1 << 18;

/// How the largest error was found.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// No input was left out: the error is a bound.
    Exhaustive,
    /// The error is the largest of many inputs.
    Searched,
}

/// The errors of a kernel in a cone, in linear codes: 1 is 1/255 of full scale, or of the light
/// itself where that is more.
#[derive(Clone, PartialEq, Debug)]
pub struct Accuracy {
    /// The kernel.
    pub row: Row,
    /// The outer half angle in degrees.
    pub half_angle: f32,
    /// The errors, or the narrowest half angle in degrees that the kernel's format holds.
    pub errors: Result<Errors, f32>,
}

/// The errors of a kernel in a cone.
#[derive(Clone, PartialEq, Debug)]
pub struct Errors {
    /// The largest.
    pub largest: f64,
    /// The largest in units of the last place of one.
    pub steps: f64,
    /// Degrees off axis of the largest error, and for a point its distance and the degrees of
    /// incidence. Empty if there is no error.
    pub at: Vec<f64>,
    /// The mean over the evaluated inputs, which are evenly spread.
    pub mean: f64,
    /// The 99.9th percentile of the errors of these inputs.
    pub nearly_all: f64,
    /// How the largest was found.
    pub kind: Kind,
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

/// `accuracy stage format kernel half-angle largest steps at mean nearly-all kind`, or `refused`
/// with the narrowest half angle in place of the last six. Numbers with all their digits.
impl fmt::Display for Accuracy {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Row { kernel, stage, format } = self.row;
        write!(out, "accuracy {} {format} {kernel} {}", stage.name(), self.half_angle)?;
        match &self.errors {
            Err(narrowest) => write!(out, " refused {narrowest}"),
            Ok(errors) => {
                let at: Vec<_> = errors.at.iter().map(|number| format!("{number:.3}")).collect();
                let at = if at.is_empty() { "nowhere".to_owned() } else { at.join(",") };
                let kind = match errors.kind {
                    Kind::Exhaustive => "exhaustive",
                    Kind::Searched => "searched",
                };
                let Errors { largest, steps, mean, nearly_all, .. } = errors;
                write!(out, " {largest:.3e} {steps:.3e} {at} {mean:.3e} {nearly_all:.3e} {kind}")
            }
        }
    }
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

    /// Enters an input into the largest error only, and returns its error.
    fn glance(&mut self, place: P, result: impl Value, exact: f64) -> f64 {
        let error = 255.0 * (result.exact() - exact).abs() / exact.max(1.0);
        // NaN counts as an infinite error.
        let error = if error.is_nan() { f64::INFINITY } else { error };
        if error > self.worst.0 {
            self.worst = (error, Some(place));
        }
        error
    }

    /// Enters one of the evenly spread inputs.
    fn look(&mut self, place: P, result: impl Value, exact: f64) {
        let error = self.glance(place, result, exact);
        self.errors.push(error);
    }

    fn errors<V: Value>(mut self, describe: impl Fn(P) -> Vec<f64>, kind: Kind) -> Errors {
        let count = self.errors.len();
        let mean = self.errors.iter().sum::<f64>() / count as f64;
        let (_, nearly_all, _) = self.errors.select_nth_unstable_by(count - 1 - count / 1000, f64::total_cmp);
        let (largest, place) = self.worst;
        Errors {
            largest,
            steps: largest / 255.0 / V::STEP,
            at: place.filter(|_| largest > 0.0).map(describe).unwrap_or_default(),
            mean,
            nearly_all: *nearly_all,
            kind,
        }
    }
}

impl Search {
    fn note(&mut self, row: Row, errors: Result<Errors, f32>) {
        let half_angle = self.setting.outer().to_degrees() / 2.0;
        self.found.push(Accuracy { row, half_angle, errors });
    }
}

impl Visitor for Search {
    fn falloff<K: Kernel<Place = f32>>(&mut self, row: Row, kernel: K, truth: &oracle::Falloff) {
        let mut tally = Tally::new();
        let outer = self.setting.outer_versine();
        let looked_at = |versine: f64| !truth.is_at_jump(versine);
        for i in 0..VERSINES {
            let versine = (f64::from(outer) * (f64::from(i) + 0.5) / f64::from(VERSINES)) as f32;
            if looked_at(versine.into()) {
                let result = kernel.evaluate(&kernel.input(&versine));
                tally.look(f64::from(versine), result, truth.at(versine.into()));
            }
        }
        for seam in [0.0, f32::MIN_POSITIVE, outer.next_down(), outer, outer.next_up()] {
            if looked_at(seam.into()) {
                tally.glance(seam.into(), kernel.evaluate(&kernel.input(&seam)), truth.at(seam.into()));
            }
        }
        let is_whole = kernel.bounds(&mut |input, versine| {
            if looked_at(versine) {
                tally.glance(versine, kernel.evaluate(&input), truth.at(versine));
            }
        });
        let kind = if is_whole { Kind::Exhaustive } else { Kind::Searched };
        let errors = tally.errors::<K::Output>(|versine| vec![half_angle(versine).to_degrees()], kind);
        self.note(row, Ok(errors));
    }

    fn point<K: Kernel<Place = Site>>(&mut self, row: Row, kernel: K, truth: &oracle::Point) {
        let mut tally = Tally::new();
        for site in site::about(truth) {
            tally.look(site, kernel.evaluate(&kernel.input(&site)), truth.at(&site));
        }
        let describe = |site: Site| {
            let way = minus(widened(site.point), truth.position);
            let difference = minus(unit(way), unit(truth.axis));
            let incidence = -dot(unit(way), unit(widened(site.normal)));
            let off_axis = half_angle(dot(difference, difference) / 2.0);
            vec![off_axis.to_degrees(), dot(way, way).sqrt(), incidence.clamp(-1.0, 1.0).acos().to_degrees()]
        };
        let errors = tally.errors::<K::Output>(describe, Kind::Searched);
        self.note(row, Ok(errors));
    }

    fn refused(&mut self, row: Row, narrowest: f32) {
        self.note(row, Err(narrowest));
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
        let errors = tally.errors::<f32>(|i| vec![f64::from(i)], Kind::Searched);
        assert_eq!((errors.largest, errors.at, errors.nearly_all), (127.5, vec![7.0], 0.0));
        assert_eq!(errors.mean, 0.1275);
        let mut tally = Tally::new();
        tally.look((), f32::NAN, 0.0);
        assert_eq!(tally.worst.0, f64::INFINITY);
    }

    #[test]
    fn every_number_of_a_small_format_is_looked_at() {
        let all = Accuracy::of_all(Setting::standard());
        let whole = |row: &Accuracy| matches!(&row.errors, Ok(errors) if errors.kind == Kind::Exhaustive);
        for row in &all {
            let is_small = row.row.stage == Stage::Falloff && row.row.format == "fx16";
            assert_eq!(whole(row), is_small, "{row}");
        }
        let soft = all.iter().find(|row| (row.row.kernel, row.row.format) == ("soft", "fx16")).unwrap();
        let errors = soft.errors.as_ref().unwrap();
        assert!(errors.nearly_all <= errors.largest && errors.mean < errors.nearly_all, "{soft}");
    }
}
