//! The converter: from the pictures of an editor to the words of a sprite.

#[path = "../convert.rs"]
mod convert;

use convert::{Picture, convert, nearest};
use luminaire_sprite::Word;

/// Opaque pixels of one colour, with these normals, in a row.
fn row(normals: &[[u8; 3]]) -> Result<Vec<Word>, String> {
    let [color, glow] = [[90, 80, 70, 255], [0; 4]].map(|pixel| vec![pixel; normals.len()]);
    let normals: Picture = normals.iter().map(|[r, g, b]| [*r, *g, *b, 255]).collect();
    let converted = convert([&color, &normals, &glow], normals.len(), 1)?;
    Ok(converted.words.into_iter().map(Word).collect())
}

fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|c| c * c).sum::<f64>().sqrt()
}

#[test]
fn normals_in_opengl_convention_have_y_down_and_unit_length() {
    let words = row(&[[128, 128, 255], [128, 218, 218], [218, 128, 218], [38, 128, 218]]).unwrap();
    let normals: Vec<_> = words.into_iter().map(Word::normal).collect();
    assert_eq!(normals, [[0, 0, 127], [0, -90, 90], [90, 0, 90], [-90, 0, 90]]);
}

#[test]
fn normals_err_little_in_length_and_direction() {
    let (mut longest, mut widest, mut count) = (0.0_f64, 0.0_f64, 0);
    for (turn, away) in (0..720).flat_map(|turn| (0..180).map(move |away| (turn, away))) {
        let [turn, away] = [turn, away].map(|half_degrees| (f64::from(half_degrees) / 2.0).to_radians());
        let normal = [turn.cos() * away.sin(), turn.sin() * away.sin(), away.cos()];
        // As the bytes of a map have it.
        let given = normal.map(|c| (127.0 * c).round() as i8);
        let (found, exact) = (nearest(given).map(f64::from), given.map(f64::from));
        assert!(found[2] >= 0.0);
        longest = longest.max((length(found) - 127.0).abs());
        let cross = [0, 1, 2].map(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            found[j] * exact[k] - found[k] * exact[j]
        });
        widest = widest.max((length(cross) / length(found) / length(exact)).asin().to_degrees());
        count += 1;
    }
    println!("{count} normals: {longest:.3} of 127, {widest:.3} degrees");
    // Measured: 0.493 of 127 and 0.742 degrees. As they are given, the lengths err by up to 0.77 of 127.
    assert!(longest < 0.5 && widest < 0.75, "{longest} of 127, {widest} degrees");
}

#[test]
fn runs_of_opaque_pixels_are_spans_with_an_end() {
    let (opaque, clear) = ([9, 9, 9, 255], [9, 9, 9, 127]);
    let color = vec![opaque, opaque, clear, opaque, clear, clear, opaque, opaque];
    let normals = vec![[128, 128, 255, 255]; 8];
    let glow = vec![[1, 2, 3, 255], [0; 4], [0; 4], [0; 4], [0; 4], [0; 4], [0; 4], [4, 5, 6, 9]];
    let converted = convert([&color, &normals, &glow], 4, 2).unwrap();
    assert_eq!(converted.spans, [[0, 0, 2], [0, 3, 4], [1, 2, 4]]);
    let ends: Vec<_> = converted.words.iter().map(|word| word >> 8 & 1).collect();
    assert_eq!(ends, [0, 1, 1, 0, 1]);
    // The glow that is not opaque is none.
    assert_eq!(converted.materials, [[[9; 3], [1, 2, 3]], [[9; 3], [0; 3]]]);
    let materials: Vec<_> = converted.words.iter().map(|word| word >> 3 & 31).collect();
    assert_eq!(materials, [0, 1, 1, 1, 1]);
}

#[test]
fn refused_pictures_are_named_with_place_and_expectation() {
    for (normal, found) in
        [([0, 0, 0], "[0, 0, 0]"), ([218, 128, 38], "[90, 0, -90]"), ([255, 128, 128], "[127, 0, 0]")]
    {
        let error = row(&[[128, 128, 255], normal]).unwrap_err();
        assert_eq!(error, format!("normal = {found} at (1, 0): expected one that faces the viewer"));
    }
    let color = vec![[1, 1, 1, 255], [2, 2, 2, 255]];
    let [normals, glow] = [[128, 128, 255, 255], [0; 4]].map(|pixel| vec![pixel; 2]);
    let error = convert([&color, &normals, &glow], 2, 1).unwrap_err();
    assert_eq!(error, "colours > 1 at (1, 0): expected a picture with a palette");
}
