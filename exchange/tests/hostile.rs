//! Files that are cut, mutated and absurd: every reader returns lights or a refusal, in bounded memory and in
//! a time that grows as the file does.

use std::alloc::{GlobalAlloc, Layout, System as Heap};
use std::fs;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::time::Instant;

use fastrand::Rng;
use luminaire_exchange::{Reading, System, read};

/// The heap, with the bytes in use, the most since the last reset, and all that were ever taken.
struct Counted;

static USED: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);
static TAKEN: AtomicUsize = AtomicUsize::new(0);

// SAFETY: the layouts and the pointers are passed on as they are.
unsafe impl GlobalAlloc for Counted {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let used = USED.fetch_add(layout.size(), Relaxed) + layout.size();
        MOST.fetch_max(used, Relaxed);
        // A small block is work, too.
        TAKEN.fetch_add(64 + layout.size(), Relaxed);
        // SAFETY: as that of this function.
        unsafe { Heap.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        USED.fetch_sub(layout.size(), Relaxed);
        // SAFETY: as that of this function.
        unsafe { Heap.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static HEAP: Counted = Counted;

/// The most memory that an input of up to a megabyte may take.
const LARGEST: usize = 64 << 20;

/// The number of inputs for each reader: 400, or that of `LUMINAIRE_HOSTILE`.
fn inputs() -> usize {
    std::env::var("LUMINAIRE_HOSTILE").ok().and_then(|text| text.parse().ok()).unwrap_or(400)
}

/// Whether the inputs are a megabyte large, as `LUMINAIRE_FULL` and a number of inputs have it.
fn is_full() -> bool {
    std::env::var_os("LUMINAIRE_FULL").is_some() || inputs() > 400
}

/// Reads an input in bounded memory, tests that a refusal is short, and returns what was taken of the heap: a
/// measure of the work.
fn survives(name: &str, bytes: &[u8], system: System) -> usize {
    // The tests run in threads of one heap.
    static ALONE: Mutex<()> = Mutex::new(());
    let _alone = ALONE.lock().expect("the other test");
    let before = USED.load(Relaxed);
    MOST.store(before, Relaxed);
    let taken = TAKEN.load(Relaxed);
    let lamps = read(name, bytes, Some(system), Reading::default());
    let most = MOST.load(Relaxed) - before;
    assert!(most <= LARGEST, "{name} as {system}: {most} bytes of memory");
    let refused = match &lamps {
        Ok(lamps) => lamps.refused.iter().map(ToString::to_string).collect(),
        Err(refusal) => vec![refusal.to_string()],
    };
    assert!(refused.iter().all(|refusal| refusal.chars().count() <= 2_000));
    TAKEN.load(Relaxed) - taken
}

/// Changes, removes, doubles and inserts bytes, words of numbers and pieces.
fn mutated(rng: &mut Rng, bytes: &[u8]) -> Vec<u8> {
    const WORDS: [&str; 10] = ["-1", "1e999", "NaN", "0", "99999999999", "{", "[[", "<a b='c'>", "\"", "\n"];
    let mut bytes = bytes.to_vec();
    for _ in 0..=rng.u32(0..4) {
        let [from, to] = [rng.usize(0..=bytes.len()), rng.usize(0..=bytes.len())];
        let (from, to) = (from.min(to), from.max(to).min(from.min(to) + 40));
        match rng.u32(0..5) {
            0 if !bytes.is_empty() => {
                let at = rng.usize(0..bytes.len());
                bytes[at] = rng.u8(..);
            }
            1 => drop(bytes.drain(from..to)),
            2 => {
                let piece = bytes[from..to].to_vec();
                bytes.splice(to..to, piece);
            }
            3 => drop(bytes.splice(from..to, rng.choice(WORDS).unwrap_or("").bytes())),
            _ => bytes.truncate(to),
        }
    }
    bytes
}

#[test]
fn mutated_files_are_read_or_refused() {
    let total = inputs();
    let mut fixtures = Vec::new();
    for folder in ["real", "files"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(folder);
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("a file").path();
            let name = path.file_name().and_then(|name| name.to_str()).expect("a name").to_owned();
            let bytes = fs::read(&path).expect("a file");
            if let Ok(lamps) = read(&name, &bytes, None, Reading::default()) {
                fixtures.push((name, bytes, lamps.system));
            }
        }
    }
    // Cut at every byte, or in short at some.
    let step = if total > 400 { 1 } else { 7 };
    for (name, bytes, system) in &fixtures {
        (0..bytes.len()).step_by(step).for_each(|end| _ = survives(name, &bytes[..end], *system));
    }
    let mut rng = Rng::with_seed(fixtures.len() as u64);
    for &system in System::ALL {
        let own: Vec<_> = fixtures.iter().filter(|fixture| fixture.2 == system).collect();
        // A system without a fixture gets those of all others.
        let own = if own.is_empty() { fixtures.iter().collect() } else { own };
        for round in 0..total {
            let (name, bytes, _) = own[round % own.len()];
            survives(name, &mutated(&mut rng, bytes), system);
        }
        println!("{system}: {total} inputs from {} files", own.len());
    }
}

#[test]
fn bombs_are_refused_in_bounded_memory() {
    // A tenth of a megabyte, or with a slower run the whole.
    let part = if is_full() { 1 } else { 10 };
    let deep = |open: &str, count: usize| open.repeat(count / part);
    let entities = format!(
        "<!DOCTYPE x [<!ENTITY a \"{}\">{}]><X3D>&a;</X3D>",
        "b".repeat(1_000),
        "<!ENTITY c \"&a;&a;\">".repeat(1_000)
    );
    let inputs = [
        deep("[", 900_000),
        deep("{\"a\":", 180_000),
        deep("<a>", 300_000),
        deep("{", 900_000),
        deep("Transform { ", 70_000),
        deep("def Xform \"a\" {", 60_000),
        deep("AttributeBegin\n", 60_000),
        deep("9 ", 450_000),
        deep("\"", 900_000),
        entities,
        format!("IESNA91\nTILT=NONE\n1 -1 1 999999999 999999999 1 2 0 0 0\n1 1 0\n{}", deep("0 ", 400_000)),
        format!(
            "{{\"format\":\"luminaire-lights-1\",\"lights\":[{}]}}",
            vec!["{\"about\":[[],[]]}"; 40_000 / part].join(",")
        ),
    ];
    for input in &inputs {
        for &system in System::ALL {
            survives("bomb", input.as_bytes(), system);
        }
    }
}

/// Inputs of about `bytes` bytes in which one thing is there for each of many others, or the text of a value is
/// far smaller than what it becomes.
fn products(bytes: usize) -> Vec<(System, &'static str, String)> {
    use System::{Babylon, Eulumdat, Gltf, Godot, Ies, Luminaire, Ofl, Pbrt, Three, Unity, Unreal, Usd, X3d};
    let many = |unit: &str| unit.repeat(bytes / unit.len());
    // Half of the bytes, and a quarter of them.
    let (half, long) = (|unit: &str| unit.repeat(bytes / 2 / unit.len()), "n".repeat(bytes / 2));
    let numbered = |part: usize, unit: fn(usize) -> String| {
        let count = bytes / part / unit(1_000).len();
        (0..count).map(unit).collect::<String>()
    };
    let own = |lights: &str| format!("{{\"format\":\"luminaire-lights-1\",\"lights\":[{lights}]}}");
    let gltf = |nodes: &str, name: &str| {
        let lights = format!(
            "{{\"KHR_lights_punctual\":{{\"lights\":[{{\"type\":\"point\",\"name\":\"{name}\"}}]}}}}"
        );
        format!("{{\"asset\":{{\"version\":\"2.0\"}},\"extensions\":{lights},\"nodes\":[{nodes}{{}}]}}")
    };
    let lit = "{\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}},";
    let chain = numbered(2, |i| format!("{{\"children\":[{}]}},", i % 500 + 1));
    let babylon = numbered(2, |i| format!("{{\"uniqueId\":{i},\"parentId\":{}}},", i + 1));
    let ops = half("\"xformOp:translate\",");
    let angles =
        |count: usize| (0..count).map(|i| format!("{} ", 90.0 * i as f64 / count as f64)).collect::<String>();
    let angles = angles((bytes / 20).min(900_000));
    let count = angles.matches(' ').count();
    let values =
        |on: &str| (0..count).map(|i| format!("{} ", if i % 2 == 0 { on } else { "0" })).collect::<String>();
    let world = |text: String| format!("#X3D V3.0 utf8\n{text}");
    let component = "Begin Object Class=PointLightComponent Name=\"b\"\nEnd Object\n";
    let document = |kind: u32, id: usize, rest: &str| format!("--- !u!{kind} &{id}\nA:\n{rest}");
    let place =
        "  m_GameObject: {fileID: 1}\n  m_LocalPosition: {x: 0, y: 0, z: 0}\n  m_Father: {fileID: 0}\n";
    let unity = |name: &str| document(4, 2, place) + &document(1, 1, &format!("  m_Name: {name}\n"));
    vec![
        (Luminaire, "about", own(&format!("{{\"kind\":\"point\",\"about\":[{}1]}}", many("1,")))),
        (Luminaire, "lights", own(&(many("{},") + "{}"))),
        (Luminaire, "trees", own(&format!("{{\"attenuation\":[{}1]}}", many("{\"\":0},")))),
        (Luminaire, "points", own(&(many("{\"kind\":\"point\"},") + "{}"))),
        (
            X3d,
            "colours",
            format!("<X3D>{}</X3D>", many(&format!("<PointLight color='{}'/>", "9e307 ".repeat(16)))),
        ),
        (
            X3d,
            "names",
            format!(
                "<X3D><PointLight DEF='{long}' color='{long}'/>{}</X3D>",
                half(&format!("<A USE='{long:.40}'/>"))
            ),
        ),
        (
            X3d,
            "again",
            world(format!("DEF A Group {{ PointLight {{ color {} }} }} {}", half("1 "), half("USE A "))),
        ),
        (X3d, "nodes", world(many("A{B[]"))),
        (X3d, "deep", world(many("Group{") + "PointLight{}")),
        (X3d, "beams", world(numbered(1, |i| format!("SpotLight{{beamWidth .{i}}}")))),
        (
            Usd,
            "orders",
            format!(
                "#usda 1.0\ndef Xform \"a\" {{ double3 xformOp:translate = (1, 2, 3)\ntoken[] xformOpOrder = [{ops}]\n{} }}",
                half("def SphereLight \"b\" { }")
            ),
        ),
        (Usd, "nodes", "#usda 1.0\n".to_owned() + &many("over \"a\"{a=1}")),
        (Usd, "paths", "#usda 1.0\n".to_owned() + &many("@<'")),
        (Pbrt, "comments", format!("Translate 1 2 {}3\n{}", half("#\n"), half("LightSource \"point\"\n"))),
        (Pbrt, "scales", many("Scale 1 ") + "LightSource \"point\""),
        (Pbrt, "moves", numbered(1, |_| "Scale 1 1 1 LightSource \"point\" ".to_owned())),
        (
            Godot,
            "moves",
            format!(
                "[node name=\"a\" type=\"Node3D\"]\ntransform = A({})\n{}",
                half("1, "),
                half("[node name=\"b\" type=\"OmniLight3D\" parent=\".\"]\n")
            ),
        ),
        (Godot, "lines", "[node name=\"a\" type=\"OmniLight3D\"]\n".to_owned() + &many("a = [\n")),
        (
            Unity,
            "names",
            unity(&long) + &half(&document(108, 3, "  m_GameObject: {fileID: 1}\n  m_Type: 2\n")),
        ),
        (
            Unity,
            "fields",
            document(4, 9, &(place.to_owned() + &numbered(2, |i| format!("  a{i}: 1\n"))))
                + &half(&document(4, 3, "  m_GameObject: {fileID: 7}\n  m_Father: {fileID: 9}\n")),
        ),
        (Unity, "quotes", document(4, 9, "  m_Name: ") + &many("'")),
        (Unreal, "names", format!("Begin Actor\nActorLabel=\"{long}\"\n{}End Actor\n", half(component))),
        (
            Unreal,
            "values",
            format!(
                "Begin Actor\n{}{}End Actor\n",
                numbered(2, |i| format!("a{i}=1\n")),
                numbered(2, |i| format!("Begin Object Class=PointLightComponent Name=\"{i}\"\nEnd Object\n"))
            ),
        ),
        (Gltf, "names", gltf(&half(lit), &long)),
        (Gltf, "parents", gltf(&(chain + &half(lit)), "")),
        (Gltf, "objects", gltf(&many("{},"), "")),
        (
            Babylon,
            "parents",
            format!(
                "{{\"lights\":[{}{{}}],\"meshes\":[{babylon}{{}}]}}",
                half("{\"type\":0,\"parentId\":3},")
            ),
        ),
        (
            Three,
            "deep",
            format!(
                "{{\"metadata\":{{\"type\":\"Object\"}},\"object\":{{\"children\":[{}{{}}]}}}}",
                many("{\"type\":\"PointLight\"},")
            ),
        ),
        (
            Ofl,
            "modes",
            format!("{{\"modes\":[{}{{}}]}}", many("{\"physical\":{\"lens\":{\"degreesMinMax\":[9,8]}}},")),
        ),
        (Usd, "numbers", format!("# system: usd\n{}", numbered(1, |i| format!("a{i}=1\n")))),
        (
            Ies,
            "angles",
            format!("IES\nTILT=NONE\n1 -1 1 {count} 1 1 2 0 0 0\n1 1 0\n{angles}\n0\n{}", values("100")),
        ),
        (
            Eulumdat,
            "angles",
            // A plane with many angles, relative to a lamp of 1000 lm.
            format!("a\n\n1\n1\n0\n{count}\n0\n\nb\nc\n{}1\n0\n1\n1\n\n1000\n", "\n".repeat(13))
                + &format!("{}0\n{angles}\n{}", "\n".repeat(13), values("100")).replace(' ', "\n"),
        ),
    ]
}

/// Twice the file is twice the work, not four times, and a megabyte takes no more memory than a scene.
/// `LUMINAIRE_FULL=1 cargo test -p luminaire-exchange --test hostile work -- --nocapture` prints the times.
#[test]
fn work_is_bounded_by_the_input() {
    let bytes = if is_full() { 1 << 19 } else { 1 << 14 };
    for ((system, what, one), (.., two)) in products(bytes).into_iter().zip(products(2 * bytes)) {
        let [one, two] = [&one, &two].map(|text| {
            let start = Instant::now();
            let work = survives(what, text.as_bytes(), system);
            println!("{system} {what}: {:.2?} for {} bytes", start.elapsed(), text.len());
            work
        });
        assert!(two <= 3 * one.max(1 << 16), "{system} {what}: {one} of the heap, of twice the file {two}");
    }
    let becomes_large = |what: &str| ["about", "lights", "colours", "nodes"].contains(&what);
    for (system, what, text) in products(1 << 20).into_iter().filter(|input| becomes_large(input.1)) {
        survives(what, text.as_bytes(), system);
    }
}
