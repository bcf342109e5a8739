//! The lighting pass: the irradiance at each pixel, and the light that the surface there reflects
//! to the eye.

pub(crate) mod air;
pub(crate) mod block;
mod filter;
pub(crate) mod part;
mod places;
pub(crate) mod prepared;
pub(crate) mod reach;
pub(crate) mod rig;

use crate::{
    buffer::{LANES, Lights, Radiance},
    light::{block::Block, filter::Filter, part::Part, prepared::Prepared},
    scene::{Highlight, Material},
    shadow::Shadows,
    space::{bounds::Bounds, directions::Directions},
};
use glam::Vec2;
use luminaire::{
    Angle, Rgb, Scalar, Vec3,
    dynamic::{CompiledAnyLight, RenderPlan},
    light::{Incident, LightModel, SurfacePoint, SurfacePoints},
    specular::{NoSpecular, SpecularLobe},
};

/// A material, and its colours and its highlight compiled for a number format.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Finish<S: Scalar> {
    material: Material,
    albedo: Rgb<S>,
    specular: Rgb<S>,
    pub(crate) highlight: <Highlight as SpecularLobe>::Constants<S>,
    /// Radius of the specular lobe, as a chord. A light causes a highlight only if the chord
    /// between the mirrored view direction and the direction to the light is at most this radius.
    pub(crate) lobe: f32,
}

/// The inputs of the lighting pass that all blocks share.
#[derive(Debug)]
pub struct Setting<'a, S: Scalar> {
    pub(crate) plan: RenderPlan,
    pub(crate) eye: Vec3<S::Length>,
    /// The position of the eye in `f32`, to test it against bounding volumes.
    pub(crate) viewpoint: glam::Vec3,
    pub(crate) ambient: Rgb<f32>,
    /// The materials by number.
    pub(crate) finishes: &'a [Finish<S>],
    pub(crate) shadows: &'a Shadows<S>,
}

/// Scratch memory for lighting a block.
///
/// The memory is reused without clearing, because clearing for each block would cost as much as a
/// light.
#[derive(Clone, Debug)]
pub struct Workspace<S: Scalar> {
    /// The numbers of the shiny materials in the block.
    shining: [u32; LANES],
    /// For each shiny material, the bounds of its surface points and of the mirrored view
    /// directions at these points.
    parts: [Option<(Bounds, Directions)>; LANES],
    /// The view directions, mirrored at the surfaces.
    views: Vec3<[S::Unit; LANES]>,
    /// Irradiance and highlight of one light.
    arrivals: Incident<Lights<S>>,
    /// The highlights of one light on several materials.
    lobes: Lights<S>,
    filter: Filter<S>,
    /// Irradiance and highlights of all lights.
    sums: Incident<Rgb<Lights<S>>>,
}

impl<S: Scalar> Default for Workspace<S> {
    fn default() -> Self {
        let dark = [S::Irradiance::default(); LANES];
        let sum = Rgb::new(dark, dark, dark);
        Self {
            shining: [0; LANES],
            parts: [None; LANES],
            views: Vec3::default().map(|()| [S::Unit::default(); LANES]),
            arrivals: Incident { diffuse: dark, specular: dark },
            lobes: dark,
            filter: Filter::default(),
            sums: Incident { diffuse: sum, specular: sum },
        }
    }
}

impl<S: Scalar> Finish<S> {
    pub(crate) fn new(material: Material) -> Self {
        let shininess = material.shininess();
        let end = Angle::from_versine(Highlight::end(shininess)).to_radians() / 2.0;
        let lobe = 2.0 * Vec2::from_angle(end / 2.0).y;
        let [albedo, specular] = [material.albedo(), material.specular()].map(|color| color.map(S::from_f32));
        Self { material, albedo, specular, highlight: Highlight::constants::<S>(shininess), lobe }
    }

    pub(crate) fn material(&self) -> &Material {
        &self.material
    }
}

