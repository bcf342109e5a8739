//! The constants of the light that every rival has, in its own words, and what computes them.

use luminaire::Vec3;

use crate::scene::{AXIS, POSITION};

/// The range of windows, in units of length.
pub const RANGE: f32 = 10.0;

/// The light's position in steps of 2^-16.
pub(super) const AT: [i32; 3] = steps(POSITION, 65_536.0);

/// The axis in steps of a format.
pub(super) const fn axis(one: f32) -> [i32; 3] {
    steps(AXIS, one)
}

/// The steps nearest to a vector.
const fn steps(v: Vec3<f32>, one: f32) -> [i32; 3] {
    [nearest((v.x * one) as f64), nearest((v.y * one) as f64), nearest((v.z * one) as f64)]
}

/// The nearest integer.
pub(super) const fn nearest(x: f64) -> i32 {
    (if x < 0.0 { x - 0.5 } else { x + 0.5 }) as i32
}

/// The square root by Newton's method, for constants.
pub(super) const fn root(x: f64) -> f64 {
    let mut root = if x < 1.0 { 1.0 } else { x };
    loop {
        let next = 0.5 * (root + x / root);
        if next >= root {
            return root;
        }
        root = next;
    }
}

/// Implements [`Kernel`] for a light with a method `at(point, normal)`, which takes the words of a format.
macro_rules! lit {
    ($type:ty: $format:ty => $output:ty) => {
        impl crate::kernel::Kernel for $type {
            type Place = crate::scene::Site;
            type Input = crate::ours::Stored<$format>;
            type Output = $output;

            fn input(&self, site: &crate::scene::Site) -> Self::Input {
                Self::Input::new(site)
            }

            #[inline(always)]
            fn evaluate(&self, site: &Self::Input) -> $output {
                let (point, normal) = site.words();
                self.at(point, normal)
            }

            #[inline(always)]
            fn touch(site: &Self::Input) -> u32 {
                site.touch()
            }
        }
    };
}
pub(super) use lit;
