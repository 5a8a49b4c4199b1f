//! An impact by rings in contact axes, and the one of similar bodies whose solution is known.

use carom_laws::friction::Friction;
use carom_laws::law::ContactLaw;
use carom_laws::rings::RingConstants;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::viscous::{Viscosity, ViscousLaw};
use carom_special::RangeError;

use super::RingImpactError;
use super::motion::{Motion, Rates};
use crate::collision::CollisionError;
use crate::normal::DURATION;
use crate::oblique::{Groups, ObliqueImpact};
use crate::viscoelastic::{ViscoelasticImpact, ViscousLoss};

/// D_zz that gives a maximum approach of 1 for unit velocity and c_z = 4.
const MOBILITY: f64 = 15.0 / 32.0;

/// The impact in contact axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Problem {
    pub(super) motion: Motion,
    pub(super) constants: RingConstants,
    pub(super) friction: Friction,
    /// The loss of the material; none of an elastic one.
    pub(super) loss: Option<ViscousLoss>,
}

/// What the same impact of similar bodies without spin does.
pub(super) struct Exact {
    pub(super) rates: Rates,
    pub(super) friction_heat: f64,
}

/// A spin whose speed at the distance of the radius of the bodies is a smaller part of f times the normal velocity is none:
/// what rounding leaves of one along the surface.
const NEGLIGIBLE_SPIN: f64 = 1e-9;

/// The coefficient of friction with which coupled bodies are followed that never slip. Places at the receding rim cannot stick
/// without tension, and let go: any great friction shows it. Between 1e3 and 1e7 the tangential velocity differs by .005 v_z
/// where it was v_z before. A rim that holds tension is then .14 to .17 v_z off at |gamma| near 1/2, against a grid.
const AS_INFINITE: f64 = 1e6;

/// Tolerance of R_x of similar bodies with a loss.
const ALIKE: f64 = 1e-4;

impl Problem {
    /// An impact with unit normal velocity and maximum approach; `lambda` is the tangential velocity over f,
    /// `ratio` is D_xx/D_zz.
    pub(super) fn of_groups(
        [kappa, gamma]: [f64; 2],
        friction: Friction,
        lambda: f64,
        ratio: f64,
    ) -> Self {
        let motion = Motion {
            mobility: [MOBILITY, MOBILITY * ratio, 0.0],
            before: [1.0, lambda * friction.coefficient().unwrap_or(1.0), 0.0, 0.0],
            duration: DURATION,
        };
        let constants = RingConstants { c_z: 4.0, radius: 1.0, kappa, gamma };
        Self { motion, constants, friction, loss: None }
    }

    /// The same with finite friction in place of infinite where coupling would pull at the rim.
    pub(super) fn letting_go_at_the_rim(mut self) -> Result<Self, RangeError> {
        if self.friction.get().is_infinite() && self.constants.gamma != 0.0 {
            self.friction = Friction::new(AS_INFINITE)?;
        }
        Ok(self)
    }

    /// The same impact of similar bodies without spin.
    pub(super) fn alike(&self) -> Self {
        let mut alike = *self;
        alike.constants.gamma = 0.0;
        alike.motion.before[3] = 0.0;
        alike
    }

    /// The same without a spin that is too slow to matter.
    pub(super) fn without_negligible_spin(mut self) -> Self {
        // The radius of the contact is the root of that of the bodies times the approach.
        let radius = self.constants.radius * self.constants.radius;
        let [speed, .., spin] = self.motion.before;
        if spin.abs() * radius < NEGLIGIBLE_SPIN * self.scale() * speed {
            self.motion.before[3] = 0.0;
        }
        self
    }

    /// Scale of the tangential velocities: f, or 1 where f is too large to be one.
    pub(super) fn scale(&self) -> f64 {
        match self.friction.get() {
            f if f > 0.0 && f < 1.0 => f,
            _ => 1.0,
        }
    }

    /// The coupling over friction, gamma/f.
    pub(super) fn spread(&self) -> f64 {
        self.constants.gamma.abs() / self.friction.get()
    }

    /// R_x of the impact of similar bodies.
    pub(super) fn exact_restitution(&self) -> Result<f64, RingImpactError> {
        Ok(self.alike_rebound()?[0])
    }

    /// R_x of the impact of similar bodies, and its heat of friction.
    fn alike_rebound(&self) -> Result<[f64; 2], RingImpactError> {
        let [speed, xi, eta, _] = self.motion.before;
        let [along, across, _] = self.motion.mobility;
        let kappa = self.constants.kappa;
        let chi = across / (along * kappa);
        let slip = xi.hypot(eta);
        let psi = match self.friction.coefficient() {
            None => 0.0,
            Some(0.0) => f64::INFINITY,
            Some(f) => slip / (kappa * speed * f),
        };
        let groups = Groups::new(chi, psi)?;
        if let Some(loss) = self.loss {
            let impact = ViscoelasticImpact::new(groups, loss);
            let rebound = impact.solve(ALIKE);
            let over = slip / impact.psi();
            return Ok([
                rebound.restitution,
                over * over * rebound.friction_heat / (kappa * along),
            ]);
        }
        let impact = ObliqueImpact::new(groups).map_err(CollisionError::from)?;
        let r_x = impact.restitution();
        Ok([r_x, 0.5 * slip * slip * (1.0 - r_x) * (1.0 + r_x) / across])
    }

    /// The same impact of similar bodies without spin.
    pub(super) fn exact(&self) -> Result<Exact, RingImpactError> {
        let [speed, xi, eta, _] = self.motion.before;
        let [r_x, friction_heat] = self.alike_rebound()?;
        let rates = [-self.normal() * speed, -r_x * xi, -r_x * eta, 0.0];
        Ok(Exact { rates, friction_heat })
    }

    /// The normal restitution of similar bodies.
    pub(super) fn normal(&self) -> f64 {
        self.loss.map_or(1.0, |loss| loss.restitution())
    }

    /// The viscosity of the material, if it loses energy.
    pub(super) fn viscosity(&self) -> Result<Option<Viscosity>, RangeError> {
        // The duration of the free impact is that of Hertz, in units of zeta_max/v.
        let unit = self.motion.duration / DURATION * libm::pow(1.25, -0.4);
        self.loss.map(|loss| loss.viscosity(unit)).transpose()
    }

    /// A law in a material with this viscosity.
    pub(super) fn viscous_law<L: ContactLaw>(&self, law: L, viscosity: Viscosity) -> ViscousLaw<L> {
        ViscousLaw::new(law, viscosity, self.friction.get(), self.stiffness())
    }

    pub(super) fn stiffness(&self) -> ContactStiffness {
        let RingConstants { c_z, kappa, .. } = self.constants;
        ContactStiffness { c_x: c_z / kappa, c_y: c_z / kappa, c_z }
    }
}
