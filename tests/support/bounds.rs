//! The tables of error bounds, `tests/bounds.csv`. Each bound is a measured largest error with a
//! little headroom: a test fails if an error exceeds its bound, and also if the bound is more than
//! twice the error.
//!
//! | table | errors | unit | columns | labelled |
//! |---|---|---|---|---|
//! | `falloff` | versine to intensity | steps of the format | one | searched |
//! | `spot` | position to intensity | full scale | [`HALF_ANGLES`](super::sweep::HALF_ANGLES) | searched |
//! | `lit` | position and normal to irradiance, with Lambert's cosine and the inverse square, of a light that reaches full scale about where the point is | the larger of full scale and the light on the axis there | the same | searched |
//! | `exhaustive` | versine to intensity, every versine | steps of the format | `slow::exhaustive::CONES` | exhaustive |
//! | `fractions` | `t` to intensity, every fraction of 30 bits | steps of `Fx32` | one | exhaustive |
//! | `operation` | one operation of the seam | steps of the format, relative or radians, by its name; 0 is exact | one | searched |
//! | `set-up` | one result of set-up, which is f32 whatever the format | relative, or by its name | one | searched |
//! | `attenuation` | a point light at 0.02 to 1.1 times its range, at full scale at half of it if it falls so | the larger of full scale and the light without a window | one | searched |
//! | `lobe` | a highlight, from directions and a normal as stored, by its shininess | full scale | one | searched |
//! | `lit point` | the classic equation with ambient light, a spotlight and a highlight: linear, and in codes before rounding | full scale, sRGB codes | one | searched |
//! | `difference form` | Lyon's form and the power that it approximates, in exact arithmetic | full scale | shininess 16, 64, 256 | searched |
//! | `square` | a place on the projected square, from the middle of its step; its depth | sides; relative | these two | searched |
//! | `gobo` | the transmittance of random texels, at a place or a point | full scale | one | searched |
//! | `haze` | air light of 1,800 rays, by the inverse square | what is seen there, or across the axis as near to the light where that is more | [`haze::HALF_ANGLES`](super::haze::HALF_ANGLES) | searched |
//! | `haze attenuation`, `haze critical` | the same of the soft edge with another attenuation, and along rays near critical directions | the same | the same | searched |
//! | `haze law` | what a law allows for rounding | relative | one | searched |
//! | `seen linear`, `seen codes` | from an exact position and axis to the display | 1/255; sRGB codes before rounding | [`limits::CONES`](super::limits::CONES) | searched |
//!
//! `LUMINAIRE_BLESS=1 LUMINAIRE_FULL=1 cargo test --test suite --test slow -- accuracy::
//! exhaustive:: haze::every_cone` writes the rows that are missing or do not hold, and with
//! `LUMINAIRE_SHAPE` those of the shape with this name alone.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::{LazyLock, Mutex};

/// In place of a bound: the format refuses such a narrow cone.
pub const REFUSE: f64 = f64::INFINITY;

/// Largest ratio of a bound to the measured error. Bounds come from the long search, and the quick
/// search evaluates fewer points.
const LOOSE: f64 = 2.0;

/// Bounds by table, shape and format.
type Rows = BTreeMap<[String; 3], Vec<f64>>;

const HEADER: &str = "# table,shape,format,bounds\n";
static ROWS: LazyLock<Mutex<Rows>> = LazyLock::new(|| Mutex::new(read(include_str!("../bounds.csv"))));

fn read(text: &str) -> Rows {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines
        .map(|line| {
            let mut words = line.split(',');
            let key = [(); 3].map(|()| words.next().unwrap_or_default().to_owned());
            let bound = |word| if word == "refused" { REFUSE } else { str::parse(word).expect(line) };
            (key, words.map(bound).collect())
        })
        .collect()
}

