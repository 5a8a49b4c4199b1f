//! FASTSIM, the common approximation of rolling with independent springs.

use carom_special::RangeError;
use carom_table::Column;

use super::{CreepCoefficients, Creepage, Springs};

/// Kalker's simplified theory: each particle has springs of its own, with three flexibilities from
/// the creep coefficients and a parabolic friction limit. For two equal bodies.
///
/// In full sliding the force is f F_z along (C11 xi, C22 eta), up to 7 degrees from the slip. Compared with the solver at
/// nu = 0.25, for a/b from 0.29 to 3.5 and creepage in any direction, forces without spin are off by up to 0.09 f F_z (0.05
/// along x or y). With spin the lateral force is off by up to 0.18 f F_z, and in contacts with a < b by up to 0.2 f F_z.
///
/// ```
/// use carom_rolling::{Creepage, Fastsim, creep_coefficients_on};
/// let coefficients = creep_coefficients_on([8, 8], 1.0, 0.25)?;
/// let springs = Fastsim {
///     semi_axes: [1.0, 1.0],
///     shear_modulus: 1.0,
///     coefficients,
///     force: 1.0,
///     friction: 0.3,
///     mesh: [50, 50],
/// };
/// // For small creepage F_x = G a b C11 xi.
/// let forces = springs.forces(Creepage { along: 1e-4, ..Creepage::default() })?;
/// assert!((forces.f_x / (1e-4 * coefficients.c11) - 1.0).abs() < 2e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fastsim {
    /// Semi-axes along and across the direction of rolling.
    pub semi_axes: [f64; 2],
    /// Shear modulus of each body.
    pub shear_modulus: f64,
    /// Creep coefficients of the contact.
    pub coefficients: CreepCoefficients,
    /// Normal force.
    pub force: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Number of strips, and of elements in each.
    pub mesh: [usize; 2],
}

/// Tangential forces.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FastsimForces {
    /// Longitudinal, along the direction of rolling.
    pub f_x: f64,
    /// Lateral.
    pub f_y: f64,
}

impl FastsimForces {
    /// The columns of results.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("F_x", "N", "on body 1 along x, the direction of rolling", |forces| {
            forces.f_x.into()
        }),
        Column::new("F_y", "N", "on body 1 along y", |forces| forces.f_y.into()),
    ];
}

/// The greatest number of strips, and of elements in each.
const MOST: usize = 1000;
/// Tractions whose squares do not overflow.
const MOST_STRETCHED: f64 = 1e150;

impl Fastsim {
    /// The tangential forces for a given creepage.
    ///
    /// # Errors
    /// [`RangeError`] unless lengths, modulus, force and friction are positive, there are 1 to 1000
    /// strips and elements, and the creepage is finite and stretches springs to at most 1e150.
    pub fn forces(&self, creepage: Creepage) -> Result<FastsimForces, RangeError> {
        let [a, b] = self.semi_axes;
        let springs = Springs::of_ellipse([a, b], self.shear_modulus, &self.coefficients)?;
        RangeError::positive("force", self.force)?;
        RangeError::positive("friction", self.friction)?;
        let [strips, elements] = self.mesh;
        for count in self.mesh {
            let fits = (1..=MOST).contains(&count);
            RangeError::check("mesh", count as f64, fits, "from 1 to 1000 strips and elements")?;
        }
        creepage.check()?;
        let [l_1, l_2, l_3] = springs.flexibilities();
        let (along, across, spin) =
            (creepage.along / l_1, creepage.across / l_2, creepage.spin / l_3);
        for (field, value, slope) in [
            ("creepage", creepage.along, along),
            ("creepage_across", creepage.across, across),
            ("spin", creepage.spin, spin * a.max(b)),
        ] {
            let holds = (slope * a).abs() <= MOST_STRETCHED;
            RangeError::check(field, value, holds, "less: the tractions of its springs overflow")?;
        }
        let top = 2.0 * self.friction * self.force / (std::f64::consts::PI * a * b);
        let height = 2.0 * b / strips as f64;
        let mut sum = FastsimForces::default();
        for strip in 0..strips {
            let y = (strip as f64 + 0.5) * height - b;
            let half = a * (1.0 - (y / b) * (y / b)).sqrt();
            let width = 2.0 * half / elements as f64;
            let mut t = [0.0; 2];
            for element in 0..elements {
                // From the leading edge backwards, from centre to centre of the elements.
                let x = half - (element as f64 + 0.5) * width;
                let way = if element == 0 { 0.5 * width } else { width };
                let between = x + 0.5 * way;
                t = [t[0] + way * (along + y * spin), t[1] + way * (across - between * spin)];
                let limit = top * (1.0 - (x / a) * (x / a) - (y / b) * (y / b));
                let size = t[0].hypot(t[1]);
                if size > limit {
                    t = t.map(|part| part * limit / size);
                }
                sum.f_x += t[0] * width * height;
                sum.f_y += t[1] * width * height;
            }
        }
        // The middles of few elements carry more than the contact.
        let (size, most) = (sum.f_x.hypot(sum.f_y), self.friction * self.force);
        let part = if size > most { most / size } else { 1.0 };
        Ok(FastsimForces { f_x: part * sum.f_x, f_y: part * sum.f_y })
    }
}
