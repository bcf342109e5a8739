//! What the command line asks for.

use std::ffi::OsString;
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

use lexopt::prelude::*;
use luminaire_render::examples::Example;

use crate::conform::{self, ConformOptions};
use crate::effects::EffectsOptions;
use crate::firmware::frame::FrameOptions;
use crate::firmware::{Board, FirmwareOptions};
use crate::measure::{self, MeasureOptions};
use crate::site;
use crate::size::SizeOptions;

/// A command with its options.
#[derive(Debug, PartialEq)]
pub(crate) enum Request {
    Help,
    Conform(ConformOptions),
    Demo(DemoOptions),
    Effects(EffectsOptions),
    Firmware(FirmwareOptions),
    Frame(FrameOptions),
    Size(SizeOptions),
    Measure(MeasureOptions),
    Test(TestOptions),
}

/// The options of `demo`.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct DemoOptions {
    /// The port to serve on; none means the usual one.
    pub(crate) port: Option<u16>,
    /// The size of the lit picture; none leaves it to the page.
    pub(crate) size: Option<Size>,
    /// What stands after the # of the address: `compare`, or with settings `compare?half=0.1`, `scenes?scene=grid`.
    pub(crate) view: Option<String>,
    /// Run the page once in a browser instead of serving for ever.
    pub(crate) check: bool,
    /// Where to write a picture of the page.
    pub(crate) screenshot: Option<PathBuf>,
}

/// The options of `test`.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct TestOptions {
    /// Run the long sweeps too.
    pub(crate) full: bool,
    /// Run only the steps whose name contains this text.
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

impl Request {
    /// Reads the command line; an error says which word was not understood.
    pub(crate) fn parse(mut words: lexopt::Parser) -> Result<Self, lexopt::Error> {
        let command: OsString = match words.next()? {
            None | Some(Short('h') | Long("help")) => return Ok(Self::Help),
            Some(Value(command)) => command,
            Some(option) => return Err(option.unexpected()),
        };
        match command.to_str() {
            Some("help") => Ok(Self::Help),
            Some("conform") => Self::parse_conform(words),
            Some("demo") => Self::parse_demo(words),
            Some("effects") => Self::parse_effects(words),
            Some("firmware") => Self::parse_firmware(words),
            Some("frame") => Self::parse_frame(words),
            Some("size") => Self::parse_size(words),
            Some("measure") => Self::parse_measure(words),
            Some("test") => Self::parse_test(words),
            _ => Err(format!("there is no command {command:?}").into()),
        }
    }

    fn parse_conform(mut words: lexopt::Parser) -> Result<Self, lexopt::Error> {
        let mut options = ConformOptions::default();
        while let Some(word) = words.next()? {
            match word {
                Long("target") => options.targets.extend(conform::Target::named(&words.value()?.string()?)?),
                Long("bless") => options.bless = true,
                Short('h') | Long("help") => return Ok(Self::Help),
                other => return Err(other.unexpected()),
            }
        }
        Ok(Self::Conform(options))
    }

    fn parse_demo(mut words: lexopt::Parser) -> Result<Self, lexopt::Error> {
        let (mut options, mut scene) = (DemoOptions::default(), None);
        while let Some(word) = words.next()? {
            match word {
                Long("port") => options.port = Some(port(&words.value()?.string()?)?),
                Long("size") => options.size = Some(words.value()?.parse()?),
                Long("view") => options.view = Some(words.value()?.string()?),
                Long("scene") => scene = Some(words.value()?.string()?),
                Long("check") => options.check = true,
                Long("screenshot") => options.screenshot = Some(words.value()?.into()),
                Short('h') | Long("help") => return Ok(Self::Help),
                other => return Err(other.unexpected()),
            }
        }
        if let Some(scene) = scene {
            if options.view.is_some_and(|view| view != "scenes") {
                return Err("--scene opens the view scenes, and no other".into());
            }
            options.view = Some(format!("scenes?scene={scene}"));
        }
        options.view.as_deref().map_or(Ok(()), check_view)?;
        Ok(Self::Demo(options))
    }

    fn parse_effects(mut words: lexopt::Parser) -> Result<Self, lexopt::Error> {
        let mut options = EffectsOptions::default();
        while let Some(word) = words.next()? {
            match word {
                Long("check") => options.check = true,
                Long("bless") => options.bless = true,
                Short('h') | Long("help") => return Ok(Self::Help),
                other => return Err(other.unexpected()),
            }
        }
        refuse_both(options.check, options.bless)?;
        Ok(Self::Effects(options))
    }

