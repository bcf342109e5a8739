//! temp
use luminaire::Projection;
use luminaire_render::{ShadowMap, stage};
use std::time::Instant;
fn main() {
    let scene = stage::scene();
    let spots = stage::lights().unwrap();
    let n: usize = std::env::args().nth(1).unwrap().parse().unwrap();
    for spot in &spots {
        let mut map = ShadowMap::<f32>::new(512).unwrap();
        let p = Projection::of(spot).unwrap();
        let q = p.turned(luminaire::Angle::degrees(1.0)).unwrap();
        let mut best = f64::MAX;
        for i in 0..n {
            let s = Instant::now();
            map.draw(&scene, if i % 2 == 0 { &p } else { &q }).unwrap();
            best = best.min(s.elapsed().as_secs_f64());
        }
        println!("{:.3} ms", best * 1e3);
    }
}
