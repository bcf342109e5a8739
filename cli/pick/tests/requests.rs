//! Requests at random: the error of every answer is within its bound.

use luminaire_oracle::SplitMix64;
use luminaire_pick::{Chip, Display, Request, Tolerance, measure};

/// The number of requests, and how many times the points of an answer are searched.
fn length() -> (u64, usize) {
    if std::env::var_os("LUMINAIRE_FULL").is_some() { (1_000, 4) } else { (40, 3) }
}

#[test]
fn error_of_random_requests_is_within_the_bound() {
    let (count, effort) = length();
    let (mut answers, mut most) = (0, 0.0_f64);
    for number in 0..count {
        // Other lights than those from which the margin was measured.
        let mut random = SplitMix64(0x5eed_0000_0000 + number);
        let light = measure::random_light(&mut random);
        let chip = Chip::ALL[random.below(4) as usize];
        let display = Display::ALL[random.below(2) as usize];
        let amount = 10_f64.powf(random.between(-1.5, 0.7));
        let tolerance = if number % 4 == 0 { Tolerance::Codes(amount) } else { Tolerance::Steps(amount) };
        let Ok(answer) = Request::new(chip, display).tolerance(tolerance).pick(&light) else { continue };
        assert!(answer.bound.value <= amount, "{answer:?}");
        let found = measure::found(&answer, number + 1, effort).expect("the light of an answer");
        assert!(found <= answer.bound.value, "found {found}: {answer:?}");
        most = most.max(found / answer.bound.value);
        answers += 1;
    }
    println!("{answers} answers to {count} requests: the largest error is {most:.3} of its bound");
    assert!(answers > count * 3 / 4, "only {answers} answers to {count} requests");
}
