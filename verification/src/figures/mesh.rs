//! Contacts on a mesh, as the thesis computes them: a box of equal elements, a history in steps.

use crate::{Arrow, Failure, Panel, Point, Series};
use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLoad, Shift};
use carom_solver::{CellState, ContactProblem, ContactState, Drive, Frictional, Gap, Method as _};

/// The shear modulus of both bodies, in N/mm^2 (section 14.1).
pub(super) const SHEAR_MODULUS: f64 = 82_000.0;
/// The approach zeta at which the contact of a paraboloid fills its box, in mm.
pub(super) const APPROACH: f64 = 0.1;

/// What meets the half-space in the box |x| <= a, |y| <= b.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    /// A paraboloid whose contact has the semi-axes a and b at [`APPROACH`].
    Paraboloid,
    /// A flat punch: where it is.
    Punch(fn(f64, f64) -> bool),
}

/// A numerical example: lengths in mm, forces in N.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mesh {
    pub(super) semi_axes: [f64; 2],
    pub(super) poisson: [f64; 2],
    pub(super) friction: f64,
    /// Elements along x and y.
    pub(super) elements: [usize; 2],
    pub(super) shape: Shape,
}

/// The contact at the end of a step.
#[derive(Debug, Clone)]
pub(super) struct Step {
    pub(super) load: ContactLoad,
    pub(super) state: ContactState,
    /// Slip of body 1 against body 2 in this step.
    pub(super) slip: [Field; 2],
}

impl Mesh {
    /// A paraboloid with these semi-axes, Poisson's ratio of both bodies 0 and f = 1.
    pub(super) const fn of(semi_axes: [f64; 2], elements: [usize; 2]) -> Self {
        let poisson = [0.0; 2];
        Self { semi_axes, poisson, friction: 1.0, elements, shape: Shape::Paraboloid }
    }

    pub(super) fn materials(&self) -> Result<MaterialPair, Failure> {
        let [one, two] = self.poisson;
        let body = |poisson| Material::from_shear(SHEAR_MODULUS, poisson);
        Ok(MaterialPair::new(body(one)?, body(two)?)?)
    }

    pub(super) fn grid(&self) -> Result<Grid, Failure> {
        let ([a, b], [nx, ny]) = (self.semi_axes, self.elements);
        Ok(Grid::new(nx, ny, 2.0 * a / nx as f64, 2.0 * b / ny as f64)?)
    }

    pub(super) fn ellipse(&self) -> Result<ContactEllipse, Failure> {
        Ok(ContactEllipse::new(self.semi_axes[0], self.semi_axes[1])?)
    }

    /// Hertz's contact of the paraboloid.
    pub(super) fn hertz(&self) -> Result<Hertz, Failure> {
        Ok(Hertz::from_ellipse(self.ellipse()?, APPROACH, self.materials()?)?)
    }

    pub(super) fn problem(&self) -> Result<ContactProblem, Failure> {
        let grid = self.grid()?;
        let gap = match self.shape {
            Shape::Paraboloid => Gap::of_curvature(grid, &self.hertz()?.curvature()),
            Shape::Punch(inside) => {
                let height = |x, y| if inside(x, y) { 0.0 } else { f64::INFINITY };
                Gap::from_function(grid, height)?
            }
        };
        let friction = Friction::new(self.friction)?;
        Ok(ContactProblem::of_half_spaces(gap, self.materials()?, friction)?)
    }

    /// Follows a history of rigid shifts at the ends of the steps, from rest.
    pub(super) fn follow(&self, history: &[Shift]) -> Result<Vec<Step>, Failure> {
        let problem = self.problem()?;
        let method = Frictional::default();
        let mut scratch = method.scratch(&problem)?;
        let mut before = ContactState::apart(problem.grid());
        let mut steps = Vec::with_capacity(history.len());
        for shift in history {
            let mut state = before.clone();
            let drive = Drive::by_shift(*shift);
            method.step(&problem, &before, &drive, &mut state, &mut scratch, &mut ())?;
            let slip = state.slip_since(&before);
            before.clone_from(&state);
            steps.push(Step { load: state.load(), state, slip });
        }
        Ok(steps)
    }
}

/// Steps from one shift to another, the first left out.
pub(super) fn steps(from: Shift, to: Shift, count: usize) -> impl Iterator<Item = Shift> {
    (1..=count).map(move |i| {
        let part = i as f64 / count as f64;
        let mix = |a: f64, b: f64| a + part * (b - a);
        Shift {
            zeta: mix(from.zeta, to.zeta),
            xi: mix(from.xi, to.xi),
            eta: mix(from.eta, to.eta),
            omega: mix(from.omega, to.omega),
        }
    })
}

/// A cell in contact: place, tangential traction, pressure, whether it sticks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touching {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) traction: [f64; 2],
    pub(super) pressure: f64,
    pub(super) slip: [f64; 2],
    pub(super) sticks: bool,
}

