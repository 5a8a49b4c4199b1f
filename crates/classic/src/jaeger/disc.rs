//! Gauss-Seidel iteration that solves contact and friction exactly for one element at a time.

use carom_special::{RangeError, interrupt};

use crate::direct::{Demand, DirectError, End, Influence, Outcome, apart, check_tolerance};
use carom_solver::{
    CellState, ContactProblem, ContactState, Convergence, Drive, Method, Observer, Products,
    Progress, Residuals, Stop,
};

/// Gauss-Seidel sweeps in which the pressure of each element, and its traction within the disc of
/// radius f p, are exact for given tractions of all other elements. There are no loops for areas
/// and directions. The method is slow and simple, and serves as a check of the others. Shifts must
/// be prescribed, and tractions on an element must not displace it in another direction.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction, law::Shift};
/// use carom_classic::jaeger::DiscGaussSeidel;
/// use carom_solver::{ContactProblem, ContactState, Drive, Gap, Method};
/// let grid = Grid::new(8, 8, 0.28, 0.28)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let body = Material::from_shear(1.0, 0.3)?;
/// let problem =
///     ContactProblem::of_half_spaces(gap, MaterialPair::new(body, body)?, Friction::new(0.4)?)?;
/// let method = DiscGaussSeidel::default();
/// let mut scratch = method.scratch(&problem)?;
/// let apart = ContactState::apart(grid);
/// let mut state = apart.clone();
/// let drive = Drive::by_shift(Shift { zeta: 1.0, xi: 0.2, ..Shift::default() });
/// let convergence = method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
/// assert_eq!(scratch.changes().len(), convergence.iterations);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DiscGaussSeidel {
    tolerance: f64,
    sweeps: usize,
}

impl Default for DiscGaussSeidel {
    /// Tolerance 1e-11, at most 20 000 sweeps.
    fn default() -> Self {
        Self { tolerance: 1e-11, sweeps: 20_000 }
    }
}

impl DiscGaussSeidel {
    /// Sets the tolerance: violations of the normal conditions relative to the greatest
    /// displacement, and of the friction law relative to the greatest friction limit.
    ///
    /// # Errors
    /// [`RangeError`] unless it is in the range 1e-13 to 0.01.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        check_tolerance(tolerance)?;
        Ok(Self { tolerance, ..self })
    }

    /// Limits the number of sweeps.
    #[must_use]
    pub const fn at_most(self, sweeps: usize) -> Self {
        Self { sweeps, ..self }
    }
}

/// The working memory of [`DiscGaussSeidel`].
#[derive(Clone)]
pub struct DiscScratch {
    influence: Influence,
    outcome: Outcome,
    changes: Vec<f64>,
}

impl DiscScratch {
    /// The largest change of a traction in each sweep of the last step, relative to the largest
    /// pressure.
    #[must_use]
    pub fn changes(&self) -> &[f64] {
        &self.changes
    }

    /// One sweep, or a part of it if it is interrupted; returns the largest change relative to the largest pressure.
    fn sweep(&mut self, demand: &Demand) -> f64 {
        let own = self.influence.own();
        let (mut change, mut top) = (0.0_f64, f64::MIN_POSITIVE);
        for cell in 0..self.outcome.cells.len() {
            if interrupt::is_wanted() {
                break;
            }
            let outcome = &mut self.outcome;
            // A cell without a body is never in contact.
            if demand.target[2][cell] == f64::NEG_INFINITY {
                continue;
            }
            let found = |axis| self.influence.displacement(axis, cell, &outcome.traction);
            let missing = |axis: usize| demand.target[axis][cell] - found(axis);
            let before = [0, 1, 2].map(|axis| outcome.traction[axis][cell]);
            let pressure = (before[2] + missing(2) / own[2]).max(0.0);
            let limit = demand.limit(cell, pressure);
            let mut tangent = [0.0; 2];
            if limit > 0.0 {
                let free = [0, 1].map(|axis| own[axis] * before[axis] + missing(axis));
                tangent = on_disc(free, [own[0], own[1]], limit);
            }
            for (axis, now) in [tangent[0], tangent[1], pressure].into_iter().enumerate() {
                outcome.traction[axis][cell] = now;
                change = change.max((now - before[axis]).abs());
            }
            let sticks = limit > 0.0 && tangent[0].hypot(tangent[1]) < limit * (1.0 - 1e-12);
            outcome.cells[cell] = match (pressure > 0.0, sticks) {
                (false, _) => CellState::Exterior,
                (true, true) => CellState::Stick,
                (true, false) => CellState::Slip,
            };
            top = top.max(pressure);
        }
        change / top
    }
}

