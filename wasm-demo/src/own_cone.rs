//! A cone as text of an address: that of a light of a file.

use crate::{decimal, edge};
use luminaire::Cone;
use luminaire::falloff::{
    AnyFalloff, Cubic, IntegerPower, InvertedIntegerPower, InvertedRealPower, Knot, Quadratic, RealPower,
    Table,
};
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
    let falloff = match edge::named(name) {
        Some(AnyFalloff::Quadratic(_)) => Quadratic::new(number()?).ok()?.into(),
        Some(AnyFalloff::Cubic(_)) => Cubic::with_slopes(number()?, number()?).ok()?.into(),
        Some(AnyFalloff::Power(_)) => IntegerPower::new(number()? as u32).ok()?.into(),
        Some(AnyFalloff::InvertedPower(_)) => InvertedIntegerPower::new(number()? as u32).ok()?.into(),
        Some(AnyFalloff::RealPower(_)) => RealPower::new(number()?).ok()?.into(),
        Some(AnyFalloff::InvertedRealPower(_)) => {
            InvertedRealPower::with_floor(number()?, number().unwrap_or_default()).ok()?.into()
        }
        Some(AnyFalloff::Table(_)) => {
            let samples = parts.by_ref().map(|part| part.parse().ok()).collect::<Option<Vec<_>>>()?;
            Table::new(samples.leak()).ok()?.into()
        }
        Some(plain) => plain,
        None if name == "knots" => {
            let mut knots = Vec::new();
            while let Some(place) = parts.next() {
                let [value, slope] = [parts.next()?, parts.next()?];
                knots.push(Knot::from_bits(place.parse().ok()?, value.parse().ok()?, slope.parse().ok()?));
            }
            Table::from_knots(knots.leak()).ok()?.into()
        }
        None => return None,
    };
    let cone = Cone::from_versines(falloff, versines).ok().filter(|_| parts.next().is_none())?;
    READ.with_borrow_mut(|read| read.push((text.to_owned(), cone)));
    Some(cone)
}
