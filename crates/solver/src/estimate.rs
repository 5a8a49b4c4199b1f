//! How wrong a solution is by its mesh: the same history on three grids.

use carom_halfspace::Grid;
use carom_special::RangeError;

use crate::drive::Drive;
use crate::method::Method;
use crate::problem::{ContactProblem, ProblemError};
use crate::state::{CellState, ContactState};
use crate::{Convergence, Observer};

/// Fewer cells than this across a contact are too few.
const FEW: usize = 10;
/// Differences of successive grids fall at least by this factor, at most as the square of the width.
const FALL: [f64; 2] = [1.5, 4.0];

/// A value on the finest grid with an estimate of its error by the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Estimated {
    /// The value.
    pub value: f64,
    /// The estimated size of its error.
    pub error: f64,
}

impl Estimated {
    /// From the values on the finest grid and on those of twice and four times the width
    /// (Richardson): differences of successive grids fall with the measured order, kept between
    /// that of 1.5 and of 4 a halving. A difference that vanishes by accident is not believed.
    #[must_use]
    pub fn of(values: [f64; 3]) -> Self {
        let (fine, coarse) = ((values[0] - values[1]).abs(), (values[1] - values[2]).abs());
        let fall = if fine > 0.0 { (coarse / fine).clamp(FALL[0], FALL[1]) } else { FALL[1] };
        let error = fine.max(coarse / FALL[1]) / (fall - 1.0);
        Self { value: values[0], error }
    }
}

impl Estimated {
    /// The same where tractions are greatest at an edge that the grid fixes: the edge lies within
    /// part of a cell of its place, which makes errors of the first order, in leaps.
    #[must_use]
    pub fn of_edge(values: [f64; 3]) -> Self {
        let (fine, coarse) = ((values[0] - values[1]).abs(), (values[1] - values[2]).abs());
        Self { value: values[0], error: fine.max(0.5 * coarse) }
    }
}

/// A side of the window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// That of the lowest x.
    Left,
    /// That of the greatest x.
    Right,
    /// That of the lowest y.
    Bottom,
    /// That of the greatest y.
    Top,
}

/// What casts doubt on a solution.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Doubt {
    /// The contact is cut off by the window.
    #[error("the contact reaches the {side:?} border of the window")]
    Border {
        /// Where.
        side: Side,
    },
    /// The contact is only a few cells wide.
    #[error("the contact is {across} cells wide, fewer than {FEW}")]
    FewCells {
        /// Its width along its narrower direction.
        across: usize,
    },
}

impl ContactState {
    /// The columns and rows between which cells touch: first and last of each; none apart.
    #[must_use]
    pub fn extent(&self) -> Option<[[usize; 2]; 2]> {
        let grid = self.pressure.grid();
        let mut extent: Option<[[usize; 2]; 2]> = None;
        for (i, pressure) in self.pressure.values().iter().enumerate() {
            if *pressure > 0.0 {
                let at = [i % grid.nx(), i / grid.nx()];
                let [x, y] = extent.unwrap_or([[at[0]; 2], [at[1]; 2]]);
                let wider = |[a, b]: [usize; 2], at: usize| [a.min(at), b.max(at)];
                extent = Some([wider(x, at[0]), wider(y, at[1])]);
            }
        }
        extent
    }

    /// What casts doubt on this state: a contact that reaches the border of the grid, or fewer than
    /// ten cells wide.
    #[must_use]
    pub fn doubts(&self) -> Vec<Doubt> {
        let (grid, Some([x, y])) = (self.pressure.grid(), self.extent()) else {
            return Vec::new();
        };
        let sides = [
            (x[0] == 0, Side::Left),
            (x[1] + 1 == grid.nx(), Side::Right),
            (y[0] == 0, Side::Bottom),
            (y[1] + 1 == grid.ny(), Side::Top),
        ];
        let mut doubts: Vec<Doubt> = sides
            .iter()
            .filter(|(at, _)| *at)
            .map(|(_, side)| Doubt::Border { side: *side })
            .collect();
        let across = (x[1] - x[0] + 1).min(y[1] - y[0] + 1);
        if across < FEW {
            doubts.push(Doubt::FewCells { across });
        }
        doubts
    }

