//! Filament's glTF loader: half angles taken for full ones.

use super::*;

pub(super) const EXHIBIT: Exhibit = Exhibit {
    name: "full-angle",
    label: "Half or full angle",
    title: "The beam is twice as wide as its file says: a half angle was doubled for a function that wants \
        half angles.",
    source: Source {
        project: "Filament, gltfio",
        file: "libs/gltfio, spot lights",
        version: "some days of April 2020",
        licence: "Apache-2.0",
        thread: "google/filament #2339, #2340, #2399",
    },
    code: "setSpotLightCone(2 * innerConeAngle, 2 * outerConeAngle) // half angles are expected",
    cause: "The documentation said full angles and the code took half angles. A correction of the loader \
        followed the documentation, and days later both were put right. Angles in the crate are full; \
        a half angle needs the type HalfAngle.",
    no_better: "A number without its convention cannot be checked by anybody: if the file means the full \
        angle, the crate draws the wrong beam, too.",
    agrees_at: None,
    control: Control::linear("Half angle of the file", "°", [5.0, 20.0, 35.0]),
    bounds: Bounds { faulty: 140.0, ours: 0.5 },
    beam,
};

fn beam(degrees: f32) -> Result<Beam, Error> {
    let view = View::spot_on_wall(f64::from(2.0 * degrees));
    let faulty = clamped_span(1.0 / 1024.0, 0.0, 2.0 * degrees.to_radians());
    let exact = oracle::Cone::new(soft, oracle::versine(degrees.into()));
    Beam::of_cone(view, Cone::from_outer(Soft, HalfAngle::degrees(degrees))?, exact, move |seen| {
        faulty(seen.cosine())
    })
}
