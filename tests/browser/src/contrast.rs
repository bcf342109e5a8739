//! With forced colours, a visitor still sees which switches are on, what is chosen, and where a
//! slider stands.

use std::collections::BTreeSet;
use std::io::Cursor;

use anyhow::{Context, Result, ensure};

use crate::Visitor;
use tools::browser::Page;

type Colour = [u8; 3];

/// The pixels of a part of the page.
#[derive(PartialEq)]
struct Seen {
    pixels: Vec<Colour>,
    width: usize,
}

impl Seen {
    fn of(page: &mut Page, selector: &str) -> Result<Self> {
        let file = page.screenshot_of(selector)?;
        let mut reader = png::Decoder::new(Cursor::new(file)).read_info()?;
        let mut bytes = vec![0; reader.output_buffer_size().context("the picture is too large")?];
        let info = reader.next_frame(&mut bytes)?;
        let samples = info.color_type.samples();
        let pixels = bytes.chunks_exact(samples).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        Ok(Self { pixels, width: info.width as usize })
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
    for slider in ["#light-beam", "#light-intensity"] {
        let share = Seen::of(&mut page, slider)?.share_of_row();
        ensure!(share > 0.9, "of {slider} a share of {share} is seen");
    }
    let off = Seen::of(&mut page, "#light-2-on")?;
    ensure!(off.share_of_row() > 0.2, "a switch that is off cannot be seen");
    page.ask("document.getElementById('light-2-on').click()")?;
    // Waits until the thumb has moved.
    page.settle()?;
    let on = Seen::of(&mut page, "#light-2-on")?;
    ensure!(on.share_of_row() > 0.2 && on.ground() == off.ground(), "a switch that is on cannot be seen");
    let differing = on.pixels.iter().zip(&off.pixels).filter(|(on, off)| on != off).count();
    ensure!(10 * differing > on.pixels.len(), "on and off differ in {differing} pixels");
    for (chosen, other) in [
        ("#lights li:nth-child(1)", "#lights li:nth-child(2)"),
        (".views [aria-current]", ".views a:not([aria-current])"),
    ] {
        let [chosen_ground, other_ground] =
            [chosen, other].map(|selector| Ok::<_, anyhow::Error>(Seen::of(&mut page, selector)?.ground()));
        ensure!(chosen_ground? != other_ground?, "{chosen} looks like {other}");
    }
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
