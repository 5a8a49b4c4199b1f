//! Numbers of a stored state, one field after another: whoever writes and reads them counts none of them.

use carom_special::RangeError;

use crate::bounds::in_contact;
use crate::law::Shift;

/// Checks the range of the number of a field.
pub(crate) type Check = fn(&'static str, f64) -> Result<f64, RangeError>;
type Done = Result<(), RangeError>;

/// What passes over the fields of a state in their stored order: a [`Writer`] or a [`Reader`]. Errors are those of
/// reading: [`RangeError`] of a field whose numbers are out of range or missing.
pub(crate) trait Fields {
    /// The next numbers are a field.
    fn numbers(&mut self, field: &'static str, numbers: &mut [f64], check: Check) -> Done;

    /// The next number is a field.
    fn number(&mut self, field: &'static str, number: &mut f64, check: Check) -> Done {
        self.numbers(field, std::slice::from_mut(number), check)
    }

    /// The next four numbers are a shift.
    fn shift(&mut self, Shift { zeta, xi, eta, omega }: &mut Shift) -> Done {
        self.number("zeta", zeta, in_contact)?;
        self.number("xi", xi, in_contact)?;
        self.number("eta", eta, in_contact)?;
        self.number("omega", omega, in_contact)
    }
}

/// Writes numbers where there is room for all of them.
pub(crate) struct Writer<'a>(&'a mut [f64]);

impl<'a> Writer<'a> {
    /// Asks for room for `count` numbers before any is written.
    pub(crate) fn new(
        numbers: &'a mut [f64],
        count: usize,
        allowed: &'static str,
    ) -> Result<Self, RangeError> {
        let room = numbers.len();
        RangeError::check("numbers", room as f64, room >= count, allowed)?;
        Ok(Self(numbers))
    }

    pub(crate) fn write(&mut self, numbers: &[f64]) {
        self.part(numbers.len()).copy_from_slice(numbers);
    }

    /// The place of the next numbers.
    pub(crate) fn part(&mut self, count: usize) -> &'a mut [f64] {
        let (part, rest) = std::mem::take(&mut self.0).split_at_mut(count);
        self.0 = rest;
        part
    }

    /// The place of all that are left.
    pub(crate) const fn rest(self) -> &'a mut [f64] {
        self.0
    }
}

impl Fields for Writer<'_> {
    fn numbers(&mut self, _field: &'static str, numbers: &mut [f64], _check: Check) -> Done {
        self.write(numbers);
        Ok(())
    }
}

/// Reads numbers from outside.
pub(crate) struct Reader<'a> {
    rest: &'a [f64],
    missing: RangeError,
}

impl<'a> Reader<'a> {
    /// How many numbers there must be is said in words.
    pub(crate) const fn new(numbers: &'a [f64], allowed: &'static str) -> Self {
        let missing = RangeError::new("numbers", numbers.len() as f64, allowed);
        Self { rest: numbers, missing }
    }

    /// The next numbers as they are.
    pub(crate) fn part(&mut self, count: usize) -> Result<&'a [f64], RangeError> {
        let (part, rest) = self.rest.split_at_checked(count).ok_or(self.missing)?;
        self.rest = rest;
        Ok(part)
    }

    /// All that are left.
    pub(crate) const fn rest(self) -> &'a [f64] {
        self.rest
    }

    /// The next numbers, which are a field.
    pub(crate) fn read<const N: usize>(
        &mut self,
        field: &'static str,
        check: Check,
    ) -> Result<[f64; N], RangeError> {
        let mut numbers = [0.0; N];
        self.numbers(field, &mut numbers, check)?;
        Ok(numbers)
    }
}

impl Fields for Reader<'_> {
    fn numbers(&mut self, field: &'static str, numbers: &mut [f64], check: Check) -> Done {
        numbers.copy_from_slice(self.part(numbers.len())?);
        numbers.iter().try_for_each(|number| check(field, *number).map(|_| ()))
    }
}

/// The [`Check`] of what is checked elsewhere.
pub(crate) fn any(_field: &'static str, number: f64) -> Result<f64, RangeError> {
    Ok(number)
}

/// Whether a vector with this square is zero or of the length 1.
#[inline]
pub(crate) fn is_unit_or_zero(square: f64) -> bool {
    square == 0.0 || (square - 1.0).abs() < 1e-9
}
