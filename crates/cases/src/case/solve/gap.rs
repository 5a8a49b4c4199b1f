//! The gap between the bodies: `[gap]`.

use crate::case::error::CaseError;
use crate::case::field::{Default, Field, Form, Rows};
use crate::case::range::Range;
use crate::case::section::Section;
use crate::case::unit::{Dimension, Measure};
use carom_halfspace::Grid;
use carom_solver::{Gap, Outline, SelfAffine, Shape};
use carom_surface::{Crop, Level, Reading};
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
const ROUGH: &str = "rough";
const FILL: &str = "fill";
const NO_CONTACT: &str = "no contact";

const LENGTH: Measure = Range::Positive.of(Dimension::Length);
const PLACE: Measure = Range::Finite.of(Dimension::Length);
const SHAPE: Field = Field::new(
    "shape",
    Form::Word(&[
        (PARABOLOID, "with two relative radii"),
        (SPHERE, "an exact sphere"),
        (CYLINDER, "along y"),
        (CONE, "with its tip at the origin"),
        (WEDGE, "with its edge along y"),
        (WAVY, "waves along both axes"),
        (ELLIPSE, "a flat punch"),
        (RECTANGLE, "a flat punch"),
        (POLYGON, "a flat punch"),
        (HEIGHTS, "from a file"),
        (ROUGH, "a random self-affine surface"),
    ]),
    "shape of the gap",
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
    Field::number("amplitude", LENGTH, "height of each wave from crest to trough")
        .of(&[WAVY])
        .such_as("2e-6");
const WAVELENGTHS: Field =
    pair("wavelengths", "two wavelengths [along x, along y]", "wavelengths of the waves")
        .of(&[WAVY])
        .such_as("[1e-4, 1e-4]");
const SEMI_AXES: Field =
    pair("semi_axes", "two semi-axes [along x, along y]", "semi-axes of the punch")
        .of(&[ELLIPSE])
        .such_as("[1e-4, 1e-4]");
const SIDES: Field = pair("sides", "two sides [along x, along y]", "sides of the punch")
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
    "corners of the punch, in order",
)
.of(&[POLYGON])
.such_as("[[-1e-4, -1e-4], [1e-4, -1e-4], [0, 1e-4]]");
const FILE: Field = Field::new(
    "file",
    Form::Text("the name of a file x3p, sur, sdf, npy, png or of a text"),
    "heights towards the other body: a row for each row of cells, the first at the smallest y (of \
     a PNG in greys, with 8 or 16 bits, at the greatest), or in a text a list of points x y z",
)
.of(&[HEIGHTS])
.such_as("\"heights.csv\"");
const SCALE: Field = Field::number("scale", LENGTH, "height of one unit of the file")
    .of(&[HEIGHTS])
    .default(Default::Number(1.0));
const UNIT: Field = Field::new(
    "unit",
    Form::Text("a unit of length such as m, mm, um or nm"),
    "unit of the heights, and of x and y of a list of points, if the file does not state it",
)
.of(&[HEIGHTS])
.may("the unit in the file, or m")
.such_as("\"um\"");
const WHITE: Field = Field::number("range", LENGTH, "height of white over black in a PNG")
    .of(&[HEIGHTS])
    .may("a grey level is a unit of the file")
    .such_as("\"10 um\"");
