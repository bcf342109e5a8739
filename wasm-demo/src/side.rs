//! One side of the comparison: a form and its picture of the wall.

use crate::{
    difference::{Difference, Truth},
    false_colour::{Palette, Scale, rgba},
    form::{self as forms, Curve, Form},
    picture::Picture,
    plain::plain,
    wall::Wall,
};
use wasm_bindgen::prelude::*;

/// A form with its picture.
#[derive(Debug)]
pub(crate) struct Side {
    form: Form,
    /// `Err` if the number format can't hold the beam.
    view: Result<View, luminaire::Error>,
}

#[derive(Debug)]
struct View {
    picture: Picture,
    difference: Difference,
    off_axis: f64,
}

/// State of a side for the page.
#[wasm_bindgen(getter_with_clone)]
#[derive(Clone, PartialEq, Debug)]
pub struct SideState {
    /// The name of the form.
    pub form: String,
    /// Why the number format cannot hold the beam; nothing if it can. If there is a reason, the
    /// fields below have no meaning.
    pub refusal: Option<String>,
    /// If the angle was refused, the narrowest outer half angle in degrees that the format holds.
    pub narrowest: Option<f32>,
    /// The largest error in displayed codes, before rounding.
    pub largest: f64,
    /// Angle off axis of the pixel with the largest error, in degrees.
    #[wasm_bindgen(js_name = offAxis)]
    pub off_axis: f64,
    /// Index of the pixel with the largest error, counted row by row.
    pub place: usize,
    /// Share of the pixels whose displayed code differs from that of f64.
    pub differing: f64,
    /// The largest difference of a displayed code from that of f64.
    pub apart: u8,
}

impl Side {
    /// Lights a form's picture of the wall and compares it with the reference of its curve.
    pub(crate) fn new(form: Form, wall: &Wall, truth: &Truth) -> Self {
        let view = form.picture(wall).map(|mut picture| {
            picture.light();
            let difference = truth.compare(&picture);
            let off_axis = wall.off_axis(difference.place);
            View { picture, difference, off_axis }
        });
        Self { form, view }
    }

    pub(crate) fn form(&self) -> Form {
        self.form
    }

    /// Returns the largest error in displayed codes; `None` if the form was refused.
    pub(crate) fn largest(&self) -> Option<f64> {
        Some(self.view.as_ref().ok()?.difference.largest)
    }

    /// Lights the picture again with the same result, for measuring. Returns `None` if the form was
    /// refused.
    pub(crate) fn light(&mut self) -> Option<()> {
        self.view.as_mut().ok()?.picture.light();
        Some(())
    }

    /// The picture, and its errors in false colours, as RGBA; `None` if the form was refused.
    pub(crate) fn pixels(&self, palette: &Palette, scale: Scale) -> Option<[Vec<u8>; 2]> {
        let Difference { codes, errors, .. } = &self.view.as_ref().ok()?.difference;
        let colours = errors.iter().map(|&error| palette.colour(scale, error));
        Some([rgba(codes.iter().map(|&code| [code; 3])), rgba(colours)])
    }

    /// Returns the state for the page.
    pub(crate) fn state(&self) -> SideState {
        let form = self.form.name().to_owned();
        match &self.view {
            Ok(View { difference, off_axis, .. }) => SideState {
                form,
                refusal: None,
                narrowest: None,
                largest: difference.largest,
                off_axis: *off_axis,
                place: difference.place,
                differing: difference.differing,
                apart: difference.apart,
            },
            Err(error) => SideState {
                form,
                refusal: Some(match forms::accepted_half_angle(error) {
                    Some(narrowest) => format!(
                        "{} cannot hold this beam: expected a half angle of at least {narrowest} degrees",
                        self.form.label()
                    ),
                    None => format!("{} cannot hold this beam: {error}", self.form.label()),
                }),
                narrowest: forms::accepted_half_angle(error),
                largest: f64::NAN,
                off_axis: f64::NAN,
                place: 0,
                differing: f64::NAN,
                apart: 0,
            },
        }
    }
}

plain! {
    /// A form to choose from: the name that the setters accept, its name for people, the curve of its f64
    /// reference, and the kernel and the format of its rows on the price list, for the falloff and for a lit
    /// point. Empty if it has none.
    fn form(form: Form) -> FormState {
        "name": "string" = form.name(),
        "label": "string" = form.label(),
        "truth": "string" = match form.curve() {
            Curve::Soft => "soft edge, t²",
            Curve::CosinePower => "cosine’s power",
        },
        "falloff": "string[]" = names(Some(form.rows().0)),
        "lit": "string[]" = names(form.rows().1),
    }
}

fn names(row: Option<luminaire_kernels::Row>) -> Vec<JsValue> {
    row.map_or(Vec::new(), |row| vec![row.kernel.into(), row.format.into()])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wall::Wall;

    fn side(form: Form, half_angle: f32) -> Side {
        let wall = Wall::new(40, half_angle).unwrap();
        let truth = Truth::about(wall.sites(), &form.curve().truth(&wall));
        Side::new(form, &wall, &truth)
    }

    #[test]
    fn a_refused_beam_is_told_in_words_with_one_that_is_held() {
        for (form, half_angle) in [(Form::Fx16, 0.1), (Form::F32, 0.002), (Form::Cosine, 0.002)] {
            let state = side(form, half_angle).state();
            let refusal = state.refusal.unwrap();
            assert!(refusal.contains(form.label()) && refusal.contains("at least"), "{refusal}");
            let narrowest = state.narrowest.unwrap();
            assert!(narrowest > half_angle && side(form, narrowest).state().refusal.is_none(), "{narrowest}");
        }
    }

    #[test]
    fn the_pictures_show_light_and_errors() {
        let side = side(Form::Cosine, 0.05);
        let palette = Palette::new();
        let scale = Scale::holding(side.largest().unwrap());
        let [picture, errors] = side.pixels(&palette, scale).unwrap();
        assert!(
            picture.chunks(4).any(|pixel| *pixel == [255; 4]) && picture.chunks(4).any(|pixel| pixel[0] == 0)
        );
        let place = side.state().place;
        let (first, at) = (palette.colours()[0], &errors[4 * place..4 * place + 3]);
        assert_ne!(at, first, "the place of the largest error has the colour of none");
        assert_eq!(errors[..3], first, "the dark corner has an error");
    }

    /// Every named row of the price list must exist; otherwise the page would show no price. The cosine
    /// form has none.
    #[test]
    fn every_form_stands_on_the_price_list() {
        use luminaire_kernels::{
            Kernel, Row, Setting, Visitor, falloffs, oracle, points, scene::Site, truth::Point,
        };
        struct Rows(Vec<Row>);
        impl Visitor for Rows {
            fn falloff<K: Kernel<Place = f32>>(&mut self, row: Row, _: K, _: &oracle::Cone) {
                self.0.push(row);
            }
            fn point<K: Kernel<Place = Site>>(&mut self, row: Row, _: K, _: &Point) {
                self.0.push(row);
            }
        }
        let mut rows = Rows(Vec::new());
        falloffs(Setting::standard(), &mut rows);
        points(Setting::standard(), &mut rows);
        for form in Form::ALL {
            let (falloff, lit) = form.rows();
            for row in [Some(falloff), lit].into_iter().flatten() {
                assert_eq!(rows.0.contains(&row), form != Form::Cosine, "{row:?}");
            }
            assert_eq!(Form::named(form.name()), Ok(form));
        }
        assert!(Form::named("f16").unwrap_err().to_string().contains("form = \"f16\""));
    }
}
