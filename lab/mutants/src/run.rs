//! Runs the tests on each mutant, those that reach it and no others.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fmt;
use std::fs::{self, File, OpenOptions};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::iter;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail, ensure};
use tools::project;

use crate::find::Mutant;
use crate::list::{Equivalents, LIST, lists, parse};
use crate::tree::{Program, Tree};

/// Which mutants are tested, and how.
#[derive(Clone, Debug)]
pub struct Options {
    /// Only those on lines that changed since this revision.
    pub since: Option<String>,
    /// Only those of this file below `core/src`.
    pub file: Option<String>,
    /// Only this many of them, drawn at random.
    pub sample: Option<usize>,
    /// The seed of the draw.
    pub seed: u64,
    /// How many are tested at once.
    pub jobs: usize,
}

/// What the tests noticed.
#[derive(Debug, Default, PartialEq)]
pub struct Summary {
    /// How many mutants were looked at.
    pub mutants: usize,
    /// Mutants with which a test failed or did not end.
    pub killed: usize,
    /// Mutants in the list of those that no test can notice.
    pub equivalent: usize,
    /// Mutants that are not among these: functions that run at compile time only, where no mutant
    /// can be chosen.
    pub compiled: usize,
    /// All others, as the lines that they would have in the list.
    pub survivors: Vec<String>,
}

impl fmt::Display for Summary {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { mutants, killed, equivalent, survivors, .. } = self;
        write!(
            out,
            "{mutants} mutants, {killed} killed, {equivalent} equivalent, {} survive",
            survivors.len()
        )
    }
}

/// A test, the time that it takes, and the sites that it reaches.
struct Test {
    program: Program,
    name: String,
    time: Duration,
    reached: BTreeSet<usize>,
    kills: AtomicUsize,
}

/// A test with a mutant may take this much longer than without, and then some.
const SLOWER: u32 = 20;
const AND_THEN: Duration = Duration::from_secs(5);

/// What a test reaches is recorded for this long: a sweep reaches nearly all of it at once, and
/// recording slows it down several times.
const RECORDED: Duration = Duration::from_secs(8);

/// A test that takes longer than this is left out.
const LONGEST: Duration = Duration::from_secs(30);

/// Tests the mutants of the workspace at `root`; everything that is built is below `folder`.
pub fn run(root: &Path, folder: &Path, options: &Options, tell: &(dyn Fn(&str) + Sync)) -> Result<Summary> {
    let list = parse(&fs::read_to_string(root.join(LIST)).context(LIST)?)?;
    let tree = Tree::new(root, folder, tell)?;
    tell(&format!("{} mutants compile, {} do not", tree.mutants.len(), tree.refused));
    if !tree.unparsed.is_empty() {
        tell(&format!("macros with a body that is left out: {}", tree.unparsed.join(" ")));
    }
    let chosen = chosen(root, &tree.mutants, options)?;
    let is_listed = |id: &&usize| lists(&list, &tree.mutants[**id].key());
    let mut done = Results::open(root, folder)?;
    let mut todo: Vec<_> = chosen
        .iter()
        .copied()
        .filter(|id| !is_listed(&id) && done.of(&tree.mutants[*id]).is_none())
        .collect();
    if !todo.is_empty() {
        tell("building the tests");
        let tests = tests(&tree.build()?, folder, options.jobs, tell)?;
        // Whatever stops the run, what was tested is spread over all files.
        fastrand::Rng::with_seed(options.seed).shuffle(&mut todo);
        test_all(&tree, &tests, &todo, options.jobs, &Mutex::new(&mut done), tell)?;
    }
    Ok(summary(&tree, &chosen, &list, &done))
}

fn summary(tree: &Tree, chosen: &[usize], list: &Equivalents, done: &Results) -> Summary {
    let mut summary = Summary { mutants: chosen.len(), ..Summary::default() };
    for mutant in chosen.iter().map(|id| &tree.mutants[*id]) {
        let outcome = done.of(mutant).unwrap_or_default();
        if lists(list, &mutant.key()) {
            summary.equivalent += 1;
        } else if outcome.starts_with(KILLED) {
            summary.killed += 1;
        } else if outcome == UNREACHED && mutant.is_const {
            (summary.mutants, summary.compiled) = (summary.mutants - 1, summary.compiled + 1);
        } else {
            let remark = if outcome == UNREACHED { " (no test reaches it)" } else { "" };
            summary.survivors.push(mutant.key() + remark);
        }
    }
    summary
}

