//! The folder `c` is a library for Arduino, PlatformIO, ESP-IDF and CMake: its manifests name what is there.

#[path = "support/compiler.rs"] // alone, because the rest of `support` is not packed
mod compiler;
#[path = "support/functions.rs"]
mod functions;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use luminaire_export::C_HEADERS;
use serde_json::Value;

use compiler::is_missing;
use functions::functions;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/c");
const VERSION: &str = env!("CARGO_PKG_VERSION");

fn text(file: &str) -> String {
    fs::read_to_string(Path::new(FOLDER).join(file)).expect("a file")
}

/// The words that start with a prefix, of letters, digits and underscores.
fn words<'a>(text: &'a str, prefix: &str) -> BTreeSet<&'a str> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.split(|c| !is_part(c)).filter(|word| word.starts_with(prefix) && word.len() > prefix.len()).collect()
}

#[test]
fn all_manifests_have_the_version_of_the_crate() {
    let library: Value = serde_json::from_str(&text("library.json")).expect("JSON");
    assert_eq!(library["version"], VERSION);
    for (file, line) in [
        ("library.properties", format!("version={VERSION}")),
        ("idf_component.yml", format!("version: \"{VERSION}\"")),
        ("CMakeLists.txt", format!("project(luminaire VERSION {VERSION} LANGUAGES C)")),
    ] {
        assert!(text(file).lines().any(|found| found == line), "{file}: expected `{line}`");
    }
}

#[test]
fn manifests_name_files_that_exist() {
    let library: Value = serde_json::from_str(&text("library.json")).expect("JSON");
    let strings = |value: &Value| -> Vec<String> {
        value.as_array().into_iter().flatten().filter_map(Value::as_str).map(str::to_owned).collect()
    };
    let headers = C_HEADERS.map(|(name, _)| name);
    assert_eq!(strings(&library["headers"]), headers);
    let mut examples = Vec::new();
    for example in library["examples"].as_array().expect("examples") {
        let base = example["base"].as_str().expect("a folder");
        let mut files: Vec<_> =
            strings(&example["files"]).iter().map(|file| format!("{base}/{file}")).collect();
        examples.append(&mut files);
    }
    // What Arduino finds by its folders.
    let folders = fs::read_dir(Path::new(FOLDER).join("examples")).expect("examples");
    let mut found = Vec::new();
    for folder in folders.map(|folder| folder.expect("a folder").path()) {
        let name = folder.file_name().and_then(|name| name.to_str()).expect("a name");
        assert!(folder.join(format!("{name}.ino")).is_file(), "{name}");
        for file in fs::read_dir(&folder).expect("an example") {
            found.push(format!("examples/{name}/{}", file.expect("a file").file_name().display()));
        }
    }
    examples.sort();
    found.sort();
    assert_eq!(examples, found);
    let cmake = text("CMakeLists.txt");
    assert!(headers.iter().all(|header| cmake.contains(&format!("src/{header}"))), "{cmake}");
    // A license is a file and not a link, because a user copies the folder.
    for file in ["LICENSE-APACHE", "LICENSE-MIT"] {
        assert!(fs::symlink_metadata(Path::new(FOLDER).join(file)).expect("a file").is_file(), "{file}");
        let license = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).expect("a file");
        assert_eq!(text(file), license, "{file}");
    }
}

/// The rules of Arduino's library specification 1.5, and those of its linter for what the library has.
#[test]
fn arduino_accepts_the_properties() {
    const REQUIRED: [&str; 8] =
        ["name", "version", "author", "maintainer", "sentence", "paragraph", "category", "architectures"];
    const CATEGORIES: [&str; 9] = [
        "Display",
        "Communication",
        "Signal Input/Output",
        "Sensors",
        "Device Control",
        "Timing",
        "Data Storage",
        "Data Processing",
        "Other",
    ];
    let text = text("library.properties");
    let fields: Vec<_> = text.lines().map(|line| line.split_once('=').expect("a field")).collect();
    let get = |name| fields.iter().find(|(field, _)| *field == name).map(|(_, value)| *value);
    for name in REQUIRED {
        assert!(get(name).is_some_and(|value| !value.is_empty()), "{name}");
    }
    let name = get("name").unwrap_or_default();
    assert!(name.len() <= 16 && name.chars().all(|c| c.is_ascii_alphanumeric()), "{name}");
    assert!(C_HEADERS.iter().any(|(header, _)| *header == format!("{name}.h")), "{name}");
    assert!(!text.to_lowercase().contains("arduino"), "the name is for the libraries of Arduino itself");
    assert!(CATEGORIES.contains(&get("category").unwrap_or_default()));
    assert!(C_HEADERS.iter().any(|(header, _)| get("includes") == Some(header)));
    assert!(!get("paragraph").unwrap_or_default().starts_with(get("sentence").unwrap_or_default()));
    // An empty address is invalid. Without one the library cannot be registered.
    let url = env!("CARGO_PKG_REPOSITORY");
    assert_eq!(get("url"), (!url.is_empty()).then_some(url));
    assert!(["README.md", "LICENSE"].iter().all(|file| Path::new(FOLDER).join(file).is_file()));
}

