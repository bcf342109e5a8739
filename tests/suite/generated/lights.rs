//! Samples of everything that compiles to a format, in every format. The build script writes them,
//! and the test compares them.

use std::marker::PhantomData;

use luminaire::attenuation::{
    AnyAttenuation, Attenuation, AttenuationVisitor, CutAt, GltfRange, InverseSquare, NoAttenuation,
    SmoothRange, attenuations,
};
use luminaire::falloff::{
    AnyFalloff, Cubic, Falloff, FalloffVisitor, Knot, ListedFalloff, Power, Quadratic, Soft, SoftOrHard,
    Step, Table, constant_falloffs,
};
use luminaire::models;
use luminaire::number::Quick;
use luminaire::specular::{LobeVisitor, Phong, SpecularLobe, lobes};
use luminaire::{
    AmbientLight, Angle, Cone, DirectionalLight, Error, Fx16, Fx32, Material, MeasuredLight, PointLight, Rgb,
    Scalar, SpotLight, Vec3,
    codegen::{Named, Source},
    display::{Exposure, Gray4, Ramp, Rgb565, Rgb565Ramp},
    draw::Gradient,
    haze::Haze,
    light::{Distribution, Symmetry},
    projector::{Gobo, Projection, Shadow},
};

/// A visitor of the values.
pub(crate) trait Visit {
    /// Takes a compiled value, and a name by which to find it.
    fn value<T: Source>(&mut self, name: String, value: T);
}

/// Positions and directions, with components of both signs and of very different sizes.
const PLACES: [Vec3<f32>; 3] =
    [Vec3::new(0.0, 4.0, 0.0), Vec3::new(-1.5, 0.1, 12_000.25), Vec3::new(1e-5, -7.0, 3.3)];
const AXES: [Vec3<f32>; 3] =
    [Vec3::new(0.0, -1.0, 0.0), Vec3::new(0.36, -0.8, 0.48), Vec3::new(-3.0, 2.0, 1.0)];
/// Intensities from less than a step of the coarsest format to the largest that a light may have.
const INTENSITIES: [f32; 3] = [1e-6, 16.0, 1e9];
const AMBER: Rgb<f32> = Rgb::new(1.0, 0.62, 0.0);
const PANES: Gobo<'static> = Gobo::of(&[0, 255, 0, 255, 1, 254, 7, 128, 0]);
const KNOTS: [Knot; 2] = [Knot::from_bits(0, 65_535, -65_535), Knot::from_bits(32_768, 32_768, -32_768)];

/// Every value: models that are chosen at run time in every format, and those that are types in one,
/// because their source is generic over the format.
pub(crate) fn all(visit: &mut impl Visit) -> Result<(), Error> {
    beams(visit)?;
    typed::<Fx16>(visit)?;
    of_format::<f32>(visit)?;
    of_format::<Fx32>(visit)?;
    of_format::<Fx16>(visit)?;
    quick::<Fx16>(visit)
}

/// Spotlights of the quick evaluation.
fn quick<S: Quick>(visit: &mut impl Visit) -> Result<(), Error> {
    let cone = Cone::from_outer(Cubic::with_slopes(1.25, 3.5)?, Angle::degrees(40.0))?;
    for (index, intensity) in INTENSITIES.into_iter().enumerate() {
        let spot = SpotLight::new(PLACES[index], AXES[index], cone)?.with_intensity(intensity)?;
        visit.value(format!("quick {} {spot:?}", S::NAME), spot.compile_quick::<S>()?);
        let level = spot.with_color(AMBER)?.with_attenuation(SmoothRange::new(8.0)?);
        visit.value(format!("quick {} {level:?}", S::NAME), level.compile_quick::<S>()?);
    }
    Ok(())
}

