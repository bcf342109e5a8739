//! Reading the lines of words that `luminaire-prices` prints.

use anyhow::{Context, Result, bail, ensure};

use super::list::{Cone, Error, Place};

/// A kernel as it is named in a line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Kernel {
    pub(crate) stage: String,
    pub(crate) format: String,
    pub(crate) kernel: String,
}

impl Kernel {
    /// The name on the price list.
    pub(crate) fn name(&self) -> String {
        format!("{}.{}", self.kernel, self.format)
    }
}

/// A kernel's times: nanoseconds a call, by quartiles, and a checksum of its results.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Times {
    pub(crate) kernel: Kernel,
    pub(crate) quartiles: [f64; 3],
    pub(crate) sum: String,
}

/// Reads a line such as
/// `accuracy falloff fx16 soft 15 2.3e-2 1.5e0 2.741 4.7e-3 1.8e-2 exhaustive`.
pub(crate) fn accuracy(line: &str) -> Result<(Kernel, Cone)> {
    let read = || -> Result<_> {
        let (kernel, rest) = kernel("accuracy", line)?;
        let [half_angle, rest @ ..] = &rest[..] else { bail!("an angle is missing") };
        let half_angle = half_angle.parse()?;
        if let ["refused", narrowest] = rest {
            return Ok((kernel, Cone { half_angle, error: None, narrowest: Some(narrowest.parse()?) }));
        }
        let [codes, lsb, at, mean, nearly_all, kind] = rest else { bail!("it has not six figures") };
        let error = Error {
            codes: codes.parse()?,
            lsb: lsb.parse()?,
            at: place(at)?,
            mean_codes: mean.parse()?,
            p999_codes: nearly_all.parse()?,
            kind: (*kind).to_owned(),
        };
        ensure!(error.codes.is_finite(), "the error is not a number");
        Ok((kernel, Cone { half_angle, error: Some(error), narrowest: None }))
    };
    read().with_context(|| format!("not an accuracy: {line}"))
}

/// Reads a line such as `time falloff fx16 soft 0.85 0.88 0.92 9e38729e`.
pub(crate) fn time(line: &str) -> Result<Times> {
    let read = || -> Result<_> {
        let (kernel, rest) = kernel("time", line)?;
        let [lower, median, upper, sum] = &rest[..] else { bail!("it has not four figures") };
        let quartiles = [lower.parse()?, median.parse()?, upper.parse()?];
        Ok(Times { kernel, quartiles, sum: (*sum).to_owned() })
    };
    read().with_context(|| format!("not a time: {line}"))
}

fn kernel<'a>(what: &str, line: &'a str) -> Result<(Kernel, Vec<&'a str>)> {
    let words: Vec<_> = line.split(' ').collect();
    let [first, stage, format, kernel, ..] = words[..] else { bail!("words are missing") };
    ensure!(first == what, "it does not begin with {what}");
    let [stage, format, kernel] = [stage, format, kernel].map(str::to_owned);
    Ok((Kernel { stage, format, kernel }, words[4..].to_vec()))
}

/// Degrees off axis, and for points the distance and the degrees of incidence, between commas.
fn place(words: &str) -> Result<Option<Place>> {
    if words == "nowhere" {
        return Ok(None);
    }
    let numbers: Result<Vec<f64>, _> = words.split(',').map(str::parse).collect();
    Ok(Some(match numbers?[..] {
        [degrees_off_axis] => Place { degrees_off_axis, distance: None, degrees_of_incidence: None },
        [degrees_off_axis, distance, incidence] => {
            Place { degrees_off_axis, distance: Some(distance), degrees_of_incidence: Some(incidence) }
        }
        _ => bail!("not a place: {words}"),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_accuracy_is_read_or_a_refusal() {
        let line = "accuracy lit fx16 lit 15 5.7e-2 3.6e0 1.6,5.2,63.4 8.3e-3 3.9e-2 searched";
        let (kernel, cone) = accuracy(line).unwrap();
        let error = cone.error.unwrap();
        assert_eq!(
            (kernel.name().as_str(), error.codes, error.kind.as_str()),
            ("lit.fx16", 0.057, "searched")
        );
        assert_eq!(error.at.unwrap().distance, Some(5.2));
        let (_, cone) = accuracy("accuracy falloff fx16 hard 1 refused 1.4").unwrap();
        assert_eq!((cone.error, cone.narrowest), (None, Some(1.4)));
        for broken in ["", "accuracy falloff fx16 hard 1", "accuracy a b c 1 x 2 3 4 5 searched"] {
            assert!(accuracy(broken).is_err(), "{broken}");
        }
        let wrong = "accuracy falloff f32 soft 1 inf inf 1 inf inf searched";
        assert!(accuracy(wrong).is_err(), "an error that is not a number must not pass");
    }

    #[test]
    fn a_time_is_read() {
        let times = time("time falloff fx16 soft 0.85 0.88 0.92 9e38729e").unwrap();
        assert_eq!((times.quartiles, times.sum.as_str()), ([0.85, 0.88, 0.92], "9e38729e"));
        assert!(time("time falloff fx16 soft 0.85 0.88").is_err());
    }
}
