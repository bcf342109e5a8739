//! Writes a file again with all its mutants, each behind a choice at run time.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::ops::Range;

use crate::find::{self, Found, Mutant};

/// A file and what of its mutants has compiled so far.
#[derive(Debug)]
pub(crate) struct Source {
    pub(crate) file: String,
    pub(crate) text: String,
    pub(crate) found: Found,
}

/// What a part of the rewritten text is: by position among the sites, constants or names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Part {
    Mutant(usize, usize),
    Site(usize),
    Constant(usize),
    Name(usize),
}

/// The rewritten text and the parts from which it was put together.
#[derive(Debug, Default)]
pub(crate) struct Rewritten {
    pub(crate) text: String,
    pub(crate) parts: Vec<(Range<usize>, Part)>,
}

impl Source {
    pub(crate) fn new(file: &str, text: String) -> syn::Result<Self> {
        let mut found = find::mutants(file, &text)?;
        let constants: Vec<_> = found.constants.iter().map(|constant| constant.name.clone()).collect();
        found.names.retain(|(_, name)| constants.contains(name));
        Ok(Self { file: file.to_owned(), text, found })
    }

    pub(crate) fn mutants(&self) -> impl Iterator<Item = &Mutant> {
        self.found.sites.iter().flat_map(|site| &site.mutants)
    }

    /// The text with the mutants, numbered from `first` on in the order of [`Self::mutants`].
    pub(crate) fn rewritten(&self, first: usize) -> Rewritten {
        let mut edits: Vec<_> = Vec::new();
        let mut id = first;
        for (index, site) in self.found.sites.iter().enumerate() {
            if !site.mutants.is_empty() {
                edits.push((site.range.clone(), Part::Site(index), id));
            }
            id += site.mutants.len();
        }
        let constants = self.found.constants.iter().enumerate();
        edits.extend(constants.map(|(index, constant)| (constant.item.clone(), Part::Constant(index), 0)));
        let names = self.found.names.iter().enumerate();
        edits.extend(names.map(|(index, (range, _))| (range.clone(), Part::Name(index), 0)));
        // The outer before the inner, and a site before the name that it is.
        edits.sort_by_key(|(range, part, _)| {
            (range.start, usize::MAX - range.end, matches!(part, Part::Name(_)))
        });
        let mut out = Rewritten::default();
        self.write(0..self.text.len(), &edits, &mut out);
        out
    }

    /// Writes a part of the text with the edits inside it, which are sorted.
    fn write(&self, range: Range<usize>, edits: &[(Range<usize>, Part, usize)], out: &mut Rewritten) {
        let (mut at, mut next) = (range.start, 0);
        while let Some((whole, part, id)) = edits.get(next) {
            out.text += &self.text[at..whole.start];
            let start = out.text.len();
            let inner = edits[next + 1..].iter().take_while(|(range, ..)| range.end <= whole.end).count();
            let inside = &edits[next + 1..=next + inner];
            match *part {
                Part::Site(index) => self.write_site(index, *id, inside, out),
                Part::Constant(index) => {
                    let constant = &self.found.constants[index];
                    let (name, ty) = (&constant.name, &self.text[constant.signature.clone()]);
                    out.text += &self.text[whole.clone()];
                    let head = "#[allow(dead_code, non_snake_case)] const fn";
                    let _ = write!(out.text, " {head} {name}__() -> {ty} {{ ");
                    self.write(constant.value.clone(), inside, out);
                    out.text += " }";
                }
                Part::Name(index) => out.text += &format!("{}__()", self.found.names[index].1),
                Part::Mutant(..) => {}
            }
            out.parts.push((start..out.text.len(), *part));
            (at, next) = (whole.end, next + 1 + inner);
        }
        out.text += &self.text[at..range.end];
    }

    /// The original comes first: it decides the type of the whole.
    fn write_site(
        &self,
        index: usize,
        id: usize,
        inside: &[(Range<usize>, Part, usize)],
        out: &mut Rewritten,
    ) {
        let site = &self.found.sites[index];
        let is_statement = self.text[site.range.clone()].ends_with(';');
        let count = site.mutants.len();
        out.text += if is_statement { "" } else { "(" };
        // In a macro, the crate is the one that defines the macro.
        let is_in_macro = site.mutants.first().is_some_and(|mutant| mutant.function.contains('!'));
        let any = if is_in_macro { "$crate::mutant::any" } else { "crate::mutant::any" };
        let _ = write!(out.text, "if !{any}({id}, {count}) {{ ");
        self.write(site.range.clone(), inside, out);
        for (position, mutant) in site.mutants.iter().enumerate() {
            out.text += " } else ";
            if position + 1 < count {
                let _ = write!(out.text, "if {any}({}, 1) ", id + position);
            }
            out.text += "{ ";
            let start = out.text.len();
            out.text += &mutant.text;
            out.parts.push((start..out.text.len(), Part::Mutant(index, position)));
        }
        out.text += if is_statement { " }" } else { " })" };
    }

    /// Takes out parts that do not compile, and with a constant what depends on its function.
    pub(crate) fn take_out(&mut self, parts: BTreeSet<Part>) {
        // From the last on, so that the positions of the others stay.
        for part in parts.into_iter().rev() {
            match part {
                // The site may be gone as a whole.
                Part::Mutant(site, position) if self.found.sites[site].mutants.len() > position => {
                    self.found.sites[site].mutants.remove(position);
                }
                Part::Mutant(..) => {}
                Part::Site(site) => self.found.sites[site].mutants.clear(),
                Part::Name(index) => drop(self.found.names.remove(index)),
                Part::Constant(index) => {
                    let constant = self.found.constants.remove(index);
                    let value = constant.value;
                    let inside = |range: &Range<usize>| value.start <= range.start && range.end <= value.end;
                    for site in self.found.sites.iter_mut().filter(|site| inside(&site.range)) {
                        site.mutants.clear();
                    }
                    self.found.names.retain(|(range, name)| *name != constant.name && !inside(range));
                }
            }
        }
    }
}

impl Rewritten {
    /// The innermost part around a place.
    pub(crate) fn part(&self, place: usize) -> Option<Part> {
        let around = self.parts.iter().filter(|(range, _)| range.contains(&place));
        around.min_by_key(|(range, _)| range.len()).map(|(_, part)| *part)
    }
}
