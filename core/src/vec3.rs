//! Vectors of three components, with only the operations that the kernel needs.

/// A vector of three components: a position, an axis or a normal.
///
/// The user chooses the coordinate system.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[repr(C)]
pub struct Vec3<T> {
    /// First component.
    pub x: T,
    /// Second component.
    pub y: T,
    /// Third component.
    pub z: T,
}

impl<T> Vec3<T> {
    /// Creates a vector from its components.
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    /// Applies `f` to each component.
    #[inline]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Vec3<U> {
        Vec3::new(f(self.x), f(self.y), f(self.z))
    }

    /// Applies `f` to each pair of components.
    #[inline]
    pub fn zip<U, V>(self, other: Vec3<U>, mut f: impl FnMut(T, U) -> V) -> Vec3<V> {
        Vec3::new(f(self.x, other.x), f(self.y, other.y), f(self.z, other.z))
    }
}

impl<T> From<[T; 3]> for Vec3<T> {
    fn from([x, y, z]: [T; 3]) -> Self {
        Self { x, y, z }
    }
}

impl<T> From<Vec3<T>> for [T; 3] {
    fn from(Vec3 { x, y, z }: Vec3<T>) -> Self {
        [x, y, z]
    }
}

impl Vec3<f32> {
    /// Returns the dot product, summed from left to right. The order of the sum determines the
    /// rounding.
    #[inline]
    pub fn dot(self, other: Self) -> f32 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Returns the cross product.
    #[must_use]
    #[inline]
    pub fn cross(self, other: Self) -> Self {
        let [a, b] = [self, other];
        Self::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
    }
}

/// Returns `column[i]`, or the default if `i` is out of bounds. In a loop over `0..N` the compiler
/// removes the bounds check.
#[inline]
pub(crate) fn nth<T: Copy + Default>(column: &[T], i: usize) -> T {
    column.get(i).copied().unwrap_or_default()
}
