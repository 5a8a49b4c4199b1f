//! The collision of two bodies of any smooth shape, position and motion: contact point and rebound.

mod aftermath;
mod balls;
mod columns;
mod derivatives;
mod differences;
mod glancing;
mod history;
mod input;
mod instants;
mod loss_cause;
mod needed_law;
mod solver;
mod stiffness_ratio;
mod tabled;
mod twist_bound;
mod viscous_spin;

use carom_geometry::{ContactFrame, ContactPoint, SearchError};
use carom_halfspace::MaterialPair;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::static_friction::StaticFriction;
use carom_special::RangeError;
use nalgebra::{Matrix3, Vector3};

use crate::body::Body;
use crate::coupled::{CoupledError, CoupledImpact, TurningLaw, Unsettled};
use crate::impact_friction::ImpactFriction;
use crate::mobility::{Lever, Mobility};
use crate::motion::Motion;
use crate::normal_restitution::NormalRestitution;
use crate::normal_spin::NormalSpinError;
use crate::oblique::ObliqueError;
use crate::outcome::{Outcome, TorsionMode};

pub(crate) use aftermath::Known;
pub use derivatives::ReboundDerivatives;
pub use differences::ReboundDifferences;
use glancing::Axes;
pub use input::Input;
pub use instants::Instants;
pub use needed_law::NeededLaw;
pub use solver::{AnalyticOrRings, CollisionSolver};
pub use tabled::{TabledCollision, TabledRebound};
pub use twist_bound::TwistBound;

/// Relative differences of D between tangents below this value are round-off.
const EVEN: f64 = 1e-12;

/// Why a collision cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum CollisionError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// No contact point, or no elliptical contact there.
    #[error(transparent)]
    Search(SearchError),
    /// Neither body can move.
    #[error("both bodies are infinitely heavy: mass = inf must be finite for at least one")]
    BothHeldFast,
    /// The oblique impact could not be solved.
    #[error(transparent)]
    Oblique(#[from] ObliqueError),
    /// The coupled impact could not be solved.
    #[error(transparent)]
    Coupled(CoupledError),
    /// Torsion was requested but cannot be computed.
    #[error(transparent)]
    NormalSpin(#[from] NormalSpinError),
    /// With the law of rings the bodies do not separate.
    #[error("the bodies do not separate within 64 times the duration of a free impact")]
    NoSeparation,
}

impl From<SearchError> for CollisionError {
    fn from(error: SearchError) -> Self {
        match error {
            SearchError::Range(error) => Self::Range(error),
            error => Self::Search(error),
        }
    }
}

impl From<CoupledError> for CollisionError {
    fn from(error: CoupledError) -> Self {
        match error {
            CoupledError::Range(error) => Self::Range(error),
            CoupledError::Oblique(error) => Self::Oblique(error),
            error => Self::Coupled(error),
        }
    }
}

/// Two bodies that touch. z points from body 2 into body 1.
///
/// The shapes determine the method. The rotational symmetry of spheres and planes keeps the tangential motion
/// in one direction and independent of the normal motion: the outcome is exact for materials with epsilon = 0
/// (5.20); for others it warns of [`carom_laws::validity::Limit::Coupling`]. For all other bodies the method is that of
/// [`CoupledImpact`]. The spin about the normal is not changed, except by [`Collision::with_torsion`].
///
/// ```
/// use carom_geometry::Surface;
/// use carom_halfspace::Material;
/// use carom_impact::{Body, Collision, Motion};
/// use carom_laws::friction::Friction;
/// let steel = Material::from_shear(80e9, 0.3)?;
/// let ball = |z| -> Result<Body, carom_special::RangeError> {
///     Ok(Body::sphere(0.01, steel, 0.0329)?.moving(Motion::new([0.0, 0.0, z], [0.0; 3])?))
/// };
/// let outcome = Collision::new(ball(-1.0)?, ball(1.0)?, Friction::new(0.15)?)?.solve()?;
/// assert!((outcome.motions()[0].velocity.z - 1.0).abs() < 1e-15);
/// // An ellipsoid that touches a plane.
/// let egg = Surface::ellipsoid([0.03, 0.02, 0.015])?;
/// let inertia = egg.solid(0.296)?;
/// let egg = Body::new(egg, steel, inertia)
///     .at([0.0, 0.0, 0.015])?
///     .moving(Motion::new([-0.6, -0.4, -2.0], [0.0; 3])?);
/// let collision = Collision::touching(egg, Body::plane(steel), Friction::new(0.5)?)?;
/// assert!((collision.solve()?.motions()[0].velocity.z - 2.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Collision {
    bodies: [Body; 2],
    friction: Friction,
    static_friction: Option<StaticFriction>,
    law: TurningLaw,
    torsion: TorsionMode,
    normal_restitution: NormalRestitution,
    tolerance: Option<f64>,
    unsettled: Unsettled,
    /// Normal over tangential stiffness, if it is not that of the materials.
    stiffness_ratio: Option<f64>,
    axes: Axes,
    contact: ContactPoint,
    materials: MaterialPair,
    hertz: Hertz,
    levers: [Lever; 2],
    mobility: Mobility,
}

