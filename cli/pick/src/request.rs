//! A request and its answer.

use luminaire::bound::ErrorBound;
use luminaire::dynamic::AnyLight;
use luminaire_export::rust::Constant;
use serde::Serialize;

use crate::evaluation::Evaluation;
use crate::light::Light;
use crate::price::{Fine, Price};
use crate::refusal::Refusal;
use crate::search::{Bound, Place, Search};
use crate::target::{Chip, Display, Tolerance};
use crate::truth::Truth;

/// A request: the chip, the display and the tolerance. The default tolerance is one step of the
/// display. The cheapest evaluation is that with the fewest instructions in the mean, or in the worst case.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Request {
    pub(crate) chip: Chip,
    pub(crate) display: Display,
    pub(crate) tolerance: Tolerance,
    is_worst_case: bool,
}

/// The cheapest evaluation of a light whose error is within the tolerance.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Answer {
    /// The light.
    pub light: Light,
    /// The full angle in degrees at which the light ends; `None`, in JSON `null`, for a light without a cone.
    pub outer: Option<f32>,
    /// The chip.
    pub chip: Chip,
    /// The display.
    pub display: Display,
    /// The tolerance.
    pub tolerance: Tolerance,
    /// The evaluation.
    pub evaluation: Evaluation,
    /// The cost of a lit point.
    #[serde(flatten)]
    pub price: Price,
    /// The bound of the error, in the unit of the tolerance.
    pub bound: Bound,
    /// The evaluation of fewer instructions that comes nearest to the tolerance, without keeping it.
    pub cheaper: Option<Cheaper>,
    /// Rust source of the constant `LIGHT`, the compiled light.
    pub code: String,
}

/// An evaluation that costs less than that of an answer.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Cheaper {
    /// The evaluation.
    pub evaluation: Evaluation,
    /// Mean number of instructions of a lit point; those of the worst case if the request is for it.
    pub instructions: f64,
    /// The bound of the error, in the unit of the tolerance.
    pub bound: f64,
}

impl Request {
    /// Requests an evaluation for a chip and a display.
    pub fn new(chip: Chip, display: Display) -> Self {
        Self { chip, display, tolerance: Tolerance::Steps(1.0), is_worst_case: false }
    }

    /// Returns the request for the evaluation with the fewest instructions in the worst case: see [`Price::worst`].
    #[must_use]
    pub fn worst_case(self) -> Self {
        Self { is_worst_case: true, ..self }
    }

    /// Returns the request with a tolerance in steps of the display.
    #[must_use]
    pub fn steps(self, steps: f64) -> Self {
        self.tolerance(Tolerance::Steps(steps))
    }

    /// Returns the request with a tolerance in linear codes.
    #[must_use]
    pub fn codes(self, codes: f64) -> Self {
        self.tolerance(Tolerance::Codes(codes))
    }

    /// Returns the request with a tolerance.
    #[must_use]
    pub fn tolerance(self, tolerance: Tolerance) -> Self {
        Self { tolerance, ..self }
    }

    /// Returns the cheapest evaluation of the light whose error is within the tolerance.
    ///
    /// # Errors
    /// A parameter of the light that is invalid. A tolerance that no evaluation keeps: the refusal
    /// names the smallest bound and its evaluation.
    pub fn pick(&self, light: &Light) -> Result<Answer, Refusal> {
        let amount = self.tolerance.amount();
        if !(amount > 0.0 && amount.is_finite()) {
            return Err(Refusal::parameter("tolerance", amount.to_string(), "more than 0".to_owned()));
        }
        let offers = self.offers(light)?;
        if let Some(number) = offers.iter().position(|offer| offer.bound() <= amount) {
            let cheaper = offers[..number].iter().min_by(|a, b| a.bound().total_cmp(&b.bound()));
            let cheaper = cheaper.map(|offer| Cheaper {
                evaluation: offer.evaluation,
                instructions: offer.instructions,
                bound: offer.bound(),
            });
            return Ok(Answer { cheaper, ..self.answer(&offers[number], light)? });
        }
        let Some(nearest) = offers.iter().min_by(|a, b| a.bound().total_cmp(&b.bound())) else {
            return Err(none_holds(light));
        };
        Err(Refusal::parameter(
            "tolerance",
            self.tolerance.to_string(),
            format!(
                "at least {} {}, the bound of {}{}",
                rounded_up(nearest.bound()),
                self.tolerance.unit(self.display),
                nearest.evaluation,
                remedy(std::slice::from_ref(light))?
            ),
        ))
    }

