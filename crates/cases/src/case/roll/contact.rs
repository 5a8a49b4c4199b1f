//! What touches: an elliptical contact or any gap, and its grid.

use super::ANY_GAP;
use crate::case::contact::{A, B, C, friction_by_speed};
use crate::case::error::{CaseError, CaseFault};
use crate::case::field::{Default, Field, Form, Usual};
use crate::case::range::Range;
use crate::case::section::Section;
use crate::case::solve::{
    ACCURACY, Border, CELLS, CUT, FRICTION_MAP, FrictionCase, GridCase, SIZE, TOLERANCE,
};
use crate::case::unit::{Dimension, Measure};
use carom_halfspace::{Grid, MaterialPair};
use carom_laws::curvature::{CurvatureError, RelativeCurvature};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::hertz::{Hertz, HertzState};
use carom_laws::slip_speed::SlipSpeedFriction;

const PAIR: &str = "two lengths [along x, along y]";
const LENGTH: Measure = Range::Positive.of(Dimension::Length);
const SEMI_AXES: Field = Field::new(
    "semi_axes",
    Form::Vector(&["x", "y"], LENGTH, PAIR),
    "semi-axes of the contact ellipse",
)
.or("`radii` or `gap`")
.such_as("[0.006, 0.004]");
const RADII: Field =
    Field::new("radii", Form::Vector(&["x", "y"], LENGTH, PAIR), "relative radii of curvature")
        .or("`semi_axes` or `gap`")
        .such_as("[0.46, 0.3]");
const FORCE: Field = Field::number(
    "F_z",
    Range::Positive.of(Dimension::Force),
    "normal force of an elliptical contact",
)
.or("`rolling.F_z` beside `gap`")
.such_as("8e4");
/// The coefficient of friction.
const FRICTION: Field =
    Field::number("friction", Range::Positive.pure(), "coefficient of friction f")
        .such_as("0.3")
        .usually(Usual::FRICTION);
/// The table in place of the number `friction`.
pub(super) const FRICTION_BY_SLIP: Field = Field::new(
    "friction",
    Form::Table(&[A, B, C]),
    "friction by the slip speed v of each cell, f = a + b exp(-c v), instead of a number; without memory, the \
     state that is reached from rest",
)
.may("`friction` is a number");
/// The field `contact` of a case.
pub(super) const CONTACT: Field = Field::new(
    "contact",
    Form::Table(&[SEMI_AXES, RADII, FORCE, FRICTION, FRICTION_BY_SLIP, FRICTION_MAP, TOLERANCE]),
    "an elliptical contact under load, or the friction of a gap",
)
.begun(&[(&SEMI_AXES, ""), (&FORCE, "")]);

/// Reads the friction of a contact; where it falls with the slip speed, that at rest, and the law.
pub(super) fn read_friction(
    contact: &Section<'_>,
    grid: GridCase,
) -> Result<(FrictionCase, Option<SlipSpeedFriction>), CaseError> {
    if !contact.means(&FRICTION_BY_SLIP) {
        return Ok((FrictionCase::read_one(contact, &FRICTION, grid)?, None));
    }
    if contact.has(&FRICTION_MAP) {
        let reason = "a map has factors of one coefficient";
        return Err(contact.conflict(&FRICTION_MAP, &FRICTION_BY_SLIP, reason));
    }
    let law = friction_by_speed(contact, &FRICTION_BY_SLIP)?;
    let [a, b, _] = law.coefficients();
    if a + b <= 0.0 || a <= 0.0 {
        let table = contact.section(&FRICTION_BY_SLIP)?;
        return Err(table.out_of_range(&A, a, "positive, and so a + b"));
    }
    Ok((FrictionCase { rest: a + b, motion: a + b, map: None }, Some(law)))
}

const ELEMENTS_ACROSS: f64 = 40.0;
const ELEMENTS: Field = Field::number(
    "elements",
    Range::Elements.pure(),
    "cells across an elliptical contact, along both axes",
)
.default(Default::Number(ELEMENTS_ACROSS));
const OF_GAP: &str = "`accuracy`, or an elliptical contact";
/// The field `grid` of a case. An elliptical contact needs neither cells nor size.
pub(super) const GRID: Field = Field::new(
    "grid",
    Form::Table(&[ELEMENTS, CELLS.may(OF_GAP), SIZE.may(OF_GAP), CUT, ACCURACY]),
    "the grid",
)
.may("its defaults; a `gap` needs `cells` and `size`, or `accuracy`");

/// Free cells on each side of an elliptical contact, at least.
const BORDER: usize = 2;

