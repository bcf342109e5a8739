//! A floor of 16 x 16 metres under 64 narrow spotlights.

use super::{
    MovingLight, Setup,
    fixture::Chase,
    room::{aimed, floor},
};
use crate::{Camera, Material, Scene};
use alloc::vec::Vec;
use luminaire::{Cone, Error, HalfAngle, Rgb, Vec3, falloff::Soft};

/// The side of the floor in metres.
const SIDE: f32 = 16.0;
/// The height of the spotlights above the floor, in metres.
const HEIGHT: f32 = 4.0;

/// The number of spotlights along each side of the floor.
const ROWS: usize = 8;

pub(super) fn setup() -> Result<Setup, Error> {
    let mut scene = Scene::new();
    // The floor is larger than the lit area, so that the floor's edges stay out of the picture.
    scene.add(floor(SIDE + 6.0, SIDE + 6.0), Material::srgb(212, 208, 202))?;
    // The camera is far away, so that the floor is almost a parallelogram in the picture: the
    // floor's depth of 16 m appears as long as 9 m of its width.
    let camera = Camera::new(Vec3::new(0.0, 0.0, 0.2), 90.0, 0.0, 0.61, 0.108);
    let cone = Cone::from_outer(Soft, HalfAngle::degrees(10.0))?;
    let turns = ROWS * ROWS;
    let mut fixtures = Vec::with_capacity(turns);
    for turn in 0..turns {
        let [x, z] =
            [turn % ROWS, turn / ROWS].map(|number| SIDE * ((number as f32 + 0.5) / ROWS as f32 - 0.5));
        let spot = aimed(Vec3::new(x, HEIGHT, z), Vec3::new(x, 0.0, z), cone)?
            .with_color(gel(x / SIDE + 0.5, z / SIDE + 0.5))?
            .with_intensity(0.86 * HEIGHT * HEIGHT)?;
        let chase = Chase { turn, turns, step: 0.25, bump: 1.5 };
        fixtures.push(MovingLight::new("downlight", spot).chased(chase));
    }
    Ok(Setup::new(scene, camera, fixtures))
}

/// Returns the colour of the light at a position on the floor.
///
/// The colour is amber on the left, rose in the middle and blue on the right. The colour is paler
/// towards the front.
fn gel(across: f32, along: f32) -> Rgb<f32> {
    let (amber, rose, blue) = (Rgb::new(1.0, 0.4, 0.06), Rgb::new(1.0, 0.14, 0.4), Rgb::new(0.08, 0.28, 1.0));
    let between = |a: Rgb<f32>, b, part| a.zip(b, |a: f32, b: f32| a + part * (b - a));
    let pure = between(between(amber, rose, across), between(rose, blue, across), across);
    between(pure, Rgb::new(1.0, 1.0, 1.0), 0.4 * along)
}
