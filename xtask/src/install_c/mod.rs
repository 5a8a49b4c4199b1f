//! Installs the C library: header, static and shared library, and what pkg-config and CMake read.

mod check;

use crate::{cargo, release};
use anyhow::{Context as _, ensure};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

pub(crate) use check::run as check;

/// The profile in `Cargo.toml`, and the folder below target/ into which it builds.
const PROFILE: &str = "install-c";

/// The names of the installed shared library.
struct Shared {
    /// That of the file: `libcarom.so.0.1.0`.
    file: String,
    /// That which programs look for, by the version of the interface: `libcarom.so.5`.
    soname: String,
    /// That which the linker looks for: `libcarom.so`.
    link: String,
    /// The argument of the linker that stores the second in the library.
    argument: String,
    /// The name that cargo gives to it.
    built: &'static str,
}

impl Shared {
    fn new(abi: &str) -> anyhow::Result<Self> {
        let version = env!("CARGO_PKG_VERSION");
        ensure!(
            cfg!(unix),
            "install-c is for Linux, macOS and other Unix; on Windows use the files of target/release"
        );
        let (file, soname, link, built) = match cfg!(target_os = "macos") {
            true => (
                format!("libcarom.{version}.dylib"),
                format!("libcarom.{abi}.dylib"),
                "libcarom.dylib",
                "libcarom_capi.dylib",
            ),
            false => (
                format!("libcarom.so.{version}"),
                format!("libcarom.so.{abi}"),
                "libcarom.so",
                "libcarom_capi.so",
            ),
        };
        let argument = match cfg!(target_os = "macos") {
            true => format!("-Wl,-install_name,@rpath/{soname}"),
            false => format!("-Wl,-soname,{soname}"),
        };
        Ok(Self { file, soname, link: link.to_owned(), argument, built })
    }
}

/// Builds the library and puts all its files below a prefix.
pub(crate) fn install(prefix: &Path) -> anyhow::Result<()> {
    fs::create_dir_all(prefix).with_context(|| prefix.display().to_string())?;
    let prefix = prefix.canonicalize()?;
    let source = crate::root::root().canonicalize()?.join("crates/capi");
    let header = fs::read_to_string(source.join("include/carom.h"))?;
    let shared = Shared::new(abi(&header)?)?;
    build(&shared)?;

    let made = release::target().join(PROFILE);
    put(&prefix, "include/carom.h", |to| fs::write(to, &header))?;
    put(&prefix, "lib/libcarom.a", |to| {
        fs::copy(made.join("libcarom_capi.a"), to)?;
        strip(to)
    })?;
    let library = format!("lib/{}", shared.file);
    put(&prefix, &library, |to| fs::copy(made.join(shared.built), to).map(drop))?;
    for name in [&shared.soname, &shared.link] {
        put(&prefix, &format!("lib/{name}"), |to| link(&shared.file, to))?;
    }
    let fill = |name: &str| -> anyhow::Result<String> {
        let path = source.join("install").join(name);
        let text = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
        Ok(filled(&text, &prefix, &shared))
    };
    let pkg_config = fill("carom.pc.in")?;
    put(&prefix, "lib/pkgconfig/carom.pc", |to| fs::write(to, pkg_config))?;
    for name in ["caromConfig.cmake", "caromConfigVersion.cmake"] {
        let text = fill(&format!("{name}.in"))?;
        put(&prefix, &format!("lib/cmake/carom/{name}"), |to| fs::write(to, text))?;
    }
    Ok(())
}

/// The version of the interface that a header declares.
fn abi(header: &str) -> anyhow::Result<&str> {
    let mut lines = header.lines();
    lines
        .find_map(|line| line.strip_prefix("#define CAROM_ABI_VERSION "))
        .context("carom.h without a version")
}

/// Both libraries in one build, which the Rust library beside them would keep from being optimised as a whole.
fn build(shared: &Shared) -> anyhow::Result<()> {
    let link = format!("link-arg={}", shared.argument);
    let what = ["rustc", "--package", "carom-capi", "--lib", "--profile", PROFILE];
    let how = ["--crate-type", "staticlib,cdylib", "--", "-C", &link];
    cargo::run(&[&what[..], &how[..]].concat())
}

/// Removes the debug information of Rust's standard library, two fifths of the size, if `strip` is installed.
fn strip(library: &Path) -> std::io::Result<()> {
    match Command::new("strip").arg("-S").arg(library).status() {
        Ok(status) if !status.success() => Err(std::io::Error::other("`strip -S` failed")),
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

fn filled(template: &str, prefix: &Path, shared: &Shared) -> String {
    let version = env!("CARGO_PKG_VERSION");
    let major_minor = version.rsplit_once('.').map_or(version, |(start, _)| start);
    template
        .replace("@PREFIX@", &prefix.to_string_lossy())
        .replace("@VERSION@", version)
        .replace("@MAJOR_MINOR@", major_minor)
        .replace("@SHARED@", &shared.file)
        .replace("@SONAME@", &shared.soname)
}

/// Writes a file below the prefix, in place of an older one, and prints its path and size.
fn put(
    prefix: &Path,
    name: &str,
    write: impl FnOnce(&Path) -> std::io::Result<()>,
) -> anyhow::Result<()> {
    let to = prefix.join(name);
    let folder: PathBuf = to.parent().context("a file in a folder")?.to_owned();
    fs::create_dir_all(&folder).with_context(|| folder.display().to_string())?;
    if to.symlink_metadata().is_ok() {
        fs::remove_file(&to).with_context(|| to.display().to_string())?;
    }
    write(&to).with_context(|| to.display().to_string())?;
    match to.symlink_metadata()? {
        about if about.is_symlink() => {
            println!("{} -> {}", to.display(), fs::read_link(&to)?.display())
        }
        about => println!("{}: {} kB", to.display(), about.len().div_ceil(1000)),
    }
    Ok(())
}

#[cfg(unix)]
fn link(to: &str, at: &Path) -> std::io::Result<()> {
    std::os::unix::fs::symlink(to, at)
}

#[cfg(not(unix))]
fn link(to: &str, at: &Path) -> std::io::Result<()> {
    fs::copy(at.with_file_name(to), at).map(drop)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn templates_are_filled_in_completely() {
        let shared = Shared::new("5").unwrap();
        let folder = crate::root::root().join("crates/capi/install");
        for name in ["carom.pc.in", "caromConfig.cmake.in", "caromConfigVersion.cmake.in"] {
            let text = fs::read_to_string(folder.join(name)).unwrap();
            let text = filled(&text, Path::new("/opt/carom"), &shared);
            assert!(!text.contains('@'), "{name}:\n{text}");
        }
    }

    #[test]
    fn the_header_says_the_version_of_the_interface() {
        let header =
            fs::read_to_string(crate::root::root().join("crates/capi/include/carom.h")).unwrap();
        assert!(abi(&header).unwrap().parse::<u32>().unwrap() >= 5);
        assert!(abi("").is_err());
    }
}
