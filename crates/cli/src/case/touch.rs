//! Where the two bodies of an impact touch.

use super::body::BodyCase;
use super::error::CaseError;
use super::range::Range;
use super::section::{Section, Words};
use super::unit::Dimension;
use carom_geometry::{FrameError, SearchError, SurfaceError};
use carom_impact::{Body, Collision, CollisionError};
use carom_laws::friction::Friction;
use nalgebra::Vector3;

/// Fields of `[contact]` that say it.
pub(super) const FIELDS: [&str; 4] = ["point", "point_1", "point_2", "search"];
const SEARCH: Words = Words {
    words: &["touch", "approach"],
    allowed: "\"touch\" (the bodies touch where they are) or \"approach\" (body 1 goes on straight \
              until they do)",
};
const POSITION: &str = "three numbers [x, y, z], the centre of mass";
const POINT: &str = "three numbers [x, y, z], the contact point in the body's axes";

/// How the bodies touch.
#[derive(Debug, Clone, Copy)]
pub(super) enum Touch {
    /// Body 1 on top of body 2 along this normal; the place of body 1 may be the one known.
    Along { normal: Vector3<f64>, place_of_1: Option<Vector3<f64>> },
    /// Where they are.
    Found,
    /// Where body 1 comes to.
    Approach,
    /// At a point of space.
    At([f64; 3]),
    /// At a point of each.
    Own([[f64; 3]; 2]),
}

impl Touch {
    pub(super) fn read(
        case: &Section<'_>,
        contact: &Section<'_>,
        bodies: &[BodyCase; 2],
    ) -> Result<Self, CaseError> {
        let has_own = contact.has("point_1") || contact.has("point_2");
        let ways = ["point", "search", if contact.has("point_1") { "point_1" } else { "point_2" }];
        let given: Vec<&str> = ways.into_iter().filter(|name| contact.has(name)).collect();
        if let [one, other, ..] = given.as_slice() {
            return Err(contact.conflict(other, one, "give one way to find the contact point"));
        }
        let is_given = bodies.iter().any(|body| body.point.is_some());
        let is_asked = contact.has("point") || contact.has("search");
        if has_own || (is_given && !is_asked) {
            if bodies[0].has_position {
                let reason = "body 1 is put where its own contact point touches body 2";
                return Err(case.conflict("body_1.position", "contact.point_1", reason));
            }
            return Ok(Self::Own([
                read_own(case, contact, ["point_1", "body_1.point"], &bodies[0])?,
                read_own(case, contact, ["point_2", "body_2.point"], &bodies[1])?,
            ]));
        }
        // A plane without a position runs through the origin.
        let unplaced = |body: &BodyCase| !body.has_position && !body.is_plane;
        let is_anywhere = bodies.iter().all(|body| !body.has_position);
        if !is_asked && (is_anywhere || bodies.iter().any(unplaced)) {
            return Ok(Self::along(bodies));
        }
        for (body, name) in bodies.iter().zip(["body_1.position", "body_2.position"]) {
            if unplaced(body) {
                return Err(case.missing(name, POSITION));
            }
        }
        if contact.has("point") {
            return contact.vector("point", Range::Finite.of(Dimension::Length)).map(Self::At);
        }
        match contact.has("search") {
            true if contact.word("search", SEARCH)? == "approach" => Ok(Self::Approach),
            _ => Ok(Self::Found),
        }
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
        friction: Friction,
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

    /// The field that is to blame, with its line.
    pub(super) fn at_fault(&self, case: &Section<'_>, source: CollisionError) -> CaseError {
        let own = |body: u8| if body == 1 { "contact.point_1" } else { "contact.point_2" };
        let shape = |body: u8| if body == 1 { "body_1.shape" } else { "body_2.shape" };
        let field = match (&source, self) {
            (CollisionError::Search(SearchError::NotTouching { gap, .. }), Touch::Approach)
                if *gap > 0.0 =>
            {
                "contact.search"
            }
            (CollisionError::Search(SearchError::NotTouching { .. }), _) => "body_1.position",
            (CollisionError::Search(SearchError::Surface { body, source }), touch) => {
                match (source, touch) {
                    (_, Touch::At(_)) => "contact.point",
                    (SurfaceError::OffSurface { .. }, Touch::Own(_)) => own(*body),
                    _ => shape(*body),
                }
            }
            (CollisionError::Search(SearchError::Frame(FrameError::Curvature(_))), _) => {
                let radii =
                    ["body_1.radii", "body_2.radii"].into_iter().find(|name| case.has(name));
                radii.unwrap_or("body_2.shape")
            }
            (CollisionError::Search(SearchError::Frame(_)), _) => "contact",
            (CollisionError::Search(_), _) => "body_1.shape",
            _ => "contact",
        };
        // A field that the file leaves to its default has no line of its own.
        let field = if case.has(field) { field } else { "contact" };
        CaseError::Collision {
            field,
            line: case.line(field),
            hint: hint(&source, self),
            source: Box::new(source),
        }
    }
}

fn read_own(
    case: &Section<'_>,
    contact: &Section<'_>,
    [name, own]: [&str; 2],
    body: &BodyCase,
) -> Result<[f64; 3], CaseError> {
    match body.point {
        Some(_) if contact.has(name) => {
            let reason = "the surface is known at that point only";
            Err(case.conflict(&contact.full(name), own, reason))
        }
        Some(point) => Ok(point),
        None if contact.has(name) => contact.vector(name, Range::Finite.of(Dimension::Length)),
        None if body.is_plane => Ok([0.0; 3]),
        None => Err(contact.missing(name, POINT)),
    }
}

/// What may help.
fn hint(source: &CollisionError, touch: &Touch) -> &'static str {
    match (source, touch) {
        (CollisionError::Search(SearchError::NotTouching { gap, .. }), Touch::Found)
            if *gap > 0.0 =>
        {
            "; `contact.search = \"approach\"` lets body 1 go on until they do"
        }
        (CollisionError::Search(SearchError::NotTouching { gap, .. }), Touch::Approach)
            if *gap > 0.0 =>
        {
            "; with its `velocity` against that of body 2, body 1 goes past it or away from it"
        }
        (CollisionError::Search(SearchError::Frame(FrameError::NotOpposed { .. })), _) => {
            "; `quaternion`, `angles` and contact point do not fit together"
        }
        _ => "",
    }
}
