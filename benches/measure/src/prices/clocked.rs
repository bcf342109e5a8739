//! Runs the measurements of `luminaire-prices`: errors, and times on this machine and in a browser.

use std::env::consts::EXE_SUFFIX;
use std::process::Command;
use std::{env, fs};

use anyhow::{Context, Result, ensure};
use serde::Deserialize;
use serde::de::DeserializeOwned;

use super::ladder::Rung;
use super::list::{Cone, TargetMeta};
use super::target::Target;
use browser::{Act, Visit};
use tools::progress::Progress;
use tools::server::{self, Server};
use tools::wasm;
use tools::{command, project, toolchain};

/// The page that loads the module, and shows nothing.
const PAGE: &str = r#"<!doctype html>
<meta charset="utf-8">
<title>Prices</title>
<link rel="icon" href="data:,">
<body data-state="loading">
<script type="module">
import init, { count, time } from "./pkg/luminaire_prices.js";
await init();
window.prices = { count, time };
document.body.dataset.state = "ready";
</script>
"#;

/// How often each kernel is timed. The rounds are some time apart, so that other work of the
/// machine seldom disturbs all of them.
const ROUNDS: usize = 3;

/// Times every kernel once. Between two kernels the page does other work.
const ROUND: &str = "(async () => {
    const times = [];
    for (let number = 0; number < prices.count(); number += 1) {
        times.push(prices.time(number));
        await new Promise((resolve) => setTimeout(resolve));
    }
    return times;
})()";

/// A kernel by its name on the price list.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(super) struct Kernel {
    pub(super) kernel: String,
    pub(super) stage: String,
    pub(super) format: String,
}

/// The errors of a kernel in a cone.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(super) struct Measured {
    #[serde(flatten)]
    pub(super) kernel: Kernel,
    #[serde(flatten)]
    pub(super) cone: Cone,
}

/// A kernel's times: nanoseconds a call, by quartiles, and a checksum of its results.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(super) struct Times {
    #[serde(flatten)]
    pub(super) kernel: Kernel,
    pub(super) quartiles: [f64; 3],
    sum: u32,
}

impl Kernel {
    /// The name on the price list.
    pub(super) fn name(&self) -> String {
        format!("{}.{}", self.kernel, self.format)
    }
}

/// A line that `luminaire-prices` has printed.
fn read<T: DeserializeOwned>(line: &str) -> Result<T> {
    serde_json::from_str(line).with_context(|| format!("not a measurement: {line}"))
}

/// The errors of every kernel, in each cone.
pub(crate) fn accuracy(progress: &Progress) -> Result<Vec<Measured>> {
    run("accuracy", progress)?.lines().map(read).collect()
}

/// The errors of lit points by each evaluation.
pub(crate) fn ladder(progress: &Progress) -> Result<Vec<Rung>> {
    run("ladder", progress)?.lines().map(read).collect()
}

/// Times every kernel on this machine.
pub(crate) fn host(progress: &Progress) -> Result<(Vec<Times>, TargetMeta)> {
    let mut rounds = Vec::new();
    for _ in 0..ROUNDS {
        rounds.push(run("time", progress)?.lines().map(read).collect::<Result<_>>()?);
    }
    let flags = env::var("RUSTFLAGS").unwrap_or_default();
    let meta = TargetMeta {
        compiler: toolchain::active_compiler()?,
        flags: format!("opt-level=3 {flags}").trim_end().to_owned(),
        runs_on: format!("{} on {}", processor(), env::consts::OS),
        reference: Target::Host.reference().to_owned(),
        measured: String::new(),
    };
    Ok((best(rounds), meta))
}

/// Times every kernel in a browser. It is an error if the results are not the host's.
pub(crate) fn browser(simd: bool, host: &[Times], progress: &Progress) -> Result<(Vec<Times>, TargetMeta)> {
    let package = if simd { wasm::SIMD_PRICES } else { wasm::PRICES };
    let module = package.compile(progress)?;
    let site = tempfile::Builder::new()
        .prefix("prices-")
        .tempdir_in(project::target())
        .context("cannot make a folder for the page")?;
    fs::write(site.path().join("index.html"), PAGE)?;
    package.bind(&module, &site.path().join("pkg"), progress)?;
    let server = Server::start(server::listen(0)?, site.path())?;
    let step = progress.begin("Timing", "the kernels in Chromium");
    let round = Act::Ask(ROUND.to_owned());
    let found =
        Visit { address: &server.address(), ..Visit::default() }.run(&vec![round; ROUNDS], progress)?;
    let rounds = found.values.iter().map(|round| {
        let lines = round.as_array().context("no list of times")?.iter();
        lines.map(|line| read(line.as_str().context("a time is no text")?)).collect()
    });
    let times = best(rounds.collect::<Result<_>>()?);
    let meta = TargetMeta {
        compiler: wasm::compiler(progress)?,
        flags: format!("opt-level=3 lto=fat {}", package.flags().join(" ")).trim_end().to_owned(),
        runs_on: format!("{}, {}", found.version, processor()),
        reference: Target::Browser { simd }.reference().to_owned(),
        measured: String::new(),
    };
    step.done();
    compare(&times, host)?;
    Ok((times, meta))
}

