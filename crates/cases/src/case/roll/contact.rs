//! What touches: an elliptical contact, a line or any gap, and its grid.

use super::ANY_GAP;
use crate::case::contact::{A, B, C, friction_by_speed};
use crate::case::error::{CaseError, CaseFault};
use crate::case::field::{Field, Form, Usual};
use crate::case::range::Range;
use crate::case::section::Section;
use crate::case::solve::{
    ACCURACY, Border, CELLS, CUT, FRICTION_MAP, FrictionCase, GridCase, SIZE, TOLERANCE,
};
use crate::case::unit::{Dimension, Measure};
use crate::{PointOrLine, Pressed};
use carom_halfspace::{Grid, MaterialPair};
use carom_laws::curvature::{CurvatureError, RelativeCurvature};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::hertz::{Hertz, HertzState};
use carom_laws::line::{LineContact, LineState};
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_laws::validity::Validity;
use carom_solver::Shape;

const PAIR: &str = "two lengths [along x, along y]";
const LENGTH: Measure = Range::Positive.of(Dimension::Length);
const SEMI_AXES: Field = Field::new(
    "semi_axes",
    Form::Vector(&["x", "y"], LENGTH, PAIR),
    "semi-axes of the contact ellipse",
)
.or("`radii`, `radius` and `length`, or `gap`")
.such_as("[0.006, 0.004]")
.usually(Usual::SEMI_AXIS);
const RADII: Field =
    Field::new("radii", Form::Vector(&["x", "y"], LENGTH, PAIR), "relative radii of curvature")
        .or("`semi_axes`, `radius` or `gap`")
        .such_as("[0.46, 0.3]");
const RADIUS: Field = Field::number(
    "radius",
    LENGTH,
    "relative radius of cylinders with axes along y, which touch along `length`",
)
.or("`semi_axes`, `radii` or `gap`")
.such_as("0.025");
const LINE: Field =
    Field::number("length", LENGTH, "length of the line along which cylinders touch")
        .or("`semi_axes`, `radii` or `gap`")
        .such_as("0.012");
