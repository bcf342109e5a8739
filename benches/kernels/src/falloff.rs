//! The falloffs of the list, each with its exact model.

#[allow(clippy::wildcard_imports, reason = "the types of the list")]
use luminaire::falloff::*;
use luminaire::models::{SAMPLES, interpolated, power, squared};

/// A falloff of the crate `luminaire` and its exact model.
pub trait Shape: Falloff {
    /// The name on the price list.
    const NAME: &'static str;

    /// The intensity in f64 with the fewest operations: a kernel.
    fn double(t: f64) -> f64;

    /// The falloff of the list.
    fn sample() -> Self;

    /// The intensity in f64 by the formula: what kernels are compared with.
    fn exact(t: f64) -> f64 {
        Self::sample().formula().exact(t)
    }
}

macro_rules! shapes {
    ($($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr, $truth:expr;)*) => {
        $(impl Shape for $type {
            const NAME: &'static str = $name;

            #[inline(always)]
            fn double(t: f64) -> f64 {
                let truth: fn(f64) -> f64 = $truth;
                truth(t)
            }

            fn sample() -> Self {
                let sample: Result<Self, luminaire::Error> = $sample;
                sample.expect("the parameters of the list are sound")
            }
        })*
    };
}
luminaire::constant_falloffs!(shapes);

/// A power so high that rounding shows.
impl Shape for Power<16> {
    const NAME: &'static str = "power-16";

    #[inline(always)]
    fn double(t: f64) -> f64 {
        squared(squared(squared(squared(t))))
    }

    fn sample() -> Self {
        Self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_forms<P: Shape>() {
        for i in 0..=1000 {
            let t = f64::from(i) / 1000.0;
            let (exact, double) = (P::exact(t), P::double(t));
            assert!((exact - double).abs() < 1e-15, "{} at {t}: {exact} and {double}", P::NAME);
        }
        assert_eq!((P::double(0.0), P::double(1.0)), (0.0, 1.0), "{}", P::NAME);
    }

    #[test]
    fn both_forms_are_one_function_with_its_ends_in_place() {
        macro_rules! rows {
            ($($(#[$doc:meta])* $variant:ident($type:ty) = $name:literal, $sample:expr, $truth:expr;)*) => {
                $(assert_forms::<$type>();)*
            };
        }
        luminaire::constant_falloffs!(rows);
        assert_forms::<Power<16>>();
    }
}
