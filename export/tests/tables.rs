//! The tables in the files for C are those of the kernel.

use luminaire::codegen::{CodeTables, Tables};
use luminaire::display::threshold;
use luminaire_export::C_HEADERS;

/// The numbers of a table of C.
fn numbers(name: &str) -> Vec<u64> {
    let table = C_HEADERS.iter().find_map(|(_, text)| text.split_once(&format!(" luminaire_{name}[")));
    let (_, rest) = table.unwrap_or_else(|| panic!("no table {name}"));
    let (_, rest) = rest.split_once("LUMINAIRE_TABLE = {").expect("a table");
    let (body, _) = rest.split_once("};").expect("an end");
    let words = body.split([',', '{', '}', '(', ')', '\n', ' ']).filter(|word| *word != "UINT32_C");
    words.filter(|word| !word.is_empty()).map(|word| word.parse().expect("a number")).collect()
}

fn assert_table(name: &str, expected: impl IntoIterator<Item: Into<u64>>) {
    let expected: Vec<_> = expected.into_iter().map(Into::into).collect();
    assert_eq!(numbers(name), expected, "luminaire_{name}");
}

/// The lower code around the least light with these upper eight bits.
fn lower(codes: &CodeTables, place: u32) -> u32 {
    codes.lights.partition_point(|light| *light <= place << 16) as u32
}

fn assert_nearest(name: &str, codes: &CodeTables) {
    assert_table(&format!("nearest_{name}"), codes.thresholds.iter().copied().chain([1 << 14]));
    assert_table(&format!("lights_{name}"), [0].into_iter().chain(codes.lights.iter().copied()));
}

#[test]
fn tables_of_lights_are_those_of_the_kernel() {
    let Tables { inverse_square_roots, logarithms, powers, .. } = Tables::KERNEL;
    assert_table("inverse_square_roots", inverse_square_roots.iter().copied());
    assert_table("logarithms", logarithms.iter().flat_map(|(reciprocal, log)| [*reciprocal, *log]));
    assert_table("powers", powers.iter().copied());
    assert_table("log2", (0..128_u32).map(|n| n.checked_ilog2().unwrap_or(0)));
}

#[test]
fn tables_of_outputs_are_those_of_the_kernel() {
    let Tables { srgb, gammas, .. } = Tables::KERNEL;
    assert_table("thresholds", (0..64).map(|place| threshold(place % 8, place / 8)));
    // The largest start that no width of codes scales to more than its lower code.
    let fits = |place, start| {
        srgb.iter().all(|codes| (start * codes.lights.len() as u32) >> 8 <= lower(codes, place))
    };
    let start = |place| (0..256_u32).rfind(|start| fits(place, *start)).unwrap_or_default();
    assert_table("starts", (0..256).map(start));
    for codes in &srgb {
        let bits = codes.lights.len().count_ones();
        if bits > 1 {
            assert_nearest(&bits.to_string(), codes);
        }
        if bits.is_power_of_two() {
            let thresholds = codes.fine_thresholds.iter().copied().chain([1 << 30]);
            assert_table(&format!("grays_{bits}"), thresholds);
        }
    }
    for (codes, name) in gammas.iter().zip(["22", "28"]) {
        assert_table(&format!("starts_{name}"), (0..256).map(|place| lower(codes, place)));
        assert_nearest(name, codes);
    }
}
