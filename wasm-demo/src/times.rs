//! The times of the passes of a picture.

/// The time of each pass in milliseconds, by the browser's clock.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Times {
    /// `None` if the picture was only re-lit.
    pub(crate) geometry: Option<f64>,
    /// `None` if no shadow map was redrawn.
    pub(crate) shadows: Option<f64>,
    pub(crate) lighting: f64,
    pub(crate) encode: f64,
    pub(crate) show: f64,
}
