//! The stage: its scenes and their effects, the state and its address, and the camera.

use anyhow::{Context, Result, ensure};
use serde_json::Value;

use crate::Visitor;
use browser::{Engine, Page};

/// The arrow keys, with the codes that keyboards give them.
const ARROWS: [(&str, u32); 4] = [("ArrowLeft", 37), ("ArrowUp", 38), ("ArrowRight", 39), ("ArrowDown", 40)];

/// The passes of a picture, as measurements name them.
const PASSES: [&str; 6] = ["geometryMs", "lightingMs", "encodeMs", "transferMs", "showMs", "frameMs"];

pub(crate) fn are_all_drawn(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#stage?play=none")?;
    ensure!(page.shows("view")?, "the address does not open the stage");
    let mut titles = Vec::new();
    for name in names(&mut page)? {
        choose(&mut page, &name)?;
        ensure!(page.text("luminaire.scene")? == name, "{name} was asked for");
        ensure!(page.holds("probe.survey().lit > 0")?, "{name} is black");
        let account = account(&mut page)?;
        let count = |part: &str| account[part].as_f64().unwrap_or(f64::NAN);
        let parts: f64 =
            ["evaluated", "missedByRow", "missedByTile", "kept", "dropped"].map(count).iter().sum();
        ensure!(parts == count("pairs") && count("evaluated") > 0.0, "the account of {name}: {account}");
        let (called, all) = (called(&mut page)?, page.number(&elements("#effects li"))?);
        ensure!(called > 2.0 && called < all, "{name} calls for {called} effects of {all}");
        let told = page.message("account-ratio")?;
        ensure!(told.starts_with("1 in "), "the share of {name} is told as {told:?}");
        let time = page.message("frame-ms")?;
        ensure!(time.ends_with(" ms"), "the time of {name} is told as {time:?}");
        titles.push(page.message("summary")?);
        page.must_be_content().with_context(|| name.clone())?;
    }
    titles.dedup();
    ensure!(titles.len() > 7, "the scenes are called {titles:?}");
    Ok(())
}

/// For every scene, the comparison with evaluating everything, which a visitor starts with a
/// button, finds equal pictures.
pub(crate) fn equal_everything(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#stage?play=none")?;
    let (mut left_out, mut pairs) = (0.0, 0.0);
    for name in names(&mut page)? {
        choose(&mut page, &name)?;
        let found = page.ask("luminaire.compare()")?;
        ensure!(found["differing"] == 0 && found["pixels"].as_f64() > Some(0.0), "{name}: {found}");
        let all = found["pairs"].as_f64().unwrap_or(0.0);
        pairs += all;
        left_out += all - found["evaluated"].as_f64().unwrap_or(0.0);
    }
    // Most pairs are those of the grids, of which more than nine tenths are left out.
    ensure!(left_out > 0.6 * pairs, "hardly anything is left out: {left_out} of {pairs} pairs");
    press(&mut page, "verify")?;
    page.ask("probe.until(() => probe.text('equality').includes('are equal, bit for bit'))")?;

    // With the switch the page evaluates everything and shows the same picture. The account states
    // what was evaluated.
    let before = checksum(&mut page)?;
    redraw(&mut page, "the switch", |page| press(page, "everything"))?;
    ensure!(checksum(&mut page)? == before, "evaluating everything changes the picture");
    let account = account(&mut page)?;
    ensure!(account["evaluated"] == account["pairs"], "not everything is evaluated: {account}");
    ensure!(page.message("account-ratio")? == "1 in 1", "everything is told as another share");
    page.must_be_content()
}

