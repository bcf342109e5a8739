//! Files for other tools.

mod gltf;
mod ies;
mod node;
mod scene;
mod usd;
pub use ies::ies;
pub use node::Entry;
pub use scene::{extension, scene};