    fn parse_firmware(mut words: lexopt::Parser) -> Result<Self, lexopt::Error> {
        let mut options = FirmwareOptions::default();
        while let Some(word) = words.next()? {
            match word {
                Long("target") => options.boards.push(Board::named(&words.value()?.string()?)?),
                Long("by-symbol") => options.by_symbol = Some(words.value()?.string()?),
                Short('h') | Long("help") => return Ok(Self::Help),
                other => return Err(other.unexpected()),
            }
        }
        Ok(Self::Firmware(options))
    }

    fn parse_frame(mut words: lexopt::Parser) -> Result<Self, lexopt::Error> {
        let mut options = FrameOptions::default();
        while let Some(word) = words.next()? {
            match word {
                Long("target") => options.boards.push(Board::named(&words.value()?.string()?)?),
                Long("bless") => options.bless = true,
                Short('h') | Long("help") => return Ok(Self::Help),
                other => return Err(other.unexpected()),
            }
        }
        Ok(Self::Frame(options))
    }

    fn parse_size(mut words: lexopt::Parser) -> Result<Self, lexopt::Error> {
        let mut options = SizeOptions::default();
        while let Some(word) = words.next()? {
            match word {
                Long("json") => options.json = true,
                Short('h') | Long("help") => return Ok(Self::Help),
                other => return Err(other.unexpected()),
            }
        }
        Ok(Self::Size(options))
    }

    fn parse_measure(mut words: lexopt::Parser) -> Result<Self, lexopt::Error> {
        let mut options = MeasureOptions::default();
        while let Some(word) = words.next()? {
            match word {
                Long("target") => options.targets.push(measure::Target::named(&words.value()?.string()?)?),
                Long("check") => options.check = true,
                Long("bless") => options.bless = true,
                Short('h') | Long("help") => return Ok(Self::Help),
                other => return Err(other.unexpected()),
            }
        }
        refuse_both(options.check, options.bless)?;
        Ok(Self::Measure(options))
    }

    fn parse_test(mut words: lexopt::Parser) -> Result<Self, lexopt::Error> {
        let mut options = TestOptions::default();
        while let Some(word) = words.next()? {
            match word {
                Long("full") => options.full = true,
                Long("only") => options.only = Some(words.value()?.string()?),
                Short('h') | Long("help") => return Ok(Self::Help),
                other => return Err(other.unexpected()),
            }
        }
        Ok(Self::Test(options))
    }
}

fn port(text: &str) -> Result<u16, lexopt::Error> {
    text.parse().map_err(|_| format!("--port {text}: expected a whole number from 0 to {}", u16::MAX).into())
}

/// The page would show another view than one that it does not have, or refuse a scene: it is better to say so before it
/// is built.
fn check_view(view: &str) -> Result<(), lexopt::Error> {
    let (name, settings) = view.split_once('?').unwrap_or((view, ""));
    one_of("--view", name, &site::views().collect::<Vec<_>>())?;
    let mut scenes = settings.split('&').filter_map(|setting| setting.strip_prefix("scene="));
    scenes.try_for_each(|scene| one_of("--scene", scene, &Example::ALL.map(Example::name)))
}

fn one_of(option: &str, name: &str, names: &[&str]) -> Result<(), lexopt::Error> {
    if names.contains(&name) {
        Ok(())
    } else {
        Err(format!("{option} {name}: expected one of {}", names.join(", ")).into())
    }
}

