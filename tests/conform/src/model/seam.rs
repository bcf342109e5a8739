//! The arithmetic of a format, below the models.

use crate::case::{Case, Outcome};
use crate::word::Format;

/// A number converted to a scalar and to a length, and the scalar converted back.
pub(super) fn convert<S: Format>(case: &mut Case<'_>) -> Outcome {
    let number = case.number("number");
    case.give(S::from_f32(number));
    case.give(S::length(number));
    case.give(S::from_f32(number).to_f32());
    Ok(())
}

/// Product and difference of two scalars, and the smooth step of the first.
pub(super) fn arithmetic<S: Format>(case: &mut Case<'_>) -> Outcome {
    let (a, b) = (case.scalar::<S>("linear"), case.scalar::<S>("factor"));
    case.give(a.times(b));
    case.give(a.minus(b));
    case.give(a.smooth());
    Ok(())
}

/// The first channel of a light after a filter, and the sum of the other two channels.
pub(super) fn light<S: Format>(case: &mut Case<'_>) -> Outcome {
    let (light, filter) = (case.light::<S>("light"), case.scalar::<S>("factor"));
    case.give(S::filter(light.red, filter));
    case.give(light.green + light.blue);
    Ok(())
}
