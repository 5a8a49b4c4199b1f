//! The cells of the contact: cells outside it are left out of the computation.

use std::sync::Arc;

use carom_halfspace::Grid;
use carom_halfspace::operator::{
    DisplacementField, OperatorError, Preconditioner, SurfaceOperator, Threads, TractionField,
    Workspace, transform_length,
};

use crate::convergence::Products;
use crate::parts::together;
use crate::rough::inverse_of;

/// A box is used only if it holds at most this fraction of the cells.
const LARGEST_FRACTION: f64 = 0.85;

/// The cells with a positive bound, in the order of the grid, and a box around them.
#[derive(Clone, Default)]
pub(super) struct Contact {
    /// Consecutive cells: where each run begins in the grid and in the box, and its length.
    runs: Vec<[usize; 3]>,
    cells: usize,
}

impl Contact {
    /// Finds the cells of the contact and the columns and rows of the box around them, enlarged to
    /// the next fast transform length; `None` if the box is hardly smaller than the grid.
    pub(super) fn find(&mut self, grid: Grid, limits: &[f64]) -> Option<[usize; 2]> {
        self.runs.clear();
        self.cells = 0;
        let [mut columns, mut rows] = [[usize::MAX, 0]; 2];
        for (row, values) in limits.chunks_exact(grid.nx()).enumerate() {
            let mut column = 0;
            while let Some(free) = values[column..].iter().position(|limit| *limit > 0.0) {
                let begin = column + free;
                let length = values[begin..].iter().take_while(|limit| **limit > 0.0).count();
                column = begin + length;
                self.runs.push([grid.index(begin, row), 0, length]);
                self.cells += length;
                columns = [columns[0].min(begin), columns[1].max(column)];
                rows = [rows[0].min(row), row + 1];
            }
        }
        let sides = if self.cells == 0 {
            [1, 1]
        } else {
            [columns[1] - columns[0], rows[1] - rows[0]].map(|side| transform_length(side) / 2)
        };
        let sides = [sides[0].min(grid.nx()), sides[1].min(grid.ny())];
        for [at, boxed, _] in &mut self.runs {
            *boxed = *at % grid.nx() - columns[0] + sides[0] * (*at / grid.nx() - rows[0]);
        }
        ((sides[0] * sides[1]) as f64 <= LARGEST_FRACTION * grid.cells() as f64).then_some(sides)
    }

    /// Uses the whole grid in place of a box.
    fn unbox(&mut self) {
        for [at, boxed, _] in &mut self.runs {
            *boxed = *at;
        }
    }

    /// The centres of the cells in contact.
    pub(super) fn centres(&self, grid: Grid, [x, y]: &mut [Vec<f64>; 2]) {
        x.clear();
        y.clear();
        for [at, _, length] in &self.runs {
            let (column, row) = (*at % grid.nx(), *at / grid.nx());
            x.extend((column..column + length).map(|column| grid.centred_x(column)));
            y.resize(x.len(), grid.centred_y(row));
        }
    }

    /// Their number.
    pub(super) const fn cells(&self) -> usize {
        self.cells
    }

    /// Copies their values from a field of the grid.
    pub(super) fn gather<T: Copy>(&self, field: &[T], own: &mut Vec<T>) {
        own.clear();
        for [at, _, length] in &self.runs {
            own.extend_from_slice(&field[*at..*at + length]);
        }
    }

    /// Copies their values to a field of the grid.
    pub(super) fn scatter<T: Copy>(&self, own: &[T], field: &mut [T]) {
        let mut from = 0;
        for [at, _, length] in &self.runs {
            field[*at..*at + length].copy_from_slice(&own[from..from + length]);
            from += length;
        }
    }

    /// Copies the values of the cells in contact to a field of the subwindow.
    fn fill(&self, own: &[f64], field: &mut [f64]) {
        let mut from = 0;
        for [_, at, length] in &self.runs {
            field[*at..*at + length].copy_from_slice(&own[from..from + length]);
            from += length;
        }
    }

    /// Copies their values from a field of the box.
    fn take(&self, field: &[f64], own: &mut [f64]) {
        let mut from = 0;
        for [_, at, length] in &self.runs {
            own[from..from + length].copy_from_slice(&field[*at..*at + length]);
            from += length;
        }
    }
}

/// Influence within a contact, with its working memory.
#[derive(Clone)]
pub(super) struct ContactInfluence {
    threads: Threads,
    pub(super) contact: Contact,
    /// The operator on a box around the contact; `None` if the whole grid is used.
    fewer: Option<Arc<dyn SurfaceOperator>>,
    inverse: Option<Arc<dyn Preconditioner>>,
    workspace: Workspace,
    /// Fraction of the cells that are in the box.
    part: f64,
    /// Whether tractions along an axis cause displacements along that axis only.
    separate: bool,
    /// Fields of the box, zero outside the contact, and the resulting displacements.
    there: [Vec<f64>; 2],
    back: [Vec<f64>; 2],
}

impl ContactInfluence {
    pub(super) fn new(threads: Threads) -> Self {
        Self {
            threads,
            contact: Contact::default(),
            fewer: None,
            inverse: None,
            workspace: Workspace::default(),
            part: 1.0,
            separate: false,
            there: Default::default(),
            back: Default::default(),
        }
    }

