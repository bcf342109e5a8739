//! A guide in chapters: choose, describe, move, port and test a light.
//!
//! Each chapter says first what you will have at the end, then shows code; most end with limits. The code
//! is compiled, and asserts its figures: `cargo test -p luminaire --doc guide` runs it, but for the kernel of
//! [oracle], which is an example of its own. A figure that the code does not compute names the command that
//! prints it.
//!
//! | you want to | chapter |
//! |---|---|
//! | choose a number format | [format] |
//! | choose an edge for a light | [falloff] |
//! | describe a stage light by its data sheet | [data_sheet] |
//! | light pixels on a microcontroller | [microcontroller] |
//! | drive LEDs, grey displays or electronic paper | [outputs] |
//! | show a gradient without bands | [gradients] |
//! | move, aim, zoom and dim lights | [moving] |
//! | port a spotlight of another system | [porting]: [OpenGL](porting::opengl), [Direct3D 9](porting::direct3d), [glTF](porting::gltf), [three.js](porting::three), [Godot](porting::godot), [Bevy](porting::bevy) |
//! | light spans of pixels, arrays of points or vertices in a renderer | [scanline] |
//! | use vectors and colours of other crates | the features of [interop](crate::interop) |
//! | test a kernel of your own | [oracle] |
//! | know when to use something else | [not_for] |
//!
//! Whole programs are in `core/examples`; `cargo run -p luminaire --example NAME` runs one:
//!
//! | example | shows |
//! |---|---|
//! | `hello` | the shortest program: a pixel under a spotlight |
//! | `data_sheet` | from the angles and lumens of a data sheet to lux on a floor, and the bounds of the error |
//! | `wall` | two coloured lights on a wall, row by row, in the bytes of a display |
//! | `moving_light` | a light that follows a target, zooms and fades, in integers |
//! | `beacon` | a lighthouse: a direction in integers, tiles that no light reaches, materials that shine |
//! | `lighting_desk` | cones from the channels of a lighting desk, designed in integers |
//! | `street_light` | a light that is not round, by a table over all directions: turned and tilted in integers |
//! | `paper` | a normal map on electronic paper of four greys |
//! | `leds` | the bytes of four families of LEDs, and the hue that dim light keeps |
//! | `embedded_graphics` | a display of `embedded-graphics`, with `--features embedded-graphics-core04` |
//!
//! Commands are run in a clone of the repository; files such as `docs/EFFECTS.md` and folders such as
//! `examples/boards/` are in it, not in the crate.
//!
//! This module has no items: it is in the documentation alone.

#[doc = include_str!("../guide/format.md")]
pub mod format {}

#[doc = include_str!("../guide/falloff.md")]
pub mod falloff {}

#[doc = include_str!("../guide/data_sheet.md")]
pub mod data_sheet {}

#[doc = include_str!("../guide/microcontroller.md")]
pub mod microcontroller {}

#[doc = include_str!("../guide/outputs.md")]
pub mod outputs {}

#[doc = include_str!("../guide/gradients.md")]
pub mod gradients {}

#[doc = include_str!("../guide/moving.md")]
pub mod moving {}

#[doc = include_str!("../guide/porting.md")]
/// ```
#[doc = include_str!("../guide/worst.rs")]
/// ```
pub mod porting {
    #[doc = include_str!("../guide/porting/opengl.md")]
    pub mod opengl {}

    #[doc = include_str!("../guide/porting/direct3d.md")]
    pub mod direct3d {}

    #[doc = include_str!("../guide/porting/gltf.md")]
    pub mod gltf {}

    #[doc = include_str!("../guide/porting/three.md")]
    pub mod three {}

    #[doc = include_str!("../guide/porting/godot.md")]
    pub mod godot {}

    #[doc = include_str!("../guide/porting/bevy.md")]
    pub mod bevy {}
}

#[doc = include_str!("../guide/scanline.md")]
pub mod scanline {}

// `luminaire-oracle` tests this code as its example; here it would depend on an unpublished crate.
#[doc = include_str!("../guide/oracle.md")]
#[cfg_attr(not(doctest), doc = concat!("```\n", include_str!("../guide/own_kernel.rs"), "\n```\n"))]
#[doc = include_str!("../guide/oracle_end.md")]
pub mod oracle {}

#[doc = include_str!("../guide/not_for.md")]
pub mod not_for {}
