//! The rows of the models in the library's lists.

use luminaire::dynamic::{Effect, Effects};
#[allow(clippy::wildcard_imports, reason = "the types of the lists")]
use luminaire::{attenuation::*, falloff::*, specular::*};

use crate::catalogue::{Entry, Visit};
use crate::input::Inputs;
use crate::listed::Listed;

// The build script writes the functions `falloffs`, `attenuations` and `lobes`, which visit the rows.
include!(concat!(env!("OUT_DIR"), "/models.rs"));
