//! The project's commands, run by cargo itself: `cargo demo` and `cargo xtask test`.

mod arguments;
mod browser;
mod command;
mod conform;
mod contributing;
mod demo;
mod effects;
mod firmware;
mod http;
mod install;
mod measure;
mod progress;
mod project;
mod server;
mod shrink;
mod site;
mod size;
mod suite;
mod tally;
mod test;
mod toolchain;
mod turntable;
mod wasm;

use std::process::ExitCode;

use arguments::Request;

const USAGE: &str = "\
The project's commands.

cargo demo [OPTIONS]         Build the browser demo into target/demo and serve it on http://127.0.0.1:8080
    --port N                 Serve on port N instead of 8080
    --size WxH               Light a picture of WxH pixels instead of 960x540
    --view NAME              Open this view of the page: stage, scenes or compare
    --scene NAME             Open this scene of the view scenes, such as grid or show
    --check                  Instead of serving: run the page once in headless Chromium, print one line and exit
    --screenshot FILE        Like --check, and write a PNG of the page at 1440x900 to FILE

cargo xtask test [OPTIONS]   Run the tests: format, lints, documentation, host, two emulated boards, browser
    --full                   Run the long sweeps too (the host tests see LUMINAIRE_FULL=1), on all boards and feature sets
    --only TEXT              Run only the steps whose name contains TEXT

cargo xtask firmware [OPTIONS]   Count what the kernels cost on microcontrollers, in QEMU
    --target NAME            Count on this one only: cortex-m0, cortex-m3, cortex-m4f or rv32imc; may be repeated
    --by-symbol KERNEL       Split one kernel, such as lit.fx16, by function instead of printing the table

cargo xtask frame [OPTIONS]  Draw a picture on microcontrollers, in QEMU, and count the instructions of a pixel
    --target NAME            On this one only: one of the above; may be repeated
    --bless                  Write picture and counts although they differ from those in docs and firmware/README.md

cargo xtask effects [OPTIONS]    Write what each effect costs: instructions a pixel and bytes of flash, on two processors
    --check                  Compare with what is recorded instead, and write nothing
    --bless                  Write the prices also where they differ from those recorded, and time a browser anew

cargo xtask size [OPTIONS]   Count what each effect takes of a microcontroller's flash
    --json                   Print {target: {format: {effect: bytes}}} instead of the table
cargo xtask measure [OPTIONS]    Write the price list of accuracy: errors, and costs on every target
    --target NAME            Measure the costs on this one only: host, wasm, wasm-simd or one of the above; may be repeated
    --check                  Compare errors and instructions with the list instead, and write nothing
    --bless                  Write the list also where errors or instructions differ from it
cargo xtask conform [OPTIONS]    Compare the bits of every model with the conformance vectors, on every target
    --target NAME            On this one only: host, wasm or one of the processors above; may be repeated
    --bless                  Write the vectors anew as the host computes them, and tell what changed

cargo xtask demo             The same as cargo demo
cargo xtask help             Print this text
";

fn main() -> ExitCode {
    let request = match Request::parse(lexopt::Parser::from_env()) {
        Ok(request) => request,
        Err(error) => {
            eprintln!("error: {error}\n\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    let outcome = match request {
        Request::Help => {
            print!("{USAGE}");
            Ok(ExitCode::SUCCESS)
        }
        Request::Conform(options) => conform::run(&options),
        Request::Demo(options) => demo::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Effects(options) => effects::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Firmware(options) => firmware::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Frame(options) => firmware::frame::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Size(options) => size::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Measure(options) => measure::run(&options).map(|()| ExitCode::SUCCESS),
        Request::Test(options) => Ok(test::run(&options)),
    };
    outcome.unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        ExitCode::FAILURE
    })
}
