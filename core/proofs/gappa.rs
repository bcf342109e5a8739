//! Scripts for Gappa, which proves bounds of expressions with roundings, and for Coq, which checks the
//! proofs.

extern crate std;

use core::fmt::{self, Display};
use core::ops::{Add, Mul, Sub};
use std::cell::RefCell;
use std::format;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::string::{String, ToString};
use std::thread_local;
use std::vec::Vec;

use super::model::Number;

/// An expression of a script.
#[derive(Clone, Debug)]
pub(super) struct Text(String);

thread_local! {
    /// The definitions of the script that is being written, with the range of each word.
    static WORDS: RefCell<Vec<(String, String, [f64; 2])>> = const { RefCell::new(Vec::new()) };
}

impl Text {
    pub(super) fn new(expression: impl Display) -> Self {
        Self(expression.to_string())
    }

    /// Names an expression.
    pub(super) fn named(self, name: &str) -> Self {
        self.within(name, [f64::NEG_INFINITY, f64::INFINITY])
    }

    /// The nearest integer, the even one of two.
    pub(super) fn nearest(self) -> Self {
        Self(format!("int<ne>({self})"))
    }

    fn within(self, name: &str, range: [f64; 2]) -> Self {
        WORDS.with_borrow_mut(|words| {
            let same =
                words.iter().filter(|(other, ..)| other.trim_end_matches(char::is_numeric) == name).count();
            let name = if same == 0 { name.to_string() } else { format!("{name}{}", same + 1) };
            words.push((name.clone(), self.0, range));
            Self(name)
        })
    }
}

impl Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl From<i64> for Text {
    fn from(value: i64) -> Self {
        Self::new(value)
    }
}

impl Add for Text {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(format!("({self} + {other})"))
    }
}

impl Sub for Text {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(format!("({self} - {other})"))
    }
}

impl Mul for Text {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(format!("{self} * {other}"))
    }
}

impl Number for Text {
    fn down(self, bits: u32) -> Self {
        Self(format!("int<dn>({self} / {})", 1_u64 << bits))
    }

    fn divided(self, power: Self) -> Self {
        Self(if power.0 == "1" { self.0 } else { format!("int<dn>({self} / ({power}))") })
    }

    fn word(self, name: &str) -> Self {
        self.within(name, [0.0, u32::MAX.into()])
    }

    fn signed(self, name: &str) -> Self {
        self.within(name, [i32::MIN.into(), i32::MAX.into()])
    }
}

/// A statement with its proof's hints.
#[derive(Debug)]
pub(super) struct Script {
    pub(super) name: String,
    facts: Vec<String>,
    goals: Vec<String>,
    hints: Vec<String>,
}

impl Script {
    /// Begins a script, to which the operations that follow belong.
    pub(super) fn new(name: impl Display) -> Self {
        WORDS.with_borrow_mut(Vec::clear);
        Self { name: name.to_string(), facts: Vec::new(), goals: Vec::new(), hints: Vec::new() }
    }

    /// Adds a variable, or a fact about an expression.
    pub(super) fn given(&mut self, expression: impl Display, range: [f64; 2]) -> Text {
        self.facts.push(inside(&expression, range));
        Text::new(expression)
    }

    /// Adds a fact about an integer.
    pub(super) fn integer(&mut self, name: &str, range: [f64; 2]) -> Text {
        let real = format!("{name}_real");
        self.facts.push(inside(&real, range));
        Text::new(format!("int<dn>({real})")).named(name)
    }

    /// Adds a statement.
    pub(super) fn states(&mut self, expression: impl Display, range: [f64; 2]) {
        self.goals.push(inside(&expression, range));
    }

    /// Adds an equation, which Coq proves: the left side is to be replaced by the right one.
    pub(super) fn equal(&mut self, left: impl Display, right: impl Display, nonzero: &str) {
        let condition = nonzero
            .split_whitespace()
            .map(|name| format!("{} <> 0", name.replace('+', " + ")))
            .collect::<Vec<_>>();
        let condition = condition.join(", ");
        let condition = if nonzero.is_empty() { String::new() } else { format!(" {{ {condition} }}") };
        self.hints.push(format!("{left} -> {right}{condition};"));
    }

