//! The slip rule of one annulus of sliders on a straight step: it sticks up to its limit, then
//! slips in the direction of its traction in the physical plane.

use super::turning::{Pull, inverse_mean, onset, turned};
use crate::coulomb::Step;
use crate::memory::Lateral;
use crate::stiffness::ContactStiffness;

/// A straight step in normalised shifts, `X = C x/(f c_z)`, from one approach to another.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlipStep {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) by: [f64; 2],
    /// c_x and c_y.
    pub(super) stiffness: [f64; 2],
    /// Angle to which the directions of tractions are required, times the square of their limit.
    pub(super) accuracy: f64,
    /// Angle to which directions are computed in any case.
    pub(super) finest: f64,
}

impl SlipStep {
    /// The stretch X - W at the end of the step, for the annulus of a depth that reaches its limit,
    /// from the stretch at the beginning.
    pub(super) fn drag(&self, stretch: [f64; 2], depth: f64) -> [f64; 2] {
        let (start, bound) = (self.from - depth, self.to - depth);
        if bound <= 0.0 {
            return [0.0; 2];
        }
        if start <= 0.0 {
            return self.touched(bound);
        }
        if self.stiffness[0] == self.stiffness[1] {
            let step = Step::new((self.from, [0.0; 2]), (self.to, self.by));
            return self.by.minus(step.drag(depth, stretch.times(-1.0)));
        }
        let growth = self.to - self.from;
        let onset = onset(stretch, self.by, start, growth);
        let at = [stretch[0] + onset * self.by[0], stretch[1] + onset * self.by[1]];
        let norm = (at[0] * at[0] + at[1] * at[1]).sqrt();
        if norm <= 0.0 {
            return self.touched(bound);
        }
        let length = (1.0 - onset) * inverse_mean(start + onset * growth, bound);
        let at = [at[0] / norm, at[1] / norm];
        let pull = Pull { stiffness: self.stiffness, by: self.by, growth };
        let accurate = (self.accuracy / (bound * bound)).clamp(self.finest, 1e-2);
        let [cos, sin] = turned(at, length, &pull, accurate);
        [bound * cos, bound * sin]
    }

    // From zero traction on a straight path the direction is constant (8.58): with the slip l along
    // e, X - l C e = L e, so that e is parallel to (L + l C)^-1 X.
    fn touched(&self, bound: f64) -> [f64; 2] {
        let [x, y] = self.by;
        let [c_x, c_y] = self.stiffness;
        let mut slip = 0.0;
        // 1/|e| is concave and increasing in l: Newton's iteration rises to the root.
        for _ in 0..40 {
            let (d_x, d_y) = (bound + c_x * slip, bound + c_y * slip);
            let (e_x, e_y) = (x / d_x, y / d_y);
            let square = e_x * e_x + e_y * e_y;
            let rate = e_x * e_x * c_x / d_x + e_y * e_y * c_y / d_y;
            let change = (square.sqrt() - 1.0) * square / rate;
            slip += change;
            if change.abs() * c_x.max(c_y) <= 1e-15 * (slip * c_x.min(c_y) + bound) {
                break;
            }
        }
        let (e_x, e_y) = (x / (bound + c_x * slip), y / (bound + c_y * slip));
        let norm = libm::hypot(e_x, e_y);
        [bound * e_x / norm, bound * e_y / norm]
    }
}

/// The direction of the traction on body 1 at the beginning of an impact with sliding: the root of
/// `y' cos - x' sin + f z' sin cos (c_z/c_x - c_z/c_y) = 0` (8.58), corrected, with the velocity
/// (x', y', z') of body 2 relative to body 1 at first contact. `None` if the impact begins with
/// adhesion (8.50).
///
/// ```
/// use carom_laws::sliders::sliding_direction;
/// use carom_laws::stiffness::ContactStiffness;
/// let stiffness = ContactStiffness::new(0.9, 0.7, 1.0)?;
/// let [cos, sin] = sliding_direction(&stiffness, 0.3, [0.8, 0.5, 1.0]).expect("slides");
/// let residue = 0.5 * cos - 0.8 * sin + 0.3 * sin * cos * (1.0 / 0.9 - 1.0 / 0.7);
/// assert!(residue.abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[must_use]
pub fn sliding_direction(
    stiffness: &ContactStiffness,
    friction: f64,
    velocity: [f64; 3],
) -> Option<[f64; 2]> {
    let ContactStiffness { c_x, c_y, c_z } = *stiffness;
    let ([x, y, z], limit) = (velocity, friction * c_z);
    let (pull, bound) = ([c_x * x, c_y * y], limit * z);
    if bound.is_nan() || bound <= 0.0 || libm::hypot(pull[0], pull[1]) <= bound {
        return None;
    }
    let by = pull.map(|pull| pull / bound);
    let step =
        SlipStep { from: 0.0, to: 1.0, by, stiffness: [c_x, c_y], accuracy: 0.0, finest: 0.0 };
    Some(step.touched(1.0))
}
