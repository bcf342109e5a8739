//! Derived bounds of the error of a light.
//!
//! A bound follows from the errors of the stages of an evaluation, which each format states: the
//! direction, the ramp, the falloff, the cosine, the share, the attenuation and the light. Nothing is
//! searched; the stages of fixed point are proved by machine (`core/proofs`), but for those of a measured
//! light's distribution, which are derived by hand. The kernel's own code
//! of falloffs and attenuations carries the errors: it runs on numbers that know the interval in which
//! the exact result lies, its derivative with respect to the falloff's argument, and the roundings so
//! far. The cone and the distances are divided into cells, so that an interval is narrow.
//!
//! Direction and axis have errors `e` and `e'` of their lengths, and differ from the exact ones by at
//! most `d` across. With `w = l - s` the versine `|w|^2 / 2` of a point is then wrong by at most
//! `(e + e') v + |w| d + (|e - e'| + d)^2 / 2`, because `w.l = v` and `w.s = -v`.
//!
//! ```
//! use luminaire::{Angle, Cone, Fx16, SpotLight};
//! let cone = Cone::soft(Angle::degrees(36.0))?;
//! let spot = SpotLight::new([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], cone)?.with_intensity(16.0)?;
//! let bound = spot.error_bound::<Fx16>(4.0..=7.0)?;
//! assert!(bound.light < 0.5 / 255.0 && bound.edge == 0.0);
//! # Ok::<(), luminaire::Error>(())
//! ```

mod carried;
mod interpolation;

use core::{cell::Cell, ops::RangeInclusive};

pub use self::carried::Lit;
use self::carried::{Carried, Pass, Way};
use crate::{
    angle::Angle,
    any_light::AnyLight,
    attenuation::{Attenuation, NoAttenuation},
    distribution::FULL,
    error::{Error, Expected, Parameter},
    falloff::{CompiledFalloff, Falloff, Formula, STRIP},
    light::{DirectionalLight, MeasuredLight, PointLight, SpotLight, check_reach},
    number::{Fraction, Offset, Quick, Scalar, Stages, Types},
    trig::square_root,
    vec3::Vec3,
};

/// An upper bound of the error of a compiled light.
///
/// The bound holds for every point within the given distances, every unit normal, and every position and
/// axis of the light. The exact light is that of the coordinates and of the normal as the format has
/// rounded them; a cosine of more than 1, of a normal that is rounded up, counts as 1. The bound is that
/// of the diffuse light, without colours.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ErrorBound {
    /// The error of the irradiance, clipped to full scale; 1 is full scale and 1/255 a linear code.
    pub light: f32,
    /// The angle, in radians, by which the edge of the cone may move, where the intensity jumps or its
    /// derivative is infinite. `light` holds for directions farther from such an angle; 0 if it holds for all.
    ///
    /// A jump of no more light than the error beside it is part of `light`.
    pub edge: f32,
    /// The distance by which the range may move where an attenuation is cut off. `light` holds for
    /// distances farther from the range; 0 if it holds for all. A small jump is part of `light`, as at the edge.
    pub range: f32,
}

impl ErrorBound {
    /// Returns the error of the irradiance in linear codes, 1/255 of full scale.
    pub fn codes(&self) -> f32 {
        255.0 * self.light
    }
}

/// Number of cells of the argument `t` of a falloff in each half.
const CELLS: u32 = 32;
/// `2^-(1/6)`: the ratio of the ends of a cell of cosines, and of a class of shares.
const FINER: f64 = 0.890_898_718_140_339_3;
/// Number of cells of cosines and of classes of shares, of 20 octaves; the last one ends at 0.
const CLASSES: usize = 6 * 20 + 1;
/// `2^(1/8)`: the ratio of the ends of a cell of distances.
const LONGER: f64 = 1.090_507_732_665_257_7;
/// The shares of the intensity that reach surfaces, in classes of a similar size.
struct Shares([Class; CLASSES]);

#[derive(Clone, Copy)]
struct Class {
    low: f64,
    high: f64,
    error: f64,
}

