//! The scenes: which effects they require, which are left out, and that the picture stays the same.

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::Visitor;
use tools::browser::Page;

/// The passes of a picture, as measurements name them.
const PASSES: [&str; 5] = ["geometryMs", "lightingMs", "encodeMs", "showMs", "frameMs"];

pub(crate) fn are_all_drawn(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#scenes")?;
    ensure!(page.shows("scenes-page")? && !page.shows("view")?, "the address does not open the scenes");
    let mut titles = Vec::new();
    for name in names(&mut page)? {
        page.enter("scene-name", &name)?;
        ensure!(page.text("luminaire.scenes.example")? == name, "{name} was asked for");
        ensure!(page.holds("luminaire.scenes.isLit")?, "{name} is black");
        let account = account(&mut page)?;
        let count = |part: &str| account[part].as_f64().unwrap_or(f64::NAN);
        let parts: f64 =
            ["evaluated", "missedByRow", "missedByTile", "kept", "dropped"].map(count).iter().sum();
        ensure!(parts == count("pairs") && count("evaluated") > 0.0, "the account of {name}: {account}");
        let (called, all) = (called(&mut page)?, page.number(&elements("#scene-effects li"))?);
        ensure!(called > 2.0 && called < all, "{name} calls for {called} effects of {all}");
        let told = page.message("account-ratio")?;
        ensure!(told.starts_with("1 in "), "the share of {name} is told as {told:?}");
        let time = page.message("scene-frame-ms")?;
        ensure!(time.ends_with(" ms"), "the time of {name} is told as {time:?}");
        titles.push(page.message("scene-summary")?);
        page.must_be_content().with_context(|| name.clone())?;
    }
    titles.dedup();
    ensure!(titles.len() > 7, "the scenes are called {titles:?}");
    Ok(())
}

/// For every scene, the comparison with evaluating everything, which a visitor starts with a
/// button, finds equal pictures.
pub(crate) fn equal_everything(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#scenes")?;
    let mut left_out = 0.0;
    for name in names(&mut page)? {
        page.enter("scene-name", &name)?;
        let found = page.ask("luminaire.scenes.compare()")?;
        ensure!(found["differing"] == 0 && found["pixels"].as_f64() > Some(0.0), "{name}: {found}");
        left_out += found["pairs"].as_f64().unwrap_or(0.0) - found["evaluated"].as_f64().unwrap_or(0.0);
    }
    // The grids alone have 40 million pairs, of which more than nine tenths are left out.
    ensure!(left_out > 3e7, "hardly anything is left out: {left_out} pairs");
    press(&mut page, "scene-compare")?;
    let told = page.message("scene-equality")?;
    ensure!(told.contains("are equal, bit for bit"), "the comparison is told as {told:?}");

    // With the switch the page evaluates everything and shows the same picture. The account states
    // what was evaluated.
    let before = checksum(&mut page)?;
    redraw(&mut page, "the switch", |page| press(page, "scene-everything"))?;
    ensure!(checksum(&mut page)? == before, "evaluating everything changes the picture");
    let account = account(&mut page)?;
    ensure!(account["evaluated"] == account["pairs"], "not everything is evaluated: {account}");
    ensure!(page.message("account-ratio")? == "1 in 1", "everything is told as another share");
    page.must_be_content()
}

pub(crate) fn are_opened_by_address(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#scenes?scene=grid")?;
    ensure!(page.text("luminaire.scenes.example")? == "grid", "the address opens another scene");
    ensure!(
        page.text("document.getElementById('scene-name').value")? == "grid",
        "the list shows another scene"
    );
    page.enter("scene-name", "show")?;
    page.ask("probe.until(() => location.hash === '#scenes?scene=show')")
        .context("the address does not follow")?;
    redraw(&mut page, "the address", |page| {
        page.ask("void (location.hash = '#scenes?scene=turntable')").map(drop)
    })?;
    ensure!(page.text("luminaire.scenes.example")? == "turntable", "the view does not follow the address");
    page.enter("scene-map-subject", "tiles")?;
    page.ask("probe.until(() => location.hash === '#scenes?scene=turntable&map=tiles')")
        .context("the address has no map")?;
    page.ask("document.querySelector('.views a[href=\"#stage\"]').click()")?;
    page.settle()?;
    ensure!(page.shows("view")? && !page.shows("scenes-page")?, "the way back does not show the stage");
    page.ask("document.querySelector('.views a[href=\"#scenes\"]').click()")?;
    page.settle()?;
    ensure!(page.text("luminaire.scenes.example")? == "turntable", "the scene is another after coming back");
    page.must_be_content()
}

