//! Rows of pixels and vertices of meshes.

use core::slice;

use luminaire::{
    Fx16, Length, Rgb, Vec3,
    display::{Rgb565, clip},
    light::Row,
};

use crate::{luminaire_bool, luminaire_light, luminaire_normal, luminaire_point, luminaire_spot, or_dark};

/// A vertex: a point and a normal of unit length.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct luminaire_vertex {
    /// The point.
    pub point: luminaire_point,
    /// The normal.
    pub normal: luminaire_normal,
}

/// A row of pixels on a flat surface: the first point, the step from pixel to pixel and the normal.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct luminaire_row {
    /// The point of the first pixel.
    pub first: luminaire_point,
    /// What the point changes by from pixel to pixel.
    pub step: luminaire_point,
    /// The normal of the surface.
    pub normal: luminaire_normal,
}

/// The elements at a pointer; none at a null pointer.
///
/// # Safety
/// A pointer that is not null points to `count` elements that nothing else changes.
unsafe fn elements<'a, T>(first: *const T, count: usize) -> &'a [T] {
    // SAFETY: as the caller promises.
    if first.is_null() { &[] } else { unsafe { slice::from_raw_parts(first, count) } }
}

/// The elements at a pointer; none at a null pointer.
///
/// # Safety
/// A pointer that is not null points to `count` elements that nothing else reads or changes.
unsafe fn elements_mut<'a, T>(first: *mut T, count: usize) -> &'a mut [T] {
    // SAFETY: as the caller promises.
    if first.is_null() { &mut [] } else { unsafe { slice::from_raw_parts_mut(first, count) } }
}

/// Writes the light of all spotlights at each vertex.
///
/// # Safety
/// `spots` points to `spot_count` lights, and `vertices` and `lights` to `count` elements each.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn luminaire_vertices(
    spots: *const luminaire_spot,
    spot_count: usize,
    vertices: *const luminaire_vertex,
    lights: *mut luminaire_light,
    count: usize,
) {
    // SAFETY: as the caller promises.
    let (spots, vertices) = unsafe { (elements(spots, spot_count), elements(vertices, count)) };
    // SAFETY: as the caller promises.
    let lights = unsafe { elements_mut(lights, count) };
    lights.fill(luminaire_light::default());
    for spot in spots {
        let spot = spot.light();
        for (sum, vertex) in lights.iter_mut().zip(vertices) {
            let light = spot.irradiance(vertex.point.place(), vertex.normal.vector());
            *sum = luminaire_light::of(sum.sum().plus::<Fx16>(Rgb::lit(light, spot.color())));
        }
    }
}

/// Adds the light of a spotlight to each pixel of a row that it reaches.
///
/// # Safety
/// `lights` points to `count` elements.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn luminaire_row_add(
    row: Option<&luminaire_row>,
    spot: Option<&luminaire_spot>,
    lights: *mut luminaire_light,
    count: usize,
) {
    let Some(row) = row else { return };
    // SAFETY: as the caller promises.
    let lights = unsafe { elements_mut(lights, count) };
    let (first, step) = (row.first, row.step);
    let at =
        |i: usize, first: i32, step: i32| Length::from_bits(first.wrapping_add(step.wrapping_mul(i as i32)));
    let points = Row::new(row.normal.vector(), |i| {
        Vec3::new(at(i, first.x, step.x), at(i, first.y, step.y), at(i, first.z, step.z))
    });
    points.light(&[or_dark(spot).light()], lights, |sum, _, light| {
        *sum = luminaire_light::of(sum.sum().plus::<Fx16>(light));
    });
}

/// Writes the pixels of RGB565 of a row that has light; the other pixels keep their values. `row` is
/// the number of the row in the picture, for the dither; `is_big_endian` swaps the bytes.
///
/// # Safety
/// `lights` and `pixels` point to `count` elements each.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn luminaire_row_rgb565(
    lights: *const luminaire_light,
    pixels: *mut u16,
    count: usize,
    row: u32,
    is_big_endian: luminaire_bool,
) {
    // SAFETY: as the caller promises.
    let (lights, pixels) = unsafe { (elements(lights, count), elements_mut(pixels, count)) };
    for ((column, light), pixel) in (0..).zip(lights).zip(pixels) {
        if *light != luminaire_light::default() {
            let code = Rgb565::from_linear_dithered(clip::<Fx16>(light.sum()), column, row).0;
            *pixel = if is_big_endian.0 != 0 { code.swap_bytes() } else { code };
        }
    }
}