    /// Sets the contact to the cells with a positive bound.
    pub(super) fn enter(&mut self, operator: &dyn SurfaceOperator, limits: &[f64]) {
        let grid = operator.grid();
        let last = self.fewer.take();
        if let Some([nx, ny]) = self.contact.find(grid, limits) {
            let fits = |own: &Arc<dyn SurfaceOperator>| {
                let own = own.grid();
                (own.nx(), own.ny(), own.cell()) == (nx, ny, grid.cell())
            };
            // If memory is short, the whole grid is used.
            let new = || operator.on_fewer(nx, ny).and_then(Result::ok).map(Arc::from);
            self.fewer = last.filter(fits).or_else(new);
        }
        if self.fewer.is_none() {
            self.contact.unbox();
        }
        let own = self.fewer.as_deref().unwrap_or(operator);
        self.inverse = inverse_of(own);
        self.separate = own.is_separate();
        self.part = own.grid().cells() as f64 / grid.cells() as f64;
        for field in self.there.iter_mut().chain(&mut self.back) {
            field.clear();
            field.resize(own.grid().cells(), 0.0);
        }
    }

    /// The displacements of the contact due to tractions on it.
    pub(super) fn displace(
        &mut self,
        operator: &dyn SurfaceOperator,
        traction: &[Vec<f64>; 2],
        displacement: &mut [Vec<f64>; 2],
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        self.displace_by(operator, traction, displacement, products, |operator, from, to, space| {
            operator.apply(from, to, space)
        })
    }

    /// The same, by [`SurfaceOperator::apply_roughly`].
    pub(super) fn displace_roughly(
        &mut self,
        operator: &dyn SurfaceOperator,
        traction: &[Vec<f64>; 2],
        displacement: &mut [Vec<f64>; 2],
        products: &mut Products,
    ) -> Result<(), OperatorError> {
        self.displace_by(operator, traction, displacement, products, |operator, from, to, space| {
            operator.apply_roughly(from, to, space)
        })
    }

    fn displace_by(
        &mut self,
        operator: &dyn SurfaceOperator,
        traction: &[Vec<f64>; 2],
        displacement: &mut [Vec<f64>; 2],
        products: &mut Products,
        product: impl FnOnce(
            &dyn SurfaceOperator,
            TractionField<'_>,
            DisplacementField<'_>,
            &mut Workspace,
        ) -> Result<(), OperatorError>,
    ) -> Result<(), OperatorError> {
        let [x, y] = self.there(traction);
        let [u, v] = self.wanted([x, y]);
        let [along, across] = &mut self.back;
        let [from_x, from_y] = &self.there;
        let tractions = TractionField {
            x: x.then_some(&from_x[..]),
            y: y.then_some(&from_y[..]),
            normal: None,
        };
        let displacements = DisplacementField {
            u: u.then_some(&mut along[..]),
            v: v.then_some(&mut across[..]),
            w: None,
        };
        let operator = self.fewer.as_deref().unwrap_or(operator);
        product(operator, tractions, displacements, &mut self.workspace)?;
        self.take([u, v], displacement);
        products.tangential += self.part;
        Ok(())
    }

    /// Copies components that are not zero to the fields of the box. Returns which ones these are.
    fn there(&mut self, fields: &[Vec<f64>; 2]) -> [bool; 2] {
        // NaN does not count as zero.
        let given = [0, 1].map(|axis| fields[axis].iter().any(|value: &f64| *value != 0.0));
        let (contact, [x, y]) = (&self.contact, &mut self.there);
        together(
            self.threads,
            || given[0].then(|| contact.fill(&fields[0], x)),
            || given[1].then(|| contact.fill(&fields[1], y)),
        );
        given
    }

    /// The components of displacement that these components of traction cause.
    const fn wanted(&self, [x, y]: [bool; 2]) -> [bool; 2] {
        if self.separate { [x, y] } else { [x || y, x || y] }
    }

    fn take(&self, wanted: [bool; 2], fields: &mut [Vec<f64>; 2]) {
        let take = |axis: usize, field: &mut [f64]| {
            if wanted[axis] {
                self.contact.take(&self.back[axis], field);
            } else {
                field.fill(0.0);
            }
        };
        let [x, y] = fields;
        together(self.threads, || take(0, x), || take(1, y));
    }

    /// Whether the operator has an approximate inverse.
    pub(super) const fn has_inverse(&self) -> bool {
        self.inverse.is_some()
    }

    /// Replaces displacements by the tractions of an approximate inverse, if there is one.
    pub(super) fn invert(&mut self, field: &mut [Vec<f64>; 2], products: &mut Products) {
        let Some(inverse) = self.inverse.take() else { return };
        let [x, y] = self.there(field);
        let [u, v] = self.wanted([x, y]);
        let [along, across] = &mut self.back;
        let [from_x, from_y] = &self.there;
        inverse.traction(
            [x.then_some(&from_x[..]), y.then_some(&from_y[..])],
            [u.then_some(&mut along[..]), v.then_some(&mut across[..])],
            &mut self.workspace,
        );
        self.take([u, v], field);
        self.inverse = Some(inverse);
        products.preconditioner += self.part;
    }
}
