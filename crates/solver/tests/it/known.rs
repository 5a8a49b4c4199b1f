//! Discretisation errors of contacts with known solutions.

use crate::known_solutions::Known;
use carom_solver::{ContactState, Frictional, Method as _};

fn solved(known: Known, cells: usize) -> ContactState {
    let problem = known.problem(cells, [0.0; 2]).unwrap();
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let mut state = ContactState::apart(problem.grid());
    for drive in known.drives(cells).unwrap() {
        let from = state.clone();
        method.step(&problem, &from, &drive, &mut state, &mut scratch, &mut ()).unwrap();
    }
    state
}

/// Relative errors of the characteristic load of the contact, or of its peak pressure.
fn error(known: Known, cells: usize) -> f64 {
    let (state, want) = (solved(known, cells), known.expected(cells).unwrap());
    let (got, load) = (state.load(), want.load);
    let (got, want) = match known {
        Known::Hertz | Known::FlatPunch => (got.f_z, load.f_z),
        Known::CattaneoMindlin => (got.f_x, load.f_x),
        Known::Lubkin | Known::MindlinTorsion => (got.m_z, load.m_z),
        Known::Westergaard => (state.peak_pressure(), want.peak.unwrap()),
    };
    got / want - 1.0
}

/// Bounds for 24, 48 and 96 cells, of which 20, 40 and 80 lie across the contact.
#[test]
fn errors_fall_with_the_cells() {
    let bounds = [
        (Known::Hertz, [7e-4, 2.2e-4, 5e-5]),
        (Known::CattaneoMindlin, [1.9e-3, 5e-4, 1.5e-4]),
        (Known::Lubkin, [4e-3, 1e-3, 4e-4]),
        (Known::MindlinTorsion, [3e-2, 1.5e-2, 8e-3]),
        (Known::FlatPunch, [2e-2, 1e-2, 5e-3]),
        (Known::Westergaard, [1e-2, 3e-3, 1e-3]),
    ];
    let mut wrong = false;
    for (known, bounds) in bounds {
        let errors = [24, 48, 96].map(|cells| error(known, cells));
        println!("{known:?}: {:.1e} {:.1e} {:.1e}", errors[0], errors[1], errors[2]);
        wrong |= errors.iter().zip(bounds).any(|(error, bound)| error.abs() > bound);
    }
    assert!(!wrong, "an error is above its bound");
}
