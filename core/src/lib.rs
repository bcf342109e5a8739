//! A `no_std` lighting kernel.
#![no_std]
#![forbid(unsafe_code)]
