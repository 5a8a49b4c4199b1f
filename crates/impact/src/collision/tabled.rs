//! Rebounds of one collision for many frictions, ratios of stiffness and losses, from the table of R_x.

use carom_special::RangeError;
use nalgebra::Vector3;

use super::{Collision, CollisionError};
use crate::body::Body;
use crate::motion::Motion;
use crate::normal_restitution::NormalRestitution;
use crate::oblique::Groups;
use crate::outcome::TorsionMode;
use crate::restitution::RestitutionTable;

/// A collision of spheres or planes whose motion and bodies are kept, while friction, ratio of stiffness and loss vary.
///
/// Its rebound comes from [`RestitutionTable`]: within 1e-8 of R_x without a loss, within 3e-3 with a loss of a viscous
/// material, in a fraction of a microsecond. It serves fits, which ask for very many.
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::{Body, Collision, Motion};
/// use carom_laws::friction::Friction;
/// let glass = Material::from_young(70e9, 0.22)?;
/// let ball = Body::sphere(1.5e-3, glass, 3.5e-5)?.moving(Motion::new([0.3, 0.0, -1.0], [0.0; 3])?);
/// let collision = Collision::new(ball, Body::plane(glass), Friction::new(0.1)?)?;
/// let tabled = collision.tabled().ok_or("spheres of one material")?;
/// let quick = tabled.rebound(0.2, 1.1, 1.0)?;
/// let outcome = collision.with_friction(Friction::new(0.2)?)?.with_stiffness_ratio(1.1)?.solve()?;
/// let exact = outcome.motions()[0];
/// assert!((quick.motions[0].spin - exact.spin).norm() < 1e-5 * exact.spin.norm());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct TabledCollision {
    collision: Collision,
    /// Velocity of body 2 against body 1 before, in contact axes.
    before: Vector3<f64>,
    /// The motions before, and their changes when the contact velocity loses its tangential and its normal part once.
    motions: [[Motion; 2]; 3],
    slip: f64,
    /// D_tt and D_zz.
    mobility: [f64; 2],
    /// Normal over tangential stiffness of this collision.
    stiffness_ratio: f64,
    /// Normal restitution of this collision, and whether its bodies yield.
    loss: (f64, bool),
}

/// The part of a rebound that the table gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TabledRebound {
    /// The motions afterwards, of body 1 and body 2.
    pub motions: [Motion; 2],
    /// Tangential restitution.
    pub r_x: f64,
    /// Velocity of body 2 against body 1 at the contact afterwards, in contact axes.
    pub contact_velocity: Vector3<f64>,
}

impl Collision {
    /// This collision by the table of R_x; none if its analytic rebound is not that of the table: for other bodies, for bodies
    /// that do not approach, for static friction, where the loss is not one restitution of a Kelvin-Voigt material or of yield, where friction acts on the spin about the normal, and for balls whose line
    /// of centres turns.
    #[must_use]
    pub fn tabled(&self) -> Option<TabledCollision> {
        let loss = self.normal_restitution.constant()?;
        if !self.is_plain() {
            return None;
        }
        let before = self.velocity();
        let d = self.mobility.matrix();
        let stiffness = self.stiffness();
        let whole = [
            Vector3::new(before.x / d.m11, before.y / d.m11, 0.0),
            Vector3::new(0.0, 0.0, before.z / d.m33),
        ];
        let own = self.bodies.each_ref().map(Body::motion);
        let [across, along] = whole.map(|impulse| change(&self.pushed(&impulse), &own));
        Some(TabledCollision {
            collision: self.clone(),
            before,
            motions: [own, across, along],
            slip: libm::hypot(before.x, before.y),
            mobility: [d.m11, d.m33],
            stiffness_ratio: stiffness.c_z / stiffness.c_x,
            loss,
        })
    }

    /// Whether the impact without a loss is that of [`Groups`]: of spheres or planes that approach, with one coefficient of
    /// friction that does not act on the spin about the normal, and with centres whose line does not turn.
    pub(super) fn is_plain(&self) -> bool {
        let speed = self.velocity().z;
        if speed <= 0.0 || !self.is_symmetric() || self.static_friction.is_some() {
            return false;
        }
        let twists = match self.torsion {
            TorsionMode::LeftOut => false,
            TorsionMode::Included => true,
            TorsionMode::Auto => self.twist_bound().spin > Self::NEGLIGIBLE_COUPLING,
        };
        !twists && self.pulse(speed).is_ok_and(|pulse| !self.turns_centres(pulse.duration()))
    }
}