/// The numbers of the mutants that the options ask for.
fn chosen(root: &Path, mutants: &[Mutant], options: &Options) -> Result<Vec<usize>> {
    let changed = options.since.as_ref().map(|since| changed_lines(root, since)).transpose()?;
    let file = options.file.as_ref().map(|file| file.trim_start_matches("core/src/"));
    ensure!(file.is_none_or(|file| mutants.iter().any(|mutant| mutant.file == file)), "{file:?}: no mutants");
    let is_changed = |mutant: &Mutant| {
        changed.as_ref().is_none_or(|changed| {
            let lines = changed.get(&mutant.file).into_iter().flatten();
            lines.copied().any(|line| mutant.lines.0 <= line && line <= mutant.lines.1)
        })
    };
    let is_chosen = |mutant: &Mutant| file.is_none_or(|file| mutant.file == file) && is_changed(mutant);
    let mut chosen: Vec<_> = (0..mutants.len()).filter(|id| is_chosen(&mutants[*id])).collect();
    if let Some(sample) = options.sample {
        fastrand::Rng::with_seed(options.seed).shuffle(&mut chosen);
        chosen.truncate(sample);
        chosen.sort_unstable();
    }
    Ok(chosen)
}

fn changed_lines(root: &Path, since: &str) -> Result<BTreeMap<String, Vec<usize>>> {
    let mut git = Command::new("git");
    git.args(["diff", "--unified=0", "--no-color", "--relative=core/src/", since, "--"]).current_dir(root);
    let output = git.output().context("cannot start git")?;
    if !output.status.success() {
        bail!("git diff {since}: {}", String::from_utf8_lossy(&output.stderr).trim());
    }
    Ok(hunks(&String::from_utf8_lossy(&output.stdout)))
}

/// The new lines of each file in the output of `git diff --unified=0`.
fn hunks(difference: &str) -> BTreeMap<String, Vec<usize>> {
    let (mut lines, mut file) = (BTreeMap::<_, Vec<_>>::new(), None);
    for line in difference.lines() {
        if let Some(path) = line.strip_prefix("+++ ") {
            file = path.strip_prefix("b/").map(str::to_owned);
        }
        let new = line
            .strip_prefix("@@ ")
            .and_then(|rest| rest.split_whitespace().find_map(|word| word.strip_prefix('+')));
        if let (Some(new), Some(file)) = (new, &file) {
            let (start, length) = new.split_once(',').unwrap_or((new, "1"));
            let (start, length) = (start.parse().unwrap_or(0), length.parse().unwrap_or(0));
            lines.entry(file.clone()).or_default().extend(start..start + length);
        }
    }
    lines
}

/// The tests with what they reach, recorded again only if a program has changed.
fn tests(
    programs: &[Program],
    folder: &Path,
    jobs: usize,
    tell: &(dyn Fn(&str) + Sync),
) -> Result<Vec<Test>> {
    let contents = programs.iter().map(|program| fs::read(&program.file)).collect::<Result<Vec<_>, _>>()?;
    let (path, key) = (folder.join("reached.txt"), format!("{:016x}", hash(&contents)));
    let text = fs::read_to_string(&path).unwrap_or_default();
    let mut lines = text.lines();
    if lines.next() == Some(&key) {
        return lines.map(|line| Test::parse(line, programs).context("reached.txt")).collect();
    }
    let tests = recorded(programs, folder, jobs, tell)?;
    let lines: Vec<_> = iter::once(key).chain(tests.iter().map(Test::line)).collect();
    fs::write(&path, lines.join("\n")).context("reached.txt")?;
    Ok(tests)
}

impl Test {
    fn line(&self) -> String {
        let reached: Vec<_> = self.reached.iter().map(usize::to_string).collect();
        let (program, name, time) = (&self.program.name, &self.name, self.time.as_secs_f64());
        format!("{program}\t{name}\t{time}\t{}", reached.join(" "))
    }

    fn parse(line: &str, programs: &[Program]) -> Option<Self> {
        let mut words = line.split('\t');
        let program = words.next()?;
        let program = programs.iter().find(|known| known.name == program)?.clone();
        let (name, time) = (words.next()?.to_owned(), words.next()?.parse().ok()?);
        let reached = words.next()?.split(' ').filter_map(|id| id.parse().ok()).collect();
        Some(Self { program, name, time: Duration::from_secs_f64(time), reached, kills: AtomicUsize::new(0) })
    }
}