impl Shares {
    fn none() -> Self {
        Self([Class { low: 1.0, high: 0.0, error: 0.0 }; CLASSES])
    }

    fn add(&mut self, share: &Carried<'_>) {
        let (mut class, mut least) = (0, FINER);
        while class + 1 < CLASSES && share.high < least {
            class += 1;
            least *= FINER;
        }
        let Class { low, high, error } = &mut self.0[class];
        *low = low.min(share.low);
        *high = high.max(share.high);
        *error = error.max(share.total());
    }
}

/// Returns the edges of cells of `[0, 1]`, narrower towards both ends.
fn edges() -> impl Iterator<Item = f64> {
    let half = (0..=CELLS).map(|i| {
        let place = f64::from(i) / f64::from(CELLS);
        place * place / 2.0
    });
    half.clone().chain(half.rev().skip(1).map(|place| 1.0 - place))
}

/// A cone with the errors of an evaluation.
struct Edge<P> {
    falloff: P,
    inner: f64,
    outer: f64,
    limit: f64,
    stages: Stages,
    /// The factor by which the ramp magnifies a difference of directions before it is rounded.
    zoom: f64,
}

impl<P: Falloff> Edge<P> {
    /// Returns the error of a versine.
    fn versine_error(&self, versine: f64) -> f64 {
        let Stages { length, turn, difference, versine: rounding, set_up, .. } = self.stages;
        let turn = turn + difference / self.zoom;
        let unit = self.zoom * self.zoom;
        let of_lengths = length * versine + (length + turn) * (length + turn) / 2.0;
        let rounded = rounding.absolute / unit + rounding.relative * versine;
        of_lengths + turn * square_root(2.0 * versine) + rounded + 2.0 * set_up / unit
    }

    /// Returns the angle in which the versine changes by this much, on the side of the axis.
    fn angle_of(&self, change: f64) -> f64 {
        let versine = (self.limit - change).max(change).min(1.0);
        change / square_root(versine * (2.0 - versine))
    }

    /// Adds the shares of all points within the cone for each cosine, and returns where the edge may move.
    fn shares(&self, pass: &Pass, shares: &mut Shares) -> Moved {
        let Self { falloff, inner, outer, limit, .. } = *self;
        let span = outer - inner;
        let at_edge = self.versine_error(limit);
        let curve = falloff.compile::<f32>();
        let argument = |cell: [f64; 2], error| curve.intensity(Carried::argument(pass, cell, error));
        let mut add = |falloff| each_cosine(pass, |cosine| shares.add(&cosine.times_value(falloff)));
        // The hotspot and the axis.
        add(argument([1.0; 2], 0.0));
        if at_edge >= span / 2.0 || limit <= inner {
            // So steep an edge is a step, and so is a cutoff of the hotspot.
            let edge = self.angle_of(at_edge + if limit <= inner { 0.0 } else { span });
            return Moved { jump: 1.0, edge, strip: 0.0 };
        }
        let error_at = |t: f64| {
            let versine = (outer - t * span).max(inner);
            self.versine_error(versine) / span + self.stages.ramp.of(t)
        };
        let (mut least, mut most, mut strip) = ((outer - limit).max(0.0) / span, 1.0, 0.0);
        // A step is 0 at 0 itself.
        let jump = argument([least.max(f32::MIN_POSITIVE.into()); 2], 0.0).high;
        let edge = self.angle_of(at_edge + span * self.stages.ramp.of(1.0));
        // Where a derivative is infinite, there is an error of the angle alone.
        let half_angle = angle_of(outer);
        let t_at = |angle: f64| ((outer - versine_of(angle)) / span).clamp(0.0, 1.0);
        match falloff.formula() {
            Formula::Power(p) if p < 1.0 => {
                least = least.max(t_at(half_angle * (1.0 - STRIP)));
                strip = half_angle * STRIP;
            }
            Formula::InvertedPower(p, _) if p < 1.0 => {
                most = t_at(angle_of(inner) + half_angle * STRIP);
                strip = half_angle * STRIP;
            }
            _ => {}
        }
        let mut from = least;
        for place in edges().skip(1) {
            let to = least + place * (most - least);
            add(argument([from, to], error_at(from).max(error_at(to))));
            from = to;
        }
        Moved { jump, edge, strip }
    }
}

