//! Fields that are lists of a given number of numbers, and rows of them.

use super::Section;
use crate::case::error::CaseError;
use crate::case::unit::Measure;
use toml::Spanned;
use toml::de::DeValue;

impl<'a> Section<'a> {
    /// Three numbers in their range.
    ///
    /// # Errors
    /// If they are missing, not three numbers, or one is out of range.
    pub(crate) fn vector(
        &self,
        name: &str,
        measure: impl Into<Measure>,
    ) -> Result<[f64; 3], CaseError> {
        self.array(name, ["x", "y", "z"], measure, "three numbers [x, y, z]")
    }

    /// As many numbers in their range as `parts` names; `allowed` says so in words.
    ///
    /// # Errors
    /// If they are missing, more or fewer, or one is out of range.
    pub(crate) fn array<const N: usize>(
        &self,
        name: &str,
        parts: [&str; N],
        measure: impl Into<Measure>,
        allowed: &'static str,
    ) -> Result<[f64; N], CaseError> {
        let measure = measure.into();
        let value = self.find(name).ok_or_else(|| self.missing(name, allowed))?;
        let items = match value.get_ref() {
            DeValue::Array(items) if items.iter().count() == N => items,
            _ => return Err(self.kind(name, value, allowed)),
        };
        let mut numbers = [0.0; N];
        for ((number, item), part) in numbers.iter_mut().zip(items.iter()).zip(parts) {
            *number = self.as_number(&format!("{name}.{part}"), item, measure)?;
        }
        Ok(numbers)
    }

    /// Whether the field is there and a list.
    #[must_use]
    pub(crate) fn is_list(&self, name: &str) -> bool {
        matches!(self.find(name).map(Spanned::get_ref), Some(DeValue::Array(_)))
    }

    /// Rows of N numbers, each in its range, at least one row; a row may lack its last number, which is
    /// then 0. `allowed` says so in words.
    ///
    /// # Errors
    /// If they are missing, of another kind, or a number is out of range.
    pub(crate) fn rows<const N: usize>(
        &self,
        name: &str,
        measures: [Measure; N],
        allowed: &'static str,
    ) -> Result<Vec<[f64; N]>, CaseError> {
        let value = self.find(name).ok_or_else(|| self.missing(name, allowed))?;
        match value.get_ref() {
            DeValue::Array(rows) if rows.iter().next().is_some() => rows
                .iter()
                .enumerate()
                .map(|(i, row)| self.row(&format!("{name}[{i}]"), row, measures, allowed))
                .collect(),
            _ => Err(self.kind(name, value, allowed)),
        }
    }

    fn row<const N: usize>(
        &self,
        name: &str,
        value: &'a Spanned<DeValue<'a>>,
        measures: [Measure; N],
        allowed: &'static str,
    ) -> Result<[f64; N], CaseError> {
        let items = match value.get_ref() {
            DeValue::Array(items) if matches!(items.iter().count(), n if n == N || n + 1 == N) => {
                items
            }
            _ => return Err(self.kind(name, value, allowed)),
        };
        let mut numbers = [0.0; N];
        for ((number, item), measure) in numbers.iter_mut().zip(items.iter()).zip(measures) {
            *number = self.as_number(name, item, measure)?;
        }
        Ok(numbers)
    }
}
