//! The sets of luminaire's features that are tested.

use std::iter;

use anyhow::{Context, Result};
use serde_json::Value;

use tools::command;

/// The smallest processor that is supported: it has no floating point unit, no division and no
/// atomics.
pub(crate) const BARE_METAL: &str = "thumbv6m-none-eabi";

/// The sets of luminaire's features that are supported on bare metal, as options of cargo.
pub(crate) const SETS: [(&str, &[&str]); 5] = [
    ("libm alone", &["--no-default-features", "--features", "libm"]),
    ("micromath alone", &["--no-default-features", "--features", "micromath"]),
    ("fixed alone", &["--no-default-features", "--features", "fixed"]),
    ("its default features", &[]),
    (
        "every feature without std",
        &[
            "--no-default-features",
            "--features",
            "arithmetic,bytemuck,defmt,embedded-graphics-core04,fixed,glam034,libm,micromath,mint05,native,serde",
        ],
    ),
];

pub(crate) const STD: (&str, &[&str]) = ("std alone", &["--no-default-features", "--features", "std"]);

pub(crate) const ALL: (&str, &[&str]) = ("all features", &["--all-features"]);

/// The features that luminaire's manifest names, without `default`, which only selects others.
pub(crate) fn names() -> Result<Vec<String>> {
    let metadata = command::answer(&mut command::cargo(["metadata", "--no-deps", "--format-version=1"]))?;
    let metadata: Value = serde_json::from_str(&metadata).context("cargo metadata is no JSON")?;
    let mut packages = metadata["packages"].as_array().into_iter().flatten();
    let luminaire = packages.find(|package| package["name"] == "luminaire");
    let features = luminaire.and_then(|package| package["features"].as_object());
    let names = features.context("cargo metadata has no features of luminaire")?.keys();
    Ok(names.filter(|name| *name != "default").cloned().collect())
}

/// Sets of features as options of cargo: none, each alone, each pair, and all.
pub(crate) fn pairs(features: &[String]) -> Vec<String> {
    let alone = features.iter().cloned();
    let pairs = features
        .iter()
        .enumerate()
        .flat_map(|(i, first)| features[i + 1..].iter().map(move |second| format!("{first},{second}")));
    iter::once(String::new()).chain(alone).chain(pairs).chain([features.join(",")]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bare_metal_is_promised_every_feature_but_std() {
        let mut features = names().unwrap();
        features.retain(|feature| feature != "std");
        assert_eq!(SETS.last().unwrap().1[2], features.join(","));
    }
}
