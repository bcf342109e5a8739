//! Finds the mutants of a source file.

use std::collections::BTreeMap;
use std::ops::Range;

use proc_macro2::{TokenStream, TokenTree};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, Item, Lit, Stmt, UnOp};

use crate::macros;

/// A change of the source that a test should notice.
#[derive(Clone, Debug, PartialEq)]
pub struct Mutant {
    /// The file's path below `core/src`.
    pub file: String,
    /// The function, with the type or trait around it, such as `Cone::outer`.
    pub function: String,
    /// What changes: `` `a + b`: `+` to `-` ``; with a number where a function has the same change
    /// more than once.
    pub change: String,
    /// The first and the last line of what is replaced.
    pub lines: (usize, usize),
    /// Whether it is in a function that may run at compile time.
    pub is_const: bool,
    /// The text that replaces it.
    pub(crate) text: String,
}

/// A part of the source with its mutants.
#[derive(Debug)]
pub(crate) struct Site {
    pub(crate) range: Range<usize>,
    pub(crate) mutants: Vec<Mutant>,
}

/// What a file has.
#[derive(Debug, Default)]
pub(crate) struct Found {
    pub(crate) sites: Vec<Site>,
    /// Names of constants whose value is computed by a function of the same text in the copy.
    pub(crate) constants: Vec<Constant>,
    /// Names in expressions, which may be those of such constants.
    pub(crate) names: Vec<(Range<usize>, String)>,
    /// Macros of which no body could be parsed.
    pub(crate) unparsed: Vec<String>,
}

/// A constant item with mutants: where its name and its value are.
#[derive(Debug)]
pub(crate) struct Constant {
    pub(crate) name: String,
    pub(crate) item: Range<usize>,
    pub(crate) signature: Range<usize>,
    pub(crate) value: Range<usize>,
}

/// Literals in a list longer than this are data.
const LONGEST_LIST: usize = 8;

/// All mutants of a file.
pub(crate) fn mutants(file: &str, source: &str) -> syn::Result<Found> {
    let tree = syn::parse_file(source)?;
    let mut finder = Finder { file, source, ..Finder::new() };
    finder.visit_file(&tree);
    let mut found = finder.found;
    found.sites.retain(|site| !site.mutants.is_empty());
    found.sites.sort_by_key(|site| (site.range.start, usize::MAX - site.range.end));
    let mut times = BTreeMap::new();
    for mutant in found.sites.iter_mut().flat_map(|site| &mut site.mutants) {
        let times = times.entry((mutant.function.clone(), mutant.change.clone())).or_insert(0);
        *times += 1;
        if *times > 1 {
            mutant.change += &format!(" #{times}");
        }
    }
    Ok(found)
}

struct Finder<'a> {
    file: &'a str,
    source: &'a str,
    /// Where the text that is parsed begins in the source.
    base: isize,
    path: Vec<String>,
    /// What contains the present expression.
    parent: Option<Range<usize>>,
    /// Inside a value that is computed at compile time.
    frozen: bool,
    /// Inside a function that may be.
    is_const: bool,
    found: Found,
}

