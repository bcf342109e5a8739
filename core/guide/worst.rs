use luminaire::{Scalar, Vec3};

/// The largest difference between a light and a formula, in linear codes.
///
/// The light is at the origin and points down. The formula takes the cosine of the angle
/// off axis and the distance. The points are at 9,000 angles to 90 degrees and at 8
/// distances to 8; their surfaces face the light. Points have steps of 2^-16 and normals of
/// 2^-14, which every format can hold.
pub fn worst<S: Scalar>(
    light: impl Fn(Vec3<S::Length>, Vec3<S>) -> S::Irradiance,
    formula: impl Fn(f64, f64) -> f64,
) -> f64 {
    let rounded = |value: f64, steps: f64| (value * steps).round() / steps;
    let mut worst = 0.0_f64;
    for distance in 1..=8 {
        for angle in 0..9_000 {
            let angle = ((f64::from(angle) + 0.5) / 100.0).to_radians();
            let way = [angle.sin(), -angle.cos(), 0.0].map(|c| f64::from(distance) * c);
            let [x, y, z] = way.map(|c| rounded(c, 65_536.0));
            let distance = x.hypot(y);
            let [normal_x, normal_y, _] = [x, y, z].map(|c| rounded(-c / distance, 16_384.0));
            let lambert = -(x * normal_x + y * normal_y) / distance;
            let exact = lambert.min(1.0) * formula(-y / distance, distance);
            let normal = S::normal([normal_x as f32, normal_y as f32, 0.0]);
            let found = S::light_to_f32(light(S::point([x as f32, y as f32, 0.0]), normal));
            worst = worst.max((f64::from(found).min(1.0) - exact.min(1.0)).abs() * 255.0);
        }
    }
    worst
}
