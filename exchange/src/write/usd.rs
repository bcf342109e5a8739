//! Stages of USD with the lights of UsdLux.

use glam::DVec3;
use luminaire::Rgb;
use luminaire::dynamic::AnyLight;
use luminaire_export::printable;

use super::node::Node;

/// Returns a stage as text.
///
/// Lights have no unit of length and no axis that is up. The stage states metres and y, because USD's own default is
/// centimetres.
///
/// UsdLux multiplies its numbers by a profile. So the numbers beside one are those of 1 candela, without a fall over the
/// angle up to where the profile ends.
pub(super) fn text(nodes: &[Node]) -> String {
    let mut text =
        "#usda 1.0\n(\n    defaultPrim = \"lights\"\n    metersPerUnit = 1\n    upAxis = \"Y\"\n)\n\n\
                    def Xform \"lights\"\n{\n"
            .to_owned();
    for node in nodes {
        prim(&mut text, node);
    }
    text + "}\n"
}

fn prim(text: &mut String, Node { entry, name, position, rotation, profile, lines }: &Node) {
    let light = &entry.lamp.light;
    let (kind, is_shaped) = match light {
        AnyLight::Spot(_) => ("SphereLight", true),
        AnyLight::Point(_) | AnyLight::Measured(_) => ("SphereLight", false),
        AnyLight::Directional(_) => ("DistantLight", false),
    };
    let schemas = if is_shaped { "        prepend apiSchemas = [\"ShapingAPI\"]\n" } else { "" };
    let shown = printable(&entry.lamp.name).replace('\\', "\\\\").replace('"', "\\\"");
    *text +=
        &format!("    def {kind} \"{name}\" (\n{schemas}        displayName = \"{shown}\"\n    )\n    {{\n");
    let mut row = |row: String| *text += &format!("        {row}\n");
    lines.iter().for_each(|line| row(format!("# {}", printable(line))));
    let Rgb { red, green, blue } = light.color();
    row(format!("color3f inputs:color = ({red}, {green}, {blue})"));
    for (key, value) in &entry.found.values {
        let value = match (*key, profile) {
            ("intensity", Some(profile)) => (4.0 * profile.factor).to_string(),
            ("shaping:cone:angle", Some(profile)) => profile.end.to_string(),
            ("shaping:cone:softness", Some(_)) => "0".to_owned(),
            _ => value.clone(),
        };
        row(format!("{} inputs:{key} = {value}", if *key == "normalize" { "bool" } else { "float" }));
    }
    if let Some(profile) = profile {
        let marks = if profile.file.contains('@') { "@@@" } else { "@" };
        row(format!("asset inputs:shaping:ies:file = {marks}./{}{marks}", profile.file));
        row("float inputs:shaping:ies:angleScale = 0".to_owned());
        row("bool inputs:shaping:ies:normalize = 0".to_owned());
    }
    let (DVec3 { x, y, z }, turn) = (position, rotation);
    row(format!("double3 xformOp:translate = ({x}, {y}, {z})"));
    row(format!("quatd xformOp:orient = ({}, {}, {}, {})", turn.w, turn.x, turn.y, turn.z));
    row("uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]".to_owned());
    *text += "    }\n";
}
