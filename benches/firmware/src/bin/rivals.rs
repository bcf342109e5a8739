//! Runs the lit points of others over their inputs between the markers, and prints a checksum of the results of
//! each.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_firmware::entry!(luminaire_firmware::rivals);
