//! From light to the codes of a display.

use luminaire::{
    Rgb,
    display::{Exposure, Rgb565, decode_srgb, encode_srgb, encode_srgb_dithered},
};

use crate::case::{Case, Outcome};
use crate::word::Format;

/// Light after an exposure.
pub(super) fn expose<S: Format>(case: &mut Case<'_>) -> Outcome {
    let (factor, light) = (case.number("exposure"), case.light::<S>("light"));
    case.give_color(Exposure::factor(factor)?.compile::<S>().expose(light));
    Ok(())
}

/// Light clipped to full scale.
pub(super) fn clip<S: Format>(case: &mut Case<'_>) -> Outcome {
    let light = case.light::<S>("light");
    case.give_color(luminaire::display::clip(light));
    Ok(())
}

/// Light scaled to full scale, with its hue kept.
pub(super) fn compress_keep_hue<S: Format>(case: &mut Case<'_>) -> Outcome {
    let light = case.light::<S>("light");
    case.give_color(luminaire::display::compress_keep_hue(light));
    Ok(())
}

/// The code of a linear value.
pub(super) fn srgb<S: Format>(case: &mut Case<'_>) -> Outcome {
    let linear = case.scalar::<S>("linear");
    case.give(encode_srgb(linear));
    Ok(())
}

/// The pixel of a linear colour.
pub(super) fn rgb565<S: Format>(case: &mut Case<'_>) -> Outcome {
    let color = case.normal::<S>("linear");
    case.give(Rgb565::from_linear(Rgb::new(color.x, color.y, color.z)).0);
    Ok(())
}

/// The dithered code of a linear value, for a pixel at a column and row.
pub(super) fn srgb_dithered<S: Format>(case: &mut Case<'_>) -> Outcome {
    let linear = case.scalar::<S>("linear");
    let (column, row) = (case.whole("column"), case.whole("row"));
    case.give(encode_srgb_dithered(linear, column, row));
    Ok(())
}

/// The dithered pixel of a linear colour.
pub(super) fn rgb565_dithered<S: Format>(case: &mut Case<'_>) -> Outcome {
    let color = case.normal::<S>("linear");
    let (column, row) = (case.whole("column"), case.whole("row"));
    case.give(Rgb565::from_linear_dithered(Rgb::new(color.x, color.y, color.z), column, row).0);
    Ok(())
}

/// The linear value of a code, which is the input's low eight bits.
pub(super) fn decode(case: &mut Case<'_>) -> Outcome {
    let code = case.whole("code");
    case.give(decode_srgb::<f32>(code as u8));
    Ok(())
}
