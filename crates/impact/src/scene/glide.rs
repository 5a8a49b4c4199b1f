//! Motion of the ball on a wall: it slides, rolls or rests.
//!
//! With n the normal of the wall into the ball, N = -g.n the normal force over the mass, k = I/(m R^2), v the velocity of the
//! centre and s = R n x omega that of the contact point by the spin, the contact point slips with u = v + s. Sliding,
//!
//! v' = g_t - f N u/|u|,   s' = -(f N/k) u/|u| - (mu_r N/k) s/|s|,
//!
//! where g_t is gravity along the wall and mu_r R N m the torque that resists rolling. Rolling, u = 0 and
//! v' = (g_t - mu_r N v/|v|)/(1 + k), for which the wall must bear the force |k g_t + mu_r N v/|v||/(1 + k) over the mass, at
//! most the friction limit at rest. The spin about the normal stays as it is: a contact point has no torque about it.

use carom_special::RangeError;
use nalgebra::Vector3;

use super::path::Manner;
use super::wall::Wall;
use crate::impact_friction::ImpactFriction;

/// Vectors are parallel if their cross product is below this part of the product of their sizes.
const PARALLEL: f64 = 1e-13;
/// Gravity along a wall below this part of the whole is round-off.
const ROUNDING: f64 = 1e-13;
/// A slip, a spin or a velocity below this part of the velocities of the motion is over.
const OVER: f64 = 1e-12;
/// In this part of the time in which the velocity changes, accelerations that turn are constant within the square of it.
const BEGINNING: f64 = 1e-7;
/// The same, at most, where a slip hardly grows.
const LONG_BEGINNING: f64 = 1e-3;

/// What a ball of a wall moves under.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ground {
    /// The normal of the wall, into the ball.
    pub(super) normal: Vector3<f64>,
    /// Gravity along the wall.
    along: Vector3<f64>,
    /// The normal force over the mass, N.
    pressing: f64,
    friction: ImpactFriction,
    /// mu_r.
    pub(super) rolling: f64,
    /// k.
    inertia: f64,
    radius: f64,
    /// A velocity of its size: sqrt(N R), or that of the surface by the spin about the normal if greater.
    pub(super) unit: f64,
}

/// Velocity of the centre along the wall, and of the contact point by the spin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Gliding {
    pub(super) velocity: Vector3<f64>,
    pub(super) spinning: Vector3<f64>,
}

/// How the ball goes on.
#[derive(Debug)]
pub(super) enum Course {
    /// It stays where it is.
    Rests,
    /// Accelerations of the centre and of the contact point by the spin are constant for this time.
    Constant(Steady),
    /// They turn.
    Turning(Manner),
}

/// A motion with constant accelerations.
#[derive(Debug, Clone, Copy)]
pub(super) struct Steady {
    pub(super) manner: Manner,
    pub(super) acceleration: Vector3<f64>,
    pub(super) spinning: Vector3<f64>,
    /// When it ends by itself, and how.
    pub(super) end: Option<(f64, Stop)>,
}

/// What ends a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stop {
    /// The contact point slips enough for its slip to have a direction.
    Begin,
    /// The contact point no longer slips.
    Slip,
    /// The spin along the wall is zero.
    Spin,
    /// The ball stands still.
    Motion,
}

impl Gliding {
    /// The slip of the contact point.
    pub(super) fn slip(&self) -> Vector3<f64> {
        self.velocity + self.spinning
    }

    /// The same after a stop.
    pub(super) fn stopped(self, stop: Stop) -> Self {
        match stop {
            Stop::Begin => self,
            Stop::Slip => Self { spinning: -self.velocity, ..self },
            Stop::Spin => Self { spinning: Vector3::zeros(), ..self },
            Stop::Motion => Self { velocity: Vector3::zeros(), spinning: Vector3::zeros() },
        }
    }
}

fn direction(vector: &Vector3<f64>) -> Vector3<f64> {
    let size = vector.norm();
    if size > 0.0 { vector / size } else { Vector3::zeros() }
}

fn parallel(one: &Vector3<f64>, other: &Vector3<f64>) -> bool {
    one.cross(other).norm() <= PARALLEL * one.norm() * other.norm()
}

/// When a vector that changes at a constant rate along itself vanishes.
fn vanishes(vector: &Vector3<f64>, rate: &Vector3<f64>) -> Option<f64> {
    let size = vector.norm();
    let speed = -rate.dot(&direction(vector));
    (size > 0.0 && speed > 0.0).then(|| size / speed)
}

