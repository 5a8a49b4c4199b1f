//! The angle by which the direction of slip has turned within one annulus.

use super::drag::{Step, cross};
use crate::friction::Friction;
use crate::law::Shift;
use crate::memory::Lateral as _;
use crate::stiffness::ContactStiffness;
use carom_special::RangeError;

/// The annuli that are followed, with equal distances in the approach at which they touch.
const ANNULI: usize = 48;
/// Slip that takes this share of a step began with the step.
const WHOLE: f64 = 1.0 - 1e-12;

/// The largest angle by which the direction of slip has turned within one annulus since that annulus last
/// stuck.
///
/// Coulomb's law lets annuli slip independently of each other. That is exact while the direction of slip is
/// the same everywhere; on paths that turn, the distance of the law from elastic half-spaces grows with this
/// angle (page `accuracy.turning` of the verification). The angle does not bound it: where annuli stick again, the
/// error made before stays. 48 annuli are followed, each exactly along straight
/// steps; units: approach in m, angle in radians, from 0; a step counts as turning by at most half a turn.
///
/// ```
/// use carom_laws::coulomb::SlipTurn;
/// use carom_laws::friction::Friction;
/// use carom_laws::law::Shift;
/// use carom_laws::stiffness::ContactStiffness;
/// let stiffness = ContactStiffness::new(1.0, 1.0, 1.2)?;
/// let mut turn = SlipTurn::new(stiffness, Friction::new(0.3)?, 1.0)?;
/// turn.advance(Shift { zeta: 1.0, ..Shift::default() })?;
/// turn.advance(Shift { zeta: 1.0, xi: 2.0, ..Shift::default() })?;
/// assert_eq!(turn.angle(), 0.0);
/// turn.advance(Shift { zeta: 1.0, xi: 2.0, eta: 9.0, ..Shift::default() })?;
/// assert!((turn.angle() - std::f64::consts::FRAC_PI_2).abs() < 1e-6);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SlipTurn {
    /// The normalised shift of the unit shift; zero without friction, where nothing resists.
    scale: [f64; 2],
    zeta: f64,
    shift: [f64; 2],
    annuli: Vec<Annulus>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Annulus {
    /// The approach at which it touches.
    depth: f64,
    /// The shift at which it would carry no traction.
    anchor: [f64; 2],
    /// The angle since it last stuck.
    turn: f64,
    slips: bool,
}

impl SlipTurn {
    /// A contact that has not touched yet, for approaches up to `deepest`.
    ///
    /// # Errors
    /// [`RangeError`] unless `deepest` is finite and positive.
    pub fn new(
        stiffness: ContactStiffness,
        friction: Friction,
        deepest: f64,
    ) -> Result<Self, RangeError> {
        RangeError::positive("deepest", deepest)?;
        let limit = friction.get() * stiffness.c_z;
        let turns = limit > 0.0 && limit.is_finite();
        let scale = if turns { [stiffness.c_x / limit, stiffness.c_y / limit] } else { [0.0; 2] };
        let annulus = |i: usize| Annulus {
            depth: deepest * i as f64 / ANNULI as f64,
            anchor: [0.0; 2],
            turn: 0.0,
            slips: false,
        };
        let annuli = (0..ANNULI).map(annulus).collect();
        Ok(Self { scale, zeta: 0.0, shift: [0.0; 2], annuli })
    }

    /// Moves to a shift along a straight line; a twist is ignored.
    ///
    /// # Errors
    /// [`RangeError`] if a part of the shift is infinite or no number; nothing has then changed.
    pub fn advance(&mut self, to: Shift) -> Result<(), RangeError> {
        let zeta = RangeError::finite("zeta", to.zeta)?.max(0.0);
        RangeError::finite("xi", to.xi)?;
        RangeError::finite("eta", to.eta)?;
        let shift = [to.xi * self.scale[0], to.eta * self.scale[1]];
        let step = Step::new((self.zeta, self.shift), (zeta, shift));
        self.annuli.iter_mut().for_each(|annulus| annulus.advance(&step));
        (self.zeta, self.shift) = (zeta, shift);
        Ok(())
    }