pub(crate) fn play(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#scenes?scene=turntable")?;
    for switch in ["scene-play", "scene-camera"] {
        let (before, drawn) = (checksum(&mut page)?, page.number("luminaire.drawn")?);
        press(&mut page, switch)?;
        page.ask(&format!("probe.until(() => luminaire.drawn > {drawn} + 4)"))?;
        press(&mut page, switch)?;
        page.settle()?;
        ensure!(checksum(&mut page)? != before, "{switch} leaves the picture as it was");
    }
    page.enter("scene-name", "bare-spot")?;
    let disabled = "['scene-play', 'scene-camera'].every((id) => document.getElementById(id).disabled)";
    ensure!(page.holds(disabled)? && page.shows("scene-still")?, "a scene that stands still can be played");
    page.must_be_content()
}

pub(crate) fn camera_is_moved(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#scenes?scene=three-point")?;
    let middle = page.middle("scene-view")?;
    must_change(&mut page, "dragging", |page| page.drag(middle, (90.0, 20.0)))?;
    must_change(&mut page, "the wheel", |page| page.wheel(middle, 120.0))?;
    page.ask("document.getElementById('scene-view').focus()")?;
    must_change(&mut page, "an arrow key", |page| page.press("ArrowLeft", 37))?;
    page.must_be_content()
}

pub(crate) fn are_switched(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#scenes?scene=turntable")?;
    for effect in ["haze", "dither"] {
        let (before, switch) = (called(&mut page)?, format!("scene-effect-{effect}"));
        must_change(&mut page, effect, |page| press(page, &switch))?;
        ensure!(called(&mut page)? == before + 1.0, "{effect} is not called for");
        must_change(&mut page, effect, |page| press(page, &switch))?;
    }
    must_change(&mut page, "shadows put in", |page| press(page, "scene-effect-shadow"))?;
    let time = page.message("scene-shadows-ms")?;
    ensure!(time.ends_with(" ms"), "the time of shadows is told as {time:?}");
    must_change(&mut page, "shadows left out", |page| press(page, "scene-effect-shadow"))?;
    let (effects, account_before) = (called(&mut page)?, account(&mut page)?);
    must_change(&mut page, "highlights left out", |page| press(page, "scene-effect-specular"))?;
    ensure!(called(&mut page)? == effects - 1.0, "highlights left out are still called for");
    must_change(&mut page, "a light switched off", |page| press(page, "scene-light-0"))?;
    let account_after = account(&mut page)?;
    ensure!(account_after["lightsDropped"] == 1, "a light that is off is not dropped: {account_after}");
    ensure!(account_after["dropped"] != account_before["dropped"], "switches leave the account as it was");
    must_change(&mut page, "all lights off", |page| press(page, "scene-all-off"))?;
    ensure!(called(&mut page)? == 1.0, "in the dark more than ambient light is called for");
    ensure!(page.message("account-ratio")? == "none", "in the dark lights are evaluated");
    must_change(&mut page, "all lights on", |page| press(page, "scene-all-on"))?;
    ensure!(page.message("scene-lights-count")? == "8 of 8 on", "not all lights are on");

    page.enter("scene-name", "show")?;
    ensure!(!page.holds("document.getElementById('scene-effect-gobo').disabled")?, "the show has no gobos");
    must_change(&mut page, "gobos left out", |page| press(page, "scene-effect-gobo"))?;
    page.enter("scene-name", "grid")?;
    let disabled = "['specular', 'gobo', 'shadow']\
                    .every((effect) => document.getElementById(`scene-effect-${effect}`).disabled)";
    ensure!(page.holds(disabled)?, "effects can be switched that the scene neither has nor takes");
    page.must_be_content()
}

