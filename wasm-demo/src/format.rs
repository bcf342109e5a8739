//! The number format: a run-time choice in this module, a type parameter in the code that it calls.

use crate::refusal::{Refusal, choose};
use luminaire::{
    Angle, Cone, Error, Fx16, Fx32, Rgb, Scalar, falloff::Falloff, light::CompiledCone, projector::Fixture,
};
use luminaire_render::{Account, Camera, Display, DrawError, Renderer, Scene, Stripes};

/// One of the kernel's number formats.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Format {
    /// 16-bit fixed point.
    Fx16,
    /// 32-bit fixed point.
    Fx32,
    /// 32-bit floating point.
    F32,
}

/// Evaluates the body with `$S` as the type of the format.
macro_rules! with_scalar {
    ($format:expr, $S:ident => $body:expr) => {
        match $format {
            Format::Fx16 => {
                type $S = Fx16;
                $body
            }
            Format::Fx32 => {
                type $S = Fx32;
                $body
            }
            Format::F32 => {
                type $S = f32;
                $body
            }
        }
    };
}

impl Format {
    pub(crate) const ALL: [Self; 3] = [Self::Fx16, Self::Fx32, Self::F32];

    /// The format of this name.
    pub(crate) fn named(name: &str) -> Result<Self, Refusal> {
        choose("number format", name, &Self::ALL, Self::name)
    }

    /// The name that [`Format::named`] accepts.
    pub(crate) fn name(self) -> &'static str {
        with_scalar!(self, S => S::NAME)
    }

    /// The name for people.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Fx16 => "16-bit fixed point",
            Self::Fx32 => "32-bit fixed point",
            Self::F32 => "32-bit floating point",
        }
    }

    /// Returns whether the format can hold a fixture with its gobo and shadow map.
    pub(crate) fn check_fixture(self, fixture: &Fixture) -> Result<(), Error> {
        with_scalar!(self, S => {
            fixture.light().compile::<S>()?;
            fixture.compile_gobo::<S>()?;
            fixture.shadow().map_or(Ok(()), |(_, projection)| projection.compile::<S>().map(drop))
        })
    }

    /// The largest coordinate of a light's position, in metres.
    pub(crate) fn farthest(self) -> f32 {
        with_scalar!(self, S => S::FARTHEST)
    }

    /// The narrowest cone with this edge that the format holds.
    pub(crate) fn narrowest(self, edge: impl Falloff) -> Angle {
        with_scalar!(self, S => Cone::narrowest::<S>(edge))
    }

    /// The intensities of a cone at angles off its axis, in degrees, as this format evaluates them.
    pub(crate) fn intensities<P: Falloff>(self, cone: &Cone<P>, angles: &[f32]) -> Result<Vec<f32>, Error> {
        with_scalar!(self, S => {
            let falloff: CompiledCone<S, P> = cone.compile()?;
            let versine = |off_axis: f32| falloff.versine(Angle::degrees(2.0 * off_axis).versine());
            Ok(angles.iter().map(|&angle| falloff.at(versine(angle)).to_f32()).collect())
        })
    }

    /// Returns whether this module has the renderer of the format.
    pub(crate) fn is_drawn_here(self) -> bool {
        match self {
            Self::Fx16 => cfg!(feature = "stage"),
            Self::Fx32 | Self::F32 => cfg!(feature = "wide"),
        }
    }

    /// A renderer of these stripes of pictures of a width and height, which evaluates the lights in
    /// this format.
    #[cfg(feature = "painter")]
    pub(crate) fn renderer(self, size: (u32, u32), stripes: Stripes) -> Result<Box<dyn Draw>, Refusal> {
        match self {
            #[cfg(feature = "stage")]
            Self::Fx16 => renderer::<Fx16>(size, stripes),
            #[cfg(feature = "wide")]
            Self::Fx32 => renderer::<Fx32>(size, stripes),
            #[cfg(feature = "wide")]
            Self::F32 => renderer::<f32>(size, stripes),
            #[cfg(not(all(feature = "stage", feature = "wide")))]
            _ => Err(Refusal::name("number format", self.name(), "a format that this module draws")),
        }
    }
}

fn renderer<S: luminaire_render::Format>(
    (width, height): (u32, u32),
    stripes: Stripes,
) -> Result<Box<dyn Draw>, Refusal> {
    Ok(Box::new(Renderer::<S>::of_stripes(width as usize, height as usize, stripes)?))
}

