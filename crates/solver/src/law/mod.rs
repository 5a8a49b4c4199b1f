//! The numerical contact as a contact law: from rigid shifts to loads (15.1).

mod ahead;
mod cells;
mod entry;
mod error;
mod lagging;
mod start;
mod window;

pub use error::NumericalLawError;

use std::sync::{Arc, Mutex, PoisonError};

use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, ContactLoad, ImpactLaw, Shift};
use carom_laws::slip_lag::SlipLag;
use carom_special::RangeError;

use crate::convergence::Convergence;
use crate::frictional::Frictional;
use crate::state::{CellState, ContactState};
use ahead::{Slip, Way};
use cells::Cells;
use lagging::ToCome;
use window::Windows;

/// The contact of two paraboloids, solved on a grid, as a [`ContactLaw`]: for any pair of materials
/// and any history of approach, shifts and twist.
///
/// The cells are fixed, so that tractions are remembered where they act. Only a window around the
/// contact is solved, which follows the contact as it grows and shrinks. Displacements beyond it
/// follow from the tractions. If the contact becomes twice as wide as expected, the cell width is
/// doubled; forces are conserved.
///
/// Clones are cheap: they share all data that does not change. Clones do not affect each other.
///
/// Within a step the contact is taken to grow from the old to the new approach. Cells that come
/// into contact take part in the rest of the step only. A single step along a straight path is
/// therefore nearly as accurate as many.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// use carom_laws::curvature::RelativeCurvature;
/// use carom_laws::friction::Friction;
/// use carom_laws::hertz::Hertz;
/// use carom_laws::law::{ContactLaw, Shift};
/// use carom_solver::NumericalLaw;
/// let body = |nu| Material::from_shear(1.0, nu);
/// let pair = MaterialPair::new(body(0.0)?, body(0.5)?)?;
/// let hertz = Hertz::new(RelativeCurvature::from_coefficients(0.5, 0.5)?, pair)?;
/// let mut law = NumericalLaw::new(hertz, Friction::new(0.1)?, 0.01, 20)?;
/// law.advance(Shift { zeta: 0.005, ..Shift::default() })?;
/// let mut trial = law.clone();
/// let pushed = trial.advance(Shift { zeta: 0.005, xi: 0.001, ..Shift::default() })?;
/// // All of it slides, though not yet exactly along x: dissimilar bodies are drawn sideways when
/// // pressed together.
/// let of_limit = pushed.f_x / (0.1 * pushed.f_z);
/// assert!(of_limit > 0.98 && of_limit < 0.999);
/// assert_eq!(law.shift().xi, 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct NumericalLaw {
    shared: Arc<Shared>,
    shift: Shift,
    load: ContactLoad,
    /// `None` while the bodies are separated.
    touching: Option<Arc<Touching>>,
}

struct Shared {
    hertz: Hertz,
    friction: Friction,
    method: Frictional,
    /// Cells of the expected contact.
    cells: Cells,
    /// Whether slip is taken ahead.
    ahead: bool,
    windows: Mutex<Windows>,
}

/// The contact on its window.
#[derive(Debug, Clone)]
struct Touching {
    cells: Cells,
    state: ContactState,
    /// The slip of the last step, if it is taken ahead or lags.
    slip: Option<Slip>,
    /// How it lags.
    lag: SlipLag,
    convergence: Convergence,
}

/// The least number of cells across the expected contact.
const FEWEST_CELLS: usize = 4;
/// The greatest number of cells across the expected contact.
const MOST_CELLS: usize = 2048;
/// If the contact is this much wider than expected, the cell width is doubled.
const WIDTH_FOR_COARSER_CELLS: f64 = 2.0;

impl NumericalLaw {
    /// The law for two elastic bodies with paraboloidal surfaces and friction, for contacts up to
    /// about this approach. `cells` is the number of cells across the contact at this approach,
    /// along x and along y; the cells have the aspect ratio of the contact.
    ///
    /// # Errors
    /// [`RangeError`] unless the approach is finite and positive, the friction finite, and `cells`
    /// in the range 4 to 2048.
    pub fn new(
        hertz: Hertz,
        friction: Friction,
        approach: f64,
        cells: usize,
    ) -> Result<Self, RangeError> {
        let holds = (FEWEST_CELLS..=MOST_CELLS).contains(&cells);
        RangeError::check("cells", cells as f64, holds, "from 4 to 2048")?;
        RangeError::finite("friction", friction.get())?;
        let cells = Cells::across(&hertz.ellipse(approach)?, cells)?;
        Ok(Self::fresh(hertz, friction, Frictional::default(), cells, false))
    }

