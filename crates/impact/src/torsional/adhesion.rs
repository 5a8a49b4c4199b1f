//! Complete adhesion in compression: the spin as a function of the contact radius.
//!
//! While nothing slips, `y'' = -eps zeta^(3/2) y` (10.10) with y = beta'/beta'(0). Two arguments
//! keep the right-hand side analytic: the radius al = sqrt(zeta) up to `SWITCH_RADIUS`, from there
//! the normal velocity w.

use carom_special::ode::{DenseStep, Stepper, Tolerance};
use carom_special::roots::{self, Bracket};

use super::error::TorsionalError;

/// The normal velocity at which the independent variable changes from the radius to w, and the
/// contact radius there.
pub(super) const SWITCH_VELOCITY: f64 = 0.7;
pub(super) const SWITCH_RADIUS: f64 = 0.874_005_237_612_637_2;

const TOLERANCE: Tolerance = Tolerance { absolute: 1e-14, relative: 1e-13 };

/// Largest steps in al and in w; dense output is of lower order than the steps.
const MAX_STEP: f64 = 0.125;

/// Impulse of the torque, twist and torque at one instant, each over the initial spin beta'(0): the
/// spin is `y = 1 - eps impulse`, the twist `int y dt`, the torque `mu/Omega`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Turn {
    pub(super) impulse: f64,
    pub(super) twist: f64,
    pub(super) torque: f64,
}

impl Turn {
    pub(super) fn spin(&self, epsilon: f64) -> f64 {
        1.0 - epsilon * self.impulse
    }
}

impl From<[f64; 3]> for Turn {
    fn from([impulse, twist, torque]: [f64; 3]) -> Self {
        Self { impulse, twist, torque }
    }
}

/// The adhesive motion from first contact to the onset of slip, or to maximum compression.
#[derive(Debug, Clone)]
pub(super) struct Adhesion {
    epsilon: f64,
    omega: f64,
    by_radius: Vec<DenseStep<3>>,
    by_velocity: Vec<DenseStep<3>>,
    onset: f64,
    onset_velocity: f64,
    at_onset: Turn,
}

impl Adhesion {
    /// Solves the motion for the given epsilon until slip begins at the edge,
    /// `R |dbeta/da| = f/(1 - nu)` (10.7, corrected): `2 Omega al |y| = w`.
    pub(super) fn new(epsilon: f64, omega: f64) -> Result<Self, TorsionalError> {
        let start = [0.0; 3];
        let mut course = Self {
            epsilon,
            omega,
            by_radius: Vec::with_capacity(16),
            by_velocity: Vec::with_capacity(16),
            onset: 1.0,
            onset_velocity: 0.0,
            at_onset: Turn::from(start),
        };
        let mut stepper = Stepper::new(0.0, start, MAX_STEP, TOLERANCE, |al, y: &[f64; 3]| {
            Self::slope_by_radius(epsilon, al, y)
        })?;
        while stepper.x() < SWITCH_RADIUS {
            stepper.step((stepper.x() + MAX_STEP).min(SWITCH_RADIUS))?;
            course.by_radius.push(stepper.dense());
            if course.slips(stepper.x(), velocity_at(stepper.x()), stepper.y()) {
                course.find_onset_by_radius()?;
                return Ok(course);
            }
        }
        let state = *stepper.y();
        let slope = |w: f64, y: &[f64; 3]| Self::slope_by_velocity(epsilon, w, y);
        let mut stepper = Stepper::new(SWITCH_VELOCITY, state, MAX_STEP, TOLERANCE, slope)?;
        while stepper.x() > 0.0 {
            stepper.step((stepper.x() - MAX_STEP).max(0.0))?;
            course.by_velocity.push(stepper.dense());
            let w = stepper.x();
            if omega > 0.0 && w > 0.0 && course.slips(radius_at(w), w, stepper.y()) {
                break;
            }
        }
        course.find_onset_by_velocity()?;
        Ok(course)
    }

    fn slips(&self, radius: f64, w: f64, state: &[f64; 3]) -> bool {
        self.rim_excess(radius, w, *state) >= 0.0
    }