impl Ground {
    /// The ground of a wall for a ball of this k, with this spin about the normal, under gravity.
    pub(super) fn new(
        wall: &Wall,
        normal: Vector3<f64>,
        gravity: &Vector3<f64>,
        (inertia, radius): (f64, f64),
        spin: f64,
    ) -> Self {
        let pressing = -gravity.dot(&normal);
        let along = gravity + pressing * normal;
        // Gravity straight into the wall has no part along it.
        let along =
            if along.norm() <= ROUNDING * gravity.norm() { Vector3::zeros() } else { along };
        let (friction, rolling) = (wall.friction(), wall.rolling_resistance());
        let unit = (pressing * radius).sqrt().max(radius * spin.abs());
        Self { normal, along, pressing, friction, rolling, inertia, radius, unit }
    }

    /// The motion after infinite friction has ended any slip: the moment of momentum about the contact point stays.
    pub(super) fn gripped(&self, now: Gliding) -> Gliding {
        if !self.friction.is_infinite() {
            return now;
        }
        let velocity = (now.velocity - self.inertia * now.spinning) / (1.0 + self.inertia);
        Gliding { velocity, spinning: -velocity }
    }

    /// The angular velocity along the wall with which the contact point moves like this.
    pub(super) fn spin(&self, spinning: &Vector3<f64>) -> Vector3<f64> {
        spinning.cross(&self.normal) / self.radius
    }

    /// What is round-off in the velocities of a motion, at most.
    fn least(&self, now: &Gliding) -> f64 {
        OVER * now.velocity.norm().max(now.spinning.norm()).max(self.unit)
    }

    /// The same motion with zero for round-off, which would have a direction of its own.
    pub(super) fn rounded(&self, now: Gliding) -> Gliding {
        let least = self.least(&now);
        let turns = now.spinning.norm() > least;
        let now = if turns { now } else { now.stopped(Stop::Spin) };
        if now.slip().norm() > least {
            return now;
        }
        let moves = now.velocity.norm() > OVER * self.unit;
        now.stopped(if moves { Stop::Slip } else { Stop::Motion })
    }

    /// The acceleration of the centre at the beginning of a course.
    pub(super) fn acceleration(&self, course: &Course, now: &Gliding) -> Vector3<f64> {
        match course {
            Course::Rests => Vector3::zeros(),
            Course::Constant(steady) => steady.acceleration,
            Course::Turning(manner) => self.rates(*manner, now)[0],
        }
    }

    /// What is over in a motion that turns.
    pub(super) fn is_over(&self, manner: Manner, now: &Gliding) -> Option<Stop> {
        match manner {
            Manner::Slides => {
                let least = self.least(now);
                // Where the torque that resists exceeds that of friction the ball ends without spin.
                let still = self.rolling > 0.0 && now.spinning.norm() <= least;
                let stops = still && now.spinning.norm() > 0.0;
                match now.slip().norm() <= least {
                    true => Some(Stop::Slip),
                    false => stops.then_some(Stop::Spin),
                }
            }
            Manner::Rolls => (now.velocity.norm() <= OVER * self.unit).then_some(Stop::Motion),
        }
    }

    /// The rates of velocity and spin in a motion that turns.
    pub(super) fn rates(&self, manner: Manner, now: &Gliding) -> [Vector3<f64>; 2] {
        match manner {
            Manner::Slides => {
                let slip = now.slip();
                let rates = self.slides(&direction(&slip), &now.spinning, slip.norm());
                // The integration reports what is not finite.
                rates.unwrap_or([Vector3::repeat(f64::NAN); 2])
            }
            Manner::Rolls => {
                let rate = self.rolls(&now.velocity);
                [rate, -rate]
            }
        }
    }

    /// Friction over the mass at a slip speed.
    fn sliding(&self, slip: f64) -> Result<f64, RangeError> {
        let friction = self.friction.at(&Vector3::new(slip, 0.0, 0.0))?.get();
        Ok(friction * self.pressing)
    }

    /// The greatest friction without slip over the mass.
    fn sticking(&self) -> Result<f64, RangeError> {
        match self.friction.static_friction() {
            Some(friction) => Ok(friction.threshold().get() * self.pressing),
            None => self.sliding(0.0),
        }
    }

