//! The picture that other sites show beside a link to the demo: the scene with which it opens.

use super::picture::Picture;
use luminaire_render::{Renderer, scenes::Example};
use std::error::Error;

/// Width and height in pixels, as most sites show link previews. The demo's page states the same size.
const SIZE: (usize, usize) = (1200, 630);

/// The time within the scene, in seconds, at which the beams are spread over the stage.
const SECOND: f32 = 3.0;

pub(crate) fn picture() -> Result<Picture, Box<dyn Error>> {
    let setup = Example::Show.setup()?;
    let fixtures = setup.fixtures_at(SECOND)?;
    let mut renderer = Renderer::<f32>::new(SIZE.0, SIZE.1)?;
    renderer.draw_geometry(&setup.scene, &setup.camera);
    renderer.draw_shadows(&setup.scene, &fixtures)?;
    renderer.draw_light(&fixtures)?;
    let codes = renderer.encode().chunks_exact(4).flat_map(|pixel| &pixel[..3]).copied().collect();
    Ok(Picture { width: SIZE.0, height: SIZE.1, codes })
}
