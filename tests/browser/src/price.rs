//! The price of the selected light, beside the format of the stage.

use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Result, bail, ensure};
use serde_json::json;

use crate::Visitor;
use browser::Page;

/// How long an answer of the picker may take, on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);

const CHIPS: &str = "[...document.querySelectorAll('#price-chips tr')].map((row) => row.textContent).join()";
const STAGE: &str = "document.querySelector('#price-chart .point.current')?.getAttribute('cx')";

pub(crate) fn follows_the_format(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let early = page.requests()?.iter().find(|request| request.contains("price-panel")).cloned();
    ensure!(early.is_none(), "{early:?} is loaded before the price is in view");
    page.ask("document.getElementById('price').scrollIntoView()")?;
    let mut seen = Vec::new();
    for (format, name) in [("fx16", "16 bits"), ("fx32", "32 bits"), ("f32", "f32")] {
        page.ask(&format!("luminaire.setFormat('{format}')"))?;
        until(
            &mut page,
            &format!("document.getElementById('price-format')?.textContent === '{name}' && {STAGE}"),
        )?;
        let [place, chips] = [page.text(STAGE)?, page.text(CHIPS)?];
        ensure!(["Cortex-M0+", "Cortex-M3", "Cortex-M4F", "RV32IMC"].iter().all(|chip| chips.contains(chip)));
        ensure!(chips.matches(" ms").count() == 4, "{format}: {chips}");
        seen.push((place, chips));
    }
    for (i, one) in seen.iter().enumerate() {
        let same = seen[..i].iter().any(|other| one.0 == other.0 || one.1 == other.1);
        ensure!(!same, "two formats have the same price: {seen:?}");
    }
    let live = page.message("price-live")?;
    ensure!(live.contains(" ns of a core for a lit point"), "the time here is {live:?}");

    // A stricter tolerance has another answer, with the constant to paste.
    let picked = "document.getElementById('price-picked').textContent";
    let [rough, strict] = ["5", "0.01"].map(|most| {
        page.ask(&format!(
            "((most) => {{ most.value = '{most}'; most.dispatchEvent(new Event('input')); }})(\
             document.getElementById('price-most'))"
        ))?;
        until(
            &mut page,
            &format!(
                "document.querySelector('#price-chart .allowed') && luminaire.price.tolerance === {most}"
            ),
        )?;
        Ok::<_, anyhow::Error>((page.text(picked)?, page.message("price-code")?))
    });
    let (rough, strict) = (rough?, strict?);
    ensure!(rough.0.contains("(searched)") && rough != strict, "{rough:?} and {strict:?}");
    ensure!(rough.1.contains("pub const LIGHT: "), "the constant is {:?}", rough.1);
    charts_data(&mut page)?;
    page.must_be_content()
}

/// The functions behind the chart, with small numbers.
fn charts_data(page: &mut Page) -> Result<()> {
    let points = json!([
        { "cost": 100, "error": 2 }, { "cost": 200, "error": 0.5 }, { "cost": 300, "error": 0.5 },
        { "cost": 400, "error": 0.75 }, { "cost": 500, "error": 0.01 },
    ]);
    let front = page.ask(&format!(
        "import('./price-chart.js').then(({{ front }}) => front({points}).map(({{ cost }}) => cost))"
    ))?;
    ensure!(front == json!([100, 200, 500]), "the front is {front}");
    let light = json!({ "beam": 10, "field": 20, "edge": "own", "ownEdge": "hard", "intensity": 3 });
    let described = page.ask(&format!(
        "import('./price-panel.js').then(({{ described }}) => [described({light}, [1, 2]), \
         described({{ ...{light}, ownEdge: 'linear', throw: 4 }})])"
    ))?;
    let [hard, fitted] = [
        json!({ "edge": "hard", "field": 20, "intensity": 3, "near": 1, "far": 2 }),
        json!({ "beam": 10, "field": 20, "intensity": 3, "near": 2, "far": 8 }),
    ];
    ensure!(described == json!([hard, fitted]), "{described}");
    let chips = json!({ "reached": 10 });
    let chip = json!({ "megahertz": 2, "rest": { "f32": { "instructions": 500, "cycles": 700 } } });
    let price = json!({ "instructions": 50, "cycles": 130 });
    let picture = page.ask(&format!(
        "import('./price-panel.js').then(({{ picture }}) => picture({chips}, {chip}, 'f32', {price}))"
    ))?;
    ensure!(picture == json!({ "instructions": 1000, "cycles": 2000, "milliseconds": 1 }), "{picture}");
    Ok(())
}

fn until(page: &mut Page, expression: &str) -> Result<()> {
    let start = Instant::now();
    while !page.holds(&format!("Boolean({expression})"))? {
        if start.elapsed() > PATIENCE {
            let told = page.ask("document.getElementById('price').textContent")?;
            bail!("{expression} is not true after {PATIENCE:?}: {told}");
        }
        thread::sleep(Duration::from_millis(50));
    }
    Ok(())
}
