//! The amplitude of an incomplete elliptic integral.

use crate::RangeError;

/// An angle from 0 to pi/2, stored as sine and cosine so that both ends of the range are exact.
///
/// ```
/// use carom_special::elliptic::Amplitude;
/// let amplitude = Amplitude::from_cosine(1e-20)?;
/// assert_eq!((amplitude.sine(), amplitude.cosine()), (1.0, 1e-20));
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Amplitude {
    sine: f64,
    cosine: f64,
}

impl Amplitude {
    /// The right angle: the complete integral.
    pub const RIGHT: Self = Self { sine: 1.0, cosine: 0.0 };

    /// The angle `phi` in radians. Near pi/2 prefer [`Self::from_cosine`].
    ///
    /// # Errors
    /// [`RangeError`] unless `phi` is from 0 to pi/2.
    pub fn from_angle(phi: f64) -> Result<Self, RangeError> {
        let holds = (0.0..=std::f64::consts::FRAC_PI_2).contains(&phi);
        RangeError::check("phi", phi, holds, "from 0 to pi/2")?;
        let (sine, cosine) = libm::sincos(phi);
        Ok(Self { sine, cosine })
    }

    /// The angle of cosine `cosine`. Near 0 prefer [`Self::from_sine`].
    ///
    /// # Errors
    /// [`RangeError`] unless `cosine` is from 0 to 1.
    pub fn from_cosine(cosine: f64) -> Result<Self, RangeError> {
        RangeError::check("cosine", cosine, (0.0..=1.0).contains(&cosine), "from 0 to 1")?;
        Ok(Self { sine: ((1.0 - cosine) * (1.0 + cosine)).sqrt(), cosine })
    }

    /// The angle of sine `sine`. Near pi/2 prefer [`Self::from_cosine`].
    ///
    /// # Errors
    /// [`RangeError`] unless `sine` is from 0 to 1.
    pub fn from_sine(sine: f64) -> Result<Self, RangeError> {
        RangeError::check("sine", sine, (0.0..=1.0).contains(&sine), "from 0 to 1")?;
        Ok(Self { sine, cosine: ((1.0 - sine) * (1.0 + sine)).sqrt() })
    }

    /// The angle of tangent `opposite / adjacent`, exact at both ends.
    ///
    /// # Errors
    /// [`RangeError`] unless both are finite and not negative and one is positive.
    pub fn from_legs(opposite: f64, adjacent: f64) -> Result<Self, RangeError> {
        RangeError::non_negative("opposite", opposite)?;
        RangeError::non_negative("adjacent", adjacent)?;
        let larger = opposite.max(adjacent);
        RangeError::check("adjacent", adjacent, larger > 0.0, "> 0 if opposite is 0")?;
        let (s, c) = (opposite / larger, adjacent / larger);
        let hypotenuse = (s * s + c * c).sqrt();
        Ok(Self { sine: s / hypotenuse, cosine: c / hypotenuse })
    }

    /// The sine.
    #[must_use]
    pub const fn sine(self) -> f64 {
        self.sine
    }

    /// The cosine.
    #[must_use]
    pub const fn cosine(self) -> f64 {
        self.cosine
    }
}
