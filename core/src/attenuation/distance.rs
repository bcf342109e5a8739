//! Any distance model, chosen at run time.

use super::{
    Attenuation, Faded, HardRange, InverseSquare, Polynomial, SmoothRange, SquaredWindow, Unattenuated,
    Windowed,
};
use crate::scalar::{Ray, Scalar};

/// Any distance model, chosen at run time: the one that matches a light of [another system](crate::import), or that a
/// [`Lamp`](crate::Lamp) was given.
///
/// It branches per point; [`CompiledLamp::arrive_each`](crate::CompiledLamp::arrive_each) branches once per light
/// instead, and goes on with the model's own type.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Distance {
    /// No fall, cut off.
    Constant(HardRange<Unattenuated>),
    /// The inverse-square law, cut off.
    InverseSquare(HardRange<InverseSquare>),
    /// One over a polynomial, cut off.
    Polynomial(HardRange<Polynomial>),
    /// The inverse-square law in glTF's window.
    Windowed(Windowed),
    /// No fall, faded out.
    FadedConstant(Faded<Unattenuated>),
    /// The inverse-square law, faded out.
    SquaredWindow(SquaredWindow),
    /// One over a polynomial, faded out.
    FadedPolynomial(Faded<Polynomial>),
    /// Smoothstep to a range.
    SmoothRange(SmoothRange),
}

/// What a [`Distance`] knows once it is compiled.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CompiledDistance<S: Scalar> {
    /// No fall, cut off.
    Constant(<HardRange<Unattenuated> as Attenuation>::Constants<S>),
    /// The inverse-square law, cut off.
    InverseSquare(<HardRange<InverseSquare> as Attenuation>::Constants<S>),
    /// One over a polynomial, cut off.
    Polynomial(<HardRange<Polynomial> as Attenuation>::Constants<S>),
    /// The inverse-square law in glTF's window.
    Windowed(<Windowed as Attenuation>::Constants<S>),
    /// No fall, faded out.
    FadedConstant(<Faded<Unattenuated> as Attenuation>::Constants<S>),
    /// The inverse-square law, faded out.
    SquaredWindow(<SquaredWindow as Attenuation>::Constants<S>),
    /// One over a polynomial, faded out.
    FadedPolynomial(<Faded<Polynomial> as Attenuation>::Constants<S>),
    /// Smoothstep to a range.
    SmoothRange(<SmoothRange as Attenuation>::Constants<S>),
}

/// What the model in the enum answers, by its type.
macro_rules! compiled {
    ($choice:ident, $constants:ident: $model:ident => $answer:expr) => {
        match $choice {
            CompiledDistance::Constant($constants) => compiled!($model = HardRange<Unattenuated>; $answer),
            CompiledDistance::InverseSquare($constants) => compiled!($model = HardRange<InverseSquare>; $answer),
            CompiledDistance::Polynomial($constants) => compiled!($model = HardRange<Polynomial>; $answer),
            CompiledDistance::Windowed($constants) => compiled!($model = Windowed; $answer),
            CompiledDistance::FadedConstant($constants) => compiled!($model = Faded<Unattenuated>; $answer),
            CompiledDistance::SquaredWindow($constants) => compiled!($model = SquaredWindow; $answer),
            CompiledDistance::FadedPolynomial($constants) => compiled!($model = Faded<Polynomial>; $answer),
            CompiledDistance::SmoothRange($constants) => compiled!($model = SmoothRange; $answer),
        }
    };
    ($model:ident = $type:ty; $answer:expr) => {{
        type $model = $type;
        $answer
    }};
}

impl Distance {
    /// Where the light ends, if it does.
    pub fn range(&self) -> Option<f32> {
        match self {
            Self::Constant(model) => model.range(),
            Self::InverseSquare(model) => model.range(),
            Self::Polynomial(model) => model.range(),
            Self::Windowed(model) => model.range(),
            Self::FadedConstant(model) => model.range(),
            Self::SquaredWindow(model) => model.range(),
            Self::FadedPolynomial(model) => model.range(),
            Self::SmoothRange(model) => Some(model.range()),
        }
    }
}

/// A model of one type as one of any.
macro_rules! from {
    ($($model:ty => $variant:ident,)*) => {$(
        impl From<$model> for Distance {
            fn from(model: $model) -> Self {
                Self::$variant(model)
            }
        }
    )*};
}

from! {
    HardRange<Unattenuated> => Constant,
    HardRange<InverseSquare> => InverseSquare,
    HardRange<Polynomial> => Polynomial,
    Windowed => Windowed,
    Faded<Unattenuated> => FadedConstant,
    SquaredWindow => SquaredWindow,
    Faded<Polynomial> => FadedPolynomial,
    SmoothRange => SmoothRange,
}

impl From<Unattenuated> for Distance {
    fn from(model: Unattenuated) -> Self {
        Self::Constant(HardRange::unlimited(model))
    }
}

impl From<InverseSquare> for Distance {
    fn from(model: InverseSquare) -> Self {
        Self::InverseSquare(HardRange::unlimited(model))
    }
}

impl From<Polynomial> for Distance {
    fn from(model: Polynomial) -> Self {
        Self::Polynomial(HardRange::unlimited(model))
    }
}

impl Attenuation for Distance {
    type Constants<S: Scalar> = CompiledDistance<S>;

    fn constants<S: Scalar>(self) -> CompiledDistance<S> {
        match self {
            Self::Constant(model) => CompiledDistance::Constant(model.constants::<S>()),
            Self::InverseSquare(model) => CompiledDistance::InverseSquare(model.constants::<S>()),
            Self::Polynomial(model) => CompiledDistance::Polynomial(model.constants::<S>()),
            Self::Windowed(model) => CompiledDistance::Windowed(model.constants::<S>()),
            Self::FadedConstant(model) => CompiledDistance::FadedConstant(model.constants::<S>()),
            Self::SquaredWindow(model) => CompiledDistance::SquaredWindow(model.constants::<S>()),
            Self::FadedPolynomial(model) => CompiledDistance::FadedPolynomial(model.constants::<S>()),
            Self::SmoothRange(model) => CompiledDistance::SmoothRange(model.constants::<S>()),
        }
    }

    fn grows(&self) -> bool {
        match self {
            Self::Constant(_)
            | Self::Polynomial(_)
            | Self::FadedConstant(_)
            | Self::FadedPolynomial(_)
            | Self::SmoothRange(_) => false,
            Self::InverseSquare(_) | Self::Windowed(_) | Self::SquaredWindow(_) => true,
        }
    }

    #[inline(always)]
    fn is_inverse_square<S: Scalar>(constants: &CompiledDistance<S>) -> bool {
        matches!(constants, CompiledDistance::InverseSquare((range, ())) if *range == S::gain(0.0))
    }

    #[inline(always)]
    fn is_beyond<S: Scalar>(constants: &CompiledDistance<S>, offset: &S::Offset) -> bool {
        compiled!(constants, model: Model => Model::is_beyond::<S>(model, offset))
    }

    #[inline(always)]
    fn expose<S: Scalar, R: Ray<S>>(
        constants: &CompiledDistance<S>,
        offset: &S::Offset,
        ray: &R,
        share: R::Share,
        intensity: S::Gain,
    ) -> S::Irradiance {
        compiled!(constants, model: Model => Model::expose::<S, R>(model, offset, ray, share, intensity))
    }
}
