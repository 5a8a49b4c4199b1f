//! A wheel from the source distribution of the Python module, as on a machine for which there is no wheel.

use crate::outcome::{Outcome, Part};
use crate::python::{self, NONE, call};
use anyhow::Context as _;
use std::path::Path;
use std::process::Command;

/// What a user does first.
const FIRST: &str = "import carom; steel = carom.Material(208e9, 0.3); \
     ball = carom.sphere(0.01, steel, 0.033, velocity=(0.1, 0, -0.2)); \
     assert abs(carom.collide(ball, carom.plane(steel), 0.15).R_x) < 1";

/// Packs the sources, builds a wheel from them outside the workspace, and imports it; skipped without Python 3.10 or
/// later.
pub(crate) fn check() -> anyhow::Result<Outcome> {
    let Some(place) = python::place()? else { return Ok(Outcome::skipped(Part::Python, NONE)) };
    let outside = std::env::temp_dir().join(format!("carom-sdist-{}", std::process::id()));
    let checked = built(&place, &outside);
    std::fs::remove_dir_all(&outside).with_context(|| outside.display().to_string())?;
    checked.map(|()| Outcome::Passed)
}

fn built(place: &python::Place, outside: &Path) -> anyhow::Result<()> {
    std::fs::create_dir_all(outside).with_context(|| outside.display().to_string())?;
    let venv = place.python();
    let programs = venv.parent().context("the interpreter has no folder")?;
    let mut pack = Command::new(programs.join("maturin"));
    call(pack.current_dir(python::project()).args(["sdist", "--out"]).arg(outside))?;
    let mut path = vec![programs.to_owned()];
    path.extend(std::env::split_paths(&std::env::var_os("PATH").unwrap_or_default()));
    let packed = python::only(outside, "gz")?;
    let mut build = Command::new(&venv);
    build.args(["-m", "pip", "wheel", "--quiet", "--disable-pip-version-check", "--no-deps"]);
    // The workspace's settings of cargo must not count.
    build.env_remove("CAROM_WORKSPACE").env_remove("CARGO_TARGET_DIR");
    build.env("PATH", std::env::join_paths(path)?).current_dir(outside);
    call(build.args(["--no-build-isolation", "--wheel-dir", "wheel"]).arg(packed))?;
    let wheel = python::only(&outside.join("wheel"), "whl")?;
    let mut install = Command::new(&venv);
    install.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
    call(install.args(["--no-index", "--force-reinstall", "--no-deps"]).arg(wheel))?;
    call(Command::new(&venv).args(["-c", FIRST]).current_dir(outside))
}
