//! The table of error bounds of single operations: those of the seam (the interface between kernel
//! and number format) in each format, and those of set-up, which are f32 whatever the format.
//! Errors are searched and compared as in [`bounds`](super::bounds), two-sided; `LUMINAIRE_FULL=1
//! cargo test --test suite -- operations:: setup:: --nocapture --test-threads 1` prints the
//! measured ones.

/// The bounds of one operation in `f32`, `Fx32` and `Fx16`, in this order. With a bound of 0 the
/// operation must be exact.
pub struct Row {
    pub operation: &'static str,
    pub bounds: [f64; 3],
}

const fn row(operation: &'static str, bounds: [f64; 3]) -> Row {
    Row { operation, bounds }
}

#[rustfmt::skip]
pub const ROWS: [Row; 35] = [
    row("axis, radians",                 [0.0, 1.0e-9, 7.1e-10]),
    row("normal unit, radians",          [0.0, 0.0, 0.0]),
    row("mirror, radians",               [2.1e-7, 1.8e-9, 8.1e-5]),
    row("direction between, radians",    [1.1e-7, 1.8e-8, 1.3e-5]),
    row("incidence",                     [0.95, 0.5, 1.4]),
    row("versine between, of the outer", [2.1e-7, 6.3e-9, 7.3e-5]),
    row("versine, of the outer",         [0.0, 1.0e-9, 1.0e-9]),
    row("power 32",                      [14.0, 8.6, 1.3]),
    row("gain, relative",                [0.0, 0.0, 3.1e-5]),
    row("gain by, relative",             [6.4e-8, 4.0e-9, 1.7e-5]),
    row("gain plus, relative",           [0.0, 0.0, 1.7e-5]),
    row("inverse capped, relative",      [6.4e-8, 4.2e-9, 1.7e-5]),
    row("fraction of a gain",            [0.0, 0.0, 0.5]),
    row("expose",                        [0.25, 0.5, 0.5]),
    row("filter",                        [1.0, 0.5, 0.5]),
    row("add light",                     [2.0, 0.0, 0.0]),
    row("light to f32, relative",        [0.0, 6.4e-8, 0.0]),
    row("light to gain, relative",       [0.0, 0.0, 0.0]),
    row("amplify",                       [1.0, 0.5, 1.0]),
    row("clip",                          [0.0, 0.0, 0.0]),
    row("exposure",                      [1.0, 0.5, 2.1]),
    row("ambient light and glow",        [1.1, 35.0, 2.1]),
    row("light, filter and sum",         [4.1, 1.1, 1.1]),
    row("ray direction, of the stated",  [0.46, 1.1, 1.1]),
    row("ray direction, its length",     [1.8e-7, 2.1e-8, 1.9e-4]),
    row("ray distance, relative",        [1.4e-7, 3.1e-8, 1.4e-4]),
    row("squared distance, relative",    [1.8e-7, 1.1e-8, 1.6e-4]),
    row("ray cosine",                    [2.2, 43.0, 2.8]),
    row("ray versine, of the outer",     [6.1e-7, 3.0e-8, 2.9e-4]),
    row("ray expose, relative",          [3.7e-7, 6.2e-8, 3.1e-4]),
    row("directional light",             [1.7, 1.8, 1.8]),
    row("times",                         [0.25, 0.5, 0.5]),
    row("minus",                         [0.5, 0.0, 0.0]),
    row("smooth",                        [0.69, 0.5, 0.5]),
    row("to f32, relative",              [0.0, 6.4e-8, 0.0]),
];

/// The bound of one result of set-up: a relative error, unless the name says otherwise.
pub struct Figure {
    pub name: &'static str,
    pub bound: f64,
}

const fn figure(name: &'static str, bound: f64) -> Figure {
    Figure { name, bound }
}

#[rustfmt::skip]
pub const FIGURES: [Figure; 24] = [
    figure("angle in radians",                    7.3e-8),
    figure("angle from radians",                  7.7e-8),
    figure("half angle in radians",               7.3e-8),
    figure("half angle from radians",             7.7e-8),
    figure("versine of an angle",                 3.3e-7),
    figure("angle of a versine",                  1.8e-7),
    figure("direction of an axis, radians",       5.2e-8),
    figure("length of an axis",                   1.7e-7),
    figure("range of a spotlight between points", 1.5e-7),
    figure("outer versine from the outer angle",  2.0e-7),
    figure("outer versine from the field angle",  2.9e-7),
    figure("outer versine from the beam angle",   3.3e-7),
    figure("inner angle of a cone",               7.1e-8),
    figure("beam angle of a cone",                2.1e-7),
    figure("field angle of a cone",               2.5e-7),
    figure("outer angle of a cone",               1.3e-7),
    figure("lumens of a cone",                    3.0e-7),
    figure("candela of a cone",                   2.7e-7),
    figure("beam versine of a falloff",           9.3e-8),
    figure("field versine of a falloff",          1.1e-7),
    figure("integral of a falloff",               3.4e-7),
    figure("inner product of unit vectors",       1.1e-7),
    figure("beam and field angle at once",        5.2e-7),
    figure("beam and field angle with a slope",   4.1e-7),
];
