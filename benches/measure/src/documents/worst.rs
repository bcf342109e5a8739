//! The worst case of calls.

use super::memory;
use super::text::{cells, table};
use crate::c::{self, CALLS_COUNTED, SMALLEST};
use crate::record::{MOST, Record};

const ABOUT: &str = "
## Worst case of a call

The most instructions that a search found over any points, normals and colours, beside the mean of points in the light alone. It
climbs on instructions, counted exactly for each call, so these are lower bounds of the worst case; an upper bound is not
derived. In `fx16` a point near a light takes the fine evaluation after the coarse one. `luminaire pick --worst` chooses by such
figures. **In C** (`-O3`), with the means of the [page of C](../export/c/README.md#what-a-call-costs):

";

const RUST: &str = "
**In Rust**:

";

/// The tables of means and maxima.
pub(super) fn section(record: &Record) -> String {
    let smallest = record.group(SMALLEST);
    let count = |name: &str, unit| smallest.number(&c::figure(name), unit).map(|count| format!("{count:.0}"));
    let rows = CALLS_COUNTED.iter().filter_map(|(name, title)| {
        let (mean, most) = count(name, "instructions").zip(count(name, MOST))?;
        Some(vec![title.split(", of").next().unwrap_or(title).to_owned(), mean, most])
    });
    let mut text = ABOUT.to_owned() + &table(&cells(["call", "Cortex-M0, mean", "most"]), rows) + RUST;
    let heads = memory::heads(&["mean", "most"]);
    let rows = memory::rows(record, &["instructions", MOST]);
    text += &table(&[cells(["lit point"]), heads].concat(), rows);
    text
}
