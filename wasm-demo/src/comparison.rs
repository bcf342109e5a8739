//! The JavaScript class of the comparison: one wall, lit side by side in two forms. A form is a
//! number format or a formula.

use crate::{
    canvas::Canvas,
    clock::Clock,
    difference::Truth,
    false_colour::{ENDS, Palette, Scale},
    form::Form,
    panic,
    refusal::Refusal,
    side::{self, Side, SideState},
    wall::{NARROWEST, WIDEST, Wall},
};
use wasm_bindgen::{Clamped, prelude::*};
use web_sys::HtmlCanvasElement;

/// The two forms at start, and the outer half angle in degrees at start.
const FIRST: ([Form; 2], f32) = ([Form::Fx16, Form::F32], 11.0);

/// Largest side of a picture, in pixels: a few times the size of a screen.
const LARGEST: u32 = 2048;

/// Two forms of one picture, each compared with its f64 reference. Every setter either takes its
/// value, or changes nothing and throws a string that names the parameter, its value and the
/// remedy.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Comparison {
    wall: Wall,
    sides: [Side; 2],
    palette: Palette,
    /// The scale that the visitor chose; `None` if the scale follows the errors.
    chosen: Option<Scale>,
    /// A picture and its errors for each side.
    canvases: [[Canvas; 2]; 2],
    clock: Clock,
}

#[wasm_bindgen]
impl Comparison {
    /// Opens the comparison on four canvases: the picture and the errors of the left form, then
    /// those of the right form. Each is a square with a side of `pixels` pixels. Nothing is shown
    /// yet.
    #[wasm_bindgen(constructor)]
    pub fn new(
        left: &HtmlCanvasElement,
        left_errors: &HtmlCanvasElement,
        right: &HtmlCanvasElement,
        right_errors: &HtmlCanvasElement,
        size: u32,
    ) -> Result<Self, Refusal> {
        panic::tell_the_page();
        let canvases = Canvas::pairs([[left, left_errors], [right, right_errors]], size, LARGEST)?;
        let (forms, half_angle) = FIRST;
        let wall = Wall::new(size, half_angle)?;
        Ok(Self {
            sides: light(forms, &wall),
            palette: Palette::new(),
            chosen: None,
            canvases,
            clock: Clock::new(),
            wall,
        })
    }

    /// Shows both pictures and their errors.
    pub fn draw(&self) -> Result<(), Refusal> {
        let scale = self.scale_in_force();
        for (side, [picture, errors]) in self.sides.iter().zip(&self.canvases) {
            if let Some([light, colours]) = side.pixels(&self.palette, scale) {
                picture.show(&light)?;
                errors.show(&colours)?;
            }
        }
        Ok(())
    }

    /// The outer half angle in degrees.
    #[wasm_bindgen(getter, js_name = halfAngle)]
    pub fn half_angle(&self) -> f32 {
        self.wall.half_angle()
    }

    /// Sets the outer half angle of the beam in degrees. The wall moves so that the spot keeps its
    /// size.
    #[wasm_bindgen(js_name = setHalfAngle)]
    pub fn set_half_angle(&mut self, degrees: f32) -> Result<(), Refusal> {
        self.wall.set_half_angle(degrees)?;
        self.sides = light(self.sides.each_ref().map(Side::form), &self.wall);
        Ok(())
    }

    /// Narrowest outer half angle in degrees of the comparison.
    pub fn narrowest() -> f32 {
        NARROWEST
    }

    /// Widest outer half angle in degrees of the comparison.
    pub fn widest() -> f32 {
        WIDEST
    }

    /// The full beam angle in degrees.
    #[wasm_bindgen(getter)]
    pub fn beam(&self) -> f32 {
        self.wall.spot().cone().beam().to_degrees()
    }

    /// The full field angle in degrees.
    #[wasm_bindgen(getter)]
    pub fn field(&self) -> f32 {
        self.wall.spot().cone().field().to_degrees()
    }

