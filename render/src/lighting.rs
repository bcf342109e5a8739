//! The lighting pass: how much light arrives at each pixel, and how much of it the surface sends to the eye.

use crate::{
    gbuffer::{Block, LANES},
    prepared::Prepared,
    scene::{Highlight, Material},
    shadows::Shadows,
};
use luminaire::{
    Arrival, CompiledLamp, Light as _, Matte, Plan, Rgb, Scalar, Shadow, Specular, Surface, Surfaces, Vec3,
};

/// The light that the pixels of a block send to the eye: linear, 1 is full scale.
pub(crate) type Radiance = Rgb<[f32; LANES]>;

/// Light at the pixels of a block.
type Light<S> = Rgb<[<S as Scalar>::Irradiance; LANES]>;

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
    pub(crate) shadows: &'a Shadows<S>,
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
    /// Lights the pixels of a block.
    #[inline(always)]
    pub(crate) fn light(&self, block: &Block<S>, lamps: &mut dyn Iterator<Item = &Prepared<S>>) -> Radiance {
        let mut shining = [0; LANES];
        match self.shining(block, &mut shining) {
            [] => self.light_matte(block, lamps),
            shining => self.light_shining(block, shining, lamps),
        }
    }

    /// Lights a block of matt surfaces.
    #[inline(always)]
    fn light_matte(&self, block: &Block<S>, lamps: &mut dyn Iterator<Item = &Prepared<S>>) -> Radiance {
        let dark = [S::Irradiance::default(); LANES];
        let mut sum = self.ambient();
        let mut arrivals = Arrival { diffuse: dark, specular: dark };
        let no_view = [S::Unit::default(); LANES];
        let surfaces = Surfaces {
            point: borrowed(&block.point),
            normal: borrowed(&block.normal),
            view: Vec3::new(&no_view, &no_view, &no_view),
        };
        for prepared in lamps {
            self.arrive::<Matte>(&prepared.lamp, &surfaces, &(), &mut arrivals);
            let Arrival { diffuse, specular } = &mut arrivals;
            self.filter(prepared, block, [diffuse, specular]);
            add::<S>(&mut sum, diffuse, prepared.lamp.color());
        }
        self.reflected(&sum, block, |material| material.albedo)
    }

    /// Lights a block with surfaces that shine, whose materials have these numbers.
    #[inline(always)]
    fn light_shining(
        &self,
        block: &Block<S>,
        shining: &[u32],
        lamps: &mut dyn Iterator<Item = &Prepared<S>>,
    ) -> Radiance {
        let dark = [S::Irradiance::default(); LANES];
        let (mut sum, mut shine) = (self.ambient(), Rgb::new(dark, dark, dark));
        let mut arrivals = Arrival { diffuse: dark, specular: dark };
        let view = self.views(block);
        let surfaces = Surfaces {
            point: borrowed(&block.point),
            normal: borrowed(&block.normal),
            view: borrowed(&view),
        };
        for prepared in lamps {
            let mut lobes = dark;
            for &number in shining {
                let highlight = &self.finishes[number as usize].highlight;
                self.arrive::<Highlight>(&prepared.lamp, &surfaces, highlight, &mut arrivals);
                for (lane, lobe) in lobes.iter_mut().enumerate() {
                    *lobe = if block.material[lane] == number { arrivals.specular[lane] } else { *lobe };
                }
            }
            self.filter(prepared, block, [&mut arrivals.diffuse, &mut lobes]);
            add::<S>(&mut sum, &arrivals.diffuse, prepared.lamp.color());
            add::<S>(&mut shine, &lobes, prepared.lamp.specular_color());
        }
        let diffuse = self.reflected(&sum, block, |material| material.albedo);
        let specular = self.reflected(&shine, block, |material| material.specular());
        diffuse.zip(specular, |a, b| core::array::from_fn(|lane| a[lane] + b[lane]))
    }

    /// The light that is everywhere.
    #[inline(always)]
    fn ambient(&self) -> Light<S> {
        self.ambient.map(|channel| [S::ONE.expose(S::gain(channel)); LANES])
    }

    /// Leaves of the light of a lamp what its pattern and its shadow leave of it.
    #[inline(always)]
    fn filter(&self, prepared: &Prepared<S>, block: &Block<S>, lights: [&mut [S::Irradiance; LANES]; 2]) {
        let [diffuse, lobes] = lights;
        if let Some(gobo) = &prepared.gobo {
            filter::<S>([&mut *diffuse, &mut *lobes], block, |point| gobo.at(point));
        }
        if let Some(square) = prepared.shadow {
            let none = Shadow::from_parts(square, 0, &[]);
            let shadow = self.shadows.of(prepared.number).unwrap_or(none);
            filter::<S>([diffuse, lobes], block, |point| shadow.visibility(point));
        }
    }

    /// What the surfaces of a block send back of the light, each by a colour of its material.
    #[inline(always)]
    fn reflected(
        &self,
        light: &Light<S>,
        block: &Block<S>,
        color: impl Fn(&Material) -> Rgb<f32>,
    ) -> Radiance {
        let mut radiance = light.map(|channel| channel.map(S::light_to_f32));
        let color = |number: u32| color(&self.finishes[number as usize].material);
        if let Some(number) = block.only_material() {
            let color = color(number);
            return radiance.zip(color, |channel, color| channel.map(|light| light * color));
        }
        for (lane, &number) in block.material.iter().enumerate() {
            let color = color(number);
            radiance.red[lane] *= color.red;
            radiance.green[lane] *= color.green;
            radiance.blue[lane] *= color.blue;
        }
        radiance
    }

    /// What arrives of a lamp: by the loop that is made for it, or by none where nothing is left out.
    #[inline(always)]
    fn arrive<H: Specular>(
        &self,
        lamp: &CompiledLamp<S>,
        surfaces: &Surfaces<'_, S, LANES>,
        highlight: &H::Constants<S>,
        arrivals: &mut Arrival<[S::Irradiance; LANES]>,
    ) {
        if self.plan.skips() {
            return lamp.arrive_each::<H, LANES>(surfaces, highlight, arrivals);
        }
        for lane in 0..LANES {
            let arrival = lamp.arrive::<H>(&surfaces.at(lane), highlight, false);
            arrivals.diffuse[lane] = arrival.diffuse;
            arrivals.specular[lane] = arrival.specular;
        }
    }

    /// The numbers of the materials in a block that shine, each once; of all materials where nothing is left out.
    #[inline(always)]
    fn shining<'n>(&self, block: &Block<S>, numbers: &'n mut [u32; LANES]) -> &'n [u32] {
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
        &numbers[..count]
    }

    /// The directions to the eye, mirrored in the surfaces.
    #[inline(always)]
    fn views(&self, block: &Block<S>) -> Vec3<[S::Unit; LANES]> {
        let mut views = Vec3::default().map(|()| [S::Unit::default(); LANES]);
        for lane in 0..LANES {
            let surface = Surface::<S>::seen_from(self.eye, block.point_at(lane), block.normal_at(lane));
            let view = S::mirror(surface.view, surface.normal);
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

/// Leaves a part of the light at each point: where none arrives there is nothing to leave.
#[inline(always)]
fn filter<S: Scalar>(
    [diffuse, lobes]: [&mut [S::Irradiance; LANES]; 2],
    block: &Block<S>,
    part: impl Fn(Vec3<S::Length>) -> S,
) {
    let dark = S::Irradiance::default();
    for lane in 0..LANES {
        if diffuse[lane] > dark || lobes[lane] > dark {
            let part = part(block.point_at(lane));
            diffuse[lane] = S::filter(diffuse[lane], part);
            lobes[lane] = S::filter(lobes[lane], part);
        }
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
