//! Numbers from text and as text.
//!
//! The standard library's parser brings a table that hardly compresses, and that these few numbers do not need.

/// Reads a decimal number as [`f32`]'s `Display` writes it: no exponent, no infinity. A text of at
/// most 9 digits gives the nearest number, as the tests search; `None` if the text is no number or
/// beyond the largest.
pub(crate) fn read(text: &str) -> Option<f32> {
    /// More digits than these do not change the nearest number but at a tie.
    const DIGITS: u32 = 18;
    let (sign, digits) = text.strip_prefix('-').map_or((1.0, text), |digits| (-1.0, digits));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let is_number = !whole.is_empty() && (!fraction.is_empty() || whole.len() == digits.len());
    if !is_number || !(whole.bytes().chain(fraction.bytes())).all(|digit| digit.is_ascii_digit()) {
        return None;
    }
    let (mut mantissa, mut taken, mut exponent) = (0_u64, 0, 0_i32);
    let places = whole.bytes().map(|digit| (digit, 0)).chain(fraction.bytes().map(|digit| (digit, -1)));
    for (digit, shift) in places {
        if taken < DIGITS {
            mantissa = 10 * mantissa + u64::from(digit - b'0');
            taken += u32::from(mantissa > 0);
            exponent += shift;
        } else {
            exponent += 1 + shift;
        }
    }
    let power = 10_f64.powi(exponent.abs().min(400));
    let value = if exponent < 0 { mantissa as f64 / power } else { mantissa as f64 * power };
    Some((sign * value) as f32).filter(|number| number.is_finite())
}

/// Writes the numbers of one value of an address.
pub(crate) fn numbers(values: &[f32]) -> String {
    values.iter().map(f32::to_string).collect::<Vec<_>>().join("/")
}

/// Reads what [`numbers`] writes.
pub(crate) fn read_numbers<const N: usize>(text: &str) -> Option<[f32; N]> {
    text.split('/').map(read).collect::<Option<Vec<_>>>()?.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_written_number_comes_back() {
        let mut random = fastrand::Rng::with_seed(5);
        for _ in 0..1_000_000 {
            let number = f32::from_bits(random.u32(..));
            if number.is_finite() {
                assert_eq!(read(&number.to_string()).map(f32::to_bits), Some(number.to_bits()), "{number}");
            }
        }
        for number in [0.0, -0.0, 1.0, f32::MAX, f32::MIN_POSITIVE, f32::from_bits(1)] {
            assert_eq!(read(&number.to_string()).map(f32::to_bits), Some(number.to_bits()), "{number}");
        }
    }

    #[test]
    fn a_text_of_few_digits_gives_the_nearest_number() {
        let mut random = fastrand::Rng::with_seed(6);
        for _ in 0..1_000_000 {
            let text = format!("{}.{}", random.u32(..10_000), random.u32(..100_000));
            assert_eq!(read(&text), text.parse().ok(), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_is_none() {
        for text in ["", "-", ".", "1.", ".5", "--1", "+1", "1e3", "NaN", "inf", "1.2.3", "1 ", "é", "٣"] {
            assert_eq!(read(text), None, "{text:?}");
        }
        assert_eq!(read(&"9".repeat(60)), None);
        assert_eq!(read(&format!("0.{}1", "0".repeat(60))), Some(0.0));
    }
}