/// What Arduino's editor colours is what the README names, and exists.
#[test]
fn keywords_are_the_public_names() {
    let (keywords, readme) = (text("keywords.txt"), text("README.md"));
    let headers = C_HEADERS.map(|(_, text)| text).concat();
    let mut names = BTreeSet::new();
    for line in keywords.lines().filter(|line| !line.starts_with('#')) {
        let (name, kind) = line.split_once('\t').expect("a tab");
        assert!(names.insert(name), "{name} is there twice");
        let is_constant = |line: &str| {
            let line = line.strip_prefix("#define ").unwrap_or(line).trim_start();
            line.split([' ', ',']).next() == Some(name)
        };
        let is_defined = match kind {
            "KEYWORD1" => headers.contains(&format!("}} {name};")),
            "KEYWORD2" if name.starts_with("LUMINAIRE_") => headers.contains(&format!("#define {name}(")),
            "KEYWORD2" => functions().any(|(function, _)| function == name),
            "LITERAL1" => headers.lines().any(is_constant),
            _ => false,
        };
        assert!(is_defined, "{line}: expected a definition of this kind");
    }
    let documented: BTreeSet<_> = &words(&readme, "luminaire_") | &words(&readme, "LUMINAIRE_");
    let files: BTreeSet<_> = ["luminaire_constant", "luminaire_display", "luminaire_dmx"].into();
    assert_eq!(&documented - &files, names, "the names of the README and of keywords.txt");
}

/// A call reads as an assignment: what it writes stands before what it reads, as in `memcpy`.
#[test]
fn outputs_stand_before_inputs() {
    let (mut written, mut wrong) = (0, Vec::new());
    for (name, parameters) in functions() {
        let is_output = |parameter: &&str| parameter.contains(['*', '[']) && !parameter.contains("const ");
        let outputs = parameters.iter().take_while(|parameter| is_output(parameter)).count();
        written += outputs;
        if parameters.iter().skip(outputs).any(is_output) {
            wrong.push(format!("{name}({})", parameters.join(", ")));
        }
    }
    assert!(wrong.is_empty(), "expected pointers that are not const first, found {wrong:#?}");
    assert!(written > 30, "expected the outputs of the headers, found {written}");
}

/// The table of the README has the parameters of each public function, by the names of the header.
#[test]
fn readme_has_the_parameters_of_the_headers() {
    let (keywords, readme) = (text("keywords.txt"), text("README.md"));
    let is_public = |name: &str| keywords.lines().any(|line| line == format!("{name}\tKEYWORD2"));
    for (name, parameters) in functions().filter(|(name, _)| is_public(name)) {
        let names = parameters.iter().map(|parameter| {
            let name = parameter.split('[').next().expect("a name");
            name.rsplit([' ', '*']).next().expect("a name")
        });
        let call = format!("`{name}({})`", names.collect::<Vec<_>>().join(", "));
        assert!(readme.contains(&call), "expected {call} in the README");
    }
}

/// Runs CMake; `None` if it is not installed.
fn cmake(arguments: &[&str]) -> Option<String> {
    let Ok(output) = Command::new("cmake").args(arguments).output() else { return is_missing("cmake") };
    let text = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    assert!(output.status.success(), "cmake {arguments:?}: {text}");
    Some(text)
}

#[test]
fn cmake_installs_the_library_and_finds_it() {
    const PROGRAM: &str = "#include \"luminaire_display.h\"\nint main(void) { return LUMINAIRE_OK; }\n";
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (build, prefix) = (path("build"), path("installed"));
    let Some(_) = cmake(&["-S", FOLDER, "-B", &build, &format!("-DCMAKE_INSTALL_PREFIX={prefix}")]) else {
        return;
    };
    cmake(&["--install", &build]);
    for (name, finds) in [
        ("found", format!("find_package(luminaire {VERSION} REQUIRED)")),
        ("added", format!("add_subdirectory(\"{FOLDER}\" luminaire)")),
    ] {
        let lists = format!(
            "cmake_minimum_required(VERSION 3.14)\nproject(test LANGUAGES C)\n{finds}\n\
             add_executable(test main.c)\ntarget_link_libraries(test luminaire::luminaire)\n"
        );
        fs::create_dir(path(name)).expect("a folder");
        fs::write(path(&format!("{name}/main.c")), PROGRAM).expect("a folder");
        fs::write(path(&format!("{name}/CMakeLists.txt")), lists).expect("a folder");
        let build = path(&format!("{name}/build"));
        cmake(&["-S", &path(name), "-B", &build, &format!("-DCMAKE_PREFIX_PATH={prefix}")]);
        cmake(&["--build", &build]);
    }
}

/// ESP-IDF sets a variable, and defines the function that registers a component.
#[test]
fn esp_idf_registers_the_component() {
    let folder = tempfile::tempdir().expect("a folder");
    let script = folder.path().join("component.cmake");
    let text = format!(
        "function(idf_component_register)\n  message(\"registers ${{ARGV}}\")\nendfunction()\n\
         include(\"{FOLDER}/CMakeLists.txt\")\n"
    );
    fs::write(&script, text).expect("a folder");
    if let Some(found) = cmake(&["-DESP_PLATFORM=1", "-P", &script.display().to_string()]) {
        assert_eq!(found.trim(), "registers INCLUDE_DIRS;src");
    }
}