pub(crate) fn are_opened_by_address(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#stage?play=none&scene=grid")?;
    ensure!(page.text("luminaire.scene")? == "grid", "the address opens another scene");
    ensure!(page.holds("document.getElementById('scene-grid').checked")?, "the list shows another scene");
    choose(&mut page, "three-point")?;
    says(&mut page, "#stage?v=1&scene=three-point&play=none")?;
    redraw(&mut page, "the address", |page| {
        page.ask("void (location.hash = '#stage?scene=turntable&play=none')").map(drop)
    })?;
    ensure!(page.text("luminaire.scene")? == "turntable", "the view does not follow the address");
    page.enter("map-subject", "tiles")?;
    says(&mut page, "#stage?v=1&scene=turntable&play=none&map=tiles")?;
    page.ask("document.querySelector('.views a[href=\"#compare\"]').click()")?;
    page.ask("probe.until(() => probe.visible('comparison'))")?;
    page.ask("document.querySelector('.views a[href=\"#stage\"]').click()")?;
    page.settle()?;
    ensure!(page.text("luminaire.scene")? == "turntable", "the scene is another after coming back");
    page.must_be_content()?;

    // Addresses of an earlier page, whose scenes were a view of their own.
    let mut page = visitor.ready_at("#scenes?scene=pocket&map=lights")?;
    ensure!(page.text("luminaire.scene")? == "pocket" && page.shows("map-bar")?, "an old link is lost");
    page.must_be_content()
}

/// Every setting is in the address, which opens the same picture.
pub(crate) fn are_kept_by_the_address(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    page.enter("light-beam-number", 17)?;
    page.enter("light-color", "#40ff80")?;
    page.enter("light-intensity-number", 120)?;
    page.enter("exposure", 0.5)?;
    page.enter("format", "fx32")?;
    press(&mut page, "light-1-on")?;
    press(&mut page, "effect-haze")?;
    let middle = page.middle("view")?;
    page.drag(middle, (70.0, 12.0))?;
    page.settle()?;
    // Longer than the page waits before it writes the last change.
    page.ask("new Promise((resolve) => setTimeout(resolve, 600))")?;
    page.ask("probe.until(() => location.hash.includes('view=') && location.hash.includes(':b17:'))")
        .context("the address does not follow")?;
    let (hash, picture) = (page.text("location.hash")?, checksum(&mut page)?);
    ensure!(hash.starts_with("#stage?v=1&scene=three-point&format=fx32&view="), "the address is {hash}");
    let mut again = visitor.ready_at(&hash)?;
    ensure!(again.message("stage-error")?.is_empty(), "{hash} is refused: {}", again.message("stage-error")?);
    ensure!(checksum(&mut again)? == picture, "{hash} opens another picture");
    ensure!(again.value("light-beam-number")? == 17.0 && again.value("exposure")? == 0.5, "the desk differs");
    ensure!(!again.holds("document.getElementById('light-1-on').checked")?, "light 2 is on");
    page.must_be_content()?;
    again.must_be_content()
}

/// What an address requires and cannot have is refused in words, and the rest is shown.
pub(crate) fn bad_addresses_are_told(visitor: &mut Visitor) -> Result<()> {
    for (query, words) in [
        ("v=9", "v = \"9\""),
        ("scene=nowhere", "scene = \"nowhere\""),
        ("map=heat", "\"heat\""),
        ("lights=0:b0.1&format=fx16", "16-bit fixed point cannot hold light 1"),
        ("lights=0:b500", "beam angle"),
        ("lights=%3Cimg%20onerror%3E", "lights"),
        ("view=NaN/0/1", "view"),
        ("__proto__=1", "parameter = \"__proto__\""),
    ] {
        let mut page = visitor.ready_at(&format!("#stage?scene=three-point&play=none&{query}"))?;
        let scene = if query == "scene=nowhere" { "three-point" } else { "" };
        let told = page.message("stage-error")?;
        ensure!(told.contains(words) || !scene.is_empty(), "{query} is answered with {told:?}");
        ensure!(page.lit_share()? > 0.0, "{query} leaves no picture");
        page.must_be_content()?;
    }
    Ok(())
}

