//! `serde` serialisation of lights, cones, vectors, colours, angles and numbers.
//!
//! | type | serialised as |
//! |---|---|
//! | [`Cone`](crate::Cone) | its falloff, and the versines `1 - cos` of half its `inner` angle, of half the `outer` angle at which the falloff ends, and of half the angle from which on there is no light, its `limit` |
//! | [`SpotLight`](crate::SpotLight), [`PointLight`](crate::PointLight), [`DirectionalLight`](crate::DirectionalLight), [`AmbientLight`](crate::AmbientLight) | their properties; an axis as a vector of any length |
//! | falloffs and attenuations | the parameters of their constructors |
//! | [`AnyLight`](crate::dynamic::AnyLight), [`AnyFalloff`](crate::falloff::AnyFalloff), [`AnyAttenuation`](crate::attenuation::AnyAttenuation) | the variant and its value |
//! | [`Vec3`] | an array of three: x, y, z |
//! | [`Rgb`] | an array of three: red, green, blue |
//! | [`Rgb565`] | its 16 bits, as one integer |
//! | [`Angle`], [`HalfAngle`] | degrees: the full angle, the half angle |
//! | fixed-point numbers | their bits, as one integer: exact |
//!
//! A light or a cone that is read back compiles to the same bits. Its parameters are checked as by
//! its constructors: the data format returns their [`Error`](crate::Error) as its own. A cone is
//! stored as versines because not every versine has an angle in f32: if people write the file, let
//! it hold [`Angle`]s, and call the constructor of [`Cone`](crate::Cone). A [`Table`] borrows its
//! samples, so it can be neither written nor read: store the samples.
//!
//! The other types accept every value of their serialised form but numbers that are not finite: an
//! angle, a component or a channel that is infinite or NaN is neither written nor read, because text
//! formats have no such numbers.
//!
//! ```
//! use luminaire::{Angle, Cone, SpotLight, falloff::Soft};
//! let spot = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], Cone::soft(Angle::degrees(36.0))?)?;
//! let text = serde_json::to_string(&spot)?;
//! assert_eq!(serde_json::from_str::<SpotLight<Soft>>(&text)?, spot);
//!
//! let refused = serde_json::from_str::<SpotLight<Soft>>(&text.replace("1.0}", "-1.0}")).unwrap_err();
//! assert!(refused.to_string().starts_with("intensity = -1: expected a finite number from 0"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(feature = "fixed")]
use crate::number::{Fx16, Fx32, Length, Light16, Light32, Versine, Weight16, Weight32};
use crate::{
    angle::{Angle, HalfAngle},
    color::Rgb,
    display::Rgb565,
    falloff::Table,
    vec3::Vec3,
};
use core::{any::Any, fmt};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de, ser};

/// The error of a table.
const TABLE: &str = "falloff = a table: expected a falloff without borrowed samples; store the samples";

impl Serialize for Table<'_> {
    fn serialize<S: Serializer>(&self, _: S) -> Result<S::Ok, S::Error> {
        Err(ser::Error::custom(TABLE))
    }
}

impl<'de> Deserialize<'de> for Table<'_> {
    fn deserialize<D: Deserializer<'de>>(_: D) -> Result<Self, D::Error> {
        Err(de::Error::custom(TABLE))
    }
}

/// A number that is not finite, and its name: the error of what is written and of what is read.
struct NotFinite(&'static str, f64);

impl fmt::Display for NotFinite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}: expected a finite number", self.0, self.1)
    }
}

/// Returns an error for a float that is not finite; JSON reads 1e39 as infinity, which it writes as
/// `null`. Values of other types are accepted.
fn check_finite<T: Any>(name: &'static str, value: &T) -> Result<(), NotFinite> {
    let value: &dyn Any = value;
    let single = value.downcast_ref().map(|&single: &f32| single.into());
    match single.or(value.downcast_ref().copied()) {
        Some(number) if !f64::is_finite(number) => Err(NotFinite(name, number)),
        _ => Ok(()),
    }
}

/// Implements serialisation of three components as an array.
macro_rules! array {
    ($($name:ident($($component:ident),*))*) => {$(
        impl<T: Any> $name<T> {
            fn check_finite(&self) -> Result<(), NotFinite> {
                $(check_finite(stringify!($component), &self.$component)?;)*
                Ok(())
            }
        }

        impl<T: Serialize + Any> Serialize for $name<T> {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                self.check_finite().map_err(ser::Error::custom)?;
                [$(&self.$component),*].serialize(serializer)
            }
        }

        impl<'de, T: Deserialize<'de> + Any> Deserialize<'de> for $name<T> {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let read = <[T; 3]>::deserialize(deserializer).map(Self::from)?;
                read.check_finite().map_err(de::Error::custom)?;
                Ok(read)
            }
        }
    )*};
}

