//! Every price and every error in the README, the crates' documentation, the guide and the head of the
//! demo's page is one on record, or one that a test asserts.

use std::collections::{BTreeMap, HashSet};
use std::fs;
use std::path::{Path, PathBuf};

use luminaire::{Angle, Cone, Fx16, Fx32, HalfAngle, SpotLight, falloff::Soft};
use serde_json::Value;

const README: &str = "README.md";
const FRONT: &str = "core/src/lib.rs";
const GUIDE: &str = "core/guide";
/// The crates whose documentation is read.
const CRATES: [&str; 7] = ["cli", "core", "exchange", "export", "native", "render", "wasm-demo"];
const PAGE: &str = "wasm-demo/web/index.html";

/// A paragraph or a row of a table with one of these words has prices or errors.
const UNITS: [&str; 8] =
    ["instructions", "instr.", "linear code", "cycles", " kB", " ms", " ns", "/255 of full scale"];
/// In the crates' documentation these, too, stand beside figures.
const ERRORS: [&str; 5] = ["error", "errs", "differ", " bytes", " steps"];

fn text(path: impl AsRef<Path>) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The bounds of the light of the front page in each evaluation, rounded up.
fn derived(outer: HalfAngle) -> String {
    let cone = Cone::from_outer(Soft, outer).expect("a sound cone");
    let spot = SpotLight::new([0.0; 3], [0.0, -1.0, 0.0], cone).and_then(|spot| spot.with_intensity(16.0));
    let spot = spot.expect("a sound light");
    let bounds = [
        spot.error_bound::<f32>(1.0..=7.0),
        spot.error_bound::<Fx32>(1.0..=7.0),
        spot.error_bound::<Fx16>(1.0..=7.0),
        spot.quick_error_bound::<Fx16>(1.0..=7.0),
    ];
    bounds.map(|bound| rounded_up(bound.expect("held").codes().into())).join(" | ")
}

/// A number with two digits, rounded up.
fn rounded_up(value: f64) -> String {
    let unit = 10_f64.powf(value.log10().floor() - 1.0);
    let value = (value / unit - 1e-6).ceil() * unit;
    if value < 1e-3 {
        format!("{value:.1e}")
    } else {
        format!("{value:.*}", (-unit.log10()).round().max(0.0) as usize)
    }
}

/// A bound of an operation in a format, as it stands in `tests/bounds.csv`.
fn bound(operation: &str, format: &str) -> String {
    let bounds = text("tests/bounds.csv");
    let row = format!("operation,{operation},{format},");
    let found = bounds.lines().find_map(|line| line.strip_prefix(&row));
    found.unwrap_or_else(|| panic!("tests/bounds.csv has no row {row}")).to_owned()
}

/// Instructions of a lit point in C on a Cortex-M0 by the software floats of Arm: measured once, elsewhere.
const ARMS_FLOATS: f64 = 1_733.0;

/// The record behind the figures.
struct Records(Value);

impl Records {
    fn read() -> Self {
        Self(serde_json::from_str(&text("docs/prices.json")).expect("JSON"))
    }

    /// The figures of a name in a group, such as `soft.fx16` on the target `host`.
    fn figures(&self, group: &str, name: &str) -> &Value {
        &self.0[group]["figures"][name]
    }

    /// The cost of a kernel in a format on a target.
    fn cost(&self, name: &str, target: &str) -> String {
        let found = self.figures(target, name);
        cost(found["instructions"].as_f64().unwrap_or_else(|| number(&found["ns"])))
    }

    /// Its largest error, at a half angle of 22 degrees.
    fn error(&self, name: &str) -> String {
        error(number(&self.figures("errors", name)["codes"]))
    }

    /// The same in every recorded cone.
    fn errors(&self, name: &str) -> Vec<f64> {
        let cones = ["errors", "errors at 15", "errors at 5", "errors at 1"];
        cones.iter().map(|cone| number(&self.figures(cone, name)["codes"])).collect()
    }

