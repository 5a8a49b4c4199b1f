//! Destinations of results: no input is overwritten, no file is half written, and the reader may stop early.

use crate::common::{carom, case, example, folder, fresh, stdout};
use std::fs::File;
use std::io::{BufRead as _, BufReader};
use std::path::Path;
use std::process::{Command, Output, Stdio};

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.args(arguments);
    command
}

fn refused(output: &Output, expected: &str) {
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(stderr.contains(expected) && output.stdout.is_empty(), "{stderr}");
}

#[test]
#[cfg(unix)]
fn two_outputs_never_share_a_file() {
    let file = fresh("both.svg");
    let out = File::create(&file).unwrap();
    let arguments =
        ["restitution", "--kappa", "1", "--lambda", "1", "--plot", file.to_str().unwrap()];
    refused(&command(&arguments).stdout(out).output().unwrap(), "standard output goes to the same");
}

#[test]
fn names_that_are_no_picture_are_refused() {
    let balls = example("steel_balls.toml");
    let folder = folder();
    for name in ["a", "a.eps", "a.svg.txt", ".svg", "a.", ""] {
        let place = folder.join(name);
        let output = carom(&["impact", &balls, "--plot", place.to_str().unwrap()]);
        refused(&output, "a picture's name must end in .svg, .png or .pdf");
    }
    std::fs::create_dir(folder.join("folder.svg")).unwrap();
    let output = carom(&["impact", &balls, "--plot", folder.join("folder.svg").to_str().unwrap()]);
    refused(&output, "this is not a regular file");
    refused(&carom(&["impact", &balls, "--format", "csv", "--plot", "-"]), "add --format none");
    assert!(!Path::new("-").exists());
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1);
}

#[test]
fn a_picture_on_standard_output_is_alone_there() {
    let file = fresh("alone.svg");
    let balls = example("steel_balls.toml");
    let picture = stdout(&["impact", &balls, "--plot", "-"]);
    assert!(picture.starts_with("<svg") && picture.ends_with("</svg>\n"));
    let none = stdout(&["impact", &balls, "--plot", file.to_str().unwrap()]);
    assert!(none.is_empty());
    assert_eq!(std::fs::read_to_string(&file).unwrap(), picture);
}

#[test]
fn a_picture_with_pixels_is_one() {
    for (arguments, size) in [
        (vec!["history".to_owned(), example("history_loop.toml")], 2000..3000),
        (
            ["restitution", "--kappa", "1:1.5:20", "--lambda", "1:9:20"]
                .map(str::to_owned)
                .to_vec(),
            1000..2000,
        ),
    ] {
        let file = fresh("pixels.PNG");
        let mut arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let option = if arguments[0] == "history" { "--plot" } else { "--map" };
        arguments.extend([option, file.to_str().unwrap()]);
        stdout(&arguments);
        let bytes = std::fs::read(&file).unwrap();
        assert!(bytes.starts_with(b"\x89PNG\r\n\x1a\n"));
        let width = u32::from_be_bytes(bytes[16..20].try_into().unwrap());
        assert!(size.contains(&width), "{width}");
        // Letters, lines and colours: far from an empty page.
        assert!(bytes.len() > 20_000, "{}", bytes.len());
    }
}

#[test]
#[cfg(unix)]
fn a_picture_is_replaced_whole_and_only_after_success() {
    let folder = folder();
    let (kept, link) = (folder.join("kept.svg"), folder.join("link.svg"));
    std::fs::write(&kept, "what was there before, longer than nothing").unwrap();
    std::os::unix::fs::symlink("kept.svg", &link).unwrap();
    let plot = link.to_str().unwrap();
    let bad = case("replace-bad.toml", "[body_1]\n");
    assert_eq!(carom(&["impact", &bad, "--plot", plot]).status.code(), Some(2));
    let balls = example("steel_balls.toml");
    let full = File::options().write(true).open("/dev/full").unwrap();
    let failed = command(&["impact", &balls, "--format", "csv", "--plot", plot])
        .stdout(full)
        .output()
        .unwrap();
    assert_eq!(failed.status.code(), Some(1));
    assert!(std::fs::read_to_string(&kept).unwrap().starts_with("what was there before"));
    stdout(&["impact", &balls, "--plot", plot]);
    assert!(std::fs::read_to_string(&kept).unwrap().starts_with("<svg"));
    assert!(link.is_symlink());
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 2, "nothing is left beside it");
    let mut rights = std::fs::metadata(&kept).unwrap().permissions();
    rights.set_readonly(true);
    std::fs::set_permissions(&kept, rights).unwrap();
    refused(&carom(&["impact", &balls, "--plot", plot]), "this file is read-only");
}

