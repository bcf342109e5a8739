//! Zoom: the cones between two cones.
//!
//! The chords of a cone, the roots of its versines, are linear in the part of the way. So the share of the hotspot
//! is monotone, and so are the angles: over an interval of parts, the ends have the steepest falloff and the narrowest cone.
//! Bounds over intervals, halved where they are too coarse, hold for all cones between.

use super::{CompiledCone, Cone, STEEPEST, errors_of_direction, slopes};
use crate::{
    angle::Angle,
    error::{Error, Expected, Parameter},
    falloff::Falloff,
    number::{HALF_A_CODE, Scalar, Slopes, float::versine_between},
    search::bisect,
    trig::{sqrt, square_root},
};

impl<P: Falloff> Cone<P> {
    /// Returns a cone between this cone (`part` 0) and another one (`part` 1), with the falloff of
    /// this cone.
    ///
    /// For each of the inner angle, the outer angle and the cutoff, the sine of a quarter of the
    /// full angle is linear in `part`. So the full angle is nearly linear. It is less than the linear
    /// one by at most 0.08 degrees in a zoom up to 40 degrees, 0.27 up to 60, 0.9 up to 90 and 7.6
    /// up to 180 (searched). The half angles are off by at most 3.5e-7 of their size (derived).
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
    /// Also returns an upper bound of the `Errors::coarse_error` of the cones.
    ///
    /// # Errors
    /// A cone that the format cannot hold by itself, or an angle of a cone with which it cannot hold all cones between.
    pub(crate) fn compile_zoom<S: Scalar>(
        &self,
        other: &Self,
    ) -> Result<([CompiledCone<S, P>; 2], f32), Error> {
        let other = Self { falloff: self.falloff, ..*other };
        self.check::<S>()?;
        other.check::<S>()?;
        let error = self.zoom_error::<S>(&other).ok_or_else(|| self.refused_zoom::<S>(&other))?;
        Ok(([self, &other].map(|cone| cone.compile_for(error)), error))
    }

    /// Returns an upper bound of the `Errors::coarse_error` of the cones between this one and another one; `None` if
    /// the error of a cone between may exceed half a linear code.
    fn zoom_error<S: Scalar>(&self, other: &Self) -> Option<f32> {
        /// The part of a chord by which it changes within the shortest interval. The bound of such an interval exceeds
        /// the bounds of its cones by at most 1 %, so that no cone is refused whose bound is below 0.99 of half a code.
        const SHORTEST: f64 = 1e-3;
        /// The excess of the returned bound over the bound of a cone, but where a ramp's scale changes.
        const EXCESS: f32 = 1.005;
        if S::LOSES_HIDDEN && [self.loses(other), other.loses(self)].contains(&true) {
            return None;
        }
        // The cones are closer together near the narrow one, where the error changes more.
        let (narrow, wide) = if self.limit < other.limit { (self, other) } else { (other, self) };
        let ends = [narrow, wide].map(Chords::of::<S, P>);
        let bound = |a: Chords, b: Chords| Chords::errors::<S, P>(a, b, self.falloff);
        let mut least = 0.0_f32;
        for end in ends {
            let [error, coarse] = bound(end, end);
            if error > HALF_A_CODE {
                return None;
            }
            least = least.max(coarse);
        }
        let (mut most, mut from, mut length, mut here) = (least, 0.0, 1.0, ends[0]);
        while from < 1.0 {
            let to = if from + length < 1.0 { from + length } else { 1.0 };
            let next = ends[0].between(ends[1], to);
            let [error, coarse] = bound(here, next);
            let is_shortest = length <= SHORTEST * here.scale(ends);
            // From half a code on, all points have the fine evaluation.
            let is_close = coarse <= EXCESS * least || least > HALF_A_CODE || is_shortest;
            if error <= HALF_A_CODE && is_close {
                (most, from, length, here) = (most.max(coarse), to, 2.0 * length, next);
                continue;
            }
            let [single, coarse] = bound(next, next);
            if is_shortest || single > HALF_A_CODE {
                return None;
            }
            least = least.max(coarse);
            length = (to - from) / 2.0;
        }
        Some(most)
    }

