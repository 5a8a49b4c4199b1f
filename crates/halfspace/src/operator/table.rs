//! The table of coefficients of a grid: offsets 0..nx by 0..ny; all others by parity (4.23).

use super::memory;
use super::pool;
use super::spectrum::Parity;
use super::{Axis, OperatorError, Threads};
use crate::influence::{Independent, normal};
use crate::multipoles::Multipoles;
use crate::{Coefficients, Grid, MaterialPair, Offset, RectangleInfluence};

/// The independent coefficients of (4.14), in the order of the table's blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Entry {
    Xx,
    Yy,
    Zz,
    Xy,
    Xz,
    Yz,
}

impl Entry {
    pub(crate) const ALL: [Self; 6] = [Self::Xx, Self::Yy, Self::Zz, Self::Xy, Self::Xz, Self::Yz];

    /// Parities along x and y, (4.23).
    pub(crate) const fn parity(self) -> [Parity; 2] {
        match self {
            Self::Xx | Self::Yy | Self::Zz => [Parity::Even, Parity::Even],
            Self::Xy => [Parity::Odd, Parity::Odd],
            Self::Xz => [Parity::Odd, Parity::Even],
            Self::Yz => [Parity::Even, Parity::Odd],
        }
    }

    /// That of a pair of components, and its sign in (4.23).
    pub(crate) const fn of(of: Axis, by: Axis) -> (Self, f64) {
        match (of, by) {
            (Axis::X, Axis::X) => (Self::Xx, 1.0),
            (Axis::Y, Axis::Y) => (Self::Yy, 1.0),
            (Axis::Normal, Axis::Normal) => (Self::Zz, 1.0),
            (Axis::X, Axis::Y) | (Axis::Y, Axis::X) => (Self::Xy, 1.0),
            (Axis::X, Axis::Normal) => (Self::Xz, 1.0),
            (Axis::Normal, Axis::X) => (Self::Xz, -1.0),
            (Axis::Y, Axis::Normal) => (Self::Yz, 1.0),
            (Axis::Normal, Axis::Y) => (Self::Yz, -1.0),
        }
    }

    const fn value(self, all: &Independent) -> f64 {
        match self {
            Self::Xx => all.xx,
            Self::Yy => all.yy,
            Self::Zz => all.zz,
            Self::Xy => all.xy,
            Self::Xz => all.xz,
            Self::Yz => all.yz,
        }
    }
}

/// The blocks of the influence matrix that an operator contains.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Blocks {
    /// All blocks: three spectra and one for similar bodies, six if normal and tangential
    /// directions couple.
    #[default]
    All,
    /// Normal displacement due to pressure: one spectrum.
    Normal,
    /// Tangential displacements due to tangential tractions: three spectra.
    Tangential,
}

impl Blocks {
    pub(crate) fn holds(self, entry: Entry, pair: &MaterialPair) -> bool {
        match entry {
            Entry::Xx | Entry::Yy => self != Self::Normal,
            Entry::Xy => self != Self::Normal && pair.poisson() != 0.0,
            Entry::Zz => self != Self::Tangential,
            Entry::Xz | Entry::Yz => self == Self::All && !pair.is_uncoupled(),
        }
    }

    /// The coefficient for a pair of components and its sign, `None` if it is zero.
    pub(crate) fn entry(
        self,
        pair: &MaterialPair,
        of: Axis,
        by: Axis,
    ) -> Result<(Option<Entry>, f64), OperatorError> {
        let (entry, sign) = Entry::of(of, by);
        let held = self.holds(entry, pair);
        if !held && Self::All.holds(entry, pair) {
            let (of, by) = (of.displacement_name(), by.traction_name());
            return Err(OperatorError::Missing { of, by });
        }
        Ok((held.then_some(entry), sign))
    }

    /// The number of coefficients.
    pub(crate) fn count(self, pair: &MaterialPair) -> usize {
        Entry::ALL.iter().filter(|&&entry| self.holds(entry, pair)).count()
    }

    /// Whether a table stores them. The influence of pressures alone is needed once at each offset.
    fn stores(self, entry: Entry, pair: &MaterialPair) -> bool {
        self != Self::Normal && self.holds(entry, pair)
    }
}

/// The coefficients (4.14) at every offset of a grid; only offsets >= 0 are stored.
///
/// The thesis stores nine numbers per offset, for three tractions and three displacements (28 800
/// bytes for 20 x 20 cells); by (4.23) six are independent, and four for similar bodies.
#[derive(Debug, Clone)]
pub struct CoefficientTable {
    influence: RectangleInfluence,
    /// Of a cell.
    multipoles: Multipoles,
    grid: Grid,
    blocks: [Vec<f64>; 6],
}

impl CoefficientTable {
    /// The table of `pair` on `grid` with all blocks, computed on one thread.
    ///
    /// # Errors
    /// [`OperatorError::TooLarge`] if it would not fit into memory.
    pub fn new(pair: MaterialPair, grid: Grid) -> Result<Self, OperatorError> {
        memory::check(Self::bytes(&pair, grid, Blocks::All))?;
        Ok(Self::build(pair, grid, Blocks::All, Threads::One))
    }

