//! Getters return exactly the values that were set; each `with_*` changes only its own field.

use luminaire::{
    AmbientLight, Angle, Cone, DirectionalLight, Fx16, Material, PointLight, Rgb, Scalar, SpotLight, Vec3,
    attenuation::{CutAt, InverseSquare, NoAttenuation, Polynomial, Windowed},
    display::Exposure,
    dynamic::AnyLight,
    falloff::{Cubic, Hard, Soft},
    light::{LightModel, SurfacePoint},
    specular::Phong,
};

const RED: Rgb<f32> = Rgb::new(0.75, 0.25, 0.125);
const BLUE: Rgb<f32> = Rgb::new(0.125, 0.5, 0.875);
const PLACE: Vec3<f32> = Vec3::new(1.5, -2.25, 300.0);
const DOWN: Vec3<f32> = Vec3::new(0.0, -1.0, 0.0);

fn cone() -> Cone<Soft> {
    Cone::from_outer(Soft, Angle::degrees(30.0)).expect("sound")
}

/// Asserts that a light keeps its colours and its intensity.
macro_rules! assert_emission {
    ($light:expr) => {{
        let white = $light.expect("sound");
        assert_eq!((white.color(), white.specular_color(), white.intensity()), (WHITE, WHITE, 1.0));
        let red = white.with_color(RED).and_then(|light| light.with_intensity(2.5)).expect("sound");
        assert_eq!((red.color(), red.specular_color(), red.intensity()), (RED, RED, 2.5));
        let both = red.with_specular_color(BLUE).expect("sound");
        assert_eq!((both.color(), both.specular_color(), both.intensity()), (RED, BLUE, 2.5));
        both
    }};
}
const WHITE: Rgb<f32> = Rgb::new(1.0, 1.0, 1.0);

#[test]
fn lights_keep_what_they_are_given() {
    let sun = assert_emission!(DirectionalLight::new(DOWN));
    assert_eq!(sun.direction(), DOWN);
    let bulb = assert_emission!(PointLight::new(PLACE)).with_attenuation(NoAttenuation);
    assert_eq!((bulb.position(), bulb.attenuation(), bulb.color()), (PLACE, NoAttenuation, RED));
    let spot = assert_emission!(SpotLight::new(PLACE, DOWN, cone()));
    assert_eq!(
        (spot.position(), spot.axis(), spot.cone(), spot.attenuation()),
        (PLACE, DOWN, cone(), InverseSquare)
    );
    let hard = Cone::from_outer(Hard, Angle::degrees(10.0)).expect("sound");
    let other = spot.with_cone(hard).with_attenuation(NoAttenuation);
    assert_eq!(
        (other.cone(), other.attenuation(), other.position(), other.intensity()),
        (hard, NoAttenuation, PLACE, 2.5)
    );
    let turned = spot.with_axis(Vec3::new(3.0, 0.0, 4.0)).expect("sound");
    assert_eq!(turned.axis(), Vec3::new(0.6, 0.0, 0.8));
    assert_eq!(turned.with_axis(DOWN), Ok(spot), "all else stays");
    let ambient = AmbientLight::new(BLUE).and_then(|light| light.with_intensity(0.5)).expect("sound");
    assert_eq!((ambient.color(), ambient.intensity()), (BLUE, 0.5));
}

/// Asserts that compiled lights keep their colours. Multiples of 1/8 are exact in every format.
fn assert_compiled<S: Scalar>() {
    let spot = SpotLight::new(PLACE, DOWN, cone()).and_then(|spot| spot.with_color(RED)).expect("sound");
    let spot = spot.with_specular_color(BLUE).and_then(|spot| spot.compile::<S>()).expect("held");
    assert_eq!((spot.color().map(S::to_f32), spot.specular_color().map(S::to_f32)), (RED, BLUE));
    assert_eq!(spot.colors(), [spot.color(), spot.specular_color()]);
    assert_eq!(spot.falloff(), Soft);
    assert_eq!(<S as Scalar>::point([1.5, -2.25, 300.0]), PLACE.map(S::length));
    assert_eq!(<S as Scalar>::normal(DOWN), DOWN.map(S::from_f32));
    let surface = SurfacePoint::<S>::matte(PLACE.map(S::length), DOWN.map(S::from_f32));
    assert_eq!((surface.point, surface.normal), (PLACE.map(S::length), DOWN.map(S::from_f32)));
}

#[test]
fn compiled_lights_keep_their_colors() {
    assert_compiled::<f32>();
    assert_compiled::<luminaire::Fx32>();
    assert_compiled::<Fx16>();
    let colors = |bulb: AnyLight| bulb.compile::<f32>().expect("held").colors();
    let bulb = PointLight::new(PLACE).and_then(|bulb| bulb.with_color(RED)?.with_specular_color(BLUE));
    let sun = DirectionalLight::new(DOWN).and_then(|sun| sun.with_color(RED)?.with_specular_color(BLUE));
    let (bulb, sun) = (bulb.expect("sound"), sun.expect("sound"));
    assert_eq!([colors(bulb.into()), colors(sun.into())], [[RED, BLUE]; 2]);
    let (bulb, sun) = (bulb.compile::<f32>().expect("held"), sun.compile::<f32>());
    assert_eq!([bulb.color(), bulb.specular_color()], [RED, BLUE]);
    assert_eq!([sun.color(), sun.specular_color()], [RED, BLUE]);
}

#[test]
fn materials_keep_what_they_are_given() {
    let material = Material::new(RED)
        .and_then(|material| material.with_ambient(BLUE))
        .and_then(|material| material.with_emissive(RED))
        .and_then(|material| material.with_highlight(Phong, BLUE, 24))
        .expect("sound");
    assert_eq!((material.diffuse(), material.ambient(), material.emissive()), (RED, BLUE, RED));
    assert_eq!((material.specular(), material.shininess()), (BLUE, 24));
}

#[test]
fn models_keep_what_they_are_given() {
    let polynomial = Polynomial::new(0.5, 0.25, 0.125).expect("sound");
    assert_eq!(polynomial.coefficients(), [0.5, 0.25, 0.125]);
    let faded = Windowed::new(polynomial, Some(7.5)).expect("sound");
    assert_eq!((faded.attenuation(), faded.range()), (polynomial, Some(7.5)));
    assert_eq!(CutAt::new(polynomial, None).expect("sound").range(), None);
    let cubic = Cubic::with_slopes(1.25, 3.5).expect("sound");
    assert_eq!((cubic.edge_slope(), cubic.middle_slope()), (1.25, 3.5));
    assert_eq!(Cubic::new(1.25, -3.0, 2.75).expect("sound"), cubic);
    let falloff = cone().compile::<Fx16>().expect("held");
    let hard = Cone::from_outer(Hard, Angle::degrees(30.0)).expect("sound");
    assert_eq!(falloff.with_falloff(Hard), hard.compile::<Fx16>().expect("held"));
    assert_eq!(falloff.with_falloff(Hard).with_falloff(Soft), falloff);
    assert_eq!(Exposure::factor(4.0).expect("sound"), Exposure::stops(2).expect("sound"));
}
