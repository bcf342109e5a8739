//! What the tests share: the f64 reference, the table of error bounds, the sweeps, the exact view of a format.
#![allow(dead_code, reason = "each test binary uses its part of the support")]
#![allow(missing_docs, reason = "tests are read, not published")]
#![allow(unused_macros, unused_imports, reason = "each test binary uses its part of the support")]
#![allow(unreachable_pub, reason = "every test binary has these modules to itself")]

pub mod air_light;
pub mod arbitrary;
pub mod beams;
pub mod beams_picture;
pub mod bounds;
pub mod critical;
pub mod cubics;
pub mod every;
pub mod every_falloff;
pub mod format;
pub mod gobos;
pub mod haze;
pub mod imports;
pub mod limits;
pub mod operations;
pub mod originals;
pub mod prices;
pub mod profiles;
pub mod reference;
pub mod region;
pub mod shadows;
pub mod squares;
pub mod sweep;
pub mod views;
pub mod worst;
