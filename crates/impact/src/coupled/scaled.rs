//! A coupled impact in units of the free impact and in axes of its own.

use carom_laws::stiffness::ContactStiffness;
use nalgebra::{Matrix3, Vector3};

use super::refine::Problem;
use super::{CoupledImpact, ImpactMethod};
use crate::normal;

/// Units in which the numbers of the law are of order one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Units {
    pub(super) time: f64,
    pub(super) length: f64,
    pub(super) speed: f64,
    pub(super) force: f64,
    pub(super) impulse: f64,
}

impl Units {
    /// Units of a law in those of the data.
    pub(super) const GIVEN: Self =
        Self { time: 1.0, length: 1.0, speed: 1.0, force: 1.0, impulse: 1.0 };
}

/// Conversion from a run to the contact axes and the units of the data.
#[derive(Debug, Clone, Copy)]
pub(super) struct View {
    pub(super) units: Units,
    pub(super) frame: Matrix3<f64>,
}

impl CoupledImpact {
    pub(super) fn view(&self) -> View {
        View { units: self.units(), frame: self.frame() }
    }

    pub(super) fn units(&self) -> Units {
        Units {
            time: self.normal.time_unit(),
            length: self.normal.maximal_approach(),
            speed: self.velocity.z,
            force: self.normal.maximal_force(),
            impulse: 1.25 * self.velocity.z / self.mobility.matrix().m33,
        }
    }

    // Columns: the tangent of a planar motion, the normal of its plane, the contact normal.
    pub(super) fn frame(&self) -> Matrix3<f64> {
        match self.method() {
            ImpactMethod::Planar { direction } => {
                Matrix3::from_columns(&[direction, Vector3::z().cross(&direction), Vector3::z()])
            }
            _ => Matrix3::identity(),
        }
    }

    // In units of the uncoupled normal impact: dv/dt = -(5/4) D/D_zz F, F_z = zeta^(3/2).
    pub(super) fn problem(&self) -> Problem {
        let frame = self.frame();
        let d = self.mobility.matrix();
        let mut mobility = frame.transpose() * (d * (1.25 / d.m33)) * frame;
        if matches!(self.method(), ImpactMethod::Planar { .. }) {
            // Couplings out of the plane are round-off.
            for (i, j) in [(0, 1), (1, 2)] {
                (mobility[(i, j)], mobility[(j, i)]) = (0.0, 0.0);
            }
        }
        let mut velocity = frame.tr_mul(&(self.velocity / self.velocity.z));
        if matches!(self.method(), ImpactMethod::Planar { .. }) {
            velocity.y = 0.0;
        }
        let stiffness = self.scaled();
        let expected = self.is_mild().then_some(normal::DURATION);
        Problem { mobility, velocity, stiffness, expected }
    }

    /// Whether the impact resembles a free one: friction hardly drives the normal motion, and the
    /// tangential motion takes at least a third of the time of the normal one.
    #[must_use]
    pub fn is_mild(&self) -> bool {
        let d = self.mobility.matrix();
        let ContactStiffness { c_x, c_y, c_z } = self.stiffness;
        let driven = self.friction.get() * libm::hypot(d.m13, d.m23);
        let stiff = (c_x * d.m11).max(c_y * d.m22);
        driven <= 0.5 * d.m33 && stiff <= 10.0 * c_z * d.m33
    }

    // In the units of the problem; in a plane c_x is that along its tangent.
    pub(super) fn scaled(&self) -> ContactStiffness {
        let ContactStiffness { c_x, c_y, c_z } = self.stiffness;
        let (c_x, c_y) = match self.method() {
            ImpactMethod::Planar { direction: e } => {
                let along = c_x * e.x * e.x + c_y * e.y * e.y;
                (along, along)
            }
            _ => (c_x, c_y),
        };
        let unit = 1.5 / c_z;
        ContactStiffness { c_x: c_x * unit, c_y: c_y * unit, c_z: 1.5 }
    }
}
