//! Sizes of pictures.

use core::fmt;
use luminaire::projector::Fixture;

/// The largest width and the largest height of a picture, in pixels.
pub const LARGEST: usize = 8192;

/// The largest number of shares of a picture.
pub(crate) const MOST_SHARES: usize = 64;

/// A rejected size of a picture or shadow map.
///
/// The message names the parameter, its value and the accepted values.
///
/// ```
/// use luminaire_render::Renderer;
/// let refused = Renderer::<f32>::new(960, 0).unwrap_err();
/// assert_eq!(refused.to_string(), "height = 0: expected 1 to 8192 pixels");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum SizeError {
    /// A rejected width: zero, or more than [`LARGEST`] pixels.
    Width(usize),
    /// A rejected height: zero, or more than [`LARGEST`] pixels.
    Height(usize),
    /// A rejected share of a picture, with the number of shares: see
    /// [`Stripes::new`](crate::Stripes::new).
    Share(usize, usize),
    /// A shadow map with a rejected number of depths, and the expected number.
    Depths(usize, usize),
    /// A rejected side of a shadow map: outside 16 to 2048 texels.
    ShadowSide(usize),
    /// A valid width and height of a picture that does not fit into memory.
    Memory(usize, usize),
}

impl SizeError {
    /// Returns an error for an invalid size; called before anything is allocated.
    pub(crate) fn check(width: usize, height: usize) -> Result<(), Self> {
        match (accepts(width), accepts(height)) {
            (false, _) => Err(Self::Width(width)),
            (_, false) => Err(Self::Height(height)),
            _ => Ok(()),
        }
    }
}

fn accepts(pixels: usize) -> bool {
    (1..=LARGEST).contains(&pixels)
}

impl fmt::Display for SizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Width(width) => write!(f, "width = {width}: expected 1 to {LARGEST} pixels"),
            Self::Height(height) => write!(f, "height = {height}: expected 1 to {LARGEST} pixels"),
            Self::Share(share, count) => {
                let most = MOST_SHARES;
                write!(
                    f,
                    "share = {share} of {count}: expected a share below the count, and a count of 1 to {most}"
                )
            }
            Self::Depths(depths, expected) => {
                write!(
                    f,
                    "depths of a shadow map = {depths}: expected {expected}, those of the fixture's map"
                )
            }
            Self::ShadowSide(side) => {
                let (least, most) = (Fixture::SHADOW_SIDES.start(), Fixture::SHADOW_SIDES.end());
                write!(f, "side of a shadow map = {side}: expected {least} to {most} texels")
            }
            Self::Memory(width, height) => {
                write!(
                    f,
                    "size = {width} x {height}: expected fewer pixels, for there is no memory for so many"
                )
            }
        }
    }
}

impl core::error::Error for SizeError {}