    /// What friction must bear over the mass where the ball rolls.
    fn needed(&self, velocity: &Vector3<f64>) -> Vector3<f64> {
        let towards = if velocity.norm() > 0.0 { velocity } else { &self.along };
        let resistance = self.rolling * self.pressing * direction(towards);
        (self.inertia * self.along + resistance) / (1.0 + self.inertia)
    }

    /// Whether friction bears it.
    pub(super) fn bears(&self, velocity: &Vector3<f64>) -> Result<bool, RangeError> {
        Ok(self.needed(velocity).norm() <= self.sticking()?)
    }

    /// Acceleration of a rolling ball.
    fn rolls(&self, velocity: &Vector3<f64>) -> Vector3<f64> {
        let resistance = self.rolling * self.pressing;
        let towards =
            if velocity.norm() > 0.0 { direction(velocity) } else { direction(&self.along) };
        (self.along - resistance * towards) / (1.0 + self.inertia)
    }

    /// Rates of velocity and spin of a ball that slips in a direction.
    fn slides(
        &self,
        slip: &Vector3<f64>,
        spinning: &Vector3<f64>,
        speed: f64,
    ) -> Result<[Vector3<f64>; 2], RangeError> {
        let friction = self.sliding(speed)?;
        let resistance = self.rolling * self.pressing;
        let turned = if spinning.norm() > 0.0 {
            friction * slip + resistance * direction(spinning)
        } else {
            // From rest the spin follows friction if that exceeds the resistance.
            (friction - resistance).max(0.0) * slip
        };
        Ok([self.along - friction * slip, -turned / self.inertia])
    }

    /// How the ball goes on from a motion without round-off.
    pub(super) fn course(&self, now: &Gliding) -> Result<Course, RangeError> {
        let slip = now.slip();
        if slip.norm() > 0.0 {
            return self.slide(now, direction(&slip), slip.norm());
        }
        let resistance = self.rolling * self.pressing;
        let stands = now.velocity.norm() == 0.0;
        if stands && self.along.norm() <= resistance.min(self.sticking()?) {
            return Ok(Course::Rests);
        }
        if !self.bears(&now.velocity)? {
            return self.slide(now, direction(&self.needed(&now.velocity)), 0.0);
        }
        let acceleration = self.rolls(&now.velocity);
        if resistance > 0.0 && !parallel(&now.velocity, &self.along) {
            return Ok(Course::Turning(Manner::Rolls));
        }
        let stop = if resistance > 0.0 { vanishes(&now.velocity, &acceleration) } else { None };
        let end = stop.map(|time| (time, Stop::Motion));
        Ok(Course::Constant(Steady {
            manner: Manner::Rolls,
            acceleration,
            spinning: -acceleration,
            end,
        }))
    }

    fn slide(&self, now: &Gliding, slip: Vector3<f64>, speed: f64) -> Result<Course, RangeError> {
        let straight =
            parallel(&slip, &self.along) && (self.rolling == 0.0 || parallel(&slip, &now.spinning));
        let turns = !straight || matches!(self.friction, ImpactFriction::SlipSpeed(_));
        if turns && speed > 0.0 {
            return Ok(Course::Turning(Manner::Slides));
        }
        let [acceleration, spinning] = self.slides(&slip, &now.spinning, speed)?;
        if turns {
            let end = Some((self.beginning(now, &acceleration, &spinning), Stop::Begin));
            let manner = Manner::Slides;
            return Ok(Course::Constant(Steady { manner, acceleration, spinning, end }));
        }
        let ends = [
            vanishes(&(speed * slip), &(acceleration + spinning)).map(|time| (time, Stop::Slip)),
            (self.rolling > 0.0)
                .then(|| vanishes(&now.spinning, &spinning))
                .flatten()
                .map(|time| (time, Stop::Spin)),
        ];
        let end = ends.into_iter().flatten().min_by(|one, other| one.0.total_cmp(&other.0));
        Ok(Course::Constant(Steady { manner: Manner::Slides, acceleration, spinning, end }))
    }

    /// How long a slip that begins with these rates, and then turns, goes straight: until it is more than round-off.
    fn beginning(&self, now: &Gliding, rate: &Vector3<f64>, turning: &Vector3<f64>) -> f64 {
        let (speed, rates) = (now.velocity.norm(), rate.norm() + turning.norm());
        let longest = LONG_BEGINNING * speed.max(self.unit) / rates;
        let grown = 2.0 * self.least(now) / (rate + turning).norm();
        let speed = if speed > 0.0 { speed } else { self.unit };
        (BEGINNING * speed / rates).max(grown.min(longest))
    }
}
