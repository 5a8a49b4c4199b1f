//! The resistance of two grains to rolling on each other.

use carom_special::RangeError;

use super::heats::Heats;
use super::load::GrainLoad;
use super::meeting::Meeting;
use super::vector::{Vector, cross, dot, plus, times};
use crate::stored::is_unit_or_zero;

/// The constants of a resistance to rolling: a spring and a dashpot side by side, in series with a slider.
///
/// With the relative radius R (1/R = 1/R_1 + 1/R_2) and the normal n into body 1 two bodies roll on each other with
/// the velocity `v = R (spin_1 - spin_2) x n`. Spring and dashpot exert the force
///
/// `F = - stiffness s - damping ds/dt`, up to `friction` times the normal force,
///
/// beyond which they slip: `ds/dt = v` without slip. The force acts on no body; the torque on body 1 is `R n x F`,
/// that on body 2 the opposite.
///
/// ```
/// use carom_laws::grains::{Grain, GrainRoll, Meeting, Rolling, RollingResistance};
/// let resistance = RollingResistance::new(3e4, 20.0, 0.02)?;
/// let below = Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 0.03, mass: 1.0 };
/// let above = Grain { place: [0.0, 0.0, 0.049999], spin: [0.0, 5.0, 0.0], radius: 0.02, ..below };
/// let meeting = Meeting::of_spheres(&above, &below, [0.5; 2])?;
/// let (mut roll, pressed) = (GrainRoll::default(), 50.0);
/// let mut rolling = Rolling { resistance: &resistance, relative_radius: 0.012, roll: &mut roll };
/// let torque = rolling.advance(&meeting, 1e-3, pressed, None)?;
/// // It acts against the spin, and has come to its limit.
/// assert!((torque[1] + 0.012 * 0.02 * pressed).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingResistance {
    stiffness: f64,
    damping: f64,
    friction: f64,
}

impl RollingResistance {
    /// From the spring, force over the displacement of rolling, N/m; the dashpot, force over the velocity of rolling,
    /// N s/m; and the slider, the greatest force over the normal force.
    ///
    /// # Errors
    /// [`RangeError`] unless all are finite and not negative.
    pub fn new(stiffness: f64, damping: f64, friction: f64) -> Result<Self, RangeError> {
        RangeError::non_negative("stiffness", stiffness)?;
        RangeError::non_negative("damping", damping)?;
        RangeError::non_negative("friction", friction)?;
        Ok(Self { stiffness, damping, friction })
    }

    fn energy(&self, shift: Vector) -> f64 {
        0.5 * self.stiffness * dot(shift, shift)
    }
}

/// The state of a resistance to rolling; by default that of two bodies that are apart.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct GrainRoll {
    /// The displacement of the spring, m.
    shift: Vector,
    /// The normal of the last step; zero while the bodies are apart.
    normal: Vector,
    /// The force of the last step, N.
    force: Vector,
}

impl GrainRoll {
    /// Number of numbers of a stored state.
    pub const NUMBERS: usize = size_of::<Self>() / size_of::<f64>();

    /// The torque on body 1 after the last step, N m.
    #[must_use]
    pub fn torque(&self, relative_radius: f64, meeting: &Meeting) -> [f64; 3] {
        times(cross(meeting.normal, self.force), relative_radius)
    }

    /// The energy of the spring, J.
    #[must_use]
    pub fn stored_energy(&self, resistance: &RollingResistance) -> f64 {
        resistance.energy(self.shift)
    }

    /// The state as numbers, all of which are zero while the bodies are apart.
    #[must_use]
    pub fn packed(&self) -> [f64; Self::NUMBERS] {
        let mut numbers = [0.0; Self::NUMBERS];
        numbers.copy_from_slice([self.shift, self.normal, self.force].as_flattened());
        numbers
    }

