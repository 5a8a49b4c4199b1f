//! The gap between the bodies: `[gap]`.

use crate::case::error::CaseError;
use crate::case::field::{Default, Field, Form, Rows};
use crate::case::range::Range;
use crate::case::section::Section;
use crate::case::unit::{Dimension, Measure};
use carom_halfspace::Grid;
use carom_solver::{Gap, Outline};
use std::path::PathBuf;

const PARABOLOID: &str = "paraboloid";
const SPHERE: &str = "sphere";
const CYLINDER: &str = "cylinder";
const CONE: &str = "cone";
const WEDGE: &str = "wedge";
const WAVY: &str = "wavy";
const ELLIPSE: &str = "ellipse";
const RECTANGLE: &str = "rectangle";
const POLYGON: &str = "polygon";
const HEIGHTS: &str = "heights";

const LENGTH: Measure = Range::Positive.of(Dimension::Length);
const PLACE: Measure = Range::Finite.of(Dimension::Length);
const SHAPE: Field = Field::new(
    "shape",
    Form::Word(&[
        (PARABOLOID, "with two relative radii"),
        (SPHERE, "exactly round"),
        (CYLINDER, "along y"),
        (CONE, "with its tip at the origin"),
        (WEDGE, "with its edge along y"),
        (WAVY, "waves along both axes"),
        (ELLIPSE, "a flat punch"),
        (RECTANGLE, "a flat punch"),
        (POLYGON, "a flat punch"),
        (HEIGHTS, "from a file"),
    ]),
    "what lies between the bodies before they touch",
)
.such_as("\"sphere\"");
const RADII: Field =
    pair("radii", "two relative radii [along x, along y]", "relative radii of curvature")
        .of(&[PARABOLOID])
        .such_as("[0.01, 0.02]");
const RADIUS: Field =
    Field::number("radius", LENGTH, "radius").of(&[SPHERE, CYLINDER]).such_as("0.01");
const SLOPE: Field = Field::number("slope", Range::Positive.pure(), "rise over distance")
    .of(&[CONE, WEDGE])
    .such_as("0.01");
const AMPLITUDE: Field =
    Field::number("amplitude", LENGTH, "from crest to trough").of(&[WAVY]).such_as("2e-6");
const WAVELENGTHS: Field =
    pair("wavelengths", "two wavelengths [along x, along y]", "of the waves")
        .of(&[WAVY])
        .such_as("[1e-4, 1e-4]");
const SEMI_AXES: Field = pair("semi_axes", "two semi-axes [along x, along y]", "of the punch")
    .of(&[ELLIPSE])
    .such_as("[1e-4, 1e-4]");
const SIDES: Field = pair("sides", "two sides [along x, along y]", "of the punch")
    .of(&[RECTANGLE])
    .such_as("[2e-4, 1e-4]");
const CORNERS: Field = Field::new(
    "corners",
    Form::Rows(Rows {
        parts: &["x", "y"],
        measures: &[PLACE, PLACE],
        optional: 0,
        least: 3,
        words: "a list of corners [x, y], at least three",
    }),
    "of the punch, in order",
)
.of(&[POLYGON])
.such_as("[[-1e-4, -1e-4], [1e-4, -1e-4], [0, 1e-4]]");
const FILE: Field = Field::new(
    "file",
    Form::Text("the name of a CSV file with a row of heights a line"),
    "heights towards the other body; a line for each row of cells, the first at the smallest y",
)
.of(&[HEIGHTS])
.such_as("\"heights.csv\"");
const SCALE: Field = Field::number("scale", LENGTH, "of the numbers in the file")
    .of(&[HEIGHTS])
    .default(Default::Number(1.0));
const BASE: Field = Field::number(
    "radius",
    Range::PositiveOrInfinite.of(Dimension::Length),
    "of the paraboloid that the heights stand on",
)
.of(&[HEIGHTS])
.default(Default::Number(f64::INFINITY));
/// The field of a case.
pub(super) const GAP: Field = Field::new(
    "gap",
    Form::Table(&[
        SHAPE,
        RADII,
        RADIUS,
        SLOPE,
        AMPLITUDE,
        WAVELENGTHS,
        SEMI_AXES,
        SIDES,
        CORNERS,
        FILE,
        SCALE,
        BASE,
    ]),
    "the gap between the bodies before they touch",
);

const fn pair(name: &'static str, words: &'static str, meaning: &'static str) -> Field {
    Field::new(name, Form::Vector(&["x", "y"], LENGTH, words), meaning)
}

/// A gap, or the file that holds it.
#[derive(Debug, Clone, PartialEq)]
pub enum GapCase {
    /// By a formula.
    Formula(Gap),
    /// From a file.
    Heights(HeightFile),
}

/// Heights of a surface towards the other one, as a table of numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightFile {
    /// CSV without heads: a line for each row of cells, the first one at the smallest y; relative
    /// to the case file.
    pub file: PathBuf,
    /// Metres for each unit of the file.
    pub scale: f64,
    /// The radius of a paraboloid that the heights stand on; infinite for a plane.
    pub radius: f64,
}

impl GapCase {
    pub(super) fn read(case: &Section<'_>, grid: Grid) -> Result<Self, CaseError> {
        let (gap, shape) = &case.shaped(&GAP, &SHAPE)?;
        let made = match *shape {
            PARABOLOID => {
                let [x, y] = gap.vector(&RADII)?;
                Gap::from_function(grid, move |at_x, at_y| {
                    0.5 * (at_x * at_x / x + at_y * at_y / y)
                })
            }
            SPHERE => Gap::sphere(grid, gap.number(&RADIUS)?),
            CYLINDER => Gap::cylinder(grid, gap.number(&RADIUS)?),
            CONE => Gap::cone(grid, gap.number(&SLOPE)?),
            WEDGE => Gap::wedge(grid, gap.number(&SLOPE)?),
            WAVY => {
                let half = 0.5 * gap.number(&AMPLITUDE)?;
                Gap::wavy(grid, [half, half], gap.vector(&WAVELENGTHS)?)
            }
            ELLIPSE => {
                let [half_x, half_y] = gap.vector(&SEMI_AXES)?;
                Gap::punch(grid, &Outline::Ellipse { half_x, half_y })
            }
            RECTANGLE => {
                let [half_x, half_y] = gap.vector(&SIDES)?.map(|side| 0.5 * side);
                Gap::punch(grid, &Outline::Rectangle { half_x, half_y })
            }
            POLYGON => Gap::punch(grid, &Outline::Polygon(gap.rows(&CORNERS)?)),
            _ => {
                return Ok(Self::Heights(HeightFile {
                    file: gap.text(&FILE)?.into(),
                    scale: gap.number(&SCALE)?,
                    radius: gap.number(&BASE)?,
                }));
            }
        };
        let allowed = "such that a cell of the grid lies under the body";
        made.map(Self::Formula).map_err(|error| gap.out_of_range(&SHAPE, error.value, allowed))
    }
}
