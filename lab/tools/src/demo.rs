//! The browser demo: building its folder, and timing its frames.

mod shrink;
pub mod site;
pub mod turntable;
