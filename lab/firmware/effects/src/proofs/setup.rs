//! Every constructor, of any numbers, and every conversion to the format: what panics anywhere does
//! not link.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::array::from_fn;
use core::hint::black_box;

#[allow(clippy::wildcard_imports, reason = "the types of the list")]
use luminaire::falloff::*;
use luminaire::import::{Difference, Direct3d, Gltf, Godot, OpenGl, Penumbra, Ramp, Three};
use luminaire::{
    AmbientLight, Angle, Cone, DirectionalLight, Error, HalfAngle, Material, PointLight, SpotLight, Vec3,
    display::{Exposure, decode_srgb},
    dynamic::{AnyLight, Effect, RenderPlan},
    haze::{Haze, RayBundle, ViewRay},
    models::SAMPLES,
    projector::{Fixture, Gobo, Projection, Shadow},
    specular::{BlinnPhong, DifferenceForm, DualConeLobe, Phong, SpecularLobe},
};
use luminaire_effects::Format;
use luminaire_effects::raw::{Bits, Raw};

luminaire_effects::program!(setup);

const PATTERN: [u8; 9] = [255, 0, 1, 254, 127, 128, 3, 200, 40];

fn setup(words: [u64; 64]) {
    of_format::<Format>(&mut Bits::new(words));
}

fn of_format<S: Raw>(bits: &mut Bits) {
    macro_rules! falloffs {
        ($($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr, $truth:expr;)*) => {
            $(
                let sample: Result<$type, Error> = $sample;
                if let Ok(falloff) = black_box(sample) {
                    designs::<S, $type>(bits, falloff);
                }
            )*
        };
    }
    luminaire::constant_falloffs!(falloffs);
    designs::<S, _>(bits, Power::<15>);
    let edge = if bits.choice(2) == 0 { SoftOrHard::Soft } else { SoftOrHard::Hard };
    designs::<S, _>(bits, edge);
    let (quadratic, cubic) = (bits.any_quadratic(), bits.any_cubic());
    let fitted =
        if bits.choice(2) == 0 { FittedFalloff::Quadratic(quadratic) } else { FittedFalloff::Cubic(cubic) };
    designs::<S, _>(bits, fitted);
    let matched = bits.any_profile();
    designs::<S, _>(bits, matched);
    measures::<S>(bits);
    two_angles::<S>(bits);
    if let Ok(light) = light::<S>(bits) {
        hangs::<S>(bits, light);
    }
    imports::<S>(bits);
    surfaces::<S>(bits);
    sees(bits);
}

/// All constructors and getters of the cones of a profile.
#[inline(never)]
fn designs<S: Raw, P: Falloff>(bits: &mut Bits, profile: P) {
    let [angle, inner, cutoff] = from_fn(|_| Angle::degrees(bits.float()));
    black_box([profile.beam_versine(), profile.field_versine()]);
    black_box([profile.steepness(bits.float()), profile.integral(bits.float())]);
    black_box(Cone::narrowest::<S>(profile));
    let made = match bits.choice(3) {
        0 => Cone::from_field(profile, angle),
        1 => Cone::from_beam(profile, angle),
        _ => Cone::from_outer(profile, angle),
    };
    let made = made.and_then(|cone| cone.with_inner(inner)?.with_cutoff(cutoff));
    if let Ok(cone) = made {
        black_box([cone.inner(), cone.beam(), cone.field(), cone.outer()]);
        black_box([
            cone.outer_versine(),
            Cone::lumens(&cone, bits.float()),
            Cone::candela(&cone, bits.float()),
        ]);
        black_box([cone.has_hotspot(), cone.has_cutoff()]);
        black_box(Cone::compile::<S>(&cone.with_profile(cone.profile())).is_ok());
    }
}

/// Angles, and profiles that have numbers of their own.
#[inline(never)]
fn measures<S: Raw>(bits: &mut Bits) {
    let half = HalfAngle::radians(bits.float());
    black_box([half.to_degrees(), HalfAngle::to_radians(HalfAngle::degrees(bits.float()))]);
    let angle = if bits.choice(2) == 0 { Angle::from(half) } else { Angle::radians(bits.float()) };
    black_box([angle.to_degrees(), Angle::to_radians(angle), Angle::versine(angle)]);
    black_box(HalfAngle::from(Angle::from_versine(bits.float())));
    black_box(Quadratic::new(bits.float()).is_ok());
    let [a, b, c] = from_fn(|_| bits.float());
    black_box(
        [Cubic::new(a, b, c), Cubic::with_slopes(a, b)].map(|made| made.map(Cubic::coefficients).is_ok()),
    );
    let mut knots = [Knot::default(); 7];
    let measured = [a, b, c, bits.float()];
    if let Ok((table, _)) = Table::from_angles(black_box(&measured[..]), angle, black_box(&mut knots[..])) {
        black_box((table.samples().len(), table.knots().len()));
        designs::<S, _>(bits, table);
    }
}

