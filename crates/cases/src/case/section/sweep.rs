//! Numbers of which a case gives one or several: a list, or a range with a count.

use super::Section;
use crate::case::error::CaseError;
use crate::case::field::Field;
use crate::case::range::Range;
use crate::case::unit::Measure;
use toml::de::DeValue;

pub(in crate::case) const START: Field =
    Field::number("start", Range::Finite.pure(), "first value of a sweep");
pub(in crate::case) const STOP: Field = Field::number("stop", Range::Finite.pure(), "last value");
pub(in crate::case) const COUNT: Field =
    Field::number("count", Range::Count.pure(), "how many values, equally spaced");
/// The fields of a sweep.
pub(in crate::case) const SWEEP: &[Field] = &[START, STOP, COUNT];

/// One number, or the numbers of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub enum Numbers {
    /// One number.
    One(f64),
    /// A sweep.
    Sweep(Vec<f64>),
}

impl Numbers {
    /// The numbers in order.
    #[must_use]
    pub fn as_slice(&self) -> &[f64] {
        match self {
            Self::One(number) => std::slice::from_ref(number),
            Self::Sweep(numbers) => numbers,
        }
    }
}

impl Section<'_> {
    /// Reads one number, a list of numbers, or `{ start, stop, count }`.
    ///
    /// # Errors
    /// If it is missing, of another kind, or a number is out of range.
    pub(in crate::case) fn numbers(&self, field: &Field) -> Result<Numbers, CaseError> {
        let value = self.value(field)?;
        match (value.get_ref(), field.measure()) {
            (DeValue::Array(_), _) => self.list(field).map(Numbers::Sweep),
            (DeValue::Table(_), Some(measure)) => {
                let table = self.table_at(field.name, value, SWEEP)?;
                table.spaced(measure).map(Numbers::Sweep)
            }
            _ => self.number(field).map(Numbers::One),
        }
    }

    /// The values of a sweep.
    ///
    /// # Errors
    /// If one of its fields is missing, out of range or infinite.
    pub(in crate::case) fn spaced(&self, measure: Measure) -> Result<Vec<f64>, CaseError> {
        let start = self.number(&START.measured(measure))?;
        let stop = self.number(&STOP.measured(measure))?;
        // Infinity may be a value of the field; between it and another one nothing is equally spaced.
        for (end, value) in [(&START, start), (&STOP, stop)] {
            if !value.is_finite() {
                return Err(self.out_of_range(end, value, "finite"));
            }
        }
        if !(stop - start).is_finite() {
            return Err(self.out_of_range(&STOP, stop, "less than 1.7e308 from `start`"));
        }
        Ok(carom_special::linspace(start, stop, self.count(&COUNT)?))
    }
}
