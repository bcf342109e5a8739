//! Rows of a wall, drawables for two dimensions and a tree of LEDs: prints checksums.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_firmware::entry!(luminaire_firmware::drawn::drawn);
