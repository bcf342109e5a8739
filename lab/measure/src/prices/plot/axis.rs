//! A logarithmic axis.

/// From values to places in the picture, by their logarithm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    /// Logarithms to base ten.
    least: f64,
    most: f64,
    from: f64,
    to: f64,
    /// Whether ticks stand at 2 and 5 too.
    is_fine: bool,
}

impl Axis {
    /// An axis of whole decades that holds all of these values, from one place to another.
    pub(super) fn decades(values: impl Iterator<Item = f64>, (from, to): (f64, f64)) -> Self {
        let (least, most) = ends(values);
        Self { least: least.floor(), most: most.ceil(), from, to, is_fine: false }
    }

    /// An axis that ends a little beyond the values.
    pub(super) fn steps(values: impl Iterator<Item = f64>, (from, to): (f64, f64)) -> Self {
        let (least, most) = ends(values);
        let margin = 0.06 * (most - least).max(0.5);
        Self { least: least - margin, most: most + 1.5 * margin, from, to, is_fine: most - least < 2.5 }
    }

    /// Where a value stands.
    pub(super) fn place(&self, value: f64) -> f64 {
        let part = (value.log10() - self.least) / (self.most - self.least);
        self.from + part * (self.to - self.from)
    }

    /// The places of the ticks with their values.
    pub(super) fn ticks(&self) -> Vec<(f64, f64)> {
        let steps: &[f64] = if self.is_fine { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let decades = (self.least.floor() as i32)..=(self.most.ceil() as i32);
        let values = decades.flat_map(|decade| steps.iter().map(move |step| rounded(*step, decade)));
        let room = self.least - 1e-9..=self.most + 1e-9;
        values.filter(|value| room.contains(&value.log10())).map(|value| (self.place(value), value)).collect()
    }
}

/// The logarithms of the least and the most of some values.
fn ends(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let ends = values
        .map(f64::log10)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)));
    if ends.0 <= ends.1 { ends } else { (0.0, 1.0) }
}

/// A step of a decade, as it is written.
fn rounded(step: f64, decade: i32) -> f64 {
    if decade < 0 { step / 10_f64.powi(-decade) } else { step * 10_f64.powi(decade) }
}

/// The power of ten nearest to a value.
pub(super) fn power_of_ten(value: f64) -> i32 {
    value.log10().round() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_numbers_in_their_places() {
        let axis = Axis::decades([0.02, 30.0].into_iter(), (0.0, 400.0));
        assert_eq!(axis.ticks(), [(0.0, 0.01), (100.0, 0.1), (200.0, 1.0), (300.0, 10.0), (400.0, 100.0)]);
        let axis = Axis::steps([10.0, 100.0].into_iter(), (0.0, 1.0));
        let values: Vec<_> = axis.ticks().into_iter().map(|(_, value)| value).collect();
        assert_eq!(values, [10.0, 20.0, 50.0, 100.0]);
    }
}
