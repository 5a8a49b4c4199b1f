//! The commands of the README, and those at the beginning of `carom --help`, run.

use crate::common;

use std::path::Path;
use std::process::Command;

#[test]
fn the_commands_of_the_readme_run() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let readme = std::fs::read_to_string(root.join("README.md")).unwrap();
    let commands: Vec<&str> = readme
        .lines()
        .filter_map(|line| line.strip_prefix("cargo run --release -p carom-cli -- "))
        .collect();
    assert!(commands.len() >= 3);
    let folder = common::folder();
    std::fs::create_dir_all(folder.join("target")).unwrap();
    for command in commands {
        let arguments =
            command.split_whitespace().map(|argument| match argument.strip_prefix("examples/") {
                Some(name) => root.join("examples").join(name).to_str().unwrap().to_owned(),
                None => argument.to_owned(),
            });
        let output = Command::new(env!("CARGO_BIN_EXE_carom"))
            .args(arguments)
            .current_dir(&folder)
            .output()
            .unwrap();
        let stderr = String::from_utf8_lossy(&output.stderr);
        let draws = ["--plot", "--map", "--animate"].iter().any(|option| command.contains(option));
        let is_quiet = draws && !command.contains("--format");
        assert!(output.status.success(), "{command}: {stderr}");
        assert_eq!(output.stdout.is_empty(), is_quiet, "{command}");
    }
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
