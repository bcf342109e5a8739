//! Intensities over the whole sphere, and a table on the octahedron that holds them.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use luminaire::light::{Distribution, Symmetry};

/// Intensities in candela over the planes and the angles of photometry of type C, bilinear between both. The angle is 0
/// in the direction down, and the planes 0 and 90 are to the right and ahead of a viewer above the light.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Sphere {
    /// Degrees, ascending: all planes of the circle, and one more at either end.
    planes: Vec<f64>,
    angles: Vec<f64>,
    /// Plane by plane.
    candela: Vec<f64>,
    peak: f64,
}

/// How a table differs from the intensities of its file, in linear codes: 1/255 of the largest intensity.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub(crate) struct Difference {
    /// The root of the mean square over the sphere.
    pub(crate) rms: f64,
    /// The largest difference that was found.
    pub(crate) found: f64,
    /// An upper bound of the difference in every direction.
    pub(crate) bound: f64,
}

/// A table, and whether its side is along the plane C90 in place of C0.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Table {
    pub(crate) samples: Vec<u16>,
    pub(crate) size: u32,
    pub(crate) symmetry: Symmetry,
    pub(crate) is_turned: bool,
}

/// Half a step of a sample, up to which two intensities are one.
const SAME: f64 = 0.5 / 65_535.0;

impl Sphere {
    /// Creates a sphere from the planes of a file, which may be a half or a quarter of the circle: 0 to 90, 0 to 180,
    /// 90 to 270 or 270 to 450 degrees. `None` for another part of it, or without light.
    pub(crate) fn new(planes: &[f64], angles: &[f64], candela: &[f64]) -> Option<Self> {
        let (first, last) = (*planes.first()?, *planes.last()?);
        let mirrors: &[fn(f64) -> f64] = match (first, last) {
            (0.0, 90.0) => &[|c| c, |c| 180.0 - c, |c| 180.0 + c, |c| -c],
            (0.0, 180.0) => &[|c| c, |c| -c],
            (90.0, 270.0) | (270.0, 450.0) => &[|c| c, |c| 180.0 - c],
            _ if last - first > 180.0 => &[|c| c],
            _ => return None,
        };
        let all = planes.iter().enumerate();
        let mut all: Vec<_> = all
            .flat_map(|(own, &plane)| {
                mirrors.iter().map(move |mirror| (mirror(plane).rem_euclid(360.0), own))
            })
            .collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all.dedup_by_key(|plane| plane.0);
        let ends =
            [(all[all.len() - 1], -360.0), (all[0], 360.0)].map(|((plane, own), by)| (plane + by, own));
        all.insert(0, ends[0]);
        all.push(ends[1]);
        let count = angles.len();
        let own = |&(_, own): &(f64, usize)| candela[own * count..(own + 1) * count].iter().copied();
        let candela: Vec<_> = all.iter().flat_map(own).collect();
        let peak = candela.iter().copied().fold(0.0, f64::max);
        let planes = all.into_iter().map(|plane| plane.0).collect();
        (peak > 0.0).then_some(Self { planes, angles: angles.to_vec(), candela, peak })
    }

    /// Returns the largest intensity.
    pub(crate) fn peak(&self) -> f64 {
        self.peak
    }

    /// Returns the share of the largest intensity at a plane from 0 to 360 and an angle, in degrees; 0 beyond the
    /// angles of the file.
    fn at(&self, plane: f64, angle: f64) -> f64 {
        let last = self.angles.len() - 1;
        if !(self.angles[0]..=self.angles[last]).contains(&angle) {
            return 0.0;
        }
        let cell = |places: &[f64], place: f64| {
            let next = places.partition_point(|own| *own <= place).clamp(1, places.len() - 1);
            (next - 1, (place - places[next - 1]) / (places[next] - places[next - 1]))
        };
        let ((i, u), (j, v)) = (cell(&self.planes, plane), cell(&self.angles, angle));
        let own = |i: usize| {
            let [from, to] = [j, j + 1].map(|j| self.candela[i * self.angles.len() + j]);
            from + (to - from) * v
        };
        (own(i) + (own(i + 1) - own(i)) * u) / self.peak
    }

    /// Returns whether the light is the same at mirrored planes, within half a step of a sample.
    fn is_mirrored(&self, mirror: impl Fn(f64) -> f64) -> bool {
        self.planes.iter().all(|plane| {
            let [own, other] = [*plane, mirror(*plane)].map(|plane| plane.rem_euclid(360.0));
            self.angles.iter().all(|&angle| (self.at(own, angle) - self.at(other, angle)).abs() <= SAME)
        })
    }

