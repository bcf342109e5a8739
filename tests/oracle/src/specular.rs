//! Specular lobes, and the classic equation of one light.

use glam::DVec3;

/// A highlight: from the unit directions to the light and to the eye, the unit normal and the
/// shininess.
pub type Lobe = fn(DVec3, DVec3, DVec3, f64) -> f64;

/// `max(0, R.V)^m`: Phong 1975.
pub fn phong(to_light: DVec3, to_eye: DVec3, normal: DVec3, shininess: f64) -> f64 {
    libm::pow((-to_light).reflect(normal).dot(to_eye).max(0.0), shininess)
}

/// `max(0, N.H)^m`: Blinn 1977.
pub fn blinn_phong(to_light: DVec3, to_eye: DVec3, normal: DVec3, shininess: f64) -> f64 {
    libm::pow(normal.dot((to_light + to_eye).normalize()).max(0.0), shininess)
}

/// `clamp(R.H)^m`, as the dual-cone article's shader writes it.
pub fn dual_cone(to_light: DVec3, to_eye: DVec3, normal: DVec3, shininess: f64) -> f64 {
    let halfway = (to_light + to_eye).normalize();
    libm::pow((-to_light).reflect(normal).dot(halfway).clamp(0.0, 1.0), shininess)
}

/// Lyon's difference form of Phong's lobe by two squarings.
pub fn lyon(to_light: DVec3, to_eye: DVec3, normal: DVec3, shininess: f64) -> f64 {
    let versine = (-to_light).reflect(normal).distance_squared(to_eye) / 2.0;
    crate::power_4((1.0 - shininess / 4.0 * versine).max(0.0))
}

/// One channel of the classic equation for one light:
/// `ma Ia + f(d) spot [md Is max(0, N.L) + ms Is max(0, R.V)^mh]`. A surface that faces away has no
/// highlight.
#[derive(Clone, Copy, Debug)]
pub struct Classic {
    /// `ma` and `Ia`.
    pub ambient: [f64; 2],
    /// `md`, and the light for it.
    pub diffuse: [f64; 2],
    /// `ms`, and the light for it.
    pub specular: [f64; 2],
    /// The exponent `mh`.
    pub shininess: f64,
}

impl Classic {
    /// Returns the light that a surface sends to the eye, of the light `arriving` at it head-on.
    /// Lambert's cosine uses the normal as it is stored, and the mirror direction the normalised
    /// one.
    pub fn light(&self, arriving: f64, to_light: DVec3, to_eye: DVec3, normal: DVec3) -> f64 {
        let [ma, ia] = self.ambient;
        let [md, diffuse] = self.diffuse;
        let [ms, specular] = self.specular;
        let cosine = to_light.dot(normal).max(0.0);
        let lobe = match cosine {
            0.0 => 0.0,
            _ => phong(to_light, to_eye, normal.normalize(), self.shininess),
        };
        ma * ia + arriving * (md * diffuse * cosine + ms * specular * lobe)
    }
}
