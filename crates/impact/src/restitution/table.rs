//! R_x(chi, psi) from a table: within 1e-8 of the exact impact, in tens of nanoseconds.
//!
//! The surface is analytic inside regions bounded by psi = 1, psi = chi and psi = 2 chi - 1, apart
//! from weak kinks where short regimes appear. Each region is mapped to a rectangle and halved
//! until a polynomial of degree 7 in both variables meets the tolerance. Cells that a kink crosses
//! and that stay too rough keep the exact impact instead: accuracy never depends on luck.

use std::num::NonZeroUsize;
use std::sync::OnceLock;
use std::thread;

use crate::closed_form::restitution_in_sliding;
use crate::normal::fifth_root;
use crate::oblique::{Groups, ObliqueError, ObliqueImpact};

/// Coefficients in each direction.
const ORDER: usize = 8;
/// Largest error seen at the test points of a cell that becomes a leaf.
const TOLERANCE: f64 = 2e-9;
/// Halvings after which a rough cell keeps the exact impact.
const MAX_HALVINGS: usize = 8;
/// The range of chi in the table.
const CHI: [f64; 2] = [0.5, 6.5];
/// Sum of the last coefficients beyond which testing a cell is a waste.
const HOPELESS: f64 = 1e-5;
/// Test points of a cell, in each direction.
const TESTS: [f64; 4] = [-0.97, -0.35, 0.3, 0.95];

/// A table of R_x(chi, psi) for chi in [0.5, 6.5] and any psi.
///
/// ```
/// use carom_impact::oblique::{Groups, ObliqueImpact};
/// use carom_impact::restitution::RestitutionTable;
/// let table = RestitutionTable::shared(); // built at the first call
/// let groups = Groups::of_spheres(1.2, 3.0)?;
/// let exact = ObliqueImpact::new(groups)?.restitution();
/// assert!((table.restitution(groups)? - exact).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct RestitutionTable {
    regions: [Grid; 4],
    nodes: Vec<Node>,
    leaves: Vec<Leaf>,
}

impl RestitutionTable {
    /// The table of this process, built at the first call by all processors: a few seconds of
    /// work.
    #[must_use]
    pub fn shared() -> &'static Self {
        static TABLE: OnceLock<RestitutionTable> = OnceLock::new();
        TABLE.get_or_init(Self::build)
    }

    /// R_x within 1e-8 of [`ObliqueImpact::restitution`].
    ///
    /// Sliding throughout takes the closed form (9.33); chi outside [0.5, 6.5] and cells crossed
    /// by a kink take the exact impact, a thousand times slower.
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
        let region = Region::of(chi, psi);
        let y = region.coordinate(chi, psi);
        let grid = &self.regions[region as usize];
        let (mut index, mut x, mut y) = grid.locate(chi, y);
        loop {
            match self.nodes[index] {
                Node::Leaf(leaf) => return Some((&self.leaves[leaf as usize], x, y)),
                Node::Exact => return None,
                Node::AcrossChi(first) => (index, x) = descend(first, x),
                Node::AcrossPsi(first) => (index, y) = descend(first, y),
            }
        }
    }

    fn build() -> Self {
        let mut nodes = Vec::new();
        let mut open = Vec::new();
        let regions = Region::ALL.map(|region| {
            let grid = Grid { region, first: nodes.len() };
            open.extend(grid.cells(nodes.len()));
            nodes.resize(nodes.len() + grid.len(), Node::Exact);
            grid
        });
        let mut leaves = Vec::new();
        for halvings in 0..=MAX_HALVINGS {
            let fits = in_parallel(&open, Cell::fit);
            let mut next = Vec::new();
            for (cell, fit) in open.iter().zip(fits) {
                nodes[cell.node] = match fit {
                    Fit::Smooth(leaf) => {
                        leaves.push(*leaf);
                        Node::Leaf(leaves.len() as u32 - 1)
                    }
                    Fit::Rough { .. } if halvings == MAX_HALVINGS => Node::Exact,
                    Fit::Rough { across_chi } => {
                        let first = nodes.len();
                        nodes.resize(first + 2, Node::Exact);
                        next.extend(cell.halves(across_chi, first));
                        if across_chi {
                            Node::AcrossChi(first as u32)
                        } else {
                            Node::AcrossPsi(first as u32)
                        }
                    }
                };
            }
            open = next;
        }
        Self { regions, nodes, leaves }
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

// The same in the same order on any number of threads. Not through a thread pool: a worker that
// waits inside the one-time construction must not pick up work that asks for the table again.
fn in_parallel<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let threads = thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let share = items.len().div_ceil(threads).max(1);
    let work = &work;
    thread::scope(|scope| {
        let handles: Vec<_> = items
            .chunks(share)
            .map(|chunk| scope.spawn(move || chunk.iter().map(work).collect::<Vec<_>>()))
            .collect();
        handles
            .into_iter()
            .flat_map(|handle| match handle.join() {
                Ok(results) => results,
                Err(panic) => std::panic::resume_unwind(panic),
            })
            .collect()
    })
}

