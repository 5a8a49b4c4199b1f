//! Torsion of an elliptical contact under constant normal load, approximate (7.65), (7.66).

use carom_halfspace::MaterialPair;
use carom_special::RangeError;

use super::adhesion::{AdhesiveTorsion, sliding_torque_arm};
use crate::bounds::in_memory;
use crate::ellipse::ContactEllipse;

/// The exponential law (7.65) with Masing's rule for reversals (7.66), extended to any number of
/// reversals: one that closes a loop returns to the branch that the loop left (Madelung).
///
/// On a circle the first loading is at most 2.76 % of the sliding torque below the exact law.
///
/// ```
/// use carom_laws::torsion::ellipse::EllipseTorsion;
/// let mut torsion = EllipseTorsion::new(2.0, 10.0)?;
/// torsion.advance(0.3)?;
/// let at_reversal = torsion.torque();
/// torsion.advance(0.1)?;
/// torsion.advance(0.3)?; // the small loop is closed
/// assert!((torsion.torque() - at_reversal).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct EllipseTorsion {
    sliding: f64,
    stiffness: f64,
    twist: f64,
    torque: f64,
    /// Points of reversal (twist, torque), each inside the loop of the previous ones.
    reversals: Vec<(f64, f64)>,
    dissipated: f64,
}

impl EllipseTorsion {
    /// From the sliding torque M_zS and the initial stiffness M_zA'.
    ///
    /// # Errors
    /// [`RangeError`] unless the sliding torque is finite and not negative and the stiffness
    /// finite and positive.
    pub fn new(sliding_torque: f64, stiffness: f64) -> Result<Self, RangeError> {
        RangeError::non_negative("sliding_torque", sliding_torque)?;
        RangeError::positive("stiffness", stiffness)?;
        let sliding = sliding_torque;
        let reversals = Vec::new();
        Ok(Self { sliding, stiffness, twist: 0.0, torque: 0.0, reversals, dissipated: 0.0 })
    }

    /// The law of a contact ellipse: `M_zS = (3/8) f F_z b E`, `M_zA'` from (5.35).
    ///
    /// # Errors
    /// [`RangeError`] unless the limit f F_z is finite and not negative.
    pub fn of_contact(
        ellipse: ContactEllipse,
        materials: MaterialPair,
        friction_limit: f64,
    ) -> Result<Self, RangeError> {
        RangeError::non_negative("friction_limit", friction_limit)?;
        let stiffness = AdhesiveTorsion::new(ellipse, materials).stiffness();
        Self::new(friction_limit * sliding_torque_arm(&ellipse), stiffness)
    }

    /// The torque of complete sliding, M_zS.
    #[must_use]
    pub const fn sliding_torque(&self) -> f64 {
        self.sliding
    }

    /// The initial stiffness M_zA'.
    #[must_use]
    pub const fn initial_stiffness(&self) -> f64 {
        self.stiffness
    }

    /// The present twist.
    #[must_use]
    pub const fn twist(&self) -> f64 {
        self.twist
    }

    /// The present torque.
    #[must_use]
    pub const fn torque(&self) -> f64 {
        self.torque
    }

    /// The tangent dM_z/dbeta of the present branch.
    #[must_use]
    pub fn tangent(&self) -> f64 {
        match self.reversals.last() {
            None => self.stiffness * (1.0 - self.torque.abs() / self.sliding),
            Some(&(_, torque)) => {
                self.stiffness * (1.0 - (self.torque - torque).abs() / (2.0 * self.sliding))
            }
        }
    }

    /// The energy dissipated since the beginning.
    #[must_use]
    pub const fn dissipated(&self) -> f64 {
        self.dissipated
    }

    /// The elastic energy: that of springs with sliders in parallel whose first loading is (7.65).
    /// The springs that yield at the twist y have the stiffness density `M_zA'/y_0 exp(-y/y_0)`,
    /// `y_0 = M_zS/M_zA'`.
    #[must_use]
    pub fn stored_energy(&self) -> f64 {
        if self.sliding == 0.0 {
            return 0.0;
        }
        let scale = self.sliding / self.stiffness;
        let mut energy = 0.0;
        for piece in self.pieces() {
            energy += piece.energy(scale);
        }
        self.stiffness * energy
    }

