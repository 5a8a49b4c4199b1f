//! Following a history, and what lies between its steps for a picture.

use super::laws::Laws;
use super::view::{self, Step};
use crate::case::HistoryCase;
use crate::command::hertz::smallest_radius;
use crate::error::CliError;
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_special::RangeError;

/// Radii of a drawn traction.
const RADII: usize = 401;

/// What a history is asked for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wanted {
    /// Radii at which tractions are given after each step; none for 0.
    pub(super) radii: usize,
    /// Whether there will be a picture.
    pub(super) picture: bool,
}

/// The states of a history.
#[derive(Debug, Default)]
pub(super) struct Followed {
    /// After each step.
    pub(super) steps: Vec<Step>,
    /// Before, between and after the steps; for a picture only.
    pub(super) course: Vec<Step>,
    /// After the last step in contact, with tractions at many radii; for a picture only.
    pub(super) last: Option<Step>,
}

/// Goes through the shifts. `at_fault` blames the case for what a law refuses.
pub(super) fn follow(
    case: &HistoryCase,
    shifts: &[Shift],
    wanted: Wanted,
    at_fault: impl Fn(RangeError) -> CliError,
) -> Result<Followed, CliError> {
    let friction = Friction::new(case.friction).map_err(&at_fault)?;
    if wanted.radii > 0 && friction.coefficient().is_none() {
        return Err(CliError::Options("--tractions takes a case with finite friction"));
    }
    let radius = smallest_radius(&case.hertz);
    let state = |number, laws: &Laws, radii| view::step(number, laws, friction, radii, radius);
    let mut laws = Laws::new(case, friction, shifts).map_err(&at_fault)?;
    let (mut followed, mut last) = (Followed::default(), None);
    for (i, shift) in shifts.iter().enumerate() {
        if wanted.picture {
            let first = usize::from(i > 0);
            let parts = parts_of_a_step(shifts.len());
            for part in (first..parts).map(|part| part as f64 / parts as f64) {
                // From the same state each, so that the line runs through the steps themselves.
                let mut between = laws.clone();
                between.advance(lerp(laws.present(), *shift, part)).map_err(&at_fault)?;
                followed.course.push(state(i as f64 + part, &between, 0)?);
            }
        }
        laws.advance(*shift).map_err(&at_fault)?;
        let number = (i + 1) as f64;
        followed.steps.push(state(number, &laws, wanted.radii)?);
        if wanted.picture {
            followed.course.push(state(number, &laws, 0)?);
            if wanted.radii > 0 && laws.contact().is_some() {
                last = Some((number, laws.clone()));
            }
        }
    }
    followed.last = last.map(|(number, laws)| state(number, &laws, RADII)).transpose()?;
    Ok(followed)
}

/// States drawn for every step, the last its own: enough for a smooth line.
fn parts_of_a_step(steps: usize) -> usize {
    (2000 / steps).clamp(1, 50)
}

/// The shift at a part of the way from one to the other.
fn lerp(from: Shift, to: Shift, part: f64) -> Shift {
    let between = |from: f64, to: f64| from + part * (to - from);
    Shift {
        zeta: between(from.zeta, to.zeta),
        xi: between(from.xi, to.xi),
        eta: between(from.eta, to.eta),
        omega: between(from.omega, to.omega),
    }
}
