//! Derivatives of the rebound of spheres and planes by all that it depends on.

use carom_special::RangeError;
use nalgebra::{Matrix3, SMatrix, Vector3};

use super::input::{INPUTS, Input, OUTPUTS, Part, Row, mobilities};
use super::{Collision, CollisionError};
use crate::body::Body;
use crate::closed_form::restitution_in_sliding;
use crate::motion::Motion;
use crate::oblique::Groups;
use crate::restitution::Sensitivity;

type Rows = SMatrix<f64, 3, INPUTS>;

/// A rebound and its derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct ReboundDerivatives {
    /// The motions afterwards, of body 1 and body 2.
    pub motions: [Motion; 2],
    /// Rows: velocity and spin of body 1, then of body 2; columns: [`Input::ALL`].
    pub matrix: SMatrix<f64, OUTPUTS, INPUTS>,
    /// Whether the regimes of the impact change here, so that derivatives are those of one side.
    pub is_at_change: bool,
}

impl Collision {
    /// The rebound with its derivatives by all inputs, where the theory is closed: spheres and planes without a loss whose
    /// normal and tangential motions are uncoupled. None for others: bodies of other shapes, static friction above kinetic
    /// friction, friction that changes the spin about the normal, balls whose line of centres turns.
    ///
    /// The common normal is fixed. Friction by the slip speed has the value of this impact. Errors are those of
    /// [`Sensitivity`]: within 1e-7 of the largest entry of a row, if the inputs are measured by their sizes.
    ///
    /// ```
    /// use carom_halfspace::Material;
    /// use carom_impact::{Body, Collision, Input, Motion};
    /// use carom_laws::friction::Friction;
    /// let steel = Material::from_shear(80e9, 0.3)?;
    /// let ball = Body::sphere(0.01, steel, 0.0329)?.moving(Motion::new([9.0, 0.0, -1.0], [0.0; 3])?);
    /// let collision = Collision::new(ball, Body::plane(steel), Friction::new(0.1)?)?;
    /// let found = collision.derivatives()?.ok_or("spheres and planes")?;
    /// // It slides throughout: v_x' = v_x - 2 f |v_z|.
    /// assert!((found.matrix[(0, Input::Friction.column())] + 2.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Collision::solve`].
    pub fn derivatives(&self) -> Result<Option<ReboundDerivatives>, CollisionError> {
        let elastic = self.normal_restitution.constant().is_some_and(|(e, _)| e == 1.0);
        let parts = [0, 1].map(|i| Part::of(self, i));
        let ([Some(one), Some(two)], true) = (parts, elastic && self.is_plain()) else {
            return Ok(None);
        };
        Ok(Some(self.differentiated([one, two])?))
    }

    fn differentiated(&self, parts: [Part; 2]) -> Result<ReboundDerivatives, CollisionError> {
        let own = self.bodies.each_ref().map(Body::motion);
        let (impulse, by, is_at_change) = self.impulse_with_derivatives(&parts)?;
        let mut matrix = SMatrix::<f64, OUTPUTS, INPUTS>::zeros();
        let mut motions = own;
        for (i, (part, sign)) in parts.iter().zip([1.0, -1.0]).enumerate() {
            let velocity = sign * part.inverse_mass * impulse;
            // a x J/I: both bodies get the same turn, since arm and impulse have other signs.
            let cross = part.turning * self.frame().z().cross_matrix();
            let spin = -cross * impulse;
            let mut by_velocity = by * (sign * part.inverse_mass);
            let mut by_spin = -cross * by;
            for (input, [velocities, spins]) in part.changes(i) {
                by_velocity.column_mut(input.column()).axpy(velocities, &velocity, 1.0);
                by_spin.column_mut(input.column()).axpy(spins, &spin, 1.0);
            }
            matrix.fixed_view_mut::<3, INPUTS>(6 * i, 0).copy_from(&by_velocity);
            matrix.fixed_view_mut::<3, INPUTS>(6 * i + 3, 0).copy_from(&by_spin);
            motions[i].velocity += velocity;
            motions[i].spin += spin;
        }
        for i in 0..OUTPUTS {
            matrix[(i, i)] += 1.0;
        }
        Ok(ReboundDerivatives { motions, matrix, is_at_change })
    }

