//! The product of a block matrix of spectra with the fields that are given and wanted.

use super::plan::Plan;
use super::spectrum::Spectrum;
use super::{Axis, DisplacementField, OperatorError, TractionField, Workspace};

/// One entry of the block matrix of spectra: `sign` times the spectrum.
#[derive(Clone, Copy)]
pub(crate) struct Term<'a> {
    pub(crate) spectrum: &'a Spectrum,
    pub(crate) sign: f64,
}

/// The terms of a product: `terms[output][input]`; `None` is zero.
pub(crate) type Terms<'a> = [[Option<Term<'a>>; 3]; 3];

/// Checks the fields and forms the product.
pub(crate) fn apply<'s>(
    plan: &Plan,
    term: impl Fn(Axis, Axis) -> Result<Option<Term<'s>>, OperatorError>,
    tractions: TractionField<'_>,
    displacements: DisplacementField<'_>,
    workspace: &mut Workspace,
) -> Result<(), OperatorError> {
    let cells = plan.sizes.nx * plan.sizes.ny;
    tractions.check(cells)?;
    displacements.check(cells)?;

    let mut inputs: [&[f64]; 3] = [&[]; 3];
    let mut sources = [Axis::X; 3];
    let mut given = 0;
    for (axis, values) in Axis::ALL.into_iter().zip(tractions.by_axis()) {
        if let Some(values) = values {
            (inputs[given], sources[given]) = (values, axis);
            given += 1;
        }
    }
    let mut terms: Terms<'_> = [[None; 3]; 3];
    let mut outputs: [&mut [f64]; 3] = [&mut [], &mut [], &mut []];
    let mut wanted = 0;
    for (receiver, field) in displacements.by_axis().into_iter().enumerate() {
        let Some(field) = field else { continue };
        for input in 0..given {
            terms[wanted][input] = term(Axis::ALL[receiver], sources[input])?;
        }
        outputs[wanted] = field;
        wanted += 1;
    }
    // From here on nothing can fail.
    reduced(plan, &inputs[..given], &terms, &mut outputs[..wanted], workspace);
    Ok(())
}

/// The product without the fields that vanish and without the results that no other field reaches: a
/// shift along one axis costs half where the other tangential traction is zero everywhere.
pub(crate) fn reduced(
    plan: &Plan,
    inputs: &[&[f64]],
    terms: &Terms<'_>,
    outputs: &mut [&mut [f64]],
    workspace: &mut Workspace,
) {
    let mut fields: [&[f64]; 3] = [&[]; 3];
    let mut columns = [0; 3];
    let mut given = 0;
    for (column, &values) in inputs.iter().enumerate() {
        // What is not a number is not zero, either.
        if values.iter().any(|&value| value != 0.0) {
            (fields[given], columns[given]) = (values, column);
            given += 1;
        }
    }
    let mut reached: [&mut [f64]; 3] = [&mut [], &mut [], &mut []];
    let mut used: Terms<'_> = [[None; 3]; 3];
    let mut count = 0;
    for (row, field) in outputs.iter_mut().enumerate() {
        let of_row: [_; 3] =
            std::array::from_fn(|at| if at < given { terms[row][columns[at]] } else { None });
        if of_row.iter().all(Option::is_none) {
            field.fill(0.0);
        } else {
            (reached[count], used[count]) = (field, of_row);
            count += 1;
        }
    }
    if count > 0 {
        plan.product(&fields[..given], &used, &mut reached[..count], workspace);
    }
}
