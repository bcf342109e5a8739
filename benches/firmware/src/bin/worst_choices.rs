//! Runs each lit point with one model of the lists at the points of a search, each between markers of its own.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_firmware::entry!(luminaire_firmware::worst::choices);
