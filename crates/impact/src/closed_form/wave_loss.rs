//! The share of kinetic energy radiated by elastic waves, (3.2).
//!
//! A normal force F(t) on a half-space radiates `I/(2 pi rho c_T^3) int F'(t)^2 dt`: I is the
//! imaginary part of Lamb's integral for the displacement under the force, from compressional
//! waves, shear waves and the Rayleigh pole. With the exact Hertz pulse of a sphere on a
//! half-space of its own material the share becomes `C(nu) (v/c_0)^(3/5)`, c_0 = sqrt(E/rho).

use carom_halfspace::Material;
use carom_special::RangeError;
use carom_special::gamma::gamma;
use carom_special::quadrature::FixedRule;
use carom_special::roots::bisect;

/// The coefficient C(nu) of the share of energy radiated, with the exact pulse and all waves.
///
/// ```
/// use carom_impact::closed_form::wave_loss_coefficient;
/// assert!((wave_loss_coefficient(0.25)? - 1.111_532_4).abs() < 1e-7); // printed: 1.04
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] unless Poisson's ratio is in [0, 1/2].
pub fn wave_loss_coefficient(poisson: f64) -> Result<f64, RangeError> {
    RangeError::check("poisson", poisson, (0.0..=0.5).contains(&poisson), "in [0, 1/2]")?;
    let pulse = pulse_integral();
    let sphere = libm::pow(4.0 * std::f64::consts::PI / 3.0, -0.2)
        * libm::pow(8.0 / (15.0 * (1.0 - poisson * poisson)), 1.2);
    let shear = libm::pow(2.0 * (1.0 + poisson), 1.5);
    let share = 25.0 / (16.0 * std::f64::consts::PI);
    Ok(share * radiation(poisson)? * pulse * sphere * shear)
}

/// The share of kinetic energy radiated by a sphere that hits a half-space of its own material with
/// `velocity`; `rod_speed` = sqrt(E/rho) is the speed of compressional waves in rods.
///
/// # Errors
/// [`RangeError`] unless Poisson's ratio is in [0, 1/2] and both speeds are positive.
pub fn wave_loss(poisson: f64, velocity: f64, rod_speed: f64) -> Result<f64, RangeError> {
    RangeError::positive("velocity", velocity)?;
    RangeError::positive("rod speed", rod_speed)?;
    Ok(wave_loss_coefficient(poisson)? * libm::pow(velocity / rod_speed, 0.6))
}

/// How strongly a half-space of this material radiates: a Hertz pulse of the maximum force F and the time unit
/// t = zeta_max/v radiates the energy k sqrt(density) F^2/t. This is k, in (m^2/N)^(3/2); 0 for a rigid body.
///
/// It is `I/(2 pi G^(3/2)) int F'(t)^2 dt t/F^2`. See [`NormalImpact::wave_share`](crate::normal::NormalImpact::wave_share).
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::closed_form::radiation_coefficient;
/// let [steel, rubber] = [Material::from_young(208e9, 0.3)?, Material::from_young(208e5, 0.3)?];
/// let ratio = radiation_coefficient(rubber)? / radiation_coefficient(steel)?;
/// assert!((ratio - 1e6).abs() < 1e-3);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] if the integral over the half-space is not finite.
pub fn radiation_coefficient(material: Material) -> Result<f64, RangeError> {
    if material.is_rigid() {
        return Ok(0.0);
    }
    let shear = material.shear_modulus();
    let wave = radiation(material.poisson())? * pulse_integral();
    RangeError::finite("radiation", wave / (2.0 * std::f64::consts::PI * shear * shear.sqrt()))
}

// int (d zeta^(3/2)/dt)^2 dt = (9/5) B(4/5, 3/2)
fn pulse_integral() -> f64 {
    1.8 * gamma(0.8) * gamma(1.5) / gamma(2.3)
}

static RULE: FixedRule<160> = FixedRule::fixed();

