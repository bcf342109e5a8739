//! The exhibits, in the order of a visit.

mod aurora;
mod embedded_3dgfx;
mod filament_lumens;
mod gltf;
mod godot_cutoff;
mod godot_rim;
mod learn_opengl;
mod micromath_power;
mod open_fixture_library;
mod pow_zero;
mod three_cosine;
mod three_ies;
mod tinygl;

// What the exhibits are built of; each has these names from here.
use crate::{
    beam::Beam,
    exhibit::{Bounds, Control, Exhibit, Source},
    formula::{clamped_span, glsl_pow, smoothstep},
    view::View,
};
use luminaire::{
    Cone, Error, HalfAngle,
    falloff::{Hard, Linear, Smooth, Soft, Step},
};
use luminaire_oracle::{self as oracle, hard, linear, smooth, soft, step};

/// Every exhibit.
pub const ALL: [Exhibit; 13] = [
    gltf::EXHIBIT,
    three_cosine::EXHIBIT,
    learn_opengl::EXHIBIT,
    embedded_3dgfx::EXHIBIT,
    micromath_power::EXHIBIT,
    pow_zero::EXHIBIT,
    godot_rim::EXHIBIT,
    godot_cutoff::EXHIBIT,
    aurora::EXHIBIT,
    tinygl::EXHIBIT,
    three_ies::EXHIBIT,
    filament_lumens::EXHIBIT,
    open_fixture_library::EXHIBIT,
];
