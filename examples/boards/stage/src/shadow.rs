//! Tests whether an object stands between a point and the light.

use luminaire::Vec3;
use luminaire::number::Light16;

use super::site::{Material, Site};
use super::way::Way;
use super::{ball, column};

/// Sets the light of sites in shadow to zero.
#[inline(never)]
pub(super) fn cast<const WIDTH: usize>(sites: &[Site; WIDTH], lights: &mut [Light16; WIDTH]) {
    // The row starts with a point of the wall or the floor. All points of the row on the wall and the
    // floor have its height and its depth.
    let Vec3 { y, z, .. } = sites[0].point;
    let wedges = [ball::WEDGE, column::WEDGE].map(|wedge| wedge.at([y, z]));
    for (light, site) in lights.iter_mut().zip(sites) {
        if *light == Light16::ZERO
            || site.material.is_backdrop() && !wedges.iter().any(|wedge| wedge.contains(&site.point.x))
        {
            continue;
        }
        if is_in_shadow(site) {
            *light = Light16::ZERO;
        }
    }
}

/// Whether an object stands between a site and the light. An object is not tested for sites on its
/// own surface: where it would shadow itself, its surface faces away from the light.
#[inline(always)]
pub(super) fn is_in_shadow(site: &Site) -> bool {
    let way = Way::to_light(site.point);
    (site.material != Material::Ball && ball::is_between(&way))
        || (site.material != Material::Column && column::is_between(&way))
}
