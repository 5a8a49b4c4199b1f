//! Mobility and stiffness of two spheres and of equal cylinders that cross, (9.48) and (9.49).

use carom_geometry::Inertia;
use carom_halfspace::Material;
use carom_special::RangeError;

/// Mobilities and stiffnesses of an impact with uncoupled directions.
///
/// The mobilities D_xx, D_yy, D_zz have the unit 1/mass; the stiffnesses are those of
/// F_z = (2/3) c_z zeta^(3/2) and dF_x = c_x sqrt(zeta) dxi; c_y = c_x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImpactConstants {
    /// D_xx.
    pub d_xx: f64,
    /// D_yy.
    pub d_yy: f64,
    /// D_zz.
    pub d_zz: f64,
    /// c_x = c_y.
    pub c_x: f64,
    /// c_z.
    pub c_z: f64,
}

impl ImpactConstants {
    /// Two solid spheres of these masses, radii and materials (9.49). A body of infinite mass is
    /// unaffected by the impact; an infinite radius is a plane.
    ///
    /// D_xx = D_yy = (7/2)(1/m1 + 1/m2), c_x = 8/(sqrt(1/R1 + 1/R2) sum (2 - nu)/G),
    /// c_z = 4/(sqrt(1/R1 + 1/R2) sum (1 - nu)/G).
    ///
    /// ```
    /// use carom_halfspace::Material;
    /// use carom_impact::closed_form::ImpactConstants;
    /// let rubber = Material::from_shear(1e6, 0.5)?;
    /// let constants = ImpactConstants::of_spheres([1.0, 1.0], [0.02, 0.02], [rubber, rubber])?;
    /// // chi = 7/(2 kappa) with kappa = 3/2.
    /// let chi = constants.d_xx * constants.c_x / (constants.d_zz * constants.c_z);
    /// assert!((chi - 7.0 / 3.0).abs() < 1e-15);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] unless masses and radii are positive and neither both infinite, and one of
    /// the materials yields.
    pub fn of_spheres(
        masses: [f64; 2],
        radii: [f64; 2],
        materials: [Material; 2],
    ) -> Result<Self, RangeError> {
        for (mass, radius) in masses.into_iter().zip(radii) {
            RangeError::check("mass", mass, mass > 0.0, "positive")?;
            RangeError::check("radius", radius, radius > 0.0, "positive")?;
        }
        let d_zz = 1.0 / masses[0] + 1.0 / masses[1];
        RangeError::positive("inverse reduced mass", d_zz)?;
        let curvature = 1.0 / radii[0] + 1.0 / radii[1];
        RangeError::positive("relative curvature", curvature)?;
        Self::new([3.5 * d_zz, 3.5 * d_zz, d_zz], 1.0 / curvature.sqrt(), materials)
    }

    /// Two cylinders of this radius that cross at right angles, touching midway between their ends
    /// (9.48), corrected: D_xx takes the moments about y, D_yy those about x, and the stiffnesses
    /// are those of a sphere of the same radius on a plane, sqrt 2 times the printed ones.
    ///
    /// The moments of the inertias are those about the contact axes x, y, z.
    ///
    /// D_xx = R^2/theta_1Y + R^2/theta_2Y + 1/m1 + 1/m2, c_x = 8 sqrt(R)/sum (2 - nu)/G,
    /// c_z = 4 sqrt(R)/sum (1 - nu)/G.
    ///
    /// ```
    /// use carom_halfspace::Material;
    /// use carom_geometry::Inertia;
    /// use carom_impact::closed_form::ImpactConstants;
    /// let steel = Material::from_shear(8e10, 0.28)?;
    /// // Body 1 lies along x, body 2 along y.
    /// let bodies = [Inertia::new(1.0, [0.5, 2.0, 2.0])?, Inertia::new(1.0, [2.0, 0.5, 2.0])?];
    /// let constants = ImpactConstants::of_crossed_cylinders(bodies, 1.0, [steel, steel])?;
    /// assert_eq!((constants.d_xx, constants.d_yy), (4.5, 4.5));
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] unless the radius is finite and positive, one of the bodies moves and one of
    /// the materials yields.
    pub fn of_crossed_cylinders(
        inertias: [Inertia; 2],
        radius: f64,
        materials: [Material; 2],
    ) -> Result<Self, RangeError> {
        RangeError::positive("radius", radius)?;
        let sum = |part: fn(&Inertia) -> f64| part(&inertias[0]) + part(&inertias[1]);
        let d_zz = sum(Inertia::inverse_mass);
        RangeError::positive("inverse reduced mass", d_zz)?;
        let squared = radius * radius;
        let d_xx = squared * sum(|inertia| inertia.inverse_moments().y) + d_zz;
        let d_yy = squared * sum(|inertia| inertia.inverse_moments().x) + d_zz;
        Self::new([d_xx, d_yy, d_zz], radius.sqrt(), materials)
    }

    fn new(
        [d_xx, d_yy, d_zz]: [f64; 3],
        root_radius: f64,
        materials: [Material; 2],
    ) -> Result<Self, RangeError> {
        let sum = |share: fn(f64) -> f64| -> f64 {
            materials.iter().map(|m| share(m.poisson()) / m.shear_modulus()).sum()
        };
        let (normal, tangential) = (sum(|nu| 1.0 - nu), sum(|nu| 2.0 - nu));
        RangeError::positive("compliance", normal)?;
        let (c_x, c_z) = (8.0 * root_radius / tangential, 4.0 * root_radius / normal);
        RangeError::positive("c_z", c_z)?;
        Ok(Self { d_xx, d_yy, d_zz, c_x, c_z })
    }
}
