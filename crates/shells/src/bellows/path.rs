//! Paths of states under growing force or dilatation, up to limit points.

use super::axial::{Axial, BellowsLoad};
use super::fields::{dilatation, points};
use super::newton::{self, NotConverged, Solved};
use super::state::BellowsState;
use super::system::{Bellows, BellowsError};
use carom_special::RangeError;

/// What is greatest at a limit point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LimitKind {
    /// The force: dF/dDelta = 0. Under a given force the bellows jumps from here.
    Force,
    /// The dilatation: dDelta/dF = 0. Under a given dilatation the bellows jumps from here.
    Dilatation,
}

/// How a path ends.
#[derive(Debug, Clone, PartialEq)]
pub enum PathEnd {
    /// At the load asked for, the last state of the path.
    Reached,
    /// At a limit point before it: no neighbouring state carries more.
    LimitPoint {
        /// What is greatest there.
        kind: LimitKind,
        /// The state at the limit.
        state: Box<BellowsState>,
    },
}

/// States under a growing load.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadPath {
    /// The states, from the one at the start.
    pub states: Vec<BellowsState>,
    /// How it ends.
    pub end: PathEnd,
}

/// The least part of a step that is tried before a limit point is looked for.
const LEAST_PART: f64 = 1.0 / 64.0;
/// How far a change may differ from the mean of the rates at its ends.
const SMOOTH: f64 = 0.1;
/// The most steps beyond a state in search of a limit point.
const MOST_SEARCHED: usize = 200;

impl Bellows {
    /// Follows the states from one to a load of the same pressure, with about `steps` equal steps
    /// of the force or of the dilatation, whichever the load gives. Before a limit point the path
    /// ends there.
    ///
    /// # Errors
    /// [`BellowsError::Range`] unless there are 1 to 10000 steps, the load has the pressure of the
    /// start and differs from it, and the state is of this bellows (its number of harmonics);
    /// [`BellowsError::NotConverged`] if the path is lost without a limit point.
    pub fn follow(
        &self,
        start: &BellowsState,
        load: BellowsLoad,
        steps: usize,
    ) -> Result<LoadPath, BellowsError> {
        let fits = (1..=10_000).contains(&steps);
        RangeError::check("steps", steps as f64, fits, "from 1 to 10000")?;
        let is_same = load.pressure() == start.pressure();
        RangeError::check("pressure", load.pressure(), is_same, "that of the start")?;
        let own = start.rotation_coefficients().len();
        let fits = own == self.harmonics();
        RangeError::check("harmonics of the start", own as f64, fits, "those of the bellows")?;
        let (pressure, target) = self.without_units(load);
        let walk = Walk { bellows: self, pressure, kind: target };
        walk.to(start, target.value(), steps)
    }
}

/// Steps at a fixed pressure.
#[derive(Clone, Copy)]
struct Walk<'a> {
    bellows: &'a Bellows,
    pressure: f64,
    /// What is prescribed; its value does not matter.
    kind: Axial,
}

