//! The programs of others that the commands run, and how a person installs each on their system.

use std::path::PathBuf;
use std::{env, slice};

use crate::command;
use crate::system::System;

/// A program with the packages that have it.
#[derive(Debug)]
pub struct Tool {
    /// Its names, the usual one first.
    programs: &'static [&'static str],
    /// Debian's packages.
    pub debian: &'static [&'static str],
    /// The packages for macOS and for Windows; empty where there is none.
    brew: &'static str,
    winget: &'static str,
    /// Its files below the folders of [`System::installed`] on macOS and on Windows, if it is not on PATH.
    installed: [&'static [&'static str]; 2],
}

/// Runs scripts.
pub const NODE: Tool = tool(&["node", "nodejs"], &["nodejs", "npm"], "node", "OpenJS.NodeJS.LTS");
/// Installs packages of scripts.
pub const NPM: Tool = Tool { programs: &["npm"], ..NODE };
/// Runs the page. Edge is a Chromium, which every Windows has.
pub const CHROMIUM: Tool =
    tool(&["chromium", "chromium-browser", "google-chrome"], &["chromium"], "google-chrome", "Google.Chrome")
        .installed(
            &[
                "Google Chrome.app/Contents/MacOS/Google Chrome",
                "Chromium.app/Contents/MacOS/Chromium",
                "Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
            ],
            &["Google/Chrome/Application/chrome.exe", "Microsoft/Edge/Application/msedge.exe"],
        );
/// Runs the page in another engine.
pub const FIREFOX: Tool = tool(&["firefox-esr", "firefox"], &["firefox-esr"], "firefox", "Mozilla.Firefox")
    .installed(&["Firefox.app/Contents/MacOS/firefox"], &["Mozilla Firefox/firefox.exe"]);
/// A display that nobody sees, and Mesa's renderer on it.
pub const XVFB: Tool = debian(&["Xvfb"], &["xvfb", "libgl1-mesa-dri"]);
/// Drives WebKitGTK, by Debian's Python.
pub const WEBKIT: Tool =
    debian(&["WebKitWebDriver"], &["xvfb", "webkit2gtk-driver", "python3-gi", "gir1.2-webkit2-4.1"]);
/// Runs other readers of lights.
pub const PYTHON: Tool =
    tool(&["python3", "python"], &["python3", "python3-venv"], "python", "Python.Python.3.13");
/// Emulates boards. The packages share the last two.
pub const QEMU: Tool = tool(
    &["qemu-system-arm", "qemu-system-riscv32", "qemu-system-xtensa"],
    &["qemu-system-arm", "qemu-system-misc", "qemu-system-common", "qemu-system-data"],
    "qemu",
    "SoftwareFreedomConservancy.QEMU",
);
/// Emulates a Game Boy Advance, as a library of C.
pub const MGBA: Tool = debian(&["/usr/include/mgba/core/core.h"], &["libmgba-dev"]);
/// Proves bounds of errors.
pub const GAPPA: Tool = debian(&["gappa"], &["gappa", "coq", "libcoq-gappa"]);
/// Checks the proofs.
pub const COQ: Tool = Tool { programs: &["coqc"], ..GAPPA };
/// Proves that C has no undefined behaviour.
pub const FRAMA_C: Tool = debian(&["frama-c"], &["frama-c-base", "gcc"]);
/// The compilers of this machine.
pub const CC: Tool = debian(&["cc"], &["gcc"]);
/// The same for C++.
pub const CXX: Tool = debian(&["c++"], &["g++"]);
/// Another one.
pub const CLANG: Tool = debian(&["clang"], &["clang"]);
/// The compiler for Cortex-M.
pub const ARM_CC: Tool = tool(
    &["arm-none-eabi-gcc"],
    &["gcc-arm-none-eabi", "libnewlib-arm-none-eabi"],
    "gcc-arm-embedded",
    "Arm.GnuArmEmbeddedToolchain",
);
/// The same for C++.
pub const ARM_CXX: Tool = Tool { programs: &["arm-none-eabi-g++"], ..ARM_CC };
/// The compiler for RISC-V, with picolibc.
pub const RISCV_CC: Tool =
    debian(&["riscv64-unknown-elf-gcc"], &["gcc-riscv64-unknown-elf", "picolibc-riscv64-unknown-elf"]);
