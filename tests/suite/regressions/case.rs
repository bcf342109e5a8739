//! Shared helpers: a cone that is tested in every format.

use luminaire::{Angle, Cone, Fx16, Fx32, HalfAngle, falloff::Falloff};
use std::ops::RangeInclusive;
use support::assert_that;
use support::{bounds, format::Format, oracle, sweep};

/// A cone between two half angles in degrees, and the row of the table of bounds that its falloff
/// has.
pub(crate) struct Case<P> {
    pub(crate) falloff: P,
    pub(crate) oracle: oracle::Falloff,
    pub(crate) row: &'static str,
    pub(crate) inner: f32,
    pub(crate) outer: f32,
}

impl<P: Falloff> Case<P> {
    /// The falloff from the axis to the edge.
    pub(crate) fn open(row: &'static str, falloff: P, oracle: oracle::Falloff, outer: f32) -> Self {
        Self { falloff, oracle, row, inner: 0.0, outer }
    }

    pub(crate) fn cone(&self) -> Cone<P> {
        let cone = Cone::from_outer(self.falloff, HalfAngle::degrees(self.outer));
        cone.and_then(|cone| cone.with_inner(HalfAngle::degrees(self.inner))).expect("a sound cone")
    }

    /// The names of the formats that hold the cone. Each is exact on the axis and at the edge, and
    /// between them within the bound of its row; the others refuse the cone.
    pub(crate) fn held_by(&self) -> Vec<&'static str> {
        [self.held::<f32>(), self.held::<Fx32>(), self.held::<Fx16>()].into_iter().flatten().collect()
    }

    fn held<S: Format>(&self) -> Option<&'static str> {
        let falloff = self.cone().compile::<S>().ok()?;
        let versine = |half| f64::from(Angle::from(HalfAngle::degrees(half)).versine());
        let outer = versine(self.outer);
        let exact = oracle::Cone { inner: versine(self.inner), ..oracle::Cone::new(self.oracle, outer) };
        let bound = bounds::of("falloff", self.row, S::NAME).expect("a row")[0] * f64::from(S::STEP);
        assert_eq!(falloff.at(falloff.versine(0.0)), S::ONE, "{}", S::NAME);
        assert_eq!(falloff.at(falloff.versine(outer as f32)), S::ZERO, "{}", S::NAME);
        for versine in sweep::versines(outer, 20_000) {
            let versine = falloff.versine(versine);
            let stored = S::exact_versine(&falloff, versine);
            if exact.jumps_near(stored, 1e-4 * f64::from(self.outer.to_radians())) {
                continue;
            }
            let error = (falloff.at(versine).exact() - exact.falloff(stored)).abs();
            assert_that!(error <= bound, S::NAME, stored, error);
        }
        Some(S::NAME)
    }
}

/// Every format, as [`Case::held_by`] names them.
pub(crate) const ALL: [&str; 3] = ["f32", "fx32", "fx16"];

/// The faulty formula gives a result in the stated range.
#[track_caller]
pub(crate) fn assert_fault(found: impl Into<f64>, expected: RangeInclusive<f64>) {
    let found = found.into();
    println!("the faulty formula gives {found:.5e}");
    assert!(expected.contains(&found), "the faulty formula gives {found:.5e}, not {expected:?}");
}

/// An error of ours keeps its bound, and the bound is not loose.
#[track_caller]
pub(crate) fn assert_ours(format: &str, error: f64, bound: f64) {
    println!("the kernel's error, {format}: {error:.3e}");
    bounds::check(format, error, bound).unwrap_or_else(|broken| panic!("{broken}"));
}
