//! The JavaScript class of the museum: a faulty spotlight of another project beside the crate's.

use crate::{
    canvas::Canvas,
    false_colour::{Palette, Scale, rgba},
    panic,
    plain::plain,
    refusal::Refusal,
};
use luminaire::display::encode_srgb;
use luminaire_museum::{ALL, Errors, Exhibit, Picture, Side};
use wasm_bindgen::{Clamped, prelude::*};
use web_sys::HtmlCanvasElement;

/// Largest side of a picture, in pixels. A picture is drawn on the main thread.
const LARGEST: u32 = 512;

/// The colour of a NaN: the palette does not have it.
const UNDEFINED: [u8; 3] = [0, 190, 120];

const SIDES: [Side; 2] = [Side::Faulty, Side::Ours];

/// An exhibit at a value of its control. Every setter either takes its value, or changes nothing
/// and throws a string that names the parameter, its value and the remedy.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Museum {
    exhibit: &'static Exhibit,
    value: f32,
    size: u32,
    picture: Picture,
    /// The errors of the faulty picture and of ours.
    errors: [Errors; 2],
    palette: Palette,
    /// A picture and its errors for each side.
    canvases: [[Canvas; 2]; 2],
}

plain! {
    /// An exhibit with its source and its control: see [`Exhibit`].
    fn state(exhibit: &Exhibit) -> ExhibitState {
        "name": "string" = exhibit.name,
        "label": "string" = exhibit.label,
        "title": "string" = exhibit.title,
        "project": "string" = exhibit.source.project,
        "file": "string" = exhibit.source.file,
        "version": "string" = exhibit.source.version,
        "licence": "string" = exhibit.source.licence,
        "thread": "string" = exhibit.source.thread,
        "code": "string" = exhibit.code,
        "cause": "string" = exhibit.cause,
        "noBetter": "string" = exhibit.no_better,
        "agreesAt": "number | undefined" = exhibit.agrees_at,
        "control": "string" = exhibit.control.label,
        "unit": "string" = exhibit.control.unit,
        "least": "number" = exhibit.control.least,
        "most": "number" = exhibit.control.most,
        "start": "number" = exhibit.control.start,
        "isLogarithmic": "boolean" = exhibit.control.is_logarithmic,
    }
}

plain! {
    /// The errors of one picture: see [`Errors`].
    fn told(errors: &Errors) -> PictureState {
        "largest": "number" = errors.largest,
        "place": "number" = errors.place as f64,
        "undefined": "number" = errors.undefined as f64,
    }
}

#[wasm_bindgen]
impl Museum {
    /// Opens the first exhibit on four canvases: the faulty picture and its errors, then those of
    /// the crate. Each is a square with a side of `size` pixels. Nothing is shown yet.
    #[wasm_bindgen(constructor)]
    pub fn new(
        faulty: &HtmlCanvasElement,
        faulty_errors: &HtmlCanvasElement,
        ours: &HtmlCanvasElement,
        our_errors: &HtmlCanvasElement,
        size: u32,
    ) -> Result<Self, Refusal> {
        panic::tell_the_page();
        let canvases = Canvas::pairs([[faulty, faulty_errors], [ours, our_errors]], size, LARGEST)?;
        let [exhibit, ..] = &ALL;
        let value = exhibit.control.start;
        let (picture, errors) = look(exhibit, value, size)?;
        Ok(Self { exhibit, value, size, picture, errors, palette: Palette::new(), canvases })
    }

    /// The exhibits in the order of a visit.
    #[wasm_bindgen(unchecked_return_type = "ExhibitState[]")]
    pub fn exhibits() -> Vec<JsValue> {
        ALL.iter().map(state).collect()
    }

    /// Opens an exhibit at its named case.
    pub fn open(&mut self, name: &str) -> Result<(), Refusal> {
        let exhibit = named(name)?;
        self.look(exhibit, exhibit.control.start)
    }

    /// The name of the exhibit.
    #[wasm_bindgen(getter)]
    pub fn exhibit(&self) -> String {
        self.exhibit.name.to_owned()
    }

    /// The value of the control.
    #[wasm_bindgen(getter)]
    pub fn value(&self) -> f32 {
        self.value
    }