/// Where R_x is analytic, weak kinks apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Region {
    /// chi < 1, psi < 1: sticks at first, never reverses.
    StickLow,
    /// chi >= 1, psi < 1: sticks at first.
    StickHigh,
    /// 1 <= psi < chi: slides, sticks, slips.
    SlideStick,
    /// chi <= psi < 2 chi - 1: slides, slips.
    SlideSlip,
}

impl Region {
    const ALL: [Self; 4] = [Self::StickLow, Self::StickHigh, Self::SlideStick, Self::SlideSlip];

    #[inline]
    fn of(chi: f64, psi: f64) -> Self {
        if psi < 1.0 {
            if chi < 1.0 { Self::StickLow } else { Self::StickHigh }
        } else if psi < chi {
            Self::SlideStick
        } else {
            Self::SlideSlip
        }
    }

    fn chi_range(self) -> [f64; 2] {
        if self == Self::StickLow { [CHI[0], 1.0] } else { [1.0, CHI[1]] }
    }

    // Across the region from 0 to 1. R_x is a power series in (psi - 1)^(1/5) next to psi = 1:
    // the first sliding excites the irregular solution (1 - w)^(2/5) of the adhesion.
    #[inline]
    fn coordinate(self, chi: f64, psi: f64) -> f64 {
        match self {
            Self::StickLow | Self::StickHigh => psi,
            Self::SlideStick => fifth_root((psi - 1.0) / (chi - 1.0)),
            Self::SlideSlip => (psi - chi) / (chi - 1.0),
        }
    }

    fn psi(self, chi: f64, y: f64) -> f64 {
        match self {
            Self::StickLow | Self::StickHigh => y,
            Self::SlideStick => 1.0 + (chi - 1.0) * (y * y) * (y * y) * y,
            Self::SlideSlip => chi + (chi - 1.0) * y,
        }
    }
}

/// The first cells of a region.
#[derive(Debug, Clone, Copy)]
struct Grid {
    region: Region,
    first: usize,
}

impl Grid {
    const ROWS: usize = 3;

    const fn columns(self) -> usize {
        if matches!(self.region, Region::StickLow) { 2 } else { 6 }
    }

    const fn len(self) -> usize {
        self.columns() * Self::ROWS
    }

    // The first cell at a point and the position in it, from -1 to 1.
    #[inline]
    fn locate(&self, chi: f64, y: f64) -> (usize, f64, f64) {
        // The widths of the columns as constants; truncation, as floor is a call on plain x86-64.
        let (low, per_chi) = match self.region {
            Region::StickLow => (CHI[0], 2.0 / (1.0 - CHI[0])),
            _ => (1.0, 6.0 / (CHI[1] - 1.0)),
        };
        let (x, y) = ((chi - low) * per_chi, y * Self::ROWS as f64);
        let column = (x as u32).min(self.columns() as u32 - 1);
        let row = (y as u32).min(Self::ROWS as u32 - 1);
        let index = self.first + column as usize * Self::ROWS + row as usize;
        (index, 2.0 * (x - f64::from(column)) - 1.0, 2.0 * (y - f64::from(row)) - 1.0)
    }

