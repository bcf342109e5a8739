//! Spotlights: their words, their light, and how they change.

use luminaire::{
    Fx16, Fx32, Length, Rgb, Vec3,
    codegen::{ConeParts, FixedRamp, Gain16},
    falloff::SoftOrHard,
    light::{CompiledCone, CompiledSpotLight},
    number::Light16,
};

use crate::edge::{CompiledEdge, Edge};

/// The light as the kernel holds it.
pub(crate) type Light = CompiledSpotLight<Fx16, Edge>;

/// A point, in steps of 2^-16.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct luminaire_point {
    /// First component.
    pub x: i32,
    /// Second component.
    pub y: i32,
    /// Third component.
    pub z: i32,
}

/// A normal of unit length, in steps of 2^-14.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct luminaire_normal {
    /// First component.
    pub x: i16,
    /// Second component.
    pub y: i16,
    /// Third component.
    pub z: i16,
}

/// Linear light, in steps of 2^-14 of full scale, which it may exceed.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct luminaire_light {
    /// The red channel.
    pub red: u32,
    /// The green channel.
    pub green: u32,
    /// The blue channel.
    pub blue: u32,
}

/// A spotlight with the inverse square of the distance.
///
/// With all words zero it is dark. What the words mean may change in any version.
#[repr(C)]
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct luminaire_spot {
    /// The words.
    pub words: [u32; 23],
}

impl luminaire_point {
    pub(crate) fn place(self) -> Vec3<Length> {
        Vec3::new(self.x, self.y, self.z).map(Length::from_bits)
    }
}

impl luminaire_normal {
    pub(crate) fn vector(self) -> Vec3<Fx16> {
        Vec3::new(self.x, self.y, self.z).map(Fx16::from_bits)
    }
}

impl luminaire_light {
    pub(crate) fn of(light: Rgb<Light16>) -> Self {
        let [red, green, blue] = <[Light16; 3]>::from(light).map(Light16::to_bits);
        Self { red, green, blue }
    }

    pub(crate) fn sum(self) -> Rgb<Light16> {
        Rgb::new(self.red, self.green, self.blue).map(Light16::from_bits)
    }
}

impl luminaire_spot {
    /// The light with these words. They have a meaning whatever their bits are.
    #[inline]
    pub(crate) fn light(&self) -> Light {
        // No function reads the falloff of which the edge was compiled, so the words lack it.
        const NOT_READ: Edge = Edge::Given(SoftOrHard::Soft);
        let [
            x,
            y,
            z,
            along_x,
            along_y,
            along_z,
            ramp @ ..,
            kind,
            g,
            h,
            mantissa,
            shift,
            near,
            red_green,
            blue_outside,
        ] = self.words;
        let length = |word: u32| Length::from_bits(word.cast_signed());
        let unit = |word: u32| Fx32::from_bits(word.cast_signed());
        let channel = |word: u32| Fx16::from_bits(word as u16 as i16);
        let color = Rgb::new(channel(red_green), channel(red_green >> 16), channel(blue_outside));
        let edge = CompiledEdge::of_words([kind, g, h]);
        Light::from_parts(
            Vec3::new(x, y, z).map(length),
            Vec3::new(along_x, along_y, along_z).map(unit),
            CompiledCone::from_parts(FixedRamp::from_bits(ramp), NOT_READ, edge),
            channel(blue_outside >> 16),
            (),
            Gain16::from_bits([mantissa, shift].map(u32::cast_signed)),
            near,
            [color; 2],
        )
    }

    /// The words of a light and of its edge.
    pub(crate) fn of(light: Light, edge: [u32; 3]) -> Self {
        let parts = light.parts();
        let position = parts.position.map(|c| c.to_bits().cast_unsigned());
        let word = |scalar: Fx16| u32::from(scalar.to_bits().cast_unsigned());
        // A spotlight has a cone; without one, the light would be dark.
        let Some(ConeParts { axis, ramp, outside }) = parts.cone else { return Self::default() };
        let axis = axis.map(|c| c.to_bits().cast_unsigned());
        let [mantissa, shift] = parts.intensity.to_bits().map(i32::cast_unsigned);
        let color = light.color();
        let rest = [
            mantissa,
            shift,
            parts.fine_below,
            word(color.red) | word(color.green) << 16,
            word(color.blue) | word(outside) << 16,
        ];
        let place = <[u32; 3]>::from(position).into_iter().chain(<[u32; 3]>::from(axis));
        let values = place.chain(ramp.to_bits()).chain(edge).chain(rest);
        let mut words = [0; 23];
        words.iter_mut().zip(values).for_each(|(word, value)| *word = value);
        Self { words }
    }