pub(crate) fn changes_are_undone(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let disabled =
        |page: &mut Page, id: &str| page.holds(&format!("document.getElementById('{id}').disabled"));
    ensure!(disabled(&mut page, "undo")? && disabled(&mut page, "redo")?, "there is something to undo");
    let opened = checksum(&mut page)?;
    must_change(&mut page, "a beam", |page| page.enter("light-beam-number", 12))?;
    let narrow = checksum(&mut page)?;
    page.ask("probe.until(() => location.hash.includes(':b12'))")?;
    must_change(&mut page, "a light", |page| press(page, "light-0-on"))?;
    must_change(&mut page, "undo", |page| press(page, "undo"))?;
    ensure!(checksum(&mut page)? == narrow, "undo leads to another picture");
    must_change(&mut page, "undo by keys", |page| {
        page.ask("probe.key(document.body, { key: 'z', ctrlKey: true })").map(drop)
    })?;
    ensure!(checksum(&mut page)? == opened && disabled(&mut page, "undo")?, "undo does not lead back");
    must_change(&mut page, "redo", |page| press(page, "redo"))?;
    ensure!(checksum(&mut page)? == narrow, "redo leads to another picture");
    must_change(&mut page, "reset", |page| press(page, "reset"))?;
    ensure!(checksum(&mut page)? == opened, "reset does not lead back");
    must_change(&mut page, "undo of the reset", |page| press(page, "undo"))?;
    page.must_be_content()
}

pub(crate) fn lights_are_copied_and_removed(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    press(&mut page, "light-1")?;
    ensure!(page.message("panel-title")? == "2 Fresnel (fill)", "light 2 is not selected");
    must_change(&mut page, "a copy", |page| press(page, "light-copy"))?;
    ensure!(page.message("lights-count")? == "4 of 4 on", "{}", page.message("lights-count")?);
    must_change(&mut page, "the copy", |page| page.enter("light-color", "#ff0000"))?;
    must_change(&mut page, "removal", |page| press(page, "light-remove"))?;
    for _ in 0..3 {
        press(&mut page, "light-remove")?;
        page.settle()?;
    }
    ensure!(page.message("lights-count")? == "0 of 0 on" && !page.shows("panel")?, "a light is left");
    must_change(&mut page, "a light in the dark", |page| press(page, "light-add"))?;
    must_change(&mut page, "reset", |page| press(page, "reset"))?;
    page.must_be_content()
}

/// A light is added, selected and kept by the address; one step undoes it. Too many lights are refused.
pub(crate) fn lights_are_added(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    must_change(&mut page, "a light", |page| press(page, "light-add"))?;
    ensure!(page.message("lights-count")? == "4 of 4 on", "{}", page.message("lights-count")?);
    ensure!(page.message("panel-title")? == "4 added spot", "{}", page.message("panel-title")?);
    must_change(&mut page, "its angle", |page| page.enter("light-field-number", 12))?;
    let hash =
        page.text("probe.until(() => /lights=0-2;3:.*f12/.test(location.hash)).then(() => location.hash)")?;
    let before = checksum(&mut page)?;
    let mut other = visitor.ready_at(&hash)?;
    ensure!(checksum(&mut other)? == before, "the address {hash} has another picture");
    ensure!(other.message("lights-count")? == "4 of 4 on", "the address {hash} has no added light");
    for _ in 0..2 {
        press(&mut page, "undo")?;
        page.settle()?;
    }
    ensure!(page.message("lights-count")? == "3 of 3 on", "undo leaves {}", page.message("lights-count")?);

    choose(&mut other, "grid")?;
    other.ask("Array.from({ length: 17 }, () => document.getElementById('light-add').click())")?;
    other.settle()?;
    let told = other.message("stage-error")?;
    ensure!(told == "number of lights = 81: expected 0 to 80 lights", "{told:?}");
    ensure!(other.message("lights-count")? == "80 of 80 on", "{}", other.message("lights-count")?);
    page.must_be_content()?;
    other.must_be_content()
}

/// The page opens on the show, which plays, unless the visitor wants no motion.
pub(crate) fn opens_on_the_show(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.browser.open(&visitor.address, "")?;
    page.ready()?;
    ensure!(page.text("luminaire.scene")? == "show", "the page opens on another scene");
    ensure!(page.lit_share()? > 0.0, "there is no picture when the page is ready");
    page.ask("probe.until(() => luminaire.drawn > 3)").context("the show does not play")?;
    press(&mut page, "play")?;
    page.settle()?;
    page.ask("probe.until(() => location.hash.includes('play=none'))").context("the address plays")?;
    page.must_be_content()?;

    const STILL: &str = "window.matchMedia = (query) => ({ matches: query.includes('reduced-motion') })";
    let mut page = visitor.ready_with("", STILL)?;
    ensure!(page.number("luminaire.drawn")? == 1.0, "something moves for a visitor who wants no motion");
    ensure!(!page.holds("document.getElementById('play').checked")?, "the switch says that it plays");
    page.must_be_content()
}

