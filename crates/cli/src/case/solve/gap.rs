//! The gap between the bodies: `[gap]`.

use crate::case::error::CaseError;
use crate::case::range::Range;
use crate::case::section::{Section, Words};
use crate::case::unit::Dimension;
use carom_halfspace::Grid;
use carom_solver::{Gap, Outline};
use std::path::PathBuf;

const SHAPES: Words = Words {
    words: &[
        "paraboloid",
        "sphere",
        "cylinder",
        "cone",
        "wedge",
        "wavy",
        "ellipse",
        "rectangle",
        "polygon",
        "heights",
    ],
    allowed: "\"paraboloid\", \"sphere\", \"cylinder\", \"cone\", \"wedge\", \"wavy\", \"ellipse\", \"rectangle\", \
              \"polygon\" (flat punches) or \"heights\"",
};
const FIELDS: &[&str] = &[
    "shape",
    "radii",
    "radius",
    "slope",
    "amplitude",
    "wavelengths",
    "semi_axes",
    "sides",
    "corners",
    "file",
    "scale",
];

/// A gap, or the file that holds it.
#[derive(Debug, Clone, PartialEq)]
pub enum GapCase {
    /// By a formula.
    Formula(Gap),
    /// From a file.
    Heights(HeightMap),
}

/// Heights of a surface towards the other one, as a table of numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightMap {
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
        let gap = case.section("gap", FIELDS)?;
        let length = Range::Positive.of(Dimension::Length);
        let shape = gap.word("shape", SHAPES)?;
        let own: &[&str] = match shape {
            "paraboloid" => &["radii"],
            "sphere" | "cylinder" => &["radius"],
            "cone" | "wedge" => &["slope"],
            "wavy" => &["amplitude", "wavelengths"],
            "ellipse" => &["semi_axes"],
            "rectangle" => &["sides"],
            "polygon" => &["corners"],
            _ => &["file", "scale", "radius"],
        };
        let other = FIELDS[1..].iter().find(|name| gap.has(name) && !own.contains(name));
        if let Some(name) = other {
            return Err(gap.conflict(name, "shape", "it means nothing for this shape"));
        }
        let pair = |name, allowed| gap.array(name, ["x", "y"], length, allowed);
        let made = match shape {
            "paraboloid" => {
                let [x, y] = pair("radii", "two relative radii [along x, along y]")?;
                Gap::from_function(grid, move |at_x, at_y| {
                    0.5 * (at_x * at_x / x + at_y * at_y / y)
                })
            }
            "sphere" => Gap::sphere(grid, gap.number("radius", length)?),
            "cylinder" => Gap::cylinder(grid, gap.number("radius", length)?),
            "cone" => Gap::cone(grid, gap.number("slope", Range::Positive)?),
            "wedge" => Gap::wedge(grid, gap.number("slope", Range::Positive)?),
            "wavy" => {
                let half = 0.5 * gap.number("amplitude", length)?;
                let waves = pair("wavelengths", "two wavelengths [along x, along y]")?;
                Gap::wavy(grid, [half, half], waves)
            }
            "ellipse" => {
                let [half_x, half_y] = pair("semi_axes", "two semi-axes [along x, along y]")?;
                Gap::punch(grid, &Outline::Ellipse { half_x, half_y })
            }
            "rectangle" => {
                let [x, y] = pair("sides", "two sides [along x, along y]")?;
                Gap::punch(grid, &Outline::Rectangle { half_x: 0.5 * x, half_y: 0.5 * y })
            }
            "polygon" => {
                let place = Range::Finite.of(Dimension::Length);
                let allowed = "a list of corners [x, y], at least three";
                let corners = gap.rows("corners", [place, place, place], allowed)?;
                if corners.len() < 3 {
                    return Err(gap.out_of_range("corners", corners.len() as f64, allowed));
                }
                let corners = corners.iter().map(|[x, y, _]| [*x, *y]).collect();
                Gap::punch(grid, &Outline::Polygon(corners))
            }
            _ => return Self::heights(&gap),
        };
        let allowed = "such that a cell of the grid lies under the body";
        made.map(Self::Formula).map_err(|error| gap.out_of_range("shape", error.value, allowed))
    }

    fn heights(gap: &Section<'_>) -> Result<Self, CaseError> {
        let file = gap.text("file", "the name of a CSV file with a row of heights a line")?.into();
        let number = |name: &str, range: Range, absent: f64, dimension| match gap.has(name) {
            true => gap.number(name, range.of(dimension)),
            false => Ok(absent),
        };
        let scale = number("scale", Range::Positive, 1.0, Dimension::Length)?;
        let radius = number("radius", Range::PositiveOrInfinite, f64::INFINITY, Dimension::Length)?;
        Ok(Self::Heights(HeightMap { file, scale, radius }))
    }
}