/// Cones that have two angles.
#[inline(never)]
fn two_angles<S: Raw>(bits: &mut Bits) {
    let [beam, field] = from_fn(|_| Angle::degrees(bits.float()));
    black_box(Cone::edge_slopes(beam, field).is_ok());
    if let Ok(cone) = Cone::from_beam_and_field(beam, field) {
        black_box(Cone::compile::<S>(&cone).is_ok());
    }
    if let Ok(cone) = Cone::from_beam_field_and_slope(beam, field, bits.float()) {
        black_box(Cone::compile::<S>(&cone).is_ok());
    }
    black_box(Cone::<Power<32>>::opengl(HalfAngle::degrees(bits.float())).is_ok());
}

fn floats(bits: &mut Bits) -> Vec3<f32> {
    bits.vector(f32::raw_length)
}

/// A light of any kind.
#[inline(never)]
fn light<S: Raw>(bits: &mut Bits) -> Result<AnyLight, Error> {
    let (place, direction) = (floats(bits), floats(bits));
    let [color, shine] = from_fn(|_| bits.color(f32::scalar));
    let intensity = bits.float();
    match bits.choice(3) {
        0 => {
            let light = DirectionalLight::new(direction)?.with_color(color)?.with_specular_color(shine)?;

            let light = light.with_intensity(intensity)?;
            black_box(DirectionalLight::compile::<S>(&light));
            Ok(light.into())
        }
        1 => {
            let light = PointLight::new(place)?.with_color(color)?.with_specular_color(shine)?;
            let light = light.with_intensity(intensity)?.with_attenuation(bits.any_distance());
            black_box([PointLight::lumens(&light, bits.float()), PointLight::candela(&light, bits.float())]);
            black_box(PointLight::compile::<S>(&light).is_ok());
            Ok(light.into())
        }
        _ => {
            let cone = Cone::from_outer(bits.any_profile(), Angle::degrees(bits.float()))?;
            let light = if bits.choice(2) == 0 {
                SpotLight::with_attenuation(&SpotLight::new(place, direction, cone)?, bits.any_distance())
            } else {
                let light = SpotLight::between(place, direction, cone)?;
                light.with_attenuation(light.attenuation().into())
            };
            let light = light.with_axis(floats(bits))?.with_cone(light.cone()).with_color(color)?;
            let light = light.with_specular_color(shine)?.with_intensity(intensity)?;
            black_box((light.color(), light.specular_color(), light.intensity()));
            black_box(SpotLight::axis_in::<S>(&light));
            black_box(SpotLight::compile::<S>(&light).is_ok());
            Ok(light.into())
        }
    }
}

/// What hangs from a truss: a light with what is in front of it, and the plan of its picture.
#[inline(never)]
fn hangs<S: Raw>(bits: &mut Bits, light: AnyLight) {
    black_box((AnyLight::color(&light), AnyLight::specular_color(&light), AnyLight::intensity(&light)));
    black_box((AnyLight::effects(&light), light.is_dark()));
    let pattern = Gobo::new(bits.word() as usize, black_box(PATTERN.as_slice()));
    let hung = pattern.and_then(|pattern| {
        let roll = Angle::degrees(bits.float());
        Fixture::from(light).with_gobo(pattern, roll)?.with_shadow(bits.word() as u16)
    });
    let luminaire = hung.unwrap_or(light.into());
    black_box(luminaire.compile_gobo::<S>().is_ok());
    let plan = if bits.choice(2) == 0 {
        RenderPlan::with(RenderPlan::new(), Effect::Haze)
    } else {
        RenderPlan::everything()
    };
    let plan = plan.with_fixture(&luminaire);
    black_box((plan.requires(Effect::Gobo), plan.effects().iter().count()));
    black_box(Fixture::effects(&luminaire));
    black_box(plan.prepare::<S>(luminaire.light()).is_ok());
    black_box(AnyLight::compile::<S>(&light).is_ok());
    if let AnyLight::Spot(spot) = light {
        let roll = Angle::degrees(bits.float());
        black_box(Projection::of(&spot).and_then(|square| square.turned(roll)).is_ok());
    }
    if let Some((_, square)) = luminaire.shadow() {
        black_box([square.right(), square.up()]);
        black_box(square.tangent());
        if let Ok(square) = Projection::compile::<S>(&square) {
            let depths: [S::Length; 9] = from_fn(|_| S::raw_length(bits.word()));
            black_box(Shadow::new(square, bits.word() as usize, black_box(depths.as_slice())).is_ok());
        }
    }
}

