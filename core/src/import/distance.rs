//! The distance model of an imported light.

use crate::{
    attenuation::{
        Attenuation, Faded, HardRange, InverseSquare, Polynomial, RayOf, SquaredWindow, Unattenuated,
        Windowed,
    },
    scalar::Scalar,
};

/// The distance model that matches a light of another system, chosen at run time at the price of a branch per
/// point.
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
        }
    };
    ($model:ident = $type:ty; $answer:expr) => {{
        type $model = $type;
        $answer
    }};
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
        }
    }

    #[inline(always)]
    fn is_beyond<S: Scalar>(constants: &CompiledDistance<S>, offset: &S::Offset) -> bool {
        compiled!(constants, model: Model => Model::is_beyond::<S>(model, offset))
    }

    #[inline(always)]
    fn expose<S: Scalar>(
        constants: &CompiledDistance<S>,
        offset: &S::Offset,
        ray: &RayOf<S>,
        fraction: S,
        intensity: S::Gain,
    ) -> S::Irradiance {
        compiled!(constants, model: Model => Model::expose::<S>(model, offset, ray, fraction, intensity))
    }
}