    /// Memory of a table, in bytes.
    pub(crate) fn bytes(pair: &MaterialPair, grid: Grid, blocks: Blocks) -> u128 {
        let held = Entry::ALL.iter().filter(|&&entry| blocks.stores(entry, pair)).count();
        8 * held as u128 * grid.nx() as u128 * grid.ny() as u128
    }

    pub(crate) fn build(pair: MaterialPair, grid: Grid, held: Blocks, threads: Threads) -> Self {
        let influence = RectangleInfluence::new(pair, grid.cell());
        let mut blocks = Entry::ALL
            .map(|entry| vec![0.0; if held.stores(entry, &pair) { grid.cells() } else { 0 }]);
        let rows = split_rows(&mut blocks, grid);
        let fill = |(iy, mut row): (usize, [&mut [f64]; 6])| {
            let y = iy as f64 * grid.dy();
            for ix in 0..grid.nx() {
                let all = influence.independent(Offset { x: ix as f64 * grid.dx(), y });
                for (entry, values) in Entry::ALL.into_iter().zip(&mut row) {
                    if let Some(value) = values.get_mut(ix) {
                        *value = entry.value(&all);
                    }
                }
            }
        };
        match threads {
            _ if held == Blocks::Normal => {}
            Threads::One => rows.into_iter().enumerate().for_each(fill),
            Threads::Pool => pool::each(rows, fill),
        }
        Self { influence, multipoles: Multipoles::of(grid.cell()), grid, blocks }
    }

    /// The grid.
    #[must_use]
    pub const fn grid(&self) -> Grid {
        self.grid
    }

    /// The materials.
    #[must_use]
    pub const fn pair(&self) -> MaterialPair {
        self.influence.pair()
    }

    /// The influence of one cell.
    pub(crate) const fn influence(&self) -> &RectangleInfluence {
        &self.influence
    }

    /// The normal displacement due to pressure on a cell, which is that of the table to rounding.
    pub(crate) fn normal(&self, offset: Offset) -> f64 {
        match self.multipoles.inverse_distance(offset) {
            Some(inverse_distance) => normal(&self.pair(), inverse_distance),
            None => self.influence.independent(offset).zz,
        }
    }

    /// Memory of the coefficients, in bytes.
    #[must_use]
    pub fn size_in_bytes(&self) -> usize {
        self.blocks.iter().map(|block| 8 * block.len()).sum()
    }

    /// The nine coefficients for a source `columns` and `rows` cells from the receiver, by (4.23);
    /// zero beyond the grid. Blocks that are not stored are computed.
    #[must_use]
    pub fn coefficients(&self, columns: i32, rows: i32) -> Coefficients {
        let (n, m) = (columns.unsigned_abs() as usize, rows.unsigned_abs() as usize);
        if n >= self.grid.nx() || m >= self.grid.ny() {
            return Coefficients::default();
        }
        let (sx, sy) = (f64::from(columns.signum()), f64::from(rows.signum()));
        let at = self.grid.index(n, m);
        let value = |entry: Entry| self.value(entry, at, [n, m]);
        let (xx, yy, zz) = (value(Entry::Xx), value(Entry::Yy), value(Entry::Zz));
        let xy = sx * sy * value(Entry::Xy);
        let (xz, yz) = (sx * value(Entry::Xz), sy * value(Entry::Yz));
        Coefficients { rows: [[xx, xy, xz], [xy, yy, yz], [-xz, -yz, zz]] }
    }

    fn value(&self, entry: Entry, at: usize, [n, m]: [usize; 2]) -> f64 {
        if !Blocks::All.holds(entry, &self.pair()) {
            return 0.0;
        }
        let block = self.block(entry);
        block.get(at).copied().unwrap_or_else(|| {
            self.fresh(entry, Offset { x: n as f64 * self.grid.dx(), y: m as f64 * self.grid.dy() })
        })
    }

    /// A coefficient that is not stored.
    fn fresh(&self, entry: Entry, offset: Offset) -> f64 {
        match entry {
            Entry::Zz => self.normal(offset),
            _ => entry.value(&self.influence.independent(offset)),
        }
    }

    /// The values of one coefficient at offsets `0..nx` by `0..ny`; empty if not stored.
    pub(crate) fn block(&self, entry: Entry) -> &[f64] {
        &self.blocks[entry as usize]
    }

    /// The values of one coefficient in a row of offsets, from 0 on.
    pub(crate) fn fill_row(&self, entry: Entry, row: usize, values: &mut [f64]) {
        let stored = self.block(entry);
        if let Some(stored) = stored.get(row * self.grid.nx()..)
            && !stored.is_empty()
        {
            values.copy_from_slice(&stored[..values.len()]);
            return;
        }
        let y = row as f64 * self.grid.dy();
        for (column, value) in values.iter_mut().enumerate() {
            *value = self.fresh(entry, Offset { x: column as f64 * self.grid.dx(), y });
        }
    }
}

/// The rows of the six blocks; empty slices for blocks that are not stored.
fn split_rows(blocks: &mut [Vec<f64>; 6], grid: Grid) -> Vec<[&mut [f64]; 6]> {
    let mut parts = blocks.each_mut().map(|block| block.chunks_mut(grid.nx()));
    (0..grid.ny()).map(|_| parts.each_mut().map(|part| part.next().unwrap_or_default())).collect()
}
