//! Partial slip under a single tangential load, by Cattaneo and Mindlin (5.22)-(5.30).
//!
//! The normal load is applied first, then a shift (or force) in one direction. The memory laws
//! extend it to load histories.

use carom_special::RangeError;

use crate::ellipse::ContactEllipse;
use crate::friction::Friction;
use crate::stiffness::ContactStiffness;

/// Why a shift could not be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ShiftError {
    /// An argument is out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The tangential force exceeds f F_z: there is no equilibrium.
    #[error("the tangential force {force} exceeds the friction limit f F_z = {limit}")]
    BeyondFriction {
        /// The magnitude T of the given force.
        force: f64,
        /// The limit f F_z.
        limit: f64,
    },
}

/// The law of Cattaneo and Mindlin for an elliptical contact.
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_laws::shift::CattaneoMindlin;
/// use carom_laws::stiffness::ContactStiffness;
/// let stiffness = ContactStiffness::new(0.9, 0.8, 1.0)?;
/// let law = CattaneoMindlin::new(stiffness, Friction::new(0.5)?);
/// let state = law.at_shift(1.0, 0.2, 0.1)?;
/// let back = law.at_force(1.0, state.force[0], state.force[1])?;
/// assert!((back.shift[0] - 0.2).abs() < 1e-15 && (back.shift[1] - 0.1).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CattaneoMindlin {
    stiffness: ContactStiffness,
    friction: Friction,
}

/// A contact under a single tangential load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShiftState {
    /// The rigid shift (xi, eta). In complete sliding the force does not determine it: it is then
    /// the given shift, or the shift at the onset of sliding ([`CattaneoMindlin::at_force`]).
    pub shift: [f64; 2],
    /// The tangential force (F_x, F_y) on body 1.
    pub force: [f64; 2],
    /// The normal force F_z.
    pub normal_force: f64,
    /// The direction (p, q) of the traction (5.26); (0, 0) without load.
    pub direction: [f64; 2],
    /// `1 - zeta*/zeta`, accurate for small loads; 1 without a stick area.
    pub slip_depth: f64,
    /// The friction coefficient.
    friction: Friction,
    /// `f (1 - zeta*/zeta)`, which is finite also for infinite friction.
    drive: f64,
}

impl ShiftState {
    /// `zeta*/zeta = (a*/a)^2 = (b*/b)^2` (5.26), from 1 (adhesion) to 0 (sliding).
    #[must_use]
    pub fn stick_depth(&self) -> f64 {
        1.0 - self.slip_depth
    }

    /// `a*/a = b*/b`, the relative size of the stick area.
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        self.stick_depth().sqrt()
    }

    /// Whether the whole contact slides.
    #[must_use]
    pub fn is_sliding(&self) -> bool {
        self.slip_depth >= 1.0
    }

    /// The traction (sigma_zx, sigma_zy) on body 1 at a point of the contact `ellipse` (5.23).
    ///
    /// Without slip (infinite friction) it is infinite on the edge.
    #[must_use]
    pub fn traction(&self, ellipse: &ContactEllipse, x: f64, y: f64) -> [f64; 2] {
        let q = ellipse.radius_squared(x, y);
        let peak = 1.5 * self.normal_force / ellipse.area();
        let size = peak * self.relative_traction(q);
        self.direction.map(|p| p * size)
    }

    /// Traction divided by `sigma_z0`: `f [sqrt(1 - q) - sqrt(zeta*/zeta - q)]`, written without
    /// cancellation.
    fn relative_traction(&self, q: f64) -> f64 {
        if q > 1.0 {
            return 0.0;
        }
        let outer = (1.0 - q).sqrt();
        let inner = self.stick_depth() - q;
        match self.friction.coefficient() {
            Some(f) if inner <= 0.0 => f * outer,
            _ => self.drive / (outer + inner.max(0.0).sqrt()),
        }
    }
}

impl CattaneoMindlin {
    /// From stiffness coefficients and friction.
    #[must_use]
    pub const fn new(stiffness: ContactStiffness, friction: Friction) -> Self {
        Self { stiffness, friction }
    }

