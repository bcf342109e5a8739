//! Every reader of files takes any bytes: it returns lights or says what it expects.
#![no_main]

use libfuzzer_sys::fuzz_target;
use luminaire_exchange::{Reading, System, read};

fuzz_target!(|bytes: &[u8]| {
    for system in System::ALL {
        let _ = read("file", bytes, Some(*system), Reading::default());
    }
});
