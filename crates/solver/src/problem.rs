//! The contact problem: two bodies on a grid, with friction.

use std::sync::Arc;

use carom_halfspace::operator::{
    Blocks, HalfSpaceOperator, OperatorError, PeriodicOperator, SurfaceOperator, Threads,
};
use carom_halfspace::{Grid, MaterialPair};
use carom_laws::friction::Friction;

use crate::drive::Driven;
use crate::friction::SurfaceFriction;
use crate::gap::Gap;

/// Why gap, operator and friction do not form a problem.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ProblemError {
    /// Operator or friction has another grid than the gap.
    #[error(
        "the {part} is for {} x {} cells of {} x {}, the gap for {} x {} of {} x {}",
        .grids[1].nx(), .grids[1].ny(), .grids[1].dx(), .grids[1].dy(),
        .grids[0].nx(), .grids[0].ny(), .grids[0].dx(), .grids[0].dy()
    )]
    OtherGrid {
        /// The part with the other grid: operator or friction.
        part: &'static str,
        /// The grid of the gap, and the grid of the part.
        grids: Box<[Grid; 2]>,
    },
    /// The operator of the half-space could not be built.
    #[error(transparent)]
    Operator(#[from] OperatorError),
}

/// Why no load on a periodic surface gives a prescribed shift.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum PeriodError {
    /// The approach is above the mean of the gap.
    #[error(
        "the approach {approach:?} is above the mean of the gap, {mean:?}: the whole period is then in contact, \
         and no load moves the mean planes closer"
    )]
    AllTouches {
        /// The approach.
        approach: f64,
        /// The mean of the gap.
        mean: f64,
    },
    /// A tangential shift is prescribed where all cells are in contact and friction is infinite.
    #[error(
        "a shift by {shift:?} along {axis}: the whole period sticks, and no load moves the mean planes \
         relative to each other"
    )]
    AllSticks {
        /// The axis.
        axis: &'static str,
        /// The shift in the step.
        shift: f64,
    },
}

/// Relative tolerance for an approach above the mean of the gap: within it, the approach is taken
/// to equal the mean.
const ROUNDING: f64 = 1e-13;

/// A contact problem (chapters 11 to 14): a gap, the influence of tractions on displacements, and
/// friction, all on one grid. Clones share heights and operator.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction};
/// use carom_solver::{ContactProblem, Gap};
/// let grid = Grid::new(20, 20, 0.1, 0.1)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let steel = Material::from_young(208e9, 0.3)?;
/// let pair = MaterialPair::new(steel, steel)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3)?)?;
/// assert!(!problem.operator().is_coupled());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct ContactProblem {
    gap: Gap,
    operator: Arc<dyn SurfaceOperator>,
    friction: SurfaceFriction,
}

impl ContactProblem {
    /// A problem with any operator, for example one of the user.
    ///
    /// # Errors
    /// [`ProblemError::OtherGrid`] unless operator and friction have the grid of the gap.
    pub fn new(
        gap: Gap,
        operator: Arc<dyn SurfaceOperator>,
        friction: impl Into<SurfaceFriction>,
    ) -> Result<Self, ProblemError> {
        let friction = friction.into();
        let same = |part, grid: Grid| {
            let grids = [gap.grid(), grid];
            let fits = grids[0] == grids[1];
            if fits { Ok(()) } else { Err(ProblemError::OtherGrid { part, grids: grids.into() }) }
        };
        same("operator", operator.grid())?;
        friction.grid().map_or(Ok(()), |grid| same("friction", grid))?;
        Ok(Self { gap, operator, friction })
    }

    /// A problem whose parts are known to have the same grid.
    pub(crate) const fn of_parts(
        gap: Gap,
        operator: Arc<dyn SurfaceOperator>,
        friction: SurfaceFriction,
    ) -> Self {
        Self { gap, operator, friction }
    }

    /// A problem of two elastic half-spaces, computed on all threads of the current pool where the
    /// grid is large enough ([`Threads::for_grid`]). The result does not depend on their number.
    ///
    /// # Errors
    /// [`ProblemError::Operator`] if both bodies are rigid or the grid is too large for memory.
    pub fn of_half_spaces(
        gap: Gap,
        pair: MaterialPair,
        friction: impl Into<SurfaceFriction>,
    ) -> Result<Self, ProblemError> {
        let (grid, threads) = (gap.grid(), Threads::for_grid(gap.grid()));
        let operator = HalfSpaceOperator::with_blocks(pair, grid, Blocks::All, threads)?;
        Self::new(gap, Arc::new(operator), friction)
    }

    /// Two half-spaces, with the influence of pressures alone if there is no friction and the materials do not couple: on
    /// a large grid the others take several times its memory.
    ///
    /// # Errors
    /// As [`ContactProblem::of_half_spaces`].
    pub fn of_half_spaces_by_need(
        gap: Gap,
        pair: MaterialPair,
        friction: impl Into<SurfaceFriction>,
    ) -> Result<Self, ProblemError> {
        let (friction, threads) = (friction.into(), Threads::for_grid(gap.grid()));
        let blocks = needed(&pair, &friction);
        let operator = HalfSpaceOperator::with_blocks(pair, gap.grid(), blocks, threads)?;
        Self::new(gap, Arc::new(operator), friction)
    }

