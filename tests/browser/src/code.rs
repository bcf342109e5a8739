//! The drawer with the code of the selected light.

use anyhow::{Context, Result, ensure};
use luminaire::dynamic::AnyLight;
use luminaire_export::{Language, c_header, export};
use luminaire_render::scenes::Example;

use crate::{STILL, Visitor};
use browser::Page;

/// Opens the drawer and waits for the code.
fn open(visitor: &mut Visitor, query: &str, script: &str) -> Result<Page> {
    let mut page = visitor.ready_with(query, script)?;
    let early = page.requests()?.iter().find(|request| request.contains("code")).cloned();
    let slot = |name: &String| name.contains("code-slot");
    ensure!(early.as_ref().is_none_or(slot), "{early:?} is loaded before the drawer is opened");
    page.ask("document.querySelector('#code summary').click()")?;
    page.ask("probe.until(() => document.getElementById('code-text').textContent !== '')")?;
    Ok(page)
}

fn code(page: &mut Page) -> Result<String> {
    page.text("document.getElementById('code-text').textContent")
}

/// Lights of the still life and of the show, some of which the scene moves.
pub(crate) fn is_what_the_exporter_writes(visitor: &mut Visitor) -> Result<()> {
    let mut seen = Vec::new();
    for (scene, number) in [(Example::ThreePoint, 0), (Example::ThreePoint, 2), (Example::Show, 1)] {
        let mut page = open(visitor, &format!("#stage?play=none&scene={}", scene.name()), "")?;
        page.ask(&format!("document.getElementById('light-{number}').click()"))?;
        let lights = scene.setup().context("no scene")?.fixtures_at(0.0).context("no lights")?;
        let (light, name) = (*lights[number].light(), format!("light_{}", number + 1));
        for &language in Language::ALL {
            page.enter("code-language", language)?;
            let found = code(&mut page)?;
            let expected = export(light, &name, language)?;
            ensure!(found == expected, "{scene:?}, {language}: expected {expected}, found {found}");
            seen.push(language.name());
        }
        page.enter("code-language", "c-header")?;
        ensure!(code(&mut page)? == c_header(), "the header differs");
        let offered = page.ask("probe.options('code-language')")?;
        let offered = offered.as_array().context("no languages")?;
        ensure!(offered.len() == Language::ALL.len() + 1, "the drawer has {offered:?}");
        page.must_be_content()?;
    }
    Ok(())
}

pub(crate) fn follows_the_settings(visitor: &mut Visitor) -> Result<()> {
    let mut page = open(visitor, STILL, "")?;
    page.enter("code-language", "glsl")?;
    let before = code(&mut page)?;
    page.change("the slider", |page| page.enter("light-field", 0.3))?;
    let field = page.value("light-field-number")?;
    let after = code(&mut page)?;
    ensure!(after != before && after.contains(&format!("field {field:.2}")), "{field}: {after}");
    page.change("undo", |page| page.ask("document.getElementById('undo').click()").map(drop))?;
    ensure!(code(&mut page)? == before, "undo leaves the code as it was");
    page.ask("document.getElementById('light-1').click()")?;
    ensure!(code(&mut page)?.contains("vec3 light_2_color"), "{}", code(&mut page)?);
    // Neither the switch of a light nor the exposure is a part of it.
    let before = code(&mut page)?;
    page.change("the switch", |page| page.ask("document.getElementById('light-1-on').click()").map(drop))?;
    page.change("the exposure", |page| page.enter("exposure", 1))?;
    ensure!(code(&mut page)? == before, "the code follows the switch or the exposure");
    page.must_be_content()
}

pub(crate) fn is_copied_or_selected(visitor: &mut Visitor) -> Result<()> {
    for (act, took, words) in [
        ("{ window.copied = text; }", "window.copied", "Copied."),
        ("{ throw new DOMException('no', 'NotAllowedError'); }", "getSelection().toString()", "Ctrl+C"),
    ] {
        let script = format!(
            "Object.defineProperty(navigator, 'clipboard', {{ value: {{ writeText: async (text) => {act} }} }})"
        );
        let mut page = open(visitor, STILL, &script)?;
        page.ask("document.getElementById('code-copy').focus()")?;
        page.ask("document.getElementById('code-copy').click()")?;
        page.ask("probe.until(() => probe.text('code-told') !== '')")?;
        let told = page.message("code-told")?;
        ensure!(told.contains(words), "expected {words:?}, found {told:?}");
        let (taken, code) = (page.text(took)?, code(&mut page)?);
        ensure!(taken.trim() == code.trim(), "expected {code}, found {taken}");
        page.must_be_content()?;
    }
    Ok(())
}

pub(crate) fn refusals_are_told(visitor: &mut Visitor) -> Result<()> {
    let scene = Example::Gallery;
    let setup = scene.setup().context("no scene")?;
    let is_sun = |light: &AnyLight| matches!(light, AnyLight::Directional(_));
    let sun = setup.fixtures.iter().position(|fixture| is_sun(fixture.light())).context("no sun")?;
    let mut page = open(visitor, "#stage?play=none&scene=gallery", "")?;
    page.ask(&format!("document.getElementById('light-{sun}').click()"))?;
    page.enter("code-language", "c-fx16")?;
    let told = page.message("code-error")?;
    ensure!(told.contains("a spotlight or a point light"), "{told:?}");
    ensure!(page.shows("code-error")? && !page.shows("code-text")? && !page.shows("code-copy")?);
    page.enter("code-language", "glsl")?;
    ensure!(page.message("code-error")?.is_empty() && page.shows("code-text")?, "a sun has no GLSL");

    // A beam that 16 bits cannot hold.
    let mut page = open(visitor, STILL, "")?;
    page.change("a narrow beam", |page| page.enter("light-field-number", 0.5))?;
    let told = page.message("code-error")?;
    ensure!(told.contains("expected") && !page.shows("code-text")?, "{told:?}");
    page.enter("code-language", "rust-f32")?;
    ensure!(code(&mut page)?.contains("pub const LIGHT"), "f32 cannot hold the beam");
    page.must_be_content()
}
