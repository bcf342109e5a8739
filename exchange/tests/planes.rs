//! Photometric files with planes that differ: one light over the whole sphere, within its stated difference of the file at
//! 2,000 directions.

use fastrand::Rng;
use luminaire::light::Symmetry;
use luminaire::{MeasuredLight, Vec3, attenuation::AnyAttenuation, dynamic::AnyLight};
use luminaire_exchange::{Lamps, Reading, Refusal, read};

/// The intensity in a direction: a plane and an angle in degrees.
type Intensity = fn(f64, f64) -> f64;

/// A file of planes at 15 degrees and angles at 5.
struct File {
    name: &'static str,
    text: String,
    intensity: Intensity,
    /// The last angle with light.
    last: f64,
}

/// Two lobes to the sides of the plane C90, and light above the horizon: symmetric about no plane.
fn crooked(plane: f64, angle: f64) -> f64 {
    let (c, g) = (plane.to_radians(), angle.to_radians());
    let lobe = |plane: f64, angle: f64| {
        let (other, g0) = (plane.to_radians(), angle.to_radians());
        let cosine = g.cos() * g0.cos() + g.sin() * g0.sin() * (c - other).cos();
        (4.0 * (cosine - 1.0)).exp()
    };
    (900.0 * lobe(65.0, 60.0) + 500.0 * lobe(140.0, 50.0) + 80.0 * lobe(0.0, 150.0)).round()
}

/// A street light: symmetric about C90-C270.
fn street(plane: f64, angle: f64) -> f64 {
    crooked(plane, angle) + crooked(180.0 - plane, angle)
}

/// A wall washer along C0: symmetric about C0-C180.
fn washer(plane: f64, angle: f64) -> f64 {
    crooked(plane + 90.0, angle) + crooked(90.0 - plane, angle)
}

/// A linear luminaire: symmetric about both.
fn linear(plane: f64, angle: f64) -> f64 {
    street(plane, angle) + street(-plane, angle)
}

fn planes(from: u32, to: u32) -> Vec<f64> {
    (from..=to).step_by(15).map(f64::from).collect()
}

fn words(numbers: impl IntoIterator<Item = f64>) -> String {
    numbers.into_iter().map(|number| format!("{number}\n")).collect()
}

fn ies(name: &'static str, planes: &[f64], last: f64, intensity: Intensity) -> File {
    let angles: Vec<_> = (0..=(last / 5.0) as u32).map(|i| 5.0 * f64::from(i)).collect();
    let head = "IESNA:LM-63-2002\n[LUMCAT] light\nTILT=NONE\n";
    let counts = format!("1 -1 1 {} {} 1 2 0 0 0\n1 1 10\n", angles.len(), planes.len());
    let values = planes.iter().flat_map(|plane| angles.iter().map(|angle| intensity(*plane, *angle)));
    let text = format!("{head}{counts}{}{}{}", words(angles.clone()), words(planes.to_vec()), words(values));
    File { name, text, intensity, last }
}

/// A file with values of these planes, of 24.
fn ldt(name: &'static str, symmetry: u32, planes: &[f64], intensity: Intensity) -> File {
    let angles: Vec<_> = (0..37).map(|i| 5.0 * f64::from(i)).collect();
    let all = words((0..24).map(|i| 15.0 * f64::from(i)));
    let values = planes.iter().flat_map(|plane| angles.iter().map(|angle| intensity(*plane, *angle)));
    let head = format!("company\n1\n{symmetry}\n24\n15\n37\n5\nreport\nlight\nnumber\n");
    let between = "file\ndate\n0\n0\n0\n0\n0\n0\n0\n0\n0\n100\n100\n1\n0\n1\n-1\nLED\n1000\n\n80\n10\n";
    let text = format!("{head}{between}{}{all}{}{}", "0\n".repeat(10), words(angles.clone()), words(values));
    File { name, text, intensity, last: 180.0 }
}

