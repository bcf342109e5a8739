//! A real browser, driven over the DevTools protocol.
//!
//! The protocol's client is written here on a WebSocket and JSON. It needs only a handful of the
//! protocol's methods, and a crate with all of them would take longer to compile than the rest of
//! this program.

mod chromium;
mod devtools;
mod page;
mod probe;

pub use chromium::Chromium;
pub use page::Page;
