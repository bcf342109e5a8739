//! The page `docs/ACCURACY-VS-COST.md`, which answers, and the price list `docs/PRICES.md`.

use super::text::{cells, cost, error, table};
use super::{memory, rivals, worst};
use crate::ladder::{ANGLES, POINTS};
use crate::record::{Group, Record};
use crate::target::{BOARDS, Target};
use crate::timed::NARROWER;

/// The evaluations of a lit point.
const EVALUATIONS: [&str; 4] = ["fx16-quick", "fx16", "fx32", "f32"];
/// The columns of the tables by format.
const FORMATS: [&str; 5] = ["fx16-quick", "fx16", "fx32", "f32", "f64"];

const ANSWER: &str = "\
# What accuracy costs

For one light on one chip with one display, ask:

```sh
cargo run -q --bin luminaire -- pick --chip cortex-m0 --display rgb565 --steps 1 --edge soft --field 36
```

The answer is the cheapest evaluation whose bound is small enough, with its instructions, cycles and bytes, the derived bound,
the largest error that a search finds and its place, and the code to compile. `--worst` picks by the [most that a point
takes](PRICES.md#worst-case-of-a-call) in place of the mean. This page has the short answer for all of them:

- with a floating point unit take `f32`, which costs less and errs less;
- without one take `Fx16` for a soft edge on a small display (RGB565), by the quick evaluation where no surface is lit beyond
  full scale; for a hard edge, and for a display of 8 bits a channel, take `Fx32`.

## Which evaluation for which display

From which of seven half angles (1°, 3°, 5°, 15°, 22°, 45°, 80°) on a lit point errs at most one step of a display at every
brightness, and its instructions. A cell has two ends: the angle from which on the largest error *found* is at most one step,
and the one from which on the derived *bound* is.
";

const READING: &str = "
*Attenuated* means by the inverse square from 16 times full scale at a distance of 1, at distances from 1 to 7; the light is
clipped at full scale. The display encodes in sRGB; a step is 1/63 (the green channel of RGB565) or 1/255 (RGB888) after
encoding, before the rounding to steps. sRGB magnifies the errors of dark light 13 times, so a hard edge, which is steep where
it is dark, needs more than a soft one. An error is found by climbing by bits from random points, from grazing incidence, from
dark edges and from both ends of the distances; the bound holds at all of them. It also holds for a light at any place and with
any axis, where that of the search is at the origin and along a coordinate axis: so the bound of `f32`, which rounds least
there, is several times what is found. In a narrow cone or under a bright light, more points of `fx16` take its fine evaluation.
Without a floating point unit, `f32` takes the software floats of Rust; [others](PRICES.md#floats-in-software) take a third of
their instructions, and eight times those of `fx16`.
";

const RECORD: &str = "
## How it is measured

**Errors** are the largest difference from f64 in linear codes, 1/255 of full scale; half a code is visible on a
display. They are searched: the largest of 65,536 points and of climbs from the worst by bits, at incidences up to
90°, and up to 84° with a highlight. A kernel gets the nearest input of its format, so the rounding of the input is
part of the error.

**Costs** on microcontrollers are instructions a call, counted exactly under QEMU as
[benches/firmware/README.md](../benches/firmware/README.md) describes. The light is a constant of the program, as a
build script writes it; one that is made at run time is loaded from memory as well. On the host and in the browser costs
are nanoseconds a call, over a batch of 4096 inputs from memory to memory: the median of 41 samples, in the best of three
rounds. They depend on the machine, and nothing fails because of them.

[PRICES.md](PRICES.md) is the record: every kernel in every format on every target, the methods of others, and the errors in
narrower cones. [EFFECTS.md](EFFECTS.md) has what each effect adds to a lit point. The figures of both are in
[prices.json](prices.json), which `cargo xtask measure --bless` writes with these pages, and which
`cargo xtask measure --check` compares with what it measures.
";

/// The page with the answer.
pub(super) fn answer(record: &Record) -> String {
    let mut text = ANSWER.to_owned();
    for (suffix, title) in [("", ""), ("-inverse-square", ", attenuated")] {
        let heads = ["soft", "hard"]
            .iter()
            .flat_map(|edge| ["RGB565", "RGB888"].map(|display| format!("{edge}{title}, {display}")));
        let mut heads = [String::new()].into_iter().chain(heads).collect::<Vec<_>>();
        heads.extend(BOARDS.iter().map(|board| board.title.to_owned()));
        let rows = EVALUATIONS.map(|format| {
            let mut row = vec![format!("`{format}`")];
            for kernel in ["lit", "lit-hard"] {
                let name = format!("{kernel}{suffix}.{format}");
                row.extend(["rgb565", "rgb888"].map(|display| offered(record, &name, display)));
            }
            let price = |board| {
                record
                    .group(board)
                    .number(&format!("lit{suffix}.{format}"), "instructions")
                    .map_or_else(String::new, cost)
            };
            row.extend(BOARDS.iter().map(|board| price(board.name)));
            row
        });
        text += &format!("\n{}", table(&heads, rows));
    }
    text += READING;
    text += "\n<details><summary>The largest error found and the bound, in linear codes and, in brackets, in steps of \
             RGB565</summary>\n";
    for ((kernel, ..), title) in
        POINTS.into_iter().zip(["soft", "hard", "soft, attenuated", "hard, attenuated"])
    {
        let heads: Vec<_> =
            [title.to_owned()].into_iter().chain(ANGLES.map(|degrees| format!("{degrees}°"))).collect();
        let rows = EVALUATIONS.map(|format| {
            let cell = |degrees| {
                let group = record.group(&format!("steps at {degrees}"));
                let ends = |unit: &str| {
                    let end = |unit: &str| group.number(&format!("{kernel}.{format}"), unit).map(error);
                    Some(format!("{} to {}", end(unit)?, end(&format!("{unit}_bound"))?))
                };
                let errors = ends("codes").zip(ends("rgb565"));
                errors.map_or("refused".to_owned(), |(codes, steps)| format!("{codes} ({steps})"))
            };
            [format!("`{format}`")].into_iter().chain(ANGLES.map(cell)).collect()
        });
        text += &format!("\n{}", table(&heads, rows));
    }
    text + "\n</details>\n" + RECORD
}

/// From which half angle on every cone errs at most one step: by what is found, and by the bound.
fn offered(record: &Record, name: &str, display: &str) -> String {
    let from = |unit: &str| {
        let holds = |degrees: &&&str| {
            record.group(&format!("steps at {degrees}")).number(name, unit).is_some_and(|steps| steps <= 1.0)
        };
        let narrowest = ANGLES.iter().rev().take_while(holds).last();
        narrowest.map_or_else(|| "no".to_owned(), |degrees| format!("{degrees}°"))
    };
    format!("{} / {}", from(display), from(&format!("{display}_bound")))
}

const LIST: &str = "\
# The price list

`cargo xtask measure` writes this page of the [record](prices.json). [ACCURACY-VS-COST.md](ACCURACY-VS-COST.md) has the
answer, and says how errors and costs are measured.
";

const KERNELS: &str = "
## The kernels

| kernel | from | to |
|---|---|---|
| `soft` and the other falloffs | the versine of the angle off axis, in registers; for rivals its cosine | an intensity |
| `lit`, `lit-hard` and so on | a point and a normal, in the cone and facing the light | falloff and Lambert's cosine |
| `lit-inverse-square` | the same | and the inverse square of the distance |
| `lit-specular` | the same | and Phong's highlight of shininess 32, the direction to the eye included |
| `away`, `outside` | the same, facing away, or outside the cone | zero, by an early-out before the root |

`fx16-quick` is the [quick evaluation](NUMERICS.md#the-quick-evaluation) of `fx16`, `f64` the versine form in twice the width of
f32. The falloffs of others are in f32: `powf-libm` and `powf-std` are the power of the cosine by the crate libm, of the version in
`Cargo.lock`, and by the standard library; `table-256` is the same by interpolation in 256 entries; `gltf` is the specification's
code.

## Floats in software

On a processor without a floating point unit, `f32`, `f64` and the rivals in f32 take the software floats of Rust. They are the slowest
of three on a Cortex-M0. `lit-inverse-square-libgcc` is the lit point in [C](../benches/firmware/src/lit.c) by those of gcc (gcc
12.2, `-O3`): 25 multiplications, 13 additions and two comparisons. Arm's own
[routines](https://github.com/ARM-software/optimized-routines/tree/master/fp/armv6-m) are the fastest that we know: a
multiplication takes 46 instructions, where gcc's takes 118 and Rust's 114, an addition 45 and gcc's 68, and a lit point in C
took 1,733, where gcc's took 3,854 (measured once, elsewhere, for another text of the same light). The floats in the
boot ROM of an RP2040, which its SDK takes by default, are not counted. So a ratio between fixed point and floats on a Cortex-M0
is one to Arm's.
";

/// The price list.
pub(super) fn list(record: &Record) -> String {
    let mut text = LIST.to_owned() + &rivals::section(record) + KERNELS;
    text += &memory::section(record);
    text += &worst::section(record);
    let is_here = |target: &Target| !matches!(target, Target::Errors | Target::OfC(_));
    for target in Target::all().into_iter().filter(is_here) {
        let group = record.group(target.name());
        let what = if target.unit() == "ns" { "nanoseconds" } else { "instructions" };
        let facts: Vec<_> = group.about.values().map(String::as_str).collect();
        text += &format!("\n## {}: {what} a call\n\n{}.\n\n", target.title(), facts.join("; "));
        text += &by_format(record, &group, target.unit());
    }
    text + &errors(record)
}

/// A table of the project's kernels by format, then one line with the rivals.
fn by_format(record: &Record, group: &Group, unit: &str) -> String {
    let mut kernels: Vec<&str> = Vec::new();
    let errors = record.group("errors");
    for (kernel, format) in
        group.figures.keys().chain(errors.figures.keys()).filter_map(|name| name.split_once('.'))
    {
        let is_priced =
            FORMATS.contains(&format) && group.number(&format!("{kernel}.{format}"), unit).is_some();
        // The other rows are on the page of effects.
        let is_here =
            errors.figures.contains_key(&format!("{kernel}.fx16")) || kernel.starts_with("lit-hard");
        if is_priced && is_here && !kernels.contains(&kernel) {
            kernels.push(kernel);
        }
    }
    let price = |name: &str| group.number(name, unit).map_or_else(String::new, cost);
    let heads: Vec<_> =
        [String::new()].into_iter().chain(FORMATS.map(|format| format!("`{format}`"))).collect();
    let rows = kernels.iter().map(|kernel| {
        let prices = FORMATS.map(|format| price(&format!("{kernel}.{format}")));
        [vec![(*kernel).to_owned()], prices.into()].concat()
    });
    let rivals = group.figures.keys().filter_map(|name| name.strip_suffix(".rival"));
    let rivals: Vec<_> = rivals.filter(|name| !name.starts_with("lit-")).collect();
    let heads_of_rivals: Vec<_> = rivals.iter().map(|name| (*name).to_owned()).collect();
    let prices = rivals.iter().map(|name| price(&format!("{name}.rival"))).collect();
    format!("{}\n{}", table(&heads, rows), table(&heads_of_rivals, [prices]))
}

fn errors(record: &Record) -> String {
    let widest = record.group("errors");
    let mut heads = cells(["kernel", "format", "largest", "in last places", "where", "mean", "99.9 %", ""]);
    heads.extend(NARROWER.map(|degrees| format!("{degrees}°")));
    let rows = widest.figures.keys().filter_map(|name| {
        let (kernel, format) = name.split_once('.')?;
        let figure = |unit| widest.number(name, unit).map_or_else(String::new, error);
        let mut row =
            vec![kernel.to_owned(), format.to_owned(), figure("codes"), figure("lsb"), place(&widest, name)];
        row.extend([figure("mean_codes"), figure("p999_codes")]);
        row.push(widest.text(name, "kind").unwrap_or_default().to_owned());
        row.extend(NARROWER.map(|degrees| {
            let group = record.group(&format!("errors at {degrees}"));
            let refused = || {
                let narrowest = group.number(name, "narrowest_degrees");
                narrowest.map_or_else(String::new, |degrees| format!("from {degrees:.2}°"))
            };
            group.number(name, "codes").map_or_else(refused, error)
        }));
        Some(row)
    });
    format!(
        "\n## Errors\n\nOf the cone of a soft edge with a field angle of 36°, which ends at a half angle of 21.8°, in linear \
         codes of 8 bits and in units of the format's last place of one; then the largest, in codes, of narrower cones. A format \
         that does not hold a cone refuses it, and says from which half angle on it would not. *Exhaustive* errors are bounds: \
         the 16-bit ramp is constant over intervals of versines, the exact value is monotone, and both ends of every interval of \
         the cone are tried. The others are *searched*: the largest of 262,144 angles or 65,536 points, and of climbs from the worst by bits, hence \
         lower bounds; the bounds of lit points are in [ACCURACY-VS-COST.md](ACCURACY-VS-COST.md). \
         Each kernel is compared with its own model: `powf` with the power of the cosine, `gltf` with the formula without its \
         `max(0.001, ...)`.\n\n{}",
        table(&heads, rows)
    )
}

/// Where an error is largest.
fn place(group: &Group, name: &str) -> String {
    let figure = |unit| group.number(name, unit);
    let Some(degrees) = figure("degrees_off_axis") else { return String::new() };
    match figure("distance").zip(figure("degrees_of_incidence")) {
        Some((distance, incidence)) => {
            format!("{degrees:.1}°, distance {distance:.1}, incidence {incidence:.0}°")
        }
        None => format!("{degrees:.1}°"),
    }
}
