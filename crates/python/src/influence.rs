//! Influence numbers of bodies that are no half-spaces.

use carom::halfspace::operator::{Blocks, KernelBlock, KernelOperator, TabulatedKernel, Threads};
use carom::prelude::Grid;
use carom::solver::SurfaceFriction;
use pyo3::prelude::*;

use crate::arrays::Numbers;
use crate::error::Fault;
use crate::threads::without_python;

/// Name, columns and numbers of each block.
pub(crate) type Given<'py> = Vec<(String, usize, Numbers<'py>)>;

/// The operator of these blocks on a grid: those of elastic bodies, checked for Betti's theorem and for positive work
/// of the tractions that the friction allows. None for no block.
pub(crate) fn operator(
    py: Python<'_>,
    grid: Grid,
    given: &Given<'_>,
    friction: &SurfaceFriction,
) -> PyResult<Option<KernelOperator>> {
    if given.is_empty() {
        return Ok(None);
    }
    let block = |(name, columns, numbers): &(String, usize, Numbers<'_>)| -> PyResult<KernelBlock> {
        let rows: Vec<Vec<f64>> =
            numbers.as_slice()?.chunks((*columns).max(1)).map(<[f64]>::to_vec).collect();
        Ok(KernelBlock::new(name, &rows).map_err(Fault::from)?)
    };
    let blocks = given.iter().map(block).collect::<PyResult<Vec<_>>>()?;
    let works = if friction.is_none() { Blocks::Normal } else { Blocks::All };
    let operator = without_python(py, || {
        let kernel = TabulatedKernel::from_blocks(grid, &blocks)?.reciprocal()?;
        let operator = KernelOperator::new(kernel, Threads::for_grid(grid))?;
        operator.check_definite(works)?;
        Ok::<_, Fault>(operator)
    })??;
    Ok(Some(operator))
}
