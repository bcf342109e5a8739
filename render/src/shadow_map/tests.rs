//! Shadow maps against rays in f64.

mod ray;

use super::*;
use crate::{Camera, Format, Material, Mesh, Outline, Renderer, stage};
use alloc::vec::Vec;
use core::f32::consts::PI;
use luminaire::{Angle, CompiledSpot, Cone, Edge, Fx16, Fx32, Rgb, Spot, Vec3};
use ray::Light;

extern crate std;

/// How many texels a shadow may be off.
const TEXELS: f64 = 2.0;

/// What a camera sees in the light of a spot: points that face it, within its cone.
fn points<S: Format>(
    scene: &Scene,
    camera: &Camera,
    spot: &Spot,
    size: (usize, usize),
) -> Vec<Vec3<S::Length>> {
    let mut renderer = Renderer::<S>::new(size.0, size.1).unwrap();
    renderer.draw_geometry(scene, camera);
    let compiled: CompiledSpot<S> = spot.compile().unwrap();
    let pixels = (0..size.1).flat_map(|y| (0..size.0).map(move |x| (x, y)));
    let surfaces = pixels.filter_map(|(x, y)| renderer.surface(x, y));
    let lit =
        surfaces.filter(|(point, normal, _)| compiled.irradiance(*point, *normal) > S::Irradiance::default());
    lit.map(|(point, _, _)| point).collect()
}

fn assert_is_that_of_rays<S: Format>(
    scene: &Scene,
    camera: &Camera,
    spot: &Spot,
    side: usize,
    exact: impl Fn(S::Length) -> f64,
) {
    let projection = Projection::of(spot).unwrap();
    let mut map = ShadowMap::<S>::new(side).unwrap();
    assert!(map.draw(scene, &projection).unwrap());
    let shadow = map.shadow().unwrap();
    let light = Light::new(scene, &projection);
    let (mut lit, mut hidden, mut edge, mut wrong) = (0, 0, 0, 0);
    for point in points::<S>(scene, camera, spot, (192, 108)) {
        let visibility = shadow.visibility(point).to_f32();
        let Vec3 { x, y, z } = point.map(&exact);
        let place = light.place([x, y, z]);
        let sees = light.sees(place);
        if visibility == f32::from(u8::from(sees)) {
            if sees { lit += 1 } else { hidden += 1 }
        } else {
            edge += 1;
            if light.is_inside(place, TEXELS, side) {
                wrong += 1;
                if wrong < 20 {
                    std::println!("{point:?} {place:?}: {visibility}, seen: {sees} {}", light.facing(place));
                }
            }
        }
    }
    std::println!("{} {side}: lit {lit}, hidden {hidden}, edge {edge}, wrong {wrong}", S::NAME);
}

#[test]
fn shadows_on_the_stage_are_those_of_rays() {
    for spot in stage::lights().unwrap() {
        for side in [1024, 512, 128] {
            assert_is_that_of_rays::<f32>(&stage::scene(), &stage::camera(), &spot, side, f64::from);
        }
    }
}
