//! Installs the C library below target/ and builds its examples from there, as a user does.

use crate::cargo;
use crate::outcome::{Outcome, Part};
use crate::python::call;
use crate::release;
use anyhow::{Context as _, ensure};
use std::fs;
use std::path::Path;
use std::process::Command;

const C: &[&str] = &["-std=c99", "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Werror"];
const FORTRAN: &[&str] = &["-O1"];

/// The compiler, its options and an example.
const EXAMPLES: &[(&str, &[&str], &str)] =
    &[("cc", C, "impact.c"), ("cc", C, "spheres.c"), ("gfortran", FORTRAN, "contact.f90")];

/// Builds and runs the examples, with the shared and the static library by pkg-config, and by CMake. A
/// missing tool skips its part.
pub(crate) fn run() -> anyhow::Result<Outcome> {
    let folder = release::target().join("install-c/check");
    if folder.exists() {
        fs::remove_dir_all(&folder).with_context(|| folder.display().to_string())?;
    }
    let prefix = folder.join("prefix");
    super::install(&prefix)?;
    let (prefix, folder) = (prefix.canonicalize()?, folder.canonicalize()?);
    let examples = crate::root::root().canonicalize()?.join("crates/capi/examples");
    Ok(by_pkg_config(&examples, &prefix, &folder)?.and(by_cmake(&examples, &prefix, &folder)?))
}

fn by_pkg_config(examples: &Path, prefix: &Path, folder: &Path) -> anyhow::Result<Outcome> {
    if !cargo::answers("pkg-config") {
        return Ok(Outcome::skipped(Part::CInstalled, "pkg-config is not installed"));
    }
    let shared = asked(prefix, &[])?;
    let mut statics = asked(prefix, &["--static"])?;
    for flag in &mut statics {
        if flag == "-lcarom" {
            *flag = prefix.join("lib/libcarom.a").to_string_lossy().into_owned();
        }
    }
    let mut outcome = Outcome::Passed;
    for (compiler, options, example) in EXAMPLES {
        if !cargo::answers(compiler) {
            let reason = format!("{compiler} is not installed");
            outcome = outcome.and(Outcome::skipped(Part::CInstalled, reason));
            continue;
        }
        for (kind, flags) in [("shared", &shared), ("static", &statics)] {
            let program = folder.join(format!("{kind}-{example}.out"));
            let mut compile = Command::new(compiler);
            compile.current_dir(folder).args(*options).arg(examples.join(example));
            call(compile.args(flags).arg("-lm").arg("-o").arg(&program))?;
            // A shared library that is not found must fail, and one of a static program must not be looked for.
            let mut run = Command::new(&program);
            if kind == "shared" {
                run.env("LD_LIBRARY_PATH", prefix.join("lib"));
            }
            println!("== {kind} {example}");
            call(&mut run)?;
        }
    }
    Ok(outcome)
}

/// What pkg-config says of the installed library.
fn asked(prefix: &Path, how: &[&str]) -> anyhow::Result<Vec<String>> {
    let mut ask = Command::new("pkg-config");
    ask.env("PKG_CONFIG_PATH", prefix.join("lib/pkgconfig")).args(how);
    let output = ask.args(["--cflags", "--libs", "carom"]).output()?;
    ensure!(output.status.success(), "pkg-config does not find carom below {}", prefix.display());
    Ok(String::from_utf8(output.stdout)?.split_whitespace().map(str::to_owned).collect())
}

fn by_cmake(examples: &Path, prefix: &Path, folder: &Path) -> anyhow::Result<Outcome> {
    if !cargo::answers("cmake") {
        return Ok(Outcome::skipped(Part::CInstalled, "cmake is not installed"));
    }
    let build = folder.join("cmake");
    let mut configure = Command::new("cmake");
    configure.arg("-S").arg(examples).arg("-B").arg(&build);
    call(configure.arg(format!("-DCMAKE_PREFIX_PATH={}", prefix.display())))?;
    call(Command::new("cmake").arg("--build").arg(&build))?;
    call(Command::new("ctest").current_dir(&build).arg("--output-on-failure"))?;
    Ok(Outcome::Passed)
}
