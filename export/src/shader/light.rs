//! The functions of a light in `f32`.

use luminaire::attenuation::AnyAttenuation;
use luminaire::dynamic::AnyLight;
use luminaire::number::Arithmetic;
use luminaire::{Rgb, Vec3};

use super::expression::{
    Builtin, Constant, Expression, Function, Program, Statement, Type, Value, call, clamp, if_less, name,
    number, quotient, vector,
};
use super::formula::{self, Lowering};
use super::measured::measured;
use super::names::Names;
use crate::error::ExportError;
use crate::trace::Trace;

/// Returns the functions of a light.
pub(super) fn program(names: Names<'_>, light: &AnyLight) -> Result<Program, ExportError> {
    let mut program = Program::default();
    let color = |doc, color: Rgb<f32>| {
        names.constant("color", doc, Value::Vector([color.red, color.green, color.blue]))
    };
    match light {
        AnyLight::Measured(light) => {
            let compiled = light.compile::<f32>()?;
            program.constants = place(names, light.position());
            let axes = [
                ("side", "unit vector to the side, the plane C0 of photometry"),
                ("front", "unit vector to the front"),
                ("axis", "unit vector along the light"),
            ];
            for ((own, doc), axis) in axes.into_iter().zip(compiled.frame()) {
                program.constants.push(names.constant(own, doc, xyz(axis)));
            }
            let (table, distribution) = measured(names, light)?;
            program.constants.push(table);
            program.functions.push(distribution);
            let intensity = compiled.parts().intensity;
            finish(&mut program, names, intensity, color("linear colour", light.color()));
            let share = Expression::Own(names.of("distribution"), vec![vector("back")]);
            program.functions.push(irradiance(names, Some(share), light.attenuation())?);
        }
        AnyLight::Spot(spot) => {
            let parts = spot.compile::<f32>()?.parts();
            let (Some(cone), intensity) = (parts.cone, parts.intensity) else {
                unreachable!("a spotlight has a cone")
            };
            program.constants = place(names, spot.position());
            program.constants.push(names.constant("axis", "unit vector along the beam", xyz(cone.axis)));
            let [outer, limit, slope, _] = cone.ramp.to_bits().map(f32::from_bits);
            // The ramp is that of a versine, and the functions compute twice the versine.
            let value = |value: f32| Value::Number(value);
            let doc = "twice the versine (1 - cos) of half the angle at which the falloff ends";
            program.constants.push(names.constant("outer", doc, value(2.0 * outer)));
            if limit < outer {
                let doc = "twice the versine of half the cutoff angle";
                program.constants.push(names.constant("cutoff", doc, value(2.0 * limit)));
            }
            let doc = "rise of t from the outer to the inner angle, over twice the versine";
            program.constants.push(names.constant("slope", doc, value(0.5 * slope)));
            let (tables, curve) = formula::curve(&names, &Trace::of(spot.cone().falloff()))?;
            program.constants.extend(tables);
            program.functions.extend([curve, cone_of(names, limit < outer), falloff_of(names)]);
            finish(&mut program, names, intensity, color("linear colour", spot.color()));
            let share = Expression::Own(names.of("cone"), vec![vector("back")]);
            program.functions.push(irradiance(names, Some(share), spot.attenuation())?);
        }
        AnyLight::Point(point) => {
            let parts = point.compile::<f32>()?.parts();
            program.constants = place(names, point.position());
            finish(&mut program, names, parts.intensity, color("linear colour", point.color()));
            program.functions.push(irradiance(names, None, point.attenuation())?);
        }
        AnyLight::Directional(light) => {
            let doc = "unit vector along the light";
            program.constants.push(names.constant("direction", doc, xyz(light.direction())));
            let intensity = <f32 as Arithmetic>::gain(light.intensity());
            finish(&mut program, names, intensity, color("linear colour", light.color()));
            let cosine = call(Builtin::Dot, vector(names.of("direction")), vector("normal"));
            program.functions.push(Function {
                doc: "Returns the irradiance at a unit normal, before the colour.".to_owned(),
                name: names.of("irradiance"),
                parameters: vec![(Type::Vector, "normal")],
                body: Vec::new(),
                result: call(Builtin::Max, number(0.0) - cosine, number(0.0)) * name(names.of("intensity")),
            });
        }
    }
    Ok(program)
}

