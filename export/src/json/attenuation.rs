//! The parameters of an attenuation.

use luminaire::attenuation::{
    Attenuation, Cut, GltfWindow, InverseSquare, NoAttenuation, Polynomial, Ranged, SmoothRange,
    SquareWindow, Window,
};
use serde::Serialize;

/// An attenuation as JSON has it.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Description {
    /// The law without a window.
    pub(crate) law: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) coefficients: Option<[f32; 3]>,
    /// The window that ends the law at the range.
    #[serde(skip_serializing_if = "Option::is_none")]
    window: Option<&'static str>,
    /// The range; absent if the light has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) range: Option<f32>,
}

/// An attenuation as parameters.
pub(crate) trait DescribedAttenuation {
    /// Returns the parameters.
    fn describe(&self) -> Description;
}

fn law(law: &'static str) -> Description {
    Description { law, coefficients: None, window: None, range: None }
}

impl DescribedAttenuation for NoAttenuation {
    fn describe(&self) -> Description {
        law("constant")
    }
}

impl DescribedAttenuation for InverseSquare {
    fn describe(&self) -> Description {
        law("inverse-square")
    }
}

impl DescribedAttenuation for Polynomial {
    fn describe(&self) -> Description {
        Description { coefficients: Some(self.coefficients()), ..law("polynomial") }
    }
}

impl DescribedAttenuation for SmoothRange {
    fn describe(&self) -> Description {
        Description { range: Some(SmoothRange::range(self)), ..law("smoothstep") }
    }
}

impl<W: NamedWindow, A: DescribedAttenuation + Attenuation> DescribedAttenuation for Ranged<W, A> {
    fn describe(&self) -> Description {
        let range = Ranged::range(self);
        Description { window: range.map(|_| W::TEXT), range, ..self.attenuation().describe() }
    }
}

/// The name of a window in JSON.
pub(crate) trait NamedWindow: Window {
    /// The name.
    const TEXT: &'static str;
}

impl NamedWindow for Cut {
    const TEXT: &'static str = "cut";
}

impl NamedWindow for GltfWindow {
    const TEXT: &'static str = "gltf";
}

impl NamedWindow for SquareWindow {
    const TEXT: &'static str = "square";
}