    /// Returns the table of a size, with the symmetry of the intensities.
    pub(crate) fn table(&self, size: u32) -> Table {
        let [side, front] = [self.is_mirrored(|c| -c), self.is_mirrored(|c| 180.0 - c)];
        let symmetry = match (side, front) {
            (true, true) => Symmetry::Quadrant,
            (false, false) => Symmetry::None,
            _ => Symmetry::Bilateral,
        };
        let half = f64::from(size / 2);
        let from = |folds: bool| if folds { size / 2 } else { 0 };
        let (columns, rows) =
            (from(symmetry == Symmetry::Quadrant)..size, from(symmetry != Symmetry::None)..size);
        let is_turned = front && !side;
        let sample = |(column, row): (u32, u32)| {
            let place = [column, row].map(|index| f64::from(index) / half - 1.0);
            let (plane, angle) = direction(place, is_turned);
            (self.at(plane, angle) * 65_535.0).round() as u16
        };
        let places = rows.flat_map(|row| columns.clone().map(move |column| (column, row)));
        Table { samples: places.map(sample).collect(), size, symmetry, is_turned }
    }

    /// Returns the range of shares between two planes and two angles.
    fn range(&self, [first, last]: [f64; 2], [near, far]: [f64; 2]) -> [f64; 2] {
        let (start, end) = (self.angles[0], self.angles[self.angles.len() - 1]);
        let mut range = if near < start || far > end { [0.0; 2] } else { [f64::INFINITY, f64::NEG_INFINITY] };
        if far < start || near > end {
            return range;
        }
        for plane in between(&self.planes, first, last) {
            for angle in between(&self.angles, near.max(start), far.min(end)) {
                let share = self.at(plane, angle);
                range = [range[0].min(share), range[1].max(share)];
            }
        }
        range
    }

    /// Returns how a table differs from the intensities, without a bound: in the middles of a grid of half a degree over the angle and one degree over the plane.
    pub(crate) fn sampled(&self, table: &Table) -> Option<Difference> {
        let distribution = table.distribution()?;
        let (mut found, mut square, mut weights) = (0.0_f64, 0.0, 0.0);
        for angle in (0..360).map(|i| (f64::from(i) + 0.5) / 2.0) {
            let (sine, cosine) = angle.to_radians().sin_cos();
            for plane in (0..360).map(|i| f64::from(i) + 0.5) {
                let (front, side) = (plane - table.turn()).to_radians().sin_cos();
                let share = distribution.exact([sine * side, sine * front, cosine]);
                let difference = 255.0 * (share - self.at(plane, angle)).abs();
                found = found.max(difference);
                square += difference * difference * sine;
                weights += sine;
            }
        }
        Some(Difference { rms: (square / weights).sqrt(), found, bound: 255.0 })
    }

    /// Returns how a table differs from the intensities.
    ///
    /// The bound needs no derivative: over a part of a cell, both are within the least and the largest value at
    /// its corners and, of the file, at the planes and angles between. The part with the largest bound is divided until
    /// this is within 5 % and a twentieth of a code of a difference that was found.
    pub(crate) fn difference(&self, table: &Table) -> Option<Difference> {
        /// The most parts, which bounds the time.
        const MOST: usize = 200_000;
        let mut difference = self.sampled(table)?;
        let cells = table.size / 2;
        let mut parts = BinaryHeap::new();
        // The others differ by as little as mirrored intensities do.
        let quadrants = match table.symmetry {
            Symmetry::None => 4,
            Symmetry::Bilateral => 2,
            Symmetry::Quadrant => 1,
        };
        for quadrant in 0..quadrants {
            for (i, j) in (0..cells).flat_map(|j| (0..cells).map(move |i| (i, j))) {
                let [x, y] = [i, j].map(|i| [i, i + 1].map(|i| f64::from(i) / f64::from(cells)));
                parts.push(self.part(table, quadrant, [x, y], &mut difference.found));
            }
        }
        let mut count = parts.len();
        while let Some(Part { bound, quadrant, place: [x, y] }) = parts.pop() {
            difference.bound = bound.max(difference.found);
            let is_least = x[1] - x[0] < 1e-9;
            if bound <= 1.05 * difference.found + 0.05 || is_least || count > MOST {
                break;
            }
            let halves = |[from, to]: [f64; 2]| [[from, (from + to) / 2.0], [(from + to) / 2.0, to]];
            for x in halves(x) {
                for y in halves(y) {
                    parts.push(self.part(table, quadrant, [x, y], &mut difference.found));
                    count += 1;
                }
            }
        }
        difference.bound += if quadrants < 4 { 255.0 * SAME } else { 0.0 } + 1e-9;
        Some(difference)
    }