/// Lists the tests, runs each once and records what it reaches. A test that fails in the copy, such
/// as one that reads the source, is left out.
fn recorded(
    programs: &[Program],
    folder: &Path,
    jobs: usize,
    tell: &(dyn Fn(&str) + Sync),
) -> Result<Vec<Test>> {
    let mut names = Vec::new();
    for program in programs {
        let output = command(program, &["--list", "--format", "terse"]).stdout(Stdio::piped()).output()?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let tests = text.lines().filter_map(|line| line.strip_suffix(": test"));
        names.extend(tests.map(|name| (program.clone(), name.to_owned())));
    }
    tell(&format!("recording what {} tests reach", names.len()));
    let (next, tests) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let record = || -> Result<()> {
        while let Some((program, name)) = names.get(next.fetch_add(1, Ordering::Relaxed)) {
            let seen = folder.join(format!("seen-{}-{}", program.name, name.replace("::", "-")));
            let _ = fs::remove_file(&seen);
            let timed = |recorded: bool| -> Result<_> {
                let mut test = command(program, &["--exact", name]);
                if recorded {
                    test.env("LUMINAIRE_MUTANTS_SEEN", &seen);
                }
                let start = Instant::now();
                Ok((ended(test, if recorded { RECORDED } else { LONGEST })?, start.elapsed()))
            };
            let (mut ended, mut time) = timed(true)?;
            if time > RECORDED / 4 {
                (ended, time) = timed(false)?;
            }
            let reached = fs::read_to_string(&seen).unwrap_or_default();
            let _ = fs::remove_file(&seen);
            let reached: BTreeSet<_> = reached.lines().filter_map(|id| id.parse().ok()).collect();
            match ended {
                Some(true) if !reached.is_empty() => {
                    let (program, name, kills) = (program.clone(), name.clone(), AtomicUsize::new(0));
                    let test = Test { program, name, time, reached, kills };
                    tests.lock().unwrap_or_else(|error| error.into_inner()).push(test);
                }
                Some(true) => {}
                Some(false) => tell(&format!("left out: {} {name}, which fails in the copy", program.name)),
                None => tell(&format!("left out: {} {name}, which takes long", program.name)),
            }
        }
        Ok(())
    };
    on_threads(jobs, record)?;
    let tests = tests.into_inner().unwrap_or_else(|error| error.into_inner());
    ensure!(!tests.is_empty(), "no test reaches a mutant");
    Ok(tests)
}

fn on_threads(jobs: usize, work: impl Fn() -> Result<()> + Sync) -> Result<()> {
    thread::scope(|scope| {
        let threads: Vec<_> = (0..jobs.max(1)).map(|_| scope.spawn(&work)).collect();
        threads.into_iter().try_for_each(|thread| match thread.join() {
            Ok(result) => result,
            Err(panic) => std::panic::resume_unwind(panic),
        })
    })
}

fn test_all(
    tree: &Tree,
    tests: &[Test],
    todo: &[usize],
    jobs: usize,
    done: &Mutex<&mut Results>,
    tell: &(dyn Fn(&str) + Sync),
) -> Result<()> {
    let mut reaching: HashMap<usize, Vec<&Test>> = HashMap::new();
    for test in tests {
        for site in &test.reached {
            reaching.entry(*site).or_default().push(test);
        }
    }
    let (next, alive, start) = (AtomicUsize::new(0), AtomicUsize::new(0), Instant::now());
    on_threads(jobs, || {
        loop {
            let count = next.fetch_add(1, Ordering::Relaxed);
            let Some(&id) = todo.get(count) else { return Ok(()) };
            let reaching = reaching.get(&tree.sites[id]).map_or(&[][..], Vec::as_slice);
            let outcome = outcome(id, reaching)?;
            if !outcome.starts_with(KILLED) {
                alive.fetch_add(1, Ordering::Relaxed);
            }
            done.lock().unwrap_or_else(|error| error.into_inner()).add(&tree.mutants[id], outcome)?;
            if (count + 1).is_multiple_of(50) {
                let (alive, seconds) = (alive.load(Ordering::Relaxed), start.elapsed().as_secs());
                tell(&format!("tested {} of {}, {alive} survive, {seconds} s", count + 1, todo.len()));
            }
        }
    })
}

const KILLED: &str = "killed";
const UNREACHED: &str = "unreached";