    /// The state that numbers are.
    ///
    /// # Errors
    /// [`RangeError`] of `roll` for numbers that are no state.
    pub fn unpacked(numbers: &[f64; Self::NUMBERS]) -> Result<Self, RangeError> {
        let mut parts = [[0.0; 3]; 3];
        parts.as_flattened_mut().copy_from_slice(numbers);
        let [shift, normal, force] = parts;
        let state = Self { shift, normal, force };
        state.check()?;
        Ok(state)
    }

    /// Checks a state whose bytes may have been changed elsewhere.
    ///
    /// # Errors
    /// [`RangeError`] of `roll`, whose value is the sum of the numbers.
    #[inline]
    pub fn check(&self) -> Result<(), RangeError> {
        let square = dot(self.normal, self.normal);
        let numbers = self.shift.iter().chain(&self.force);
        let size = numbers.fold(0.0, |sum: f64, number| sum + number.abs());
        let holds = size.is_finite() && is_unit_or_zero(square);
        RangeError::check("roll", size, holds, "of finite numbers and a normal of length 0 or 1")?;
        Ok(())
    }
}

/// The resistance of a contact to rolling.
#[derive(Debug)]
pub struct Rolling<'a> {
    /// Its constants.
    pub resistance: &'a RollingResistance,
    /// R, 1/R = 1/R_1 + 1/R_2.
    pub relative_radius: f64,
    /// Its state.
    pub roll: &'a mut GrainRoll,
}

impl Rolling<'_> {
    /// Advances by a step of duration `dt`, at the end of which the bodies are as given and pressed together by
    /// `normal_force`, and returns the torque on body 1, N m. The step of s is that of the implicit Euler method.
    /// Bodies that are apart lose the history; a step of duration zero changes nothing else. What becomes heat is added
    /// to `heats` if they are given: of the dashpot, of the slider, and of the spring where the bodies part.
    ///
    /// # Errors
    /// [`RangeError`] if way, displacement, force or radius are no numbers or above 1e100; the state is then unchanged.
    pub fn advance(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        normal_force: f64,
        heats: Option<&mut Heats>,
    ) -> Result<[f64; 3], RangeError> {
        let trial = self.trial(meeting, dt)?;
        Ok(self.end(&trial, normal_force, heats))
    }

    /// The step without the slider, before the normal force is known; what it says is all that can fail.
    pub(super) fn trial(&self, meeting: &Meeting, dt: f64) -> Result<RollTrial, RangeError> {
        let (Self { resistance, roll, .. }, normal) = (self, meeting.normal);
        if dt == 0.0 && !meeting.is_apart() {
            return Ok(RollTrial { end: End::Stays, normal, ..RollTrial::default() });
        }
        let from = if roll.normal == [0.0; 3] { normal } else { roll.normal };
        let middle = unit(plus(from, normal));
        let turn = Turn { from, normal, angle: dot(meeting.turning(), middle) * dt };
        let shift = turn.of(roll.shift);
        let rate = cross(meeting.twisting(), middle);
        let way = times(carried(rate, middle, normal), -self.relative_radius * dt);
        let is_apart = meeting.is_apart();
        let by_dashpot = if is_apart { 0.0 } else { resistance.damping / dt };
        let stuck = sum(times(plus(shift, way), -resistance.stiffness), -by_dashpot, way);
        let end = if is_apart { End::Apart } else { End::Rolls };
        for v in [shift, way, roll.force, stuck, times(shift, resistance.stiffness)] {
            checked(dot(v, v))?;
        }
        checked(self.relative_radius * self.relative_radius)?;
        Ok(RollTrial { end, normal, turn, shift, way, stuck, by_dashpot })
    }

    /// The end of a step, whose trial has not failed: the torque on body 1, and what becomes heat.
    fn end(&mut self, trial: &RollTrial, normal_force: f64, heats: Option<&mut Heats>) -> [f64; 3] {
        let (before, resistance) = (self.roll.force, self.resistance);
        match trial.end {
            End::Stays => {}
            End::Apart => *self.roll = GrainRoll::default(),
            End::Rolls => *self.roll = trial.slipped(resistance, normal_force.max(0.0)),
        }
        if let (Some(heats), End::Apart | End::Rolls) = (heats, trial.end) {
            let forces = plus(trial.turn.of(before), self.roll.force);
            let [stored, rest] = [trial.shift, self.roll.shift].map(|s| resistance.energy(s));
            heats.rolling += -0.5 * dot(forces, trial.way) + stored - rest;
        }
        times(cross(trial.normal, self.roll.force), self.relative_radius)
    }

    /// Adds the torque to the load that presses the bodies, after a trial.
    pub(super) fn press(
        &mut self,
        meeting: &Meeting,
        trial: &RollTrial,
        load: &mut GrainLoad,
        heats: Option<&mut Heats>,
    ) {
        let pressed = dot(load.force, meeting.normal);
        load.couple(meeting, self.end(trial, pressed, heats));
    }
}

