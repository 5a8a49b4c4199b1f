//! Unknown numbers of a case from measured data.

use carom_fit::{
    Correlation, Data, Determined, Fit, FitError, GivenError, Loss, Options, Point, Prediction,
    Quality,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::cases::{Source, raised};
use crate::error::CaromError;
use crate::records::arrays;
use crate::threads::beside;
use crate::told::Told;

/// Headings and numbers.
type Table = Vec<(String, Vec<f64>)>;

/// Reads measured data from the text of a file of comma-separated values.
#[pyfunction]
pub(crate) fn fit_table(text: &str) -> PyResult<Table> {
    let data = Data::from_csv(text).map_err(refused)?;
    let heading = |column: &carom_fit::DataColumn| match column.unit.as_str() {
        "" => column.name.clone(),
        unit => format!("{} / {unit}", column.name),
    };
    Ok(data.columns().iter().map(|column| (heading(column), column.values.clone())).collect())
}

/// Fits the case: unknowns, quality, correlations, measured values, predictions, sentences and warnings.
#[pyfunction]
#[allow(clippy::type_complexity)] // as Python has it: tables
pub(crate) fn fit<'py>(
    py: Python<'py>,
    case: Source,
    data: Table,
    errors: Vec<GivenError>,
    robust: bool,
    predict: Option<Table>,
) -> PyResult<([Bound<'py, PyDict>; 5], Vec<String>, Told)> {
    let found = beside(py, || -> Result<Fit, FitError> {
        let data = Data::new(data)?;
        let predict = predict.map(Data::new).transpose()?;
        let loss = if robust { Loss::Huber } else { Loss::Squares };
        let options = Options { errors: &errors, loss, predict: predict.as_ref(), curve: 0 };
        carom_fit::fit(&case.read()?, &data, &options)
    });
    let fit = found?.map_err(refused)?;
    let tables = [
        arrays(py, Determined::COLUMNS, &fit.parameters)?,
        arrays(py, Quality::COLUMNS, std::slice::from_ref(&fit.quality))?,
        arrays(py, Correlation::COLUMNS, &fit.correlations)?,
        arrays(py, Point::COLUMNS, &fit.points)?,
        arrays(py, Prediction::COLUMNS, &fit.predictions)?,
    ];
    Ok((tables, fit.statements, (fit.warnings, false)))
}

fn refused(error: FitError) -> PyErr {
    match error {
        FitError::Case(error) => raised(error),
        error if error.is_bad_input() => PyValueError::new_err(error.to_string()),
        error => CaromError::new_err(error.to_string()),
    }
}
