//! Slots turn, zoom, dim and colour a light as the standard of fixtures has it.

use fastrand::Rng;
use luminaire::dmx::{Channel, Patch};
use luminaire::{Angle, Cone, Fx16, Fx32, Rgb, SpotLight, Vec3};
use support::{format::Format, in_every_format};

type Matrix = [[f64; 3]; 3];

fn times(a: Matrix, b: [f64; 3]) -> [f64; 3] {
    a.map(|row| row.iter().zip(b).map(|(a, b)| a * b).sum())
}

/// The beam of a hanging fixture in the axes of GDTF, x right, y away from the viewer and z up: along -z, turned about x by the
/// tilt and about z by the pan, both as the right hand has it.
fn beam(pan: f64, tilt: f64) -> [f64; 3] {
    let ([sp, cp], [st, ct]) = (sines(pan), sines(tilt));
    let about_x = [[1.0, 0.0, 0.0], [0.0, ct, -st], [0.0, st, ct]];
    let about_z = [[cp, -sp, 0.0], [sp, cp, 0.0], [0.0, 0.0, 1.0]];
    times(about_z, times(about_x, [0.0, 0.0, -1.0]))
}

fn sines(degrees: f64) -> [f64; 2] {
    [degrees.to_radians().sin(), degrees.to_radians().cos()]
}

fn aims_as_stated<S: Format>(error: f64) {
    let mut rng = Rng::with_seed(44);
    let cone = Cone::soft(Angle::degrees(20.0)).expect("an angle");
    let ends =
        [SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone).expect("a light").compile::<S>().expect("a cone");
            2];
    for _ in 0..20_000 {
        let degrees = [(); 4].map(|()| [540.0, 18_000.0][usize::from(rng.bool())] * (2.0 * rng.f32() - 1.0));
        let [pan, tilt] = [[degrees[0], degrees[1]], [degrees[2], degrees[3]]];
        let channel = |[from, to]: [f32; 2]| Channel::degrees(from, to).expect("angles");
        let slots = [(); 4].map(|()| [0, 255, rng.u8(..)][rng.usize(..3)]);
        let patch = Patch::new().with_pan(channel(pan).at_fine(1, 2).expect("slots")).with_tilt(
            if rng.bool() { channel(tilt).at(3) } else { channel(tilt).at_fine(3, 4) }.expect("slots"),
        );
        let [_, tilt_channel, ..] = patch.channels();
        let fine = if tilt_channel.slots()[1] == 0 { slots[2] } else { slots[3] };
        let between = |[from, to]: [f32; 2], coarse, fine| {
            let part = f64::from(u16::from_be_bytes([coarse, fine])) / 65_535.0;
            f64::from(from) + (f64::from(to) - f64::from(from)) * part
        };
        let [x, y, z] = beam(between(pan, slots[0], slots[1]), between(tilt, slots[2], fine));
        let stands = rng.bool();
        // y up; a fixture that stands is turned by half a turn about x.
        let expected = if stands { [x, -z, y] } else { [x, z, -y] };
        let patch = if stands {
            let axes = [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]].map(Vec3::from);
            patch.with_mount(axes).expect("directions")
        } else {
            patch
        };
        let axis = patch.state(&slots).light(&ends).axis().map(S::exact_unit);
        let apart =
            <[f64; 3]>::from(axis).iter().zip(expected).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        assert!(apart <= error, "{}: {apart:e} apart at {slots:?} of {patch:?}", S::NAME);
    }
}

#[test]
fn pan_and_tilt_turn_as_in_gdtf() {
    aims_as_stated::<f32>(8.8e-7);
    aims_as_stated::<Fx32>(7.6e-7);
    aims_as_stated::<Fx16>(7.6e-7);
}

/// The ends of each share are exact, also of a byte, and the colours are what the filters and the white leave.
fn shares_are_exact_at_their_ends<S: Format>() {
    let cone = |degrees| Cone::soft(Angle::degrees(degrees)).expect("an angle");
    let color = Rgb::new(1.0, 0.5, 0.25);
    let spot = SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone(20.0))
        .and_then(|spot| spot.with_color(color))
        .expect("a light");
    let ends = spot.compile_zoom::<S>(&cone(40.0)).expect("two cones");
    // Aimed again, because an aim rounds the axis otherwise than a set-up.
    let down = Patch::new().state(&[]).light(&ends).axis();
    let ends = ends.map(|light| light.placed(light.position(), down));
    let share = |slot, [from, to]: [f32; 2]| {
        Channel::share(from, to).and_then(|channel| channel.at(slot)).expect("a share")
    };
    let patch = Patch::new()
        .with_zoom(share(1, [1.0, 0.0]))
        .with_dimmer(share(2, [0.0, 1.0]))
        .with_color(Rgb::new(share(3, [1.0, 0.0]), share(4, [1.0, 0.0]), share(5, [0.0, 1.0])))
        .with_white(share(6, [0.0, 1.0]));
    // The universe ends before the white, which counts as 0.
    let light = patch.state(&[0, 255, 255, 0, 255]).light(&ends);
    assert_eq!(light, ends[1].with_color(Rgb::new(0.0, 0.5, 0.25).map(S::from_f32)));
    let light = patch.state(&[255, 255, 255, 255, 0, 255]).light(&ends);
    assert_eq!(light, ends[0]);
    let dark = patch.state(&[255, 0, 0, 0, 0, 0]).light(&ends);
    assert_eq!(dark, ends[0].dimmed(S::ZERO).with_color(Rgb::new(1.0, 0.5, 0.0).map(S::from_f32)));
    let moved = patch.at_address(20).expect("slots up to 25");
    assert_eq!(
        moved.state(&[[0; 19].as_slice(), &[255, 255, 255, 255, 0, 255]].concat()).light(&ends),
        ends[0]
    );
    assert_eq!(Patch::new().at_address(512).expect("no slots").state(&[]).light(&ends), ends[0]);
}

#[test]
fn shares_filter_dim_and_zoom() {
    in_every_format!(shares_are_exact_at_their_ends);
}

#[test]
fn refusals_of_channels_name_what_is_expected() {
    let refused = |made: Result<Channel, luminaire::Error>| made.unwrap_err().to_string();
    assert_eq!(
        refused(Channel::degrees(0.0, 18_001.0)),
        "value of the channel = 18001: expected a finite number from -18000 to 18000"
    );
    assert_eq!(
        refused(Channel::share(f32::NAN, 1.0)),
        "value of the channel = NaN: expected a finite number from 0 to 1"
    );
    let channel = Channel::share(0.0, 1.0).expect("a share");
    for slot in [0, 513] {
        assert_eq!(
            refused(channel.at(slot)),
            format!("slot = {slot}: expected a whole number from 1 to 512")
        );
    }
    let patch = Patch::new().with_dimmer(channel.at(12).expect("a slot"));
    assert!(patch.at_address(501).is_ok());
    assert_eq!(
        patch.at_address(502).unwrap_err().to_string(),
        "slot = 513: expected a whole number from 1 to 512"
    );
}
