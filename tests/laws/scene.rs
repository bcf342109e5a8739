//! Lights and surfaces made of words, or nothing where a constructor refuses.

use super::words::Words;
use luminaire::{
    Angle, Cone, HalfAngle, Material, Rgb, SpotLight, Vec3, falloff::Falloff, specular::SpecularLobe,
};

/// The samples of a table that is monotone, begins in full light and ends above the dark.
pub static SAMPLES: [u16; 6] = [65_535, 65_535, 40_000, 39_999, 1_000, 7];

/// How many profiles there are to choose from.
pub const PROFILES: u32 = 13;

/// Which of them may rise by a step of the format towards the edge: smooth, blend, cubic and table.
pub const RISING: [u32; 4] = [4, 5, 6, 12];

/// Evaluates an expression with one of the profiles there are, in a type of its own each, or refuses.
macro_rules! with_any_profile {
    ($words:expr, $profile:ident => $answer:expr) => {{
        use luminaire::falloff::{
            Cubic, Hard, InvertedPower, Linear, Power, Quadratic, Smooth, Soft, SoftOrHard, Step, Table,
        };
        let words: &mut Words<'_> = $words;
        match words.choice($crate::laws::scene::PROFILES) {
            0 => {
                let $profile = Soft;
                $answer
            }
            1 => {
                let $profile = Hard;
                $answer
            }
            2 => {
                let $profile = Linear;
                $answer
            }
            3 => {
                let $profile = Step;
                $answer
            }
            4 => {
                let $profile = Smooth;
                $answer
            }
            5 => {
                let $profile = Quadratic::new(words.number(0.0, 2.0)).ok()?;
                $answer
            }
            6 => {
                let $profile = Cubic::with_slopes(words.number(0.0, 4.0), words.number(0.0, 4.0)).ok()?;
                $answer
            }
            7 => {
                let $profile = Power::<4>;
                $answer
            }
            8 => {
                let $profile = Power::<15>;
                $answer
            }
            9 => {
                let $profile = Power::<128>;
                $answer
            }
            10 => {
                let $profile = InvertedPower::<7>;
                $answer
            }
            11 => {
                let $profile = SoftOrHard::Soft;
                $answer
            }
            _ => {
                let $profile = Table::new(&$crate::laws::scene::SAMPLES).ok()?;
                $answer
            }
        }
    }};
}
pub(crate) use with_any_profile;

/// Evaluates an expression with one of the distance models there are, in a type of its own each, or refuses.
macro_rules! with_any_distance {
    ($words:expr, $model:ident => $answer:expr) => {{
        use luminaire::attenuation::{
            CutAt, FilamentRange, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
        };
        let words: &mut Words<'_> = $words;
        let range = |words: &mut Words<'_>| words.number(0.001, 40.0);
        match words.choice(9) {
            0 => {
                let $model = NoAttenuation;
                $answer
            }
            1 => {
                let $model = InverseSquare;
                $answer
            }
            2 => {
                let c = words.numbers(0.0, 4.0);
                let $model = Polynomial::new(c.x, c.y, c.z).ok()?;
                $answer
            }
            3 => {
                let $model = SmoothRange::new(range(words)).ok()?;
                $answer
            }
            4 => {
                let $model = GltfRange::new(InverseSquare, Some(range(words))).ok()?;
                $answer
            }
            5 => {
                let $model = GltfRange::new(InverseSquare, None).ok()?;
                $answer
            }
            6 => {
                let $model = FilamentRange::new(InverseSquare, Some(range(words))).ok()?;
                $answer
            }
            7 => {
                let $model = CutAt::new(InverseSquare, Some(range(words))).ok()?;
                $answer
            }
            _ => {
                let inner = SmoothRange::new(range(words)).ok()?;
                let $model = CutAt::new(inner, Some(range(words))).ok()?;
                $answer
            }
        }
    }};
}
pub(crate) use with_any_distance;

/// Evaluates an expression with one of the highlights there are, in a type of its own each.
macro_rules! with_any_highlight {
    ($words:expr, $highlight:ident => $answer:expr) => {{
        use luminaire::specular::{BlinnPhong, DifferenceForm, DualConeLobe, NoSpecular, Phong};
        match $words.choice(7) {
            0 => {
                let $highlight = NoSpecular;
                $answer
            }
            1 => {
                let $highlight = Phong;
                $answer
            }
            2 => {
                let $highlight = BlinnPhong;
                $answer
            }
            3 => {
                let $highlight = DualConeLobe;
                $answer
            }
            4 => {
                let $highlight = DifferenceForm::<_, 2>(Phong);
                $answer
            }
            5 => {
                let $highlight = DifferenceForm::<_, 3>(BlinnPhong);
                $answer
            }
            _ => {
                let $highlight = DifferenceForm::<_, 4>(DualConeLobe);
                $answer
            }
        }
    }};
}
pub(crate) use with_any_highlight;

/// A cone by one of its angles, with or without a hotspot and a delimiter.
pub fn cone<P: Falloff>(words: &mut Words<'_>, profile: P) -> Option<Cone<P>> {
    let design = [Cone::from_outer, Cone::from_field, Cone::from_beam][words.choice(3) as usize];
    // Evenly spread over the logarithm: narrow cones are the hard ones.
    let angle = words.number(-16.0, 7.5);
    let mut cone = design(profile, Angle::degrees(angle.exp2())).ok()?;
    let outer = cone.outer().to_degrees();
    if words.choice(4) == 0 {
        cone = cone.with_inner(Angle::degrees(words.number(0.0, outer))).ok()?;
    }
    if words.choice(4) == 0 {
        cone = cone.with_cutoff(Angle::degrees(words.number(0.0, outer))).ok()?;
    }
    Some(cone)
}

/// A spotlight that is aimed about at a place.
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
    let matt = Material::new(color(words)).ok()?.with_ambient(color(words)).ok()?;
    matt.with_emissive(color(words)).ok()?.with_highlight(highlight, color(words), shininess).ok()
}
