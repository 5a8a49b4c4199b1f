//! The coefficients of friction of a contact on a grid.

use super::GridCase;
use crate::case::error::CaseError;
use crate::case::field::{Field, Form, Usual};
use crate::case::range::Range;
use crate::case::section::Section;
use std::path::PathBuf;

/// The field `friction` of a contact.
pub(in crate::case) const FRICTION: Field =
    Field::number("friction", Range::NonNegative.pure(), "coefficient of friction f")
        .such_as("0.3")
        .usually(Usual::FRICTION);
/// The field `static_friction` of a contact.
pub(super) const STATIC: Field = Field::number(
    "static_friction",
    Range::NonNegative.pure(),
    "coefficient of static friction: cells stick below it; slipping cells have `friction`",
)
.may("the same as `friction`")
.such_as("0.4");
/// The field `friction_map` of a contact.
pub(in crate::case) const FRICTION_MAP: Field = Field::new(
    "friction_map",
    Form::Text("the name of a file .csv, .npy or .png"),
    "factors of the coefficients of friction, cell by cell: a row for each row of cells, the first \
     at the smallest y",
)
.may("1 everywhere")
.such_as("\"lubricated.csv\"");

/// Coefficients of friction.
#[derive(Debug, Clone, PartialEq)]
pub struct FrictionCase {
    /// The static coefficient.
    pub rest: f64,
    /// The kinetic one, not above it.
    pub motion: f64,
    /// A file of factors of both, cell by cell; relative to the case file.
    pub map: Option<PathBuf>,
}

impl FrictionCase {
    /// Reads the fields of a contact on this grid.
    pub(super) fn read(contact: &Section<'_>, grid: GridCase) -> Result<Self, CaseError> {
        let motion = contact.number(&FRICTION)?;
        let rest = contact.maybe(&STATIC)?.unwrap_or(motion);
        if rest < motion {
            return Err(contact.out_of_range(&STATIC, rest, "at least `friction`"));
        }
        Ok(Self { rest, motion, map: Self::read_map(contact, grid)? })
    }

    /// Reads one coefficient, for rest and motion.
    pub(in crate::case) fn read_one(
        contact: &Section<'_>,
        field: &Field,
        grid: GridCase,
    ) -> Result<Self, CaseError> {
        let motion = contact.number(field)?;
        Ok(Self { rest: motion, motion, map: Self::read_map(contact, grid)? })
    }

    fn read_map(contact: &Section<'_>, grid: GridCase) -> Result<Option<PathBuf>, CaseError> {
        if !contact.has(&FRICTION_MAP) {
            return Ok(None);
        }
        if matches!(grid, GridCase::Accuracy(_)) {
            let reason = "a map has the cells of a given grid";
            return Err(contact.excluded(&FRICTION_MAP, "grid.accuracy".to_owned(), reason));
        }
        Ok(Some(contact.text(&FRICTION_MAP)?.into()))
    }
}