    /// The impulse on body 1 with its derivatives, and whether these are of one side.
    fn impulse_with_derivatives(
        &self,
        parts: &[Part; 2],
    ) -> Result<(Vector3<f64>, Rows, bool), CollisionError> {
        let z = self.frame().z();
        let before = self.frame().axes() * self.velocity();
        let by_before = self.velocity_by_inputs();
        let (speed, by_speed) = (before.dot(&z), z.transpose() * by_before);
        let (across, by_across) = (before - z * speed, by_before - z * by_speed);
        let slip = across.norm();
        let along = if slip > 0.0 { across / slip } else { Vector3::zeros() };
        let by_slip: Row = along.transpose() * by_across;
        let [(d_xx, by_d_xx), (d_zz, by_d_zz)] = mobilities(parts);
        let (normal, by_normal) = {
            let normal = 2.0 * speed / d_zz;
            (normal, by_speed * (2.0 / d_zz) - by_d_zz * (normal / d_zz))
        };
        let stiffness = self.stiffness();
        let kappa = stiffness.c_z / stiffness.c_x;
        let by_kappa = self.stiffness_ratio_by_inputs(kappa);
        let friction = self.friction.get();
        let chi = d_xx / (d_zz * kappa);
        let psi = if slip > 0.0 { slip / (kappa * friction * speed) } else { 0.0 };
        let mut by_friction = Row::zeros();
        by_friction[Input::Friction.column()] = 1.0;
        let (force, by_force, is_at_change) = if restitution_in_sliding(chi, psi).is_some() {
            let by_limit = by_friction * normal + by_normal * friction;
            let turn = (by_across - along * by_slip) * (friction * normal / slip);
            (along * (friction * normal), along * by_limit + turn, false)
        } else {
            let found = Sensitivity::of(self.groups_named([chi, psi])?)?;
            let share = (1.0 + found.restitution) / d_xx;
            let by_friction =
                if friction.is_finite() { by_friction / friction } else { Row::zeros() };
            let by_chi = by_d_xx / d_xx - by_d_zz / d_zz - by_kappa / kappa;
            let by_log_slip = if slip > 0.0 { by_slip / slip } else { Row::zeros() };
            let by_psi = by_log_slip - by_kappa / kappa - by_friction - by_speed / speed;
            let by_share = (by_chi * (chi * found.by_chi) + by_psi * (psi * found.by_psi)) / d_xx
                - by_d_xx * (share / d_xx);
            (across * share, by_across * share + across * by_share, found.is_at_change)
        };
        Ok((force + z * normal, by_force + z * by_normal, is_at_change))
    }

    /// The groups, whose error names the ratio of stiffnesses if that was given.
    fn groups_named(&self, [chi, psi]: [f64; 2]) -> Result<Groups, RangeError> {
        let field = "normal_over_tangential_stiffness";
        let allowed = "at least a hundredth of D_xx/D_zz, which is 3.5 for solid spheres";
        Groups::new(chi, psi).map_err(|error| match self.stiffness_ratio {
            Some(ratio) => RangeError::new(field, ratio, allowed),
            None => error,
        })
    }

    /// Derivatives of the velocity of body 2 against body 1 at the contact.
    fn velocity_by_inputs(&self) -> Rows {
        let z = self.frame().z();
        let mut by = Rows::zeros();
        for (i, sign) in [-1.0, 1.0].into_iter().enumerate() {
            let height = self.bodies[i].height().unwrap_or(0.0);
            let spin = self.bodies[i].motion().spin;
            let mut view = by.fixed_view_mut::<3, 3>(0, 6 * i);
            view.copy_from(&(Matrix3::identity() * sign));
            // spin x (sign height z), of this sign: both bodies have the same.
            let mut view = by.fixed_view_mut::<3, 3>(0, 6 * i + 3);
            view.copy_from(&(z.cross_matrix() * -height));
            if height > 0.0 {
                by.set_column(Input::Radius(i).column(), &spin.cross(&z));
            }
        }
        by
    }

    /// Derivatives of kappa = sum((1 - nu/2)/G)/sum((1 - nu)/G), unless it was given.
    fn stiffness_ratio_by_inputs(&self, kappa: f64) -> Row {
        let mut by = Row::zeros();
        by[Input::StiffnessRatio.column()] = 1.0;
        if self.stiffness_ratio.is_some() {
            return by;
        }
        let materials = self.bodies.each_ref().map(Body::material);
        let [across, along] = [0.5, 1.0].map(|part| {
            materials.map(|material| (1.0 - part * material.poisson()) / material.shear_modulus())
        });
        let [whole_across, whole_along] = [across, along].map(|parts| parts[0] + parts[1]);
        for (i, material) in materials.into_iter().enumerate().filter(|(_, body)| !body.is_rigid())
        {
            let (shear, own) = (material.shear_modulus(), 1.0 / material.shear_modulus());
            let by_shear = (along[i] / whole_along - across[i] / whole_across) / shear;
            by[Input::ShearModulus(i).column()] = kappa * by_shear;
            by[Input::Poisson(i).column()] = kappa * own * (1.0 / whole_along - 0.5 / whole_across);
        }
        by
    }
}