/// Beams in haze.
fn beams(visit: &mut impl Visit) -> Result<(), Error> {
    let cone = Cone::from_outer(Cubic::with_slopes(1.25, 3.5)?, Angle::degrees(40.0))?;
    let spot = SpotLight::new(PLACES[0], AXES[1], cone)?.with_intensity(16.0)?;
    let haze = Haze::new(0.02)?.with_source_radius(0.05)?;
    visit.value("beam".into(), spot.compile::<f32>()?.in_haze(&haze));
    visit.value("beam in 16 bits".into(), spot.compile::<Fx16>()?.in_haze(&haze));
    let windowed = spot.with_attenuation(GltfRange::new(InverseSquare, Some(8.0))?);
    visit.value("beam in a window".into(), windowed.compile::<f32>()?.in_haze(&haze));
    Ok(())
}

/// Lights and surfaces whose falloff, attenuation or lobe is a type.
fn typed<S: Scalar>(visit: &mut impl Visit) -> Result<(), Error> {
    let mut listed = Listed { visit, format: PhantomData::<S> };
    constant_falloffs(&mut listed);
    attenuations(&mut listed);
    lobes::<S>(&mut listed);
    spots::<S, _>(visit, Quadratic::new(0.3))?;
    spots::<S, _>(visit, Ok(Power::<15>))?;
    spots::<S, _>(visit, Ok(Table::of_knots(&KNOTS)))?;
    spots::<S, _>(visit, Ok(SoftOrHard::Hard))?;
    for field in [20.0, 29.0] {
        spots::<S, _>(
            visit,
            Cone::from_beam_and_field(Angle::degrees(14.0), Angle::degrees(field)).map(|cone| cone.falloff()),
        )?;
    }
    at_distances::<S, _>(visit, Ok(NoAttenuation))?;
    at_distances::<S, _>(visit, GltfRange::new(InverseSquare, None))?;
    let window = GltfRange::new(InverseSquare, Some(8.0))?;
    at_distances::<S, _>(visit, CutAt::new(window, Some(6.0)))
}

/// Visits the models of the list, for lights and surfaces in the format `S`.
struct Listed<'a, S, V> {
    visit: &'a mut V,
    format: PhantomData<S>,
}

const SOUND: &str = "the parameters of the lists are sound";

impl<S: Scalar, V: Visit> FalloffVisitor for Listed<'_, S, V> {
    fn falloff<P: ListedFalloff>(&mut self) {
        spots::<S, _>(self.visit, P::sample()).expect(SOUND);
    }
}

impl<S: Scalar, V: Visit> AttenuationVisitor for Listed<'_, S, V> {
    fn attenuation<A: models::Listed + Attenuation>(&mut self) {
        at_distances::<S, _>(self.visit, A::sample()).expect(SOUND);
    }
}

impl<S: Scalar, V: Visit> LobeVisitor<S> for Listed<'_, S, V> {
    fn lobe<H: models::Listed + SpecularLobe<Constants<S>: Source> + Named>(&mut self) {
        surfaces::<S, _>(self.visit, H::sample().expect(SOUND)).expect(SOUND);
    }
}

