//! The quantities that a visitor changes on the desk and in the class: one table, so that both have the
//! same names, units and ranges. The numbers of laws and edges on the desk are those of the library's lists.

/// What a dial or a field of the page changes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Quantity {
    /// The name in addresses.
    pub(crate) name: &'static str,
    /// The name for people.
    pub(crate) label: &'static str,
    /// The unit, as it follows a number; empty for a number without one.
    pub(crate) unit: &'static str,
    /// The least and the largest value.
    pub(crate) ends: [f32; 2],
    /// Whether a slider has the same way for each factor, and not for each difference.
    pub(crate) is_logarithmic: bool,
    /// Whether the value is an integer.
    pub(crate) is_whole: bool,
}

/// The constants of the law of distance `1 / (a + b d + c d^2)`, capped at 1.
pub(crate) const CONSTANT: Quantity = linear("a", "Constant a", "", [0.0, 4.0]);
pub(crate) const LINEAR: Quantity = linear("b", "Linear b", " /m", [0.0, 2.0]);
pub(crate) const QUADRATIC: Quantity = linear("c", "Quadratic c", " /m²", [0.0, 2.0]);
/// The exponent of a highlight.
pub(crate) const SHININESS: Quantity = whole(logarithmic("shininess", "Shininess", "", [8.0, 1024.0]));
/// The height of a lamp over the floor.
pub(crate) const HEIGHT: Quantity = linear("height", "Height of the lamp", " m", [3.0, 8.0]);
/// A distance from a light.
pub(crate) const DISTANCE: Quantity = linear("d", "Distance d", " m", [1.0, 4.0]);
/// OpenGL's exponent of the cosine.
pub(crate) const EXPONENT: Quantity = linear("p", "Exponent p", "", [0.0, 128.0]);
/// OpenGL's half angle from which on there is no light.
pub(crate) const CUTOFF: Quantity = linear("cutoff", "Cutoff angle δ", "°", [1.0, 90.0]);
/// The half angle up to which a cone has full intensity.
pub(crate) const INNER: Quantity = linear("inner", "Inner half angle", "°", [0.0, 40.0]);
/// The half angle at which a cone ends.
pub(crate) const OUTER: Quantity = linear("outer", "Outer half angle", "°", [1.0, 40.0]);
/// The distance at which a light ends.
pub(crate) const RANGE: Quantity = linear("range", "Range", " m", [2.0, 20.0]);
/// Direct3D's full inner angle.
pub(crate) const THETA: Quantity = linear("theta", "Theta, inner", "°", [0.0, 170.0]);
/// Direct3D's full outer angle.
pub(crate) const PHI: Quantity = linear("phi", "Phi, outer", "°", [1.0, 170.0]);
/// Direct3D's exponent.
pub(crate) const FALLOFF: Quantity = linear("falloff", "Falloff p", "", [0.0, 8.0]);
/// A field angle that a power of the cosine has, too, with an exponent of at most 1,024.
pub(crate) const FIELD: Quantity = linear("field", "Field angle", "°", [8.0, 140.0]);
/// A beam angle.
pub(crate) const BEAM: Quantity = linear("beam", "Beam angle", "°", [2.0, 90.0]);
/// A beam or a field angle.
pub(crate) const GIVEN: Quantity = linear("angle", "Given angle", "°", [1.0, 170.0]);
/// Where a cone is cut off, in percent of its outer angle.
pub(crate) const CUT: Quantity = linear("cut", "Cut off at", " %", [10.0, 100.0]);
/// The bits of a signed number in fixed point.
pub(crate) const BITS: Quantity = whole(linear("bits", "Bits n", "", [6.0, 16.0]));
/// A thin half angle.
pub(crate) const THIN: Quantity = logarithmic("half", "Outer half angle", "°", [0.01, 10.0]);
/// The bits of a code of a display.
pub(crate) const CODE_BITS: Quantity = whole(linear("bits", "Bits of a code", "", [1.0, 8.0]));

const fn linear(name: &'static str, label: &'static str, unit: &'static str, ends: [f32; 2]) -> Quantity {
    Quantity { name, label, unit, ends, is_logarithmic: false, is_whole: false }
}

const fn logarithmic(
    name: &'static str,
    label: &'static str,
    unit: &'static str,
    ends: [f32; 2],
) -> Quantity {
    Quantity { is_logarithmic: true, ..linear(name, label, unit, ends) }
}

const fn whole(quantity: Quantity) -> Quantity {
    Quantity { is_whole: true, ..quantity }
}