impl Collision {
    /// Two bodies in a standard position: body 1 on top of body 2 in their attitudes, with the common normal
    /// along the z axis of space. Body 2 keeps its position, body 1 is moved; a plane is rotated to face the
    /// other body.
    ///
    /// # Errors
    /// [`CollisionError::Search`] if they have no elliptical contact there (two planes, an edge),
    /// [`CollisionError::BothHeldFast`], [`CollisionError::Range`] if both are rigid.
    pub fn new(
        body_1: Body,
        body_2: Body,
        friction: impl Into<ImpactFriction>,
    ) -> Result<Self, CollisionError> {
        Self::along(body_1, body_2, [0.0, 0.0, 1.0], friction)
    }

    /// As [`Collision::new`], with another common normal, from body 2 into body 1.
    ///
    /// # Errors
    /// As [`Collision::new`]; [`CollisionError::Range`] unless the normal is finite and not zero.
    pub fn along(
        body_1: Body,
        body_2: Body,
        normal: [f64; 3],
        friction: impl Into<ImpactFriction>,
    ) -> Result<Self, CollisionError> {
        let ([one, two], contact) = ContactPoint::along(body_1.placed(), body_2.placed(), normal)?;
        let bodies = [body_1.with_place(one), body_2.with_place(two)];
        Self::build(bodies, friction.into(), contact)
    }

    /// Two bodies that touch at their given positions; the contact point is found by a search. The outcome
    /// carries [`crate::Warning::PointSampled`] if the search cannot prove that it is the only one.
    ///
    /// # Errors
    /// [`CollisionError::Search`] if the bodies do not touch, if they touch at an edge, or if there is no
    /// search for the pair; else as [`Collision::at`].
    pub fn touching(
        body_1: Body,
        body_2: Body,
        friction: impl Into<ImpactFriction>,
    ) -> Result<Self, CollisionError> {
        let contact = ContactPoint::find(body_1.placed(), body_2.placed())?;
        Self::build([body_1, body_2], friction.into(), contact)
    }

    /// Two separated bodies: body 1 moves straight, with the velocity of its centre relative to that of body
    /// 2, until they touch. Neither body rotates on the way.
    ///
    /// # Errors
    /// [`CollisionError::Search`] if they overlap or miss each other; else as
    /// [`Collision::touching`].
    pub fn meeting(
        body_1: Body,
        body_2: Body,
        friction: impl Into<ImpactFriction>,
    ) -> Result<Self, CollisionError> {
        let course = body_1.motion().velocity - body_2.motion().velocity;
        let (placed, contact) =
            ContactPoint::approaching(body_1.placed(), body_2.placed(), &course)?;
        Self::build([body_1.with_place(placed), body_2], friction.into(), contact)
    }

    /// Two bodies that touch at a given point of space.
    ///
    /// # Errors
    /// [`SearchError::Surface`] if the point does not lie on both surfaces or one has no tangent
    /// plane there, [`SearchError::Frame`] if the normals are not opposite or the surfaces
    /// conform or touch along a line, [`CollisionError::BothHeldFast`], [`CollisionError::Range`]
    /// if both materials are rigid.
    pub fn at(
        body_1: Body,
        body_2: Body,
        point: [f64; 3],
        friction: impl Into<ImpactFriction>,
    ) -> Result<Self, CollisionError> {
        let contact = ContactPoint::at(body_1.placed(), body_2.placed(), point)?;
        Self::build([body_1, body_2], friction.into(), contact)
    }

    /// Two bodies that touch with given points of their surfaces, each in axes of its body. Their centres
    /// need not be known; body 2 keeps its position and body 1 is moved.
    ///
    /// # Errors
    /// As [`Collision::at`].
    pub fn at_own_points(
        body_1: Body,
        body_2: Body,
        points: [[f64; 3]; 2],
        friction: impl Into<ImpactFriction>,
    ) -> Result<Self, CollisionError> {
        let (placed, contact) =
            ContactPoint::at_own_points(body_1.placed(), body_2.placed(), points)?;
        Self::build([body_1.with_place(placed), body_2], friction.into(), contact)
    }

