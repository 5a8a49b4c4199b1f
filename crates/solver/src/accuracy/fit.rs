//! A window and cells that fit a contact, found from an accuracy.

use carom_halfspace::Grid;
use carom_special::RangeError;

use super::doubt::{Doubt, Side};
use super::estimate::Estimates;
use super::history::{NestedError, NestedHistory};
use super::span::Span;
use super::window::Window;
use crate::drive::{Drive, Driven};
use crate::frictionless::{Frictionless, NormalError};
use crate::method::Method;
use crate::problem::{ContactProblem, ProblemError};
use crate::state::ContactState;

/// Cells a side that look for the place of the contact; odd, so that one has its centre in the
/// middle.
const SCOUTS: usize = 49;
/// Windows that are tried before a contact counts as endless.
const TRIES: usize = 90;
/// Contacts that fill less than this part of the scouts' window are looked at more closely.
const SMALL: f64 = 0.25;
/// Cells a side of the first solution.
const FIRST: usize = 48;
/// Free cells on each side: one of the coarsest grid.
pub(crate) const FREE: usize = 4;
/// Errors fall with the cells' width at least and at most with this power.
const ORDERS: [f64; 2] = [0.5, 2.0];

/// An accuracy instead of a grid. Window and cells are chosen so that the estimated errors of all
/// loads and shifts that follow from the drives, in every step, are at most this part of the
/// greatest of their kind in the history (of tangential ones at least a hundredth of the normal one).
///
/// Scouts on a coarse grid without friction find the contact: their window doubles, and moves, where
/// the contact reaches a side, and shrinks to a contact that fills little of it. The history then
/// runs on nested grids, again on finer ones until the estimates are small enough; a side that the
/// contact reaches in it moves away.
///
/// Pressures may be infinite under edges and tips, and areas are counted in cells: their errors are
/// estimated, not asked for.
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
/// // Anything that holds the contact will do as a start.
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
    wanted: f64,
    most: usize,
}

/// A history on cells that fit.
pub struct Fit<M: Method> {
    /// The window and its cells.
    pub window: Window,
    /// The history, at its end.
    pub history: NestedHistory<M>,
    /// Values with their errors after each drive.
    pub estimates: Vec<Estimates>,
    /// The greatest of the errors, over what it is to be compared with.
    pub error: f64,
}

/// Why no window fits.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FitError<E> {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// A problem cannot be built.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// The scouts did not find the pressures.
    #[error(transparent)]
    Scouts(NormalError),
    /// A step cannot be solved, on any grid that was tried.
    #[error(transparent)]
    Method(E),
    /// No window was found that holds the contact and is not much larger.
    #[error("no window that fits the contact was found in {tried} trials")]
    NoWindow {
        /// The windows that were tried.
        tried: usize,
    },
    /// However large the window, the contact reaches its border.
    #[error("the contact reaches the {side:?} border of every window")]
    Endless {
        /// Where.
        side: Side,
    },
    /// The cells would be too many.
    #[error(
        "with {cells} x {cells} cells the estimated error is {reached:.1e}, above {wanted:.1e}; \
         the next grid would have more than {most} cells"
    )]
    Unreached {
        /// The accuracy.
        wanted: f64,
        /// The estimated error.
        reached: f64,
        /// Cells along a side.
        cells: usize,
        /// Cells that a grid may have.
        most: usize,
    },
}

impl Accuracy {
    /// This accuracy, with at most 2^20 cells.
    ///
    /// # Errors
    /// [`RangeError`] unless it lies in 1e-6 to 0.1.
    pub fn new(accuracy: f64) -> Result<Self, RangeError> {
        let holds = (1e-6..=0.1).contains(&accuracy);
        RangeError::check("accuracy", accuracy, holds, "from 1e-6 to 0.1")?;
        Ok(Self { wanted: accuracy, most: 1 << 20 })
    }

    /// With at most this many cells.
    #[must_use]
    pub const fn at_most(self, cells: usize) -> Self {
        Self { most: cells, ..self }
    }

    /// Follows the drives on a window that fits. `make` makes the problem on any window; `sides` of
    /// a first one about the origin need only hold part of the body. Where a drive twists, windows keep
    /// the origin in their middle; elsewhere they move, and torques count about their middle.
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
            let found = scout(&make, start, &drive, twists)?;
            span = span.map_or(found, |span| found.map(|found| span.joined(&found)).or(Some(span)));
        }
        // Bodies that never touch fit any window.
        let mut span = span.unwrap_or(start);
        let (mut cells, mut before): (usize, Option<[f64; 2]>) = (FIRST, None);
        loop {
            let window = span.window(cells, FREE)?;
            let mut run = Run::begin(method.clone(), &make, window)?;
            let reached = match run.follow(drives) {
                Ok(reached) => reached,
                // A coarse grid may lack what a step takes.
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
                Reached::End { error } if error <= self.wanted => {
                    let (history, estimates) = (run.history, run.estimates);
                    return Ok(Fit { window, history, estimates, error });
                }
                Reached::End { error } => {
                    let next = finer(cells, error, before, self.wanted);
                    if next * next > self.most {
                        let (reached, wanted, most) = (error, self.wanted, self.most);
                        return Err(FitError::Unreached { wanted, reached, cells, most });
                    }
                    before = Some([cells as f64, error]);
                    next
                }
            };
            span = run.seen.map_or(span, |seen| seen.kept(twists));
            cells = finer;
        }
    }
}