pub(crate) fn play(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#stage?play=none&scene=turntable")?;
    for switch in ["play", "camera"] {
        let (before, drawn) = (checksum(&mut page)?, page.number("luminaire.drawn")?);
        press(&mut page, switch)?;
        page.ask(&format!("probe.until(() => luminaire.drawn > {drawn} + 4)"))?;
        press(&mut page, switch)?;
        page.settle()?;
        ensure!(checksum(&mut page)? != before, "{switch} leaves the picture as it was");
    }
    choose(&mut page, "bare-spot")?;
    let disabled = "['play', 'camera'].every((id) => document.getElementById(id).disabled)";
    ensure!(page.holds(disabled)?, "a scene that stands still can be played");
    page.must_be_content()
}

pub(crate) fn camera_is_moved(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let opened = checksum(&mut page)?;
    let middle = page.middle("view")?;
    must_change(&mut page, "dragging", |page| page.drag(middle, (90.0, 20.0)))?;
    must_change(&mut page, "the wheel", |page| page.wheel(middle, 120.0))?;
    page.ask("document.getElementById('view').focus()")?;
    for (key, code) in ARROWS {
        must_change(&mut page, key, |page| page.press(key, code))?;
    }
    let reset = |page: &mut Page, act: &str| -> Result<()> {
        must_change(page, act, |page| page.ask(act).map(drop))?;
        ensure!(checksum(page)? == opened, "{act} leads to another picture");
        must_change(page, "dragging", |page| page.drag(middle, (40.0, 20.0)))
    };
    reset(&mut page, "probe.key(document.getElementById('view'), { key: 'r' })")?;
    reset(&mut page, "void document.getElementById('view').dispatchEvent(new MouseEvent('dblclick'))")?;
    page.must_be_content()
}

/// At the limit of the zoom the wheel scrolls the page also while the picture has the focus, and a swipe
/// always does.
pub(crate) fn page_scrolls_over_the_picture(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let taken = |page: &mut Page, by: i32| {
        page.holds(&format!(
            "!document.getElementById('view').dispatchEvent(
                new WheelEvent('wheel', {{ deltaY: {by}, cancelable: true, bubbles: true }}))"
        ))
    };
    page.ask("document.getElementById('view').focus()")?;
    ensure!(taken(&mut page, 100)?, "the wheel does not zoom");
    let mut turns = 0..20;
    ensure!(turns.any(|_| taken(&mut page, 1000).is_ok_and(|is_taken| !is_taken)), "the wheel is swallowed");
    ensure!(turns.start > 2, "the limit is reached after {} turns", turns.start);
    ensure!(taken(&mut page, -100)?, "the wheel does not zoom back");
    let action = page.text("getComputedStyle(document.getElementById('view')).touchAction")?;
    ensure!(action == "pan-y", "a swipe over the picture has the action {action}");
    page.must_be_content()
}

