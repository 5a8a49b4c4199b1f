//! The path of a ball between walls.

use crate::Error;
use crate::case::SceneCase;
use crate::input::CaseFile;
use crate::theory::ValidityReport;
use carom_impact::Rebound;
use carom_impact::scene::{Bounce, Ending, Event, Leg, PathPoint};
use carom_special::RangeError;
use carom_special::interrupt::is_wanted;
use carom_table::Column;

/// Legs that are computed before they are visited.
const BLOCK: usize = 1024;

/// The end of a path and its reason.
#[derive(Debug, Clone, PartialEq)]
pub struct End {
    /// Why the path ends.
    pub ending: Ending,
    /// The ball at the end.
    pub last: PathPoint,
}

impl End {
    /// Why the path ends, in words.
    #[must_use]
    pub fn reason(&self, case: &SceneCase) -> String {
        let name = |wall: usize| &case.names[wall];
        match self.ending {
            Ending::Time if leaves_all(case) => {
                "the time is over; gravity points away from every wall".to_owned()
            }
            Ending::Time => "the time is over".to_owned(),
            Ending::Bounces => "the last bounce is done".to_owned(),
            Ending::Rest { wall } => format!("it rests on {}", name(wall)),
            Ending::Edge { wall } => format!("it meets an edge of {}", name(wall)),
            Ending::Carried { wall } => format!("it is carried by {}", name(wall)),
            Ending::Wedged { wall, other } => {
                format!("it lies between {} and {}", name(wall), name(other))
            }
        }
    }
}

/// Whether gravity points away from every wall, so that the ball never comes back to one.
fn leaves_all(case: &SceneCase) -> bool {
    let gravity = case.scene.gravity();
    case.scene.walls().iter().all(|wall| gravity.dot(&wall.normal()) > 0.0)
}

/// Computes the path; `visit` receives several legs at a time.
///
/// # Errors
/// [`ErrorKind::Scene`](crate::ErrorKind::Scene) if an impact cannot be computed; errors of `visit`.
pub fn follow<E: From<Error>>(
    case: &SceneCase,
    mut visit: impl FnMut(&[Leg]) -> Result<(), E>,
) -> Result<End, E> {
    let legs = case.scene.legs_by(case.law, &case.ball, case.limits);
    let mut legs = legs.map_err(Error::from)?;
    let mut ending = Ending::Time;
    loop {
        let block = legs.by_ref().take(BLOCK).take_while(|_| !is_wanted());
        let some = block.collect::<Result<Vec<_>, _>>().map_err(Error::from)?;
        let Some(last) = some.last() else { break };
        ending = last.ending().unwrap_or(ending);
        visit(&some)?;
    }
    Ok(End { ending, last: legs.now() })
}

/// Adds the next bounce to what the bounces of a path exceed.
pub fn add_bounce(report: &mut ValidityReport, bounce: &Bounce) {
    report.add_impact(|number| format!("at bounce {number}"), &bounce.rebound);
}

/// The whole path of a ball.
#[derive(Debug, Clone)]
pub struct Followed {
    /// The case.
    pub case: SceneCase,
    /// All bounces, in their order.
    pub bounces: Vec<Bounce>,
    /// Bounces, highest points, where it begins to slide or to roll, and the end.
    pub events: Vec<Event>,
    /// Instants of every flight.
    pub points: Vec<PathPoint>,
    /// The end of the path.
    pub end: End,
}

/// Computes the whole path, with `count` instants of every flight; none for 0.
///
/// # Errors
/// If the case has an error, or an impact cannot be computed; [`ErrorKind::Range`](crate::ErrorKind::Range) if `count` is 1.
pub fn followed(file: &CaseFile, count: usize) -> Result<Followed, Error> {
    let case = file.parse::<SceneCase>()?;
    RangeError::check("points", count as f64, count != 1, ">= 2")?;
    let (mut bounces, mut events, mut points) = (Vec::new(), Vec::new(), Vec::new());
    let visit = |legs: &[Leg]| -> Result<(), Error> {
        bounces.extend(legs.iter().filter_map(Leg::bounce).cloned());
        events.extend(legs.iter().flat_map(Leg::events));
        for leg in legs.iter().filter(|_| count > 0) {
            points.extend(leg.points(count)?);
        }
        Ok(())
    };
    let end = file.follow(|| follow(&case, visit))?;
    Ok(Followed { case, bounces, events, points, end })
}

/// The name of the wall of an event; empty in flight.
#[must_use]
pub fn wall_name(case: &SceneCase, event: &Event) -> String {
    event.kind.wall().map_or_else(String::new, |wall| case.names[wall].clone())
}

/// The columns of the impact of a bounce, without those that [`Bounce::COLUMNS`] has: the ball is body 1, and walls
/// do not move.
#[must_use]
pub fn rebound_columns() -> Vec<Column<Rebound>> {
    let is_new = |column: &&Column<Rebound>| {
        column.name() != "outcome" && !column.name().starts_with("body_")
    };
    Rebound::COLUMNS.iter().filter(is_new).copied().collect()
}
