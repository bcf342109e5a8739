//! Silhouettes: the visible edges of the meshes, and the exact share of each pixel beyond an edge.
//!
//! A picture has one sample per pixel, so the rasteriser gives a pixel at an edge to one side of
//! the edge. This module finds which part of the pixel belongs to the other side. The edges come
//! from the meshes, not from the picture, so their positions are exact to 1/256 of a pixel.

use crate::{
    raster::{
        Edge, Fragments, Grid, PIXEL, Walk,
        adjacency::Adjacency,
        clip::{Sighting, clip_edge},
        first_center,
        view::{Corner, View},
    },
    scene::{Fingerprint, Scene},
    stripes::Stripes,
};
use alloc::vec::Vec;
use core::ops::Range;

/// Factor by which a surface beside an edge may be nearer than the edge, for rounding errors.
const NEARER: f32 = 1.001;

/// The same factor for a surface whose slope is unknown, because it is at the border of a stripe.
/// Only pixels of one stripe decide whether an edge is visible, so that the renderers that share a
/// picture find the same edges as one renderer of the whole picture.
const MUCH_NEARER: f32 = 1.03;

/// Column and row of a pixel; negative outside the picture.
type Pixel = (i64, i64);

/// The edges of a scene, and the shares that they take of the pixels of a view.
#[derive(Clone, Default, Debug)]
pub(crate) struct Silhouettes {
    scene: Option<Fingerprint>,
    meshes: Vec<Adjacency>,
    faces: Vec<bool>,
    segments: Vec<Segment>,
    marks: Vec<Mark>,
}

/// A pixel of which an edge gives a share to a neighbour.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Mark(pub(crate) u64);

/// A projected edge. On a screen with y down, the surface that faces the eye lies on the right.
#[derive(Clone, Copy, Debug)]
struct Segment {
    from: Corner,
    to: Corner,
    material: u32,
    is_crease: bool,
}

impl Silhouettes {
    /// Forgets the edges of the last view, and finds the adjacency of a changed scene.
    pub(crate) fn begin(&mut self, scene: &Scene) {
        self.segments.clear();
        self.marks.clear();
        if self.scene != Some(scene.fingerprint()) {
            self.scene = Some(scene.fingerprint());
            self.meshes.clear();
            self.meshes.extend(scene.objects().iter().map(|object| Adjacency::new(&object.mesh)));
        }
    }

    /// Projects the edges of the mesh with the given number, from 1 on, that a view shows unless
    /// something hides them. `sightings` are the mesh's vertices.
    pub(crate) fn project(&mut self, view: &View, material: u32, sightings: &[Sighting]) {
        let Self { meshes, faces, segments, .. } = self;
        let Some(mesh) = meshes.get(material as usize - 1) else { return };
        mesh.seen_from(view.eye(), faces, |edge| {
            let [from, to] = edge.ends.map(|vertex| &sightings[vertex as usize]);
            // The rasteriser walks around a triangle in the opposite order, because y points down.
            if let Some([to, from]) = clip_edge(view, [from, to]) {
                segments.push(Segment { from, to, material, is_crease: edge.is_crease });
            }
        });
    }

    /// Finds the pixels beside the visible edges.
    pub(crate) fn trace(&mut self, fragments: &Fragments) {
        for segment in &self.segments {
            segment.trace(fragments, |mark| self.marks.push(mark));
        }
    }

    pub(crate) fn marks(&self) -> &[Mark] {
        &self.marks
    }
}

