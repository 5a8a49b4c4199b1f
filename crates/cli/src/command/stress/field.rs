//! The stresses at all points as a file for other programs: NumPy arrays or a VTK grid.

use crate::command::npz::{self, Array};
use crate::error::CliError;
use crate::outputs::{Outputs, Place};
use carom_cases::case::StressCase;
use carom_cases::stress::StressPoint;
use carom_table::{Column, Value};
use std::collections::BTreeMap;
use std::path::Path;

/// A file for the stresses.
pub(super) struct FieldFile {
    place: Place,
    kind: Kind,
}

enum Kind {
    Npz,
    Vtk,
}

impl FieldFile {
    /// The file of `--field`; nothing is written yet.
    ///
    /// # Errors
    /// [`CliError::Destination`] unless its name ends in `.npz` or `.vtk` and it may be written.
    pub(super) fn new(path: &Path, outputs: &mut Outputs) -> Result<Self, CliError> {
        const OPTION: &str = "field";
        let is = |ending: &str| {
            path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(ending))
        };
        let kind = match () {
            () if is("npz") => Kind::Npz,
            () if is("vtk") => Kind::Vtk,
            () => {
                let reason = "a field's name must end in .npz or .vtk";
                return Err(CliError::Destination {
                    option: OPTION,
                    path: path.to_owned(),
                    reason,
                });
            }
        };
        Ok(Self { place: outputs.file(OPTION, path)?, kind })
    }

    /// Its place and its content.
    ///
    /// # Errors
    /// [`CliError::Case`] with the error of the archive.
    pub(super) fn encoded(
        self,
        case: &StressCase,
        points: &[StressPoint],
    ) -> Result<(Place, Vec<u8>), CliError> {
        let bytes = match self.kind {
            Kind::Npz => npz::encode(&arrays(case, points))
                .map_err(|source| CliError::io("write", self.place.path(), source))?,
            Kind::Vtk => grid(case, points),
        };
        Ok((self.place, bytes))
    }
}

fn number(column: &Column<StressPoint>, point: &StressPoint) -> f64 {
    match column.value(point) {
        Value::Number(number) => number,
        _ => f64::NAN,
    }
}

/// x, y and depth, and each column as an array over depth, y and x.
fn arrays(case: &StressCase, points: &[StressPoint]) -> BTreeMap<String, Array> {
    let (axes, stresses) = StressPoint::COLUMNS.split_at(3);
    let shape: Vec<usize> = case.places.iter().rev().map(Vec::len).collect();
    let along = axes.iter().zip(&case.places).map(|(column, places)| {
        (column.name().to_owned(), Array::Numbers(vec![places.len()], places.clone()))
    });
    let over = stresses.iter().map(|column| {
        let values = points.iter().map(|point| number(column, point)).collect();
        (column.name().to_owned(), Array::Numbers(shape.clone(), values))
    });
    along.chain(over).collect()
}

/// A structured grid in VTK's legacy format, big-endian. z points into body 1: body 2 lies below.
fn grid(case: &StressCase, points: &[StressPoint]) -> Vec<u8> {
    let (body, side) = if case.is_in_body_1 { ("body 1", 1.0) } else { ("body 2", -1.0) };
    let [nx, ny, nz] = case.places.each_ref().map(Vec::len);
    let count = points.len();
    let mut file = format!(
        "# vtk DataFile Version 3.0\ncarom: stresses in {body}, SI units\nBINARY\n\
         DATASET STRUCTURED_GRID\nDIMENSIONS {nx} {ny} {nz}\nPOINTS {count} double\n"
    )
    .into_bytes();
    let mut put = |head: &str, numbers: &mut dyn Iterator<Item = f64>| {
        file.extend(head.as_bytes());
        file.extend(numbers.flat_map(f64::to_be_bytes));
        file.push(b'\n');
    };
    put("", &mut points.iter().flat_map(|p| [p.at[0], p.at[1], side * p.at[2]]));
    let mut head = format!("POINT_DATA {count}\n");
    for name in ["von_mises", "maximum_shear"] {
        head += &format!("SCALARS {name} double 1\nLOOKUP_TABLE default\n");
        let columns = StressPoint::COLUMNS.iter().filter(|column| column.name() == name);
        put(&head, &mut columns.flat_map(|c| points.iter().map(move |point| number(c, point))));
        head.clear();
    }
    put(
        "TENSORS stress double\n",
        &mut points.iter().flat_map(|StressPoint { stress: s, .. }| {
            [s.xx, s.xy, s.zx, s.xy, s.yy, s.yz, s.zx, s.yz, s.zz]
        }),
    );
    file
}