// I: minus the imaginary part of int q a/R dq, a = sqrt(q^2 - h^2), b = sqrt(q^2 - 1),
// R = (2 q^2 - 1)^2 - 4 q^2 a b, q in units of the shear wave number, h = c_T/c_L.
fn radiation(poisson: f64) -> Result<f64, RangeError> {
    let h2 = (1.0 - 2.0 * poisson) / (2.0 * (1.0 - poisson));
    let h = h2.sqrt();
    let right = 0.5 * std::f64::consts::PI;
    // q = h sin t and q^2 = h^2 + (1 - h^2) sin^2 t remove the roots at the ends.
    let compressional = RULE.integrate(0.0, right, |t| {
        let (sin, cos) = (libm::sin(t), libm::cos(t));
        let q2 = h2 * sin * sin;
        let a = h * cos;
        let square = (2.0 * q2 - 1.0) * (2.0 * q2 - 1.0);
        h * sin * a / (square + 4.0 * q2 * a * (1.0 - q2).sqrt()) * a
    });
    let shear = RULE.integrate(0.0, right, |t| {
        let (sin, cos) = (libm::sin(t), libm::cos(t));
        let width = 1.0 - h2;
        let q2 = h2 + width * sin * sin;
        let (a2, b2) = (width * sin * sin, width * cos * cos);
        let square = (2.0 * q2 - 1.0) * (2.0 * q2 - 1.0);
        let density = 4.0 * q2 * a2 * b2.sqrt() / (square * square + 16.0 * q2 * q2 * a2 * b2);
        density * width * sin * cos
    });
    Ok(compressional + shear + rayleigh(h2))
}

// pi times the residue at the Rayleigh pole.
fn rayleigh(h2: f64) -> f64 {
    let function = |p: f64| {
        let root = ((p - h2) * (p - 1.0)).sqrt();
        (2.0 * p - 1.0) * (2.0 * p - 1.0) - 4.0 * p * root
    };
    // p = q^2 from 1, where R > 0, to 4/3 at nu = 0 and less beyond: bisection.
    let [low, high] = bisect([1.0, 1.5], 60, |p| function(p) > 0.0);
    let p = 0.5 * (low + high);
    let (a, b) = ((p - h2).sqrt(), (p - 1.0).sqrt());
    // dR/dp; dR/dq = 2 q dR/dp
    let slope = 4.0 * (2.0 * p - 1.0) - 4.0 * a * b - 2.0 * p * (b / a + a / b);
    std::f64::consts::PI * a / (2.0 * slope.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_by_poissons_ratio() {
        // Quadrature of Lamb's integral with 20 digits.
        let values = [
            (0.0, 1.063_185_194_700_64),
            (0.1, 1.076_684_633_434_43),
            (0.2, 1.096_645_900_661_09),
            (0.25, 1.111_532_436_869_86),
            (0.3, 1.131_809_722_782_67),
            (0.4, 1.199_782_833_672_59),
            (0.49, 1.324_550_713_490_96),
            (0.5, 1.346_272_762_050_56),
        ];
        for (poisson, expected) in values {
            let own = wave_loss_coefficient(poisson).unwrap();
            assert!((own / expected - 1.0).abs() < 1e-12, "{poisson} {own}");
        }
        assert!(wave_loss_coefficient(0.51).is_err());
    }

    #[test]
    fn rayleigh_waves_carry_two_thirds() {
        // Miller and Pursey: 67.4 % at nu = 1/4.
        let share = rayleigh(1.0 / 3.0) / radiation(0.25).unwrap();
        assert!((share - 0.673_618_166_043).abs() < 1e-11, "{share}");
    }

    #[test]
    fn steel_at_one_metre_per_second() {
        let steel = (208e9_f64 / 7850.0).sqrt();
        let loss = wave_loss(0.3, 1.0, steel).unwrap();
        assert!((0.006..0.007).contains(&loss), "{loss}");
    }
}
