//! Chooses the window and the cell width for a required accuracy.

use carom_halfspace::Grid;
use carom_special::RangeError;

use super::estimate::Estimates;
use super::grid_warning::{GridWarning, Side};
use super::history::{NestedError, NestedHistory};
use super::reach::Errors;
use super::span::Span;
use super::window::Window;
use crate::drive::{Drive, Driven};
use crate::frictionless::{Frictionless, NormalError};
use crate::method::Method;
use crate::problem::{ContactProblem, ProblemError};
use crate::state::ContactState;

/// Cells along a side of the pilot grid; odd, so that one cell has its centre in the middle.
const PILOT_CELLS: usize = 49;
/// Number of windows tried before the contact is taken to be unbounded.
const MOST_WINDOWS: usize = 90;
/// A contact that fills less than this fraction of the pilot window is solved again on a smaller
/// window.
const SMALL_FRACTION: f64 = 0.25;
/// Cells along a side of the first grid of the history.
pub(super) const FIRST_CELLS: usize = 48;
/// Cells kept free on each side of the contact: one cell of the coarsest grid.
pub(crate) const FREE_CELLS: usize = 4;
/// Bounds on the order of convergence: the error falls with this power of the cell width.
const CONVERGENCE_ORDERS: [f64; 2] = [0.5, 2.0];

/// Solves a history to a required accuracy instead of on a given grid. Window and cell width are
/// chosen so that the estimated error of every load and shift that follows from the drives, in
/// every step, is at most this fraction of the greatest value of its kind in the history.
/// Tangential values are compared with at least a hundredth of the normal ones.
///
/// A pilot solve without friction on a coarse grid locates the contact. Its window is doubled and
/// moved if the contact reaches a side, and reduced if the contact fills little of it. The history
/// is then solved on nested grids, and repeated on finer ones until the error estimates are small
/// enough. If the contact reaches a side during the history, that side is moved outwards.
///
/// Under the edge of a punch errors fall at most in proportion to the cell width: an accuracy that would need too
/// many cells is then refused after two grids, with one that is within reach ([`FitError::Unreached`]). One that the
/// greatest number of cells would just reach may be refused, too: these errors fall in jumps.
///
/// Errors of pressures and areas are estimated but not controlled: pressures may be infinite under
/// edges and tips, and areas are counted in whole cells.
///
/// ```
/// use carom_halfspace::operator::OperatorError;
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::friction::Friction;
/// use carom_solver::{Accuracy, ContactProblem, Drive, Driven, Frictionless, Window};
/// let body = Material::from_young(200e9, 0.3)?;
/// let pair = MaterialPair::new(body, body)?;
/// let make = |window: &Window| {
///     let gap = window.gap(|x, y| 50.0 * (x * x + y * y)).map_err(OperatorError::from)?;
///     ContactProblem::of_half_spaces(gap, pair, Friction::NONE)
/// };
/// // Any window that contains the contact will do as a start.
/// let start = [1.0, 1.0];
/// let pressed = Drive { normal: Driven::Load(10.0), ..Drive::default() };
/// let fit = Accuracy::new(1e-3)?.fit(Frictionless::default(), make, start, &[pressed])?;
/// // Hertz, R = 1 cm: zeta^3 = 9 F^2/(16 R E*^2), E* = E/(2 (1 - nu^2)).
/// let modulus: f64 = 200e9 / (2.0 * 0.91);
/// let exact = (9.0 / 16.0 * 100.0 / (0.01 * modulus * modulus)).cbrt();
/// assert!((fit.history.state().shift.zeta / exact - 1.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy {
    pub(super) wanted: f64,
    pub(super) most: usize,
}

/// A history on a window and cells that meet the required accuracy.
pub struct Fit<M: Method> {
    /// The window and its grid.
    pub window: Window,
    /// The history, after its last step.
    pub history: NestedHistory<M>,
    /// Loads, shifts and areas with their estimated errors, after each drive.
    pub estimates: Vec<Estimates>,
    /// The greatest relative error of the history.
    pub error: f64,
}

/// Why no window meets the required accuracy.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FitError<E> {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// A problem could not be built.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// The pilot solve for the place of the contact failed.
    #[error(transparent)]
    Pilot(NormalError),
    /// A step of the history failed, on every grid that was tried.
    #[error(transparent)]
    Method(E),
    /// No window was found that contains the contact without being much too large.
    #[error("no window that fits the contact was found in {tried} trials")]
    NoWindow {
        /// Number of windows tried.
        tried: usize,
    },
    /// The contact reaches the border of every window: it is unbounded.
    #[error("the contact reaches the {side} border of every window")]
    Endless {
        /// The border that it reaches.
        side: Side,
    },
    /// The accuracy would need more cells than allowed.
    #[error(
        "with {cells} x {cells} cells the estimated error is {reached:.1e}, above {wanted:.1e}; \
         a grid that is fine enough would have more than {most} cells; an accuracy of {possible:.1e} is within reach"
    )]
    Unreached {
        /// The required accuracy.
        wanted: f64,
        /// The estimated error on the last grid.
        reached: f64,
        /// Cells along a side of the last grid.
        cells: usize,
        /// The greatest number of cells allowed.
        most: usize,
        /// An accuracy that should be reached with the greatest number of cells.
        possible: f64,
    },
}

