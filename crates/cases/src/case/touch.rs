//! Where the two bodies of an impact touch.

use super::body::{BODY_1, BODY_2, BodyCase, KNOWN_POINT, POSITION, RADII};
use super::contact::{
    FRICTION, FRICTION_BY_SPEED, LAW, LOSS, NORMAL_RESTITUTION, RELAXATION, RESTITUTION_BY_SPEED,
    STATIC_FRICTION, STIFFNESS_RATIO, TORSION, WAVE_LOSS,
};
use super::error::{CaseError, CaseFault};
use super::field::{AXES, Default, Field, Form};
use super::range::Range;
use super::section::Section;
use super::shape::SHAPE;
use super::unit::{Dimension, Measure};
use carom_geometry::{FrameError, SearchError, SurfaceError};
use carom_impact::{Body, Collision, CollisionError, ImpactFriction};
use nalgebra::Vector3;

const TOUCH: &str = "touch";
const APPROACH: &str = "approach";
const PLACE: Measure = Range::Finite.of(Dimension::Length);
pub(super) const SEARCH: Field = Field::new(
    "search",
    Form::Word(&[
        (TOUCH, "the bodies touch at their given positions"),
        (APPROACH, "body 1 moves along its velocity until they touch"),
    ]),
    "how the contact point is found",
)
.default(Default::Word(TOUCH));
pub(super) const POINT: Field = Field::vector("point", PLACE, "the contact point in space")
    .may("found by a search")
    .such_as("[0, 0, 0]");
pub(super) const POINT_1: Field = own("point_1", "the contact point in the axes of body 1");
pub(super) const POINT_2: Field = own("point_2", "the contact point in the axes of body 2");
/// The field `contact` of an impact.
pub(super) const CONTACT: Field = Field::new(
    "contact",
    Form::Table(&[
        FRICTION,
        FRICTION_BY_SPEED,
        STATIC_FRICTION,
        STIFFNESS_RATIO,
        LAW,
        TORSION,
        NORMAL_RESTITUTION,
        RESTITUTION_BY_SPEED,
        LOSS,
        WAVE_LOSS,
        RELAXATION,
        POINT,
        POINT_1,
        POINT_2,
        SEARCH,
    ]),
    "friction and contact point",
);
const OWN: &str = "three numbers [x, y, z], the contact point in the body's axes";

const fn own(name: &'static str, meaning: &'static str) -> Field {
    Field::new(name, Form::Vector(AXES, PLACE, OWN), meaning)
        .may("found by a search; for shape \"given\" its point")
        .such_as("[0, 0, -0.01]")
}

/// How the contact point is found.
#[derive(Debug, Clone, Copy)]
pub(super) enum Touch {
    /// Body 1 lies on top of body 2 with this normal; the position of body 1 may be given.
    Along { normal: Vector3<f64>, place_of_1: Option<Vector3<f64>> },
    /// Both positions are given; a search finds the contact point.
    Found,
    /// Body 1 moves along its velocity until they touch.
    Approach,
    /// At a given point in space.
    At([f64; 3]),
    /// At a given point of each body.
    Own([[f64; 3]; 2]),
}

impl Touch {
    pub(super) fn read(
        case: &Section<'_>,
        contact: &Section<'_>,
        bodies: &[BodyCase; 2],
    ) -> Result<Self, CaseError> {
        let own = if contact.has(&POINT_1) { &POINT_1 } else { &POINT_2 };
        let given = contact.given([&POINT, &SEARCH, own]);
        if given.len() > 1 {
            return Err(contact.several(&given, "give one way to find the contact point"));
        }
        let is_given = bodies.iter().any(|body| body.point.is_some());
        let is_asked = contact.has(&POINT) || contact.has(&SEARCH);
        if contact.has(own) || (is_given && !is_asked) {
            if bodies[0].has_position {
                let reason = "body 1 is put where its own contact point touches body 2";
                return Err(case.conflict([&BODY_1, &POSITION], [&CONTACT, &POINT_1], reason));
            }
            return Ok(Self::Own([
                read_own(case, contact, &POINT_1, &BODY_1, &bodies[0])?,
                read_own(case, contact, &POINT_2, &BODY_2, &bodies[1])?,
            ]));
        }
        // A plane without a position passes through the origin.
        let unplaced = |body: &BodyCase| !body.has_position && !body.is_plane;
        let is_anywhere = bodies.iter().all(|body| !body.has_position);
        if !is_asked && (is_anywhere || bodies.iter().any(unplaced)) {
            return Ok(Self::along(bodies));
        }
        for (body, field) in bodies.iter().zip([&BODY_1, &BODY_2]) {
            if unplaced(body) {
                return Err(case.missing_as([field, &POSITION], POSITION.allowed()));
            }
        }
        if contact.has(&POINT) {
            return contact.vector(&POINT).map(Self::At);
        }
        Ok(if contact.word(&SEARCH)? == APPROACH { Self::Approach } else { Self::Found })
    }