/// A record is compared or accepted.
fn refuse_both(check: bool, bless: bool) -> Result<(), lexopt::Error> {
    if check && bless { Err("--check compares and --bless accepts: one of them".into()) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(line: &str) -> Result<Request, lexopt::Error> {
        Request::parse(lexopt::Parser::from_args(line.split_whitespace()))
    }

    #[test]
    fn no_word_at_all_asks_for_help() {
        for line in ["", "help", "--help", "-h", "demo --help", "test -h"] {
            assert_eq!(parse(line).unwrap(), Request::Help, "{line}");
        }
    }

    #[test]
    fn demo_takes_its_options_in_any_order() {
        let options = DemoOptions {
            port: Some(9000),
            size: Some(Size { width: 320, height: 180 }),
            view: Some("compare".into()),
            check: true,
            screenshot: Some("page.png".into()),
        };
        let expected = Request::Demo(options);
        assert_eq!(
            parse("demo --check --port 9000 --size 320x180 --view compare --screenshot page.png").unwrap(),
            expected
        );
        assert_eq!(
            parse("demo --screenshot=page.png --view=compare --size=320x180 --port=9000 --check").unwrap(),
            expected
        );
    }

    #[test]
    fn demo_opens_a_scene() {
        let view = Some("scenes?scene=grid".to_owned());
        let expected = Request::Demo(DemoOptions { view, ..DemoOptions::default() });
        for line in ["demo --view scenes --scene grid", "demo --scene grid"] {
            assert_eq!(parse(line).unwrap(), expected, "{line}");
        }
        for view in ["stage", "compare?left=f32&half=0.1", "scenes?scene=show&map=tiles"] {
            let expected = DemoOptions { view: Some(view.to_owned()), ..DemoOptions::default() };
            assert_eq!(parse(&format!("demo --view {view}")).unwrap(), Request::Demo(expected));
        }
        assert!(parse("demo --view compare --scene grid").unwrap_err().to_string().contains("--scene"));
    }

    #[test]
    fn test_takes_its_options() {
        assert_eq!(parse("test").unwrap(), Request::Test(TestOptions::default()));
        let options = TestOptions { full: true, only: Some("browser".into()) };
        assert_eq!(parse("test --only browser --full").unwrap(), Request::Test(options));
    }

    #[test]
    fn conform_takes_targets_or_blesses() {
        let bless = ConformOptions { targets: Vec::new(), bless: true };
        assert_eq!(parse("conform --bless").unwrap(), Request::Conform(bless));
        let targets = ConformOptions { targets: vec![conform::Target::Browser], bless: false };
        assert_eq!(parse("conform --target wasm").unwrap(), Request::Conform(targets));
    }

    #[test]
    fn firmware_takes_targets_one_by_one() {
        let Request::Firmware(options) = parse("firmware --target cortex-m0 --target rv32imc").unwrap()
        else {
            panic!("another command");
        };
        assert_eq!(
            options.boards.iter().map(|board| board.name).collect::<Vec<_>>(),
            ["cortex-m0", "rv32imc"]
        );
        let options = FirmwareOptions { boards: Vec::new(), by_symbol: Some("lit.fx16".into()) };
        assert_eq!(parse("firmware --by-symbol lit.fx16").unwrap(), Request::Firmware(options));
    }

    #[test]
    fn effects_either_compares_or_accepts() {
        let check = EffectsOptions { check: true, bless: false };
        assert_eq!(parse("effects --check").unwrap(), Request::Effects(check));
        let bless = EffectsOptions { check: false, bless: true };
        assert_eq!(parse("effects --bless").unwrap(), Request::Effects(bless));
        assert!(parse("effects --check --bless").is_err());
    }

    #[test]
    fn frame_takes_targets_or_blesses() {
        assert_eq!(parse("frame").unwrap(), Request::Frame(FrameOptions::default()));
        let Request::Frame(options) = parse("frame --bless --target cortex-m3").unwrap() else {
            panic!("another command");
        };
        assert_eq!((options.bless, options.boards[0].name), (true, "cortex-m3"));
    }

    #[test]
    fn size_prints_a_table_or_json() {
        assert_eq!(parse("size").unwrap(), Request::Size(SizeOptions { json: false }));
        assert_eq!(parse("size --json").unwrap(), Request::Size(SizeOptions { json: true }));
    }

    #[test]
    fn measure_takes_targets_and_either_checks_or_accepts() {
        let Request::Measure(options) = parse("measure --target host --target rv32imc --bless").unwrap()
        else {
            panic!("it is not measure");
        };
        let names: Vec<_> = options.targets.iter().map(measure::Target::name).collect();
        assert_eq!((names, options.check, options.bless), (vec!["host", "rv32imc"], false, true));
        assert!(parse("measure --check --bless").is_err());
        assert!(parse("measure --target gpu").unwrap_err().to_string().contains("wasm-simd"));
    }

    #[test]
    fn what_is_not_understood_is_named() {
        for (line, name) in [
            ("tset", "tset"),
            ("--fast", "fast"),
            ("demo --prot 1", "prot"),
            ("demo now", "now"),
            ("demo --port 99999", "--port 99999: expected a whole number from 0 to 65535"),
            ("demo --port=-1", "--port -1: expected a whole number from 0 to 65535"),
            ("demo --view nope", "--view nope: expected one of stage, compare, scenes"),
            ("demo --view nope?half=1", "--view nope: expected one of stage"),
            ("demo --scene nope", "--scene nope: expected one of bare-spot, pocket, three-point"),
            ("demo --view scenes?map=lights&scene=nope", "--scene nope: expected one of bare-spot"),
            ("demo --port", "port"),
            ("demo --size 960", "960"),
            ("demo --size 0x540", "0x540"),
            ("test --only", "only"),
            ("firmware --target cortex-m1", "cortex-m1"),
            ("conform --target cortex-m1", "cortex-m1"),
        ] {
            let error = parse(line).unwrap_err().to_string();
            assert!(error.contains(name), "`{line}` was refused with: {error}");
        }
    }
}
