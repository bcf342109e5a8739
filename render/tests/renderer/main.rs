//! What the renderer promises.

mod changes;
mod edges;
mod effects;
mod examples;
mod formats;
mod haze;
mod pictures;
mod refusals;
mod saving;
mod strip;
mod stripes;
