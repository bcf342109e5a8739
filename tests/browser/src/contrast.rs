//! With forced colours, a visitor still sees which switches are on, what is chosen, and where a
//! slider stands.

use std::collections::BTreeSet;
use std::io::Cursor;

use anyhow::{Context, Result, ensure};

use crate::Visitor;
use browser::Page;

type Colour = [u8; 3];

/// The pixels of a part of the page.
#[derive(PartialEq)]
pub(crate) struct Seen {
    pixels: Vec<Colour>,
    width: usize,
}

impl Seen {
    fn of(page: &mut Page, selector: &str) -> Result<Self> {
        Self::around(page, selector, 0)
    }

    /// The pixels of an element and of a margin around it.
    pub(crate) fn around(page: &mut Page, selector: &str, margin: u32) -> Result<Self> {
        let file = page.screenshot_of(selector, margin)?;
        let mut reader = png::Decoder::new(Cursor::new(file)).read_info()?;
        let mut bytes = vec![0; reader.output_buffer_size().context("the picture is too large")?];
        let info = reader.next_frame(&mut bytes)?;
        let samples = info.color_type.samples();
        let pixels = bytes.chunks_exact(samples).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        Ok(Self { pixels, width: info.width as usize })
    }

    /// Number of pixels that differ.
    pub(crate) fn differing(&self, other: &Self) -> usize {
        self.pixels.iter().zip(&other.pixels).filter(|(one, other)| one != other).count()
    }

    /// The middle row.
    fn row(&self) -> &[Colour] {
        let height = self.pixels.len() / self.width;
        &self.pixels[height / 2 * self.width..][..self.width]
    }

    /// The most frequent colour.
    fn ground(&self) -> Colour {
        let colours: BTreeSet<_> = self.pixels.iter().collect();
        let count = |colour: &Colour| self.pixels.iter().filter(|pixel| *pixel == colour).count();
        colours.into_iter().copied().max_by_key(count).unwrap_or_default()
    }

    /// The share of the middle row that does not have the most frequent colour.
    fn share_of_row(&self) -> f64 {
        let ground = self.ground();
        self.row().iter().filter(|pixel| **pixel != ground).count() as f64 / self.width as f64
    }
}

pub(crate) fn forced_colours_hide_nothing(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    page.force_colours()?;
    for slider in ["#light-beam", "#exposure"] {
        slider_is_seen(&mut page, slider)?;
    }
    for switch in ["light-2-on", "handles-shown"] {
        switch_is_seen(&mut page, switch)?;
    }
    for (chosen, other) in [
        ("#lights li:nth-child(1)", "#lights li:nth-child(2)"),
        (".views [aria-current]", ".views a:not([aria-current])"),
    ] {
        chosen_is_seen(&mut page, chosen, other)?;
    }
    frame_is_seen(&mut page, ".picker label:has(:checked)", ".picker label:not(:has(:checked))")?;
    let label = "getComputedStyle(document.querySelector('#curve .angle')).fill";
    let ground = "getComputedStyle(document.querySelector('.desk')).backgroundColor";
    ensure!(page.text(label)? != page.text(ground)?, "the labels of the curve cannot be seen");
    page.must_be_content()?;

    let mut page = visitor.ready_at("#stage?play=none&scene=show")?;
    page.force_colours()?;
    let parts: BTreeSet<_> = Seen::of(&mut page, ".bar")?.row().iter().copied().collect();
    // At least four colours: the frame, what was evaluated, and two kinds of what was left out.
    ensure!(parts.len() > 3, "the bar of what was evaluated has the colours {parts:?}");
    page.must_be_content()
}

/// The same in the other views.
pub(crate) fn forced_colours_hide_nothing_elsewhere(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#compare")?;
    page.force_colours()?;
    slider_is_seen(&mut page, "#half-angle")?;
    page.must_be_content()?;

    let mut page = visitor.ready_at("#museum")?;
    page.force_colours()?;
    slider_is_seen(&mut page, "#exhibit-value")?;
    frame_is_seen(&mut page, ".exhibits label:has(:checked)", ".exhibits label:not(:has(:checked))")?;
    page.must_be_content()?;

    let mut page = visitor.ready_at("#chip")?;
    page.force_colours()?;
    page.ask("probe.until(() => luminaire.chip?.drawn > 0)")?;
    switch_is_seen(&mut page, "chip-run")?;
    let bar: BTreeSet<_> = Seen::of(&mut page, "#chip-stages td")?.row().iter().copied().collect();
    ensure!(bar.len() > 1, "the bar of a stage has one colour, {bar:?}");
    page.must_be_content()
}

fn slider_is_seen(page: &mut Page, selector: &str) -> Result<()> {
    let share = Seen::of(page, selector)?.share_of_row();
    ensure!(share > 0.9, "of {selector} a share of {share} is seen");
    Ok(())
}

/// On and off are seen, and differ.
fn switch_is_seen(page: &mut Page, id: &str) -> Result<()> {
    let state = |page: &mut Page| {
        // Waits until the thumb has moved.
        page.settle()?;
        Seen::of(page, &format!("#{id}"))
    };
    let before = state(page)?;
    page.ask(&format!("document.getElementById('{id}').click()"))?;
    let after = state(page)?;
    for one in [&before, &after] {
        let share = one.share_of_row();
        ensure!(share > 0.2, "of the switch {id} a share of {share} is seen");
    }
    ensure!(before.ground() == after.ground(), "the ground of the switch {id} changes");
    let differing = before.differing(&after);
    ensure!(10 * differing > before.pixels.len(), "on and off of {id} differ in {differing} pixels");
    Ok(())
}

/// The ground of what is chosen differs from that of another.
fn chosen_is_seen(page: &mut Page, chosen: &str, other: &str) -> Result<()> {
    let [chosen_ground, other_ground] = [Seen::of(page, chosen)?.ground(), Seen::of(page, other)?.ground()];
    ensure!(chosen_ground != other_ground, "{chosen} looks like {other}");
    Ok(())
}

/// The frame of what is chosen differs from that of another, which has none.
fn frame_is_seen(page: &mut Page, chosen: &str, other: &str) -> Result<()> {
    let mut top = |selector: &str| {
        let seen = Seen::of(page, selector)?;
        let ground = seen.ground();
        Ok::<_, anyhow::Error>(seen.pixels[..3 * seen.width].iter().any(|pixel| *pixel != ground))
    };
    ensure!(top(chosen)? && !top(other)?, "{chosen} looks like {other}");
    Ok(())
}
