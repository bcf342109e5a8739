//! What kinds of light there are.

use super::*;
use luminaire::{AmbientLight, DirectionalLight, dynamic::AnyLight, dynamic::CompiledAnyLight};

pub(super) const FIGURE: Figure = Figure {
    name: "kinds",
    title: "Four kinds of light",
    text: "A spotlight and a point light have a position, a directional light only has a direction, and ambient light has neither. The same ball stands on the same floor, lit by one of them alone. Raise the lamp, and see which pictures change.",
    formula: "I = m_a I_a + Σ f(d) · spot · [m_d I_s max(0, N·L) + m_s I_s max(0, R·V)^m]",
    source: "Lecture CPSC 424, “Kinds of Light Sources”; Peng Engine’s blog, “Why add Spot Lights?”",
    parameters: &[
        Choice(
            "kind",
            "Kind of light",
            &[("spot", "Spot"), ("point", "Point"), ("directional", "Directional"), ("ambient", "Ambient")],
        ),
        Dial(HEIGHT, 4.0),
    ],
    question: "Which kinds ignore the height of the lamp, and what does the floor under a point light lose if it hangs twice as high?",
    answer: || {
        let [low, high] =
            [Lamp::new("point", 4.0)?, Lamp::new("point", 8.0)?].map(|lamp| lamp.light(UNDER, DVec3::Y));
        let parts = [low, high, high / low].map(tidy);
        Ok(format!(
            "Directional and ambient light: without a position, f(d) = 1. The floor gets {} at 4 m and {} at 8 m, {} times as much.",
            parts[0], parts[1], parts[2]
        ))
    },
    draw,
};

/// The centre of the ball, whose radius is 1 m, and the place on the floor under the lamp.
const BALL: DVec3 = DVec3::new(0.0, 1.0, 0.0);
const UNDER: DVec3 = DVec3::new(-1.8, 0.0, 1.6);

struct Lamp {
    /// Nothing but for ambient light.
    light: Option<CompiledAnyLight<f32>>,
    ambient: f64,
    /// The position; of a directional light a place far towards it.
    position: DVec3,
}

impl Lamp {
    fn new(kind: &str, height: f32) -> Result<Self, Refusal> {
        let (place, sun) = (UNDER + DVec3::Y * f64::from(height), BALL - UNDER - 4.0 * DVec3::Y);
        let cone = Cone::soft(Angle::degrees(44.0))?;
        let light: Option<AnyLight> = match kind {
            "spot" => {
                Some(SpotLight::new(single(place), single(BALL - place), cone)?.with_intensity(12.0)?.into())
            }
            "point" => Some(PointLight::new(single(place))?.with_intensity(12.0)?.into()),
            "directional" => Some(DirectionalLight::new(single(sun))?.with_intensity(0.8)?.into()),
            _ => None,
        };
        let ambient = AmbientLight::new(Rgb::new(1.0, 1.0, 1.0))?.with_intensity(if light.is_none() {
            0.3
        } else {
            0.0
        })?;
        Ok(Self {
            light: light.map(|light| light.compile()).transpose()?,
            ambient: ambient.compile::<f32>().red.into(),
            position: if kind == "directional" { -1e6 * sun } else { place },
        })
    }

    /// The light that arrives at a point whose way to the lamp is free.
    fn light(&self, point: DVec3, normal: DVec3) -> f64 {
        let arrived =
            |light: CompiledAnyLight<f32>| light.irradiance(single(point).into(), single(normal).into());
        self.ambient + f64::from(self.light.map_or(0.0, arrived))
    }

    /// The light that a ray from the eye meets, on the ball or on the floor.
    fn seen(&self, eye: DVec3, ray: DVec3) -> f64 {
        let (point, normal) = match meets_ball(eye, ray) {
            Some(way) => (eye + way * ray, eye + way * ray - BALL),
            None if ray.y < 0.0 => (eye - eye.y / ray.y * ray, DVec3::Y),
            None => return 0.0,
        };
        let start = point + 1e-4 * normal;
        let is_dark = meets_ball(start, self.position - start).is_some_and(|way| way < 1.0);
        0.8 * if is_dark { self.ambient } else { self.light(point, normal) }
    }
}

/// How many times the ray fits between the start and the ball.
fn meets_ball(start: DVec3, ray: DVec3) -> Option<f64> {
    let (from, square) = (start - BALL, ray.length_squared());
    let half = from.dot(ray);
    let inside = half * half - square * (from.length_squared() - 1.0);
    let way = (-half - inside.max(0.0).sqrt()) / square;
    (inside > 0.0 && way > 0.0).then_some(way)
}

fn draw(values: &Values) -> Result<Drawing, Refusal> {
    let (kind, [height]) = (values.choice(), values.numbers([HEIGHT]));
    let lamp = Lamp::new(&kind, height)?;
    let eye = DVec3::new(0.0, 3.6, 9.0);
    let forward = (0.7 * DVec3::Y - eye).normalize();
    let above = DVec3::X.cross(forward);
    // The mean of four rays of a pixel.
    let light = |x: f64, y: f64, _| {
        const NEAR: f64 = 0.5 / 640.0;
        let ray = |x, y| lamp.seen(eye, forward + 0.42 * (x * DVec3::X + y * above));
        [x - NEAR, x + NEAR].map(|x| ray(x, y - NEAR) + ray(x, y + NEAR)).iter().sum::<f64>() / 4.0
    };
    let seen = format!("A ball on a floor in {kind} light");
    Ok(Drawing {
        pictures: vec![picture("A ball of radius 1 m on a floor", seen, [640, 400], light)],
        numbers: vec![
            ("Light on top of the ball", lamp.light(BALL + DVec3::Y, DVec3::Y), ""),
            ("Light on the floor under the lamp", lamp.light(UNDER, DVec3::Y), ""),
        ],
        ..Drawing::default()
    })
}
