//! Conversions from and to the types of other crates, each by the feature of its name.

#[cfg(feature = "glam")]
pub mod glam;