    fn edge(&self) -> [u32; 3] {
        let [.., kind, g, h, _, _, _, _, _] = self.words;
        [kind, g, h]
    }
}

/// The light at a pointer, or a dark one at a null pointer.
pub(crate) fn or_dark(spot: Option<&luminaire_spot>) -> &luminaire_spot {
    const DARK: &luminaire_spot = &luminaire_spot { words: [0; 23] };
    spot.unwrap_or(DARK)
}

fn change(spot: Option<&mut luminaire_spot>, change: impl FnOnce(Light) -> Light) {
    try_to(spot, |light| Some(change(light)));
}

fn try_to(spot: Option<&mut luminaire_spot>, change: impl FnOnce(Light) -> Option<Light>) -> bool {
    let Some(spot) = spot else { return false };
    change(spot.light()).is_some_and(|light| {
        *spot = luminaire_spot::of(light, spot.edge());
        true
    })
}

/// Returns the irradiance at a surface point, before the light's colour.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_spot_irradiance(
    spot: Option<&luminaire_spot>,
    point: luminaire_point,
    normal: luminaire_normal,
) -> u32 {
    or_dark(spot).light().irradiance(point.place(), normal.vector()).to_bits()
}

/// Returns the light at a surface point: the irradiance times the light's colour.
///
/// Each call checks the words of the light. `luminaire_vertices` and `luminaire_row_add` check them once
/// for many points.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_spot_light(
    spot: Option<&luminaire_spot>,
    point: luminaire_point,
    normal: luminaire_normal,
) -> luminaire_light {
    let light = or_dark(spot).light();
    luminaire_light::of(Rgb::lit(light.irradiance(point.place(), normal.vector()), light.color()))
}

/// Returns the falloff of the cone at a point, from 0 to 2^14.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_spot_falloff(spot: Option<&luminaire_spot>, point: luminaire_point) -> i16 {
    or_dark(spot).light().falloff_at(point.place()).to_bits()
}

/// Returns whether the light may reach points within `radius` of `center`; the radius has steps of
/// 2^-16.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_spot_can_reach(
    spot: Option<&luminaire_spot>,
    center: luminaire_point,
    radius: i32,
) -> bool {
    or_dark(spot).light().can_reach(center.place(), Length::from_bits(radius))
}

/// Moves the light; its axis stays.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_spot_move(spot: Option<&mut luminaire_spot>, position: luminaire_point) {
    change(spot, |light| light.moved_to(position.place()));
}

/// Aims the light at a point. Returns false, and leaves the light as it is, if the point is the
/// light's position.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_spot_aim(spot: Option<&mut luminaire_spot>, point: luminaire_point) -> bool {
    try_to(spot, |light| light.aimed_at(point.place()))
}

/// Aims the light along a vector of any length. Returns false, and leaves the light as it is, if the
/// vector is zero.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_spot_aim_along(
    spot: Option<&mut luminaire_spot>,
    x: i32,
    y: i32,
    z: i32,
) -> bool {
    try_to(spot, |light| light.aimed_along(Vec3::new(x, y, z).map(Length::from_bits)))
}

/// Dims the light to a part of its intensity, in steps of 2^-14 from 0 to 2^14.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_spot_dim(spot: Option<&mut luminaire_spot>, part: i16) {
    change(spot, |light| light.dimmed(Fx16::from_bits(part)));
}

/// Gives the light a linear colour, in steps of 2^-14 from 0 to 2^14.
#[unsafe(no_mangle)]
pub extern "C" fn luminaire_spot_tint(spot: Option<&mut luminaire_spot>, red: i16, green: i16, blue: i16) {
    change(spot, |light| light.with_color(Rgb::new(red, green, blue).map(Fx16::from_bits)));
}

/// Gives the light a cone between its own (`part` 0) and that of another light (`part` 2^14). The
/// edge of the light keeps its shape.
///
/// # Safety
/// Each pointer is null or points to a light, which may be the same.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn luminaire_spot_zoom(
    spot: *mut luminaire_spot,
    other: *const luminaire_spot,
    part: i16,
) {
    // SAFETY: as the caller promises; nothing is written before both are read.
    let (Some(from), Some(to)) = (unsafe { spot.as_ref() }, unsafe { other.as_ref() }) else { return };
    let light = from.light().zoomed(&to.light(), Fx16::from_bits(part));
    let zoomed = luminaire_spot::of(light, from.edge());
    // SAFETY: as the caller promises.
    unsafe { spot.write(zoomed) };
}
