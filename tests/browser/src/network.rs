//! The demo is one folder and needs nothing else.

use anyhow::{Result, ensure};

use crate::Visitor;

pub(crate) fn stays_at_home(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    let requests = page.requests()?;
    ensure!(
        requests.iter().any(|address| address.ends_with(".wasm")),
        "no WebAssembly was loaded: {requests:?}"
    );
    for address in requests {
        let inside =
            ["data:", "blob:", visitor.address.as_str()].iter().any(|start| address.starts_with(start));
        ensure!(inside, "the page asks for {address}");
    }
    page.must_be_content()
}
