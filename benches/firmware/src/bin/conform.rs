//! Checks the conformance vectors. The program reads them line by line from a file of the machine
//! that runs the emulator, because the whole file would not fit into the flash of the smallest
//! board.
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::fmt;

use luminaire_conform::Check;
use luminaire_firmware::board::println;
#[cfg(target_os = "none")]
use semihosting::{fs::File, io::Read, print};
#[cfg(not(target_os = "none"))]
use std::{fs::File, io::Read, print};

luminaire_firmware::entry!(conform);

/// Size of the line buffer in bytes: more than the longest line.
const ROOM: usize = 1024;

/// Prints the lines that differ.
struct Console;

impl fmt::Write for Console {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        print!("{text}");
        Ok(())
    }
}

fn conform() {
    let mut file = open();
    let mut check = Check::default();
    let (mut bytes, mut length) = ([0; ROOM], 0);
    loop {
        let read = file.read(&mut bytes[length..]).expect("the file can be read");
        length += read;
        while let Some(end) = bytes[..length].iter().position(|byte| *byte == b'\n') {
            let line = core::str::from_utf8(&bytes[..end]).expect("the file is text");
            check.take(line, &mut Console).expect("the console takes what is written");
            bytes.copy_within(end + 1..length, 0);
            length -= end + 1;
        }
        if read == 0 {
            break;
        }
    }
    println!("{check}");
}

/// Opens the file, which is in the folder that the emulator was started in.
#[cfg(target_os = "none")]
fn open() -> File {
    File::open(c"vectors.txt").expect("the file is there")
}

#[cfg(not(target_os = "none"))]
fn open() -> File {
    File::open("vectors.txt").expect("the file is there")
}
