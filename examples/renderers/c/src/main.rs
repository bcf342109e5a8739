//! Compiles `rasteriser.c`, a program in C, with the system's compiler and `luminaire.h`, and takes the picture that it prints.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

use luminaire_export::C_HEADERS;
use scene::Picture;

fn draw() -> Picture {
    let folder = tempfile::tempdir().expect("a folder");
    let (root, program) = (Path::new(env!("CARGO_MANIFEST_DIR")), folder.path().join("rasteriser"));
    for (name, text) in C_HEADERS {
        fs::write(folder.path().join(name), text).expect("a folder");
    }
    let mut compile = Command::new(env::var_os("CC").unwrap_or_else(|| "cc".into()));
    compile.args(["-std=c99", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-I"]).arg(folder.path());
    compile.arg(root.join("rasteriser.c")).args(["-lm", "-o"]).arg(&program);
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
