//! The working memory of a step with friction.

use std::sync::Arc;

use carom_halfspace::operator::SurfaceOperator;

use super::Frictional;
use super::anderson::Mixing;
use super::coupled::Coupled;
use super::cut::Cut;
use super::error::FrictionalError;
use super::limits::FrictionLimits;
use crate::normal::NormalGrids;
use crate::problem::ContactProblem;
use crate::tangential::{LimitSurface, TangentialScratch};

/// The working memory of [`Frictional`].
#[derive(Clone)]
pub struct FrictionalScratch {
    pub(super) normal: NormalGrids,
    pub(super) tangential: TangentialScratch,
    pub(super) limits: FrictionLimits,
    /// Tangential displacement due to pressure; this and the next two fields are empty without
    /// coupling.
    pub(super) by_pressure: [Vec<f64>; 2],
    pub(super) offset: [Vec<f64>; 2],
    /// Normal displacement due to tangential tractions, in this pass and in the last one.
    pub(super) by_traction: Vec<f64>,
    pub(super) last: Vec<f64>,
    pub(super) mixing: Mixing,
    /// Cells at kinetic friction: they have slipped since they last stuck.
    pub(super) kinetic: Vec<bool>,
    /// The solver for pressures and tractions together, built when first needed.
    pub(super) coupled: Option<Box<Coupled>>,
    /// The loads that friction can hold under the pressures of this pass.
    pub(super) surface: LimitSurface,
    /// The last box that was used, and the normal displacements of all cells.
    pub(super) boxed: Option<Box<Boxed>>,
    pub(super) sunk: Vec<f64>,
}

/// The problem on a box.
#[derive(Clone)]
pub(super) struct Boxed {
    pub(super) cut: Cut,
    pub(super) problem: ContactProblem,
    pub(super) operator: Arc<dyn SurfaceOperator>,
    pub(super) coarser: Vec<Arc<dyn SurfaceOperator>>,
    pub(super) scratch: FrictionalScratch,
}

impl Frictional {
    pub(super) fn scratch_with(
        &self,
        problem: &ContactProblem,
        coarser: &[Arc<dyn SurfaceOperator>],
    ) -> Result<FrictionalScratch, FrictionalError> {
        let operator = problem.operator();
        let zero = || vec![0.0; problem.grid().cells()];
        let heights = problem.gap().shared_heights();
        let coupling = || if operator.is_coupled() { zero() } else { Vec::new() };
        let slips = !problem.friction().is_none();
        Ok(FrictionalScratch {
            normal: NormalGrids::new(operator, heights, || Ok(coarser.to_vec()))?,
            tangential: TangentialScratch::new(operator, if slips { coarser } else { &[] }),
            limits: FrictionLimits::new(problem.grid().cells()),
            by_pressure: [coupling(), coupling()],
            offset: [zero(), zero()],
            by_traction: coupling(),
            last: coupling(),
            mixing: Mixing::default(),
            kinetic: vec![false; problem.grid().cells()],
            coupled: None,
            surface: LimitSurface::default(),
            boxed: None,
            sunk: Vec::new(),
        })
    }
}