    /// The state under a rigid shift (5.26), (5.27), at a positive approach.
    ///
    /// # Errors
    /// [`RangeError`] for an approach that is not positive or a shift that is not finite.
    pub fn at_shift(&self, approach: f64, xi: f64, eta: f64) -> Result<ShiftState, RangeError> {
        RangeError::positive("approach", approach)?;
        RangeError::finite("xi", xi)?;
        RangeError::finite("eta", eta)?;
        let ContactStiffness { c_x, c_y, c_z } = self.stiffness;
        let (size, direction) = polar(c_x * xi, c_y * eta);
        let drive = size / (c_z * approach);
        let (slip_depth, drive) = match self.friction.coefficient() {
            _ if size == 0.0 => (0.0, 0.0),
            None => (0.0, drive),
            Some(f) if drive >= f => (1.0, f),
            Some(f) => (drive / f, drive),
        };
        Ok(self.state(approach, [xi, eta], direction, slip_depth, drive))
    }

    /// The state under a tangential force (5.28), (5.29), at a positive approach.
    ///
    /// # Errors
    /// [`ShiftError::BeyondFriction`] for a force above f F_z; [`ShiftError::Range`] for an
    /// approach that is not positive or a force that is not finite.
    pub fn at_force(
        &self,
        approach: f64,
        force_x: f64,
        force_y: f64,
    ) -> Result<ShiftState, ShiftError> {
        RangeError::positive("approach", approach)?;
        RangeError::finite("force_x", force_x)?;
        RangeError::finite("force_y", force_y)?;
        let ContactStiffness { c_x, c_y, c_z } = self.stiffness;
        let normal_force = self.normal_force(approach);
        let (force, direction) = polar(force_x, force_y);
        let (slip_depth, drive) = match self.friction.coefficient() {
            _ if force == 0.0 => (0.0, 0.0),
            None => (0.0, force / (1.5 * normal_force)),
            Some(f) => {
                let limit = f * normal_force;
                if force > limit {
                    return Err(ShiftError::BeyondFriction { force, limit });
                }
                // 1 - (1 - T/(f F_z))^(2/3)
                let x = -libm::expm1(2.0 / 3.0 * libm::log1p(-force / limit));
                (x, f * x)
            }
        };
        let size = drive * c_z * approach;
        let shift = [direction[0] * size / c_x, direction[1] * size / c_y];
        let state = self.state(approach, shift, direction, slip_depth, drive);
        Ok(ShiftState { force: [force_x, force_y], ..state })
    }

    fn normal_force(&self, approach: f64) -> f64 {
        2.0 / 3.0 * self.stiffness.c_z * (approach * approach.sqrt())
    }

    fn state(
        &self,
        approach: f64,
        shift: [f64; 2],
        direction: [f64; 2],
        slip_depth: f64,
        drive: f64,
    ) -> ShiftState {
        let normal_force = self.normal_force(approach);
        let force = normal_force * drive * growth(slip_depth);
        ShiftState {
            shift,
            force: direction.map(|p| p * force),
            normal_force,
            direction,
            slip_depth,
            friction: self.friction,
            drive,
        }
    }
}

/// `(1 - (1 - x)^(3/2))/x` for 0 <= x <= 1: 3/2 at no slip, 1 at sliding.
fn growth(x: f64) -> f64 {
    // With r = sqrt(1 - x): (1 - r^3)/(1 - r^2) = (1 + r + r^2)/(1 + r).
    let r = (1.0 - x).sqrt();
    1.0 + r * r / (1.0 + r)
}

fn polar(x: f64, y: f64) -> (f64, [f64; 2]) {
    let size = libm::hypot(x, y);
    if size == 0.0 { (0.0, [0.0, 0.0]) } else { (size, [x / size, y / size]) }
}