/// The compiler for the Xtensa of an ESP8266.
pub const XTENSA_CC: Tool = debian(&["xtensa-lx106-elf-gcc"], &["gcc-xtensa-lx106"]);
/// Its library of C, where the compiler does not look.
pub const XTENSA_LIBRARY: Tool =
    debian(&["/usr/lib/xtensa-lx106-elf/picolibc.specs"], &["picolibc-xtensa-lx106-elf"]);
/// The compiler for AVR.
pub const AVR_CC: Tool =
    tool(&["avr-gcc"], &["gcc-avr", "avr-libc"], "osx-cross/avr/avr-gcc", "ZakKemble.avr-gcc");
/// Says how large a program for AVR is.
pub const AVR_SIZE: Tool = Tool { programs: &["avr-size"], debian: &["binutils-avr"], ..AVR_CC };
/// Emulates an AVR.
pub const SIMAVR: Tool = tool(&["simavr"], &["simavr"], "osx-cross/avr/simavr", "");
/// The boards of Arduino.
pub const ARDUINO: Tool =
    debian(&["/usr/share/arduino/hardware/arduino/avr/boards.txt"], &["arduino-core-avr"]);
/// Configures builds of C.
pub const CMAKE: Tool = tool(&["cmake"], &["cmake"], "cmake", "Kitware.CMake");

const fn tool(
    programs: &'static [&'static str],
    debian: &'static [&'static str],
    brew: &'static str,
    winget: &'static str,
) -> Tool {
    Tool { programs, debian, brew, winget, installed: [&[]; 2] }
}

/// A tool that has no package for other systems.
const fn debian(programs: &'static [&'static str], debian: &'static [&'static str]) -> Tool {
    tool(programs, debian, "", "")
}

impl Tool {
    const fn installed(self, mac: &'static [&'static str], windows: &'static [&'static str]) -> Self {
        Self { installed: [mac, windows], ..self }
    }

    /// The program, on PATH or else where its installer puts it.
    pub fn find(&self) -> Option<PathBuf> {
        command::on_path(self.programs)
            .or_else(|| self.places(System::HERE, |name| env::var_os(name)).find(|file| file.is_file()))
    }

    /// Where its installer may put it.
    fn places(
        &self,
        system: System,
        variable: impl Fn(&str) -> Option<std::ffi::OsString>,
    ) -> impl Iterator<Item = PathBuf> {
        let [mac, windows] = self.installed;
        let files = match system {
            System::Linux => &[],
            System::Mac => mac,
            System::Windows => windows,
        };
        let folders = system.installed(variable);
        files.iter().flat_map(move |file| folders.clone().into_iter().map(move |folder| folder.join(file)))
    }

    /// That it is missing, and what to do.
    pub fn missing(&self, system: System) -> String {
        let names = self.programs.join(" or ");
        format!("no {names} is found: {}", remedy(slice::from_ref(&self), system))
    }
}