/// How the axes of a contact turn in a step.
#[derive(Debug, Clone, Copy, Default)]
struct Turn {
    from: Vector,
    normal: Vector,
    angle: f64,
}

impl Turn {
    fn of(&self, vector: Vector) -> Vector {
        turned(carried(vector, self.from, self.normal), self.normal, self.angle)
    }
}

/// How a step ends.
#[derive(Debug, Clone, Copy, Default)]
enum End {
    /// It takes no time.
    #[default]
    Stays,
    /// The bodies part.
    Apart,
    Rolls,
}

/// A step of a resistance to rolling before the normal force is known ([`Rolling::trial`]).
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct RollTrial {
    end: End,
    normal: Vector,
    turn: Turn,
    /// The shift of before, in the axes of the end of the step.
    shift: Vector,
    /// By how much the bodies roll.
    way: Vector,
    /// The force without slip.
    stuck: Vector,
    /// The force of the dashpot over the way.
    by_dashpot: f64,
}

impl RollTrial {
    /// The state at the end, whose force is at most that of the slider.
    fn slipped(&self, resistance: &RollingResistance, normal_force: f64) -> GrainRoll {
        let (normal, force) = (self.normal, self.stuck);
        let (size, limit) = (dot(force, force).sqrt(), resistance.friction * normal_force);
        if size <= limit {
            return GrainRoll { shift: plus(self.shift, self.way), normal, force };
        }
        let force = times(force, limit / size);
        let by = 1.0 / (resistance.stiffness + self.by_dashpot);
        let shift = sum(times(force, -by), by * self.by_dashpot, self.shift);
        GrainRoll { shift, normal, force }
    }
}

/// Sizes up to this leave heat and torque finite.
const LARGEST: f64 = 1e100;

/// Checks a size by its square.
fn checked(square: f64) -> Result<(), RangeError> {
    if square <= LARGEST * LARGEST {
        return Ok(());
    }
    let size = square.sqrt();
    RangeError::check("rolling resistance", size, false, "at most 1e100").map(|_| ())
}

/// A vector across `from`, carried to `to` by the smallest rotation.
fn carried(vector: Vector, from: Vector, to: Vector) -> Vector {
    let lean = 1.0 + dot(from, to);
    if lean < 1e-9 {
        return [0.0; 3];
    }
    sum(vector, -dot(vector, to) / lean, plus(from, to))
}

/// A vector across the normal, rotated about it, to second order in the angle and without a change of length.
fn turned(vector: Vector, normal: Vector, angle: f64) -> Vector {
    let tangent = 0.5 * angle;
    let by = 1.0 / (1.0 + tangent * tangent);
    let along = times(vector, (1.0 - tangent * tangent) * by);
    sum(along, 2.0 * tangent * by, cross(normal, vector))
}

fn unit(vector: Vector) -> Vector {
    let length = dot(vector, vector).sqrt();
    if length > 0.0 { times(vector, 1.0 / length) } else { vector }
}

/// a + by b.
fn sum(a: Vector, by: f64, b: Vector) -> Vector {
    plus(a, times(b, by))
}
