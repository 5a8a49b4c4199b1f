//! The resistance of two grains, or of a grain and a wall, to rolling on each other.

use carom_laws::grains::{Grain, Meeting, Surface};
use carom_special::RangeError;

use crate::error::{CaromError, CaromStatus, Failure, border};
use crate::grains::{Bodies, CaromGrainLoad, CaromGrains, relative_radius};
use crate::pointers::{read, write, write_or_null};
use crate::touch_twist::add;

/// Number of numbers in a `carom_roll`.
pub const CAROM_ROLL_NUMBERS: usize = 9;

const _: () = assert!(size_of::<CaromRoll>() == 8 * CAROM_ROLL_NUMBERS);

/// The constants of a rolling resistance: a spring and a dashpot side by side, in series with a slider. The force
/// of spring and dashpot acts on no body; times the relative radius it is a torque.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct CaromRolling {
    /// The spring: force over the displacement of rolling, N/m.
    pub stiffness: f64,
    /// The dashpot: force over the velocity of rolling, N s/m.
    pub damping: f64,
    /// The slider: the greatest force over the normal force.
    pub friction: f64,
}

/// The state of a rolling resistance, as 9 numbers in memory of the caller, in any build; zeros stand for two
/// separated grains.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct CaromRoll {
    /// The displacement of the spring, m.
    pub shift: [f64; 3],
    /// The normal of the last step; zero for separated grains.
    pub normal: [f64; 3],
    /// The force of the last step, N.
    pub force: [f64; 3],
}

/// One step of the rolling resistance of two grains, for use after `carom_touch_grains` in the same step: the
/// normal force is that of `load`, to whose torques it adds its own. The heat is added to `heat`, which may be
/// null.
///
/// With the relative radius R (1/R = 1/radius_1 + 1/radius_2) and the normal n from body 2 into body 1 the grains
/// roll with the velocity v = R (spin_1 - spin_2) x n. Spring and dashpot exert the force F = - stiffness s -
/// damping ds/dt, up to friction times the normal force, beyond which they slip: ds/dt = v without slip. The
/// torque on body 1 is R n x F, that on body 2 the opposite. The step of s is that of the implicit Euler method.
///
/// A step of duration zero returns the torque after the last step. Where the grains separate, the history is lost,
/// and the energy of the spring becomes heat.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_roll_grains(
    grains: *const CaromGrains,
    rolling: *const CaromRolling,
    roll: *mut CaromRoll,
    one: *const Grain,
    two: *const Grain,
    dt: f64,
    load: *mut CaromGrainLoad,
    heat: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let bodies = [read(one, "one")?, read(two, "two")?];
        let (rolling, heat) = (read(rolling, "rolling")?, write_or_null(heat, "heat")?);
        let (grains, load) = (read(grains, "grains")?, write(load, "load")?);
        let torque = write(roll, "roll")?.advance(grains, rolling, bodies, dt, load, heat)?;
        add(&mut load.torque_1, torque, 1.0);
        add(&mut load.torque_2, torque, -1.0);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// One step of the rolling resistance of a grain, body 1, and a wall of any shape, whose torque is zero, as
/// `carom_touch_roll_grains`. The relative radius is the radius of the grain.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_roll_surface(
    grains: *const CaromGrains,
    rolling: *const CaromRolling,
    roll: *mut CaromRoll,
    one: *const Grain,
    surface: *const Surface,
    dt: f64,
    load: *mut CaromGrainLoad,
    heat: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let bodies = (read(one, "one")?, read(surface, "surface")?);
        let (rolling, heat) = (read(rolling, "rolling")?, write_or_null(heat, "heat")?);
        let (grains, load) = (read(grains, "grains")?, write(load, "load")?);
        let torque = write(roll, "roll")?.advance(grains, rolling, bodies, dt, load, heat)?;
        add(&mut load.torque_1, torque, 1.0);
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

/// The elastic energy of a rolling resistance, J.
///
/// # Safety
/// Pointers and memories are as [the crate](crate#pointers) asks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_touch_roll_energy(
    rolling: *const CaromRolling,
    roll: *const CaromRoll,
    energy: *mut f64,
    error: *mut CaromError,
) -> CaromStatus {
    // SAFETY: the caller's promise.
    let call = || unsafe {
        let (rolling, roll) = (read(rolling, "rolling")?, read(roll, "roll")?);
        rolling.check()?;
        roll.check()?;
        *write(energy, "energy")? = RangeError::finite("energy", rolling.energy(roll.shift))?;
        Ok(())
    };
    // SAFETY: the caller's promise.
    unsafe { border(error, call) }
}

