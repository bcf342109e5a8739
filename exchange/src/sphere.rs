//! Intensities over the whole sphere, and a table on the octahedron that holds them.

use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::ops::Neg;

use luminaire::light::{Distribution, Symmetry};

/// A coordinate system of photometry: half planes about a pole, and angles from the pole, in degrees.
///
/// The axis of the light is the direction down of type C, and the direction at which both angles of the types B and A are
/// 0. Seen along the axis, the side is to the right and the front is up (CIE 121, IES LM-75).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Goniometer {
    /// The pole is the axis. The plane C0 is that of the side, and C90 that of the front.
    C,
    /// The pole is the side. The planes are the vertical angles, from the axis toward the front, and the angles are
    /// 90 degrees less the horizontal ones.
    B,
    /// The pole is the front. The planes are the horizontal angles, from the axis toward the side, and the angles are
    /// 90 degrees less the vertical ones.
    A,
}

impl Goniometer {
    /// Returns the components along the plane 0, the plane 90 and the pole of those along side, front and axis.
    fn own<T>(self, [side, front, axis]: [T; 3]) -> [T; 3] {
        match self {
            Self::C => [side, front, axis],
            Self::B => [axis, front, side],
            Self::A => [axis, side, front],
        }
    }

    /// Returns the components along side, front and axis: the inverse of [`own`](Self::own).
    fn of_light<T>(self, [zero, right, pole]: [T; 3]) -> [T; 3] {
        match self {
            Self::C => [zero, right, pole],
            Self::B => [pole, right, zero],
            Self::A => [right, pole, zero],
        }
    }

    /// Returns the plane and the angle of the direction that is mirrored from side to side.
    fn other_side(self, [plane, angle]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::C => [180.0 - plane, angle],
            Self::B => [plane, 180.0 - angle],
            Self::A => [-plane, angle],
        }
    }

    /// Returns the plane and the angle of the direction that is mirrored from front to back.
    fn other_front(self, [plane, angle]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::C | Self::B => [-plane, angle],
            Self::A => [plane, 180.0 - angle],
        }
    }
}

