//! Which columns of the data are inputs, measured values and errors.

use crate::FitError;
use crate::data::{Data, DataColumn, split};
use crate::measured::{Measurement, Quantity};
use crate::observable::{converted, in_dimension};
use carom_cases::case::OpenCase;
use carom_cases::case::{Measure, Renewed, Stated, likely};
use carom_special::Readable;

/// The ending of a column with standard errors.
const ERROR: &str = "_sd";

/// The standard error of the values of a quantity, or without a name of the only one: one of all, or one of each row. A unit
/// may stand behind the name; without it the errors have that of the column of the values.
pub type GivenError = (Option<String>, Vec<f64>);
/// The largest size of a measured value, over its standard error and alone, whose square can be summed.
const LARGEST: f64 = 1e100;

/// The data as a fit needs them.
pub(crate) struct Read<O> {
    /// The numbers of the case that each row replaces.
    pub(crate) inputs: Vec<Input>,
    /// The measured quantities.
    pub(crate) quantities: Vec<(Quantity, O)>,
    pub(crate) measured: Vec<Measurement>,
    /// Columns that are not used.
    pub(crate) unused: Vec<String>,
}

/// A number of the case that each row replaces.
#[derive(Debug, Clone)]
pub(crate) struct Input {
    pub(crate) field: &'static str,
    pub(crate) place: usize,
    pub(crate) unit: &'static str,
    pub(crate) values: Vec<f64>,
}