/// The shares of a light that emits the same in all directions.
fn everywhere(pass: &Pass, _: f64, shares: &mut Shares) -> Moved {
    each_cosine(pass, |cosine| shares.add(&cosine.value()));
    Moved::NONE
}

/// Where the edge of a cone may move.
struct Moved {
    /// The intensity of the falloff at the edge, beyond which it is 0.
    jump: f64,
    /// The angle by which a jump may move.
    edge: f64,
    /// The angle beside the edge or the hotspot in which the derivative is too large.
    strip: f64,
}

impl Moved {
    /// No edge.
    const NONE: Self = Self { jump: 0.0, edge: 0.0, strip: 0.0 };
}

/// Returns the angle of a versine.
fn angle_of(versine: f64) -> f64 {
    f64::from(Angle::from_versine(versine as f32).to_radians()) / 2.0
}

/// Returns the versine of an angle.
fn versine_of(angle: f64) -> f64 {
    Angle::radians(2.0 * angle as f32).versine().into()
}

/// Calls a function with the cosine of each cell of angles of incidence.
fn each_cosine(pass: &Pass, mut call: impl FnMut(Carried<'_>)) {
    let (mut low, mut high) = (FINER, 1.0);
    for class in 0..CLASSES {
        let low_end = if class + 1 < CLASSES { low } else { 0.0 };
        call(Carried::number(pass, [low_end, high], pass.stages.cosine.of(high)));
        (low, high) = (low * FINER, low);
    }
}

/// Returns the largest measure of the light of all shares between the distances of a pass.
fn largest<A: Attenuation>(
    attenuation: A,
    pass: &mut Pass,
    shares: &Shares,
    measure: &dyn Fn(Lit) -> f64,
) -> f64 {
    let constants = attenuation.constants::<f32>();
    let nowhere = Vec3::default();
    let offset = <f32 as Types>::Offset::between(nowhere, nowhere);
    let [near, far] = pass.distances;
    let (mut from, mut most) = (near, 0.0_f64);
    while from <= far {
        let to = if from * LONGER < far { from * LONGER } else { far };
        pass.distances = [from, to];
        for class in shares.0.iter().filter(|class| class.high > 0.0) {
            let share = Carried::number(pass, [class.low, class.high], class.error);
            pass.lit.set(Lit::default());
            A::light::<f32, _, _>(&constants, &offset, &Way(pass), share, 1.0);
            most = most.max(measure(pass.lit.get()));
        }
        if to >= far {
            break;
        }
        from = to;
    }
    pass.distances = [near, far];
    most
}

/// An evaluation between two distances.
struct Followed {
    stages: Stages,
    is_fine: bool,
    zoom: f64,
    /// Whether only light is followed that the coarse evaluation keeps because it is clipped.
    is_kept: bool,
    distances: [f64; 2],
}

/// What is known of the shares of the intensity: adds those of all points for each cosine, and returns where an
/// edge may move.
type AddShares<'a> = &'a dyn Fn(&Pass, f64, &mut Shares) -> Moved;

/// Returns the bound over all evaluations of a light.
fn derived<A: Attenuation>(
    add_shares: AddShares<'_>,
    attenuation: A,
    intensity: f32,
    evaluations: impl Iterator<Item = Followed>,
    measure: &dyn Fn(Lit) -> f64,
) -> ErrorBound {
    let (mut light, mut strip) = (0.0_f64, 0.0_f64);
    // The light on the one side of a jump, of which the other side has none, and how far its place may move.
    let (mut at_edge, mut at_range) = ([0.0_f64; 2], [0.0_f64; 2]);
    let lit = |share: f64, distance| {
        let light = (share * f64::from(intensity) * attenuation.exact(distance)).min(1.0);
        measure(Lit { from: 0.0, to: light, error: light })
    };
    for Followed { stages, is_fine, zoom, is_kept, distances: [mut near, mut far] } in evaluations {
        if let Some(range) = attenuation.range().map(f64::from) {
            // The squared fraction of the range is wrong by this much where it is 1.
            let moved = range * stages.near.of(1.0) / 2.0;
            if near > range + moved {
                continue;
            }
            if far >= range - moved {
                let last = f64::from_bits(range.to_bits() - 1);
                at_range = most_of(at_range, [lit(1.0, last), moved]);
            }
            (near, far) = (near.min(range - moved), far.min(range));
        }
        let distances = [near, far];
        let mut pass =
            Pass { stages, is_fine, distances, intensity: intensity.into(), is_kept, lit: Cell::default() };
        let mut shares = Shares::none();
        let moved = add_shares(&pass, zoom, &mut shares);
        at_edge = most_of(at_edge, [lit(moved.jump, near), moved.edge]);
        strip = strip.max(moved.strip);
        light = light.max(largest(attenuation, &mut pass, &shares, measure));
    }
    // On the wrong side of a jump the light is wrong by the jump, and by its error beside it. A jump of at most
    // this error is added to it, and a larger one has a place.
    let (mut all, mut places) = (light, [0.0; 2]);
    for (place, [jump, moved]) in places.iter_mut().zip([at_edge, at_range]) {
        if jump <= light {
            all += jump;
        } else {
            *place = moved;
        }
    }
    let [edge, range] = places;
    ErrorBound { light: above(all), edge: above(edge.max(strip)), range: above(range) }
}

/// Returns the larger one of each two numbers.
fn most_of(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].max(b[0]), a[1].max(b[1])]
}

