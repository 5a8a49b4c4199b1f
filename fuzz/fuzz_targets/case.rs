//! Any text as a case of every kind, read as `carom check` does, and as an input of CONTACT; contacts in closed
//! form are computed too.
#![no_main]

use carom_cases::case::{Case as _, CaseKind, HertzCase, HistoryCase, Steps};
use carom_cases::input::CaseFile;
use carom_cases::{contact, hertz, history};
use carom_fuzz::Folder;
use libfuzzer_sys::fuzz_target;
use std::sync::LazyLock;

static FOLDER: LazyLock<Folder> = LazyLock::new(|| Folder::new("case"));
/// More loads or steps than this are checked, not computed.
const MOST: usize = 20;

fuzz_target!(|text: &str| {
    if let Ok(cases) = contact::cases(text) {
        for case in cases.iter().take(MOST) {
            let _ = contact::toml(&cases, case.number);
        }
    }
    if let Ok(kind) = CaseKind::of(text) {
        read(kind, text);
    }
    for kind in CaseKind::ALL {
        if kind.check(text).is_ok() {
            read(kind, text);
            compute(kind, text);
        }
    }
});

/// What `carom check` tells of a case.
fn read(kind: CaseKind, text: &str) {
    if let Err(error) = kind.check(text) {
        assert!(!error.shown_in(text).is_empty());
    }
    if let Ok(fields) = kind.understood(text) {
        assert!(fields.iter().all(|field| !field.field.is_empty()));
    }
    let _ = kind.unusual(text);
}

fn compute(kind: CaseKind, text: &str) {
    match kind {
        CaseKind::Hertz => {
            let case = HertzCase::parse(text).expect("checked");
            if case.values.as_slice().len() <= MOST {
                pressed(&file(text));
            }
        }
        CaseKind::History => {
            let case = HistoryCase::parse(text).expect("checked");
            // The law of a finer tolerance takes its time.
            if case.tolerance.get() >= 1e-4
                && matches!(case.steps, Steps::Inline(steps) if steps.len() <= MOST)
            {
                shifted(&file(text));
            }
        }
        _ => {}
    }
}

fn file(text: &str) -> CaseFile {
    let path = FOLDER.write("case.toml", text.as_bytes());
    CaseFile::read(&path).expect("a text")
}

fn pressed(file: &CaseFile) {
    let Ok(followed) = hertz::followed(file) else { return };
    for state in &followed.states {
        let numbers = [state.approach(), state.force(), state.peak_pressure(), state.widest()];
        assert!(numbers.iter().all(|number| !number.is_nan()), "{state:?}");
    }
    let _ = followed.validity_report();
}

fn shifted(file: &CaseFile) {
    let Ok(followed) = history::followed(file) else { return };
    for step in &followed.steps {
        let load = step.load;
        let numbers = [load.f_x, load.f_y, load.f_z, load.m_z, step.stored_energy, step.dissipated];
        assert!(numbers.iter().all(|number| !number.is_nan()), "{step:?}");
    }
    let _ = followed.validity_report();
}
