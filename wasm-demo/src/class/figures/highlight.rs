//! Highlights.

use super::*;
use luminaire::{
    DirectionalLight, Material,
    light::SurfacePoint,
    specular::{DualConeLobe, Phong, SpecularLobe},
};

pub(super) const FIGURE: Figure = Figure {
    name: "highlight",
    title: "Highlights: per vertex or per pixel",
    text: "A ball of a few patches: Gouraud lights their corners and blends the light, Phong lights every pixel by its own normal. The shader’s highlight takes the half vector H where Phong takes the direction V to the eye. The more shininess, the smaller the highlight.",
    formula: "m_d max(0, N·L) + m_s max(0, R·V)^m,   shader: m_s max(0, R·H)^m",
    source: "Lecture CPSC 424, “Attenuation”; the article on the dual-cone spotlight, “Appendix”",
    parameters: &[
        Choice(
            "way",
            "Way",
            &[
                ("phong", "Phong, per pixel"),
                ("gouraud", "Gouraud, per vertex"),
                ("shader", "R·H, per pixel"),
            ],
        ),
        Dial(SHININESS, 16.0),
    ],
    question: "Why does Gouraud’s highlight fade while the shininess grows?",
    answer: || {
        let ball = ball(Phong, 16.0)?;
        let [corners, pixels] = [true, false].map(|is_per_vertex| tidy(brightest(&ball, is_per_vertex)));
        Ok(format!(
            "It is only computed at corners, and a small highlight lies between them: at a shininess of 16 the brightest light is {corners} per vertex, {pixels} per pixel."
        ))
    },
    draw: |values| {
        let ([shininess], way) = (values.numbers([SHININESS]), values.choice());
        let ball = if way == "shader" { ball(DualConeLobe, shininess)? } else { ball(Phong, shininess)? };
        let is_per_vertex = way == "gouraud";
        let unit = if is_per_vertex { "vertex" } else { "pixel" };
        let words = format!("A ball with a highlight, lit per {unit}");
        let light = |x: f64, y: f64, _| seen(&ball, is_per_vertex, [x, y]);
        Ok(Drawing {
            pictures: vec![picture("The ball", words, [360; 2], light)],
            numbers: vec![
                ("Brightest, per pixel", brightest(&ball, false), ""),
                ("Brightest, per vertex", brightest(&ball, true), ""),
            ],
            ..Drawing::default()
        })
    },
};

/// Half the meridians, and the parallels of the ball.
const SEGMENTS: f64 = 9.0;

/// The light that an eye in the direction +z sees of a ball, over the normal.
fn ball<H: SpecularLobe + 'static>(lobe: H, shininess: f32) -> Result<Box<dyn Fn(DVec3) -> f64>, Refusal> {
    let grey = |share| Rgb::new(share, share, share);
    let material =
        Material::new(grey(0.35))?.with_highlight(lobe, grey(0.6), shininess as u32)?.compile::<f32>();
    let light = DirectionalLight::new([-0.62, -0.55, -1.0])?.compile::<f32>();
    Ok(Box::new(move |normal| {
        let normal = single(normal).into();
        let surface = SurfacePoint { point: normal, normal, view: [0.0, 0.0, 1.0].into() };
        material.color(&surface, &[light], grey(0.08)).red.into()
    }))
}

/// The light at a place of the picture, which is a bit wider than the ball.
fn seen(ball: impl Fn(DVec3) -> f64, is_per_vertex: bool, [x, y]: [f64; 2]) -> f64 {
    let [x, y] = [1.05 * x, 1.05 * y];
    let depth = 1.0 - x * x - y * y;
    if depth < 0.0 {
        return 0.0;
    }
    let normal = DVec3::new(x, y, depth.sqrt());
    if !is_per_vertex {
        return ball(normal);
    }
    let places = [normal.x.atan2(normal.z), y.acos()].map(|angle| angle * SEGMENTS / std::f64::consts::PI);
    let corner = |right: f64, down: f64| {
        let [(across, along), (ring, up)] = [places[0].floor() + right, places[1].floor() + down]
            .map(|i| (i * std::f64::consts::PI / SEGMENTS).sin_cos());
        ball(DVec3::new(ring * across, up, ring * along))
    };
    let [u, v] = places.map(|place| place - place.floor());
    let [above, below] = [0.0, 1.0].map(|down| (1.0 - u) * corner(0.0, down) + u * corner(1.0, down));
    (1.0 - v) * above + v * below
}

fn brightest(ball: &impl Fn(DVec3) -> f64, is_per_vertex: bool) -> f64 {
    let places = (0..90_000).map(|i| [i % 300, i / 300].map(|c| f64::from(c) / 150.0 - 1.0));
    places.map(|place| seen(ball, is_per_vertex, place)).fold(0.0, f64::max)
}
