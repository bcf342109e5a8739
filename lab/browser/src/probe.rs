//! The methods that are specific to the demo's page. They call `probe.js`, which runs in the page.

use std::fmt::Display;

use anyhow::{Context, Result, bail, ensure};
use serde_json::json;

use super::page::{Page, list};

impl Page {
    /// Waits until the page has drawn nothing for a while.
    pub fn settle(&mut self) -> Result<()> {
        self.ask("probe.settle()").map(drop)
    }

    /// The number that an input holds.
    pub fn value(&mut self, id: &str) -> Result<f64> {
        self.number(&format!("probe.value('{id}')"))
    }

    /// The minimum and the maximum of a slider.
    pub fn range(&mut self, id: &str) -> Result<(f64, f64)> {
        Ok((self.number(&format!("probe.least('{id}')"))?, self.number(&format!("probe.greatest('{id}')"))?))
    }

    /// The text of an element.
    pub fn message(&mut self, id: &str) -> Result<String> {
        self.text(&format!("probe.text('{id}')"))
    }

    /// Whether an element can be seen.
    pub fn shows(&mut self, id: &str) -> Result<bool> {
        self.holds(&format!("probe.visible('{id}')"))
    }

    /// The point in the middle of an element, scrolled into view.
    pub fn middle(&mut self, id: &str) -> Result<(f64, f64)> {
        let point = self.ask(&format!("probe.middle('{id}')"))?;
        Ok((point["x"].as_f64().context("no x")?, point["y"].as_f64().context("no y")?))
    }

    /// Enters a value as a visitor would by typing, sliding or choosing, and waits until the page
    /// has settled.
    pub fn enter(&mut self, id: &str, value: impl Display) -> Result<()> {
        self.ask(&format!("probe.enter('{id}', {})", json!(value.to_string())))?;
        self.settle()
    }

    /// Runs `act`, which must change the picture. `what` names the act in error messages.
    pub fn change(&mut self, what: &str, act: impl FnOnce(&mut Self) -> Result<()>) -> Result<()> {
        self.keep("before")?;
        let drawn = self.number("luminaire.drawn")?;
        act(self)?;
        if let Err(error) = self.ask(&format!("probe.redrawn({drawn})")) {
            bail!("{what} has no effect: {error:#}{}", list(&self.complaints()?));
        }
        self.keep("after")?;
        let difference = self.difference("before", "after")?;
        ensure!(difference > 0.0, "{what} leaves the picture as it was");
        Ok(())
    }

    /// Stores the current picture under a name.
    pub fn keep(&mut self, name: &str) -> Result<()> {
        self.ask(&format!("probe.keep('{name}')")).map(drop)
    }

    /// The largest difference between two stored pictures, in displayed 8-bit codes.
    pub fn difference(&mut self, one: &str, other: &str) -> Result<f64> {
        self.number(&format!("probe.difference('{one}', '{other}')"))
    }

    /// The share of the picture's pixels that are brighter than black.
    pub fn lit_share(&mut self) -> Result<f64> {
        self.number("probe.survey().lit")
    }
}
