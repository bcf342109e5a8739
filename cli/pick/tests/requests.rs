//! Requests at random: the error of every answer is within its bound.

use luminaire::dynamic::AnyLight;
use luminaire_oracle::SplitMix64;
use luminaire_pick::{Attenuation, Chip, Display, Light, Request, Tolerance, measure};

/// The number of requests, and how many times the points of an answer are searched.
fn length() -> (u64, usize) {
    if std::env::var_os("LUMINAIRE_FULL").is_some() { (2_500, 4) } else { (60, 2) }
}

/// A random light; a quarter are bright, over long distances.
fn light(random: &mut SplitMix64) -> Light {
    let light = measure::random_light(random);
    if random.below(4) > 0 {
        return light;
    }
    let intensity = 10_f64.powf(random.between(1.0, 5.0)) as f32;
    let far = light.near * 20.0 * 150_f64.powf(random.between(0.0, 1.0)) as f32;
    Light { attenuation: Attenuation::InverseSquare, intensity, far, ..light }
}

/// Lights at the ends of all that is accepted, of which most are refused.
#[test]
fn error_of_requests_at_the_ends_is_within_the_bound() {
    let (count, effort) = length();
    let mut answers = 0;
    for number in 0..4 * count {
        let mut random = SplitMix64(0x0e2d_0000_0000 + number);
        let light = measure::light_anywhere(&mut random);
        let chip = Chip::ALL[random.below(Chip::ALL.len() as u64) as usize];
        let display = Display::ALL[random.below(Display::ALL.len() as u64) as usize];
        let amount = 10_f64.powf(random.between(-2.0, 3.0));
        let tolerance = if number % 4 == 0 { Tolerance::Codes(amount) } else { Tolerance::Steps(amount) };
        let Ok(answer) = Request::new(chip, display).tolerance(tolerance).pick(&light) else { continue };
        let found = measure::found(&answer, number + 1, effort / 2).expect("the light of an answer");
        assert!(found <= answer.bound.value && answer.bound.value <= amount, "found {found}: {answer:?}");
        answers += 1;
    }
    println!("{answers} answers to {} requests", 4 * count);
    assert!(answers > count, "only {answers} answers to {} requests", 4 * count);
}

/// Lights of any kind, with any falloff and any attenuation, by usual numbers and by the ends of what is accepted.
#[test]
fn error_of_any_light_is_within_the_bound() {
    let (count, effort) = length();
    let (mut answers, mut refused, mut kinds) = (0, 0, [0; 4]);
    for number in 0..4 * count {
        let mut random = SplitMix64(0xa11_0000_0000 + number);
        let Some(light) = measure::any_light_anywhere(&mut random) else { continue };
        let chip = Chip::ALL[random.below(Chip::ALL.len() as u64) as usize];
        let display = Display::ALL[random.below(Display::ALL.len() as u64) as usize];
        let amount = 10_f64.powf(random.between(-2.0, 3.0));
        let tolerance = if number % 4 == 0 { Tolerance::Codes(amount) } else { Tolerance::Steps(amount) };
        let Ok(answer) = Request::new(chip, display).tolerance(tolerance).pick(&light) else {
            refused += 1;
            continue;
        };
        let found = measure::found(&answer, number + 1, effort / 2).expect("the light of an answer");
        assert!(found <= answer.bound.value && answer.bound.value <= amount, "found {found}: {answer:?}");
        kinds[match light.light {
            Some(AnyLight::Spot(_)) | None => 0,
            Some(AnyLight::Point(_)) => 1,
            Some(AnyLight::Directional(_)) => 2,
            Some(AnyLight::Measured(_)) => 3,
        }] += 1;
        answers += 1;
    }
    println!("{answers} answers, {refused} refusals, to {} requests; {kinds:?} by kind", 4 * count);
    assert!(
        answers > 2 * count && kinds.iter().all(|kind| *kind > count / 8),
        "{answers} answers, {kinds:?}"
    );
}

#[test]
fn error_of_random_requests_is_within_the_bound() {
    let (count, effort) = length();
    let mut parts = Vec::new();
    for number in 0..count {
        let mut random = SplitMix64(0x5eed_0000_0000 + number);
        let light = light(&mut random);
        let chip = Chip::ALL[random.below(4) as usize];
        let display = Display::ALL[random.below(2) as usize];
        let amount = 10_f64.powf(random.between(-1.5, 0.7));
        let tolerance = if number % 4 == 0 { Tolerance::Codes(amount) } else { Tolerance::Steps(amount) };
        let Ok(answer) = Request::new(chip, display).tolerance(tolerance).pick(&light) else { continue };
        assert!(answer.bound.value <= amount, "{answer:?}");
        let found = measure::found(&answer, number + 1, effort).expect("the light of an answer");
        assert!(found <= answer.bound.value, "found {found}: {answer:?}");
        parts.push((answer.bound.value / found.max(answer.bound.found), answer));
    }
    parts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let answers = parts.len() as u64;
    let at = |part: f64| &parts[(part * (parts.len() - 1) as f64) as usize];
    println!(
        "{answers} answers to {count} requests: the bound is {:.2} times the largest error that is found for the \
         tightest, {:.2} for half of them, {:.2} for the loosest: {:?}",
        at(0.0).0,
        at(0.5).0,
        at(1.0).0,
        at(1.0).1
    );
    assert!(answers > count * 3 / 4, "only {answers} answers to {count} requests");
    // A bound that is far from all that is found would say little.
    assert!(at(0.5).0 < 2.5, "half of the bounds are over {:.2} times the error", at(0.5).0);
}