/// Declares the trait [`Draw`] and implements it by the methods of a renderer that have the same names.
macro_rules! draw {
    (
        changes { $($(#[$act_text:meta])* fn $act:ident($($given:ident: $of:ty),*) $(-> $done:ty)?;)+ }
        tells { $($(#[$ask_text:meta])* fn $ask:ident($($asked:ident: $by:ty),*) -> $told:ty;)+ }
    ) => {
        /// A renderer behind a trait object that hides its format: the choice costs one indirect call
        /// per pass, and none per pixel.
        pub(crate) trait Draw {
            $($(#[$act_text])* fn $act(&mut self, $($given: $of),*) $(-> $done)?;)+
            $($(#[$ask_text])* fn $ask(&self, $($asked: $by),*) -> $told;)+
            /// Returns the bits of a fixture's shadow map; empty without a map.
            fn shadow_map(&self, fixture: usize) -> Vec<u32>;
            /// Returns the marks of the pixels beside edges.
            fn edge_marks(&self) -> Vec<u64>;
        }

        impl<S: luminaire_render::Format> Draw for Renderer<S> {
            $(fn $act(&mut self, $($given: $of),*) $(-> $done)? {
                self.$act($($given),*)
            })+
            $(fn $ask(&self, $($asked: $by),*) -> $told {
                self.$ask($($asked),*)
            })+

            fn shadow_map(&self, fixture: usize) -> Vec<u32> {
                self.shadow_map(fixture).map_or(Vec::new(), Iterator::collect)
            }

            fn edge_marks(&self) -> Vec<u64> {
                self.edge_marks().collect()
            }
        }
    };
}

draw! {
    changes {
        /// Draws the geometry if scene or camera has changed. Returns whether it was drawn.
        fn draw_geometry(scene: &Scene, camera: &Camera) -> bool;
        /// Draws the shadow maps whose scene or fixture has changed. Returns whether any was drawn.
        fn draw_shadows(scene: &Scene, fixtures: &[Fixture]) -> Result<bool, DrawError>;
        /// Draws those maps that are dealt to the renderer's stripes. Returns the indices of their
        /// fixtures.
        fn draw_own_shadows(scene: &Scene, fixtures: &[Fixture]) -> Result<Vec<usize>, DrawError>;
        /// Takes a fixture's shadow map from another renderer.
        fn take_shadow_map(
            scene: &Scene, fixtures: &[Fixture], number: usize, depths: &[u32]
        ) -> Result<(), DrawError>;
        /// Switches anti-aliasing on or off, from the next `draw_geometry` on.
        fn set_antialiased(antialiased: bool);
        /// Lights the geometry if anything has changed. Returns whether it was lit.
        fn draw_light(fixtures: &[Fixture]) -> Result<bool, Error>;
        /// Lights the whole picture with every effect, needed or not.
        fn draw_everything(fixtures: &[Fixture]) -> Result<(), Error>;
        /// Changes the display format, from the next `encode` on.
        fn set_display(display: Display);
        /// Measures what each pixel costs by a clock, from the next lighting pass on.
        fn set_clock(clock: Option<fn() -> f64>);
        /// Encodes the light for the display: RGBA, sRGB, eight bits.
        fn encode() -> &[u8];
    }
    tells {
        /// The last encoded picture.
        fn pixels() -> &[u8];
        /// Returns the counts of the last lighting pass.
        fn account() -> Account;
        /// Returns how many lights were evaluated at a pixel when it was last lit; `None` outside the
        /// picture.
        fn lights_evaluated(x: usize, y: usize) -> Option<u16>;
        /// Returns whether the last lighting pass re-lit a pixel; `None` outside the picture.
        fn is_relit(x: usize, y: usize) -> Option<bool>;
        /// Returns what the last lighting pass took for a pixel, by the clock; `None` outside the
        /// picture.
        fn cost(x: usize, y: usize) -> Option<f64>;
        /// Returns the linear light from a pixel to the eye; `None` outside the picture.
        fn linear(x: usize, y: usize) -> Option<Rgb<f32>>;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luminaire::falloff::{Soft, SoftOrHard};

    #[test]
    fn the_curve_passes_its_marks_in_every_format() {
        let cone = Cone::from_field(Soft, Angle::degrees(30.0)).unwrap().with_falloff(SoftOrHard::Soft);
        let half = |angle: Angle| angle.to_degrees() / 2.0;
        let angles = [0.0, half(cone.beam()), half(cone.field()), half(cone.outer()) * 1.01];
        for format in Format::ALL {
            let found = format.intensities(&cone, &angles).unwrap();
            for (found, wanted) in found.iter().zip([1.0, 0.5, 0.1, 0.0]) {
                assert!((found - wanted).abs() < 2e-3, "{format:?}: {found} in place of {wanted}");
            }
        }
    }
}
