//! The demo is one folder, needs nothing else, and runs nothing else.

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

/// The page's policy forbids code and data from anywhere else, also from the page itself.
pub(crate) fn policy_forbids_the_rest(visitor: &mut Visitor) -> Result<()> {
    let mut page = visitor.ready()?;
    for (directive, act) in [
        (
            "script-src-elem",
            "document.head.append(Object.assign(document.createElement('script'), { text: '0' }))",
        ),
        ("script-src", "setTimeout('0')"),
        ("script-src-elem", "import('https://example.org/a.js').catch(() => {})"),
        (
            "style-src-elem",
            "document.head.append(Object.assign(document.createElement('style'), { textContent: 'a{}' }))",
        ),
        ("img-src", "(new Image()).src = 'data:image/gif;base64,R0lGODlhAQABAAAAACw='"),
        ("connect-src", "fetch('https://example.org/').catch(() => {})"),
    ] {
        let found = page.text(&format!(
            "new Promise((resolve) => {{
                addEventListener('securitypolicyviolation', (event) => resolve(event.effectiveDirective), {{ once: true }});
                {act};
                setTimeout(resolve, 5000, 'nothing');
            }})"
        ))?;
        ensure!(found == directive, "{act}: expected {directive} to forbid it, found {found}");
    }
    Ok(())
}
