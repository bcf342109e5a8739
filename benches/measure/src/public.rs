//! Writes calls of all public functions of a crate, from rustdoc's list of them in JSON.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Context, Result, bail};
use serde_json::{Value, json};

type Rows = &'static [(&'static str, &'static [&'static str])];

/// The types for a generic parameter, by its bound. If several rows match the parameter's bounds,
/// the first counts. If a row has several types, the function is called with each.
///
/// One type stands for all falloffs, and one for all attenuations: the functions of these enums
/// match on every model. One lobe with unknown results stands for all lobes, whose own functions are
/// called by the row `Highlight`.
const TYPES: Rows = &[
    ("Quick", &["QuickFormat"]),
    ("Scalar", &["Format"]),
    ("Irradiance", &["Irradiance"]),
    ("Types", &["Format"]),
    ("Arithmetic", &["Format"]),
    ("Directions", &["Format"]),
    ("Places", &["Format"]),
    ("Ramps", &["Format"]),
    ("Errors", &["Format"]),
    ("Lights", &["Format"]),
    ("Gain", &["Gain"]),
    ("Offset", &["Offset"]),
    // No other crate can name a type of it.
    ("Among", &[]),
    ("Ray", &["Ray", "FineRay"]),
    ("Directed", &["Ray", "FineRay"]),
    ("Share", &["Format", "FineShare"]),
    ("Fraction", &["Fraction", "FineFraction"]),
    ("Falloff", &["AnyFalloff"]),
    ("Attenuation", &["AnyAttenuation"]),
    ("Window", &["Cut", "GltfWindow", "SquareWindow"]),
    (
        "Pixel",
        &["luminaire::display::Gray4", RGB444, "luminaire::display::Rgb565", "luminaire::display::Rgb666"],
    ),
    (
        "LedChip",
        &[
            "luminaire::display::LedOrder",
            "luminaire::display::Rgbw",
            "luminaire::display::Apa102",
            "luminaire::display::Hd108",
        ],
    ),
    // The colours and displays of `embedded-graphics` for the pixels above. It has none for the second.
    (
        "PixelColor",
        &[
            "embedded_graphics_core::pixelcolor::Gray4",
            "embedded_graphics_core::pixelcolor::Gray8",
            "embedded_graphics_core::pixelcolor::Rgb565",
            "embedded_graphics_core::pixelcolor::Rgb666",
        ],
    ),
    (
        "DrawTarget",
        &[
            "Screen<embedded_graphics_core::pixelcolor::Gray4>",
            "Screen<embedded_graphics_core::pixelcolor::Gray8>",
            "Screen<embedded_graphics_core::pixelcolor::Rgb565>",
            "Screen<embedded_graphics_core::pixelcolor::Rgb666>",
        ],
    ),
    (
        "Fn() -> ",
        &[
            "fn(i32, i32, &mut [luminaire::display::Gray4])",
            "fn(i32, i32, &mut [luminaire::display::Rgb444])",
            "fn(i32, i32, &mut [luminaire::display::Rgb565])",
            "fn(i32, i32, &mut [luminaire::display::Rgb666])",
        ],
    ),
    ("SpecularLobe", &["AnyLobe", "NoSpecular"]),
    ("Highlight", &["Phong", "BlinnPhong", "DualConeLobe", "MirroredPhong"]),
    ("LightModel", &["CompiledAnyLight<Format>"]),
    ("Into<AnyLight>", &["AnyLight"]),
    ("Hasher", &["Words"]),
    ("Serializer", &["Data"]),
    ("Deserializer", &["Data"]),
    ("Copy", &["Irradiance"]),
    ("Add", &["Irradiance"]),
    ("Fn() -> Vec3", &[POINTS]),
    ("Fn() -> Length", &[PLACES]),
    (
        "Points",
        &[
            POINTS,
            "luminaire::light::AlongX<<Format as luminaire::Scalar>::Length, fn(usize) -> <Format as luminaire::Scalar>::Length>",
        ],
    ),
];
const RGB444: &str = "luminaire::display::Rgb444";
const POINTS: &str = "fn(usize) -> luminaire::Vec3<<Format as luminaire::Scalar>::Length>";
const PLACES: &str = "fn(usize) -> <Format as luminaire::Scalar>::Length";
/// The type for a parameter that has only bounds in `OF_NUMBERS`, which every number satisfies.
const PLAIN: &[&str] = &["Format"];
const OF_NUMBERS: &str = "Any Clone Debug Default Deserialize Eq Format Hash Named Ord PartialEq PartialOrd Pod Serialize \
                          Source Zeroable";