type Vector = [f64; 3];

impl CaromRolling {
    fn check(&self) -> Result<(), RangeError> {
        RangeError::non_negative("stiffness", self.stiffness)?;
        RangeError::non_negative("damping", self.damping)?;
        RangeError::non_negative("friction", self.friction).map(|_| ())
    }

    fn energy(&self, shift: Vector) -> f64 {
        0.5 * self.stiffness * dot(shift, shift)
    }

    /// Shift and force at the end of a step, of which the grains roll by `way`.
    fn step(&self, shift: Vector, way: Vector, dt: f64, normal_force: f64) -> (Vector, Vector) {
        let by_dashpot = self.damping / dt;
        let stuck = sum(shift, 1.0, way);
        let force = sum(times(stuck, -self.stiffness), -by_dashpot, way);
        let (size, limit) = (dot(force, force).sqrt(), self.friction * normal_force);
        if size <= limit {
            return (stuck, force);
        }
        let force = times(force, limit / size);
        let by = 1.0 / (self.stiffness + by_dashpot);
        (sum(times(force, -by), by * by_dashpot, shift), force)
    }
}

impl CaromRoll {
    fn check(&self) -> Result<(), Failure> {
        let square = dot(self.normal, self.normal);
        let numbers = self.shift.iter().chain(&self.force);
        let size = numbers.fold(0.0, |sum: f64, number| sum + number.abs());
        if size.is_finite() && (square == 0.0 || (square - 1.0).abs() < 1e-9) {
            return Ok(());
        }
        let text = "the numbers of a rolling resistance are damaged, in the restart file or since";
        Err(Failure::new(CaromStatus::BadState, "roll", text))
    }

    /// Advances the state and returns the torque on body 1.
    fn advance(
        &mut self,
        grains: &CaromGrains,
        rolling: &CaromRolling,
        bodies: impl Bodies,
        dt: f64,
        load: &CaromGrainLoad,
        heat: Option<&mut f64>,
    ) -> Result<Vector, Failure> {
        rolling.check()?;
        self.check()?;
        let [one, two] = bodies.radii();
        let (meeting, radius) =
            (bodies.meeting(bodies.apart()?, grains), relative_radius(one, two)?);
        let (mut next, mut made) = (*self, 0.0);
        if dt > 0.0 || meeting.is_apart() {
            let normal_force = dot(load.force, meeting.normal).max(0.0);
            made = next.turn(rolling, &meeting, radius, dt, normal_force);
        }
        let torque = times(cross(meeting.normal, next.force), radius);
        for part in [next.shift, next.force, torque].into_iter().flatten() {
            RangeError::finite("rolling resistance", part)?;
        }
        RangeError::finite("heat", made)?;
        *self = next;
        if let Some(heat) = heat {
            *heat += made;
        }
        Ok(torque)
    }

    /// The step of the state, with its heat.
    fn turn(
        &mut self,
        rolling: &CaromRolling,
        meeting: &Meeting,
        radius: f64,
        dt: f64,
        normal_force: f64,
    ) -> f64 {
        let normal = meeting.normal;
        let from = if self.normal == [0.0; 3] { normal } else { self.normal };
        let middle = unit(sum(from, 1.0, normal));
        let angle = dot(meeting.turning(), middle) * dt;
        let [shift, force] =
            [self.shift, self.force].map(|v| turned(carried(v, from, normal), normal, angle));
        let rate = cross(meeting.twisting(), middle);
        let way = times(carried(rate, middle, normal), -radius * dt);
        let before = rolling.energy(shift);
        *self = Self::default();
        if meeting.zeta > 0.0 {
            let (shift, force) = rolling.step(shift, way, dt, normal_force);
            *self = Self { shift, normal, force };
        }
        let work = -0.5 * dot(sum(force, 1.0, self.force), way);
        work + before - rolling.energy(self.shift)
    }
}

/// A vector across `from`, carried to `to` by the smallest rotation.
fn carried(vector: Vector, from: Vector, to: Vector) -> Vector {
    let lean = 1.0 + dot(from, to);
    if lean < 1e-9 {
        return [0.0; 3];
    }
    sum(vector, -dot(vector, to) / lean, sum(from, 1.0, to))
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

fn dot([a, b, c]: Vector, [x, y, z]: Vector) -> f64 {
    a * x + b * y + c * z
}

fn cross([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn times(vector: Vector, by: f64) -> Vector {
    vector.map(|x| x * by)
}

/// a + by b.
fn sum([a, b, c]: Vector, by: f64, [x, y, z]: Vector) -> Vector {
    [a + by * x, b + by * y, c + by * z]
}
