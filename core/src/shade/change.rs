//! The colours of compiled lights, and their changes at run time: position, aim, brightness and colour.
//!
//! No function of this module computes in floats in a fixed-point format. A change costs a small
//! part of [`SpotLight::compile`](crate::SpotLight::compile), because the cone stays compiled.

use super::{
    CompiledDirectionalLight, CompiledMeasuredLight, CompiledPointLight, CompiledSpotLight, QuickSpotLight,
};
use crate::{
    attenuation::Attenuation,
    color::Rgb,
    cone::CompiledCone,
    falloff::Falloff,
    number::{Gain, Offset, Quick, Scalar, across, unit},
    vec3::Vec3,
};

/// Implements the colours and the changes that every kind of light has.
macro_rules! change {
    ($light:ty, $($lifetime:lifetime,)? $($parameter:ident: $bound:ident),*) => {
        impl<$($lifetime,)? $($parameter: $bound),*> $light {
            /// Returns the light's linear colour.
            pub fn color(&self) -> Rgb<S> {
                self.color
            }

            /// Returns the linear colour of the light's specular highlights.
            pub fn specular_color(&self) -> Rgb<S> {
                self.specular_color
            }

            /// Returns the same light at a part of its intensity, from 0 (dark) to 1 (unchanged).
            ///
            /// A part outside this range is clamped, and NaN is dark. The relative error is at most
            /// 3 * 2^-16 in `Fx16` and 2^-27 in `Fx32` (derived), beside the error of a light of the dimmed
            /// intensity: where the full light is clipped, that of the dimmed one is larger.
            #[must_use]
            pub fn dimmed(self, part: S) -> Self {
                Self { intensity: self.intensity.times_scalar(part), ..self }
            }

            /// Returns the same light in another linear colour. The colour of its specular
            /// highlights does not change.
            #[must_use]
            pub fn with_color(self, color: Rgb<S>) -> Self {
                Self { color, ..self }
            }

            /// Returns the same light with highlights in another linear colour.
            #[must_use]
            pub fn with_specular_color(self, specular_color: Rgb<S>) -> Self {
                Self { specular_color, ..self }
            }
        }
    };
}

change!(CompiledSpotLight<S, P, A>, S: Scalar, P: Falloff, A: Attenuation);
change!(QuickSpotLight<S, P, A>, S: Quick, P: Falloff, A: Attenuation);
change!(CompiledPointLight<S, A>, S: Scalar, A: Attenuation);
change!(CompiledMeasuredLight<'a, S, A>, 'a, S: Scalar, A: Attenuation);
change!(CompiledDirectionalLight<S>, S: Scalar);

impl<S: Scalar, P: Falloff, A: Attenuation> CompiledSpotLight<S, P, A> {
    /// Returns the same light at another position, with the same axis.
    #[must_use]
    pub fn moved_to(self, position: Vec3<S::Length>) -> Self {
        Self { position, ..self }
    }

    /// Returns the same light with its axis through a point; `None` if the point is the light's
    /// position, and in `f32` if the squared distance is not a normal number.
    ///
    /// The axis is within 2.5e-9 radians of the exact one in fixed point, 1.1e-7 in `Fx16` at a point
    /// farther than 256 units, and 1.2e-7 in `f32` (derived).
    #[must_use]
    pub fn aimed_at(self, point: Vec3<S::Length>) -> Option<Self> {
        let axis = unit::<S>(S::Offset::between(self.position, point))?;
        Some(Self { axis, ..self })
    }

    /// Returns the same light with its axis along a vector of any length, which has the type of a
    /// point; `None` if the vector is zero, and in `f32` if its squared length is not a normal number.
    ///
    /// The error of the axis is that of [`aimed_at`](Self::aimed_at).
    #[must_use]
    pub fn aimed_along(self, direction: Vec3<S::Length>) -> Option<Self> {
        let axis = unit::<S>(S::Offset::between(Vec3::default(), direction))?;
        Some(Self { axis, ..self })
    }

    /// Returns the same light with a cone between its own (`part` 0) and that of another light
    /// (`part` 1): zoom.
    ///
    /// The cone is that of [`Cone::zoomed`](crate::Cone::zoomed), and at the ends exactly one of the
    /// two. All else stays that of this light, such as the falloff and the intensity; a gobo or a
    /// shadow map does not zoom with the light.
    ///
    /// The half angles of the outer angle and of the cutoff are within 1.9e-9 radians and 1.3e-8 of their size in fixed
    /// point, and within 3.5e-7 of their size in `f32`. So is the inner angle; in fixed point its versine is off by up to
    /// 2e-9 of the outer one more, and the versine of a hotspot is that which the ramp of the light has (derived). No
    /// fixed-point format divides.
    ///
    /// [`SpotLight::compile_zoom`](crate::SpotLight::compile_zoom) compiles the two lights so that
    /// all cones between them keep the accuracy of the format, and refuses two that cannot. Two lights that are compiled
    /// singly zoom without this promise. In fixed point a cone whose cutoff is within its hotspot zooms as a step.
    #[must_use]
    pub fn zoomed(self, other: &Self, part: S) -> Self {
        if part > S::ZERO {
            let (from, to) = (self.cone.ramp, other.cone.ramp);
            let (ramp, outside) = if part < S::ONE { S::zoomed(from, to, part) } else { (to, other.outside) };
            let cone = CompiledCone { ramp, ..self.cone };
            Self { cone, outside, fine_below: self.fine_below.max(other.fine_below), ..self }
        } else {
            self
        }
    }
}

