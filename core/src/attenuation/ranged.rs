//! Attenuations with a range.

use core::{
    fmt::{self, Formatter},
    marker::PhantomData,
};

#[cfg(feature = "arithmetic")]
use super::WithAttenuation;
use super::{Attenuation, InverseSquare, checked_range, dimmed, inverse_squared, squared_fraction};
use crate::{
    effect::{Effect, Effects},
    error::Error,
    number::{Offset, Ray, Scalar, Share},
    source::{Named, name},
    stored::stored,
};

/// An attenuation with a window that ends the light at a range.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Ranged<W, A> {
    attenuation: A,
    range: Option<f32>,
    window: PhantomData<W>,
}

stored!([W: Window, A: Attenuation] Ranged<W, A> { attenuation: A, range: Option<f32> } by Self::new(attenuation, range));

/// An attenuation that is cut off at a range: unchanged within the range, 0 from the range on.
pub type CutAt<A> = Ranged<Cut, A>;
/// An attenuation times `(1 - (d/r)^4)^2`. This window fades to 0 at the range without a visible
/// edge.
pub type Windowed<A> = Ranged<SquareWindow, A>;
/// The inverse-square law times glTF's window `1 - (d/r)^4`.
pub type GltfRange = Ranged<GltfWindow, InverseSquare>;
/// The inverse-square law times `(1 - (d/r)^4)^2`, the window of Filament, Bevy and three.js.
pub type FilamentRange = Ranged<SquareWindow, InverseSquare>;

/// A window: how a range ends an attenuation.
pub trait Window: Copy + PartialEq + core::fmt::Debug {
    /// The name of the type of an attenuation with this window, up to that of the attenuation.
    const TYPE: &'static str;
    /// The name of the window in data.
    const KEY: &'static str;

    /// The effects that the window requires in addition to [`Effect::Range`].
    const EFFECTS: Effects;

    /// Evaluates the window's factor at a fraction `d/r` of the range, in f64.
    fn exact(fraction: f64) -> f64;

    /// Multiplies a share of the intensity by the window, at the squared fraction `(d/r)^2` of the
    /// range.
    fn dim<S: Scalar, T: Share<S>>(share: T, squared: T) -> T;
}

/// The window that is 1 within the range and 0 from the range on.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Cut;

/// The window `1 - (d/r)^4`.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct GltfWindow;

/// The window `(1 - (d/r)^4)^2`.
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SquareWindow;

/// Returns `1 - (d/r)^4` from `(d/r)^2`.
#[inline]
fn window<S: Scalar, T: Share<S>>(squared: T) -> T {
    squared.times(squared).complement()
}

impl Window for Cut {
    const TYPE: &'static str = "CutAt<";
    const KEY: &'static str = "cut";
    const EFFECTS: Effects = Effects::NONE;

    fn exact(fraction: f64) -> f64 {
        if fraction < 1.0 { 1.0 } else { 0.0 }
    }

    #[inline]
    fn dim<S: Scalar, T: Share<S>>(share: T, squared: T) -> T {
        if squared.is_one() { T::default() } else { share }
    }
}

impl Window for GltfWindow {
    const TYPE: &'static str = "Ranged<GltfWindow, ";
    const KEY: &'static str = "gltf";
    const EFFECTS: Effects = Effects::NONE.with(Effect::Window);

    fn exact(fraction: f64) -> f64 {
        (1.0 - fraction * fraction * fraction * fraction).max(0.0)
    }

    #[inline]
    fn dim<S: Scalar, T: Share<S>>(share: T, squared: T) -> T {
        dimmed::<S, T>(share, window::<S, T>(squared))
    }
}

impl Window for SquareWindow {
    const TYPE: &'static str = "Windowed<";
    const KEY: &'static str = "square";
    const EFFECTS: Effects = Effects::NONE.with(Effect::Window);

    fn exact(fraction: f64) -> f64 {
        let window = GltfWindow::exact(fraction);
        window * window
    }

    #[inline]
    fn dim<S: Scalar, T: Share<S>>(share: T, squared: T) -> T {
        let window = window::<S, T>(squared);
        dimmed::<S, T>(share, window.times(window))
    }
}

impl<W: Window, A: Attenuation> Ranged<W, A> {
    /// Creates the attenuation with this range, in scene units; `None` leaves the attenuation
    /// unchanged.
    ///
    /// # Errors
    /// A range outside 0.001 to 1e9.
    pub fn new(attenuation: A, range: Option<f32>) -> Result<Self, Error> {
        Ok(Self { range: range.map(checked_range).transpose()?, ..Self::unlimited(attenuation) })
    }

    /// Creates the attenuation without a range.
    pub(super) fn unlimited(attenuation: A) -> Self {
        Self { attenuation, range: None, window: PhantomData }
    }

    /// Returns the attenuation without its range.
    pub fn attenuation(&self) -> A {
        self.attenuation
    }

    /// Returns the range of the light; `None` for a light without a range.
    pub fn range(&self) -> Option<f32> {
        self.range
    }
}

impl<W: Window, A: Named> Named for Ranged<W, A> {
    fn write_name(out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "{}{}>", W::TYPE, name::<A>())
    }
}

impl<W: Window, A: Attenuation> Attenuation for Ranged<W, A> {
    /// The reciprocal of the squared range (0 without a range), and the constants of the inner
    /// attenuation.
    type Constants<S: Scalar> = (S::Gain, A::Constants<S>);

    fn constants<S: Scalar>(self) -> Self::Constants<S> {
        (inverse_squared::<S>(self.range), self.attenuation.constants::<S>())
    }

    fn range(&self) -> Option<f32> {
        self.range
    }

    fn effects(&self) -> Effects {
        let effects = self.attenuation.effects();
        if self.range.is_some() { effects.union(W::EFFECTS).with(Effect::Range) } else { effects }
    }

    fn exact(&self, distance: f64) -> f64 {
        let window = self.range.map_or(1.0, |range| W::exact(distance / f64::from(range)));
        window * self.attenuation.exact(distance)
    }

    fn growth(&self) -> f32 {
        self.attenuation.growth()
    }

    #[cfg(feature = "arithmetic")]
    fn with<V: WithAttenuation>(self, visitor: V) -> V::Output {
        if self.range.is_some() { visitor.attenuation(self) } else { self.attenuation.with(visitor) }
    }

    #[inline]
    fn is_inverse_square<S: Scalar>((squared, inner): &Self::Constants<S>) -> bool {
        *squared == S::gain(0.0) && A::is_inverse_square::<S>(inner)
    }

    #[inline]
    fn is_beyond<S: Scalar, O: Offset<S>>((squared, inner): &Self::Constants<S>, offset: &O) -> bool {
        squared_fraction::<S, O>(*squared, offset) == S::ONE || A::is_beyond::<S, O>(inner, offset)
    }

    #[inline]
    fn windowed<S: Scalar, O: Offset<S>, R: Ray<S>>(
        (squared, inner): &Self::Constants<S>,
        offset: &O,
        ray: &R,
        share: R::Share,
    ) -> R::Share {
        A::windowed::<S, O, R>(
            inner,
            offset,
            ray,
            W::dim::<S, _>(share, ray.squared_range_share(offset, *squared)),
        )
    }

    #[inline(always)] // `lit-gltf-range` on Cortex-M0: +31 instructions without.
    fn light<S: Scalar, O: Offset<S>, R: Ray<S>>(
        (squared, inner): &Self::Constants<S>,
        offset: &O,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        let share = W::dim::<S, _>(share, ray.squared_range_share(offset, *squared));
        A::light::<S, O, R>(inner, offset, ray, share, intensity)
    }
}
