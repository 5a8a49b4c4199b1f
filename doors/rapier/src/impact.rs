//! The tangential impulse of an impact.

use carom_impact::oblique::Groups;
use carom_impact::restitution::RestitutionTable;
use rapier3d::glamx::DVec3;

/// An impact at a point, by what the impulse needs of the bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    /// The unit normal, from body 1 into body 2.
    pub normal: DVec3,
    /// The velocity of body 1 against body 2 at the contact, before the impact.
    pub velocity: DVec3,
    /// Change of the normal velocity per impulse, 1/kg.
    pub normal_mobility: f64,
    /// Change of the tangential velocity per impulse, 1/kg.
    pub tangential_mobility: f64,
    /// Normal over tangential stiffness of the contact.
    pub kappa: f64,
    /// The coefficient of friction.
    pub friction: f64,
    /// The coefficient of restitution of the normal velocity.
    pub restitution: f64,
}

impl Impact {
    /// The tangential part of a vector.
    #[must_use]
    pub fn across(&self, vector: DVec3) -> DVec3 {
        vector - vector.dot(self.normal) * self.normal
    }

    /// The tangential impulse on body 1; none if the bodies do not approach each other or nothing drags them.
    ///
    /// It is `(1 + R_x) slip/D_xx`, R_x that of a viscous material with the restitution of the normal velocity.
    #[must_use]
    pub fn tangential_impulse(&self) -> Option<DVec3> {
        let approach = self.velocity.dot(self.normal);
        let slip = self.across(self.velocity);
        if !(approach > 0.0 && self.friction > 0.0) {
            return None;
        }
        let chi = self.tangential_mobility / (self.normal_mobility * self.kappa);
        let psi = slip.length() / (self.kappa * self.friction * approach);
        let groups = Groups::new(chi, psi).ok()?;
        let r_x = RestitutionTable::shared().restitution_with(groups, self.restitution).ok()?;
        Some(-(1.0 + r_x) / self.tangential_mobility * slip)
    }
}
