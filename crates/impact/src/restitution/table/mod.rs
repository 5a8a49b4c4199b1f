//! R_x(chi, psi) from a table: within 1e-8 of the exact impact, in tens of nanoseconds.
//!
//! The surface is analytic inside regions bounded by psi = 1, psi = chi, psi = 2 chi - 1 and the
//! curve where the sense of the final sliding changes; beyond chi = 5.2, where the slip may stop and
//! start again, weaker kinks remain. Each region is mapped to a square and halved until a
//! polynomial of degree 7 in both variables meets the tolerance. Cells that a kink crosses and that
//! stay too rough keep the exact impact instead: accuracy never depends on luck.

use std::sync::OnceLock;

use crate::closed_form::restitution_in_sliding;
use crate::oblique::{Groups, ObliqueError, ObliqueImpact};

use atlas::{Atlas, CHI, ORDER, Region, chebyshev};

mod atlas;
mod build;
mod loss;
mod stored;

/// A table of R_x(chi, psi) for chi in [0.5, 6.5] and any psi.
///
/// ```
/// use carom_impact::oblique::{Groups, ObliqueImpact};
/// use carom_impact::restitution::RestitutionTable;
/// let table = RestitutionTable::shared(); // stored in the crate
/// let groups = Groups::of_spheres(1.2, 3.0)?;
/// let exact = ObliqueImpact::new(groups)?.restitution();
/// assert!((table.restitution(groups)? - exact).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct RestitutionTable {
    atlas: Atlas,
    nodes: Vec<Node>,
    leaves: Vec<Leaf>,
}

impl RestitutionTable {
    /// The table of this process, read at the first call from the data stored in this crate.
    #[must_use]
    pub fn shared() -> &'static Self {
        static TABLE: OnceLock<RestitutionTable> = OnceLock::new();
        TABLE.get_or_init(|| Self::stored().unwrap_or_else(Self::build))
    }

    /// R_x within 1e-8 of [`ObliqueImpact::restitution`].
    ///
    /// Sliding throughout takes the closed form (9.33); chi outside [0.5, 6.5] takes the exact
    /// impact, some hundred times slower, as do the cells crossed by a kink: about 0.5 % of the
    /// points with chi > 5.2, next to none below.
    ///
    /// # Errors
    /// [`ObliqueError`] as [`ObliqueImpact::new`], only where that is used.
    pub fn restitution(&self, groups: Groups) -> Result<f64, ObliqueError> {
        let (chi, psi) = (groups.chi(), groups.psi());
        if let Some(sliding) = restitution_in_sliding(chi, psi) {
            return Ok(sliding);
        }
        match self.leaf(chi, psi) {
            Some((leaf, x, y)) => Ok(leaf.at(x, y)),
            None => Ok(ObliqueImpact::new(groups)?.restitution()),
        }
    }

    /// Whether `groups` are answered without the exact impact.
    #[must_use]
    pub fn covers(&self, groups: Groups) -> bool {
        let (chi, psi) = (groups.chi(), groups.psi());
        restitution_in_sliding(chi, psi).is_some() || self.leaf(chi, psi).is_some()
    }

    /// Memory in bytes.
    #[must_use]
    pub fn size(&self) -> usize {
        self.nodes.len() * size_of::<Node>() + self.leaves.len() * size_of::<Leaf>()
    }

    // The leaf at a point and the position in it, from -1 to 1.
    #[inline]
    fn leaf(&self, chi: f64, psi: f64) -> Option<(&Leaf, f64, f64)> {
        if !(CHI[0]..=CHI[1]).contains(&chi) {
            return None;
        }
        let (region, x, y) = self.atlas.locate(chi, psi);
        let (mut index, mut x, mut y) = Grid::of(region).locate(x, y);
        loop {
            match self.nodes[index] {
                Node::Leaf(leaf) => return Some((&self.leaves[leaf as usize], x, y)),
                Node::Exact => return None,
                Node::AcrossChi(first) => (index, x) = descend(first, x),
                Node::AcrossPsi(first) => (index, y) = descend(first, y),
            }
        }
    }
}

// The child of a halved cell and the position in it.
#[inline]
fn descend(first: u32, position: f64) -> (usize, f64) {
    if position < 0.0 {
        (first as usize, 2.0 * position + 1.0)
    } else {
        (first as usize + 1, 2.0 * position - 1.0)
    }
}

/// The first cells of a region.
#[derive(Debug, Clone, Copy)]
struct Grid {
    region: Region,
    first: usize,
}

impl Grid {
    const ROWS: usize = 4;
    const COLUMNS: usize = 4;
    const LEN: usize = Self::COLUMNS * Self::ROWS;

    #[inline]
    fn of(region: Region) -> Self {
        Self { region, first: region as usize * Self::LEN }
    }

    // The first cell at a point and the position in it, from -1 to 1.
    #[inline]
    fn locate(&self, x: f64, y: f64) -> (usize, f64, f64) {
        // Truncation, as floor is a call on plain x86-64.
        let (x, y) = (x * Self::COLUMNS as f64, y * Self::ROWS as f64);
        let column = (x as u32).min(Self::COLUMNS as u32 - 1);
        let row = (y as u32).min(Self::ROWS as u32 - 1);
        let index = self.first + column as usize * Self::ROWS + row as usize;
        (index, 2.0 * (x - f64::from(column)) - 1.0, 2.0 * (y - f64::from(row)) - 1.0)
    }
}

#[derive(Debug, Clone, Copy)]
enum Node {
    Leaf(u32),
    Exact,
    /// Halved in chi: its two cells stand from here on.
    AcrossChi(u32),
    /// Halved across.
    AcrossPsi(u32),
}

/// Chebyshev coefficients: rows by the degree across, columns by the degree in chi.
#[derive(Debug, Clone, Copy)]
struct Leaf([[f64; ORDER]; ORDER]);

impl Leaf {
    #[inline]
    fn at(&self, x: f64, y: f64) -> f64 {
        let (by_x, by_y) = (chebyshev(x), chebyshev(y));
        let mut sums = [0.0; ORDER];
        for (row, weight) in self.0.iter().zip(by_y) {
            for (sum, coefficient) in sums.iter_mut().zip(row) {
                *sum += weight * coefficient;
            }
        }
        let mut products = [0.0; ORDER];
        for i in 0..ORDER {
            products[i] = sums[i] * by_x[i];
        }
        let [a, b, c, d, e, f, g, h] = products;
        ((a + b) + (c + d)) + ((e + f) + (g + h))
    }
}
