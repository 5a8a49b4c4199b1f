//! The angle by which the direction of slip has turned within one annulus.

mod pack;

use super::drag::{Step, cross};
use crate::friction::Friction;
use crate::law::Shift;
use crate::memory::{Lateral as _, Turn};
use crate::stiffness::ContactStiffness;
use carom_special::RangeError;

/// The annuli that are followed, with equal distances in the approach at which they touch.
const ANNULI: usize = 48;
/// Slip that takes this share of a step began with the step.
const WHOLE: f64 = 1.0 - 1e-12;
/// An annulus with a limit below this many round-off lengths has just touched.
const JUST_TOUCHED: f64 = 1e4;

/// The largest angle by which the direction of slip has turned within one annulus since that annulus last
/// stuck.
///
/// Coulomb's law lets annuli slip independently of each other. That is exact while the direction of slip is
/// the same everywhere; on paths that turn, the distance of the law from elastic half-spaces grows with this
/// angle (page `accuracy.turning` of the verification). The angle does not bound it: where annuli stick again, the
/// error made before stays. 48 annuli are followed, each exactly along straight
/// steps; of a contact that is pressed deeper than expected, 24 to 48; units: approach in m, angle in radians, from 0; a step counts as turning by at most half a turn.
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
    /// The approach up to which annuli are spread; 0 before it is known.
    deepest: f64,
    zeta: f64,
    /// In units of length.
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
    /// A contact that has not touched yet, for approaches up to `deepest`. A deeper approach spreads the annuli
    /// twice as far.
    ///
    /// # Errors
    /// [`RangeError`] unless `deepest` is finite and positive.
    pub fn new(
        stiffness: ContactStiffness,
        friction: Friction,
        deepest: f64,
    ) -> Result<Self, RangeError> {
        RangeError::positive("deepest", deepest)?;
        Ok(Self::spread(stiffness, friction, deepest))
    }

    /// The same for approaches that are not known: the first is taken for the deepest.
    #[must_use]
    pub fn of_any_depth(stiffness: ContactStiffness, friction: Friction) -> Self {
        Self::spread(stiffness, friction, 0.0)
    }

    fn spread(stiffness: ContactStiffness, friction: Friction, deepest: f64) -> Self {
        let limit = friction.get() * stiffness.c_z;
        let turns = limit > 0.0 && limit.is_finite();
        let scale = if turns { [stiffness.c_x / limit, stiffness.c_y / limit] } else { [0.0; 2] };
        let annuli = (0..ANNULI).map(|i| Annulus::apart(deepest, i, [0.0; 2])).collect();
        Self { scale, deepest, zeta: 0.0, shift: [0.0; 2], annuli }
    }

    /// Moves to a shift along a straight line; a twist is ignored.
    ///
    /// # Errors
    /// [`RangeError`] if a part of the shift is infinite or no number; nothing has then changed.
    pub fn advance(&mut self, to: Shift) -> Result<(), RangeError> {
        let zeta = RangeError::finite("zeta", to.zeta)?.max(0.0);
        RangeError::finite("xi", to.xi)?;
        RangeError::finite("eta", to.eta)?;
        self.reach(zeta);
        let shift = [to.xi, to.eta];
        let [before, after] = [self.shift, shift].map(|shift| self.normalised(shift));
        let step = Step::new((self.zeta, before), (zeta, after));
        self.annuli.iter_mut().for_each(|annulus| annulus.advance(&step));
        (self.zeta, self.shift) = (zeta, shift);
        Ok(())
    }

    /// Spreads the annuli up to this approach, so that those between which they lie stay.
    fn reach(&mut self, zeta: f64) {
        let shift = self.normalised(self.shift);
        while self.deepest < zeta {
            let kept = if self.deepest > 0.0 { ANNULI / 2 } else { 0 };
            self.deepest = if kept > 0 { (2.0 * self.deepest).min(f64::MAX) } else { zeta };
            for i in 0..ANNULI {
                let new = || Annulus::apart(self.deepest, i, shift);
                self.annuli[i] = if i < kept { self.annuli[2 * i] } else { new() };
            }
        }
    }

    /// A shift over that at which the annulus of unit limit slips.
    fn normalised(&self, shift: [f64; 2]) -> [f64; 2] {
        [shift[0] * self.scale[0], shift[1] * self.scale[1]]
    }

    /// Rotates the contact axes by an angle (radians, from x to y), as
    /// [`ShiftLaw::turn_frame`](crate::shift_law::ShiftLaw::turn_frame).
    pub fn turn_frame(&mut self, angle: f64) {
        let turn = Turn::by(angle);
        let before = self.normalised(self.shift);
        self.shift = turn.of(self.shift);
        let after = self.normalised(self.shift);
        for annulus in &mut self.annuli {
            annulus.anchor = after.minus(turn.of(before.minus(annulus.anchor)));
        }
    }

    /// The angle now, in radians; 0 while nothing slips.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.annuli.iter().fold(0.0, |most, annulus| most.max(annulus.turn.abs()))
    }
}

