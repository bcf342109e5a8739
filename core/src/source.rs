//! Formatting of values as constant expressions of Rust: see [`codegen`](crate::codegen).

use core::{
    fmt::{self, Formatter},
    marker::PhantomData,
};

/// A value that can be written as a constant expression of Rust.
pub trait Source {
    /// Writes the expression. The expression uses the names of the public modules.
    ///
    /// # Errors
    /// The errors of the formatter.
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result;
}

/// A type whose name must be part of the generated text, because nothing else in the text
/// determines the type.
pub trait Named {
    /// Writes the type's name.
    ///
    /// # Errors
    /// The errors of the formatter.
    fn write_name(out: &mut Formatter<'_>) -> fmt::Result;
}

/// Wraps a compiled value for display as a constant expression.
///
/// The expression is a block that imports the names it uses. [`codegen`](crate::codegen) lists the
/// supported values.
pub fn as_source<T: Source>(value: &T) -> AsSource<'_, T> {
    AsSource(value)
}

/// The version of this crate.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Fails to compile unless the version is that of this crate: every text of [`as_source`] begins
/// with such a constant, as the bits behind it may mean another light in another version.
///
/// ```compile_fail
/// const _: () = luminaire::codegen::written_by("0.0.9");
/// ```
///
/// # Panics
/// Another version.
pub const fn written_by(version: &str) {
    let (own, other) = (VERSION.as_bytes(), version.as_bytes());
    let mut same = own.len() == other.len();
    let mut at = 0;
    while same && at < own.len() {
        same = own[at] == other[at];
        at += 1;
    }
    assert!(same, "the constants are of another version of luminaire: write them again");
}

/// A value that displays as a constant expression. Created by [`as_source`].
#[derive(Clone, Copy, Debug)]
pub struct AsSource<'a, T>(&'a T);

impl<T: Source> fmt::Display for AsSource<'_, T> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let import = "use ::luminaire::{attenuation::*, codegen::*, display::*, draw::*, falloff::*, haze::*, light::*, number::*, projector::*, specular::*, *};";
        let reason = "an expression need not have names of both kinds";
        write!(
            out,
            "{{\nconst _: () = ::luminaire::codegen::written_by({VERSION:?});\n\
             #[allow(unused_imports, reason = \"{reason}\")]\n{import}\n{:#?}\n}}\n",
            Written(self.0)
        )
    }
}

/// Formats the expression alone. The formatter's list builders require the trait `Debug`.
pub(crate) struct Written<'a, T: ?Sized>(pub(crate) &'a T);

impl<T: Source + ?Sized> fmt::Debug for Written<'_, T> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        self.0.write(out)
    }
}

/// A type that displays as its name.
#[allow(unreachable_pub, reason = "public with the feature arithmetic")]
#[derive(Debug)]
pub struct Name<T>(PhantomData<T>);

impl<T: Named> fmt::Display for Name<T> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        T::write_name(out)
    }
}

/// Returns the name of a type for display.
#[allow(unreachable_pub, reason = "public with the feature arithmetic")]
pub fn name<T: Named>() -> Name<T> {
    Name(PhantomData)
}

/// Writes a function call, with one argument per line.
pub(crate) fn call(out: &mut Formatter<'_>, function: &str, arguments: &[&dyn Source]) -> fmt::Result {
    let mut call = out.debug_tuple(function);
    for argument in arguments {
        call.field(&Written(*argument));
    }
    call.finish()
}

/// Implements [`Source`] as a call of `from_bits`.
macro_rules! written_by_bits {
    ($($name:ident)*) => {$(
        impl $crate::source::Source for $name {
            fn write(&self, out: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                write!(out, "{}::from_bits({:?})", stringify!($name), self.to_bits())
            }
        }
    )*};
}

/// Implements [`Source`] by `Debug`, for unit types and their variants.
macro_rules! written_by_debug {
    ($($name:ident)*) => {$(
        impl $crate::source::Source for $name {
            fn write(&self, out: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                write!(out, "{self:?}")
            }
        }
    )*};
}

/// Implements [`Named`] for types without parameters.
macro_rules! named {
    ($($name:ident)*) => {$(
        impl $crate::source::Named for $name {
            fn write_name(out: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                out.write_str(stringify!($name))
            }
        }
    )*};
}

pub(crate) use {named, written_by_bits, written_by_debug};

impl Source for () {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.write_str("()")
    }
}

impl Source for u32 {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "{self}")
    }
}

impl<A: Source, B: Source> Source for (A, B) {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        call(out, "", &[&self.0, &self.1])
    }
}

impl<T: Source, const N: usize> Source for [T; N] {
    fn write(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.debug_list().entries(self.iter().map(Written)).finish()
    }
}
