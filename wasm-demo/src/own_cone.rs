//! A cone as text of an address: that of a light of a file.

use crate::decimal;
use luminaire::Cone;
use luminaire::falloff::{AnyFalloff, Knot, Table};
use luminaire_export::words;
use std::cell::RefCell;

thread_local! {
    /// What was read, by its text: a job is read for each picture, and a table lives as long as the program.
    static READ: RefCell<Vec<(String, Cone<AnyFalloff>)>> = const { RefCell::new(Vec::new()) };
}

/// Writes the name of a falloff, the three versines of its cone and its parameters, with `/` between them.
pub(crate) fn write(cone: &Cone<AnyFalloff>) -> String {
    let (name, parameters) = words::described(&cone.falloff());
    let parameter = |number: f64| match number as i32 {
        // The slope of a knot has more bits than an `f32`.
        whole if f64::from(whole) == number => format!("/{whole}"),
        _ => format!("/{}", number as f32),
    };
    let parameters: String = parameters.into_iter().map(parameter).collect();
    format!("{name}/{}{parameters}", decimal::numbers(&cone.versines()))
}

/// Reads what [`write`] writes. As [`words::falloff`], but without its messages in the page's first module.
pub(crate) fn read(text: &str) -> Option<Cone<AnyFalloff>> {
    if let Some(cone) =
        READ.with_borrow(|read| read.iter().find(|(own, _)| own == text).map(|(_, cone)| *cone))
    {
        return Some(cone);
    }
    let mut parts = text.split('/');
    let name = parts.next()?;
    let mut number = || decimal::read(parts.next()?);
    let versines = [number()?, number()?, number()?];
    let falloff = match name {
        "table" => {
            let samples = parts.by_ref().map(|part| part.parse().ok()).collect::<Option<Vec<_>>>()?;
            Table::new(samples.leak()).ok()?.into()
        }
        "knots" => {
            let mut knots = Vec::new();
            while let Some(place) = parts.next() {
                let [value, slope] = [parts.next()?, parts.next()?];
                knots.push(Knot::from_bits(place.parse().ok()?, value.parse().ok()?, slope.parse().ok()?));
            }
            Table::from_knots(knots.leak()).ok()?.into()
        }
        _ => {
            let row = AnyFalloff::LIST.iter().find(|row| row.name == name)?;
            let numbers = parts.by_ref().take(row.numbers.len()).map(decimal::read);
            row.of(&numbers.collect::<Option<Vec<_>>>()?).ok()?
        }
    };
    let cone = Cone::from_versines(falloff, versines).ok().filter(|_| parts.next().is_none())?;
    READ.with_borrow_mut(|read| read.push((text.to_owned(), cone)));
    Some(cone)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each falloff with the numbers at their ends, and with those that may be left out.
    #[test]
    fn every_falloff_comes_back() {
        for row in AnyFalloff::LIST {
            let mut count = 0;
            for choice in 0..9 {
                let numbers: Vec<_> = row
                    .numbers
                    .iter()
                    .enumerate()
                    .map(|(place, number)| {
                        let ends = [number.limits[0], number.sample, number.limits[1]];
                        ends[choice / 3_usize.pow(place as u32) % 3]
                    })
                    .collect();
                let Ok(falloff) = row.of(&numbers) else { continue };
                let cone = Cone::from_versines(falloff, [0.1, 0.5, 0.4]).unwrap();
                assert_eq!(read(&write(&cone)), Some(cone), "{}", write(&cone));
                count += 1;
            }
            assert!(count > 0, "{}", row.name);
        }
    }
}
