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
use carom_special::ode::{DenseStep, OdeError, Stepper, Tolerance};
use nalgebra::Vector3;

use super::flight::Flight;
use super::path::{Manner, TimedFlight};
use super::wall::Wall;
use crate::impact_friction::ImpactFriction;

/// Vectors are parallel if their cross product is below this part of the product of their sizes.
const PARALLEL: f64 = 1e-13;
/// A velocity below this part of those that make it up is round-off.
const ROUNDING: f64 = 1e-13;
/// A slip, or a velocity of rolling, below this part of that at the start of a step is over.
const OVER: f64 = 1e-12;
/// The longest step of an integration, over the time in which the slip or the velocity would vanish.
const SHARE: f64 = 0.2;
const TOLERANCE: f64 = 1e-13;

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
    rolling: f64,
    /// k.
    inertia: f64,
    radius: f64,
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
    /// The contact point no longer slips.
    Slip,
    /// The spin along the wall is zero.
    Spin,
    /// The ball stands still.
    Motion,
}

impl Gliding {
    /// The slip of the contact point; zero within round-off.
    pub(super) fn slip(&self) -> Vector3<f64> {
        let slip = self.velocity + self.spinning;
        let size = self.velocity.norm().max(self.spinning.norm());
        if slip.norm() <= ROUNDING * size { Vector3::zeros() } else { slip }
    }

