//! Two spheres, or a sphere and a plane: the uncoupled oblique impact with its dimensions.

use carom_geometry::{Attitude, perpendicular};
use carom_halfspace::MaterialPair;
use carom_laws::curvature::{CurvatureError, RelativeCurvature};
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;
use nalgebra::{Matrix3, Vector3};

use crate::body::{Body, Motion, Shape, kinetic_energy};
use crate::closed_form::NOTICEABLE;
use crate::mobility::{Lever, Mobility};
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
/// carries [`Warning::Coupling`]. Spheres whose moments of inertia differ about the tangents of the
/// contact are refused: they are for an [`crate::Encounter`]. The spin about the normal is left alone, apart from
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
    /// quantity overflows or moments of inertia differ about the tangents of the contact, [`CollisionError::NormalSpin`] if torsion was asked for and cannot be
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
        let slip = approach.slip;
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

    // Body 1 lies on the side of the normal; the centres of spheres lie on it.
    fn levers(&self) -> [Lever; 2] {
        [-1.0, 1.0].map(|side: f64| {
            let body = &self.bodies[usize::from(side > 0.0)];
            let height = side * body.shape().arm();
            Lever::upright(body.inertia(), &Attitude::ALIGNED, &self.normal, height)
        })
    }

    fn approach(&self) -> Result<Option<Approach>, CollisionError> {
        let levers = self.levers();
        let of = |i: usize| {
            let motion = self.bodies[i].motion();
            levers[i].point_velocity(&motion.velocity, &motion.spin)
        };
        // Body 2 against body 1 at the contact point.
        let velocity = of(1) - of(0);
        let speed = velocity.dot(&self.normal);
        if speed <= 0.0 {
            return Ok(None);
        }
        let (slip, direction) = length_and_direction(&across(&velocity, &self.normal));
        // Any direction does where there is no slip.
        let x = direction.unwrap_or_else(|| perpendicular(&self.normal));
        let axes = Matrix3::from_columns(&[x, self.normal.cross(&x), self.normal]);
        let mobility = Mobility::new(&levers, &axes)?;
        let (along, normal_mobility) = self.symmetric(&mobility)?;
        let ContactStiffness { c_x, c_z, .. } = self.hertz.stiffness();
        let normal = NormalImpact::new(normal_mobility, c_z, speed)?;
        let chi = along * c_x / (normal_mobility * c_z);
        let psi = match self.friction.coefficient() {
            None => 0.0,
            Some(0.0) => f64::INFINITY,
            Some(f) => c_x / c_z * slip / speed / f,
        };
        let groups = Groups::new(chi, psi)?;
        Ok(Some(Approach { velocity, slip, axes, levers, mobility: along, normal, groups }))
    }

    // D_xx and D_zz, unless a sphere turns more easily about one tangent than about the other: that
    // would turn the slip out of its direction.
    fn symmetric(&self, mobility: &Mobility) -> Result<(f64, f64), RangeError> {
        let d = mobility.matrix();
        let skew = (d.m11 - d.m22).abs().max(2.0 * d.m12.abs());
        if skew > 1e-12 * d.m11 {
            let [one, two] = self.bodies.map(|body| body.inertia());
            let uneven = if one.is_isotropic() { two } else { one };
            let allowed = "the same about all tangents of the contact (else use an Encounter)";
            return Err(RangeError::new("moment of inertia", uneven.moments()[0], allowed));
        }
        Ok((d.m11, d.m33))
    }

    fn rebound(
        &self,
        approach: &Approach,
        oblique: &ObliqueImpact,
    ) -> Result<Rebound, CollisionError> {
        let restitution = oblique.restitution();
        let Approach { velocity, slip, axes, levers, mobility, normal, .. } = approach;
        let tangential_impulse = (1.0 + restitution) * slip / mobility;
        let impulse = Vector3::new(tangential_impulse, 0.0, normal.impulse());
        let mut motions = [1.0, -1.0].map(|sign: f64| {
            let i = usize::from(sign < 0.0);
            levers[i].pushed(axes, &self.bodies[i].motion(), &(sign * impulse))
        });
        let velocity_after = axes * Vector3::new(-restitution * slip, 0.0, -normal.velocity());
        let mut dissipated =
            0.5 * slip * slip * (1.0 - restitution) * (1.0 + restitution) / mobility;
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
        let maximal_contact = self.hertz.ellipse(normal.maximal_approach())?;
        Ok(Rebound {
            motions,
            impulse: axes * impulse,
            velocity_before: *velocity,
            velocity_after,
            tangential_restitution: Some(restitution),
            duration: normal.duration(),
            maximal_force: normal.maximal_force(),
            maximal_approach: normal.maximal_approach(),
            maximal_contact,
            energy,
            torsion,
            compressions: 1,
            error_estimate: 0.0,
            log: log(normal, oblique),
            warnings: self.warnings(maximal_contact.semi_axis_b(), approach),
        })
    }

    fn normal_spin(&self, approach: &Approach) -> NormalSpin<'_> {
        let pivot = |i: usize| Pivot {
            arm: approach.levers[i].arm(),
            inverse_tensor: *approach.levers[i].inverse_tensor(),
            spin: self.bodies[i].motion().spin,
        };
        NormalSpin {
            hertz: &self.hertz,
            friction: self.friction,
            normal: self.normal,
            pivots: [pivot(0), pivot(1)],
            normal_mobility: approach.normal.mobility(),
            velocity: approach.normal.velocity(),
        }
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
    /// The tangential speed.
    slip: f64,
    /// The slip direction, the one across it and the normal, as columns.
    axes: Matrix3<f64>,
    levers: [Lever; 2],
    /// D_xx.
    mobility: f64,
    normal: NormalImpact,
    groups: Groups,
}

// What of a vector lies across a unit vector; twice, for the first difference keeps a rounding of
// the whole.
fn across(vector: &Vector3<f64>, normal: &Vector3<f64>) -> Vector3<f64> {
    let once = vector - vector.dot(normal) * normal;
    once - once.dot(normal) * normal
}

// Without under- or overflow of the squares.
fn length_and_direction(vector: &Vector3<f64>) -> (f64, Option<Vector3<f64>>) {
    let largest = vector.amax();
    if largest == 0.0 {
        return (0.0, None);
    }
    let scaled = vector / largest;
    let length = scaled.norm();
    (largest * length, Some(scaled / length))
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
