//! Files that are cut, mutated and absurd: every reader returns lights or a refusal, in bounded memory.

use std::alloc::{GlobalAlloc, Layout, System as Heap};
use std::fs;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use fastrand::Rng;
use luminaire_exchange::{System, read};

/// The heap, with the bytes in use and the most since the last reset.
struct Counted;

static USED: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: the layouts and the pointers are passed on as they are.
unsafe impl GlobalAlloc for Counted {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let used = USED.fetch_add(layout.size(), Relaxed) + layout.size();
        MOST.fetch_max(used, Relaxed);
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

/// Reads an input in bounded memory, and tests that a refusal is short.
fn survives(name: &str, bytes: &[u8], system: System) {
    // The tests run in threads of one heap.
    static ALONE: Mutex<()> = Mutex::new(());
    let _alone = ALONE.lock().expect("the other test");
    let before = USED.load(Relaxed);
    MOST.store(before, Relaxed);
    let lamps = read(name, bytes, Some(system), 1.0);
    let most = MOST.load(Relaxed) - before;
    assert!(most <= LARGEST, "{name} as {system}: {most} bytes of memory");
    let refused = match &lamps {
        Ok(lamps) => lamps.refused.iter().map(ToString::to_string).collect(),
        Err(refusal) => vec![refusal.to_string()],
    };
    assert!(refused.iter().all(|refusal| refusal.chars().count() <= 2_000));
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
            if let Ok(lamps) = read(&name, &bytes, None, 1.0) {
                fixtures.push((name, bytes, lamps.system));
            }
        }
    }
    // Cut at every byte, or in short at some.
    let step = if total > 400 { 1 } else { 7 };
    for (name, bytes, system) in &fixtures {
        (0..bytes.len()).step_by(step).for_each(|end| survives(name, &bytes[..end], *system));
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
    let part = if inputs() > 400 { 1 } else { 10 };
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