pub(crate) fn are_switched(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#stage?play=none&scene=turntable")?;
    // Dither is on at first.
    for (effect, more) in [("haze", 1.0), ("dither", -1.0)] {
        let (before, switch) = (called(&mut page)?, format!("effect-{effect}"));
        must_change(&mut page, effect, |page| press(page, &switch))?;
        ensure!(called(&mut page)? == before + more, "{effect} is called for as before");
        must_change(&mut page, effect, |page| press(page, &switch))?;
    }
    must_change(&mut page, "shadows put in", |page| press(page, "effect-shadow"))?;
    let time = page.message("shadows-ms")?;
    ensure!(time.ends_with(" ms"), "the time of shadows is told as {time:?}");
    must_change(&mut page, "shadows left out", |page| press(page, "effect-shadow"))?;
    let (effects, account_before) = (called(&mut page)?, account(&mut page)?);
    must_change(&mut page, "highlights left out", |page| press(page, "effect-specular"))?;
    ensure!(called(&mut page)? == effects - 1.0, "highlights left out are still called for");
    must_change(&mut page, "a light switched off", |page| press(page, "light-0-on"))?;
    let account_after = account(&mut page)?;
    ensure!(account_after["lightsDropped"] == 1, "a light that is off is not dropped: {account_after}");
    ensure!(account_after["dropped"] != account_before["dropped"], "switches leave the account as it was");
    must_change(&mut page, "all lights off", |page| press(page, "all-off"))?;
    ensure!(called(&mut page)? == 2.0, "in the dark more than ambient light and dither is called for");
    ensure!(page.message("account-ratio")? == "none", "in the dark lights are evaluated");
    must_change(&mut page, "all lights on", |page| press(page, "all-on"))?;
    ensure!(page.message("lights-count")? == "8 of 8 on", "not all lights are on");

    choose(&mut page, "show")?;
    ensure!(!page.holds("document.getElementById('effect-gobo').disabled")?, "the show has no gobos");
    must_change(&mut page, "gobos left out", |page| press(page, "effect-gobo"))?;
    choose(&mut page, "grid")?;
    let disabled = "['specular', 'gobo', 'shadow']\
                    .every((effect) => document.getElementById(`effect-${effect}`).disabled)";
    ensure!(page.holds(disabled)?, "effects can be switched that the scene neither has nor takes");
    page.must_be_content()
}

pub(crate) fn tiles_are_lit_again(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#stage?play=none&scene=grid")?;
    ensure!(account(&mut page)?["kept"] == 0, "tiles are kept that never were lit");
    page.enter("map-subject", "tiles")?;
    redraw(&mut page, "a light", |page| press(page, "light-27-on"))?;
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
    let mut page = visitor.ready_at("#stage?play=none&scene=grid")?;
    ensure!(!page.shows("map")? && !page.shows("map-lights")?, "there is a map before it is asked for");
    page.enter("map-subject", "lights")?;
    ensure!(page.shows("map")? && page.shows("map-bar")?, "the map or its legend is not shown");
    let end = page.message("map-end")?;
    ensure!(end.ends_with(" lights"), "the map ends at {end:?}");
    let colours = page.number(
        "(() => { const map = document.getElementById('map'); \
         const { data } = map.getContext('2d').getImageData(0, 0, map.width, map.height); \
         return new Set(new Uint32Array(data.buffer)).size; })()",
    )?;
    ensure!(colours > 2.0, "the map has {colours} colours");
    redraw(&mut page, "the switch", |page| press(page, "everything"))?;
    ensure!(page.message("map-end")? == "64 lights", "64 lights at each pixel leave the map as it was");
    page.enter("map-subject", "nothing")?;
    ensure!(!page.shows("map")?, "the map does not go away");
    page.must_be_content()
}

/// The map of the lighting time has the time of the lighting pass, haze included.
pub(crate) fn map_of_costs_adds_up(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#stage?play=none&scene=show")?;
    redraw(&mut page, "the map", |page| page.enter("map-subject", "cost"))?;
    let mut differences = Vec::new();
    // Other work of the machine may interrupt a worker between two tiles.
    while differences.iter().all(|difference: &f64| *difference >= 0.01) {
        ensure!(differences.len() < 10, "the map differs from the time by {differences:?} of it");
        redraw(&mut page, "a light", |page| press(page, "light-0-on"))?;
        let costs = page.ask("luminaire.costs")?;
        let time = |of: &str| costs[of].as_f64().context("no time");
        differences.push((time("mapped")? / time("lighting")? - 1.0).abs());
    }
    let [total, end] = [page.message("map-total")?, page.message("map-end")?];
    ensure!(total.ends_with(" ms of a core in all") && end.ends_with(" ns a pixel"), "{total:?}, {end:?}");
    page.must_be_content()
}

