//! Tests whether an object stands between a point and the light.

use core::ops::Range;

use luminaire::{
    Vec3,
    number::{Length, Light16},
};

use super::backdrop::{Backdrop, Seen};
#[cfg(test)]
use super::site::Material;
use super::site::Site;
use super::way::{Way, Wedge};
use super::{ball, column};

/// Finds the shadows on the backdrop, of which those in the row before are known, and marks the pixels of objects
/// that no shadow hides by any light.
#[inline(never)]
pub(super) fn cast(seen: &mut Seen, sites: &[Site], lights: &mut [Light16]) {
    let Seen { backdrop, objects: [on_column, on_ball], shadows: [by_column, by_ball], .. } = seen;
    let wedge = |wedge: Wedge| wedge.at([backdrop.y, backdrop.z]);
    let width = lights.len();
    *by_ball = shadowed(by_ball, width, &wedge(ball::WEDGE), backdrop, ball::is_between);
    *by_column = shadowed(by_column, width, &wedge(column::WEDGE), backdrop, |way| {
        column::is_over(&way.point()) || column::is_between(way)
    });
    shade(on_column, sites, lights, ball::WEDGE, ball::is_between);
    shade(on_ball, sites, lights, column::WEDGE, column::is_between);
}

/// The columns of a row in the shadow of an object, of which those in the row before are known.
///
/// The object is convex, and so is its shadow on a plane: it is one stretch of a row. Its ends in the next row are
/// near. `wedge` are the x coordinates between which points can be in the shadow.
#[inline(never)]
fn shadowed(
    before: &Range<usize>,
    width: usize,
    wedge: &Range<Length>,
    backdrop: &Backdrop,
    is_dark: impl Fn(&Way) -> bool,
) -> Range<usize> {
    let is_dark = |column: usize| is_dark(&Way::to_light(backdrop.point(column)));
    let within = |column: usize| wedge.contains(&backdrop.x(column));
    if wedge.is_empty() {
        return 0..0;
    }
    // A column in the shadow: the middle of that before, or the first of all.
    let middle = before.start.midpoint(before.end);
    let is_known = !before.is_empty() && is_dark(middle);
    let known =
        if is_known { Some(middle) } else { (0..width).find(|&column| within(column) && is_dark(column)) };
    let Some(known) = known else { return 0..0 };
    // The ends move from where they were.
    let (mut start, mut end) = if is_known { (before.start, before.end) } else { (known, known + 1) };
    if is_dark(start) {
        while start > 0 && is_dark(start - 1) {
            start -= 1;
        }
    } else {
        while !is_dark(start) {
            start += 1;
        }
    }
    if is_dark(end - 1) {
        while end < width && is_dark(end) {
            end += 1;
        }
    } else {
        while !is_dark(end - 1) {
            end -= 1;
        }
    }
    start..end
}

/// Marks the pixels of an object that the other one does not shadow. An object is not tested for sites on its own
/// surface: where it would shadow itself, its surface faces away from the light.
#[inline(always)]
fn shade(
    object: &Range<usize>,
    sites: &[Site],
    lights: &mut [Light16],
    wedge: Wedge,
    is_between: impl Fn(&Way) -> bool,
) {
    let sites = sites.get(object.clone()).unwrap_or_default();
    for (site, light) in sites.iter().zip(lights.get_mut(object.clone()).unwrap_or_default()) {
        let Vec3 { x, y, z } = site.point;
        let is_dark = wedge.at([y, z]).contains(&x) && is_between(&Way::to_light(site.point));
        *light = if is_dark { Light16::ZERO } else { Light16::MAX };
    }
}

/// Whether another object stands between a site and the light.
#[cfg(test)]
pub(super) fn is_in_shadow(site: &Site, material: Material) -> bool {
    let way = Way::to_light(site.point);
    (material != Material::Ball && ball::is_between(&way))
        || (material != Material::Column && column::is_between(&way))
}
