//! A street light on a pole, in 16-bit integers: prints the road and the pavement as characters, and again with the light
//! turned and tilted by somebody on a ladder.
//!
//! The table of its distribution is computed here from a formula. `luminaire export --to rust --from FILE` writes that of a
//! photometric file.

use luminaire::{
    Fx16, Length, MeasuredLight, Rgb, Vec3,
    display::{clip, encode_srgb},
    light::{CompiledMeasuredLight, Distribution, Symmetry},
};

const SIZE: u32 = 17;
const COLUMNS: i16 = 80;
const ROWS: i16 = 20;
/// Metres from one column to the next, and from one row to the next, in quarters.
const STEP: [i16; 2] = [2, 3];

fn main() -> Result<(), luminaire::Error> {
    let samples = samples();
    let distribution = Distribution::new(&samples, SIZE, Symmetry::Bilateral)?;
    // The side is along the road, and the front over it, towards -z. It is bilateral about the plane of axis and side, and
    // so are the lobes to both sides of the road.
    let light = MeasuredLight::new([20.0, 8.0, 7.5], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0], distribution)?;
    let lamp = light.with_intensity(120.0)?.compile::<Fx16>()?;
    print(&lamp);
    let whole = |v: [i16; 3]| Vec3::from(v.map(Length::from_int));
    // Its plane of symmetry is turned to the right, and its axis tilted towards the houses.
    let moved = lamp.turned_to(whole([1, 0, -3])).and_then(|lamp| lamp.aimed_along(whole([0, -4, -1])));
    if let Some(moved) = moved {
        println!("\nturned and tilted: it points along {:?}", moved.frame()[2].map(|c| c.to_f32()));
        print(&moved);
    }
    Ok(())
}

/// Two lobes, 65 degrees from straight down and 20 degrees over the road to both sides, row by row: in rows of y, across the
/// plane of symmetry, and columns of x, over the road.
fn samples() -> Vec<u16> {
    let half = SIZE / 2;
    let place = |index: u32| index as f32 / half as f32;
    let rows = (0..=half).flat_map(|row| (0..SIZE).map(move |column| (place(column) - 1.0, place(row))));
    rows.map(|(x, y)| {
        let along = 1.0 - x.abs() - y;
        let [over, across, down] =
            if along < 0.0 { [x.signum() * (1.0 - y), 1.0 - x.abs(), along] } else { [x, y, along] };
        let size = (over * over + across * across + down * down).sqrt();
        let cosine = (0.31 * over + 0.85 * across + 0.42 * down) / size;
        let lobe = cosine.max(0.0).powi(10) + 0.15 * (down / size).max(0.0);
        (65_535.0 * lobe.min(1.0)) as u16
    })
    .collect()
}

fn print(lamp: &CompiledMeasuredLight<'_, Fx16>) {
    let up = Fx16::normal([0.0, 1.0, 0.0]);
    for row in 0..ROWS {
        let line = (0..COLUMNS).map(|column| {
            let quarter = |count: i16| Length::from_bits(i32::from(count) << 14);
            let point = Vec3::new(quarter(STEP[0] * column), Length::ZERO, quarter(STEP[1] * row));
            let light = clip(Rgb::lit(lamp.irradiance(point, up), lamp.color())).green;
            char::from(b" .:-=+*#%@"[usize::from(encode_srgb(light)) * 9 / 255])
        });
        println!("{}", line.collect::<String>());
    }
}
