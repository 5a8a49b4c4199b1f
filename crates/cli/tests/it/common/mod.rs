//! Runs the command, and files for it.
pub(crate) mod pebble;
pub(crate) mod picture;
mod rough;

use carom_cases::case::CaseKind;
pub(crate) use rough::{grey_heights, heights, rough};
use std::ops::Deref;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::atomic::{AtomicUsize, Ordering};

pub(crate) fn carom(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.args(arguments).env_remove("COLUMNS").output().unwrap()
}

/// The command under limits of the shell: `ulimit -t 5` ends it after five seconds of processor time, by a signal.
pub(crate) fn limited(limits: &str, arguments: &[&str]) -> Output {
    let run = format!("{limits}; exec \"$0\" \"$@\"");
    let mut shell = Command::new("sh");
    shell.args(["-c", &run, env!("CARGO_BIN_EXE_carom")]).args(arguments).output().unwrap()
}

pub(crate) fn stdout(arguments: &[&str]) -> String {
    successful(arguments, carom(arguments))
}

/// What the command says of what it refuses; it must end with code 2 and give nothing else.
pub(crate) fn refusal(arguments: &[&str]) -> String {
    let output = carom(arguments);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {stderr}");
    assert!(output.stdout.is_empty(), "{arguments:?}: {stderr}");
    stderr
}

/// The results where lines have this width.
pub(crate) fn stdout_at(width: usize, arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    let output = command.args(arguments).env("COLUMNS", width.to_string()).output().unwrap();
    successful(arguments, output)
}

fn successful(arguments: &[&str], output: Output) -> String {
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {stderr}");
    String::from_utf8(output.stdout).unwrap()
}

pub(crate) fn json(arguments: &[&str]) -> serde_json::Value {
    let arguments = [arguments, &["--format", "json"]].concat();
    serde_json::from_str(&stdout(&arguments)).unwrap()
}

pub(crate) fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    path.to_str().unwrap().to_owned()
}

/// A folder of its own for a test, empty; in that for temporary files of this build, named after the
/// process, so that the same test can run twice at once.
pub(crate) fn folder() -> Folder {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    let name = format!("{}-{number}", std::process::id());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    // A process of the same number, long ago, may have been killed.
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    Folder(folder.canonicalize().unwrap())
}

/// A folder that is removed when the test ends.
pub(crate) struct Folder(PathBuf);

impl Deref for Folder {
    type Target = Path;

    fn deref(&self) -> &Path {
        &self.0
    }
}

impl AsRef<Path> for Folder {
    fn as_ref(&self) -> &Path {
        &self.0
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

thread_local! {
    static OWN: Folder = folder();
}

/// A file in a folder of this test, gone before the test.
pub(crate) fn fresh(name: &str) -> PathBuf {
    let path = OWN.with(|folder| folder.join(name));
    let _ = std::fs::remove_file(&path);
    path
}

/// A case file with this text.
pub(crate) fn case(name: &str, text: &str) -> String {
    let path = fresh(name);
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Names and bytes of all files of a folder and those in it; of a link, where it leads.
pub(crate) fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        let (path, kind) = (entry.path(), entry.file_type().unwrap());
        if kind.is_dir() {
            let inner = contents(&path).into_iter();
            found.extend(inner.map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else if kind.is_file() {
            found.push((name, std::fs::read(&path).unwrap()));
        } else if kind.is_symlink() {
            let target = std::fs::read_link(&path).unwrap();
            found.push((name, target.into_os_string().into_encoded_bytes()));
        } else {
            found.push((name, Vec::new()));
        }
    }
    found.sort();
    found
}

pub(crate) fn close(value: &serde_json::Value, expected: f64, tolerance: f64) {
    let value = value.as_f64().unwrap();
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected}");
}

/// The number of this name in a row.
pub(crate) fn number(row: &serde_json::Value, name: &str) -> f64 {
    row[name].as_f64().unwrap_or_else(|| panic!("{name} of {row}"))
}

/// Names and texts of the examples of a kind.
pub(crate) fn examples(kind: CaseKind) -> Vec<(String, String)> {
    examples_in("", kind)
}

/// The same in a folder of the examples.
pub(crate) fn examples_in(folder: &str, kind: CaseKind) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(example(folder)).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let of =
            CaseKind::ALL.into_iter().find(|kind| name.starts_with(&format!("{}_", kind.name)));
        if name.ends_with(".toml") && of.unwrap_or(CaseKind::Impact) == kind {
            found.push((name, std::fs::read_to_string(&path).unwrap()));
        }
    }
    found.sort();
    found
}

/// What was told without lines of progress, which come on a slow machine, with colours or without.
pub(crate) fn without_progress(told: &str) -> String {
    let is_progress = |line: &&str| console::strip_ansi_codes(line).starts_with("progress: ");
    told.split_inclusive('\n').filter(|line| !is_progress(line)).collect()
}
