//! Runs `luminaire-prices`: errors, and times on this machine and in a browser. Times frames of the demo.

use std::env::consts::EXE_SUFFIX;
use std::process::Command;
use std::{env, fs};

use anyhow::{Context, Result, ensure};
use luminaire::dynamic::Effect;
use serde_json::Value;

use crate::ladder;
use crate::record::{Group, Record};
use crate::target::Target;
use tools::browser::{Found, Visit};
use tools::demo::site::{self, Build};
use tools::progress::Progress;
use tools::server::Server;
use tools::turntable::{self, Frame, LOADS};
use tools::{command, project, toolchain, wasm};

/// Outer half angles in degrees at which errors are measured beside the standard cone, because there the
/// cosine form and the versine form differ.
pub(crate) const NARROWER: [&str; 3] = ["15", "5", "1"];

/// How often each kernel is timed. The rounds are some time apart, so that other work of the
/// machine seldom disturbs all of them.
const ROUNDS: usize = 3;

/// The kernel whose bits depend on the platform, and whose errors are not compared.
const PLATFORMS_OWN: &str = "powf-std.rival";

/// The page that loads the module, and shows nothing.
const PAGE: &str = r#"<!doctype html>
<meta charset="utf-8">
<title>Prices</title>
<link rel="icon" href="data:,">
<body data-state="loading">
<script type="module">
import init, { time } from "./pkg/luminaire_prices.js";
await init();
window.time = time;
document.body.dataset.state = "ready";
</script>
"#;

/// Times every kernel once. Between two kernels the page does other work.
const ROUND: &str = "(async () => {
    const times = [];
    for (let lines; (lines = time(times.length)); ) {
        times.push(lines);
        await new Promise((resolve) => setTimeout(resolve));
    }
    return times.join('');
})()";

/// The errors of every kernel, in each cone, and those of lit points in steps of displays.
pub(crate) fn errors(progress: &Progress) -> Result<Record> {
    let mut record = Record::default();
    let mut add = |name: String, words: &[&str]| -> Result<()> {
        let mut group = Group::default();
        group.add_lines(&run(words, progress)?)?;
        group.figures.shift_remove(PLATFORMS_OWN);
        record.0.insert(name, group);
        Ok(())
    };
    add("errors".to_owned(), &["errors"])?;
    for degrees in NARROWER {
        add(format!("errors at {degrees}"), &["errors", degrees])?;
    }
    for degrees in ladder::ANGLES {
        record.0.insert(format!("steps at {degrees}"), ladder::at(degrees)?);
    }
    Ok(record)
}

/// Times every kernel on this machine.
pub(crate) fn host(progress: &Progress) -> Result<Record> {
    let rounds = (0..ROUNDS).map(|_| run(&["time"], progress)).collect::<Result<Vec<_>>>()?;
    let best = best(rounds.iter().map(String::as_str))?;
    let flags = env::var("RUSTFLAGS").unwrap_or_default();
    let about = [
        ("compiler", toolchain::active_compiler()?),
        ("flags", format!("opt-level=3 {flags}").trim_end().to_owned()),
        ("runs_on", format!("{} on {}", processor(), env::consts::OS)),
    ];
    Ok(Record([("host".to_owned(), times(&about, best))].into()))
}

/// Times every kernel in a browser, and frames of the demo. It is an error if the results are not the
/// host's.
pub(crate) fn browser(simd: bool, progress: &Progress) -> Result<Record> {
    let package = if simd { wasm::SIMD_PRICES } else { wasm::PRICES };
    let module = package.compile(wasm::PUBLISHED, progress)?;
    let site = tempfile::Builder::new().prefix("prices-").tempdir_in(project::target())?;
    fs::write(site.path().join("index.html"), PAGE)?;
    package.bind(&module, &site.path().join("pkg"), progress)?;
    let server = Server::start(site.path())?;
    let found = visit(&server.address(), &vec![ROUND.to_owned(); ROUNDS], progress)?;
    let best = best(found.values.iter().map(|round| round.as_str().unwrap_or_default()))?;
    let mut host = Group::default();
    host.add_lines(&run(&["time"], progress)?)?;
    compare(&best, &host)?;
    let about = [
        ("compiler", wasm::compiler(progress)?),
        ("flags", format!("opt-level=3 lto=fat {}", package.flags()).trim_end().to_owned()),
        ("runs_on", format!("{}, {}", found.version, processor())),
    ];
    let name = Target::Browser { simd }.name();
    let mut record = Record([(name.to_owned(), times(&about, best))].into());
    if simd {
        record.0.insert("demo".to_owned(), frames(progress)?);
    }
    Ok(record)
}

fn visit(address: &str, expressions: &[String], progress: &Progress) -> Result<Found> {
    let visit = Visit { address, ..Visit::default() };
    progress.timed("Timing", "in Chromium", || visit.run(expressions, progress))
}

/// The times of each kernel in the round where its median is smallest.
fn best<'a>(rounds: impl Iterator<Item = &'a str>) -> Result<Group> {
    let mut best = Group::default();
    for text in rounds {
        let mut round = Group::default();
        round.add_lines(text)?;
        for (name, times) in round.figures {
            let median = times.get("ns").and_then(Value::as_f64);
            if best.number(&name, "ns").is_none_or(|before| median.is_some_and(|now| now < before)) {
                best.figures.insert(name, times);
            }
        }
    }
    ensure!(!best.figures.is_empty(), "nothing was timed");
    Ok(best)
}