/// An elliptical contact under its load.
#[derive(Debug, Clone, PartialEq)]
pub struct Elliptical {
    /// Curvatures and materials.
    pub hertz: Hertz,
    /// The contact under the load of the case.
    pub loaded: HertzState,
}

impl Elliptical {
    /// Relative radii of curvature along x and along y.
    #[must_use]
    pub fn relative_radii(&self) -> [f64; 2] {
        let curvature = self.hertz.curvature();
        [0.5 / curvature.a(), 0.5 / curvature.b()]
    }

    /// A grid with this many cells across the contact, along both axes; both counts are multiples of
    /// four, so that coarser grids have the same border.
    fn grid(&self, elements: usize) -> Result<Grid, carom_special::RangeError> {
        let ellipse = self.loaded.ellipse;
        let [dx, dy] =
            [ellipse.semi_axis_a(), ellipse.semi_axis_b()].map(|half| 2.0 * half / elements as f64);
        // An odd count stays odd, so that its cells end where the contact does.
        let cells = match elements % 2 {
            0 => (elements + 2 * BORDER).next_multiple_of(4),
            _ => elements + 2 * BORDER,
        };
        Grid::new(cells, cells, dx, dy)
    }
}

/// Reads the elliptical contact; none if the case gives a gap.
pub(super) fn read(
    case: &Section<'_>,
    contact: &Section<'_>,
    materials: MaterialPair,
) -> Result<Option<Elliptical>, CaseError> {
    let given = contact.given([&SEMI_AXES, &RADII]);
    if case.has(&ANY_GAP) {
        let beside = [&SEMI_AXES, &RADII, &FORCE].into_iter().find(|field| contact.has(*field));
        let reason = "a gap takes its load as `rolling.F_z` or `rolling.zeta`";
        return beside.map_or(Ok(None), |field| {
            Err(contact.excluded(field, ANY_GAP.name.to_owned(), reason))
        });
    }
    let field = match given.as_slice() {
        [] => return Err(contact.missing(&SEMI_AXES)),
        [field] => *field,
        both => return Err(contact.several(both, "give one of the two")),
    };
    let force = contact.number(&FORCE)?;
    let [x, y]: [f64; 2] = contact.vector(field)?;
    let made = if field.name == SEMI_AXES.name {
        ContactEllipse::new(x, y)
            .map_err(CurvatureError::from)
            .and_then(|ellipse| Hertz::from_ellipse_and_force(ellipse, force, materials))
    } else {
        RelativeCurvature::from_coefficients(0.5 / x, 0.5 / y)
            .and_then(|curvature| Ok(Hertz::new(curvature, materials)?))
    };
    let hertz = made.map_err(|source| {
        CaseFault::Curvature { others: "", source }.at(contact.path(&field), contact.line(field))
    })?;
    let loaded = hertz
        .at_force(force)
        .map_err(|error| contact.out_of_range(&FORCE, error.value, error.allowed))?;
    Ok(Some(Elliptical { hertz, loaded }))
}

/// Reads the grid: elements across an ellipse, the cells of a gap, or an accuracy for both.
pub(super) fn read_grid(
    case: &Section<'_>,
    ellipse: Option<&Elliptical>,
) -> Result<GridCase, CaseError> {
    let Some(ellipse) = ellipse else {
        let grid = case.section(&GRID)?;
        if grid.has(&ELEMENTS) {
            let reason = "elements are counted across an ellipse; give `cells` and `size`";
            return Err(case.conflict([&GRID, &ELEMENTS], &ANY_GAP, reason));
        }
        return GridCase::read(&grid);
    };
    let mut elements = ELEMENTS_ACROSS as usize;
    if case.has(&GRID) {
        let grid = case.section(&GRID)?;
        if let Some(field) = [&CELLS, &SIZE, &CUT].into_iter().find(|f| grid.has(*f)) {
            let reason = "the grid of an elliptical contact follows from `elements`";
            return Err(grid.excluded(field, CONTACT.name.to_owned(), reason));
        }
        if grid.has(&ACCURACY) {
            if grid.has(&ELEMENTS) {
                return Err(grid.conflict(&ACCURACY, &ELEMENTS, "an accuracy chooses the grid"));
            }
            return GridCase::read(&grid);
        }
        elements = grid.count(&ELEMENTS)?;
    }
    let grid = ellipse.grid(elements).map_err(|error| {
        let force = case.section(&CONTACT).and_then(|contact| contact.number(&FORCE));
        case.out_of_range([&CONTACT, &FORCE], force.unwrap_or(error.value), error.allowed)
    })?;
    Ok(GridCase::Cells { grid, border: Border::Free })
}
