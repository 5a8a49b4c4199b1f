//! The nine load-displacement coefficients (4.14) of a rectangle on two bodies in contact.

use std::f64::consts::PI;

use carom_special::RangeError;

use crate::{Displacement, MaterialPair, Offset, Rectangle, RectangleIntegrals, Traction};

/// The displacements at a point due to unit tractions on a rectangle: the matrix A of (4.14).
///
/// Rows are the displacements u = u1 - u2, v = v1 - v2, w = w1 + w2 of (4.6); columns the
/// tractions on body 1 along x, y and the pressure. For nu = 0 the three on the diagonal are equal (14.5).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Coefficients {
    /// `rows[i][l]`: displacement i due to traction l.
    pub rows: [[f64; 3]; 3],
}

impl Coefficients {
    /// The displacement due to the tractions `load` on the rectangle.
    #[must_use]
    pub fn displacement(&self, load: Traction) -> Displacement {
        let row = |r: &[f64; 3]| r[0] * load.x + r[1] * load.y + r[2] * load.normal;
        Displacement { u: row(&self.rows[0]), v: row(&self.rows[1]), w: row(&self.rows[2]) }
    }

    /// The largest magnitude of the nine coefficients.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.rows.iter().flatten().fold(0.0, |largest, value| largest.max(value.abs()))
    }
}

/// The influence of a rectangle of constant traction on the surfaces of two elastic bodies.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair, Offset, Rectangle, RectangleInfluence};
/// let steel = Material::from_young(208e3, 0.3)?;
/// let rubber = Material::from_young(2.0, 0.49)?;
/// let pair = MaterialPair::new(steel, rubber)?;
/// let cell = RectangleInfluence::new(pair, Rectangle::new(0.1, 0.2)?);
/// let here = cell.coefficients(Offset { x: 0.3, y: 0.0 })?;
/// assert_eq!(here.rows[0][2], -here.rows[2][0]); // (4.23): A31 = -A13
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RectangleInfluence {
    pair: MaterialPair,
    rectangle: Rectangle,
}

/// The influence of a point load on the surfaces of two elastic bodies: the integrands of (4.14).
///
/// At large distances it equals the coefficients of a rectangle divided by its area; per unit
/// force.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair, Offset, PointInfluence};
/// let body = Material::from_shear(1.0, 0.25)?;
/// let pair = MaterialPair::new(body, Material::RIGID)?;
/// let here = PointInfluence::new(pair).coefficients(Offset { x: 3.0, y: 4.0 })?;
/// let expected = (1.0 - 0.25) / (2.0 * std::f64::consts::PI * 5.0); // (4.5c)
/// assert!((here.rows[2][2] - expected).abs() < 1e-17);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointInfluence {
    pair: MaterialPair,
}

impl PointInfluence {
    /// The influence of a point load on the bodies `pair`.
    #[must_use]
    pub const fn new(pair: MaterialPair) -> Self {
        Self { pair }
    }

    /// The displacements (4.8), (4.9) due to unit forces at `offset`, source minus receiver.
    ///
    /// # Errors
    /// [`RangeError`] unless the offset is finite and not zero, where the displacements are
    /// infinite.
    pub fn coefficients(&self, offset: Offset) -> Result<Coefficients, RangeError> {
        let Offset { x, y } = offset;
        RangeError::finite("offset x", x)?;
        RangeError::finite("offset y", y)?;
        let r = libm::hypot(x, y);
        let singular = "> 0: a point load is singular where it acts";
        RangeError::check("r", r, r > 0.0 && (1.0 / r).is_finite(), singular)?;
        let (a, b) = (x / r, y / r);
        let integrands = RectangleIntegrals {
            inverse_distance: 1.0 / r,
            xx: b * b / r,
            yy: a * a / r,
            xy: -a * b / r,
            log_x: a / r,
            log_y: b / r,
        };
        Ok(Independent::of(&self.pair, &integrands).nine())
    }
}

/// The six independent coefficients of (4.14); the other three follow from (4.23).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Independent {
    pub(crate) xx: f64,
    pub(crate) yy: f64,
    pub(crate) zz: f64,
    pub(crate) xy: f64,
    pub(crate) xz: f64,
    pub(crate) yz: f64,
}

impl RectangleInfluence {
    /// The influence of `rectangle` on the bodies `pair`.
    #[must_use]
    pub const fn new(pair: MaterialPair, rectangle: Rectangle) -> Self {
        Self { pair, rectangle }
    }

    /// The materials.
    #[must_use]
    pub const fn pair(&self) -> MaterialPair {
        self.pair
    }

    /// The loaded rectangle.
    #[must_use]
    pub const fn rectangle(&self) -> Rectangle {
        self.rectangle
    }

    /// The nine coefficients (4.14) at `offset`, source minus receiver.
    ///
    /// # Errors
    /// [`RangeError`] unless the offset is finite.
    pub fn coefficients(&self, offset: Offset) -> Result<Coefficients, RangeError> {
        RangeError::finite("offset x", offset.x)?;
        RangeError::finite("offset y", offset.y)?;
        Ok(self.independent(offset).nine())
    }

    /// The coefficients (4.14) at an offset known to be finite.
    pub(crate) fn independent(&self, offset: Offset) -> Independent {
        Independent::of(&self.pair, &self.rectangle.trusted_integrals(offset))
    }
}

/// The normal displacement due to pressure, (4.14), from the integral of 1/r.
pub(crate) fn normal(pair: &MaterialPair, inverse_distance: f64) -> f64 {
    let direct = 1.0 / (2.0 * PI * pair.shear_modulus());
    direct * (1.0 - pair.poisson()) * inverse_distance
}

impl Independent {
    /// (4.14) from the integrals (4.29).
    fn of(pair: &MaterialPair, integrals: &RectangleIntegrals) -> Self {
        let nu = pair.poisson();
        let direct = 1.0 / (2.0 * PI * pair.shear_modulus());
        let coupling = pair.epsilon() / (2.0 * PI); // (4.14) with (5.20)
        Self {
            // I0 - nu d2r/dx2, written as a sum of positive terms
            xx: direct * (integrals.yy + (1.0 - nu) * integrals.xx),
            yy: direct * (integrals.xx + (1.0 - nu) * integrals.yy),
            zz: normal(pair, integrals.inverse_distance),
            xy: -direct * nu * integrals.xy,
            xz: coupling * integrals.log_x,
            yz: coupling * integrals.log_y,
        }
    }

    /// All nine coefficients; three of them by (4.23).
    fn nine(self) -> Coefficients {
        let Self { xx, yy, zz, xy, xz, yz } = self;
        Coefficients { rows: [[xx, xy, xz], [xy, yy, yz], [-xz, -yz, zz]] }
    }
}
