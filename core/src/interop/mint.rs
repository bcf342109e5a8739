//! Conversions between [`Vec3`] and `mint::Vector3` or `mint::Point3`, the common types of
//! mathematics crates, and between [`Rgb`] and `mint::Vector3`.
//!
//! ```
//! use luminaire::{Fx16, Scalar, Vec3};
//! let position = mint::Point3 { x: 0.0_f32, y: 4.0, z: 0.0 };
//! assert_eq!(<Fx16 as Scalar>::point(position), Fx16::point([0.0, 4.0, 0.0]));
//! ```

use crate::{color::Rgb, vec3::Vec3};

/// Implements conversions between a vector and a type of mint with the same components.
macro_rules! both_ways {
    ($($other:ident)*) => {$(
        impl<T> From<mint::$other<T>> for Vec3<T> {
            fn from(mint::$other { x, y, z }: mint::$other<T>) -> Self {
                Self { x, y, z }
            }
        }

        impl<T> From<Vec3<T>> for mint::$other<T> {
            fn from(Vec3 { x, y, z }: Vec3<T>) -> Self {
                Self { x, y, z }
            }
        }
    )*};
}

both_ways!(Vector3 Point3);

impl<T> From<mint::Vector3<T>> for Rgb<T> {
    fn from(mint::Vector3 { x, y, z }: mint::Vector3<T>) -> Self {
        Self { red: x, green: y, blue: z }
    }
}

impl<T> From<Rgb<T>> for mint::Vector3<T> {
    fn from(Rgb { red, green, blue }: Rgb<T>) -> Self {
        Self { x: red, y: green, z: blue }
    }
}

/// By default a `Vec3` converts to a mint vector, not to a point.
impl<T> mint::IntoMint for Vec3<T> {
    type MintType = mint::Vector3<T>;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_and_points_go_there_and_back() {
        let ours = Vec3::new(1, -2, 3);
        let (vector, point) = (mint::Vector3::from(ours), mint::Point3::from(ours));
        assert_eq!(vector, mint::Vector3 { x: 1, y: -2, z: 3 });
        assert_eq!(point, mint::Point3 { x: 1, y: -2, z: 3 });
        assert_eq!((Vec3::from(vector), Vec3::from(point)), (ours, ours));
        assert_eq!(mint::Vector3::from(Rgb::from(vector)), vector);
    }

    #[test]
    fn a_generic_caller_gets_a_vector() {
        fn sum<V: mint::IntoMint<MintType = mint::Vector3<i32>>>(v: V) -> i32 {
            let mint::Vector3 { x, y, z } = v.into();
            x + 10 * y + 100 * z
        }
        assert_eq!(sum(Vec3::new(1, 2, 3)), 321);
    }
}
