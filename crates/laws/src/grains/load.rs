//! The load of two grains in contact.

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

/// Hertz's force (5.27).
#[inline(always)]
pub(super) fn elastic<T: Number>(c_z: T, zeta: T) -> T {
    let zeta = zeta.larger(T::of(0.0));
    T::of(2.0 / 3.0) * c_z * (zeta * zeta.sqrt())
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
    let [torque_1, torque_2] = arms.map(|arm| times(couple, arm));
    [plus(times(normal, normal_force), friction), torque_1, torque_2]
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
