//! Elastic materials and the combined moduli of a pair.
//!
//! Two half-spaces in contact behave like one with combined constants, apart from a coupling of normal and
//! tangential displacements. [`MaterialPair`] holds these constants: 1/G and nu/G (4.7), the coupling epsilon
//! (5.20) and gamma (15.2), and kappa (15.1). It is made once from two [`Material`]s; contact laws and grids take
//! the pair. A rigid body is a material as well, [`Material::RIGID`].

use carom_special::RangeError;

const POISSON_RANGE: &str = "in (-1, 0.5]";
/// Hardness over yield stress: a contact that flows fully carries a mean pressure of about 2.8 Y.
const HARDNESS_OVER_YIELD: f64 = 2.8;

/// An isotropic linear elastic material, or a rigid one.
///
/// Built from Young's modulus or the shear modulus, with Poisson's ratio in (-1, 0.5].
///
/// ```
/// use carom_halfspace::Material;
/// let steel = Material::from_young(208e9, 0.3)?;
/// assert_eq!(steel.shear_modulus(), 80e9);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    shear_modulus: f64,
    poisson: f64,
    /// Infinite if the material does not yield.
    yield_stress: f64,
}

impl Material {
    /// A rigid body: infinite moduli.
    pub const RIGID: Self =
        Self { shear_modulus: f64::INFINITY, poisson: 0.0, yield_stress: f64::INFINITY };

    /// From the shear modulus G (force/area) and Poisson's ratio.
    ///
    /// # Errors
    /// [`RangeError`] unless G is finite and positive and nu lies in (-1, 0.5].
    pub fn from_shear(shear_modulus: f64, poisson: f64) -> Result<Self, RangeError> {
        RangeError::positive("shear_modulus", shear_modulus)?;
        check_poisson(poisson)?;
        Ok(Self { shear_modulus, poisson, yield_stress: f64::INFINITY })
    }

    /// From Young's modulus E (force/area) and Poisson's ratio: G = E / (2 (1 + nu)).
    ///
    /// # Errors
    /// [`RangeError`] unless E is finite and positive and nu lies in (-1, 0.5].
    pub fn from_young(young_modulus: f64, poisson: f64) -> Result<Self, RangeError> {
        RangeError::positive("young_modulus", young_modulus)?;
        check_poisson(poisson)?;
        let shear_modulus = young_modulus / (2.0 * (1.0 + poisson));
        RangeError::positive("shear_modulus", shear_modulus)?;
        Ok(Self { shear_modulus, poisson, yield_stress: f64::INFINITY })
    }

    /// The same material, which yields in simple tension at this stress Y. It stays elastic in all
    /// computations; Y only tells where they leave the theory.
    ///
    /// # Errors
    /// [`RangeError`] unless Y is positive; infinite: it does not yield.
    pub fn yielding_at(self, yield_stress: f64) -> Result<Self, RangeError> {
        RangeError::check("yield_stress", yield_stress, yield_stress > 0.0, "> 0")?;
        Ok(Self { yield_stress, ..self })
    }

    /// The same material with this hardness H, a pressure (Vickers or Brinell): it yields at Y = H/2.8.
    ///
    /// ```
    /// use carom_halfspace::Material;
    /// let steel = Material::from_young(208e9, 0.3)?.with_hardness(2.8e9)?;
    /// assert!((steel.yield_stress() / 1e9 - 1.0).abs() < 1e-15);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] unless H is positive; infinite: it does not yield.
    pub fn with_hardness(self, hardness: f64) -> Result<Self, RangeError> {
        RangeError::check("hardness", hardness, hardness > 0.0, "> 0")?;
        Ok(Self { yield_stress: hardness / HARDNESS_OVER_YIELD, ..self })
    }

    /// The yield stress Y in simple tension; infinite if it is not known or the material does not yield.
    #[must_use]
    pub const fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    /// The shear modulus G; infinite for a rigid body.
    #[must_use]
    pub const fn shear_modulus(&self) -> f64 {
        self.shear_modulus
    }

    /// Poisson's ratio nu; of no meaning (and zero) for a rigid body.
    #[must_use]
    pub const fn poisson(&self) -> f64 {
        self.poisson
    }

    /// Young's modulus E = 2 G (1 + nu); infinite for a rigid body.
    #[must_use]
    pub fn young_modulus(&self) -> f64 {
        2.0 * self.shear_modulus * (1.0 + self.poisson)
    }