/// Returns an f32 that is not less than a number.
fn above(value: f64) -> f32 {
    let nearest = value as f32;
    if f64::from(nearest) < value { f32::from_bits(nearest.to_bits() + 1) } else { nearest }
}

/// The farthest distance: `f32` cannot square one of more than 1.8e19.
const FARTHEST: f32 = 1e18;

/// Returns the distances as f64, within those of a format.
fn checked<S: Scalar>(distances: RangeInclusive<f32>) -> Result<[f64; 2], Error> {
    let (near, far) = distances.into_inner();
    let refused = |value, accepted| Err(Error { parameter: Parameter::Distance, value, accepted });
    if !(near > 0.0 && near <= FARTHEST) {
        return refused(near, Expected::UpTo(FARTHEST));
    }
    if !(near..=FARTHEST).contains(&far) {
        return refused(far, Expected::Between(near, FARTHEST));
    }
    Ok([near, far].map(|distance| f64::from(distance).max(S::NEAREST)))
}

/// Divides distances into those whose stages have the same errors.
fn divided<S: Scalar>([near, far]: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    let mut next = Some(near).filter(|near| *near <= far);
    core::iter::from_fn(move || {
        let from = next?;
        let to = S::larger_errors_from(from);
        next = Some(to).filter(|next| *next <= far);
        Some([from, to.min(far)])
    })
}

/// The relative error of a distance that [`Offset::is_near`] compares: more than the truncation of an offset to 15
/// bits changes its length.
pub(crate) const NEARLY: f64 = 8.4e-5;

/// Returns the evaluations of a format between two distances: fine within a distance, and coarse from
/// it on.
fn evaluations<S: Scalar>(
    [near, far]: [f64; 2],
    fine_within: f64,
    zoom: f64,
) -> impl Iterator<Item = Followed> {
    let is_always_fine = fine_within == f64::INFINITY;
    let fine = [near, far.min(fine_within * (1.0 + NEARLY))];
    let coarse = [if is_always_fine { f64::INFINITY } else { near.max(fine_within * (1.0 - NEARLY)) }, far];
    let kept = [if is_always_fine { f64::INFINITY } else { near }, fine[1]];
    let followed = move |is_kept, distances: [f64; 2]| {
        let stages = S::stages(distances[0]);
        Followed { stages, is_fine: false, zoom, is_kept, distances }
    };
    let coarse = divided::<S>(coarse).map(move |it| followed(false, it));
    let kept = divided::<S>(kept).map(move |it| followed(true, it));
    let fine = (fine[0] <= fine[1]).then(|| {
        let stages = S::fine_stages(fine[1]);
        Followed { stages, is_fine: true, zoom, is_kept: false, distances: fine }
    });
    coarse.chain(kept).chain(fine)
}

