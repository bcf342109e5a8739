//! Light that surfaces reflect.

use crate::constants::{AMBIENT, DIRECTIONAL, MATTE};
use crate::format::{Light, Surface};

effects! { matte_alone;
    /// A diffuse colour and nothing else.
    "matte", surface, [];
    fn matte(surface: Surface) -> Light { MATTE.reflect(&surface, &DIRECTIONAL) }
}

effects! { sum;
    /// Light that is everywhere, as one matte material sends it back, added to that of the other lights.
    "ambient light", light, [Ambient];
    fn ambient(lights: Light) -> Light { lights + MATTE.glow(AMBIENT) }
}
