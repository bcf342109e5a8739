//! The lighting pass: how much light arrives at each pixel, and how much of it the surface sends to the eye.

use crate::{
    bounds::Reach,
    gbuffer::{Block, LANES},
    scene::{Highlight, Material},
};
use luminaire::{
    Arrival, CompiledGobo, CompiledLamp, Error, Luminaire, Matte, Plan, Rgb, Scalar, Specular, Surface,
    Surfaces, Vec3,
};

/// The light that the pixels of a block send to the eye: linear, 1 is full scale.
pub(crate) type Radiance = Rgb<[f32; LANES]>;

/// Light at the pixels of a block.
type Light<S> = Rgb<[<S as Scalar>::Irradiance; LANES]>;

/// A lamp compiled for a format, and where its light may be.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<S: Scalar> {
    lamp: CompiledLamp<S>,
    gobo: Option<CompiledGobo<'static, S>>,
    pub(crate) reach: Reach,
}

/// A material compiled for a format.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Finish<S: Scalar> {
    material: Material,
    highlight: <Highlight as Specular>::Constants<S>,
}

/// What the lamps light: all that is the same for every block.
#[derive(Debug)]
pub struct Setting<'a, S: Scalar> {
    pub(crate) plan: Plan,
    pub(crate) eye: Vec3<S::Length>,
    pub(crate) ambient: Rgb<f32>,
    /// By number.
    pub(crate) finishes: &'a [Finish<S>],
}

impl<S: Scalar> Prepared<S> {
    /// The lamp, if the plan keeps it.
    ///
    /// # Errors
    /// What the format can't hold.
    pub(crate) fn new(luminaire: &Luminaire, plan: &Plan) -> Result<Option<Self>, Error> {
        let (lamp, gobo) = (plan.prepare(luminaire.lamp())?, luminaire.compile_gobo()?);
        Ok(lamp.map(|lamp| Self { lamp, gobo, reach: Reach::new(luminaire.lamp()) }))
    }
}

impl<S: Scalar> Finish<S> {
    pub(crate) fn new(material: Material) -> Self {
        Self { material, highlight: Highlight::constants::<S>(material.shininess()) }
    }

    pub(crate) fn material(&self) -> &Material {
        &self.material
    }
}

impl<S: Scalar> Setting<'_, S> {
    /// Lights the pixels of a block; with `SKIPS`, none where a lamp's light cannot arrive.
    #[inline(always)]
    pub(crate) fn light<const SKIPS: bool>(
        &self,
        block: &Block<S>,
        lamps: &mut dyn Iterator<Item = &Prepared<S>>,
    ) -> Radiance {
        let mut sums = [self.ambient, Rgb::default()]
            .map(|light| light.map(|channel| [S::ONE.expose(S::gain(channel)); LANES]));
        let [diffuse, specular] = &mut sums;
        let shines = self.shining(block).next().is_some();
        let view =
            if shines { self.views(block) } else { Vec3::default().map(|()| [S::Unit::default(); LANES]) };
        let surfaces = Surfaces {
            point: borrowed(&block.point),
            normal: borrowed(&block.normal),
            view: borrowed(&view),
        };
        let dark = [S::Irradiance::default(); LANES];
        let mut arrivals = Arrival { diffuse: dark, specular: dark };
        for Prepared { lamp, gobo, .. } in lamps {
            let mut lobes = dark;
            if shines {
                for number in self.shining(block) {
                    let highlight = &self.finishes[number as usize].highlight;
                    lamp.arrive_each::<Highlight, SKIPS, LANES>(&surfaces, highlight, &mut arrivals);
                    for (lane, lobe) in lobes.iter_mut().enumerate() {
                        *lobe = if block.material[lane] == number { arrivals.specular[lane] } else { *lobe };
                    }
                }
            } else {
                lamp.arrive_each::<Matte, SKIPS, LANES>(&surfaces, &(), &mut arrivals);
            }
            if let Some(gobo) = gobo {
                let part = core::array::from_fn(|lane| gobo.at(block.point_at(lane)));
                filter::<S>(&mut arrivals.diffuse, &part);
                filter::<S>(&mut lobes, &part);
            }
            add::<S>(diffuse, &arrivals.diffuse, lamp.color());
            if shines {
                add::<S>(specular, &lobes, lamp.specular_color());
            }
        }
        let mut radiance = reflected::<S>(diffuse, block, |number| self.finishes[number].material.albedo);
        if shines {
            let shine = reflected::<S>(specular, block, |number| self.finishes[number].material.specular());
            radiance = radiance
                .zip(shine, |diffuse, specular| core::array::from_fn(|lane| diffuse[lane] + specular[lane]));
        }
        radiance
    }

    /// The numbers of the materials in a block that shine, each once; of all materials where nothing is left out.
    fn shining(&self, block: &Block<S>) -> impl Iterator<Item = u32> {
        let numbers = &block.material;
        let is_new = |lane: usize| lane == 0 || !numbers[..lane].contains(&numbers[lane]);
        let shines = |number: u32| !self.plan.skips() || self.finishes[number as usize].material.shines();
        let differs = move |lane: &usize| *lane == 0 || numbers[*lane] != numbers[*lane - 1];
        (0..LANES)
            .filter(differs)
            .filter(move |lane| shines(numbers[*lane]) && is_new(*lane))
            .map(|lane| numbers[lane])
    }

    /// The directions to the eye.
    fn views(&self, block: &Block<S>) -> Vec3<[S::Unit; LANES]> {
        let mut views = Vec3::default().map(|()| [S::Unit::default(); LANES]);
        for lane in 0..LANES {
            let view = Surface::<S>::seen_from(self.eye, block.point_at(lane), Vec3::default()).view;
            views.x[lane] = view.x;
            views.y[lane] = view.y;
            views.z[lane] = view.z;
        }
        views
    }
}

fn borrowed<T>(columns: &Vec3<T>) -> Vec3<&T> {
    Vec3::new(&columns.x, &columns.y, &columns.z)
}

/// Leaves a part of the light.
#[inline(always)]
fn filter<S: Scalar>(light: &mut [S::Irradiance; LANES], part: &[S; LANES]) {
    for (light, part) in light.iter_mut().zip(part) {
        *light = S::filter(*light, *part);
    }
}

/// Adds the light of a lamp in its colour.
#[inline(always)]
fn add<S: Scalar>(sum: &mut Light<S>, light: &[S::Irradiance; LANES], color: Rgb<S>) {
    for (sum, color) in
        [(&mut sum.red, color.red), (&mut sum.green, color.green), (&mut sum.blue, color.blue)]
    {
        for (sum, light) in sum.iter_mut().zip(light) {
            *sum = S::add_light(*sum, S::filter(*light, color));
        }
    }
}

/// What the surfaces send back, each by the colour that goes with the number of its material.
#[inline(always)]
fn reflected<S: Scalar>(light: &Light<S>, block: &Block<S>, color: impl Fn(usize) -> Rgb<f32>) -> Radiance {
    let mut radiance = light.map(|channel| channel.map(S::light_to_f32));
    for lane in 0..LANES {
        let color = color(block.material[lane] as usize);
        radiance.red[lane] *= color.red;
        radiance.green[lane] *= color.green;
        radiance.blue[lane] *= color.blue;
    }
    radiance
}
