//! An operator that leaves out what another one has beyond the necessary.

use std::sync::Arc;

use carom_halfspace::operator::{
    DisplacementField, OperatorError, Preconditioner, SurfaceOperator, Threads, TractionField,
    Workspace,
};
use carom_halfspace::{Coefficients, Grid};

type Other = Option<Result<Box<dyn SurfaceOperator>, OperatorError>>;

/// Its rough products are exact.
pub(crate) struct Delegating {
    operator: Box<dyn SurfaceOperator>,
    has_coarser: bool,
    has_fewer: bool,
}

impl Delegating {
    /// Without rough products alone.
    pub(crate) fn exact(operator: impl SurfaceOperator + 'static) -> Self {
        Self { operator: Box::new(operator), has_coarser: true, has_fewer: true }
    }

    /// That cannot be restricted to a part of its grid.
    pub(crate) fn whole(operator: impl SurfaceOperator + 'static) -> Self {
        Self { has_fewer: false, ..Self::exact(operator) }
    }

    /// Without coarser grids.
    pub(crate) fn on_one_grid(operator: impl SurfaceOperator + 'static) -> Self {
        Self { has_coarser: false, ..Self::whole(operator) }
    }

    fn alike(&self, other: Other) -> Other {
        let Self { has_coarser, has_fewer, .. } = *self;
        let alike = |operator| Box::new(Self { operator, has_coarser, has_fewer }) as Box<_>;
        other.map(|made| made.map(alike))
    }
}

impl SurfaceOperator for Delegating {
    fn grid(&self) -> Grid {
        self.operator.grid()
    }

    fn threads(&self) -> Threads {
        self.operator.threads()
    }

    fn is_coupled(&self) -> bool {
        self.operator.is_coupled()
    }

    fn coefficients(&self, columns: i32, rows: i32) -> Coefficients {
        self.operator.coefficients(columns, rows)
    }

    fn inverse(&self) -> Option<Arc<dyn Preconditioner>> {
        self.operator.inverse()
    }

    fn coarser(&self) -> Other {
        self.alike(self.has_coarser.then(|| self.operator.coarser()).flatten())
    }

    fn on_fewer(&self, nx: usize, ny: usize) -> Other {
        self.alike(self.has_fewer.then(|| self.operator.on_fewer(nx, ny)).flatten())
    }

    fn apply(
        &self,
        tractions: TractionField<'_>,
        displacements: DisplacementField<'_>,
        workspace: &mut Workspace,
    ) -> Result<(), OperatorError> {
        self.operator.apply(tractions, displacements, workspace)
    }
}
