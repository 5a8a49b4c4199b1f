//! The torsional impact with dimensions: two bodies that collide head-on and spin about the normal.

use std::f64::consts::PI;

use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::torsion::adhesion::{AdhesiveTorsion, sliding_torque_arm};
use carom_special::RangeError;

use super::error::TorsionalError;
use super::groups::{MAX_OMEGA, TorsionalGroups};
use super::impact::TorsionalImpact;
use super::limits;
use crate::normal::NormalImpact;

/// A body that spins about the contact normal, which is a principal axis of inertia through its
/// centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spinner {
    inverse_mass: f64,
    inverse_moment: f64,
    spin: f64,
}

impl Spinner {
    /// A body with this mass and moment of inertia about the normal; infinity: unaffected by the
    /// impact.
    ///
    /// # Errors
    /// [`RangeError`] unless both are positive.
    pub fn new(mass: f64, moment: f64) -> Result<Self, RangeError> {
        RangeError::check("mass", mass, mass > 0.0, "> 0 (inf: fixed)")?;
        RangeError::check("moment of inertia", moment, moment > 0.0, "> 0 (inf: fixed)")?;
        let (inverse_mass, inverse_moment) = (1.0 / mass, 1.0 / moment);
        RangeError::finite("inverse mass", inverse_mass)?;
        RangeError::finite("inverse moment of inertia", inverse_moment)?;
        Ok(Self { inverse_mass, inverse_moment, spin: 0.0 })
    }

    /// A solid sphere, of moment (2/5) m R^2.
    ///
    /// # Errors
    /// [`RangeError`] unless mass and radius are finite and positive.
    pub fn solid_sphere(mass: f64, radius: f64) -> Result<Self, RangeError> {
        RangeError::positive("mass", mass)?;
        RangeError::positive("radius", radius)?;
        Self::new(mass, 0.4 * mass * radius * radius)
    }

    /// A body that does not move and is unaffected by the impact.
    #[must_use]
    pub const fn held_fast() -> Self {
        Self { inverse_mass: 0.0, inverse_moment: 0.0, spin: 0.0 }
    }

    /// The same body with a spin in radians per unit of time; both bodies' spins have the same
    /// sense.
    ///
    /// # Errors
    /// [`RangeError`] unless it is finite.
    pub fn spinning(self, spin: f64) -> Result<Self, RangeError> {
        RangeError::finite("spin", spin)?;
        Ok(Self { spin, ..self })
    }

    /// The spin about the normal.
    #[must_use]
    pub const fn spin(&self) -> f64 {
        self.spin
    }
}

/// A head-on collision of two bodies that spin about their common normal.
///
/// Exact within Hertz's theory for a circular contact. For an ellipse Lubkin's law is scaled to the
/// adhesive stiffness (5.35) and the sliding torque (7.65), (10.57) of the ellipse. This is an
/// approximation, since no exact law is known; both limits, no slip and sliding, are exact.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// use carom_impact::torsional::{SpinCollision, Spinner};
/// use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
/// use carom_laws::friction::Friction;
/// use carom_laws::hertz::Hertz;
/// // A rubber ball spins as it falls on a hard floor.
/// let rubber = Material::from_shear(1e6, 0.5)?;
/// let gap = RelativeCurvature::new(PrincipalRadii::sphere(0.02)?, PrincipalRadii::PLANE, 0.0)?;
/// let hertz = Hertz::new(gap, MaterialPair::new(rubber, Material::RIGID)?)?;
/// let ball = Spinner::solid_sphere(0.0369, 0.02)?.spinning(100.0)?;
/// let floor = Spinner::held_fast();
/// let outcome = SpinCollision::new(&hertz, Friction::new(0.8)?, [ball, floor], 1.0)?.solve()?;
/// assert!(outcome.spins[0] < 100.0 && outcome.spins[0] > 70.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpinCollision {
    bodies: [Spinner; 2],
    normal: NormalImpact,
    friction: Friction,
    epsilon: f64,
    /// Omega times friction over spin.
    omega_scale: f64,
    contact_radius: f64,
}

/// Result of a torsional impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpinOutcome {
    /// The spins of the two bodies afterwards.
    pub spins: [f64; 2],
    /// The relative spin afterwards over that before.
    pub spin_ratio: f64,
    /// The impulse of the torque on body 1, about the normal.
    pub torque_impulse: f64,
    /// The kinetic energy that friction took.
    pub energy_loss: f64,
    /// Estimated error of `spin_ratio` ([`TorsionalImpact::error_estimate`]).
    pub error_estimate: f64,
}