    /// Returns an offer for every evaluation that can hold the light, the cheapest first.
    pub(crate) fn offers(&self, light: &Light) -> Result<Vec<Offer>, Refusal> {
        light.check()?;
        let any = light.any()?;
        let search = search(light, &any, SEED, 1);
        let farthest = farthest(light, &any);
        let measure = |lit| self.tolerance.measure(self.display, lit);
        let (mut offers, mut refused, mut uncounted) = (Vec::new(), None, false);
        for &evaluation in Evaluation::ALL {
            match evaluation.compile(&any) {
                Ok(Some(kernel)) if farthest <= evaluation.farthest() => {
                    let is_steep = evaluation.is_steep(&any)?;
                    let fine = if is_steep { Fine::Steep } else { Fine::Bright(search.fine_share(&*kernel)) };
                    let price = Price::of(self.chip, &any, evaluation, fine)?;
                    let instructions =
                        if self.is_worst_case { price.worst } else { Some(price.instructions) };
                    let Some(instructions) = instructions else {
                        uncounted = true;
                        continue;
                    };
                    let bound = evaluation.bound(&any, [light.near, light.far], &measure)?;
                    offers.push(Offer { evaluation, fine, price, instructions, bound });
                }
                Ok(_) => {}
                Err(error) => refused = Some(error),
            }
        }
        offers.sort_by(|a, b| a.instructions.total_cmp(&b.instructions));
        if uncounted && offers.is_empty() {
            let expected = format!("a chip whose worst cases are on record: {}", Price::chips_with_worst());
            return Err(Refusal::parameter("worst", self.chip.to_string(), expected));
        }
        match refused {
            Some(error) if offers.is_empty() => Err(error.into()),
            _ => Ok(offers),
        }
    }

    /// Returns the answer of an offer, with the largest error that a search finds.
    pub(crate) fn answer(&self, offer: &Offer, light: &Light) -> Result<Answer, Refusal> {
        let &Offer { evaluation, price, ref bound, .. } = offer;
        let any = light.any()?;
        let (found, at) = largest(self, offer, light, SEED, 1)?;
        Ok(Answer {
            light: light.clone(),
            outer: match &any {
                AnyLight::Spot(spot) => Some(spot.cone().outer().to_degrees()),
                AnyLight::Point(_) | AnyLight::Measured(_) | AnyLight::Directional(_) => None,
            },
            chip: self.chip,
            display: self.display,
            tolerance: self.tolerance,
            evaluation,
            price,
            bound: Bound {
                value: offer.bound(),
                found,
                label: "derived",
                edge_degrees: bound.edge.to_degrees(),
                range: bound.range,
                at,
            },
            cheaper: None,
            code: code(&light.name, evaluation, &evaluation.constant(&any)?),
        })
    }
}

fn search(light: &Light, any: &AnyLight, seed: u64, effort: usize) -> Search {
    Search::new(Truth::of(*any), [light.near, light.far], seed, effort)
}

/// Returns the largest error of an offer that a search finds, and where.
pub(crate) fn largest(
    request: &Request,
    offer: &Offer,
    light: &Light,
    seed: u64,
    effort: usize,
) -> Result<(f64, Place), Refusal> {
    let any = light.any()?;
    let Some(kernel) = offer.evaluation.compile(&any)? else { return Ok(Default::default()) };
    let search = search(light, &any, seed, effort);
    Ok(search.largest(&*kernel, &offer.bound, request.tolerance, request.display))
}

