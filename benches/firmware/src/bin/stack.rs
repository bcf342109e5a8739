//! Prints the stack of a call of each effect, and the bytes of what a program holds in memory.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_firmware::entry!(luminaire_firmware::stack);
