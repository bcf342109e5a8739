//! Mach bands: a wall lit head-on by a clamped linear ramp, and by two falloffs without a kink.

use super::{
    picture::{self, Picture},
    svg::{Drawing, Frame},
};
use luminaire::{
    Angle, Cone, HalfAngle, Rgb, SpotLight, Vec3,
    falloff::{Falloff, Linear, Smooth, Soft},
};
use luminaire_render::{Camera, Material, Mesh, Renderer, Scene};
use std::error::Error;

/// Width and height of a panel, and the gap to the next, in pixels.
const PANEL: usize = 300;
const GAP: usize = 30;
/// Outer and inner angle of the cones, as full angles. They are narrow, so that distance and
/// incidence hardly change the curves.
const OUTER: Angle = Angle::degrees(6.0);
const INNER: Angle = Angle::degrees(3.0);
/// The camera's full angle of view.
const SEEN: Angle = Angle::degrees(7.3);
/// Distance of light and eye from the wall, and height of both, in metres.
const DISTANCE: f32 = 8.0;
const HEIGHT: f32 = 2.0;
/// The wall's reflectance. It is below 1, so that the display has room for a bright band.
const ALBEDO: f32 = 0.75;

const DARK: &str = "#202124";
const GREY: &str = "#5f6368";
const BLUE: &str = "#20639b";
const RED: &str = "#b3261e";

/// A wall under one falloff.
struct Panel {
    title: &'static str,
    remark: &'static str,
    /// The full angles at which the intensity has a kink.
    kinks: &'static [Angle],
    picture: Picture,
    /// The linear light along the middle row, one value per sample.
    row: Vec<f64>,
}

/// The panels side by side.
pub(crate) struct MachBands {
    pub(crate) picture: Picture,
    panels: [Panel; 3],
}

impl MachBands {
    pub(crate) fn draw() -> Result<Self, Box<dyn Error>> {
        let mut renderer = picture::renderer(PANEL, PANEL)?;
        renderer.draw_geometry(&wall()?, &camera());
        let linear = Cone::from_outer(Linear, OUTER)?.with_inner(INNER)?;
        let soft = Cone::from_outer(Soft, OUTER)?;
        let smooth = Cone::from_outer(Smooth, OUTER)?.with_inner(INNER)?;
        let panels = [
            Panel::lit(
                &renderer,
                linear,
                "linear, clamped at a hotspot",
                "a kink is seen as a band",
                &[INNER, OUTER],
            )?,
            Panel::lit(&renderer, soft, "soft", "one multiply, no clamp, no kink", &[])?,
            Panel::lit(
                &renderer,
                smooth,
                "smooth, clamped at the same hotspot",
                "two multiplies, no kink",
                &[],
            )?,
        ];
        let picture = Picture::beside(&panels.each_ref().map(|panel| &panel.picture), GAP);
        Ok(Self { picture, panels })
    }

    /// The light across the middle of each panel and, below, its slope.
    pub(crate) fn curves(&self) -> String {
        let title = "Light across the beam, and its slope, for a linear, a soft and a smooth edge";
        let mut drawing = Drawing::new(self.picture.width as f64, 310.0, title);
        for (number, panel) in self.panels.iter().enumerate() {
            panel.curve(&mut drawing, (number * (PANEL + GAP)) as f64);
        }
        drawing.finish()
    }
}

impl Panel {
    /// The wall under a cone of light.
    fn lit<P: Falloff>(
        renderer: &Renderer<f32>,
        cone: Cone<P>,
        title: &'static str,
        remark: &'static str,
        kinks: &'static [Angle],
    ) -> Result<Self, luminaire::Error> {
        let position = Vec3::new(0.0, HEIGHT, DISTANCE);
        let spot = SpotLight::new(position, Vec3::new(0.0, 0.0, -1.0), cone)?;
        let spot = spot.with_intensity(DISTANCE * DISTANCE)?.compile::<f32>()?;
        let linear = picture::lit(renderer, Rgb::default(), |point, normal| spot.irradiance(point, normal));
        let (width, height) = renderer.size();
        let row = (0..width).map(|x| linear(x, height / 2).green.into()).collect();
        let picture = Picture::develop(renderer, linear);
        Ok(Self { title, remark, kinks, picture, row })
    }

