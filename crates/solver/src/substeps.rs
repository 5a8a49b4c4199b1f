//! Steps divided until their loads settle.

use carom_special::RangeError;

use crate::convergence::{Convergence, Observer, Residuals};
use crate::drive::{Drive, Driven};
use crate::method::Method;
use crate::problem::ContactProblem;
use crate::state::ContactState;

/// Another method whose steps are halved, and halved again, where they fail and until halving
/// changes the loads by no more than a tolerance. The way from one drive to the next is straight.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{friction::Friction, law::Shift};
/// use carom_solver::{ContactProblem, ContactState, Drive, Frictional, Gap, Method, Substepped};
/// let grid = Grid::new(24, 24, 0.1, 0.1)?;
/// let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y))?;
/// let soft = Material::from_shear(1.0, 0.0)?;
/// let pair = MaterialPair::new(soft, Material::RIGID)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3)?)?;
/// let method = Substepped::new(Frictional::default(), 1e-2)?;
/// let (apart, mut scratch) = (ContactState::apart(grid), method.scratch(&problem)?);
/// let mut state = apart.clone();
/// let drive = Drive::by_shift(Shift { zeta: 1.0, xi: 0.1, ..Shift::default() });
/// method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Substepped<M> {
    method: M,
    tolerance: f64,
    halvings: u32,
}

/// Why a divided step failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SubstepError<E> {
    /// The smallest steps failed too.
    #[error(transparent)]
    Step(#[from] E),
    /// The loads do not settle.
    #[error(
        "halving the steps {halvings} times, the loads still change by {change:.1e} of the greatest \
         force, above {tolerance:.1e}"
    )]
    Unsettled {
        /// The change by the last halving, over the greatest force.
        change: f64,
        /// The tolerance.
        tolerance: f64,
        /// How often the step was halved.
        halvings: u32,
    },
}

impl<M> Substepped<M> {
    /// Steps of `method` to a tolerance: the change of the loads by halving, over the normal force.
    /// A step is divided into at most 2^12 ones.
    ///
    /// # Errors
    /// [`RangeError`] unless the tolerance is positive. An infinite one divides only what fails.
    pub fn new(method: M, tolerance: f64) -> Result<Self, RangeError> {
        RangeError::check("tolerance", tolerance, tolerance > 0.0, "> 0")?;
        Ok(Self { method, tolerance, halvings: 12 })
    }

    /// Divided into at most 2^`halvings` steps.
    #[must_use]
    pub fn at_most(self, halvings: u32) -> Self {
        Self { halvings, ..self }
    }
}

/// What all steps of a way share.
struct Way<'a, M: Method> {
    method: &'a M,
    problem: &'a ContactProblem,
    tolerance: f64,
    halvings: u32,
    scratch: &'a mut M::Scratch,
    observer: &'a mut dyn Observer,
    went: Option<Convergence>,
}

impl<M: Method> Method for Substepped<M> {
    type Error = SubstepError<M::Error>;
    type Scratch = M::Scratch;

    fn scratch(&self, problem: &ContactProblem) -> Result<M::Scratch, Self::Error> {
        Ok(self.method.scratch(problem)?)
    }

    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut M::Scratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, Self::Error> {
        let (method, tolerance, halvings) = (&self.method, self.tolerance, self.halvings);
        let mut way = Way { method, problem, tolerance, halvings, scratch, observer, went: None };
        let last = way.step(from, drive, to);
        if self.tolerance.is_infinite() && last.is_ok() {
            return Ok(last?);
        }
        way.halve(from, drive, last, to, 1)?;
        // Every way has a step.
        way.went.map_or_else(|| way.step(from, drive, to).map_err(Into::into), Ok)
    }
}

impl<M: Method> Way<'_, M> {
    fn step(
        &mut self,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
    ) -> Result<Convergence, M::Error> {
        self.method.step(self.problem, from, drive, to, self.scratch, self.observer)
    }

    /// Goes from `from` to `drive` in two steps, in more where that differs from the one whose
    /// result is in `to`.
    fn halve(
        &mut self,
        from: &ContactState,
        drive: &Drive,
        whole: Result<Convergence, M::Error>,
        to: &mut ContactState,
        depth: u32,
    ) -> Result<(), SubstepError<M::Error>> {
        if depth > self.halvings {
            whole?;
            let (tolerance, halvings) = (self.tolerance, self.halvings);
            return Err(SubstepError::Unsettled { change: f64::NAN, tolerance, halvings });
        }
        let middle = halfway(from, drive);
        let (mut half, mut end) = (from.clone(), from.clone());
        let first = self.step(from, &middle, &mut half);
        let halves = match &first {
            Ok(part) => self.step(&half, drive, &mut end).ok().map(|second| [*part, second]),
            Err(_) => None,
        };
        let change = match (&whole, &halves) {
            (Ok(_), Some(_)) => difference(to, &end),
            // Two steps where one fails are all that is asked for.
            (Err(_), Some(_)) if self.tolerance.is_infinite() => 0.0,
            _ => f64::INFINITY,
        };
        if let Some(parts) = halves
            && change <= self.tolerance
        {
            parts.into_iter().for_each(|part| self.add(part));
            to.clone_from(&end);
            return Ok(());
        }
        if depth == self.halvings && change.is_finite() {
            let (tolerance, halvings) = (self.tolerance, self.halvings);
            return Err(SubstepError::Unsettled { change, tolerance, halvings });
        }
        self.halve(from, &middle, first, &mut half, depth + 1)?;
        let second = self.step(&half, drive, to);
        self.halve(&half, drive, second, to, depth + 1)
    }

    fn add(&mut self, part: Convergence) {
        self.went = Some(self.went.map_or(part, |sum| Convergence {
            iterations: sum.iterations + part.iterations,
            products: sum.products.plus(part.products),
            residuals: Residuals {
                normal: sum.residuals.normal.max(part.residuals.normal),
                tangential: sum.residuals.tangential.max(part.residuals.tangential),
            },
            stop: part.stop,
        }));
    }
}

/// The drive half way from a state.
fn halfway(from: &ContactState, drive: &Drive) -> Drive {
    let (shift, load) = (from.shift, from.load());
    let middle = |driven, shift: f64, load: f64| match driven {
        Driven::Shift(next) => Driven::Shift(0.5 * (shift + next)),
        Driven::Load(next) => Driven::Load(0.5 * (load + next)),
    };
    Drive {
        normal: middle(drive.normal, shift.zeta, load.f_z),
        x: middle(drive.x, shift.xi, load.f_x),
        y: middle(drive.y, shift.eta, load.f_y),
        twist: middle(drive.twist, shift.omega, load.m_z),
    }
}

/// The greatest difference of the forces over the greatest force; torques count by the radius of a
/// disc with the area in contact.
fn difference(one: &ContactState, other: &ContactState) -> f64 {
    let (a, b) = (one.load(), other.load());
    let grid = one.pressure.grid();
    let touching = one.pressure.values().iter().filter(|p| **p > 0.0).count().max(1);
    let radius = (touching as f64 * grid.cell_area() / std::f64::consts::PI).sqrt();
    let scale = a.f_z.max(b.f_z);
    let moved = [a.f_x - b.f_x, a.f_y - b.f_y, a.f_z - b.f_z, (a.m_z - b.m_z) / radius];
    let most = moved.into_iter().fold(0.0_f64, |most, change| most.max(change.abs()));
    if most == 0.0 { 0.0 } else { most / scale }
}
