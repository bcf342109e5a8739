//! The hall and its exhibits.

use crate::{
    Material, Mesh, Scene,
    scenes::{
        room::{floor, wall},
        solids::{cone, sphere, torus, vase},
    },
};
use core::f32::consts::FRAC_PI_2;
use luminaire::{Error, Rgb, Vec3};

/// Half the width of the hall, the distance to its back wall, and the height of its walls, in
/// metres.
const HALF: f32 = 4.2;
const BACK: f32 = -4.0;
const HEIGHT: f32 = 6.0;

/// The height of the middle of the pictures, in metres.
const EYE_LEVEL: f32 = 1.75;

/// A wall with pictures.
#[derive(Clone, Copy)]
pub(super) enum Side {
    Left,
    Back,
    Right,
}

/// Positions of the pictures: the distance along the wall, and the wall.
pub(super) const PICTURES: [(f32, Side); 7] = [
    (-2.6, Side::Left),
    (-0.5, Side::Left),
    (-2.6, Side::Back),
    (0.0, Side::Back),
    (2.6, Side::Back),
    (-2.6, Side::Right),
    (-0.5, Side::Right),
];

/// Positions of the sculptures: x and z.
pub(super) const SCULPTURES: [(f32, f32); 4] = [(-2.1, -1.0), (-0.85, 0.3), (0.95, -1.4), (2.15, 0.0)];

/// Positions of the pendants: x and z.
pub(super) const PENDANTS: [(f32, f32); 2] = [(-1.3, -3.1), (1.3, -3.1)];

/// The colours of each picture, in sRGB: the ground and two fields.
const PAINTS: [[(u8, u8, u8); 3]; 7] = [
    [(196, 60, 44), (232, 150, 52), (120, 30, 44)],
    [(36, 66, 120), (82, 140, 170), (222, 206, 160)],
    [(206, 176, 82), (176, 74, 42), (96, 44, 52)],
    [(28, 44, 78), (160, 44, 50), (210, 120, 60)],
    [(70, 110, 92), (190, 196, 150), (34, 58, 66)],
    [(214, 190, 150), (90, 120, 160), (60, 60, 92)],
    [(150, 50, 80), (230, 170, 160), (60, 24, 50)],
];

impl Side {
    /// Returns a point from the distance along the wall, the distance in front of the wall, and the
    /// height.
    fn at(self, along: f32, before: f32, height: f32) -> Vec3<f32> {
        match self {
            Self::Left => Vec3::new(-HALF + before, height, along),
            Self::Back => Vec3::new(along, height, BACK + before),
            Self::Right => Vec3::new(HALF - before, height, along),
        }
    }

    /// Returns the middle of a picture.
    pub(super) fn on_wall(self, along: f32) -> Vec3<f32> {
        self.at(along, 0.0, EYE_LEVEL)
    }

    /// Returns the position of a light for a picture, with a sideways offset.
    pub(super) fn before_wall(self, along: f32, offset: f32) -> Vec3<f32> {
        self.at(along + offset, 2.1, 4.3)
    }

    /// Hangs a mesh on the wall. The mesh must be built at z = 0, facing positive z.
    fn hang(self, mesh: Mesh, along: f32, before: f32) -> Mesh {
        let turn = match self {
            Self::Left => FRAC_PI_2,
            Self::Back => 0.0,
            Self::Right => -FRAC_PI_2,
        };
        mesh.turned(Vec3::new(0.0, 1.0, 0.0), turn).moved(self.at(along, before, 0.0))
    }
}

/// Adds the sculptures on plinths: a glazed vase and a bronze ball with highlights, and two plaster
/// sculptures.
pub(super) fn sculptures(scene: &mut Scene) -> Result<(), Error> {
    let plaster = Material::srgb(214, 208, 198);
    let glaze = Material::srgb(34, 104, 122).with_highlight(Rgb::new(0.55, 0.55, 0.55), 160)?;
    let bronze = Material::srgb(150, 98, 48).with_highlight(Rgb::new(0.6, 0.42, 0.2), 48)?;
    let ring = torus(0.34, 0.11).turned(Vec3::new(1.0, 0.0, 0.0), FRAC_PI_2 - 0.25);
    let shown = [
        (vase(), 0.0, glaze),
        (sphere(0.36), 0.0, bronze),
        (ring, 0.4, plaster),
        (cone(0.3, 0.95), 0.0, plaster),
    ];
    for ((mesh, lift, material), (x, z)) in shown.into_iter().zip(SCULPTURES) {
        let plinth = 0.8;
        scene.add(mesh.moved(Vec3::new(x, plinth + lift, z)), material)?;
        scene.add(
            Mesh::cuboid(0.62, plinth, 0.62).moved(Vec3::new(x, 0.0, z)),
            Material::srgb(226, 224, 220),
        )?;
    }
    Ok(())
}

/// Adds framed pictures: two fields of colour on a ground.
pub(super) fn pictures(scene: &mut Scene) -> Result<(), Error> {
    let board = |width: f32, height: f32, thickness: f32, middle: f32| {
        Mesh::cuboid(width, height, thickness).moved(Vec3::new(0.0, middle - height / 2.0, thickness / 2.0))
    };
    for (&(along, side), paints) in PICTURES.iter().zip(PAINTS) {
        let [ground, upper, lower] = paints.map(|(red, green, blue)| Material::srgb(red, green, blue));
        let mut hang = |mesh, before, material| scene.add(side.hang(mesh, along, before), material);
        hang(board(1.12, 0.52, 0.004, EYE_LEVEL + 0.36), 0.034, upper)?;
        hang(board(1.12, 0.68, 0.004, EYE_LEVEL - 0.3), 0.034, lower)?;
        hang(board(1.36, 1.56, 0.03, EYE_LEVEL), 0.004, ground)?;
        hang(board(1.44, 1.64, 0.02, EYE_LEVEL), 0.0, Material::srgb(48, 40, 34))?;
    }
    Ok(())
}

/// Adds the floor, the walls and the shades of the pendants.
pub(super) fn room(scene: &mut Scene) -> Result<(), Error> {
    let up = Vec3::new(0.0, 1.0, 0.0);
    let paint = Material::srgb(208, 206, 202);
    for (x, z) in PENDANTS {
        scene.add(cone(0.16, 0.2).moved(Vec3::new(x, 2.92, z)), Material::srgb(60, 58, 56))?;
        scene.add(Mesh::cuboid(0.012, 3.0, 0.012).moved(Vec3::new(x, 3.1, z)), Material::srgb(40, 40, 40))?;
    }
    scene
        .add(floor(2.0 * HALF, 16.0).moved(Vec3::new(0.0, 0.0, 8.0 + BACK)), Material::srgb(138, 126, 112))?;
    scene.add(wall(2.0 * HALF, HEIGHT, BACK), paint)?;
    let side = || wall(16.0, HEIGHT, -HALF);
    let ahead = Vec3::new(0.0, 0.0, 8.0 + BACK);
    scene.add(side().turned(up, FRAC_PI_2).moved(ahead), paint)?;
    scene.add(side().turned(up, -FRAC_PI_2).moved(ahead), paint)?;
    Ok(())
}
