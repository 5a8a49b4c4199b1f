//! A scene, computed from event to event.

use carom_special::RangeError;
use nalgebra::Vector3;

use super::ball::Ball;
use super::chatter::Chatter;
use super::error::SceneError;
use super::flight::{Flight, along};
use super::path::{Bounce, Ending, Leg, Limits, Manner, Path, PathPoint, TimedFlight};
use super::wall::{Meeting, Wall};
use crate::body::Body;
use crate::collision::{AnalyticOrRings, Collision, CollisionSolver};
use crate::motion::Motion;
use crate::outcome::{Outcome, TorsionMode};

/// The walls and the gravity of a scene.
///
/// Each impact is computed with [`AnalyticOrRings`], which accounts for the coupling of dissimilar materials.
/// A bounce of similar bodies in a plane takes some microseconds; by rings, with a viscous loss or with slip that turns some
/// milliseconds or more.
///
/// If the ball touches two walls at the same instant, as in a corner, it bounces off the one added first,
/// then off the other.
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::scene::{Ball, Ending, Limits, Scene, Wall};
/// use carom_impact::Body;
/// use carom_laws::friction::Friction;
/// let rubber = Material::from_young(20e6, 0.5)?;
/// let floor = Wall::new([0.0; 3], [0.0, 0.0, 1.0], Material::RIGID, Friction::new(0.3)?)?;
/// let scene = Scene::new([0.0, 0.0, -10.0])?.with(floor);
/// // Dropped from 5 m without spin: elastic bounces 2 s apart, the first after 1 s.
/// let ball = Ball::new(Body::sphere(0.02, rubber, 0.03)?.at([0.0, 0.0, 5.02])?)?;
/// let path = scene.run(&ball, Limits::new(6.0, 100)?)?;
/// let times: Vec<f64> = path.bounces().iter().map(|bounce| bounce.time).collect();
/// assert_eq!(times.len(), 3);
/// assert!((times[2] - 5.0).abs() < 1e-12);
/// assert_eq!(path.ending(), Ending::Time);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    gravity: Vector3<f64>,
    walls: Vec<Wall>,
    torsion: TorsionMode,
}

impl Scene {
    /// A scene without walls; gravity is an acceleration, and may be zero.
    ///
    /// # Errors
    /// [`RangeError`] if gravity is not finite.
    pub fn new(gravity: [f64; 3]) -> Result<Self, RangeError> {
        for value in gravity {
            RangeError::finite("gravity", value)?;
        }
        let torsion = TorsionMode::default();
        Ok(Self { gravity: gravity.into(), walls: Vec::new(), torsion })
    }

    /// Adds a wall.
    #[must_use]
    pub fn with(mut self, wall: Wall) -> Self {
        self.walls.push(wall);
        self
    }

    /// The same scene with friction acting on the spin about the normal always, never, or where it matters.
    #[must_use]
    pub fn with_torsion_mode(self, torsion: TorsionMode) -> Self {
        Self { torsion, ..self }
    }

    /// The walls, in the order they were added.
    #[must_use]
    pub fn walls(&self) -> &[Wall] {
        &self.walls
    }

    /// The acceleration of free fall.
    #[must_use]
    pub const fn gravity(&self) -> Vector3<f64> {
        self.gravity
    }

    /// Computes the path of the ball up to a limit, rest or an edge.
    ///
    /// # Errors
    /// [`SceneError::Inside`] if the ball overlaps a wall at the start, [`SceneError::Collision`] if it
    /// cannot collide with a wall (both rigid), or an impact fails; [`SceneError::Range`] if a coordinate
    /// overflows.
    pub fn run(&self, ball: &Ball, limits: Limits) -> Result<Path, SceneError> {
        self.run_by(AnalyticOrRings, ball, limits)
    }

    /// As [`Scene::run`], with another solver of collisions.
    ///
    /// # Errors
    /// As [`Scene::run`].
    pub fn run_by<S: CollisionSolver>(
        &self,
        solver: S,
        ball: &Ball,
        limits: Limits,
    ) -> Result<Path, SceneError<S::Error>> {
        let mut legs = self.legs_by(solver, ball, limits)?;
        let (mut flights, mut bounces, mut ending) = (Vec::new(), Vec::new(), Ending::Time);
        let mut events = Vec::new();
        for leg in &mut legs {
            let leg = leg?;
            events.extend(leg.events());
            flights.extend(leg.flight);
            bounces.extend(leg.bounce);
            ending = leg.ending.unwrap_or(ending);
        }
        Ok(Path { flights, bounces, events, ending, last: legs.now() })
    }

