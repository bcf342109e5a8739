//! Measures how far a search of 30 times the points exceeds the search of a request.
//!
//! `cargo run --release -p luminaire-pick --example margin -- 3000` prints the largest ratio over
//! as many random requests.

use luminaire_pick::measure;

fn main() {
    let count = std::env::args().nth(1).and_then(|word| word.parse().ok()).unwrap_or(100);
    let most = measure::margins(count, |ratio, light, evaluation| {
        if ratio > 1.35 {
            println!("{ratio:.3} {evaluation} {light:?}");
        }
    });
    println!("{count} requests: a search of 30 times the points finds up to {most:.3} times the error");
}