/// The tangential stiffness of a contact in a frame rotated by `angle` (radians) from the axes of
/// the ellipse: a second-order tensor (proposition 1), in force/length^(3/2).
///
/// Rows are forces and columns shifts in the rotated frame; multiply by sqrt(zeta).
#[must_use]
pub fn turned_stiffness(stiffness: &ContactStiffness, angle: f64) -> [[f64; 2]; 2] {
    let (s, c) = libm::sincos(angle);
    let ContactStiffness { c_x, c_y, .. } = *stiffness;
    let off = (c_y - c_x) * s * c;
    [[c_x * c * c + c_y * s * s, off], [off, c_x * s * s + c_y * c * c]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn law(friction: f64) -> CattaneoMindlin {
        let stiffness = ContactStiffness::new(0.8, 0.7, 1.3).unwrap();
        CattaneoMindlin::new(stiffness, Friction::new(friction).unwrap())
    }

    #[test]
    fn limits_of_friction() {
        // No friction: no force, whatever the shift.
        let free = law(0.0).at_shift(1.0, 0.1, 0.2).unwrap();
        assert_eq!(free.force, [0.0, 0.0]);
        assert!(free.is_sliding());
        let error = law(0.0).at_force(1.0, 1e-9, 0.0).unwrap_err();
        assert!(matches!(error, ShiftError::BeyondFriction { .. }));
        // No slip: Mindlin's constant stiffness (5.30), and the limit of large friction.
        let stuck = law(f64::INFINITY).at_shift(4.0, 0.1, 0.2).unwrap();
        assert_relative_eq!(stuck.force[0], 0.8 * 2.0 * 0.1, max_relative = 1e-15);
        assert_relative_eq!(stuck.force[1], 0.7 * 2.0 * 0.2, max_relative = 1e-15);
        let large = law(1e12).at_shift(4.0, 0.1, 0.2).unwrap();
        assert_relative_eq!(large.force[0], stuck.force[0], max_relative = 1e-12);
        let back = law(f64::INFINITY).at_force(4.0, stuck.force[0], stuck.force[1]).unwrap();
        assert_relative_eq!(back.shift[1], 0.2, max_relative = 1e-15);
        let ellipse = ContactEllipse::new(1.0, 2.0).unwrap();
        let (one, two) = (stuck.traction(&ellipse, 0.5, 0.3), large.traction(&ellipse, 0.5, 0.3));
        assert_relative_eq!(one[0], two[0], max_relative = 1e-11);
    }

    #[test]
    fn traction_is_continuous_and_bounded_by_friction() {
        let state = law(0.4).at_shift(1.0, 0.2, -0.1).unwrap();
        let ellipse = ContactEllipse::new(1.0, 2.0).unwrap();
        let edge = state.stick_radius();
        let (inside, outside) = (
            state.traction(&ellipse, edge * (1.0 - 1e-12), 0.0),
            state.traction(&ellipse, edge * (1.0 + 1e-12), 0.0),
        );
        assert_relative_eq!(inside[0], outside[0], max_relative = 1e-5);
        let peak = 1.5 * state.normal_force / ellipse.area();
        for i in 0..100 {
            let x = f64::from(i) / 100.0;
            let [u, v] = state.traction(&ellipse, x, 0.0);
            let limit = 0.4 * peak * (1.0 - x * x).sqrt();
            assert!(libm::hypot(u, v) <= limit * (1.0 + 1e-15));
        }
        assert_eq!(state.traction(&ellipse, 1.01, 0.0), [0.0, 0.0]);
    }

    #[test]
    fn turned_stiffness_is_a_tensor() {
        let stiffness = ContactStiffness::new(0.8, 0.5, 1.0).unwrap();
        let turned = turned_stiffness(&stiffness, 0.7);
        assert_relative_eq!(turned[0][0] + turned[1][1], 1.3, max_relative = 1e-15);
        let determinant = turned[0][0] * turned[1][1] - turned[0][1] * turned[1][0];
        assert_relative_eq!(determinant, 0.4, max_relative = 1e-15);
        assert_eq!(turned_stiffness(&stiffness, 0.0), [[0.8, 0.0], [0.0, 0.5]]);
    }

    #[test]
    fn bad_arguments_are_named() {
        assert_eq!(law(0.3).at_shift(0.0, 0.1, 0.0).unwrap_err().field, "approach");
        assert_eq!(law(0.3).at_shift(1.0, f64::NAN, 0.0).unwrap_err().field, "xi");
        let error = law(0.3).at_force(1.0, 0.0, f64::INFINITY).unwrap_err();
        assert!(matches!(error, ShiftError::Range(RangeError { field: "force_y", .. })));
    }
}
