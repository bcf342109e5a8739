//! What the tests share: the table of error bounds, the sweeps, the exact view of a format. The
//! truth is the crate `luminaire-oracle`.
#![allow(missing_docs, missing_debug_implementations, reason = "tests are read, not published")]

pub mod arbitrary;
pub mod beams;
pub mod beams_picture;
pub mod bounds;
pub mod critical;
pub mod cubics;
pub mod every;
pub mod falloffs;
pub mod format;
pub mod gobos;
pub mod haze;
pub mod haze16;
pub mod imports;
pub mod in_scattering;
pub mod limits;
pub mod operations;
pub mod originals;
pub mod prices;
pub mod region;
pub mod shadows;
pub mod shapes;
pub mod squares;
pub mod sweep;
pub mod views;
pub mod worst;

pub use luminaire_oracle as oracle;
