//! The encoding for the display against IEC 61966-2-1.

mod support;

use luminaire::{decode_srgb, encode_srgb};
use support::reference;

/// Every code decodes to a linear value that encodes to it again, within the stated error of the standard.
#[test]
fn every_code_comes_back() {
    let mut worst = 0.0_f64;
    for code in 0..=255 {
        let linear = decode_srgb(code);
        assert_eq!(encode_srgb(linear), code);
        worst = worst.max((f64::from(linear) - reference::srgb_linear(code.into())).abs());
    }
    assert!((1e-6..=2e-6).contains(&worst), "largest error {worst:.2e}");
}

/// A code is the nearest one, but for values whose exact code is within 0.002 of halfway between two.
#[test]
fn codes_are_the_nearest() {
    let (mut worst, mut count) = (0.0_f64, 0_u32);
    let steps = 4_000_000_u32;
    for linear in (0..=steps).map(|i| i as f32 / steps as f32) {
        let exact = reference::srgb_code(linear.into());
        worst = worst.max((f64::from(encode_srgb(linear)) - exact).abs());
        count += u32::from(f64::from(encode_srgb(linear)) != (exact + 0.5).floor());
    }
    assert!((0.5005..=0.502).contains(&worst), "largest distance from the exact code {worst:.5}");
    assert!(count > 0 && count < steps / 250, "{count} of {steps} round the other way");
}

#[test]
fn codes_never_fall() {
    let codes = (0..=2_000_000).map(|i| encode_srgb(i as f32 / 2_000_000.0));
    assert!(codes.is_sorted());
}

#[test]
fn values_beyond_the_display_are_clipped() {
    let clipped = [-1.0, -0.0, f32::NAN, f32::NEG_INFINITY, 1.0, 2.0, f32::INFINITY].map(encode_srgb);
    assert_eq!(clipped, [0, 0, 0, 0, 255, 255, 255]);
}
