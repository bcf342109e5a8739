//! The prices by which `luminaire pick` chooses an evaluation: a part of the record, in its crate.

use anyhow::{Context, Result};
use luminaire::attenuation::{AnyAttenuation, Attenuation, AttenuationVisitor, attenuations};
use luminaire::falloff::{AnyFalloff, FalloffVisitor, ListedFalloff, constant_falloffs};
use luminaire::models::Listed;

use crate::record::{Group, MOST, Record};
use crate::target::BOARDS;

/// The evaluations. Under a bright light `fx16` takes the fine evaluation at some points, so the picker
/// needs the price of both.
const EVALUATIONS: [&str; 5] = ["f32", "fx16", "fx16-fine", "fx16-quick", "fx32"];

/// The falloffs whose lit points are counted with the inverse square, too.
const WITH_INVERSE_SQUARE: [&str; 5] = ["soft", "hard", "quadratic", "cubic", "table"];

/// A lit point that the picker has a price of: its name there, and on the price list.
struct Priced {
    name: String,
    kernel: String,
}

/// The lit points of the picker: those with one model of the library's lists each, a falloff or an attenuation; some
/// pairs of models; and those of other lights than spotlights.
///
/// A name is that of the falloff in data and, if the light falls with the distance, those of the law and the window.
fn priced() -> Vec<Priced> {
    let models = Models::of_the_lists();
    let lit = |falloff: &str| if falloff == "soft" { "lit".to_owned() } else { format!("lit-{falloff}") };
    let mut priced: Vec<Priced> = Vec::new();
    let mut add = |name: String, kernel: String| {
        if priced.iter().all(|own| own.name != name) {
            priced.push(Priced { name, kernel });
        }
    };
    for (row, constant) in AnyFalloff::LIST.iter().zip(&models.falloffs) {
        add(row.name.to_owned(), lit(constant));
        if WITH_INVERSE_SQUARE.contains(&row.name) {
            add(format!("{}-inverse-square", row.name), format!("{}-inverse-square", lit(constant)));
        }
    }
    add("power-16".to_owned(), lit("power-16"));
    for row in AnyAttenuation::LIST {
        let mut counted = |model: &str, name: String| {
            if let Some((_, own)) = models.attenuations.iter().find(|(of, _)| same(of, model)) {
                add(name, format!("lit-{own}"));
            }
        };
        counted(row.law_type, format!("soft-{}", row.law));
        if let Some(window) = row.window {
            counted(row.type_name, format!("soft-{}-{window}", row.law));
        }
    }
    let godot = "inverted-real-power-decay-square";
    add(godot.to_owned(), lit(godot));
    add("outside".to_owned(), "outside".to_owned());
    add("point-inverse-square".to_owned(), "point".to_owned());
    add("measured-inverse-square".to_owned(), "measured".to_owned());
    add("directional".to_owned(), "directional".to_owned());
    priced
}

/// Whether two types are the same but for spaces, which `stringify!` writes around brackets.
fn same(a: &str, b: &str) -> bool {
    let letters = |text: &str| text.split_whitespace().collect::<String>();
    letters(a) == letters(b)
}

/// Returns the kernels of the price list that the picker needs.
pub(crate) fn kernels() -> impl Iterator<Item = String> {
    priced().into_iter().map(|priced| priced.kernel)
}

/// The names on the price list of the models that programs know when they are compiled.
#[derive(Default)]
struct Models {
    falloffs: Vec<&'static str>,
    /// Each type, as Rust writes it, and its name.
    attenuations: Vec<(&'static str, &'static str)>,
}

impl Models {
    fn of_the_lists() -> Self {
        let mut models = Self::default();
        constant_falloffs(&mut models);
        attenuations(&mut models);
        models
    }
}

impl FalloffVisitor for Models {
    fn falloff<P: ListedFalloff>(&mut self) {
        self.falloffs.push(P::NAME);
    }
}

impl AttenuationVisitor for Models {
    fn attenuation<A: Listed + Attenuation>(&mut self) {
        self.attenuations.push((A::TYPE, A::NAME));
    }
}

/// Instructions, bytes, and cycles and the most instructions if they were counted, by board, lit point and evaluation.
pub(super) fn prices(record: &Record) -> Result<String> {
    let mut boards = Vec::new();
    for board in &BOARDS {
        let group = record.group(board.name);
        let mut rows = Vec::new();
        for Priced { name, kernel } in priced() {
            for evaluation in EVALUATIONS {
                rows.extend(row(&group, &name, &kernel, evaluation).with_context(|| board.name)?);
            }
        }
        rows.sort();
        let compiler = group.about.get("compiler").map_or("", String::as_str);
        boards.push(format!(
            "  \"{}\": {{\n    \"compiler\": \"{compiler}\",\n    \"kernels\": {{\n{}\n    }}\n  }}",
            board.name,
            rows.join(",\n")
        ));
    }
    Ok(format!("{{\n{}\n}}\n", boards.join(",\n")))
}

/// Returns the line of a lit point by an evaluation; none for an evaluation that its light does not have.
fn row(group: &Group, name: &str, kernel: &str, evaluation: &str) -> Result<Option<String>> {
    // A kernel without attenuation, of a light within full scale, is coarse everywhere.
    let coarse = format!("{kernel}.fx16-coarse");
    let counted = match evaluation {
        "fx16" if group.figures.contains_key(&coarse) => coarse,
        _ => format!("{kernel}.{evaluation}"),
    };
    let lacks_one = match kernel {
        "directional" => ["fx16-quick", "fx16-fine"].contains(&evaluation),
        "outside" => evaluation != "fx16",
        "point" | "measured" => evaluation == "fx16-quick",
        _ => false,
    };
    if lacks_one {
        return Ok(None);
    }
    let figure = |unit| group.number(&counted, unit);
    let (instructions, bytes) = figure("instructions")
        .zip(figure("bytes"))
        .with_context(|| format!("{counted} is not on record: `cargo xtask measure --bless` counts it"))?;
    // The worst case is that of any light: this kernel's or that of a brighter one.
    let most = [&counted, &format!("{kernel}.{evaluation}")];
    let most = most.into_iter().filter_map(|name| group.number(name, MOST)).max_by(f64::total_cmp);
    let [cycles, most] =
        [figure("cycles"), most].map(|count| count.map_or("null".to_owned(), |count| count.to_string()));
    Ok(Some(format!("      \"{name}.{evaluation}\": [{instructions:?}, {bytes}, {cycles}, {most}]")))
}