const FORCE: Field = Field::number(
    "F_z",
    Range::Positive.of(Dimension::Force),
    "normal force of an elliptical contact, or of a line",
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
    Form::Table(&[
        SEMI_AXES,
        RADII,
        RADIUS,
        LINE,
        FORCE,
        FRICTION,
        FRICTION_BY_SLIP,
        FRICTION_MAP,
        TOLERANCE,
    ]),
    "an elliptical contact or a line under load, or the friction of a gap",
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

/// Cells across an ellipse, and across a line, whose one row costs little.
const ELEMENTS_ACROSS: [usize; 2] = [40, 320];
const ELEMENTS: Field = Field::number(
    "elements",
    Range::Elements.pure(),
    "cells across an elliptical contact, along both axes; across a line",
)
.may("40 across an ellipse, 320 across a line")
.such_as("40");
const OF_GAP: &str = "`accuracy`, or an elliptical contact or a line";
/// The field `grid` of a case. An elliptical contact and a line need neither cells nor size.
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

/// Cylinders that touch along a line under their load.
#[derive(Debug, Clone, PartialEq)]
pub struct Straight {
    /// Radius, length and materials.
    pub line: LineContact,
    /// The contact under the load of the case.
    pub loaded: LineState,
}

/// A contact with a closed form of its pressures, under its load.
#[derive(Debug, Clone, PartialEq)]
pub enum Touching {
    /// Of bodies that touch at a point.
    Ellipse(Elliptical),
    /// Of cylinders with parallel axes along y.
    Line(Straight),
}

impl Elliptical {
    /// Relative radii of curvature along x and along y.
    #[must_use]
    pub fn relative_radii(&self) -> [f64; 2] {
        let curvature = self.hertz.curvature();
        [0.5 / curvature.a(), 0.5 / curvature.b()]
    }
}

impl Touching {
    /// The normal force.
    #[must_use]
    pub const fn force(&self) -> f64 {
        match self {
            Self::Ellipse(ellipse) => ellipse.loaded.force,
            Self::Line(line) => line.loaded.force,
        }
    }

    /// Half of the contact's length along x.
    #[must_use]
    pub const fn semi_axis_a(&self) -> f64 {
        match self {
            Self::Ellipse(ellipse) => ellipse.loaded.ellipse.semi_axis_a(),
            Self::Line(line) => line.loaded.half_width,
        }
    }

    /// The gap before deformation.
    #[must_use]
    pub fn gap(&self) -> Shape {
        let radii = match self {
            Self::Ellipse(ellipse) => ellipse.relative_radii(),
            Self::Line(line) => [line.line.radius(), f64::INFINITY],
        };
        Shape::Paraboloid { radii }
    }

    /// How far the contact is from the limits of the theory.
    #[must_use]
    pub fn validity(&self) -> Validity {
        match self {
            Self::Ellipse(ellipse) => {
                let [x, y] = ellipse.relative_radii();
                Validity::of_hertz(&ellipse.hertz, &ellipse.loaded, x.min(y))
            }
            Self::Line(Straight { line, loaded }) => {
                Pressed::Line(*loaded).validity(&PointOrLine::Line(*line), line.radius())
            }
        }
    }

    /// A grid with this many cells across the contact: along both axes of an ellipse, whose both counts are multiples of
    /// four, so that coarser grids have the same border; across a line one row, whose ends are those of the cylinders.
    fn grid(&self, elements: usize) -> Result<GridCase, carom_special::RangeError> {
        let width = 2.0 * self.semi_axis_a() / elements as f64;
        // An odd count stays odd, so that its cells end where the contact does.
        let cells = match elements % 2 {
            0 => (elements + 2 * BORDER).next_multiple_of(4),
            _ => elements + 2 * BORDER,
        };
        let (rows, height, border) = match self {
            Self::Ellipse(ellipse) => {
                let height = 2.0 * ellipse.loaded.ellipse.semi_axis_b() / elements as f64;
                (cells, height, Border::Free)
            }
            Self::Line(line) => (1, line.line.length(), Border::Cut),
        };
        Ok(GridCase::Cells { grid: Grid::new(cells, rows, width, height)?, border })
    }
}

/// Reads the contact under its load; none if the case gives a gap.
pub(super) fn read(
    case: &Section<'_>,
    contact: &Section<'_>,
    materials: MaterialPair,
) -> Result<Option<Touching>, CaseError> {
    if case.has(&ANY_GAP) {
        let own = [&SEMI_AXES, &RADII, &RADIUS, &LINE, &FORCE];
        let beside = own.into_iter().find(|field| contact.has(*field));
        let reason = "a gap takes its load as `rolling.F_z` or `rolling.zeta`";
        return beside.map_or(Ok(None), |field| {
            Err(contact.excluded(field, ANY_GAP.name.to_owned(), reason))
        });
    }
    let given = contact.given([&SEMI_AXES, &RADII, &RADIUS, &LINE]);
    match given.as_slice() {
        [] => Err(contact.missing(&SEMI_AXES)),
        [field] if [SEMI_AXES.name, RADII.name].contains(&field.name) => {
            Ok(Some(Touching::Ellipse(read_ellipse(contact, field, materials)?)))
        }
        many if many.iter().any(|field| [SEMI_AXES.name, RADII.name].contains(&field.name)) => {
            Err(contact
                .several(many, "give one of `semi_axes`, `radii`, or `radius` with `length`"))
        }
        _ => Ok(Some(Touching::Line(read_line(contact, materials)?))),
    }
}

fn read_line(contact: &Section<'_>, materials: MaterialPair) -> Result<Straight, CaseError> {
    let (radius, length) = (contact.number(&RADIUS)?, contact.number(&LINE)?);
    let force = contact.number(&FORCE)?;
    let line = LineContact::new(radius, length, materials)
        .map_err(|error| contact.out_of_range(&RADIUS, error.value, error.allowed))?;
    let loaded = line.at_force(force).map_err(|_| {
        let allowed = "such that the contact is at most as wide as long; give a `gap` and a `grid`";
        contact.out_of_range(&FORCE, force, allowed)
    })?;
    Ok(Straight { line, loaded })
}

fn read_ellipse(
    contact: &Section<'_>,
    field: &Field,
    materials: MaterialPair,
) -> Result<Elliptical, CaseError> {
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
    Ok(Elliptical { hertz, loaded })
}

/// Reads the grid: elements across an ellipse or a line, the cells of a gap, or an accuracy.
pub(super) fn read_grid(
    case: &Section<'_>,
    touching: Option<&Touching>,
) -> Result<GridCase, CaseError> {
    let Some(touching) = touching else {
        let grid = case.section(&GRID)?;
        if grid.has(&ELEMENTS) {
            let reason =
                "elements are counted across an ellipse or a line; give `cells` and `size`";
            return Err(case.conflict([&GRID, &ELEMENTS], &ANY_GAP, reason));
        }
        return GridCase::read(&grid);
    };
    let [of_ellipse, of_line] = ELEMENTS_ACROSS;
    let mut elements = match touching {
        Touching::Ellipse(_) => of_ellipse,
        Touching::Line(_) => of_line,
    };
    if case.has(&GRID) {
        let grid = case.section(&GRID)?;
        if let Some(field) = [&CELLS, &SIZE, &CUT].into_iter().find(|f| grid.has(*f)) {
            let reason = "the grid of an elliptical contact or a line follows from `elements`";
            return Err(grid.excluded(field, CONTACT.name.to_owned(), reason));
        }
        if grid.has(&ACCURACY) {
            if grid.has(&ELEMENTS) {
                return Err(grid.conflict(&ACCURACY, &ELEMENTS, "an accuracy chooses the grid"));
            }
            if let Touching::Line(_) = touching {
                let reason = "an accuracy is for ellipses and gaps; a line takes `elements`";
                return Err(grid.excluded(&ACCURACY, CONTACT.name.to_owned(), reason));
            }
            return GridCase::read(&grid);
        }
        elements = grid.maybe(&ELEMENTS)?.map_or(elements, |count| count as usize);
    }
    touching.grid(elements).map_err(|error| {
        let force = case.section(&CONTACT).and_then(|contact| contact.number(&FORCE));
        case.out_of_range([&CONTACT, &FORCE], force.unwrap_or(error.value), error.allowed)
    })
}
