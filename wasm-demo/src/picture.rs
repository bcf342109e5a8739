//! A picture of the wall in one form: the timed work and its result.

use crate::display::srgb_code;
use luminaire::number::{Light16, Light32};
use luminaire::{
    Rgb,
    display::{clip, encode_srgb},
};
use luminaire_kernels::{Kernel, Value, scene::Site};
use std::fmt;

/// Light of a number format, with the display encoder of that format.
pub(crate) trait Shown: Value {
    /// The sRGB code, clipped at full scale.
    fn code(self) -> u8;
}

impl Shown for f32 {
    fn code(self) -> u8 {
        encode_srgb(self)
    }
}

impl Shown for f64 {
    fn code(self) -> u8 {
        srgb_code(self).round() as u8
    }
}

impl Shown for Light16 {
    fn code(self) -> u8 {
        encode_srgb(clip(Rgb::new(self, self, self)).red)
    }
}

impl Shown for Light32 {
    fn code(self) -> u8 {
        encode_srgb(clip(Rgb::new(self, self, self)).red)
    }
}

/// A picture behind a trait object that hides its form: the choice costs one indirect call per
/// picture, and none per pixel.
pub(crate) struct Picture(Box<dyn Lit>);

impl Picture {
    /// Prepares a kernel's picture of these sites. It is dark until `light` is called.
    pub(crate) fn of<K: Kernel<Place = Site, Output: Shown> + 'static>(kernel: K, sites: &[Site]) -> Self {
        let inputs = sites.iter().map(|site| kernel.input(site)).collect();
        Self(Box::new(Pixels { kernel, inputs, lights: Vec::with_capacity(sites.len()) }))
    }

    /// Evaluates the kernel for every pixel. This is the timed work.
    pub(crate) fn light(&mut self) {
        self.0.light();
    }

    /// Calls the closure with each pixel's light, where 1 is full scale, and with its sRGB code by
    /// the encoder of the form.
    pub(crate) fn visit(&self, visit: &mut dyn FnMut(f64, u8)) {
        self.0.visit(visit);
    }
}

impl fmt::Debug for Picture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Picture")
    }
}

trait Lit {
    fn light(&mut self);
    fn visit(&self, visit: &mut dyn FnMut(f64, u8));
}

/// Inputs and results in the kernel's own format, so that only the kernel is timed.
struct Pixels<K: Kernel> {
    kernel: K,
    inputs: Vec<K::Input>,
    lights: Vec<K::Output>,
}

impl<K: Kernel<Output: Shown>> Lit for Pixels<K> {
    fn light(&mut self) {
        self.lights.clear();
        self.lights.extend(self.inputs.iter().map(|input| self.kernel.evaluate(input)));
    }

    fn visit(&self, visit: &mut dyn FnMut(f64, u8)) {
        for light in &self.lights {
            visit(light.exact(), light.code());
        }
    }
}
