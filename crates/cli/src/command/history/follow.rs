//! Computes a history, with states between its steps for a picture.

use crate::command::plot::{MOST_MARKS, Value};
use crate::command::thinned::Thinned;
use crate::error::CliError;
use crate::rows::BLOCK;
use carom_cases::Error;
use carom_cases::case::HistoryCase;
use carom_cases::history::{self, Laws, Step};
use carom_laws::law::Shift;

/// Number of radii of a traction in a picture.
const RADII: usize = 401;

/// The drawn quantities of a step.
const QUANTITIES: [Value<Step>; 14] = [
    |s| s.load.f_x,
    |s| s.load.f_y,
    |s| s.load.f_z,
    |s| s.load.m_z,
    |s| s.shift.xi,
    |s| s.shift.eta,
    |s| s.shift.omega,
    |s| s.semi_axis_a,
    |s| s.semi_axis_b,
    |s| s.stick_semi_axis_a,
    |s| s.stick_semi_axis_b,
    |s| s.stored_energy,
    |s| s.dissipated,
    |s| s.twist.map_or(0.0, |twist| twist.stick_semi_axis_b),
];

/// What the user requested of a history.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wanted {
    /// Number of radii at which tractions are given after each step; 0 for none.
    pub(super) radii: usize,
    /// Whether a picture is drawn.
    pub(super) picture: bool,
}

/// The states of a history for a picture.
#[derive(Debug)]
pub(super) struct Drawn {
    /// States before, between and after the steps.
    pub(super) course: Vec<Step>,
    /// States after a step, only as many as are needed to decide whether they can be marked.
    pub(super) marked: Vec<Step>,
    /// The last step in contact, if tractions are requested: with tractions at many radii for the
    /// picture, and as printed.
    pub(super) last: Option<[Step; 2]>,
}

/// Computes the states along the shifts. `visit` is called with blocks of states after steps; the
/// states for a picture are returned.
pub(super) fn follow(
    case: &HistoryCase,
    shifts: &[Shift],
    wanted: Wanted,
    mut visit: impl FnMut(&mut Vec<Step>) -> Result<(), CliError>,
) -> Result<Drawn, CliError> {
    let friction = case.friction;
    if wanted.radii > 0 && friction.kinetic().coefficient().is_none() {
        return Err(CliError::Options("--tractions requires finite friction"));
    }
    let state = |number, laws: &Laws, radii| history::step(number, laws, friction, radii);
    let mut laws = Laws::new(case, shifts).map_err(Error::from)?;
    let (mut course, mut marked) = (Thinned::new(QUANTITIES), Vec::new());
    let (mut steps, mut last) = (Vec::new(), None);
    for (i, shift) in shifts.iter().enumerate() {
        if wanted.picture {
            let first = usize::from(i > 0);
            let parts = parts_of_a_step(shifts.len());
            for part in (first..parts).map(|part| part as f64 / parts as f64) {
                // Each from the same state, so that the line passes through the states after the
                // steps.
                let mut between = laws.clone();
                between.advance(lerp(laws.present(), *shift, part)).map_err(Error::from)?;
                course.push(state(i as f64 + part, &between, 0)?);
            }
        }
        laws.advance(*shift).map_err(Error::from)?;
        let step = state((i + 1) as f64, &laws, wanted.radii)?;
        if wanted.picture {
            let bare = Step { tractions: Vec::new(), ..step.clone() };
            if marked.len() <= MOST_MARKS {
                marked.push(bare.clone());
            }
            course.push(bare);
            if wanted.radii > 0 && laws.contact().is_some() {
                last = Some((step.clone(), laws.clone()));
            }
        }
        steps.push(step);
        if steps.len() * wanted.radii.max(1) >= BLOCK {
            visit(&mut steps)?;
            steps.clear();
        }
    }
    visit(&mut steps)?;
    let last = match last {
        Some((given, laws)) => Some([state(given.step, &laws, RADII)?, given]),
        None => None,
    };
    Ok(Drawn { course: course.records(), marked, last })
}

/// Number of states drawn for each step, of which the last is the one after the step: enough for a
/// smooth line.
fn parts_of_a_step(steps: usize) -> usize {
    (2000 / steps).clamp(1, 50)
}

/// Linear interpolation between two shifts.
fn lerp(from: Shift, to: Shift, part: f64) -> Shift {
    let between = |from: f64, to: f64| from + part * (to - from);
    Shift {
        zeta: between(from.zeta, to.zeta),
        xi: between(from.xi, to.xi),
        eta: between(from.eta, to.eta),
        omega: between(from.omega, to.omega),
    }
}