    /// `2 Omega al |y| - w`, positive if the edge would slip.
    fn rim_excess(&self, radius: f64, w: f64, state: [f64; 3]) -> f64 {
        2.0 * self.omega * radius * Turn::from(state).spin(self.epsilon).abs() - w
    }

    /// d/dal of the unknowns: dt = 2 al dal/w.
    fn slope_by_radius(epsilon: f64, al: f64, y: &[f64; 3]) -> [f64; 3] {
        let dt = 2.0 * al / velocity_at(al);
        let spin = 1.0 - epsilon * y[0];
        [y[2] * dt, spin * dt, al * al * al * spin * dt]
    }

    /// d/dw: dt = -(4/5) zeta^(-3/2) dw.
    fn slope_by_velocity(epsilon: f64, w: f64, y: &[f64; 3]) -> [f64; 3] {
        let al = radius_at(w);
        let dt = -0.8 / (al * al * al);
        let spin = 1.0 - epsilon * y[0];
        [y[2] * dt, spin * dt, -0.8 * spin]
    }

    fn find_onset_by_radius(&mut self) -> Result<(), TorsionalError> {
        let Some(&step) = self.by_radius.last() else { return Ok(()) };
        let excess = |al: f64| self.rim_excess(al, velocity_at(al), step.at(al));
        let root = roots::brent(excess, Bracket::new(step.start(), step.end())?, 0.0)?;
        self.onset = root.position;
        self.onset_velocity = velocity_at(root.position);
        self.at_onset = step.at(root.position).into();
        Ok(())
    }

    fn find_onset_by_velocity(&mut self) -> Result<(), TorsionalError> {
        let Some(&step) = self.by_velocity.last() else { return Ok(()) };
        let excess = |w: f64| self.rim_excess(radius_at(w), w, step.at(w));
        let w = if self.omega > 0.0 {
            roots::brent(excess, Bracket::new(step.end(), step.start())?, 0.0)?.position
        } else {
            0.0
        };
        self.onset = radius_at(w);
        self.onset_velocity = w;
        self.at_onset = step.at(w).into();
        Ok(())
    }

    /// The contact radius at which slip begins; 1 if only in restitution (Omega = 0).
    pub(super) fn onset(&self) -> f64 {
        self.onset
    }

    /// The normal velocity at the onset.
    pub(super) fn onset_velocity(&self) -> f64 {
        self.onset_velocity
    }

    /// The sign of the spin at the onset, and of the slip that begins there.
    pub(super) fn slip_sign(&self) -> f64 {
        1.0_f64.copysign(self.at_onset.spin(self.epsilon))
    }

    /// The state at the onset.
    pub(super) fn at_onset(&self) -> Turn {
        self.at_onset
    }

    /// The state when the contact radius was `al` and the normal velocity `w`, before the onset.
    pub(super) fn at(&self, al: f64, w: f64) -> Turn {
        if w <= self.onset_velocity {
            return self.at_onset;
        }
        if al <= SWITCH_RADIUS {
            let i = self.by_radius.partition_point(|step| step.end() < al);
            if let Some(step) = self.by_radius.get(i) {
                return step.at(al).into();
            }
        }
        let i = self.by_velocity.partition_point(|step| step.end() > w);
        self.by_velocity.get(i).map_or(self.at_onset, |step| step.at(w).into())
    }

    /// `dbh/dal` at the contact radius `al` and velocity `w`, with the state there: the adhesive density b(al).
    pub(super) fn density(&self, al: f64, w: f64, there: &Turn) -> f64 {
        2.0 * self.omega * al * there.spin(self.epsilon) / w
    }
}

/// The normal velocity in compression at the contact radius `al`.
pub(super) fn velocity_at(al: f64) -> f64 {
    let square = al * al;
    (1.0 - square * square * al).max(0.0).sqrt()
}

/// The contact radius at the normal velocity `w`.
pub(super) fn radius_at(w: f64) -> f64 {
    crate::normal::compression(w).sqrt()
}
