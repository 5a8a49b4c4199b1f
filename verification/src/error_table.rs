//! A table of errors in eps: maximum and 99 % of each function over a set of reference values.

use crate::{Cell, Claim, Failure, Figure, Table};

/// Columns of numbers with their names, from comma-separated text.
pub(crate) struct Reference {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Reference {
    /// The table in `text`.
    ///
    /// # Errors
    /// If the text is not a table of numbers below a line of names.
    pub(crate) fn parse(text: &str) -> Result<Self, Failure> {
        let mut reader = crate::reference::reader(text);
        let names = reader.headers()?.iter().map(str::to_owned).collect();
        let mut rows = Vec::new();
        for record in reader.records() {
            rows.push(record?.iter().map(str::parse).collect::<Result<_, _>>()?);
        }
        Ok(Self { names, rows })
    }

    /// The rows, with the columns in the order of the text.
    pub(crate) fn rows(&self) -> &[Vec<f64>] {
        &self.rows
    }

    /// The position of a column.
    ///
    /// # Errors
    /// If there is none of this name.
    pub(crate) fn column(&self, name: &str) -> Result<usize, String> {
        let found = self.names.iter().position(|n| n == name);
        found.ok_or_else(|| format!("no column {name}"))
    }
}

/// The errors of one function, in eps.
pub(crate) struct Errors {
    function: String,
    /// Below this size of the reference the error counts as absolute.
    floor: f64,
    found: Vec<Error>,
}

struct Error {
    eps: f64,
    place: String,
}

impl Errors {
    /// No errors yet of `function`, relative where the reference is above `floor`, else of `floor`.
    pub(crate) fn of(function: impl Into<String>, floor: f64) -> Self {
        Self { function: function.into(), floor, found: Vec::new() }
    }

    /// Counts a value; one that is not a number is an infinite error.
    pub(crate) fn add(&mut self, value: f64, reference: f64, place: impl Into<String>) {
        let grain = reference.abs().max(self.floor).max(f64::MIN_POSITIVE) * f64::EPSILON;
        let eps = if value == reference { 0.0 } else { (value - reference).abs() / grain };
        let eps = if eps.is_nan() { f64::INFINITY } else { eps };
        self.found.push(Error { eps, place: place.into() });
    }
}

/// The errors of several functions, each with its target.
pub(crate) struct ErrorTable {
    table: Table,
    claims: Vec<Claim>,
}

impl ErrorTable {
    /// An empty table.
    pub(crate) fn new(title: &str) -> Self {
        let columns = ["function", "values", "99 % / eps", "max / eps", "target / eps", "worst at"];
        Self { table: Table::new(title, columns), claims: Vec::new() }
    }

    /// Adds a function whose errors must stay below `target` eps.
    ///
    /// The snapshot omits the errors: last bits may differ between machines, the claims hold on all.
    pub(crate) fn add(&mut self, mut errors: Errors, target: f64) {
        errors.found.sort_by(|x, y| x.eps.total_cmp(&y.eps));
        let count = errors.found.len();
        let Some(worst) = errors.found.last() else { return };
        let most = errors.found[(count - 1) * 99 / 100].eps;
        self.table.row([
            Cell::Text(errors.function.clone()),
            Cell::Number(count as f64),
            Cell::Remark(format!("{most:.2}")),
            Cell::Remark(format!("{:.2}", worst.eps)),
            Cell::Number(target),
            Cell::Remark(worst.place.clone()),
        ]);
        let statement = format!("{}: largest error in eps", errors.function);
        self.claims.push(
            Claim::at_most(statement, worst.eps, target).source("references of 22 digits and more"),
        );
    }

    /// Hands table and claims to a figure.
    pub(crate) fn finish(self, figure: &mut Figure) {
        figure.table(self.table);
        self.claims.into_iter().for_each(|claim| figure.claim(claim));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_in_eps_and_the_worst_is_named() {
        let mut errors = Errors::of("f", 0.1);
        errors.add(1.0 + 2.0 * f64::EPSILON, 1.0, "one");
        errors.add(f64::EPSILON, 0.0, "zero");
        let mut table = ErrorTable::new("t");
        table.add(errors, 5.0);
        assert_eq!(table.table.rows[0][3], Cell::Remark("10.00".to_owned()));
        assert_eq!(table.table.rows[0][5], Cell::Remark("zero".to_owned()));
        assert!(!table.claims[0].passes());
    }

    #[test]
    fn not_a_number_fails() {
        let mut errors = Errors::of("f", 0.0);
        errors.add(f64::NAN, 1.0, "");
        let mut table = ErrorTable::new("t");
        table.add(errors, 5.0);
        assert!(!table.claims[0].passes());
    }
}
