//! The colours of white light.

use super::Rgb;
use crate::error::{Error, Parameter, check_between};

/// The parts of red, green and blue in the luminance of linear sRGB (ITU-R BT.709).
const LUMINANCE: Rgb<f32> = Rgb::new(0.2126, 0.7152, 0.0722);

impl Rgb<f32> {
    /// Returns white light of a correlated colour temperature in kelvin, in [1000, 25,000], in linear sRGB: the
    /// number on a lamp or in its data sheet.
    ///
    /// The luminance is 1, so that a channel may exceed 1; a light's
    /// [`with_kelvin`](crate::SpotLight::with_kelvin) has the strongest one in its intensity. Under 1,900 K the
    /// colour is outside sRGB, and blue is 0.
    ///
    /// Up to 4,000 K it is the light of a [black body](Self::black_body), and from 5,000 K on daylight as CIE 15
    /// has it, for which 6,504 K is white. Between the two it is their mixture in proportion, as in ANSI/IES TM-30.
    /// From the chromaticities that CIE tabulates, or that its observer of 1931 sees of Planck's law, it differs by up
    /// to 0.22 linear codes of the strongest channel (found at 16 temperatures).
    ///
    /// # Errors
    /// A temperature outside [1000, 25,000].
    pub fn from_kelvin(kelvin: f32) -> Result<Self, Error> {
        check_between(Parameter::ColorTemperature, kelvin, 1e3, 25e3)?;
        let warm = visible(black_body(kelvin.min(5e3)));
        let cool = visible(daylight(kelvin.max(4e3)));
        let share = ((kelvin - 4e3) / 1e3).clamp(0.0, 1.0);
        Ok(warm.zip(cool, |warm, cool| warm + (cool - warm) * share))
    }

    /// Returns the light of a black body of a temperature in kelvin, in [1000, 15,000], in linear sRGB of
    /// luminance 1: the white of Blender, Godot, Unreal Engine and pbrt. Above 5,000 K data sheets mean
    /// [daylight](Self::from_kelvin), which is greener.
    ///
    /// M. Krystek, *An algorithm to calculate correlated colour temperature*, Color Research & Application 10
    /// (1985). From Planck's law as CIE's observer of 1931 sees it, it differs by up to 0.43 linear codes of the
    /// strongest channel (found at 14 temperatures).
    ///
    /// # Errors
    /// A temperature outside [1000, 15,000].
    pub fn black_body(kelvin: f32) -> Result<Self, Error> {
        check_between(Parameter::ColorTemperature, kelvin, 1e3, 15e3)?;
        Ok(visible(black_body(kelvin)))
    }

    /// Returns the colour of a CIE 1931 chromaticity in linear sRGB of luminance 1, as a gel or an emitter of a stage light is
    /// published: `x` in [0, 1], and `y` in [0.001, 1].
    ///
    /// What is outside of sRGB is at its border, with the channels that would be negative at 0. The chromaticity of white
    /// is that of D65: 0.3127, 0.3290.
    ///
    /// # Errors
    /// An `x` or a `y` outside its range.
    pub fn from_chromaticity(x: f32, y: f32) -> Result<Self, Error> {
        check_between(Parameter::Chromaticity, x, 0.0, 1.0)?;
        check_between(Parameter::Chromaticity, y, 1e-3, 1.0)?;
        Ok(visible([x, y]))
    }

    /// Returns the luminance of a linear colour; that of white is 1.
    pub fn luminance(self) -> f32 {
        let Rgb { red, green, blue } = self.zip(LUMINANCE, |channel, part| channel * part);
        red + green + blue
    }

    /// Returns the strongest channel.
    pub fn strongest(self) -> f32 {
        self.red.max(self.green).max(self.blue)
    }
}

/// Returns the chromaticity x and y of a black body: Krystek's u and v in the diagram of 1960.
fn black_body(kelvin: f32) -> [f32; 2] {
    let ratio = |[a, b, c]: [f32; 3], [d, e]: [f32; 2]| {
        (a + kelvin * (b + kelvin * c)) / (1.0 + kelvin * (d + kelvin * e))
    };
    let u = ratio([0.860_117_76, 1.541_182_5e-4, 1.286_412e-7], [8.424_202_4e-4, 7.081_451_6e-7]);
    let v = ratio([0.317_398_73, 4.228_062_5e-5, 4.204_816_9e-8], [-2.897_418_2e-5, 1.614_560_5e-7]);
    let whole = 2.0 * u - 8.0 * v + 4.0;
    [3.0 * u / whole, 2.0 * v / whole]
}

/// Returns the chromaticity x and y of daylight (CIE 15, 4.1.2).
fn daylight(kelvin: f32) -> [f32; 2] {
    let mired = 1e3 / kelvin;
    let [a, b, c, d] = if kelvin <= 7e3 {
        [0.244_063, 0.099_11, 2.967_8, -4.607]
    } else {
        [0.237_04, 0.247_48, 1.901_8, -2.006_4]
    };
    let x = a + mired * (b + mired * (c + mired * d));
    [x, x * (2.87 - 3.0 * x) - 0.275]
}

