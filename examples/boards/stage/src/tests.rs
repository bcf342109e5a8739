//! What the pixels see, what is in shadow, and the colour of the pixels, against f64.

use std::array;
use std::ops::Range;

use luminaire::falloff::Soft;
use luminaire::number::{Length, Light16};
use luminaire::{Angle, Cone, Fx16, Vec3};
use luminaire_oracle::{self as oracle, DVec3, SpotLight};

use super::backdrop::Seen;
use super::column::Side;
use super::measures::{
    AMBIENT, AXIS, BALL, BALL_RADIUS, COLOR, COLUMN, COLUMN_HEIGHT, COLUMN_RADIUS, EYE, FIELD, INTENSITY,
    LIGHT, MATERIALS, WALL,
};
use super::paint::RAMPS;
use super::scene::look;
use super::shadow::is_in_shadow;
use super::site::{Material, Site};
use super::{Stage, path};

fn wide(metres: [f32; 3]) -> DVec3 {
    metres.map(f64::from).into()
}

/// Parameter at which a line enters an object that is round in the axes of `mask`, if it starts
/// outside and does not only touch it.
fn entry(start: DVec3, way: DVec3, middle: DVec3, radius: f64, mask: DVec3) -> Option<f64> {
    let (way, from) = (way * mask, (start - middle) * mask);
    let (a, b, c) = (way.length_squared(), from.dot(way), from.length_squared() - radius * radius);
    let discriminant = b * b - a * c;
    (discriminant > 0.0 && b < 0.0 && c > 0.0).then(|| (-b - discriminant.sqrt()) / a)
}

fn into_ball(start: DVec3, way: DVec3) -> Option<f64> {
    entry(start, way, wide(BALL), BALL_RADIUS.into(), DVec3::ONE)
}

/// Where a line enters the column by its side or by its top, and the normal there.
fn into_column(start: DVec3, way: DVec3) -> Option<(f64, DVec3)> {
    let middle = wide([COLUMN[0], 0.0, COLUMN[1]]);
    let (height, radius) = (f64::from(COLUMN_HEIGHT), f64::from(COLUMN_RADIUS));
    let side = entry(start, way, middle, radius, DVec3::new(1.0, 0.0, 1.0))?;
    let there = start + side * way;
    if there.y <= height {
        let normal = ((there - middle) / radius).with_y(0.0);
        return (there.y >= 0.0).then_some((side, normal));
    }
    let top = (height - start.y) / way.y;
    let is_over = (start + top * way - middle).with_y(0.0).length() < radius;
    (top > 0.0 && is_over).then_some((top, DVec3::Y))
}

/// A picture: its width and its rows.
#[derive(Clone)]
struct View<const WIDTH: usize>(Range<i32>);

const SMALL: View<160> = View(0..120);
const LARGE: View<240> = View(-40..200);

impl<const WIDTH: usize> View<WIDTH> {
    /// The line of sight through the middle of a pixel. The pixels of `SMALL` are 410/65,536 wide,
    /// and those of `LARGE` 274/65,536.
    fn sight(column: usize, row: i32) -> DVec3 {
        let (pixel, horizon) = if WIDTH == 160 { (410.0, 38.0) } else { (274.0, 57.0) };
        let slope = |pixels: f64| pixels * pixel / 65_536.0;
        let right = slope(column as f64 + 0.5 - WIDTH as f64 / 2.0);
        DVec3::new(right, -slope(f64::from(row) + 0.5 - horizon), -1.0)
    }

    /// What each pixel sees, with its line of sight.
    fn seen(self) -> impl Iterator<Item = (DVec3, Material, Site)> {
        let (side, mut seen) = (Side::new::<WIDTH>(), Seen::new::<WIDTH>());
        self.0.flat_map(move |row| {
            let mut sites = [Site::default(); WIDTH];
            look(&mut seen, &side, row, &mut sites);
            let seen = seen.clone();
            let sites = seen.sites(&sites).into_iter().enumerate();
            sites.map(move |(column, site)| (Self::sight(column, row), seen.material(column), site))
        })
    }
}