fn files() -> Vec<(File, Symmetry, [f32; 3])> {
    let (right, ahead) = ([1.0, 0.0, 0.0], [0.0, 0.0, -1.0]);
    use Symmetry::{Bilateral, None, Quadrant};
    vec![
        (ies("whole.ies", &planes(0, 360), 180.0, crooked), None, right),
        (ies("open.ies", &planes(0, 345), 180.0, crooked), None, right),
        (ies("half.ies", &planes(0, 180), 180.0, washer), Bilateral, right),
        (ies("other.ies", &planes(90, 270), 180.0, street), Bilateral, ahead),
        (ies("quarter.ies", &planes(0, 90), 180.0, linear), Quadrant, right),
        // The fold is that of the intensities, not the one that the file states.
        (ies("stated.ies", &planes(0, 360), 180.0, street), Bilateral, ahead),
        (ies("folded.ies", &planes(0, 180), 180.0, linear), Quadrant, right),
        (ies("down.ies", &planes(0, 360), 90.0, crooked), None, right),
        (ldt("none.ldt", 0, &planes(0, 345), crooked), None, right),
        (ldt("about0.ldt", 2, &planes(0, 180), washer), Bilateral, right),
        (ldt("about90.ldt", 3, &planes(270, 450), street), Bilateral, ahead),
        (ldt("both.ldt", 4, &planes(0, 90), linear), Quadrant, right),
    ]
}

fn found(file: &File, size: Option<u32>) -> Result<Lamps, Refusal> {
    read(file.name, file.text.as_bytes(), None, Reading { size, ..Reading::default() })
}

fn light(lamps: &Lamps) -> MeasuredLight<'static, AnyAttenuation> {
    let [lamp] = &lamps.lamps[..] else { panic!("expected one light: {lamps:?}") };
    let AnyLight::Measured(light) = lamp.light else { panic!("expected a measured light: {lamp:?}") };
    light
}

/// The intensity of a file between its planes and angles.
fn between(file: &File, plane: f64, angle: f64) -> f64 {
    if angle > file.last {
        return 0.0;
    }
    let [i, j] = [(plane / 15.0).floor(), (angle / 5.0).floor()];
    let (u, v) = (plane / 15.0 - i, angle / 5.0 - j);
    let corner = |di: f64, dj: f64| {
        let angle = (5.0 * (j + dj)).min(file.last);
        (if di > 0.0 { u } else { 1.0 - u })
            * (if dj > 0.0 { v } else { 1.0 - v })
            * (file.intensity)(15.0 * (i + di), angle)
    };
    corner(0.0, 0.0) + corner(1.0, 0.0) + corner(0.0, 1.0) + corner(1.0, 1.0)
}

/// The largest difference of a light from its file at 2,000 directions, in codes.
fn difference(file: &File, light: &MeasuredLight<'_, AnyAttenuation>) -> f64 {
    let (mut rng, mut worst) = (Rng::with_seed(65), 0.0_f64);
    for _ in 0..2_000 {
        let (plane, cosine) = (360.0 * rng.f64(), 2.0 * rng.f64() - 1.0);
        let (sine, angle) = ((1.0 - cosine * cosine).sqrt(), cosine.acos().to_degrees());
        // C0 is along x, C90 along -z, and the angle 0 down.
        let (front, side) = plane.to_radians().sin_cos();
        let way = Vec3::new(sine * side, -cosine, -sine * front);
        let expected = between(file, plane, angle);
        let off = (light.exact_intensity(way) - expected).abs() / f64::from(light.intensity());
        worst = worst.max(255.0 * off);
    }
    worst
}

#[test]
fn files_of_all_symmetries_are_one_light_within_its_difference() {
    for (file, symmetry, side) in files() {
        let lamps = found(&file, None).expect(file.name);
        let (light, stated) = (light(&lamps), 255.0 * f64::from(lamps.lamps[0].difference.angle));
        assert_eq!(
            (light.distribution().symmetry(), light.distribution().size()),
            (symmetry, 65),
            "{}",
            file.name
        );
        assert_eq!(
            (light.frame()[0], light.frame()[2]),
            (side.into(), [0.0, -1.0, 0.0].into()),
            "{}",
            file.name
        );
        let off = difference(&file, &light);
        println!("{}: {off:.2} codes, stated {stated:.2}", file.name);
        // The light of a file that ends at the horizon jumps there.
        let most = if file.last < 180.0 { 255.0 } else { 3.0 * off };
        assert!(off <= stated && stated <= most, "{}: {off} of {stated}", file.name);
        let note = lamps.lamps[0].notes.last().expect("a note");
        assert!(note.contains("not round: a table of ") && note.contains(" samples over all"), "{note}");
    }
}