    /// Whether the body does not deform.
    #[must_use]
    pub fn is_rigid(&self) -> bool {
        self.shear_modulus.is_infinite()
    }
}

fn check_poisson(poisson: f64) -> Result<f64, RangeError> {
    RangeError::check("poisson", poisson, poisson > -1.0 && poisson <= 0.5, POISSON_RANGE)
}

/// The combined elastic constants of two bodies in contact.
///
/// `1/G = 1/G1 + 1/G2` and `nu/G = nu1/G1 + nu2/G2` (4.7): for two equal bodies G is half of
/// one body's. From them epsilon (5.20), which couples normal and tangential displacements,
/// its dimensionless form gamma (15.2) and the stiffness ratio of spheres kappa (15.1).
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// let steel = Material::from_shear(80e9, 0.3)?;
/// let pair = MaterialPair::new(steel, steel)?;
/// assert_eq!(pair.shear_modulus(), 40e9);
/// assert_eq!(pair.gamma(), 0.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MaterialPair {
    body_1: Material,
    body_2: Material,
    shear_modulus: f64,
    poisson: f64,
    epsilon: f64,
    gamma: f64,
}

impl MaterialPair {
    /// The pair of two materials; z points into body 1.
    ///
    /// # Errors
    /// [`RangeError`] if both bodies are rigid, or if the combined modulus overflows.
    pub fn new(body_1: Material, body_2: Material) -> Result<Self, RangeError> {
        let (c1, c2) = (1.0 / body_1.shear_modulus, 1.0 / body_2.shear_modulus);
        let compliance = c1 + c2;
        if compliance == 0.0 {
            return Err(RangeError::new(
                "shear_modulus",
                f64::INFINITY,
                "finite for at least one of the two bodies: both are rigid, give one `young_modulus` and `poisson`",
            ));
        }
        let shear_modulus = 1.0 / compliance; // (4.7)
        RangeError::positive("combined shear_modulus", shear_modulus)?;
        let (nu1, nu2) = (body_1.poisson, body_2.poisson);
        let poisson = (nu1 * c1 + nu2 * c2) * shear_modulus; // (4.7)
        let epsilon = 0.5 * ((1.0 - 2.0 * nu1) * c1 - (1.0 - 2.0 * nu2) * c2); // (5.20)
        let gamma = epsilon * shear_modulus / (1.0 - poisson); // (15.2)
        Ok(Self { body_1, body_2, shear_modulus, poisson, epsilon, gamma })
    }

    /// The material of body 1.
    #[must_use]
    pub const fn body_1(&self) -> Material {
        self.body_1
    }

    /// The material of body 2.
    #[must_use]
    pub const fn body_2(&self) -> Material {
        self.body_2
    }

    /// The combined shear modulus G of (4.7).
    #[must_use]
    pub const fn shear_modulus(&self) -> f64 {
        self.shear_modulus
    }

    /// The combined Poisson's ratio nu of (4.7), weighted by the compliances 1/G.
    #[must_use]
    pub const fn poisson(&self) -> f64 {
        self.poisson
    }

    /// epsilon = (1 - 2 nu1)/(2 G1) - (1 - 2 nu2)/(2 G2) (5.20), in 1/modulus.
    ///
    /// The analytic laws are exact for epsilon = 0.
    #[must_use]
    pub const fn epsilon(&self) -> f64 {
        self.epsilon
    }

    /// gamma (15.2) in [-1/2, 1/2] for nu >= 0: epsilon over (1 - nu)/G.
    #[must_use]
    pub const fn gamma(&self) -> f64 {
        self.gamma
    }

    /// kappa (15.1), c_z/c_x of a circular contact: (2 - nu)/(2 (1 - nu)), 1 to 1.5 for nu >= 0.
    #[must_use]
    pub fn kappa(&self) -> f64 {
        (2.0 - self.poisson) / (2.0 * (1.0 - self.poisson))
    }

    /// E* of Hertz: `1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2`, in Pa; `2 G/(1 - nu)` of the pair (4.7).
    #[must_use]
    pub fn contact_modulus(&self) -> f64 {
        2.0 * self.shear_modulus / (1.0 - self.poisson)
    }