#[test]
fn an_interrupted_map_leaves_no_file() {
    let folder = folder();
    let map = folder.join("map.svg");
    let arguments = ["restitution", "--kappa", "0.8:1.5:4000", "--lambda", "0.05:9:4000", "--map"];
    let arguments = [&arguments[..], &[map.to_str().unwrap(), "--format", "csv"]].concat();
    let mut child = command(&arguments).stdout(Stdio::piped()).spawn().unwrap();
    // Rows come before the last is computed.
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    assert_eq!(lines.next().unwrap().unwrap(), "kappa,lambda,R_x,regimes");
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 0);
}

/// The writing end of a pipe that nobody reads.
fn deaf() -> std::io::PipeWriter {
    std::io::pipe().unwrap().1
}

#[test]
fn a_reader_that_left_is_no_failure() {
    let sweep = example("alumina_on_plane.toml");
    let map = ["restitution", "--kappa", "1:1.5:1000", "--lambda", "1:9:1000", "--format", "csv"];
    for arguments in [&["impact", &sweep][..], &["--help"], &map] {
        let output = command(arguments).stdout(deaf()).stderr(Stdio::piped()).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert!(!stderr.contains("error") && !stderr.contains("panicked"), "{stderr}");
    }
    // Warnings and errors that nobody reads change no exit code.
    for (arguments, code) in
        [(&["impact", &sweep][..], 0), (&["impact", "no/such.toml"], 1), (&["bogus"], 2)]
    {
        let output = command(arguments).stderr(deaf()).output().unwrap();
        assert_eq!(output.status.code(), Some(code), "{arguments:?}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_an_error_of_results_but_not_of_messages() {
    let full = || File::options().write(true).open("/dev/full").unwrap();
    let sweep = example("alumina_on_plane.toml");
    let rows = ["restitution", "--kappa", "1:1.5:99", "--lambda", "1:9:99", "--format", "json"];
    for arguments in [&["impact", &sweep][..], &["--help"], &rows] {
        let output = command(arguments).stdout(full()).stderr(Stdio::piped()).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(!String::from_utf8_lossy(&output.stderr).contains("panicked"));
    }
    for (arguments, code) in
        [(&["impact", &sweep][..], 0), (&["impact", "no/such.toml"], 1), (&["bogus"], 2)]
    {
        let output = command(arguments).stderr(full()).output().unwrap();
        assert_eq!(output.status.code(), Some(code), "{arguments:?}");
    }
}

#[test]
fn tables_too_long_to_read_are_declined_before_work_starts() {
    let many = ["restitution", "--kappa", "1:1.5:1000", "--lambda", "1:9:101"];
    refused(&carom(&many), "choose --format csv, json or none");
    let huge = ["restitution", "--chi", "1:1.5:100000", "--psi", "1:9:100000", "--format", "none"];
    let map = fresh("huge.svg");
    let output = carom(&[&huge[..], &["--map", map.to_str().unwrap()]].concat());
    refused(&output, "--map takes at most 16000000 pairs");
    assert_eq!(stdout(&huge), "");
}

#[test]
fn rows_in_blocks_are_the_same_on_any_number_of_threads() {
    let arguments = ["restitution", "--kappa", "0.8:1.5:103", "--lambda", "0.1:9:107", "--format"];
    for format in ["csv", "json"] {
        let bytes = ["1", "2", "5"].map(|threads| {
            let arguments = [&arguments[..], &[format]].concat();
            command(&arguments).env("RAYON_NUM_THREADS", threads).output().unwrap().stdout
        });
        assert!(bytes[0] == bytes[1] && bytes[1] == bytes[2]);
        let text = String::from_utf8(bytes[0].clone()).unwrap();
        match format {
            "csv" => assert_eq!(text.lines().count(), 1 + 103 * 107),
            _ => {
                let rows: serde_json::Value = serde_json::from_str(&text).unwrap();
                assert_eq!(rows.as_array().unwrap().len(), 103 * 107);
                assert!(text.starts_with("[\n  {\n    \"kappa\": 0.8,\n    \"lambda\": 0.1,"));
                assert!(text.ends_with("\n    ]\n  }\n]\n"));
            }
        }
    }
}

/// The places of letters and lines were looked at; here that it is a whole file with an image.
#[test]
fn a_picture_for_a_paper_is_a_pdf() {
    let file = fresh("map.pdf");
    let balls = ["restitution", "--kappa", "1:1.5:9", "--lambda", "1:9:9", "--map"];
    stdout(&[&balls[..], &[file.to_str().unwrap()]].concat());
    let bytes = std::fs::read(&file).unwrap();
    assert!(bytes.starts_with(b"%PDF-1.7"));
    assert!(bytes.trim_ascii_end().ends_with(b"%%EOF"));
    let has = |text: &[u8]| bytes.windows(text.len()).any(|part| part == text);
    assert!(has(b"/Subtype /Image") && has(b"/MediaBox [0 0 "));
}
