//! From the pictures of an editor to the words of the sprite.

use luminaire::{display::threshold, draw::normals_from_opengl};

/// Red, green, blue and opacity of each pixel, row by row.
pub(crate) type Picture = Vec<[u8; 4]>;

/// The mark of the last word of a span.
const END: u32 = 1 << 8;

/// The sprite's numbers.
#[derive(Debug, PartialEq)]
pub(crate) struct Converted {
    /// The opaque pixels: `word::Word` has the layout.
    pub(crate) words: Vec<u32>,
    /// Where they are: row, first column, the column after the last.
    pub(crate) spans: Vec<[usize; 3]>,
    /// The colour and the glow of each material, in sRGB codes.
    pub(crate) materials: Vec<[[u8; 3]; 2]>,
}

/// Converts the colours, the normals in OpenGL's convention and the glow of a sprite of a width.
///
/// Each pair of a colour and a glow is a material, as of a picture with a palette.
///
/// # Errors
/// More than `most` materials; an opaque pixel whose normal is black or faces away.
pub(crate) fn convert(
    [color, normals, glow]: [&Picture; 3],
    width: usize,
    most: usize,
) -> Result<Converted, String> {
    let mut converted = Converted { words: Vec::new(), spans: Vec::new(), materials: Vec::new() };
    for (place, ((color, normal), glow)) in color.iter().zip(normals).zip(glow).enumerate() {
        let (x, y) = (place % width, place / width);
        let opaque = |pixel: &[u8; 4]| [pixel[0], pixel[1], pixel[2]];
        if color[3] < 128 {
            continue;
        }
        let [normal] = normals_from_opengl(&[opaque(normal)]);
        if normal[2] <= 0 {
            return Err(format!("normal = {normal:?} at ({x}, {y}): expected one that faces the viewer"));
        }
        let material = [opaque(color), if glow[3] < 128 { [0; 3] } else { opaque(glow) }];
        let index = converted.materials.iter().position(|known| *known == material).unwrap_or_else(|| {
            converted.materials.push(material);
            converted.materials.len() - 1
        });
        if index >= most {
            return Err(format!("colours > {most} at ({x}, {y}): expected a picture with a palette"));
        }
        let [nx, ny, nz] = nearest(normal).map(|c| u32::from(c as u8));
        let dither = u32::from(threshold(x as u32, y as u32)) >> 4;
        converted.words.push(nx << 24 | ny << 16 | nz << 9 | (index as u32) << 3 | dither);
        match converted.spans.last_mut() {
            Some([row, _, end]) if *row == y && *end == x => *end += 1,
            _ => converted.spans.push([y, x, x + 1]),
        }
    }
    let mut after = 0;
    for [_, start, end] in &converted.spans {
        after += end - start;
        converted.words[after - 1] |= END;
    }
    Ok(converted)
}

/// Returns three bytes along a vector, of a length near 127.
///
/// The nearest bytes to a vector of length 127 have a length from 126.2 to 127.8, by which a surface would be too bright
/// or too dark. Of the 27 next to them, these err least in the length and, a third as important, in the direction.
pub(crate) fn nearest(vector: [i8; 3]) -> [i8; 3] {
    let length = |vector: [f64; 3]| vector.iter().map(|c| c * c).sum::<f64>().sqrt();
    let exact = vector.map(f64::from);
    let exact = exact.map(|c| 127.0 * c / length(exact));
    let error = |bytes: [f64; 3]| {
        let apart = [0, 1, 2].map(|i| bytes[i] - exact[i]);
        3.0 * (length(bytes) - 127.0).abs() + length(apart)
    };
    let around = (0..27).map(|i| [i % 3, i / 3 % 3, i / 9].map(|step| f64::from(step) - 1.0));
    let candidates = around
        .map(|step| [0, 1, 2].map(|i| exact[i].round() + step[i]))
        .filter(|bytes| bytes[2] >= 0.0 && bytes.iter().all(|c| c.abs() <= 127.0));
    candidates.min_by(|a, b| error(*a).total_cmp(&error(*b))).unwrap_or(exact).map(|c| c as i8)
}
