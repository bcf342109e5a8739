//! The errors of the kernels against f64.

use fastrand::Rng;
use luminaire_kernels::scene::{Population, Site};
use luminaire_kernels::truth::{Point, widened};
use luminaire_kernels::{Kernel, Row, Setting, Value, Visitor, falloffs, points, rivals};
use luminaire_oracle::climb::{Worst, climb, ulp_step};
use luminaire_oracle::{Cone, half_degrees, linear_codes};

use crate::{Lines, four_digits, site};

/// Number of versines per cone.
const VERSINES: u32 = 1 << 18;
/// Number of climbs from the worst of the evenly spread inputs, and their steps.
const CLIMBS: usize = 8;
const STEPS: usize = 4_000;

/// Returns the errors of every kernel in a cone, as lines, after the cone's half angle: the largest in linear codes, 1/255 of full scale
/// or of the exact light where that is over full scale, and in steps of the format at 1; the input with
/// the largest error; the mean and the 99.9th percentile over the evenly spread inputs; and how the largest
/// was found. For a format that does not hold the cone, the narrowest half angle in degrees that it holds.
pub fn errors(setting: Setting) -> String {
    let cone = format!("cone {} half_angle\n", setting.outer().to_degrees() / 2.0);
    let mut search = Search { setting, lines: Lines(cone) };
    falloffs(setting, &mut search);
    points(setting, &mut search);
    rivals(setting, &mut search);
    search.lines.0
}

/// Rounds to three decimals.
fn thousandths(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

struct Search {
    setting: Setting,
    lines: Lines,
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

    /// Climbs from the worst input so far.
    fn climb(&mut self, moved: impl Fn(&mut Rng, P) -> P, error: impl Fn(P) -> f64) {
        let (largest, Some(place)) = self.worst else { return };
        for seed in 0..CLIMBS {
            let worst = Worst { input: place, error: largest };
            let found = climb(&mut Rng::with_seed(seed as u64), worst, STEPS, &moved, &error);
            if found.error > self.worst.0 {
                self.worst = (found.error, Some(found.input));
            }
        }
    }

    /// Records one of the evenly spread inputs, which also count for mean and percentile.
    fn look(&mut self, place: P, result: impl Value, exact: f64) {
        let error = self.glance(place, result, exact);
        self.errors.push(error);
    }

    /// Writes the errors, and the place of the largest as `describe` gives it: numbers with their units.
    fn write<V: Value>(
        mut self,
        lines: &mut Lines,
        row: Row,
        kind: &str,
        describe: impl Fn(P) -> Vec<(f64, &'static str)>,
    ) {
        let count = self.errors.len();
        let mean = self.errors.iter().sum::<f64>() / count as f64;
        let (_, nearly_all, _) = self.errors.select_nth_unstable_by(count - 1 - count / 1000, f64::total_cmp);
        let (largest, place) = self.worst;
        lines.add(row, row.stage.name(), "stage");
        lines.add(row, four_digits(largest), "codes");
        lines.add(row, four_digits(largest / 255.0 / V::STEP), "lsb");
        for (value, unit) in place.filter(|_| largest > 0.0).map(describe).into_iter().flatten() {
            lines.add(row, thousandths(value), unit);
        }
        lines.add(row, four_digits(mean), "mean_codes");
        lines.add(row, four_digits(*nearly_all), "p999_codes");
        lines.add(row, kind, "kind");
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
        if !is_whole {
            let error = |versine: f64| {
                let result = kernel.evaluate(&kernel.input(&(versine as f32)));
                if looked_at(versine) { linear_codes(result.exact(), truth.falloff(versine)) } else { -1.0 }
            };
            let moved =
                |rng: &mut Rng, versine: f64| f64::from(ulp_step(rng)(versine as f32).clamp(0.0, outer));
            tally.climb(moved, error);
        }
        let kind = if is_whole { "exhaustive" } else { "searched" };
        let describe = |versine| vec![(half_degrees(versine), "degrees_off_axis")];
        tally.write::<K::Output>(&mut self.lines, row, kind, describe);
    }

    fn point<K: Kernel<Place = Site>>(&mut self, row: Row, kernel: K, truth: &Point) {
        let mut tally = Tally::new();
        for site in site::about(truth) {
            tally.look(site, kernel.evaluate(&kernel.input(&site)), truth.at(&site));
        }
        if truth.population == Population::Lit {
            tally.climb(site::moved, |site| {
                let result = kernel.evaluate(&kernel.input(&site));
                if site::is_counted(truth, &site) {
                    linear_codes(result.exact(), truth.at(&site))
                } else {
                    -1.0
                }
            });
        }
        let describe = |site: Site| {
            let point = widened(site.point);
            let to_light = truth.light.position - point;
            let incidence = to_light.angle_between(widened(site.normal)).to_degrees();
            vec![
                (half_degrees(truth.light.versine(point)), "degrees_off_axis"),
                (to_light.length(), "distance"),
                (incidence, "degrees_of_incidence"),
            ]
        };
        tally.write::<K::Output>(&mut self.lines, row, "searched", describe);
    }

    fn refused(&mut self, row: Row, narrowest: f32) {
        self.lines.add(row, narrowest, "narrowest_degrees");
    }
}