fn place(names: Names<'_>, position: Vec3<f32>) -> Vec<Constant> {
    vec![names.constant("position", "position", xyz(position))]
}

fn xyz(vector: Vec3<f32>) -> Value {
    Value::Vector(vector.into())
}

fn finish(program: &mut Program, names: Names<'_>, intensity: f32, color: Constant) {
    let doc = "1 is full scale on the axis, at distance 1";
    program.constants.push(names.constant("intensity", doc, Value::Number(intensity)));
    program.constants.push(color);
}

/// Adds the statements from a point to the unit vector back to the light.
fn arrive(names: Names<'_>) -> Vec<Statement> {
    let squared = call(Builtin::Dot, vector("offset"), vector("offset"));
    // The reciprocal distance is 0 for a point on the light, so that no light arrives there.
    let root = quotient(number(1.0), Expression::Call(Builtin::Sqrt, vec![name("squared")]));
    let reciprocal = if_less(name("squared"), number(f32::MIN_POSITIVE), number(0.0), root);
    vec![
        Statement::Let(Type::Vector, "offset".to_owned(), vector(names.of("position")) - vector("point")),
        Statement::Let(Type::Number, "squared".to_owned(), squared),
        Statement::Let(Type::Number, "reciprocal".to_owned(), reciprocal),
        Statement::Let(Type::Vector, "back".to_owned(), vector("offset") * name("reciprocal")),
    ]
}

/// Returns the function of the falloff over the unit vector back to the light.
fn cone_of(names: Names<'_>, has_cutoff: bool) -> Function {
    // The squared difference of two unit vectors is twice the versine of their angle. `1 - dot`
    // would lose the leading bits of the versine of a narrow beam.
    let limit = names.of(if has_cutoff { "cutoff" } else { "outer" });
    let rise = (name(names.of("outer")) - name("twice_versine")) * name(names.of("slope"));
    Function {
        doc: "Returns the falloff toward a point, by the unit vector from the point to the light.".to_owned(),
        name: names.of("cone"),
        parameters: vec![(Type::Vector, "back")],
        body: vec![
            Statement::Let(Type::Vector, "difference".to_owned(), vector("back") + vector(names.of("axis"))),
            Statement::Let(
                Type::Number,
                "twice_versine".to_owned(),
                call(Builtin::Dot, vector("difference"), vector("difference")),
            ),
            Statement::Let(
                Type::Number,
                "rise".to_owned(),
                if_less(name("twice_versine"), name(limit), rise, number(0.0)),
            ),
        ],
        result: Expression::Own(names.of("curve"), vec![call(Builtin::Min, name("rise"), number(1.0))]),
    }
}

fn falloff_of(names: Names<'_>) -> Function {
    Function {
        doc: "Returns the falloff at a point, in [0, 1].".to_owned(),
        name: names.of("falloff"),
        parameters: vec![(Type::Vector, "point")],
        body: arrive(names),
        result: Expression::Own(names.of("cone"), vec![vector("back")]),
    }
}

fn irradiance(
    names: Names<'_>,
    falloff: Option<Expression>,
    attenuation: AnyAttenuation,
) -> Result<Function, ExportError> {
    let mut body = arrive(names);
    if falloff.is_none() {
        body.pop(); // A point light needs no unit vector.
    }
    let facing = call(Builtin::Dot, vector("offset"), vector("normal"));
    body.push(Statement::Let(Type::Number, "cosine".to_owned(), clamp(facing * name("reciprocal"))));
    let share = match falloff {
        Some(falloff) => {
            body.push(Statement::Let(Type::Number, "share".to_owned(), falloff * name("cosine")));
            name("share")
        }
        None => name("cosine"),
    };
    let [_, trace] = Trace::of_attenuation(attenuation);
    let mut lowering = Lowering::new(&names, share, body);
    let result = lowering.result(&trace)?;
    Ok(Function {
        doc: "Returns the irradiance at a point with a unit normal, before the colour.".to_owned(),
        name: names.of("irradiance"),
        parameters: vec![(Type::Vector, "point"), (Type::Vector, "normal")],
        body: lowering.body,
        result,
    })
}
