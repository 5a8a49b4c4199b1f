//! Any bytes as the files that a case names: heights, factors of friction, influence numbers, steps.
#![no_main]

use carom_cases::case::{Case as _, SolveCase};
use carom_cases::history::read_steps;
use carom_cases::input::CaseFile;
use carom_cases::solve::Bodies;
use carom_fuzz::Folder;
use libfuzzer_sys::fuzz_target;
use std::path::Path;
use std::sync::LazyLock;

static FOLDER: LazyLock<Folder> = LazyLock::new(|| Folder::new("heights"));

/// Where the file goes, and its name. The first byte chooses.
const FILES: [(&str, &str); 9] = [
    ("heights", "file.csv"),
    ("heights", "file.npy"),
    ("heights", "file.png"),
    ("influence", "file.csv"),
    ("influence", "file.npz"),
    ("influence", "file.txt"),
    ("friction", "file.csv"),
    ("friction", "file.npy"),
    ("steps", "file.csv"),
];

fuzz_target!(|bytes: &[u8]| {
    let Some((first, bytes)) = bytes.split_first() else { return };
    let (purpose, name) = FILES[usize::from(*first) % FILES.len()];
    FOLDER.write(name, bytes);
    let text = case(purpose, name);
    let file = CaseFile::read(&FOLDER.write("case.toml", text.as_bytes())).expect("a text");
    if purpose == "steps" {
        if let Ok(steps) = read_steps(&file, Path::new(name)) {
            assert!(steps.iter().all(|step| step.check_finite().is_ok() || step.zeta.is_finite()));
        }
        return;
    }
    let case = SolveCase::parse(&text).expect("a case");
    let _ = Bodies::of(&file, &case);
});

/// A case of 3 x 2 cells.
fn case(purpose: &str, name: &str) -> String {
    let bodies = "[body_1]\nmaterial = { rigid = true }\n\
                  [body_2]\nmaterial = { shear_modulus = 1e9, poisson = 0.3 }\n";
    let (gap, influence, map) = match purpose {
        "heights" => {
            (format!("shape = \"heights\"\nfile = \"{name}\""), String::new(), String::new())
        }
        "influence" => (
            "shape = \"paraboloid\"\nradii = [1, 1]".to_owned(),
            format!("[bodies.influence]\nfile = \"{name}\"\n"),
            String::new(),
        ),
        _ => (
            "shape = \"paraboloid\"\nradii = [1, 1]".to_owned(),
            String::new(),
            format!("friction_map = \"{name}\"\n"),
        ),
    };
    format!(
        "{bodies}{influence}[gap]\n{gap}\n[grid]\ncells = [3, 2]\nsize = [3e-3, 2e-3]\ncut = true\n\
         [contact]\nfriction = 0.3\n{map}[[step]]\nzeta = 1e-6\n"
    )
}