    /// Returns whether a ramp may lose what a zoom to the other cone needs: the falloff behind a cutoff within the
    /// hotspot. Two such cones zoom as the step that they are.
    fn loses(&self, other: &Self) -> bool {
        let is_hidden = |cone: &Self| cone.inner >= STEEPEST * cone.limit;
        self.has_cutoff() && is_hidden(self) && !is_hidden(other)
    }

    /// Returns the error of two cones, each of which the format holds, between which it cannot hold a cone.
    ///
    /// The error names an angle of one of the two. With an angle of the accepted range the format holds the zoom; but if the other
    /// cone or another angle is refused as well, it holds this cone as an end.
    #[cold]
    fn refused_zoom<S: Scalar>(&self, other: &Self) -> Error {
        let holds = |a: &Self, b: &Self| {
            a.zoom_error::<S>(b).is_some() && [a, b].iter().all(|cone| cone.check::<S>().is_ok())
        };
        // An end may be too narrow or too steep for any zoom.
        for end in [self, other] {
            if !holds(end, end) {
                return end.remedy(0.0, |cone| holds(cone, cone)).unwrap_or(Error {
                    parameter: Parameter::OuterAngle,
                    value: Angle::from_versine(end.outer).to_degrees(),
                    accepted: Expected::AngleFrom(f32::INFINITY),
                });
            }
        }
        let is_wider = self.inner * other.outer >= other.inner * self.outer;
        let (wider, narrower) = if is_wider { (self, other) } else { (other, self) };
        // A hotspot of less than 1/1,000 of the angle is more easily missed than an edge less steep.
        let is_tiny = narrower.inner < 1e-6 * narrower.outer;
        let without = |cone: &Self| Self { inner: 0.0, ..*cone };
        let found = if is_tiny && narrower.has_hotspot() && holds(&without(narrower), wider) {
            narrower.remedy(0.0, |cone| holds(cone, wider))
        } else {
            let inner = narrower.inner / narrower.outer * wider.outer;
            wider
                .remedy(inner, |cone| holds(cone, narrower))
                .or_else(|| narrower.remedy(0.0, |cone| holds(cone, wider)))
        };
        // Two cones without a hotspot zoom if each does with itself.
        let none = Error {
            parameter: Parameter::InnerAngle,
            value: Angle::from_versine(wider.inner).to_degrees(),
            accepted: Expected::AngleBetween(0.0, 0.0),
        };
        found.unwrap_or(none)
    }

    /// Returns the error that names an angle of this cone with which a predicate holds, or `None` if that takes more
    /// than one angle. The first choice is a narrower hotspot of at least the versine `inner`.
    fn remedy(&self, inner: f32, holds: impl Fn(&Self) -> bool) -> Option<Error> {
        /// Part by which a limit is inside of what holds: the roundings between angle and versine.
        const INSIDE: f32 = 1e-6;
        let degrees = |versine: f32| Angle::from_versine(versine).to_degrees();
        let refused =
            |parameter, versine, accepted| Some(Error { parameter, value: degrees(versine), accepted });
        let with_inner = |inner: f32| holds(&Self { inner, ..*self });
        let safe = [inner.min(0.9 * self.limit), 0.0];
        if let Some(from) = safe.into_iter().find(|&from| from < self.inner && with_inner(from)) {
            let to = bisect(from, self.inner, with_inner) * (1.0 - INSIDE);
            // A hotspot of a few units of the ramp may be worse than a wider one and than none.
            let narrower_hold = || (1_u32..24).all(|i| with_inner(to / (1_u64 << (2 * i)) as f32));
            let range = if with_inner(0.0) && narrower_hold() {
                [0.0, to]
            } else if from < to {
                [from, to].map(|inner| if from > 0.0 { inner } else { 0.0 })
            } else {
                [from; 2]
            };
            let [least, most] = range.map(degrees);
            return refused(Parameter::InnerAngle, self.inner, Expected::AngleBetween(least, most));
        }
        let with_cutoff = |limit: f32| holds(&Self { limit, ..*self });
        if self.has_cutoff() && with_cutoff(self.outer) {
            let least = bisect(self.limit, self.outer, |limit| !with_cutoff(limit)) * (1.0 + INSIDE);
            let accepted = Expected::AngleBetween(degrees(least.min(self.outer)), super::widest(self.outer));
            return refused(Parameter::CutoffAngle, self.limit, accepted);
        }
        let scaled = |outer: f32| {
            let [inner, limit] = [self.inner, self.limit].map(|versine| versine / self.outer * outer);
            holds(&Self { inner: inner.min(outer), outer, limit: limit.min(outer), ..*self })
        };
        scaled(1.0).then(|| {
            let least = bisect(self.outer, 1.0, |outer| !scaled(outer)) * (1.0 + INSIDE);
            refused(Parameter::OuterAngle, self.outer, Expected::AngleFrom(degrees(least.min(1.0))))
        })?
    }
}

