//! Lit points of others beside those of the library.

use luminaire_kernels::{Rival, RivalVisitor, Row, Setting, rivals, truth::Point};

use super::text::{cells, cost, error, table};
use crate::effects::COMPARED;
use crate::record::Record;
use crate::target::Target;

/// The lit points of the library: what they are, and who would choose them.
const OURS: [(&str, &str, &str); 4] = [
    (
        "lit-inverse-square.fx16-quick",
        "**`Fx16`, quick**",
        "who has a small display and no surface beyond full scale",
    ),
    ("lit-inverse-square.fx16", "**`Fx16`**", "who has no floating point unit"),
    ("lit-inverse-square.fx32", "**`Fx32`**", "who has no floating point unit and 8 bits a channel"),
    ("lit-inverse-square.f32", "**`f32`**", "who has a floating point unit"),
];

/// The lit point in C.
const C: (&str, &str, &str) = (
    "lit-inverse-square-libgcc.rival",
    "C by the floats of gcc, root by three steps of Newton's method",
    "who writes C and floats for a Cortex-M0",
);

/// The error, in codes, from which on a display shows a difference.
const VISIBLE: f64 = 0.5;

const ABOUT: &str = "
## A lit point by others

What one would write instead: the same soft spotlight, inverse square and Lambert's cosine at the same points. These cost less
than every evaluation of ours that errs as little, where half a code and less count as equal:

";

const READING: &str = "
Each is a [text of its own](../benches/kernels/src/rival) of the published law, or calls a crate; its light is a constant, as
ours is. The two renderers, `f32-tgx` and `f32-3dgfx`, have windows of their own in place of the inverse square. The errors
of each are those against its own law in linear codes (searched, at half angles of 22° and 1°, at distances of 1 to 7, also over full
scale), the costs instructions or nanoseconds a call, sorted by those on a Cortex-M0; bytes are those of its code there and of
its tables. The baked pool has a floor instead of points and normals, and 8 kB of RAM if the light ever changes. Instructions are not
cycles: a division or a root takes 14 on a Cortex-M4F (Arm's technical reference manual); `f32-plain` has five divisions and a
root, `f32-difference` and our `f32` one of each.

";

/// A row: its name on record, two phrases, and the bytes of its tables.
struct Listed {
    name: String,
    what: &'static str,
    who: &'static str,
    tables: u64,
}

struct Reader(Vec<Listed>);

impl RivalVisitor for Reader {
    fn rival<R: Rival>(&mut self, row: Row, _: &Point) {
        let name = format!("{}.{}", row.kernel, row.format);
        self.0.push(Listed { name, what: R::WHAT, who: R::WHO, tables: R::TABLES as u64 });
    }
}

/// The table of lit points, and where a rival is better.
pub(super) fn section(record: &Record) -> String {
    let own = OURS.into_iter().chain([C]);
    let mut all =
        Reader(own.map(|(name, what, who)| Listed { name: name.into(), what, who, tables: 0 }).collect());
    rivals(Setting::standard(), &mut all);
    let targets: Vec<_> = COMPARED.into_iter().chain(["host"]).flat_map(Target::named).collect();
    let price = |name: &str, target: &Target| record.group(target.name()).number(name, target.unit());
    all.0.sort_by(|a, b| {
        price(&a.name, &targets[0]).partial_cmp(&price(&b.name, &targets[0])).expect("numbers")
    });
    let mut heads = cells(["lit point", "for whom", "error at 22°", "at 1°", "mean"]);
    heads.extend(targets.iter().map(|target| target.title().to_owned()));
    heads.push("bytes".to_owned());
    let rows = all.0.iter().map(|Listed { name, what, who, tables }| {
        let figure =
            |group: &str, unit| record.group(group).number(name, unit).map_or_else(String::new, error);
        let mut row =
            vec![short(name).map_or_else(|| (*what).to_owned(), |name| format!("`{name}`: {what}"))];
        row.push((*who).to_owned());
        row.extend([
            figure("errors", "codes"),
            figure("errors at 1", "codes"),
            figure("errors", "mean_codes"),
        ]);
        row.extend(targets.iter().map(|target| price(name, target).map_or_else(String::new, cost)));
        let bytes = record.group("cortex-m0").number(name, "bytes");
        row.push(bytes.map_or_else(String::new, |bytes| (bytes as u64 + tables).to_string()));
        row
    });
    let better = targets.iter().map(|target| {
        let found: Vec<_> = all.0.iter().filter_map(|rival| better(record, target, rival)).collect();
        let found = if found.is_empty() { "none".to_owned() } else { found.join("; ") };
        format!("- {}: {found}.\n", target.title())
    });
    ABOUT.to_owned() + &better.collect::<String>() + READING + &table(&heads, rows)
}

/// The name of a rival without its stage; none for a light of the library.
fn short(name: &str) -> Option<&str> {
    name.strip_suffix(".rival").map(|name| name.trim_start_matches("lit-"))
}

/// States a rival that costs less than every evaluation of the library whose error is no larger.
fn better(record: &Record, target: &Target, rival: &Listed) -> Option<String> {
    let (group, errors) = (record.group(target.name()), record.group("errors"));
    let figures = |name: &str| group.number(name, target.unit()).zip(errors.number(name, "codes"));
    let (own, most) = figures(&rival.name)?;
    let ours = OURS.iter().filter_map(|(name, what, _)| Some((figures(name)?, what)));
    let as_good = ours.filter(|((_, codes), _)| *codes <= most.max(VISIBLE));
    let ((least, _), what) = as_good.min_by(|((a, _), _), ((b, _), _)| a.total_cmp(b))?;
    let name = short(&rival.name)?;
    (own < least)
        .then(|| format!("`{name}` {}, where {} takes {}", cost(own), what.replace('*', ""), cost(least)))
}
