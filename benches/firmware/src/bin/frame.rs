//! A picture of 160 x 120 pixels, lit pixel by pixel: prints its rows, as hexadecimal digits of
//! RGB565.
#![cfg_attr(target_os = "none", no_std, no_main)]

luminaire_firmware::entry!(luminaire_firmware::frame::frame);