/// The times of each kernel in the round where its median is smallest.
fn best(rounds: Vec<Vec<Times>>) -> Vec<Times> {
    let mut rounds = rounds.into_iter();
    let mut best = rounds.next().unwrap_or_default();
    for round in rounds {
        for (best, times) in best.iter_mut().zip(round) {
            if times.quartiles[1] < best.quartiles[1] {
                *best = times;
            }
        }
    }
    best
}

/// Whether the bits of this row depend on the platform.
pub(crate) fn is_platforms_own(name: &str) -> bool {
    name == "powf-std.rival"
}

fn compare(times: &[Times], host: &[Times]) -> Result<()> {
    ensure!(times.len() == host.len(), "{} kernels in the browser, {} on the host", times.len(), host.len());
    for (here, there) in times.iter().zip(host) {
        let name = here.kernel.name();
        ensure!(here.kernel == there.kernel, "{name} in place of {}", there.kernel.name());
        ensure!(here.sum == there.sum || is_platforms_own(&name), "{name} has not the bits of the host");
    }
    Ok(())
}

/// Builds and runs the program that measures.
fn run(what: &str, progress: &Progress) -> Result<String> {
    let mut build = command::cargo("build");
    build.args(["--release", "--package", "luminaire-prices"]);
    progress.run(build)?;
    let program = project::target().join("release").join(format!("luminaire-prices{EXE_SUFFIX}"));
    let step = progress.begin("Measuring", format_args!("the {what} of every kernel"));
    let answer = command::answer(Command::new(program).arg(what))?;
    step.done();
    Ok(answer)
}

/// The processor's name, or its architecture where the system does not state the name.
fn processor() -> String {
    let told = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = told.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or_else(|| env::consts::ARCH.to_owned(), |(_, name)| name.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn times(name: &str, sum: &str) -> Times {
        let kernel = format!(r#""kernel": "{name}", "stage": "falloff", "format": "rival""#);
        read(&format!(r#"{{ {kernel}, "quartiles": [1, 1, 1], "sum": {sum} }}"#)).unwrap()
    }

    #[test]
    fn an_error_is_read_or_a_refusal() {
        let kernel = r#""kernel": "hard", "stage": "falloff", "format": "fx16", "half_angle": 1.0"#;
        let refused: Measured = read(&format!(r#"{{ {kernel}, "error": null, "narrowest": 1.4 }}"#)).unwrap();
        assert_eq!((refused.kernel.name().as_str(), refused.cone.narrowest), ("hard.fx16", Some(1.4)));
        let error = r#""lsb": 1.0, "at": null, "mean_codes": 0.1, "p999_codes": 0.2, "kind": "searched""#;
        let line = |codes| format!(r#"{{ {kernel}, "error": {{ "codes": {codes}, {error} }} }}"#);
        assert_eq!(read::<Measured>(&line("0.5")).unwrap().cone.error.unwrap().codes, 0.5);
        assert!(read::<Measured>(&line("null")).is_err(), "an infinite error must not pass");
        assert!(read::<Times>(&line("0.5")).is_err());
    }

    #[test]
    fn the_best_round_of_each_kernel_counts() {
        let round = |medians: [f64; 2]| {
            medians.map(|median| Times { quartiles: [0.0, median, 9.0], ..times("gltf", "1") }).to_vec()
        };
        let best = best(vec![round([2.0, 1.0]), round([1.0, 3.0]), round([3.0, 2.0])]);
        assert_eq!([best[0].quartiles[1], best[1].quartiles[1]], [1.0, 1.0]);
    }

    #[test]
    fn other_bits_in_the_browser_are_named_but_for_the_platforms_own() {
        let host = [times("gltf", "1"), times("powf-std", "2")];
        assert!(compare(&[times("gltf", "1"), times("powf-std", "3")], &host).is_ok());
        let error = compare(&[times("gltf", "4"), times("powf-std", "2")], &host).unwrap_err().to_string();
        assert!(error.contains("gltf.rival"), "{error}");
        assert!(compare(&host[..1], &host).is_err());
    }
}