/// The values for a const generic parameter, by its type: exponents and squarings, and the lengths
/// of arrays. A length is a square number, as patterns require.
const CONSTANTS: Rows = &[("u32", &["4", "1", "31", "3"]), ("usize", &["4", "0", "1", "64"])];
/// Lengths that a function refuses to be compiled for.
const REFUSED: Rows = &[
    ("draw", &[RGB444]),
    ("of", &["0", "1"]),
    ("of_knots", &["0"]),
    ("duty", &["31"]),
    ("next", &["31"]),
    ("fill_interpolated", &["0", "1", "64"]),
];

/// Private modules of other crates, whose items the crates export from the module above.
const PRIVATE: [&str; 8] = [
    "arith::",
    "binary_color::",
    "drawable::",
    "formatter::",
    "gray_color::",
    "range::",
    "rgb_color::",
    "traits::",
];

/// Traits that each format implements, mostly by private types. Each build calls their functions on
/// the types that the traits' rows in `TYPES` name for its format.
const OF_FORMATS: [&str; 14] = [
    "Scalar",
    "Arithmetic",
    "Directions",
    "Places",
    "Ramps",
    "Errors",
    "Lights",
    "Quick",
    "Gain",
    "Offset",
    "Ray",
    "Directed",
    "Share",
    "Fraction",
];

/// A public function.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Function {
    /// Its path, such as `luminaire::Cone::soft` or `<luminaire::Rgb<Format> as Clone>::clone`.
    pub(crate) name: String,
    /// The path without the type, such as `Clone::clone`, if it is a function of a trait.
    pub(crate) of_trait: Option<String>,
    /// The calls, one per choice of types, none if no other crate can call it, or the reason why no call can be written.
    pub(crate) calls: Result<Vec<String>, String>,
}

/// The types for the generic parameters in scope.
type Scope = BTreeMap<String, &'static [&'static str]>;

/// What rustdoc lists, with the public paths of its items.
struct Listing<'a> {
    json: &'a Value,
    public: BTreeMap<String, String>,
}

/// What a function belongs to: nothing, a type, or a trait implemented for a type.
#[derive(Clone, Default)]
struct Owner {
    this: Value,
    of: Option<String>,
    scope: Scope,
}

/// Spells types as source text, for one choice of each generic parameter.
struct Spelling<'a> {
    listing: &'a Listing<'a>,
    this: &'a Value,
    scope: &'a Scope,
    choice: usize,
}

/// All public functions of a crate, in the order of their names.
pub(crate) fn functions(json: &Value) -> Result<Vec<Function>> {
    let mut listing = Listing { json, public: BTreeMap::new() };
    let name = listing.item(&json["root"])["name"].as_str().context("rustdoc lists no crate")?;
    listing.visit(&json["root"], name);
    let mut functions = Vec::new();
    listing.free_and_of_formats(&mut functions)?;
    listing.implemented(&mut functions)?;
    functions.retain(|function| !function.calls.as_ref().is_ok_and(Vec::is_empty));
    functions.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(functions)
}

fn list(of: &Value) -> &[Value] {
    of.as_array().map_or(&[], Vec::as_slice)
}

fn text(of: &Value) -> &str {
    of.as_str().unwrap_or_default()
}

fn last(path: &str) -> &str {
    path.rsplit("::").next().unwrap_or(path)
}

fn row(rows: Rows, names: &[String]) -> Option<&'static [&'static str]> {
    rows.iter().find(|(name, _)| names.iter().any(|of| of == name)).map(|(_, types)| *types)
}

/// `head<a, b>`, or the head alone.
fn with_arguments(head: String, arguments: &[String]) -> String {
    if arguments.is_empty() { head } else { format!("{head}<{}>", arguments.join(", ")) }
}

