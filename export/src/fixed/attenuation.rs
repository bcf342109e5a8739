//! Attenuations in the C of the 16-bit format.
//!
//! Each attenuation of the list of models has an `impl` here. Without one, the list in
//! `crate::models` does not compile.

use luminaire::Fx16;
use luminaire::attenuation::{
    Attenuation, Cut, GltfWindow, InverseSquare, NoAttenuation, Polynomial, Ranged, SmoothRange,
    SquareWindow, Window,
};
use luminaire::codegen::Gain16;

use crate::name::global;

/// Which of the two evaluations of the format: `coarse` or `fine`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Precision(pub(super) &'static str);

/// The code of an attenuation while it is written.
#[derive(Debug)]
pub(crate) struct Law<'a> {
    pub(super) name: &'a str,
    pub(super) precision: Precision,
    /// The gains that the code names, as definitions.
    pub(super) constants: Vec<String>,
    /// The expression of the share `share` in the windows so far.
    pub(super) windowed: String,
    /// The expression of the light that arrives of the share `share`.
    pub(super) result: String,
}

impl Law<'_> {
    /// Returns the name of the gain of the intensity.
    fn intensity(&self) -> String {
        global(self.name, "intensity")
    }

    /// Defines a gain, and returns its name.
    fn gain(&mut self, part: &str, gain: Gain16) -> String {
        let name = global(self.name, part);
        self.constants.push(format!("static const luminaire_gain {name} = {};", gain_of(gain)));
        name
    }
}

/// Returns the initialiser of a gain.
pub(super) fn gain_of(gain: Gain16) -> String {
    let [mantissa, shift] = gain.to_bits();
    format!("{{ UINT32_C({:#x}), {shift} }}", mantissa as u32)
}

/// An attenuation as C in the 16-bit format.
pub(crate) trait FixedAttenuation {
    /// Sets the expression of the light, and adds the constants and the windows.
    fn attenuate(&self, law: &mut Law<'_>);
}

impl FixedAttenuation for NoAttenuation {
    fn attenuate(&self, law: &mut Law<'_>) {
        let (Precision(precision), intensity, share) = (law.precision, law.intensity(), &law.windowed);
        law.result = format!("luminaire_{precision}_give({share}, {intensity})");
    }
}

impl FixedAttenuation for InverseSquare {
    fn attenuate(&self, law: &mut Law<'_>) {
        let (Precision(precision), intensity, share) = (law.precision, law.intensity(), &law.windowed);
        law.result = format!("luminaire_{precision}_inverse_square(ray, {share}, {intensity})");
    }
}

impl FixedAttenuation for Polynomial {
    fn attenuate(&self, law: &mut Law<'_>) {
        let (Precision(precision), intensity, share) = (law.precision, law.intensity(), &law.windowed);
        let divisor = global(law.name, "divisor");
        let gains = Attenuation::constants::<Fx16>(*self).map(gain_of).join(", ");
        law.constants.push(format!("static const luminaire_gain {divisor}[3] = {{ {gains} }};"));
        law.result = format!(
            "luminaire_{precision}_give({share}, luminaire_polynomial(luminaire_{precision}_distance(ray), \
             {divisor}, {intensity}))"
        );
    }
}

impl FixedAttenuation for SmoothRange {
    fn attenuate(&self, law: &mut Law<'_>) {
        let [near, squared] = Attenuation::constants::<Fx16>(*self);
        let (near, squared) = (law.gain("range", near), law.gain("squared_range", squared));
        let (Precision(precision), intensity, share) = (law.precision, law.intensity(), &law.windowed);
        law.result = format!(
            "luminaire_{precision}_give(luminaire_{precision}_smooth_range({share}, \
             luminaire_{precision}_near(ray, {near}), luminaire_{precision}_squared_near(ray, {squared})), \
             {intensity})"
        );
    }
}

impl<W: FixedWindow, A: FixedAttenuation + Attenuation> FixedAttenuation for Ranged<W, A> {
    fn attenuate(&self, law: &mut Law<'_>) {
        if Ranged::range(self).is_some() {
            let (squared, _) = Attenuation::constants::<Fx16>(*self);
            let squared = law.gain("squared_range", squared);
            let (Precision(precision), share) = (law.precision, &law.windowed);
            law.windowed = format!(
                "luminaire_{precision}_{}({share}, luminaire_{precision}_squared_near(ray, {squared}))",
                W::FUNCTION
            );
        }
        self.attenuation().attenuate(law);
    }
}

/// A window as C in the 16-bit format.
pub(crate) trait FixedWindow: Window {
    /// The name of its function, without `luminaire` and the precision.
    const FUNCTION: &'static str;
}

impl FixedWindow for Cut {
    const FUNCTION: &'static str = "cut";
}

impl FixedWindow for GltfWindow {
    const FUNCTION: &'static str = "gltf_window";
}

impl FixedWindow for SquareWindow {
    const FUNCTION: &'static str = "square_window";
}
