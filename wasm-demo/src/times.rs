//! How long the passes of a picture took.

/// Milliseconds, by the browser's clock.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Times {
    /// Nothing when the picture was lit anew only.
    pub(crate) geometry: Option<f64>,
    /// Nothing when no shadow was drawn anew.
    pub(crate) shadows: Option<f64>,
    pub(crate) lighting: f64,
    pub(crate) encode: f64,
    pub(crate) show: f64,
}
