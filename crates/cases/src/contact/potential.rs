//! The potential contact area and its cells: IPOTCN.

use super::fault::Fault;
use super::lines::{Given, Lines};
use super::surface::Surface;
use carom_halfspace::{Grid, MaterialPair};
use carom_laws::curvature::{CurvatureError, RelativeCurvature};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::hertz::Hertz;
use carom_solver::{Driven, Window};
use carom_special::RangeError;

/// The most cells of a case.
const MOST_CELLS: i32 = 1 << 19;

/// A rectangle of cells: how many, how large, and where its lower left corner is. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Potential {
    /// Cells along x and y.
    pub cells: [usize; 2],
    /// Their sizes.
    pub size: [f64; 2],
    /// The lower left corner.
    pub corner: [f64; 2],
}

/// The contact of Hertz: semi-axes along x and y, mm, normal force and approach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipse {
    /// Semi-axes.
    pub semi_axes: [f64; 2],
    /// FN.
    pub force: f64,
    /// PEN.
    pub approach: f64,
}

/// Where a case lies.
pub(super) struct Placed {
    pub(super) area: Potential,
    /// Of a contact of Hertz, its surface, and its ellipse if it is one.
    pub(super) surface: Option<Surface>,
    pub(super) ellipse: Option<Ellipse>,
}

/// What a file says of the potential contact area.
#[derive(Debug, Clone, Copy)]
pub(super) struct Area {
    kind: i32,
    cells: [usize; 2],
    numbers: [Given; 4],
}

impl Potential {
    /// The number of cells.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.cells[0] * self.cells[1]
    }

    pub(super) fn middle(&self) -> [f64; 2] {
        [0, 1].map(|i| self.corner[i] + 0.5 * self.cells[i] as f64 * self.size[i])
    }

    pub(super) fn window(&self) -> Result<Window, RangeError> {
        let ([nx, ny], [dx, dy]) = (self.cells, self.size);
        Window::about(self.middle(), Grid::new(nx, ny, dx, dy)?)
    }

    /// The same with so many cells more on each side.
    pub(super) fn padded(&self, [x, y]: [usize; 2]) -> Self {
        let [nx, ny] = self.cells;
        let corner =
            [self.corner[0] - x as f64 * self.size[0], self.corner[1] - y as f64 * self.size[1]];
        Self { cells: [nx + 2 * x, ny + 2 * y], corner, ..*self }
    }

    /// By how many cells the corner of this area lies beyond that of another one of the same cells; none if
    /// their cells do not coincide.
    pub(super) fn offset_from(&self, other: &Self) -> Option<[i64; 2]> {
        const ROUNDING: f64 = 1e-6;
        let mut offset = [0; 2];
        for (i, offset) in offset.iter_mut().enumerate() {
            let (own, size) = (self.size[i], other.size[i]);
            let steps = (self.corner[i] - other.corner[i]) / own;
            let near = (steps - steps.round()).abs() < ROUNDING && steps.abs() < 1e9;
            if (own - size).abs() >= ROUNDING * own.min(size) || !near {
                return None;
            }
            *offset = steps.round() as i64;
        }
        Some(offset)
    }
}