    /// A figure of an effect in `Fx16` on a Cortex-M0, and by how much it exceeds the soft spotlight's.
    fn effect(&self, name: &str, unit: &str) -> [f64; 2] {
        let [all, base] =
            [name, "lit"].map(|name| number(&self.figures("cortex-m0", &format!("{name}.fx16"))[unit]));
        [all, all - base]
    }

    /// The figures in their words. A blank line, a point of a list and a row of a table begin a
    /// paragraph; words are those of one paragraph.
    fn in_readme(&self) -> Vec<String> {
        let mut stated = Vec::new();
        let mut say = |words| stated.push(words);
        let times =
            ARMS_FLOATS / number(&self.figures("cortex-m0", "lit-inverse-square.fx16")["instructions"]);
        say(format!("a lit point in C takes {} instructions: {times:.1} times", thousands(ARMS_FLOATS)));
        // `cargo xtask full --only package` compares these two.
        say("**4.0 kB of flash**".to_owned());
        say("2.4 kB by the quick evaluation".to_owned());
        for (name, title) in [
            ("lit-inverse-square.fx16", "`Fx16`"),
            ("lit-inverse-square.fx16-quick", "`Fx16`, quick"),
            ("lit-inverse-square.f32", "`f32`"),
            ("lit-q15-difference.rival", "15 bits by hand"),
            ("lit-q16-libfixmath.rival", "Q16.16, libfixmath"),
            ("lit-f32-difference.rival", "`f32` by hand"),
            ("lit-baked.rival", "baked on a floor"),
        ] {
            let [widest, .., narrowest] = self.errors(name)[..] else { panic!("{name}: expected two cones") };
            let costs = ["cortex-m0", "cortex-m4f", "cortex-m33", "rv32imc", "host"]
                .map(|target| self.cost(name, target));
            let (errors, costs) = ([widest, narrowest].map(error).join(" | "), costs.join(" | "));
            say(format!("| {title} | {errors} | {} |", costs.replace(',', "")));
        }
        stated
    }

    fn on_page(&self) -> String {
        let name = "lit-inverse-square.fx16";
        let (errors, cost) = (self.figures("errors", name), self.cost(name, "cortex-m0"));
        let cone = (2.0 * number(&self.figures("errors", "cone")["half_angle"])).round();
        // Rounded as in the documents, but for an upper bound, which is rounded up.
        let hundredths = 100.0 * number(&errors["codes"]);
        let (bound, hundredths) = match errors["kind"].as_str() {
            Some("searched") => ("the largest error found is", hundredths.round()),
            _ => ("the error is at most", hundredths.ceil()),
        };
        let error = hundredths / 100.0;
        format!("{cost} instructions on a Cortex-M0; {bound} {error}/255 of full scale ({cone}&deg; cone).")
    }

    fn on_front_page(&self) -> Vec<String> {
        let mut stated = Vec::new();
        let mut say = |words| stated.push(words);
        let formats = |figure: &dyn Fn(&str) -> String| {
            let all = ["f32", "fx32", "fx16", "fx16-quick"];
            all.map(|format| figure(&format!("lit-inverse-square.{format}"))).join(" | ")
        };
        let outer = HalfAngle::degrees(number(&self.figures("errors", "cone")["half_angle"]) as f32);
        let field = Cone::from_outer(Soft, outer).expect("a cone").field().to_degrees().round();
        let errors = formats(&|name| self.error(name));
        let title = format!("largest error of a lit point of a soft spotlight of {field} degrees");
        say(format!("| {title}, linear codes (searched) | {errors} |"));
        say(format!("| a bound of that error, linear codes (derived) | {} |", derived(outer)));
        for (target, title) in [
            ("cortex-m0", "instructions of a lit point, Cortex-M0 (counted)"),
            ("cortex-m4f", "instructions, Cortex-M4F"),
            ("rv32imc", "instructions, RV32IMC"),
            ("cortex-m33", "instructions, Cortex-M33 (RP2350)"),
            ("hazard3", "instructions, Hazard3 (RP2350)"),
        ] {
            say(format!("| {title} | {} |", formats(&|name| self.cost(name, target))));
        }
        let single = half_angle(Cone::narrowest::<f32>(Soft));
        let wide = half_angle(Cone::narrowest::<Fx32>(Soft));
        let short = half_angle(Cone::narrowest::<Fx16>(Soft));
        let narrowest = format!("{single:.4} | {wide:.5} | {short:.2} | {short:.2}");
        say(format!("(half of [`Cone::narrowest`]) | {narrowest} |"));
        stated
    }

