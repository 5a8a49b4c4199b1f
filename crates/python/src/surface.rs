//! Height maps: read, cut, levelled, filled and measured.

use carom_surface::{Crop, Level, Measures, Reading, Topography, read, spectrum, spikes};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::Numbers;
use crate::error::Fault;
use crate::records::arrays;
use crate::threads::without_python;

/// A map: number of columns, heights row by row, spacing along x and y in m.
type Map<'py> = (usize, Bound<'py, PyArray1<f64>>, Option<[f64; 2]>);

/// Reads the bytes of a file: the map in m, whether its unit is known, and notes.
#[pyfunction]
pub(crate) fn surface_read<'py>(
    py: Python<'py>,
    bytes: &[u8],
    unit: Option<f64>,
    range: Option<f64>,
) -> PyResult<(Map<'py>, bool, Vec<String>)> {
    let reading = Reading { unit, range, ..Reading::default() };
    let measured = read(bytes, &carom_cases::heights::within_memory(reading));
    let measured = measured.map_err(Fault::other)?;
    Ok((map(py, measured.topography), measured.has_unit, measured.notes))
}

fn map(py: Python<'_>, of: Topography) -> Map<'_> {
    let (columns, spacing) = (of.columns(), of.spacing());
    (columns, PyArray1::from_vec(py, of.into_heights()), spacing)
}

fn topography(
    columns: usize,
    heights: &Numbers<'_>,
    spacing: Option<[f64; 2]>,
) -> PyResult<Topography> {
    let map = Topography::new(columns, heights.as_slice()?.to_vec()).map_err(Fault::other)?;
    Ok(map.spaced(spacing))
}

/// A part of a map, levelled, and filled on request.
#[pyfunction]
#[pyo3(signature = (columns, heights, spacing, crop, level, fill))]
pub(crate) fn surface_prepared<'py>(
    py: Python<'py>,
    columns: usize,
    heights: Numbers<'py>,
    spacing: Option<[f64; 2]>,
    crop: Option<[usize; 4]>,
    level: Option<&str>,
    fill: bool,
) -> PyResult<Map<'py>> {
    let mut own = topography(columns, &heights, spacing)?;
    if let Some(crop) = crop {
        own = own.cropped(Crop(crop)).map_err(Fault::other)?;
    }
    if let Some(level) = level {
        let level: Level = level
            .parse()
            .map_err(|allowed| Fault::other(format!("level = {level:?}: {allowed}")))?;
        own = own.levelled(level);
    }
    Ok(map(py, if fill { own.filled() } else { own }))
}

/// The measures of a map, and what should be mended.
#[pyfunction]
pub(crate) fn surface_measures<'py>(
    py: Python<'py>,
    columns: usize,
    heights: Numbers<'py>,
    spacing: Option<[f64; 2]>,
    periodic: bool,
) -> PyResult<(Bound<'py, PyDict>, Vec<String>)> {
    let own = topography(columns, &heights, spacing)?;
    let measures = without_python(py, || {
        Measures::of(&own, spectrum(&own, periodic).as_ref(), &spikes(&own))
    })?;
    let warnings = measures.warnings(periodic);
    Ok((arrays(py, Measures::COLUMNS, &[measures])?, warnings))
}