array!(Vec3(x, y, z) Rgb(red, green, blue));

/// Implements serialisation of a type as another type, under a name for errors.
macro_rules! written_as {
    ($($name:ident($as:ty, $from:expr, $to:expr, $words:literal))*) => {$(
        impl Serialize for $name {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                let written = $to(*self);
                check_finite($words, &written).map_err(ser::Error::custom)?;
                written.serialize(serializer)
            }
        }

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let read = <$as>::deserialize(deserializer)?;
                check_finite($words, &read).map_err(de::Error::custom)?;
                Ok($from(read))
            }
        }
    )*};
}

written_as! {
    Rgb565(u16, Self, u16::from, "pixel")
    Angle(f32, Self::degrees, Self::to_degrees, "angle")
    HalfAngle(f32, Self::degrees, Self::to_degrees, "half angle")
}

/// Implements serialisation of numbers as the integers that store them.
#[cfg(feature = "fixed")]
macro_rules! bits {
    ($($number:ident($bits:ty))*) => {
        written_as!($($number($bits, Self::from_bits, Self::to_bits, "bits"))*);
    };
}

#[cfg(feature = "fixed")]
for_numbers!(bits);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        attenuation::{
            AnyAttenuation, CutAt, Decay, GltfRange, InverseSquare, NoAttenuation, Polynomial, SmoothRange,
            Windowed,
        },
        cone::Cone,
        dynamic::AnyLight,
        falloff::{AnyFalloff, Falloff, IntegerPower, InvertedRealPower, Power, Quadratic, Soft, SoftOrHard},
        light::{
            AmbientLight, DirectionalLight, Distribution, MeasuredLight, PointLight, SpotLight, Symmetry,
        },
    };
    use core::fmt::Debug;
    use serde::de::value::F32Deserializer;
    use serde_json::{from_str, to_string};

    extern crate std;
    use std::string::ToString;

    /// Checks that a value is serialised as this text, and that this text is read back as the
    /// value.
    fn there_and_back<T: Serialize + for<'de> Deserialize<'de> + PartialEq + Debug>(value: T, text: &str) {
        assert_eq!(to_string(&value).unwrap(), text);
        assert_eq!(from_str::<T>(text).unwrap(), value);
    }

    fn refusal<T: for<'de> Deserialize<'de> + Debug>(text: &str) -> std::string::String {
        from_str::<T>(text).unwrap_err().to_string()
    }

    #[test]
    fn vectors_and_colours_are_arrays() {
        there_and_back(Vec3::new(1.0, -2.5, 0.1_f32), "[1.0,-2.5,0.1]");
        there_and_back(Rgb::new(255_u8, 128, 0), "[255,128,0]");
    }

    #[test]
    fn angles_are_degrees_full_or_half() {
        there_and_back(Angle::degrees(36.5), "36.5");
        there_and_back(HalfAngle::degrees(36.5), "36.5");
        // The constructors accept any angle; the cones reject invalid ones.
        there_and_back(Angle::degrees(-1.0), "-1.0");
    }

    #[test]
    fn pixels_are_sixteen_bits() {
        there_and_back(Rgb565(0xf81f), "63519");
    }

    #[cfg(feature = "fixed")]
    #[test]
    fn numbers_are_their_bits() {
        there_and_back(Fx16::ONE, "16384");
        there_and_back(Fx16::point([1.0, -2.0, 0.5]), "[65536,-131072,32768]");
        macro_rules! check {
            ($($number:ident($bits:ty))*) => {$(
                for bits in [0, 1, <$bits>::MIN, <$bits>::MAX] {
                    there_and_back($number::from_bits(bits), &bits.to_string());
                }
            )*};
        }
        for_numbers!(check);
    }

    /// A spotlight with no two equal properties.
    fn spot<P: Falloff>(falloff: P) -> SpotLight<P, AnyAttenuation> {
        let cone = Cone::from_outer(falloff, Angle::degrees(70.0)).unwrap();
        let cone = cone.with_inner(Angle::degrees(10.0)).unwrap().with_cutoff(Angle::degrees(50.0)).unwrap();
        let spot = SpotLight::new([1.0, 4.0, 0.1], [0.3, -0.7, 0.11], cone).unwrap();
        let spot = spot.with_color(Rgb::new(0.1, 0.2, 0.3)).unwrap().with_intensity(7.3).unwrap();
        spot.with_specular_color(Rgb::new(0.4, 0.5, 0.6)).unwrap().with_attenuation(InverseSquare.into())
    }

    fn read_back<T: Serialize + for<'de> Deserialize<'de> + PartialEq + Debug>(value: T) {
        let text = to_string(&value).unwrap();
        assert_eq!(from_str::<T>(&text).unwrap(), value, "{text}");
    }

    #[test]
    fn lights_of_all_falloffs_and_attenuations_are_read_back() {
        for falloff in AnyFalloff::samples() {
            if let AnyFalloff::Table(_) = falloff {
                assert_eq!(to_string(&spot(falloff)).unwrap_err().to_string(), TABLE);
                assert!(refusal::<AnyFalloff>(r#"{"Table":[1]}"#).starts_with(TABLE));
                continue;
            }
            read_back(AnyLight::from(spot(falloff)));
        }
        let distribution = Distribution::from_parts(&[1, 2, 3, 4], 3, Symmetry::Quadrant);
        let measured = MeasuredLight::new([0.0; 3], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0], distribution);
        let text = to_string(&AnyLight::from(measured.unwrap())).unwrap_err().to_string();
        assert!(text.starts_with("distribution = borrowed samples: "), "{text}");
        assert!(refusal::<AnyLight>(r#"{"Measured":[1]}"#).starts_with(&text));
        let [some, none] = [Some(9.3), None];
        let polynomial = Polynomial::new(0.1, 0.2, 0.3).unwrap();
        let decay = Decay::new(1.7, 100.0).unwrap();
        let attenuations: [AnyAttenuation; 6] = [
            CutAt::new(InverseSquare, none).unwrap().into(),
            CutAt::new(polynomial, some).unwrap().into(),
            GltfRange::new(InverseSquare, some).unwrap().into(),
            Windowed::new(NoAttenuation, some).unwrap().into(),
            Windowed::new(decay, some).unwrap().into(),
            SmoothRange::new(9.3).unwrap().into(),
        ];
        for attenuation in attenuations {
            read_back(spot(Soft).with_attenuation(attenuation));
            let point = PointLight::new([0.1, 0.2, 0.3]).unwrap().with_intensity(3.3).unwrap();
            read_back(AnyLight::from(point.with_attenuation(attenuation)));
        }
        read_back(DirectionalLight::new([0.1, -0.7, 0.3]).unwrap());
        read_back(AmbientLight::new(Rgb::new(0.1, 0.2, 0.3)).unwrap().with_intensity(0.3).unwrap());
        read_back(spot(Power::<16>));
        read_back(spot(SoftOrHard::Hard));
        read_back(Cone::from_beam_and_field(Angle::degrees(10.0), Angle::degrees(17.0)).unwrap());
        read_back(InvertedRealPower::with_floor(2.5, 1.0 / 128.0).expect("a floor"));
    }

    #[test]
    fn a_cone_is_its_versines() {
        let text = r#"{"falloff":{"edge_slope":0.5},"inner":0.125,"outer":0.5,"limit":0.25}"#;
        let cone: Cone<Quadratic> = from_str(text).unwrap();
        assert_eq!(to_string(&cone).unwrap(), text);
        assert!((cone.outer().to_degrees() - 82.82).abs() < 0.01, "{cone:?}");
    }

    #[test]
    fn what_a_constructor_refuses_is_refused() {
        let cone = |inner: f32, outer: f32, limit: f32| {
            let text = std::format!(r#"{{"falloff":null,"inner":{inner},"outer":{outer},"limit":{limit}}}"#);
            from_str::<Cone<Soft>>(&text).map_or_else(|error| error.to_string(), |_| "read".to_string())
        };
        assert_eq!(cone(0.5, 0.5, 0.25), "read");
        assert!(cone(0.0, 1.5, 0.5).starts_with("versine = 1.5: expected a finite number from 0"));
        assert!(cone(0.6, 0.5, 0.5).starts_with("versine = 0.6: expected a finite number from 0 to 0.5"));
        assert!(cone(-0.1, 0.5, 0.5).starts_with("versine = -0.1: "));
        assert!(cone(0.0, 0.5, 0.6).starts_with("versine = 0.6: "));
        assert!(cone(0.0, 0.5, 0.0).starts_with("versine = 0: "));
        assert!(refusal::<Quadratic>(r#"{"edge_slope":2.5}"#).starts_with("edge slope = 2.5: expected"));
        assert!(refusal::<IntegerPower>(r#"{"exponent":0}"#).starts_with("exponent = 0: expected"));
        assert!(refusal::<Decay>(r#"{"exponent":17.0,"most":1.0}"#).starts_with("decay = 17: expected"));
        let steep = r#"{"exponent":0.5,"floor":0.9}"#;
        assert!(refusal::<InvertedRealPower>(steep).starts_with("floor = 0.9: expected"));
        let range = r#"{"attenuation":null,"range":0.0}"#;
        assert!(refusal::<GltfRange>(range).starts_with("range = 0: expected a distance from 0.001"));
        assert!(refusal::<SmoothRange>(r#"{"range":9.0,"end":1}"#).starts_with("unknown field `end`"));

        let lit = to_string(&spot(Soft)).unwrap();
        let refused = |old: &str, new: &str| {
            assert!(lit.contains(old), "{old} is not in {lit}");
            refusal::<SpotLight<Soft, AnyAttenuation>>(&lit.replacen(old, new, 1))
        };
        assert!(refused("7.3", "-7.3").starts_with("intensity = -7.3: expected"));
        assert!(refused("[1.0,4.0,", "[1e39,4.0,").contains("expected"));
        assert!(refused("0.5,0.6]", "0.5,1.6]").starts_with("color = 1.6: expected"));
        let direction = r#"{"direction":[0.0,0.0,0.0],"emission":null}"#;
        assert!(refusal::<DirectionalLight>(direction).starts_with("axis = 0: expected"));
        let bright = r#"{"color":[1.0,1.0,1.0],"intensity":1e10}"#;
        assert!(refusal::<AmbientLight>(bright).starts_with("intensity = 10000000000: expected"));
    }

    /// JSON, and a format that holds the bits of any float: a value is read back to the bit, or refused
    /// in words both when it is written and when it is read.
    #[test]
    fn floats_are_read_back_or_refused() {
        let mut rng = fastrand::Rng::with_seed(38);
        let hostile = [f32::NAN, f32::INFINITY, -f32::INFINITY, f32::MAX, f32::MIN, 1e-45, -1e-39, -0.0];
        let drawn: std::vec::Vec<_> = (0..10_000).map(|_| f32::from_bits(rng.u32(..))).collect();
        for number in hostile.into_iter().chain(drawn) {
            type Bits = F32Deserializer<de::value::Error>;
            let bits = |angle: Angle| angle.to_degrees().to_bits();
            let read = Angle::deserialize(Bits::new(number)).map_err(|error| error.to_string());
            let written = to_string(&Angle::degrees(number)).map_err(|error| error.to_string());
            let way = to_string(&Vec3::new(0.5, number, 2.0)).map_err(|error| error.to_string());
            if !number.is_finite() {
                let refused = |name: &str| std::format!("{name} = {number}: expected a finite number");
                assert_eq!((read, written), (Err(refused("angle")), Err(refused("angle"))));
                assert_eq!(way, Err(refused("y")));
                continue;
            }
            let from_text = from_str::<Angle>(&written.unwrap()).unwrap();
            assert_eq!([bits(read.unwrap()), bits(from_text)], [number.to_bits(); 2]);
            let way: Vec3<f32> = from_str(&way.unwrap()).unwrap();
            assert_eq!(way.y.to_bits(), number.to_bits());
        }
        assert!(refusal::<Angle>("1e39").starts_with("angle = inf: expected a finite number"));
        assert!(refusal::<HalfAngle>("-1e39").starts_with("half angle = -inf: expected"));
        assert!(refusal::<Vec3<f32>>("[0.0,-1e39,0.0]").starts_with("y = -inf: expected"));
        assert!(refusal::<Rgb<f32>>("[0.0,0.0,1e39]").starts_with("blue = inf: expected"));
    }

    /// Also an axis with components so small that they have few digits.
    #[test]
    fn an_axis_is_read_back_to_the_bit() {
        let mut rng = fastrand::Rng::with_seed(39);
        let mut tiny = 0;
        for _ in 0..20_000 {
            let [x, z] = [(); 2].map(|()| f32::from_bits(rng.u32(..) & 0x83ff_ffff));
            let axis = Vec3::new(x, f32::from_bits(rng.u32(..)), z);
            let Ok(light) = DirectionalLight::new(axis) else { continue };
            tiny += usize::from([axis.x, axis.y, axis.z].iter().any(|c| c.abs() < 1e-38));
            read_back(light);
        }
        assert!(tiny > 1_000, "{tiny} axes with a component that is not a normal number");
    }

    #[test]
    fn what_is_no_such_value_is_refused() {
        assert!(
            refusal::<Vec3<f32>>("[1.0,2.0]").contains("invalid length 2, expected an array of length 3")
        );
        assert!(refusal::<Rgb<u8>>("[1,2,3,4]").contains("trailing characters"));
        assert!(refusal::<Rgb<u8>>("[1,2,256]").contains("integer `256`, expected u8"));
        assert!(refusal::<Rgb565>("65536").contains("integer `65536`, expected u16"));
        assert!(refusal::<Angle>("null").contains("invalid type: null, expected f32"));
        #[cfg(feature = "fixed")]
        assert!(refusal::<Fx16>("32768").contains("integer `32768`, expected i16"));
        #[cfg(feature = "fixed")]
        assert!(refusal::<Fx16>("0.5").contains("floating point `0.5`, expected i16"));
    }
}