/// The times alone, with what they depend on.
fn times(about: &[(&str, String)], mut best: Group) -> Group {
    best.figures.values_mut().for_each(|figures| figures.retain(|unit, _| unit != "bits"));
    Group { figures: best.figures, ..Group::about(about) }
}

/// Fails if a kernel has other results in the browser than on the host.
fn compare(browser: &Group, host: &Group) -> Result<()> {
    ensure!(browser.figures.len() == host.figures.len(), "the browser has other kernels than the host");
    for (name, figures) in &browser.figures {
        let is_same = host.figures.get(name).is_some_and(|host| host.get("bits") == figures.get("bits"));
        ensure!(is_same || name == PLATFORMS_OWN, "{name} has not the bits of the host");
    }
    Ok(())
}

/// Builds and runs the program that measures.
fn run(words: &[&str], progress: &Progress) -> Result<String> {
    progress.run(command::cargo(["build", "--release", "--package", "luminaire-prices"]))?;
    let program = project::target().join("release").join(format!("luminaire-prices{EXE_SUFFIX}"));
    progress.timed("Measuring", words.join(" "), || command::answer(Command::new(program).args(words)))
}

/// The processor's name, or its architecture where the system does not state the name.
fn processor() -> String {
    let told = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = told.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or_else(|| env::consts::ARCH.to_owned(), |(_, name)| name.trim().to_owned())
}

/// Scenes that are timed with an effect and without it: arguments of the page's meter.
const TRIALS: [(Effect, &str, [&str; 2]); 5] = [
    (Effect::Specular, "turntable", ["{}", "{ without: ['specular'] }"]),
    (Effect::Gobo, "show", ["{}", "{ without: ['gobo'] }"]),
    (Effect::Shadow, "turntable", ["{ with: ['shadow'] }", "{}"]),
    (Effect::Haze, "turntable", ["{ with: ['haze'] }", "{}"]),
    (Effect::Dither, "turntable", ["{ with: ['dither'] }", "{}"]),
];

/// Each time is the median of `FRAMES` frames.
const FRAMES: u32 = 15;

/// Times a frame in `f32` with and without every effect that has a switch while the camera is at rest, and the
/// turntable under each load. The quickest of the rounds counts; both times with and without an effect
/// come from the same round, so that a slow machine affects both alike.
fn frames(progress: &Progress) -> Result<Group> {
    let server = Server::start(&site::build(Build::Small, progress)?)?;
    let mut acts = Vec::new();
    for _ in 0..ROUNDS {
        for (_, scene, options) in &TRIALS {
            acts.extend(options.map(|options| turntable::frame_call(&format!("'{scene}'"), FRAMES, options)));
        }
        acts.extend(LOADS.iter().map(|load| load.frame_call(FRAMES)));
    }
    let found = visit(&format!("{}#stage?play=none&format=f32", server.address()), &acts, progress)?;
    let mut group = Group::about(&[("runs_on", found.version)]);
    let per_round = 2 * TRIALS.len() + LOADS.len();
    let rounds: Vec<Vec<_>> =
        found.values.chunks(per_round).map(|round| round.iter().map(Frame::of).collect()).collect();
    for (number, (effect, scene, _)) in TRIALS.iter().enumerate() {
        group.add(effect.name(), "scene", *scene);
        let pairs = rounds.iter().map(|round| [round[2 * number].at_rest, round[2 * number + 1].at_rest]);
        add_quickest(&mut group, effect.name(), ["ms_with", "ms_without"], pairs)?;
    }
    for (number, load) in (2 * TRIALS.len()..).zip(&LOADS) {
        let pairs = rounds.iter().map(|round| [round[number].at_rest, round[number].moving]);
        add_quickest(&mut group, load.name, ["ms_at_rest", "ms_moving"], pairs)?;
    }
    Ok(group)
}

/// Adds the pair of times with the smallest sum, in hundredths of a millisecond.
fn add_quickest(
    group: &mut Group,
    name: &str,
    units: [&str; 2],
    pairs: impl Iterator<Item = [Option<f64>; 2]>,
) -> Result<()> {
    let pairs = pairs.filter_map(|[one, other]| Some([one?, other?]));
    let best = pairs.min_by(|one, other| one.iter().sum::<f64>().total_cmp(&other.iter().sum()));
    let best = best.with_context(|| format!("the page has no time of {name}"))?;
    units.iter().zip(best).for_each(|(unit, time)| group.add(name, unit, (time * 100.0).round() / 100.0));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_bits_in_the_browser_are_refused_but_for_the_platforms_own() {
        let group = |bits: &str| {
            let mut group = Group::default();
            group.add_lines(&format!("gltf.rival {bits} bits\npowf-std.rival {bits}0 bits\n")).unwrap();
            group
        };
        assert!(compare(&group("1a"), &group("1a")).is_ok());
        let error = compare(&group("1a"), &group("1b")).unwrap_err().to_string();
        assert!(error.contains("gltf.rival"), "{error}");
    }
}
