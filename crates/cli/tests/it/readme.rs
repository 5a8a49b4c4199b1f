//! The commands of the README, and those at the beginning of `carom --help`, run.

use crate::book::{blocks, root, run, shelf};
use crate::common;
use std::process::Command;

#[test]
#[cfg(unix)]
fn the_readme_shows_what_its_commands_print() {
    let readme = std::fs::read_to_string(root().join("README.md")).unwrap();
    let (folder, mut said) = (shelf(), String::new());
    for block in blocks(&readme, "sh") {
        said += &run(&folder, block, &readme);
    }
    assert!(folder.join("ball.svg").exists() && folder.join("slow_motion.svg").exists());
    // The lines of the table: name, value and the last words of the meaning.
    let [table] = blocks(&readme, "text")[..] else { panic!("one table") };
    for line in table.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let has = |row: &str| words.iter().all(|word| row.contains(word));
        assert!(said.lines().any(has), "{line}");
    }
}

#[test]
#[cfg(unix)]
fn a_warning_that_a_page_does_not_show_is_found() {
    let folder = shelf();
    let warns = "carom impact examples/rubber_on_table.toml --plot ball.svg";
    for shown in ["", "OUTSIDE THE THEORY: elastic waves would carry away more than 10 %"] {
        assert!(std::panic::catch_unwind(|| run(&folder, warns, shown)).is_err(), "{shown}");
    }
    let page = "OUTSIDE THE THEORY: elastic waves would carry away more than 10 %, large contact: a/R exceeds 0.1, \
                elastic waves would carry away more than 10";
    run(&folder, warns, page);
}

#[test]
#[cfg(unix)]
fn the_first_steps_of_the_help_run() {
    let help = common::stdout(&["--help"]);
    let (_, steps) = help.split_once("First steps:").unwrap();
    let commands: Vec<&str> = steps
        .lines()
        .filter_map(|line| line.strip_prefix("  carom "))
        .filter_map(|line| line.split("  ").next())
        .collect();
    assert!(commands.len() >= 5, "{help}");
    let folder = common::folder();
    for command in commands {
        let output = Command::new("sh")
            .args(["-c", &format!("'{}' {command}", env!("CARGO_BIN_EXE_carom"))])
            .current_dir(&folder)
            .output()
            .unwrap();
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "carom {command}: {stderr}");
    }
    assert!(folder.join("ball.svg").exists() && folder.join("rebound.svg").exists());
}
