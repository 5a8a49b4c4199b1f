//! The case file of `carom impact` for bodies of any smooth shape.
//!
//! SI units. z of the contact points into body 1. The bodies touch where `[contact]` says so, or
//! where a search finds it.

use super::contact::{self, Contact};
use super::error::CaseError;
use super::impact;
use super::placed::{self, MARKS, Placed, WORDS};
use super::range::Range;
use super::section::{Section, Words, parse};
use super::unit::Dimension;
use carom_geometry::{FrameError, SearchError, SurfaceError};
use carom_impact::{Collision, CollisionError, Motion};
use carom_laws::friction::Friction;
use toml::de::{DeTable, DeValue};

const CONTACT_FIELDS: [&str; 4] = ["point", "point_1", "point_2", "search"];
const SEARCH: Words = Words {
    words: &["touch", "approach"],
    allowed: "\"touch\" (the bodies touch where they are) or \"approach\" (body 1 goes on straight \
              until they do)",
};
const POINT: &str = "three numbers [x, y, z], the contact point in the body's axes";
const POSITION: &str = "three numbers [x, y, z], the centre of mass (or give `contact.point_1` and \
                        `contact.point_2`)";

/// An impact of two bodies of any smooth shape.
#[derive(Debug, Clone)]
pub struct EncounterCase {
    /// The bodies, touching.
    pub encounter: Collision,
    /// Their motions before.
    pub before: [Motion; 2],
    /// Friction, law and torsion.
    pub contact: Contact,
}

/// How the bodies touch.
enum Touch {
    Found,
    Approach,
    At([f64; 3]),
    Own([[f64; 3]; 2]),
}

impl EncounterCase {
    /// Reads a case from the text of its file; none if its bodies are spheres and planes without
    /// a place.
    ///
    /// # Errors
    /// If the text is not TOML, a field is missing, unknown, out of range or in conflict with
    /// another, or the bodies make no contact that can be computed.
    pub fn parse(source: &str) -> Result<Option<Self>, CaseError> {
        let table = parse(source)?;
        if !has_place(table.get_ref()) {
            return Ok(None);
        }
        let case = &Section::root(source, table.get_ref(), impact::FIELDS)?;
        placed::check(case, "body_1")?;
        placed::check(case, "body_2")?;
        for (name, reason) in [
            ("approach", "bodies with a shape or place of their own have velocities"),
            ("uncertainty", "only spheres and planes without a place take distributions"),
        ] {
            if case.has(name) {
                return Err(case.conflict(name, "body_1", reason));
            }
        }
        let bodies = [Placed::read(case, "body_1")?, Placed::read(case, "body_2")?];
        check_pair(case, &bodies)?;
        let fields: Vec<&'static str> = contact::FIELDS.into_iter().chain(CONTACT_FIELDS).collect();
        let table = case.section("contact", &fields)?;
        let contact = Contact::read(&table)?;
        let touch = read_touch(case, &table, &bodies)?;
        let before = [bodies[0].motion, bodies[1].motion];
        let encounter =
            meet(bodies, &touch, contact).map_err(|source| at_fault(case, &touch, source))?;
        Ok(Some(Self { encounter, before, contact }))
    }
}

/// Whether a body has a shape of its own or a place, or the contact a point.
fn has_place(table: &DeTable<'_>) -> bool {
    let field = |body: &str, name: &str| {
        let table = table.iter().find(|(key, _)| key.get_ref() == body)?.1.get_ref().as_table()?;
        table.iter().find(|(key, _)| key.get_ref() == name).map(|(_, value)| value.get_ref())
    };
    let is_placed = |body: &str| {
        let shape = match field(body, "shape") {
            // An unknown word tells nothing.
            Some(DeValue::String(shape)) => {
                WORDS.words.contains(&shape.as_ref())
                    && !matches!(shape.as_ref(), "sphere" | "plane")
            }
            _ => false,
        };
        shape || MARKS.iter().any(|name| field(body, name).is_some())
    };
    is_placed("body_1")
        || is_placed("body_2")
        || CONTACT_FIELDS.iter().any(|name| field("contact", name).is_some())
}

/// What two bodies cannot both be.
fn check_pair(case: &Section<'_>, bodies: &[Placed; 2]) -> Result<(), CaseError> {
    let [one, two] = bodies;
    if one.is_plane && two.is_plane {
        let reason = "two planes do not meet in a point";
        return Err(case.conflict("body_2.shape", "body_1.shape", reason));
    }
    impact::check_masses(case, [one.is_heavy(), two.is_heavy()])?;
    impact::check_materials(case, [one.material(), two.material()])
}

fn read_touch(
    case: &Section<'_>,
    contact: &Section<'_>,
    bodies: &[Placed; 2],
) -> Result<Touch, CaseError> {
    let has_own = contact.has("point_1") || contact.has("point_2");
    let ways = ["point", "search", if contact.has("point_1") { "point_1" } else { "point_2" }];
    let given: Vec<&str> = ways.into_iter().filter(|name| contact.has(name)).collect();
    if let [one, other, ..] = given.as_slice() {
        return Err(contact.conflict(other, one, "give one way to find the contact point"));
    }
    let is_given = bodies.iter().any(|body| body.point.is_some());
    if has_own || (is_given && !contact.has("point") && !contact.has("search")) {
        if bodies[0].has_position {
            let reason = "body 1 is put where its own contact point touches body 2";
            return Err(case.conflict("body_1.position", "contact.point_1", reason));
        }
        return Ok(Touch::Own([
            read_own(case, contact, ["point_1", "body_1.point"], &bodies[0])?,
            read_own(case, contact, ["point_2", "body_2.point"], &bodies[1])?,
        ]));
    }
    for (body, name) in bodies.iter().zip(["body_1.position", "body_2.position"]) {
        if !body.has_position && !body.is_plane {
            return Err(case.missing(name, POSITION));
        }
    }
    if contact.has("point") {
        return contact.vector("point", Range::Finite.of(Dimension::Length)).map(Touch::At);
    }
    match contact.has("search") {
        true if contact.word("search", SEARCH)? == "approach" => Ok(Touch::Approach),
        _ => Ok(Touch::Found),
    }
}

fn read_own(
    case: &Section<'_>,
    contact: &Section<'_>,
    [name, own]: [&str; 2],
    body: &Placed,
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

fn meet(bodies: [Placed; 2], touch: &Touch, contact: Contact) -> Result<Collision, CollisionError> {
    let [one, two] = bodies.map(|placed| placed.body);
    let friction = Friction::new(contact.friction)?;
    let encounter = match touch {
        Touch::Found => Collision::touching(one, two, friction),
        Touch::Approach => Collision::meeting(one, two, friction),
        Touch::At(point) => Collision::at(one, two, *point, friction),
        Touch::Own([first, second]) => {
            Collision::at_own_points(one, *first, two, *second, friction)
        }
    };
    let encounter = encounter?.with_law(contact.law);
    Ok(if contact.torsion.is_some() { encounter.with_torsion() } else { encounter })
}

/// The field that is to blame, with its line.
fn at_fault(case: &Section<'_>, touch: &Touch, source: CollisionError) -> CaseError {
    let own = |body: u8| if body == 1 { "contact.point_1" } else { "contact.point_2" };
    let shape = |body: u8| if body == 1 { "body_1.shape" } else { "body_2.shape" };
    let field = match (&source, touch) {
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
            let radii = ["body_1.radii", "body_2.radii"].into_iter().find(|name| case.has(name));
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
        hint: hint(&source, touch),
        source: Box::new(source),
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