impl Segment {
    /// Calls `mark` with each pixel beside the edge where the edge is visible.
    fn trace(&self, fragments: &Fragments, mut mark: impl FnMut(Mark)) {
        let Self { from, to, .. } = self;
        let Grid { width, height, stripes, .. } = fragments.grid;
        let (top, bottom) = (from.y.min(to.y), from.y.max(to.y));
        // Below the last row of centres the edge may be beside the row above it.
        let touched = first_center(top).saturating_sub(1)..(first_center(bottom) + 1).min(height);
        if stripes.next(touched).is_empty() {
            return;
        }
        let edge = Edge::new(from, to);
        let mut over_rows = |rows: Range<usize>| {
            let part = Part::new((from.y, from.nearness), (to.y, to.nearness));
            self.walk(edge.walk(rows.start as i64), rows, &part, fragments, |x, y| (x, y), &mut mark);
        };
        let is_steep = to.x.abs_diff(from.x) <= to.y.abs_diff(from.y);
        // One step along the longer axis crosses at most two pixels, so the shorter axis is walked
        // only where an outline may turn from one axis to the other.
        if is_steep {
            over_rows(crossed(from.y, to.y, height));
        } else {
            turns([from.y, to.y], [from.x, to.x], height).for_each(&mut over_rows);
        }
        let mut over_columns = |columns: Range<usize>| {
            let part = Part::new((from.x, from.nearness), (to.x, to.nearness));
            let walk = edge.walk_column(columns.start as i64);
            self.walk(walk, columns, &part, fragments, |y, x| (x, y), &mut mark);
        };
        if is_steep {
            turns([from.x, to.x], [from.y, to.y], width).for_each(over_columns);
        } else {
            over_columns(crossed(from.x, to.x, width));
        }
    }

    /// Walks along an edge, over rows or columns. `place` returns the pixel at a position across
    /// the edge and along the edge.
    #[inline(always)]
    fn walk(
        &self,
        mut walk: Walk,
        along: Range<usize>,
        part: &Part,
        fragments: &Fragments,
        place: impl Fn(i64, i64) -> Pixel,
        mark: &mut impl FnMut(Mark),
    ) {
        let grid = &fragments.grid;
        let slope = (walk.row as f32 / walk.column as f32).abs();
        // The step across the edge towards the surface.
        let inwards = walk.column.signum();
        for along in along {
            let along = along as i64;
            let last = -walk.columns * inwards;
            let distance = (walk.rest + walk.excluded) as f32 / walk.whole as f32;
            let [near, far, beyond] = [0, 1, 2].map(|steps| place(last - steps * inwards, along));
            if grid.has(far) && self.is_visible(fragments, [near, far, beyond], part.at(along), distance) {
                let marks = [
                    Mark::new(grid, near, far, share(0.5 - distance, slope)),
                    Mark::new(grid, far, near, share(distance - 0.5, slope)),
                ];
                marks.into_iter().flatten().for_each(&mut *mark);
            }
            walk.step();
        }
    }

    /// Returns whether the edge is visible between the pixels `near`, of its surface, and `far`.
    /// `beyond` is the pixel behind `far`. `nearness` is that of the edge, and `distance` is the
    /// distance of the edge from the centre of `near`, in pixels.
    #[inline(always)]
    fn is_visible(
        &self,
        fragments: &Fragments,
        [near, far, beyond]: [Pixel; 3],
        nearness: f32,
        distance: f32,
    ) -> bool {
        if fragments.at(near).is_none_or(|(_, material)| material != self.material) {
            return false;
        }
        let in_stripe = |pixel: Pixel| {
            let stripe = |(_, y): Pixel| y.div_euclid(Stripes::ROWS as i64);
            fragments.at(pixel).filter(|_| stripe(pixel) == stripe(near))
        };
        let Some((here, material)) = in_stripe(far) else { return true };
        if self.is_crease && material != self.material {
            return false;
        }
        if here <= nearness * NEARER {
            return true;
        }
        match in_stripe(beyond) {
            // A surface that meets the edge, such as a floor under a box, is as near as the edge
            // there.
            Some((next, same)) if same == material => {
                here + (here - next) * (1.0 - distance) <= nearness * NEARER
            }
            Some(_) => false,
            None => here <= nearness * MUCH_NEARER,
        }
    }
}

/// The nearness along an edge.
struct Part {
    start: f32,
    step: f32,
}

impl Part {
    /// `from` and `to` are screen coordinates with the nearness there.
    fn new((from, near_from): (i32, f32), (to, near_to): (i32, f32)) -> Self {
        let step = (near_to - near_from) / (to - from) as f32;
        Self { start: near_from + step * ((PIXEL / 2) as f32 - from as f32), step: step * PIXEL as f32 }
    }

