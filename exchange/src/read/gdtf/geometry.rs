//! The tree of a fixture's geometries: where each beam is.

use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use glam::{DAffine3, DMat3, DVec3};
use roxmltree::Node;

use crate::refusal::Refusal;

/// The most geometries of all modes, each as often as it is referred to.
const GEOMETRIES: usize = 200_000;
/// The most beams of a fixture.
const BEAMS: usize = 1_000;

/// A beam in the axes of its fixture: z up, in metres, and the beam along -z.
pub(crate) struct Placed<'a, 'i> {
    pub(crate) beam: Node<'a, 'i>,
    /// The names of the references by which it is there, and its own.
    pub(crate) name: String,
    pub(crate) world: DAffine3,
}

/// The beams of a mode.
#[derive(Default)]
pub(crate) struct Beams<'a, 'i> {
    pub(crate) placed: Vec<Placed<'a, 'i>>,
    pub(crate) refused: Vec<Refusal>,
    /// How many references are within what they refer to.
    pub(crate) loops: usize,
}

/// The geometries of a fixture, which are trees.
pub(crate) struct Geometries<'a, 'i> {
    trees: Vec<Node<'a, 'i>>,
    /// The trees that no other refers to.
    tops: Vec<Node<'a, 'i>>,
    named: HashMap<&'a str, Node<'a, 'i>>,
    /// How many geometries were visited.
    visited: usize,
}

/// A geometry that is visited: where its parent is, by which references, and to what these refer.
struct Step<'a, 'i> {
    node: Node<'a, 'i>,
    above: DAffine3,
    /// Whether a reference has the position.
    is_placed: bool,
    names: Rc<str>,
    within: Rc<[&'a str]>,
}

impl<'a, 'i> Geometries<'a, 'i> {
    /// Finds the geometries of a fixture.
    pub(crate) fn new(fixture: Node<'a, 'i>) -> Self {
        let all = fixture.children().filter(|node| node.has_tag_name("Geometries"));
        let trees: Vec<_> = all.flat_map(|node| node.children()).filter(Node::is_element).collect();
        let name = |node: &Node<'a, 'i>| node.attribute("Name").unwrap_or_default();
        let mut referred = HashSet::new();
        for tree in &trees {
            let others = tree.descendants().filter(|node| node.has_tag_name("GeometryReference"));
            let others = others.filter_map(|node| node.attribute("Geometry"));
            referred.extend(others.filter(|to| *to != name(tree)));
        }
        let tops: Vec<_> = trees.iter().copied().filter(|tree| !referred.contains(name(tree))).collect();
        let named = trees.iter().map(|tree| (name(tree), *tree)).collect();
        Self { tops: if tops.is_empty() { trees.clone() } else { tops }, trees, named, visited: 0 }
    }

    /// Returns whether there is a beam in any tree.
    pub(crate) fn has_beams(&self) -> bool {
        self.trees.iter().any(|tree| tree.descendants().any(|node| node.has_tag_name("Beam")))
    }

