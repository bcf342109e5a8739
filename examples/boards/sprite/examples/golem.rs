//! Draws the sprite's pictures in `art` from a height: a golem's head of stone, with moss and glowing eyes.
//!
//! `cargo run -p luminaire-sprite --example golem`

use std::fs::File;
use std::path::Path;

const SIDE: usize = 64;

/// The height of a body at a place, and its kind.
#[derive(Clone, Copy)]
struct Surface {
    height: f64,
    kind: Kind,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Stone,
    Pale,
    Dark,
    Eye,
    Moss,
}

/// A smooth step from 0 at `from` to 1 at `to`.
fn smooth(from: f64, to: f64, x: f64) -> f64 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// A rounded box of these half sides: its height, `None` outside.
fn slab(
    [x, y]: [f64; 2],
    center: [f64; 2],
    half: [f64; 2],
    [base, rise]: [f64; 2],
    round: f64,
) -> Option<f64> {
    let [dx, dy] = [(x - center[0]).abs() / half[0], (y - center[1]).abs() / half[1]];
    let part = dx.powf(round) + dy.powf(round);
    (part < 1.0).then(|| base + rise * (1.0 - part).powf(1.0 / round))
}

/// Noise of a lattice: smooth, from 0 to 1.
fn noise([x, y]: [f64; 2], scale: f64, seed: u32) -> f64 {
    let [x, y] = [x / scale + 100.0, y / scale + 100.0];
    let hash = |i: f64, j: f64| {
        let mut h = (i as u32).wrapping_mul(0x9e37_79b1)
            ^ (j as u32).wrapping_mul(0x85eb_ca77)
            ^ seed.wrapping_mul(0xc2b2_ae3d);
        h ^= h >> 15;
        h = h.wrapping_mul(0x2c1b_3c6d);
        h ^= h >> 12;
        h = h.wrapping_mul(0x297a_2d39);
        f64::from(h >> 8) / f64::from(1 << 24)
    };
    let (i, j) = (x.floor(), y.floor());
    let [u, v] = [x - i, y - j].map(|t| t * t * (3.0 - 2.0 * t));
    let row = |j: f64| hash(i, j) * (1.0 - u) + hash(i + 1.0, j) * u;
    row(j) * (1.0 - v) + row(j + 1.0) * v
}

