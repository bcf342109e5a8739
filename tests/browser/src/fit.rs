//! The page fits: telephones, tablets, laptops, and a window that is zoomed to 200 %.

use anyhow::{Result, ensure};

use crate::{Visitor, states};

/// Windows in CSS pixels, and pixels of the device along each of them. The last is a window of 1280
/// x 900 pixels at 200 %.
const WINDOWS: [(u32, u32, f64); 4] = [(390, 844, 1.0), (768, 1024, 1.0), (1280, 900, 1.0), (640, 450, 2.0)];

/// No state has a text that is cut, covered by another or beside its window.
pub(crate) fn nothing_is_cut(visitor: &mut Visitor) -> Result<()> {
    for state in states::ALL {
        let mut page = states::open(visitor, state)?;
        for (width, height, density) in WINDOWS {
            page.resize_on(width, height, density)?;
            page.settle()?;
            let found = page.text("probe.misplaced().join('\\n')")?;
            ensure!(found.is_empty(), "{}, {width} pixels wide:\n{found}", state.0);
        }
        page.must_be_content()?;
    }
    Ok(())
}
