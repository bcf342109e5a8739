//! A panic would be a bug, and a page that stands still without a word a second one.

use std::panic;
use web_sys::{CustomEvent, CustomEventInit, console};

/// The event that tells the page of a panic; its detail is the message.
const EVENT: &str = "luminaire-panic";

/// From here on a panic is told on the console and to the page.
pub(crate) fn tell_the_page() {
    panic::set_hook(Box::new(|panic| {
        let message = panic.to_string().into();
        console::error_1(&message);
        let detail = CustomEventInit::new();
        detail.set_detail(&message);
        if let (Some(window), Ok(event)) =
            (web_sys::window(), CustomEvent::new_with_event_init_dict(EVENT, &detail))
        {
            // Whether a listener prevents the event is nothing that a dying module could act on.
            let _ = window.dispatch_event(&event);
        }
    }));
}