    /// Returns a part of a quadrant with its bound, in codes.
    fn part(&self, table: &Table, quadrant: usize, place: [[f64; 2]; 2], found: &mut f64) -> Part {
        let [[x, right], [y, top]] = place;
        let corners = [[x, y], [right, y], [x, top], [right, top]];
        let of_table = corners.map(|place| table.at(quadrant, place));
        let [near, far] = [[x, y], [right, top]].map(angle_of);
        // In front of the diagonal the plane is that of the place, and behind it that of the place mirrored in it.
        let mut planes = [f64::INFINITY, f64::NEG_INFINITY];
        let mut add = |least: f64, most: f64| planes = [planes[0].min(least), planes[1].max(most)];
        if x + y <= 1.0 {
            add(y.atan2(right), top.atan2(x));
        }
        if right + top >= 1.0 {
            add((1.0 - right).atan2(1.0 - y), (1.0 - x).atan2(1.0 - top));
        }
        // The turn leaves the circle at most once.
        let planes = [0, 1].map(|i| turned(planes[i].to_degrees(), quadrant) + table.turn());
        let planes = [planes[0].min(planes[1]), planes[0].max(planes[1])];
        let over = if planes[0] >= 360.0 { 360.0 } else { 0.0 };
        let split = planes[0] < 360.0 && planes[1] > 360.0;
        let [mut least, mut most] =
            self.range(planes.map(|plane| if split { plane.min(360.0) } else { plane - over }), [near, far]);
        if split {
            let beyond = self.range([0.0, planes[1] - 360.0], [near, far]);
            (least, most) = (least.min(beyond[0]), most.max(beyond[1]));
        }
        for (place, own) in corners.into_iter().zip(of_table) {
            let (plane, angle) = place_of(place);
            let plane = (turned(plane, quadrant) + table.turn()).rem_euclid(360.0);
            *found = found.max(255.0 * (own - self.at(plane, angle)).abs());
        }
        let [low, high] = of_table
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], own| [low.min(*own), high.max(*own)]);
        let bound = 255.0 * (most - low).max(high - least);
        Part { bound, quadrant, place }
    }
}

impl Table {
    /// Returns the distribution of the samples.
    pub(crate) fn distribution(&self) -> Option<Distribution<'_>> {
        Distribution::new(&self.samples, self.size, self.symmetry).ok()
    }

    /// Returns the plane of the side, in degrees.
    fn turn(&self) -> f64 {
        if self.is_turned { 90.0 } else { 0.0 }
    }

    /// Returns the share at a place of a quadrant of the square.
    fn at(&self, quadrant: usize, place: [f64; 2]) -> f64 {
        let half = f64::from(self.size / 2);
        let is_folded = [self.symmetry == Symmetry::Quadrant, self.symmetry != Symmetry::None];
        let is_negative = [quadrant & 1 == 1, quadrant & 2 == 2];
        let [x, y] = [0, 1].map(|i| match (is_folded[i], is_negative[i]) {
            (true, _) => half * place[i],
            (false, false) => half * (1.0 + place[i]),
            (false, true) => half * (1.0 - place[i]),
        });
        let columns = if is_folded[0] { self.size / 2 + 1 } else { self.size } as usize;
        let rows = self.samples.len() / columns;
        let [i, j] = [(x, columns), (y, rows)].map(|(place, count)| (place as usize).min(count - 2));
        let (u, v) = (x - i as f64, y - j as f64);
        let own = |j: usize| {
            let [from, to] = [i, i + 1].map(|i| f64::from(self.samples[j * columns + i]));
            from + (to - from) * u
        };
        (own(j) + (own(j + 1) - own(j)) * v) / 65_535.0
    }
}

/// A part of a quadrant of the square: the least and the most x and y, and an upper bound of the difference there.
struct Part {
    bound: f64,
    quadrant: usize,
    place: [[f64; 2]; 2],
}

impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Part {}

impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Part {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound)
    }
}

/// Returns two places and those of a list between them.
fn between(places: &[f64], from: f64, to: f64) -> impl Iterator<Item = f64> {
    let [start, end] = [places.partition_point(|own| *own <= from), places.partition_point(|own| *own < to)];
    let inside = places.get(start..end).unwrap_or(&[]).iter().copied();
    [from].into_iter().chain(inside).chain([to])
}

/// Returns a plane of the first quadrant in another one, in degrees.
fn turned(plane: f64, quadrant: usize) -> f64 {
    match quadrant {
        0 => plane,
        1 => 180.0 - plane,
        2 => 360.0 - plane,
        _ => 180.0 + plane,
    }
}

/// Returns the angle in degrees off the axis of a place of the first quadrant. It rises with x and with y.
fn angle_of([x, y]: [f64; 2]) -> f64 {
    let along = 1.0 - x - y;
    let [a, b] = if along < 0.0 { [1.0 - y, 1.0 - x] } else { [x, y] };
    a.hypot(b).atan2(along).to_degrees()
}

/// Returns the plane and the angle, in degrees, of a place of the first quadrant.
fn place_of([x, y]: [f64; 2]) -> (f64, f64) {
    let [a, b] = if x + y > 1.0 { [1.0 - y, 1.0 - x] } else { [x, y] };
    (b.atan2(a).to_degrees(), angle_of([x, y]))
}

/// Returns the plane from 0 to 360 and the angle, in degrees, of a place on the square from -1 to 1.
fn direction([x, y]: [f64; 2], is_turned: bool) -> (f64, f64) {
    let quadrant = usize::from(x < 0.0) + 2 * usize::from(y < 0.0);
    let (plane, angle) = place_of([x.abs(), y.abs()]);
    let plane = turned(plane, quadrant) + if is_turned { 90.0 } else { 0.0 };
    (plane.rem_euclid(360.0), angle)
}