fn change(after: &[Motion; 2], before: &[Motion; 2]) -> [Motion; 2] {
    [0, 1].map(|i| Motion {
        velocity: after[i].velocity - before[i].velocity,
        spin: after[i].spin - before[i].spin,
    })
}

impl TabledCollision {
    /// The collision with its own friction, ratio of stiffness and loss.
    #[must_use]
    pub const fn collision(&self) -> &Collision {
        &self.collision
    }

    /// Normal over tangential stiffness of the collision, kappa.
    #[must_use]
    pub const fn stiffness_ratio(&self) -> f64 {
        self.stiffness_ratio
    }

    /// The same with this loss; none unless it is one restitution of a Kelvin-Voigt material or of yield.
    #[must_use]
    pub fn with_normal_restitution(self, loss: &NormalRestitution) -> Option<Self> {
        Some(Self { loss: loss.constant()?, ..self })
    }

    /// Normal restitution of the collision.
    #[must_use]
    pub const fn normal_restitution(&self) -> f64 {
        self.loss.0
    }

    /// Velocity of body 2 against body 1 at the contact before, in contact axes.
    #[must_use]
    pub const fn contact_velocity(&self) -> Vector3<f64> {
        self.before
    }

    /// The motions before.
    #[must_use]
    pub const fn motions(&self) -> [Motion; 2] {
        self.motions[0]
    }

    /// Tangential over normal velocity before.
    #[must_use]
    pub fn slope(&self) -> f64 {
        self.slip / self.before.z
    }

    /// Whether the contact slides throughout with this friction and ratio of stiffness, without a loss: R_x then tells
    /// friction alone.
    #[must_use]
    pub fn slides(&self, friction: f64, stiffness_ratio: f64) -> bool {
        let chi = self.mobility[0] / (self.mobility[1] * stiffness_ratio);
        let psi = self.slope() / (stiffness_ratio * friction);
        psi >= (2.0 * chi - 1.0).max(1.0)
    }

    /// The rebound with this friction, ratio of stiffness and normal restitution, of the cause of loss of the collision.
    ///
    /// # Errors
    /// [`CollisionError::Range`] for a number out of range; [`CollisionError::Oblique`] where the table falls back on an impact
    /// that cannot be computed.
    pub fn rebound(
        &self,
        friction: f64,
        stiffness_ratio: f64,
        normal_restitution: f64,
    ) -> Result<TabledRebound, CollisionError> {
        RangeError::positive("normal_over_tangential_stiffness", stiffness_ratio)?;
        RangeError::check("friction", friction, friction >= 0.0, ">= 0")?;
        let holds = (0.0..=1.0).contains(&normal_restitution);
        RangeError::check("normal_restitution", normal_restitution, holds, "from 0 to 1")?;
        let [along, normal] = self.mobility;
        let psi = match (self.slip, friction) {
            (0.0, _) => 0.0,
            (_, 0.0) => f64::INFINITY,
            (slip, friction) => slip / (self.before.z * stiffness_ratio * friction),
        };
        let groups = Groups::new(along / (normal * stiffness_ratio), psi)?;
        let (e, table) = (normal_restitution, RestitutionTable::shared());
        let r_x = match self.loss.1 {
            true => 0.5 * (1.0 + e) * (1.0 + table.restitution(groups)?) - 1.0,
            false => table.restitution_with(groups, e)?,
        };
        let after = Vector3::new(
            -r_x * self.before.x,
            -r_x * self.before.y,
            -normal_restitution * self.before.z,
        );
        let [own, across, along] = &self.motions;
        let motions = [0, 1].map(|i| {
            let sum = |part: fn(&Motion) -> &Vector3<f64>| {
                part(&own[i]) + part(&across[i]) * (1.0 + r_x) + part(&along[i]) * (1.0 + e)
            };
            Motion { velocity: sum(|motion| &motion.velocity), spin: sum(|motion| &motion.spin) }
        });
        Ok(TabledRebound { motions, r_x, contact_velocity: after })
    }
}
