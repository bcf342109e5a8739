mod support;
use fastrand::Rng;
use luminaire::*;
use support::{format::Format, reference, sweep};
#[test]
fn gain() {
    let shapes: [(&str, Matched, reference::Profile); 3] = [("soft", Soft.into(), reference::soft), ("hard", Hard.into(), reference::hard), ("linear", Linear.into(), reference::linear)];
    for (name, p, exact) in shapes {
        for half in [1.0f32, 1.3, 1.6, 2.0, 3.0, 3.5, 5.0, 7.5, 15.0, 30.0] {
            if half < Cone::<Matched>::narrowest::<Fx16>(p).to_degrees()/2.0 { continue; }
            let cone = Cone::from_outer(p, sweep::half(half)).unwrap();
            let c = reference::Cone::new(exact, reference::versine(half.into()));
            let mut rng = Rng::with_seed(1);
            let mut row = vec![];
            for intensity in [1.0f32, 2.0, 3.0, 4.0, 16.0, 64.0, 256.0, 1024.0, 4f32.powi(14)] {
                let base = (intensity as f64 / 4.0).sqrt().max(1.0);
                let mut worst = 0.0f64;
                for _ in 0..200_000 {
                    let light = sweep::on_grid([0; 3].map(|_| rng.f64() * 8.0));
                    let mut dir = if rng.bool() { sweep::direction(&mut rng) } else { reference::unit([1.0, 0.3*(rng.f64()-0.5), 0.3*(rng.f64()-0.5)]) };
                    dir.rotate_left(rng.usize(..3));
                    let m = dir.iter().fold(0.0f64, |m, c| m.max(c.abs()));
                    let d = base / m * (1.0 + 0.2 * rng.f64());
                    let point = sweep::on_grid([0,1,2].map(|i| light[i] + d * dir[i]));
                    let way = reference::minus(point, light);
                    let off = f64::from(half).to_radians() * (1.0 - rng.f64().powi(3));
                    let axis = sweep::direction_off(&mut rng, reference::unit(way), off);
                    let spot = Spot::new(sweep::single(light), sweep::single(axis), cone).unwrap().with_intensity(intensity).unwrap();
                    let axis = reference::unit(Fx16::exact_direction(spot.axis_in::<Fx16>()));
                    let normal = sweep::single(reference::unit(way).map(|c| -c)).map(Fx16::from_f32);
                    let cosine = -reference::dot(reference::unit(way), Fx16::exact_normal(normal));
                    let e = f64::from(intensity) / reference::dot(way, way) * c.falloff(reference::versine_between(way, axis)) * cosine;
                    let p = sweep::single(point).map(Fx16::length);
                    let f = Fx16::exact_light(spot.compile::<Fx16>().unwrap().irradiance(p, normal));
                    worst = worst.max(255.0 * (f.min(1.0) - e.min(1.0)).abs());
                }
                row.push(format!("{intensity}: {worst:.3}"));
            }
            println!("{name} {half}: {}", row.join(", "));
        }
    }
}
