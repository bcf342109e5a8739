//! The laboratory: what the kernel errs, costs and takes on every target, compared with the figures
//! on record.

pub mod boards;
pub mod conform;
pub mod effects;
pub mod frame;
pub mod prices;
mod record;
pub mod size;