    fn build(
        bodies: [Body; 2],
        friction: ImpactFriction,
        contact: ContactPoint,
    ) -> Result<Self, CollisionError> {
        let materials = MaterialPair::new(bodies[0].material(), bodies[1].material())?;
        let hertz = Hertz::new(contact.frame().relative_curvature(), materials)?;
        let (z, arms) = (contact.frame().z(), contact.arms());
        let levers = [bodies[0].lever(arms[0], &z, -1.0)?, bodies[1].lever(arms[1], &z, 1.0)?];
        if levers.iter().all(|lever| lever.mobility() == Matrix3::zeros()) {
            return Err(CollisionError::BothHeldFast);
        }
        let mobility = Mobility::new(&levers, contact.frame().axes())?;
        let static_friction = friction.static_friction();
        let friction = friction.at(&velocity(&bodies, &levers, contact.frame()))?;
        Ok(Self {
            bodies,
            friction,
            static_friction,
            law: TurningLaw::default(),
            torsion: TorsionMode::default(),
            normal_restitution: NormalRestitution::ELASTIC,
            tolerance: None,
            unsettled: Unsettled::Refused,
            stiffness_ratio: None,
            axes: Axes::default(),
            contact,
            materials,
            hertz,
            levers,
            mobility,
        })
    }

    /// The same collision with another law of friction for turning directions.
    #[must_use]
    pub fn with_law(self, law: TurningLaw) -> Self {
        Self { law, ..self }
    }

    /// The same collision with the torsional impact of chapter 10 on the spin about the normal.
    ///
    /// By default that spin is not changed. [`carom_laws::validity::Limit::Spin`] tells where friction would change
    /// it, [`carom_laws::validity::Limit::SpinOnShift`] where it would change R_x. The neglected change of the
    /// spin is of the order of zeta_max/R. The torsional impact is computed as if there were
    /// no tangential impact. This is an approximation if both slip, since they share one friction limit. A viscous loss
    /// multiplies the change of the spin by the ratio of those that rings give with it and without.
    /// [`Collision::solve`] then rejects bodies whose spin about the normal is coupled to other motion.
    /// Spheres, planes and bodies that touch at the end of an axis of symmetry are accepted.
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
    pub fn with_torsion(self) -> Self {
        self.with_torsion_mode(TorsionMode::Included)
    }

    /// The same collision with a loss in the material: an extension of the elastic theory, see [`NormalRestitution`]. With
    /// a loss by yield, duration, greatest force and history are those of the elastic impact.
    #[must_use]
    pub fn with_normal_restitution(self, normal_restitution: NormalRestitution) -> Self {
        // What cannot be had at this speed is refused where it is asked for.
        let here = normal_restitution.at(self.velocity().z);
        let normal_restitution = here.unwrap_or(normal_restitution);
        Self { normal_restitution, ..self }
    }

