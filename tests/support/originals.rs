//! The reference for imported lights: the complete formulas of other systems in f64, as their
//! sources write them.
//!
//! Each formula gives the light at a distance and at a cosine of the angle off axis, for a light of
//! intensity 1.

/// A light of another system.
pub struct Original {
    pub name: String,
    /// The cosines of the half angles at which the falloff begins and ends.
    pub inner: f64,
    pub outer: f64,
    /// The falloff, a function of the cosine of the angle off axis.
    pub angle: Box<dyn Fn(f64) -> f64>,
    /// The attenuation, a function of the distance.
    pub distance: Box<dyn Fn(f64) -> f64>,
    /// The distance below which the original stops growing, and its range.
    pub stop: f64,
    pub range: Option<f64>,
}

impl Original {
    /// The light at a cosine and a distance.
    pub fn light(&self, cosine: f64, distance: f64) -> f64 {
        (self.angle)(cosine) * (self.distance)(distance)
    }
}

/// `glLight`: GL_SPOT_CUTOFF, GL_SPOT_EXPONENT, GL_CONSTANT_ATTENUATION and its siblings.
pub fn opengl(cutoff: f32, exponent: f32, [k0, k1, k2]: [f32; 3]) -> Original {
    let name = format!("OpenGL, cutoff {cutoff}, exponent {exponent}, attenuation {k0} {k1} {k2}");
    let (k0, k1, k2) = (f64::from(k0), f64::from(k1), f64::from(k2));
    let (cutoff, exponent) = (f64::from(cutoff), f64::from(exponent));
    let outer = cutoff.to_radians().cos();
    let angle = move |cosine: f64| {
        if cutoff == 180.0 {
            1.0
        } else if cosine < outer {
            0.0
        } else {
            cosine.max(0.0).powf(exponent)
        }
    };
    let distance = move |d: f64| 1.0 / (k0 + k1 * d + k2 * d * d);
    Original {
        name,
        inner: 1.0,
        outer,
        angle: Box::new(angle),
        distance: Box::new(distance),
        stop: 1e-3,
        range: None,
    }
}

/// `D3DLIGHT9`: Theta, Phi, Falloff, Attenuation0 to 2, Range.
pub fn direct3d(theta: f32, phi: f32, falloff: f32, [a0, a1, a2]: [f32; 3], range: f32) -> Original {
    let name = format!("Direct3D, theta {theta}, phi {phi}, falloff {falloff}, attenuation {a0} {a1} {a2}");
    let (a0, a1, a2, range) = (f64::from(a0), f64::from(a1), f64::from(a2), f64::from(range));
    let falloff = f64::from(falloff);
    let [inner, outer] = [theta, phi].map(|angle| (f64::from(angle) / 2.0).cos());
    let angle = move |rho: f64| {
        if rho > inner {
            1.0
        } else if rho <= outer {
            0.0
        } else {
            ((rho - outer) / (inner - outer)).powf(falloff)
        }
    };
    let distance = move |d: f64| if d > range { 0.0 } else { 1.0 / (a0 + a1 * d + a2 * d * d) };
    let range = if range > 1e9 { None } else { Some(range) };
    Original { name, inner, outer, angle: Box::new(angle), distance: Box::new(distance), stop: 1e-3, range }
}

/// `KHR_lights_punctual`: innerConeAngle, outerConeAngle, range; without the `max(0.001, ...)` of
/// its reference code.
pub fn gltf(inner_cone_angle: f32, outer_cone_angle: f32, range: Option<f32>) -> Original {
    let name = format!("glTF, inner {inner_cone_angle}, outer {outer_cone_angle}");
    let range = range.map(f64::from);
    let [inner, outer] = [inner_cone_angle, outer_cone_angle].map(|angle| f64::from(angle).cos());
    let angle = move |cd: f64| {
        if inner == outer {
            return if cd > outer { 1.0 } else { 0.0 };
        }
        let scale = 1.0 / (inner - outer);
        (cd * scale - outer * scale).clamp(0.0, 1.0).powi(2)
    };
    let distance = move |d: f64| {
        let window = range.map_or(1.0, |range| (1.0 - (d / range).powi(4)).clamp(0.0, 1.0));
        window / (d * d)
    };
    Original { name, inner, outer, angle: Box::new(angle), distance: Box::new(distance), stop: 0.0, range }
}