impl Touching {
    pub(super) fn size(&self) -> f64 {
        self.traction[0].hypot(self.traction[1])
    }

    pub(super) fn slip_size(&self) -> f64 {
        self.slip[0].hypot(self.slip[1])
    }

    fn cosine_to_slip(&self) -> f64 {
        let along = self.slip[0] * self.traction[0] + self.slip[1] * self.traction[1];
        along / (self.size() * self.slip_size())
    }

    /// The direction of the traction on body 1 in degrees from x, -180 to 180.
    pub(super) fn angle(&self) -> f64 {
        self.traction[1].atan2(self.traction[0]).to_degrees()
    }
}

impl Step {
    /// The cells in contact.
    pub(super) fn touching(&self) -> impl Iterator<Item = Touching> + '_ {
        let cells = self.state.pressure.grid().centres().enumerate();
        let touching = cells.filter(|(i, _)| self.state.pressure.values()[*i] > 0.0);
        touching.map(|(i, (x, y))| Touching {
            x,
            y,
            traction: [self.state.traction_x.values()[i], self.state.traction_y.values()[i]],
            pressure: self.state.pressure.values()[i],
            slip: [self.slip[0].values()[i], self.slip[1].values()[i]],
            sticks: self.state.cells.values()[i] == CellState::Stick,
        })
    }

    /// The cosines of the angles between traction and slip, where it slips, with Coulomb's -1.
    pub(super) fn cosines_to_slip(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let slipping = self.touching().filter(|cell| !cell.sticks);
        slipping.map(|cell| (cell.cosine_to_slip(), -1.0))
    }

    /// The part of the contact that sticks.
    pub(super) fn stick(&self) -> f64 {
        let (sticks, slips) =
            (self.state.count(CellState::Stick), self.state.count(CellState::Slip));
        sticks as f64 / (sticks + slips) as f64
    }

    /// The mean place of the cells that stick.
    pub(super) fn stick_centre(&self) -> [f64; 2] {
        let (mut sum, mut count) = ([0.0; 2], 0.0);
        for cell in self.touching().filter(|cell| cell.sticks) {
            sum = [sum[0] + cell.x, sum[1] + cell.y];
            count += 1.0;
        }
        sum.map(|sum| sum / f64::max(count, 1.0))
    }

    /// A map of the cells that stick and of those that slip.
    pub(super) fn stick_map(&self, title: impl Into<String>) -> Result<Panel, Failure> {
        let kinds = self.state.cells.values().iter().map(|cell| match cell {
            CellState::Stick => Some(0),
            CellState::Slip => Some(1),
            CellState::Exterior => None,
        });
        let grid = self.state.cells.grid();
        let x = (0..grid.nx()).map(|i| grid.centred_x(i)).collect();
        let y = (0..grid.ny()).map(|i| grid.centred_y(i)).collect();
        let field = carom_plot::Field::of_kinds(["stick", "slip"], x, y, kinds.collect())?;
        let panel = Panel::new("x", "y").titled(title).equal_aspect();
        Ok(panel.over(field))
    }

    /// Arrows of a plane field, the longest `length` long.
    pub(super) fn arrows(
        &self,
        label: &str,
        length: f64,
        of: impl Fn(&Touching) -> [f64; 2],
    ) -> Series {
        let size = |[x, y]: [f64; 2]| x.hypot(y);
        let longest = self.touching().map(|cell| size(of(&cell))).fold(0.0, f64::max);
        let scale = if longest > 0.0 { length / longest } else { 0.0 };
        Series::arrows(
            label,
            self.touching().filter(|cell| size(of(cell)) > 0.02 * longest).map(|cell| {
                let [x, y] = of(&cell);
                Arrow {
                    tail: Point::new(cell.x, cell.y),
                    head: Point::new(cell.x + scale * x, cell.y + scale * y),
                }
            }),
        )
    }
}

impl Step {
    /// The outline of the area that sticks, row by row: for areas without holes or inlets along x.
    pub(super) fn stick_outline(&self) -> Vec<(f64, f64)> {
        let half = 0.5 * self.state.pressure.grid().dx();
        let mut rows: Vec<(f64, f64, f64)> = Vec::new();
        for cell in self.touching().filter(|cell| cell.sticks) {
            match rows.last_mut().filter(|row| row.0 == cell.y) {
                Some(row) => row.2 = cell.x + half,
                None => rows.push((cell.y, cell.x - half, cell.x + half)),
            }
        }
        let right = rows.iter().map(|row| (row.2, row.0));
        let left = rows.iter().rev().map(|row| (row.1, row.0));
        let mut outline: Vec<(f64, f64)> = right.chain(left).collect();
        outline.extend(outline.first().copied());
        outline
    }
}