/// Returns the largest coordinate of the points.
fn farthest(light: &Light, any: &AnyLight) -> f32 {
    let position = match any {
        AnyLight::Spot(spot) => spot.position(),
        AnyLight::Point(point) => point.position(),
        AnyLight::Measured(light) => light.position(),
        // Its points may be anywhere.
        AnyLight::Directional(_) => return 0.0,
    };
    <[f32; 3]>::from(position).iter().fold(light.far, |most, c| most.max(c.abs() + light.far))
}

/// Returns what else keeps a tolerance, if a light is so bright that little of its error is clipped away.
pub(crate) fn remedy(lights: &[Light]) -> Result<String, Refusal> {
    /// Illuminance of a bright light at the nearest surface, in units of full scale.
    const BRIGHT: f64 = 100.0;
    let mut brightest = 0.0_f64;
    for light in lights {
        brightest = brightest.max(Truth::of(light.any()?).most(light.near.into()));
    }
    Ok(if brightest < BRIGHT {
        String::new()
    } else {
        let times = brightest.round();
        format!(", or a larger illuminance as full scale: the nearest surface has {times} times that")
    })
}

/// The seed of the searches of answers.
const SEED: u64 = 1983;

/// An evaluation that can hold a light, before its error is searched.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Offer {
    pub(crate) evaluation: Evaluation,
    pub(crate) fine: Fine,
    pub(crate) price: Price,
    /// Its instructions by which the request compares.
    pub(crate) instructions: f64,
    /// The bound of the error, in the unit of the tolerance.
    pub(crate) bound: ErrorBound,
}

impl Offer {
    /// Returns the bound of the error, in the unit of the tolerance.
    pub(crate) fn bound(&self) -> f64 {
        self.bound.light.into()
    }
}

/// Returns the refusal of a light whose coordinates no evaluation can hold.
fn none_holds(light: &Light) -> Refusal {
    let farthest = Evaluation::ALL.iter().map(|evaluation| evaluation.farthest()).fold(0.0, f32::max);
    Refusal::parameter("far", light.far.to_string(), format!("coordinates of at most {farthest}"))
}

fn code(name: &str, evaluation: Evaluation, Constant { type_name, value }: &Constant) -> String {
    format!(
        "/// `{name}`, evaluated by {evaluation}.\npub const LIGHT: {} = {};\n",
        qualified(type_name),
        value.trim_end()
    )
}

/// Returns the type of a compiled light with the modules of its names.
fn qualified(type_name: &str) -> String {
    let is_of_name = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
    let (mut text, mut rest, mut depth, mut place) = (String::new(), type_name, 0, 0);
    while let Some(first) = rest.chars().next() {
        let (name, others) = rest.split_at(rest.find(|c| !is_of_name(c)).unwrap_or(rest.len()));
        if name.is_empty() {
            // The parameters of the light's type: the format, the falloff of a spotlight, and the attenuation.
            match first {
                '<' => depth += 1,
                '>' => depth -= 1,
                ',' if depth == 1 => place += 1,
                _ => {}
            }
            text.push(first);
            rest = &rest[first.len_utf8()..];
            continue;
        }
        // The lifetime of a table is before the format.
        place -= i32::from(depth == 1 && name.starts_with('\''));
        let has_falloff = type_name.contains("SpotLight");
        let module = match (depth, place) {
            _ if !name.starts_with(char::is_uppercase) => "",
            (0, _) => "luminaire::light::",
            (_, 0) => "luminaire::",
            (_, 1) if has_falloff => "luminaire::falloff::",
            _ => "luminaire::attenuation::",
        };
        text += module;
        text += name;
        rest = others;
    }
    text
}

/// Returns a positive number with three digits, rounded up so that a tolerance of this number is
/// accepted.
pub(crate) fn rounded_up(value: f64) -> String {
    let decimals = (2.0 - value.log10().floor()).clamp(0.0, 30.0);
    let unit = 10_f64.powf(-decimals);
    format!("{:.*}", decimals as usize, (value / unit + 1e-6).ceil() * unit)
}