/// The linear error.
fn linear(lit: Lit) -> f64 {
    lit.error
}

impl<P: Falloff, A: Attenuation> SpotLight<P, A> {
    /// Returns an upper bound of the error of the light compiled for the format `S`, at surfaces
    /// within these distances from the light.
    ///
    /// # Errors
    /// The errors of [`compile`](Self::compile); distances that are not in (0, 1e18], or not in order.
    pub fn error_bound<S: Scalar>(&self, distances: RangeInclusive<f32>) -> Result<ErrorBound, Error> {
        self.error_bound_by::<S>(distances, &linear)
    }

    /// Returns the bound of [`error_bound`](Self::error_bound) in another measure, such as the steps of
    /// a display.
    ///
    /// `measure` returns the largest error in its unit of lights of this size with this error.
    ///
    /// # Errors
    /// The errors of [`error_bound`](Self::error_bound).
    pub fn error_bound_by<S: Scalar>(
        &self,
        distances: RangeInclusive<f32>,
        measure: &dyn Fn(Lit) -> f64,
    ) -> Result<ErrorBound, Error> {
        let distances = checked::<S>(distances)?;
        check_reach::<S>(self.position())?;
        let cone = self.cone();
        let (_, error) = cone.compile_with_error::<S>()?;
        let fine_within = S::fine_within(error, self.intensity(), self.attenuation().growth());
        let zoom = S::magnification(cone.outer_versine());
        Ok(self.derived(evaluations::<S>(distances, fine_within, zoom), measure))
    }

    /// Returns an upper bound of the error of the light compiled for the quick evaluation of the format
    /// `S`, at surfaces within these distances from the light.
    ///
    /// # Errors
    /// The errors of [`error_bound`](Self::error_bound).
    pub fn quick_error_bound<S: Quick>(&self, distances: RangeInclusive<f32>) -> Result<ErrorBound, Error> {
        self.quick_error_bound_by::<S>(distances, &linear)
    }

    /// Returns the bound of [`quick_error_bound`](Self::quick_error_bound) in another measure: see
    /// [`error_bound_by`](Self::error_bound_by).
    ///
    /// # Errors
    /// The errors of [`error_bound`](Self::error_bound).
    pub fn quick_error_bound_by<S: Quick>(
        &self,
        distances: RangeInclusive<f32>,
        measure: &dyn Fn(Lit) -> f64,
    ) -> Result<ErrorBound, Error> {
        let distances = checked::<S>(distances)?;
        check_reach::<S>(self.position())?;
        self.cone().compile_quick::<S>()?;
        let followed = |distances: [f64; 2]| {
            let stages = S::quick_stages(distances[0]);
            Followed { stages, is_fine: false, zoom: 1.0, is_kept: false, distances }
        };
        Ok(self.derived(divided::<S>(distances).map(followed), measure))
    }

    fn derived(
        &self,
        evaluations: impl Iterator<Item = Followed>,
        measure: &dyn Fn(Lit) -> f64,
    ) -> ErrorBound {
        let (falloff, versines) = (self.cone().falloff(), self.cone().versines());
        let [inner, outer, limit] = versines.map(f64::from);
        let add_shares = |pass: &Pass, zoom, shares: &mut Shares| {
            Edge { falloff, inner, outer, limit, stages: pass.stages, zoom }.shares(pass, shares)
        };
        derived(&add_shares, self.attenuation(), self.intensity(), evaluations, measure)
    }
}

impl<A: Attenuation> PointLight<A> {
    /// Returns an upper bound of the error of the light compiled for the format `S`, at surfaces
    /// within these distances from the light.
    ///
    /// # Errors
    /// The errors of [`compile`](Self::compile); distances that are not in (0, 1e18], or not in order.
    pub fn error_bound<S: Scalar>(&self, distances: RangeInclusive<f32>) -> Result<ErrorBound, Error> {
        self.error_bound_by::<S>(distances, &linear)
    }

