//! Impacts of two equal spheres on the numerical contact, step by step as the thesis runs them.

use crate::Failure;
use carom_halfspace::{Material, MaterialPair};
use carom_impact::coupled::Trajectory;
use carom_impact::normal::NormalImpact;
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::rings::{RingLaw, Tolerance};
use carom_solver::{CellState, ContactState, NumericalLaw};
use nalgebra::{Matrix3, Vector3};

/// 82000 N/mm^2, in Pa.
pub(super) const SHEAR_MODULUS: f64 = 82e9;
/// Tolerance of each step.
const TOLERANCE: f64 = 1e-7;
const RING_TOLERANCE: f64 = 1e-6;

/// The law of rings beside the grid: as many rings as there are cells along a radius.
pub(super) type FineRings = RingLaw<16, 16>;

/// Two spheres of the same size and mass; SI units.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spheres {
    pub(super) bodies: [Material; 2],
    pub(super) radius: f64,
    pub(super) mass: f64,
    pub(super) friction: f64,
    /// The speed of approach.
    pub(super) speed: f64,
}

/// An instant of an impact; rates of xi, eta, zeta and of the twist.
#[derive(Debug, Clone)]
pub(super) struct Instant {
    pub(super) time: f64,
    pub(super) shift: Shift,
    pub(super) rate: [f64; 4],
    pub(super) load: ContactLoad,
    /// None if the bodies are separated.
    pub(super) contact: Option<ContactState>,
}

impl Spheres {
    /// Of fig. 15.4, with other materials and friction: 2188 g at 1 m/s, the radius from 7.85 g/cm^3.
    pub(super) fn of(bodies: [Material; 2], friction: f64) -> Self {
        let mass = 2.188;
        let radius = libm::cbrt(mass / (4.0 / 3.0 * std::f64::consts::PI * 7850.0));
        Self { bodies, radius, mass, friction, speed: 1.0 }
    }

    /// Of this Poisson's ratio and G = 82000 N/mm^2, f = 0.1.
    pub(super) fn alike(poisson: f64) -> Result<Self, Failure> {
        Ok(Self::of([Material::from_shear(SHEAR_MODULUS, poisson)?; 2], 0.1))
    }

    pub(super) fn hertz(&self) -> Result<Hertz, Failure> {
        let [one, two] = self.bodies;
        // Gaps r^2/(2 R) on both sides.
        let curvature = RelativeCurvature::from_coefficients(1.0 / self.radius, 1.0 / self.radius)?;
        Ok(Hertz::new(curvature, MaterialPair::new(one, two)?)?)
    }

    pub(super) fn normal(&self) -> Result<NormalImpact, Failure> {
        let c_z = self.hertz()?.stiffness().c_z;
        Ok(NormalImpact::new(2.0 / self.mass, c_z, self.speed)?)
    }

    fn law(&self, cells: usize) -> Result<NumericalLaw, Failure> {
        let (friction, peak) = (Friction::new(self.friction)?, self.normal()?.maximal_approach());
        Ok(NumericalLaw::new(self.hertz()?, friction, peak, cells)?.within(TOLERANCE)?)
    }

    /// R_x and e_z for a slip of lambda f times the speed of approach.
    pub(super) fn restitutions(
        &self,
        lambda: f64,
        cells: usize,
        steps: usize,
    ) -> Result<[f64; 2], Failure> {
        let velocity = Vector3::new(lambda * self.friction * self.speed, 0.0, self.speed);
        let trajectory = Trajectory {
            mobility: Matrix3::from_diagonal(&Vector3::new(3.5, 3.5, 1.0)) * (2.0 / self.mass),
            velocity,
            stiffness: self.hertz()?.stiffness(),
            steps,
            expected: Some(self.normal()?.duration()),
        };
        let end =
            trajectory.follow(&mut self.law(cells)?, |_, _| ())?.ok_or("they stay together")?;
        Ok([-end.velocity.x / velocity.x, -end.velocity.z / velocity.z])
    }

