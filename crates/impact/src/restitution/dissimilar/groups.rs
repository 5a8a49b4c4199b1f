//! The numbers that govern the impact of dissimilar spheres and planes.

use carom_laws::friction::Friction;
use carom_special::RangeError;

use crate::oblique::Groups;
use crate::rings::GroupImpact;

/// kappa (15.1) of Poisson's ratios from -1 to 1/2.
const KAPPA: [f64; 2] = [0.75, 1.5];
/// What rounding may add.
const ROUNDING: f64 = 1e-12;
/// The largest D_xx/D_zz, far above that of any body.
const RATIO: f64 = 75.0;

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
    /// Limits are values: friction 0 or lambda infinite is no friction. Where bodies never slip, friction infinite,
    /// lambda is 0 at any velocity.
    ///
    /// # Errors
    /// [`RangeError`] unless kappa is from 3/4 to 3/2, |gamma| at most 3/2 - kappa (what materials can have),
    /// lambda not negative, and 0 where friction is infinite, and `ratio` (`mobility_ratio`) in (0, 75].
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
        RangeError::check("lambda", lambda, lambda >= 0.0, ">= 0")?;
        let holds = lambda == 0.0 || friction.coefficient().is_some();
        RangeError::check("lambda", lambda, holds, "0 where friction is infinite")?;
        let holds = ratio > 0.0 && ratio <= RATIO;
        RangeError::check("mobility_ratio", ratio, holds, "D_xx/D_zz in (0, 75]")?;
        Ok(Self { kappa, gamma, friction, lambda, ratio })
    }

    /// The same impact of alike bodies.
    ///
    /// # Errors
    /// None of valid groups.
    pub(super) fn alike(&self) -> Result<Groups, RangeError> {
        Groups::new(self.ratio / self.kappa, self.lambda / self.kappa)
    }

    /// The impact as rings follow it.
    pub(super) fn impact(&self) -> GroupImpact {
        let Self { kappa, gamma, friction, lambda, ratio } = *self;
        GroupImpact { kappa, gamma, friction, lambda, ratio }
    }

    /// Whether friction changes no tangential velocity.
    pub(super) fn is_frictionless(&self) -> bool {
        self.friction == Friction::NONE || self.lambda.is_infinite()
    }

    /// gamma/f, without sign: the exchange of the bodies leaves R_x as it is.
    pub(super) fn spread(&self) -> f64 {
        self.gamma.abs() / self.friction.get()
    }
}