impl<'a> Listing<'a> {
    fn item(&self, id: &Value) -> &'a Value {
        &self.json["index"][id.to_string()]
    }

    /// Records the public path of an item, or the paths of all items in a module.
    fn visit(&mut self, id: &Value, path: &str) {
        let module = &self.item(id)["inner"]["module"];
        if !module.is_object() {
            self.public.entry(id.to_string()).or_insert_with(|| path.to_owned());
        }
        for child in list(&module["items"]) {
            let item = self.item(child);
            let import = &item["inner"]["use"];
            if import["is_glob"] == true {
                for child in list(&self.item(&import["id"])["inner"]["module"]["items"]) {
                    self.visit(child, &format!("{path}::{}", text(&self.item(child)["name"])));
                }
            } else {
                let (id, named) = if import.is_object() { (&import["id"], import) } else { (child, item) };
                self.visit(id, &format!("{path}::{}", text(&named["name"])));
            }
        }
    }

    /// Adds the free functions, and the functions of the traits of the formats.
    fn free_and_of_formats(&self, functions: &mut Vec<Function>) -> Result<()> {
        for (id, path) in &self.public {
            let item = &self.json["index"][id];
            if item["inner"]["function"].is_object() {
                functions.push(self.function(item, path, &Owner::default())?);
            }
            if OF_FORMATS.contains(&last(path)) && item["inner"]["trait"].is_object() {
                for this in row(TYPES, &[last(path).to_owned()]).unwrap_or_default() {
                    let owner = Owner { this: json!({ "primitive": this }), ..Owner::default() };
                    self.of_our_trait(id, owner, functions)?;
                }
            }
        }
        Ok(())
    }

    /// Adds the functions of implementations.
    fn implemented(&self, functions: &mut Vec<Function>) -> Result<()> {
        let inner = |id: &String| &self.json["index"][id]["inner"];
        let listed = self.public.keys().flat_map(|id| {
            let types = ["struct", "enum", "union"].map(|kind| &inner(id)[kind]["impls"]);
            types.into_iter().chain([&inner(id)["trait"]["implementations"]]).flat_map(list)
        });
        for id in listed.map(Value::to_string).collect::<BTreeSet<_>>() {
            let of = &inner(&id)["impl"];
            let trait_ = &of["trait"];
            let ours = self.public.get(&trait_["id"].to_string());
            let of_formats = ours.is_some_and(|path| OF_FORMATS.contains(&last(path)));
            if of["is_synthetic"] == true || of["blanket_impl"].is_object() || of_formats {
                continue;
            }
            let scope = self.scope(&of["generics"], &Scope::new());
            let scope = scope.with_context(|| format!("in an implementation for {}", of["for"]))?;
            if scope.values().any(|types| types.is_empty()) {
                continue;
            }
            let mut owner = Owner { this: of["for"].clone(), of: None, scope };
            if ours.is_some() {
                self.of_our_trait(&trait_["id"].to_string(), owner, functions)?;
                continue;
            }
            if trait_.is_object() {
                // The compiler infers the parameters of a foreign trait from the arguments.
                let arguments = list(&trait_["args"]["angle_bracketed"]["args"]);
                let blank = if arguments.iter().any(|of| of["type"].is_object()) { "<_>" } else { "" };
                owner.of = Some(self.name(trait_)? + blank);
            }
            for item in list(&of["items"]).iter().map(|id| self.item(id)) {
                let is_public = trait_.is_object() || item["visibility"] == "public";
                if is_public && item["inner"]["function"].is_object() {
                    functions.push(self.function(item, "", &owner)?);
                }
            }
        }
        Ok(())
    }

    /// Adds all functions of a public trait for a type, including provided methods.
    fn of_our_trait(&self, id: &str, mut owner: Owner, functions: &mut Vec<Function>) -> Result<()> {
        let of = &self.json["index"][id]["inner"]["trait"];
        let mut scope = self.scope(&of["generics"], &Scope::new())?;
        // A parameter of the implementation is narrower than that of the trait.
        scope.iter_mut().for_each(|(name, types)| *types = owner.scope.get(name).unwrap_or(types));
        let arguments: Vec<_> = scope.values().map(|types| types[0].to_owned()).collect();
        owner.of = Some(with_arguments(self.public[id].clone(), &arguments));
        owner.scope.extend(scope);
        for item in list(&of["items"]).iter().map(|id| self.item(id)) {
            if item["inner"]["function"].is_object() {
                functions.push(self.function(item, "", &owner)?);
            }
        }
        Ok(())
    }

    fn function(&self, item: &Value, path: &str, owner: &Owner) -> Result<Function> {
        let (name, function) = (text(&item["name"]), &item["inner"]["function"]);
        let path = |spelling: &Spelling| -> Result<String> {
            match &owner.of {
                _ if owner.this.is_null() => Ok(path.to_owned()),
                None => Ok(format!("<{}>::{name}", spelling.spell(&owner.this)?)),
                Some(of) => Ok(format!("<{} as {of}>::{name}", spelling.spell(&owner.this)?)),
            }
        };
        let call = |scope: &Scope, choice| -> Result<String> {
            let spelling = Spelling { listing: self, this: &owner.this, scope, choice };
            let inputs = list(&function["sig"]["inputs"]).iter().map(|input| spelling.argument(&input[1]));
            let inputs = inputs.collect::<Result<Vec<_>>>()?;
            // The crate `defmt` never calls the `format` that it derives, which panics.
            if owner.of.as_deref() == Some("defmt::Format") {
                return Ok(format!("defmt::export::fmt({})", inputs[0]));
            }
            let inputs = inputs.join(", ");
            let generics = list(&function["generics"]["params"]).iter();
            let generics: Vec<_> = generics.filter_map(|of| spelling.chosen(text(&of["name"]))).collect();
            let generics = with_arguments("::".into(), &generics);
            let call = format!("{}{}({inputs})", path(&spelling)?, generics.trim_end_matches("::"));
            let is_iterator = function["sig"]["output"]["impl_trait"].is_array();
            Ok(if is_iterator { format!("{call}.for_each(sink)") } else { format!("sink({call})") })
        };
        let calls = || {
            let scope = self.scope(&function["generics"], &owner.scope)?;
            if scope.values().any(|types| types.is_empty()) {
                return Ok(Vec::new());
            }
            let choices = scope.values().map(|types| types.len()).max().unwrap_or(1);
            let refused = row(REFUSED, &[name.to_owned()]).unwrap_or_default();
            let is_refused =
                |choice| scope.values().any(|types| refused.contains(&types[choice % types.len()]));
            let choices = (0..choices).filter(|choice| !is_refused(*choice));
            choices.map(|choice| call(&scope, choice)).collect::<Result<_>>()
        };
        let first = Spelling { listing: self, this: &owner.this, scope: &owner.scope, choice: 0 };
        // Implementations of the same trait for the same type are named by their argument.
        let argument = first.spell(&function["sig"]["inputs"][0][1]).unwrap_or_else(|_| "_".into());
        let of_trait = owner.of.as_ref().map(|of| last(of.split('<').next().unwrap_or(of)));
        Ok(Function {
            name: path(&first)?.replace("<_>", &format!("<{argument}>")),
            of_trait: of_trait.map(|of| format!("{of}::{name}")),
            calls: calls().map_err(|error| format!("{error:#}")),
        })
    }

    /// The types for generic parameters, including those of the enclosing scope.
    fn scope(&self, generics: &Value, outer: &Scope) -> Result<Scope> {
        let mut scope = outer.clone();
        for parameter in list(&generics["params"]) {
            let (name, kind) = (text(&parameter["name"]), &parameter["kind"]);
            if kind["type"]["is_synthetic"] == true || kind["lifetime"].is_object() {
                continue;
            }
            let more = list(&generics["where_predicates"]).iter().map(|of| &of["bound_predicate"]);
            let more = more.filter(|of| of["type"]["generic"] == name).flat_map(|of| list(&of["bounds"]));
            let bounds = list(&kind["type"]["bounds"]).iter().chain(more);
            let traits: Vec<_> = bounds.map(|of| &of["trait_bound"]["trait"]).collect();
            let bounds: Vec<_> = traits.iter().map(|of| bound(of)).collect();
            let types = if kind["const"].is_object() {
                row(CONSTANTS, &[text(&kind["const"]["type"]["primitive"]).to_owned()])
            } else {
                let is_plain = bounds.iter().all(|bound| OF_NUMBERS.split(' ').any(|of| of == bound));
                row(TYPES, &bounds).or(is_plain.then_some(PLAIN))
            };
            let Some(types) = types else {
                bail!("no row of TYPES is for the parameter `{name}: {}`", bounds.join(" + "));
            };
            // No other crate can name the types of a private trait, but for the formats and the lobes.
            let is_private = |of: &&Value| {
                let id = of["id"].to_string();
                self.json["paths"][&id]["crate_id"] == 0 && !self.public.contains_key(&id)
            };
            let is_public = |of: &&str| self.public.values().any(|path| last(path) == *of);
            let is_unnamed = types != PLAIN && traits.iter().any(is_private) && !types.iter().all(is_public);
            scope.insert(name.to_owned(), if is_unnamed { &[] } else { types });
        }
        Ok(scope)
    }

    /// The public name of a type or trait, without arguments.
    fn name(&self, of: &Value) -> Result<String> {
        let (id, written) = (of["id"].to_string(), text(&of["path"]));
        if let Some(path) = self.public.get(&id) {
            return Ok(path.clone());
        }
        // A path that starts with a crate's name is public as written; the path of its definition
        // need not be.
        let crates = self.json["external_crates"].as_object().into_iter().flatten();
        let start = written.split_once("::").map_or("", |(start, _)| start);
        if crates.into_iter().any(|(_, of)| of["name"] == start) {
            return Ok(written.to_owned());
        }
        let path = &self.json["paths"][id];
        if path.is_null() || path["crate_id"] == 0 {
            bail!("`{written}` has no public name");
        }
        let path = list(&path["path"]).iter().map(text).collect::<Vec<_>>().join("::");
        Ok(PRIVATE.iter().fold(path, |path, module| path.replace(module, "")))
    }
}

