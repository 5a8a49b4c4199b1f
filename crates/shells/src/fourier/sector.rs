//! Functions that are constant in sectors, with exact coefficients.

use std::f64::consts::{PI, TAU};

use carom_special::RangeError;

use super::ComplexSeries;
use carom_dense::c64;

/// A sector of the circle, the angles within `half_width` of `middle` in radians, and the factor
/// of a function in it.
///
/// ```
/// use carom_shells::fourier::Sector;
/// let hole = Sector::new(0.5, 0.1, 0.25)?;
/// assert!(hole.contains(0.41) && !hole.contains(0.39));
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sector {
    middle: f64,
    half_width: f64,
    factor: f64,
}

impl Sector {
    /// The sector about the angle `middle` with half width in (0, pi), where a function is `factor`
    /// times its value outside.
    ///
    /// # Errors
    /// [`RangeError`] unless `middle` is from -1000 to 1000, the half width in its range and the
    /// factor from 1e-6 to 1e6.
    pub fn new(middle: f64, half_width: f64, factor: f64) -> Result<Self, RangeError> {
        let fits = middle.abs() <= 1000.0;
        RangeError::check("middle", middle, fits, "an angle from -1000 to 1000")?;
        let fits = half_width > 0.0 && half_width < PI;
        RangeError::check("half_width", half_width, fits, "> 0 and < pi")?;
        let fits = (1e-6..=1e6).contains(&factor);
        RangeError::check("factor", factor, fits, "from 1e-6 to 1e6")?;
        Ok(Self { middle, half_width, factor })
    }

    /// The angle of its middle.
    #[must_use]
    pub const fn middle(&self) -> f64 {
        self.middle
    }

    /// Half of its angle.
    #[must_use]
    pub const fn half_width(&self) -> f64 {
        self.half_width
    }

    /// The factor in it.
    #[must_use]
    pub const fn factor(&self) -> f64 {
        self.factor
    }

    /// Whether the angle lies in the sector.
    #[must_use]
    pub fn contains(&self, angle: f64) -> bool {
        distance(angle, self.middle) <= self.half_width
    }

    /// Whether two sectors have a common part. Sectors that only touch, to rounding, have none.
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> bool {
        distance(self.middle, other.middle) < self.half_width + other.half_width - 1e-12
    }

    /// Coefficient k of the function that is 1 in the sector and 0 outside.
    fn coefficient(&self, k: i64) -> c64 {
        if k == 0 {
            return c64::new(self.half_width / PI, 0.0);
        }
        let k = k as f64;
        let size = libm::sin(k * self.half_width) / (k * PI);
        c64::new(size * libm::cos(k * self.middle), -size * libm::sin(k * self.middle))
    }
}

/// The distance of two angles around the circle.
fn distance(one: f64, other: f64) -> f64 {
    let away = (one - other).rem_euclid(TAU);
    away.min(TAU - away)
}

/// A positive function of the angle: a base value, multiplied by a factor in some sectors.
///
/// ```
/// use carom_shells::fourier::{PiecewiseConstant, Sector};
/// let hole = Sector::new(0.5, 0.1, 0.25)?;
/// let stiffness = PiecewiseConstant::new(2.0, &[hole])?;
/// assert_eq!(stiffness.at(0.55), 0.5);
/// assert_eq!(stiffness.at(0.7), 2.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PiecewiseConstant {
    base: f64,
    sectors: Vec<Sector>,
}

/// The most sectors of one function.
const MOST_SECTORS: usize = 1000;

impl PiecewiseConstant {
    /// The same value everywhere.
    ///
    /// # Errors
    /// [`RangeError`] unless it is finite and positive.
    pub fn uniform(base: f64) -> Result<Self, RangeError> {
        Ok(Self { base: RangeError::positive("base", base)?, sectors: Vec::new() })
    }

    /// The value `base`, multiplied in each sector by its factor. Sectors must not overlap.
    ///
    /// # Errors
    /// [`RangeError`] unless the base is positive, there are at most 1000 sectors, and none
    /// overlaps another (the value is the middle of the later one).
    pub fn new(base: f64, sectors: &[Sector]) -> Result<Self, RangeError> {
        let count = sectors.len();
        RangeError::check("sectors", count as f64, count <= MOST_SECTORS, "at most 1000")?;
        for (i, sector) in sectors.iter().enumerate() {
            let is_apart = sectors[..i].iter().all(|earlier| !sector.overlaps(earlier));
            let allowed = "so that no two sectors overlap";
            RangeError::check("middle", sector.middle, is_apart, allowed)?;
        }
        Ok(Self { sectors: sectors.to_vec(), ..Self::uniform(base)? })
    }

    /// The value outside the sectors.
    #[must_use]
    pub const fn base(&self) -> f64 {
        self.base
    }

    /// The value at an angle; at an edge that of the sector.
    #[must_use]
    pub fn at(&self, angle: f64) -> f64 {
        let sector = self.sectors.iter().find(|sector| sector.contains(angle));
        sector.map_or(self.base, |sector| self.base * sector.factor)
    }

    /// Whether the value is the same everywhere.
    #[must_use]
    pub fn is_uniform(&self) -> bool {
        self.sectors.iter().all(|sector| sector.factor == 1.0)
    }

    /// The exact coefficients of the function up to `order`.
    #[must_use]
    pub fn series(&self, order: usize) -> ComplexSeries {
        self.powered(order, self.base, |factor| factor)
    }

    /// The exact coefficients of the reciprocal function up to `order`.
    #[must_use]
    pub fn reciprocal_series(&self, order: usize) -> ComplexSeries {
        self.powered(order, 1.0 / self.base, |factor| 1.0 / factor)
    }

    fn powered(&self, order: usize, base: f64, of: impl Fn(f64) -> f64) -> ComplexSeries {
        let order = order as i64;
        let coefficient = |k: i64| -> c64 {
            let steps =
                self.sectors.iter().map(|sector| sector.coefficient(k) * (of(sector.factor) - 1.0));
            let constant = c64::new(if k == 0 { 1.0 } else { 0.0 }, 0.0);
            steps.fold(constant, |sum, step| sum + step) * base
        };
        ComplexSeries::from_coefficients((-order..=order).map(coefficient).collect())
    }
}
