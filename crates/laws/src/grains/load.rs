//! The load of two grains in contact.

use carom_special::RangeError;

use super::meeting::Meeting;
use super::number::Number;
use super::vector::{Vector, cross, minus, plus, times};

/// The load that body 2 exerts on body 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct GrainLoad {
    /// The force on body 1, N; the force on body 2 is the opposite.
    pub force: [f64; 3],
    /// The torque on each body about its centre, `-arm normal x force`, N m; zero for a wall.
    pub torques: [[f64; 3]; 2],
}

impl GrainLoad {
    /// Adds a torque on body 1; body 2 gets the opposite unless it is a wall, which has no arm.
    #[inline]
    pub(super) fn couple(&mut self, meeting: &Meeting, torque: Vector) {
        let [one, two] = &mut self.torques;
        let has_torque = meeting.arms[1] != 0.0;
        for k in 0..3 {
            one[k] += torque[k];
            if has_torque {
                two[k] -= torque[k];
            }
        }
    }
}

/// Hertz's force (5.27).
#[inline(always)]
pub(super) fn elastic<T: Number>(c_z: T, zeta: T) -> T {
    let zeta = zeta.larger(T::of(0.0));
    T::of(2.0 / 3.0) * c_z * (zeta * zeta.sqrt())
}

/// The energy of compression, the work of Hertz's force.
pub(super) fn compressed(c_z: f64, zeta: f64) -> f64 {
    0.4 * zeta.max(0.0) * elastic(c_z, zeta)
}

/// The force on body 1 and the torques on both bodies, in the axes of tangent and normal.
#[inline(always)]
pub(super) fn forces<T: Number>(
    [tangent, normal]: [Vector<T>; 2],
    arms: [T; 2],
    normal_force: T,
    [x, y]: [T; 2],
) -> [Vector<T>; 3] {
    let along = cross(normal, tangent);
    let friction = plus(times(tangent, x), times(along, y));
    // normal x tangent is the second axis, normal x second axis is minus the tangent; the torque on
    // body 1 is - arm normal x force.
    let couple = minus(times(tangent, y), times(along, x));
    let force = plus(times(normal, normal_force), friction);
    [force, times(couple, arms[0]), times(couple, arms[1])]
}

#[inline]
pub(super) fn load_in(
    axes: [Vector; 2],
    arms: [f64; 2],
    normal_force: f64,
    friction: [f64; 2],
) -> GrainLoad {
    let [force, torque_1, torque_2] = forces(axes, arms, normal_force, friction);
    GrainLoad { force, torques: [torque_1, torque_2] }
}

/// The largest arm of a force whose torque cannot overflow.
pub(super) const LARGEST_ARM: f64 = 1e60;
/// The largest damping force whose torque and heat cannot overflow.
pub(super) const LARGEST_DRAG: f64 = 1e150;

/// Checks what else than the law decides on the load of a step, before the law is advanced.
#[inline(always)]
pub(super) fn check_beside(arms: [f64; 2], drag: f64) -> Result<(), RangeError> {
    let [one, two] = arms;
    let holds = (one.abs() <= LARGEST_ARM) & (two.abs() <= LARGEST_ARM);
    if holds & (drag.abs() <= LARGEST_DRAG) { Ok(()) } else { name_the_wrong_one(arms, drag) }
}

#[cold]
fn name_the_wrong_one(arms: [f64; 2], drag: f64) -> Result<(), RangeError> {
    for arm in arms {
        RangeError::check("arm", arm, arm.abs() <= LARGEST_ARM, "at most 1e60 in magnitude")?;
    }
    let holds = drag.abs() <= LARGEST_DRAG;
    RangeError::check("damping force", drag, holds, "at most 1e150").map(|_| ())
}