pub(crate) fn tiles_are_lit_again(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#scenes?scene=grid")?;
    ensure!(account(&mut page)?["kept"] == 0, "tiles are kept that never were lit");
    page.enter("scene-map-subject", "tiles")?;
    redraw(&mut page, "a light", |page| press(page, "scene-light-27"))?;
    let account = account(&mut page)?;
    let (relit, tiles) = (account["tilesRelit"].as_f64(), account["tiles"].as_f64());
    let share = relit.context("no tiles")? / tiles.context("no tiles")?;
    ensure!(share > 0.0 && share < 0.25, "one light of 64 lets a share of {share} of the tiles be lit again");
    let relit = page.text("getComputedStyle(document.getElementById('map-relit')).backgroundColor")?;
    let marked = share_of_map(&mut page, &relit)?;
    ensure!((marked - share).abs() < 0.05, "the map marks {marked} of the picture, lit again is {share}");
    page.must_be_content()
}

pub(crate) fn map_is_shown(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#scenes?scene=grid")?;
    ensure!(!page.shows("scene-map")? && !page.shows("map-lights")?, "there is a map before it is asked for");
    page.enter("scene-map-subject", "lights")?;
    ensure!(page.shows("scene-map")? && page.shows("map-bar")?, "the map or its legend is not shown");
    let end = page.message("map-end")?;
    ensure!(end.ends_with(" lights"), "the map ends at {end:?}");
    let colours = page.number(
        "(() => { const map = document.getElementById('scene-map'); \
         const { data } = map.getContext('2d').getImageData(0, 0, map.width, map.height); \
         return new Set(new Uint32Array(data.buffer)).size; })()",
    )?;
    ensure!(colours > 2.0, "the map has {colours} colours");
    redraw(&mut page, "the switch", |page| press(page, "scene-everything"))?;
    ensure!(page.message("map-end")? == "64 lights", "64 lights at each pixel leave the map as it was");
    page.enter("scene-map-subject", "nothing")?;
    ensure!(!page.shows("scene-map")?, "the map does not go away");
    page.must_be_content()
}

pub(crate) fn refusals_are_told(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#scenes?map=heat")?;
    let told = page.message("scene-error")?;
    ensure!(told.contains("\"heat\""), "a map that there is not is answered with {told:?}");
    let mut page = visitor.ready_at("#scenes?scene=nowhere")?;
    let told = page.message("scene-error")?;
    ensure!(told.contains("scene = \"nowhere\""), "a scene that there is not is answered with {told:?}");
    ensure!(page.holds("luminaire.scenes.isLit")?, "a scene that there is not leaves no picture");
    for name in names(&mut page)? {
        page.enter("scene-format", "f32")?;
        page.enter("scene-name", &name)?;
        for format in ["fx32", "fx16"] {
            page.enter("scene-format", format)?;
            let (told, taken) = (page.message("scene-error")?, page.text(&value_of("scene-format"))?);
            let answered = if told.is_empty() { taken == format } else { told.contains("cannot hold light") };
            ensure!(answered, "{name} in {format}: {told:?}, and the format is {taken}");
            ensure!(page.holds("luminaire.scenes.isLit")?, "{name} is black in {format}");
        }
    }
    page.must_be_content()
}

/// The Tab key moves from one control to the next, and reaches every control.
pub(crate) fn keys_are_enough(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#scenes?scene=turntable")?;
    page.ask("document.getElementById('scene-name').focus()")?;
    let mut reached = Vec::new();
    for _ in 0..30 {
        reached.push(page.text("document.activeElement.id")?);
        page.press("Tab", 9)?;
    }
    for id in
        ["scene-view", "scene-play", "scene-camera", "scene-map-subject", "scene-format", "scene-everything"]
    {
        ensure!(reached.iter().any(|other| other == id), "#{id} is not reached by keys: {reached:?}");
    }
    for id in ["scene-compare", "scene-effect-specular", "scene-all-off", "scene-light-0", "scene-light-7"] {
        ensure!(reached.iter().any(|other| other == id), "#{id} is not reached by keys: {reached:?}");
    }
    let unnamed = "Array.from(document.querySelectorAll('#scenes-page :is(input, select, button, canvas[tabindex])'))\
                   .filter((e) => !e.labels?.length && !e.textContent.trim() && !e.getAttribute('aria-label'))\
                   .map((e) => e.id).join()";
    ensure!(page.text(unnamed)?.is_empty(), "controls without a name: {}", page.text(unnamed)?);
    page.must_be_content()
}