    /// The same for surfaces that repeat themselves.
    ///
    /// # Errors
    /// [`ProblemError::Operator`] if both bodies are rigid, a number of cells is odd, or the grid is too large for memory.
    pub fn of_periods_by_need(
        gap: Gap,
        pair: MaterialPair,
        friction: impl Into<SurfaceFriction>,
    ) -> Result<Self, ProblemError> {
        let (friction, threads) = (friction.into(), Threads::for_grid(gap.grid()));
        let blocks = needed(&pair, &friction);
        let operator = PeriodicOperator::with_blocks(pair, gap.grid(), blocks, threads)?;
        Self::new(gap, Arc::new(operator), friction)
    }

    /// The grid of gap, operator and friction.
    #[must_use]
    pub fn grid(&self) -> Grid {
        self.gap.grid()
    }

    /// The same problem with another friction.
    ///
    /// # Errors
    /// [`ProblemError::OtherGrid`] unless the friction is uniform or has the grid of the gap.
    pub fn with_friction(self, friction: impl Into<SurfaceFriction>) -> Result<Self, ProblemError> {
        Self::new(self.gap, self.operator, friction)
    }

    /// The same problem without friction.
    #[must_use]
    pub fn without_friction(self) -> Self {
        Self { friction: Friction::NONE.into(), ..self }
    }

    /// The approach after a step if the bodies are then separated; `None` if they are in contact.
    #[must_use]
    pub fn apart(&self, normal: Driven) -> Option<f64> {
        let heights = self.gap.heights().values();
        let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
        match normal {
            Driven::Shift(approach) => (approach <= lowest).then_some(approach),
            Driven::Load(force) => (force == 0.0).then_some(lowest),
        }
    }

    /// Checks that some load gives this approach. On a periodic surface many loads give the mean of
    /// the gap.
    pub(crate) fn check_approach(&self, normal: Driven) -> Result<(), PeriodError> {
        let Driven::Shift(approach) = normal else { return Ok(()) };
        if self.operator.displaces_on_average() {
            return Ok(());
        }
        let heights = self.gap.heights().values();
        let mean = heights.iter().sum::<f64>() / heights.len() as f64;
        let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
        if approach - mean > ROUNDING * (approach - lowest) {
            return Err(PeriodError::AllTouches { approach, mean });
        }
        Ok(())
    }

    /// The gap.
    #[must_use]
    pub const fn gap(&self) -> &Gap {
        &self.gap
    }

    /// The operator: the influence of tractions on displacements.
    #[must_use]
    pub fn operator(&self) -> &dyn SurfaceOperator {
        &*self.operator
    }

    /// The operator, shared.
    #[must_use]
    pub const fn shared_operator(&self) -> &Arc<dyn SurfaceOperator> {
        &self.operator
    }

    /// The friction of the surface.
    #[must_use]
    pub const fn friction(&self) -> &SurfaceFriction {
        &self.friction
    }
}

/// The blocks of the influence that a problem needs.
fn needed(pair: &MaterialPair, friction: &SurfaceFriction) -> Blocks {
    if friction.is_none() && pair.is_uncoupled() { Blocks::Normal } else { Blocks::All }
}

impl std::fmt::Debug for ContactProblem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ContactProblem").field("grid", &self.grid()).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CellFriction;
    use carom_halfspace::operator::{DisplacementField, TractionField};
    use carom_halfspace::{Field, Material};
    use carom_laws::curvature::RelativeCurvature;

    /// Tractions displace where there is friction, pressures along the surface where bodies couple.
    #[test]
    fn what_is_needed_depends_on_friction_and_coupling() {
        let grid = Grid::new(4, 4, 0.5, 0.25).unwrap();
        let gap = Gap::from_function(grid, |x, y| x * x + y * y).unwrap();
        let body = |nu: f64| Material::from_shear(1.0, nu).unwrap();
        for (nu, friction, is_all) in [(0.3, 0.0, false), (0.3, 0.2, true), (0.1, 0.0, true)] {
            let pair = MaterialPair::new(body(0.3), body(nu)).unwrap();
            let friction = Friction::new(friction).unwrap();
            for problem in [
                ContactProblem::of_half_spaces_by_need(gap.clone(), pair, friction),
                ContactProblem::of_periods_by_need(gap.clone(), pair, friction),
            ] {
                let (problem, values) = (problem.unwrap(), [1.0; 16]);
                let (mut u, mut v) = ([0.0; 16], [0.0; 16]);
                let done = problem.operator().apply(
                    TractionField::full(&values, &values, &values),
                    DisplacementField::tangential(&mut u, &mut v),
                    &mut problem.operator().workspace(),
                );
                assert_eq!(done.is_ok(), is_all, "{nu} {friction:?}");
            }
        }
    }

    #[test]
    fn parts_of_another_grid_are_refused() {
        let grid = |nx| Grid::new(nx, 3, 0.5, 0.25).unwrap();
        let body = Material::from_shear(1.0, 0.3).unwrap();
        let pair = MaterialPair::new(body, body).unwrap();
        let curvature = RelativeCurvature::from_coefficients(1.0, 1.0).unwrap();
        let gap = Gap::of_curvature(grid(4), &curvature);
        let operator = |nx| Arc::new(HalfSpaceOperator::new(pair, grid(nx)).unwrap());
        let error = ContactProblem::new(gap.clone(), operator(5), Friction::NONE).unwrap_err();
        let text = "the operator is for 5 x 3 cells of 0.5 x 0.25, the gap for 4 x 3 of 0.5 x 0.25";
        assert_eq!(error.to_string(), text);
        let friction = Field::uniform(grid(5), CellFriction::from(Friction::NONE));
        let error = ContactProblem::new(gap.clone(), operator(4), friction).unwrap_err();
        assert!(error.to_string().starts_with("the friction is for 5 x 3"));
        assert!(ContactProblem::new(gap, operator(4), Friction::NONE).is_ok());
    }
}
