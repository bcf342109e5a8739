//! Browsers that cannot show the demo. The page may complain on the console, too; what counts is what is visible.

use anyhow::{Result, ensure};

use super::Visitor;

pub(super) fn without_simd(visitor: &mut Visitor) -> Result<()> {
    is_told(visitor, "WebAssembly.validate = () => false", "simd")
}

pub(super) fn without_canvas(visitor: &mut Visitor) -> Result<()> {
    is_told(visitor, "HTMLCanvasElement.prototype.getContext = () => null", "canvas")
}

fn is_told(visitor: &mut Visitor, script: &str, cause: &str) -> Result<()> {
    let mut page = visitor.failed(script)?;
    let message = page.message("failure")?;
    ensure!(message.to_lowercase().contains(cause), "the message does not name {cause}: {message:?}");
    ensure!(page.shows("failure")?, "the message cannot be seen: {message:?}");
    Ok(())
}