    /// The same collision with another tolerance of its impact than the default: the error of the contact velocity
    /// after the impact, over that before.
    ///
    /// Every law refines to it, and [`NeededLaw`] follows it. Analytic laws that do not reach it refuse the impact
    /// ([`CoupledError::NotSettled`]); rings and grids, whose finest resolution is given, return their best outcome
    /// with [`crate::Warning::NotSettled`].
    ///
    /// # Errors
    /// [`RangeError`] unless it is finite and positive.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        RangeError::positive("tolerance", tolerance)?;
        Ok(Self { tolerance: Some(tolerance), ..self })
    }

    /// The largest error of the tangential and of the normal velocity after the impact, over the velocity of approach,
    /// with which both keep the given tolerance.
    #[must_use]
    pub fn allowed_error(&self) -> Option<f64> {
        let before = self.velocity();
        let whole = self.tolerance? * before.norm() / before.z;
        Some(whole * std::f64::consts::FRAC_1_SQRT_2)
    }

    /// The same collision, which gives its best outcome with [`crate::Warning::NotSettled`] if the impact
    /// does not converge to its tolerance, instead of [`CoupledError::NotSettled`].
    #[must_use]
    pub fn accepting_unsettled(self) -> Self {
        Self { unsettled: Unsettled::Accepted, ..self }
    }

    /// The same collision with another friction.
    ///
    /// # Errors
    /// [`RangeError`] if friction by the slip speed is out of range at this speed.
    pub fn with_friction(self, friction: impl Into<ImpactFriction>) -> Result<Self, RangeError> {
        let friction = friction.into();
        let static_friction = friction.static_friction();
        let friction = friction.at(&self.velocity())?;
        Ok(Self { friction, static_friction, ..self })
    }

    /// The bodies in contact.
    #[must_use]
    pub const fn bodies(&self) -> &[Body; 2] {
        &self.bodies
    }

    /// The friction between them; if it depends on the slip speed, that at the first touch; kinetic friction, if
    /// static friction exceeds it.
    #[must_use]
    pub const fn friction(&self) -> Friction {
        self.friction
    }

    /// Both coefficients, if static friction exceeds kinetic friction.
    #[must_use]
    pub const fn static_friction(&self) -> Option<StaticFriction> {
        self.static_friction
    }

    /// Checks that friction has one coefficient, for what cannot be computed with two.
    ///
    /// # Errors
    /// [`RangeError`] if static friction exceeds kinetic friction; it says `allowed`.
    pub fn refuse_static_friction(&self, allowed: &'static str) -> Result<(), RangeError> {
        match self.static_friction {
            None => Ok(()),
            Some(friction) => {
                Err(RangeError::new("static_friction", friction.threshold().get(), allowed))
            }
        }
    }

    /// The contact point.
    #[must_use]
    pub const fn point(&self) -> Vector3<f64> {
        self.contact.point()
    }

    /// The contact axes; z is the common normal, from body 2 into body 1.
    #[must_use]
    pub const fn frame(&self) -> &ContactFrame {
        self.contact.frame()
    }

    /// The Hertz contact.
    #[must_use]
    pub const fn hertz(&self) -> &Hertz {
        &self.hertz
    }

    /// The resistance of each body to an impulse at the contact point.
    #[must_use]
    pub const fn levers(&self) -> &[Lever; 2] {
        &self.levers
    }

    /// The mobility D in contact axes.
    #[must_use]
    pub const fn mobility(&self) -> &Mobility {
        &self.mobility
    }

    /// Velocity of body 2 against body 1 at the contact point, in contact axes (8.27).
    #[must_use]
    pub fn velocity(&self) -> Vector3<f64> {
        velocity(&self.bodies, &self.levers, self.frame())
    }

    /// The impact in contact axes; None if the bodies do not approach each other.
    ///
    /// # Errors
    /// [`RangeError`] if a derived quantity over- or underflows.
    pub fn impact(&self) -> Result<Option<CoupledImpact>, CollisionError> {
        let velocity = self.velocity();
        if velocity.z <= 0.0 {
            return Ok(None);
        }
        let stiffness = self.stiffness();
        let mut impact = CoupledImpact::new(self.mobility, stiffness, self.friction, velocity)?;
        if let Some(friction) = self.static_friction {
            impact = impact.with_static_friction(friction);
        }
        if self.is_symmetric() {
            impact = impact.of_symmetric_bodies();
        }
        if let Some(tolerance) = self.tolerance {
            impact = impact.within(tolerance)?;
        }
        if let Some(loss) = self.viscous_loss(velocity.z)? {
            impact = impact.with_loss(loss);
        }
        Ok(Some(match self.unsettled {
            Unsettled::Refused => impact,
            Unsettled::Accepted => impact.accepting_unsettled(),
        }))
    }

    /// Computes the impact up to separation.
    ///
    /// # Errors
    /// [`CollisionError::Oblique`], [`CollisionError::Coupled`] if the impact could not be computed,
    /// [`CollisionError::Range`] if a derived quantity overflows, [`CollisionError::NormalSpin`] if torsion
    /// was requested but cannot be computed.
    pub fn solve(&self) -> Result<Outcome, CollisionError> {
        let Some(impact) = self.impact()? else { return Ok(self.missed()) };
        if self.torsion == TorsionMode::Included {
            self.refuse_static_friction("equal to kinetic friction with torsion")?;
        }
        let (mut outcome, log) = impact.solve_with_log(self.law)?;
        outcome.error_estimate += impact.turning_error(self.law, &outcome);
        Ok(Outcome::Rebound(Box::new(self.rebound_of(outcome, log)?)))
    }

    /// Whether two spheres or planes have the same mobility along all tangents. Then their tangential motion
    /// keeps its direction and is exactly independent of the normal motion.
    pub(crate) fn is_symmetric(&self) -> bool {
        let d = self.mobility.matrix();
        let skew = (d.m11 - d.m22).abs().max(2.0 * d.m12.abs());
        self.bodies.iter().all(|body| body.height().is_some()) && skew <= EVEN * d.m11
    }

    /// The outcome for bodies that do not approach each other: unchanged motions.
    #[must_use]
    pub fn missed(&self) -> Outcome {
        Outcome::NoImpact { motions: self.bodies.each_ref().map(Body::motion) }
    }
}

/// Velocity of body 2 against body 1 at the contact point, in contact axes (8.27).
fn velocity(bodies: &[Body; 2], levers: &[Lever; 2], frame: &ContactFrame) -> Vector3<f64> {
    velocity_at(&bodies.each_ref().map(Body::motion), levers, frame)
}

fn velocity_at(motions: &[Motion; 2], levers: &[Lever; 2], frame: &ContactFrame) -> Vector3<f64> {
    let of = |i: usize| levers[i].point_velocity_in(frame.axes(), &motions[i]);
    of(1) - of(0)
}
