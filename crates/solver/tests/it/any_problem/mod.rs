//! Random contacts of any shape, material, friction and drive: each step satisfies the conditions
//! of contact and friction, has no negative friction heat in any cell, and is the same when driven
//! by shifts or by loads, started from coarse grids or not.

mod drawn;

use std::sync::Arc;

use crate::delegating::Delegating;
use carom_drawn::{Congruential, Draw as _};
use carom_halfspace::operator::HalfSpaceOperator;
use carom_laws::law::Shift;
use carom_solver::{
    CellState, ContactProblem, ContactState, Drive, Driven, Frictional, FrictionalError,
    Method as _, dissipated, violations,
};
use drawn::{Case, difference, step};

/// A drawn case, and which of its steps are driven by loads.
fn case(seed: u64) -> (Case, [bool; 4]) {
    let mut random = Congruential(991 + 104_729 * seed).after(8);
    let case = Case::drawn(&mut random).unwrap();
    (case, [(); 4].map(|()| random.part() < 0.5))
}

/// The same problem on one grid only; none on a period.
fn alone(case: &Case) -> Option<ContactProblem> {
    let operator = || HalfSpaceOperator::new(case.pair, case.gap.grid()).unwrap();
    let alone = || case.solved_by(Arc::new(Delegating::on_one_grid(operator()))).unwrap();
    (!case.periodic).then(alone)
}

/// The drive of a shift, with some shifts replaced by the loads of a state.
fn by_load((case, loaded): &(Case, [bool; 4]), shift: Shift, state: &ContactState) -> Drive {
    let load = state.load();
    let driven = |k: usize, shift: f64, load: f64| {
        if loaded[k] || (k == 0 && case.periodic) {
            Driven::Load(load)
        } else {
            Driven::Shift(shift)
        }
    };
    let twist = if case.periodic { Driven::Shift(0.0) } else { driven(3, shift.omega, load.m_z) };
    Drive {
        normal: driven(0, shift.zeta, load.f_z),
        x: driven(1, shift.xi, load.f_x),
        y: driven(2, shift.eta, load.f_y),
        twist,
    }
}

/// Describes what is wrong with the steps of a case.
fn check(seed: u64) -> Result<(), String> {
    let drawn = case(seed);
    let case = &drawn.0;
    let method = Frictional::default();
    let problem = case.problem().unwrap();
    let mut scratch = method.scratch(&problem).unwrap();
    let alone = alone(case);
    let mut alone = alone.as_ref().map(|problem| (problem, method.scratch(problem).unwrap()));
    let mut before = ContactState::apart(problem.grid());
    for (number, shift) in case.steps.iter().enumerate() {
        let at = |what: &str| format!("seed {seed}, step {number}: {what}");
        let drive = case.drive(*shift);
        let after = step(&problem, &mut scratch, &before, &drive)
            .map_err(|error| at(&error.to_string()))?;
        let touching = after.count(CellState::Stick) + after.count(CellState::Slip);
        if touching > 0 {
            let left = violations(&problem, &before, &after).unwrap();
            if left.normal > 1e-8 || (left.tangential > 1e-7) {
                return Err(at(&format!("{left:?}")));
            }
            let heat = dissipated(&before, &after);
            let least = heat.values().iter().copied().fold(0.0, f64::min);
            let scale = after.load().f_z.abs() * shift.zeta.abs();
            if least < -1e-9 * scale {
                return Err(at(&format!("a cell cools by {:e} of the work", -least / scale)));
            }
        }
        // If almost nothing sticks, a load hardly determines the shift.
        let sticks = after.count(CellState::Stick) * 5 > touching;
        if sticks && case.breaks {
            match step(&problem, &mut scratch, &before, &by_load(&drawn, *shift, &after)) {
                Ok(other) => {
                    let left = violations(&problem, &before, &other).unwrap();
                    if left.normal > 1e-8 || left.tangential > 1e-7 {
                        return Err(at(&format!("by load {left:?}")));
                    }
                }
                // Cells that change to kinetic friction make others slip.
                Err(FrictionalError::Slides { .. } | FrictionalError::Turns { .. }) => {}
                Err(error) => return Err(at(&format!("by load: {error}"))),
            }
        } else if sticks {
            let other = step(&problem, &mut scratch, &before, &by_load(&drawn, *shift, &after))
                .map_err(|error| at(&format!("by load: {error}")))?;
            let apart = difference(&after, &other);
            if apart > 1e-5 {
                return Err(at(&format!("by load off by {apart:e}")));
            }
        }
        if let Some((problem, scratch)) = alone.as_mut() {
            let other = step(problem, scratch, &before, &drive)
                .map_err(|error| at(&format!("on one grid: {error}")))?;
            let apart = difference(&after, &other);
            if apart > 1e-6 {
                return Err(at(&format!("on one grid off by {apart:e}")));
            }
        }
        before = after;
    }
    Ok(())
}

fn all_hold(seeds: std::ops::Range<u64>) {
    let wrong: Vec<String> = seeds.filter_map(|seed| check(seed).err()).collect();
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn any_step_of_any_contact_obeys_its_laws() {
    all_hold(0..60);
}

#[test]
#[ignore = "minutes: many more"]
fn any_step_of_many_more_contacts_obeys_its_laws() {
    all_hold(1000..2500);
}

/// The rigid shift diverged while all cells slipped in one direction.
#[test]
fn a_shift_that_has_run_away_comes_back() {
    all_hold(1032..1033);
}
