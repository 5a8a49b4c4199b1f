//! The spin about the common normal: unchanged by an impact, or changed by its torsion.
//!
//! Chapter 10 treats the torsional impact as independent of the tangential one. Both use the same
//! friction limit, but each is computed as if the other were absent. This is valid if one of them
//! is small.

use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use nalgebra::{Matrix3, Vector3};

use crate::normal_restitution::Damped;
use crate::outcome::Torsion;
use crate::torsional::{SpinCollision, Spinner, TorsionalError, limits};

/// Couplings below this share of their largest possible value are round-off.
const MAX_COUPLING_OF_ROUND_OFF: f64 = 1e-9;

/// Why torsion cannot be treated separately.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NormalSpinError {
    /// A body's spin about the normal is coupled to its other motion.
    #[error(
        "torsion: the spin of body {body} about the normal is coupled to the motion of its contact \
         point; the normal must pass through the centre of mass along a principal axis of inertia"
    )]
    SpinCoupled {
        /// 1 or 2.
        body: u8,
    },
    /// The normal motion is coupled to the tangential motion.
    #[error(
        "torsion: normal and tangential motion are coupled; the normal must pass through both \
         centres of mass"
    )]
    NormalCoupled,
    /// The torsional impact could not be solved.
    #[error("torsion: {0}")]
    Torsional(#[from] TorsionalError),
}

impl Torsion {
    /// Keeps the share s of the torsional impact.
    pub(crate) fn damp(&mut self, damped: Damped) {
        if damped.part < 1.0 {
            self.torque_impulse *= damped.part;
            self.spin_ratio = 1.0 - damped.part * (1.0 - self.spin_ratio);
            self.dissipated *= damped.part;
        }
    }
}

/// The properties of a body that determine its change of spin about the normal.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pivot {
    /// Vector from the centre of mass to the contact point.
    pub(crate) arm: Vector3<f64>,
    /// theta^-1 in space axes.
    pub(crate) inverse_tensor: Matrix3<f64>,
    pub(crate) spin: Vector3<f64>,
}

/// Two bodies that collide and spin about their common normal.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NormalSpin<'a> {
    pub(crate) hertz: &'a Hertz,
    pub(crate) friction: Friction,
    pub(crate) normal: Vector3<f64>,
    pub(crate) pivots: [Pivot; 2],
    /// D_zz.
    pub(crate) normal_mobility: f64,
    /// Approach velocity.
    pub(crate) velocity: f64,
    /// The normal restitution of a viscous material; 1 of others.
    pub(crate) restitution: f64,
}

/// A viscous material resists the twist of a contact that sticks, too: with hardly any rebound it takes up to this part more
/// of the spin than an elastic one, by rings, and from e = .2 on less.
const VISCOUS: f64 = 1.5;

impl NormalSpin<'_> {
    /// The torsional impact.
    pub(crate) fn solve(&self) -> Result<Torsion, NormalSpinError> {
        for (body, pivot) in [1, 2].into_iter().zip(&self.pivots) {
            let turned = pivot.inverse_tensor * self.normal;
            let most = pivot.arm.norm() * pivot.inverse_tensor.norm();
            if pivot.arm.cross(&turned).norm() > MAX_COUPLING_OF_ROUND_OFF * most {
                return Err(NormalSpinError::SpinCoupled { body });
            }
        }
        if self.relative_spin() == 0.0 {
            return Ok(Torsion {
                spin_ratio: 1.0,
                torque_impulse: 0.0,
                dissipated: 0.0,
                error_estimate: 0.0,
            });
        }
        let outcome = self.collision()?.solve()?;
        Ok(Torsion {
            spin_ratio: outcome.spin_ratio,
            torque_impulse: outcome.torque_impulse,
            dissipated: outcome.energy_loss,
            error_estimate: outcome.error_estimate,
        })
    }

    /// Half the torque impulse times the change of the relative spin.
    pub(crate) fn exchanged(&self, torsion: &Torsion) -> f64 {
        0.5 * (torsion.torque_impulse * (1.0 - torsion.spin_ratio) * self.relative_spin()).abs()
    }

    /// The change of a body's spin by the torque impulse on body 1.
    pub(crate) fn turn(&self, body: usize, torsion: &Torsion) -> Vector3<f64> {
        let sign = if body == 0 { 1.0 } else { -1.0 };
        self.pivots[body].inverse_tensor * self.normal * (sign * torsion.torque_impulse)
    }

    /// An upper bound of the fraction of the relative spin that torsion would remove: the smaller of the
    /// closed forms for no slip and for sliding. None without spin or friction.
    pub(crate) fn greatest_loss(&self) -> Option<f64> {
        if self.relative_spin() == 0.0 {
            return None;
        }
        let groups = self.collision().ok()?.groups().ok()??;
        let (epsilon, omega, e) = (groups.epsilon(), groups.omega(), self.restitution);
        let resisted = 1.0 + VISCOUS * (1.0 - e).powi(8);
        let stuck = resisted * (1.0 - limits::no_slip_first_order(epsilon));
        Some(stuck.min(1.0 - limits::sliding(epsilon, omega)).min(1.0))
    }

    fn relative_spin(&self) -> f64 {
        (self.pivots[0].spin - self.pivots[1].spin).dot(&self.normal)
    }

    // D_zz is that of both bodies: all mass is assigned to the first.
    fn collision(&self) -> Result<SpinCollision, TorsionalError> {
        let spinner = |pivot: &Pivot, mass: f64| {
            let inverse = self.normal.dot(&(pivot.inverse_tensor * self.normal));
            Spinner::new(mass, 1.0 / inverse)?.spinning(pivot.spin.dot(&self.normal))
        };
        let [one, two] = &self.pivots;
        let bodies = [spinner(one, 1.0 / self.normal_mobility)?, spinner(two, f64::INFINITY)?];
        SpinCollision::new(self.hertz, self.friction, bodies, self.velocity)
    }
}