/// The chords of a cone between two cones: the roots of its versines.
#[derive(Clone, Copy)]
struct Chords {
    inner: f64,
    outer: f64,
    limit: f64,
    /// The error of the inner chord that the ramps of the two cones leave.
    lost: f64,
}

impl Chords {
    fn of<S: Scalar, P: Falloff>(cone: &Cone<P>) -> Self {
        let [inner, outer, limit] =
            [cone.inner, cone.outer, cone.limit].map(|versine| square_root(versine.into()));
        let lost = S::inner_chord_error(cone.inner, cone.limit).into();
        Self { inner, outer, limit, lost }
    }

    fn between(self, other: Self, part: f64) -> Self {
        let between = |from: f64, to: f64| from * (1.0 - part) + to * part;
        Self {
            inner: between(self.inner, other.inner),
            outer: between(self.outer, other.outer),
            limit: between(self.limit, other.limit),
            lost: between(self.lost, other.lost),
        }
    }

    /// Returns the part of the hotspot in the versine of the cone.
    fn hotspot(self) -> f32 {
        let share = self.inner / self.outer;
        (share * share) as f32
    }

    /// Returns the part of the way between two cones over which the chords or the width of the edge change by no more than
    /// themselves.
    fn scale(self, ends: [Self; 2]) -> f64 {
        // So narrow an edge is a step.
        let edge = |cone: Self| (cone.outer - cone.inner).max(0.25 * f64::from(1.0 - STEEPEST) * cone.outer);
        let scale = |size: fn(Self) -> f64| {
            let change = (size(ends[1]) - size(ends[0])).abs();
            if change > 0.0 { size(self) / change } else { f64::INFINITY }
        };
        scale(|cone| cone.outer).min(scale(|cone| cone.limit)).min(scale(edge))
    }

    /// Returns upper bounds of the error of all cones between two cones, and of the error of their coarse evaluation.
    ///
    /// With the derivatives `k` and `s` of the falloff, the hotspot `h`, the outer chord `o` and an error of the chords of
    /// a part `c` and of `d`, the error beside that of a cone that is compiled as it is is at most `k (c + d / o) + s q / (1 - h)`:
    /// see NUMERICS.md. Where a cutoff or a table ends above zero, the place of this end is as accurate as that of a step.
    fn errors<S: Scalar, P: Falloff>(a: Self, b: Self, falloff: P) -> [f32; 2] {
        let least = |size: fn(Self) -> f64| size(a).min(size(b)) as f32;
        let (outer, limit) = (least(|cone| cone.outer), least(|cone| cone.limit));
        let lost = a.lost.max(b.lost) as f32;
        let [less, more] = [a.hotspot().min(b.hotspot()), a.hotspot().max(b.hotspot())];
        let hotspot = more.min(STEEPEST);
        let edge = if less >= STEEPEST { Slopes::STEP } else { steepest(falloff, less, hotspot) };
        // The error of the inner chord changes `t` by at most `2 h^(1/2) / (1 - h)` of its part of the outer chord.
        let slope = edge.fraction + edge.beside_axis;
        let of_inner = (2.0 * slope * sqrt(hotspot) / (1.0 - hotspot)).min(edge.angle);
        let zoomed = edge.angle * (S::CHORD_ERROR + S::CHORD_STEP / outer)
            + of_inner * lost / outer
            + slope * S::edge_error(outer * outer) / (1.0 - hotspot);
        let error = own_error::<S>(&edge, outer) + zoomed;
        let place = own_error::<S>(&Slopes::STEP, limit)
            + S::CHORD_ERROR
            + S::CHORD_STEP / limit
            + S::edge_error(limit * limit) / 2.0;
        // The scale of a ramp changes where its chord, which has an error, passes a power of two.
        let widest = a.limit.max(b.limit) as f32 * (1.0 + 1e-6);
        let coarse = S::coarse_error(&edge, outer * outer, widest * widest);
        [error.max(place), if coarse > 0.0 { coarse + zoomed } else { 0.0 }]
    }
}