/// The name of a bound; for `Into`, with the type that it converts to.
fn bound(of: &Value) -> String {
    let into = text(&of["args"]["angle_bracketed"]["args"][0]["type"]["resolved_path"]["path"]);
    match last(text(&of["path"])) {
        "Into" => format!("Into<{}>", last(into)),
        "Fn" => {
            let output = &of["args"]["parenthesized"]["output"];
            let names = [&output["resolved_path"]["path"], &output["qualified_path"]["name"]].map(text);
            format!("Fn() -> {}", last(&names.concat()))
        }
        name => name.to_owned(),
    }
}

impl Spelling<'_> {
    fn chosen(&self, parameter: &str) -> Option<String> {
        let types = self.scope.get(parameter)?;
        let chosen = types.get(self.choice % types.len().max(1))?;
        // A light of the quick evaluation takes points of its own format.
        let is_quick = self.scope.values().any(|types| types.contains(&"QuickFormat"));
        Some(if is_quick { chosen.replace("<Format as", "<QuickFormat as") } else { (*chosen).to_owned() })
    }

    /// An expression for an argument of a type.
    fn argument(&self, of: &Value) -> Result<String> {
        let bound = &of["impl_trait"][0]["trait_bound"]["trait"];
        match last(text(&bound["path"])) {
            "Fn" | "FnMut" | "FnOnce" => {
                let inputs = list(&bound["args"]["parenthesized"]["inputs"]).len();
                Ok(format!("|{}| source()", vec!["_"; inputs].join(", ")))
            }
            "Into" => self.argument(&bound["args"]["angle_bracketed"]["args"][0]["type"]),
            "IntoAngle" => Ok("source::<luminaire::Angle>()".to_owned()),
            // A type without a public name is inferred.
            "" => Ok(self.spell(of).map_or("source()".into(), |of| format!("source::<{of}>()"))),
            name => bail!("no argument is known for `impl {name}`"),
        }
    }

    /// A type as a program writes it.
    fn spell(&self, of: &Value) -> Result<String> {
        let (kind, of) = of.as_object().and_then(|of| of.iter().next()).context("no type")?;
        let number = |name: &Value| self.chosen(text(name)).unwrap_or_else(|| text(name).to_owned());
        let arguments = |of: &Value| -> Result<Vec<String>> {
            let arguments = list(&of["args"]["angle_bracketed"]["args"]).iter();
            let arguments = arguments.filter(|argument| argument["lifetime"].is_null());
            let spell = |of: &Value| match &of["const"] {
                Value::Null => self.spell(&of["type"]),
                constant => Ok(number(&constant["expr"])),
            };
            arguments.map(spell).collect()
        };
        match kind.as_str() {
            "primitive" => Ok(text(of).to_owned()),
            "generic" if of == "Self" => self.spell(self.this),
            "generic" => self.chosen(text(of)).with_context(|| format!("no parameter {of}")),
            "resolved_path" => Ok(with_arguments(self.listing.name(of)?, &arguments(of)?)),
            "tuple" => list(of)
                .iter()
                .map(|of| Ok(self.spell(of)? + ","))
                .collect::<Result<String>>()
                .map(|of| format!("({of})")),
            "slice" => Ok(format!("[{}]", self.spell(of)?)),
            "array" => Ok(format!("[{}; {}]", self.spell(&of["type"])?, number(&of["len"]))),
            "borrowed_ref" if of["is_mutable"] == true => Ok(format!("&mut {}", self.spell(&of["type"])?)),
            "borrowed_ref" => Ok(format!("&{}", self.spell(&of["type"])?)),
            "qualified_path" => {
                // `Self::Name` is listed without the arguments of its trait: they are those in scope.
                let generics = &self.listing.item(&of["trait"]["id"])["inner"]["trait"]["generics"]["params"];
                let of_trait = list(generics).iter().map(|of| self.chosen(text(&of["name"])));
                let of_trait: Vec<_> =
                    of_trait.map(|chosen| chosen.unwrap_or_else(|| "_".to_owned())).collect();
                let by = with_arguments(self.listing.name(&of["trait"])?, &of_trait);
                let this = self.spell(&of["self_type"])?;
                Ok(with_arguments(format!("<{this} as {by}>::{}", text(&of["name"])), &arguments(of)?))
            }
            _ => bail!("a type of the kind {kind}"),
        }
    }
}
