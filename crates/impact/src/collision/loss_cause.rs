//! How far R_x may be off because the cause of a loss along the normal is not known.

use carom_special::RangeError;
use nalgebra::Vector3;

use super::Collision;
use crate::oblique::{Groups, ObliqueImpact};
use crate::warning::Warning;

/// The share of the velocity before the impact from which on this is a warning.
const NOTICEABLE: f64 = 0.05;

impl Collision {
    /// By how much R_x may differ in a material that loses as much from another cause; 0 where the cause is given, nothing
    /// is lost or nothing rubs.
    ///
    /// With R the elastic R_x of (chi, psi), it is the larger of the distances to `R(chi, 2 psi/(1 + e))`, the elastic impact
    /// with the friction that the impulse still allows, and to `(1 + e)(1 + R)/2 - 1`, the elastic impulse scaled. Both vanish
    /// at e = 1 and where all slides. For spheres (kappa 1 to 1.5, lambda .2 to 8, e .5 to .95) it covered each value of a
    /// constant loss tangent and of Maxwell's material, and 69 to 83 % of crude estimates for bodies that yield.
    ///
    /// Normal and tangential motion are taken as uncoupled, along the slip before.
    pub(super) fn model_uncertainty(
        &self,
        before: &Vector3<f64>,
        r_x: Option<f64>,
    ) -> Result<f64, RangeError> {
        let loss = self.viscous_loss(before.z)?;
        let (Some(loss), Some(r_x)) =
            (loss.filter(|_| !self.normal_restitution.is_cause_known()), r_x)
        else {
            return Ok(0.0);
        };
        let Some(groups) = self.groups_along_slip(before) else { return Ok(0.0) };
        let e = loss.restitution();
        let elastic = |psi: f64| {
            let groups = Groups::new(groups.chi(), psi).ok()?;
            ObliqueImpact::new(groups).ok().map(|impact| impact.restitution())
        };
        let both = (elastic(2.0 * groups.psi() / (1.0 + e)), elastic(groups.psi()));
        let (Some(shifted), Some(given)) = both else { return Ok(0.0) };
        let scaled = 0.5 * (1.0 + e) * (1.0 + given) - 1.0;
        Ok((r_x - shifted).abs().max((r_x - scaled).abs()))
    }

    /// The groups of the impact along its slip; None without friction or slip, or beyond their ranges.
    fn groups_along_slip(&self, before: &Vector3<f64>) -> Option<Groups> {
        let slip = libm::hypot(before.x, before.y);
        let friction = self.friction.coefficient();
        if slip == 0.0 || friction == Some(0.0) {
            return None;
        }
        let along = Vector3::new(before.x / slip, before.y / slip, 0.0);
        let (d, stiffness) = (self.mobility.matrix(), self.stiffness());
        // Compliances add along an axis between those of the contact.
        let soft = along.x * along.x / stiffness.c_x + along.y * along.y / stiffness.c_y;
        let ratio = 1.0 / (soft * stiffness.c_z);
        let chi = along.dot(&(d * along)) * ratio / d.m33;
        let psi = friction.map_or(0.0, |f| ratio * slip / (f * before.z));
        Groups::new(chi, psi).ok()
    }

    /// The warning that R_x depends on the cause of the loss.
    pub(super) fn unknown_cause(before: &Vector3<f64>, uncertainty: f64) -> Option<Warning> {
        let share = uncertainty * libm::hypot(before.x, before.y) / before.norm();
        (share > NOTICEABLE).then_some(Warning::UnknownLoss { share })
    }
}
