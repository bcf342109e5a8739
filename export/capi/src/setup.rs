//! Lights from the angles of a data sheet, in floating point.

use core::ffi::c_char;
use core::fmt::{self, Write};
use core::slice;

use luminaire::{Angle, Cone, Error, Rgb, SpotLight, falloff::SoftOrHard};

use crate::edge::{CompiledEdge, Edge};
use crate::{luminaire_bool, luminaire_spot};

/// A spotlight in metres, degrees and linear colour.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct luminaire_spot_description {
    /// The position.
    pub position: [f32; 3],
    /// The direction in which the light points, of any length.
    pub axis: [f32; 3],
    /// The full beam angle, at which 50 % of the intensity is left, in degrees. 0 if the data sheet
    /// does not name it: it then follows from the field angle and `is_hard`.
    pub beam_degrees: f32,
    /// The full field angle, at which 10 % of the intensity is left, in degrees. 0 if the data sheet
    /// does not name it: it then follows from the beam angle and `is_hard`.
    pub field_degrees: f32,
    /// The intensity on the axis: 1 lights a surface at distance 1 to full scale.
    pub intensity: f32,
    /// The linear colour, from 0 to 1.
    pub color: [f32; 3],
    /// Whether the edge is hard, as of a profile, instead of soft, as of a Fresnel. Not read if both
    /// angles are given, which determine the edge. With one angle, the beam angle is about 0.86 of
    /// the field angle with a hard edge and 0.65 with a soft one.
    pub is_hard: luminaire_bool,
}

impl luminaire_spot_description {
    fn cone(&self) -> Result<Cone<Edge>, Error> {
        let edge = Edge::Given(if self.is_hard.0 != 0 { SoftOrHard::Hard } else { SoftOrHard::Soft });
        let [beam, field] = [self.beam_degrees, self.field_degrees].map(Angle::degrees);
        if self.beam_degrees == 0.0 {
            return Cone::from_field(edge, field);
        }
        if self.field_degrees == 0.0 {
            return Cone::from_beam(edge, beam);
        }
        let fitted = Cone::from_beam_and_field(beam, field)?;
        Ok(fitted.with_falloff(Edge::Fitted(fitted.falloff())))
    }

    fn compile(&self) -> Result<luminaire_spot, Error> {
        let spot = SpotLight::new(self.position, self.axis, self.cone()?)?
            .with_intensity(self.intensity)?
            .with_color(Rgb::from(self.color))?;
        let edge = CompiledEdge::from(spot.cone().falloff());
        Ok(luminaire_spot::of(spot.compile()?, edge.words()))
    }
}

/// Sets up a light, on a processor with or without a floating-point unit. Returns whether the
/// description is accepted. If not, the light is dark, and `message` gets the reason, cut to
/// `capacity` bytes with the final zero; it may be null.
///
/// Firmware that need not set lights up by itself includes a light that `luminaire export` writes.
///
/// # Safety
/// `message` is null or points to `capacity` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn luminaire_spot_set_up(
    spot: Option<&mut luminaire_spot>,
    description: Option<&luminaire_spot_description>,
    message: *mut c_char,
    capacity: usize,
) -> bool {
    let (Some(spot), Some(description)) = (spot, description) else { return false };
    match description.compile() {
        Ok(light) => {
            *spot = light;
            true
        }
        Err(error) => {
            *spot = luminaire_spot::default();
            if !message.is_null() && capacity > 0 {
                // SAFETY: as the caller promises.
                let bytes = unsafe { slice::from_raw_parts_mut(message.cast::<u8>(), capacity) };
                bytes.fill(0);
                let (_, text) = bytes.split_last_mut().unwrap_or((&mut 0, &mut []));
                // A message that is too long is cut.
                let _ = write!(Cut(text), "{error}");
            }
            false
        }
    }
}

/// Text that is cut where the buffer ends.
struct Cut<'a>(&'a mut [u8]);

impl fmt::Write for Cut<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let count = text.len().min(self.0.len());
        let (here, rest) = core::mem::take(&mut self.0).split_at_mut(count);
        here.copy_from_slice(&text.as_bytes()[..count]);
        self.0 = rest;
        Ok(())
    }
}
