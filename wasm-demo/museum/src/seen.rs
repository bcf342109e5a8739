//! What a shader knows of a point.

/// A point as a shader receives it, in f32.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Seen {
    /// The way from the light to the point.
    pub way: [f32; 3],
    /// The unit vector along which the light shines.
    pub axis: [f32; 3],
}

impl Seen {
    /// The squared distance to the light.
    pub fn squared_distance(&self) -> f32 {
        dot(self.way, self.way)
    }

    /// The distance to the light.
    pub fn distance(&self) -> f32 {
        self.squared_distance().sqrt()
    }

    /// The cosine of the angle off axis: the product of the axis and the normalised way.
    pub fn cosine(&self) -> f32 {
        self.cosine_at(self.distance())
    }

    /// The cosine of the angle off axis, if this is the distance.
    pub fn cosine_at(&self, distance: f32) -> f32 {
        dot(self.way.map(|c| c / distance), self.axis)
    }
}

/// The inner product, summed from left to right.
pub(crate) fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
