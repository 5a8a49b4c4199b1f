//! Two spheres, or a sphere and a plane: the uncoupled oblique impact with its dimensions.

use carom_halfspace::MaterialPair;
use carom_laws::curvature::{CurvatureError, RelativeCurvature};
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_special::RangeError;
use nalgebra::{Matrix3, Vector3};

use crate::body::{Body, Motion, Shape, kinetic_energy};
use crate::closed_form::NOTICEABLE;
use crate::mobility::{point_velocity, share};
use crate::normal::{self, NormalImpact};
use crate::normal_spin::{NormalSpin, NormalSpinError, Pivot};
use crate::oblique::{Groups, ObliqueError, ObliqueImpact};
use crate::outcome::{
    EnergyBudget, HistoryPoint, LogEntry, Outcome, Rebound, TorsionMode, Warning,
};
use crate::wave_share::wave_share;

/// Why a collision cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum CollisionError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The bodies make no point contact.
    #[error(transparent)]
    Curvature(#[from] CurvatureError),
    /// Neither body can move.
    #[error("both bodies are infinitely heavy: mass = inf must be finite for at least one")]
    BothHeldFast,
    /// The oblique impact could not be followed.
    #[error(transparent)]
    Oblique(#[from] ObliqueError),
    /// Torsion was asked for and cannot be given.
    #[error(transparent)]
    NormalSpin(#[from] NormalSpinError),
}

/// A collision of two spheres, or of a sphere and a plane, with any motion.
///
/// Rotation symmetry keeps the tangential motion in one direction and uncouples it from the
/// normal one, so the outcome is exact for materials with epsilon = 0 (5.20); for others it
/// carries [`Warning::Coupling`]. The spin about the normal is left alone, apart from
/// [`Collision::with_torsion`].
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::{Body, Collision, Motion};
/// use carom_laws::friction::Friction;
/// let steel = Material::from_shear(80e9, 0.3)?;
/// let ball = |z| -> Result<Body, carom_special::RangeError> {
///     Ok(Body::sphere(0.01, steel, 0.0329)?.moving(Motion::new([0.0, 0.0, z], [0.0; 3])?))
/// };
/// // z points from body 2 into body 1.
/// let outcome = Collision::new(ball(-1.0)?, ball(1.0)?, Friction::new(0.15)?)?.solve()?;
/// assert!((outcome.motions()[0].velocity.z - 1.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Collision {
    bodies: [Body; 2],
    friction: Friction,
    materials: MaterialPair,
    hertz: Hertz,
    normal: Vector3<f64>,
    torsion: TorsionMode,
}

impl Collision {
    /// Body 1 above body 2: the common normal, from body 2 into body 1, is the z axis.
    ///
    /// # Errors
    /// [`CollisionError`] if both bodies are rigid or held fast, or both are planes.
    pub fn new(body_1: Body, body_2: Body, friction: Friction) -> Result<Self, CollisionError> {
        let materials = MaterialPair::new(body_1.material(), body_2.material())?;
        let (one, two) = (body_1.shape().radii()?, body_2.shape().radii()?);
        let hertz = Hertz::new(RelativeCurvature::new(one, two, 0.0)?, materials)?;
        if body_1.inertia().inverse_mass() + body_2.inertia().inverse_mass() == 0.0 {
            return Err(CollisionError::BothHeldFast);
        }
        let bodies = [body_1, body_2];
        let torsion = TorsionMode::default();
        Ok(Self { bodies, friction, materials, hertz, normal: Vector3::z(), torsion })
    }

    /// The same collision with another common normal, from body 2 into body 1.
    ///
    /// # Errors
    /// [`RangeError`] unless the vector is finite and not zero.
    pub fn along(self, normal: [f64; 3]) -> Result<Self, CollisionError> {
        let vector = Vector3::from(normal);
        let length = vector.norm();
        RangeError::positive("normal", length)?;
        Ok(Self { normal: vector / length, ..self })
    }

    /// The same collision with the torsional impact of chapter 10 on the spin about the normal.
    ///
    /// Without it that spin is left alone; [`Warning::SpinLeftAlone`] says where that matters, and
    /// it changes by the order of zeta_max/R. The torsional impact is computed as if there were no
    /// tangential one: an approximation where both slip, for they share one friction.
    ///
    /// ```
    /// use carom_halfspace::Material;
    /// use carom_impact::{Body, Collision, Motion};
    /// use carom_laws::friction::Friction;
    /// let rubber = Material::from_shear(1e6, 0.5)?;
    /// let ball = Body::sphere(0.02, rubber, 0.0369)?
    ///     .moving(Motion::new([0.0, 0.0, -1.0], [0.0, 0.0, 100.0])?);
    /// let floor = Body::plane(Material::RIGID);
    /// let outcome = Collision::new(ball, floor, Friction::new(0.8)?)?.with_torsion().solve()?;
    /// let spin = outcome.motions()[0].spin.z;
    /// assert!(spin < 100.0 && spin > 70.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub const fn with_torsion(self) -> Self {
        Self { torsion: TorsionMode::Included, ..self }
    }

    /// The common normal, from body 2 into body 1, of length 1.
    #[must_use]
    pub const fn normal(&self) -> Vector3<f64> {
        self.normal
    }

    /// The Hertz contact of the two bodies.
    #[must_use]
    pub fn hertz(&self) -> Hertz {
        self.hertz
    }

    /// Follow the collision to separation.
    ///
    /// # Errors
    /// [`CollisionError::Oblique`] if the walk fails, [`CollisionError::Range`] if a derived
    /// quantity overflows, [`CollisionError::NormalSpin`] if torsion was asked for and cannot be
    /// given.
    pub fn solve(&self) -> Result<Outcome, CollisionError> {
        let Some(approach) = self.approach()? else {
            return Ok(Outcome::NoImpact { motions: self.bodies.map(|body| body.motion()) });
        };
        let oblique = ObliqueImpact::new(approach.groups)?;
        Ok(Outcome::Rebound(Box::new(self.rebound(&approach, &oblique)?)))
    }

    /// The course of the impact at `count` instants equally spaced in time, touch and separation
    /// included; empty without an impact.
    ///
    /// # Errors
    /// As [`Collision::solve`]; [`RangeError`] for fewer than two instants.
    pub fn history(&self, count: usize) -> Result<Vec<HistoryPoint>, CollisionError> {
        RangeError::check("history points", count as f64, count >= 2, ">= 2")?;
        let Some(approach) = self.approach()? else {
            return Ok(Vec::new());
        };
        let step = normal::DURATION / (count - 1) as f64;
        // The normal motion by time: the velocity alone does not resolve the first instants.
        let times: Vec<f64> = (0..count - 1).map(|i| step * i as f64).collect();
        let normal: Vec<_> =
            times.iter().chain(&[normal::DURATION]).map(|t| normal::state_at(*t)).collect();
        let velocities: Vec<f64> = normal.iter().map(|state| state.velocity).collect();
        let trace = ObliqueImpact::trace(approach.groups, &velocities)?;
        let unit = approach.normal.maximal_approach();
        let clock = approach.normal.time_unit();
        let (force, speed) = (approach.normal.maximal_force(), approach.normal.velocity());
        let slip = approach.tangential_speed;
        let stiffness = self.hertz.stiffness();
        let tangential = force * stiffness.c_x / stiffness.c_z * slip / speed;
        trace
            .iter()
            .zip(times.iter().chain(&[normal::DURATION]))
            .zip(&normal)
            .map(|((point, time), state)| {
                let zeta = state.compression;
                Ok(HistoryPoint {
                    time: clock * time,
                    approach: unit * zeta,
                    approach_velocity: speed * point.normal_velocity,
                    normal_force: force * zeta * zeta.sqrt(),
                    contact_radius: self.radius(unit * zeta)?,
                    shift: slip * clock * point.shift,
                    shift_velocity: slip * point.velocity,
                    tangential_force: if slip > 0.0 { tangential * point.force } else { 0.0 },
                    stick_radius: self.radius(unit * point.stick_depth.min(zeta))?,
                    regime: point.regime,
                })
            })
            .collect()
    }

    fn radius(&self, approach: f64) -> Result<f64, CollisionError> {
        if approach <= 0.0 {
            return Ok(0.0);
        }
        Ok(self.hertz.ellipse(approach)?.semi_axis_a())
    }

    // From the centre of mass to the contact point: body 1 lies on the side of the normal.
    fn arms(&self) -> [Vector3<f64>; 2] {
        let [one, two] = self.bodies;
        [-one.shape().arm() * self.normal, two.shape().arm() * self.normal]
    }

    // Body 2 against body 1 at the contact point.
    fn relative_velocity(&self, motions: &[Motion; 2]) -> Vector3<f64> {
        let arms = self.arms();
        let of = |i: usize| point_velocity(&motions[i].velocity, &motions[i].spin, &arms[i]);
        of(1) - of(0)
    }

    fn approach(&self) -> Result<Option<Approach>, CollisionError> {
        let motions = self.bodies.map(|body| body.motion());
        let velocity = self.relative_velocity(&motions);
        let normal_speed = velocity.dot(&self.normal);
        if normal_speed <= 0.0 {
            return Ok(None);
        }
        let tangent = velocity - normal_speed * self.normal;
        let tangential_speed = tangent.norm();
        let direction =
            if tangential_speed > 0.0 { tangent / tangential_speed } else { Vector3::zeros() };
        let mobility = self.mobility(&direction);
        let stiffness = self.hertz.stiffness();
        let normal = NormalImpact::new(mobility.normal, stiffness.c_z, normal_speed)?;
        let chi = mobility.tangential * stiffness.c_x / (mobility.normal * stiffness.c_z);
        let ratio = stiffness.c_x / stiffness.c_z * tangential_speed / normal_speed;
        let psi = if tangential_speed == 0.0 { 0.0 } else { ratio / self.friction.get() };
        let groups = Groups::new(chi, psi)?;
        Ok(Some(Approach { velocity, direction, tangential_speed, mobility, normal, groups }))
    }

    fn mobility(&self, direction: &Vector3<f64>) -> Mobility {
        let arms = self.arms();
        let inverse =
            |i: usize| Matrix3::from_diagonal(&self.bodies[i].inertia().inverse_moments());
        let of = |i: usize| share(&self.bodies[i].inertia(), &inverse(i), &arms[i]);
        let d = of(0) + of(1);
        let normal =
            self.bodies[0].inertia().inverse_mass() + self.bodies[1].inertia().inverse_mass();
        Mobility { normal, tangential: direction.dot(&(d * direction)).max(normal) }
    }

    fn rebound(
        &self,
        approach: &Approach,
        oblique: &ObliqueImpact,
    ) -> Result<Rebound, CollisionError> {
        let restitution = oblique.restitution();
        let Approach { velocity, direction, tangential_speed: slip, mobility, normal, .. } =
            approach;
        let normal_impulse = 2.0 * normal.velocity() / mobility.normal;
        let tangential_impulse = (1.0 + restitution) * slip / mobility.tangential;
        let impulse = normal_impulse * self.normal + tangential_impulse * direction;
        let mut motions = self.after(&impulse);
        let velocity_after = -restitution * *slip * direction - normal.velocity() * self.normal;
        let mut dissipated =
            0.5 * slip * slip * (1.0 - restitution) * (1.0 + restitution) / mobility.tangential;
        let spin = self.normal_spin(approach);
        let torsion = match self.torsion {
            TorsionMode::LeftOut => None,
            TorsionMode::Included => Some(spin.solve()?),
        };
        if let Some(torsion) = &torsion {
            motions.iter_mut().enumerate().for_each(|(i, m)| m.spin += spin.turn(i, torsion));
            dissipated += torsion.dissipated;
        }
        let kinetic = |motion: [Motion; 2]| {
            kinetic_energy(&self.bodies[0].inertia(), &motion[0])
                + kinetic_energy(&self.bodies[1].inertia(), &motion[1])
        };
        let energy = EnergyBudget {
            before: kinetic(self.bodies.map(|body| body.motion())),
            after: kinetic(motions),
            dissipated,
        };
        let maximal_radius = self.radius(normal.maximal_approach())?;
        Ok(Rebound {
            motions,
            impulse,
            velocity_before: *velocity,
            velocity_after,
            tangential_restitution: restitution,
            duration: normal.duration(),
            maximal_force: normal.maximal_force(),
            maximal_approach: normal.maximal_approach(),
            maximal_radius,
            energy,
            torsion,
            compressions: 1,
            error_estimate: 0.0,
            log: log(normal, oblique),
            warnings: self.warnings(maximal_radius, approach),
        })
    }

    fn normal_spin(&self, approach: &Approach) -> NormalSpin<'_> {
        let arms = self.arms();
        let pivot = |i: usize| Pivot {
            arm: arms[i],
            inverse_tensor: Matrix3::from_diagonal(&self.bodies[i].inertia().inverse_moments()),
            spin: self.bodies[i].motion().spin,
        };
        NormalSpin {
            hertz: &self.hertz,
            friction: self.friction,
            normal: self.normal,
            pivots: [pivot(0), pivot(1)],
            normal_mobility: approach.mobility.normal,
            velocity: approach.normal.velocity(),
        }
    }

    fn after(&self, impulse: &Vector3<f64>) -> [Motion; 2] {
        let arms = self.arms();
        [1.0, -1.0].map(|sign| {
            let i = usize::from(sign < 0.0);
            let (inertia, motion) = (self.bodies[i].inertia(), self.bodies[i].motion());
            let push = sign * impulse;
            let turn = inertia.inverse_moments().component_mul(&arms[i].cross(&push));
            Motion {
                velocity: motion.velocity + push * inertia.inverse_mass(),
                spin: motion.spin + turn,
            }
        })
    }

    fn warnings(&self, maximal_radius: f64, approach: &Approach) -> Vec<Warning> {
        let mut warnings = Vec::new();
        if !self.materials.is_uncoupled() {
            let gamma = self.materials.gamma();
            let friction_over_gamma = self.friction.get() / gamma.abs();
            warnings.push(Warning::Coupling { gamma, friction_over_gamma });
        }
        let ratio = self
            .bodies
            .iter()
            .filter_map(|body| match body.shape() {
                Shape::Sphere(radius) => Some(maximal_radius / radius),
                Shape::Plane => None,
            })
            .fold(0.0, f64::max);
        if ratio > 0.1 {
            warnings.push(Warning::LargeContact { ratio });
        }
        let share = self.bodies.iter().filter_map(|body| wave_loss_of(body, &approach.normal));
        let share = share.fold(0.0, f64::max);
        if share > NOTICEABLE {
            warnings.push(Warning::WaveLoss { share });
        }
        if self.torsion == TorsionMode::LeftOut {
            warnings.extend(self.normal_spin(approach).left_alone());
        }
        warnings
    }
}

// The share of energy a solid sphere loses to waves; nothing for rigid and infinitely heavy ones.
fn wave_loss_of(body: &Body, pulse: &NormalImpact) -> Option<f64> {
    let Shape::Sphere(radius) = body.shape() else { return None };
    let volume = 4.0 / 3.0 * std::f64::consts::PI * radius * radius * radius;
    wave_share(body.material(), body.inertia().mass() / volume, pulse)
}

/// The state at first touch.
struct Approach {
    velocity: Vector3<f64>,
    direction: Vector3<f64>,
    tangential_speed: f64,
    mobility: Mobility,
    normal: NormalImpact,
    groups: Groups,
}

/// D_zz and D_xx along the slip direction.
struct Mobility {
    normal: f64,
    tangential: f64,
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
