//! The four stiffnesses of a ring's section.

use std::f64::consts::PI;

use carom_special::RangeError;

/// One of the four stiffnesses of a ring.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StiffnessKind {
    /// EA, against stretching.
    Stretching,
    /// EI, against bending in the plane of the ring.
    InPlane,
    /// EJ, against bending out of the plane.
    OutOfPlane,
    /// GJ, against torsion.
    Torsion,
}

impl StiffnessKind {
    /// All four, in the order of the strains.
    pub const ALL: [Self; 4] = [Self::Stretching, Self::InPlane, Self::OutOfPlane, Self::Torsion];
}

/// Stiffnesses of the section of a ring: stretching EA (force), bending EI in the plane of the
/// ring, bending EJ out of it and torsion GJ (force times length squared).
///
/// ```
/// use carom_shells::flange::RingStiffness;
/// let square = RingStiffness::rectangle(1.0, 0.25, 2.0, 2.0)?;
/// assert_eq!(square.stretching(), 4.0);
/// // Torsion constant of a square: 0.1406 times the fourth power of its side.
/// assert!((square.torsion() * 2.5 / 16.0 - 0.1406).abs() < 1e-4);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingStiffness {
    stretching: f64,
    in_plane: f64,
    out_of_plane: f64,
    torsion: f64,
}

impl RingStiffness {
    /// The section with these stiffnesses, all positive.
    ///
    /// # Errors
    /// [`RangeError`] for a value that is not finite and positive.
    pub fn new(
        stretching: f64,
        in_plane: f64,
        out_of_plane: f64,
        torsion: f64,
    ) -> Result<Self, RangeError> {
        Ok(Self {
            stretching: RangeError::positive("stretching", stretching)?,
            in_plane: RangeError::positive("in_plane", in_plane)?,
            out_of_plane: RangeError::positive("out_of_plane", out_of_plane)?,
            torsion: RangeError::positive("torsion", torsion)?,
        })
    }

    /// A rectangular section, `along` wide along the tube and `outward` high, of Young's modulus
    /// `young_modulus` and Poisson's ratio `poisson` in [0, 0.5]. The torsion constant is Saint
    /// Venant's series, for sides a >= b
    /// J = a b^3 (1/3 - 64 b/(pi^5 a) sum tanh((2k+1) pi a/(2b))/(2k+1)^5).
    ///
    /// # Errors
    /// [`RangeError`] for a value out of range, or sides with a ratio over 1000.
    pub fn rectangle(
        young_modulus: f64,
        poisson: f64,
        along: f64,
        outward: f64,
    ) -> Result<Self, RangeError> {
        let e = RangeError::positive("young_modulus", young_modulus)?;
        let fits = (0.0..=0.5).contains(&poisson);
        RangeError::check("poisson", poisson, fits, "from 0 to 0.5")?;
        let along = RangeError::positive("along", along)?;
        let outward = RangeError::positive("outward", outward)?;
        let ratio = along / outward;
        let fits = (1e-3..=1e3).contains(&ratio);
        RangeError::check("along/outward", ratio, fits, "from 0.001 to 1000")?;
        let (long, short) = (along.max(outward), along.min(outward));
        let shear = 0.5 * e / (1.0 + poisson);
        Self::new(
            e * along * outward,
            e * along * outward * outward * outward / 12.0,
            e * outward * along * along * along / 12.0,
            shear * long * short * short * short * torsion_factor(long / short),
        )
    }

    /// EA.
    #[must_use]
    pub const fn stretching(&self) -> f64 {
        self.stretching
    }

    /// EI, in the plane of the ring.
    #[must_use]
    pub const fn in_plane(&self) -> f64 {
        self.in_plane
    }

    /// EJ, out of the plane of the ring.
    #[must_use]
    pub const fn out_of_plane(&self) -> f64 {
        self.out_of_plane
    }

    /// GJ.
    #[must_use]
    pub const fn torsion(&self) -> f64 {
        self.torsion
    }

    /// The stiffness of this kind.
    #[must_use]
    pub const fn of(&self, kind: StiffnessKind) -> f64 {
        match kind {
            StiffnessKind::Stretching => self.stretching,
            StiffnessKind::InPlane => self.in_plane,
            StiffnessKind::OutOfPlane => self.out_of_plane,
            StiffnessKind::Torsion => self.torsion,
        }
    }
}

/// J/(a b^3) of a rectangle with sides a = `ratio` b >= b.
fn torsion_factor(ratio: f64) -> f64 {
    let term = |k: i32| {
        let odd = f64::from(2 * k + 1);
        libm::tanh(0.5 * odd * PI * ratio) / (odd * odd * odd * odd * odd)
    };
    // Term k is below (2k)^-5: 600 terms give 15 digits.
    let sum: f64 = (0..600).rev().map(term).sum();
    let fifth = PI * PI * PI * PI * PI;
    1.0 / 3.0 - 64.0 / (fifth * ratio) * sum
}