#[test]
fn sizes_bound_the_difference() {
    let file = ies("whole.ies", &planes(0, 360), 180.0, crooked);
    let stated = |size| f64::from(found(&file, size).expect("a light").lamps[0].difference.angle);
    let all = [9, 17, 33, 65].map(|size| stated(Some(size)));
    assert!(all.windows(2).all(|pair| pair[1] < 0.7 * pair[0]), "{all:?}");
    for size in [0, 2, 64, 258, 513] {
        let refusal = found(&file, Some(size)).expect_err("no size").to_string();
        assert_eq!(refusal, format!("size = {size}: expected a power of two and one, from 3 to 257"));
    }
    // The smallest that is within the fit of the file.
    let sized = |fit| {
        let lamps = read(file.name, file.text.as_bytes(), None, Reading { fit, ..Reading::default() });
        light(&lamps.expect("a light")).distribution().size()
    };
    assert_eq!([0.5, 40.0].map(sized), [65, 17]);
}

/// Planes that end elsewhere than at a symmetry are no whole sphere.
#[test]
fn parts_of_a_circle_are_refused() {
    let refusal = found(&ies("part.ies", &planes(0, 120), 180.0, crooked), None).expect_err("a part");
    assert_eq!(refusal.parameter, "symmetry");
}

/// Of a file that ends at the horizon nothing is above it but what the last row of cells holds.
#[test]
fn files_that_end_at_the_horizon_have_no_light_above() {
    let light = light(&found(&ies("down.ies", &planes(0, 360), 90.0, crooked), Some(129)).expect("a light"));
    for plane in 0..36 {
        let (z, x) = (10.0 * f64::from(plane)).to_radians().sin_cos();
        assert_eq!(light.exact_intensity(Vec3::new(x, 0.06, z)), 0.0);
        assert!(light.exact_intensity(Vec3::new(x, -0.03, z)) > 0.0);
    }
}

/// A file of type B (2) or A (3) at horizontal and vertical angles every 10 and 5 degrees from these on.
fn across(kind: u32, [from_side, from_front]: [i32; 2], intensity: Intensity) -> String {
    let horizontal: Vec<_> = (from_side..=90).step_by(10).map(f64::from).collect();
    let vertical: Vec<_> = (from_front..=90).step_by(5).map(f64::from).collect();
    let values = horizontal.iter().flat_map(|h| vertical.iter().map(|v| intensity(*h, *v)));
    let counts = format!("1 -1 1 {} {} {kind} 2 0 0 0\n1 1 10\n", vertical.len(), horizontal.len());
    let head = format!("IESNA:LM-63-2002\n[LUMCAT] light\nTILT=NONE\n{counts}");
    format!("{head}{}{}{}", words(vertical.clone()), words(horizontal.clone()), words(values))
}

/// A floodlight that is aimed up and to the right.
fn flood(horizontal: f64, vertical: f64) -> f64 {
    let share = (horizontal - 20.0).powi(2) / 1_800.0 + (vertical - 10.0).powi(2) / 600.0;
    // At the poles, where all planes meet, is no light.
    (1_000.0 * (-share).exp() * horizontal.to_radians().cos() * vertical.to_radians().cos()).round()
}

fn both_sides(horizontal: f64, vertical: f64) -> f64 {
    flood(horizontal, vertical) + flood(-horizontal, vertical)
}

fn all_sides(horizontal: f64, vertical: f64) -> f64 {
    both_sides(horizontal, vertical) + both_sides(horizontal, -vertical)
}

/// The horizontal and the vertical angle of a direction to the right, up and ahead: about the horizontal pole of type B,
/// or the vertical one of type A.
fn angles(kind: u32, [right, up, ahead]: [f64; 3]) -> [f64; 2] {
    let angles = if kind == 2 {
        [right.atan2(up.hypot(ahead)), up.atan2(ahead)]
    } else {
        [right.atan2(ahead), up.atan2(right.hypot(ahead))]
    };
    angles.map(f64::to_degrees)
}