    /// The smaller yield stress of the two: both bodies bear the same pressure.
    #[must_use]
    pub fn yield_stress(&self) -> f64 {
        self.body_1.yield_stress.min(self.body_2.yield_stress)
    }

    /// Whether normal and tangential displacements are uncoupled (epsilon = 0).
    #[must_use]
    pub fn is_uncoupled(&self) -> bool {
        self.epsilon == 0.0
    }

    /// The same pair with the bodies exchanged.
    #[must_use]
    pub fn exchanged(&self) -> Self {
        Self {
            body_1: self.body_2,
            body_2: self.body_1,
            epsilon: -self.epsilon,
            gamma: -self.gamma,
            ..*self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn combined_constants_of_equal_bodies() {
        let body = Material::from_shear(82_000.0, 0.25).unwrap();
        let pair = MaterialPair::new(body, body).unwrap();
        assert_eq!(pair.shear_modulus(), 41_000.0);
        assert_eq!(pair.poisson(), 0.25);
        assert!(pair.is_uncoupled());
    }

    #[test]
    fn dissimilar_example_of_chapter_15() {
        // nu1 = 0, nu2 = 1/2, equal G: kappa = 7/6, gamma = 1/3.
        let one = Material::from_shear(1.0, 0.0).unwrap();
        let two = Material::from_shear(1.0, 0.5).unwrap();
        let pair = MaterialPair::new(one, two).unwrap();
        approx::assert_relative_eq!(pair.kappa(), 7.0 / 6.0, max_relative = 1e-15);
        approx::assert_relative_eq!(pair.gamma(), 1.0 / 3.0, max_relative = 1e-15);
        approx::assert_relative_eq!(pair.exchanged().gamma(), -1.0 / 3.0, max_relative = 1e-15);
    }

    #[test]
    fn rigid_partner_is_the_limit_of_a_stiff_one() {
        let soft = Material::from_young(1e6, 0.45).unwrap();
        let stiff = Material::from_young(1e30, 0.2).unwrap();
        let limit = MaterialPair::new(soft, stiff).unwrap();
        let rigid = MaterialPair::new(soft, Material::RIGID).unwrap();
        approx::assert_relative_eq!(rigid.gamma(), limit.gamma(), max_relative = 1e-12);
        approx::assert_relative_eq!(rigid.kappa(), limit.kappa(), max_relative = 1e-12);
    }

    #[test]
    fn bad_materials_are_named() {
        for nu in [-1.0, 0.51, f64::NAN, f64::INFINITY] {
            assert_eq!(Material::from_young(1.0, nu).unwrap_err().field, "poisson");
        }
        for e in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(Material::from_young(e, 0.3).unwrap_err().field, "young_modulus");
            assert_eq!(Material::from_shear(e, 0.3).unwrap_err().field, "shear_modulus");
        }
        assert!(MaterialPair::new(Material::RIGID, Material::RIGID).is_err());
    }

    #[test]
    fn a_pair_yields_where_its_weaker_body_does() {
        let steel = Material::from_young(208e9, 0.3).unwrap();
        assert_eq!(steel.yield_stress(), f64::INFINITY);
        let (soft, hard) = (steel.yielding_at(3e8).unwrap(), steel.with_hardness(8.4e9).unwrap());
        approx::assert_relative_eq!(hard.yield_stress(), 3e9, max_relative = 1e-15);
        assert_eq!(MaterialPair::new(soft, hard).unwrap().yield_stress(), 3e8);
        assert_eq!(MaterialPair::new(hard, steel).unwrap().yield_stress(), hard.yield_stress());
        for bad in [0.0, -1.0, f64::NAN] {
            assert_eq!(steel.yielding_at(bad).unwrap_err().field, "yield_stress");
            assert_eq!(steel.with_hardness(bad).unwrap_err().field, "hardness");
        }
    }

    #[test]
    fn exchanged_bodies_are_the_pair_in_the_other_order() {
        let one = Material::from_shear(2.0, 0.1).unwrap();
        let two = Material::from_shear(5.0, 0.4).unwrap();
        let (pair, other) =
            (MaterialPair::new(one, two).unwrap(), MaterialPair::new(two, one).unwrap());
        assert_eq!(pair.exchanged().body_1(), two);
        approx::assert_relative_eq!(pair.exchanged().epsilon(), other.epsilon());
        approx::assert_relative_eq!(pair.exchanged().gamma(), other.gamma());
    }
}
