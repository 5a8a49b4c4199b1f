//! The nodes of the table of creep forces, and the symmetries that leave a quarter of all directions.

use crate::creep::CreepCoefficients;
use std::f64::consts::{FRAC_PI_2, PI};

/// Numbers of nodes: axis ratio, angle from the spin, angle between both creepages, size, Poisson's ratio.
pub const COUNTS: [usize; 5] = [13, 25, 17, 25, 4];
/// Numbers of stored coefficients: a spline that is not periodic has two more than nodes.
pub const STORED: [usize; 5] = [COUNTS[0] + 2, COUNTS[1], COUNTS[2], COUNTS[3] + 2, COUNTS[4]];

/// Place of an axis ratio from 0.1 to 10 among its nodes.
#[must_use]
pub fn place_of_ratio(ratio: f64) -> f64 {
    0.5 * (libm::log10(ratio) + 1.0) * (COUNTS[0] - 1) as f64
}

/// The axis ratio of a node.
#[must_use]
pub fn ratio(node: usize) -> f64 {
    libm::pow(10.0, 2.0 * node as f64 / (COUNTS[0] - 1) as f64 - 1.0)
}

/// Place of a Poisson's ratio from 0 to 0.5 among its nodes.
#[must_use]
pub fn place_of_poisson(poisson: f64) -> f64 {
    2.0 * poisson * (COUNTS[4] - 1) as f64
}

/// Poisson's ratio of a node.
#[must_use]
pub fn poisson(node: usize) -> f64 {
    0.5 * node as f64 / (COUNTS[4] - 1) as f64
}

/// Stiffnesses by which creepages are scaled: x = k_x G ab xi/(f F_z), y = k_y G ab eta/(f F_z),
/// phi = k_phi G (ab)^1.5 spin/(f F_z).
///
/// k_x and k_y are C11 and C22. k_phi weighs the force and the torque of a spin such that the centre of rotation
/// leaves the contact in the middle of the table at each axis ratio.
#[must_use]
pub fn scales(coefficients: &CreepCoefficients, ratio: f64) -> [f64; 3] {
    let CreepCoefficients { c11, c22, c23, c33, .. } = *coefficients;
    // ab/((a^2 + b^2)/2)
    let slender = 2.0 / (ratio + 1.0 / ratio);
    [c11, c22, libm::hypot(3.0 * c23, 2.0 * c33 * libm::sqrt(slender))]
}

/// By how much y counts more than x in the angle between both creepages: a slender contact bends where one is small.
fn stretch(ratio: f64) -> f64 {
    libm::pow(ratio, -0.2)
}

/// The scaled creepage at which half of the sizes are used; the contact starts to slide as a whole about there.
const HALF: f64 = 3.0;

/// A scaled creepage (x, y, phi), x and phi >= 0, as places among the nodes of the angle from the spin, from 0 to pi/2,
/// of that between both creepages, from -pi/2 to pi/2, and of the size.
#[must_use]
pub fn places(ratio: f64, [x, y, phi]: [f64; 3]) -> [f64; 3] {
    let pulled = libm::hypot(x, y);
    let r = libm::hypot(pulled, phi);
    let theta = libm::atan2(pulled, phi) / FRAC_PI_2 * (COUNTS[1] - 1) as f64;
    let psi = if pulled > 0.0 { libm::atan2(stretch(ratio) * y, x) / PI + 0.5 } else { 0.5 };
    [theta, psi * (COUNTS[2] - 1) as f64, r / (HALF + r) * (COUNTS[3] - 1) as f64]
}

/// The direction of a node at an axis ratio: x, y and phi of length 1.
#[must_use]
pub fn direction(ratio: f64, [theta, psi]: [usize; 2]) -> [f64; 3] {
    let (sin, cos) = libm::sincos(FRAC_PI_2 * theta as f64 / (COUNTS[1] - 1) as f64);
    let (y, x) = libm::sincos(PI * (psi as f64 / (COUNTS[2] - 1) as f64 - 0.5));
    let y = y / stretch(ratio);
    let length = libm::hypot(x, y);
    // Exact where a component vanishes.
    let clean = |part: f64| if part.abs() < 1e-15 { 0.0 } else { part };
    [sin * clean(x / length), sin * clean(y / length), clean(cos)]
}

/// The size of a node; infinite at the last one.
#[must_use]
pub fn size(node: usize) -> f64 {
    let part = node as f64 / (COUNTS[3] - 1) as f64;
    HALF * part / (1.0 - part)
}

/// The forces of a node are stored over r/(1 + r) of its size, which is finite at both ends.
#[must_use]
pub fn weight(r: f64) -> f64 {
    if r.is_finite() { r / (1.0 + r) } else { 1.0 }
}

/// The signs of the forces of (-x, y, phi) beside those of (x, y, phi): half a turn about the direction across, with
/// both creepages and the spin reversed.
pub const TURNED: [f64; 3] = [-1.0, 1.0, 1.0];
/// Those of (x, -y, -phi): a mirror.
pub const MIRRORED: [f64; 3] = [1.0, -1.0, -1.0];

/// The node that stands for one beyond the ends of both angles, and the signs of its forces.
#[must_use]
pub fn reflected(mut theta: isize, mut psi: isize) -> ([usize; 2], [f64; 3]) {
    let [last_theta, last_psi] = [COUNTS[1] as isize - 1, COUNTS[2] as isize - 1];
    let mut signs = [1.0; 3];
    let mut change = |by: [f64; 3]| (0..3).for_each(|i| signs[i] *= by[i]);
    theta = theta.rem_euclid(4 * last_theta);
    if theta >= 2 * last_theta {
        // Over the pole both creepages change their signs.
        theta = 4 * last_theta - theta;
        psi += last_psi;
    }
    if theta > last_theta {
        // The spin changes its sign: the mirror, which turns y round.
        theta = 2 * last_theta - theta;
        psi = last_psi - psi;
        change(MIRRORED);
    }
    psi = psi.rem_euclid(2 * last_psi);
    if psi > last_psi {
        psi = 2 * last_psi - psi;
        change(TURNED);
    }
    ([theta as usize, psi as usize], signs)
}

/// The unit of stored coefficients, all of which are below 2: its half is the error of storing one.
const UNIT: f64 = 2.0 / 32768.0;

/// A coefficient as it is stored; none from 2 on.
#[must_use]
pub fn stored(coefficient: f64) -> Option<[u8; 2]> {
    let units = libm::round(coefficient / UNIT);
    (units.abs() < 32768.0).then(|| (units as i16).to_le_bytes())
}

/// A coefficient from its two bytes.
pub(super) fn coefficient([low, high]: [u8; 2]) -> f64 {
    UNIT * f64::from(i16::from_le_bytes([low, high]))
}
