//! The examples in C and Fortran, compiled and run with the static library; C also under valgrind.
//!
//! Without a compiler or valgrind the test does nothing; in CI (`CI` is set) it fails.

use std::path::{Path, PathBuf};
use std::process::Command;

/// What the static library needs of the system.
const SYSTEM: &[&str] = &["-lpthread", "-ldl", "-lm"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The folder of the built library: that of this test, or above.
fn library() -> PathBuf {
    let test = std::env::current_exe().unwrap();
    let folders = test.ancestors().skip(1).take(2);
    let mut found = folders.map(|folder| folder.join("libcarom_capi.a"));
    found.find(|path| path.exists()).expect("libcarom_capi.a beside the tests")
}

fn is_installed(tool: &str) -> bool {
    let there = Command::new(tool).arg("--version").output().is_ok_and(|out| out.status.success());
    let is_ci = std::env::var("CI").is_ok_and(|ci| !ci.is_empty() && ci != "false");
    assert!(there || !is_ci, "{tool} is not installed: CI must compile and run every example");
    there
}

fn run(command: &mut Command) -> String {
    let output = command.output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let wrong = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?} failed:\n{text}\n{wrong}");
    text
}

/// Compiles an example into a folder of this process.
fn compile(compiler: &str, arguments: &[&str], example: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("carom-{}-{example}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let program = folder.join("program");
    let mut command = Command::new(compiler);
    command.current_dir(&folder).args(arguments).arg("-I").arg(root().join("include"));
    command.arg(root().join("examples").join(example)).arg(library()).args(SYSTEM);
    run(command.arg("-o").arg(&program));
    program
}

const STRICT: &[&str] = &["-std=c99", "-O1", "-g", "-Wall", "-Wextra", "-Wpedantic", "-Werror"];

#[test]
fn examples_in_c() {
    if !is_installed("cc") {
        return;
    }
    for example in ["impact.c", "spheres.c"] {
        let program = compile("cc", STRICT, example);
        let said = run(&mut Command::new(&program));
        assert!(said.ends_with("all is well\n"), "{said}");
        if is_installed("valgrind") {
            let options = ["--quiet", "--error-exitcode=9", "--leak-check=full"];
            run(Command::new("valgrind").args(options).arg(&program));
        }
        std::fs::remove_dir_all(program.parent().unwrap()).unwrap();
    }
}

/// Runs the line of a page that compiles with `compiler`, as it stands but for where the files are, and what
/// comes of it.
fn compiles_as_written(page: &str, compiler: &str) {
    if !is_installed(compiler) {
        return;
    }
    let page = std::fs::read_to_string(root().join(page)).unwrap().replace("\\\n", " ");
    let mut lines = page.lines().map(|line| line.strip_prefix("$ ").unwrap_or(line));
    let command = format!("{compiler} ");
    let line = lines.find_map(|line| line.strip_prefix(&command)).expect(compiler);
    let folder = std::env::temp_dir().join(format!("carom-{}-page-{compiler}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let (library, program) = (library(), folder.join("program"));
    let modules = format!("-J{}", folder.display());
    let words = line.split_whitespace().map(|word| match word {
        "target/release/libcarom_capi.a" => library.as_os_str(),
        "target/impact" | "target/contact" => program.as_os_str(),
        "-Jtarget" => modules.as_ref(),
        word => word.as_ref(),
    });
    run(Command::new(compiler).current_dir(root().join("../..")).args(words));
    let said = run(&mut Command::new(&program));
    for warning in said.lines().filter(|line| line.contains("warning")) {
        assert!(page.contains(warning), "the page does not show `{warning}`");
    }
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn pages_compile_the_examples() {
    compiles_as_written("README.md", "cc");
    compiles_as_written("../../docs/book/src/start/c.md", "cc");
    compiles_as_written("../../docs/book/src/start/c.md", "gfortran");
}

/// Compiles the header alone.
fn accepts_the_header(compiler: &str, standard: &str, language: &str) {
    let mut command = Command::new(compiler);
    command.args([
        standard,
        "-pedantic",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-fsyntax-only",
        "-x",
        language,
    ]);
    run(command.arg(root().join("include/carom.h")));
}

/// The header holds to the oldest standards of C, but for the types of `stdint.h`, and to new ones.
#[test]
fn the_header_in_every_standard() {
    let standards = [("cc", "c", "c89 c99 c11 c17"), ("c++", "c++", "c++11 c++17")];
    for (compiler, language, names) in standards {
        if is_installed(compiler) {
            for name in names.split(' ') {
                accepts_the_header(compiler, &format!("-std={name}"), language);
            }
        }
    }
}

/// The header is C++ as well.
#[test]
fn example_in_c_as_cpp() {
    if !is_installed("c++") {
        return;
    }
    let folder = std::env::temp_dir().join(format!("carom-{}-header", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let source = folder.join("header.cpp");
    let text = "#include \"carom.h\"\n\
                static_assert(sizeof(carom_state) == 8 * CAROM_STATE_NUMBERS, \"state\");\n\
                static_assert(sizeof(carom_contact) == 8 * (CAROM_CONTACT_WORDS + 1), \"contact\");\n\
                int main() { return carom_abi_version() == CAROM_ABI_VERSION ? 0 : 1; }\n";
    std::fs::write(&source, text).unwrap();
    let program = folder.join("program");
    let mut command = Command::new("c++");
    command.args(["-std=c++11", "-Wall", "-Wextra", "-Werror", "-I"]).arg(root().join("include"));
    run(command.arg(&source).arg(library()).args(SYSTEM).arg("-o").arg(&program));
    run(&mut Command::new(&program));
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn example_in_fortran() {
    if !is_installed("gfortran") {
        return;
    }
    let program = compile("gfortran", &["-O1", "-Wall", "-Wno-unused-parameter"], "contact.f90");
    let said = run(&mut Command::new(&program));
    assert!(said.ends_with("all is well\n"), "{said}");
    std::fs::remove_dir_all(program.parent().unwrap()).unwrap();
}