/// The traction t within the disc of this radius that is closest in energy to the solution of a_i
/// t_i = free_i: t_i = free_i/(a_i + m), with m = 0 inside the disc and otherwise such that |t| is
/// the radius.
fn on_disc(free: [f64; 2], own: [f64; 2], radius: f64) -> [f64; 2] {
    let at = |more: f64| [free[0] / (own[0] + more), free[1] / (own[1] + more)];
    let mut more = 0.0;
    let mut t = at(more);
    if t[0].hypot(t[1]) <= radius {
        return t;
    }
    // Newton's method for 1/|t| = 1/radius, which is concave in m: a few steps from below.
    for _ in 0..50 {
        let size = t[0].hypot(t[1]);
        let falling = t[0] * t[0] / (own[0] + more) + t[1] * t[1] / (own[1] + more);
        let step = (size / radius - 1.0) * size * size / falling;
        more += step;
        t = at(more);
        if step.abs() <= 1e-16 * more {
            break;
        }
    }
    let size = t[0].hypot(t[1]);
    t.map(|part| part * radius / size)
}

impl Method for DiscGaussSeidel {
    type Error = DirectError;
    type Scratch = DiscScratch;

    fn scratch(&self, problem: &ContactProblem) -> Result<DiscScratch, DirectError> {
        Demand::check(problem)?;
        let outcome = Outcome::new(problem.grid().cells());
        Ok(DiscScratch {
            influence: Influence::new(problem.operator())?,
            outcome,
            changes: Vec::new(),
        })
    }

    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut DiscScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, DirectError> {
        let demand = Demand::new(problem, scratch.influence.own(), from, drive)?;
        scratch.changes.clear();
        if let Some(convergence) = apart(problem, drive, from, to) {
            return Ok(convergence);
        }
        scratch.outcome.start(from);
        let mut residuals = Residuals::default();
        let mut stop = Stop::Exhausted;
        for iteration in 1..=self.sweeps {
            let change = scratch.sweep(&demand);
            scratch.changes.push(change);
            let goes_on = iteration < self.sweeps && !interrupt::is_wanted();
            if change > self.tolerance && goes_on {
                continue;
            }
            let Outcome { traction, displacement, .. } = &mut scratch.outcome;
            scratch.influence.displacements(traction, displacement);
            residuals = demand.residuals(traction, displacement);
            let touching = scratch.outcome.touching().count();
            let cells = problem.grid().cells();
            let progress = Progress { iteration, cells, touching, residuals };
            if observer.see(&progress).is_break() {
                stop = Stop::Observer;
                break;
            }
            if residuals.worst() <= self.tolerance {
                break;
            }
        }
        let (iterations, products) = (scratch.changes.len(), Products::default());
        let reached = Convergence { iterations, products, residuals, stop };
        scratch.outcome.end(End { tolerance: self.tolerance, reached, from, drive }, to)
    }
}

#[cfg(test)]
mod tests {
    use super::on_disc;

    #[test]
    fn on_the_rim_the_slip_opposes_the_traction() {
        for (free, own) in
            [([3.0, -2.0], [1.0, 1.3]), ([1e-3, 5.0], [1.0, 0.4]), ([0.0, 2.0], [1.0, 1.0])]
        {
            let t = on_disc(free, own, 0.7);
            assert!((t[0].hypot(t[1]) - 0.7).abs() < 1e-15);
            let slip = [own[0] * t[0] - free[0], own[1] * t[1] - free[1]];
            assert!((slip[0] * t[1] - slip[1] * t[0]).abs() < 1e-14);
            assert!(slip[0] * t[0] + slip[1] * t[1] < 0.0);
        }
        assert_eq!(on_disc([0.1, 0.2], [1.0, 2.0], 0.7), [0.1, 0.1]);
    }
}
