//! The numbers that govern the impact of dissimilar spheres and planes.

use carom_laws::friction::Friction;
use carom_special::RangeError;

/// kappa (15.1) of Poisson's ratios from -1 to 1/2.
const KAPPA: [f64; 2] = [0.75, 1.5];
/// What rounding may add.
const ROUNDING: f64 = 1e-12;
/// The largest D_xx/D_zz.
const RATIO: f64 = 100.0;

/// What governs R_x of dissimilar spheres and planes without spin about the normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DissimilarGroups {
    pub(super) kappa: f64,
    pub(super) gamma: f64,
    pub(super) friction: Friction,
    pub(super) lambda: f64,
    pub(super) ratio: f64,
}

impl DissimilarGroups {
    /// Of solid spheres: D_xx/D_zz = 7/2.
    ///
    /// # Errors
    /// As [`DissimilarGroups::new`].
    pub fn of_spheres(
        kappa: f64,
        gamma: f64,
        friction: Friction,
        lambda: f64,
    ) -> Result<Self, RangeError> {
        Self::new(kappa, gamma, friction, lambda, 3.5)
    }

    /// kappa (15.1), gamma (15.2) of either sign, friction, lambda = |xi'|/(f zeta') and D_xx/D_zz.
    ///
    /// # Errors
    /// [`RangeError`] unless kappa is from 3/4 to 3/2, |gamma| at most |3/2 - kappa| (what materials can have),
    /// friction finite and positive, lambda not negative and `ratio` in (0, 100].
    pub fn new(
        kappa: f64,
        gamma: f64,
        friction: Friction,
        lambda: f64,
        ratio: f64,
    ) -> Result<Self, RangeError> {
        let [low, high] = KAPPA;
        let holds = kappa >= low - ROUNDING && kappa <= high + ROUNDING;
        RangeError::check("kappa", kappa, holds, "from 3/4 to 3/2")?;
        let holds = gamma.abs() <= (high - kappa).max(0.0) + ROUNDING;
        RangeError::check("gamma", gamma, holds, "|gamma| <= 3/2 - kappa")?;
        let f = friction.get();
        RangeError::check("friction", f, f > 0.0 && f.is_finite(), "finite and > 0")?;
        let holds = lambda >= 0.0 && lambda.is_finite();
        RangeError::check("lambda", lambda, holds, ">= 0 and finite")?;
        RangeError::check("D_xx/D_zz", ratio, ratio > 0.0 && ratio <= RATIO, "in (0, 100]")?;
        Ok(Self { kappa: kappa.clamp(low, high), gamma, friction, lambda, ratio })
    }

    /// gamma/f, without sign: the exchange of the bodies leaves R_x as it is.
    pub(super) fn spread(&self) -> f64 {
        self.gamma.abs() / self.friction.get()
    }
}
