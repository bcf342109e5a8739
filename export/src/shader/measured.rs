//! The function of a light that is not round, in `f32`.

use luminaire::MeasuredLight;
use luminaire::light::Symmetry;

use super::expression::{
    Builtin, Constant, Expression, Function, Statement, Type, Value, call, clamp, if_less, name, number,
    quotient, vector,
};
use super::names::Names;
use crate::error::ExportError;

/// The most samples of a table: those of size 65 without a symmetry.
const MOST: usize = 4_225;

/// Returns the table of a light and its function over the unit vector back to the light, in the order of the kernel.
pub(super) fn measured<A>(
    names: Names<'_>,
    light: &MeasuredLight<'_, A>,
) -> Result<(Constant, Function), ExportError>
where
    A: luminaire::attenuation::Attenuation,
{
    let distribution = light.distribution();
    let samples: Vec<f32> = distribution.samples().iter().map(|&sample| sample.into()).collect();
    if samples.len() > MOST {
        let expected = format!("at most {MOST} (`--size 65`)");
        return Err(ExportError::new("number of samples", samples.len(), expected));
    }
    let [columns, rows] = distribution.shape();
    let cells = (distribution.size() / 2) as f32;
    let folds = match distribution.symmetry() {
        Symmetry::None => [false, false],
        Symmetry::Bilateral => [false, true],
        Symmetry::Quadrant => [true, true],
    };
    let mut body = Vec::new();
    let mut local = |own: &str, value| {
        body.push(Statement::Let(Type::Number, own.to_owned(), value));
        name(own)
    };
    let axes = [("a", "side"), ("b", "front"), ("c", "axis")];
    let [a, b, c] = axes.map(|(own, axis)| {
        local(own, number(0.0) - call(Builtin::Dot, vector("back"), vector(names.of(axis))))
    });
    let size = |of: &Expression| call(Builtin::Max, of.clone(), number(0.0) - of.clone());
    // Less than 1 is the sum of a point on the light alone.
    let sum = call(Builtin::Max, size(&a) + size(&b) + size(&c), number(0.5));
    let reciprocal = local("inverse_sum", quotient(number(1.0), sum));
    let ahead = [("x_ahead", &a), ("y_ahead", &b)].map(|(own, of)| local(own, size(of) * reciprocal.clone()));
    let places = [("x", 0, columns), ("y", 1, rows)].map(|(own, i, _)| {
        let behind = number(1.0) - ahead[1 - i].clone();
        let size = number(cells) * clamp(if_less(c.clone(), number(0.0), behind, ahead[i].clone()));
        let size = local(&format!("{own}_size"), size);
        let side = if i == 0 { a.clone() } else { b.clone() };
        let whole = if_less(side, number(0.0), number(cells) - size.clone(), number(cells) + size.clone());
        local(own, if folds[i] { size } else { whole })
    });
    for (index, place, count) in [("i", 0, columns), ("j", 1, rows)] {
        // The last cell includes its end.
        let first = call(Builtin::Min, places[place].clone(), number((count - 2) as f32));
        body.push(Statement::Index(index.to_owned(), first));
    }
    let converted = |index: &str| Expression::Converted(index.to_owned());
    let cell = converted("j") * number(columns as f32) + converted("i");
    body.push(Statement::Index("cell".to_owned(), cell));
    let table = names.of("samples");
    let row = |next: u32| {
        let [from, to] =
            [next, next + 1].map(|next| Expression::Element(table.clone(), "cell".to_owned(), next));
        (to - from.clone(), from)
    };
    let [x, y] = places;
    for (own, next) in [("near", 0), ("far", columns as u32)] {
        let (rise, from) = row(next);
        let value = from + rise * (x.clone() - converted("i"));
        body.push(Statement::Let(Type::Number, own.to_owned(), value));
    }
    let value = name("near") + (name("far") - name("near")) * (y - converted("j"));
    let share = clamp(value * number(1.0 / 65_535.0));
    let function = Function {
        doc: "Returns the share of the intensity toward a point, by the unit vector from the point to the light."
            .to_owned(),
        name: names.of("distribution"),
        parameters: vec![(Type::Vector, "back")],
        body,
        result: if_less(reciprocal, number(2.0), share, number(0.0)),
    };
    let doc = "samples of the octahedron, row by row; 65535 is 1";
    Ok((Constant { doc, name: table, value: Value::Table(samples) }, function))
}
