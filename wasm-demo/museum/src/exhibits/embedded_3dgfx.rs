//! embedded-3dgfx without `std`: a direction that is no unit vector.
//!
//! Rounded to the 64 levels of its green, this formula had the result of the published crate at
//! 200,000 points of five cones (searched), and the crate is black on the axis of a cone of 5 degrees at
//! 76 % of the distances from 1 to 4 metres.

use micromath::F32;

use super::*;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "embedded-3dgfx",
    label: "A beam that blinks",
    title: "The beam goes black and comes back with the distance, because its direction has the wrong \
        length.",
    source: Source {
        project: "embedded-3dgfx without its feature std",
        file: "src/pipeline/shade/lights.rs, SpotLight::contribution_at",
        version: "0.7.2",
        licence: "MIT or Apache-2.0",
        thread: "",
    },
    code: "let dist = dist_sq.sqrt(); // micromath’s\n\
        let cos_theta = (to_pos / dist).dot(&self.direction);\n\
        let t = ((cos_theta - cos_outer) / (cos_inner - cos_outer)).clamp(0.0, 1.0);",
    cause: "Without std the root is micromath’s estimate, which is up to 6 % too large. A direction \
        divided by it is too short, so its cosine is too small by up to 6 %. A cone of 10 degrees \
        spans only 1.5 %. The estimate is exact at 1, 2 and 4 metres, and there the beam is back.",
    no_better: "Where any crate of the program links std, the root is the processor’s, and the cone is \
        right. The range is 10 km here, and the light is shown before it is rounded to RGB565.",
    agrees_at: None,
    control: Control::logarithmic("Half angle", "°", [3.0, 10.0, 40.0]),
    bounds: Bounds { faulty: 254.0, ours: 0.5 },
    beam,
};

fn beam(degrees: f32) -> Result<Beam, Error> {
    let view = View::Side(0.5, 4.5);
    // micromath's cosine, too: its error is at most 0.002.
    let [inner, outer] = [0.0, degrees].map(|degrees: f32| F32(degrees.to_radians()).cos().0);
    let exact = oracle::Cone::new(soft, oracle::versine(degrees.into()));
    Beam::of_cone(view, Cone::from_outer(Soft, HalfAngle::degrees(degrees))?, exact, move |seen| {
        let cosine = seen.cosine_at(F32(seen.squared_distance()).sqrt().0);
        if cosine <= outer {
            return 0.0;
        }
        let factor = if inner > outer { ((cosine - outer) / (inner - outer)).clamp(0.0, 1.0) } else { 1.0 };
        factor * factor
    })
}
