//! The catalogue: every effect, with what it is, and the function that is measured. Instructions and
//! bytes of the documents are of these functions.

mod display;
mod evaluation;
mod light;
mod models;
mod surface;
mod way;

pub use self::{display::*, evaluation::*, light::*, surface::*, way::*};
use crate::catalogue::Visit;

/// Visits every effect, in the order of the page.
pub fn each(visit: &mut impl Visit) {
    visit.group("Lights", "From a point and a normal to what arrives of one light, before its colour.");
    light::soft(visit);
    light::others(visit);
    visit.group(
        "Edges of the cone",
        "The soft spotlight with another falloff. A scene pays for those that its spotlights have.",
    );
    models::falloffs(visit);
    light::ramps(visit);
    visit.group(
        "Distance",
        "The soft spotlight with a fall with distance. The window and the range are compared with the inverse square.",
    );
    models::attenuations(visit);
    visit.group(
        "Evaluation and set-up",
        "The soft spotlight by other evaluations, and what it costs to move it or to compile it again. Both are \
         needed once a light and picture; here they are part of each pixel, so that they can be counted.",
    );
    evaluation::each(visit);
    visit.group(
        "In the way of a spotlight",
        "The soft spotlight through something. A fixture has it or not, and one that has it not knows nothing of it.",
    );
    way::each(visit);
    visit.group(
        "Surfaces",
        "From a point, its normal and the direction to the eye to what a material sends back of one directional \
         light, in colours. The direction to the eye is found once for all lights and not counted. Highlights are \
         of a shininess of 32.",
    );
    surface::matte_alone(visit);
    models::lobes(visit);
    visit.group(
        "The picture as a whole",
        "Once a pixel, however many lights there are: from the sum of the light, or from a colour, in three channels.",
    );
    surface::sum(visit);
    display::each(visit);
}