/// Runs the tests on a mutant until one fails: first those that are quick and noticed many.
fn outcome(id: usize, reaching: &[&Test]) -> Result<String> {
    if reaching.is_empty() {
        return Ok(UNREACHED.into());
    }
    let mut tests = reaching.to_vec();
    let cost = |test: &Test| test.time.as_secs_f64() / (1 + test.kills.load(Ordering::Relaxed)) as f64;
    tests.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
    for test in tests {
        let mut command = command(&test.program, &["--exact", &test.name]);
        command.env("LUMINAIRE_MUTANT", id.to_string());
        let how = match ended(command, test.time * SLOWER + AND_THEN)? {
            Some(true) => continue,
            Some(false) => "by",
            None => "by the time of",
        };
        test.kills.fetch_add(1, Ordering::Relaxed);
        return Ok(format!("{KILLED} {how} {} {}", test.program.name, test.name));
    }
    Ok("survives".into())
}

fn command(program: &Program, words: &[&str]) -> Command {
    let mut command = Command::new(&program.file);
    command.args(words).current_dir(&program.folder).env("RUST_BACKTRACE", "0");
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

/// Whether a program succeeds; `None` if it takes too long.
fn ended(mut command: Command, limit: Duration) -> Result<Option<bool>> {
    let mut child = command.spawn().context("cannot start a test")?;
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status.success()));
        }
        if start.elapsed() > limit {
            // It may have ended by now.
            let _ = child.kill();
            child.wait()?;
            return Ok(None);
        }
        thread::sleep((start.elapsed() / 20).clamp(Duration::from_micros(500), Duration::from_millis(20)));
    }
}

/// The outcomes so far, which a later run goes on from: a line for each mutant with the hashes of
/// its file and of the tests.
struct Results {
    tests: u64,
    sources: BTreeMap<PathBuf, u64>,
    outcomes: HashMap<String, String>,
    file: File,
}

impl Results {
    fn open(root: &Path, folder: &Path) -> Result<Self> {
        let path = folder.join("results.txt");
        let text = fs::read_to_string(&path).unwrap_or_default();
        let outcomes = text.lines().filter_map(|line| line.rsplit_once('\t'));
        let outcomes = outcomes.map(|(key, outcome)| (key.to_owned(), outcome.to_owned())).collect();
        let file = OpenOptions::new().append(true).create(true).open(&path).context("results.txt")?;
        let [tests, conform, sources] =
            ["tests", "lab/conform", "core/src"].map(|folder| project::files(&root.join(folder), &[]));
        let tests = hash(&[tests?, conform?]);
        let sources = sources?;
        let sources = sources.into_iter().map(|(path, bytes)| (path, hash(&bytes))).collect();
        Ok(Self { tests, sources, outcomes, file })
    }

    fn key(&self, mutant: &Mutant) -> String {
        let source = self.sources.get(Path::new(&mutant.file)).copied().unwrap_or_default();
        format!("{}\t{source:016x}", mutant.key())
    }

    /// What came of a mutant. One that survived other tests is tested again.
    fn of(&self, mutant: &Mutant) -> Option<&str> {
        let outcome = self.outcomes.get(&self.key(mutant))?;
        let (outcome, tests) = outcome.rsplit_once(" #")?;
        (outcome.starts_with(KILLED) || tests == format!("{:016x}", self.tests)).then_some(outcome)
    }

    fn add(&mut self, mutant: &Mutant, outcome: String) -> Result<()> {
        let outcome = format!("{outcome} #{:016x}", self.tests);
        let key = self.key(mutant);
        writeln!(self.file, "{key}\t{outcome}")?;
        self.outcomes.insert(key, outcome);
        Ok(())
    }
}

fn hash(value: &impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    value.hash(&mut hasher);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changed_lines_are_the_new_ones() {
        let difference = "+++ b/a.rs\n@@ -1,2 +3,2 @@ fn f\n+x\n@@ -9 +8,0 @@\n@@ -9 +12 @@\n+++ /dev/null\n@@ -1 +0,0 @@\n";
        assert_eq!(hunks(difference), BTreeMap::from([("a.rs".to_owned(), vec![3, 4, 12])]));
    }

    #[test]
    fn a_program_is_waited_for_as_long_as_its_limit() {
        let sleep = |time: &str| {
            let mut command = Command::new("sleep");
            command.arg(time);
            command
        };
        assert_eq!(ended(sleep("0"), LONGEST).unwrap(), Some(true));
        assert_eq!(ended(sleep("x"), LONGEST).unwrap(), Some(false));
        assert_eq!(ended(sleep("60"), Duration::from_millis(20)).unwrap(), None);
    }

    #[test]
    fn a_summary_is_one_line() {
        let summary =
            Summary { mutants: 9, killed: 7, equivalent: 1, compiled: 0, survivors: vec!["a".into()] };
        assert_eq!(summary.to_string(), "9 mutants, 7 killed, 1 equivalent, 1 survive");
    }
}
