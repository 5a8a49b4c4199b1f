//! From tractions and displacements to the state at the end of a step.

use carom_laws::law::Shift;

use super::DirectError;
use carom_solver::{CellState, ContactProblem, ContactState, Convergence, Drive, Residuals, Stop};

/// Tractions, displacements and states of all cells.
#[derive(Debug, Clone, Default)]
pub(crate) struct Outcome {
    pub(crate) traction: [Vec<f64>; 3],
    pub(crate) displacement: [Vec<f64>; 3],
    pub(crate) cells: Vec<CellState>,
}

impl Outcome {
    pub(crate) fn new(cells: usize) -> Self {
        let zero = || [(); 3].map(|()| vec![0.0; cells]);
        let cells = vec![CellState::Exterior; cells];
        Self { traction: zero(), displacement: zero(), cells }
    }

    /// Sets the tractions and cells of a state.
    pub(crate) fn start(&mut self, from: &ContactState) {
        let tractions = [&from.traction_x, &from.traction_y, &from.pressure];
        for (own, field) in self.traction.iter_mut().zip(tractions) {
            own.copy_from_slice(field.values());
        }
        self.cells.copy_from_slice(from.cells.values());
    }

    /// Complete adhesion in the given contact area.
    pub(crate) fn touch_where(&mut self, touches: impl Fn(usize) -> bool) {
        for (i, cell) in self.cells.iter_mut().enumerate() {
            *cell = if touches(i) { CellState::Stick } else { CellState::Exterior };
        }
    }

    /// Removes all tractions from a cell that leaves the contact.
    pub(crate) fn release(&mut self, cell: usize) {
        self.cells[cell] = CellState::Exterior;
        for traction in &mut self.traction {
            traction[cell] = 0.0;
        }
    }

    pub(crate) fn tangent(&self, cell: usize) -> [f64; 2] {
        [self.traction[0][cell], self.traction[1][cell]]
    }

    /// The unit vector of the tangential traction of a cell; along x if the traction is zero.
    pub(crate) fn direction(&self, cell: usize) -> [f64; 2] {
        let [x, y] = self.tangent(cell);
        let size = x.hypot(y);
        if size > 0.0 { [x / size, y / size] } else { [1.0, 0.0] }
    }

    /// Sets the tangential traction of a cell to this magnitude and direction.
    pub(crate) fn pull(&mut self, cell: usize, size: f64, direction: [f64; 2]) {
        for (traction, direction) in self.traction.iter_mut().zip(direction) {
            traction[cell] = size * direction;
        }
    }

    pub(crate) fn touching(&self) -> impl Iterator<Item = usize> + '_ {
        let touches = |(i, cell): (usize, &CellState)| (*cell != CellState::Exterior).then_some(i);
        self.cells.iter().enumerate().filter_map(touches)
    }
}

/// The end of a step.
#[derive(Debug, Clone, Copy)]
pub(crate) struct End<'a> {
    pub(crate) tolerance: f64,
    pub(crate) reached: Convergence,
    pub(crate) from: &'a ContactState,
    pub(crate) drive: &'a Drive,
}

impl Outcome {
    /// Writes the state at the end of a step, if its violations are within the tolerance.
    pub(crate) fn end(
        &self,
        end: End<'_>,
        to: &mut ContactState,
    ) -> Result<Convergence, DirectError> {
        let End { tolerance, reached, from, drive } = end;
        let Residuals { normal, tangential } = reached.residuals;
        if !(normal <= tolerance && tangential <= tolerance) {
            return Err(DirectError::NotConverged { tolerance, reached });
        }
        to.shift = drive.shift_after(from.shift);
        let [x, y, pressure] = &self.traction;
        to.pressure.values_mut().copy_from_slice(pressure);
        to.traction_x.values_mut().copy_from_slice(x);
        to.traction_y.values_mut().copy_from_slice(y);
        to.displacement_x.values_mut().copy_from_slice(&self.displacement[0]);
        to.displacement_y.values_mut().copy_from_slice(&self.displacement[1]);
        to.cells.values_mut().copy_from_slice(&self.cells);
        Ok(Convergence { stop: Stop::Converged, ..reached })
    }
}

/// Writes the end of a step after which the bodies are separated; `None` if they are in contact.
pub(crate) fn apart(
    problem: &ContactProblem,
    drive: &Drive,
    from: &ContactState,
    to: &mut ContactState,
) -> Option<Convergence> {
    let zeta = problem.apart(drive.normal)?;
    *to = ContactState::apart(problem.grid());
    to.shift = Shift { zeta, ..drive.shift_after(from.shift) };
    let (products, residuals) = Default::default();
    Some(Convergence { iterations: 0, products, residuals, stop: Stop::Converged })
}
