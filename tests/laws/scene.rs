//! Lights and surfaces made of words, or `None` if a constructor refuses them.

use super::words::Words;
use luminaire::{
    Angle, Cone, HalfAngle, Material, Rgb, Scalar, SpotLight, Vec3,
    attenuation::AnyAttenuation,
    falloff::{AnyFalloff, Falloff, Table},
    models::Number,
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
    let draw = if words.is_end() { AnyFalloff::anywhere } else { AnyFalloff::drawn };
    draw(index, || words.number(0.0, 1.0)).ok()
}

/// An attenuation of the list.
pub fn attenuation(words: &mut Words<'_>) -> Option<AnyAttenuation> {
    let row = &AnyAttenuation::LIST[words.choice(AnyAttenuation::COUNT as u32) as usize];
    let draw = if words.is_end() { Number::anywhere } else { Number::drawn };
    let numbers: Vec<_> = row.beside_range().map(|number| draw(number, words.number(0.0, 1.0))).collect();
    let has_range = row.window.is_none() || words.choice(10) > 0;
    let range = has_range.then(|| range(words));
    row.of(&numbers, range).ok()
}

/// A range of an attenuation: up to 40, or any that is accepted.
pub fn range(words: &mut Words<'_>) -> f32 {
    if words.is_end() {
        let middle = words.between(-9.9, 29.8).exp2();
        return words.one_of([0.001, middle, 1e9]);
    }
    words.number(0.0, 40.0)
}

/// An intensity: up to 100, or at the ends of what is accepted.
pub fn intensity(words: &mut Words<'_>) -> f32 {
    if words.is_end() { words.one_of([0.0, f32::from_bits(1), 1e9, 1e9]) } else { words.number(0.0, 100.0) }
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

/// A cone that is given by its outer, field or beam angle, or the narrowest or the widest of a
/// format; with or without a hotspot and a cutoff.
pub fn cone<S: Scalar, P: Falloff>(words: &mut Words<'_>, falloff: P) -> Option<Cone<P>> {
    let mut cone = if words.is_end() {
        Cone::from_outer(falloff, words.one_of([narrowest::<S, P>(falloff), Angle::degrees(180.0)])).ok()?
    } else {
        let design = words.one_of([Cone::from_outer, Cone::from_field, Cone::from_beam]);
        // The logarithm of the angle is uniform, because narrow cones are the hard cases.
        design(falloff, Angle::degrees(words.number(-16.0, 7.5).exp2())).ok()?
    };
    let outer = cone.outer().to_degrees();
    if words.choice(4) == 0 {
        cone = cone.with_inner(Angle::degrees(words.number(0.0, outer))).ok()?;
    }
    if words.choice(4) == 0 {
        cone = cone.with_cutoff(Angle::degrees(words.number(0.0, outer))).ok()?;
    }
    Some(cone)
}

/// The narrowest accepted outer angle, plus a margin for the rounding of an angle.
pub fn narrowest<S: Scalar, P: Falloff>(falloff: P) -> Angle {
    Angle::degrees(Cone::narrowest::<S>(falloff).to_degrees() * 1.000_01)
}

/// The position of a light, and a place that it lights. Both are within 8 of the origin, or the
/// light is at the farthest coordinates of the format, and the place within 8 of it, of the origin
/// or of the opposite end of the coordinates.
pub fn places<S: Scalar>(words: &mut Words<'_>) -> [Vec3<f32>; 2] {
    let (place, position) = (words.place(), words.numbers(-8.0, 8.0));
    if !words.is_end() {
        return [position, place];
    }
    // In f32 nothing is lit over a distance of more than 1.8e19.
    let (farthest, opposite) = match S::NAME {
        "f32" => words.one_of([(S::FARTHEST, S::FARTHEST), (1e18, 1e18), (32_768.0, 32_768.0)]),
        _ => (S::FARTHEST, 32_768.0),
    };
    let end = position.map(|c| words.one_of([c, farthest, -farthest]));
    let place = match words.choice(3) {
        0 => place,
        1 => end.zip(place, |end, place| end + place),
        _ => end.zip(place, |end, place| match end.abs() == farthest {
            true => place - opposite.copysign(end),
            false => place,
        }),
    };
    [end, place]
}

/// A spotlight at a position, aimed roughly at a place.
pub fn spot<P: Falloff>(
    words: &mut Words<'_>,
    cone: Cone<P>,
    [position, place]: [Vec3<f32>; 2],
) -> Option<SpotLight<P>> {
    let off = words.numbers(-1.0, 1.0).map(|c| c * HalfAngle::from(cone.outer()).to_radians());
    // Neither the difference of the farthest coordinates nor its square is infinite.
    let way = place.zip(position, |to, from| to / 4.0 - from / 4.0);
    let most = way.x.abs().max(way.y.abs()).max(way.z.abs());
    let way = way.map(|c| c / most);
    let distance = way.dot(way).sqrt();
    let axis = way.zip(off, |way, off| way + distance * off);
    SpotLight::new(position, axis, cone).ok()?.with_intensity(intensity(words)).ok()
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