impl Accuracy {
    /// Requires this relative accuracy, with at most 2^20 cells.
    ///
    /// # Errors
    /// [`RangeError`] unless it lies in 1e-6 to 0.1.
    pub fn new(accuracy: f64) -> Result<Self, RangeError> {
        let holds = (1e-6..=0.1).contains(&accuracy);
        RangeError::check("accuracy", accuracy, holds, "from 1e-6 to 0.1")?;
        Ok(Self { wanted: accuracy, most: 1 << 20 })
    }

    /// Sets the greatest number of cells.
    #[must_use]
    pub const fn at_most(self, cells: usize) -> Self {
        Self { most: cells, ..self }
    }

    /// Follows the drives on a window that fits. `make` builds the problem on a given window.
    /// `sides` are those of a first window about the origin, which need only contain part of the
    /// body. If any drive twists the contact, the window stays centred at the origin; otherwise it
    /// may move, and torques are taken about its centre.
    ///
    /// # Errors
    /// [`FitError`].
    pub fn fit<M: Method + Clone>(
        &self,
        method: M,
        make: impl Fn(&Window) -> Result<ContactProblem, ProblemError>,
        sides: [f64; 2],
        drives: &[Drive],
    ) -> Result<Fit<M>, FitError<M::Error>> {
        for drive in drives {
            drive.check()?;
        }
        let twists = drives.iter().any(|drive| drive.twist != Driven::Shift(0.0));
        let start = Span::about_origin(sides)?;
        let mut span: Option<Span> = None;
        for drive in hardest(drives) {
            let found = pilot(&make, start, &drive, twists)?;
            span = span.map_or(found, |span| found.map(|found| span.joined(&found)).or(Some(span)));
        }
        // Bodies that never touch fit any window.
        let mut span = span.unwrap_or(start);
        let (mut cells, mut before): (usize, Option<[f64; 2]>) = (FIRST_CELLS, None);
        loop {
            let window = span.window(cells, FREE_CELLS)?;
            let mut run = Run::begin(method.clone(), &make, window)?;
            let reached = match run.follow(drives) {
                Ok(reached) => reached,
                // On a coarse grid a step may fail that succeeds on a finer one.
                Err(error) if 16 * cells * cells > self.most => {
                    return Err(FitError::Method(error));
                }
                Err(_) => Reached::Nothing,
            };
            let finer = match reached {
                Reached::Border(side) => {
                    span = span.moved(side, 0.1, twists);
                    if !span.is_sensible() {
                        return Err(FitError::Endless { side });
                    }
                    continue;
                }
                Reached::Nothing => 2 * cells,
                Reached::End(Errors { all: error, .. }) if error <= self.wanted => {
                    let (history, estimates) = (run.history, run.estimates);
                    return Ok(Fit { window, history, estimates, error });
                }
                Reached::End(errors) => {
                    let next = finer(cells, errors.all, before, self.wanted);
                    if self.is_out_of_reach([cells, next], before.is_none(), errors) {
                        return Err(self.unreached(cells, errors));
                    }
                    before = Some([cells as f64, errors.all]);
                    next
                }
            };
            span = run.seen.map_or(span, |seen| seen.kept(twists));
            cells = finer;
        }
    }
}

/// The drives with the greatest approach and with the greatest normal force.
fn hardest(drives: &[Drive]) -> impl Iterator<Item = Drive> {
    let most = |is: fn(&Driven) -> bool| {
        let normals = drives.iter().map(|drive| drive.normal).filter(is);
        normals.max_by(|one, other| one.value().total_cmp(&other.value()))
    };
    let both = [most(|d| matches!(d, Driven::Shift(_))), most(|d| matches!(d, Driven::Load(_)))];
    both.into_iter().flatten().map(|normal| Drive { normal, ..Drive::default() })
}

/// The number of cells along a side expected to be sufficient, from the error on the present and on
/// the previous grid; a multiple of four.
pub(super) fn finer(cells: usize, error: f64, before: Option<[f64; 2]>, wanted: f64) -> usize {
    let order = before.map_or(1.5, |[cells_before, error_before]| {
        libm::log(error_before / error) / libm::log(cells as f64 / cells_before)
    });
    let order = if order.is_nan() {
        CONVERGENCE_ORDERS[0]
    } else {
        order.clamp(CONVERGENCE_ORDERS[0], CONVERGENCE_ORDERS[1])
    };
    let times = 1.1 * libm::pow(error / wanted, 1.0 / order);
    let times = if times.is_nan() { 2.0 } else { times.clamp(1.25, 4.0) };
    fast((times * cells as f64) as usize)
}

