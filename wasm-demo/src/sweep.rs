//! Motion of the lights during a sweep: each light pans about the vertical and tilts a little, with
//! periods of its own.

use luminaire::Vec3;

/// Amplitudes of pan and tilt in radians, and their periods in seconds.
struct Motion {
    pan: (f32, f32),
    nod: (f32, f32),
}

const MOTIONS: [Motion; 3] = [
    Motion { pan: (0.22, 7.0), nod: (0.06, 5.0) },
    Motion { pan: (0.30, 9.0), nod: (0.08, 6.5) },
    Motion { pan: (0.26, 11.0), nod: (0.05, 8.0) },
];

/// Returns the axis of a light at a time in seconds. `rest` is its axis at rest, from which every
/// motion starts.
pub(crate) fn axis(light: usize, rest: Vec3<f32>, seconds: f32) -> Vec3<f32> {
    let motion = &MOTIONS[light % MOTIONS.len()];
    let swing = |(reach, period): (f32, f32)| reach * (std::f32::consts::TAU * seconds / period).sin();
    nod(pan(rest, swing(motion.pan)), swing(motion.nod))
}

/// Rotates about the vertical axis y.
fn pan(v: Vec3<f32>, angle: f32) -> Vec3<f32> {
    let (sin, cos) = angle.sin_cos();
    Vec3::new(v.x * cos + v.z * sin, v.y, v.z * cos - v.x * sin)
}

/// Rotates within the vertical plane that contains the vector.
fn nod(v: Vec3<f32>, angle: f32) -> Vec3<f32> {
    let (sin, cos) = angle.sin_cos();
    let flat = v.x.hypot(v.z);
    if flat == 0.0 {
        return v;
    }
    let scale = (flat * cos + v.y * sin) / flat;
    Vec3::new(v.x * scale, v.y * cos - flat * sin, v.z * scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    const REST: Vec3<f32> = Vec3::new(0.48, -0.6, -0.64);

    #[test]
    fn a_light_starts_from_rest_and_keeps_its_length() {
        for light in 0..4 {
            assert_eq!(axis(light, REST, 0.0), REST);
            for step in 0..200_u8 {
                let moved = axis(light, REST, 0.1 * f32::from(step));
                assert!((moved.dot(moved) - 1.0).abs() < 1e-5);
                assert!(moved.dot(REST) > 0.9, "light {light} strays at step {step}");
            }
        }
    }

    #[test]
    fn straight_down_stays_defined() {
        let down = axis(0, Vec3::new(0.0, -1.0, 0.0), 1.0);
        assert_eq!(down, Vec3::new(0.0, -1.0, 0.0));
    }
}
