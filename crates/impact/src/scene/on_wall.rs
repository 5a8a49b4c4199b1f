//! The legs of a path on a wall.

use carom_special::RangeError;
use nalgebra::Vector3;

use super::flight::Flight;
use super::glide::{Course, Gliding, Ground, Steady, Stop};
use super::path::{Ending, Leg, Manner, TimedFlight};
use super::run::Legs;
use super::turned::Turned;
use super::wall::{Meeting, Wall};
use crate::collision::CollisionSolver;
use crate::scene::SceneError;

/// Velocities along the normal of a second wall below this part of sqrt(g R), and accelerations below this part of g, are
/// round-off.
const LEANING: f64 = 1e-9;

/// What ends a leg on a wall before its motion does.
enum Met {
    Wall { index: usize, normal: Vector3<f64> },
    Edge { index: usize },
}

impl<S: CollisionSolver> Legs<'_, S> {
    /// The leg on a wall up to the next event.
    pub(super) fn on_wall(
        &mut self,
        wall: usize,
        normal: Vector3<f64>,
    ) -> Result<Leg, SceneError<S::Error>> {
        self.settle(wall, &normal);
        let left = self.limits.time() - self.now.time;
        if left <= 0.0 {
            return Ok(Leg::ending_with(Ending::Time));
        }
        let ground = self.ground(wall, normal);
        let gliding = ground.rounded(ground.gripped(self.gliding(&normal)));
        self.set(&ground, gliding);
        let course = ground.course(&gliding)?;
        if let Some(other) = self.pressed_on(wall, &ground.acceleration(&course, &gliding)) {
            return Ok(Leg::ending_with(Ending::Wedged { wall, other }));
        }
        match course {
            Course::Rests => {
                self.set(&ground, gliding.stopped(Stop::Motion));
                Ok(Leg::ending_with(Ending::Rest { wall }))
            }
            Course::Constant(steady) => self.steadily((wall, &ground), &gliding, steady, left),
            Course::Turning(manner) => self.turning((wall, &ground), &gliding, manner, left),
        }
    }

    fn ground(&self, wall: usize, normal: Vector3<f64>) -> Ground {
        let [theta, ..] = self.body.inertia().moments();
        let inertia = theta / (self.body.inertia().mass() * self.radius * self.radius);
        let wall = &self.scene.walls()[wall];
        let spin = self.now.motion.spin.dot(&normal);
        Ground::new(wall, normal, &self.scene.gravity(), (inertia, self.radius), spin)
    }

    fn gliding(&self, normal: &Vector3<f64>) -> Gliding {
        let motion = self.now.motion;
        Gliding {
            velocity: motion.velocity - motion.velocity.dot(normal) * normal,
            spinning: self.radius * normal.cross(&motion.spin),
        }
    }

    fn set(&mut self, ground: &Ground, gliding: Gliding) {
        let (spin, n) = (self.now.motion.spin, &ground.normal);
        // What integration leaves along the normal would be a flight where the ball turns back.
        self.now.motion.velocity = gliding.velocity - gliding.velocity.dot(n) * n;
        self.now.motion.spin =
            ground.spin(&gliding.spinning) + spin.dot(&ground.normal) * ground.normal;
    }

    fn steadily(
        &mut self,
        (wall, ground): (usize, &Ground),
        gliding: &Gliding,
        steady: Steady,
        left: f64,
    ) -> Result<Leg, SceneError<S::Error>> {
        let flight = Flight {
            position: self.now.position,
            velocity: gliding.velocity,
            gravity: steady.acceleration,
        };
        let (end, stop) = match steady.end {
            Some((time, stop)) if time <= left => (time, Some(stop)),
            _ => (left, None),
        };
        let met = self.met(wall, &flight, end)?;
        let time = met.as_ref().map_or(end, |(time, _)| *time);
        let leg = TimedFlight {
            turning: ground.spin(&steady.spinning),
            ..TimedFlight::free(self.now.time, time, flight, self.now.motion.spin)
        };
        self.now = leg.reached()?;
        if let (None, Some(stop)) = (&met, stop) {
            self.set(ground, self.gliding(&ground.normal).stopped(stop));
        }
        let leg = Leg { flight: Some(leg), ..Leg::on(wall, steady.manner) };
        self.closed(leg, met.map(|(_, met)| met), stop.is_none())
    }

    fn turning(
        &mut self,
        (wall, ground): (usize, &Ground),
        gliding: &Gliding,
        manner: Manner,
        left: f64,
    ) -> Result<Leg, SceneError<S::Error>> {
        let begin = self.now;
        let mut turned = Turned::new(ground, manner, begin.position, gliding, left)?;
        if manner == Manner::Rolls {
            turned = turned.gripping(ground)?;
        }
        let mut met = None;
        if self.passed(wall, (begin.time + turned.end(), &turned.position(turned.end()))).is_some()
        {
            // The last instant before it meets something.
            let (mut free, mut over) = (0.0, turned.end());
            loop {
                let middle = 0.5 * (free + over);
                if middle <= free || middle >= over {
                    break;
                }
                match self.passed(wall, (begin.time + middle, &turned.position(middle))) {
                    Some(_) => over = middle,
                    None => free = middle,
                }
            }
            met = self.passed(wall, (begin.time + over, &turned.position(over)));
            if free == 0.0 {
                return self.closed(Leg::empty(), met, false);
            }
            turned.cut(free);
        }
        let leg = turned.flight(begin.time, begin.motion.spin, ground);
        self.now = leg.reached()?;
        self.now.position = turned.position(turned.end());
        let mut next = turned.gliding();
        if let (None, Some(stop)) = (&met, ground.is_over(manner, &next)) {
            next = next.stopped(stop);
        }
        self.set(ground, next);
        let is_over = met.is_none() && self.now.time >= self.limits.time();
        self.closed(Leg { flight: Some(leg), ..Leg::on(wall, manner) }, met, is_over)
    }

    /// The end of a leg on a wall.
    fn closed(
        &mut self,
        leg: Leg,
        met: Option<Met>,
        is_over: bool,
    ) -> Result<Leg, SceneError<S::Error>> {
        match met {
            Some(Met::Edge { index }) => {
                Ok(Leg { ending: Some(Ending::Edge { wall: index }), ..leg })
            }
            Some(Met::Wall { index, normal }) => {
                let met = self.bounce(index, normal)?;
                Ok(Leg { bounce: met.bounce, ending: met.ending, ..leg })
            }
            None if is_over => {
                self.now.time = self.limits.time();
                Ok(Leg { ending: Some(Ending::Time), ..leg })
            }
            None => Ok(leg),
        }
    }

    /// What a ball that moves on a wall with a constant acceleration meets first, up to a time: another wall, or the edge of
    /// its own.
    fn met(&self, own: usize, flight: &Flight, end: f64) -> Result<Option<(f64, Met)>, RangeError> {
        let rim = self.scene.walls()[own].rim(flight);
        let mut first =
            rim.filter(|time| *time <= end).map(|time| (time, Met::Edge { index: own }));
        for (index, wall) in self.scene.walls().iter().enumerate() {
            // It moves along a wall that it touches, or away from it.
            if index == own || self.leans_on(wall).is_some() {
                continue;
            }
            let until = first.as_ref().map_or(end, |(time, _)| *time);
            let met = match wall.meeting(self.now.time, flight, self.radius, until)? {
                Some(Meeting::Face { time, normal }) => (time, Met::Wall { index, normal }),
                Some(Meeting::Edge { time }) => (time, Met::Edge { index }),
                None => continue,
            };
            if first.as_ref().is_none_or(|(time, _)| met.0 < *time) {
                first = Some(met);
            }
        }
        Ok(first)
    }

    /// The normal of a fixed wall that the ball touches without moving against it.
    fn leans_on(&self, wall: &Wall) -> Option<Vector3<f64>> {
        let normal = self.touched(wall).filter(|_| wall.motion().is_none())?;
        let least = LEANING * (self.scene.gravity().norm() * self.radius).sqrt();
        let speed = self.now.motion.velocity.dot(&normal);
        (speed.abs() <= least).then_some(normal)
    }

    /// Another wall on which the ball leans, and into which it would accelerate.
    fn pressed_on(&self, own: usize, acceleration: &Vector3<f64>) -> Option<usize> {
        let least = LEANING * self.scene.gravity().norm();
        let presses = |wall: &Wall| {
            self.leans_on(wall).is_some_and(|normal| acceleration.dot(&normal) < -least)
        };
        let mut walls = self.scene.walls().iter().enumerate();
        walls.find(|(index, wall)| *index != own && presses(wall)).map(|(index, _)| index)
    }

    /// What a ball on a wall has passed at this place.
    fn passed(&self, own: usize, (time, place): (f64, &Vector3<f64>)) -> Option<Met> {
        if !self.scene.walls()[own].holds(place) {
            return Some(Met::Edge { index: own });
        }
        let mut others = self.scene.walls().iter().enumerate().filter(|(index, _)| *index != own);
        others.find_map(|(index, wall)| {
            let wall = wall.placed(time);
            (wall.gap(place, self.radius) < -wall.tolerance(place, self.radius)).then(|| match wall
                .face(place)
            {
                Some(normal) => Met::Wall { index, normal },
                None => Met::Edge { index },
            })
        })
    }
}