impl<S: Scalar> Setting<'_, S> {
    /// Lights the pixels of a block. Returns the number of lights that were evaluated with a
    /// highlight.
    #[inline(always)]
    pub(crate) fn light(
        &self,
        block: &Block<S>,
        fixtures: &[&Prepared<S>],
        work: &mut Workspace<S>,
        radiance: &mut Radiance<S>,
    ) -> usize {
        fill::<S>(&mut work.sums.diffuse, self.ambient.map(|channel| S::ONE.light(S::gain(channel))));
        let glints = match self.shining(block, &mut work.shining) {
            0 => self.light_matte(block, fixtures, work),
            kinds => self.light_shining(block, kinds, fixtures, work),
        };
        let Incident { diffuse, specular } = &work.sums;
        self.reflect(block, diffuse, |of| of.albedo, radiance, |_, light| light);
        if glints > 0 {
            self.reflect(block, specular, |of| of.specular, radiance, |sum, light| sum + light);
        }
        glints
    }

    /// Computes the irradiance from all lights at each surface point of a block of matte materials.
    /// Returns 0, the number of lights with a highlight.
    #[inline(always)]
    fn light_matte(&self, block: &Block<S>, fixtures: &[&Prepared<S>], work: &mut Workspace<S>) -> usize {
        let Workspace { views, arrivals, filter, sums, .. } = work;
        for fixture in fixtures {
            self.evaluate::<NoSpecular>(&fixture.light, &surfaces(block, views), &(), arrivals);
            let Incident { diffuse, specular } = arrivals;
            if fixture.is_filtered() {
                specular.fill(S::Irradiance::default());
                filter.apply(fixture, self.shadows, block, [diffuse, specular]);
            }
            add::<S>(&mut sums.diffuse, diffuse, fixture.light.color());
        }
        0
    }

    /// Computes the light from all lights at each surface point of a block with `kinds` shiny materials. Returns the number of lights with
    /// a highlight that the eye may see.
    #[inline(always)]
    fn light_shining(
        &self,
        block: &Block<S>,
        kinds: usize,
        fixtures: &[&Prepared<S>],
        work: &mut Workspace<S>,
    ) -> usize {
        for (&number, part) in work.shining[..kinds].iter().zip(&mut work.parts) {
            *part = self.mirrored(block, number);
        }
        let mut glints = 0;
        for fixture in fixtures {
            let shines = self.arrive_shining(block, kinds, fixture, glints == 0, work);
            let Workspace { arrivals: Incident { diffuse, specular }, lobes, filter, sums, .. } = &mut *work;
            let highlights = if block.is_uniform { specular } else { lobes };
            if fixture.is_filtered() {
                if !shines {
                    highlights.fill(S::Irradiance::default());
                }
                filter.apply(fixture, self.shadows, block, [diffuse, highlights]);
            }
            add::<S>(&mut sums.diffuse, diffuse, fixture.light.color());
            if shines {
                glints += 1;
                add::<S>(&mut sums.specular, highlights, fixture.light.specular_color());
            }
        }
        glints
    }

    /// Evaluates a light, with the highlights that the eye may see. The highlights are written to
    /// `arrivals`, or to `lobes` if the block has several materials. Returns whether there are any
    /// highlights. For the first light with highlights, the function also clears the sum of the
    /// highlights.
    #[inline(always)]
    fn arrive_shining(
        &self,
        block: &Block<S>,
        kinds: usize,
        fixture: &Prepared<S>,
        is_first: bool,
        work: &mut Workspace<S>,
    ) -> bool {
        let Workspace { shining, parts, views, arrivals, lobes, sums, .. } = work;
        let dark = S::Irradiance::default();
        let mut shines = false;
        for (&number, part) in shining[..kinds].iter().zip(&*parts) {
            let finish = &self.finishes[number as usize];
            if self.misses_highlight(finish, part, fixture) {
                continue;
            }
            if is_first && !shines {
                self.look(block, views);
                fill::<S>(&mut sums.specular, Rgb::new(dark, dark, dark));
            }
            self.evaluate::<Highlight>(&fixture.light, &surfaces(block, views), &finish.highlight, arrivals);
            if !block.is_uniform {
                if !shines {
                    lobes.fill(dark);
                }
                take_where(number, block, &arrivals.specular, lobes);
            }
            shines = true;
        }
        if !shines {
            self.evaluate::<NoSpecular>(&fixture.light, &surfaces(block, views), &(), arrivals);
        }
        shines
    }

    /// Returns true only if the eye sees no highlight of this light on surfaces with this finish.
    #[inline(always)]
    fn misses_highlight(
        &self,
        finish: &Finish<S>,
        mirrored: &Option<(Bounds, Directions)>,
        fixture: &Prepared<S>,
    ) -> bool {
        let Some((bounds, mirrored)) = mirrored else { return false };
        let Some(to_light) = fixture.reach.directions_from(bounds) else { return false };
        self.plan.skips() && mirrored.are_apart(&to_light, finish.lobe)
    }

    /// Computes the light that the surfaces of a block reflect, and sets the radiance to `sum` of it and
    /// this light. `color` selects the reflectance of the material.
    #[inline(always)]
    fn reflect(
        &self,
        block: &Block<S>,
        light: &Rgb<Lights<S>>,
        color: impl Fn(&Finish<S>) -> Rgb<S>,
        radiance: &mut Radiance<S>,
        sum: impl Fn(S::Irradiance, S::Irradiance) -> S::Irradiance,
    ) {
        let color = |number: u32| color(&self.finishes[number as usize]);
        let Rgb { red, green, blue } = radiance;
        if let Some(number) = block.only_material() {
            let color = color(number);
            for (to, light, color) in [
                (red, &light.red, color.red),
                (green, &light.green, color.green),
                (blue, &light.blue, color.blue),
            ] {
                let light = S::filter_each(light, color);
                for lane in 0..LANES {
                    to[lane] = sum(to[lane], light[lane]);
                }
            }
            return;
        }
        for lane in 0..LANES {
            let color = color(block.material[lane]);
            red[lane] = sum(red[lane], S::filter(light.red[lane], color.red));
            green[lane] = sum(green[lane], S::filter(light.green[lane], color.green));
            blue[lane] = sum(blue[lane], S::filter(light.blue[lane], color.blue));
        }
    }

    /// Evaluates a light at all pixels of a block, by the loop for the kind of the light.
    ///
    /// If the plan skips nothing, the general function evaluates the light point by point.
    #[inline(always)]
    fn evaluate<H: SpecularLobe>(
        &self,
        light: &CompiledAnyLight<S>,
        surfaces: &SurfacePoints<'_, S, LANES>,
        highlight: &H::Constants<S>,
        arrivals: &mut Incident<Lights<S>>,
    ) {
        if self.plan.skips() {
            return light.evaluate_each::<H, LANES>(surfaces, highlight, arrivals);
        }
        for lane in 0..LANES {
            let arrival = light.evaluate::<H>(&surfaces.at(lane), highlight, false);
            arrivals.diffuse[lane] = arrival.diffuse;
            arrivals.specular[lane] = arrival.specular;
        }
    }

    /// Collects the indices of the shiny materials in a block, without duplicates. If the plan skips
    /// nothing, all materials count as shiny. Returns the count.
    #[inline(always)]
    fn shining(&self, block: &Block<S>, numbers: &mut [u32; LANES]) -> usize {
        let shines = |number: u32| !self.plan.skips() || self.finishes[number as usize].material.shines();
        let mut count = 0;
        let mut note = |number: u32| {
            if shines(number) && !numbers[..count].contains(&number) {
                numbers[count] = number;
                count += 1;
            }
        };
        match block.only_material() {
            Some(number) => note(number),
            None => block.material.iter().for_each(|&number| note(number)),
        }
        count
    }

    /// Returns the bounds of a material's surface points and of the mirrored view directions at
    /// these points.
    #[inline(always)]
    fn mirrored(&self, block: &Block<S>, number: u32) -> Option<(Bounds, Directions)> {
        let Part { bounds, normals } = block.part(number)?;
        Some((bounds, Directions::towards(self.viewpoint, &bounds)?.mirrored(&normals)))
    }

    /// Computes the view directions, mirrored at the surfaces.
    #[inline(always)]
    fn look(&self, block: &Block<S>, views: &mut Vec3<[S::Unit; LANES]>) {
        for lane in 0..LANES {
            let surface = SurfacePoint::<S>::seen_from(self.eye, block.point_at(lane), block.normal_at(lane));
            let view = S::mirror(surface.view, surface.normal);
            views.x[lane] = view.x;
            views.y[lane] = view.y;
            views.z[lane] = view.z;
        }
    }
}