impl SpinCollision {
    /// A collision with this contact, these bodies and the approach velocity of their centres, > 0.
    ///
    /// # Errors
    /// [`TorsionalError::Range`] if both bodies are fixed in motion or spin, the velocity is
    /// not positive, or a derived quantity is out of range.
    pub fn new(
        hertz: &Hertz,
        friction: Friction,
        bodies: [Spinner; 2],
        approach_velocity: f64,
    ) -> Result<Self, TorsionalError> {
        let [one, two] = bodies;
        let mobility = one.inverse_mass + two.inverse_mass;
        let stiffness = hertz.stiffness().c_z;
        let normal = NormalImpact::new(mobility, stiffness, approach_velocity)?;
        let ellipse = hertz.ellipse(normal.maximal_approach())?;
        // M = kappa beta at maximum compression; time in its unit.
        let kappa = AdhesiveTorsion::new(ellipse, hertz.materials()).stiffness();
        let unit = normal.time_unit();
        let epsilon = (one.inverse_moment + two.inverse_moment) * kappa * unit * unit;
        // mu = (3 pi/32) M/M_sliding and mu = bh at al = 1, so bh = beta kappa (3 pi/32)/M_sliding.
        let sliding = normal.maximal_force() * sliding_torque_arm(&ellipse);
        let omega_scale = 3.0 * PI / 32.0 * kappa * unit / sliding;
        TorsionalGroups::new(epsilon, 0.0)?;
        RangeError::positive("twist scale", omega_scale)?;
        let contact_radius = ellipse.semi_axis_b();
        Ok(Self { bodies, normal, friction, epsilon, omega_scale, contact_radius })
    }

    /// The relative spin before, that of body 1 less that of body 2.
    #[must_use]
    pub fn relative_spin(&self) -> f64 {
        self.bodies[0].spin - self.bodies[1].spin
    }

    /// The governing groups; Omega is zero for infinite friction. `None` without friction.
    ///
    /// # Errors
    /// [`RangeError`] if Omega exceeds its range.
    pub fn groups(&self) -> Result<Option<TorsionalGroups>, RangeError> {
        self.omega().map(|omega| TorsionalGroups::new(self.epsilon, omega)).transpose()
    }

    /// Omega; none without friction.
    fn omega(&self) -> Option<f64> {
        match self.friction.coefficient() {
            Some(0.0) => None,
            Some(f) => Some(self.omega_scale * self.relative_spin().abs() / f),
            None => Some(0.0),
        }
    }

    /// The normal motion.
    #[must_use]
    pub const fn normal(&self) -> NormalImpact {
        self.normal
    }

    /// The larger semi-axis of the contact area at maximum compression.
    #[must_use]
    pub const fn contact_radius(&self) -> f64 {
        self.contact_radius
    }

    /// Solves the impact up to separation. Above Omega = 1e15 the contact slides throughout, and
    /// the closed form of sliding is exact to round-off: friction may be arbitrarily small.
    ///
    /// # Errors
    /// As [`TorsionalImpact::new`].
    pub fn solve(&self) -> Result<SpinOutcome, TorsionalError> {
        if let Some(omega) = self.omega().filter(|omega| *omega > MAX_OMEGA) {
            return Ok(self.outcome(limits::sliding_loss(self.epsilon, omega), 0.0));
        }
        let Some(groups) = self.groups()? else {
            return Ok(self.outcome(0.0, 0.0));
        };
        if self.friction.coefficient().is_none() {
            return Ok(self.outcome(limits::no_slip_loss(groups.epsilon())?, 0.0));
        }
        let impact = TorsionalImpact::new(groups)?;
        Ok(self.outcome(impact.spin_loss(), impact.error_estimate()))
    }

    fn outcome(&self, spin_loss: f64, error_estimate: f64) -> SpinOutcome {
        let [one, two] = self.bodies;
        let relative = self.relative_spin();
        let mobility = one.inverse_moment + two.inverse_moment;
        let impulse = if mobility > 0.0 { -spin_loss * relative / mobility } else { 0.0 };
        let spins =
            [one.spin + one.inverse_moment * impulse, two.spin - two.inverse_moment * impulse];
        let energy_loss = -0.5 * impulse * relative * (2.0 - spin_loss);
        let spin_ratio = 1.0 - spin_loss;
        SpinOutcome { spins, spin_ratio, torque_impulse: impulse, energy_loss, error_estimate }
    }
}
