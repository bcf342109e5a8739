//! The profiles, each beside the truth about it.

use luminaire::falloff::{
    Cubic, Falloff, Hard, InvertedPower, Linear, Power, Quadratic, Smooth, Soft, Step, Table,
};

/// A profile of the crate `luminaire` and what it stands for.
pub trait Shape: Falloff {
    /// The name on the price list.
    const NAME: &'static str;
    /// Whether the intensity jumps at the edge.
    const JUMPS: bool = false;
    /// The intensity in f64, as the literature writes it.
    const EXACT: fn(f64) -> f64;

    /// The intensity in f64, with as few operations as there must be.
    fn double(t: f64) -> f64;
}

/// A measured fixture: intensities that are evenly spaced in the versine, 65,535 being one.
pub const SAMPLES: [u16; 10] = [65_535, 65_000, 63_211, 60_007, 51_234, 39_876, 24_321, 11_111, 3_210, 0];

/// The quadratic halfway from soft to linear.
pub(crate) fn blend() -> Quadratic {
    Quadratic::new(0.5).expect("a slope from 0 to 2")
}

/// A steep cubic: of slopes 1.25 at the edge and 3.5 in the middle.
pub(crate) fn cubic() -> Cubic {
    Cubic::with_slopes(1.25, 3.5).expect("slopes of a monotone cubic")
}

pub(crate) fn table() -> Table<'static> {
    Table::new(&SAMPLES).expect("enough samples")
}

/// A shape whose two forms in f64 are `exact` and `double`.
macro_rules! shape {
    ($profile:ty, $name:literal, $jumps:literal, |$t:ident| $exact:expr, $double:expr) => {
        impl Shape for $profile {
            const NAME: &'static str = $name;
            const JUMPS: bool = $jumps;
            const EXACT: fn(f64) -> f64 = |$t| $exact;

            #[inline(always)]
            fn double($t: f64) -> f64 {
                $double
            }
        }
    };
}

shape!(Soft, "soft", false, |t| t * t, t * t);
shape!(Hard, "hard", false, |t| 1.0 - (1.0 - t) * (1.0 - t), t * (2.0 - t));
shape!(Linear, "linear", false, |t| t, t);
shape!(Step, "cut-off", true, |t| if t > 0.0 { 1.0 } else { 0.0 }, if t > 0.0 { 1.0 } else { 0.0 });
shape!(Smooth, "smooth", false, |t| t * t * (3.0 - 2.0 * t), t * t * (3.0 - 2.0 * t));
shape!(Quadratic, "blend", false, |t| 0.5 * t + 0.5 * t * t, t * (0.5 + 0.5 * t));
shape!(
    Cubic,
    "cubic",
    false,
    |t| 1.25 * t - 3.0 * t * t + 2.75 * t * t * t,
    t * (1.25 + t * (2.75 * t - 3.0))
);
shape!(Power<4>, "power-4", false, |t| libm::pow(t, 4.0), squared(squared(t)));
shape!(Power<16>, "power-16", false, |t| libm::pow(t, 16.0), squared(squared(squared(squared(t)))));
shape!(InvertedPower<4>, "rim-4", false, |t| 1.0 - libm::pow(1.0 - t, 4.0), 1.0 - squared(squared(1.0 - t)));
shape!(Table<'_>, "table", false, |t| interpolated(t), interpolated(t));

#[inline(always)]
fn squared(x: f64) -> f64 {
    x * x
}

/// Linear interpolation in [`SAMPLES`].
#[inline(always)]
fn interpolated(t: f64) -> f64 {
    let segments = SAMPLES.len() - 1;
    let place = (1.0 - t) * segments as f64;
    let index = (place as usize).min(segments - 1);
    let (from, to) = (f64::from(SAMPLES[index]), f64::from(SAMPLES[index + 1]));
    (from + (to - from) * (place - index as f64)) / 65_535.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_forms<P: Shape>(_: P) {
        for i in 0..=1000 {
            let t = f64::from(i) / 1000.0;
            let (exact, double) = ((P::EXACT)(t), P::double(t));
            assert!((exact - double).abs() < 1e-15, "{} at {t}: {exact} and {double}", P::NAME);
        }
        assert_eq!((P::double(0.0), P::double(1.0)), (0.0, 1.0), "{}", P::NAME);
    }

    #[test]
    fn both_forms_are_one_function_with_its_ends_in_place() {
        assert_forms(Soft);
        assert_forms(Hard);
        assert_forms(Linear);
        assert_forms(Step);
        assert_forms(Smooth);
        assert_forms(blend());
        assert_forms(cubic());
        assert_forms(Power::<4>);
        assert_forms(Power::<16>);
        assert_forms(InvertedPower::<4>);
        assert_forms(table());
    }
}
