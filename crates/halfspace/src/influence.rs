//! The nine load-displacement coefficients (4.14) of a rectangle on two bodies in contact.

use std::f64::consts::PI;

use carom_special::RangeError;

use crate::{Displacement, MaterialPair, Offset, Rectangle, Traction};

/// The displacements of a point due to unit tractions on one rectangle, A of (4.14).
///
/// Rows are the displacements u = u1 - u2, v = v1 - v2, w = w1 + w2 of (4.6); columns the
/// tractions on body 1 along x, y and the pressure.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Coefficients {
    /// `rows[i][l]`: displacement i by traction l.
    pub rows: [[f64; 3]; 3],
}

impl Coefficients {
    /// The displacement by the tractions `load` on the rectangle.
    #[must_use]
    pub fn displacement(&self, load: Traction) -> Displacement {
        let row = |r: &[f64; 3]| r[0] * load.x + r[1] * load.y + r[2] * load.normal;
        Displacement { u: row(&self.rows[0]), v: row(&self.rows[1]), w: row(&self.rows[2]) }
    }

    /// The largest magnitude of the nine.
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

/// The six independent values of (4.14): the other three follow from (4.23).
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
        let Independent { xx, yy, zz, xy, xz, yz } = self.independent(offset);
        Ok(Coefficients { rows: [[xx, xy, xz], [xy, yy, yz], [-xz, -yz, zz]] })
    }

    /// The coefficients (4.14) at an offset known to be finite.
    pub(crate) fn independent(&self, offset: Offset) -> Independent {
        let integrals = self.rectangle.trusted_integrals(offset);
        let nu = self.pair.poisson();
        let direct = 1.0 / (2.0 * PI * self.pair.shear_modulus());
        let coupling = self.pair.epsilon() / (2.0 * PI); // (4.14) with (5.20)
        Independent {
            // I0 - nu d2r/dx2, written as a sum of positive terms
            xx: direct * (integrals.yy + (1.0 - nu) * integrals.xx),
            yy: direct * (integrals.xx + (1.0 - nu) * integrals.yy),
            zz: direct * (1.0 - nu) * integrals.inverse_distance,
            xy: -direct * nu * integrals.xy,
            xz: coupling * integrals.log_x,
            yz: coupling * integrals.log_y,
        }
    }
}
