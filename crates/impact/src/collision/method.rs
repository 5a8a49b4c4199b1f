//! How a collision is followed, by its shapes.

use carom_laws::friction::Friction;
use carom_laws::stiffness::ContactStiffness;
use nalgebra::Vector3;

use super::{Collision, CollisionError};
use crate::coupled::{CoupledImpact, CoupledOutcome, ImpactMethod, VectorLaw};
use crate::normal::{self, NormalImpact};
use crate::oblique::{Groups, ObliqueImpact};
use crate::outcome::{LogEntry, Torsion, Warning};

/// Differences of D between tangents below this part of it are round-off.
const EVEN: f64 = 1e-12;

/// How a collision is followed.
pub(super) enum Method {
    /// Spheres and planes that turn as easily about all tangents: the tangential motion keeps its
    /// direction and stays exactly apart from the normal one.
    Symmetric(Symmetric),
    /// All others, by their matrices.
    Coupled(CoupledImpact),
}

/// An impact with rotation symmetry about the normal, in contact axes.
pub(super) struct Symmetric {
    pub(super) velocity: Vector3<f64>,
    /// The tangential speed and its direction; any direction where there is none.
    pub(super) slip: f64,
    pub(super) direction: Vector3<f64>,
    /// D_xx.
    mobility: f64,
    friction: Friction,
    pub(super) normal: NormalImpact,
    pub(super) groups: Groups,
    method: ImpactMethod,
}

/// What an impact did, in contact axes.
pub(crate) struct Passed {
    pub(super) before: Vector3<f64>,
    pub(super) after: Vector3<f64>,
    /// On body 1.
    pub(super) impulse: Vector3<f64>,
    /// What friction took; none where it follows from the velocities.
    pub(super) dissipated: Option<f64>,
    /// R_x, where the method itself knows it.
    pub(crate) restitution: Option<f64>,
    /// What became of the spin about the normal, where the method itself knows it.
    pub(crate) torsion: Option<Torsion>,
    pub(super) duration: f64,
    pub(super) maximal_force: f64,
    pub(super) maximal_approach: f64,
    pub(super) compressions: u32,
    pub(super) method: ImpactMethod,
    pub(super) error_estimate: f64,
    pub(super) log: Vec<LogEntry>,
    pub(super) warning: Option<Warning>,
}

impl Collision {
    /// None if the bodies do not approach each other.
    pub(super) fn method(&self) -> Result<Option<Method>, CollisionError> {
        let velocity = self.velocity();
        if velocity.z <= 0.0 {
            return Ok(None);
        }
        let d = self.mobility.matrix();
        let skew = (d.m11 - d.m22).abs().max(2.0 * d.m12.abs());
        let is_round = self.bodies.iter().all(|body| body.height().is_some());
        if is_round && skew <= EVEN * d.m11 {
            return Ok(Some(Method::Symmetric(self.symmetric(velocity)?)));
        }
        Ok(self.impact()?.map(Method::Coupled))
    }

    fn symmetric(&self, velocity: Vector3<f64>) -> Result<Symmetric, CollisionError> {
        let (slip, direction) = length_and_direction(&velocity);
        let d = self.mobility.matrix();
        let ContactStiffness { c_x, c_z, .. } = self.hertz.stiffness();
        let normal = NormalImpact::new(d.m33, c_z, velocity.z)?;
        let (psi, method) = match self.friction.coefficient() {
            None => (0.0, ImpactMethod::Uncoupled { direction }),
            Some(0.0) => (f64::INFINITY, ImpactMethod::Frictionless),
            Some(f) => (c_x / c_z * slip / velocity.z / f, ImpactMethod::Uncoupled { direction }),
        };
        let groups = Groups::new(d.m11 * c_x / (d.m33 * c_z), psi)?;
        let friction = self.friction;
        Ok(Symmetric {
            velocity,
            slip,
            direction,
            mobility: d.m11,
            friction,
            normal,
            groups,
            method,
        })
    }
}

impl Method {
    pub(super) fn follow(&self, law: VectorLaw) -> Result<Passed, CollisionError> {
        match self {
            Self::Symmetric(symmetric) => symmetric.follow(),
            Self::Coupled(impact) => {
                let (outcome, log) = impact.solve_with_log(law)?;
                Ok(Passed::coupled(impact.velocity(), outcome, log))
            }
        }
    }
}

impl Passed {
    /// By its matrices.
    pub(crate) fn coupled(
        before: Vector3<f64>,
        outcome: CoupledOutcome,
        log: Vec<LogEntry>,
    ) -> Self {
        Self {
            before,
            after: outcome.velocity,
            impulse: outcome.impulse,
            dissipated: None,
            restitution: None,
            torsion: None,
            duration: outcome.duration,
            maximal_force: outcome.maximal_force,
            maximal_approach: outcome.maximal_approach,
            compressions: outcome.compressions,
            method: outcome.method,
            error_estimate: outcome.error_estimate,
            log,
            warning: outcome.warning,
        }
    }
}

impl Symmetric {
    fn follow(&self) -> Result<Passed, CollisionError> {
        let Self { slip, direction, normal, .. } = self;
        let oblique = ObliqueImpact::new(self.groups)?;
        let restitution = oblique.restitution();
        let mut after = direction * (-restitution * slip);
        after.z = -self.velocity.z;
        let limit = self.friction.get() * normal.impulse();
        let drag = oblique.drag(*slip, self.mobility, limit);
        let mut impulse = direction * drag;
        impulse.z = normal.impulse();
        let lost = 0.5 * slip * (1.0 - restitution) * drag;
        Ok(Passed {
            before: self.velocity,
            after,
            impulse,
            dissipated: Some(lost),
            restitution: Some(restitution),
            torsion: None,
            duration: normal.duration(),
            maximal_force: normal.maximal_force(),
            maximal_approach: normal.maximal_approach(),
            compressions: 1,
            method: self.method,
            error_estimate: 0.0,
            log: log(normal, &oblique),
            warning: None,
        })
    }
}

// Of the tangential part, without under- or overflow of the squares.
fn length_and_direction(velocity: &Vector3<f64>) -> (f64, Vector3<f64>) {
    let tangential = Vector3::new(velocity.x, velocity.y, 0.0);
    let largest = tangential.amax();
    if largest == 0.0 {
        return (0.0, Vector3::x());
    }
    let scaled = tangential / largest;
    let length = scaled.norm();
    (largest * length, scaled / length)
}

pub(crate) fn log(normal: &NormalImpact, oblique: &ObliqueImpact) -> Vec<LogEntry> {
    let unit = normal.time_unit();
    oblique
        .phases()
        .iter()
        .map(|phase| LogEntry {
            time: unit * normal::time(phase.start),
            event: phase.began_by,
            regime: phase.regime,
        })
        .collect()
}
