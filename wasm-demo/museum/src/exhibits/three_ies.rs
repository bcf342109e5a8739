//! three.js: candelas of IES files, squared.

use luminaire::attenuation::NoAttenuation;

use super::{micromath_power::opengl, *};

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "three-ies",
    label: "Candelas, squared",
    title: "Every measured light is drawn too narrow, because each candela is multiplied by itself.",
    source: Source {
        project: "three.js",
        file: "examples/jsm/loaders/IESLoader.js",
        version: "until September 2026",
        licence: "MIT",
        thread: "mrdoob/three.js #34554, BabylonJS/Babylon.js #15949",
    },
    code: "candelaValues[ i ][ j ] *= candelaValues[ i ][ j ] * multiplier * ballFactor * blpFactor;",
    cause: "`a *= a * b` is `a = a * a * b`. The table is then divided by its largest value, so that the \
        axis looks right and everything else is too dark. Babylon.js has the same line, and defended \
        it in review.",
    no_better: "On the axis both agree. The file here samples a power of the cosine at every degree; \
        between two samples a straight line is as far from the truth as one measures.",
    agrees_at: None,
    control: Control::linear("Field angle of the file", "°", [20.0, 60.0, 120.0]),
    bounds: Bounds { faulty: 55.0, ours: 0.6 },
    beam,
};

/// The candelas at every degree off axis, as the loader leaves them: squared, and relative to the
/// largest.
fn loaded(exponent: f64) -> Vec<f32> {
    let candelas = (0..=180).map(|degrees| {
        let cosine = libm::cos(f64::from(degrees).to_radians()).max(0.0);
        1000.0 * libm::pow(cosine, exponent)
    });
    let squared: Vec<f64> = candelas.map(|candela| candela * candela).collect();
    let most = squared.iter().copied().fold(0.0, f64::max);
    squared.into_iter().map(|value| (value / most) as f32).collect()
}

fn beam(field: f32) -> Result<Beam, Error> {
    let exponent = -core::f64::consts::LN_10 / libm::log(libm::cos(f64::from(field / 2.0).to_radians()));
    let view = View::spot_on_wall(f64::from(field / 2.0));
    let exact = oracle::Cone::opengl((exponent as f32).into(), 1.0);
    let table = loaded(exponent);
    Ok(Beam {
        view,
        ours: opengl(view, 90.0, exponent as f32, NoAttenuation)?,
        exact: Box::new(move |versine, _| exact.falloff(versine)),
        faulty: Box::new(move |seen| {
            let degrees = libm::acosf(seen.cosine().clamp(-1.0, 1.0)).to_degrees();
            let index = (degrees as usize).min(179);
            let (from, to) = (table[index], table[index + 1]);
            from + (to - from) * (degrees - index as f32)
        }),
    })
}