/// Returns upper bounds of the derivatives of a falloff with hotspots from `less` to `more`.
///
/// They grow with the hotspot, but beside an infinite slope on the axis, which a hotspot cuts off.
fn steepest<P: Falloff>(falloff: P, less: f32, more: f32) -> Slopes {
    let edge = slopes(falloff, more);
    if edge.beside_axis == 0.0 || less == more {
        return edge;
    }
    let other = slopes(falloff, less);
    Slopes {
        angle: edge.angle.max(other.angle),
        fraction: edge.fraction.max(other.fraction),
        beside_axis: edge.beside_axis.max(other.beside_axis),
    }
}

/// Returns an upper bound of the error of a cone with these derivatives and this outer chord that is compiled as it is.
fn own_error<S: Scalar>(edge: &Slopes, outer: f32) -> f32 {
    let half = Angle::from_versine(outer * outer).to_radians() / 2.0;
    let [turned, shortened] = errors_of_direction::<S>(edge);
    S::rounding(edge) + turned / half + shortened / (half * half)
}

#[cfg(all(test, feature = "fixed"))]
mod tests {
    use super::*;
    use crate::{
        HalfAngle,
        falloff::{AnyFalloff, InvertedRealPower, Power, Soft},
        number::{Fx16, Fx32},
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

    /// The bounds of an interval are bounds of its cones, with any falloff: also where a slope is infinite on the axis.
    fn intervals_bound_their_cones<S: Scalar>() {
        let mut rng = fastrand::Rng::with_seed(1024);
        let peaks = [0.05, 0.3, 0.7].map(|exponent| InvertedRealPower::new(exponent).expect("an exponent"));
        for falloff in AnyFalloff::samples().chain(peaks.map(AnyFalloff::from)) {
            for _ in 0..300 {
                let [a, b] = [(); 2].map(|()| {
                    let outer = 1e-8_f32.powf(rng.f32());
                    let mut share = || if rng.bool() { rng.f32() } else { 1.0 - 1e-5_f32.powf(rng.f32()) };
                    let versines = [share() * outer, outer, share().max(1e-3) * outer];
                    Chords::of::<S, _>(&Cone::from_versines(falloff, versines).expect("sound versines"))
                });
                let all = Chords::errors::<S, _>(a, b, falloff);
                for _ in 0..10 {
                    let one = a.between(b, rng.f64());
                    let one = Chords::errors::<S, _>(one, one, falloff);
                    let is_bound = |(one, all)| one <= all * 1.000_01;
                    assert!(one.into_iter().zip(all).all(is_bound), "{falloff:?}: {one:?} {all:?}");
                }
            }
        }
    }

    #[test]
    fn bounds_of_an_interval_hold_for_its_cones() {
        intervals_bound_their_cones::<f32>();
        intervals_bound_their_cones::<Fx32>();
        intervals_bound_their_cones::<Fx16>();
    }

    #[test]
    fn a_cone_between_has_the_stated_error() {
        let (mut of_all, mut of_ends) = (0.0_f32, 0.0_f32);
        for hotspots in [[0.0; 2], [0.5; 2], [0.0, 0.6], [0.6, 0.0]] {
            for [all, ends] in [excess(Soft, hotspots), excess(Power::<8>, hotspots)] {
                (of_all, of_ends) = (of_all.max(all), of_ends.max(ends));
            }
        }
        assert!((0.99..=1.0).contains(&of_all), "{of_all} of the largest error");
        assert!((1.1..1.2).contains(&of_ends), "{of_ends} of the errors of the ends");
    }
}
