//! The page `docs/ACCURACY-VS-COST.md`.

use super::figures;
use super::ladder;
use super::list::{Cost, Error, Place, PriceList, Row};
use super::target::Target;

/// The columns of the tables by format.
const FORMATS: [&str; 6] = ["fx16-quick", "fx16", "fx32", "f32-quick", "f32", "f64"];

const INTRODUCTION: &str = "\
# What accuracy costs

For one light on one chip with one display, ask:

```sh
cargo run -q --bin luminaire -- pick --chip cortex-m0 --display rgb565 --steps 1 --edge soft --field 36
```

The answer is the cheapest evaluation whose error is small enough, with its instructions, cycles and bytes, a bound of the
error, the place where it is largest, and the code to compile. This page has the prices behind it: first which evaluation is
good enough for which display, then how all is measured, then each processor with its front, its table and every row.

`cargo xtask measure` writes this page, its pictures and the price list behind them,
[accuracy-vs-cost.json](accuracy-vs-cost.json). A row has an address, such as
[`#cortex-m0.lit.fx16`](#cortex-m0.lit.fx16): the target, the kernel and the format.
";

const MEASUREMENT: &str = "
## How it is measured

Errors and costs are of the same functions, which are the crate
[`luminaire-kernels`](../benches/kernels/src/lib.rs): firmware, host and browser run them, and the same bits come out everywhere.

**Errors** are the largest difference from f64 in linear codes, 1/255 of full scale; half a code is
visible on a display. A kernel gets the nearest input of its format, so the rounding of the input is
part of the error. *Exhaustive* errors are bounds: the 16-bit ramp is constant over intervals of
versines, the exact value is monotone, and both ends of every interval of the cone are tried. The
others are *searched*: the largest of 262,144 angles, or of 65,536 points at incidences up to 80°,
hence lower bounds. All are the same in every run. Each kernel is compared with its own model: `powf` with the power of the cosine,
`gltf` with the formula without its `max(0.001, ...)`.

**Costs** on microcontrollers are instructions a call, counted exactly under QEMU as
[benches/firmware/README.md](../benches/firmware/README.md) describes. They are not cycles. Cycles are those of
the core of an RP2040, a Cortex-M0+, which rp2040js runs without wait states; it executes as many
instructions as QEMU counts, in every kernel. On the host and in the
browser costs are nanoseconds a call, over a batch of 4096 inputs from memory to memory: the median of
41 samples, in the best of three rounds. They depend on the machine and its other work, and nothing
fails because of them. \"powf\" is how many calls cost as much as one power function, that of libm on
microcontrollers and of the platform elsewhere. Bytes are the code of all functions that a call
executes, without constant tables such as those of roots and the 1024 bytes of `table-256`.

| stage | from | to |
|---|---|---|
| falloff | the versine of the angle off axis, in registers; for rivals its cosine | an intensity |
| lit | a point and a normal, in the cone and facing the light | the light that arrives: a soft edge and Lambert's cosine |
| lit-inverse-square | the same | and the inverse square of the distance |
| lit-specular | the same | and Phong's highlight of shininess 32, the direction to the eye included |
| away, outside | the same, facing away, or outside the cone | zero, by an early-out before the root |

`fx16-quick` and `f32-quick` are the [quick evaluations](NUMERICS.md#the-quick-evaluation).
`f64` reads points of f32. `powf-libm`, `powf-micromath` and `powf-std` are the power of the cosine by the crates libm and
micromath, of the versions in `Cargo.lock`, and by the standard library; `table-256` is the same by
interpolation in 256 entries, `schlick` by Schlick's rational function; `smoothstep` is GLSL's, `gltf` the specification's
code. `clamp` is a loop that does next to nothing.
";

/// Writes the page.
pub(super) fn write(list: &PriceList) -> String {
    let mut text = INTRODUCTION.to_owned() + &ladder::write(list) + MEASUREMENT;
    for target in list.targets() {
        text += &section(list, &target);
    }
    text += &errors(list);
    text + &key(list)
}

fn section(list: &PriceList, target: &Target) -> String {
    let title = target.title();
    let mut text = format!("\n## {title}\n\n![Error against cost: {title}]({})\n\n", target.picture());
    if let Some(meta) = list.meta.targets.get(target.name()) {
        text += &format!("{}; {}, `{}`; {}.", meta.runs_on, meta.compiler, meta.flags, meta.measured);
        text += "\n\n";
    }
    text += &format!("{}, by format:\n\n", capitalised(target.unit()));
    text += &by_format(list, |row| Some(figures::cost(row.cost.get(target.name())?.amount())));
    text += "\n<details><summary>Every row</summary>\n\n";
    text += match target {
        Target::Board(_) if has_cycles(list, target) => {
            "| kernel | format | error, codes | instructions | RP2040, cycles | powf | bytes of code |\n\
             |---|---|---|---|---|---|---|\n"
        }
        Target::Board(_) => {
            "| kernel | format | error, codes | instructions | powf | bytes of code |\n\
             |---|---|---|---|---|---|\n"
        }
        _ => {
            "| kernel | format | error, codes | ns | quartiles | powf |\n\
             |---|---|---|---|---|---|\n"
        }
    };
    for row in &list.rows {
        text += &priced(row, target).unwrap_or_default();
    }
    text + "\n</details>\n"
}

/// Whether cycles are on record for a target.
fn has_cycles(list: &PriceList, target: &Target) -> bool {
    let mut costs = list.rows.iter().filter_map(|row| row.cost.get(target.name()));
    costs.any(|cost| matches!(cost, Cost::Counted { cycles: Some(_), .. }))
}

fn capitalised(word: &str) -> String {
    match word {
        "ns" => "Nanoseconds a call".to_owned(),
        _ => "Instructions a call".to_owned(),
    }
}

fn priced(row: &Row, target: &Target) -> Option<String> {
    let error = row.error.as_ref().map_or_else(String::new, |error| figures::error(error.codes));
    let cost = match *row.cost.get(target.name())? {
        Cost::Counted { instructions, cycles, ratio_to_powf } => {
            let bytes = row.bytes.get(target.name()).map_or_else(String::new, u64::to_string);
            let cycles = cycles.map_or_else(String::new, |cycles| format!("{cycles:.2} | "));
            format!("{instructions:.2} | {cycles}{} | {bytes}", figures::cost(ratio_to_powf))
        }
        Cost::Timed { ns, ns_quartiles: [lower, upper], ratio_to_powf } => {
            format!("{ns:.3} | {lower:.3} to {upper:.3} | {}", figures::cost(ratio_to_powf))
        }
    };
    let address = format!("{}.{}", target.name(), row.name());
    Some(format!("| <a id=\"{address}\"></a>{} | {} | {error} | {cost} |\n", row.kernel, row.format))
}

/// A table of the project's kernels by format, then one line with the rivals.
fn by_format(list: &PriceList, cell: impl Fn(&Row) -> Option<String>) -> String {
    let mut text = format!(
        "| | {} |\n|---|{}\n",
        FORMATS.map(|f| format!("`{f}`")).join(" | "),
        "---|".repeat(FORMATS.len())
    );
    let mut kernels: Vec<&str> = Vec::new();
    for row in list.rows.iter().filter(|row| row.format != "rival") {
        if !kernels.contains(&row.kernel.as_str()) {
            kernels.push(&row.kernel);
        }
    }
    for kernel in kernels {
        let cells =
            FORMATS.map(|format| list.row(&format!("{kernel}.{format}")).and_then(&cell).unwrap_or_default());
        text += &format!("| {kernel} | {} |\n", cells.join(" | "));
    }
    let rivals = list.rows.iter().filter(|row| row.format == "rival");
    let rivals: Vec<_> = rivals.filter_map(|row| Some((row.kernel.as_str(), cell(row)?))).collect();
    let (names, cells): (Vec<_>, Vec<_>) = rivals.into_iter().unzip();
    text + &format!(
        "\n| {} |\n|{}\n| {} |\n",
        names.join(" | "),
        "---|".repeat(names.len()),
        cells.join(" | ")
    )
}

fn errors(list: &PriceList) -> String {
    let narrower: Vec<_> = list.rows.first().map_or_else(Vec::new, |row| {
        row.narrower.iter().map(|cone| format!(" | {}°", cone.half_angle)).collect()
    });
    let mut text = format!(
        "\n## Errors\n\nOf a cone with an outer half angle of {:.1}°, in codes of 8 bits and in units of the format's last \
         place of one; then the largest, in codes, of narrower cones. A format that does not hold a cone refuses it, and \
         says from which half angle on it would not.\n\n\
         | kernel | format | largest | in last places | where | mean | 99.9 % | |{}  |\n\
         |---|---|---|---|---|---|---|---|{}\n",
        list.meta.half_angle,
        narrower.concat().trim_start_matches(" |"),
        "---|".repeat(narrower.len())
    );
    for row in &list.rows {
        let Some(error) = &row.error else { continue };
        let narrower = row.narrower.iter().map(|cone| match (&cone.error, cone.narrowest) {
            (Some(error), _) => format!(" {} |", figures::error(error.codes)),
            (None, narrowest) => format!(" from {:.2}° |", narrowest.unwrap_or_default()),
        });
        text += &format!(
            "| {} | {} | {} | {} | {} | {} | {} | {} |{}\n",
            row.kernel,
            row.format,
            figures::error(error.codes),
            figures::error(error.lsb),
            place(error),
            figures::error(error.mean_codes),
            figures::error(error.p999_codes),
            error.kind,
            narrower.collect::<String>()
        );
    }
    text
}

fn place(error: &Error) -> String {
    match error.at {
        None => String::new(),
        Some(Place { degrees_off_axis, distance: Some(distance), degrees_of_incidence }) => format!(
            "{degrees_off_axis:.1}°, distance {distance:.1}, incidence {:.0}°",
            degrees_of_incidence.unwrap_or_default()
        ),
        Some(Place { degrees_off_axis, .. }) => format!("{degrees_off_axis:.1}°"),
    }
}

fn key(list: &PriceList) -> String {
    format!(
        "\n## The price list\n\n[accuracy-vs-cost.json](accuracy-vs-cost.json) has an object `meta` and a line for each of \
         {} rows.\n\n\
         | key | what it is |\n|---|---|\n\
         | `meta.half_angle` | the outer half angle in degrees that `error` and `cost` are of |\n\
         | `meta.targets` | by target: compiler, flags, what it runs on, the reference of `ratio_to_powf`, the day |\n\
         | `kernel`, `stage`, `format` | the name of a row; `stage` is `falloff` or `lit` |\n\
         | `error.codes`, `error.lsb` | the largest error, in 1/255 and in units of the last place of one |\n\
         | `error.at` | where that is: `degrees_off_axis`, and for points `distance` and `degrees_of_incidence` |\n\
         | `error.mean_codes`, `error.p999_codes` | the mean, and what 99.9 % of evenly spread inputs do not exceed |\n\
         | `error.kind` | `exhaustive` or `searched` |\n\
         | `narrower` | by `half_angle` in degrees: an `error`, or the `narrowest` half angle that the format holds |\n\
         | `cost` | by target: `instructions`; or `ns` with `ns_quartiles`; `ratio_to_powf` is how many calls have the price of one power |\n\
         | `bytes` | by target: bytes of code, of all functions that a call executes |\n\
         | `ladder` | by evaluation, `edge` and `half_angle`: the largest `errors` of a lit point in linear `codes` and in display steps, `rgb565` and `rgb888`; none if refused |\n\n\
         `cargo xtask measure --check`, which `cargo xtask full` runs too, measures errors, instructions and bytes again and fails \
         with the name of a row whose figures differ. Instructions of another compiler than the list's may differ by 5 %. \
         `cargo xtask measure --bless` accepts what is measured.\n",
        list.rows.len()
    )
}
