use super::{figure::Parameter::*, figures::code, *};
use luminaire::{
    Fx16, Rgb, Scalar,
    display::{Curve, Gray2, Gray4, Linear, Pixel, Srgb},
};
use luminaire_oracle::{DVec3, smooth, specular::phong, srgb_linear, versine};
use std::f64::consts::{FRAC_1_SQRT_2, PI};

fn opened(address: &str) -> Class {
    let mut class = Class::of(&ALL[2]).unwrap();
    assert_eq!(class.open(&format!("figure={address}")).unwrap(), "", "{address}");
    class
}

fn cosine(degrees: f64) -> f64 {
    degrees.to_radians().cos()
}

/// The whole angle whose half has this cosine, in degrees.
fn whole(cosine: f64) -> f64 {
    2.0 * cosine.acos().to_degrees()
}

/// The cosine of half of Hast's soft outer angle for a field angle, equation 8.
fn tau(field: f64) -> f64 {
    (cosine(field / 2.0) - 0.1_f64.sqrt()) / (1.0 - 0.1_f64.sqrt())
}

/// Beam angles for a field angle: soft (equation 9), hard (equations 15 and 16), and Warn's.
fn beams(field: f64) -> [f64; 3] {
    let (tau, sigma) = (tau(field), cosine(field / 2.0));
    let hard = 1.0 - (1.0 - sigma) / 0.9_f64.sqrt() * FRAC_1_SQRT_2;
    let warn = 0.5_f64.powf(sigma.ln() / 0.1_f64.ln());
    [(1.0 - tau) * FRAC_1_SQRT_2 + tau, hard, warn].map(whole)
}

/// Direct3D's ramp at an angle off the axis, between two half angles.
fn ramp(degrees: f64, inner: f64, outer: f64) -> f64 {
    (cosine(degrees) - cosine(outer)) / (cosine(inner) - cosine(outer))
}

/// The brightest light by the equation of all lights at places on the front of a ball.
fn brightest(parallels: u32, shininess: f64) -> f64 {
    let to_light = DVec3::new(0.62, 0.55, 1.0).normalize();
    let places = (0..=parallels).flat_map(|i| (0..2 * parallels).map(move |j| [i, j]));
    let light = |place: [u32; 2]| {
        let [(ring, y), (x, z)] = place.map(|i| (PI * f64::from(i) / f64::from(parallels)).sin_cos());
        let normal = DVec3::new(ring * x, y, ring * z);
        let facing = normal.dot(to_light).max(0.0);
        if normal.z < 0.0 {
            0.0
        } else {
            0.35 * (0.08 + facing) + 0.6 * phong(to_light, DVec3::Z, normal, shininess)
        }
    };
    places.map(light).fold(0.0, f64::max)
}

/// The largest error of the soft quadratic in integers of n bits, in steps.
fn in_integers(bits: u32) -> f64 {
    let error = |i: u64| {
        let (shift, t) = (bits - 2, ((i << (bits - 2)) + 32_768) >> 16);
        let light = (t * t + (1 << (shift - 1))) >> shift;
        (light as f64 - (i as f64 / 65_536.0).powi(2) * (1_u64 << shift) as f64).abs()
    };
    (0..=65_536).map(error).fold(0.0, f64::max)
}