/// How to install tools on a system, in words.
pub fn remedy(tools: &[&Tool], system: System) -> String {
    let unique = |packages: Vec<&'static str>| {
        let mut words: Vec<&str> = Vec::new();
        for package in packages {
            if !words.contains(&package) {
                words.push(package);
            }
        }
        words.join(" ")
    };
    let all = unique(tools.iter().flat_map(|tool| tool.debian).copied().collect());
    let debian = format!("on Debian, as root, `apt-get install {all}`");
    let (package, install): (fn(&Tool) -> &'static str, _) = match system {
        System::Linux => return debian,
        System::Mac => (|tool| tool.brew, "`brew install "),
        System::Windows => (|tool| tool.winget, "`winget install "),
    };
    let found = unique(tools.iter().map(|tool| package(tool)).filter(|name| !name.is_empty()).collect());
    let new = if system == System::Windows { ", then open a new terminal" } else { "" };
    let mut words: Vec<_> =
        (!found.is_empty()).then(|| format!("{install}{found}`{new}")).into_iter().collect();
    let without: Vec<_> =
        tools.iter().filter(|tool| package(tool).is_empty()).map(|tool| tool.programs[0]).collect();
    if !without.is_empty() {
        words.push(format!("{} has no package for this system: {debian}", without.join(", ")));
    }
    words.join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_tool_is_named_with_what_installs_it_on_each_system() {
        for (tool, linux, mac, windows) in [
            (
                &NPM,
                "no npm is found: on Debian, as root, `apt-get install nodejs npm`",
                "no npm is found: `brew install node`",
                "no npm is found: `winget install OpenJS.NodeJS.LTS`, then open a new terminal",
            ),
            (
                &QEMU,
                "no qemu-system-arm or qemu-system-riscv32 or qemu-system-xtensa is found: on Debian, as root, \
                 `apt-get install qemu-system-arm qemu-system-misc qemu-system-common qemu-system-data`",
                "no qemu-system-arm or qemu-system-riscv32 or qemu-system-xtensa is found: `brew install qemu`",
                "no qemu-system-arm or qemu-system-riscv32 or qemu-system-xtensa is found: `winget install \
                 SoftwareFreedomConservancy.QEMU`, then open a new terminal",
            ),
        ] {
            for (system, words) in [(System::Linux, linux), (System::Mac, mac), (System::Windows, windows)] {
                assert_eq!(tool.missing(system), words, "{system:?}");
            }
        }
    }

    #[test]
    fn several_tools_are_one_command_and_one_without_a_package_is_named() {
        let tools = [&ARM_CC, &ARM_CXX, &CMAKE, &SIMAVR];
        let debian =
            "on Debian, as root, `apt-get install gcc-arm-none-eabi libnewlib-arm-none-eabi cmake simavr`";
        for (system, words) in [
            (System::Linux, debian.to_owned()),
            (System::Mac, "`brew install gcc-arm-embedded cmake osx-cross/avr/simavr`".to_owned()),
            (
                System::Windows,
                format!(
                    "`winget install Arm.GnuArmEmbeddedToolchain Kitware.CMake`, then open a new terminal; \
                     simavr has no package for this system: {debian}"
                ),
            ),
        ] {
            assert_eq!(remedy(&tools, system), words, "{system:?}");
        }
    }

    #[test]
    fn a_browser_is_looked_for_where_its_installer_puts_it() {
        let variable = |name: &str| match name {
            "HOME" => Some("/Users/me".into()),
            "ProgramFiles" => Some("C:/Program Files".into()),
            "LocalAppData" => Some("C:/Users/me/AppData/Local".into()),
            _ => None,
        };
        let places = |system| CHROMIUM.places(system, variable).collect::<Vec<_>>();
        assert!(places(System::Linux).is_empty());
        let chrome = "Google Chrome.app/Contents/MacOS/Google Chrome";
        let own = ["/Applications/", "/Users/me/Applications/"]
            .map(|folder| PathBuf::from(format!("{folder}{chrome}")));
        assert_eq!(places(System::Mac)[..2], own);
        for file in [
            "C:/Program Files/Google/Chrome/Application/chrome.exe",
            "C:/Users/me/AppData/Local/Google/Chrome/Application/chrome.exe",
            "C:/Program Files/Microsoft/Edge/Application/msedge.exe",
        ] {
            assert!(places(System::Windows).contains(&file.into()), "{file}");
        }
    }
}
