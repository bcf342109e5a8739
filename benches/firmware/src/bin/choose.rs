//! Runs each lit point whose price chooses an evaluation over its inputs between the markers, and
//! prints a checksum of its results.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_firmware::entry!(luminaire_firmware::choose);