/// Intensities in candela over the planes and the angles of a goniometer, bilinear between both.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Sphere {
    goniometer: Goniometer,
    /// Degrees, ascending: all planes of the circle of type C, and one more at either end; of the other types the planes
    /// of the file.
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
    /// Creates a sphere from the planes of a file of type C, which may be a half or a quarter of the circle: 0 to 90, 0 to 180,
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
        let goniometer = Goniometer::C;
        (peak > 0.0).then_some(Self { goniometer, planes, angles: angles.to_vec(), candela, peak })
    }

    /// Creates a sphere from the intensities of a file of type B or A at horizontal and vertical angles, in degrees from -90
    /// to 90. Angles that begin at 0 are those of both sides. `None` without light.
    ///
    /// `candela` has all vertical angles of a horizontal one, one after the other.
    pub(crate) fn across(
        goniometer: Goniometer,
        [horizontal, vertical]: [&[f64]; 2],
        candela: &[f64],
    ) -> Option<Self> {
        let both = |angles: &[f64]| -> Vec<(f64, usize)> {
            let own = angles.iter().enumerate().map(|(index, angle)| (*angle, index));
            let mirrored = own.clone().rev().filter(|(angle, _)| angles[0] == 0.0 && *angle > 0.0);
            mirrored.map(|(angle, index)| (-angle, index)).chain(own).collect()
        };
        let [across, up] = [both(horizontal), both(vertical)];
        let is_b = goniometer == Goniometer::B;
        let (planes, latitudes) = if is_b { (up, across) } else { (across, up) };
        let candela = planes.iter().flat_map(|(_, plane)| {
            latitudes.iter().rev().map(move |(_, latitude)| {
                let [across, up] = if is_b { [latitude, plane] } else { [plane, latitude] };
                candela[across * vertical.len() + up]
            })
        });
        let candela: Vec<_> = candela.collect();
        let peak = candela.iter().copied().fold(0.0, f64::max);
        let angles = latitudes.iter().rev().map(|(latitude, _)| 90.0 - latitude).collect();
        let planes = planes.into_iter().map(|plane| plane.0).collect();
        (peak > 0.0).then_some(Self { goniometer, planes, angles, candela, peak })
    }

    /// Returns the mean intensity in candela about the axis of the light, at angles off the axis in degrees, and of the direction
    /// that differs most from it the difference in candela, the angle off the axis and the angle about it from the
    /// side.
    pub(crate) fn mean(&self) -> (Vec<(f64, f64)>, [f64; 3]) {
        let (mut points, mut worst) = (Vec::new(), [0.0; 3]);
        for angle in (0..=720).map(|i| f64::from(i) / 4.0) {
            let (sine, cosine) = angle.to_radians().sin_cos();
            let at = |about: f64| {
                let (front, side) = about.to_radians().sin_cos();
                self.peak * self.toward([sine * side, sine * front, cosine])
            };
            let mean = (0..360).map(|about| at(f64::from(about))).sum::<f64>() / 360.0;
            for about in (0..360).map(f64::from) {
                let difference = (at(about) - mean).abs();
                if difference > worst[0] {
                    worst = [difference, angle, about];
                }
            }
            points.push((angle, mean));
        }
        (points, worst)
    }

    /// Returns the largest intensity.
    pub(crate) fn peak(&self) -> f64 {
        self.peak
    }

    /// Returns the share of the largest intensity at a plane from 0 to 360 and an angle, in degrees; 0 beyond the
    /// planes and the angles of the file.
    fn at(&self, plane: f64, angle: f64) -> f64 {
        let holds = |places: &[f64], place| (places[0]..=places[places.len() - 1]).contains(&place);
        let plane = if holds(&self.planes, plane) { plane } else { plane - 360.0 };
        if !(holds(&self.planes, plane) && holds(&self.angles, angle)) {
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

    /// Returns the share of the largest intensity in a direction along side, front and axis, of any length.
    fn toward(&self, direction: [f64; 3]) -> f64 {
        let [zero, right, pole] = self.goniometer.own(direction);
        let plane = right.atan2(zero).to_degrees();
        let plane = if plane < 0.0 { plane + 360.0 } else { plane };
        self.at(plane, zero.hypot(right).atan2(pole).to_degrees())
    }

    /// Returns whether the light is the same in mirrored directions, within half a step of a sample.
    fn is_mirrored(&self, mirror: impl Fn([f64; 2]) -> [f64; 2]) -> bool {
        let at = |[plane, angle]: [f64; 2]| self.at(plane.rem_euclid(360.0), angle);
        let places = self.planes.iter().flat_map(|plane| self.angles.iter().map(|angle| [*plane, *angle]));
        places.into_iter().all(|place| (at(place) - at(mirror(place))).abs() <= SAME)
    }

    /// Returns the table of a size, with the symmetry of the intensities.
    pub(crate) fn table(&self, size: u32) -> Table {
        let side = self.is_mirrored(|place| self.goniometer.other_front(place));
        let front = self.is_mirrored(|place| self.goniometer.other_side(place));
        let symmetry = match (side, front) {
            (true, true) => Symmetry::Quadrant,
            (false, false) => Symmetry::None,
            _ => Symmetry::Bilateral,
        };
        let half = f64::from(size / 2);
        let from = |folds: bool| if folds { size / 2 } else { 0 };
        let (columns, rows) =
            (from(symmetry == Symmetry::Quadrant)..size, from(symmetry != Symmetry::None)..size);
        let mut table = Table { samples: Vec::new(), size, symmetry, is_turned: front && !side };
        let sample = |(column, row): (u32, u32)| {
            let place = [column, row].map(|index| f64::from(index) / half - 1.0);
            (self.toward(table.of_light(direction(place))) * 65_535.0).round() as u16
        };
        let places = rows.flat_map(|row| columns.clone().map(move |column| (column, row)));
        table.samples = places.map(sample).collect();
        table
    }

    /// Returns the range of shares between two planes of a quarter of the circle and two angles.
    fn range(&self, planes: [f64; 2], angles: [f64; 2]) -> [f64; 2] {
        let ends = |places: &[f64]| [places[0], places[places.len() - 1]];
        let [own_planes, own_angles] = [ends(&self.planes), ends(&self.angles)];
        let planes = if planes[0] >= own_planes[1] { planes.map(|plane| plane - 360.0) } else { planes };
        let parts = [(planes, own_planes), (angles, own_angles)];
        let is_beyond = parts.iter().any(|([from, to], [first, last])| from < first || to > last);
        let mut range = if is_beyond { [0.0; 2] } else { [f64::INFINITY, f64::NEG_INFINITY] };
        if parts.iter().any(|([from, to], [first, last])| to < first || from > last) {
            return range;
        }
        let [planes, angles] =
            parts.map(|([from, to], [first, last]): ([f64; 2], [f64; 2])| [from.max(first), to.min(last)]);
        for plane in between(&self.planes, planes) {
            for angle in between(&self.angles, angles) {
                let share = self.at(plane, angle);
                range = [range[0].min(share), range[1].max(share)];
            }
        }
        range
    }

    /// Returns how a table differs from the intensities, without a bound: in the middles of a grid of half a degree over the
    /// angle and one degree over the plane.
    pub(crate) fn sampled(&self, table: &Table) -> Option<Difference> {
        let distribution = table.distribution()?;
        let (mut found, mut square, mut weights) = (0.0_f64, 0.0, 0.0);
        let planes = (0..360).map(|i| f64::from(i) + 0.5);
        let planes: Vec<_> = planes.map(|plane: f64| (plane, plane.to_radians().sin_cos())).collect();
        for angle in (0..360).map(|i| (f64::from(i) + 0.5) / 2.0) {
            let (sine, cosine) = angle.to_radians().sin_cos();
            for (plane, (right, zero)) in planes.iter().copied() {
                let direction = self.goniometer.of_light([sine * zero, sine * right, cosine]);
                let share = distribution.exact(table.own(direction));
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
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for own in boxes(place).map(|own| self.goniometer.own(table.of_light(signed(own, quadrant)))) {
            let [low, high] = self.range(planes_of(own), angles_of(own));
            (least, most) = (least.min(low), most.max(high));
        }
        for (place, own) in corners.into_iter().zip(of_table) {
            let share = self.toward(table.of_light(signed(direction(place), quadrant)));
            *found = found.max(255.0 * (own - share).abs());
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

    /// Returns the components along the side, the front and the axis of the table of those of the light.
    fn own<T: Neg<Output = T>>(&self, [side, front, axis]: [T; 3]) -> [T; 3] {
        if self.is_turned { [front, -side, axis] } else { [side, front, axis] }
    }

    /// Returns the components along the side, the front and the axis of the light of those of the table.
    fn of_light<T: Neg<Output = T>>(&self, [side, front, axis]: [T; 3]) -> [T; 3] {
        if self.is_turned { [-front, side, axis] } else { [side, front, axis] }
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
fn between(places: &[f64], [from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    let [start, end] = [places.partition_point(|own| *own <= from), places.partition_point(|own| *own < to)];
    let inside = places.get(start..end).unwrap_or(&[]).iter().copied();
    [from].into_iter().chain(inside).chain([to])
}

/// Returns the direction of a place on the square from -1 to 1, along side, front and axis, with components whose
/// magnitudes have the sum 1.
fn direction([x, y]: [f64; 2]) -> [f64; 3] {
    let along = 1.0 - x.abs() - y.abs();
    if along < 0.0 {
        [(1.0 - y.abs()).copysign(x), (1.0 - x.abs()).copysign(y), along]
    } else {
        [x, y, along]
    }
}

/// Returns the ranges of the components in a part of the first quadrant: in front, and behind.
fn boxes([[x, right], [y, top]]: [[f64; 2]; 2]) -> impl Iterator<Item = [Range; 3]> {
    let (near, far) = (1.0 - x - y, 1.0 - right - top);
    let front = (near >= 0.0).then(|| [[x, right], [y, top], [far.max(0.0), near]]);
    let last = if near < 0.0 { near } else { -0.0 };
    let behind = (far <= 0.0).then_some([[1.0 - top, 1.0 - y], [1.0 - right, 1.0 - x], [far, last]]);
    front.into_iter().chain(behind).map(|own| own.map(|[from, to]| Range(from, to)))
}

/// Returns components of the first quadrant with the signs of another one.
fn signed<T: Neg<Output = T>>([side, front, axis]: [T; 3], quadrant: usize) -> [T; 3] {
    [if quadrant & 1 == 1 { -side } else { side }, if quadrant & 2 == 2 { -front } else { front }, axis]
}

/// The range of a component, of numbers of one sign.
#[derive(Clone, Copy)]
struct Range(f64, f64);

impl Neg for Range {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.1, -self.0)
    }
}

/// Returns the least and the most of a function of two ranges that is monotone in each number, where the other one is
/// fixed.
fn over([a, b]: [Range; 2], function: fn(f64, f64) -> f64) -> [f64; 2] {
    let all = [function(a.0, b.0), function(a.0, b.1), function(a.1, b.0), function(a.1, b.1)];
    [all.into_iter().fold(f64::INFINITY, f64::min), all.into_iter().fold(f64::NEG_INFINITY, f64::max)]
}

/// Returns the range of the planes of directions, in degrees, within a quarter of the circle from 0 to 360.
fn planes_of([zero, right, _]: [Range; 3]) -> [f64; 2] {
    let planes = over([right, zero], f64::atan2).map(f64::to_degrees);
    if planes[0] < 0.0 { planes.map(|plane| plane + 360.0) } else { planes }
}

/// Returns the range of the angles of directions from the pole, in degrees.
fn angles_of([zero, right, pole]: [Range; 3]) -> [f64; 2] {
    let [from, to] = over([zero, right], f64::hypot);
    over([Range(from, to), pole], f64::atan2).map(f64::to_degrees)
}
