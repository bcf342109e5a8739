//! The browser demo: as a folder that can be served, and how long its frames take.

mod shrink;
pub mod site;
pub mod turntable;
