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

/// Checks the fields, leaves out what is zero, and forms the product.
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
    let mut row_of = [0; 3];
    let mut wanted = 0;
    let fields = displacements.by_axis();
    for (receiver, field) in fields.iter().enumerate() {
        if field.is_some() {
            for input in 0..given {
                terms[wanted][input] = term(Axis::ALL[receiver], sources[input])?;
            }
            row_of[receiver] = wanted;
            wanted += 1;
        }
    }
    // From here on nothing can fail. Displacements without a term are zero.
    let mut outputs: [&mut [f64]; 3] = [&mut [], &mut [], &mut []];
    let mut used: Terms<'_> = [[None; 3]; 3];
    let mut count = 0;
    for (receiver, field) in fields.into_iter().enumerate() {
        let Some(field) = field else { continue };
        let row = terms[row_of[receiver]];
        if row.iter().all(Option::is_none) {
            field.fill(0.0);
        } else {
            (outputs[count], used[count]) = (field, row);
            count += 1;
        }
    }
    if count > 0 {
        plan.product(&inputs[..given], &used, &mut outputs[..count], workspace);
    }
    Ok(())
}