/// Floodlights and headlamps: right of the light is x, up is -z and ahead is down, as it hangs.
#[test]
fn files_about_other_poles_are_one_light_within_its_difference() {
    use Symmetry::{Bilateral, None, Quadrant};
    for (kind, from, intensity, symmetry) in [
        (2, [-90, -90], flood as Intensity, None),
        (3, [-90, -90], flood, None),
        (2, [-90, -90], both_sides, Bilateral),
        (3, [0, -90], both_sides, Bilateral),
        (2, [0, 0], all_sides, Quadrant),
        // The file has nothing below 30 degrees.
        (2, [-90, -30], flood, None),
    ] {
        let text = across(kind, from, intensity);
        let lamps = read("flood.ies", text.as_bytes(), Option::None, Reading::default()).expect("a light");
        let (light, stated) = (light(&lamps), 255.0 * f64::from(lamps.lamps[0].difference.angle));
        let side = if symmetry == Bilateral { [0.0, 0.0, -1.0] } else { [1.0, 0.0, 0.0] };
        assert_eq!((light.distribution().symmetry(), light.frame()[0]), (symmetry, side.into()), "{from:?}");
        let (mut rng, mut worst, mut peak) = (Rng::with_seed(63), 0.0_f64, 0.0_f64);
        for _ in 0..2_000 {
            let (about, ahead) = (std::f64::consts::TAU * rng.f64(), 2.0 * rng.f64() - 1.0);
            let (up, right) = about.sin_cos();
            let sine = (1.0 - ahead * ahead).sqrt();
            let [h, v] = angles(kind, [sine * right, sine * up, ahead]);
            let is_lit =
                h.abs() <= 90.0 && (-90.0..=90.0).contains(&v) && (from[1] == 0 || v >= f64::from(from[1]));
            let (i, j) = ((h / 10.0).floor(), (v / 5.0).floor());
            let (s, t) = (h / 10.0 - i, v / 5.0 - j);
            let corner = |di: f64, dj: f64| intensity(10.0 * (i + di), 5.0 * (j + dj));
            let near = corner(0.0, 0.0) * (1.0 - s) + corner(1.0, 0.0) * s;
            let far = corner(0.0, 1.0) * (1.0 - s) + corner(1.0, 1.0) * s;
            let expected = if is_lit { near * (1.0 - t) + far * t } else { 0.0 };
            let way = Vec3::new(sine * right, -ahead, -sine * up);
            worst = worst
                .max(255.0 * (light.exact_intensity(way) - expected).abs() / f64::from(light.intensity()));
            peak = peak.max(expected);
        }
        println!("type {kind} from {from:?}: {worst:.2} codes, stated {stated:.2}");
        let most = if from[1] == -30 { 255.0 } else { 3.0 * worst };
        assert!(worst <= stated && stated <= most, "{kind} {from:?}: {worst} of {stated}");
        assert!(peak > 0.8 * f64::from(light.intensity()), "{peak}");
    }
}

/// Intensities that are the same all about the axis are a round light, and others are by request.
#[test]
fn files_about_other_poles_may_be_round() {
    // The angle off the axis is that of both: cos = cos h cos v.
    let round: Intensity = |h, v| (1e3 * (h.to_radians().cos() * v.to_radians().cos()).powi(4)).round();
    for kind in [2, 3] {
        let fine = across(kind, [-90, -90], round);
        let reading = Reading { fit: 8.0, ..Reading::default() };
        let lamps = read("round.ies", fine.as_bytes(), None, reading).expect("a light");
        assert!(matches!(lamps.lamps[0].light, AnyLight::Spot(_)), "type {kind}");
        let text = across(kind, [-90, -90], flood);
        let reading = Reading { is_round: true, ..Reading::default() };
        let lamps = read("flood.ies", text.as_bytes(), None, reading).expect("a light");
        assert!(matches!(lamps.lamps[0].light, AnyLight::Spot(_)), "type {kind}");
        let note = "The light is taken as round: the direction ";
        assert!(lamps.notes.iter().any(|own| own.starts_with(note)), "{:?}", lamps.notes);
    }
    for (from, name) in
        [([10, -90], "horizontal angles"), ([-90, 10], "vertical angles"), ([90, 0], "horizontal angles")]
    {
        let refusal = read("part.ies", across(2, from, flood).as_bytes(), None, Reading::default())
            .expect_err("a part");
        assert_eq!(refusal.parameter, name);
    }
}
