//! An operator that leaves out what another one has beyond the necessary.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use carom_halfspace::operator::{
    DisplacementField, OperatorError, Preconditioner, SurfaceOperator, Threads, TractionField,
    Workspace,
};
use carom_halfspace::{Coefficients, Grid};

type Other = Option<Result<Box<dyn SurfaceOperator>, OperatorError>>;

/// How many products were asked for: normal, tangential, and those that couple both.
#[derive(Default)]
pub(crate) struct Asked([AtomicUsize; 3]);

impl Asked {
    pub(crate) fn counts(&self) -> [f64; 3] {
        self.0.each_ref().map(|count| count.load(Relaxed) as f64)
    }
}

/// Its rough products are exact.
pub(crate) struct Delegating {
    asked: Arc<Asked>,
    operator: Box<dyn SurfaceOperator>,
    has_coarser: bool,
    has_fewer: bool,
}

impl Delegating {
    /// Without rough products alone.
    pub(crate) fn exact(operator: impl SurfaceOperator + 'static) -> Self {
        let asked = Arc::default();
        Self { asked, operator: Box::new(operator), has_coarser: true, has_fewer: true }
    }

    pub(crate) const fn asked(&self) -> &Arc<Asked> {
        &self.asked
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
        let asked = &self.asked;
        let alike = |operator| {
            Box::new(Self { asked: Arc::clone(asked), operator, has_coarser, has_fewer }) as Box<_>
        };
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
        let [by, of] = [
            [tractions.normal.is_some(), tractions.x.is_some()],
            [displacements.w.is_some(), displacements.u.is_some()],
        ];
        let asked = [by[0] && of[0], by[1] && of[1], by[0] && of[1], by[1] && of[0]];
        for (is_asked, kind) in asked.into_iter().zip([0, 1, 2, 2]) {
            self.asked.0[kind].fetch_add(usize::from(is_asked), Relaxed);
        }
        self.operator.apply(tractions, displacements, workspace)
    }
}