/// Borrows the surface points of a block.
fn surfaces<'a, S: Scalar>(
    block: &'a Block<S>,
    views: &'a Vec3<[S::Unit; LANES]>,
) -> SurfacePoints<'a, S, LANES> {
    SurfacePoints { point: borrowed(&block.point), normal: borrowed(&block.normal), view: borrowed(views) }
}

fn borrowed<T>(columns: &Vec3<T>) -> Vec3<&T> {
    Vec3::new(&columns.x, &columns.y, &columns.z)
}

/// Copies the light of the pixels that have the material with this number.
#[inline(always)]
fn take_where<S: Scalar>(number: u32, block: &Block<S>, from: &[S::Irradiance], to: &mut Lights<S>) {
    for ((to, &from), &material) in to.iter_mut().zip(from).zip(&block.material) {
        *to = if material == number { from } else { *to };
    }
}

/// Sets every pixel to the same light.
#[inline(always)]
fn fill<S: Scalar>(lights: &mut Rgb<Lights<S>>, light: Rgb<S::Irradiance>) {
    lights.red.fill(light.red);
    lights.green.fill(light.green);
    lights.blue.fill(light.blue);
}

/// Adds light, multiplied by its colour.
#[inline(never)]
fn add<S: Scalar>(sum: &mut Rgb<Lights<S>>, light: &Lights<S>, color: Rgb<S>) {
    let Rgb { red, green, blue } = sum;
    for (sum, color) in [(red, color.red), (green, color.green), (blue, color.blue)] {
        let light = S::filter_each(light, color);
        for lane in 0..LANES {
            sum[lane] += light[lane];
        }
    }
}