    /// The chapters, and the words in each.
    fn in_guide(&self) -> Vec<(&'static str, String)> {
        let mut stated = Vec::new();
        let mut say = |chapter, words| stated.push((chapter, words));
        for (chapter, program) in FIVE_TIMES {
            say(chapter, "five times the instructions of a lit point on a Cortex-M0".to_owned());
            let times = [program, "lit"].map(|program| self.effect(program, "instructions")[0]);
            let times = times[0] / times[1];
            assert!((4.5..5.5).contains(&times), "{chapter}: expected five times, found {times}");
        }
        for (chapter, program, is_added, words) in COUNTED {
            let count = self.effect(program, "instructions")[usize::from(is_added)];
            say(chapter, words.replace("{}", &thousands(count)));
        }
        let kilobytes = self.effect("lit-compiled", "flash")[1] / 1_000.0;
        say("core/guide/microcontroller.md", format!(" and {kilobytes:.0} kB of flash"));
        for (format, words) in LIT {
            let count = self.cost(&format!("lit-inverse-square.{format}"), "cortex-m4f");
            say("core/guide/not_for.md", words.replace("{}", &count));
        }
        stated
    }
}

/// Errors of the stages of a format, by their row of `tests/bounds.csv`. `{}` is the bound.
const STAGES: [(&str, &str, &str, &str); 18] = [
    ("core/src/number/float.rs", "f32", "ray direction of the stated", "| {} times 1.12e-7 radians, offset"),
    ("core/src/number/float.rs", "f32", "ray direction its length", "its length {} |"),
    ("core/src/number/float.rs", "f32", "ray versine of the outer", "| {} of the outer versine |"),
    ("core/src/number/float.rs", "f32", "ray cosine", "| cosine {} steps |"),
    ("core/src/number/float.rs", "f32", "ray light relative", "| {}, relative |"),
    ("core/src/number/fx16.rs", "fx16", "ray direction of the stated", "| {} times 1.55e-5 radians;"),
    ("core/src/number/fx16.rs", "fx16", "ray direction its length", "its length {} |"),
    ("core/src/number/fx16.rs", "fx16", "ray versine of the outer", "| {} of the outer versine |"),
    ("core/src/number/fx16.rs", "fx16", "ray cosine", "| {} steps of 2^-14 |"),
    ("core/src/number/fx16.rs", "fx16", "times", "cosine times falloff, 14 | {} steps |"),
    ("core/src/number/fx16.rs", "fx16", "gain times relative", "| {}, relative, for a product |"),
    ("core/src/number/fx16.rs", "fx16", "ray light relative", "over `\\|v\\|^2`, 14 | {}, relative |"),
    ("core/src/number/fx32.rs", "fx32", "ray direction of the stated", "| {} times 2.68e-9 radians;"),
    ("core/src/number/fx32.rs", "fx32", "ray direction its length", "its length {} |"),
    ("core/src/number/fx32.rs", "fx32", "ray versine of the outer", "| {} of the outer versine |"),
    ("core/src/number/fx32.rs", "fx32", "ray cosine", "| {} steps of 2^-30 |"),
    ("core/src/number/fx32.rs", "fx32", "gain times relative", "| {}, relative, for a product |"),
    ("core/src/number/fx32.rs", "fx32", "ray light relative", "over `\\|W\\|^2`, 30 | {}, relative |"),
];