    /// Distance from the light to the wall, in metres.
    #[wasm_bindgen(getter)]
    pub fn distance(&self) -> f64 {
        self.wall.distance()
    }

    /// Sets the form of the left side, 0, or of the right side, 1.
    #[wasm_bindgen(js_name = setForm)]
    pub fn set_form(&mut self, side: usize, name: &str) -> Result<(), Refusal> {
        let form = Form::named(name)?;
        let mut forms = self.sides.each_ref().map(Side::form);
        *forms.get_mut(side).ok_or(no_side(side))? = form;
        self.sides = light(forms, &self.wall);
        Ok(())
    }

    /// Returns the state of a side.
    pub fn side(&self, side: usize) -> Result<SideState, Refusal> {
        Ok(self.sides.get(side).ok_or(no_side(side))?.state())
    }

    /// Returns whether both forms compute the same curve. An error is the difference between a form
    /// and the reference of its own curve. So the errors say which form is better only if both
    /// compute the same curve.
    #[wasm_bindgen(getter, js_name = isOneCurve)]
    pub fn is_one_curve(&self) -> bool {
        let [left, right] = self.sides.each_ref().map(Side::form);
        left.shares_truth_with(right)
    }

    /// Lights the picture of a side again. Returns the time in milliseconds, or nothing if the form
    /// was refused.
    pub fn time(&mut self, side: usize) -> Result<Option<f64>, Refusal> {
        let side = self.sides.get_mut(side).ok_or(no_side(side))?;
        let (milliseconds, lit) = self.clock.time(|| side.light());
        Ok(lit.map(|()| milliseconds))
    }

    /// The end of the scale of the errors, in displayed codes.
    #[wasm_bindgen(getter)]
    pub fn scale(&self) -> f64 {
        self.scale_in_force().end
    }

    /// Returns by what factor the scale magnifies the errors.
    #[wasm_bindgen(getter)]
    pub fn gain(&self) -> f64 {
        self.scale_in_force().gain()
    }

    /// Sets the end of the scale, in displayed codes, to one of `scales`. Without a value the scale
    /// follows the largest error of both pictures.
    #[wasm_bindgen(js_name = setScale)]
    pub fn set_scale(&mut self, codes: Option<f64>) -> Result<(), Refusal> {
        let chosen = codes.map(|codes| {
            let expected = "1, 2 or 5 of a power of ten from 0.001 to 100 codes, or 255";
            let refused = || Refusal::name("end of the scale", &codes.to_string(), expected);
            Scale::ending_at(codes).ok_or_else(refused)
        });
        self.chosen = chosen.transpose()?;
        Ok(())
    }

    /// The possible ends of the scale, in displayed codes.
    pub fn scales() -> Vec<f64> {
        ENDS.to_vec()
    }

    /// The colours of the scale from no error to its end: red, green, blue of each.
    pub fn palette(&self) -> Clamped<Vec<u8>> {
        Clamped(self.palette.colours().concat())
    }

    /// The forms to choose from.
    #[wasm_bindgen(unchecked_return_type = "FormState[]")]
    pub fn forms() -> Vec<JsValue> {
        Form::ALL.map(side::form).into()
    }
}

impl Comparison {
    /// Returns one scale for both sides, so that their colours are comparable.
    fn scale_in_force(&self) -> Scale {
        let largest = self.sides.iter().filter_map(Side::largest).fold(0.0, f64::max);
        self.chosen.unwrap_or_else(|| Scale::holding(largest))
    }
}

/// Lights both sides. Forms of the same curve share the reference.
fn light(forms: [Form; 2], wall: &Wall) -> [Side; 2] {
    let truth = |form: Form| Truth::about(wall.sites(), &form.curve().truth(wall));
    let [left, right] = forms;
    let one = truth(left);
    let other = (!left.shares_truth_with(right)).then(|| truth(right));
    [Side::new(left, wall, &one), Side::new(right, wall, other.as_ref().unwrap_or(&one))]
}

fn no_side(value: usize) -> Refusal {
    Refusal::name("side", &value.to_string(), "0 for the left one or 1 for the right")
}