const LEVEL: Field = Field::new(
    "level",
    Form::Word(&[
        ("mean", "the mean height"),
        ("plane", "the plane of best fit"),
        ("quadratic", "the paraboloid of best fit"),
    ]),
    "what is subtracted from the heights, by least squares",
)
.of(&[HEIGHTS])
.may("heights as they are")
.such_as("\"plane\"");
const MISSING: Field = Field::new(
    "missing",
    Form::Word(&[
        (FILL, "by a smooth patch of the heights around them"),
        (NO_CONTACT, "there is no body"),
    ]),
    "what stands for points without a height",
)
.of(&[HEIGHTS])
.may("an error if there are such points")
.such_as("\"fill\"");
const CROP: Field = Field::new(
    "crop",
    Form::Vector(
        &["left", "lower", "right", "upper"],
        Range::Point.pure(),
        "four whole numbers [left, lower, right, upper]",
    ),
    "part of the map in points from 0; right and upper are the first beyond it",
)
.of(&[HEIGHTS])
.may("the whole map")
.such_as("[0, 0, 512, 512]");
const BASE: Field = Field::number(
    "radius",
    Range::PositiveOrInfinite.of(Dimension::Length),
    "radius of a paraboloid that is added to the heights",
)
.of(&[HEIGHTS, ROUGH])
.default(Default::Number(f64::INFINITY));
const HURST: Field =
    Field::number("hurst", Range::Part.pure(), "Hurst's exponent").of(&[ROUGH]).such_as("0.8");
const RMS: Field =
    Field::number("rms", LENGTH, "root-mean-square height").of(&[ROUGH]).such_as("1e-7");
const LONGEST: Field =
    Field::number("longest", LENGTH, "the longest wavelength, at most a side of the grid")
        .of(&[ROUGH])
        .such_as("1e-4");
const SHORTEST: Field =
    Field::number("shortest", LENGTH, "the shortest wavelength, at least two cells")
        .of(&[ROUGH])
        .such_as("2e-5");
const SEED: Field = Field::number(
    "seed",
    Range::Seed.pure(),
    "seed of the random numbers: another seed gives another surface",
)
.of(&[ROUGH])
.default(Default::Number(1.0));
/// The field `gap` of a case.
pub(in crate::case) const GAP: Field = Field::new(
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
        UNIT,
        WHITE,
        LEVEL,
        MISSING,
        CROP,
        BASE,
        HURST,
        RMS,
        LONGEST,
        SHORTEST,
        SEED,
    ]),
    "the gap between the undeformed bodies",
);

const fn pair(name: &'static str, words: &'static str, meaning: &'static str) -> Field {
    Field::new(name, Form::Vector(&["x", "y"], LENGTH, words), meaning)
}

/// The gap of a case.
#[derive(Debug, Clone, PartialEq)]
pub enum GapCase {
    /// A gap given by a formula.
    Formula(Shape),
    /// Heights from a file.
    Heights(HeightFile),
    /// A random rough surface.
    Rough {
        /// The surface.
        surface: SelfAffine,
        /// The radius of the paraboloid that is added to it; infinite for a plane.
        radius: f64,
    },
}

/// Heights of a surface, positive towards the other one, from a file.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightFile {
    /// The file; relative to the case file.
    pub file: PathBuf,
    /// What the file does not say itself.
    pub reading: Reading,
    /// Factor of the heights.
    pub scale: f64,
    /// The part of the map; none for the whole.
    pub crop: Option<Crop>,
    /// What is subtracted from the heights.
    pub level: Option<Level>,
    /// What stands for missing points; none refuses them.
    pub missing: Option<Missing>,
    /// The radius of the paraboloid that is added to the heights; infinite for a plane.
    pub radius: f64,
}

/// What stands for points without a height.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Missing {
    /// A smooth patch of the heights around them.
    Fill,
    /// No body.
    NoContact,
}

impl HeightFile {
    fn read(gap: &Section<'_>) -> Result<Self, CaseError> {
        if let [unit, scale] = gap.given([&UNIT, &SCALE])[..] {
            return Err(gap.conflict(unit, scale, "both say what a unit of the file is"));
        }
        if let [white, scale] = gap.given([&WHITE, &SCALE])[..] {
            return Err(gap.conflict(white, scale, "both say what a grey level is"));
        }
        let word = |field| gap.has(field).then(|| gap.word(field)).transpose();
        let reading = Reading {
            unit: gap.has(&UNIT).then(|| unit(gap)).transpose()?,
            range: gap.maybe(&WHITE)?,
            ..Reading::default()
        };
        let crop = gap.has(&CROP).then(|| gap.vector::<4>(&CROP)).transpose()?;
        let missing = |word| if word == FILL { Missing::Fill } else { Missing::NoContact };
        Ok(Self {
            file: gap.text(&FILE)?.into(),
            reading,
            scale: gap.number(&SCALE)?,
            crop: crop.map(|parts| Crop(parts.map(|point| point as usize))),
            level: word(&LEVEL)?.and_then(|word| word.parse().ok()),
            missing: word(&MISSING)?.map(missing),
            radius: gap.number(&BASE)?,
        })
    }
}