    /// Whether a traction is greatest in a cell at the border of the contact, as under a punch.
    fn peaks_at_the_edge(&self, traction: impl Fn(usize) -> f64) -> bool {
        let grid = self.pressure.grid();
        let values = (0..grid.cells()).map(|i| (i, traction(i)));
        let Some((top, most)) = values.max_by(|one, other| one.1.total_cmp(&other.1)) else {
            return false;
        };
        let (column, row) = (top % grid.nx(), top / grid.nx());
        let apart = |x: Option<usize>, y: Option<usize>| {
            let pressure = x.zip(y).and_then(|(x, y)| self.pressure.get(x, y));
            pressure.is_none_or(|pressure| *pressure == 0.0)
        };
        let beside = apart(column.checked_sub(1), Some(row))
            || apart(Some(column + 1), Some(row))
            || apart(Some(column), row.checked_sub(1))
            || apart(Some(column), Some(row + 1));
        most > 0.0 && beside
    }

    /// The greatest pressure, on parabolas through the highest cell and its neighbours along both
    /// axes where all of them touch.
    #[must_use]
    pub fn peak_pressure(&self) -> f64 {
        let (grid, p) = (self.pressure.grid(), self.pressure.values());
        let Some((top, peak)) = p.iter().enumerate().max_by(|one, other| one.1.total_cmp(other.1))
        else {
            return 0.0;
        };
        let (column, row) = (top % grid.nx(), top / grid.nx());
        let rise = |at: usize, count: usize, step: usize| {
            if at == 0 || at + 1 == count {
                return 0.0;
            }
            let (before, after) = (p[top - step], p[top + step]);
            let bend = 2.0 * peak - before - after;
            let counts = before > 0.0 && after > 0.0 && bend > 0.0;
            if counts { (after - before) * (after - before) / (8.0 * bend) } else { 0.0 }
        };
        peak + rise(column, grid.nx(), 1) + rise(row, grid.ny(), grid.nx())
    }
}

/// The loads, shifts and areas of a state with their errors by the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Estimates {
    /// Force along x.
    pub f_x: Estimated,
    /// Force along y.
    pub f_y: Estimated,
    /// Normal force.
    pub f_z: Estimated,
    /// Torque.
    pub m_z: Estimated,
    /// Approach, which has an error where the force is given.
    pub zeta: Estimated,
    /// Shift along x.
    pub xi: Estimated,
    /// Shift along y.
    pub eta: Estimated,
    /// Twist.
    pub omega: Estimated,
    /// The greatest pressure.
    pub peak: Estimated,
    /// The area that touches; its error is at least that of half a ring of cells.
    pub contact_area: Estimated,
    /// The area that sticks; its error is at least that of half a ring of cells.
    pub stick_area: Estimated,
}

/// A history on a grid and on two coarser ones, for a third more than on the one.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{friction::Friction, law::Shift};
/// use carom_solver::{ContactProblem, Drive, Frictional, Gap, NestedHistory};
/// let body = Material::from_shear(2.0, 0.3)?;
/// let pair = MaterialPair::new(body, body)?;
/// let make = |grid: Grid| {
///     let gap = Gap::sphere(grid, 100.0).map_err(carom_halfspace::operator::OperatorError::from)?;
///     ContactProblem::of_half_spaces(gap, pair, Friction::NONE)
/// };
/// let grid = Grid::new(64, 64, 0.04, 0.04)?;
/// let mut history = NestedHistory::new(Frictional::default(), grid, make)?;
/// history.step(&Drive::by_shift(Shift { zeta: 0.01, ..Shift::default() }), &mut ())?;
/// let force = history.estimates().f_z;
/// let exact = 4.0 / 3.0 * (2.0 / 0.7) * 0.01;
/// assert!((force.value - exact).abs() < 4.0 * force.error && force.error < 1e-3 * exact);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct NestedHistory<M: Method> {
    method: M,
    levels: [Level<M>; 3],
}

struct Level<M: Method> {
    problem: ContactProblem,
    state: ContactState,
    scratch: M::Scratch,
}