fn write(rows: &Rows) {
    let mut text = HEADER.to_owned();
    for (key, bounds) in rows {
        let bound = |bound: &f64| if *bound == REFUSE { "refused".to_owned() } else { short(*bound) };
        text += &format!("{},{}\n", key.join(","), bounds.iter().map(bound).collect::<Vec<_>>().join(","));
    }
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bounds.csv");
    fs::write(file, text).expect("the table of bounds can be written");
}

/// A bound as it is written.
fn short(bound: f64) -> String {
    if bound == 0.0 || bound >= 0.1 { format!("{bound}") } else { format!("{bound:e}") }
}

/// A bound for a measured error: 3 % more, rounded up to two figures.
fn headroom(error: f64) -> f64 {
    if error == 0.0 || error == REFUSE {
        return error;
    }
    let unit = 10.0_f64.powi((1.03 * error).log10().floor() as i32 - 1);
    format!("{:.1e}", (1.03 * error / unit).ceil() * unit).parse().expect("a number")
}

/// The bounds of a shape in a format.
pub fn of(table: &str, shape: &str, format: &str) -> Option<Vec<f64>> {
    let key = [table, shape, format].map(str::to_owned);
    ROWS.lock().expect("no test panics with the table").get(&key).cloned()
}

/// Returns a message for each measured error of a shape that does not agree with its row.
pub fn broken(table: &str, shape: &str, format: &str, measured: &[f64]) -> Vec<String> {
    let name = format!("{table} {shape} {format}");
    let broken = match of(table, shape, format) {
        Some(bounds) if bounds.len() == measured.len() => {
            let cells = measured.iter().zip(bounds).enumerate();
            cells
                .filter_map(|(i, (&error, bound))| check(&format!("{name}, column {i}"), error, bound).err())
                .collect()
        }
        _ => vec![format!("{name} has no row: {measured:?}")],
    };
    if broken.is_empty() || !is_blessed() {
        return broken;
    }
    let mut rows = ROWS.lock().expect("no test panics with the table");
    let key = [table, shape, format].map(str::to_owned);
    rows.insert(key, measured.iter().copied().map(headroom).collect());
    write(&rows);
    Vec::new()
}

/// Whether rows are written, but not those of this shape.
pub fn is_left_out(shape: &str) -> bool {
    is_blessed() && std::env::var("LUMINAIRE_SHAPE").is_ok_and(|only| only != shape)
}

/// Whether the rows that do not hold are written.
fn is_blessed() -> bool {
    std::env::var_os("LUMINAIRE_BLESS").is_some()
}

/// Errors with three digits each.
pub fn shown(errors: &[f64]) -> String {
    errors.iter().map(|error| format!("{error:.2e}")).collect::<Vec<_>>().join(", ")
}

/// Asserts that no row is broken.
#[track_caller]
pub fn assert_kept(broken: &[String]) {
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

/// Asserts that one error in each of `f32`, `Fx32` and `Fx16` keeps the bound of its row.
#[track_caller]
pub fn assert_row(table: &str, shape: &str, measured: [f64; 3]) {
    println!("{table} {shape}: {}", shown(&measured));
    let formats = ["f32", "fx32", "fx16"].into_iter().zip(measured);
    let broken: Vec<_> = formats.flat_map(|(format, error)| broken(table, shape, format, &[error])).collect();
    assert_kept(&broken);
}

/// Asserts that an error that has one format alone keeps the bound of its row.
#[track_caller]
pub fn assert_figure(table: &str, shape: &str, measured: f64) {
    println!("{table} {shape}: {measured:.2e}");
    assert_kept(&broken(table, shape, "f32", &[measured]));
}

/// Returns an error if a measured error exceeds its bound, or if the bound is loose; the message
/// says which of the two. A cone must be refused exactly where the table says so.
pub fn check(name: &str, measured: f64, bound: f64) -> Result<(), String> {
    if measured > bound {
        Err(format!("{name}: the error is {measured:.2e}, over its bound of {bound:.2e}"))
    } else if bound > LOOSE * measured {
        Err(format!("{name}: the bound of {bound:.2e} is loose, the error is only {measured:.2e}"))
    } else {
        Ok(())
    }
}
