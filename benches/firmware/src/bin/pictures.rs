//! Lights the renderer's pictures again: prints how many pixels differ.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_firmware::entry!(luminaire_firmware::pictures::pictures);