    /// Advances to a new twist and returns the torque.
    ///
    /// # Errors
    /// [`RangeError`] for a twist that is not finite; the state is then unchanged.
    pub fn advance(&mut self, twist: f64) -> Result<f64, RangeError> {
        in_memory("twist", twist)?;
        if twist == self.twist {
            return Ok(self.torque);
        }
        let stored = self.stored_energy();
        let work = self.travel(twist);
        self.dissipated += (work - (self.stored_energy() - stored)).max(0.0);
        Ok(self.torque)
    }

    /// Follows the branches to a twist; returns the work done.
    fn travel(&mut self, twist: f64) -> f64 {
        let up = twist > self.twist;
        let branch_up = match self.reversals.last() {
            None => self.twist == 0.0 || (self.twist > 0.0) == up,
            Some(&(from, _)) => (self.twist > from) == up,
        };
        if !branch_up {
            self.reversals.push((self.twist, self.torque));
        }
        let mut work = 0.0;
        loop {
            let target = match self.loop_end() {
                Some(end) if (twist >= end) == up || twist == end => end,
                _ => twist,
            };
            work += self.along_branch(target);
            if target == twist && self.loop_end() != Some(twist) {
                return work;
            }
            // The loop is closed: its two points are removed.
            let closed = if self.reversals.len() > 1 { 2 } else { 1 };
            self.reversals.truncate(self.reversals.len() - closed);
            if target == twist {
                return work;
            }
        }
    }

    /// The twist at which the present branch meets the one that its loop left.
    fn loop_end(&self) -> Option<f64> {
        match self.reversals.len() {
            0 => None,
            1 => Some(-self.reversals[0].0),
            n => Some(self.reversals[n - 2].0),
        }
    }

    /// Follows the present branch to a twist; returns the work.
    fn along_branch(&mut self, twist: f64) -> f64 {
        let (from, torque, scale) = match self.reversals.last() {
            None => (0.0, 0.0, 1.0),
            Some(&(from, torque)) => (from, torque, 2.0),
        };
        let limit = scale * self.sliding;
        let rate = if limit > 0.0 { self.stiffness / limit } else { 0.0 };
        let sign = if twist >= self.twist { 1.0 } else { -1.0 };
        // M = M_1 + s L (1 - exp(-rate |beta - beta_1|))
        let fall = |beta: f64| libm::expm1(-rate * (beta - from).abs());
        let work = (torque + sign * limit) * (twist - self.twist)
            + if rate > 0.0 { limit / rate * (fall(twist) - fall(self.twist)) } else { 0.0 };
        self.torque = torque - sign * limit * fall(twist);
        self.twist = twist;
        work
    }

    /// Ranges of yield twists y in which the stretch of the springs is one linear function of y.
    fn pieces(&self) -> impl Iterator<Item = Piece> + '_ {
        // A spring with yield twist y slid in the last branch if 2 y < |beta - beta_n|, otherwise
        // in the previous one, and so on; its stretch is +-y from where it slid last.
        let n = self.reversals.len();
        (0..=n)
            .rev()
            .scan(0.0, move |low, i| {
                let end = if i == n { self.twist } else { self.reversals[i].0 };
                let (start, scale) =
                    if i == 0 { (0.0, 1.0) } else { (self.reversals[i - 1].0, 2.0) };
                let high = ((end - start).abs() / scale).max(*low);
                let sign = if end >= start { 1.0 } else { -1.0 };
                let piece = Piece { low: *low, high, offset: self.twist - end, sign };
                *low = high;
                Some(piece)
            })
            .chain(std::iter::once(self.unslid()))
    }

    /// The springs that have not slid yet.
    fn unslid(&self) -> Piece {
        let first = self.reversals.first().map_or(self.twist, |&(twist, _)| twist);
        Piece { low: first.abs(), high: f64::INFINITY, offset: self.twist, sign: 0.0 }
    }
}

/// Springs with yield twists from `low` to `high`, stretched by `offset + sign y`.
struct Piece {
    low: f64,
    high: f64,
    offset: f64,
    sign: f64,
}

impl Piece {
    /// `(1/2) int (offset + sign y)^2 exp(-y/y0)/y0 dy`.
    fn energy(&self, y0: f64) -> f64 {
        if self.high <= self.low {
            return 0.0;
        }
        let end = |y: f64| {
            if y.is_infinite() {
                return 0.0;
            }
            let u = self.offset + self.sign * y;
            libm::exp(-y / y0)
                * 0.5
                * (u * u + 2.0 * self.sign * y0 * u + 2.0 * self.sign.powi(2) * y0 * y0)
        };
        end(self.low) - end(self.high)
    }
}