    /// Returns the bound of [`error_bound`](Self::error_bound) in another measure: see
    /// [`SpotLight::error_bound_by`].
    ///
    /// # Errors
    /// The errors of [`error_bound`](Self::error_bound).
    pub fn error_bound_by<S: Scalar>(
        &self,
        distances: RangeInclusive<f32>,
        measure: &dyn Fn(Lit) -> f64,
    ) -> Result<ErrorBound, Error> {
        let distances = checked::<S>(distances)?;
        check_reach::<S>(self.position())?;
        let (attenuation, intensity) = (self.attenuation(), self.intensity());
        let fine_within = S::fine_within(0.0, intensity, attenuation.growth());
        let followed = evaluations::<S>(distances, fine_within, 1.0);
        Ok(derived(&everywhere, attenuation, intensity, followed, measure))
    }
}

impl<A: Attenuation> MeasuredLight<'_, A> {
    /// Returns an upper bound of the error of the light compiled for the format `S`, at surfaces
    /// within these distances from the light.
    ///
    /// The exact light is that of the distribution as it is, without what its table differs from a measurement. An error of the
    /// place on the square moves the intensity by at most the largest slope of the table.
    ///
    /// # Errors
    /// The errors of [`compile`](Self::compile); distances that are not in (0, 1e18], or not in order.
    pub fn error_bound<S: Scalar>(&self, distances: RangeInclusive<f32>) -> Result<ErrorBound, Error> {
        self.error_bound_by::<S>(distances, &linear)
    }

    /// Returns the bound of [`error_bound`](Self::error_bound) in another measure: see
    /// [`SpotLight::error_bound_by`].
    ///
    /// # Errors
    /// The errors of [`error_bound`](Self::error_bound).
    pub fn error_bound_by<S: Scalar>(
        &self,
        distances: RangeInclusive<f32>,
        measure: &dyn Fn(Lit) -> f64,
    ) -> Result<ErrorBound, Error> {
        let distances = checked::<S>(distances)?;
        check_reach::<S>(self.position())?;
        let (attenuation, intensity, distribution) =
            (self.attenuation(), self.intensity(), self.distribution());
        let fine_within = S::fine_within(self.coarse_error::<S>(), intensity, attenuation.growth());
        let (steepness, peak) = (f64::from(distribution.steepness()), distribution.peak());
        let add_shares = |pass: &Pass, _, shares: &mut Shares| {
            let placing = S::placing(pass.is_fine);
            let error = steepness * placing.error(pass.stages.turn, self.sine().into()) + placing.cell;
            let mut high = f64::from(peak) / f64::from(FULL);
            for class in 0..CLASSES {
                let low = if class + 1 < CLASSES { FINER * high } else { 0.0 };
                let share = Carried::number(pass, [low, high], error);
                each_cosine(pass, |cosine| shares.add(&cosine.times_value(share)));
                high = low;
            }
            Moved::NONE
        };
        let followed = evaluations::<S>(distances, fine_within, 1.0);
        Ok(derived(&add_shares, attenuation, intensity, followed, measure))
    }
}

impl DirectionalLight {
    /// Returns an upper bound of the error of the light compiled for the format `S`.
    pub fn error_bound<S: Scalar>(&self) -> ErrorBound {
        self.error_bound_by::<S>(&linear)
    }

    /// Returns the bound of [`error_bound`](Self::error_bound) in another measure: see
    /// [`SpotLight::error_bound_by`].
    pub fn error_bound_by<S: Scalar>(&self, measure: &dyn Fn(Lit) -> f64) -> ErrorBound {
        let stages = S::stages(1.0);
        let stages = Stages { cosine: stages.incidence, ..stages };
        let followed = Followed { stages, is_fine: false, zoom: 1.0, is_kept: false, distances: [1.0; 2] };
        let followed = core::iter::once(followed);
        derived(&everywhere, NoAttenuation, self.intensity(), followed, measure)
    }
}

impl AnyLight {
    /// Returns an upper bound of the error of the light compiled for the format `S`, at surfaces
    /// within these distances from the light. A directional light has no distance.
    ///
    /// # Errors
    /// The errors of [`SpotLight::error_bound`].
    pub fn error_bound<S: Scalar>(&self, distances: RangeInclusive<f32>) -> Result<ErrorBound, Error> {
        self.error_bound_by::<S>(distances, &linear)
    }