/// The drives that press hardest, by shift and by load.
fn hardest(drives: &[Drive]) -> impl Iterator<Item = Drive> {
    let most = |is: fn(&Driven) -> bool| {
        let normals = drives.iter().map(|drive| drive.normal).filter(is);
        normals.max_by(|one, other| one.value().total_cmp(&other.value()))
    };
    let both = [most(|d| matches!(d, Driven::Shift(_))), most(|d| matches!(d, Driven::Load(_)))];
    both.into_iter().flatten().map(|normal| Drive { normal, ..Drive::default() })
}

/// Cells a side that should do, from the error on these and on those before; a multiple of four.
fn finer(cells: usize, error: f64, before: Option<[f64; 2]>, wanted: f64) -> usize {
    let order = before.map_or(1.5, |[cells_before, error_before]| {
        libm::log(error_before / error) / libm::log(cells as f64 / cells_before)
    });
    let order = if order.is_nan() { ORDERS[0] } else { order.clamp(ORDERS[0], ORDERS[1]) };
    let times = 1.1 * libm::pow(error / wanted, 1.0 / order);
    let times = if times.is_nan() { 2.0 } else { times.clamp(1.25, 4.0) };
    fast((times * cells as f64) as usize)
}

/// The next multiple of sixteen whose only other factors are 2 and 3.
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

/// Where the contact of a drive lies without friction; none apart.
fn scout<E>(
    make: &impl Fn(&Window) -> Result<ContactProblem, ProblemError>,
    start: Span,
    drive: &Drive,
    twists: bool,
) -> Result<Option<Span>, FitError<E>> {
    let method = Frictionless::default().within(1e-4)?;
    let mut span = start;
    let mut reached = None;
    for _ in 0..TRIES {
        let window = span.window(SCOUTS, 0)?;
        let problem = make(&window)?.without_friction();
        if problem.apart(drive.normal).is_some() {
            // Perhaps the body comes nearer between the centres.
            span = Span::around_lowest(&problem, &window).kept(twists);
            if !span.is_sensible() {
                return Ok(None);
            }
            continue;
        }
        let (mut state, apart) =
            (ContactState::apart(window.grid()), ContactState::apart(window.grid()));
        let mut scratch = method.scratch(&problem).map_err(FitError::Scouts)?;
        method
            .step(&problem, &apart, drive, &mut state, &mut scratch, &mut ())
            .map_err(FitError::Scouts)?;
        let Some(found) = Span::touching(&state, &window) else { return Ok(None) };
        if let Some(side) = border(&state) {
            reached = Some(side);
            span = span.moved(side, 1.0, twists);
            if !span.is_sensible() {
                break;
            }
        } else if found.kept(twists).is_small_in(&span, SMALL) {
            span = found.kept(twists).widened(1.0);
        } else {
            return Ok(Some(found.kept(twists)));
        }
    }
    Err(reached.map_or(FitError::NoWindow { tried: TRIES }, |side| FitError::Endless { side }))
}

/// A side that the contact reaches.
pub(crate) fn border(state: &ContactState) -> Option<Side> {
    state.doubts().into_iter().find_map(|doubt| match doubt {
        Doubt::Border { side } => Some(side),
        Doubt::FewCells { .. } => None,
    })
}

/// A history on one window.
struct Run<M: Method> {
    window: Window,
    history: NestedHistory<M>,
    estimates: Vec<Estimates>,
    /// All that was in contact.
    seen: Option<Span>,
}

/// How far it got.
enum Reached {
    Border(Side),
    /// No estimates.
    Nothing,
    End {
        error: f64,
    },
}

impl<M: Method> Run<M> {
    fn begin(
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
        Ok(Self { window, history, estimates: Vec::new(), seen: None })
    }

    fn follow(&mut self, drives: &[Drive]) -> Result<Reached, M::Error> {
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
            match self.history.estimates() {
                Some(estimates) => self.estimates.push(estimates),
                None => return Ok(Reached::Nothing),
            }
        }
        Ok(Reached::End { error: Estimates::worst(&self.estimates) })
    }
}
