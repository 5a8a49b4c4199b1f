//! Fields that are lists of a given number of numbers, and rows of them.

use super::Section;
use crate::case::error::CaseError;
use crate::case::field::{Field, Form, Rows};
use crate::case::unit::Measure;
use toml::Spanned;
use toml::de::DeValue;

impl<'a> Section<'a> {
    /// Reads one number for each component of the field.
    ///
    /// # Errors
    /// If the field is missing, has more or fewer numbers, or one is out of range.
    pub(in crate::case) fn vector<const N: usize>(
        &self,
        field: &Field,
    ) -> Result<[f64; N], CaseError> {
        let value = self.value(field)?;
        let (Form::Vector(parts, measure, _) | Form::WordOrVector(_, parts, measure, _)) =
            field.form
        else {
            return Err(self.wrong(field, value));
        };
        let items = match value.get_ref() {
            DeValue::Array(items) if items.iter().count() == N && parts.len() == N => items,
            _ => return Err(self.wrong(field, value)),
        };
        let mut numbers = [0.0; N];
        for ((number, item), part) in numbers.iter_mut().zip(items.iter()).zip(parts) {
            *number = self.as_number(&format!("{}.{part}", field.name), item, measure)?;
        }
        Ok(numbers)
    }

    /// Reads two numbers from a list, or a single one that stands for both.
    ///
    /// # Errors
    /// If the field is missing, of another kind, or a number is out of range.
    pub(in crate::case) fn pair(&self, field: &Field) -> Result<[f64; 2], CaseError> {
        let value = self.value(field)?;
        if !self.is_list(field) {
            return self.number(field).map(|number| [number, number]);
        }
        let numbers = self.list(field)?;
        numbers.try_into().map_err(|_| self.wrong(field, value))
    }

    /// Whether the field is present and a list.
    #[must_use]
    pub(in crate::case) fn is_list(&self, field: &Field) -> bool {
        self.find(&field).is_some_and(|value| value.get_ref().is_array())
    }

    /// Rows of N numbers, each in its range.
    ///
    /// # Errors
    /// Reads rows of N numbers.
    pub(in crate::case) fn rows<const N: usize>(
        &self,
        field: &Field,
    ) -> Result<Vec<[f64; N]>, CaseError> {
        let value = self.value(field)?;
        match (value.get_ref(), field.form) {
            (DeValue::Array(rows), Form::Rows(form)) if rows.iter().count() >= form.least => rows
                .iter()
                .enumerate()
                .map(|(i, row)| self.row(&format!("{}[{i}]", field.name), row, form))
                .collect(),
            _ => Err(self.wrong(field, value)),
        }
    }

    fn row<const N: usize>(
        &self,
        name: &str,
        value: &'a Spanned<DeValue<'a>>,
        Rows { measures, optional, words, .. }: Rows,
    ) -> Result<[f64; N], CaseError> {
        let allowed = N - optional.min(N)..=N;
        let items = match value.get_ref() {
            DeValue::Array(items) if allowed.contains(&items.iter().count()) => items,
            _ => return Err(self.kind(name, value, words)),
        };
        let mut numbers = [0.0; N];
        let measures: &[Measure] = measures;
        for ((number, item), measure) in numbers.iter_mut().zip(items.iter()).zip(measures) {
            *number = self.as_number(name, item, *measure)?;
        }
        Ok(numbers)
    }
}
