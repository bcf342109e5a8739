//! A data format with unknown content for `serde`, a logger for `defmt`, and a display of any size.

use core::marker::PhantomData;

use embedded_graphics_core::geometry::Dimensions;
use embedded_graphics_core::pixelcolor::PixelColor;
use embedded_graphics_core::primitives::Rectangle;
use embedded_graphics_core::{Pixel, draw_target::DrawTarget};
use serde_core::de::value::Error;
use serde_core::de::{DeserializeSeed, Deserializer, SeqAccess, Visitor};
use serde_core::forward_to_deserialize_any;
use serde_core::ser::{Impossible, Serialize, SerializeTuple, Serializer};

use crate::{any, sink};

/// Data of which the compiler knows nothing: takes all values, and gives a value of any kind.
#[derive(Clone, Copy, Debug)]
pub struct Data;

/// A display of unknown size.
#[derive(Clone, Copy, Debug)]
pub struct Screen<C>(PhantomData<C>);

impl<C> Dimensions for Screen<C> {
    fn bounding_box(&self) -> Rectangle {
        any()
    }
}

impl<C: PixelColor> DrawTarget for Screen<C> {
    type Color = C;
    type Error = ();

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), ()> {
        pixels.into_iter().for_each(|pixel| sink(pixel.0));
        any()
    }
}

/// Implements methods that take values and have any result.
macro_rules! methods {
    ($($method:ident$(<$value:ident>)?($($type:ty),*) -> $result:ty;)*) => {$(
        fn $method$(<$value: ?Sized + Serialize>)?(self, $(_: $type),*) -> Result<$result, Error> {
            any()
        }
    )*};
}

type Not = Impossible<(), Error>;
type Name = &'static str;

impl Serializer for Data {
    type Ok = ();
    type Error = Error;
    type SerializeSeq = Not;
    type SerializeTuple = Self;
    type SerializeTupleStruct = Not;
    type SerializeTupleVariant = Not;
    type SerializeMap = Not;
    type SerializeStruct = Not;
    type SerializeStructVariant = Not;

    methods! {
        serialize_bool(bool) -> (); serialize_char(char) -> (); serialize_str(&str) -> ();
        serialize_bytes(&[u8]) -> (); serialize_i8(i8) -> (); serialize_i16(i16) -> ();
        serialize_i32(i32) -> (); serialize_i64(i64) -> (); serialize_u8(u8) -> (); serialize_u16(u16) -> ();
        serialize_u32(u32) -> (); serialize_u64(u64) -> (); serialize_f32(f32) -> ();
        serialize_f64(f64) -> (); serialize_none() -> (); serialize_unit() -> ();
        serialize_unit_struct(Name) -> (); serialize_unit_variant(Name, u32, Name) -> ();
        serialize_some<T>(&T) -> (); serialize_newtype_struct<T>(Name, &T) -> ();
        serialize_newtype_variant<T>(Name, u32, Name, &T) -> (); serialize_seq(Option<usize>) -> Not;
        serialize_tuple(usize) -> Self; serialize_tuple_struct(Name, usize) -> Not;
        serialize_tuple_variant(Name, u32, Name, usize) -> Not; serialize_map(Option<usize>) -> Not;
        serialize_struct(Name, usize) -> Not; serialize_struct_variant(Name, u32, Name, usize) -> Not;
    }

    fn collect_str<T: ?Sized + core::fmt::Display>(self, _: &T) -> Result<(), Error> {
        any()
    }
}

impl SerializeTuple for Data {
    type Ok = ();
    type Error = Error;

    fn serialize_element<T: ?Sized + Serialize>(&mut self, value: &T) -> Result<(), Error> {
        value.serialize(*self)
    }

    fn end(self) -> Result<(), Error> {
        any()
    }
}

impl<'de> Deserializer<'de> for Data {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        match any() {
            0_u8 => visitor.visit_i64(any()),
            1 => visitor.visit_u64(any()),
            2 => visitor.visit_f64(any()),
            3 => visitor.visit_f32(any()),
            4 => visitor.visit_str(any()),
            _ => visitor.visit_seq(self),
        }
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 u8 u16 u32 u64 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

impl<'de> SeqAccess<'de> for Data {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Error> {
        if any() { seed.deserialize(*self).map(Some) } else { Ok(None) }
    }
}

#[defmt::global_logger]
struct Logger;

// SAFETY: no program with this logger is ever run.
unsafe impl defmt::Logger for Logger {
    fn acquire() {}
    unsafe fn flush() {}
    unsafe fn release() {}
    unsafe fn write(bytes: &[u8]) {
        sink(bytes);
    }
}