pub(crate) fn refusals_are_told(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    for name in names(&mut page)? {
        page.enter("format", "f32")?;
        choose(&mut page, &name)?;
        for format in ["fx32", "fx16"] {
            page.enter("format", format)?;
            let (told, taken) = (page.message("stage-error")?, page.text(&value_of("format"))?);
            let answered = if told.is_empty() { taken == format } else { told.contains("cannot hold light") };
            ensure!(answered, "{name} in {format}: {told:?}, and the format is {taken}");
            ensure!(page.holds("probe.survey().lit > 0")?, "{name} is black in {format}");
        }
    }
    page.must_be_content()
}

/// The Tab key moves from one control to the next, and reaches every control.
pub(crate) fn keys_are_enough(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#stage?play=none&scene=turntable")?;
    page.ask("document.querySelector('.views a').focus()")?;
    let mut reached = Vec::new();
    for _ in 0..75 {
        reached.push(page.text("document.activeElement.id")?);
        page.press("Tab", 9)?;
    }
    for id in [
        "view",
        "handle-0",
        "handle-aim",
        "handles-shown",
        "play",
        "camera",
        "reset",
        "copy",
        "save",
        "full",
        "scene-turntable",
        "format",
        "map-subject",
        "exposure",
        "all-off",
        "light-0",
        "light-0-on",
        "light-7-on",
        "light-copy",
        "light-fixture",
        "light-beam",
        "light-intensity-number",
        "light-edge",
        "light-color",
        "light-aim-z",
        "everything",
        "verify",
        "effect-specular",
    ] {
        // The Tab key skips choices of colours in WebKitGTK, on every page.
        if id == "light-color" && visitor.browser.engine() == Engine::WebKit {
            continue;
        }
        ensure!(reached.iter().any(|other| other == id), "#{id} is not reached by keys: {reached:?}");
    }
    let unnamed = "Array.from(document.querySelectorAll('#stage-page :is(input, select, button, canvas[tabindex])'))\
                   .filter((e) => !e.labels?.length && !e.textContent.trim() && !e.getAttribute('aria-label'))\
                   .map((e) => e.id).join()";
    ensure!(page.text(unnamed)?.is_empty(), "controls without a name: {}", page.text(unnamed)?);
    page.must_be_content()
}

pub(crate) fn are_measured(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready_at("#stage?play=none&scene=pocket")?;
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
    ensure!(page.text("luminaire.scene")? == "pocket", "the scene that was shown is not shown again");
    page.must_be_content()
}

fn names(page: &mut Page) -> Result<Vec<String>> {
    let names =
        page.ask("Array.from(document.querySelectorAll('input[name=scene]'), (input) => input.value)")?;
    let names = names.as_array().context("the scenes are no list")?;
    ensure!(names.len() > 7, "there are only the scenes {names:?}");
    Ok(names.iter().filter_map(|name| name.as_str().map(str::to_owned)).collect())
}

/// Chooses a scene and waits until the page has settled.
fn choose(page: &mut Page, name: &str) -> Result<()> {
    press(page, &format!("scene-{name}"))?;
    page.settle()
}

fn says(page: &mut Page, hash: &str) -> Result<()> {
    page.ask(&format!("probe.until(() => location.hash === '{hash}')"))
        .map(drop)
        .with_context(|| format!("the address is not {hash}"))
}

fn account(page: &mut Page) -> Result<Value> {
    page.ask("luminaire.account")
}

/// Number of effects that are marked as required.
fn called(page: &mut Page) -> Result<f64> {
    page.number(&elements("#effects .called"))
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
    page.number("luminaire.pixels().reduce((sum, code) => (31 * sum + code) % 4294967291, 7)")
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
        "(() => {{ const map = document.getElementById('map'); \
         const {{ data }} = map.getContext('2d').getImageData(0, 0, map.width, map.height); \
         const colour = '{colour}'.match(/\\d+/g).map(Number); let count = 0; \
         for (let i = 0; i < data.length; i += 4) \
             if (colour.every((code, channel) => Math.abs(code - data[i + channel]) < 4)) count += 1; \
         return 4 * count / data.length; }})()"
    ))
}
