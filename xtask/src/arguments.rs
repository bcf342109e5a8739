//! The command line.

use std::ffi::OsString;
use std::path::PathBuf;

use anyhow::{Result, bail, ensure};
use pico_args::Arguments;

use tools::demo::site;

/// What `--help` prints without building the laboratory. Each command has a line that two spaces indent.
pub(crate) const HELP: &str = "\
Usage: cargo xtask COMMAND [OPTIONS]

  demo          Build the browser demo into target/demo and serve it on 127.0.0.1; the same as
                `cargo demo`
    --port N            Serve on this port instead of 8080
    --view NAME         Open this view of the page: stage, compare, museum, class, chip or use;
                        settings may follow, as in compare?half=0.1 or stage?scene=grid
    --check             Instead of serving: run the page once in headless Chromium, print one line
                        and exit
    --screenshot FILE   Like --check, and write a PNG of the page at 1440x900 to this file
    --build DIR         Instead of serving: write the demo into this folder, for any static host
    --address URL       With --build: where the folder will be served, for link previews, as in
                        https://example.org/demo/
    --repository URL    With --build: where the source is, for links of the view `use`

The laboratory, built when it is first called; `cargo xtask COMMAND --help` has the options:
  test          Run the tests: format, lints, documentation, host, an emulated board, a browser
  full          Run the tests with the long sweeps, on all boards, in all browsers, with all feature
                sets, and from the packed crates
  prove         Prove the errors of the fixed-point stages, by Gappa and Coq, and C, by Frama-C
  fuzz          Search inputs that break a law of the kernel or a reader of files, by libFuzzer
  board         Build the firmware of a board with a display, or of a console: rp2040, gba
  conform       Compare the results of every model, bit by bit, with the conformance vectors
  measure       Measure errors, and costs on every target; compare them with the record, or write it
  pictures      Take the pictures of the demo for the documents again
  renderers     Draw the pictures of renderers that are not the project's
  rivals        Time frames of the demo and of three.js without a GPU, in one run
";

/// A command with its options.
#[derive(Debug, PartialEq)]
pub(crate) enum Request {
    Help,
    Demo(DemoOptions),
    /// A command of the laboratory, with its own options.
    Laboratory(Vec<OsString>),
}

/// The options of `demo`.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct DemoOptions {
    pub(crate) port: Option<u16>,
    pub(crate) view: Option<String>,
    pub(crate) check: bool,
    pub(crate) screenshot: Option<PathBuf>,
    pub(crate) build: Option<PathBuf>,
    pub(crate) address: Option<String>,
    pub(crate) repository: Option<String>,
}

/// Parses the words after the program's name.
pub(crate) fn parse(words: Vec<OsString>) -> Result<Request> {
    let first = words.first().map(|word| word.to_string_lossy().into_owned()).unwrap_or_default();
    if first != "demo" && commands().any(|name| name == first) {
        return Ok(Request::Laboratory(words));
    }
    let mut words = Arguments::from_vec(words);
    if words.contains(["-h", "--help"]) {
        return Ok(Request::Help);
    }
    if words.subcommand()?.as_deref() != Some("demo") {
        bail!("command = \"{first}\": expected {}", commands().collect::<Vec<_>>().join(", "));
    }
    let options = demo(&mut words)?;
    let left = words.finish();
    ensure!(left.is_empty(), "{left:?} is no option of {first}: `cargo xtask --help` lists them");
    Ok(Request::Demo(options))
}

fn demo(words: &mut Arguments) -> Result<DemoOptions> {
    let options = DemoOptions {
        port: words.opt_value_from_str("--port")?,
        view: words.opt_value_from_fn("--view", view)?,
        check: words.contains("--check"),
        screenshot: words.opt_value_from_str("--screenshot")?,
        build: words.opt_value_from_str("--build")?,
        address: words.opt_value_from_fn("--address", address)?,
        repository: words.opt_value_from_fn("--repository", address)?,
    };
    let DemoOptions { port, view, check, screenshot, build, address, repository } = &options;
    for (name, value) in [("--address", address), ("--repository", repository)] {
        ensure!(value.is_none() || build.is_some(), "{name}: expected --build, too");
    }
    let is_served = *check || port.is_some() || view.is_some() || screenshot.is_some();
    ensure!(build.is_none() || !is_served, "--build: expected no option but --address and --repository");
    Ok(options)
}

/// The names of all commands.
fn commands() -> impl Iterator<Item = &'static str> {
    let lines = HELP.lines().filter_map(|line| line.strip_prefix("  "));
    lines.filter(|line| !line.starts_with(' ')).filter_map(|line| line.split(' ').next())
}

/// Parses a view of the page with its settings. An unknown view is an error here, before the demo is
/// built: the page itself would show another.
fn view(view: &str) -> Result<String, String> {
    let name = view.split('?').next().unwrap_or_default();
    let names: Vec<_> = site::views().collect();
    if names.contains(&name) {
        Ok(view.to_owned())
    } else {
        Err(format!("expected one of {}", names.join(", ")))
    }
}

/// Parses the address of a folder and ends it with a slash. The address is written into the page, so
/// only characters of addresses are accepted.
fn address(address: &str) -> Result<String, &'static str> {
    let host = ["https://", "http://"].iter().find_map(|scheme| address.strip_prefix(scheme));
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-._~:/%[]@+".contains(c);
    match host {
        Some(host) if !host.is_empty() && host.chars().all(is_plain) => {
            Ok(format!("{}/", address.trim_end_matches('/')))
        }
        _ => Err("expected a folder's address, as in https://example.org/demo/"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(line: &str) -> Result<Request> {
        super::parse(line.split_whitespace().map(OsString::from).collect())
    }

    #[test]
    fn commands_take_their_options() {
        let address = Some("https://example.org/demo/".to_owned());
        let repository = Some("https://example.org/source/".to_owned());
        let built = DemoOptions { build: Some("site".into()), address, repository, ..Default::default() };
        let laboratory = Request::Laboratory(["test", "--help"].map(OsString::from).to_vec());
        for (line, request) in [
            ("demo -h", Request::Help),
            (
                "demo --build=site --address https://example.org/demo --repository https://example.org/source",
                Request::Demo(built),
            ),
            ("test --help", laboratory),
        ] {
            assert_eq!(parse(line).unwrap(), request, "{line}");
        }
    }

    #[test]
    fn a_refused_word_is_named_with_what_is_expected() {
        for (line, name) in [
            ("", "expected demo, test, full, prove, fuzz, board"),
            ("tset", "tset"),
            ("--fast", "fast"),
            ("demo --prot 1", "--prot"),
            ("demo now", "now"),
            ("demo --port 99999", "99999"),
            ("demo --view nope?half=1", "expected one of stage, compare, museum"),
            ("demo --build site --check", "--build"),
            ("demo --address https://example.org", "--build"),
            ("demo --repository https://example.org", "--build"),
            ("demo --build site --address example.org", "expected a folder's address"),
            ("demo --build site --address https://a.org/\"", "expected a folder's address"),
            ("demo --port", "--port"),
        ] {
            let error = parse(line).unwrap_err().to_string();
            assert!(error.contains(name), "`{line}` was refused with: {error}");
        }
    }
}