    fn cells(self, first: usize) -> impl Iterator<Item = Cell> {
        let [low, high] = self.region.chi_range();
        let (width, height) = ((high - low) / self.columns() as f64, 1.0 / Self::ROWS as f64);
        (0..self.len()).map(move |i| {
            let (column, row) = (i / Self::ROWS, i % Self::ROWS);
            Cell {
                region: self.region,
                node: first + i,
                chi: [low + width * column as f64, low + width * (column + 1) as f64],
                y: [height * row as f64, height * (row + 1) as f64],
            }
        })
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

// T_0 .. T_7, by products rather than the recurrence: a shorter chain.
#[inline]
fn chebyshev(x: f64) -> [f64; ORDER] {
    let t2 = 2.0 * x * x - 1.0;
    let t3 = x * (2.0 * t2 - 1.0);
    let t4 = 2.0 * t2 * t2 - 1.0;
    let t5 = 2.0 * t2 * t3 - x;
    let t6 = 2.0 * t3 * t3 - 1.0;
    let t7 = 2.0 * t3 * t4 - x;
    [1.0, x, t2, t3, t4, t5, t6, t7]
}

enum Fit {
    Smooth(Box<Leaf>),
    Rough { across_chi: bool },
}

#[derive(Debug, Clone, Copy)]
struct Cell {
    region: Region,
    node: usize,
    chi: [f64; 2],
    y: [f64; 2],
}

impl Cell {
    fn halves(&self, across_chi: bool, first: usize) -> [Self; 2] {
        [0, 1].map(|half| {
            let mut cell = Self { node: first + half, ..*self };
            let range = if across_chi { &mut cell.chi } else { &mut cell.y };
            range[1 - half] = 0.5 * (range[0] + range[1]);
            cell
        })
    }

    fn exact(&self, x: f64, y: f64) -> Option<f64> {
        let at = |[low, high]: [f64; 2], t: f64| 0.5 * ((high + low) + (high - low) * t);
        let chi = at(self.chi, x);
        let groups = Groups::new(chi, self.region.psi(chi, at(self.y, y))).ok()?;
        ObliqueImpact::new(groups).ok().map(|impact| impact.restitution())
    }

    fn fit(&self) -> Fit {
        let Some(leaf) = self.interpolate() else {
            return Fit::Rough { across_chi: true };
        };
        // The direction in which the last coefficients are larger.
        let tail = |chi: bool| -> f64 {
            (ORDER - 2..ORDER)
                .flat_map(|i| (0..ORDER).map(move |j| if chi { (j, i) } else { (i, j) }))
                .map(|(row, column)| leaf.0[row][column].abs())
                .sum()
        };
        let (tail_chi, tail_across) = (tail(true), tail(false));
        let rough = Fit::Rough { across_chi: tail_chi > tail_across };
        if tail_chi.max(tail_across) > HOPELESS {
            return rough;
        }
        let smooth = TESTS.iter().all(|&x| {
            TESTS.iter().all(|&y| {
                self.exact(x, y).is_some_and(|exact| (leaf.at(x, y) - exact).abs() <= TOLERANCE)
            })
        });
        if smooth {
            return Fit::Smooth(Box::new(leaf));
        }
        rough
    }

    // Interpolation at the Chebyshev points.
    fn interpolate(&self) -> Option<Leaf> {
        let angle = |i: usize| (i as f64 + 0.5) * std::f64::consts::PI / ORDER as f64;
        let points: [f64; ORDER] = std::array::from_fn(|i| libm::cos(angle(i)));
        let mut coefficients = [[0.0; ORDER]; ORDER];
        for &y in &points {
            for &x in &points {
                let value = self.exact(x, y)? / (ORDER * ORDER) as f64;
                let (by_x, by_y) = (chebyshev(x), chebyshev(y));
                for (j, row) in coefficients.iter_mut().enumerate() {
                    for (i, coefficient) in row.iter_mut().enumerate() {
                        let twice = |k: usize| if k == 0 { 1.0 } else { 2.0 };
                        *coefficient += twice(i) * twice(j) * by_x[i] * by_y[j] * value;
                    }
                }
            }
        }
        Some(Leaf(coefficients))
    }
}