impl Finder<'_> {
    fn new() -> Self {
        Self {
            file: "",
            source: "",
            base: 0,
            path: vec![],
            parent: None,
            frozen: false,
            is_const: false,
            found: Found::default(),
        }
    }

    fn range(&self, spanned: &impl Spanned) -> Range<usize> {
        let range = spanned.span().byte_range();
        let moved = |place: usize| (place as isize + self.base) as usize;
        moved(range.start)..moved(range.end)
    }

    fn text(&self, spanned: &impl Spanned) -> String {
        self.source[self.range(spanned)].to_owned()
    }

    /// Adds a mutant: this part, replaced by this text. `change` says it for the list.
    fn add(&mut self, range: Range<usize>, text: String, change: String) {
        if self.frozen {
            return;
        }
        let line = |place: usize| 1 + self.source[..place].matches('\n').count();
        let lines = (line(range.start), line(range.end));
        let function = self.path.join("::");
        let (file, is_const) = (self.file.to_owned(), self.is_const);
        let mutant = Mutant { file, function, change, lines, is_const, text };
        match self.found.sites.iter_mut().find(|site| site.range == range) {
            Some(site) if site.mutants.iter().any(|other| other.text == mutant.text) => {}
            Some(site) => site.mutants.push(mutant),
            None => self.found.sites.push(Site { range, mutants: vec![mutant] }),
        }
    }

    /// Adds a mutant that replaces an expression.
    fn replace(&mut self, expression: &impl Spanned, text: impl Into<String>) {
        let (range, text) = (self.range(expression), text.into());
        let change = format!("`{}` to `{}`", short(&self.source[range.clone()]), short(&text));
        self.add(range, text, change);
    }

    /// Adds mutants that replace one operator by others.
    fn operators(&mut self, whole: &Expr, operator: &BinOp, others: &[&str]) {
        let (range, at) = (self.range(whole), self.range(operator));
        for other in others {
            let text =
                format!("{}{other}{}", &self.source[range.start..at.start], &self.source[at.end..range.end]);
            let (old, new) = (&self.source[at.clone()], &other);
            let change = format!("`{}`: `{old}` to `{new}`", short(&self.source[range.clone()]));
            self.add(range.clone(), text, change);
        }
    }

    fn delete(&mut self, part: &impl Spanned, text: &str) {
        let range = self.range(part);
        let change = format!("`{}`: deleted", short(&self.source[range.clone()]));
        self.add(range, text.into(), change);
    }

    fn literal(&mut self, whole: &Expr, literal: &Lit) {
        let texts: Vec<_> = match literal {
            Lit::Int(number) => {
                let Ok(value) = number.base10_parse::<u128>() else { return };
                let suffix = number.suffix();
                [value.checked_add(1), value.checked_sub(1)]
                    .into_iter()
                    .flatten()
                    .map(|n| format!("{n}{suffix}"))
                    .collect()
            }
            Lit::Float(number) => {
                let Ok(value) = number.base10_parse::<f64>() else { return };
                let value = if value == 0.0 { 0.001 } else { value * 1.001 };
                vec![format!("{value:?}{}", number.suffix())]
            }
            _ => return,
        };
        for text in texts {
            let range = self.range(whole);
            let parent = self.parent.clone().unwrap_or_else(|| range.clone());
            let around = format!("`{}`: ", short(&self.source[parent.clone()]));
            let around = if parent == range { String::new() } else { around };
            let change = format!("{around}`{}` to `{text}`", &self.source[range.clone()]);
            self.add(range, text, change);
        }
    }

    fn condition(&mut self, condition: &Expr) {
        if !has_let(condition) && !matches!(condition, Expr::Lit(_)) {
            self.replace(condition, "true");
            self.replace(condition, "false");
        }
    }

    fn method_call(&mut self, call: &syn::ExprMethodCall) {
        let (name, receiver) = (call.method.to_string(), self.range(&call.receiver));
        let whole = self.range(call);
        let at = self.range(&call.method);
        let swapped = |from: &str, to: &str| name.strip_prefix(from).map(|rest| format!("{to}{rest}"));
        let others: Vec<_> = match name.as_str() {
            "min" => vec!["max".into()],
            "max" => vec!["min".into()],
            "plus" => vec!["minus".into()],
            "minus" => vec!["plus".into()],
            "saturating_add" | "wrapping_add" => vec![name.replace("add", "sub")],
            "saturating_sub" | "wrapping_sub" => vec![name.replace("sub", "add")],
            _ => vec![],
        };
        let others = others
            .into_iter()
            .chain(swapped("saturating_", "wrapping_"))
            .chain(swapped("wrapping_", "saturating_"));
        for other in others {
            let text =
                format!("{}{other}{}", &self.source[whole.start..at.start], &self.source[at.end..whole.end]);
            let change = format!("`{}`: `{name}` to `{other}`", short(&self.source[whole.clone()]));
            self.add(whole.clone(), text, change);
        }
        let is_wrapper =
            matches!(name.as_str(), "min" | "max" | "clamp" | "abs" | "complement" | "plus" | "minus");
        if is_wrapper || name.starts_with("saturating_") || name.starts_with("wrapping_") {
            let text = self.source[receiver.clone()].to_owned();
            let change = format!("`{}`: `.{name}` removed", short(&self.source[whole.clone()]));
            self.add(whole, text, change);
        }
    }

    fn expression(&mut self, whole: &Expr) {
        match whole {
            Expr::Binary(binary) => {
                let others: &[&str] = match binary.op {
                    BinOp::Add(_) => &["-"],
                    BinOp::Sub(_) => &["+"],
                    BinOp::Mul(_) => &["/"],
                    BinOp::Div(_) | BinOp::Rem(_) => &["*"],
                    BinOp::BitAnd(_) | BinOp::BitXor(_) => &["|"],
                    BinOp::BitOr(_) => &["&"],
                    BinOp::Shl(_) => &[">>"],
                    BinOp::Shr(_) => &["<<"],
                    BinOp::Eq(_) => &["!="],
                    BinOp::Ne(_) => &["=="],
                    BinOp::Lt(_) => &["<="],
                    BinOp::Le(_) => &["<"],
                    BinOp::Gt(_) => &[">="],
                    BinOp::Ge(_) => &[">"],
                    BinOp::And(_) if !has_let(whole) => &["||"],
                    BinOp::Or(_) => &["&&"],
                    BinOp::AddAssign(_) => &["-="],
                    BinOp::SubAssign(_) => &["+="],
                    BinOp::MulAssign(_) => &["/="],
                    BinOp::DivAssign(_) => &["*="],
                    BinOp::ShlAssign(_) => &[">>="],
                    BinOp::ShrAssign(_) => &["<<="],
                    BinOp::BitAndAssign(_) | BinOp::BitXorAssign(_) => &["|="],
                    BinOp::BitOrAssign(_) => &["&="],
                    _ => &[],
                };
                self.operators(whole, &binary.op, others);
                match binary.op {
                    BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_) => self.condition(whole),
                    _ if others.first().is_some_and(|other| {
                        other.ends_with('=')
                            && other.len() > 1
                            && *other != "!="
                            && *other != "=="
                            && *other != "<="
                            && *other != ">="
                    }) =>
                    {
                        self.delete(whole, "()");
                    }
                    _ => {}
                }
            }
            Expr::Assign(_) => self.delete(whole, "()"),
            Expr::Unary(unary) if matches!(unary.op, UnOp::Not(_) | UnOp::Neg(_)) => {
                let text = self.text(&unary.expr);
                self.replace(whole, text);
            }
            Expr::Lit(literal) => self.literal(whole, &literal.lit),
            Expr::MethodCall(call) => self.method_call(call),
            Expr::If(choice) => {
                self.condition(&choice.cond);
                // With any other condition it is the same as a condition that is false.
                if let (true, Some(Stmt::Expr(last, _))) =
                    (has_let(&choice.cond), choice.then_branch.stmts.last())
                    && matches!(last, Expr::Return(_) | Expr::Break(_) | Expr::Continue(_))
                {
                    self.delete(last, "()");
                }
            }
            // A loop without an end is killed by its time alone.
            Expr::While(repeated) if !has_let(&repeated.cond) => self.replace(&repeated.cond, "false"),
            _ => {}
        }
    }

    /// Visits the value of a constant, whose text the copy has again as a function.
    fn constant(&mut self, whole: &impl Spanned, name: &syn::Ident, ty: &syn::Type, value: &Expr) {
        // A table that code fills would be filled again at each use.
        if matches!(value, Expr::Block(_)) {
            return;
        }
        let before = self.found.sites.len();
        self.named(name, |finder| finder.visit_expr(value));
        if self.found.sites.len() > before {
            let signature = self.range(ty);
            let (item, value, name) = (self.range(whole), self.range(value), name.to_string());
            self.found.constants.push(Constant { name, item, signature, value });
        }
    }

    fn function(&mut self, signature: &syn::Signature, block: &syn::Block) {
        let before = std::mem::replace(&mut self.is_const, signature.constness.is_some());
        self.named(&signature.ident, |finder| finder.visit_block(block));
        self.is_const = before;
    }

    fn named(&mut self, name: impl ToString, work: impl FnOnce(&mut Self)) {
        let depth = self.path.len();
        // What a macro's body is wrapped in has no name.
        self.path.extend(Some(name.to_string()).filter(|name| name != "__"));
        work(self);
        self.path.truncate(depth);
    }

    fn frozen(&mut self, work: impl FnOnce(&mut Self)) {
        let before = std::mem::replace(&mut self.frozen, true);
        work(self);
        self.frozen = before;
    }
}

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        let attributes = match item {
            Item::Const(item) => &item.attrs,
            Item::Fn(item) => &item.attrs,
            Item::Impl(item) => &item.attrs,
            Item::Macro(item) => &item.attrs,
            Item::Mod(item) => &item.attrs,
            Item::Static(item) => &item.attrs,
            Item::Trait(item) => &item.attrs,
            // No other item has code.
            _ => return,
        };
        if !is_enabled(attributes) {
            return;
        }
        match item {
            Item::Const(item) => self.constant(item, &item.ident, &item.ty, &item.expr),
            Item::Static(item) => self.frozen(|finder| finder.visit_expr(&item.expr)),
            Item::Fn(item) => self.function(&item.sig, &item.block),
            Item::Macro(item) => {
                let Some(name) = &item.ident else { return };
                self.named(format!("{name}!"), |finder| {
                    for body in macros::bodies(item.mac.tokens.clone()) {
                        finder.body(&body);
                    }
                });
            }
            Item::Impl(block) => {
                let syn::Type::Path(ty) = &*block.self_ty else {
                    return visit::visit_item_impl(self, block);
                };
                let name = ty.path.segments.last().map(|segment| segment.ident.to_string());
                self.named(name.unwrap_or_default(), |finder| visit::visit_item_impl(finder, block));
            }
            Item::Trait(item) => self.named(&item.ident, |finder| visit::visit_item_trait(finder, item)),
            _ => visit::visit_item(self, item),
        }
    }

    fn visit_impl_item(&mut self, item: &'ast syn::ImplItem) {
        match item {
            syn::ImplItem::Fn(item) if is_enabled(&item.attrs) => {
                self.function(&item.sig, &item.block);
            }
            syn::ImplItem::Const(item) if is_enabled(&item.attrs) => {
                self.frozen(|finder| finder.named(&item.ident, |finder| finder.visit_expr(&item.expr)));
            }
            _ => {}
        }
    }

    fn visit_trait_item(&mut self, item: &'ast syn::TraitItem) {
        if let syn::TraitItem::Fn(item) = item
            && let (Some(block), true) = (&item.default, is_enabled(&item.attrs))
        {
            self.named(&item.sig.ident, |finder| finder.visit_block(block));
        }
    }

    fn visit_stmt(&mut self, statement: &'ast Stmt) {
        match statement {
            Stmt::Local(local) if !is_enabled(&local.attrs) => return,
            Stmt::Expr(expression, semicolon) => {
                if !is_enabled(attributes(expression)) {
                    return;
                }
                let is_call = matches!(expression, Expr::Call(_) | Expr::MethodCall(_) | Expr::Try(_));
                if is_call && semicolon.is_some() {
                    self.delete(statement, "");
                }
            }
            _ => {}
        }
        visit::visit_stmt(self, statement);
    }

    fn visit_expr(&mut self, expression: &'ast Expr) {
        if let Expr::Path(path) = expression
            && let Some(name) = path.path.get_ident()
            && !self.frozen
        {
            self.found.names.push((self.range(expression), name.to_string()));
        }
        if let Expr::Const(_) = expression {
            return;
        }
        if let Expr::Array(list) = expression
            && list.elems.len() > LONGEST_LIST
            && list.elems.iter().all(|element| matches!(element, Expr::Lit(_)))
        {
            return;
        }
        self.expression(expression);
        // A literal is shown with what is around it.
        let parent = match expression {
            Expr::Binary(_) | Expr::Call(_) | Expr::MethodCall(_) | Expr::Range(_) | Expr::Unary(_) => {
                self.parent.replace(self.range(expression))
            }
            _ => self.parent.take(),
        };
        visit::visit_expr(self, expression);
        self.parent = parent;
    }

    fn visit_expr_repeat(&mut self, repeat: &'ast syn::ExprRepeat) {
        self.visit_expr(&repeat.expr);
    }

    // None of these is an expression that is evaluated where it stands.
    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}
    fn visit_generics(&mut self, _: &'ast syn::Generics) {}
    fn visit_pat(&mut self, _: &'ast syn::Pat) {}
    fn visit_path(&mut self, _: &'ast syn::Path) {}
    fn visit_type(&mut self, _: &'ast syn::Type) {}
    fn visit_angle_bracketed_generic_arguments(&mut self, _: &'ast syn::AngleBracketedGenericArguments) {}
    fn visit_macro(&mut self, _: &'ast syn::Macro) {}
}

impl Finder<'_> {
    /// Visits the body of a macro, as items, as statements or as the content of an `impl`.
    fn body(&mut self, body: &Range<usize>) {
        let start = self.base + body.start as isize;
        let source = &self.source[start as usize..self.base as usize + body.end];
        let before = self.base;
        match macros::parsed(source) {
            Some((file, shift)) => {
                self.base = start - shift as isize;
                self.visit_file(&file);
            }
            None => self.found.unparsed.push(self.path.join("::")),
        }
        self.base = before;
    }
}

/// The attributes of an expression that stands as a statement.
fn attributes(expression: &Expr) -> &[syn::Attribute] {
    match expression {
        Expr::Block(block) => &block.attrs,
        Expr::Call(call) => &call.attrs,
        Expr::MethodCall(call) => &call.attrs,
        Expr::Return(back) => &back.attrs,
        _ => &[],
    }
}

fn has_let(expression: &Expr) -> bool {
    match expression {
        Expr::Let(_) => true,
        Expr::Binary(binary) => has_let(&binary.left) || has_let(&binary.right),
        _ => false,
    }
}

/// Whether code with these attributes is built: with every feature, and not for a test.
fn is_enabled(attributes: &[syn::Attribute]) -> bool {
    let mut lists = attributes.iter().filter(|attribute| attribute.path().is_ident("cfg"));
    lists.all(|attribute| {
        attribute
            .parse_args::<TokenStream>()
            .is_ok_and(|condition| holds(&condition.into_iter().collect::<Vec<_>>()))
    })
}

/// The value of a condition of `cfg`.
fn holds(condition: &[TokenTree]) -> bool {
    let [TokenTree::Ident(name), rest @ ..] = condition else { return false };
    let inner: Vec<_> = match rest {
        [TokenTree::Group(group)] => group.stream().into_iter().collect(),
        _ => return name == "feature",
    };
    let mut parts = inner
        .split(|token| matches!(token, TokenTree::Punct(comma) if comma.as_char() == ','))
        .filter(|part| !part.is_empty());
    match name.to_string().as_str() {
        "all" => parts.all(holds),
        "any" => parts.any(holds),
        "not" => !holds(&inner),
        _ => false,
    }
}

/// A text on one line, cut in the middle where it is long.
fn short(text: &str) -> String {
    const HALF: usize = 30;
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let letters: Vec<_> = line.chars().collect();
    if letters.len() <= 2 * HALF {
        return line;
    }
    let (begin, end) = (&letters[..HALF], &letters[letters.len() - HALF..]);
    format!(
        "{} .. {}",
        begin.iter().collect::<String>().trim_end(),
        end.iter().collect::<String>().trim_start()
    )
}
