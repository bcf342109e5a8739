//! Runs lit points by every evaluation over their inputs between the markers, and prints a checksum of their
//! results.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_firmware::entry!(luminaire_firmware::evaluations);
