//! The undeformed distance of the surfaces and the part of the plane in which they may touch: IBASE and IPLAN.

use super::fault::Fault;
use super::lines::Lines;
use carom_halfspace::Field;
use carom_solver::{Gap, Window};
use carom_special::RangeError;
use std::sync::Arc;

/// The undeformed distance of the surfaces.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    distance: Distance,
    planform: Planform,
}

/// The values of IBASE.
#[derive(Debug, Clone, PartialEq)]
enum Distance {
    /// B1 x^2 + B2 x y + B3 y^2 + B4 x + B5 y + B6.
    Quadratic([f64; 6]),
    /// Circles along x about XM of radius RM, and given heights along y, first at Y1 and then DY1 apart.
    Circles { xm: f64, rm: f64, y1: f64, dy1: f64, heights: Arc<[f64]> },
    /// B1 sin(B2 (x - B3)) - B4 sin(B5 (x - B6)) + x^2/B7 + y^2/B8.
    Sines([f64; 8]),
    /// In each cell.
    Cells(Arc<[f64]>),
}

/// The values of IPLAN.
#[derive(Debug, Clone, PartialEq)]
enum Planform {
    Unrestricted,
    /// Where a quadratic function is negative.
    Quadratic([f64; 6]),
    /// Two rectangles: XL, XH, YL, YH of each.
    Rectangles([[f64; 4]; 2]),
}

fn quadratic(b: &[f64; 6], x: f64, y: f64) -> f64 {
    b[0] * x * x + b[1] * x * y + b[2] * y * y + b[3] * x + b[4] * y + b[5]
}

impl Surface {
    /// The distance A1 x^2 + B1 y^2.
    pub(super) const fn paraboloid([a1, b1]: [f64; 2]) -> Self {
        let distance = Distance::Quadratic([a1, 0.0, b1, 0.0, 0.0, 0.0]);
        Self { distance, planform: Planform::Unrestricted }
    }

    /// Reads IBASE, IPLAN and their numbers, for this many cells.
    pub(super) fn read(lines: &mut Lines<'_>, cells: usize) -> Result<Self, Fault> {
        let [base, plan] = lines.numbers(["IBASE", "IPLAN"])?;
        let (of_base, of_plan) = (base.whole([1, 9])?, plan.whole([1, 4])?);
        let distance = match of_base {
            1 => Distance::Quadratic(lines.numbers(["B"; 6])?.map(|given| given.value)),
            2 => circles(lines)?,
            3 => {
                let b = lines.numbers(["B1", "B2", "B3", "B4", "B5", "B6", "B7", "B8"])?;
                for divisor in &b[6..] {
                    divisor.checked(|value| value != 0.0, "no 0")?;
                }
                Distance::Sines(b.map(|given| given.value))
            }
            9 => Distance::Cells(lines.list("undeformed distance", cells)?.into()),
            _ => return Err(base.must("1, 2, 3 or 9")),
        };
        let planform = match of_plan {
            1 => Planform::Unrestricted,
            2 => Planform::Quadratic(lines.numbers(["P"; 6])?.map(|given| given.value)),
            3 => rectangles(lines)?,
            _ => return Err(plan.must("1, 2 or 3; carom does not weigh patches")),
        };
        Ok(Self { distance, planform })
    }

    /// A1 and B1, of a distance A1 x^2 + B1 y^2 in the whole plane.
    pub(super) fn coefficients(&self) -> Option<[f64; 2]> {
        match (&self.distance, &self.planform) {
            (Distance::Quadratic([a1, 0.0, b1, 0.0, 0.0, 0.0]), Planform::Unrestricted) => {
                Some([*a1, *b1])
            }
            _ => None,
        }
    }

    fn is_excluded(&self, x: f64, y: f64) -> bool {
        match &self.planform {
            Planform::Unrestricted => false,
            Planform::Quadratic(p) => quadratic(p, x, y) >= 0.0,
            Planform::Rectangles(all) => !all.iter().any(|[left, right, lower, upper]| {
                (*left..=*right).contains(&x) && (*lower..=*upper).contains(&y)
            }),
        }
    }

    fn height(&self, x: f64, y: f64) -> f64 {
        if self.is_excluded(x, y) {
            return f64::INFINITY;
        }
        match &self.distance {
            Distance::Quadratic(b) => quadratic(b, x, y),
            Distance::Circles { xm, rm, y1, dy1, heights } => {
                let last = heights.len() - 2;
                let left = (((y - y1) / dy1).max(0.0) as usize).min(last);
                let slope = (heights[left + 1] - heights[left]) / dy1;
                heights[left] + slope * (y - y1 - left as f64 * dy1) + 0.5 * (x - xm).powi(2) / rm
            }
            Distance::Sines(b) => {
                b[0] * libm::sin(b[1] * (x - b[2])) - b[3] * libm::sin(b[4] * (x - b[5]))
                    + x * x / b[6]
                    + y * y / b[7]
            }
            Distance::Cells(_) => 0.0,
        }
    }

    /// The gap on a window; cell by cell on the window of the file, `own`, and its coarser grids.
    pub(super) fn gap(&self, window: &Window, own: &Window) -> Result<Gap, RangeError> {
        let Distance::Cells(heights) = &self.distance else {
            return window.gap(|x, y| self.height(x, y));
        };
        let ([x, y], grid) = (own.middle(), own.grid());
        let cells = grid.centres().zip(heights.iter());
        let heights =
            cells.map(|((at_x, at_y), height)| match self.is_excluded(x + at_x, y + at_y) {
                true => f64::INFINITY,
                false => *height,
            });
        Gap::new(Field::new(grid, heights.collect())?)?.coarsened_to(window.grid())
    }
}

fn circles(lines: &mut Lines<'_>) -> Result<Distance, Fault> {
    let [nn, xm, rm, y1, dy1] = lines.numbers(["NN", "XM", "RM", "Y1", "DY1"])?;
    let count = nn.whole([2, 999_999])? as usize;
    rm.checked(|value| value != 0.0, "no 0")?;
    let dy1 = dy1.positive()?;
    let heights = lines.list("undeformed distance along y", count)?.into();
    Ok(Distance::Circles { xm: xm.value, rm: rm.value, y1: y1.value, dy1, heights })
}

fn rectangles(lines: &mut Lines<'_>) -> Result<Planform, Fault> {
    let p = lines.numbers(["XL1", "XH1", "YL1", "YH1", "XL2", "XH2", "YL2", "YH2"])?;
    for pair in p.chunks_exact(2) {
        if pair[1].value <= pair[0].value {
            return Err(pair[1].must(format!("> {} = {}", pair[0].name, pair[0].value)));
        }
    }
    let p = p.map(|given| given.value);
    Ok(Planform::Rectangles([[p[0], p[1], p[2], p[3]], [p[4], p[5], p[6], p[7]]]))
}