/// What was set and not measured, in paragraphs with figures.
const SETTINGS: [(&str, &str); 8] = [
    (README, "from 16 times full scale at a distance of 1."),
    (FRONT, "at distances from 1 to 7 from a light of intensity 16"),
    (FRONT, "at incidences up to 80 degrees"),
    (FRONT, "clipped at 1."),
    ("core/guide/format.md", "at 72,000 points"),
    ("core/guide/format.md", "too narrow for 16 bits"),
    ("core/guide/porting.md", "at 72,000 points"),
    ("core/guide/porting/direct3d.md", "of 1 is [`Linear`](crate::falloff::Linear), of 2"),
];

/// Instructions on a Cortex-M0 of an effect, or by how much they exceed the
/// soft spotlight's. `{}` is the figure.
const COUNTED: [(&str, &str, bool, &str); 12] = [
    ("core/guide/falloff.md", "lit", false, "takes {} instructions with the soft edge"),
    ("core/guide/falloff.md", "lit-smooth", true, "smoothstep takes {} more"),
    ("core/guide/falloff.md", "lit-table", true, "a table {},"),
    ("core/guide/falloff.md", "lit-cubic", true, "a cubic {}."),
    ("core/guide/falloff.md", "lit-real-power", true, "real exponent takes {} more"),
    ("core/guide/microcontroller.md", "lit-compiled", true, "{} instructions on a Cortex-M0"),
    ("core/guide/microcontroller.md", "rgb565-ramp", false, "dithered pixel in {} instructions"),
    ("core/guide/moving.md", "lit-placed", true, "| `moved_to` | {} |"),
    ("core/guide/moving.md", "lit-aimed", true, "| `moved_to` and `aimed_at` | {} |"),
    ("core/guide/moving.md", "lit-zoomed", true, "| `zoomed` | {} |"),
    ("core/guide/moving.md", "lit-compiled", true, "| compile again | {} |"),
    ("core/guide/scanline.md", "lit-normalized", true, "for {} instructions on a Cortex-M0"),
];

/// Falloffs whose instructions on a Cortex-M0 a chapter compares with the soft one's.
const FIVE_TIMES: [(&str, &str); 2] = [
    ("core/guide/porting/direct3d.md", "lit-real-power"),
    ("core/guide/porting/godot.md", "lit-inverted-real-power"),
];

/// Formats of a lit point on a Cortex-M4F.
const LIT: [(&str, &str); 2] =
    [("f32", "a lit point takes {} instructions in `f32`"), ("fx16", "and {} in `Fx16`")];

fn half_angle(angle: Angle) -> f64 {
    f64::from(angle.to_degrees()) / 2.0
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("expected a figure on record, found {value}"))
}

/// An error with two significant digits, or as an integer from 10 on.
fn error(value: f64) -> String {
    match value {
        9.95.. => format!("{value:.0}"),
        0.995.. => format!("{value:.1}"),
        0.0995.. => format!("{value:.2}"),
        0.009_95.. => format!("{value:.3}"),
        _ => format!("{value:.1e}"),
    }
}

/// A cost with three significant digits, or as an integer from 100 on.
fn cost(value: f64) -> String {
    match value {
        99.95.. => thousands(value),
        9.995.. => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}

/// An integer with a comma between thousands.
fn thousands(value: f64) -> String {
    match value.round() as u32 {
        value @ 0..1_000 => value.to_string(),
        value => format!("{},{:03}", value / 1_000, value % 1_000),
    }
}

/// The texts by file: Markdown, without blocks of code.
fn texts() -> Vec<(String, String)> {
    let mut texts = vec![(README.to_owned(), text(README))];
    let front = text(FRONT);
    let front = front.lines().map_while(|line| line.strip_prefix("//!"));
    texts.push((FRONT.to_owned(), front.map(str::trim_start).collect::<Vec<_>>().join("\n")));
    let page = text(PAGE);
    let (_, head) = page.split_once("<header").expect("a head");
    let (head, _) = head.split_once("</header>").expect("its end");
    texts.push((PAGE.to_owned(), head.to_owned()));
    texts.extend(below(GUIDE, "md"));
    texts.into_iter().map(|(file, text)| (file, outside_of_code(&text))).collect()
}

/// The files of a folder and its folders that have this extension, with their texts.
fn below(folder: &str, extension: &str) -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let (mut files, mut folders) = (Vec::new(), vec![PathBuf::from(folder)]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(root.join(&folder)).expect("a folder") {
            let path = folder.join(entry.expect("a file").file_name());
            if root.join(&path).is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|found| found == extension) {
                files.push((path.display().to_string(), text(&path)));
            }
        }
    }
    files
}