    /// Draws the light of the middle row and its slope, aligned with the panel in the picture.
    /// Across the panel x goes from -1 to 1.
    fn curve(&self, drawing: &mut Drawing, left: f64) {
        let x = [(left, -1.0), (left + PANEL as f64, 1.0)];
        let light = Frame { x, y: [(160.0, 0.0), (44.0, f64::from(ALBEDO))] };
        let slope = Frame { x, y: [(270.0, -3.2), (190.0, 3.2)] };
        for frame in [&light, &slope] {
            let (from, to) = frame.level(0.0);
            drawing.line(from, to, r##"stroke="#dadce0""##);
        }
        for kink in self.kinks.iter().map(|&kink| tangent(kink) / tangent(SEEN)) {
            for (frame, side) in [(&light, -kink), (&light, kink), (&slope, -kink), (&slope, kink)] {
                let [foot, top] = frame.y.map(|(_, value)| frame.place(side, value));
                drawing.line(foot, top, r##"stroke="#b3261e" stroke-dasharray="4 3""##);
            }
        }
        let step = 2.0 / self.row.len() as f64;
        let lights =
            (0..).zip(&self.row).map(|(i, &value)| light.place(step * (f64::from(i) + 0.5) - 1.0, value));
        drawing.path(lights, &format!(r#"fill="none" stroke="{DARK}" stroke-width="2.5""#));
        let slopes = (1..).zip(self.row.windows(2));
        let slopes =
            slopes.map(|(i, pair)| slope.place(step * f64::from(i) - 1.0, (pair[1] - pair[0]) / step));
        drawing.path(slopes, &format!(r#"fill="none" stroke="{BLUE}" stroke-width="2""#));
        let middle = left + PANEL as f64 / 2.0;
        drawing.text((middle, 18.0), "middle", DARK, self.title);
        drawing.text((left, 38.0), "start", DARK, "light");
        drawing.text((left, 184.0), "start", BLUE, "its slope");
        let color = if self.kinks.is_empty() { GREY } else { RED };
        drawing.text((middle, 300.0), "middle", color, self.remark);
    }
}

/// The tangent of half an angle: the distance from the axis at which the ray meets the wall, in
/// units of the wall's distance.
fn tangent(angle: Angle) -> f64 {
    libm::tan(f64::from(HalfAngle::from(angle).to_degrees()).to_radians())
}

/// A wall whose face is at z = 0.
fn wall() -> Result<Scene, luminaire::Error> {
    let mut scene = Scene::new();
    let wall = Mesh::cuboid(8.0, 4.0, 1.0).moved(Vec3::new(0.0, 0.0, -0.5));
    scene.add(wall, Material::new(Rgb::new(ALBEDO, ALBEDO, ALBEDO))?)?;
    Ok(scene)
}

/// A camera at the position of the light.
fn camera() -> Camera {
    Camera::new(Vec3::new(0.0, HEIGHT, 0.0), DISTANCE, 0.0, 0.0, SEEN.to_radians())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Positions, from -1 to 1, at which the slope of a row changes by more than 0.7 within two
    /// samples, as it does only at a kink.
    fn jumps(row: &[f64]) -> Vec<f64> {
        let step = 2.0 / row.len() as f64;
        let slopes: Vec<_> = row.windows(2).map(|pair| (pair[1] - pair[0]) / step).collect();
        let jumps = (2..).zip(slopes.windows(3)).filter(|(_, slopes)| (slopes[2] - slopes[0]).abs() > 0.7);
        jumps.map(|(place, _)| step * f64::from(place) - 1.0).collect()
    }

    /// The rendered light has kinks at the marked positions of the linear panel, and nowhere else.
    #[test]
    fn only_the_linear_edge_has_kinks() {
        let bands = MachBands::draw().expect("sound cones");
        for panel in &bands.panels {
            let marked = panel.kinks.iter().map(|&kink| tangent(kink) / tangent(SEEN));
            let mut marked: Vec<_> = marked.flat_map(|kink| [-kink, kink]).collect();
            for jump in jumps(&panel.row) {
                let near = |kink: &f64| (kink - jump).abs() < 0.005;
                assert!(marked.iter().any(near), "{}: {jump}", panel.title);
            }
            marked.retain(|kink| !jumps(&panel.row).iter().any(|jump| (kink - jump).abs() < 0.005));
            assert!(marked.is_empty(), "{}: no jump at {marked:?}", panel.title);
        }
    }
}
