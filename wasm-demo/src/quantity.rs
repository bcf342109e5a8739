//! The quantities that a visitor changes on the desk and in the class: one table, so that both have the
//! same names, units and ranges.

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
}

/// The constants of the law of distance `1 / (a + b d + c d^2)`, capped at 1.
pub(crate) const CONSTANT: Quantity = linear("a", "Constant a", "", [0.0, 4.0]);
/// See [`CONSTANT`].
pub(crate) const LINEAR: Quantity = linear("b", "Linear b", " /m", [0.0, 2.0]);
/// See [`CONSTANT`].
pub(crate) const QUADRATIC: Quantity = linear("c", "Quadratic c", " /m²", [0.0, 2.0]);
/// The exponent of a highlight.
pub(crate) const SHININESS: Quantity = logarithmic("shininess", "Shininess", "", [8.0, 1024.0]);

const fn linear(name: &'static str, label: &'static str, unit: &'static str, ends: [f32; 2]) -> Quantity {
    Quantity { name, label, unit, ends, is_logarithmic: false }
}

const fn logarithmic(
    name: &'static str,
    label: &'static str,
    unit: &'static str,
    ends: [f32; 2],
) -> Quantity {
    Quantity { is_logarithmic: true, ..linear(name, label, unit, ends) }
}
