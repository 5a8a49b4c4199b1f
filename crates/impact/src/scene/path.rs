//! The path of the ball: flights, bounces and the end.

use carom_special::RangeError;
use carom_table::Column;
use nalgebra::Vector3;

use super::flight::Flight;
use crate::motion::Motion;
use crate::outcome::Rebound;

/// When the computation stops.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    time: f64,
    bounces: usize,
    rebound_height: f64,
}

impl Limits {
    /// Stops at `time`, or after `bounces` bounces.
    ///
    /// # Errors
    /// [`RangeError`] unless the time is finite and positive and there is at least one bounce.
    pub fn new(time: f64, bounces: usize) -> Result<Self, RangeError> {
        RangeError::positive("time", time)?;
        RangeError::check("bounces", bounces as f64, bounces >= 1, ">= 1")?;
        Ok(Self { time, bounces, rebound_height: 0.0 })
    }

    /// Stops also when the ball will rise less than this above the wall it has just left.
    ///
    /// # Errors
    /// [`RangeError`] unless the height is finite and not negative.
    pub fn at_rest_below(self, height: f64) -> Result<Self, RangeError> {
        Ok(Self { rebound_height: RangeError::non_negative("rebound height", height)?, ..self })
    }

    /// The time at which it stops.
    #[must_use]
    pub const fn time(&self) -> f64 {
        self.time
    }

    /// The largest number of bounces.
    #[must_use]
    pub const fn bounces(&self) -> usize {
        self.bounces
    }

    /// The smallest height of a rebound.
    #[must_use]
    pub const fn rebound_height(&self) -> f64 {
        self.rebound_height
    }
}

/// A flight from a start or a bounce to the next event.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TimedFlight {
    pub(super) start: f64,
    pub(super) duration: f64,
    pub(super) flight: Flight,
    pub(super) spin: Vector3<f64>,
    /// The rate of the spin, of a ball on a wall.
    pub(super) turning: Vector3<f64>,
    /// The rate of the acceleration.
    pub(super) bend: Vector3<f64>,
}

impl TimedFlight {
    /// A flight with a constant spin.
    pub(super) fn free(start: f64, duration: f64, flight: Flight, spin: Vector3<f64>) -> Self {
        Self { start, duration, flight, spin, turning: Vector3::zeros(), bend: Vector3::zeros() }
    }

    /// The ball at `time` after the start.
    pub(super) fn after(&self, time: f64) -> PathPoint {
        let bend = 0.5 * time * time * self.bend;
        PathPoint {
            time: self.start + time,
            position: self.flight.position_after(time) + time / 3.0 * bend,
            motion: Motion {
                velocity: self.flight.velocity_after(time) + bend,
                spin: self.spin + time * self.turning,
            },
        }
    }

    /// The ball at the end.
    ///
    /// # Errors
    /// [`RangeError`] if a coordinate overflows.
    pub(super) fn reached(&self) -> Result<PathPoint, RangeError> {
        let end = self.after(self.duration);
        RangeError::finite("position", end.position.sum())?;
        RangeError::finite("velocity", end.motion.velocity.sum())?;
        RangeError::finite("spin", end.motion.spin.sum())?;
        Ok(end)
    }

    /// The highest point, against gravity, if it lies within the flight.
    fn apex(&self) -> Option<PathPoint> {
        let Flight { velocity, gravity, .. } = self.flight;
        let time = -velocity.dot(&gravity) / gravity.norm_squared();
        (time > 0.0 && time < self.duration).then(|| self.after(time))
    }
}

/// How the ball moves on a wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Manner {
    /// The contact point slips.
    Slides,
    /// The contact point does not slip.
    Rolls,
}

/// What happens at an instant of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventKind {
    /// The ball bounces off this wall; the motion is that afterwards.
    Bounce {
        /// The wall.
        wall: usize,
    },
    /// The ball is at its highest, against gravity.
    Apex,
    /// The ball begins to move on this wall, in another manner than before.
    Moves {
        /// The wall.
        wall: usize,
        /// How it moves from now on.
        manner: Manner,
    },
    /// The path ends.
    End(Ending),
}

