//! The quadrature of many rays, node by node: the falloff is evaluated at the nodes of all rays in one loop, so a
//! falloff that is chosen at run time is chosen once.

use super::{
    BeamScattering, ViewRays,
    arc::{Arc, Span},
    beam::{greater, lesser},
    quadrature::{NODES, by_angle, integrate, nodes, weighed},
};
use crate::{attenuation::Attenuation, falloff::Falloff};

/// A value for each ray at each node of the two rims: before and behind the part of the arc with full intensity.
pub(crate) type AtNodes<const N: usize> = [[[f32; N]; NODES]; 2];

impl<P: Falloff, A: Attenuation> BeamScattering<P, A> {
    /// Computes the in-scattered light of `N` rays by quadrature, for the inverse square, with the bits of
    /// [`by_nodes`](Self::by_nodes). `at_each` sets the intensities of the falloff at versines.
    #[inline]
    pub(crate) fn by_nodes_each<const N: usize>(
        &self,
        rays: &ViewRays<N>,
        at_each: impl FnOnce(&AtNodes<N>, &mut AtNodes<N>),
        lights: &mut [f32; N],
    ) {
        let (extent, full) = (self.extent(), self.falloff.at(0.0));
        let [mut versines, mut shares, mut intensities]: [AtNodes<N>; 3] = [[[[0.0; N]; NODES]; 2]; 3];
        let mut limits = [[[0.0; N]; 2]; 2];
        let [mut middles, mut scales] = [[0.0; N]; 2];
        let mut is_any = [false; N];
        for i in 0..N {
            let arc = Arc::new(&extent, &rays.at(i));
            let [inner, outer] = self.cone.map(|versine| arc.edge(versine));
            let Span { from, to, scale } = arc.span(outer);
            let rims = [[from, lesser(to, -inner)], [greater(from, inner), to]];
            let of_rims = limits.iter_mut().zip(versines.iter_mut().zip(&mut shares));
            for ([from, to], ([starts, ends], (versines, shares))) in rims.iter().zip(of_rims) {
                (starts[i], ends[i]) = (*from, *to);
                for (v, (versines, shares)) in nodes(*from, *to).iter().zip(versines.iter_mut().zip(shares)) {
                    shares[i] = 1.0 / (1.0 + v * v);
                    versines[i] = arc.versine(*v, shares[i]);
                }
            }
            middles[i] = integrate(greater(from, -inner), lesser(to, inner), |v| by_angle(v, |_| full));
            scales[i] = scale;
            is_any[i] = arc.is_any();
        }
        at_each(&versines, &mut intensities);
        for (i, light) in lights.iter_mut().enumerate() {
            let mut rims = [0.0; 2];
            let of_rims = limits.iter().zip(&shares).zip(&intensities);
            for (rim, (([starts, ends], shares), intensities)) in rims.iter_mut().zip(of_rims) {
                let mut values = [0.0; NODES];
                for (value, (shares, intensities)) in values.iter_mut().zip(shares.iter().zip(intensities)) {
                    *value = 2.0 * shares[i] * intensities[i];
                }
                *rim = weighed(starts[i], ends[i], values);
            }
            let [before, behind] = rims;
            *light = self.gained(is_any[i], scales[i] * (before + middles[i] + behind));
        }
    }
}
