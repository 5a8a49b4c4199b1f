//! How the table is made: each region is halved until polynomials meet the tolerance.

use std::num::NonZeroUsize;
use std::thread;

use super::atlas::{Atlas, Region, chebyshev, chebyshev_points};
use super::{Grid, Leaf, Node, ORDER, RestitutionTable};
use crate::oblique::{Groups, ObliqueImpact};

/// Largest error seen at the test points of a cell that becomes a leaf.
const TOLERANCE: f64 = 3.5e-9;
/// Halvings after which a rough cell keeps the exact impact.
const MAX_HALVINGS: usize = 11;
/// Sum of the last coefficients beyond which testing a cell is a waste.
const HOPELESS: f64 = 1e-5;
/// Test points of a cell, in each direction.
const TESTS: [f64; 6] = [-0.99, -0.83, -0.37, 0.13, 0.64, 0.97];

impl RestitutionTable {
    /// The table from exact impacts, on all processors: several seconds of work. The shared one is
    /// stored.
    #[must_use]
    pub fn build() -> Self {
        let atlas = Atlas::new();
        let mut nodes = Vec::new();
        let mut open = Vec::new();
        for region in Region::ALL {
            let grid = Grid::of(region);
            open.extend(cells(grid));
            nodes.resize(nodes.len() + Grid::LEN, Node::Exact);
        }
        let mut leaves = Vec::new();
        for halvings in 0..=MAX_HALVINGS {
            let fits = in_parallel(&open, |cell| cell.fit(&atlas));
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
        Self { atlas, nodes, leaves }
    }
}

fn cells(grid: Grid) -> impl Iterator<Item = Cell> {
    let (width, height) = (1.0 / Grid::COLUMNS as f64, 1.0 / Grid::ROWS as f64);
    (0..Grid::LEN).map(move |i| {
        let (column, row) = (i / Grid::ROWS, i % Grid::ROWS);
        Cell {
            region: grid.region,
            node: grid.first + i,
            x: [width * column as f64, width * (column + 1) as f64],
            y: [height * row as f64, height * (row + 1) as f64],
        }
    })
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

enum Fit {
    Smooth(Box<Leaf>),
    Rough { across_chi: bool },
}

#[derive(Debug, Clone, Copy)]
struct Cell {
    region: Region,
    node: usize,
    x: [f64; 2],
    y: [f64; 2],
}

impl Cell {
    fn halves(&self, across_chi: bool, first: usize) -> [Self; 2] {
        [0, 1].map(|half| {
            let mut cell = Self { node: first + half, ..*self };
            let range = if across_chi { &mut cell.x } else { &mut cell.y };
            range[1 - half] = 0.5 * (range[0] + range[1]);
            cell
        })
    }

    fn exact(&self, atlas: &Atlas, x: f64, y: f64) -> Option<f64> {
        let at = |[low, high]: [f64; 2], t: f64| 0.5 * ((high + low) + (high - low) * t);
        let [chi, psi] = atlas.place(self.region, at(self.x, x), at(self.y, y));
        let groups = Groups::new(chi, psi).ok()?;
        ObliqueImpact::new(groups).ok().map(|impact| impact.restitution())
    }

    fn fit(&self, atlas: &Atlas) -> Fit {
        let Some(leaf) = self.interpolate(atlas) else {
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
                self.exact(atlas, x, y)
                    .is_some_and(|exact| (leaf.at(x, y) - exact).abs() <= TOLERANCE)
            })
        });
        if smooth {
            return Fit::Smooth(Box::new(leaf));
        }
        rough
    }

    // Interpolation at the Chebyshev points.
    fn interpolate(&self, atlas: &Atlas) -> Option<Leaf> {
        let points = chebyshev_points();
        let mut coefficients = [[0.0; ORDER]; ORDER];
        for &y in &points {
            for &x in &points {
                let value = self.exact(atlas, x, y)? / (ORDER * ORDER) as f64;
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