fn outside_of_code(text: &str) -> String {
    text.split("```").step_by(2).collect()
}

/// The documentation in a source file, and its code.
fn parted(source: &str) -> (String, String) {
    let (mut documentation, mut code) = (String::new(), String::new());
    for line in source.lines().map(str::trim_start) {
        if let Some(text) = line.strip_prefix("//!").or_else(|| line.strip_prefix("///")) {
            documentation += text.trim_start();
        } else {
            code += line.split("//").next().unwrap_or_default();
        }
        documentation.push('\n');
        code.push('\n');
    }
    (outside_of_code(&documentation), code)
}

/// The values of the numbers in code and in tables of numbers.
fn literals(code: &str) -> impl Iterator<Item = u64> {
    let words = code.split(|c: char| !(c.is_ascii_alphanumeric() || "_.-".contains(c)));
    let ends = words.flat_map(|word| word.split("..")).flat_map(|word| match word.contains("e-") {
        true => vec![word],
        false => word.split('-').collect(),
    });
    let numbers = ends.map(|word| word.trim_end_matches(['.', '_']).replace('_', ""));
    numbers.filter_map(|number| number.parse::<f64>().ok()).map(f64::to_bits)
}

/// The paragraphs, points of lists and rows of tables, each on one line.
fn paragraphs(text: &str) -> Vec<String> {
    let mut paragraphs = vec![String::new()];
    for line in text.lines().map(str::trim) {
        if line.is_empty() || line.starts_with("- ") || line.starts_with('|') {
            paragraphs.push(String::new());
        }
        let last = paragraphs.last_mut().expect("a paragraph");
        *last += line;
        *last += " ";
    }
    paragraphs
}

/// The numbers among the words of a paragraph, without those in code.
fn numbers(paragraph: &str) -> Vec<&str> {
    let prose = paragraph.split('`').step_by(2).flat_map(str::split_whitespace);
    let bare = prose.map(|word| {
        word.trim_start_matches(['*', '(', '[']).trim_end_matches([',', '.', ':', ';', '*', ')'])
    });
    bare.filter(|word| word.starts_with(|c: char| c.is_ascii_digit()))
        .filter(|word| word.chars().all(|c| c.is_ascii_digit() || ".,e-".contains(c)))
        .collect()
}