/// Why a history on three grids cannot begin.
#[derive(Debug, thiserror::Error)]
pub enum NestedError<E> {
    /// A problem cannot be built.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// A grid is out of range.
    #[error(transparent)]
    Range(RangeError),
    /// The method does not take the problem.
    #[error(transparent)]
    Method(E),
}

impl<M: Method> NestedHistory<M> {
    /// Bodies apart, on `grid` and on two coarser ones, for each of which `make` makes the problem.
    ///
    /// # Errors
    /// [`NestedError`] of the problems and the method.
    pub fn new(
        method: M,
        grid: Grid,
        make: impl Fn(Grid) -> Result<ContactProblem, ProblemError>,
    ) -> Result<Self, NestedError<M::Error>> {
        let level = |grid: Grid| -> Result<Level<M>, NestedError<M::Error>> {
            let problem = make(grid)?;
            let scratch = method.scratch(&problem).map_err(NestedError::Method)?;
            Ok(Level { state: ContactState::apart(problem.grid()), problem, scratch })
        };
        let coarse = grid.coarser().map_err(NestedError::Range)?;
        let coarsest = coarse.coarser().map_err(NestedError::Range)?;
        let levels = [level(grid)?, level(coarse)?, level(coarsest)?];
        Ok(Self { method, levels })
    }

    /// Goes on to the end of a step on all grids.
    ///
    /// # Errors
    /// The method's; all states are then as they were.
    pub fn step(
        &mut self,
        drive: &Drive,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, M::Error> {
        let mut next = self.levels.each_ref().map(|level| level.state.clone());
        let mut went = None;
        for (level, to) in self.levels.iter_mut().zip(&mut next).rev() {
            let (problem, from) = (&level.problem, &level.state);
            went =
                Some(self.method.step(problem, from, drive, to, &mut level.scratch, observer)?);
        }
        for (level, state) in self.levels.iter_mut().zip(next) {
            level.state = state;
        }
        Ok(went.unwrap_or_else(|| unreachable!("there are three levels")))
    }

    /// The state on the finest grid.
    #[must_use]
    pub const fn state(&self) -> &ContactState {
        &self.levels[0].state
    }

    /// Its values with their errors by the mesh.
    #[must_use]
    pub fn estimates(&self) -> Estimates {
        let state = self.state();
        let [p, x, y] = [&state.pressure, &state.traction_x, &state.traction_y].map(|f| f.values());
        let normal_edge = state.peaks_at_the_edge(|i| p[i]);
        let tangential_edge = normal_edge || state.peaks_at_the_edge(|i| x[i].hypot(y[i]));
        let by = |edge: bool, value: &dyn Fn(&ContactState) -> f64| {
            let values = self.levels.each_ref().map(|level| value(&level.state));
            if edge { Estimated::of_edge(values) } else { Estimated::of(values) }
        };
        let of = |value: &dyn Fn(&ContactState) -> f64| by(normal_edge, value);
        let along = |value: &dyn Fn(&ContactState) -> f64| by(tangential_edge, value);
        let area = |outlines: &dyn Fn(&ContactState) -> Vec<crate::Contour>| {
            let estimated = of(&|state| outlines(state).iter().map(crate::Contour::area).sum());
            let cell = self.state().pressure.grid().cell_area().sqrt();
            let ring: f64 = outlines(self.state()).iter().map(crate::Contour::length).sum();
            Estimated { error: estimated.error.max(0.5 * ring * cell), ..estimated }
        };
        Estimates {
            f_x: along(&|state| state.load().f_x),
            f_y: along(&|state| state.load().f_y),
            f_z: of(&|state| state.load().f_z),
            m_z: along(&|state| state.load().m_z),
            zeta: of(&|state| state.shift.zeta),
            xi: along(&|state| state.shift.xi),
            eta: along(&|state| state.shift.eta),
            omega: along(&|state| state.shift.omega),
            peak: of(&ContactState::peak_pressure),
            contact_area: area(&ContactState::contact_outlines),
            stick_area: if self.state().count(CellState::Stick) > 0 {
                area(&ContactState::stick_outlines)
            } else {
                Estimated::default()
            },
        }
    }
}