/// What each pixel of both pictures sees, with its line of sight.
fn seen() -> impl Iterator<Item = (DVec3, Material, Site)> {
    SMALL.seen().chain(LARGE.seen())
}

/// What a line of sight meets: how far into the depth, and with which normal.
fn exact(way: DVec3) -> (Material, f64, DVec3) {
    let eye = wide(EYE);
    let wall = (Material::Wall, eye.z - f64::from(WALL), DVec3::Z);
    let floor = (Material::LightTile, -eye.y / way.y, DVec3::Y);
    let ball = into_ball(eye, way)
        .map(|depth| (Material::Ball, depth, (eye + depth * way - wide(BALL)) / f64::from(BALL_RADIUS)));
    let column = into_column(eye, way).map(|(depth, normal)| (Material::Column, depth, normal));
    let all = [Some(wall), Some(floor), ball, column].into_iter().flatten().filter(|seen| seen.1 > 0.0);
    all.min_by(|a, b| a.1.total_cmp(&b.1)).expect("the wall is everywhere")
}

fn metres(point: Vec3<Length>) -> DVec3 {
    DVec3::new(point.x.to_f64(), point.y.to_f64(), point.z.to_f64())
}

/// Returns the largest errors of the points, in metres, and of the components of the normals of what
/// a picture shows. Every pixel must see what a line of sight meets.
fn seen_errors<const WIDTH: usize>(view: View<WIDTH>) -> (f64, f64) {
    let (mut off, mut turned) = (0.0_f64, 0.0_f64);
    for (sight, found, site) in view.seen() {
        let (material, depth, normal) = exact(sight);
        let is_tile = |material| matches!(material, Material::LightTile | Material::DarkTile);
        let is_same = found == material || (is_tile(found) && is_tile(material));
        assert!(is_same, "expected {material:?}, found {found:?} at {site:?}");
        let there = wide(EYE) + depth * sight;
        off = off.max((metres(site.point) - there).abs().max_element());
        let found = DVec3::new(site.normal.x.to_f64(), site.normal.y.to_f64(), site.normal.z.to_f64());
        turned = turned.max((found - normal).abs().max_element());
    }
    println!("{:.2} mm, normals by {turned:.1e}", 1000.0 * off);
    (off, turned)
}

/// Exhaustive.
#[test]
fn pixels_see_what_is_there() {
    for (off, turned) in [seen_errors(SMALL), seen_errors(LARGE)] {
        assert!((0.2e-3..=0.3e-3).contains(&off), "a point is off by {off} m");
        assert!((3.5e-4..=5e-4).contains(&turned), "a normal is off by {turned}");
    }
}

/// Shadows are where they should be, but for a few pixels at their outline.
#[test]
fn shadows_fall_where_they_should() {
    let (mut outline, mut count) = (0, 0);
    for (_, material, site) in seen() {
        let start = metres(site.point);
        let way = wide(LIGHT) - start;
        let before_light = |after: f64| after < 1.0;
        let by_ball = material != Material::Ball && into_ball(start, way).is_some_and(before_light);
        let by_column = material != Material::Column && entry_below_top(start, way).is_some_and(before_light);
        count += usize::from(by_ball || by_column);
        outline += usize::from(is_in_shadow(&site, material) != (by_ball || by_column));
    }
    println!("{outline} of {count} pixels in shadow");
    assert!(count > 1000, "{count} pixels are in shadow");
    assert!((1..=15).contains(&outline), "{outline} pixels of {count}");
}

/// Parameter at which a rising line enters the column.
fn entry_below_top(start: DVec3, way: DVec3) -> Option<f64> {
    let middle = wide([COLUMN[0], 0.0, COLUMN[1]]);
    let side = entry(start, way, middle, COLUMN_RADIUS.into(), DVec3::new(1.0, 0.0, 1.0))?;
    ((start + side * way).y < f64::from(COLUMN_HEIGHT)).then_some(side)
}

