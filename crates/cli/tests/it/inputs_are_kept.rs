//! No input is ever overwritten: each way in which one once was, and many others.
#![cfg(unix)]

use crate::common::{contents, folder, grey_heights, heights, rough};
use std::path::Path;
use std::process::{Command, Output};

fn carom(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carom")).args(arguments).current_dir(folder).output().unwrap()
}

fn write(folder: &Path, name: &str, bytes: impl AsRef<[u8]>) {
    std::fs::write(folder.join(name), bytes).unwrap();
}

/// Refused with code 2 and these words, and every file as it was.
fn refused(folder: &Path, arguments: &[&str], words: &str) {
    let before = contents(folder);
    let output = carom(folder, arguments);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
    assert!(said.contains(words), "{arguments:?}: {said}");
    assert!(contents(folder) == before, "{arguments:?} changed a file");
}

#[test]
fn a_plot_does_not_replace_the_height_map() {
    let folder = folder();
    write(&folder, "rough.png", grey_heights());
    write(&folder, "rough.svg", heights());
    for name in ["rough.png", "rough.svg"] {
        write(&folder, "rough.toml", rough(name));
        let plot = ["solve", "rough.toml", "--plot", name, "--format", "none"];
        refused(&folder, &plot, "this is an input of the same run");
        // The heights are what they were, and taken.
        let output = carom(&folder, &["solve", "rough.toml"]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
fn a_kept_table_of_loads_does_not_replace_the_height_map() {
    let folder = folder();
    write(&folder, "loads.csv", heights());
    write(&folder, "case.toml", rough("loads.csv"));
    refused(
        &folder,
        &["solve", "case.toml", "--keep", "."],
        "an input of the same run is in this folder",
    );
}

#[test]
fn a_kept_table_of_loads_does_not_replace_the_case() {
    let folder = folder();
    write(&folder, "heights.csv", heights());
    write(&folder, "loads.csv", rough("heights.csv"));
    refused(
        &folder,
        &["solve", "loads.csv", "--keep", "."],
        "an input of the same run is in this folder",
    );
}

#[test]
fn a_kept_step_does_not_replace_the_case() {
    let folder = folder();
    write(&folder, "heights.csv", heights());
    write(&folder, "step-000002.npz", rough("heights.csv"));
    refused(
        &folder,
        &["solve", "step-000002.npz", "--keep", "."],
        "an input of the same run is in this folder",
    );
}

#[test]
fn a_kept_table_of_loads_does_not_replace_that_of_a_stranger() {
    let folder = folder();
    write(&folder, "heights.csv", heights());
    write(&folder, "case.toml", rough("heights.csv"));
    std::fs::create_dir(folder.join("kept")).unwrap();
    write(&folder, "kept/loads.csv", "his loads\n");
    refused(&folder, &["solve", "case.toml", "--keep", "kept"], "no manifest of carom");
    refused(&folder, &["solve", "case.toml", "--keep", "kept", "--resume"], "no manifest of carom");
}
