//! A cone as text of an address: that of a light of a file.

use crate::decimal;
use luminaire::{Cone, falloff::AnyFalloff};
use luminaire_export::words;
use std::cell::RefCell;

thread_local! {
    /// What was read, by its text: a job is read for each picture, and a table lives as long as the program.
    static READ: RefCell<Vec<(String, Cone<AnyFalloff>)>> = const { RefCell::new(Vec::new()) };
}

/// Writes the name of a falloff, the three versines of its cone and its parameters, with `/` between them.
pub(crate) fn write(cone: &Cone<AnyFalloff>) -> String {
    let (name, parameters) = words::described(&cone.falloff());
    let parameters: String = parameters.iter().map(|parameter| format!("/{parameter}")).collect();
    format!("{name}/{}{parameters}", decimal::numbers(&cone.versines()))
}

/// Reads what [`write`] writes.
pub(crate) fn read(text: &str) -> Option<Cone<AnyFalloff>> {
    READ.with_borrow_mut(|read| {
        let known = read.iter().find(|(own, _)| own == text).map(|(_, cone)| *cone);
        known.or_else(|| {
            let (name, numbers) = text.split_once('/')?;
            // The slope of a knot has more bits than an `f32`.
            let whole = |text: &str| text.parse::<i32>().ok().map(f64::from);
            let number = |text| whole(text).or_else(|| decimal::read(text).map(f64::from));
            let numbers: Vec<_> = numbers.split('/').map(number).collect::<Option<_>>()?;
            let (versines, parameters) = numbers.split_first_chunk()?;
            let falloff = words::falloff(name, parameters).ok()?;
            let cone = Cone::from_versines(falloff, versines.map(|versine: f64| versine as f32)).ok()?;
            read.push((text.to_owned(), cone));
            Some(cone)
        })
    })
}
