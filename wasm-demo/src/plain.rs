//! Plain objects of JavaScript, with their types in TypeScript.

use wasm_bindgen::JsValue;
use web_sys::js_sys::{Object, Reflect};

/// Returns an object with these properties.
pub(crate) fn object<const N: usize>(properties: [(&str, JsValue); N]) -> JsValue {
    let object = Object::new();
    for (name, value) in properties {
        // A new object takes every property.
        let _ = Reflect::set(&object, &name.into(), &value);
    }
    object.into()
}

/// Declares a function that returns a plain object, and the object's interface for the page's scripts:
/// each property has its name, its type and its value.
macro_rules! plain {
    (
        $(#[$text:meta])*
        fn $function:ident($($of:ident: $Of:ty),+) -> $Interface:ident {
            $($name:literal: $kind:literal = $value:expr,)+
        }
    ) => {
        const _: () = {
            #[wasm_bindgen::prelude::wasm_bindgen(typescript_custom_section)]
            const INTERFACE: &str = concat!(
                "export interface ", stringify!($Interface), " { ",
                $($name, ": ", $kind, "; ",)+
                "}"
            );
        };

        $(#[$text])*
        pub(crate) fn $function($($of: $Of),+) -> wasm_bindgen::JsValue {
            $crate::plain::object([$(($name, $value.into())),+])
        }
    };
}
pub(crate) use plain;