/// A furrow along a line: how deep it is at a place, from 0 to 1.
fn furrow([x, y]: [f64; 2], [ax, ay]: [f64; 2], [bx, by]: [f64; 2], width: f64) -> f64 {
    let [dx, dy] = [bx - ax, by - ay];
    let along = (((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
    let apart = (x - ax - along * dx).hypot(y - ay - along * dy);
    1.0 - smooth(0.0, width, apart)
}

/// The golem at a place in pixels; `None` beside it.
fn golem(place: [f64; 2]) -> Option<Surface> {
    // The left half is a little different from the right.
    let [x, y] = place;
    let wobble = 0.7 * (noise(place, 7.0, 1) - 0.5);
    let [x, y] = [x - 31.5 + wobble, y - 31.5 + wobble];
    let side = x.abs();
    let mut best: Option<Surface> = None;
    let mut put = |height: Option<f64>, kind: Kind| {
        if let Some(height) = height
            && best.is_none_or(|best| height > best.height)
        {
            best = Some(Surface { height, kind });
        }
    };
    // Skull, jaw, cheeks, brow, nose, ears.
    put(slab([x, y], [0.0, -4.0], [23.0, 24.0], [0.0, 19.0], 3.0), Kind::Stone);
    put(slab([x, y], [0.0, 18.0], [18.5, 12.5], [2.0, 16.0], 3.4), Kind::Stone);
    put(slab([side, y], [15.5, 7.0], [8.5, 8.0], [8.0, 12.0], 2.6), Kind::Pale);
    put(slab([side, y + 0.16 * side], [9.5, -5.5], [13.0, 5.0], [10.0, 14.0], 2.8), Kind::Pale);
    put(slab([x, y], [0.0, 3.0], [4.4, 10.5], [10.0, 14.5], 2.4), Kind::Pale);
    put(slab([x, y], [0.0, 9.6], [6.2, 4.4], [10.0, 15.0], 2.4), Kind::Pale);
    put(slab([side, y], [25.5, 1.0], [5.0, 9.0], [0.0, 9.0], 2.6), Kind::Stone);
    put(slab([x, y], [0.0, 24.0], [8.5, 6.0], [9.0, 11.0], 2.6), Kind::Pale);
    put(slab([x, y], [0.0, -20.5], [9.0, 8.5], [9.0, 13.0], 2.8), Kind::Pale);
    let mut surface = best?;
    // Eye sockets, and eyes in them.
    let socket = ((side - 9.8) / 6.4).powi(2) + ((y - 1.6) / 4.2).powi(2);
    if socket < 1.0 && surface.height < 23.5 {
        let deep = 1.0 - smooth(0.35, 1.0, socket);
        surface.height -= 9.5 * deep;
        if socket > 0.2 {
            surface.kind = Kind::Dark;
        }
        let eye = ((side - 9.4) / 3.1).powi(2) + ((y - 1.7) / 1.9).powi(2);
        if eye < 1.0 {
            surface.height += 3.0 * (1.0 - eye).sqrt();
            surface.kind = Kind::Eye;
        }
    }
    // The mouth: a furrow between slabs of teeth.
    let mouth = furrow([x, y], [-12.0, 16.6], [12.0, 16.6], 2.4);
    let teeth = if side < 12.0 && (y - 17.5).abs() < 4.5 {
        furrow([(side + 2.0) % 4.0, 0.0], [2.0, -1.0], [2.0, 1.0], 0.9)
    } else {
        0.0
    };
    surface.height -= 4.6 * mouth + 1.3 * teeth;
    if mouth > 0.45 {
        surface.kind = Kind::Dark;
    }
    // Cracks.
    let cracks = [
        ([4.0, -27.0], [8.0, -21.0]),
        ([8.0, -21.0], [6.0, -15.5]),
        ([6.0, -15.5], [12.0, -11.0]),
        ([-21.0, -12.0], [-15.0, -15.0]),
        ([-15.0, -15.0], [-13.5, -20.0]),
        ([-19.0, 10.0], [-13.0, 13.0]),
        ([13.0, 24.0], [9.0, 20.5]),
        ([19.0, 3.5], [16.0, 10.5]),
    ];
    let crack = cracks.iter().map(|(a, b)| furrow([x, y], *a, *b, 1.25)).fold(0.0, f64::max);
    surface.height -= 2.2 * crack;
    if crack > 0.55 && surface.kind != Kind::Eye {
        surface.kind = Kind::Dark;
    }
    // Moss on the brow and the crown, thicker to the left.
    let moss = noise(place, 6.0, 5) + 0.55 * noise(place, 2.6, 6) + 0.011 * (-8.0 - y) - 0.006 * x;
    if moss > 1.04 && y < 4.0 && matches!(surface.kind, Kind::Stone | Kind::Pale) {
        surface.kind = Kind::Moss;
        surface.height += 1.1 * smooth(1.04, 1.16, moss) + 1.4 * (noise(place, 1.8, 7) - 0.5);
    }
    // Grain.
    let rough = if surface.kind == Kind::Eye {
        0.0
    } else {
        1.5 * (noise(place, 4.5, 2) - 0.5) + 0.8 * (noise(place, 2.0, 3) - 0.5)
    };
    Some(Surface { height: surface.height + rough, ..surface })
}

/// The colours of each kind, from dark to light.
fn palette(kind: Kind) -> &'static [[u8; 3]] {
    match kind {
        Kind::Stone => &[[128, 120, 116], [140, 131, 126], [152, 143, 136], [164, 154, 146]],
        Kind::Pale => &[[158, 148, 138], [172, 162, 150], [184, 174, 162], [196, 186, 174]],
        Kind::Dark => &[[76, 70, 72], [92, 85, 84]],
        Kind::Eye => &[[90, 150, 150]],
        Kind::Moss => &[[74, 98, 44], [90, 116, 50], [108, 134, 60], [128, 150, 74]],
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [mut color, mut normals, mut glow] = [[0_u8; 4]; 3].map(|empty| vec![empty; SIDE * SIDE]);
    for (place, ((color, normal), glow)) in color.iter_mut().zip(&mut normals).zip(&mut glow).enumerate() {
        let [x, y] = [place % SIDE, place / SIDE].map(|c| c as f64);
        let Some(surface) = golem([x, y]) else { continue };
        let tones = palette(surface.kind);
        let tone = (0.7 * noise([x, y], 5.0, 11) + 0.5 * noise([x, y], 1.6, 12) - 0.1) * tones.len() as f64;
        let [red, green, blue] = tones[(tone.max(0.0) as usize).min(tones.len() - 1)];
        *color = [red, green, blue, 255];
        // Beyond the outline the surface falls off steeply.
        let height =
            |dx: f64, dy: f64| golem([x + dx, y + dy]).map_or(surface.height - 2.2, |next| next.height);
        let slope = |a: f64, b: f64| ((a - b) / 2.0).clamp(-2.2, 2.2);
        let n = [slope(height(-1.0, 0.0), height(1.0, 0.0)), slope(height(0.0, 1.0), height(0.0, -1.0)), 1.0];
        let length = n.iter().map(|c| c * c).sum::<f64>().sqrt();
        let [nx, ny, nz] = n.map(|c| (128.0 + 127.0 * c / length).round() as u8);
        *normal = [nx, ny, nz, 255];
        *glow = match surface.kind {
            Kind::Eye => [40, 190, 180, 255],
            _ => [0, 0, 0, 255],
        };
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("art");
    for (name, picture) in [("golem", color), ("golem-normals", normals), ("golem-glow", glow)] {
        let mut encoder =
            png::Encoder::new(File::create(folder.join(format!("{name}.png")))?, SIDE as u32, SIDE as u32);
        encoder.set_color(png::ColorType::Rgba);
        encoder.write_header()?.write_image_data(picture.as_flattened())?;
    }
    Ok(())
}
