//! The lights of a scene in the C of the 16-bit format: a structure, and functions that light points and rows by it.

use std::fmt::Write;

use luminaire::Fx16;

use super::Compiled;
use crate::error::ExportError;
use crate::head::guarded;
use crate::scene::Together;

/// Returns the structure and the functions of a scene.
pub(crate) fn scene(together: &Together<'_>) -> Result<String, ExportError> {
    let Together { name, ambient_name, items, .. } = together;
    let (mut fields, mut values, mut spots) = (String::new(), String::new(), Vec::new());
    // The statements of a point and of a row; what is the same at all points of a row comes first.
    let (mut points, mut flat, mut rows) = (String::new(), String::new(), String::new());
    // Those of a point without a normal.
    let mut bodies = String::new();
    for item in *items {
        let own = item.name;
        let (structure, initialiser) = match Compiled::new(&item.light)? {
            Compiled::Directional(initialiser) => {
                for (text, sum, normal) in [(&mut points, "sum", "normal"), (&mut flat, "all", "row->normal")]
                {
                    let irradiance = format!("luminaire_directional_irradiance(&scene->{own}, {normal})");
                    let _ = writeln!(text, "    luminaire_add(&{sum}, {irradiance}, scene->{own}.color);");
                }
                let irradiance = format!("luminaire_directional_irradiance_facing(&scene->{own})");
                let _ = writeln!(bodies, "    luminaire_add(&sum, {irradiance}, scene->{own}.color);");
                ("luminaire_directional", initialiser)
            }
            Compiled::Placed(placed) => {
                if placed.weights.is_some() {
                    spots.push(format!("&scene->{own}"));
                } else {
                    let by = format!("luminaire_{own}_Irradiance");
                    let spot = format!("scene->{own}{}", placed.member());
                    let irradiance = format!("{by}(&{spot}, point, normal)");
                    let _ = writeln!(points, "    luminaire_add(&sum, {irradiance}, {spot}.color);");
                    let irradiance = format!("{by}Facing(&{spot}, point)");
                    let _ = writeln!(bodies, "    luminaire_add(&sum, {irradiance}, {spot}.color);");
                    let _ = writeln!(rows, "    luminaire_row_add_by(lights, row, &{spot}, {by}, count);");
                }
                (placed.structure(), placed.initialiser(item.light.color()))
            }
        };
        let _ = writeln!(fields, "    {structure} {own};");
        let _ = writeln!(values, "    {},", initialiser.replace('\n', "\n    "));
    }
    if !spots.is_empty() {
        // One place that calls each function, however many spotlights there are: a compiler for speed inlines it.
        let (count, list) = (spots.len(), spots.join(", "));
        let each = |call: &str| {
            format!(
                "    const luminaire_spot *const spots[{count}] = {{ {list} }};\n    \
                 for (int k = 0; k < {count}; ++k) {{\n        {call}\n    }}\n"
            )
        };
        points += &each(
            "luminaire_add(&sum, luminaire_spot_irradiance(spots[k], point, normal), spots[k]->color);",
        );
        bodies +=
            &each("luminaire_add(&sum, luminaire_spot_irradiance_facing(spots[k], point), spots[k]->color);");
        rows += &each("luminaire_row_add(lights, row, spots[k], count);");
    }
    let ambient =
        <[_; 3]>::from(together.ambient::<Fx16>()).map(|light| format!("UINT32_C({})", light.to_bits()));
    let ambient = ambient.join(", ");
    let body = format!(
        r#"#include "luminaire_constant.h"

/* The lights by their names. A luminaire_spot changes by luminaire_spot_move, _aim, _aim_along, _zoom, _dim and _tint, a
 * luminaire_directional by luminaire_directional_aim_along, _dim and _tint, and a luminaire_measured by
 * luminaire_measured_aim, _aim_along and _turn, and by luminaire_spot_move, _dim and _tint of its spot. {name}_light and
 * {name}_row_add know the falloff and the attenuation of each light; the functions of luminaire.h light by the inverse
 * square alone. */
typedef struct {{
{fields}    luminaire_rgb {ambient_name}; /* the same at every point and normal */
}} {name}_scene;

/* The lights as they were described, which a program copies to change them. */
static const {name}_scene {name}_start = {{
{values}    {{ {ambient} }}
}};

/* Returns the light at a point with a unit normal: that of all lights, with their colours. */
static inline luminaire_rgb {name}_light(const {name}_scene *scene, const int32_t point[3], const int16_t normal[3]) {{
    luminaire_rgb sum = {{ 0, 0, 0 }};
    if (!scene || !point || !normal) {{ return sum; }}
    sum = scene->{ambient_name};
{points}    return sum;
}}

/* Returns the light at a point of a surface that faces each light: what a small body without a normal receives, such as
 * an LED. */
static inline luminaire_rgb {name}_light_facing(const {name}_scene *scene, const int32_t point[3]) {{
    luminaire_rgb sum = {{ 0, 0, 0 }};
    if (!scene || !point) {{ return sum; }}
    sum = scene->{ambient_name};
{bodies}    return sum;
}}

/* Adds the light of all lights to each pixel of a row. The part of the row that a light cannot reach costs little. */
static inline void {name}_row_add(
    luminaire_rgb *lights, const luminaire_row *row, const {name}_scene *scene, uint32_t count
) {{
    if (!lights || !row || !scene) {{ return; }}
    luminaire_rgb all = scene->{ambient_name};
{flat}    for (uint32_t i = 0; i < count; ++i) {{ lights[i] = luminaire_rgb_plus(lights[i], all); }}
{rows}}}
"#
    );
    Ok(guarded(name, "scene", &format!("The lights of the scene {name} together."), &body))
}
