//! Files for other tools.

mod ies;
pub use ies::ies;
