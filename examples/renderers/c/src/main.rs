//! Compiles `rasteriser.c`, a program in C, with the system's compiler and the static library
//! of luminaire, and takes the picture that it prints.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use scene::Picture;

/// The static library, which cargo writes beside what it compiles.
fn library() -> PathBuf {
    let program = env::current_exe().expect("a program");
    let folder = program.parent().expect("a folder");
    let folder = if folder.ends_with("deps") { folder.to_owned() } else { folder.join("deps") };
    let files = folder.read_dir().expect("a folder").map(|entry| entry.expect("a file").path());
    let is_library = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with("libluminaire_c-") && name.ends_with(".a")
    };
    let age = |path: &PathBuf| path.metadata().and_then(|data| data.modified()).expect("a time");
    files.filter(is_library).max_by_key(age).expect("the static library")
}

fn draw() -> Picture {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("luminaire.h"), luminaire_c::header()).expect("a folder");
    let program = folder.path().join("rasteriser");
    let mut compile = Command::new(env::var_os("CC").unwrap_or_else(|| "cc".into()));
    compile.args(["-std=c99", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-I"]).arg(folder.path());
    compile.arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("rasteriser.c")).arg(library());
    compile.args(["-lm", "-lpthread", "-ldl", "-o"]).arg(&program);
    assert!(compile.status().expect("a compiler of C").success(), "the C was not compiled");
    let printed = Command::new(program).output().expect("a program").stdout;
    let printed = String::from_utf8(printed).expect("text");
    let codes = printed.lines().skip(1).map(|pixel| {
        let mut codes = pixel.split(' ').map(|code| code.parse().expect("a code"));
        [(); 3].map(|()| codes.next().expect("three codes"))
    });
    Picture(codes.collect())
}

fn main() {
    draw().write("picture.png");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn picture_is_what_the_kernel_computes() {
        let picture = draw();
        let found = picture.agreement::<luminaire::Fx16>();
        // Between vertices the light is a straight line.
        let bounds = [9.0, 16.0];
        let (source, folder) = (include_str!("../rasteriser.c"), env!("CARGO_MANIFEST_DIR"));
        scene::check("C, colours of vertices", source, folder, &picture, found, bounds);
    }
}