impl EventKind {
    /// Its word in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bounce { .. } => "bounce",
            Self::Apex => "apex",
            Self::Moves { manner: Manner::Slides, .. } => "slides",
            Self::Moves { manner: Manner::Rolls, .. } => "rolls",
            Self::End(Ending::Rest { .. }) => "rest",
            Self::End(Ending::Edge { .. }) => "edge",
            Self::End(Ending::Wedged { .. }) => "wedged",
            Self::End(Ending::Carried { .. }) => "carried",
            Self::End(Ending::Time | Ending::Bounces) => "end",
        }
    }

    /// The wall at which it happens.
    #[must_use]
    pub const fn wall(self) -> Option<usize> {
        match self {
            Self::Bounce { wall }
            | Self::Moves { wall, .. }
            | Self::End(
                Ending::Rest { wall }
                | Ending::Carried { wall }
                | Ending::Edge { wall }
                | Ending::Wedged { wall, .. },
            ) => Some(wall),
            Self::Apex | Self::End(Ending::Time | Ending::Bounces) => None,
        }
    }
}

/// An instant of a path at which its course changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// What happens.
    pub kind: EventKind,
    /// The ball.
    pub at: PathPoint,
}

/// The ball at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPoint {
    /// Time since the start.
    pub time: f64,
    /// Position of the centre.
    pub position: Vector3<f64>,
    /// Motion of the ball.
    pub motion: Motion,
}

/// A bounce off a wall.
#[derive(Debug, Clone, PartialEq)]
pub struct Bounce {
    /// Time since the start.
    pub time: f64,
    /// The wall, numbered from 0 in the order they were added.
    pub wall: usize,
    /// Position of the centre.
    pub position: Vector3<f64>,
    /// Unit normal of the wall, into the ball.
    pub normal: Vector3<f64>,
    /// Motion of the ball before.
    pub before: Motion,
    /// Motion of the ball after.
    pub after: Motion,
    /// The whole impact: R_x, regimes, impulse, energy, warnings. The ball is body 1.
    pub rebound: Rebound,
}

impl Bounce {
    /// Time, position and motion of the ball; the impact is described by [`Rebound::COLUMNS`].
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("time", "s", "since the start", |bounce| bounce.time.into()),
        Column::vector("position", "m", "of the centre", |bounce| {
            <[f64; 3]>::from(bounce.position).into()
        }),
        Column::vector("velocity_before", "m/s", "of the centre", |bounce| {
            <[f64; 3]>::from(bounce.before.velocity).into()
        }),
        Column::vector("spin_before", "rad/s", "", |b| <[f64; 3]>::from(b.before.spin).into()),
        Column::vector("velocity", "m/s", "of the centre afterwards", |bounce| {
            <[f64; 3]>::from(bounce.after.velocity).into()
        }),
        Column::vector("spin", "rad/s", "afterwards", |b| <[f64; 3]>::from(b.after.spin).into()),
    ];
}

impl Event {
    /// Time, event, position and motion; walls have names elsewhere.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("time", "s", "since the start", |event| event.at.time.into()),
        Column::text(
            "event",
            "",
            "bounce, apex, slides or rolls (begins to), rest, carried, edge, wedged or end",
            |event| event.kind.name().into(),
        ),
        Column::vector("position", "m", "of the centre", |event| {
            <[f64; 3]>::from(event.at.position).into()
        }),
        Column::vector("velocity", "m/s", "of the centre, from then on", |event| {
            <[f64; 3]>::from(event.at.motion.velocity).into()
        }),
        Column::vector("spin", "rad/s", "from then on", |event| {
            <[f64; 3]>::from(event.at.motion.spin).into()
        }),
    ];
}

impl PathPoint {
    /// Time, position and motion.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("time", "s", "since the start", |point| point.time.into()),
        Column::vector("position", "m", "of the centre", |point| {
            <[f64; 3]>::from(point.position).into()
        }),
        Column::vector("velocity", "m/s", "of the centre", |point| {
            <[f64; 3]>::from(point.motion.velocity).into()
        }),
        Column::vector("spin", "rad/s", "", |point| <[f64; 3]>::from(point.motion.spin).into()),
    ];
}

/// Why a path ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The time limit is reached.
    Time,
    /// The limit of bounces is reached.
    Bounces,
    /// The ball rests on this wall. Its spin about the normal may go on.
    Rest {
        /// The wall.
        wall: usize,
    },
    /// The ball no longer rises from this wall, which moves; what it does on it is not followed.
    Carried {
        /// The wall.
        wall: usize,
    },
    /// The ball hits an edge of this wall, or comes to the edge of the wall on which it moves; a sharp edge has no Hertz
    /// contact.
    Edge {
        /// The wall.
        wall: usize,
    },
    /// Gravity presses the ball into the corner of two walls, or it bounces between them faster than a contact lasts; what it
    /// does there is not followed.
    Wedged {
        /// One wall.
        wall: usize,
        /// The other.
        other: usize,
    },
}

