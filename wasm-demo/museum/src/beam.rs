//! A light, exact and faulty.

use luminaire::{
    Cone, Error,
    dynamic::AnyLight,
    falloff::{AnyFalloff, Falloff},
};
use luminaire_oracle as oracle;
use std::fmt;

use crate::{seen::Seen, view::View};

/// An exhibit at one value of its control.
pub struct Beam {
    /// The points of the picture.
    pub view: View,
    /// The light that is meant, as the crate describes it.
    pub ours: AnyLight,
    /// The light that is meant: the light that arrives at a surface that faces the light, at a
    /// versine off the axis and at a distance.
    pub exact: Box<dyn Fn(f64, f64) -> f64>,
    /// The light that arrives at a surface that faces the light, by the faulty formula.
    pub faulty: Box<dyn Fn(&Seen) -> f32>,
}

impl Beam {
    /// The beam of a cone without attenuation, beside the faulty formula.
    ///
    /// # Errors
    /// A cone that the crate refuses.
    pub(crate) fn of_cone(
        view: View,
        cone: Cone<impl Falloff + Into<AnyFalloff>>,
        exact: oracle::Cone,
        faulty: impl Fn(&Seen) -> f32 + 'static,
    ) -> Result<Self, Error> {
        Ok(Self {
            view,
            ours: view.spot(cone)?,
            exact: Box::new(move |versine, _| exact.falloff(versine)),
            faulty: Box::new(faulty),
        })
    }
}

impl fmt::Debug for Beam {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Beam").field("view", &self.view).field("ours", &self.ours).finish_non_exhaustive()
    }
}
