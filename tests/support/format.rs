//! Exact conversions of a number format: the values in f64 that its stored values represent.

use luminaire::{Fx16, Fx32, Scalar, Vec3, falloff::Falloff, light::CompiledCone};
use luminaire_oracle::DVec3;

/// A format whose values convert exactly to f64, and whose versines can be built from f64.
pub trait Format: Scalar {
    fn exact(self) -> f64;
    fn exact_length(length: Self::Length) -> f64;
    fn exact_unit(unit: Self::Unit) -> f64;
    fn exact_light(light: Self::Irradiance) -> f64;
    /// The exact value of a versine in the scale of a cone. The scale follows from the versine that
    /// the cone stores for 2^-28.
    fn exact_versine<P: Falloff>(falloff: &CompiledCone<Self, P>, versine: Self::Versine) -> f64;
    /// The nearest length. `Scalar::length` takes an f32, which has 24 bits.
    fn nearest_length(value: f64) -> Self::Length;
    /// The scalar, length, unit and versine with these bits, truncated to the width of the format.
    fn scalar_from_bits(bits: u64) -> Self;
    fn length_from_bits(bits: u64) -> Self::Length;
    fn versine_from_bits(bits: u64) -> Self::Versine;
    fn unit_from_bits(bits: u64) -> Self::Unit;

    fn exact_point(point: Vec3<Self::Length>) -> DVec3 {
        double(point.map(Self::exact_length))
    }

    fn exact_direction(direction: Vec3<Self::Unit>) -> DVec3 {
        double(direction.map(Self::exact_unit))
    }

    fn exact_normal(normal: Vec3<Self>) -> DVec3 {
        double(normal.map(Self::exact))
    }
}

fn double(v: Vec3<f64>) -> DVec3 {
    DVec3::new(v.x, v.y, v.z)
}

impl Format for f32 {
    fn exact(self) -> f64 {
        f64::from(self)
    }

    fn exact_length(length: f32) -> f64 {
        f64::from(length)
    }

    fn exact_unit(unit: f32) -> f64 {
        f64::from(unit)
    }

    fn exact_light(light: f32) -> f64 {
        f64::from(light)
    }

    fn exact_versine<P: Falloff>(_: &CompiledCone<f32, P>, versine: f32) -> f64 {
        f64::from(versine)
    }

    fn nearest_length(value: f64) -> f32 {
        value as f32
    }

    fn scalar_from_bits(bits: u64) -> f32 {
        f32::from_bits(bits as u32)
    }

    fn length_from_bits(bits: u64) -> f32 {
        f32::from_bits(bits as u32)
    }

    fn versine_from_bits(bits: u64) -> f32 {
        f32::from_bits(bits as u32)
    }

    fn unit_from_bits(bits: u64) -> f32 {
        f32::from_bits(bits as u32)
    }
}

macro_rules! fixed_format {
    ($format:ty, $scalar:ty, $length:ty, $versine:ty) => {
        impl Format for $format {
            // The exhaustive tests call this for every input, and it is faster than `to_num`.
            fn exact(self) -> f64 {
                f64::from(self.to_bits()) * f64::from(Self::STEP)
            }

            fn exact_length(length: Self::Length) -> f64 {
                length.to_f64()
            }

            fn exact_unit(unit: Self::Unit) -> f64 {
                unit.to_f64()
            }

            fn exact_light(light: Self::Irradiance) -> f64 {
                light.to_f64()
            }

            fn exact_versine<P: Falloff>(falloff: &CompiledCone<Self, P>, versine: Self::Versine) -> f64 {
                let unit: f64 = falloff.versine(0.5_f32.powi(28)).to_f64();
                versine.to_f64() * 0.5_f64.powi(28) / unit
            }

            fn nearest_length(value: f64) -> Self::Length {
                Self::Length::from_bits((value * 65_536.0).round() as $length)
            }

            fn scalar_from_bits(bits: u64) -> Self {
                Self::from_bits(bits as $scalar)
            }

            fn length_from_bits(bits: u64) -> Self::Length {
                Self::Length::from_bits(bits as $length)
            }

            fn versine_from_bits(bits: u64) -> Self::Versine {
                Self::Versine::from_bits(bits as $versine)
            }

            fn unit_from_bits(bits: u64) -> Self::Unit {
                Self::Unit::from_bits(bits as i32)
            }
        }
    };
}

fixed_format!(Fx16, i16, i32, u32);
fixed_format!(Fx32, i32, i32, u32);