    /// Returns the nearness at the centre of a row or column.
    fn at(&self, along: i64) -> f32 {
        self.start + self.step * along as f32
    }
}

impl Mark {
    /// Returns the mark of a pixel that gives a share to a neighbour; `None` if the share rounds to
    /// 0.
    fn new(grid: &Grid, (x, y): Pixel, neighbor: Pixel, share: f32) -> Option<Self> {
        let direction = match (neighbor.0 - x, neighbor.1 - y) {
            (-1, _) => 0,
            (1, _) => 1,
            (_, -1) => 2,
            _ => 3,
        };
        let share = (share * 256.0 + 0.5) as u64;
        let pixel = (y * grid.width as i64 + x) as u64;
        (share > 0).then_some(Self(pixel << 32 | direction << 16 | share))
    }

    /// The index of the pixel, row by row from the top.
    pub(crate) fn pixel(self) -> u32 {
        (self.0 >> 32) as u32
    }

    /// The direction of the neighbour: 0 to 3 for left, right, up and down.
    pub(crate) fn direction(self) -> usize {
        (self.0 >> 16 & 3) as usize
    }

    /// The share in 256ths, at most 128.
    pub(crate) fn share(self) -> u16 {
        (self.0 as u16).min(128)
    }
}

/// Returns the area of the part of a pixel that lies beyond a line. `across` is the distance by
/// which the line enters the pixel, from the pixel's border, at the middle of the pixel's other
/// axis; negative if the line does not reach the pixel there. `slope` is the change of this distance
/// per pixel along the other axis.
fn share(across: f32, slope: f32) -> f32 {
    // The integral of `clamp(x, 0, 1)` up to x.
    let integral = |x: f32| if x > 1.0 { x - 0.5 } else { 0.5 * x.max(0.0) * x.max(0.0) };
    // For a smaller slope the difference of the integrals has large rounding errors.
    let half = 0.5 * slope.max(1.0 / 256.0);
    (integral(across + half) - integral(across - half)) / (2.0 * half)
}

/// Returns the rows or columns whose centres an edge crosses. Of two edges that meet at a centre,
/// one crosses it.
fn crossed(from: i32, to: i32, count: usize) -> Range<usize> {
    first_center(from.min(to))..first_center(from.max(to)).min(count)
}

/// Returns the rows or columns at the ends of an edge, at which an outline that turns there has no
/// other crossing: from the end of the edge, their centre comes before the first centre along the
/// longer axis. `short` and `long` are the screen coordinates of both ends on both axes.
fn turns(short: [i32; 2], long: [i32; 2], count: usize) -> impl Iterator<Item = Range<usize>> {
    let whole = crossed(short[0], short[1], count);
    let center = |[end, other]: [i32; 2]| first_center(end) as i32 - i32::from(other < end);
    let distance = move |ends: [i32; 2]| {
        let center = center(ends) * PIXEL as i32 + PIXEL as i32 / 2;
        i64::from(center.abs_diff(ends[0]))
    };
    let length = |[a, b]: [i32; 2]| i64::from(b.abs_diff(a));
    let reversed = |[a, b]: [i32; 2]| [b, a];
    [(short, long), (reversed(short), reversed(long))].into_iter().filter_map(move |(short, long)| {
        let row = usize::try_from(center(short)).ok().filter(|row| whole.contains(row))?;
        (distance(short) * length(long) < distance(long) * length(short)).then_some(row..row + 1)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The share is the area beyond the line, for lines of all slopes and distances.
    #[test]
    fn a_share_is_the_area_beyond_a_line() {
        const STEPS: i32 = 1000;
        for slope in [0.0_f32, 0.001, 0.2, 0.7, 1.0, 3.0, 50.0, 1e6] {
            for across in (-10..=10).map(|step| step as f32 * 0.05) {
                let at = |step| across + slope * ((step as f32 + 0.5) / STEPS as f32 - 0.5);
                let area = (0..STEPS).map(|step| at(step).clamp(0.0, 1.0)).sum::<f32>() / STEPS as f32;
                let share = share(across, slope);
                assert!((share - area).abs() < 2e-3, "{across} {slope}: {share} instead of {area}");
            }
        }
    }
}