#[test]
fn texts_have_the_figures_on_record_and_no_others() {
    let records = Records::read();
    let mut stated = records.in_guide();
    stated.extend(records.in_readme().into_iter().map(|words| (README, words)));
    stated.push((PAGE, records.on_page()));
    stated.extend(records.on_front_page().into_iter().map(|words| (FRONT, words)));
    stated.extend(SETTINGS.map(|(file, words)| (file, words.to_owned())));
    let (mut found, mut wrong) = (vec![false; stated.len()], Vec::new());
    for (file, text) in texts() {
        for paragraph in paragraphs(&text) {
            let mut rest = paragraph.clone();
            for ((_, words), found) in stated.iter().zip(&mut found).filter(|((of, _), _)| *of == file) {
                *found |= rest.contains(words);
                rest = rest.replace(words, " ");
            }
            if UNITS.iter().any(|unit| paragraph.contains(unit)) && !numbers(&rest).is_empty() {
                wrong.push(format!("{file}: {:?} not on record in `{paragraph}`", numbers(&rest)));
            }
        }
    }
    let missing = stated.iter().zip(found).filter(|(_, found)| !found);
    wrong.extend(missing.map(|((file, words), _)| format!("{file}: expected `{words}`")));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Every figure in a table or beside an error in the crates' documentation is a number of the code in its
/// folder, of a test or of `tests/bounds.csv`: it changes with what is asserted.
#[test]
fn documentation_has_the_figures_of_code_and_tests_and_no_others() {
    let folders = CRATES.map(|name| format!("{name}/src"));
    let sources: Vec<_> = folders.iter().flat_map(|folder| below(folder, "rs")).collect();
    let bounds = text("tests/bounds.csv");
    let is_one = |row: &&str| row.starts_with("operation,") || row.starts_with("set-up,");
    let mut asserted: HashSet<_> = bounds.lines().filter(is_one).flat_map(literals).collect();
    for (_, source) in below("tests", "rs").into_iter().chain(below("core/proofs", "rs")) {
        asserted.extend(literals(&parted(&source).1));
    }
    let mut computed = BTreeMap::<_, HashSet<_>>::new();
    for (file, source) in &sources {
        for folder in Path::new(file).ancestors().skip(1) {
            computed.entry(folder).or_default().extend(literals(&parted(source).1));
        }
    }
    let stages =
        STAGES.map(|(file, format, operation, words)| (file, words.replace("{}", &bound(operation, format))));
    let mut wrong: Vec<_> = Vec::new();
    for (file, words) in &stages {
        if !parted(&text(file)).0.contains(words) {
            wrong.push(format!("{file}: expected `{words}`"));
        }
    }
    for (file, source) in sources.iter().filter(|(file, _)| file != FRONT) {
        let computed = &computed[Path::new(file).parent().expect("a folder")];
        let mut heading = None;
        for paragraph in paragraphs(&parted(source).0) {
            // A table has figures if its first row says so.
            let subject = match paragraph.starts_with('|') {
                true => heading.get_or_insert_with(|| paragraph.clone()),
                false => {
                    heading = None;
                    &paragraph
                }
            };
            if UNITS.iter().chain(&ERRORS).any(|word| subject.contains(word)) {
                let value = |number: &str| number.replace(',', "").parse::<f64>().map(f64::to_bits);
                let mut found = numbers(&paragraph);
                found.retain(|number| number.len() != 4 || !number.starts_with(['1', '2'])); // years of the literature
                found.retain(|number| {
                    value(number).is_ok_and(|value| !asserted.contains(&value) && !computed.contains(&value))
                });
                if !found.is_empty() {
                    wrong.push(format!("{file}: {found:?} in no code or test, in `{paragraph}`"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The chapters on porting assert a range for each figure, and run with the documentation's tests.
#[test]
fn differences_of_the_porting_guide_are_within_the_ranges_that_its_chapters_assert() {
    let table = text("core/guide/porting.md");
    for (title, chapter) in [
        ("OpenGL", "opengl"),
        ("Direct3D", "direct3d"),
        ("glTF", "gltf"),
        ("three.js", "three"),
        ("Godot", "godot"),
        ("Bevy", "bevy"),
    ] {
        let (_, table) = table.split_once("# The comparison").expect("a table");
        let row = table.lines().find(|line| line.starts_with(&format!("| {title}"))).expect(title);
        let figures: Vec<f64> = row.split('|').filter_map(|cell| cell.trim().parse().ok()).collect();
        let chapter = text(format!("core/guide/porting/{chapter}.md"));
        assert_eq!(figures.len(), 2, "{row}");
        for (figure, name) in figures.iter().zip(["single", "short"]) {
            let (before, _) = chapter.split_once(&format!(").contains(&{name})")).expect(title);
            let (_, range) = before.rsplit_once("((").expect("a range");
            let (least, most) = range.split_once("..").expect("two ends");
            let [least, most] = [least, most].map(|end| end.parse::<f64>().expect("a number"));
            assert!((least..most).contains(figure), "{title}: expected {least} to {most}, found {figure}");
        }
    }
}