/// A part of a path: from the start or a bounce to the next event.
#[derive(Debug, Clone, PartialEq)]
pub struct Leg {
    pub(super) flight: Option<TimedFlight>,
    pub(super) bounce: Option<Bounce>,
    pub(super) ending: Option<Ending>,
    /// The wall on which the ball moves, and how; none in flight.
    pub(super) on: Option<(usize, Manner)>,
    /// Whether the leg before was not of this kind.
    pub(super) begins: bool,
    /// The ball at the end.
    pub(super) end: Option<PathPoint>,
}

impl Leg {
    /// A leg in which nothing has happened yet.
    pub(super) fn empty() -> Self {
        Self { flight: None, bounce: None, ending: None, on: None, begins: false, end: None }
    }

    /// One at whose start the path ends.
    pub(super) fn ending_with(ending: Ending) -> Self {
        Self { ending: Some(ending), ..Self::empty() }
    }

    /// One on a wall.
    pub(super) fn on(wall: usize, manner: Manner) -> Self {
        Self { on: Some((wall, manner)), ..Self::empty() }
    }

    /// The wall on which the ball moves in this leg, and how; None in flight.
    #[must_use]
    pub const fn on_wall(&self) -> Option<(usize, Manner)> {
        self.on
    }

    /// What happens in this leg, in order.
    pub fn events(&self) -> impl Iterator<Item = Event> {
        let event = |kind, at| Event { kind, at };
        let flight = self.flight.as_ref();
        let moves = self.on.filter(|_| self.begins).zip(flight).map(|((wall, manner), flight)| {
            event(EventKind::Moves { wall, manner }, flight.after(0.0))
        });
        let apex = flight.filter(|_| self.on.is_none()).and_then(TimedFlight::apex);
        let bounce = self.bounce.as_ref().map(|bounce| {
            let Bounce { time, wall, position, after, .. } = *bounce;
            event(EventKind::Bounce { wall }, PathPoint { time, position, motion: after })
        });
        let end = self.ending.zip(self.end).map(|(ending, at)| event(EventKind::End(ending), at));
        let apex = apex.map(|at| event(EventKind::Apex, at));
        [moves, apex, bounce, end].into_iter().flatten()
    }

    /// The bounce at its end; None if the path ends otherwise, or the ball touches a wall without approaching
    /// it.
    #[must_use]
    pub const fn bounce(&self) -> Option<&Bounce> {
        self.bounce.as_ref()
    }

    /// Why the path ends after this leg; None if another leg follows.
    #[must_use]
    pub const fn ending(&self) -> Option<Ending> {
        self.ending
    }

    /// The ball at `count` instants of its flight, as [`Path::points`]; none without a flight.
    ///
    /// # Errors
    /// [`RangeError`] for fewer than two instants.
    pub fn points(&self, count: usize) -> Result<Vec<PathPoint>, RangeError> {
        points(self.flight.as_slice(), count)
    }
}

/// The ball at `count` instants of every flight.
fn points(flights: &[TimedFlight], count: usize) -> Result<Vec<PathPoint>, RangeError> {
    RangeError::check("points", count as f64, count >= 2, ">= 2")?;
    let last = (count - 1) as f64;
    let of = |flight: &TimedFlight| {
        let flight = *flight;
        (0..count).map(move |i| flight.after(flight.duration * (i as f64 / last)))
    };
    Ok(flights.iter().flat_map(of).collect())
}

/// The path of the ball.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    pub(super) flights: Vec<TimedFlight>,
    pub(super) bounces: Vec<Bounce>,
    pub(super) events: Vec<Event>,
    pub(super) ending: Ending,
    pub(super) last: PathPoint,
}

impl Path {
    /// The bounces in order.
    #[must_use]
    pub fn bounces(&self) -> &[Bounce] {
        &self.bounces
    }

    /// Bounces, highest points, where it begins to slide or to roll, and the end, in order.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// Why it ends.
    #[must_use]
    pub const fn ending(&self) -> Ending {
        self.ending
    }

    /// The ball at the end.
    #[must_use]
    pub const fn last(&self) -> PathPoint {
        self.last
    }

    /// The ball at `count` instants of every flight, equally spaced in time, both ends included: at
    /// a bounce one point before and one after it.
    ///
    /// # Errors
    /// [`RangeError`] for fewer than two instants.
    pub fn points(&self, count: usize) -> Result<Vec<PathPoint>, RangeError> {
        points(&self.flights, count)
    }
}