    fn along([one, two]: &[BodyCase; 2]) -> Self {
        let outward = |body: &BodyCase| body.body.placed().attitude().to_space(&Vector3::z());
        let normal = match (one.is_plane, two.is_plane) {
            (true, _) => -outward(one),
            (_, true) => outward(two),
            _ => Vector3::z(),
        };
        let place_of_1 = one.has_position.then(|| one.body.placed().centre());
        Self::Along { normal, place_of_1 }
    }

    pub(super) const fn is_approach(&self) -> bool {
        matches!(self, Self::Approach)
    }

    pub(super) fn collision(
        &self,
        one: Body,
        two: Body,
        friction: ImpactFriction,
    ) -> Result<Collision, CollisionError> {
        match *self {
            Self::Found => Collision::touching(one, two, friction),
            Self::Approach => Collision::meeting(one, two, friction),
            Self::At(point) => Collision::at(one, two, point, friction),
            Self::Own(points) => Collision::at_own_points(one, two, points, friction),
            Self::Along { normal, place_of_1: None } => {
                Collision::along(one, two, normal.into(), friction)
            }
            Self::Along { normal, place_of_1: Some(place) } => {
                let there = Collision::along(one.clone(), two.clone(), normal.into(), friction)?;
                let [first, second] = there.bodies().each_ref().map(|body| body.placed().centre());
                let two = two.at((second + place - first).into())?;
                Collision::along(one, two, normal.into(), friction)
            }
        }
    }

    /// The field that causes the error, with its line.
    pub(super) fn at_fault(&self, case: &Section<'_>, source: CollisionError) -> CaseError {
        let body = |body: &u8| if *body == 1 { &BODY_1 } else { &BODY_2 };
        let own = |body: &u8| if *body == 1 { &POINT_1 } else { &POINT_2 };
        let at = match (&source, self) {
            (CollisionError::Search(SearchError::NotTouching { gap, .. }), Self::Approach)
                if *gap > 0.0 =>
            {
                [&CONTACT, &SEARCH]
            }
            (CollisionError::Search(SearchError::NotTouching { .. }), _) => [&BODY_1, &POSITION],
            (CollisionError::Search(SearchError::Surface { .. }), Self::At(_)) => {
                [&CONTACT, &POINT]
            }
            (
                CollisionError::Search(SearchError::Surface {
                    body,
                    source: SurfaceError::OffSurface { .. },
                }),
                Self::Own(_),
            ) => [&CONTACT, own(body)],
            (CollisionError::Search(SearchError::Surface { body: which, .. }), _) => {
                [body(which), &SHAPE]
            }
            (CollisionError::Search(SearchError::Frame(FrameError::Curvature(_))), _) => {
                let radii = [[&BODY_1, &RADII], [&BODY_2, &RADII]];
                radii.into_iter().find(|at| case.has(*at)).unwrap_or([&BODY_2, &SHAPE])
            }
            (CollisionError::Search(SearchError::Frame(_)), _) => [&CONTACT, &POINT],
            (CollisionError::Search(_), _) => [&BODY_1, &SHAPE],
            _ => [&CONTACT, &POINT],
        };
        // A field with its default value has no line.
        let (field, line) = match case.has(at) {
            true => (case.path(&at), case.line(at)),
            false => (CONTACT.name.to_owned(), case.line(&CONTACT)),
        };
        let hint = hint(&source, self);
        CaseFault::Collision { hint, source: Box::new(source) }.at(field, line)
    }
}

fn read_own(
    case: &Section<'_>,
    contact: &Section<'_>,
    field: &'static Field,
    of: &'static Field,
    body: &BodyCase,
) -> Result<[f64; 3], CaseError> {
    match (body.point, contact.has(field)) {
        (Some(_), true) => {
            let reason = "the surface is known at that point only";
            Err(case.conflict([&CONTACT, field], [of, &KNOWN_POINT], reason))
        }
        (Some(point), false) => Ok(point),
        (None, true) => contact.vector(field),
        (None, false) if body.is_plane => Ok([0.0; 3]),
        (None, false) => Err(contact.missing(field)),
    }
}

/// A hint for the user.
fn hint(source: &CollisionError, touch: &Touch) -> &'static str {
    match (source, touch) {
        (CollisionError::Search(SearchError::NotTouching { gap, .. }), Touch::Found)
            if *gap > 0.0 =>
        {
            "; `contact.search = \"approach\"` moves body 1 along its velocity until they touch"
        }
        (CollisionError::Search(SearchError::NotTouching { gap, .. }), Touch::Approach)
            if *gap > 0.0 =>
        {
            "; with its `velocity` relative to body 2, body 1 misses it or moves away from it"
        }
        (CollisionError::Search(SearchError::Frame(FrameError::NotOpposed { .. })), _) => {
            "; `quaternion` or `angles` and contact point are not consistent"
        }
        _ => "",
    }
}