/// The lights of other systems.
#[inline(never)]
fn imports<S: Raw>(bits: &mut Bits) {
    let (place, direction) = (floats(bits), floats(bits));
    let [a, b, c, d, e, f] = from_fn(|_| bits.float());
    let opengl = OpenGl {
        spot_cutoff: a,
        spot_exponent: b,
        constant_attenuation: c,
        linear_attenuation: d,
        quadratic_attenuation: e,
        intensity: f,
    };
    imported(OpenGl::import(&opengl, place, direction).map(|of| of.difference));
    let direct3d = Direct3d {
        theta: a,
        phi: b,
        falloff: c,
        attenuation0: d,
        attenuation1: e,
        attenuation2: f,
        range: bits.float(),
        intensity: bits.float(),
    };
    imported(Direct3d::import(&direct3d, place, direction).map(|of| of.difference));
    let gltf = Gltf { inner_cone_angle: a, outer_cone_angle: b, range: bits.any_range(), intensity: c };
    imported(Gltf::import(&gltf, place, direction).map(|of| of.difference));
    imported(Gltf::import_as_recommended(&gltf, place, direction).map(|of| of.difference));
    let three = Three { angle: a, penumbra: b, distance: c, decay: d, intensity: e };
    imported(Three::import(&three, place, direction).map(|of| of.difference));
    let godot = Godot {
        spot_angle: a,
        spot_angle_attenuation: b,
        spot_range: c,
        spot_attenuation: d,
        light_energy: e,
    };
    let godot = Godot::import(&godot, place, direction);
    if let Ok(of) = godot {
        // No other rim has a floor.
        black_box(SpotLight::compile::<S>(&of.light).is_ok());
    }
    imported(godot.map(|of| of.difference));
    let ramp = if bits.choice(2) == 0 { Ramp::Linear } else { Ramp::Smooth };
    let penumbra = Penumbra { umbra: Angle::degrees(a), penumbra: Angle::degrees(b), ramp, intensity: c };
    imported(Penumbra::import(&penumbra, place, direction).map(|of| of.difference));
}

fn imported(difference: Result<Difference, Error>) {
    if let Ok(difference) = difference {
        black_box(difference.most());
    }
}

/// Materials, light from everywhere, and the display.
#[inline(never)]
fn surfaces<S: Raw>(bits: &mut Bits) {
    if let Ok(paper) = paper(bits) {
        black_box(Material::compile::<S>(&paper));
        glossy::<S, _>(bits, paper, Phong);
        glossy::<S, _>(bits, paper, BlinnPhong);
        glossy::<S, _>(bits, paper, DualConeLobe);
        glossy::<S, _>(bits, paper, DifferenceForm::<_, 3>(Phong));
    }
    let ambient = AmbientLight::new(bits.color(f32::scalar))
        .and_then(|all| AmbientLight::with_intensity(all, bits.float()));
    if let Ok(ambient) = ambient {
        black_box(AmbientLight::compile::<S>(&ambient));
        black_box(RenderPlan::with_ambient(RenderPlan::new(), &ambient).skips());
    }
    for exposure in [Exposure::factor(bits.float()), Exposure::stops(bits.word() as i32)] {
        black_box(exposure.map(Exposure::compile::<S>).is_ok());
    }
    black_box(decode_srgb(bits.word() as u8));
}

fn paper(bits: &mut Bits) -> Result<Material, Error> {
    let [diffuse, ambient, emissive] = from_fn(|_| bits.color(f32::scalar));
    Material::with_ambient(Material::new(diffuse)?, ambient)?.with_emissive(emissive)
}

fn glossy<S: Raw, H: SpecularLobe>(bits: &mut Bits, paper: Material, highlight: H) {
    if let Ok(gloss) = paper.with_highlight(highlight, bits.color(f32::scalar), bits.word() as u32) {
        black_box(Material::compile::<S>(&gloss));
        black_box(RenderPlan::new().with_material(&gloss).effects());
    }
    black_box(H::end(bits.word() as u32));
}

/// Haze, and who looks at it.
#[inline(never)]
fn sees(bits: &mut Bits) {
    if let Ok(haze) = Haze::new(bits.float()).and_then(|haze| haze.with_source_radius(bits.float())) {
        black_box(haze);
    }
    let (eye, direction) = (floats(bits), floats(bits));
    let others = [floats(bits), floats(bits), floats(bits)];
    black_box(RayBundle::around(eye, direction, black_box(&others[..]), bits.float()));
    black_box([ViewRay::between(eye, direction), ViewRay::endless(eye, direction)]);
}
