//! Difference between a picture and the f64 reference, in displayed codes.

use crate::{display::srgb_code, picture::Picture};
use luminaire_kernels::{scene::Site, truth::Point};

/// The f64 reference of a picture: its exact light and its exact codes before rounding.
#[derive(Clone, Debug)]
pub(crate) struct Truth {
    lights: Vec<f64>,
    codes: Vec<f64>,
}

/// A picture compared with its reference.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Difference {
    /// The displayed code of each pixel.
    pub(crate) codes: Vec<u8>,
    /// Absolute error of each pixel in codes, before rounding.
    pub(crate) errors: Vec<f32>,
    /// The largest of the errors.
    pub(crate) largest: f64,
    /// The index of the pixel with the largest error; the first if there are several.
    pub(crate) place: usize,
    /// The share of the pixels whose displayed code is not the nearest to the reference.
    pub(crate) differing: f64,
    /// The largest difference of a displayed code from that nearest one.
    pub(crate) apart: u8,
}

impl Truth {
    /// Computes the reference at these sites.
    pub(crate) fn about(sites: &[Site], light: &Point) -> Self {
        let lights: Vec<f64> = sites.iter().map(|site| light.at(site)).collect();
        let codes = lights.iter().copied().map(srgb_code).collect();
        Self { lights, codes }
    }

    /// Compares a picture of the same sites with the reference.
    pub(crate) fn compare(&self, picture: &Picture) -> Difference {
        let mut difference = Difference {
            codes: Vec::with_capacity(self.codes.len()),
            errors: Vec::with_capacity(self.codes.len()),
            largest: 0.0,
            place: 0,
            differing: 0.0,
            apart: 0,
        };
        let mut truths = self.lights.iter().zip(&self.codes);
        let mut differing = 0_u32;
        picture.visit(&mut |light, shown| {
            let Some((&true_light, &true_code)) = truths.next() else { return };
            // The power function of sRGB is expensive, so it is evaluated only where there is an
            // error.
            let error = if light == true_light { 0.0 } else { (srgb_code(light) - true_code).abs() };
            if error > difference.largest {
                (difference.largest, difference.place) = (error, difference.errors.len());
            }
            let apart = shown.abs_diff(true_code.round() as u8);
            differing += u32::from(apart > 0);
            difference.apart = difference.apart.max(apart);
            difference.codes.push(shown);
            difference.errors.push(error as f32);
        });
        difference.differing = f64::from(differing) / self.codes.len().max(1) as f64;
        difference
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        form::Form,
        wall::{NARROWEST, WIDEST, Wall},
    };

    const PIXELS: u32 = 200;

    fn difference(form: Form, half_angle: f32) -> Option<Difference> {
        let wall = Wall::new(PIXELS, half_angle).unwrap();
        let mut picture = form.picture(&wall).ok()?;
        picture.light();
        Some(Truth::about(wall.sites(), &form.curve().truth(&wall)).compare(&picture))
    }

    #[test]
    fn the_truth_does_not_differ_from_itself() {
        for half_angle in [NARROWEST, 0.1, 10.0, WIDEST] {
            let difference = difference(Form::F64, half_angle).unwrap();
            assert!(difference.largest < 1e-5 && difference.apart == 0, "{half_angle}");
            assert_eq!(difference.differing, 0.0, "{half_angle}");
            assert_eq!(difference.codes.len(), (PIXELS * PIXELS) as usize);
            let (darkest, brightest) = (difference.codes.iter().min(), difference.codes.iter().max());
            assert_eq!((darkest, brightest), (Some(&0), Some(&255)), "{half_angle}");
        }
    }

    #[test]
    fn the_largest_error_is_told_with_its_place() {
        for form in Form::ALL {
            let Some(difference) = difference(form, 3.0) else { panic!("{form:?} refuses 3 degrees") };
            let errors = &difference.errors;
            assert_eq!(errors[difference.place], difference.largest as f32, "{form:?}");
            assert!(errors.iter().all(|&error| f64::from(error) <= difference.largest + 1e-5));
        }
    }

    /// The largest errors in displayed codes at outer half angles of 10, 1, 0.1 and 0.01 degrees,
    /// plus a tenth as headroom; nothing where the format refuses the cone. They are the maxima
    /// over the pixels of these pictures.
    const BOUNDS: [(Form, [Option<f64>; 4]); 6] = [
        (Form::F32, [Some(2.1e-4), Some(1.7e-3), Some(0.028), Some(0.25)]),
        (Form::Fx32, [Some(1.25e-5), Some(5.4e-5), Some(6.8e-4), Some(6.7e-3)]),
        (Form::Fx16, [Some(0.26), Some(0.39), None, None]),
        (Form::Cosine, [Some(6.7e-3), Some(0.49), Some(49.0), Some(255.0)]),
        (Form::Powf, [Some(6.8e-3), Some(0.49), Some(47.0), Some(255.0)]),
        (Form::Gltf, [Some(6.4e-3), Some(235.0), Some(255.0), Some(255.0)]),
    ];

    #[test]
    fn narrow_beams_part_the_forms() {
        for (form, bounds) in BOUNDS {
            for (half_angle, bound) in [10.0, 1.0, 0.1, 0.01].into_iter().zip(bounds) {
                let found = difference(form, half_angle).map(|difference| difference.largest);
                match (found, bound) {
                    (None, None) => {}
                    (Some(found), Some(bound)) => {
                        assert!(found <= bound, "{form:?} at {half_angle}: {found} passes {bound}");
                        assert!(
                            found > 0.8 * bound,
                            "{form:?} at {half_angle}: {bound} is loose for {found}"
                        );
                    }
                    _ => panic!("{form:?} at {half_angle}: {found:?} in place of {bound:?}"),
                }
            }
        }
    }
}