fn of_format<S: Scalar>(visit: &mut impl Visit) -> Result<(), Error> {
    for sample in AnyFalloff::samples() {
        spots::<S, _>(visit, Ok(sample))?;
    }
    for index in 0..AnyAttenuation::COUNT {
        at_distances::<S, _>(visit, AnyAttenuation::drawn(index, || 0.5))?;
    }
    surfaces::<S, _>(visit, Phong)?;
    for (index, (degrees, roll)) in [(1.5, 0.0), (40.0, 90.0), (160.0, -10.0)].into_iter().enumerate() {
        let spot =
            SpotLight::new(PLACES[index], AXES[index], Cone::from_outer(Step, Angle::degrees(degrees))?)?;
        let square = Projection::of(&spot)?.turned(Angle::degrees(roll))?;
        visit.value(format!("{} {square:?}", S::NAME), square.compile::<S>()?);
        let depths = [0.5, 7.25, f32::INFINITY, 3.0].map(S::length);
        visit.value(
            format!("{} shadow on {square:?}", S::NAME),
            Shadow::new(square.compile::<S>()?, 2, &depths)?,
        );
        visit.value(format!("{} {PANES:?} on {square:?}", S::NAME), PANES.on(square.compile::<S>()?));
    }
    visit.value(format!("{} ramp", S::NAME), Rgb565Ramp::new(AMBER.map(|channel| 0.1 * channel), AMBER)?);
    visit.value(format!("{} gray ramp", S::NAME), Ramp::<Gray4>::new(AMBER, AMBER)?);
    let colors = [Rgb::new(0, 0, 0), Rgb::new(255, 9, 0)];
    let gradients =
        [Gradient::linear(&colors, [0.0, 9.5], [0.0, -7.0])?, Gradient::radial(&colors, [3.0, 1.0], 20.0)?];
    for gradient in gradients {
        visit.value(format!("{} {gradient:?}", S::NAME), gradient as Gradient<Rgb565, 8>);
    }
    let paper = Material::new(Rgb::new(0.9, 0.9, 0.85))?.with_emissive(AMBER)?;
    visit.value(format!("{} matte material", S::NAME), paper.compile::<S>());
    for intensity in INTENSITIES {
        let name = |kind| format!("{} {kind} of {intensity}", S::NAME);
        visit.value(name("ambient"), AmbientLight::new(AMBER)?.with_intensity(intensity)?.compile::<S>());
        visit.value(name("exposure"), Exposure::factor(intensity)?.compile::<S>());
        for axis in AXES {
            let sun = DirectionalLight::new(axis)?.with_color(AMBER)?.with_intensity(intensity)?;
            visit.value(format!("{:?}", sun), sun.compile::<S>());
        }
    }
    Ok(())
}

/// Spotlights with a falloff: over the whole cone, around a hotspot, and with a cutoff.
fn spots<S: Scalar, P: Falloff>(visit: &mut impl Visit, falloff: Result<P, Error>) -> Result<(), Error> {
    let plain = Cone::from_outer(falloff?, Angle::degrees(40.0))?;
    let hotspot = plain.with_inner(Angle::degrees(13.0))?;
    let cut = plain.with_cutoff(Angle::degrees(31.0))?;
    for (index, cone) in [plain, hotspot, cut].into_iter().enumerate() {
        let spot = SpotLight::new(PLACES[index], AXES[index], cone)?.with_intensity(INTENSITIES[index])?;
        visit.value(format!("{} {spot:?}", S::NAME), spot.compile::<S>()?);
        visit.value(format!("{} {cone:?}", S::NAME), cone.compile::<S>()?);
    }
    Ok(())
}

/// A spotlight and a point light with an attenuation.
fn at_distances<S: Scalar, A: Attenuation>(
    visit: &mut impl Visit,
    attenuation: Result<A, Error>,
) -> Result<(), Error> {
    let attenuation = attenuation?;
    let cone = Cone::from_field(Soft, Angle::degrees(36.0))?;
    let spot = SpotLight::new(PLACES[0], AXES[0], cone)?.with_attenuation(attenuation).with_color(AMBER)?;
    visit.value(format!("{} {spot:?}", S::NAME), spot.compile::<S>()?);
    let point = PointLight::new(PLACES[1])?.with_attenuation(attenuation).with_specular_color(AMBER)?;
    visit.value(format!("{} {point:?}", S::NAME), point.compile::<S>()?);
    let distribution =
        Distribution::from_parts(&[65_535, 1, 40_000, 0, 7, 0, 0, 0, 0], 5, Symmetry::Quadrant);
    let measured =
        MeasuredLight::new(PLACES[1], AXES[1], AXES[2], distribution)?.with_attenuation(attenuation);
    visit.value(format!("{} {measured:?}", S::NAME), measured.with_specular_color(AMBER)?.compile::<S>()?);
    Ok(())
}

/// Materials with a specular lobe, wide and narrow.
fn surfaces<S: Scalar, H: SpecularLobe<Constants<S>: Source> + Named>(
    visit: &mut impl Visit,
    highlight: H,
) -> Result<(), Error> {
    for shininess in [8, 1024] {
        let glazed = Material::new(AMBER)?.with_highlight(highlight, Rgb::new(0.5, 0.5, 0.5), shininess)?;
        visit.value(format!("{} {glazed:?}", S::NAME), glazed.compile::<S>());
    }
    Ok(())
}
