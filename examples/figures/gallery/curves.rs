//! The diagram of intensity over angle for the three models, as in the paper's figure 7.

use super::{
    scene::FIELD,
    svg::{Drawing, Frame},
    warn::Warn,
};
use luminaire::{
    Angle, Cone, Error, HalfAngle,
    falloff::{Falloff, Hard, Soft},
};

const SIZE: (f64, f64) = (760.0, 500.0);
/// The largest angle off axis that is shown on either side, in degrees.
const WIDEST: f64 = 11.0;
const GREY: &str = "#5f6368";
const LINE: &str = r##"stroke="#dadce0""##;
const DASHES: &str = r##"stroke="#5f6368" stroke-dasharray="4 3""##;

/// One of the models.
struct Model {
    color: &'static str,
    name: String,
    /// The intensity at an angle off axis in degrees.
    intensity: Box<dyn Fn(f64) -> f64>,
    /// Full angles in degrees; a model may have no end.
    beam: f64,
    outer: Option<f64>,
}

impl Model {
    fn warn() -> Self {
        let warn = Warn::from_field(Angle::degrees(FIELD));
        Self {
            color: "#5f6368",
            name: format!("Warn, cosine to the power {:.0}", warn.exponent),
            intensity: Box::new(move |degrees| warn.falloff(libm::cos(degrees.to_radians()))),
            beam: warn.angle_at(0.5),
            outer: None,
        }
    }

    /// One of the kernel's falloffs, evaluated by the kernel.
    fn kernel<P: Falloff + 'static>(color: &'static str, name: &str, falloff: P) -> Result<Self, Error> {
        let cone = Cone::from_field(falloff, Angle::degrees(FIELD))?;
        let falloff = cone.compile::<f32>()?;
        let versine = |degrees: f64| Angle::from(HalfAngle::degrees(degrees as f32)).versine();
        Ok(Self {
            color,
            name: name.into(),
            intensity: Box::new(move |degrees| f64::from(falloff.at(falloff.versine(versine(degrees))))),
            beam: cone.beam().to_degrees().into(),
            outer: Some(cone.outer().to_degrees().into()),
        })
    }

    /// Points of the curve, dense enough for its steepest part.
    fn curve(&self, frame: &Frame) -> Vec<(f64, f64)> {
        let angles = (-440..=440).map(|step| f64::from(step) * WIDEST / 440.0);
        angles.map(|degrees| frame.place(degrees, (self.intensity)(degrees))).collect()
    }
}

/// The diagram.
pub(crate) fn svg() -> Result<String, Error> {
    let models = [
        Model::warn(),
        Model::kernel("#20639b", "soft, t²", Soft)?,
        Model::kernel("#b3261e", "hard, 1 − u²", Hard)?,
    ];
    let frame = Frame { x: [(64.0, -WIDEST), (736.0, WIDEST)], y: [(340.0, 0.0), (40.0, 1.0)] };
    let mut drawing = Drawing::new(SIZE.0, SIZE.1, "Intensity over the angle off axis of three models");
    axes(&mut drawing, &frame);
    for model in &models {
        let style = format!(r#"fill="none" stroke="{}" stroke-width="2.5""#, model.color);
        drawing.path(model.curve(&frame), &style);
        for side in [-0.5, 0.5] {
            drawing.dot(frame.place(side * model.beam, 0.5), model.color);
        }
    }
    for side in [-0.5, 0.5] {
        drawing.dot(frame.place(side * f64::from(FIELD), 0.1), "#202124");
    }
    key(&mut drawing, &models);
    Ok(drawing.finish())
}

/// The grid with its units, and the levels of 50 % and 10 % that define beam and field angle.
fn axes(drawing: &mut Drawing, frame: &Frame) {
    for percent in [0, 20, 40, 60, 80, 100] {
        let (from, to) = frame.level(f64::from(percent) / 100.0);
        drawing.line(from, to, LINE);
        drawing.text((from.0 - 8.0, from.1 + 4.0), "end", GREY, &format!("{percent} %"));
    }
    for degrees in (-10..=10).step_by(2) {
        let (x, y) = frame.place(degrees.into(), 0.0);
        drawing.line((x, y), (x, y + 5.0), LINE);
        drawing.text((x, y + 20.0), "middle", GREY, &format!("{degrees}°").replace('-', "−"));
    }
    for (intensity, words) in [(0.5, "beam angle: half is left"), (0.1, "field angle: a tenth is left")] {
        let (from, to) = frame.level(intensity);
        drawing.line(from, to, DASHES);
        drawing.text(((from.0 + to.0) / 2.0, from.1 - 6.0), "middle", GREY, words);
    }
    let half = f64::from(FIELD) / 2.0;
    for side in [-half, half] {
        drawing.line(frame.place(side, 0.0), frame.place(side, 0.1), DASHES);
    }
    drawing.text((frame.place(0.0, 0.0).0, 382.0), "middle", GREY, "angle off axis");
    drawing.text((frame.x[0].0 - 8.0, 22.0), "start", GREY, "intensity");
}

/// The legend: each model's colour, and its angles.
fn key(drawing: &mut Drawing, models: &[Model]) {
    const COLUMNS: [f64; 3] = [440.0, 530.0, 640.0];
    for (column, words) in COLUMNS.into_iter().zip(["beam", "field", "ends at"]) {
        drawing.text((column, 412.0), "end", GREY, words);
    }
    for (row, model) in models.iter().enumerate() {
        let y = 436.0 + 24.0 * row as f64;
        let style = format!(r#"stroke="{}" stroke-width="2.5""#, model.color);
        drawing.line((110.0, y - 4.0), (140.0, y - 4.0), &style);
        drawing.text((152.0, y), "start", "#202124", &model.name);
        let outer = model.outer.map_or_else(|| "never".into(), |outer| format!("{outer:.2}°"));
        let angles = [format!("{:.2}°", model.beam), format!("{FIELD:.2}°"), outer];
        for (column, angle) in COLUMNS.into_iter().zip(angles) {
            drawing.text((column, y), "end", "#202124", &angle);
        }
    }
}
