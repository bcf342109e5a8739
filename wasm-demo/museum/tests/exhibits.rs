//! Every exhibit is a regression test: its formula errs, and the crate does not.
//!
//! A picture of 100 x 100 pixels is compared at each of them. At the named case and where both
//! agree the errors are exhaustive over these pixels; over the rest of the control they are searched
//! at 41 values.

use luminaire_museum::{ALL, Control, Exhibit, Picture, Side};

/// Pixels on a side.
const SIZE: u32 = 100;

fn picture(exhibit: &Exhibit, value: f32) -> Picture {
    let beam = (exhibit.beam)(value).unwrap_or_else(|error| panic!("{} at {value}: {error}", exhibit.name));
    Picture::of(&beam, SIZE).unwrap_or_else(|error| panic!("{} at {value}: {error}", exhibit.name))
}

/// The largest error of a side in linear codes; infinite if a pixel is NaN.
fn worst(picture: &Picture, side: Side) -> f64 {
    let errors = picture.errors(side);
    if errors.undefined > 0 { f64::INFINITY } else { errors.largest }
}

/// Values from one end of a control to the other.
fn values(control: Control) -> impl Iterator<Item = f32> {
    let part = |i: u16| f32::from(i) / 40.0;
    (0..=40).map(move |i| {
        let value = if control.is_logarithmic {
            control.least * (control.most / control.least).powf(part(i))
        } else {
            control.least + (control.most - control.least) * part(i)
        };
        value.min(control.most)
    })
}

#[test]
fn named_cases_break_the_formula_and_not_the_crate() {
    for exhibit in &ALL {
        let picture = picture(exhibit, exhibit.control.start);
        let [faulty, ours] = [Side::Faulty, Side::Ours].map(|side| worst(&picture, side));
        println!("{:16} {faulty:10.3} codes, ours {ours:.4} in {}", exhibit.name, picture.format);
        let bounds = exhibit.bounds;
        assert!(faulty >= bounds.faulty, "{}: {faulty} is less than {}", exhibit.name, bounds.faulty);
        assert!(
            bounds.faulty.is_infinite() || bounds.faulty > 0.75 * faulty,
            "{}: {} is loose for {faulty}",
            exhibit.name,
            bounds.faulty
        );
        assert!(ours <= bounds.ours, "{}: {ours} passes {}", exhibit.name, bounds.ours);
    }
}

#[test]
fn ours_keeps_its_bound_over_the_whole_control() {
    for exhibit in &ALL {
        let (mut most, mut at) = (0.0, 0.0);
        for value in values(exhibit.control) {
            let picture = picture(exhibit, value);
            let mut errors = picture.errors(Side::Ours).codes;
            // At a step no format bounds the error of a pixel, and few pixels are that close.
            let steps = if exhibit.name == "equal-angles" { 5 } else { 0 };
            errors.sort_by(f32::total_cmp);
            let error = f64::from(errors[errors.len() - 1 - steps]);
            (most, at) = if error > most { (error, value) } else { (most, at) };
        }
        println!("{:16} ours {most:.4} at {at}", exhibit.name);
        assert!(most <= exhibit.bounds.ours, "{} at {at}: {most}", exhibit.name);
    }
}

#[test]
fn formulas_are_right_where_both_agree() {
    for exhibit in &ALL {
        let Some(value) = exhibit.agrees_at else { continue };
        let faulty = worst(&picture(exhibit, value), Side::Faulty);
        assert!(faulty <= 1.0, "{} at {value}: {faulty}", exhibit.name);
    }
}

#[test]
fn exhibits_are_told_in_full_and_by_different_names() {
    for (i, exhibit) in ALL.iter().enumerate() {
        assert!(ALL[..i].iter().all(|other| other.name != exhibit.name), "{}", exhibit.name);
        let source = exhibit.source;
        let texts = [exhibit.label, exhibit.title, exhibit.code, exhibit.cause, exhibit.no_better];
        let origin = [source.project, source.file, source.version, source.licence];
        assert!(texts.iter().chain(&origin).all(|text| !text.is_empty()), "{}", exhibit.name);
        let control = exhibit.control;
        let range = control.least..=control.most;
        assert!(range.contains(&control.start), "{}", exhibit.name);
        assert!(exhibit.agrees_at.is_none_or(|value| range.contains(&value)), "{}", exhibit.name);
        assert!(!control.is_logarithmic || control.least > 0.0, "{}", exhibit.name);
    }
}