#[test]
fn numbers_are_those_of_the_published_formulas() {
    let [top, sun] = [9.8_f64, 14.8].map(f64::sqrt);
    let spot = 1.0 - (1.0 - 11.8 / (top * sun)) / (1.0 - tau(44.0));
    let [c10, c20, hard] = [cosine(10.0), cosine(20.0), (1.0 - cosine(7.5)) / FRAC_1_SQRT_2];
    let direct3d = [whole(c20 + (c10 - c20) * 0.5_f64.cbrt()), ramp(15.0, 10.0, 20.0).powi(3)];
    let table: &[(&str, &[f64], f64)] = &[
        ("kinds&kind=ambient&height=8", &[0.3, 0.3], 1e-5),
        ("kinds&kind=directional", &[2.4 / sun, 2.4 / sun], 1e-5),
        ("kinds&kind=point", &[24.0 / top.powi(3), 0.75], 1e-5),
        ("kinds&kind=spot", &[24.0 / top.powi(3) * spot * spot, 0.0], 1e-4),
        ("attenuation&a=0.5&b=0.1&c=0.2", &[1.0, 1.0 / 4.1, (0.41_f64.sqrt() - 0.1) / 0.4], 1e-5),
        ("attenuation&a=0.5&b=0&c=0.003", &[1.0, 1.0, (0.5_f64 / 0.003).sqrt()], 1e-5),
        ("sphere&d=3", &[1.0 / 9.0, 36.0 * PI, 4.0 * PI], 1e-5),
        ("power&p=20&cutoff=30", &[whole(0.5_f64.powf(0.05)), cosine(29.97).powi(20)], 1e-4),
        ("cones&inner=10&outer=20&range=8", &[whole((c10 + c20) / 2.0) / 2.0, smooth(0.25)], 1e-4),
        ("direct3d&theta=20&phi=40&falloff=3", &direct3d, 1e-4),
        ("edges&field=40", &beams(40.0), 1e-4),
        ("beam-field&given=soft-field", &[beams(15.0)[0], 15.0, whole(tau(15.0))], 1e-4),
        ("beam-field&given=hard-beam", &[15.0, whole(1.0 - hard * 0.9_f64.sqrt()), whole(1.0 - hard)], 1e-4),
        ("both", &[7.0, 15.0, whole(0.0), versine(7.5) / versine(3.5), 19.75], 5e-4),
        ("highlight&way=gouraud", &[brightest(500, 16.0), brightest(9, 16.0)], 0.02),
        ("bits&bits=8", &[in_integers(8), 255.0 / 64.0, 65.0], 1e-9),
        ("bits&bits=16", &[in_integers(16), f64::from(255.0 * Fx16::STEP), 16_385.0], 1e-9),
        ("bands&coding=linear", &[16.0, 2.0, 1.0 / 15.0], 1e-9),
        ("bands&coding=srgb-dithered", &[16.0, 6.0, srgb_linear(17.0)], 1e-9),
    ];
    for (address, expected, tolerance) in table {
        let numbers = opened(address).drawing.numbers;
        assert!(numbers.len() >= expected.len(), "{address}");
        for (number, expected) in numbers.iter().zip(*expected) {
            let is_fitted = number.0 == "Outer angle, at 0" && *address == "both";
            let difference = (number.1 - expected).abs();
            assert!(
                is_fitted || difference <= tolerance * expected + 1e-9,
                "{address}: {number:?}, expected {expected}"
            );
        }
    }
    assert_eq!(opened("attenuation&a=0.5&b=0&c=0").drawing.numbers[2].1, f64::INFINITY);
    // Of the texts.
    assert_eq!((Fx16::STEP, format!("{:.0e}", f32::EPSILON / 2.0)), (0.5_f32.powi(14), "6e-8".to_owned()));
    let [naive, ours] = [0, 1]
        .map(|i| ["0.05", "10"].map(|half| opened(&format!("versine&half={half}")).drawing.numbers[i].1));
    assert!(naive[0] > 10.0 && naive[1] < 0.1 && ours.iter().all(|error| *error < 0.1), "{naive:?} {ours:?}");
}

#[test]
fn answers_have_the_numbers_of_the_published_formulas() {
    let [soft, hard, warn] = beams(15.0);
    let shown = opened("highlight").drawing.numbers;
    let table: [&[f64]; 13] = [
        &[12.0 / 16.0, 12.0 / 64.0, 0.25],
        &[1.0, 0.25],
        &[1.0 / (16.0 * PI), 16.0 * PI],
        &[0.5_f64.ln() / cosine(10.0).ln(), 0.5],
        &[smooth(0.5)],
        &[ramp(15.0, 0.0, 20.0).powi(2)],
        &[soft, hard, warn],
        &[whole(FRAC_1_SQRT_2), 120.0],
        &[soft, 7.0, 15.0],
        &[shown[0].1, shown[1].1],
        &[in_integers(8), in_integers(16)],
        &[(versine(0.05) * 16_777_216.0).floor()],
        &[2.0, 6.0],
    ];
    for (figure, numbers) in ALL.iter().zip(table) {
        let answer = (figure.answer)().unwrap();
        let mut words =
            answer.split(|c: char| !(c.is_ascii_digit() || c == '.')).map(|word| word.trim_end_matches('.'));
        let missing: Vec<_> =
            numbers.iter().filter(|number| !words.clone().any(|word| word == tidy(**number))).collect();
        assert!(missing.is_empty() && words.next().is_some(), "{}: {missing:?} in \"{answer}\"", figure.name);
    }
}

