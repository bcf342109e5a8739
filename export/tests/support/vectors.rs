//! The conformance vectors of lights in the 16-bit format.

use std::collections::HashMap;

use luminaire::attenuation::{
    AnyAttenuation, CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
};
use luminaire::dynamic::AnyLight;
use luminaire::falloff::{AnyFalloff, Falloff, Hard, Soft};
use luminaire::{Angle, Cone, Error, PointLight, SpotLight};

/// A light, a place and the answer there.
pub(crate) struct Vector {
    pub(crate) light: AnyLight,
    /// The words of the point and of the normal.
    pub(crate) place: [i32; 6],
    /// The irradiance and the falloff, where the section has one.
    pub(crate) answer: (u32, Option<u32>),
}

/// The words of a line by the names of the inputs.
struct Words<'a>(HashMap<&'a str, Vec<u32>>);

impl Words<'_> {
    fn number(&self, name: &str) -> f32 {
        f32::from_bits(self.0[name][0])
    }

    fn vector(&self, name: &str) -> [f32; 3] {
        [0, 1, 2].map(|i| f32::from_bits(self.0[name][i]))
    }

    fn cone<P: Falloff + Into<AnyFalloff>>(&self, falloff: P) -> Result<Cone<AnyFalloff>, Error> {
        let (falloff, angle) = (falloff.into(), Angle::degrees(self.number("angle")));
        let mut cone = match self.0["design"][0] {
            0 => Cone::from_outer(falloff, angle),
            1 => Cone::from_beam(falloff, angle),
            _ => Cone::from_field(falloff, angle),
        }?;
        if self.number("inner") != 0.0 {
            cone = cone.with_inner(Angle::degrees(self.number("inner")))?;
        }
        if self.number("cutoff") != 0.0 {
            cone = cone.with_cutoff(Angle::degrees(self.number("cutoff")))?;
        }
        Ok(cone)
    }

    fn light(&self, section: &str) -> Option<Result<AnyLight, Error>> {
        let spot = |cone: Result<Cone<AnyFalloff>, Error>| {
            let spot = SpotLight::new(self.vector("position"), self.vector("axis"), cone?)?;
            Ok(spot.with_intensity(self.number("intensity"))?.into())
        };
        let point = |attenuation: Result<AnyAttenuation, Error>| {
            let point = PointLight::new(self.vector("position"))?.with_intensity(self.number("intensity"))?;
            Ok(point.with_attenuation(attenuation?).into())
        };
        let range = || Some(self.number("range"));
        Some(match section {
            "spot soft" => spot(self.cone(Soft)),
            "spot hard" => spot(self.cone(Hard)),
            "spot between" => self.cone(Soft).and_then(|cone| {
                Ok(SpotLight::between(self.vector("position"), self.vector("end"), cone)?.into())
            }),
            "point unattenuated" => point(Ok(NoAttenuation.into())),
            "point inverse-square" => point(Ok(InverseSquare.into())),
            "point polynomial" => {
                let [a, b, c] = self.vector("coefficients");
                point(Polynomial::new(a, b, c).map(Into::into))
            }
            "point smooth-range" => point(SmoothRange::new(self.number("range")).map(Into::into)),
            "point gltf-range" => point(GltfRange::new(InverseSquare, range()).map(Into::into)),
            "point gltf-range-without-range" => point(GltfRange::new(InverseSquare, None).map(Into::into)),
            "point filament-range" => point(FilamentRange::new(InverseSquare, range()).map(Into::into)),
            "point cut-at" => point(CutAt::new(NoAttenuation, range()).map(Into::into)),
            _ => return None,
        })
    }
}

/// Returns the number of words of an input.
fn width(name: &str) -> usize {
    if ["position", "axis", "end", "point", "normal", "coefficients"].contains(&name) { 3 } else { 1 }
}

/// Returns the vectors of all lights that the crate exports to C.
pub(crate) fn fixed16() -> Vec<Vector> {
    let text = include_str!("../../../tests/conform/vectors.txt");
    let mut vectors = Vec::new();
    let (mut section, mut names) = ("", Vec::new());
    for line in text.lines() {
        if let Some((name, inputs)) = line.strip_prefix('[').and_then(|line| line.split_once(']')) {
            section = name.strip_suffix(" fx16").unwrap_or("");
            names = inputs.split_whitespace().filter_map(|input| input.split(':').next()).collect();
        }
        let line = line.split('#').next().unwrap_or_default();
        let Some((inputs, answer)) = line.split_once("->") else { continue };
        if answer.trim_start().starts_with("refused") {
            continue;
        }
        // A word of 16 bits is a normal's, and its sign is that of the number.
        let word = |word: &str| {
            let value = u32::from_str_radix(word, 16).expect("a word");
            if word.len() == 4 { value as u16 as i16 as u32 } else { value }
        };
        let is_light = section.starts_with("spot ") || section.starts_with("point ");
        if !is_light {
            continue;
        }
        let mut words = inputs.split_whitespace().map(word);
        let words =
            Words(names.iter().map(|name| (*name, words.by_ref().take(width(name)).collect())).collect());
        let Some(light) = words.light(section) else { continue };
        let light = light.expect("a light that is not refused");
        let place: Vec<i32> =
            [&words.0["point"], &words.0["normal"]].into_iter().flatten().map(|&w| w as i32).collect();
        let answer: Vec<u32> = answer.split_whitespace().map(word).collect();
        let answer = match answer[..] {
            [falloff, irradiance] => (irradiance, Some(falloff)),
            [irradiance] => (irradiance, None),
            _ => unreachable!("a light has one or two answers"),
        };
        vectors.push(Vector { light, place: place.try_into().expect("six words"), answer });
    }
    vectors
}
