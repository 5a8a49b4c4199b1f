//! Flat punches, given by their outline.

use carom_special::RangeError;

/// The outline of a flat punch, about the centre of the grid. Cells whose centre lies outside
/// cannot come into contact.
///
/// ```
/// use carom_halfspace::Grid;
/// use carom_solver::{Gap, Outline};
/// let grid = Grid::new(6, 6, 0.5, 0.5)?;
/// let square = Gap::punch(grid, &Outline::Rectangle { half_x: 1.0, half_y: 1.0 })?;
/// let inside = square.heights().values().iter().filter(|height| **height == 0.0);
/// assert_eq!(inside.count(), 16);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Outline {
    /// A circle.
    Disc {
        /// Its radius.
        radius: f64,
    },
    /// An ellipse with its axes along x and y.
    Ellipse {
        /// Semi-axis along x.
        half_x: f64,
        /// Semi-axis along y.
        half_y: f64,
    },
    /// A rectangle with its sides along x and y.
    Rectangle {
        /// Half the side length along x.
        half_x: f64,
        /// Half the side length along y.
        half_y: f64,
    },
    /// A triangle with these corners.
    Triangle([[f64; 2]; 3]),
    /// A polygon, convex or not, with these corners in either order.
    Polygon(Vec<[f64; 2]>),
}

impl Outline {
    /// Whether a point lies inside or on the outline.
    #[must_use]
    pub fn holds(&self, x: f64, y: f64) -> bool {
        let within = |a: f64, b: f64| (x / a) * (x / a) + (y / b) * (y / b) <= 1.0;
        match self {
            Self::Disc { radius } => within(*radius, *radius),
            Self::Ellipse { half_x, half_y } => within(*half_x, *half_y),
            Self::Rectangle { half_x, half_y } => x.abs() <= *half_x && y.abs() <= *half_y,
            Self::Triangle(corners) => encloses(corners, [x, y]),
            Self::Polygon(corners) => encloses(corners, [x, y]),
        }
    }

    /// The greatest |x| and |y| of the outline.
    pub(super) fn reach(&self) -> [f64; 2] {
        let farthest = |corners: &[[f64; 2]]| {
            [0, 1].map(|axis| corners.iter().map(|corner| corner[axis].abs()).fold(0.0, f64::max))
        };
        match self {
            Self::Disc { radius } => [*radius; 2],
            Self::Ellipse { half_x, half_y } | Self::Rectangle { half_x, half_y } => {
                [*half_x, *half_y]
            }
            Self::Triangle(corners) => farthest(corners),
            Self::Polygon(corners) => farthest(corners),
        }
    }

    pub(super) fn check(&self) -> Result<(), RangeError> {
        match self {
            Self::Disc { radius } => RangeError::positive("radius", *radius).map(|_| ()),
            Self::Ellipse { half_x, half_y } | Self::Rectangle { half_x, half_y } => {
                RangeError::positive("half_x", *half_x)?;
                RangeError::positive("half_y", *half_y).map(|_| ())
            }
            Self::Triangle(corners) => check_corners(corners),
            Self::Polygon(corners) => check_corners(corners),
        }
    }
}

fn check_corners(corners: &[[f64; 2]]) -> Result<(), RangeError> {
    let count = corners.len() as f64;
    RangeError::check("corners", count, corners.len() >= 3, "at least 3")?;
    for value in corners.iter().flatten() {
        RangeError::finite("corner", *value)?;
    }
    let area: f64 = sides(corners).map(|(a, b)| 0.5 * (a[0] * b[1] - b[0] * a[1])).sum();
    RangeError::positive("area of the outline", area.abs()).map(|_| ())
}

fn sides(corners: &[[f64; 2]]) -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
    corners.iter().copied().zip(corners.iter().copied().cycle().skip(1))
}

/// Whether a ray along x crosses the polygon an odd number of times, or the point lies on the
/// polygon.
fn encloses(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let mut inside = false;
    for (a, b) in sides(corners) {
        let turn = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        let between = |k: usize, at: f64| at >= a[k].min(b[k]) && at <= a[k].max(b[k]);
        if turn == 0.0 && between(0, x) && between(1, y) {
            return true;
        }
        if (a[1] > y) != (b[1] > y) {
            inside ^= (turn > 0.0) == (b[1] > a[1]);
        }
    }
    inside
}