impl Annulus {
    /// The annulus of this number, of those up to an approach, before it touches.
    fn apart(deepest: f64, number: usize, shift: [f64; 2]) -> Self {
        let depth = deepest * number as f64 / ANNULI as f64;
        Self { depth, anchor: shift, turn: 0.0, slips: false }
    }

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
        if limit <= step.dz + JUST_TOUCHED * step.round_off_length {
            // It slips along the step from its touch on.
            (self.anchor, self.turn, self.slips) = (anchor, 0.0, true);
            return;
        }
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
        let stiffness = ContactStiffness::new(0.8, 0.5, 1.0)?;
        let shifts = [(1.2, 0.0, false), (1.3, 0.0, true), (0.0, 1.9, false), (0.0, 2.1, true)];
        for (xi, eta, slips) in shifts {
            for unit in [1.0, 1e-6] {
                let mut turn = SlipTurn::new(stiffness, Friction::new(1.0)?, unit)?;
                turn.advance(Shift { zeta: unit, ..Shift::default() })?;
                let (xi, eta) = (unit * xi, unit * eta);
                turn.advance(Shift { zeta: unit, xi, eta, ..Shift::default() })?;
                assert_eq!(turn.annuli[0].slips, slips, "{xi} {eta}");
            }
        }
        for deepest in [0.0, -1.0, f64::NAN] {
            assert!(SlipTurn::new(stiffness, Friction::new(1.0)?, deepest).is_err());
        }
        Ok(())
    }

    /// Pressed deeper than expected, or of no expected depth, along the path of a contact that knew its depth.
    #[test]
    fn a_contact_of_unknown_depth_turns_as_one_of_known_depth() -> Result<(), RangeError> {
        let (stiffness, friction) = (ContactStiffness::new(1.0, 0.8, 1.0)?, Friction::new(1.0)?);
        let mut known = SlipTurn::new(stiffness, friction, 8.0)?;
        let mut shallow = SlipTurn::new(stiffness, friction, 2.0)?;
        let mut unknown = SlipTurn::of_any_depth(stiffness, friction);
        for step in 0..400 {
            let t = 0.01 * f64::from(step);
            let (sin, cos) = libm::sincos(3.0 * t);
            let shift = Shift { zeta: 1.0 + 1.75 * t, xi: 9.0 * sin, eta: 12.0 * cos, omega: 0.0 };
            for turn in [&mut known, &mut shallow, &mut unknown] {
                turn.advance(shift)?;
            }
        }
        assert!(known.angle() > 2.0, "{}", known.angle());
        for other in [shallow, unknown] {
            assert_eq!(other.deepest, 8.0);
            approx::assert_relative_eq!(other.angle(), known.angle(), epsilon = 0.05);
        }
        Ok(())
    }

    /// An annulus that touches as a step begins has no direction yet from which slip could turn.
    #[test]
    fn slip_does_not_turn_where_it_begins_with_the_touch() -> Result<(), RangeError> {
        let parts = (1..40).flat_map(|number| [0.0, 1e-15, 1e-13].map(|off| (number, off)));
        for (number, off) in parts {
            let mut turn = turn()?;
            let zeta = f64::from(number) / 48.0 * (1.0 + off);
            turn.advance(Shift { zeta, ..Shift::default() })?;
            for way in [1.0, 2.0, 3.0] {
                let shift = Shift { zeta: zeta + 1e-3 * way, xi: way, eta: 0.3 * way, omega: 0.0 };
                turn.advance(shift)?;
                assert!(turn.angle() < 1e-6, "{number} {way}: {}", turn.angle());
            }
        }
        Ok(())
    }

    /// The path in turned axes gives the angle that it gives in the old ones.
    #[test]
    fn turned_axes_keep_the_angle() -> Result<(), RangeError> {
        let (mut own, mut other) = (turn()?, turn()?);
        let (sin, cos) = libm::sincos(0.7);
        for step in 0..100 {
            let (y, x) = libm::sincos(0.05 * f64::from(step));
            let (xi, eta) = (4.0 * x, 7.0 * y);
            own.advance(Shift { zeta: 1.0, xi, eta, omega: 0.0 })?;
            let (u, v) =
                if step < 50 { (xi, eta) } else { (cos * xi + sin * eta, cos * eta - sin * xi) };
            other.advance(Shift { zeta: 1.0, xi: u, eta: v, omega: 0.0 })?;
            if step == 49 {
                other.turn_frame(0.7);
            }
        }
        assert!(own.angle() > 2.0, "{}", own.angle());
        approx::assert_relative_eq!(other.angle(), own.angle(), epsilon = 1e-12);
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
