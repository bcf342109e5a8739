//! Attenuations in `f32`.
//!
//! Each attenuation of the list of models has an `impl` here. Without one, the list in
//! `crate::models` does not compile.

use luminaire::attenuation::{
    Attenuation, Cut, GltfWindow, InverseSquare, NoAttenuation, Polynomial, Ranged, SmoothRange,
    SquareWindow, Window,
};

use super::expression::{Builtin, Expression, Statement, Type, call, clamp, if_less, name, number, quotient};

/// The brightest irradiance of one light: 2^64.
const BRIGHTEST: f32 = 18_446_744_073_709_551_616.0;

/// The body of the function of the irradiance, which has the locals `squared`, the squared distance,
/// and `reciprocal`, the reciprocal distance.
#[derive(Debug)]
pub(crate) struct Body<'a> {
    /// The statements.
    pub(crate) statements: &'a mut Vec<Statement>,
    /// The name of the constant with the intensity.
    pub(crate) intensity: String,
}

impl Body<'_> {
    /// Adds a local number.
    fn local(&mut self, local: &str, value: Expression) -> Expression {
        self.statements.push(Statement::Let(Type::Number, local.to_owned(), value));
        name(local)
    }

    fn distance(&mut self) -> Expression {
        self.local("distance", Expression::Call(Builtin::Sqrt, vec![name("squared")]))
    }
}

/// Returns a share of a gain, at most the brightest irradiance.
fn give(share: Expression, gain: Expression) -> Expression {
    call(Builtin::Min, share * gain, number(BRIGHTEST))
}

/// Returns the share of a light of which a factor arrives.
fn dimmed(body: &mut Body<'_>, share: Expression, factor: Expression) -> Expression {
    body.local("dimmed", share * factor)
}

/// An attenuation as code in `f32`.
pub(crate) trait FloatAttenuation {
    /// Returns the irradiance: a share of the intensity, attenuated.
    fn irradiance(&self, body: &mut Body<'_>, share: Expression) -> Expression;
}

impl FloatAttenuation for NoAttenuation {
    fn irradiance(&self, body: &mut Body<'_>, share: Expression) -> Expression {
        give(share, name(&body.intensity))
    }
}

impl FloatAttenuation for InverseSquare {
    fn irradiance(&self, body: &mut Body<'_>, share: Expression) -> Expression {
        let gain = name(&body.intensity) * (name("reciprocal") * name("reciprocal"));
        share * call(Builtin::Min, gain, number(BRIGHTEST))
    }
}

impl FloatAttenuation for Polynomial {
    fn irradiance(&self, body: &mut Body<'_>, share: Expression) -> Expression {
        let [constant, linear, quadratic] = self.coefficients().map(number);
        let distance = body.distance();
        let divisor = (quadratic * distance.clone() + linear) * distance + constant;
        let divisor = body.local("divisor", call(Builtin::Max, divisor, number(1.0)));
        give(share, quotient(number(1.0), divisor) * name(&body.intensity))
    }
}

impl FloatAttenuation for SmoothRange {
    fn irradiance(&self, body: &mut Body<'_>, share: Expression) -> Expression {
        let distance = body.distance();
        let t =
            body.local("nearness", number(1.0) - clamp(distance * number(1.0 / SmoothRange::range(self))));
        let smooth = t.clone() * t.clone() * (number(3.0) - number(2.0) * t);
        let squared = fraction(SmoothRange::range(self));
        let smooth = if_less(squared, number(1.0), smooth, number(0.0));
        let share = dimmed(body, share, smooth);
        give(share, name(&body.intensity))
    }
}

/// Returns the squared distance in units of the squared range, at most 1.
fn fraction(range: f32) -> Expression {
    clamp(name("squared") * number(1.0 / (range * range)))
}

impl<W: FloatWindow, A: FloatAttenuation + Attenuation> FloatAttenuation for Ranged<W, A> {
    fn irradiance(&self, body: &mut Body<'_>, share: Expression) -> Expression {
        let share = match Ranged::range(self) {
            Some(range) => {
                let squared = body.local("squared_fraction", fraction(range));
                W::narrow(body, share, squared)
            }
            None => share,
        };
        self.attenuation().irradiance(body, share)
    }
}

/// A window as code in `f32`.
pub(crate) trait FloatWindow: Window {
    /// Returns the share at a squared distance in units of the squared range.
    fn narrow(body: &mut Body<'_>, share: Expression, squared: Expression) -> Expression;
}

impl FloatWindow for Cut {
    fn narrow(body: &mut Body<'_>, share: Expression, squared: Expression) -> Expression {
        body.local("cut", if_less(squared, number(1.0), share, number(0.0)))
    }
}

impl FloatWindow for GltfWindow {
    fn narrow(body: &mut Body<'_>, share: Expression, squared: Expression) -> Expression {
        dimmed(body, share, number(1.0) - squared.clone() * squared)
    }
}

impl FloatWindow for SquareWindow {
    fn narrow(body: &mut Body<'_>, share: Expression, squared: Expression) -> Expression {
        let window = body.local("window", number(1.0) - squared.clone() * squared);
        dimmed(body, share, window.clone() * window)
    }
}