    /// States the error of a quotient that is rounded down. Before that, it differs from the exact result by
    /// `apart`.
    pub(super) fn rounds(&mut self, found: &Text, exact: &str, apart: &str, nonzero: &str, range: [f64; 2]) {
        let quotient = WORDS.with_borrow(|words| {
            let (_, expression, _) = words.iter().find(|(name, ..)| *name == found.0).expect("a name");
            let inner = expression.strip_prefix("int<dn>(").and_then(|rest| rest.strip_suffix(')'));
            inner.expect("a quotient rounded down").to_string()
        });
        self.equal(format!("{quotient} - {exact}"), apart, nonzero);
        self.states(format!("{found} - {exact}"), range);
    }

    /// Divides the range of a variable.
    pub(super) fn divided(&mut self, name: &str, parts: u32) {
        self.hints.push(format!("$ {name} in {parts};"));
    }

    /// Returns the text: the definitions, the statement with the range of each word, and the hints.
    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        let mut goals = Vec::new();
        WORDS.with_borrow(|words| {
            for (name, expression, range) in words {
                text += &format!("{name} = {expression};\n");
                if range[1] < f64::INFINITY {
                    goals.push(inside(name, *range));
                }
            }
        });
        goals.extend(self.goals.iter().cloned());
        let [facts, goals] = [&self.facts, &goals].map(|list| list.join(" /\\\n  "));
        text + &format!("{{ {facts} ->\n  {goals} }}\n{}\n", self.hints.join("\n"))
    }
}

fn inside(expression: &impl Display, [low, high]: [f64; 2]) -> String {
    format!("{expression} in [{low:e}, {high:e}]")
}

/// Returns whether Gappa can be called.
pub(super) fn is_installed() -> bool {
    Command::new("gappa").arg("--version").output().is_ok()
}

/// Returns whether Gappa proves the script of this text, or what it could not prove.
pub(super) fn proved(name: &str, text: &str, folder: &Path) -> Result<PathBuf, String> {
    fs::create_dir_all(folder).map_err(|error| error.to_string())?;
    let path = folder.join(name).with_extension("g");
    fs::write(&path, text).map_err(|error| error.to_string())?;
    let output = Command::new("gappa").arg(&path).output().map_err(|error| format!("gappa: {error}"))?;
    if output.status.success() { Ok(path) } else { Err(String::from_utf8_lossy(&output.stderr).into()) }
}

/// Returns whether Coq accepts the proofs that Gappa writes for these scripts. They become one file, because Coq takes
/// longer to load its libraries than to check most of the proofs.
///
/// Gappa takes equations of the script for granted; here Coq has to prove each of them, too.
pub(super) fn checked<'a>(scripts: impl Iterator<Item = &'a PathBuf>, file: &Path) -> Result<(), String> {
    let mut text = String::from("Require Import Reals Field.\nRequire Import Gappa.Gappa_library.\n");
    for script in scripts {
        let output = Command::new("gappa").arg("-Bcoq").arg(script).output();
        let output = output.map_err(|error| format!("gappa: {error}"))?;
        let name = script.file_stem().unwrap_or_default().to_string_lossy();
        if !output.status.success() {
            return Err(format!("{name}: {}", String::from_utf8_lossy(&output.stderr)));
        }
        text += &format!("Module {name}.\n");
        for line in String::from_utf8_lossy(&output.stdout).lines() {
            match line.strip_prefix("Hypothesis a") {
                Some(equation) => {
                    text += &format!("Lemma a{equation}\nProof. intros; unfold Float1; simpl IZR; ");
                    text += "first [ring | field; repeat split; auto; try apply IZR_neq; try discriminate]. Qed.\n";
                }
                None if line.starts_with("Require ") => {}
                None => text += &format!("{line}\n"),
            }
        }
        text += &format!("End {name}.\n");
    }
    fs::write(file, text).map_err(|error| error.to_string())?;
    coq(file)
}

/// Returns whether Coq accepts a file.
pub(super) fn coq(path: &Path) -> Result<(), String> {
    let mut command = Command::new("coqc");
    command.arg(path.file_name().unwrap_or_default()).current_dir(path.parent().unwrap_or(path));
    let output = command.output().map_err(|error| format!("coqc: {error}"))?;
    if output.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&output.stderr).into()) }
}