    /// Returns the bound of [`error_bound`](Self::error_bound) in another measure: see
    /// [`SpotLight::error_bound_by`].
    ///
    /// # Errors
    /// The errors of [`SpotLight::error_bound`].
    pub fn error_bound_by<S: Scalar>(
        &self,
        distances: RangeInclusive<f32>,
        measure: &dyn Fn(Lit) -> f64,
    ) -> Result<ErrorBound, Error> {
        match self {
            Self::Directional(light) => Ok(light.error_bound_by::<S>(measure)),
            Self::Point(light) => light.error_bound_by::<S>(distances, measure),
            Self::Spot(light) => light.error_bound_by::<S>(distances, measure),
            Self::Measured(light) => light.error_bound_by::<S>(distances, measure),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        angle::{Angle, HalfAngle},
        attenuation::{AnyAttenuation, CutAt, Decay, FilamentRange, InverseSquare, NoAttenuation},
        cone::Cone,
        falloff::{AnyFalloff, Hard, Power, RealPower, Soft, Step},
    };

    extern crate std;
    use std::string::ToString;

    fn spot<P: Falloff>(cone: Result<Cone<P>, Error>) -> SpotLight<P> {
        SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone.unwrap()).unwrap()
    }

    #[test]
    fn distances_are_positive_and_in_order() {
        let refusal =
            |distances| spot(Cone::soft(Angle::degrees(30.0))).error_bound::<f32>(distances).unwrap_err();
        assert_eq!(
            refusal(0.0..=1.0).to_string(),
            "distance = 0: expected more than 0 and at most 1000000000000000000"
        );
        for distances in
            [f32::NAN..=1.0, -1.0..=1.0, f32::INFINITY..=f32::INFINITY, 2.0..=1.0, 1.0..=f32::NAN]
        {
            assert_eq!(refusal(distances).parameter, Parameter::Distance);
        }
    }

    /// A measure of an error scales the bound of a light of every kind.
    #[test]
    fn a_measure_is_that_of_every_kind_of_light() {
        let cone = Cone::from_outer(AnyFalloff::from(Hard), Angle::degrees(30.0));
        let lights: [AnyLight; 3] = [
            spot(cone).with_attenuation(AnyAttenuation::from(InverseSquare)).into(),
            PointLight::new([0.0; 3]).unwrap().into(),
            DirectionalLight::new([0.0, -1.0, 0.0]).unwrap().into(),
        ];
        for light in lights {
            let linear = light.error_bound::<f32>(1.0..=4.0).unwrap().light;
            let by =
                |measure: &dyn Fn(Lit) -> f64| light.error_bound_by::<f32>(1.0..=4.0, measure).unwrap().light;
            let codes = by(&|lit| 255.0 * lit.error);
            assert!(linear > 0.0 && (codes / linear - 255.0).abs() < 1e-3, "{light:?}: {codes}");
        }
    }

    #[test]
    fn a_bound_is_the_next_number_of_f32_or_equal() {
        let mut rng = fastrand::Rng::with_seed(24);
        for _ in 0..10_000 {
            let value = f64::from_bits(rng.u64(0x3800_0000_0000_0000..0x4700_0000_0000_0000));
            let [below, found] = [1, 0].map(|step| f64::from(f32::from_bits(above(value).to_bits() - step)));
            assert!(below < value && value <= found, "{value:e}: {below:e} {found:e}");
            assert_eq!(f64::from(above(found)), found);
        }
    }

    #[test]
    fn an_angle_has_its_versine() {
        for i in 1..=1_000_u16 {
            let versine = f64::from(i) / 1_000.0;
            let found = versine_of(angle_of(versine));
            // micromath has 1.3e-3 of an angle.
            assert!((found - versine).abs() < 3e-3, "{versine}: {found}");
        }
    }

