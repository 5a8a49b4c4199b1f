//! The numerical contact as a law: rigid shifts in, loads out (15.1).

mod cells;
mod entry;
mod window;

use std::sync::{Arc, Mutex, PoisonError};

use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, ContactLoad, ImpactLaw, Shift};
use carom_special::RangeError;

use crate::convergence::Convergence;
use crate::frictional::{Frictional, FrictionalError};
use crate::problem::ProblemError;
use crate::state::{CellState, ContactState};
use cells::Cells;
use window::Windows;

/// Why a step of the numerical law failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NumericalLawError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The contact problem could not be built.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// The step could not be solved.
    #[error(transparent)]
    Step(#[from] FrictionalError),
}

/// The contact of two paraboloids on a grid as a [`ContactLaw`], for any two materials and any
/// history of approach, shifts and twist.
///
/// The cells keep their place, so that tractions are remembered where they act, but only a window
/// about the contact is solved: it follows the contact as it grows and shrinks, and what lies
/// beyond it has displacements that follow from the tractions. A contact twice as wide as foreseen
/// gets cells twice as wide; tractions pass on with their forces.
///
/// A clone costs next to nothing and shares all that does not change. What one clone does is never
/// seen by another.
///
/// Cells that come into contact during a step take part in what is left of it, as the contact grows
/// from the old to the new approach; so a step along a straight path does nearly as well as many.
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
/// // All of it slides, but not yet straight: unlike bodies were drawn sideways when pressed together.
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
    /// None while the bodies are apart.
    touching: Option<Arc<Touching>>,
}

struct Shared {
    hertz: Hertz,
    friction: Friction,
    method: Frictional,
    /// Of the expected contact.
    cells: Cells,
    windows: Mutex<Windows>,
}

/// The contact on its window.
#[derive(Debug, Clone)]
struct Touching {
    cells: Cells,
    state: ContactState,
    went: Convergence,
}

/// The least number of cells across the expected contact.
const FEWEST: usize = 4;
/// And the greatest.
const MOST: usize = 2048;
/// A contact this much wider than expected gets wider cells.
const OUTGROWN: f64 = 2.0;

impl NumericalLaw {
    /// The law of Hertz's bodies with friction, for contacts up to about this approach, with this
    /// number of cells across the contact there (along x as along y: cells are as slender as the
    /// contact).
    ///
    /// # Errors
    /// [`RangeError`] unless the approach is finite and positive, the friction finite, and 4 to
    /// 2048 cells are asked for.
    pub fn new(
        hertz: Hertz,
        friction: Friction,
        approach: f64,
        cells: usize,
    ) -> Result<Self, RangeError> {
        let holds = (FEWEST..=MOST).contains(&cells);
        RangeError::check("cells", cells as f64, holds, "from 4 to 2048")?;
        RangeError::finite("friction", friction.get())?;
        let cells = Cells::across(&hertz.ellipse(approach)?, cells)?;
        let (method, windows) = (Frictional::default(), Mutex::default());
        let shared = Shared { hertz, friction, method, cells, windows };
        let (shift, load) = Default::default();
        Ok(Self { shared: Arc::new(shared), shift, load, touching: None })
    }

    /// The same law before all contact, solved to another tolerance than 1e-9.
    ///
    /// # Errors
    /// As [`Frictional::within`].
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        let Shared { hertz, friction, method, cells, .. } = *self.shared;
        let (method, windows) = (method.within(tolerance)?, Mutex::default());
        let shared = Shared { hertz, friction, method, cells, windows };
        let (shift, load) = Default::default();
        Ok(Self { shared: Arc::new(shared), shift, load, touching: None })
    }

    /// The contact on its cells; none while the bodies are apart.
    #[must_use]
    pub fn state(&self) -> Option<&ContactState> {
        self.touching.as_deref().map(|touching| &touching.state)
    }

    /// How the last step went; none while the bodies are apart.
    #[must_use]
    pub fn convergence(&self) -> Option<&Convergence> {
        self.touching.as_deref().map(|touching| &touching.went)
    }

    /// How many cells are in this state.
    #[must_use]
    pub fn count(&self, cell: CellState) -> usize {
        self.state().map_or(0, |state| state.count(cell))
    }

    /// The shift at which a straight step from the present shift to another one makes the bodies
    /// touch, or the present one if they do.
    fn touch(&self, to: &Shift) -> Shift {
        let from = self.shift;
        if self.touching.is_some() || from.zeta >= 0.0 {
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

    /// The contact after a step; none if it ends apart.
    fn stepped(&self, to: Shift) -> Result<Option<Touching>, NumericalLawError> {
        let Shared { hertz, friction, method, cells, windows } = &*self.shared;
        let (ellipse, touch) = (hertz.ellipse(to.zeta)?, self.touch(&to));
        let mut cells = self.touching.as_deref().map_or(*cells, |touching| touching.cells);
        while cells.widths_across(&ellipse) > OUTGROWN * self.shared.cells.asked() as f64 {
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
            let (state, went) = window.step(method, &from, to)?;
            if !cells.touch_border(&state) {
                let apart = state.count(CellState::Exterior) == state.cells.values().len();
                return Ok((!apart).then_some(Touching { cells, state, went }));
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
        shift.check_finite()?;
        let touching = if shift.zeta > 0.0 { self.stepped(shift)? } else { None };
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
}

impl std::fmt::Debug for NumericalLaw {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (shift, load) = (&self.shift, &self.load);
        f.debug_struct("NumericalLaw").field("shift", shift).field("load", load).finish()
    }
}

impl ImpactLaw for NumericalLaw {}