/// A quantity of an outcome, by name.
pub(crate) trait Known: Sized {
    /// The quantity of this name.
    fn find(name: &str) -> Option<Self>;
    /// The names of all.
    fn names() -> Vec<String>;
    /// Its unit and meaning.
    fn about(&self) -> [&'static str; 2];
}

/// Short names of fields.
const SHORT: &[(&str, &str)] = &[
    ("angle", "approach.angle"),
    ("speed", "approach.speed"),
    ("time", "clock.time"),
    ("zeta", "history.zeta"),
    ("xi", "history.xi"),
    ("eta", "history.eta"),
    ("omega", "history.omega"),
    ("approach", "load.approach"),
    ("force", "load.force"),
];

/// What a column is.
enum Role<O> {
    Input(Stated),
    Measured(O),
    Error(String),
    Unused,
}

/// The inputs of data that have them alone, or measured values beside them, which are not used.
pub(crate) fn inputs<C: Renewed, O: Known>(
    case: &OpenCase<'_, C>,
    data: &Data,
) -> Result<Vec<Input>, FitError> {
    let mut inputs = Vec::new();
    for column in data.columns() {
        if let Role::Input(stated) = role::<C, O>(case, column)? {
            let own = input(column, stated)?;
            refuse_twice(&inputs, &own, column)?;
            inputs.push(own);
        }
    }
    Ok(inputs)
}

/// Refuses a number of the case that two columns give.
fn refuse_twice(inputs: &[Input], own: &Input, column: &DataColumn) -> Result<(), FitError> {
    match inputs.iter().any(|other| other.place == own.place) {
        true => Err(FitError::Table(format!(
            "the column `{}` gives `{}`, which another column gives too: remove one of them",
            column.name, own.field
        ))),
        false => Ok(()),
    }
}

/// Sorts the columns of the data.
pub(crate) fn read<C: Renewed, O: Known>(
    case: &OpenCase<'_, C>,
    data: &Data,
    given: &[GivenError],
) -> Result<Read<O>, FitError> {
    let rows = data.rows();
    let mut read = Read {
        inputs: Vec::new(),
        quantities: Vec::new(),
        measured: Vec::new(),
        unused: Vec::new(),
    };
    let mut errors: Vec<(String, &DataColumn)> = Vec::new();
    let mut values: Vec<Vec<f64>> = Vec::new();
    let mut units: Vec<&str> = Vec::new();
    for column in data.columns() {
        match role::<C, O>(case, column)? {
            Role::Input(stated) => {
                let own = input(column, stated)?;
                refuse_twice(&read.inputs, &own, column)?;
                read.inputs.push(own);
            }
            Role::Measured(own) => {
                let [unit, meaning] = own.about();
                values.push(converted(&column.values, [&column.unit, unit], &column.name)?);
                finite(column, values.last().map_or(&[], Vec::as_slice), true)?;
                units.push(&column.unit);
                let quantity = Quantity { name: column.name.clone(), unit, meaning };
                read.quantities.push((quantity, own));
            }
            Role::Error(of) => errors.push((of, column)),
            Role::Unused => read.unused.push(column.name.clone()),
        }
    }
    if read.quantities.is_empty() {
        let names = O::names().join(", ");
        let own = data.columns().iter().map(|column| format!("`{}`", column.name));
        let own = own.collect::<Vec<_>>().join(", ");
        return Err(FitError::Table(format!(
            "no column is a measured quantity; the columns are {own}, and quantities are {names}"
        )));
    }
    let errors = sorted_errors(&read.quantities, &units, &errors, given, rows)?;
    for row in 0..rows {
        for (quantity, values) in values.iter().enumerate() {
            let (value, error) = (values[row], errors[quantity].as_ref().map(|errors| errors[row]));
            if value.is_nan() {
                continue;
            }
            check_error(&read.quantities[quantity].0.name, row, error)?;
            check_size(&read.quantities[quantity].0.name, row, value, error)?;
            read.measured.push(Measurement { row, quantity, value, error });
        }
    }
    Ok(read)
}

fn check_error(name: &str, row: usize, error: Option<f64>) -> Result<(), FitError> {
    match error {
        Some(error) if !(error > 0.0 && error.is_finite()) => Err(FitError::Entry {
            column: format!("{name}{ERROR}"),
            row: row + 1,
            found: if error.is_nan() { "no number".to_owned() } else { error.to_string() },
            allowed: "a standard error, finite and > 0".to_owned(),
        }),
        _ => Ok(()),
    }
}

fn check_size(name: &str, row: usize, value: f64, error: Option<f64>) -> Result<(), FitError> {
    match value.abs() <= LARGEST * error.unwrap_or(1.0).min(1.0) {
        true => Ok(()),
        false => Err(FitError::Entry {
            column: name.to_owned(),
            row: row + 1,
            found: Readable(value).to_string(),
            allowed: "at most 1e100 in size, and 1e100 standard errors".to_owned(),
        }),
    }
}

/// The standard errors of each quantity, where they are given. Without a unit they have that of their column, of `units`.
fn sorted_errors<O>(
    quantities: &[(Quantity, O)],
    units: &[&str],
    columns: &[(String, &DataColumn)],
    given: &[GivenError],
    rows: usize,
) -> Result<Vec<Option<Vec<f64>>>, FitError> {
    let mut errors: Vec<Option<Vec<f64>>> = vec![None; quantities.len()];
    let find = |name: &str| quantities.iter().position(|(own, _)| own.name == name);
    let in_base = |errors: &[f64], at: usize, unit: &str, name: &str| {
        let unit = if unit.is_empty() { units[at] } else { unit };
        converted(errors, [unit, quantities[at].0.unit], name)
    };
    for (of, column) in columns {
        let Some(at) = find(of) else {
            let reason = format!("there is no column `{of}` whose errors it could hold");
            return Err(FitError::column(&column.name, reason));
        };
        errors[at] = Some(in_base(&column.values, at, &column.unit, &column.name)?);
    }
    for (heading, own) in given {
        let (name, unit) = heading.as_deref().map(split).unwrap_or_default();
        let at = match (heading, quantities.len()) {
            (Some(_), _) => find(&name),
            (None, 1) => Some(0),
            (None, _) => {
                let names: Vec<_> = quantities.iter().map(|(own, _)| own.name.as_str()).collect();
                let reason = format!("a standard error needs its quantity: {}", names.join(", "));
                return Err(FitError::Table(reason));
            }
        };
        let at = at.ok_or_else(|| FitError::column(&name, "the data have no such column"))?;
        let name = &quantities[at].0.name;
        if errors[at].is_some() {
            let other = columns.iter().find(|(of, _)| of == name);
            let beside = other.map_or("", |(_, column)| column.name.as_str());
            return Err(FitError::ErrorsTwice { column: name.clone(), beside: beside.to_owned() });
        }
        let own = in_base(own, at, &unit, name)?;
        errors[at] = Some(match own.as_slice() {
            [one] => {
                check_error(name, 0, Some(*one))?;
                vec![*one; rows]
            }
            all if all.len() == rows => own,
            all => {
                let reason = format!("{} standard errors are given for {rows} rows", all.len());
                return Err(FitError::column(name, reason));
            }
        });
    }
    Ok(errors)
}

fn role<C: Renewed, O: Known>(
    case: &OpenCase<'_, C>,
    column: &DataColumn,
) -> Result<Role<O>, FitError> {
    let name = column.name.as_str();
    let path = SHORT.iter().find(|(short, _)| *short == name).map_or(name, |(_, path)| path);
    if path != name
        && let Ok(stated) = case.stated(path)
    {
        return Ok(Role::Input(stated));
    }
    if let Some(own) = O::find(name) {
        return Ok(Role::Measured(own));
    }
    if let Some(of) = name.strip_suffix(ERROR).filter(|of| O::find(of).is_some()) {
        return Ok(Role::Error(of.to_owned()));
    }
    match case.stated(path) {
        Ok(stated) => Ok(Role::Input(stated)),
        // A field of the kind that the case does not state.
        Err(error) if error.field == path && path.contains('.') && is_missing(&error) => {
            Err(FitError::column(name, error.to_string()))
        }
        Err(_) if path.contains('.') => {
            let reason = "no number of the case has this name; `carom schema` lists the fields";
            Err(FitError::column(name, reason))
        }
        Err(_) => {
            let names = O::names();
            let names: Vec<&str> = names
                .iter()
                .map(String::as_str)
                .chain(SHORT.iter().map(|(short, _)| *short))
                .collect();
            match likely(name, &names) {
                near if near.is_empty() => Ok(Role::Unused),
                near => Err(FitError::column(name, format!("not a quantity{near}"))),
            }
        }
    }
}

fn is_missing(error: &carom_cases::case::CaseError) -> bool {
    matches!(error.fault, carom_cases::case::CaseFault::Missing(_))
}

fn input(column: &DataColumn, Stated { field, place, measure }: Stated) -> Result<Input, FitError> {
    let Measure { range, dimension } = measure;
    let values = in_dimension(&column.values, &column.unit, dimension, &column.name)?;
    finite(column, &values, false)?;
    // A reading before the first touch is no approach.
    let wrong = values.iter().position(|value| !range.holds(*value));
    if let Some(row) = wrong.filter(|_| field != "load.approach") {
        return Err(FitError::Entry {
            column: column.name.clone(),
            row: row + 1,
            found: values[row].to_string(),
            allowed: range.allowed().to_owned(),
        });
    }
    Ok(Input { field, place, unit: dimension.unit(), values })
}

/// Checks that all numbers are finite, or `may` be missing.
fn finite(column: &DataColumn, values: &[f64], may: bool) -> Result<(), FitError> {
    let is_wrong = |value: &f64| value.is_infinite() || (value.is_nan() && !may);
    match values.iter().position(is_wrong) {
        None => Ok(()),
        Some(row) => Err(FitError::Entry {
            column: column.name.clone(),
            row: row + 1,
            found: if values[row].is_nan() {
                "a missing number (NaN)".to_owned()
            } else {
                values[row].to_string()
            },
            allowed: "a finite number".to_owned(),
        }),
    }
}