    #[test]
    fn one_distance_has_a_bound() {
        let spot = spot(Cone::soft(Angle::degrees(30.0)));
        let at = |from, to| spot.error_bound::<f32>(from..=to).unwrap().light;
        assert!(at(2.0, 2.0) > 1e-7 && at(2.0, 2.0) <= at(1.9, 2.1));
    }

    #[test]
    #[cfg(feature = "fixed")]
    fn a_bound_grows_with_the_distances_and_the_intensity() {
        let spot = spot(Cone::hard(Angle::degrees(20.0)));
        let bound = |intensity, near| {
            spot.with_intensity(intensity)
                .unwrap()
                .quick_error_bound::<crate::Fx16>(near..=9.0)
                .unwrap()
                .light
        };
        assert!(bound(1.0, 1.0) < bound(1.0, 0.5) && bound(1.0, 0.5) < bound(4.0, 0.5));
        assert!(bound(1.0, 1.0) > 1e-5 && bound(1e9, 1e-3) <= 1.0);
    }

    /// However small a jump and however bright the light: it is part of the light or has a place.
    fn no_jump_is_lost<S: Scalar>() {
        let half = HalfAngle::degrees;
        for exponent in -9..=9 {
            let intensity = 10_f64.powi(exponent) as f32;
            let bound = |light: SpotLight<AnyFalloff, AnyAttenuation>, near| {
                light.with_intensity(intensity).unwrap().error_bound::<S>(near..=1.0).unwrap()
            };
            // Nearly a light of OpenGL with an exponent of 20: its intensity at 60 degrees is over 6e-7.
            let opengl = Cone::from_outer(AnyFalloff::from(Power::<20>), half(89.0)).unwrap();
            let opengl = spot(opengl.with_cutoff(half(60.0)));
            let edge = bound(opengl.with_attenuation(InverseSquare.into()), 1.0);
            assert!(edge.edge > 0.0 || edge.light >= (6e-7 * intensity).min(1.0), "{intensity}: {edge:?}");
            let open = spot(Cone::from_outer(AnyFalloff::from(Soft), half(40.0)));
            for k in [0.5, 2.0, 11.0, 16.0] {
                let cut = CutAt::new(Decay::new(k, 1e9).unwrap(), Some(1.0)).unwrap();
                let range = bound(open.with_attenuation(cut.into()), 0.9);
                assert!(range.range > 0.0 || range.light >= intensity.min(1.0), "{intensity}: {range:?}");
            }
            // Where nothing jumps, nothing has a place.
            let window = FilamentRange::new(InverseSquare, Some(1.0)).unwrap();
            let smooth = bound(open.with_attenuation(window.into()), 0.9);
            assert_eq!([smooth.edge, smooth.range], [0.0; 2], "{intensity}: {smooth:?}");
        }
    }

    #[test]
    fn no_jump_is_lost_before_the_gain() {
        no_jump_is_lost::<f32>();
        #[cfg(feature = "fixed")]
        no_jump_is_lost::<crate::Fx16>();
    }

    #[test]
    fn a_jump_has_an_error_of_its_place() {
        let wide = Angle::degrees(60.0);
        let bound = |cone| spot(cone).error_bound::<f32>(1.0..=2.0).unwrap();
        let step = bound(Cone::from_outer(Step, wide));
        assert!(step.edge > 1e-8 && step.edge < 1e-6 && step.light < 1e-5, "{step:?}");
        let steep =
            spot(Cone::from_outer(RealPower::new(0.5).unwrap(), wide)).error_bound::<f32>(1.0..=2.0).unwrap();
        assert!((steep.edge - 30_f32.to_radians() / 510.0).abs() < 1e-6, "{steep:?}");
        let smooth = spot(Cone::from_outer(Hard, wide)).with_attenuation(NoAttenuation);
        assert_eq!(smooth.error_bound::<f32>(1.0..=2.0).unwrap().edge, 0.0);
        let cut = smooth.with_attenuation(CutAt::new(InverseSquare, Some(1.5)).unwrap());
        let cut = cut.error_bound::<f32>(1.0..=2.0).unwrap();
        assert!(cut.range > 1e-8 && cut.range < 1e-5, "{cut:?}");
    }
}