impl Area {
    pub(super) fn read(lines: &mut Lines<'_>) -> Result<Self, Fault> {
        let [given] = lines.numbers(["IPOTCN"])?;
        let kind = given.whole([-6, 4])?;
        let names: &[[&'static str; 6]] = &[
            ["MX", "MY", "A1", "BB", "SCALE", ""],
            ["MX", "MY", "AA", "BB", "SCALE", ""],
            ["MX", "MY", "A1", "AOB", "SCALE", ""],
            ["MX", "MY", "A1", "B1", "SCALE", ""],
            ["MX", "MY", "XL", "YL", "DX", "DY"],
            ["MX", "MY", "XL", "YL", "XH", "YH"],
            ["MX", "MY", "XC1", "YC1", "DX", "DY"],
            ["MX", "MY", "XC1", "YC1", "XCM", "YCM"],
        ];
        let place = match kind {
            -5 | -3 => 1,
            -4 => 0,
            -2 => 2,
            -1 => 3,
            1..=4 => kind as usize + 3,
            _ => return Err(given.must("-5 to -1 or 1 to 4")),
        };
        let names = names[place];
        let [mx, my, a, b, c, d] = if kind > 0 {
            lines.numbers(names)?
        } else {
            let [mx, my, a, b, c] =
                lines.numbers([names[0], names[1], names[2], names[3], names[4]])?;
            [mx, my, a, b, c, c]
        };
        let cells = [mx.count(MOST_CELLS)?, my.count(MOST_CELLS)?];
        if cells[0] * cells[1] > MOST_CELLS as usize {
            return Err(my.must(format!("such that MX MY is at most {MOST_CELLS}")));
        }
        Ok(Self { kind, cells, numbers: [a, b, c, d] })
    }

    /// Whether the contact of Hertz gives area and surface.
    pub(super) const fn is_hertzian(&self) -> bool {
        self.kind < 0
    }

    /// The cells of an area that is given by itself.
    fn plain(&self) -> Result<Potential, Fault> {
        let [a, b, c, d] = &self.numbers;
        let counts = self.cells.map(|count| count as f64);
        let above = |upper: &Given, lower: &Given| {
            let allowed = format!("> {} = {}", lower.name, lower.value);
            upper.checked(|value| value > lower.value, &allowed).map(|upper| upper - lower.value)
        };
        let size = match self.kind {
            1 | 3 => [c.positive()?, d.positive()?],
            2 => [above(c, a)? / counts[0], above(d, b)? / counts[1]],
            _ => [
                above(c, a)? / (counts[0] - 1.0).max(1.0),
                above(d, b)? / (counts[1] - 1.0).max(1.0),
            ],
        };
        let first = if self.kind < 3 { 0.0 } else { 0.5 };
        let corner = [a.value - first * size[0], b.value - first * size[1]];
        Ok(Potential { cells: self.cells, size, corner })
    }

    /// Cells, and of a contact of Hertz the surface, under a normal force or at an approach.
    pub(super) fn placed(&self, materials: MaterialPair, normal: Driven) -> Result<Placed, Fault> {
        if !self.is_hertzian() {
            return Ok(Placed { area: self.plain()?, surface: None, ellipse: None });
        }
        let scale = self.numbers[2].positive()?;
        let ([a, b], curvatures, ellipse) = match self.kind {
            -5 | -4 => {
                let (semi_axes, curvatures) = self.line(materials, normal)?;
                (semi_axes, curvatures, None)
            }
            _ => {
                let (ellipse, curvatures) = self.ellipse(materials, normal)?;
                (ellipse.semi_axes, curvatures, Some(ellipse))
            }
        };
        let half = [scale * a, if self.kind <= -4 { self.wide(b, scale) } else { scale * b }];
        let size = [0, 1].map(|i| 2.0 * half[i] / self.cells[i] as f64);
        let area = Potential { cells: self.cells, size, corner: half.map(|half| -half) };
        Ok(Placed { area, surface: Some(Surface::paraboloid(curvatures)), ellipse })
    }

    /// Half the width of the area of a line contact: a whole number of cells covers the line.
    fn wide(&self, half_width: f64, scale: f64) -> f64 {
        let all = self.cells[1];
        let mut inside = all;
        if scale > 1.0 {
            inside = ((all as f64 / scale).round() as usize).max(1);
            inside += (all - inside) % 2;
        }
        half_width * all as f64 / inside as f64
    }

    fn line(&self, materials: MaterialPair, normal: Driven) -> Result<([f64; 2], [f64; 2]), Fault> {
        let [first, width, ..] = &self.numbers;
        let Driven::Load(force) = normal else {
            return Err(Fault::new(first.line, "IPOTCN", self.kind, "-3 to 4 with N = 0"));
        };
        let (given, half_width) = (first.positive()?, width.positive()?);
        // b^2 = 4 R F / (pi E*) of a line, its curvature A1 = 1/(2 R).
        let part =
            4.0 * force / (2.0 * half_width) / (std::f64::consts::PI * materials.contact_modulus());
        let (a, a1) = match self.kind {
            -4 => ((part * 0.5 / given).sqrt(), given),
            _ => (given, 0.5 * part / (given * given)),
        };
        Ok(([a, half_width], [a1, 0.0]))
    }

    fn ellipse(
        &self,
        materials: MaterialPair,
        normal: Driven,
    ) -> Result<(Ellipse, [f64; 2]), Fault> {
        let [first, second, ..] = &self.numbers;
        let given = [first.positive()?, second.positive()?];
        let made = self.hertz(given, materials, normal).and_then(|hertz| {
            let state = match normal {
                Driven::Load(force) => hertz.at_force(force)?,
                Driven::Shift(approach) => hertz.at_approach(approach)?,
            };
            Ok((hertz, state))
        });
        let (hertz, state) = made.map_err(|error| first.must(format!("of a contact: {error}")))?;
        let (axes, curvature) = (state.ellipse, hertz.curvature());
        let semi_axes = [axes.semi_axis_a(), axes.semi_axis_b()];
        let ellipse = Ellipse { semi_axes, force: state.force, approach: state.approach };
        Ok((ellipse, [curvature.a(), curvature.b()]))
    }

    fn hertz(
        &self,
        [first, second]: [f64; 2],
        materials: MaterialPair,
        normal: Driven,
    ) -> Result<Hertz, CurvatureError> {
        let of_axes = |a: f64, b: f64, force: f64| {
            Hertz::from_ellipse_and_force(ContactEllipse::new(a, b)?, force, materials)
        };
        let curvature = match self.kind {
            -1 => RelativeCurvature::from_coefficients(first, second)?,
            -2 => {
                let like = of_axes(second, 1.0, 1.0)?.curvature();
                RelativeCurvature::from_coefficients(first, first * like.b() / like.a())?
            }
            _ => match normal {
                Driven::Load(force) => return of_axes(first, second, force),
                // The approach of an ellipse of given size is proportional to its force.
                Driven::Shift(approach) => {
                    let unit = of_axes(first, second, 1.0)?.approach(1.0);
                    return of_axes(first, second, approach / unit);
                }
            },
        };
        Ok(Hertz::new(curvature, materials)?)
    }
}
