//! Two bodies of any smooth shape, anywhere, in any motion: where they touch and how they part.

mod aftermath;

pub use crate::placed_body::PlacedBody;

use carom_geometry::{ContactFrame, ContactPoint, SearchError};
use carom_halfspace::MaterialPair;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_special::RangeError;
use nalgebra::Vector3;

use crate::coupled::{CoupledError, CoupledImpact, Sample, Unsettled, VectorLaw};
use crate::mobility::{Lever, Mobility};
use crate::normal_spin::NormalSpinError;
use crate::outcome::{Outcome, TorsionMode};

/// Why two bodies have no impact that can be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum EncounterError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// No contact point, or no elliptical contact there.
    #[error(transparent)]
    Search(#[from] SearchError),
    /// Neither body can move.
    #[error("both bodies are infinitely heavy: mass = inf must be finite for at least one")]
    BothHeldFast,
    /// The impact could not be followed.
    #[error(transparent)]
    Coupled(#[from] CoupledError),
    /// Torsion was asked for and cannot be given.
    #[error(transparent)]
    NormalSpin(#[from] NormalSpinError),
}

/// Two bodies that touch.
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::{Encounter, Motion, PlacedBody, Surface};
/// use carom_laws::friction::Friction;
/// let steel = Material::from_shear(80e9, 0.3)?;
/// let egg = Surface::ellipsoid([0.03, 0.02, 0.015])?;
/// let inertia = egg.solid(0.296)?;
/// let body = PlacedBody::new(egg, steel, inertia)
///     .at([0.0, 0.0, 0.015])?
///     .moving(Motion::new([-0.6, -0.4, -2.0], [0.0; 3])?);
/// let encounter = Encounter::find(body, PlacedBody::plane(steel), Friction::new(0.5)?)?;
/// let outcome = encounter.solve()?;
/// assert!((outcome.motions()[0].velocity.z - 2.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Encounter {
    bodies: [PlacedBody; 2],
    friction: Friction,
    law: VectorLaw,
    torsion: TorsionMode,
    tolerance: Option<f64>,
    unsettled: Unsettled,
    contact: ContactPoint,
    materials: MaterialPair,
    hertz: Hertz,
    levers: [Lever; 2],
    mobility: Mobility,
}

impl Encounter {
    /// Two bodies whose contact point is searched for. z will point from body 2 into body 1.
    /// [`crate::Warning::PointSampled`] comes with the outcome where the search proves nothing.
    ///
    /// # Errors
    /// [`EncounterError::Search`] if the bodies do not touch, if they touch with an edge, or if
    /// no search is known for the pair; else as [`Encounter::at`].
    pub fn find(
        body_1: PlacedBody,
        body_2: PlacedBody,
        friction: Friction,
    ) -> Result<Self, EncounterError> {
        let contact = ContactPoint::find(&body_1.placed, &body_2.placed)?;
        Self::build([body_1, body_2], friction, contact)
    }

    /// Two bodies that lie apart: body 1 goes on straight, along the velocity of its centre against
    /// that of body 2, until they touch; neither turns on the way.
    ///
    /// # Errors
    /// [`EncounterError::Search`] if they overlap or pass each other; else as [`Encounter::find`].
    pub fn meeting(
        body_1: PlacedBody,
        body_2: PlacedBody,
        friction: Friction,
    ) -> Result<Self, EncounterError> {
        let course = body_1.motion.velocity - body_2.motion.velocity;
        let (placed, contact) = ContactPoint::approaching(&body_1.placed, &body_2.placed, &course)?;
        Self::build([PlacedBody { placed, ..body_1 }, body_2], friction, contact)
    }

    /// Two bodies that touch at a given point of space.
    ///
    /// # Errors
    /// [`SearchError::Surface`] if the point does not lie on both surfaces or one has no tangent
    /// plane there, [`SearchError::Frame`] if the normals are not opposite or the surfaces
    /// conform or touch along a line, [`EncounterError::BothHeldFast`],
    /// [`EncounterError::Range`] if both materials are rigid.
    pub fn at(
        body_1: PlacedBody,
        body_2: PlacedBody,
        point: [f64; 3],
        friction: Friction,
    ) -> Result<Self, EncounterError> {
        let contact = ContactPoint::at(&body_1.placed, &body_2.placed, point)?;
        Self::build([body_1, body_2], friction, contact)
    }

    /// Two bodies that touch with given points of their surfaces, each in its body's axes. Their
    /// centres need not be known; body 2 keeps its place and body 1 follows.
    ///
    /// # Errors
    /// As [`Encounter::at`].
    pub fn at_own_points(
        body_1: PlacedBody,
        point_1: [f64; 3],
        body_2: PlacedBody,
        point_2: [f64; 3],
        friction: Friction,
    ) -> Result<Self, EncounterError> {
        let (placed, contact) =
            ContactPoint::at_own_points(&body_1.placed, &body_2.placed, [point_1, point_2])?;
        Self::build([PlacedBody { placed, ..body_1 }, body_2], friction, contact)
    }

    fn build(
        bodies: [PlacedBody; 2],
        friction: Friction,
        contact: ContactPoint,
    ) -> Result<Self, EncounterError> {
        let materials = MaterialPair::new(bodies[0].material, bodies[1].material)?;
        let hertz = Hertz::new(contact.frame().relative_curvature(), materials)?;
        let (z, arms) = (contact.frame().z(), contact.arms());
        let levers = [bodies[0].lever(arms[0], &z, -1.0)?, bodies[1].lever(arms[1], &z, 1.0)?];
        if (levers[0].mobility() + levers[1].mobility()).amax() == 0.0 {
            return Err(EncounterError::BothHeldFast);
        }
        let mobility = Mobility::new(&levers, contact.frame().axes())?;
        Ok(Self {
            bodies,
            friction,
            law: VectorLaw::default(),
            torsion: TorsionMode::default(),
            tolerance: None,
            unsettled: Unsettled::Refused,
            contact,
            materials,
            hertz,
            levers,
            mobility,
        })
    }

    /// The same encounter with another law for turning directions.
    #[must_use]
    pub fn with_law(self, law: VectorLaw) -> Self {
        Self { law, ..self }
    }

    /// The same encounter with the torsional impact of chapter 10 on the spin about the normal,
    /// which is left alone otherwise. It is computed as if there were no tangential impact: an
    /// approximation where both slip.
    ///
    /// [`Encounter::solve`] then refuses bodies whose spin about the normal is coupled to other
    /// motion; the normal of spheres, planes and bodies that meet at the end of an axis of symmetry
    /// passes.
    #[must_use]
    pub fn with_torsion(self) -> Self {
        Self { torsion: TorsionMode::Included, ..self }
    }

    /// The same encounter, its impact settled to another tolerance than the default; as
    /// [`CoupledImpact::within`].
    ///
    /// # Errors
    /// [`RangeError`] unless it is finite and positive.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        RangeError::positive("tolerance", tolerance)?;
        Ok(Self { tolerance: Some(tolerance), ..self })
    }

    /// The same encounter, with the best outcome found where its impact does not settle to the
    /// tolerance, and [`crate::Warning::NotSettled`] among the warnings, instead of
    /// [`CoupledError::NotSettled`].
    #[must_use]
    pub fn accepting_unsettled(self) -> Self {
        Self { unsettled: Unsettled::Accepted, ..self }
    }

    /// The bodies.
    #[must_use]
    pub const fn bodies(&self) -> &[PlacedBody; 2] {
        &self.bodies
    }

    /// The friction between them.
    #[must_use]
    pub const fn friction(&self) -> Friction {
        self.friction
    }

    /// The contact point.
    #[must_use]
    pub const fn point(&self) -> Vector3<f64> {
        self.contact.point()
    }

    /// The contact axes.
    #[must_use]
    pub const fn frame(&self) -> &ContactFrame {
        self.contact.frame()
    }

    /// The Hertz contact.
    #[must_use]
    pub const fn hertz(&self) -> &Hertz {
        &self.hertz
    }

    /// What of each body resists the impulse.
    #[must_use]
    pub const fn levers(&self) -> &[Lever; 2] {
        &self.levers
    }

    /// The mobility D in contact axes.
    #[must_use]
    pub const fn mobility(&self) -> &Mobility {
        &self.mobility
    }

    /// Velocity of body 2 against body 1 at the contact point, in space axes (8.27).
    #[must_use]
    pub fn relative_velocity(&self) -> Vector3<f64> {
        self.frame().to_space(&self.velocity())
    }

    // The same in contact axes.
    fn velocity(&self) -> Vector3<f64> {
        let of = |i: usize| {
            self.levers[i].point_velocity_in(self.frame().axes(), &self.bodies[i].motion)
        };
        of(1) - of(0)
    }

    /// The impact in contact axes; none if the bodies do not approach each other.
    ///
    /// # Errors
    /// [`RangeError`] if a derived quantity over- or underflows.
    pub fn impact(&self) -> Result<Option<CoupledImpact>, EncounterError> {
        let velocity = self.velocity();
        if velocity.z <= 0.0 {
            return Ok(None);
        }
        let stiffness = self.hertz.stiffness();
        let mut impact = CoupledImpact::new(self.mobility, stiffness, self.friction, velocity)?;
        if let Some(tolerance) = self.tolerance {
            impact = impact.within(tolerance)?;
        }
        Ok(Some(match self.unsettled {
            Unsettled::Refused => impact,
            Unsettled::Accepted => impact.accepting_unsettled(),
        }))
    }

    /// Follows the encounter to separation. The spin about the normal is left alone, apart from
    /// [`Encounter::with_torsion`]; [`crate::Warning::SpinLeftAlone`] says where that matters.
    ///
    /// # Errors
    /// [`EncounterError::Coupled`] if the impact could not be followed,
    /// [`EncounterError::NormalSpin`] if torsion was asked for and cannot be given.
    pub fn solve(&self) -> Result<Outcome, EncounterError> {
        let Some(impact) = self.impact()? else { return Ok(self.missed()) };
        let (coupled, log) = impact.solve_with_log(self.law)?;
        let mut rebound = self.rebound(&impact, &coupled)?;
        rebound.log = log;
        Ok(Outcome::Rebound(Box::new(rebound)))
    }

    // The bodies do not approach each other.
    pub(crate) const fn missed(&self) -> Outcome {
        Outcome::NoImpact { motions: [self.bodies[0].motion, self.bodies[1].motion] }
    }

    /// Instants of the impact in contact axes; empty without an impact.
    ///
    /// # Errors
    /// As [`Encounter::solve`].
    pub fn history(&self) -> Result<Vec<Sample>, EncounterError> {
        match self.impact()? {
            None => Ok(Vec::new()),
            Some(impact) => Ok(impact.history(self.law)?),
        }
    }
}
