//! Compression in complete adhesion as hypergeometric functions of S = (zeta/zeta_max)^(5/2)
//! (section 9.2).

use carom_special::gamma::reciprocal as reciprocal_gamma;
use carom_special::hypergeometric::{Gauss, HypergeometricError, ThreeFTwo, UnitArgument};

use super::phi;

/// Time to reach S in compression (9.8), in units of zeta_max/zeta'_A.
///
/// t = S^(2/5) F(1/2, 2/5; 7/5; S), from the other end T/2 - (4/5) sqrt(1 - S) F(1/2, 3/5; 3/2; 1 - S).
///
/// ```
/// use carom_impact::{closed_form::compression_time, normal::DURATION};
/// use carom_special::hypergeometric::UnitArgument;
/// assert!((compression_time(UnitArgument::ONE)? - DURATION / 2.0).abs() < 1e-15);
/// # Ok::<(), carom_special::hypergeometric::HypergeometricError>(())
/// ```
///
/// # Errors
/// [`HypergeometricError`]: not seen for arguments in [0, 1].
pub fn compression_time(s: UnitArgument) -> Result<f64, HypergeometricError> {
    let (x, y) = (s.value(), s.complement());
    if x < 0.5 {
        return Ok(libm::pow(x, 0.4) * Gauss::new(0.5, 0.4, 1.4)?.at(s)?);
    }
    let rest = Gauss::new(0.5, 0.6, 1.5)?.at(UnitArgument::from_complement(x)?)?;
    Ok(0.5 * crate::normal::DURATION - 0.8 * y.sqrt() * rest)
}

/// Compression in complete adhesion from first contact: tangential velocity and shift in closed
/// form.
///
/// Units: the velocity by its initial value, the shift by that times zeta_max/zeta'_A. Valid while
/// nothing slips: |v| psi below sqrt(1 - S).
///
/// ```
/// use carom_impact::closed_form::AdhesiveCompression;
/// use carom_special::hypergeometric::UnitArgument;
/// // chi = 1: the shift follows the compression (9.28), the velocity sqrt(1 - S).
/// let motion = AdhesiveCompression::new(1.0)?;
/// let s = UnitArgument::new(0.3)?;
/// assert!((motion.shift(s)? - 0.3_f64.powf(0.4)).abs() < 1e-15);
/// assert!((motion.velocity(s)? - 0.7_f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), carom_special::hypergeometric::HypergeometricError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct AdhesiveCompression {
    chi: f64,
    velocity: Gauss,
    shift: ThreeFTwo,
}

impl AdhesiveCompression {
    /// The motion for chi = D_xx c_x/(D_zz c_z).
    ///
    /// # Errors
    /// [`HypergeometricError`] if chi is not positive or above about 66.
    pub fn new(chi: f64) -> Result<Self, HypergeometricError> {
        carom_special::RangeError::positive("chi", chi)?;
        let phi = phi(chi);
        // b_2 = 1, b_4 = 0 (9.27)
        let velocity = Gauss::new((1.0 - phi) / 20.0, (1.0 + phi) / 20.0, 0.6)?;
        let shift = ThreeFTwo::new(0.4, (11.0 - phi) / 20.0, (11.0 + phi) / 20.0, 0.6)?;
        Ok(Self { chi, velocity, shift })
    }

    /// Tangential velocity (9.16): F((1 - phi)/20, (1 + phi)/20; 3/5; S).
    ///
    /// # Errors
    /// [`HypergeometricError`] if cancellation costs too many digits.
    pub fn velocity(&self, s: UnitArgument) -> Result<f64, HypergeometricError> {
        self.velocity.at(s)
    }

    /// Tangential shift (9.21): S^(2/5) 3F2(2/5, (11 - phi)/20, (11 + phi)/20; 7/5, 3/5; S).
    ///
    /// # Errors
    /// [`HypergeometricError`] if cancellation costs too many digits.
    pub fn shift(&self, s: UnitArgument) -> Result<f64, HypergeometricError> {
        Ok(libm::pow(s.value(), 0.4) * self.shift.at(s)?)
    }

    /// Tangential shift by `terms` terms of each of the two series about S = 1, (9.23) to (9.25).
    ///
    /// At S = 1/2, 25 terms give 1e-10 and 40 terms full accuracy.
    ///
    /// # Errors
    /// [`HypergeometricError`] as [`AdhesiveCompression::shift`] at S = 1.
    pub fn shift_by_series(
        &self,
        s: UnitArgument,
        terms: usize,
    ) -> Result<f64, HypergeometricError> {
        const GAMMA_3_5: f64 = 1.489_192_248_812_817_1;
        let root_pi = std::f64::consts::PI.sqrt();
        let phi = phi(self.chi);
        // (9.18): c - a = (11 + phi)/20, c - b = (11 - phi)/20, c - a - b = 1/2
        let low = (120.0 - 120.0 * self.chi) / (20.0 * (11.0 + phi));
        let b_2 =
            GAMMA_3_5 * root_pi * reciprocal_gamma(low) * reciprocal_gamma((11.0 + phi) / 20.0);
        let twice_b_4 = -2.0
            * root_pi
            * GAMMA_3_5
            * reciprocal_gamma((1.0 - phi) / 20.0)
            * reciprocal_gamma((1.0 + phi) / 20.0);
        let y = s.complement();
        let whole = self.series(0.0, [self.shift(UnitArgument::ONE)?, -0.4 * twice_b_4], y, terms);
        let half = self.series(-0.5, [0.0, -0.8 * b_2], y, terms);
        Ok(whole + half)
    }

    // sum over n of c_{n,x} y^(n + x) by the recursion (9.25).
    fn series(&self, x: f64, start: [f64; 2], y: f64, terms: usize) -> f64 {
        let [mut c, mut next] = start;
        let load = 0.3 * self.chi;
        let mut power = if x == 0.0 { 1.0 } else { y.sqrt() / y.max(f64::MIN_POSITIVE) };
        let mut sum = 0.0;
        for n in 0..terms {
            sum += if c == 0.0 { 0.0 } else { c * power };
            power *= y;
            let m = n as f64 + x;
            let first =
                m * ((m - 1.0) * (-m - 1.3) - 1.32 + load) / ((m + 2.0) * (m + 1.0) * (m + 1.5));
            let second = (m * (2.0 * m + 2.8) + 1.2 - load) / ((m + 2.0) * (m + 1.5));
            (c, next) = (next, c * first + next * second);
        }
        sum
    }
}