    /// Sets the control.
    #[wasm_bindgen(js_name = setValue)]
    pub fn set_value(&mut self, value: f32) -> Result<(), Refusal> {
        let control = self.exhibit.control;
        if !(control.least..=control.most).contains(&value) {
            let range = [control.least, control.most];
            return Err(Refusal::outside(control.label, value, range, control.unit));
        }
        self.look(self.exhibit, value)
    }

    /// Shows both pictures and their errors.
    pub fn draw(&self) -> Result<(), Refusal> {
        let scale = self.scale_in_force();
        for ((lights, errors), [picture, map]) in
            [&self.picture.faulty, &self.picture.ours].into_iter().zip(&self.errors).zip(&self.canvases)
        {
            picture.show(&shown(lights))?;
            let colour =
                |&code: &f32| if code.is_nan() { UNDEFINED } else { self.palette.colour(scale, code) };
            map.show(&rgba(errors.codes.iter().map(colour)))?;
        }
        Ok(())
    }

    /// Returns the errors of the faulty picture, 0, or of the crate's, 1.
    #[wasm_bindgen(unchecked_return_type = "PictureState")]
    pub fn side(&self, side: usize) -> Result<JsValue, Refusal> {
        let errors = self.errors.get(side).ok_or_else(|| {
            Refusal::name("side", &side.to_string(), "0 for the faulty one or 1 for the crate’s")
        })?;
        Ok(told(errors))
    }

    /// The number format of the crate's picture.
    #[wasm_bindgen(getter)]
    pub fn format(&self) -> String {
        self.picture.format.to_owned()
    }

    /// The end of the scale of the errors, in linear codes.
    #[wasm_bindgen(getter)]
    pub fn scale(&self) -> f64 {
        self.scale_in_force().end
    }

    /// The colours of the scale from no error to its end: red, green, blue of each.
    pub fn palette(&self) -> Clamped<Vec<u8>> {
        Clamped(self.palette.colours().concat())
    }

    /// The colour of a NaN.
    pub fn undefined() -> Clamped<Vec<u8>> {
        Clamped(UNDEFINED.to_vec())
    }

    /// Returns the faulty picture of an exhibit at its named case, as a square of `size` pixels.
    pub fn thumbnail(name: &str, size: u32) -> Result<Clamped<Vec<u8>>, Refusal> {
        let exhibit = named(name)?;
        let (picture, _) = look(exhibit, exhibit.control.start, size.min(LARGEST))?;
        Ok(Clamped(shown(&picture.faulty)))
    }
}

impl Museum {
    fn look(&mut self, exhibit: &'static Exhibit, value: f32) -> Result<(), Refusal> {
        (self.picture, self.errors) = look(exhibit, value, self.size)?;
        (self.exhibit, self.value) = (exhibit, value);
        Ok(())
    }

    /// Returns one scale for both sides, so that their colours are comparable. It ends at one code or
    /// more: nobody sees less.
    fn scale_in_force(&self) -> Scale {
        Scale::holding(self.errors.iter().map(|errors| errors.largest).fold(1.0, f64::max))
    }
}

fn named(name: &str) -> Result<&'static Exhibit, Refusal> {
    let found = ALL.iter().find(|exhibit| exhibit.name == name);
    found.ok_or_else(|| Refusal::name("exhibit", name, "one of the museum’s list"))
}

fn look(exhibit: &Exhibit, value: f32, size: u32) -> Result<(Picture, [Errors; 2]), Refusal> {
    let picture = Picture::of(&(exhibit.beam)(value)?, size)?;
    let errors = SIDES.map(|side| picture.errors(side));
    Ok((picture, errors))
}

/// The light as RGBA.
fn shown(lights: &[f32]) -> Vec<u8> {
    let code = |&light: &f32| {
        if light.is_nan() { UNDEFINED } else { [encode_srgb(light); 3] }
    };
    rgba(lights.iter().map(code))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn undefined_pixels_have_a_colour_of_their_own() {
        let palette = Palette::new();
        assert!(palette.colours().iter().all(|&colour| colour != UNDEFINED));
        assert_eq!(shown(&[0.0, f32::NAN, 2.0]), [0, 0, 0, 255, 0, 190, 120, 255, 255, 255, 255, 255]);
    }
}
