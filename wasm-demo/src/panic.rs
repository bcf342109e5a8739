//! Reports panics to the page or the worker. A panic is a bug; a page that stops silently would be a second one.

use std::panic;
use wasm_bindgen::JsCast;
use web_sys::{CustomEvent, CustomEventInit, EventTarget, console, js_sys};

/// Event that reports a panic to the page or the worker; its detail is the message.
const EVENT: &str = "luminaire-panic";

/// Installs a hook that reports panics on the console and to the page or the worker.
pub(crate) fn tell_the_page() {
    panic::set_hook(Box::new(|panic| {
        let message = panic.to_string().into();
        console::error_1(&message);
        let detail = CustomEventInit::new();
        detail.set_detail(&message);
        if let (Ok(scope), Ok(event)) = (
            js_sys::global().dyn_into::<EventTarget>(),
            CustomEvent::new_with_event_init_dict(EVENT, &detail),
        ) {
            // The result is ignored: after a panic it makes no difference whether a listener
            // prevents the event.
            let _ = scope.dispatch_event(&event);
        }
    }));
}