impl Walk<'_> {
    fn to(
        &self,
        start: &BellowsState,
        target: f64,
        steps: usize,
    ) -> Result<LoadPath, BellowsError> {
        let mut states = vec![start.clone()];
        let mut last = start.solved.clone();
        let mut value = self.value(&last);
        let whole = target - value;
        let full = whole / steps as f64;
        let mut part = 1.0;
        while (target - value) * whole > 0.0 {
            let is_last = (target - value).abs() <= 1.000_001 * (part * full).abs();
            let next = if is_last { target } else { value + part * full };
            match self.step(&last, value, next) {
                Ok(solved) => {
                    states.push(self.bellows.state(self.pressure, solved.clone()));
                    last = solved;
                    value = next;
                    part = f64::min(1.0, 2.0 * part);
                }
                Err(_) if part > LEAST_PART => part *= 0.5,
                Err(failure) => {
                    let Some(limit) = self.limit(&last, part * full) else {
                        let fraction = 1.0 - (target - value) / whole;
                        return Err(NotConverged { fraction, ..failure }.into());
                    };
                    let end = self.limit_point(limit);
                    return Ok(LoadPath { states, end });
                }
            }
        }
        Ok(LoadPath { states, end: PathEnd::Reached })
    }

    fn limit_point(&self, solved: Solved) -> PathEnd {
        let kind = match self.kind {
            Axial::Force(_) => LimitKind::Force,
            Axial::Dilatation(_) => LimitKind::Dilatation,
        };
        PathEnd::LimitPoint { kind, state: Box::new(self.bellows.state(self.pressure, solved)) }
    }

    /// A step of what is prescribed to `value`, from the tangent. The other quantity must grow as
    /// the mean of its rates at both ends says, and the determinant keep its sign: otherwise the
    /// state found is on another path.
    fn step(&self, from: &Solved, old: f64, value: f64) -> Result<Solved, NotConverged> {
        let change = value - old;
        let growth = match self.kind {
            Axial::Force(_) => change / from.stiffness,
            Axial::Dilatation(_) => change,
        };
        let mut guess = from.unknowns.clone();
        for (unknown, rate) in guess.0.iter_mut().zip(&from.tangent) {
            *unknown += growth * rate;
        }
        let axial = self.kind.with(value);
        let found = newton::solve(&self.bellows.grid, &guess, self.pressure, axial)?;
        let other = self.other();
        let (start, end) = (other.value(from), other.value(&found));
        let rounding = 1e-10 * (start.abs() + end.abs());
        let (one, two) = (change / self.rate(from), change / self.rate(&found));
        let difference = (end - start - 0.5 * (one + two)).abs();
        let is_smooth = difference <= SMOOTH * (one.abs() + two.abs()) + rounding;
        if is_smooth && self.is_negative(&found) == self.is_negative(from) {
            return Ok(found);
        }
        let (last_step, residual) = (found.last_step, found.residual);
        Err(NotConverged { fraction: 0.0, last_step, residual })
    }

    /// The prescribed quantity of a state.
    fn value(&self, solved: &Solved) -> f64 {
        match self.kind {
            Axial::Force(_) => solved.unknowns.force(),
            Axial::Dilatation(_) => {
                let grid = &self.bellows.grid;
                dilatation(grid, &points(grid, &solved.unknowns, self.pressure))
            }
        }
    }

    /// Rate of the prescribed quantity with the other one: it vanishes at a limit point.
    fn rate(&self, solved: &Solved) -> f64 {
        match self.kind {
            Axial::Force(_) => solved.stiffness,
            Axial::Dilatation(_) => 1.0 / solved.stiffness,
        }
    }

    /// Whether the determinant of the equations is negative for what is prescribed. At given force
    /// it is that at given dilatation times the stiffness (Cramer's rule).
    fn is_negative(&self, solved: &Solved) -> bool {
        match self.kind {
            Axial::Force(_) => solved.is_negative != (solved.stiffness < 0.0),
            Axial::Dilatation(_) => solved.is_negative,
        }
    }

    /// The same walk by the other quantity.
    const fn other(&self) -> Self {
        let kind = match self.kind {
            Axial::Force(_) => Axial::Dilatation(0.0),
            Axial::Dilatation(_) => Axial::Force(0.0),
        };
        Walk { kind, ..*self }
    }

    /// The limit point beyond a state in the direction of `change`: walks on by the other quantity,
    /// which has no limit there, until the rate changes its sign, and closes in on its zero.
    fn limit(&self, last: &Solved, change: f64) -> Option<Solved> {
        let other = self.other();
        let mut step = change / self.rate(last);
        let mut place = other.value(last);
        let mut before = last.clone();
        for _ in 0..MOST_SEARCHED {
            match other.step(&before, place, place + step) {
                Ok(next) if self.rate(&next) * self.rate(last) <= 0.0 => {
                    return other.close_in(self, before, place, place + step);
                }
                Ok(next) => {
                    before = next;
                    place += step;
                    step *= 1.5;
                }
                Err(_) => step *= 0.5,
            }
        }
        None
    }

    /// Halves the interval between a state and a place beyond the zero of the rate.
    fn close_in(
        &self,
        limited: &Self,
        mut before: Solved,
        mut low: f64,
        mut high: f64,
    ) -> Option<Solved> {
        let sign = limited.rate(&before);
        for _ in 0..60 {
            if (high - low).abs() <= 1e-12 * (low.abs() + high.abs()) {
                break;
            }
            let middle = 0.5 * (low + high);
            let found = self.step(&before, low, middle).ok()?;
            if limited.rate(&found) * sign > 0.0 {
                before = found;
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(before)
    }
}
