//! Visible points and shadows, compared with f64.

use luminaire::Vec3;
use luminaire::number::Length;

use super::measures::{BALL, BALL_RADIUS, COLUMN, COLUMN_HEIGHT, COLUMN_RADIUS, EYE, LIGHT, WALL};
use super::scene::{Material, Site, look};
use super::shadow::is_in_shadow;
use super::{HEIGHT, WIDTH};

type Vector = [f64; 3];

fn wide(metres: [f32; 3]) -> Vector {
    metres.map(f64::from)
}

fn point(start: Vector, way: Vector, after: f64) -> Vector {
    [0, 1, 2].map(|i| start[i] + after * way[i])
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Parameter at which a line enters an object that is round in the axes of `mask`. `None` if the
/// line starts inside the object, misses it or only touches it.
fn entry(start: Vector, way: Vector, middle: Vector, radius: f64, mask: Vector) -> Option<f64> {
    let masked = |v: Vector| [0, 1, 2].map(|i| v[i] * mask[i]);
    let (way, from) = (masked(way), masked([0, 1, 2].map(|i| start[i] - middle[i])));
    let (a, b, c) = (dot(way, way), dot(from, way), dot(from, from) - radius * radius);
    let discriminant = b * b - a * c;
    (discriminant > 0.0 && b < 0.0 && c > 0.0).then(|| (-b - discriminant.sqrt()) / a)
}

fn into_ball(start: Vector, way: Vector) -> Option<f64> {
    entry(start, way, wide(BALL), BALL_RADIUS.into(), [1.0; 3])
}

/// Parameter at which a line enters the column through its side or its top, and the normal there.
fn into_column(start: Vector, way: Vector) -> Option<(f64, Vector)> {
    let middle = wide([COLUMN[0], 0.0, COLUMN[1]]);
    let (height, radius) = (f64::from(COLUMN_HEIGHT), f64::from(COLUMN_RADIUS));
    let side = entry(start, way, middle, radius, [1.0, 0.0, 1.0])?;
    let there = point(start, way, side);
    if there[1] <= height {
        let normal = [(there[0] - middle[0]) / radius, 0.0, (there[2] - middle[2]) / radius];
        return (there[1] >= 0.0).then_some((side, normal));
    }
    let top = (height - start[1]) / way[1];
    let [x, _, z] = point(start, way, top);
    let is_over = (x - middle[0]).hypot(z - middle[2]) < radius;
    (top > 0.0 && is_over).then_some((top, [0.0, 1.0, 0.0]))
}

/// The line of sight through the centre of a pixel. At a depth of 1, a pixel is 410/65,536 wide.
fn sight(column: usize, row: usize) -> Vector {
    let slope = |pixels: f64| pixels * 410.0 / 65_536.0;
    [slope(column as f64 + 0.5 - 80.0), -slope(row as f64 + 0.5 - 38.0), -1.0]
}

/// The material, the depth and the normal that a pixel shows.
fn exact(column: usize, row: usize) -> (Material, f64, Vector) {
    let (eye, way) = (wide(EYE), sight(column, row));
    let wall = (Material::Wall, eye[2] - f64::from(WALL), [0.0, 0.0, 1.0]);
    let floor = (Material::LightTile, -eye[1] / way[1], [0.0, 1.0, 0.0]);
    let ball = into_ball(eye, way).map(|depth| {
        let there = point(eye, way, depth);
        let normal = [0, 1, 2].map(|i| (there[i] - f64::from(BALL[i])) / f64::from(BALL_RADIUS));
        (Material::Ball, depth, normal)
    });
    let column = into_column(eye, way).map(|(depth, normal)| (Material::Column, depth, normal));
    let all = [Some(wall), Some(floor), ball, column].into_iter().flatten().filter(|seen| seen.1 > 0.0);
    all.min_by(|a, b| a.1.total_cmp(&b.1)).expect("the wall is everywhere")
}

fn seen() -> Vec<(usize, usize, Site)> {
    let mut all = Vec::new();
    for row in 0..HEIGHT {
        let mut sites = [Site::default(); WIDTH];
        look(row, &mut sites);
        all.extend(sites.into_iter().enumerate().map(|(column, site)| (column, row, site)));
    }
    all
}

fn metres(point: Vec3<Length>) -> Vector {
    [point.x, point.y, point.z].map(|c| c.to_f64())
}

/// Exhaustive over the picture: every pixel shows the right material, with depth and normal within
/// the stated errors.
#[test]
fn pixels_see_what_is_there() {
    let (mut outline, mut off, mut turned) = (0, 0.0_f64, 0.0_f64);
    for (column, row, site) in seen() {
        let (material, depth, normal) = exact(column, row);
        let is_tile = |material| matches!(material, Material::LightTile | Material::DarkTile);
        if site.material != material && !(is_tile(site.material) && is_tile(material)) {
            outline += 1;
            continue;
        }
        let there = point(wide(EYE), sight(column, row), depth);
        let found = metres(site.point);
        off = [0, 1, 2].iter().map(|&i| (found[i] - there[i]).abs()).fold(off, f64::max);
        let found = [site.normal.x, site.normal.y, site.normal.z].map(|c| c.to_f64());
        turned = [0, 1, 2].iter().map(|&i| (found[i] - normal[i]).abs()).fold(turned, f64::max);
    }
    println!("{outline} pixels, {:.2} mm, normals by {turned:.1e}", 1000.0 * off);
    assert_eq!(outline, 0, "so many pixels see something else");
    assert!((0.5e-3..=0.7e-3).contains(&off), "a point is off by {off} m");
    assert!((0.9e-3..=1.3e-3).contains(&turned), "a normal is off by {turned}");
}

#[test]
fn tiles_are_half_a_metre_wide() {
    for (_, _, site) in seen() {
        let [x, _, z] = metres(site.point).map(|metres| (2.0 * metres).floor() as i32);
        match site.material {
            Material::LightTile => assert_eq!((x + z) % 2, 0),
            Material::DarkTile => assert_ne!((x + z) % 2, 0),
            _ => {}
        }
    }
}

/// Shadows are exact except for a few pixels at their outline.
#[test]
fn shadows_fall_where_they_should() {
    let (mut outline, mut count) = (0, 0);
    for (_, _, site) in seen() {
        let start = metres(site.point);
        let way = [0, 1, 2].map(|i| f64::from(LIGHT[i]) - start[i]);
        let before_light = |after: f64| after < 1.0;
        let by_ball = site.material != Material::Ball && into_ball(start, way).is_some_and(before_light);
        let by_column =
            site.material != Material::Column && entry_below_top(start, way).is_some_and(before_light);
        count += usize::from(by_ball || by_column);
        outline += usize::from(is_in_shadow(&site) != (by_ball || by_column));
    }
    println!("{outline} of {count} pixels in shadow");
    assert!(count > 1000, "{count} pixels are in shadow");
    assert!((1..=8).contains(&outline), "{outline} pixels of {count}");
}

/// Parameter at which a rising line enters the column. It cannot enter through the top.
fn entry_below_top(start: Vector, way: Vector) -> Option<f64> {
    let middle = wide([COLUMN[0], 0.0, COLUMN[1]]);
    let side = entry(start, way, middle, COLUMN_RADIUS.into(), [1.0, 0.0, 1.0])?;
    (point(start, way, side)[1] < f64::from(COLUMN_HEIGHT)).then_some(side)
}
