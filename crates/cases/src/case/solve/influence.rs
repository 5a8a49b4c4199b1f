//! Influence numbers of bodies that are no half-spaces: `bodies.influence`.

use super::{ACCURACY, Border, GRID, GridCase, PERIODIC};
use crate::case::error::CaseError;
use crate::case::field::{Default, Field, Form};
use crate::case::range::Range;
use crate::case::section::Section;
use std::path::PathBuf;

const FILE: Field = Field::new(
    "file",
    Form::Text("the name of a file .csv or .npz, or of influence coefficients of CONTACT"),
    "displacements due to unit tractions on one cell: columns `columns`, `rows` (the offset, source minus \
     receiver, in cells) and `xx` to `zz` (displacement, then traction) of a CSV, arrays `xx` to `zz` of an \
     NPZ; any other ending is read as a file `inflcf` of the program CONTACT, in millimetres",
)
.such_as("\"layer.csv\"");
const SCALE: Field = Field::number(
    "scale",
    Range::Positive.pure(),
    "metres per pascal of one unit of a CSV or NPZ; a file of CONTACT has units of its own",
)
.default(Default::Number(1.0));
/// The field `influence` of a case.
pub(in crate::case) const INFLUENCE: Field = Field::new(
    "influence",
    Form::Table(&[FILE, SCALE]),
    "influence numbers of both bodies together, for the cells of the grid, instead of half-spaces",
)
.may("the bodies are half-spaces")
.such_as("{ file = \"layer.csv\" }");

/// A file of influence numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct InfluenceFile {
    /// A file .csv, .npz or of the program CONTACT; relative to the case file.
    pub file: PathBuf,
    /// Metres per pascal of one unit of a CSV or NPZ.
    pub scale: f64,
}

/// Reads the table `influence` of the table `bodies`, whose field in the case is `place`.
pub(in crate::case) fn read(
    case: &Section<'_>,
    place: &Field,
    grid: GridCase,
) -> Result<Option<InfluenceFile>, CaseError> {
    if !case.has(place) {
        return Ok(None);
    }
    let bodies = case.section(place)?;
    if !bodies.has(&INFLUENCE) {
        return Ok(None);
    }
    let given = bodies.section(&INFLUENCE)?;
    let read = InfluenceFile { file: given.text(&FILE)?.into(), scale: given.number(&SCALE)? };
    let place = [place, &INFLUENCE];
    match grid {
        GridCase::Accuracy(_) => {
            let reason = "influence numbers belong to the cells of a grid; give `cells` and `size`";
            Err(case.conflict([&GRID, &ACCURACY], place, reason))
        }
        _ if grid.border() == Border::Periodic => {
            let reason = "influence numbers are those of bodies without a period";
            Err(case.conflict([&GRID, &PERIODIC], place, reason))
        }
        GridCase::Cells { .. } | GridCase::OfFile { .. } => Ok(Some(read)),
    }
}
