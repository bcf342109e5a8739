//! The laboratory: measures the kernel's errors, costs and bytes on every target, and compares them
//! with the figures on record.

pub mod boards;
pub mod c;
pub mod conform;
pub mod device;
pub mod effects;
pub mod frame;
pub mod pick;
pub mod prices;
mod record;
pub mod rivals;
pub mod size;
pub mod spotlights;
