//! A lighthouse that turns over a harbour, in 16-bit integers: prints what is seen from above as characters.
//!
//! Each frame aims the lamp along a direction in integers. A tile of the picture is lit only if the beam can reach it.

use luminaire::{
    AmbientLight, Angle, Cone, Fx16, Length, Material, Rgb, SpotLight, Vec3,
    display::encode_srgb,
    falloff::Hard,
    light::{CompiledMaterial, CompiledSpotLight, SurfacePoint},
    number::Light16,
};

type Light = CompiledSpotLight<Fx16, Hard>;

const COLUMNS: i16 = 80;
const ROWS: i16 = 24;
/// Columns and rows of a tile: 4 by 4 metres.
const TILE: [i16; 2] = [8, 4];
const TILES: i16 = COLUMNS / TILE[0] * (ROWS / TILE[1]);
/// How far to the east and to the south the lamp points in each frame, in metres; it points 12 metres down.
const TURN: [[i16; 2]; 4] = [[16, 0], [11, 6], [-8, 8], [-16, -3]];
/// Columns and rows of the lit windows.
const WINDOWS: [[i16; 2]; 6] = [[12, 4], [14, 4], [13, 6], [61, 17], [66, 18], [69, 18]];

/// What is lit: the ground, and windows that shine by themselves. The moon lights both.
struct Harbour {
    ground: CompiledMaterial<Fx16>,
    window: CompiledMaterial<Fx16>,
    moon: Rgb<Light16>,
}

type Picture = [[u8; COLUMNS as usize]; ROWS as usize];

fn main() -> Result<(), luminaire::Error> {
    let (lamp, harbour) = (lamp()?, harbour()?);
    for direction in TURN {
        let (picture, lit) = seen(&turned(lamp, direction), &harbour);
        println!("{lit} of {TILES} tiles in the beam's reach");
        for row in picture {
            println!(
                "{}",
                String::from_utf8_lossy(&row.map(|code| b" .:-=+*#%@"[usize::from(code) * 9 / 255]))
            );
        }
    }
    Ok(())
}

/// The lamp, twelve metres above the middle of the harbour.
fn lamp() -> Result<Light, luminaire::Error> {
    let cone = Cone::hard(Angle::degrees(24.0))?;
    SpotLight::new([20.0, 12.0, 12.0], [0.0, -1.0, 0.0], cone)?.with_intensity(700.0)?.compile()
}

fn harbour() -> Result<Harbour, luminaire::Error> {
    let ground = Material::new(Rgb::new(0.5, 0.5, 0.5))?.with_ambient(Rgb::new(0.3, 0.3, 0.4))?;
    Ok(Harbour {
        ground: ground.compile(),
        window: ground.with_emissive(Rgb::new(0.6, 0.5, 0.2))?.compile(),
        moon: AmbientLight::new(Rgb::new(0.8, 0.9, 1.0))?.with_intensity(0.06)?.compile::<Fx16>(),
    })
}

/// Aims the lamp along a direction.
fn turned(lamp: Light, [east, south]: [i16; 2]) -> Light {
    let direction = Vec3::new(east, -12, south).map(Length::from_int);
    // `None` would mean that the direction is zero.
    lamp.aimed_along(direction).unwrap_or(lamp)
}

/// The picture in sRGB codes, and the number of tiles that the beam can reach.
fn seen(light: &Light, harbour: &Harbour) -> (Picture, usize) {
    const RADIUS: Length = Fx16::length(2.9);
    let (mut picture, mut lit) = ([[0; COLUMNS as usize]; ROWS as usize], 0);
    for top in (0..ROWS).step_by(TILE[1] as usize) {
        for left in (0..COLUMNS).step_by(TILE[0] as usize) {
            let is_reached = light.can_reach(place([left + TILE[0] / 2, top + TILE[1] / 2]), RADIUS);
            let lights: &[Light] = if is_reached { &[*light] } else { &[] };
            lit += lights.len();
            for row in top..top + TILE[1] {
                for column in left..left + TILE[0] {
                    picture[row as usize][column as usize] = code([column, row], lights, harbour);
                }
            }
        }
    }
    (picture, lit)
}

/// The ground at a column and a row: two columns and one row to the metre.
fn place([column, row]: [i16; 2]) -> Vec3<Length> {
    Vec3::new(Length::from_bits(i32::from(column) << (16 - 1)), Length::ZERO, Length::from_int(row))
}

/// The sRGB code of a character.
fn code(at: [i16; 2], lights: &[Light], harbour: &Harbour) -> u8 {
    const UP: Vec3<Fx16> = Fx16::normal([0.0, 1.0, 0.0]);
    let material = if WINDOWS.contains(&at) { &harbour.window } else { &harbour.ground };
    encode_srgb(material.color(&SurfacePoint::matte(place(at), UP), lights, harbour.moon).green)
}

#[test]
fn a_tile_that_is_left_out_is_dark() {
    let (lamp, harbour) = (lamp().expect("a light"), harbour().expect("materials"));
    for direction in TURN {
        let light = turned(lamp, direction);
        let (picture, lit) = seen(&light, &harbour);
        assert!((1..usize::from(TILES.unsigned_abs()) / 2).contains(&lit), "{lit} tiles");
        for (row, codes) in (0..).zip(picture) {
            for (column, found) in (0..).zip(codes) {
                assert_eq!(found, code([column, row], &[light], &harbour), "column {column}, row {row}");
            }
        }
    }
}
