//! Tests of the exact models of the falloffs of the list.

use luminaire::falloff::ListedFalloff;

/// Returns the intensity in f64 by the formula of the sample: what kernels are compared with.
pub(crate) fn exact<P: ListedFalloff>(t: f64) -> f64 {
    sample::<P>().formula().exact(t)
}

/// Returns the falloff of the list.
pub(crate) fn sample<P: ListedFalloff>() -> P {
    P::sample().expect("the parameters of the list are sound")
}

#[cfg(test)]
mod tests {
    use luminaire::falloff::{FalloffVisitor, Power, constant_falloffs};

    use super::*;

    struct AssertForms;

    impl FalloffVisitor for AssertForms {
        fn falloff<P: ListedFalloff>(&mut self) {
            for i in 0..=1000 {
                let t = f64::from(i) / 1000.0;
                let (exact, double) = (exact::<P>(t), P::truth(t));
                assert!((exact - double).abs() < 1e-15, "{} at {t}: {exact} and {double}", P::NAME);
            }
            assert_eq!((P::truth(0.0), P::truth(1.0)), (0.0, 1.0), "{}", P::NAME);
        }
    }

    #[test]
    fn both_forms_are_one_function_with_its_ends_in_place() {
        constant_falloffs(&mut AssertForms);
        AssertForms.falloff::<Power<16>>();
    }
}
