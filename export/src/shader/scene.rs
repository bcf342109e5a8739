//! The lights of a scene as functions in `f32`.

use luminaire::dynamic::AnyLight;

use super::syntax::Syntax;
use crate::head::guarded;
use crate::name::global;
use crate::scene::Together;

/// Returns the function of a scene, with its ambient light as a uniform or a number.
pub(crate) fn scene(together: &Together<'_>, syntax: Syntax, has_uniforms: bool) -> String {
    let Together { name, items, .. } = together;
    let ambient: [f32; 3] = together.ambient::<f32>().into();
    let ambient = ambient.map(|channel| syntax.literal(channel));
    let lights = items.iter().map(|item| {
        let place = if matches!(item.light, AnyLight::Directional(_)) { "normal" } else { "point, normal" };
        let [irradiance, color] = ["irradiance", "color"].map(|part| global(item.name, part));
        (format!("{irradiance}({place})"), color)
    });
    let doc = "Returns the light at a point with a unit normal: that of all lights, with their colours, and ambient light.";
    match syntax {
        Syntax::Glsl | Syntax::Wgsl => {
            let (head, sum) = if syntax == Syntax::Glsl {
                let parameters = "highp vec3 point, highp vec3 normal";
                (format!("highp vec3 {name}_light({parameters})"), "highp vec3 sum = vec3")
            } else {
                let parameters = "point: vec3<f32>, normal: vec3<f32>";
                (format!("fn {name}_light({parameters}) -> vec3<f32>"), "var sum = vec3<f32>")
            };
            let list = ambient.join(", ");
            let (uniform, first) = if has_uniforms {
                let doc = format!("the sum of the ambient light: {list}");
                (format!("uniform highp vec3 {name}_ambient; // {doc}\n"), format!("{sum}({name}_ambient)"))
            } else {
                (String::new(), format!("{sum}({list})"))
            };
            let added: String = lights.map(|(lit, color)| format!("    sum += {color} * {lit};\n")).collect();
            format!("{uniform}// {doc}\n{head} {{\n    {first};\n{added}    return sum;\n}}\n")
        }
        Syntax::C => {
            let set = [0, 1, 2].map(|i| format!("    light[{i}] = {};\n", ambient[i])).concat();
            let added = lights.map(|(lit, color)| {
                format!(
                    "    irradiance = {lit};\n    for (i = 0; i < 3; ++i) {{ light[i] += irradiance * {color}[i]; }}\n"
                )
            });
            let added: String = added.collect();
            let needs = if added.is_empty() {
                "    (void)point;\n    (void)normal;\n"
            } else {
                "    float irradiance;\n    int i;\n"
            };
            // Not every light has a position.
            let unused = if added.contains("(point") || added.is_empty() { "" } else { "    (void)point;\n" };
            let body = format!(
                r#"/* Sets the light at a point with a unit normal: that of all lights, with their colours, and ambient light. */
static inline void {name}_light(float light[3], const float point[3], const float normal[3]) {{
{needs}{unused}{set}{added}}}

/* Adds that light to each pixel of a row on a flat surface: its first point, and what the point changes by. */
static inline void {name}_row_add(
    float (*lights)[3], const float first[3], const float step[3], const float normal[3], int count
) {{
    for (int k = 0; k < count; ++k) {{
        const float point[3] = {{
            first[0] + (float)k * step[0], first[1] + (float)k * step[1], first[2] + (float)k * step[2]
        }};
        float light[3];
        {name}_light(light, point, normal);
        for (int i = 0; i < 3; ++i) {{ lights[k][i] += light[i]; }}
    }}
}}
"#
            );
            guarded(name, "scene", &format!("The lights of the scene {name} together."), &body)
        }
    }
}
