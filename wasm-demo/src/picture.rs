//! A picture of the wall in one form: what is timed, and what comes of it.

use crate::difference::srgb_code;
use fixed::types::{U18F14, U34F30};
use luminaire::{Fx16, Fx32, Scalar, encode_srgb};
use luminaire_kernels::{Kernel, Value, scene::Site};
use std::fmt;

/// A picture whose form has been forgotten: the choice costs one indirect call per picture, and none per pixel.
pub(crate) struct Picture(Box<dyn Canvas>);

impl Picture {
    /// The picture that a kernel makes of these sites. It is dark until it is lit.
    pub(crate) fn of<K: Kernel<Place = Site, Output: Shown> + 'static>(kernel: K, sites: &[Site]) -> Self {
        let inputs = sites.iter().map(|site| kernel.input(site)).collect();
        Self(Box::new(Sheet { kernel, inputs, lights: Vec::with_capacity(sites.len()) }))
    }

    /// Evaluates the kernel for every pixel: this is what is timed.
    pub(crate) fn light(&mut self) {
        self.0.light();
    }

    /// Gives each pixel's light, exactly and as its form displays it: 1 is full scale, and the code is of sRGB.
    pub(crate) fn visit(&self, visit: &mut dyn FnMut(f64, u8)) {
        self.0.visit(visit);
    }
}

impl fmt::Debug for Picture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Picture")
    }
}

trait Canvas {
    fn light(&mut self);
    fn visit(&self, visit: &mut dyn FnMut(f64, u8));
}

/// Inputs and results as the kernel's format has them, so that nothing is timed but the kernel.
struct Sheet<K: Kernel> {
    kernel: K,
    inputs: Vec<K::Input>,
    lights: Vec<K::Output>,
}

impl<K: Kernel<Output: Shown>> Canvas for Sheet<K> {
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

/// Light that a display shows by the encoder of its own format.
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

impl Shown for U18F14 {
    fn code(self) -> u8 {
        encode_srgb(Fx16::clip(self))
    }
}

impl Shown for U34F30 {
    fn code(self) -> u8 {
        encode_srgb(Fx32::clip(self))
    }
}
