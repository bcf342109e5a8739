//! In-scattering between the eye and the surfaces: the visible beams in haze.

use crate::{
    buffer::{LANES, Radiance},
    light::places::Places,
    raster::{Fragments, view::View},
    space::vector,
};
use luminaire::{
    Error, Rgb, Scalar, Vec3,
    attenuation::AnyAttenuation,
    dynamic::AnyLight,
    falloff::AnyFalloff,
    haze::{BeamScattering, Haze, RayBundle, ViewRays},
    projector::{CompiledGobo, Shadow},
};

/// Number of sample points on a view ray through a beam with a gobo or a shadow map.
const PLACES: usize = 16;

/// The beam of a spotlight in haze.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hazy {
    beam: BeamScattering<AnyFalloff, AnyAttenuation>,
    color: Rgb<f32>,
}

/// The gobo and the shadow map of a beam.
#[derive(Debug)]
pub(crate) struct Way<'a, S: Scalar> {
    pub(crate) gobo: Option<&'a CompiledGobo<'static, S>>,
    pub(crate) shadow: Option<Shadow<'a, S>>,
}

impl Hazy {
    /// Compiles the beam of a light; `None` if the light is not a spotlight.
    ///
    /// # Errors
    /// A light that `f32` can't hold.
    pub(crate) fn new(light: &AnyLight, haze: &Haze) -> Result<Option<Self>, Error> {
        let color = light.color();
        Ok(light.compile::<f32>()?.in_haze(haze).map(|beam| Self { beam, color }))
    }

    /// Returns false only if no ray of the bundle meets the beam.
    pub(crate) fn may_be_seen(&self, sight: &RayBundle) -> bool {
        self.beam.can_meet(sight)
    }

    /// Adds the in-scattered light of the beam along each ray to `radiance`.
    pub(crate) fn add<S: Scalar>(&self, rays: &ViewRays<LANES>, way: &Way<'_, S>, radiance: &mut Radiance) {
        let mut air = [0.0; LANES];
        if way.is_clear() {
            self.beam.in_scattering_each(rays, &mut air);
        } else {
            let mut places = Places::default();
            let mut filter = |points: &Vec3<_>, lights: &mut _| way.leave(points, lights, &mut places);
            self.beam.in_scattering_through_each(rays, &mut filter, &mut air);
        }
        let Rgb { red, green, blue } = radiance;
        for (sum, color) in [(red, self.color.red), (green, self.color.green), (blue, self.color.blue)] {
            sum.iter_mut().zip(air).for_each(|(sum, light)| *sum += light * color);
        }
    }
}

impl<S: Scalar> Way<'_, S> {
    /// Returns whether the beam has neither gobo nor shadow map.
    fn is_clear(&self) -> bool {
        self.gobo.is_none() && self.shadow.is_none()
    }

    /// Multiplies the light at each point by the transmittance of the gobo and of the shadow map.
    fn leave(
        &self,
        points: &Vec3<[f32; PLACES]>,
        lights: &mut [f32; PLACES],
        places: &mut Places<S, PLACES>,
    ) {
        let points = points.map(|column| column.map(S::length));
        if let Some(gobo) = self.gobo {
            places.find(gobo.projection(), &points);
            for (i, light) in lights.iter_mut().enumerate() {
                *light *= gobo.gobo().transmission(&places.at(i)).to_f32();
            }
        }
        if let Some(shadow) = &self.shadow {
            places.find(shadow.projection(), &points);
            for (i, light) in lights.iter_mut().enumerate().filter(|(_, light)| **light > 0.0) {
                *light *= shadow.at(&places.at(i)).to_f32();
            }
        }
    }
}

/// Returns the rays through the pixels of a block, from the eye to the surface in each pixel.
pub(crate) fn rays(view: &View, fragments: &Fragments, row: usize, column: usize) -> ViewRays<LANES> {
    let (first, step) = view.ray(row);
    let first = first + step * (column * LANES) as f32;
    let nearness = fragments.block(row, column);
    let mut rays = ViewRays {
        eye: view.eye().into(),
        direction: Vec3::new([0.0; LANES], [0.0; LANES], [0.0; LANES]),
        length: [0.0; LANES],
    };
    for (lane, nearness) in nearness.iter().enumerate() {
        let way = first + step * lane as f32;
        let unit = vector::length(way);
        rays.direction.x[lane] = way.x / unit;
        rays.direction.y[lane] = way.y / unit;
        rays.direction.z[lane] = way.z / unit;
        // The ray to depth 1 has the length `unit`. Where nothing was drawn, the length of the ray
        // is infinite.
        rays.length[lane] = unit / nearness;
    }
    rays
}

/// Returns the bundle of all rays through a rectangle of pixels. The length of the bundle is the
/// distance to the farthest surface in the rectangle.
pub(crate) fn bundle(
    view: &View,
    fragments: &Fragments,
    rows: core::ops::Range<usize>,
    column: usize,
) -> RayBundle {
    let direction = |row: usize, lane: usize| {
        let (first, step) = view.ray(row);
        vector::direction(first + step * (column * LANES + lane) as f32)
    };
    let last = rows.end.saturating_sub(1);
    let corners = [(rows.start, 0), (rows.start, LANES - 1), (last, 0), (last, LANES - 1)];
    let corners = corners.map(|(row, lane)| direction(row, lane));
    let middle = vector::direction(corners.into_iter().sum());
    let farthest = |row: usize| fragments.block(row, column).iter().copied().fold(f32::INFINITY, f32::min);
    let least = rows.map(farthest).fold(f32::INFINITY, f32::min);
    // The longest ray to depth 1 goes through a corner of the rectangle.
    let longest = corners.into_iter().map(|corner| 1.0 / corner.dot(view.ahead())).fold(0.0, f32::max);
    RayBundle::around(view.eye().into(), middle.into(), &corners.map(Into::into), longest / least)
}
