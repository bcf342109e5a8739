//! The picture of the stage in every number format against the one in `f32`.

use luminaire::{Angle, Cone, Fx16, Fx32, SpotLight, falloff::SoftOrHard};
use luminaire_render::{
    Camera, Format, Output, Renderer,
    scenes::{Example, stage},
    stated_error,
};

/// From the stalls, from both sides, from above, close to the boards, among the actors.
fn cameras() -> impl Iterator<Item = Camera> {
    let views = [
        (0.0, 0.0, 1.0),
        (0.6, 0.1, 1.2),
        (-0.7, 0.0, 0.8),
        (0.2, 0.8, 1.5),
        (0.0, -1.0, 0.6),
        (0.3, 0.05, 0.2),
    ];
    views.into_iter().map(|(yaw, pitch, zoom)| {
        let mut camera = stage::camera();
        camera.orbit(yaw, pitch);
        camera.zoom(zoom);
        camera
    })
}

/// The lights of the stage as beams of 4 degrees with a hard edge, four times as bright: a narrower
/// beam magnifies the error of a direction more.
fn narrow_beams() -> [SpotLight<SoftOrHard>; 3] {
    let cone = Cone::from_field(SoftOrHard::Hard, Angle::degrees(4.0)).unwrap();
    stage::lights().unwrap().map(|spot| spot.with_cone(cone).with_intensity(4.0 * spot.intensity()).unwrap())
}

/// Largest and mean difference of a channel, in codes.
fn difference<S: Format>(lights: &[SpotLight<SoftOrHard>]) -> (u8, f64) {
    let mut renderer = Renderer::<S>::new(960, 540).unwrap();
    let mut reference = Renderer::<f32>::new(960, 540).unwrap();
    let scene = stage::scene().unwrap();
    let (mut largest, mut sum, mut count) = (0, 0_u64, 0_u64);
    for camera in cameras() {
        renderer.draw_geometry(&scene, &camera);
        reference.draw_geometry(&scene, &camera);
        renderer.draw_light(lights).unwrap();
        reference.draw_light(lights).unwrap();
        for (found, expected) in renderer.encode().iter().zip(reference.encode()) {
            let difference = found.abs_diff(*expected);
            largest = largest.max(difference);
            sum += u64::from(difference);
            count += 1;
        }
    }
    (largest, sum as f64 / count as f64)
}

/// Under the stage's own lights the largest difference is one code, and the mean in this range.
fn holds<S: Format>(mean: core::ops::Range<f64>) {
    let (largest, found) = difference::<S>(&stage::lights().unwrap());
    assert_eq!(largest, 1, "{}: the largest difference under the lights of the stage", S::NAME);
    assert!(mean.contains(&found), "{}: the mean difference is {found:.6}", S::NAME);
    let (narrow, _) = difference::<S>(&narrow_beams());
    assert_eq!(narrow.max(largest), stated_error::<S>(), "{}: the largest difference", S::NAME);
}

#[test]
fn thirty_two_bits_differ_from_floats_as_stated() {
    holds::<Fx32>(1.2e-4..1.6e-4);
}

#[test]
fn sixteen_bits_differ_from_floats_as_stated() {
    holds::<Fx16>(9.4e-3..1.1e-2);
}

#[test]
fn floats_do_not_differ_from_themselves() {
    assert_eq!(difference::<f32>(&narrow_beams()), (0, 0.0));
    assert_eq!(stated_error::<f32>(), 0);
}

/// Returns an example as it opens, with a code for each of 256 steps.
fn picture<S: Format>(example: Example) -> Vec<u8> {
    let (setup, [width, height]) = (example.setup().unwrap(), [480, 270]);
    let fixtures = setup.fixtures_at(0.0).unwrap();
    let mut renderer = Renderer::<S>::new(width, height).unwrap();
    renderer.set_display(Output::Rgb888.nearest());
    renderer.draw_geometry(&setup.scene, &setup.camera);
    renderer.draw_shadows(&setup.scene, &fixtures).unwrap();
    renderer.draw_light(&fixtures).unwrap();
    renderer.encode().to_vec()
}

/// Pixels differ by more than one code beside the edges of shadows, whose depths are rounded.
#[test]
fn examples_differ_from_floats_by_one_code() {
    let (mut largest, mut ones) = (0, 0);
    for &example in Example::ALL {
        let floats = picture::<f32>(example);
        for (format, found) in [("fx16", picture::<Fx16>(example)), ("fx32", picture::<Fx32>(example))] {
            let pixels = found.as_chunks::<4>().0.iter().zip(floats.as_chunks::<4>().0);
            let difference =
                |(a, b): (&[u8; 4], &[u8; 4])| a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max();
            let differences: Vec<_> = pixels.filter_map(difference).collect();
            let more = differences.iter().filter(|&&difference| difference > 1).count();
            assert!(
                more * 1_000 <= differences.len(),
                "{} in {format}: {more} of {} pixels differ by more than a code",
                example.name(),
                differences.len()
            );
            largest = differences.iter().copied().fold(largest, u8::max);
            ones += differences.iter().filter(|&&difference| difference == 1).count();
        }
    }
    assert!(largest > 1 && ones > 10_000, "{ones} pixels differ by a code, the most by {largest}");
}