    /// As [`Scene::run`], leg by leg: for paths with more bounces than fit into memory.
    ///
    /// ```
    /// # use carom_halfspace::Material;
    /// # use carom_impact::scene::{Ball, Limits, Scene, Wall};
    /// # use carom_impact::Body;
    /// # use carom_laws::friction::Friction;
    /// # let floor = Wall::new([0.0; 3], [0.0, 0.0, 1.0], Material::RIGID, Friction::new(0.3)?)?;
    /// # let scene = Scene::new([0.0, 0.0, -10.0])?.with(floor);
    /// # let rubber = Material::from_young(20e6, 0.5)?;
    /// # let ball = Ball::new(Body::sphere(0.02, rubber, 0.03)?.at([0.0, 0.0, 5.02])?)?;
    /// let mut bounces = 0;
    /// for leg in scene.legs(&ball, Limits::new(6.0, 100)?)? {
    ///     bounces += usize::from(leg?.bounce().is_some());
    /// }
    /// assert_eq!(bounces, 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`SceneError::Inside`] and [`SceneError::Collision`] as for [`Scene::run`]. A leg may also be an
    /// error; it is then the last.
    pub fn legs(&self, ball: &Ball, limits: Limits) -> Result<Legs<'_>, SceneError> {
        self.legs_by(AnalyticOrRings, ball, limits)
    }

    /// As [`Scene::legs`], with another solver of collisions.
    ///
    /// # Errors
    /// As [`Scene::legs`].
    pub fn legs_by<S: CollisionSolver>(
        &self,
        solver: S,
        ball: &Ball,
        limits: Limits,
    ) -> Result<Legs<'_, S>, SceneError<S::Error>> {
        self.check(ball).map_err(SceneError::of_solver)?;
        Ok(Legs::new(self, solver, ball, limits))
    }

    /// Checks that the ball can start at its position.
    ///
    /// # Errors
    /// [`SceneError::Inside`] and [`SceneError::Collision`] as for [`Scene::run`].
    pub fn check(&self, ball: &Ball) -> Result<(), SceneError> {
        for (index, wall) in self.walls.iter().enumerate() {
            let wall = wall.placed(0.0);
            let gap = wall.gap(&ball.position(), ball.radius());
            if gap < -wall.tolerance(&ball.position(), ball.radius()) {
                return Err(SceneError::Inside { wall: index, gap });
            }
            self.collision((index, 0.0), ball.body().clone(), &wall.normal())?;
        }
        Ok(())
    }

    fn collision(
        &self,
        (index, time): (usize, f64),
        body: Body,
        normal: &Vector3<f64>,
    ) -> Result<Collision, SceneError> {
        let wall = &self.walls[index];
        let plane = Body::plane(wall.material());
        let velocity = wall.velocity(time);
        let plane = plane.moving(Motion { velocity, spin: Vector3::zeros() });
        Collision::along(body, plane, (*normal).into(), wall.friction())
            .map(|collision| {
                collision
                    .with_normal_restitution(wall.normal_restitution().clone())
                    .with_torsion_mode(self.torsion)
            })
            .map_err(|source| SceneError::Collision { wall: index, source })
    }
}

/// A ball that loses energy in each bounce would make infinitely many bounces in a finite time. It comes to
/// rest when it rises less than this fraction of its radius.
const LOW: f64 = 1e-6;

/// Velocities along a normal below this part of sqrt(g R) are round-off in a corner.
const STILL: f64 = 1e-12;

/// Legs without time before a path is refused.
const MOST_IDLE: usize = 1000;

/// The legs of a path in order, each computed when it is requested.
#[derive(Debug)]
pub struct Legs<'a, S = AnalyticOrRings> {
    pub(super) scene: &'a Scene,
    solver: S,
    pub(super) body: Body,
    pub(super) radius: f64,
    pub(super) limits: Limits,
    pub(super) now: PathPoint,
    bounces: usize,
    chatter: Chatter,
    /// The moving wall from which the ball does not rise any more.
    carried: Option<usize>,
    /// Legs without time, one after the other.
    idle: usize,
    /// How the ball moved in the last leg.
    on: Option<(usize, Manner)>,
    is_over: bool,
}