/// A linear value between the codes of a channel, in steps: as in the dither, the place between two
/// codes is that in linear light.
fn step(linear: f64, last: u16) -> f64 {
    let light = |code: f64| oracle::srgb_linear(code / f64::from(last) * 255.0);
    let linear = linear.min(1.0);
    let code = (1..last).map(f64::from).take_while(|&code| light(code) <= linear).last().unwrap_or(0.0);
    code + (linear - light(code)) / (light(code + 1.0) - light(code))
}

/// Linear light in steps of the three channels of RGB565, without rounding.
fn steps(linear: DVec3) -> [f64; 3] {
    [step(linear.x, 31), step(linear.y, 63), step(linear.z, 31)]
}

/// The steps that a cell of the dither shows on average.
fn shown(material: Material, light: Light16) -> [f64; 3] {
    let cell = (0..64).map(|place| RAMPS[material as usize].pixel::<Fx16>(light, place % 8, place / 8).0);
    let codes = cell.map(|pixel| [pixel >> 11, pixel >> 5 & 63, pixel & 31].map(f64::from));
    codes.fold([0.0; 3], |sum, codes| array::from_fn(|channel| sum[channel] + codes[channel] / 64.0))
}

/// The exact colour at the end of a line of sight, in steps of the three channels of RGB565.
fn exact_steps(light: &SpotLight, sight: DVec3) -> [f64; 3] {
    let (material, depth, normal) = exact(sight);
    let point = wide(EYE) + depth * sight;
    let (way, before_light) = (wide(LIGHT) - point, |after: f64| after < 1.0);
    let in_shadow = (material != Material::Ball && into_ball(point, way).is_some_and(before_light))
        || (material != Material::Column && entry_below_top(point, way).is_some_and(before_light));
    let irradiance = if in_shadow { 0.0 } else { light.irradiance(point, normal) };
    let tile = (2.0 * point).floor();
    let material = match material {
        Material::LightTile if (tile.x + tile.z) % 2.0 != 0.0 => Material::DarkTile,
        other => other,
    };
    let reflected = (wide(AMBIENT) + irradiance * wide(COLOR)) * wide(MATERIALS[material as usize]);
    steps(reflected)
}

/// Returns the largest error of what a picture shows on average, in steps of RGB565, and the number of
/// pixels at the outlines of shadows and tiles, which see something else than in f64.
fn error<const WIDTH: usize>(view: View<WIDTH>, frame: u32) -> (f64, u32) {
    let cone = Cone::from_field(Soft, Angle::degrees(FIELD)).expect("the cone of the scene");
    let cone = oracle::Cone::new(oracle::soft, cone.outer_versine().into());
    let axis = if frame == 0 { wide(AXIS) } else { metres(path::target(frame)) - wide(LIGHT) };
    let light = SpotLight { intensity: INTENSITY.into(), ..SpotLight::new(wide(LIGHT), axis, cone) };
    let mut stage = Stage::<WIDTH>::default();
    stage.turn_to(frame);
    let (mut largest, mut outline) = (0.0_f64, 0);
    for row in view.0 {
        stage.draw::<()>(row, &mut [0; WIDTH]);
        let lights = stage.seen.lights(&stage.lights);
        for (column, &arrived) in lights.iter().enumerate() {
            let exact = exact_steps(&light, View::<WIDTH>::sight(column, row));
            let differences = shown(stage.seen.material(column), arrived).into_iter().zip(exact);
            let error = differences.map(|(found, exact)| (found - exact).abs()).fold(0.0, f64::max);
            if error > 1.0 { outline += 1 } else { largest = largest.max(error) }
        }
    }
    (largest, outline)
}

/// In both pictures, and while the light moves.
#[test]
fn light_keeps_its_stated_error() {
    let small = [0, 1, 8, 16, 24, 32, 48, 63].map(|frame| (error(SMALL, frame), 60));
    for ((largest, outline), most) in small.into_iter().chain([(error(LARGE, 0), 120)]) {
        println!("{largest:.3} steps of RGB565, {outline} pixels at outlines");
        assert!((0.1..=0.19).contains(&largest), "{largest} steps");
        assert!((1..=most).contains(&outline), "{outline} pixels");
    }
}
