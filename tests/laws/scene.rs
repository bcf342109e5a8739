//! Lights and surfaces made of words, or `None` if a constructor refuses them.

use super::words::Words;
use luminaire::{
    Angle, Cone, HalfAngle, Material, Rgb, SpotLight, Vec3,
    attenuation::AnyAttenuation,
    falloff::{AnyFalloff, Falloff, Table},
    specular::SpecularLobe,
};

/// The samples of a table that is monotone, begins at full intensity and ends above zero.
pub static SAMPLES: [u16; 6] = [65_535, 65_535, 40_000, 39_999, 1_000, 7];

/// A falloff of the list, or the table above.
pub fn falloff(words: &mut Words<'_>) -> Option<AnyFalloff> {
    let index = words.choice(AnyFalloff::COUNT as u32 + 1) as usize;
    if index == AnyFalloff::COUNT {
        return Table::new(&SAMPLES).ok().map(AnyFalloff::from);
    }
    AnyFalloff::drawn(index, || words.number(0.0, 1.0)).ok()
}

/// An attenuation of the list.
pub fn attenuation(words: &mut Words<'_>) -> Option<AnyAttenuation> {
    let index = words.choice(AnyAttenuation::COUNT as u32) as usize;
    AnyAttenuation::drawn(index, || words.number(0.0, 1.0)).ok()
}

/// Evaluates an expression with one of all specular lobes. Each lobe has its own type.
macro_rules! with_any_highlight {
    ($words:expr, $highlight:ident => $answer:expr) => {
        with_any_highlight!(@of $words, $highlight => $answer,
            0 NoSpecular, 1 Phong, 2 BlinnPhong, 3 DualConeLobe, 4 DifferenceForm::<_, 3>(BlinnPhong))
    };
    (@of $words:expr, $highlight:ident => $answer:expr, $($index:literal $lobe:expr),*) => {{
        use luminaire::specular::{BlinnPhong, DifferenceForm, DualConeLobe, NoSpecular, Phong};
        match $words.choice(5) {
            $($index => {
                let $highlight = $lobe;
                $answer
            })*
            _ => unreachable!("there are five lobes"),
        }
    }};
}
pub(crate) use with_any_highlight;

/// A cone that is given by its outer, field or beam angle, with or without a hotspot and a cutoff.
pub fn cone<P: Falloff>(words: &mut Words<'_>, falloff: P) -> Option<Cone<P>> {
    let design = [Cone::from_outer, Cone::from_field, Cone::from_beam][words.choice(3) as usize];
    // The logarithm of the angle is uniform, because narrow cones are the hard cases.
    let angle = words.number(-16.0, 7.5);
    let mut cone = design(falloff, Angle::degrees(angle.exp2())).ok()?;
    let outer = cone.outer().to_degrees();
    if words.choice(4) == 0 {
        cone = cone.with_inner(Angle::degrees(words.number(0.0, outer))).ok()?;
    }
    if words.choice(4) == 0 {
        cone = cone.with_cutoff(Angle::degrees(words.number(0.0, outer))).ok()?;
    }
    Some(cone)
}

/// A spotlight that is aimed roughly at `target`.
pub fn spot<P: Falloff>(words: &mut Words<'_>, cone: Cone<P>, target: Vec3<f32>) -> Option<SpotLight<P>> {
    let position = words.numbers(-8.0, 8.0);
    let off = words.numbers(-1.0, 1.0).map(|c| c * HalfAngle::from(cone.outer()).to_radians());
    let way = target.zip(position, |t, p| t - p);
    let distance = way.dot(way).sqrt();
    let axis = way.zip(off, |way, off| way + distance * off);
    SpotLight::new(position, axis, cone).ok()?.with_intensity(words.number(0.0, 100.0)).ok()
}

/// A colour.
pub fn color(words: &mut Words<'_>) -> Rgb<f32> {
    let v = words.numbers(0.0, 1.0);
    Rgb::new(v.x, v.y, v.z)
}

/// A material.
pub fn material<H: SpecularLobe>(words: &mut Words<'_>, highlight: H) -> Option<Material<H>> {
    let shininess = H::LEAST_SHININESS + words.choice(1_025 - H::LEAST_SHININESS);
    let matte = Material::new(color(words)).ok()?.with_ambient(color(words)).ok()?;
    matte.with_emissive(color(words)).ok()?.with_highlight(highlight, color(words), shininess).ok()
}
