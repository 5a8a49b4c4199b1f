//! The gap between the bodies: `[gap]`.

use crate::case::error::CaseError;
use crate::case::range::Range;
use crate::case::section::{Section, Words};
use crate::case::unit::Dimension;
use carom_halfspace::Grid;
use carom_solver::Gap;
use std::f64::consts::TAU;
use std::path::PathBuf;

const SHAPES: Words = Words {
    words: &[
        "paraboloid",
        "sphere",
        "cone",
        "wedge",
        "wavy",
        "ellipse",
        "rectangle",
        "polygon",
        "heights",
    ],
    allowed: "\"paraboloid\", \"sphere\", \"cone\", \"wedge\", \"wavy\", \"ellipse\", \"rectangle\", \
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
            "sphere" => &["radius"],
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
            "sphere" => {
                let radius = gap.number("radius", length)?;
                Gap::from_function(grid, move |x, y| sphere(radius, x, y))
            }
            "cone" => {
                let slope = gap.number("slope", Range::Positive)?;
                Gap::from_function(grid, move |x, y| slope * libm::hypot(x, y))
            }
            "wedge" => {
                let slope = gap.number("slope", Range::Positive)?;
                Gap::from_function(grid, move |x, _| slope * x.abs())
            }
            "wavy" => {
                let amplitude = gap.number("amplitude", length)?;
                let [x, y] = pair("wavelengths", "two wavelengths [along x, along y]")?;
                let wave = |at: f64, length: f64| 1.0 - libm::cos(TAU * at / length);
                Gap::from_function(grid, move |at_x, at_y| {
                    0.5 * amplitude * (wave(at_x, x) + wave(at_y, y))
                })
            }
            "ellipse" => {
                let [a, b] = pair("semi_axes", "two semi-axes [along x, along y]")?;
                punch(grid, move |x, y| libm::hypot(x / a, y / b) < 1.0)
            }
            "rectangle" => {
                let [a, b] = pair("sides", "two sides [along x, along y]")?;
                punch(grid, move |x, y| x.abs() < 0.5 * a && y.abs() < 0.5 * b)
            }
            "polygon" => {
                let place = Range::Finite.of(Dimension::Length);
                let allowed = "a list of corners [x, y], at least three";
                let corners = gap.rows("corners", [place, place, place], allowed)?;
                if corners.len() < 3 {
                    return Err(gap.out_of_range("corners", corners.len() as f64, allowed));
                }
                let corners: Vec<[f64; 2]> = corners.iter().map(|[x, y, _]| [*x, *y]).collect();
                punch(grid, move |x, y| is_inside(&corners, x, y))
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

/// The height of a ball over the plane that it touches; none beside it.
fn sphere(radius: f64, x: f64, y: f64) -> f64 {
    let square = x * x + y * y;
    if square >= radius * radius {
        return f64::INFINITY;
    }
    square / (radius + (radius * radius - square).sqrt())
}

fn punch(grid: Grid, inside: impl Fn(f64, f64) -> bool) -> Result<Gap, carom_special::RangeError> {
    Gap::from_function(grid, |x, y| if inside(x, y) { 0.0 } else { f64::INFINITY })
}

/// Whether a ray from the point crosses the outline an odd number of times.
fn is_inside(corners: &[[f64; 2]], x: f64, y: f64) -> bool {
    let next = corners.iter().cycle().skip(1);
    let crossed = corners.iter().zip(next).filter(|([x_1, y_1], [x_2, y_2])| {
        (*y_1 > y) != (*y_2 > y) && x < x_1 + (y - y_1) / (y_2 - y_1) * (x_2 - x_1)
    });
    crossed.count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_lie_inside_polygons_that_are_not_convex() {
        let arrow = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 0.5]];
        for (x, y, inside) in [(1.0, 0.25, true), (1.0, 0.75, false), (1.9, 1.5, true)] {
            assert_eq!(is_inside(&arrow, x, y), inside, "{x} {y}");
        }
    }

    #[test]
    fn a_sphere_keeps_its_digits_near_touch() {
        assert!((sphere(1.0, 1e-9, 0.0) / 0.5e-18 - 1.0).abs() < 1e-15);
        assert_eq!(sphere(1.0, 0.6, 0.0), 0.2);
        assert!(sphere(1.0, 1.0, 0.5).is_infinite());
    }
}
