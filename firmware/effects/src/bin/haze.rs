//! The air light of a view ray through the beam of a spotlight in haze. It is f32 in every format.
#![cfg_attr(target_os = "none", no_std, no_main)]

use luminaire::ViewRay;
use luminaire_effects::constants::BEAM;

luminaire_effects::program!(|view: ViewRay| BEAM.air_light(&view));
