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
}

impl TimedFlight {
    /// The ball at `time` after the start.
    pub(super) fn after(&self, time: f64) -> PathPoint {
        let velocity = self.flight.velocity_after(time);
        PathPoint {
            time: self.start + time,
            position: self.flight.position_after(time),
            motion: Motion { velocity, spin: self.spin },
        }
    }
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
    /// The ball stays on this wall: it rests, slides or rolls there, or rises less than the limit (with
    /// dissipation in the material, less than a millionth of its radius).
    Rest {
        /// The wall.
        wall: usize,
    },
    /// The ball hits an edge of this wall; a sharp edge has no Hertz contact.
    Edge {
        /// The wall.
        wall: usize,
    },
}

/// A part of a path: from the start or a bounce to the next event.
#[derive(Debug, Clone, PartialEq)]
pub struct Leg {
    pub(super) flight: Option<TimedFlight>,
    pub(super) bounce: Option<Bounce>,
    pub(super) ending: Option<Ending>,
}

impl Leg {
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
    pub(super) ending: Ending,
    pub(super) last: PathPoint,
}

impl Path {
    /// The bounces in order.
    #[must_use]
    pub fn bounces(&self) -> &[Bounce] {
        &self.bounces
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
