//! Frames of the stage in which its light moves: prints a checksum for each.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_firmware::entry!(luminaire_firmware::moving::moving);