/// Returns the colour of a chromaticity in linear sRGB (IEC 61966-2-1) of luminance 1, with what is outside of sRGB
/// at its border.
fn visible([x, y]: [f32; 2]) -> Rgb<f32> {
    let [x, z] = [x / y, (1.0 - x - y) / y];
    let color = Rgb::new(
        3.240_454_2 * x - 1.537_138_5 - 0.498_531_4 * z,
        1.876_010_8 - 0.969_266 * x + 0.041_556 * z,
        0.055_643_4 * x - 0.204_025_9 + 1.057_225_2 * z,
    );
    let color = color.map(|channel| channel.max(0.0));
    let luminance = color.luminance();
    color.map(|channel| channel / luminance)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Planck's law seen by CIE's observer of 1931, and the daylights D50, D55, D65 and D75 of CIE 15: kelvin, x, y.
    const BLACK_BODIES: [[f32; 3]; 14] = [
        [1000.0, 0.652_75, 0.344_46],
        [1200.0, 0.625_05, 0.367_45],
        [1500.0, 0.585_72, 0.393_12],
        [1900.0, 0.537_78, 0.411_20],
        [2000.0, 0.526_68, 0.413_30],
        [2500.0, 0.477_00, 0.413_68],
        [2700.0, 0.459_86, 0.410_60],
        [2856.0, 0.447_54, 0.407_43],
        [3500.0, 0.405_31, 0.390_72],
        [4000.0, 0.380_44, 0.376_75],
        [5000.0, 0.345_10, 0.351_61],
        [6500.0, 0.313_53, 0.323_63],
        [10_000.0, 0.280_63, 0.288_29],
        [15_000.0, 0.263_71, 0.267_28],
    ];
    const DAYLIGHTS: [[f32; 3]; 6] = [
        [5002.8, 0.345_67, 0.358_51],
        [5502.9, 0.332_43, 0.347_44],
        [6503.6, 0.312_72, 0.329_03],
        [7503.5, 0.299_03, 0.314_88],
        [10_000.0, 0.278_77, 0.291_86],
        [25_000.0, 0.249_81, 0.254_72],
    ];

    /// Returns the largest difference in linear codes of the strongest channel.
    fn codes(color: fn(f32) -> Result<Rgb<f32>, Error>, whites: &[[f32; 3]]) -> f32 {
        let difference = |&[kelvin, x, y]: &[f32; 3]| {
            let (found, expected) = (color(kelvin).unwrap(), visible([x, y]));
            let apart = found.zip(expected, |found, expected| (found - expected).abs()).strongest();
            255.0 * apart / expected.strongest()
        };
        whites.iter().map(difference).fold(0.0, f32::max)
    }

    /// The primaries of sRGB and its white (IEC 61966-2-1), and what is outside of it.
    #[test]
    fn chromaticities_are_those_of_srgb() {
        for (place, expected) in [
            ([0.64, 0.33], [1.0 / 0.2126, 0.0, 0.0]),
            ([0.3, 0.6], [0.0, 1.0 / 0.7152, 0.0]),
            ([0.15, 0.06], [0.0, 0.0, 1.0 / 0.0722]),
            ([0.312_7, 0.329], [1.0; 3]),
            ([0.0, 1.0], [0.0, 1.0 / 0.7152, 0.0]),
        ] {
            let found = <[f32; 3]>::from(Rgb::from_chromaticity(place[0], place[1]).unwrap());
            let strongest = expected.iter().copied().fold(0.0, f32::max);
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-3 * strongest, "{place:?}: {found} of {expected}");
            }
        }
        for [x, y] in [[-0.1, 0.3], [0.3, 0.0], [0.3, 1.1], [f32::NAN, 0.3], [0.3, f32::NAN]] {
            assert_eq!(Rgb::from_chromaticity(x, y).unwrap_err().parameter, Parameter::Chromaticity);
        }
    }

    #[test]
    fn whites_are_those_of_the_standards() {
        let warm = codes(Rgb::from_kelvin, &BLACK_BODIES[..10]);
        let white = warm.max(codes(Rgb::from_kelvin, &DAYLIGHTS));
        let found =
            [white, codes(Rgb::black_body, &BLACK_BODIES)].map(|codes| (100.0 * codes).round() / 100.0);
        assert_eq!(found, [0.22, 0.43]);
        let white = Rgb::from_kelvin(6504.0).unwrap().map(|channel| (255.0 * channel).round());
        assert_eq!(white, Rgb::new(255.0, 255.0, 255.0));
    }

    /// Halfway between both, half of each; and where one begins, there is no step.
    #[test]
    fn whites_between_black_bodies_and_daylight_are_their_mixture() {
        let near = |a: Rgb<f32>, b: Rgb<f32>| a.zip(b, |a, b| (a - b).abs()).strongest() < 1e-5;
        let half = visible(black_body(4500.0)).zip(visible(daylight(4500.0)), |a, b| (a + b) / 2.0);
        assert!(near(Rgb::from_kelvin(4500.0).unwrap(), half));
        assert!(near(Rgb::from_kelvin(5000.0).unwrap(), visible(daylight(5000.0))));
    }

    #[test]
    fn whites_have_luminance_1_in_the_whole_range() {
        for kelvin in (1_000..=25_000_u16).step_by(7).chain([25_000]).map(f32::from) {
            let colors = [Rgb::from_kelvin(kelvin).ok(), Rgb::black_body(kelvin).ok()];
            for color in colors.into_iter().flatten() {
                assert!((color.luminance() - 1.0).abs() < 1e-6, "{kelvin} K: {color:?}");
                assert!(color.red > 0.0 && color.green > 0.0 && color.blue >= 0.0, "{kelvin} K: {color:?}");
            }
        }
        for kelvin in [999.9, 25_001.0, f32::NAN, f32::INFINITY] {
            assert!(Rgb::from_kelvin(kelvin).is_err() && Rgb::black_body(kelvin).is_err(), "{kelvin}");
        }
        assert!(Rgb::black_body(15_001.0).is_err());
    }
}
