//! Runs lit points with one model each of the library's lists over their inputs between the markers, and prints a
//! checksum of their results.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_firmware::entry!(luminaire_firmware::choices);