/// The next multiple of sixteen that has no prime factors but 2 and 3: fast lengths of the FFT.
fn fast(least: usize) -> usize {
    let mut cells = least.next_multiple_of(16);
    loop {
        let mut rest = cells;
        for factor in [2, 3] {
            while rest.is_multiple_of(factor) {
                rest /= factor;
            }
        }
        if rest == 1 {
            return cells;
        }
        cells += 16;
    }
}

/// Where the contact of a drive lies, solved without friction; `None` if the bodies are separated.
fn pilot<E>(
    make: &impl Fn(&Window) -> Result<ContactProblem, ProblemError>,
    start: Span,
    drive: &Drive,
    twists: bool,
) -> Result<Option<Span>, FitError<E>> {
    let method = Frictionless::default().within(1e-4)?;
    let mut span = start;
    let mut reached = None;
    for _ in 0..MOST_WINDOWS {
        let window = span.window(PILOT_CELLS, 0)?;
        let problem = make(&window)?.without_friction();
        if problem.apart(drive.normal).is_some() {
            // The closest point may lie between the cell centres.
            span = Span::around_lowest(&problem, &window).kept(twists);
            if !span.is_sensible() {
                return Ok(None);
            }
            continue;
        }
        let (mut state, apart) =
            (ContactState::apart(window.grid()), ContactState::apart(window.grid()));
        let mut scratch = method.scratch(&problem).map_err(FitError::Pilot)?;
        method
            .step(&problem, &apart, drive, &mut state, &mut scratch, &mut ())
            .map_err(FitError::Pilot)?;
        let Some(found) = Span::touching(&state, &window) else { return Ok(None) };
        if let Some(side) = border(&state) {
            reached = Some(side);
            span = span.moved(side, 1.0, twists);
            if !span.is_sensible() {
                break;
            }
        } else if found.kept(twists).is_small_in(&span, SMALL_FRACTION) {
            span = found.kept(twists).widened(1.0);
        } else {
            return Ok(Some(found.kept(twists)));
        }
    }
    Err(reached
        .map_or(FitError::NoWindow { tried: MOST_WINDOWS }, |side| FitError::Endless { side }))
}

/// The side of the window that the contact reaches.
pub(crate) fn border(state: &ContactState) -> Option<Side> {
    state.warnings().into_iter().find_map(|grid_warning| match grid_warning {
        GridWarning::Border { side } => Some(side),
        GridWarning::FewCells { .. } | GridWarning::LargeDisplacement { .. } => None,
    })
}

/// A history on one window.
pub(super) struct Run<M: Method> {
    window: Window,
    pub(super) history: NestedHistory<M>,
    pub(super) estimates: Vec<Estimates>,
    /// The region that was in contact in any step so far.
    seen: Option<Span>,
    /// Whether the pressure is greatest at an edge, after each drive.
    edges: Vec<bool>,
}

/// How the history on one window ended.
pub(super) enum Reached {
    Border(Side),
    /// The history is complete, but there are no error estimates.
    Nothing,
    End(Errors),
}

impl<M: Method> Run<M> {
    pub(super) fn begin(
        method: M,
        make: &impl Fn(&Window) -> Result<ContactProblem, ProblemError>,
        window: Window,
    ) -> Result<Self, FitError<M::Error>> {
        let history =
            NestedHistory::new(method, window.grid(), |grid: Grid| make(&window.with(grid)));
        let history = history.map_err(|error| match error {
            NestedError::Problem(error) => FitError::Problem(error),
            NestedError::Method(error) => FitError::Method(error),
        })?;
        Ok(Self { window, history, estimates: Vec::new(), seen: None, edges: Vec::new() })
    }

    pub(super) fn follow(&mut self, drives: &[Drive]) -> Result<Reached, M::Error> {
        for drive in drives {
            self.history.step(drive, &mut ())?;
            let state = self.history.state();
            if let Some(side) = border(state) {
                return Ok(Reached::Border(side));
            }
            let found = Span::touching(state, &self.window);
            self.seen = match (self.seen, found) {
                (Some(seen), Some(found)) => Some(seen.joined(&found)),
                (seen, found) => seen.or(found),
            };
            self.edges.push(state.has_a_pressed_edge());
            match self.history.estimates() {
                Some(estimates) => self.estimates.push(estimates),
                None => return Ok(Reached::Nothing),
            }
        }
        Ok(Reached::End(self.errors()))
    }

    fn errors(&self) -> Errors {
        let each = || Estimates::worst_of_each(&self.estimates);
        let at_edges = each().zip(&self.edges).filter(|(_, edge)| **edge).map(|(error, _)| error);
        Errors { all: each().fold(0.0, f64::max), at_edges: at_edges.fold(0.0, f64::max) }
    }
}
