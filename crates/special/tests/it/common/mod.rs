//! The error statistics of a function against a reference table.

/// Errors of a function, in units of 2.2e-16.
#[derive(Default)]
pub(crate) struct Errors(Vec<(f64, String)>);

impl Errors {
    /// Counts one value; `floor` is the size below which the error counts as absolute.
    pub(crate) fn push(
        &mut self,
        value: f64,
        reference: f64,
        floor: f64,
        place: impl Fn() -> String,
    ) {
        assert!(!value.is_nan(), "undefined at {}", place());
        // Both infinite or equal below the normal range: no error.
        let error = if value == reference {
            0.0
        } else {
            let grain = reference.abs().max(floor).max(f64::MIN_POSITIVE);
            (value - reference).abs() / grain / f64::EPSILON
        };
        self.0.push((error, place()));
    }

    /// Prints maximum and 99 % and returns the maximum.
    pub(crate) fn report(mut self, name: &str) -> f64 {
        self.0.sort_by(|x, y| x.0.total_cmp(&y.0));
        let (maximum, place) = self.0.last().expect("values");
        let most = self.0[(self.0.len() - 1) * 99 / 100].0;
        println!(
            "{name:<24} {:>6} values  99 % {most:>8.2} eps  max {maximum:>8.2} eps at {place}",
            self.0.len()
        );
        *maximum
    }
}
