//! Open Fixture Library: a field angle where a beam angle is meant.

use luminaire::Angle;

use super::*;

/// The full beam and field angles in degrees of the fixture’s data sheet, at both ends of the zoom.
const BEAM: [f32; 2] = [8.0, 30.0];
const FIELD: [f32; 2] = [11.0, 48.0];

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "beam-or-field",
    label: "Beam or field angle",
    title: "The beam is 1.6 times as wide as the fixture’s: its field angle was entered as its beam angle.",
    source: Source {
        project: "Open Fixture Library, Chauvet Rogue R1 Wash",
        file: "fixtures/chauvet-professional/rogue-r1-wash.json, zoom",
        version: "until January 2024",
        licence: "MIT",
        thread: "OpenLightingProject/open-fixture-library #3701",
    },
    code: "\"angleStart\": \"11deg\", \"angleEnd\": \"48deg\" // where the beam has 8 and 30",
    cause: "At the beam angle half of the light is left, at the field angle a tenth. Data sheets print \
        both or do not say which. The library’s zoom means the beam angle, and the file gave the \
        field angle.",
    no_better: "Of one angle alone nobody can say which it is. The crate takes it by name: from_beam, \
        from_field or from_beam_and_field.",
    agrees_at: None,
    control: Control::linear("Zoom", "%", [0.0, 100.0, 100.0]),
    bounds: Bounds { faulty: 95.0, ours: 0.5 },
    beam,
};

/// The outer half angle in radians of a soft cone with this full beam angle in degrees.
fn outer(beam: f32) -> f32 {
    let versine = 1.0 - libm::cosf(beam.to_radians() / 2.0);
    libm::acosf(1.0 - versine / (1.0 - core::f32::consts::FRAC_1_SQRT_2))
}

fn beam(zoom: f32) -> Result<Beam, Error> {
    let [meant, entered] = [BEAM, FIELD].map(|[narrow, wide]| narrow + (wide - narrow) * zoom / 100.0);
    let view = View::spot_on_wall(f64::from(outer(entered).to_degrees()));
    let faulty = clamped_span(1.0 / 1024.0, 0.0, outer(entered));
    let versine = oracle::versine(f64::from(meant) / 2.0) / (1.0 - core::f64::consts::FRAC_1_SQRT_2);
    let exact = oracle::Cone::new(soft, versine);
    Beam::of_cone(view, Cone::from_beam(Soft, Angle::degrees(meant))?, exact, move |seen| {
        faulty(seen.cosine())
    })
}
