//! The angles that monotone cubics can have, found by search in f64 without any formula of the
//! kernel.

/// A cubic `t (a + t (b + t c))` by its slopes at `t = 0` and `t = 1`.
#[derive(Clone, Copy, Debug)]
pub struct Cubic {
    pub a: f64,
    pub b: f64,
    pub c: f64,
}

impl Cubic {
    pub fn with_slopes(edge: f64, middle: f64) -> Self {
        Self { a: edge, b: 3.0 - 2.0 * edge - middle, c: edge + middle - 2.0 }
    }

    pub fn at(&self, t: f64) -> f64 {
        t * (self.a + t * (self.b + t * self.c))
    }

    /// The smallest slope over [0, 1]: at an end, or where the second derivative is zero.
    pub fn smallest_slope(&self) -> f64 {
        let slope = |t: f64| self.a + t * (2.0 * self.b + t * 3.0 * self.c);
        let turn = (-self.b / (3.0 * self.c)).clamp(0.0, 1.0);
        slope(0.0).min(slope(1.0)).min(if turn.is_finite() { slope(turn) } else { f64::INFINITY })
    }

    /// Returns `1 - t` at the `t` where the cubic has this intensity.
    pub fn versine_of(&self, intensity: f64) -> f64 {
        let (mut dark, mut light) = (0.0, 1.0);
        for _ in 0..50 {
            let middle = (dark + light) / 2.0;
            if self.at(middle) < intensity { dark = middle } else { light = middle }
        }
        1.0 - light
    }

    /// The versine at the field angle divided by the versine at the beam angle.
    pub fn ratio(&self) -> f64 {
        self.versine_of(0.1) / self.versine_of(0.5)
    }
}

/// The monotone cubics with an edge slope, out of `count` cubics with evenly spaced middle slopes
/// from 0 to 4.
pub fn of_edge_slope(edge: f64, count: usize) -> impl Iterator<Item = Cubic> {
    let all = (0..=count).map(move |i| Cubic::with_slopes(edge, 4.0 * i as f64 / count as f64));
    all.filter(|cubic| cubic.smallest_slope() >= -1e-9)
}

/// The smallest and the largest ratio of the monotone cubics with an edge slope.
pub fn ratios(edge: f64, count: usize) -> Option<(f64, f64)> {
    of_edge_slope(edge, count).map(|cubic| cubic.ratio()).fold(None, |range, ratio| {
        Some(range.map_or((ratio, ratio), |(least, most): (f64, f64)| (least.min(ratio), most.max(ratio))))
    })
}