impl<S: CollisionSolver> Iterator for Legs<'_, S> {
    type Item = Result<Leg, SceneError<S::Error>>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.is_over {
            return None;
        }
        let before = self.now.time;
        let leg = self.step().and_then(|leg| self.watched(leg, before)).map(|leg| {
            let begins = leg.flight.is_some() && leg.on != self.on;
            if leg.flight.is_some() {
                // A bounce begins a motion anew.
                self.on = leg.on.filter(|_| leg.bounce.is_none());
            }
            Leg { begins, end: Some(self.now), ..leg }
        });
        self.is_over = leg.as_ref().map_or(true, |leg| leg.ending.is_some());
        Some(leg)
    }
}

impl<S> Legs<'_, S> {
    /// The ball at the end of the last leg.
    #[must_use]
    pub const fn now(&self) -> PathPoint {
        self.now
    }
}

impl<'a, S: CollisionSolver> Legs<'a, S> {
    fn new(scene: &'a Scene, solver: S, ball: &Ball, limits: Limits) -> Self {
        let motion = ball.body().motion();
        Self {
            scene,
            solver,
            body: ball.body().clone(),
            radius: ball.radius(),
            limits,
            now: PathPoint { time: 0.0, position: ball.position(), motion },
            bounces: 0,
            chatter: Chatter::default(),
            carried: None,
            idle: 0,
            on: None,
            is_over: false,
        }
    }

    /// Refuses a path that goes on without time passing.
    fn watched(&mut self, leg: Leg, before: f64) -> Result<Leg, SceneError<S::Error>> {
        let idles = leg.bounce.is_none() && leg.ending.is_none() && self.now.time <= before;
        self.idle = if idles { self.idle + 1 } else { 0 };
        let allowed =
            "earlier: here the ball changes its motion again and again without time passing";
        RangeError::check("time", self.now.time, self.idle < MOST_IDLE, allowed)?;
        Ok(leg)
    }

    /// Computes the leg to the next event.
    fn step(&mut self) -> Result<Leg, SceneError<S::Error>> {
        let flight = self.flight();
        let walls = || self.scene.walls.iter().enumerate();
        if let Some((wall, other)) = self.wedged().or_else(|| self.chatter.walls()) {
            return Ok(Leg::ending_with(Ending::Wedged { wall, other }));
        }
        let mut pressed = walls()
            .filter(|(_, w)| w.motion().is_none())
            .filter_map(|(wall, w)| w.pressed(&flight, self.radius).map(|normal| (wall, normal)));
        if let Some((wall, normal)) = pressed.next() {
            return self.on_wall(wall, normal);
        }
        if let Some(wall) = self.carried.take().or_else(|| self.carried_by()) {
            return Ok(Leg::ending_with(Ending::Carried { wall }));
        }
        let left = self.limits.time() - self.now.time;
        let mut first: Option<(usize, Meeting)> = None;
        for (index, wall) in walls() {
            let end = first.map_or(left, |(_, meeting)| meeting.time());
            match wall.meeting(self.now.time, &flight, self.radius, end)? {
                Some(met) if first.is_none_or(|(_, m)| met.time() < m.time()) => {
                    first = Some((index, met));
                }
                _ => {}
            }
        }
        match first {
            None => {
                let flight = Some(self.fly(left)?);
                self.now.time = self.limits.time();
                Ok(Leg { flight, ..Leg::ending_with(Ending::Time) })
            }
            Some((wall, Meeting::Edge { time })) => {
                let flight = Some(self.fly(time)?);
                Ok(Leg { flight, ..Leg::ending_with(Ending::Edge { wall }) })
            }
            Some((wall, Meeting::Face { time, normal })) => {
                let flight = Some(self.fly(time)?);
                Ok(Leg { flight, ..self.bounce(wall, normal)? })
            }
        }
    }

    /// A moving wall that the ball touches without moving against it, and into which gravity presses it.
    fn carried_by(&self) -> Option<usize> {
        let PathPoint { motion, time, .. } = self.now;
        self.scene.walls.iter().position(|wall| {
            let pull = along(&(wall.acceleration(time) - self.scene.gravity), &wall.normal());
            let least = STILL * (pull.max(0.0) * self.radius).sqrt();
            let speed = (motion.velocity - wall.velocity(time)).dot(&wall.normal());
            let touches = wall.motion().is_some() && self.touched(wall).is_some();
            touches && pull > 0.0 && speed.abs() <= least
        })
    }

    /// Whether the ball also touches another wall, into which gravity presses it.
    fn lies_on_another(&self, wall: usize) -> bool {
        self.scene.walls.iter().enumerate().any(|(index, other)| {
            let normal = self.touched(other).filter(|_| index != wall);
            normal.is_some_and(|normal| along(&self.scene.gravity, &normal) < 0.0)
        })
    }

