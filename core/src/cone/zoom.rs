//! Zoom: the cones between two cones.

use super::{CompiledCone, Cone};
use crate::{
    error::Error,
    falloff::Falloff,
    number::{Scalar, float::versine_between},
};

impl<P: Falloff> Cone<P> {
    /// Returns a cone between this cone (`part` 0) and another one (`part` 1), with the falloff of
    /// this cone.
    ///
    /// For each of the inner angle, the outer angle and the cutoff, the sine of a quarter of the
    /// full angle is linear in `part`. So the full angle is nearly linear. It is less than the linear
    /// one by at most 0.08 degrees in a zoom up to 40 degrees, 0.27 up to 60, 0.9 up to 90 and 7.6
    /// up to 180 (searched).
    ///
    /// A part outside `[0, 1]` is clamped, and NaN counts as 0.
    #[must_use]
    pub fn zoomed(&self, other: &Self, part: f32) -> Self {
        Self {
            falloff: self.falloff,
            inner: versine_between(self.inner, other.inner, part),
            outer: versine_between(self.outer, other.outer, part),
            limit: versine_between(self.limit, other.limit, part),
        }
    }

    /// Compiles this cone and another one, which takes the falloff of this one, so that all cones
    /// between them keep the accuracy of the format.
    ///
    /// Also returns the largest `Errors::coarse_error` of the cones.
    pub(crate) fn compile_zoom<S: Scalar>(
        &self,
        other: &Self,
    ) -> Result<([CompiledCone<S, P>; 2], f32), Error> {
        /// Number of cones of which the error is computed, besides the wide one.
        const CONES: u16 = 96;
        let other = Self { falloff: self.falloff, ..*other };
        // The cones are closer together near the narrow one, where the error changes more.
        let (narrow, wide) = if self.limit < other.limit { (self, &other) } else { (&other, self) };
        let mut largest = wide.checked_error::<S>()?;
        for cone in 0..CONES {
            let root = f32::from(cone) / f32::from(CONES);
            largest = largest.max(narrow.zoomed(wide, root * root).checked_error::<S>()?);
        }
        Ok(([self, &other].map(|cone| cone.compile_for(largest)), largest))
    }
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use super::*;
    use crate::{
        HalfAngle,
        falloff::{Power, Soft},
        number::Fx16,
    };

    /// Returns the largest ratio of the error of a cone between two cones to the error that
    /// `compile_zoom` returns, and the largest ratio to that of the two cones.
    fn excess<P: Falloff>(falloff: P, hotspots: [f32; 2]) -> [f32; 2] {
        let cone = |degrees: f32, hotspot: f32| {
            let cone = Cone::from_outer(falloff, HalfAngle::degrees(degrees)).expect("a sound angle");
            cone.with_inner(HalfAngle::degrees(degrees * hotspot)).expect("a sound angle")
        };
        let mut worst = [0.0_f32; 2];
        for i in 0..40_u16 {
            let degrees = 90.0 / (1.0 + 0.05 * f32::from(i * i));
            let [narrow, wide] = [cone(degrees, hotspots[0]), cone(90.0, hotspots[1])];
            let Ok((_, largest)) = narrow.compile_zoom::<Fx16>(&wide) else { continue };
            let error = |cone: &Cone<P>| cone.checked_error::<Fx16>().expect("a cone between");
            let ends = error(&narrow).max(error(&wide));
            for step in 0..1_000_u16 {
                let found = error(&narrow.zoomed(&wide, f32::from(step) / 1_000.0));
                worst = [worst[0].max(found / largest), worst[1].max(found / ends)];
            }
        }
        worst
    }

    #[test]
    fn a_cone_between_has_the_stated_error() {
        let (mut of_all, mut of_ends) = (0.0_f32, 0.0_f32);
        for hotspots in [[0.0; 2], [0.5; 2], [0.0, 0.6], [0.6, 0.0]] {
            for [all, ends] in [excess(Soft, hotspots), excess(Power::<8>, hotspots)] {
                (of_all, of_ends) = (of_all.max(all), of_ends.max(ends));
            }
        }
        assert!((1.0..1.02).contains(&of_all), "{of_all} of the largest error");
        assert!((1.1..1.2).contains(&of_ends), "{of_ends} of the errors of the ends");
    }
}