impl<S: Quick, P: Falloff, A: Attenuation> QuickSpotLight<S, P, A> {
    /// Returns the same light at another position, with the same axis.
    #[must_use]
    pub fn moved_to(self, position: Vec3<S::Length>) -> Self {
        Self { position, ..self }
    }

    /// Returns the same light with its axis through a point, like
    /// [`CompiledSpotLight::aimed_at`].
    #[must_use]
    pub fn aimed_at(self, point: Vec3<S::Length>) -> Option<Self> {
        let axis = unit::<S>(S::Offset::between(self.position, point))?;
        Some(Self { axis: S::quick_axis(axis), ..self })
    }

    /// Returns the same light with its axis along a vector of any length, like
    /// [`CompiledSpotLight::aimed_along`].
    #[must_use]
    pub fn aimed_along(self, direction: Vec3<S::Length>) -> Option<Self> {
        let axis = unit::<S>(S::Offset::between(Vec3::default(), direction))?;
        Some(Self { axis: S::quick_axis(axis), ..self })
    }

    /// Returns the same light with a cone between its own (`part` 0) and that of another light
    /// (`part` 1), like [`CompiledSpotLight::zoomed`].
    ///
    /// [`SpotLight::quick_error_bound`](crate::SpotLight::quick_error_bound) of the cone between bounds the error
    /// (searched), and may be larger than those of the two lights.
    #[must_use]
    pub fn zoomed(self, other: &Self, part: S) -> Self {
        if part > S::ZERO {
            let (from, to) = (self.cone.ramp, other.cone.ramp);
            let (ramp, outside) =
                if part < S::ONE { S::quick_zoomed(from, to, part) } else { (to, other.outside) };
            Self { cone: CompiledCone { ramp, ..self.cone }, outside, ..self }
        } else {
            self
        }
    }
}

impl<S: Scalar, A: Attenuation> CompiledPointLight<S, A> {
    /// Returns the same light at another position.
    #[must_use]
    pub fn moved_to(self, position: Vec3<S::Length>) -> Self {
        Self { position, ..self }
    }
}

impl<S: Scalar, A: Attenuation> CompiledMeasuredLight<'_, S, A> {
    /// Returns the same light at another position, with the same axis and side.
    #[must_use]
    pub fn moved_to(self, position: Vec3<S::Length>) -> Self {
        Self { position, ..self }
    }

    /// Returns the same light with its axis through a point and the side turned with it as little as possible: towards
    /// the present side. `None` if the point is the light's position, if the new axis is along the present side, and in `f32` if
    /// the squared distance is not a normal number.
    ///
    /// The error of the axis is that of [`CompiledSpotLight::aimed_at`]. Side and front are within 2.1e-8 radians of
    /// orthogonal to it in fixed point, and within 7e-7 in `f32`, over the sine of the angle between the new axis and the
    /// present side (derived). A light that follows a target is best aimed from where it was compiled, so that no
    /// errors add up.
    #[must_use]
    pub fn aimed_at(self, point: Vec3<S::Length>) -> Option<Self> {
        self.aimed(S::Offset::between(self.position, point))
    }

    /// Returns the same light with its axis along a vector of any length, which has the type of a point: see
    /// [`aimed_at`](Self::aimed_at).
    #[must_use]
    pub fn aimed_along(self, direction: Vec3<S::Length>) -> Option<Self> {
        self.aimed(S::Offset::between(Vec3::default(), direction))
    }

    fn aimed(self, offset: S::Offset) -> Option<Self> {
        let (axis, [side, ..]) = (unit::<S>(offset)?, self.frame);
        self.framed(axis, side)
    }

    /// Returns the same light, turned about its axis until its side is nearest to a vector of any length, which has the
    /// type of a point. `None` if the vector is zero or along the axis.
    #[must_use]
    pub fn turned_to(self, side: Vec3<S::Length>) -> Option<Self> {
        let (side, [.., axis]) = (unit::<S>(S::Offset::between(Vec3::default(), side))?, self.frame);
        self.framed(axis, side)
    }

    /// Returns the same light with its axis along a vector of any length, which has the type of a point, and its side
    /// nearest to another. `None` if a vector is zero or both have one direction.
    #[must_use]
    pub fn framed_along(self, axis: Vec3<S::Length>, side: Vec3<S::Length>) -> Option<Self> {
        let along = |way| unit::<S>(S::Offset::between(Vec3::default(), way));
        self.framed(along(axis)?, along(side)?)
    }

    fn framed(self, axis: Vec3<S::Unit>, side: Vec3<S::Unit>) -> Option<Self> {
        let [side, front] = across::<S>(axis, side)?;
        Some(Self { frame: [side, front, axis], ..self })
    }
}

impl<S: Scalar> CompiledDirectionalLight<S> {
    /// Returns the same light with its rays along a vector of any length; `None` if the vector is
    /// zero, and in `f32` if its squared length is not a normal number.
    ///
    /// The error of the direction is that of [`CompiledSpotLight::aimed_at`].
    #[must_use]
    pub fn aimed_along(self, direction: Vec3<S::Length>) -> Option<Self> {
        let direction = unit::<S>(S::Offset::between(Vec3::default(), direction))?;
        Some(Self { direction, ..self })
    }
}