/// Metres of the unit of the heights.
fn unit(gap: &Section<'_>) -> Result<f64, CaseError> {
    let text = gap.text(&UNIT)?;
    Dimension::Length.read(&format!("1 {text}")).ok_or_else(|| gap.unfit(&UNIT, UNIT.allowed()))
}

impl GapCase {
    /// Whether the gap is that of a file, which has a grid of its own.
    pub(super) fn is_of_file(case: &Section<'_>) -> bool {
        case.shaped(&GAP, &SHAPE).is_ok_and(|(_, shape)| shape == HEIGHTS)
    }

    /// Reads the gap; rough surfaces and heights are checked against the grid, if there is one.
    pub(in crate::case) fn read(case: &Section<'_>, grid: Option<Grid>) -> Result<Self, CaseError> {
        let (gap, shape) = &case.shaped(&GAP, &SHAPE)?;
        let shape = match *shape {
            PARABOLOID => Shape::Paraboloid { radii: gap.vector(&RADII)? },
            SPHERE => Shape::Sphere { radius: gap.number(&RADIUS)? },
            CYLINDER => Shape::Cylinder { radius: gap.number(&RADIUS)? },
            CONE => Shape::Cone { slope: gap.number(&SLOPE)? },
            WEDGE => Shape::Wedge { slope: gap.number(&SLOPE)? },
            WAVY => Shape::Wavy {
                amplitudes: [0.5 * gap.number(&AMPLITUDE)?; 2],
                wavelengths: gap.vector(&WAVELENGTHS)?,
            },
            ELLIPSE => {
                let [half_x, half_y] = gap.vector(&SEMI_AXES)?;
                Shape::Punch(Outline::Ellipse { half_x, half_y })
            }
            RECTANGLE => {
                let [half_x, half_y] = gap.vector(&SIDES)?.map(|side: f64| 0.5 * side);
                Shape::Punch(Outline::Rectangle { half_x, half_y })
            }
            POLYGON => Shape::Punch(Outline::Polygon(gap.rows(&CORNERS)?)),
            ROUGH => return rough(gap, grid),
            _ => return Ok(Self::Heights(HeightFile::read(gap)?)),
        };
        let allowed = "such that a cell of the grid lies under the body; is `grid.size` too large?";
        let checked =
            grid.map_or_else(|| shape.check(), |grid| Gap::of_shape(grid, &shape).map(|_| ()));
        checked.map_err(|_| gap.unfit(&SHAPE, allowed.to_owned()))?;
        Ok(Self::Formula(shape))
    }
}

fn rough(gap: &Section<'_>, grid: Option<Grid>) -> Result<GapCase, CaseError> {
    let surface = SelfAffine {
        hurst: gap.number(&HURST)?,
        rms: gap.number(&RMS)?,
        longest: gap.number(&LONGEST)?,
        shortest: gap.number(&SHORTEST)?,
        seed: gap.number(&SEED)? as u64,
    };
    if let Some(grid) = grid {
        surface.heights(grid).map_err(|error| match error.field {
            "waves between the wavelengths" => gap.out_of_range(
                &LONGEST,
                surface.longest,
                "such that a wave of the grid is between",
            ),
            _ => gap.refused(error),
        })?;
    }
    Ok(GapCase::Rough { surface, radius: gap.number(&BASE)? })
}
