//! Influence numbers from a file: CSV, NPZ, or the format of the program CONTACT.

use crate::Error;
use crate::case::InfluenceFile;
use crate::input::CaseFile;
use carom_halfspace::operator::{
    Blocks, InflcfUnits, KernelBlock, KernelOperator, OperatorError, TabulatedKernel, Threads,
};
use carom_halfspace::{Grid, MaterialPair};
use carom_surface::Reading;
use std::io::{Cursor, Read as _};
use zip::ZipArchive;

/// Metres in the unit of length of a file of CONTACT.
const MILLIMETRE: f64 = 1e-3;

/// The operator of the numbers in the file that the case names, and the content of the file. The numbers must obey
/// Betti's theorem, and tractions of the kind `blocks` do positive work.
///
/// # Errors
/// [`ErrorKind::Input`](crate::ErrorKind::Input).
pub(super) fn operator(
    case: &CaseFile,
    influence: &InfluenceFile,
    grid: Grid,
    materials: MaterialPair,
    blocks: Blocks,
) -> Result<(KernelOperator, Vec<u8>), Error> {
    let file = &influence.file;
    let refused = |reason: String| Error::input(reason).of_file(&case.beside(file));
    let told = |error: OperatorError| refused(error.to_string());
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let (kernel, read) = match ending.to_ascii_lowercase().as_str() {
        "csv" => {
            let text = case.table(file)?;
            let kernel = TabulatedKernel::from_csv(grid, &text).map_err(told)?;
            (kernel.scaled(influence.scale).map_err(told)?, text.into_bytes())
        }
        "npz" => {
            let bytes = case.bytes(file)?;
            let blocks = arrays(&bytes, grid).map_err(refused)?;
            let kernel = TabulatedKernel::from_blocks(grid, &blocks).map_err(told)?;
            (kernel.scaled(influence.scale).map_err(told)?, bytes)
        }
        _ => {
            let text = case.table(file)?;
            let kernel = of_contact(&text, grid, materials, MILLIMETRE).map_err(told)?;
            (kernel, text.into_bytes())
        }
    };
    Ok((checked(kernel, blocks).map_err(told)?, read))
}

/// The same of a file of CONTACT, in its units: lengths in mm, moduli in N/mm^2.
///
/// # Errors
/// As [`operator`].
pub(crate) fn influence_of_contact(
    case: &CaseFile,
    influence: &InfluenceFile,
    grid: Grid,
    materials: MaterialPair,
    blocks: Blocks,
) -> Result<KernelOperator, Error> {
    let text = case.table(&influence.file)?;
    let kernel = of_contact(&text, grid, materials, 1.0);
    kernel
        .and_then(|kernel| checked(kernel, blocks))
        .map_err(|error| Error::input(error.to_string()).of_file(&case.beside(&influence.file)))
}

/// The numbers of a file of CONTACT, whose millimetre has this length.
fn of_contact(
    text: &str,
    grid: Grid,
    materials: MaterialPair,
    millimetre: f64,
) -> Result<TabulatedKernel, OperatorError> {
    // CONTACT's modulus of a pair is that of each of two equal bodies.
    let units = InflcfUnits::new(millimetre, 2.0 * materials.shear_modulus())?;
    TabulatedKernel::from_inflcf(grid, text, units)
}

/// The operator of numbers that obey Betti's theorem and do positive work.
fn checked(kernel: TabulatedKernel, blocks: Blocks) -> Result<KernelOperator, OperatorError> {
    let threads = Threads::for_grid(kernel.grid());
    let operator = KernelOperator::new(kernel.reciprocal()?, threads)?;
    operator.check_definite(blocks)?;
    Ok(operator)
}

/// The arrays of an NPZ, as `numpy.savez` writes it.
fn arrays(bytes: &[u8], grid: Grid) -> Result<Vec<KernelBlock>, String> {
    let broken = |error: &dyn std::fmt::Display| {
        format!(
            "this is not an .npz file of `numpy.savez`, or it is damaged or compressed: {error}"
        )
    };
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| broken(&error))?;
    let most = [2 * grid.nx() - 1, 2 * grid.ny() - 1];
    let mut blocks = Vec::new();
    for i in 0..archive.len() {
        let mut file = archive.by_index(i).map_err(|error| broken(&error))?;
        let name = file.name().map_err(|error| broken(&error))?;
        let name = name.strip_suffix(".npy").unwrap_or(&name).to_owned();
        let mut data = Vec::new();
        file.read_to_end(&mut data).map_err(|error| broken(&error))?;
        let rows = rows(&data, most).map_err(|said| format!("array \"{name}\": {said}"))?;
        blocks.push(KernelBlock::new(&name, &rows).map_err(|error| error.to_string())?);
    }
    Ok(blocks)
}

/// The rows of an array with at most so many columns and rows.
fn rows(data: &[u8], [columns, rows]: [usize; 2]) -> Result<Vec<Vec<f64>>, String> {
    let reading = Reading { most_points: columns * rows, ..Reading::default() };
    let map = carom_surface::read(data, &reading).map_err(|error| error.to_string())?.topography;
    match map.columns() > columns || map.rows() > rows {
        true => {
            let (columns, rows) = (map.columns(), map.rows());
            Err(format!("{columns} columns and {rows} rows: more than the grid has"))
        }
        false => Ok(map.heights().chunks_exact(map.columns()).map(<[f64]>::to_vec).collect()),
    }
}