pub(crate) fn are_measured(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#scenes?scene=pocket")?;
    let options = "{ width: 320, height: 180, spots: 3, without: ['specular'] }";
    let found = page.ask(&format!("luminaire.measureScene('turntable', 3, {options})"))?;
    ensure!(found["lights"] == 3 && found["width"] == 320, "another scene was measured: {found}");
    ensure!(
        found["cameraMoving"]["shadowsMs"].is_null(),
        "shadows were drawn that nobody asked for: {found}"
    );
    for pass in PASSES {
        let time = found["cameraMoving"][pass].as_f64();
        ensure!(time.is_some_and(|time| time >= 0.0), "the {pass} of a moving camera is {time:?}: {found}");
    }
    ensure!(
        found["cameraAtRest"]["geometryMs"].is_null(),
        "a camera at rest draws the geometry anew: {found}"
    );
    let (frame, lighting) = (&found["cameraAtRest"]["frameMs"], &found["cameraAtRest"]["lightingMs"]);
    ensure!(frame.as_f64() > lighting.as_f64(), "a frame is shorter than its light: {found}");
    let still = page.ask("luminaire.measureScene('bare-spot', 2)")?;
    ensure!(still["cameraAtRest"].is_null(), "where nothing moves, something is drawn: {still}");
    page.settle()?;
    ensure!(
        page.text("luminaire.scenes.example")? == "pocket",
        "the scene that was shown is not shown again"
    );
    page.must_be_content()
}

fn names(page: &mut Page) -> Result<Vec<String>> {
    let names = page.ask("probe.options('scene-name')")?;
    let names = names.as_array().context("the scenes are no list")?;
    ensure!(names.len() > 7, "there are only the scenes {names:?}");
    Ok(names.iter().filter_map(|name| name.as_str().map(str::to_owned)).collect())
}

fn account(page: &mut Page) -> Result<Value> {
    page.ask("luminaire.scenes.account")
}

/// Number of effects that are marked as required.
fn called(page: &mut Page) -> Result<f64> {
    page.number(&elements("#scene-effects .called"))
}

fn elements(selector: &str) -> String {
    format!("document.querySelectorAll('{selector}').length")
}

fn value_of(id: &str) -> String {
    format!("document.getElementById('{id}').value")
}

fn press(page: &mut Page, id: &str) -> Result<()> {
    page.ask(&format!("document.getElementById('{id}').click()")).map(drop)
}

/// A checksum of the picture: two different pictures hardly ever have the same.
fn checksum(page: &mut Page) -> Result<f64> {
    page.number("luminaire.scenes.pixels().reduce((sum, code) => (31 * sum + code) % 4294967291, 7)")
}

/// Runs `act`, which must redraw the scene.
fn redraw(page: &mut Page, what: &str, act: impl FnOnce(&mut Page) -> Result<()>) -> Result<()> {
    let drawn = page.number("luminaire.drawn")?;
    act(page)?;
    page.ask(&format!("probe.redrawn({drawn})")).map(drop).with_context(|| format!("{what} has no effect"))
}

/// Runs `act`, which must change the picture.
fn must_change(page: &mut Page, what: &str, act: impl FnOnce(&mut Page) -> Result<()>) -> Result<()> {
    let before = checksum(page)?;
    redraw(page, what, act)?;
    ensure!(checksum(page)? != before, "{what} leaves the picture as it was");
    Ok(())
}

/// The share of the map that has a colour, written `rgb(1, 2, 3)`.
fn share_of_map(page: &mut Page, colour: &str) -> Result<f64> {
    page.number(&format!(
        "(() => {{ const map = document.getElementById('scene-map'); \
         const {{ data }} = map.getContext('2d').getImageData(0, 0, map.width, map.height); \
         const colour = '{colour}'.match(/\\d+/g).map(Number); let count = 0; \
         for (let i = 0; i < data.length; i += 4) \
             if (colour.every((code, channel) => Math.abs(code - data[i + channel]) < 4)) count += 1; \
         return 4 * count / data.length; }})()"
    ))
}
