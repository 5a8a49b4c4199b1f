//! Two bodies of any smooth shape, anywhere, in any motion: where they touch and how they part.

mod aftermath;

pub use crate::placed_body::PlacedBody;

use carom_halfspace::MaterialPair;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_special::RangeError;
use nalgebra::Vector3;

use crate::contact_point::{
    Certainty, SearchError, TOUCH_TOLERANCE, nearest_points, origin_of_search,
};
use crate::coupled::{CoupledError, CoupledImpact, Sample, Unsettled, VectorLaw};
use crate::frame::{ContactFrame, FrameError};
use crate::meeting::brought_together;
use crate::mobility::{Lever, Mobility};
use crate::normal_spin::NormalSpinError;
use crate::outcome::{Outcome, TorsionMode};
use crate::surface::{LocalSurface, SurfaceError};

/// Why two bodies have no impact that can be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum EncounterError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// No contact point.
    #[error(transparent)]
    Search(#[from] SearchError),
    /// The surfaces do not make a point contact.
    #[error(transparent)]
    Frame(#[from] FrameError),
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
    point: Vector3<f64>,
    frame: ContactFrame,
    materials: MaterialPair,
    hertz: Hertz,
    levers: [Lever; 2],
    mobility: Mobility,
    smallest_radius: f64,
    /// Of the contact point; a given one needs no proof.
    certainty: Certainty,
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
        let origin = origin_of_search(&body_1, &body_2);
        let seen = [body_1.seen_from(&origin), body_2.seen_from(&origin)];
        let found = nearest_points(&seen[0], &seen[1])?;
        let allowed = allowed_gap(&body_1, &body_2);
        if found.gap.is_nan() || found.gap.abs() > allowed {
            return Err(SearchError::NotTouching { gap: found.gap, allowed }.into());
        }
        let local = |i: usize| named(i, seen[i].local_at(&found.points[i]));
        let locals = [local(0)?, local(1)?];
        let point = 0.5 * (found.points[0] + found.points[1]);
        let arms = [point - seen[0].centre, point - seen[1].centre];
        let encounter = Self::build([body_1, body_2], friction, locals, origin + point, arms)?;
        Ok(Self { certainty: found.certainty, ..encounter })
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
        // The last digits of the way are those of the touch.
        let allowed = 1e-6 * allowed_gap(&body_1, &body_2);
        let origin = body_2.centre;
        let [one, two] = [body_1.seen_from(&origin), body_2.seen_from(&origin)];
        let one = brought_together(one, &two, allowed)?;
        let mut encounter = Self::find(one, two, friction)?;
        encounter.point += origin;
        encounter.bodies = encounter.bodies.map(|body| body.seen_from(&-origin));
        // Its own digits, not those of a sum.
        encounter.bodies[1].centre = origin;
        Ok(encounter)
    }

    /// Two bodies that touch at a given point of space.
    ///
    /// # Errors
    /// [`SearchError::Surface`] if the point does not lie on both surfaces or one has no tangent
    /// plane there, [`EncounterError::Frame`] if the normals are not opposite or the surfaces
    /// conform or touch along a line, [`EncounterError::BothHeldFast`],
    /// [`EncounterError::Range`] if both materials are rigid.
    pub fn at(
        body_1: PlacedBody,
        body_2: PlacedBody,
        point: [f64; 3],
        friction: Friction,
    ) -> Result<Self, EncounterError> {
        let point = Vector3::from(point);
        let bodies = [body_1, body_2];
        let local = |i: usize| named(i, bodies[i].local_at(&point));
        let locals = [local(0)?, local(1)?];
        let arms = [point - bodies[0].centre, point - bodies[1].centre];
        Self::build(bodies, friction, locals, point, arms)
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
        let arms =
            [body_1.attitude.to_space(&point_1.into()), body_2.attitude.to_space(&point_2.into())];
        let point = body_2.centre + arms[1];
        let body_1 = PlacedBody { centre: point - arms[0], ..body_1 };
        let local = |i: usize, body: &PlacedBody, in_body: [f64; 3]| {
            let local = named(i, body.surface.local(&in_body.into()))?;
            Ok::<_, EncounterError>(local.placed(&body.centre, &body.attitude))
        };
        let locals = [local(0, &body_1, point_1)?, local(1, &body_2, point_2)?];
        Self::build([body_1, body_2], friction, locals, point, arms)
    }

    fn build(
        bodies: [PlacedBody; 2],
        friction: Friction,
        locals: [LocalSurface; 2],
        point: Vector3<f64>,
        arms: [Vector3<f64>; 2],
    ) -> Result<Self, EncounterError> {
        let frame = ContactFrame::new(&locals[0], &locals[1])?;
        let materials = MaterialPair::new(bodies[0].material, bodies[1].material)?;
        let hertz = Hertz::new(frame.relative_curvature(), materials)?;
        let z = frame.z();
        let levers = [bodies[0].lever(arms[0], &z, -1.0)?, bodies[1].lever(arms[1], &z, 1.0)?];
        if (levers[0].mobility() + levers[1].mobility()).amax() == 0.0 {
            return Err(EncounterError::BothHeldFast);
        }
        let mobility = Mobility::new(&levers, frame.axes())?;
        let sharpest = locals.iter().flat_map(LocalSurface::curvatures_abs).fold(0.0, f64::max);
        Ok(Self {
            bodies,
            friction,
            law: VectorLaw::default(),
            torsion: TorsionMode::default(),
            tolerance: None,
            unsettled: Unsettled::Refused,
            point,
            frame,
            materials,
            hertz,
            levers,
            mobility,
            smallest_radius: 1.0 / sharpest,
            certainty: Certainty::Proven,
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
        self.point
    }

    /// The contact axes.
    #[must_use]
    pub const fn frame(&self) -> &ContactFrame {
        &self.frame
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
        self.frame.to_space(&self.velocity())
    }

    // The same in contact axes.
    fn velocity(&self) -> Vector3<f64> {
        let of =
            |i: usize| self.levers[i].point_velocity_in(self.frame.axes(), &self.bodies[i].motion);
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
        let Some(impact) = self.impact()? else {
            let motions = [self.bodies[0].motion, self.bodies[1].motion];
            return Ok(Outcome::NoImpact { motions });
        };
        let (coupled, log) = impact.solve_with_log(self.law)?;
        let mut rebound = self.rebound(&impact, &coupled)?;
        rebound.log = log;
        Ok(Outcome::Rebound(Box::new(rebound)))
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

// The largest gap or overlap that counts as touch.
fn allowed_gap(body_1: &PlacedBody, body_2: &PlacedBody) -> f64 {
    let sizes = [body_1.surface.size(), body_2.surface.size()];
    let size = sizes.into_iter().filter(|size| *size > 0.0).fold(f64::INFINITY, f64::min);
    TOUCH_TOLERANCE * size
}

fn named(
    i: usize,
    local: Result<LocalSurface, SurfaceError>,
) -> Result<LocalSurface, EncounterError> {
    let body = if i == 0 { 1 } else { 2 };
    local.map_err(|source| SearchError::Surface { body, source }.into())
}
