//! The prices by which `luminaire pick` chooses an evaluation: a part of the record, in its crate.

use anyhow::{Context, Result};

use crate::record::Record;
use crate::target::BOARDS;

/// The edges of the picker, and the names of their lit points on the price list.
const EDGES: [(&str, &str); 4] =
    [("cubic", "lit-cubic"), ("hard", "lit-hard"), ("quadratic", "lit-quadratic"), ("soft", "lit")];

/// The evaluations. Under a bright light `fx16` takes the fine evaluation at some points, so the picker
/// needs the price of both.
const EVALUATIONS: [&str; 5] = ["f32", "fx16", "fx16-fine", "fx16-quick", "fx32"];

/// Instructions, bytes, and cycles if they were counted, by board and by edge, attenuation and evaluation.
pub(super) fn prices(record: &Record) -> Result<String> {
    let mut boards = Vec::new();
    for board in &BOARDS {
        let group = record.group(board.name);
        let mut rows = Vec::new();
        for (edge, kernel) in EDGES {
            for attenuation in ["-inverse-square", ""] {
                for evaluation in EVALUATIONS {
                    let counted = match (attenuation, evaluation) {
                        ("-inverse-square", "fx16") => "fx16-coarse",
                        _ => evaluation,
                    };
                    let name = format!("{kernel}{attenuation}.{counted}");
                    let figure = |unit| group.number(&name, unit);
                    let (instructions, bytes) = figure("instructions")
                        .zip(figure("bytes"))
                        .with_context(|| format!("{name} is not on record on {}", board.name))?;
                    let cycles = figure("cycles").map_or("null".to_owned(), |cycles| cycles.to_string());
                    rows.push(format!(
                        "      \"{edge}{attenuation}.{evaluation}\": [{instructions:?}, {bytes}, {cycles}]"
                    ));
                }
            }
        }
        let compiler = group.about.get("compiler").map_or("", String::as_str);
        boards.push(format!(
            "  \"{}\": {{\n    \"compiler\": \"{compiler}\",\n    \"kernels\": {{\n{}\n    }}\n  }}",
            board.name,
            rows.join(",\n")
        ));
    }
    Ok(format!("{{\n{}\n}}\n", boards.join(",\n")))
}
