//! The result of a fit, as tables.

use carom_table::{Column, Value};

/// What data tell of an unknown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Knowledge {
    /// They determine it, if it has no prior perhaps only with that of another unknown.
    Data,
    /// Only its prior does.
    Prior,
    /// Nothing does: its value is one of many that fit as well.
    Nothing,
    /// The best value lies at a bound.
    AtBound,
}

impl Knowledge {
    /// Its word.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Data => "data",
            Self::Prior => "prior",
            Self::Nothing => "nothing",
            Self::AtBound => "at its bound",
        }
    }
}

/// An unknown with its best value and its intervals.
#[derive(Debug, Clone, PartialEq)]
pub struct Determined {
    /// Its field with the path.
    pub parameter: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// The best value.
    pub value: f64,
    /// Its standard error.
    pub deviation: Option<f64>,
    /// The interval of 95 % about it.
    pub interval: Option<[f64; 2]>,
    /// The interval of 95 % by the profile of the sum of squares.
    pub profile: Option<[f64; 2]>,
    /// What determines it.
    pub knowledge: Knowledge,
}

impl Determined {
    /// The columns of the unknowns.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::text("parameter", "", "field of the case", |one| one.parameter.into()),
        Column::new("value", "", "best value, in the unit beside", |one| {
            (one.knowledge != Knowledge::Nothing).then_some(one.value).into()
        }),
        Column::text("unit", "", "unit of the numbers in this row", |one| one.unit.into()),
        Column::new("sd", "", "standard error", |one| one.deviation.into()),
        Column::new("low", "", "lower end of the interval of 95 %", |one| end(one.interval, 0)),
        Column::new("high", "", "upper end", |one| end(one.interval, 1)),
        Column::new("profile_low", "", "lower end by the profile of the sum of squares", |one| {
            end(one.profile, 0)
        }),
        Column::new("profile_high", "", "upper end by it", |one| end(one.profile, 1)),
        Column::text("determined_by", "", "data, prior, nothing, or at its bound", |one| {
            one.knowledge.name().into()
        }),
    ];
}

fn end(interval: Option<[f64; 2]>, which: usize) -> Value {
    interval.map(|ends| ends[which]).into()
}

/// A measured value beside the fitted one.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// The row of the data, from 1.
    pub row: usize,
    /// The measured quantity.
    pub quantity: String,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// The measured value.
    pub measured: f64,
    /// Its standard error, given or estimated.
    pub error: f64,
    /// The fitted value.
    pub fitted: f64,
    /// How much it determines its own fitted value, from 0 to 1.
    pub leverage: f64,
    /// Its weight in the fit, 1 with squares.
    pub weight: f64,
}

impl Point {
    /// The columns of the measured values.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::count("row", "", "row of the data", |point| (point.row as u64).into()),
        Column::text("quantity", "", "measured quantity", |point| point.quantity.clone().into()),
        Column::text("unit", "", "unit of the three numbers behind", |point| point.unit.into()),
        Column::new("measured", "", "measured value", |point| point.measured.into()),
        Column::new("error", "", "its standard error, given or estimated", |p| p.error.into()),
        Column::new("fitted", "", "fitted value", |point| point.fitted.into()),
        Column::new("residual", "", "measured less fitted, over the standard error", |point| {
            point.residual().into()
        }),
        Column::new("leverage", "", "how much it determines its own fit, 0 to 1", |point| {
            point.leverage.into()
        }),
        Column::new("weight", "", "weight in the fit, 1 with squares", |p| p.weight.into()),
    ];

    /// Measured less fitted, over the standard error.
    #[must_use]
    pub fn residual(&self) -> f64 {
        (self.measured - self.fitted) / self.error
    }
}

/// The correlation of two unknowns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Correlation {
    /// Both fields.
    pub pair: [&'static str; 2],
    /// From -1 to 1.
    pub value: f64,
}

impl Correlation {
    /// The columns of the correlations.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::text("first", "", "an unknown", |one| one.pair[0].into()),
        Column::text("second", "", "another one", |one| one.pair[1].into()),
        Column::new("correlation", "", "of both, from -1 to 1", |one| one.value.into()),
    ];
}