/// `SpotLight` of three.js: angle, penumbra, distance, decay.
pub fn three(angle: f32, penumbra: f32, distance: f32, decay: f32) -> Original {
    let name = format!("three.js, angle {angle}, penumbra {penumbra}, decay {decay}");
    let (cutoff, decay) = (f64::from(distance), f64::from(decay));
    let [inner, outer] = [1.0 - f64::from(penumbra), 1.0].map(|part| (f64::from(angle) * part).cos());
    let smoothstep = move |cosine: f64| {
        if inner == outer {
            return if cosine > outer { 1.0 } else { 0.0 };
        }
        let t = ((cosine - outer) / (inner - outer)).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    };
    let falls = move |d: f64| {
        let window = if cutoff > 0.0 { (1.0 - (d / cutoff).powi(4)).clamp(0.0, 1.0).powi(2) } else { 1.0 };
        window / d.powf(decay).max(0.01)
    };
    let stop = if decay == 0.0 { 0.0 } else { 0.01_f64.powf(1.0 / decay) };
    let range = if cutoff > 0.0 { Some(cutoff) } else { None };
    Original { name, inner, outer, angle: Box::new(smoothstep), distance: Box::new(falls), stop, range }
}

/// `SpotLight3D` of Godot 4: spot_angle, spot_angle_attenuation, spot_range, spot_attenuation.
pub fn godot(spot_angle: f32, angle_attenuation: f32, range: f32, attenuation: f32) -> Original {
    let name =
        format!("Godot, angle {spot_angle}, attenuation {angle_attenuation}, with distance {attenuation}");
    // Computed in single precision, like Godot's light buffer.
    let cone_attenuation = f64::from(1.0 / angle_attenuation);
    let (range, decay) = (f64::from(range), f64::from(attenuation));
    let outer = f64::from(spot_angle).to_radians().cos();
    let angle = move |cosine: f64| {
        let scos = cosine.max(outer);
        let rim = ((1.0 - scos) / (1.0 - outer)).max(0.0001);
        1.0 - rim.powf(cone_attenuation)
    };
    let distance = move |d: f64| {
        let window = (1.0 - (d / range).powi(4)).max(0.0).powi(2);
        window * d.max(0.0001).powf(-decay)
    };
    let (angle, distance) = (Box::new(angle), Box::new(distance));
    Original { name, inner: 1.0, outer, angle, distance, stop: 1e-4, range: Some(range) }
}

/// Full intensity up to the umbra, none from the penumbra on, and in between a line or smoothstep
/// over the cosine. Full angles in degrees.
pub fn penumbra(umbra: f32, penumbra: f32, smooth: bool) -> Original {
    let name = format!("umbra {umbra}, penumbra {penumbra}, smooth {smooth}");
    let [inner, outer] = [umbra, penumbra].map(|angle| (f64::from(angle) / 2.0).to_radians().cos());
    let angle = move |cosine: f64| {
        if inner == outer {
            return if cosine > outer { 1.0 } else { 0.0 };
        }
        let t = ((cosine - outer) / (inner - outer)).clamp(0.0, 1.0);
        if smooth { t * t * (3.0 - 2.0 * t) } else { t }
    };
    let distance = |d: f64| 1.0 / (d * d);
    Original {
        name,
        inner,
        outer,
        angle: Box::new(angle),
        distance: Box::new(distance),
        stop: 0.0,
        range: None,
    }
}
