//! The Pareto frontier of accuracy and cost.

/// The indices of the points `(cost, error)` on the frontier, the cheapest first: no other point
/// has at most the same cost and error with one of them smaller.
pub(crate) fn frontier(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<_> = (0..points.len()).collect();
    order.sort_by(|&a, &b| points[a].0.total_cmp(&points[b].0).then(points[a].1.total_cmp(&points[b].1)));
    let mut best = f64::INFINITY;
    order.retain(|&index| {
        let is_better = points[index].1 < best;
        best = best.min(points[index].1);
        is_better
    });
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_costs_more_must_err_less() {
        let points = [(1.0, 9.0), (3.0, 1.0), (2.0, 9.0), (2.0, 4.0), (4.0, 2.0), (3.0, 0.5)];
        assert_eq!(frontier(&points), [0, 3, 5]);
        assert_eq!(frontier(&[]), [0; 0]);
    }
}