    /// Returns the beams of a mode: of the tree that it names, else of those that no other refers to.
    ///
    /// What a reference refers to is where the reference is: its position takes the place of that of the tree.
    ///
    /// # Errors
    /// More than 1000 beams, or more geometries than are visited.
    pub(crate) fn beams(&mut self, mode: Option<Node<'a, 'i>>) -> Result<Beams<'a, 'i>, Refusal> {
        let own = mode.and_then(|mode| self.named.get(mode.attribute("Geometry")?));
        let roots = own.map_or(&self.tops[..], std::slice::from_ref);
        let step = |node: &Node<'a, 'i>| Step {
            node: *node,
            above: DAffine3::IDENTITY,
            is_placed: false,
            names: "".into(),
            within: node.attribute("Name").into_iter().collect(),
        };
        let mut waiting: Vec<_> = roots.iter().rev().map(step).collect();
        let mut beams = Beams::default();
        while let Some(Step { node, above, is_placed, names, within }) = waiting.pop() {
            self.visited += 1;
            if self.visited > GEOMETRIES {
                let expected = format_args!("at most {GEOMETRIES}, with what is referred to");
                return Err(Refusal::new("geometries", "more", expected));
            }
            let world = match position(node) {
                _ if is_placed => above,
                Ok(own) => above * own,
                Err(refusal) => {
                    beams.refused.push(refusal.at(path(node)));
                    continue;
                }
            };
            if node.has_tag_name("GeometryReference") {
                let to = node.attribute("Geometry").unwrap_or_default();
                match self.named.get(to) {
                    _ if within.contains(&to) => beams.loops += 1,
                    Some(tree) => waiting.push(Step {
                        node: *tree,
                        above: world,
                        is_placed: true,
                        names: format!("{names}{}: ", short(node, "Name")).into(),
                        within: within.iter().copied().chain([to]).collect(),
                    }),
                    None => {
                        let refusal = Refusal::new("Geometry", to, "the name of a geometry below Geometries");
                        beams.refused.push(refusal.at(path(node)));
                    }
                }
                continue;
            }
            if node.has_tag_name("Beam") {
                let name = format!("{names}{}", short(node, "Name"));
                beams.placed.push(Placed { beam: node, name, world });
            }
            if beams.placed.len() + beams.refused.len() > BEAMS {
                return Err(Refusal::new("Beam", "more", format_args!("at most {BEAMS}")));
            }
            let below = node.children().rev().filter(Node::is_element);
            waiting.extend(below.map(|node| Step {
                node,
                above: world,
                is_placed: false,
                names: names.clone(),
                within: within.clone(),
            }));
        }
        Ok(beams)
    }
}

/// Returns the transform of a geometry to its parent; without one, they are at one place.
fn position(node: Node) -> Result<DAffine3, Refusal> {
    let Some(text) = node.attribute("Position") else { return Ok(DAffine3::IDENTITY) };
    let expected = "16 finite numbers, such as {1,0,0,0}{0,1,0,0}{0,0,1,0}{0,0,0,1}";
    let [x, y, z, _] = rows::<4, 4>(text).ok_or_else(|| Refusal::new("Position", text, expected))?;
    let column = |at: usize| DVec3::new(x[at], y[at], z[at]);
    Ok(DAffine3 { matrix3: DMat3::from_cols(column(0), column(1), column(2)), translation: column(3) })
}

/// Returns the rows of a matrix in braces, of finite numbers.
pub(crate) fn rows<const COLUMNS: usize, const ROWS: usize>(text: &str) -> Option<[[f64; COLUMNS]; ROWS]> {
    let words = text.split(['{', '}', ',']).map(str::trim).filter(|word| !word.is_empty());
    let (mut matrix, mut count) = ([[0.0; COLUMNS]; ROWS], 0);
    for word in words {
        let number = word.parse().ok().filter(|number: &f64| number.is_finite())?;
        *matrix.get_mut(count / COLUMNS)?.get_mut(count % COLUMNS)? = number;
        count += 1;
    }
    (count == COLUMNS * ROWS).then_some(matrix)
}

/// Returns a transform between axes with z up as one between axes with y up, where y became -z.
pub(crate) fn upright(transform: DAffine3) -> DAffine3 {
    let turn = DAffine3::from_mat3(DMat3::from_cols(DVec3::X, DVec3::NEG_Z, DVec3::Y));
    turn * transform * turn.inverse()
}

/// Returns where an element is, such as `Geometries/Geometry[Body]/Beam[Beam]`.
pub(crate) fn path(node: Node) -> String {
    let within = node.ancestors().take_while(|node| node.is_element() && !node.has_tag_name("FixtureType"));
    let step = |node: Node| match node.attribute("Name") {
        Some(name) => format!("{:.80}[{name:.80}]", node.tag_name().name()),
        None => format!("{:.80}", node.tag_name().name()),
    };
    within.take(16).map(step).reduce(|inner, outer| format!("{outer}/{inner}")).unwrap_or_default()
}

/// Returns an attribute as a message shows it.
pub(crate) fn short(node: Node, key: &str) -> String {
    format!("{:.80}", node.attribute(key).unwrap_or("unnamed"))
}

/// Returns a number of an attribute, or that of the standard.
pub(super) fn number(node: Node, key: &str, standard: f64) -> Result<f64, Refusal> {
    let Some(text) = node.attribute(key) else { return Ok(standard) };
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| Refusal::new(key, text, "a finite number"))
}