    /// The normal of a wall whose face the ball touches now, into the ball.
    pub(super) fn touched(&self, wall: &Wall) -> Option<Vector3<f64>> {
        let (wall, place) = (wall.placed(self.now.time), self.now.position);
        let touches = wall.gap(&place, self.radius) <= wall.tolerance(&place, self.radius);
        wall.face(&place).filter(|_| touches)
    }

    /// Two walls that the ball touches, nearly without moving towards or away from them, and into which gravity presses it.
    fn wedged(&self) -> Option<(usize, usize)> {
        let motion = self.now.motion;
        let is_held = |wall: &Wall| {
            let normal = self.touched(wall)?;
            let pull = -along(&self.scene.gravity, &normal);
            let least = (2.0 * pull.max(0.0) * LOW * self.radius).sqrt();
            let speed = (motion.velocity - wall.velocity(self.now.time)).dot(&normal);
            (pull > 0.0 && speed.abs() <= least).then_some(())
        };
        let mut held =
            self.scene.walls.iter().enumerate().filter(|(_, wall)| is_held(wall).is_some());
        Some((held.next()?.0, held.next()?.0))
    }

    fn flight(&self) -> Flight {
        let PathPoint { position, motion, .. } = self.now;
        Flight { position, velocity: motion.velocity, gravity: self.scene.gravity }
    }

    fn fly(&mut self, duration: f64) -> Result<TimedFlight, RangeError> {
        let (start, spin) = (self.now.time, self.now.motion.spin);
        let flight = TimedFlight::free(start, duration, self.flight(), spin);
        self.now = flight.reached()?;
        Ok(flight)
    }

    /// The end of a leg at a wall: a bounce, or rest.
    pub(super) fn bounce(
        &mut self,
        wall: usize,
        normal: Vector3<f64>,
    ) -> Result<Leg, SceneError<S::Error>> {
        self.settle(wall, &normal);
        let before = self.now.motion;
        let body = self.body.clone().moving(before);
        let collision = self
            .scene
            .collision((wall, self.now.time), body, &normal)
            .map_err(SceneError::of_solver)?;
        let outcome = self.solver.solve(&collision);
        let outcome = outcome.map_err(|source| SceneError::Collision { wall, source })?;
        let (moves, now) = (&self.scene.walls[wall], self.now.time);
        let pull = along(&(moves.acceleration(now) - self.scene.gravity), &normal);
        let Outcome::Rebound(rebound) = outcome else {
            // Contact without approach: the ball stays, or gravity pulls it away.
            if pull >= 0.0 {
                self.stay(wall, &normal);
            }
            return Ok(Leg::empty());
        };
        let [after, _] = rebound.motions;
        let loses = rebound.energy.lost > 0.0;
        self.chatter.add(wall, self.now.time, rebound.duration);
        let bounce = Bounce {
            time: self.now.time,
            wall,
            position: self.now.position,
            normal,
            before,
            after,
            rebound: *rebound,
        };
        self.now.motion = after;
        self.bounces += 1;
        let speed = (after.velocity - moves.velocity(now)).dot(&normal);
        // In a corner friction may drive the ball into a wall again and again, whatever its loss.
        let cornered = self.lies_on_another(wall);
        let least = if loses || cornered { LOW * self.radius } else { 0.0 };
        let height = self.limits.rebound_height().max(least);
        let pull = if cornered { pull.max(self.scene.gravity.norm()) } else { pull };
        // v^2/(2 g) is the height of the rebound.
        let rests = pull > 0.0 && speed * speed < 2.0 * pull * height;
        if rests {
            self.stay(wall, &normal);
        }
        let ending = (self.bounces >= self.limits.bounces()).then_some(Ending::Bounces);
        Ok(Leg { bounce: Some(bounce), ending, ..Leg::empty() })
    }

    /// Leaves the ball on a wall.
    fn stay(&mut self, wall: usize, normal: &Vector3<f64>) {
        let of = &self.scene.walls[wall];
        let velocity = self.now.motion.velocity - of.velocity(self.now.time);
        self.now.motion.velocity -= velocity.dot(normal) * normal;
        self.carried = of.motion().map(|_| wall);
    }

    // Places the centre one radius from the wall, so that round-off of the flight does not accumulate.
    pub(super) fn settle(&mut self, wall: usize, normal: &Vector3<f64>) {
        let wall = self.scene.walls[wall].placed(self.now.time);
        let height = (self.now.position - wall.point()).dot(normal);
        self.now.position += (self.radius - height) * normal;
    }
}