#[test]
fn both_ends_of_every_control_are_drawn_or_refused_in_words() {
    for figure in &ALL {
        for parameter in figure.parameters {
            let texts: Vec<String> = match parameter {
                Choice(_, _, options) => options.iter().map(|option| option.0.to_owned()).collect(),
                Dial(quantity, _) => quantity.ends.map(|end| end.to_string()).into(),
            };
            let mut seen = Vec::new();
            for text in &texts {
                let mut class = Class::of(figure).unwrap();
                let refused =
                    class.set(parameter.name(), text).map_or_else(|Refusal(words)| words, |()| String::new());
                let codes: Vec<_> =
                    class.drawing.pictures.iter().flat_map(|picture| picture.codes.clone()).collect();
                assert!(refused.is_empty() || refused.contains("expected"), "{}: {refused}", figure.name);
                assert!(codes.iter().any(|code| *code > 0), "{} {text} is dark", figure.name);
                let drawn = (codes, refused);
                assert!(
                    parameter.name() == Parameter::WHICH || !seen.contains(&drawn),
                    "{} {text} changes nothing",
                    figure.name
                );
                seen.push(drawn);
            }
            assert!(Values::of(figure).set(parameter.name(), "1e9").is_err(), "{}", figure.name);
        }
    }
    // What has no number says so, and where it begins.
    let thin = ["0.01", "0.015"].map(|half| opened(&format!("versine&half={half}")).drawing);
    assert!(
        thin[0].refused.contains("0 / 0") && thin[0].numbers[0].1 == f64::INFINITY,
        "{}",
        thin[0].refused
    );
    assert!(thin[1].refused.is_empty() && thin[1].numbers[0].1 < 256.0, "{:?}", thin[1].numbers);
    let refused = opened("both&beam=8&field=140").drawing.refused;
    assert!(
        refused.contains("field angle = 140: expected 8 to 18") && refused.contains("nearest pair"),
        "{refused}"
    );
}

#[test]
fn an_address_restores_the_values() {
    for figure in &ALL {
        let mut values = Values::of(figure);
        for parameter in figure.parameters {
            let text = match parameter {
                Choice(_, _, options) => options[1].0.to_owned(),
                Dial(quantity, start) => (0.9 * start + 0.1 * quantity.ends[1]).to_string(),
            };
            values.set(parameter.name(), &text).unwrap();
        }
        let class = opened(values.address().strip_prefix("figure=").unwrap());
        assert!(class.values.texts().eq(values.texts()), "{}", values.address());
        assert_eq!(serde_json::from_str::<Value>(&class.told()).unwrap()["address"], values.address());
    }
    let refused = Class::of(&ALL[0]).unwrap().open("figure=none&fbclid=1&height=0").unwrap();
    let parts = ["figure = \"none\"", "expected 3 to 8 m"];
    assert!(parts.iter().all(|part| refused.contains(part)) && !refused.contains("fbclid"), "{refused}");
}

#[test]
fn a_figure_has_at_most_two_controls_and_three_sentences() {
    for figure in &ALL {
        let name = figure.name;
        let (choices, dials): (Vec<_>, Vec<_>) =
            figure.parameters.iter().partition(|parameter| matches!(parameter, Choice(..)));
        match choices[..] {
            [Choice(Parameter::WHICH, _, options)] => {
                assert!(
                    options.iter().map(|option| option.0).eq(dials.iter().map(|dial| dial.name())),
                    "{name}"
                );
            }
            _ => assert!(choices.len() <= 1 && (1..=2).contains(&figure.parameters.len()), "{name}"),
        }
        assert!((1..=3).contains(&figure.text.split_inclusive(". ").count()), "{name}");
    }
}

#[test]
fn codes_are_those_of_the_kernel() {
    for i in 0..=1000_u32 {
        let light = i as f32 / 1000.0;
        let (place, grey) = ([i % 8, i / 8 % 8], Rgb::new(light, light, light));
        let [x, y] = place;
        let codes = |bits, is_srgb| {
            [None, Some(place)].map(|place| code(f64::from(light), bits, is_srgb, place) as u8)
        };
        assert_eq!(
            codes(8.0, false),
            [Linear::encode(light), Linear::encode_dithered(light, x, y)],
            "{light}"
        );
        assert_eq!(codes(8.0, true), [Srgb::encode(light), Srgb::encode_dithered(light, x, y)], "{light}");
        assert_eq!(codes(4.0, true), [Gray4::nearest(grey).0, Gray4::dithered(grey, x, y).0], "{light}");
        assert_eq!(codes(2.0, true), [Gray2::nearest(grey).0, Gray2::dithered(grey, x, y).0], "{light}");
    }
}