    /// The angle now, in radians; 0 while nothing slips.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.annuli.iter().fold(0.0, |most, annulus| most.max(annulus.turn.abs()))
    }
}

impl Annulus {
    fn advance(&mut self, step: &Step<[f64; 2]>) {
        let limit = step.zeta - self.depth;
        if limit <= 0.0 {
            (self.anchor, self.turn, self.slips) = (step.shift, 0.0, false);
            return;
        }
        let stretch = step.shift.minus(self.anchor);
        if stretch.dot(stretch) <= limit * limit {
            (self.turn, self.slips) = (0.0, false);
            return;
        }
        let anchor = step.drag(self.depth, self.anchor);
        let met = step.met(stretch.dot(step.ahead), cross(step.ahead, stretch), limit);
        let begin = stretch.minus(step.ahead.times(met.rest));
        let turn = angle(begin, step.shift.minus(anchor));
        let goes_on = self.slips && met.rest >= WHOLE * step.length;
        *self = Self {
            anchor,
            turn: if goes_on { self.turn + turn } else { turn },
            slips: true,
            ..*self
        };
    }
}

/// The angle from one vector to another; 0 if one has no length.
fn angle(from: [f64; 2], to: [f64; 2]) -> f64 {
    libm::atan2(cross(from, to), from.dot(to))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn turn() -> Result<SlipTurn, RangeError> {
        SlipTurn::new(ContactStiffness::new(1.0, 1.0, 1.0)?, Friction::new(1.0)?, 1.0)
    }

    #[test]
    fn on_a_large_circle_slip_turns_as_the_path_and_is_forgotten_where_it_sticks()
    -> Result<(), RangeError> {
        let mut turn = turn()?;
        turn.advance(Shift { zeta: 1.0, xi: 50.0, ..Shift::default() })?;
        for step in 0..=360 {
            let (eta, xi) = libm::sincos(TAU * f64::from(step) / 240.0);
            turn.advance(Shift { zeta: 1.0, xi: 50.0 * xi, eta: 50.0 * eta, omega: 0.0 })?;
        }
        // From the direction of x to that of the circle, which leads by a quarter, and one and a half rounds.
        approx::assert_relative_eq!(turn.angle(), 1.75 * TAU, epsilon = 0.05);
        turn.advance(Shift { zeta: 1.5, xi: -50.0, ..Shift::default() })?;
        assert_eq!(turn.angle(), 0.0);
        Ok(())
    }

    /// The limit of each axis is that of its stiffness: f c_z zeta over c_x along x, over c_y along y.
    #[test]
    fn each_axis_slips_at_its_own_limit() -> Result<(), RangeError> {
        let stiffness = ContactStiffness::new(1.0, 0.5, 1.0)?;
        for (xi, eta, slips) in [(1.1, 0.0, true), (0.0, 1.9, false), (0.0, 2.1, true)] {
            let mut turn = SlipTurn::new(stiffness, Friction::new(1.0)?, 1.0)?;
            turn.advance(Shift { zeta: 1.0, ..Shift::default() })?;
            turn.advance(Shift { zeta: 1.0, xi, eta, ..Shift::default() })?;
            assert_eq!(turn.annuli[0].slips, slips, "{xi} {eta}");
        }
        Ok(())
    }

    #[test]
    fn a_path_that_returns_on_itself_does_not_turn() -> Result<(), RangeError> {
        let mut turn = turn()?;
        for xi in [0.0, 0.4, -0.2, 0.3, 5.0, 4.8] {
            turn.advance(Shift { zeta: 1.0, xi, eta: 0.5 * xi, omega: 0.0 })?;
            assert!(turn.angle() < 1e-9, "{xi}: {}", turn.angle());
        }
        Ok(())
    }
}