    /// The law in its initial state, with another tolerance than 1e-9.
    ///
    /// # Errors
    /// As [`Frictional::within`].
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        let Shared { hertz, friction, method, cells, ahead, .. } = *self.shared;
        Ok(Self::fresh(hertz, friction, method.within(tolerance)?, cells, ahead))
    }

    /// The law in its initial state, with steps of second order where slip goes on.
    ///
    /// A step is else a function of the state alone, and slips along the tractions at its end, which lag by half
    /// a step. Here it begins with `w^2/(1 + 2 w)` of the slip of the last step, w the ratio of the lengths of
    /// both (at most 2), times the cosine between their ways (approach, shifts over f); nothing where the way
    /// turns back, and where three quarters of the cells that slipped stick.
    #[must_use]
    pub fn with_slip_ahead(self) -> Self {
        let Shared { hertz, friction, method, cells, .. } = *self.shared;
        Self::fresh(hertz, friction, method, cells, true)
    }

    fn fresh(
        hertz: Hertz,
        friction: Friction,
        method: Frictional,
        cells: Cells,
        ahead: bool,
    ) -> Self {
        let windows = Mutex::default();
        let shared = Arc::new(Shared { hertz, friction, method, cells, ahead, windows });
        let (shift, load) = Default::default();
        Self { shared, shift, load, touching: None }
    }

    /// The contact on its grid; `None` while the bodies are separated.
    #[must_use]
    pub fn state(&self) -> Option<&ContactState> {
        self.touching.as_deref().map(|touching| &touching.state)
    }

    /// The convergence of the last step; `None` while the bodies are separated.
    #[must_use]
    pub fn convergence(&self) -> Option<&Convergence> {
        self.touching.as_deref().map(|touching| &touching.convergence)
    }

    /// The number of cells in this state.
    #[must_use]
    pub fn count(&self, cell: CellState) -> usize {
        self.state().map_or(0, |state| state.count(cell))
    }

    /// The shift at first contact on a straight path from the present shift to another one; the
    /// present shift if the bodies are in contact.
    fn touch(&self, to: &Shift) -> Shift {
        let from = self.shift;
        if from.zeta >= 0.0 {
            return from;
        }
        let part = from.zeta / (from.zeta - to.zeta);
        let mix = |from: f64, to: f64| from + part * (to - from);
        Shift {
            zeta: 0.0,
            xi: mix(from.xi, to.xi),
            eta: mix(from.eta, to.eta),
            omega: mix(from.omega, to.omega),
        }
    }

    /// The slip of the last step and its cells.
    fn last_slip(&self) -> Option<(&Slip, Cells)> {
        let touching = self.touching.as_deref()?;
        Some((touching.slip.as_ref()?, touching.cells))
    }

    /// Begins a step with the true slip of a viscous material.
    fn fall_back(&self, from: &mut ContactState) -> Result<(), RangeError> {
        if let Some(Touching { state, slip: Some(slip), lag, .. }) = self.touching.as_deref()
            && lag.part() > 0.0
        {
            let ellipse = self.shared.hertz.ellipse(self.shift.zeta)?;
            ToCome { last: state, ellipse, slip, lag: *lag }.take_off(from);
        }
        Ok(())
    }

    /// The contact after a step; `None` if the bodies are then separated.
    fn stepped(&self, to: Shift, lag: SlipLag) -> Result<Option<Touching>, NumericalLawError> {
        let Shared { hertz, friction, method, cells, ahead, windows } = &*self.shared;
        let (ellipse, touch) = (hertz.ellipse(to.zeta)?, self.touch(&to));
        let mut cells = self.touching.as_deref().map_or(*cells, |touching| touching.cells);
        while cells.widths_across(&ellipse)
            > WIDTH_FOR_COARSER_CELLS * self.shared.cells.asked() as f64
        {
            cells = cells.coarser();
        }
        cells = cells.window_for(&ellipse);
        loop {
            let mut windows = windows.lock().unwrap_or_else(PoisonError::into_inner);
            let window = windows.get(cells, hertz, *friction, method)?;
            drop(windows);
            let mut from = match self.touching.as_deref() {
                Some(touching) => window.take(touching.cells, &touching.state)?,
                None => ContactState::apart(window.grid()),
            };
            from.shift = touch;
            entry::anticipate(&mut from, &touch, &to, &ellipse);
            self.fall_back(&mut from)?;
            if lag.bent() != Shift::default() {
                lagging::bend(&mut from, &ellipse, lag);
            }
            let keeps = *ahead || lag.part() > 0.0;
            let before = keeps.then(|| ahead::displacements(&from));
            let way = Way::new(&touch, &to, ellipse.semi_axis_a(), friction.get());
            if let Some((slip, own)) = self.last_slip().filter(|_| *ahead) {
                slip.take_ahead(&own, &way, &cells, &mut from);
            }
            start::cut(&mut from, &hertz.at_approach(to.zeta)?, friction.get());
            let (mut state, mut convergence) = window.step(method, &from, to)?;
            if let (Some((slip, own)), Some(before)) =
                (self.last_slip().filter(|_| *ahead), &before)
                && slip.ends(&own, &cells, &state)
            {
                ahead::restore(&mut from, before);
                (state, convergence) = window.step(method, &from, to)?;
            }
            let slip = before.map(|before| Slip::of(way, &touch, &before, &state));
            if !cells.touch_border(&state) {
                let apart = state.count(CellState::Exterior) == state.cells.values().len();
                return Ok((!apart).then_some(Touching { cells, state, slip, lag, convergence }));
            }
            cells = cells.wider();
        }
    }
}

impl ContactLaw for NumericalLaw {
    type Error = NumericalLawError;

    /// # Errors
    /// [`NumericalLawError`] if the step could not be solved.
    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, NumericalLawError> {
        self.advance_lagging(shift, SlipLag::NONE)
    }

    /// # Errors
    /// As [`NumericalLaw::advance`].
    fn advance_lagging(
        &mut self,
        shift: Shift,
        lag: SlipLag,
    ) -> Result<ContactLoad, NumericalLawError> {
        shift.check_finite()?;
        let touching = if shift.zeta > 0.0 { self.stepped(shift, lag)? } else { None };
        self.load = touching.as_ref().map_or_else(ContactLoad::default, |it| it.state.load());
        (self.touching, self.shift) = (touching.map(Arc::new), shift);
        Ok(self.load)
    }

    fn shift(&self) -> Shift {
        self.shift
    }

    fn load(&self) -> ContactLoad {
        self.load
    }

    fn keeps_slip(&self) -> bool {
        true
    }
}

impl std::fmt::Debug for NumericalLaw {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (shift, load) = (&self.shift, &self.load);
        f.debug_struct("NumericalLaw").field("shift", shift).field("load", load).finish()
    }
}

impl ImpactLaw for NumericalLaw {}
