//! Light that a surface reflects, and the whole path from lights to a display.

use luminaire::{
    AmbientLight, Angle, Cone, DirectionalLight, Material, SpotLight,
    attenuation::{FilamentRange, InverseSquare},
    display::{Exposure, Rgb565, compress_keep_hue, encode_srgb},
    falloff::Soft,
    light::SurfacePoint,
    specular::{Phong, SpecularLobe},
};

use crate::case::{Case, Outcome};
use crate::word::Format;

/// The light of a directional light that a material reflects.
pub(super) fn reflect<S: Format, H: SpecularLobe>(case: &mut Case<'_>, highlight: H) -> Outcome {
    let (diffuse, specular, shininess) =
        (case.color("diffuse"), case.color("specular"), case.whole("shininess"));
    let (direction, intensity) = (case.vector("axis"), case.number("intensity"));
    let (color, specular_color) = (case.color("color"), case.color("specular color"));
    let (normal, view) = (case.normal::<S>("normal"), case.direction::<S>("view"));
    let material = Material::new(diffuse)?.with_highlight(highlight, specular, shininess)?;
    let light = DirectionalLight::new(direction)?.with_intensity(intensity)?.with_color(color)?;
    let light = light.with_specular_color(specular_color)?.compile::<S>();
    case.give_color(
        material
            .compile::<S>()
            .reflect(&SurfacePoint { view, ..SurfacePoint::matte(Default::default(), normal) }, &light),
    );
    Ok(())
}

/// Ambient and emitted light of a material.
pub(super) fn glow<S: Format>(case: &mut Case<'_>) -> Outcome {
    let (ambient, emissive) = (case.color("diffuse"), case.color("color"));
    let light = case.light::<S>("light");
    let material = Material::new(ambient)?.with_emissive(emissive)?;
    case.give_color(material.compile::<S>().glow(light));
    Ok(())
}

/// The direction from a point to an eye.
pub(super) fn view<S: Format>(case: &mut Case<'_>) -> Outcome {
    let (eye, point) = (case.point::<S>("eye"), case.point::<S>("point"));
    let view = SurfacePoint::<S>::seen_from(eye, point, Default::default()).view;
    for component in [view.x, view.y, view.z] {
        case.give(component);
    }
    Ok(())
}

/// A glossy surface under a spotlight in a night sky. The outputs are the light and, once it is
/// exposed, compressed and encoded, its codes and pixel.
pub(super) fn lit_point<S: Format>(case: &mut Case<'_>) -> Outcome {
    let (field, range) = (case.number("angle"), case.number("range"));
    let (position, axis, intensity) =
        (case.vector("position"), case.vector("axis"), case.number("intensity"));
    let (color, diffuse, specular) = (case.color("color"), case.color("diffuse"), case.color("specular"));
    let (shininess, factor) = (case.whole("shininess"), case.number("exposure"));
    let (eye, point, normal) = (case.point::<S>("eye"), case.point::<S>("point"), case.normal::<S>("normal"));
    let cone = Cone::from_field(Soft, Angle::degrees(field))?;
    let spot = SpotLight::new(position, axis, cone)?.with_intensity(intensity)?.with_color(color)?;
    let spot = spot.with_attenuation(FilamentRange::new(InverseSquare, Some(range))?).compile::<S>()?;
    let sky = AmbientLight::new(color)?.with_intensity(0.05)?.compile::<S>();
    let material = Material::new(diffuse)?.with_highlight(Phong, specular, shininess)?.compile::<S>();
    let exposure = Exposure::factor(factor)?.compile::<S>();
    let surface = SurfacePoint::seen_from(eye, point, normal);
    let light = material.glow(sky) + material.reflect(&surface, &spot);
    case.give_color(light);
    let shown = compress_keep_hue(exposure.expose(light));
    case.give_color(shown.map(encode_srgb));
    case.give(Rgb565::from_linear(shown).0);
    Ok(())
}