    /// The same after a stop.
    pub(super) fn stopped(self, stop: Stop) -> Self {
        match stop {
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
    /// The ground of a wall for a ball of this k, under gravity.
    pub(super) fn new(
        wall: &Wall,
        normal: Vector3<f64>,
        gravity: &Vector3<f64>,
        (inertia, radius): (f64, f64),
    ) -> Self {
        let pressing = -gravity.dot(&normal);
        let along = gravity + pressing * normal;
        // Gravity straight into the wall has no part along it.
        let along =
            if along.norm() <= ROUNDING * gravity.norm() { Vector3::zeros() } else { along };
        let (friction, rolling) = (wall.friction(), wall.rolling_resistance());
        Self { normal, along, pressing, friction, rolling, inertia, radius }
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

    /// A velocity of its size: sqrt(N R).
    fn unit(&self) -> f64 {
        (self.pressing * self.radius).sqrt()
    }

    /// The acceleration of the centre at the beginning of a course.
    pub(super) fn acceleration(&self, course: &Course, now: &Gliding) -> Vector3<f64> {
        match course {
            Course::Rests => Vector3::zeros(),
            Course::Constant(steady) => steady.acceleration,
            Course::Turning(manner) => self.rates(*manner, now)[0],
        }
    }

    /// The slip of the contact point; zero within round-off.
    fn slip(&self, now: &Gliding) -> Vector3<f64> {
        let slip = now.slip();
        if slip.norm() <= OVER * self.unit() { Vector3::zeros() } else { slip }
    }

    /// What is over in a motion that turns.
    pub(super) fn is_over(&self, manner: Manner, now: &Gliding) -> Option<Stop> {
        let unit = self.unit();
        match manner {
            Manner::Slides => {
                let size = now.velocity.norm().max(now.spinning.norm()).max(unit);
                // Where the torque that resists exceeds that of friction the ball ends without spin.
                let still = self.rolling > 0.0 && now.spinning.norm() <= OVER * size;
                let stops = still && now.spinning.norm() > 0.0;
                match now.slip().norm() <= OVER * size {
                    true => Some(Stop::Slip),
                    false => stops.then_some(Stop::Spin),
                }
            }
            Manner::Rolls => (now.velocity.norm() <= OVER * unit).then_some(Stop::Motion),
        }
    }

    /// The rates of velocity and spin in a motion that turns.
    fn rates(&self, manner: Manner, now: &Gliding) -> [Vector3<f64>; 2] {
        match manner {
            Manner::Slides => {
                let slip = now.velocity + now.spinning;
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

    /// How the ball goes on from a motion.
    pub(super) fn course(&self, now: &Gliding) -> Result<Course, RangeError> {
        let slip = self.slip(now);
        if slip.norm() > 0.0 {
            return self.slide(now, direction(&slip), slip.norm());
        }
        let resistance = self.rolling * self.pressing;
        let stands = now.velocity.norm() <= OVER * self.unit();
        if stands && self.along.norm() <= resistance.min(self.sticking()?) {
            return Ok(Course::Rests);
        }
        let towards = if now.velocity.norm() > 0.0 {
            direction(&now.velocity)
        } else {
            direction(&self.along)
        };
        let force = (self.inertia * self.along + resistance * towards) / (1.0 + self.inertia);
        if force.norm() > self.sticking()? {
            return self.slide(now, direction(&force), 0.0);
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
        if !straight || matches!(self.friction, ImpactFriction::SlipSpeed(_)) {
            return Ok(Course::Turning(Manner::Slides));
        }
        let [acceleration, spinning] = self.slides(&slip, &now.spinning, speed)?;
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
}

/// A step of a motion whose accelerations turn.
#[derive(Debug)]
pub(super) struct Turned {
    dense: DenseStep<9>,
    end: f64,
}

/// Place, velocity and spin in one line.
fn line(place: Vector3<f64>, now: &Gliding) -> [f64; 9] {
    let mut line = [0.0; 9];
    for (i, vector) in [place, now.velocity, now.spinning].iter().enumerate() {
        line[3 * i..3 * i + 3].copy_from_slice(vector.as_slice());
    }
    line
}

fn part(line: &[f64; 9], i: usize) -> Vector3<f64> {
    Vector3::from_column_slice(&line[3 * i..3 * i + 3])
}

fn gliding(line: &[f64; 9]) -> Gliding {
    Gliding { velocity: part(line, 1), spinning: part(line, 2) }
}

impl Turned {
    /// A step from a place and a motion, of at most this time.
    pub(super) fn new(
        ground: &Ground,
        manner: Manner,
        place: Vector3<f64>,
        now: &Gliding,
        most: f64,
    ) -> Result<Self, OdeError> {
        let moving = match manner {
            Manner::Slides => now.velocity + now.spinning,
            Manner::Rolls => now.velocity,
        };
        let [rate, turning] = ground.rates(manner, now);
        let over = |moving: &Vector3<f64>, rate: &Vector3<f64>| match rate.norm() > 0.0 {
            true => SHARE * moving.norm() / rate.norm(),
            false => most,
        };
        let slides = manner == Manner::Slides;
        let moves = over(&moving, &if slides { rate + turning } else { rate });
        // The direction of the torque that resists changes at once where the spin vanishes.
        let turns = slides && ground.rolling > 0.0 && now.spinning.norm() > 0.0;
        let lasts = if turns { moves.min(over(&now.spinning, &turning)) } else { moves };
        let end = most.min(lasts);
        let slope = |_: f64, y: &[f64; 9]| {
            let now = gliding(y);
            let [rate, turning] = ground.rates(manner, &now);
            line(now.velocity, &Gliding { velocity: rate, spinning: turning })
        };
        let tolerance = Tolerance { absolute: TOLERANCE * ground.unit(), relative: TOLERANCE };
        let mut stepper = Stepper::new(0.0, line(place, now), end, tolerance, slope)?;
        stepper.step(end)?;
        let end = stepper.x();
        Ok(Self { dense: stepper.dense(), end })
    }

    /// Its time.
    pub(super) const fn end(&self) -> f64 {
        self.end
    }

    /// The same, ended at this time.
    pub(super) const fn cut(&mut self, end: f64) {
        self.end = end;
    }

    /// The centre after a time.
    pub(super) fn position(&self, time: f64) -> Vector3<f64> {
        part(&self.dense.at(time), 0)
    }

    /// The motion at the end.
    pub(super) fn gliding(&self) -> Gliding {
        gliding(&self.dense.at(self.end))
    }

    /// The flight with this start and end, of third degree in time.
    pub(super) fn flight(&self, start: f64, spin: Vector3<f64>, ground: &Ground) -> TimedFlight {
        let (from, to, time) = (self.dense.at(0.0), self.dense.at(self.end), self.end);
        let (place, velocity) = (part(&from, 0), part(&from, 1));
        let way = (part(&to, 0) - place - time * velocity) / (time * time);
        let change = (part(&to, 1) - velocity) / time;
        // way = a/2 + b t/6 and change = a + b t/2.
        let flight = Flight { position: place, velocity, gravity: 6.0 * way - 2.0 * change };
        TimedFlight {
            bend: 6.0 * (change - 2.0 * way) / time,
            turning: ground.spin(&(part(&to, 2) - part(&from, 2))) / time,
            ..TimedFlight::free(start, time, flight, spin)
        }
    }
}
