//! Self-affine rough surfaces.

use std::f64::consts::TAU;

use carom_fourier::{Complex64, Transformed as _};
use carom_halfspace::{Field, Grid};
use carom_special::RangeError;

use super::Gap;

/// A random self-affine rough surface: waves with the power spectrum `q^(-2 (1 + H))` between two
/// wavelengths, with random phases. It is periodic with the sides of the grid.
///
/// The phase of each wave depends on the seed and its wave number only: the same seed on a finer
/// grid of the same size gives the same surface, sampled at other points.
///
/// ```
/// use carom_halfspace::Grid;
/// use carom_solver::SelfAffine;
/// let grid = Grid::new(64, 64, 1.0, 1.0)?;
/// let surface = SelfAffine { hurst: 0.8, rms: 0.1, longest: 32.0, shortest: 4.0, seed: 1 };
/// let gap = surface.gap(grid)?;
/// let lowest = gap.heights().values().iter().copied().fold(f64::INFINITY, f64::min);
/// assert_eq!(lowest, 0.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SelfAffine {
    /// Hurst exponent H, 0 (rough) to 1 (smooth).
    pub hurst: f64,
    /// Root mean square height about the mean.
    pub rms: f64,
    /// The longest wavelength.
    pub longest: f64,
    /// The shortest wavelength.
    pub shortest: f64,
    /// Seed of the random phases.
    pub seed: u64,
}

impl SelfAffine {
    /// Heights about their mean at the cell centres.
    ///
    /// # Errors
    /// [`RangeError`] unless H is in the range 0 to 1, rms and wavelengths are positive, the
    /// shortest wavelength is at least two cells, the longest at most the shorter side of the grid,
    /// and at least one wave of the grid lies between them.
    pub fn heights(&self, grid: Grid) -> Result<Field, RangeError> {
        self.check(grid)?;
        let (nx, ny) = (grid.nx(), grid.ny());
        let (side_x, side_y) = (nx as f64 * grid.dx(), ny as f64 * grid.dy());
        let mut waves = vec![Complex64::ZERO; grid.cells()];
        let mut power = 0.0;
        for row in 0..ny {
            let turns_y = signed(row, ny);
            for column in 0..=nx / 2 {
                // One wave of each pair with opposite wave vectors.
                if column == 0 && turns_y <= 0 {
                    continue;
                }
                let (q_x, q_y) = (column as f64 / side_x, turns_y as f64 / side_y);
                let wave = (q_x * q_x + q_y * q_y).sqrt();
                if wave * self.longest < 1.0 - 1e-9 || wave * self.shortest > 1.0 + 1e-9 {
                    continue;
                }
                let size = libm::pow(wave * self.longest, -(1.0 + self.hurst));
                let phase = self.phase(column as u64, turns_y)
                    + TAU * (q_x * grid.centred_x(0) + q_y * grid.centred_y(0));
                waves[grid.index(column, row)] =
                    Complex64::new(size * libm::cos(phase), size * libm::sin(phase));
                power += 0.5 * size * size;
            }
        }
        RangeError::check("waves between the wavelengths", 0.0, power > 0.0, "at least 1")?;
        transform(grid, &mut waves);
        let scale = self.rms / power.sqrt();
        Field::new(grid, waves.iter().map(|wave| scale * wave.re).collect())
    }

    /// The gap to a plane that rests on the highest point.
    ///
    /// # Errors
    /// As [`SelfAffine::heights`].
    pub fn gap(&self, grid: Grid) -> Result<Gap, RangeError> {
        let heights = self.heights(grid)?;
        let highest = heights.values().iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Gap::new(heights.map(|height| highest - height))
    }

    fn check(&self, grid: Grid) -> Result<(), RangeError> {
        let hurst = (0.0..=1.0).contains(&self.hurst);
        RangeError::check("hurst", self.hurst, hurst, "from 0 to 1")?;
        RangeError::positive("rms", self.rms)?;
        let (dx, dy) = (grid.dx(), grid.dy());
        let side = (grid.nx() as f64 * dx).min(grid.ny() as f64 * dy) * (1.0 + 1e-12);
        let short = self.shortest >= 2.0 * dx.max(dy) * (1.0 - 1e-12);
        RangeError::check("shortest", self.shortest, short, "at least two cells")?;
        let long = self.longest >= self.shortest && self.longest <= side;
        let allowed = "from the shortest wavelength to the shorter side of the grid";
        RangeError::check("longest", self.longest, long, allowed)?;
        Ok(())
    }

    /// A phase in the range 0 to 2 pi that depends only on the seed and the wave.
    fn phase(&self, column: u64, row: i64) -> f64 {
        let mixed = scrambled(self.seed ^ scrambled(column ^ scrambled(row as u64)));
        TAU * (mixed >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// The 64-bit mixing function of Steele, Lea and Flood (SplitMix).
const fn scrambled(bits: u64) -> u64 {
    let z = bits.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// The signed wave number along an axis of `count` cells.
const fn signed(index: usize, count: usize) -> i64 {
    if 2 * index > count { index as i64 - count as i64 } else { index as i64 }
}

/// Sums the waves in place, by a fast Fourier transform.
fn transform(grid: Grid, waves: &mut [Complex64]) {
    let (nx, ny) = (grid.nx(), grid.ny());
    f64::complex_plan(nx).inverse.process(waves);
    let columns = f64::complex_plan(ny).inverse;
    let mut column = vec![Complex64::ZERO; ny];
    for ix in 0..nx {
        for (iy, value) in column.iter_mut().enumerate() {
            *value = waves[grid.index(ix, iy)];
        }
        columns.process(&mut column);
        for (iy, value) in column.iter().enumerate() {
            waves[grid.index(ix, iy)] = *value;
        }
    }
}
