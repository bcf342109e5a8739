//! Runs a light of the kernel and the same light as exported C over the same inputs between the
//! markers, and prints a checksum of the results of each.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_firmware::entry!(luminaire_firmware::exported);
