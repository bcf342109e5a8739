//! The command line.

use std::ffi::OsString;
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

use tools::demo::site;

use crate::lab;

/// The project's commands.
#[derive(Debug, PartialEq, clap::Parser)]
#[command(
    name = "cargo xtask",
    disable_help_subcommand = true,
    arg_required_else_help = true,
    after_help = laboratory()
)]
pub(crate) enum Request {
    /// Build the browser demo into target/demo and serve it on 127.0.0.1; the same as `cargo demo`
    Demo(DemoOptions),
    /// Run the tests: format, lints, documentation, host, an emulated board, a browser
    Test(TestOptions),
    /// Run the tests with the long sweeps, on all boards, in all browsers, with all feature sets, and
    /// from the packed crates
    Full(TestOptions),
    /// A command of the laboratory
    #[command(external_subcommand)]
    Lab(Vec<OsString>),
}

/// The commands of the laboratory, for the help.
fn laboratory() -> String {
    let lines = lab::COMMANDS.iter().map(|(name, what)| format!("  {name:<10} {what}"));
    format!("The laboratory, built when it is first called:\n{}", lines.collect::<Vec<_>>().join("\n"))
}

/// The options of `demo`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub(crate) struct DemoOptions {
    /// Serve on this port instead of 8080
    #[arg(long)]
    pub(crate) port: Option<u16>,
    /// Draw a picture of this size in pixels instead of 960x540
    #[arg(long, value_name = "WxH")]
    pub(crate) size: Option<Size>,
    /// Open this view of the page: stage, compare, museum or chip; settings may follow, as in
    /// compare?half=0.1 or stage?scene=grid
    #[arg(long, value_name = "NAME", value_parser = view)]
    pub(crate) view: Option<String>,
    /// Instead of serving: run the page once in headless Chromium, print one line and exit
    #[arg(long)]
    pub(crate) check: bool,
    /// Like --check, and write a PNG of the page at 1440x900 to this file
    #[arg(long, value_name = "FILE")]
    pub(crate) screenshot: Option<PathBuf>,
    /// Instead of serving: write the demo into this folder, for any static host
    #[arg(
        long,
        value_name = "DIR",
        conflicts_with_all = ["port", "size", "view", "check", "screenshot"]
    )]
    pub(crate) build: Option<PathBuf>,
    /// With --build: where the folder will be served, for link previews, as in
    /// `https://example.org/demo/`
    #[arg(long, value_name = "URL", requires = "build", value_parser = address)]
    pub(crate) address: Option<String>,
}

/// The options of `test` and `full`.
#[derive(Debug, Default, PartialEq, clap::Args)]
pub(crate) struct TestOptions {
    /// Run only the steps whose name contains this text
    #[arg(long, value_name = "TEXT")]
    pub(crate) only: Option<String>,
}

/// Width and height in pixels, written `960x540`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Size {
    pub(crate) width: u32,
    pub(crate) height: u32,
}

impl FromStr for Size {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let refused = "a size is written WxH in whole pixels, for instance 960x540";
        let (width, height) = text.split_once('x').ok_or(refused)?;
        let size =
            Size { width: width.parse().map_err(|_| refused)?, height: height.parse().map_err(|_| refused)? };
        if size.width == 0 || size.height == 0 { Err(refused) } else { Ok(size) }
    }
}

impl fmt::Display for Size {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}x{}", self.width, self.height)
    }
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
fn address(address: &str) -> Result<String, String> {
    let host = ["https://", "http://"].iter().find_map(|scheme| address.strip_prefix(scheme));
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-._~:/%[]@+".contains(c);
    match host {
        Some(host) if !host.is_empty() && host.chars().all(is_plain) => {
            Ok(format!("{}/", address.trim_end_matches('/')))
        }
        _ => Err("expected a folder's address, as in https://example.org/demo/".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser as _;
    use clap::error::ErrorKind;

    use super::*;

    fn parse(line: &str) -> Result<Request, clap::Error> {
        Request::try_parse_from(["xtask"].into_iter().chain(line.split_whitespace()))
    }

    fn demo(line: &str) -> DemoOptions {
        match parse(line) {
            Ok(Request::Demo(options)) => options,
            other => panic!("{line}: expected demo, found {other:?}"),
        }
    }

    #[test]
    fn help_is_printed_for_every_command() {
        for line in ["--help", "-h", "demo --help", "test -h", "full --help"] {
            assert_eq!(parse(line).unwrap_err().kind(), ErrorKind::DisplayHelp, "{line}");
        }
        assert_eq!(parse("").unwrap_err().kind(), ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand);
    }

    #[test]
    fn demo_takes_its_options_in_any_order() {
        let options = demo("demo --check --port 9000 --size 320x180 --view compare --screenshot page.png");
        assert_eq!(
            (options.port, options.size, options.view.clone(), options.check, options.screenshot.clone()),
            (
                Some(9000),
                Some(Size { width: 320, height: 180 }),
                Some("compare".into()),
                true,
                Some("page.png".into())
            )
        );
        let again = demo("demo --screenshot=page.png --view=compare --size=320x180 --port=9000 --check");
        assert_eq!(again, options);
    }

    #[test]
    fn demo_opens_a_view() {
        for view in ["stage", "compare?left=f32&half=0.1", "stage?scene=show&map=tiles"] {
            assert_eq!(demo(&format!("demo --view {view}")).view.unwrap(), view);
        }
    }

    #[test]
    fn demo_is_built_for_an_address() {
        let options = demo("demo --build site --address https://example.org/demo");
        assert_eq!(options.build, Some("site".into()));
        assert_eq!(options.address.as_deref(), Some("https://example.org/demo/"));
    }

    #[test]
    fn full_is_a_command_of_its_own() {
        assert_eq!(parse("test").unwrap(), Request::Test(TestOptions::default()));
        let options = TestOptions { only: Some("browser".into()) };
        assert_eq!(parse("full --only browser").unwrap(), Request::Full(options));
    }

    #[test]
    fn another_word_is_a_command_of_the_laboratory() {
        let words = ["measure", "--check"].map(OsString::from).to_vec();
        assert_eq!(parse("measure --check").unwrap(), Request::Lab(words));
        let refused = lab::run(&["tset".into()]).unwrap_err().to_string();
        assert!(
            refused.contains("tset") && refused.contains("expected demo, test, full, board"),
            "{refused}"
        );
    }

    #[test]
    fn a_refused_word_is_named_with_what_is_expected() {
        for (line, name) in [
            ("--fast", "fast"),
            ("demo --prot 1", "--prot"),
            ("demo now", "now"),
            ("demo --port 99999", "99999 is not in 0..=65535"),
            ("demo --view nope", "expected one of stage, compare, museum"),
            ("demo --view nope?half=1", "expected one of stage"),
            ("demo --build site --check", "--check"),
            ("demo --address https://example.org", "--build"),
            ("demo --build site --address example.org", "expected a folder's address"),
            ("demo --build site --address https://a.org/\"", "expected a folder's address"),
            ("demo --port", "--port"),
            ("demo --size 960", "960"),
            ("demo --size 0x540", "0x540"),
            ("test --only", "--only"),
        ] {
            let error = parse(line).unwrap_err().to_string();
            assert!(error.contains(name), "`{line}` was refused with: {error}");
        }
    }
}
