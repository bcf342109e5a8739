//! The irradiance of a spotlight with a table of 16 samples for an edge: Lambert's cosine, no fall with distance.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_effects::program!(luminaire_effects::effects::spot_table_lambert);