/// How well the theory meets the data.
#[derive(Debug, Clone, PartialEq)]
pub struct Quality {
    /// The number of measured values.
    pub measured: usize,
    /// The number of unknowns.
    pub unknowns: usize,
    /// Measured values and priors less what they determine.
    pub freedom: usize,
    /// The sum of squares over the standard errors.
    pub chi_squared: f64,
    /// Whether standard errors were given, so that chi^2 judges the theory.
    pub has_errors: bool,
    /// The standard errors that were estimated: quantity, error and unit.
    pub estimated: Vec<(String, f64, &'static str)>,
    /// How residuals count.
    pub loss: &'static str,
}

impl Quality {
    /// The columns of the quality.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::count("measured_values", "", "number of measured values", |quality| {
            (quality.measured as u64).into()
        }),
        Column::count("unknowns", "", "number of unknowns", |q| (q.unknowns as u64).into()),
        Column::count(
            "degrees_of_freedom",
            "",
            "measured values beyond what they determine",
            |q| (q.freedom as u64).into(),
        ),
        Column::new("chi2", "", "sum of the squares of residual over error", |quality| {
            quality.has_errors.then_some(quality.chi_squared).into()
        }),
        Column::new("chi2_per_degree", "", "about 1 if theory and errors are right", |quality| {
            quality.chi_squared_per_degree().into()
        }),
        Column::text(
            "estimated_errors",
            "",
            "standard errors, estimated from the residuals",
            |q| match q.estimated.as_slice() {
                [] => Value::Absent,
                errors => errors.iter().map(told_error).collect::<Vec<_>>().into(),
            },
        ),
        Column::text("loss", "", "how residuals count", |quality| quality.loss.into()),
    ];

    /// chi^2 over the degrees of freedom; none without any, or if all errors were estimated.
    #[must_use]
    pub fn chi_squared_per_degree(&self) -> Option<f64> {
        (self.has_errors && self.freedom > 0).then(|| self.chi_squared / self.freedom as f64)
    }
}

fn told_error((name, error, unit): &(String, f64, &'static str)) -> String {
    format!("{name} {} {unit}", carom_table::short(*error)).trim_end().to_owned()
}

/// A prediction with the fitted numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Prediction {
    /// The row of the inputs, from 1.
    pub row: usize,
    /// The quantity.
    pub quantity: String,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// The predicted value.
    pub value: f64,
    /// The interval of 95 % of the prediction, by the uncertainty of the unknowns alone.
    pub interval: Option<[f64; 2]>,
}

impl Prediction {
    /// The columns of predictions.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::count("row", "", "row of the inputs", |one| (one.row as u64).into()),
        Column::text("quantity", "", "predicted quantity", |one| one.quantity.clone().into()),
        Column::text("unit", "", "unit of the numbers behind", |one| one.unit.into()),
        Column::new("value", "", "predicted value", |one| one.value.into()),
        Column::new("low", "", "lower end of 95 %, by the unknowns", |one| end(one.interval, 0)),
        Column::new("high", "", "upper end", |one| end(one.interval, 1)),
    ];
}

/// The fit of a case to data.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// The unknowns in the order of the case.
    pub parameters: Vec<Determined>,
    /// The measured values beside the fitted ones.
    pub points: Vec<Point>,
    /// The correlations of the unknowns that are determined.
    pub correlations: Vec<Correlation>,
    /// How well the theory meets the data.
    pub quality: Quality,
    /// What the data tell and leave open, in sentences.
    pub statements: Vec<String>,
    /// What should be looked at.
    pub warnings: Vec<String>,
    /// The predictions asked for.
    pub predictions: Vec<Prediction>,
    /// The fit over the input that varies, for a picture.
    pub curve: Option<Curve>,
}

/// The fit over the one input that varies.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The input and its unit.
    pub input: (String, &'static str),
    /// The values of the input in the data, row by row.
    pub given: Vec<f64>,
    /// The values of the input of the curve.
    pub along: Vec<f64>,
    /// For each measured quantity its name, its unit, and the predictions along the curve.
    pub lines: Vec<(String, &'static str, Vec<Prediction>)>,
}
