//! Runs the lights that `luminaire pick` answered with at random points, and prints a checksum of
//! the results of each.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_firmware::entry!(luminaire_firmware::picked);
