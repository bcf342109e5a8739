//! The answers of `luminaire pick` that the program `picked` runs.

use luminaire_pick::{Answer, Chip, Display, Refusal, Request, measure};

/// Number of answers.
pub(crate) const COUNT: usize = 20;

/// Returns answers to random requests for the smallest chip, with cones of up to 120 degrees.
pub(crate) fn all() -> Result<Vec<Answer>, Refusal> {
    let mut answers = Vec::new();
    for seed in 77_000.. {
        let mut random = luminaire_oracle::SplitMix64(seed);
        let light = measure::random_light(&mut random);
        let display = Display::ALL[random.below(2) as usize];
        let steps = [0.25, 0.5, 1.0, 2.0][random.below(4) as usize];
        // One in four of a chip with floats, so that there are answers in each format.
        let chip = if seed % 4 == 0 { Chip::CortexM4f } else { Chip::CortexM0 };
        let Ok(answer) = Request::new(chip, display).steps(steps).pick(&light) else { continue };
        if answer.outer <= 120.0 {
            answers.push(answer);
        }
        if answers.len() == COUNT {
            break;
        }
    }
    Ok(answers)
}
