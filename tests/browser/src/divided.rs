//! A divided picture: one scene in two number formats, and the difference between them.

use anyhow::{Context, Result, ensure};
use luminaire::{Fx16, projector::Fixture};
use luminaire_render::{Format, Renderer, scenes::Example};

use crate::Visitor;

/// The scene, its size and its time are those of the address below.
const SCENE: Example = Example::ThreePoint;
const ADDRESS: &str =
    "?width=960&height=540#stage?scene=three-point&play=none&format=fx16&with=f32&effects=-dither";

pub(crate) fn differs_as_on_the_host(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at(ADDRESS)?;
    ensure!(page.shows("divided")?, "the picture is whole");
    let (one, other) = (picture::<Fx16>()?, picture::<f32>()?);
    let difference = |(one, other): (&[u8; 4], &[u8; 4])| {
        one.iter().zip(other).map(|(one, other)| one.abs_diff(*other)).max().unwrap_or_default()
    };
    let pixels = one.as_chunks::<4>().0.iter().zip(other.as_chunks::<4>().0).map(difference);
    let differences: Vec<u8> = pixels.collect();
    let largest = *differences.iter().max().context("no pixels")?;
    let place = differences.iter().position(|&difference| difference == largest).context("no pixels")?;
    let differing = differences.iter().filter(|&&difference| difference > 0).count();
    ensure!(largest > 0, "both formats have the same picture");
    let found = page.ask("luminaire.difference")?;
    ensure!(
        found["largest"] == largest && found["place"] == place && found["differing"] == differing,
        "{found} is not {largest} at {place}, {differing} pixels"
    );
    let told = page.message("divided-note")?;
    ensure!(told.contains(&format!("at most {largest} code")), "the difference is told as {told:?}");

    // The same format again, and the whole picture.
    page.enter("divided-format", "fx16")?;
    page.settle()?;
    let found = page.ask("luminaire.difference")?;
    ensure!(found["largest"] == 0 && found["differing"] == 0, "a format differs from itself: {found}");
    page.enter("divided-format", "")?;
    page.settle()?;
    ensure!(!page.shows("divided")? && page.holds("luminaire.difference === undefined")?, "it stays divided");
    page.must_be_content()
}

pub(crate) fn is_covered_and_kept_by_the_address(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at(ADDRESS)?;
    ensure!(!page.shows("divided-difference")?, "the difference covers the picture at first");
    page.ask("document.getElementById('divided-cover').click()")?;
    ensure!(page.shows("divided-difference")?, "the switch does not cover the picture");
    let hash =
        page.text("probe.until(() => location.hash.includes('difference=1')).then(() => location.hash)")?;
    ensure!(hash.contains("with=f32") && hash.contains("format=fx16"), "the address is {hash:?}");
    page.ask("document.getElementById('undo').click()")?;
    ensure!(!page.shows("divided-difference")?, "undo leaves the picture covered");
    // A beam that the other format cannot hold is refused, and the picture stays.
    page.enter("light-field-number", 0.5)?;
    let told = page.message("light-error")?;
    ensure!(!told.is_empty(), "a beam of half a degree is taken in 16 bits");
    page.must_be_content()
}

/// The scene's picture at second 0: RGBA, sRGB, eight bits.
fn picture<S: Format>() -> Result<Vec<u8>> {
    let setup = SCENE.setup().context("the scene has no setup")?;
    let (width, height) = SCENE.size();
    let fixtures: Vec<Fixture> = setup.fixtures_at(0.0).context("no fixtures")?;
    let mut renderer = Renderer::<S>::new(width, height).context("no renderer")?;
    renderer.set_display(setup.display);
    renderer.set_antialiased(true);
    renderer.draw_geometry(&setup.scene, &setup.camera);
    renderer.draw_shadows(&setup.scene, &fixtures).context("no shadows")?;
    renderer.draw_light(&fixtures).context("no light")?;
    Ok(renderer.encode().to_vec())
}
