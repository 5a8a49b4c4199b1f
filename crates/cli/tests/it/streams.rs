//! Standard output that is closed, dangling links, and limits of memory.
#![cfg(unix)]

use crate::common;

use crate::common::{example, folder, limited};
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// A line for the shell, in which `$carom` is the command.
fn shell(folder: &Path, line: &str) -> Output {
    let mut command = Command::new("sh");
    command.args(["-c", line]).env("carom", env!("CARGO_BIN_EXE_carom"));
    command.current_dir(folder).output().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
#[cfg(target_os = "linux")]
fn a_closed_standard_output_is_an_error_where_results_go_there() {
    let folder = folder();
    let balls = example("steel_balls.toml");
    for arguments in [
        &format!("impact '{balls}'"),
        &format!("impact '{balls}' --format csv --plot x.svg"),
        &format!("impact '{balls}' --plot -"),
        &format!("check '{balls}'"),
        "restitution --kappa 1.2 --lambda 1:2:9 --format csv",
        "new impact",
        "schema impact",
        "man",
        "completions bash",
        "--help",
        "--version",
        "impact --help",
    ] {
        let output = shell(&folder, &format!("\"$carom\" {arguments} >&-"));
        assert_eq!(output.status.code(), Some(1), "{arguments}: {}", said(&output));
        assert!(!folder.join("x.svg").exists(), "{arguments}");
        // Thrown away on purpose.
        let output = shell(&folder, &format!("\"$carom\" {arguments} > /dev/null"));
        assert!(output.status.success(), "{arguments}: {}", said(&output));
        let _ = std::fs::remove_file(folder.join("x.svg"));
    }
    // Nothing goes there.
    let output = shell(&folder, &format!("\"$carom\" impact '{balls}' --plot x.svg >&-"));
    assert!(output.status.success() && folder.join("x.svg").exists(), "{}", said(&output));
    let mut quiet = Command::new(env!("CARGO_BIN_EXE_carom"));
    assert!(quiet.args(["impact", &balls]).stdout(Stdio::null()).status().unwrap().success());
    // Bad options are told on standard error.
    assert_eq!(shell(&folder, "\"$carom\" impact >&-").status.code(), Some(2));
}

#[test]
fn a_link_to_nothing_is_followed_as_others_are() {
    let folder = folder();
    std::fs::create_dir(folder.join("there")).unwrap();
    symlink("there/new.svg", folder.join("link.svg")).unwrap();
    symlink("link.svg", folder.join("chain.svg")).unwrap();
    symlink("no/such/folder/new.svg", folder.join("lost.svg")).unwrap();
    symlink("round.svg", folder.join("round.svg")).unwrap();
    let balls = example("steel_balls.toml");
    let drawn = |name: &str| {
        shell(&folder, &format!("\"$carom\" impact '{balls}' --format none --plot {name}"))
    };
    assert!(drawn("chain.svg").status.success());
    let target = folder.join("there/new.svg");
    assert!(std::fs::read_to_string(&target).unwrap().starts_with("<svg"));
    assert!(!target.is_symlink() && folder.join("link.svg").is_symlink());
    assert!(folder.join("chain.svg").is_symlink());
    for name in ["lost.svg", "round.svg"] {
        let output = drawn(name);
        assert_eq!(output.status.code(), Some(1), "{}", said(&output));
        assert!(said(&output).contains("cannot write"), "{}", said(&output));
        assert!(folder.join(name).is_symlink());
    }
}

#[test]
fn a_field_that_leads_to_the_picture_is_refused_before_either_is_written() {
    let folder = folder();
    std::fs::write(folder.join("x.svg"), "what was there").unwrap();
    symlink("x.svg", folder.join("y.npz")).unwrap();
    let case = example("stress_ball.toml");
    let output = shell(&folder, &format!("\"$carom\" stress '{case}' --field y.npz --plot x.svg"));
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
    assert!(said(&output).contains("another output goes to the same file"), "{}", said(&output));
    assert_eq!(std::fs::read(folder.join("x.svg")).unwrap(), b"what was there");
}

#[test]
#[cfg(target_os = "linux")]
fn a_limit_of_the_address_space_is_an_error_and_no_abort() {
    let case = common::case(
        "large.toml",
        "[body_1]\nmaterial = { shear_modulus = 1, poisson = 0.3 }\n\
         [body_2]\nmaterial = { rigid = true }\n\
         [gap]\nshape = \"sphere\"\nradius = 10\n\
         [grid]\ncells = [2048, 2048]\nsize = [4, 4]\n\
         [contact]\nfriction = 0.3\n[[step]]\nF_z = 0.2\n",
    );
    for limit in [250_000, 500_000, 1_000_000] {
        let output = limited(&format!("ulimit -v {limit}"), &["solve", &case, "--threads", "2"]);
        assert_eq!(output.status.code(), Some(2), "{limit}: {}", said(&output));
        assert!(said(&output).contains("are available"), "{limit}: {}", said(&output));
    }
}
