//! Conversions between [`Vec3`]`<f32>` and `glam::Vec3`.
//!
//! ```
//! use luminaire::Vec3;
//! assert_eq!(Vec3::from(glam::Vec3::X), Vec3::new(1.0, 0.0, 0.0));
//! ```

use crate::vec3::Vec3;

impl From<glam::Vec3> for Vec3<f32> {
    fn from(v: glam::Vec3) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

impl From<Vec3<f32>> for glam::Vec3 {
    fn from(v: Vec3<f32>) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_go_there_and_back() {
        let there = glam::Vec3::from(Vec3::new(1.0, -2.0, 3.5));
        assert_eq!(there, glam::Vec3::new(1.0, -2.0, 3.5));
        assert_eq!(Vec3::from(there), Vec3::new(1.0, -2.0, 3.5));
    }
}
