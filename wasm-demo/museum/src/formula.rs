//! What several formulas have in common.

/// The cone of glTF, Filament and Bevy: scale and offset are computed once, from a span of cosines
/// that is at least `least`; a point is scaled, clamped and squared.
pub(crate) fn clamped_span(least: f32, inner: f32, outer: f32) -> impl Fn(f32) -> f32 {
    let scale = 1.0 / least.max(libm::cosf(inner) - libm::cosf(outer));
    let offset = -libm::cosf(outer) * scale;
    move |cosine| {
        let attenuation = (cosine * scale + offset).clamp(0.0, 1.0);
        attenuation * attenuation
    }
}

/// GLSL's smoothstep by the equation of its specification.
pub(crate) fn smoothstep(edge0: f32, edge1: f32, x: f32) -> f32 {
    let t = ((x - edge0) / (edge1 - edge0)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// GLSL's power as processors compute it.
pub(crate) fn glsl_pow(x: f32, y: f32) -> f32 {
    libm::exp2f(y * libm::log2f(x))
}