    /// R_x alone.
    pub(super) fn restitution(
        &self,
        lambda: f64,
        cells: usize,
        steps: usize,
    ) -> Result<f64, Failure> {
        Ok(self.restitutions(lambda, cells, steps)?[0])
    }

    /// The impact from first contact to separation, with this many equal time steps in Hertz's duration;
    /// `spin` is the relative spin about the normal, in radians.
    pub(super) fn follow(
        &self,
        lambda: f64,
        spin: f64,
        cells: usize,
        steps: usize,
    ) -> Result<Vec<Instant>, Failure> {
        let law = self.law(cells)?;
        let step = self.normal()?.duration() / steps as f64;
        let slip = lambda * self.friction * self.speed;
        self.swing(law, [slip, 0.0, self.speed, spin], step, |law| law.state().cloned())
    }

    /// The same by rings; `see` sees the law after each step.
    pub(super) fn by_rings(
        &self,
        lambda: f64,
        spin: f64,
        steps: usize,
        see: impl Fn(&FineRings),
    ) -> Result<Vec<Instant>, Failure> {
        let tolerance = Tolerance::new(RING_TOLERANCE)?;
        let law = FineRings::new(&self.hertz()?, Friction::new(self.friction)?, tolerance)?;
        let step = self.normal()?.duration() / steps as f64;
        let slip = lambda * self.friction * self.speed;
        self.swing(law, [slip, 0.0, self.speed, spin], step, |law| {
            see(law);
            None
        })
    }

    /// The same with any law.
    pub(super) fn swing<L: ContactLaw>(
        &self,
        mut law: L,
        rate: [f64; 4],
        step: f64,
        seen: impl Fn(&L) -> Option<ContactState>,
    ) -> Result<Vec<Instant>, Failure> {
        let (shift, load) = Default::default();
        let mut now = Instant { time: 0.0, shift, rate, load, contact: None };
        let mut all = vec![now.clone()];
        loop {
            let pull = self.pull(&now.load);
            let half = combined(now.rate, pull, -0.5 * step);
            let to = moved(now.shift, half, step);
            if to.zeta <= 0.0 {
                // The force decreases with the power 3/2 of the remaining time: its mean is 2/5.
                let part = now.shift.zeta / -half[2];
                let rate = combined(now.rate, pull, -0.4 * part);
                let shift = moved(now.shift, half, part);
                let (time, load) = (now.time + part, ContactLoad::default());
                all.push(Instant { time, shift, rate, load, contact: None });
                return Ok(all);
            }
            let load = law.advance(to)?;
            let rate = combined(half, self.pull(&load), -0.5 * step);
            now = Instant { time: now.time + step, shift: to, rate, load, contact: seen(&law) };
            all.push(now.clone());
        }
    }

    /// The change of the rates by a load: the mobility of two solid spheres times the load.
    fn pull(&self, load: &ContactLoad) -> [f64; 4] {
        let unit = 2.0 / self.mass;
        let spin = 2.5 * unit / (self.radius * self.radius); // 2/theta
        [3.5 * unit * load.f_x, 3.5 * unit * load.f_y, unit * load.f_z, spin * load.m_z]
    }
}

fn combined(rate: [f64; 4], pull: [f64; 4], time: f64) -> [f64; 4] {
    std::array::from_fn(|i| rate[i] + time * pull[i])
}

fn moved(from: Shift, rate: [f64; 4], time: f64) -> Shift {
    Shift {
        xi: from.xi + time * rate[0],
        eta: from.eta + time * rate[1],
        zeta: from.zeta + time * rate[2],
        omega: from.omega + time * rate[3],
    }
}

/// The fraction of the contact that sticks; None if the bodies are separated.
pub(super) fn stick(contact: &ContactState) -> f64 {
    let [sticks, slips] = [CellState::Stick, CellState::Slip].map(|cell| contact.count(cell));
    sticks as f64 / (sticks + slips).max(1) as f64
}
