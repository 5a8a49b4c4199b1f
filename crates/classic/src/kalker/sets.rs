//! The sets of cells in contact, sticking and slipping, and their linear systems.

use crate::direct::dense::{self, AXES, Unknown};
use crate::direct::{Demand, DirectError, Influence, Outcome};
use carom_solver::CellState;

/// A violation below this fraction of its scale is rounding.
pub(super) const ROUNDING: f64 = 1e-13;

/// The problem of one step and its solution.
pub(super) struct Sets<'a> {
    pub(super) influence: &'a Influence,
    pub(super) demand: &'a Demand,
    pub(super) outcome: &'a mut Outcome,
    /// Number of linear systems solved.
    pub(super) solved: usize,
}

impl Sets<'_> {
    /// Computes the displacements due to all tractions.
    pub(super) fn displace(&mut self) {
        self.influence.displacements(&self.outcome.traction, &mut self.outcome.displacement);
    }

    /// The overlap of a cell; positive if the surfaces would penetrate each other.
    fn overlap(&self, cell: usize) -> f64 {
        self.demand.target[2][cell] - self.outcome.displacement[2][cell]
    }

    /// Solves for these unknowns, adds them to the tractions and computes the displacements.
    pub(super) fn solve(&mut self, unknowns: &[Unknown]) -> Result<Vec<f64>, DirectError> {
        let amounts = dense::solve(unknowns, |at, from| self.influence.block(at, from))?;
        for (unknown, amount) in unknowns.iter().zip(&amounts) {
            for (traction, direction) in self.outcome.traction.iter_mut().zip(unknown.direction) {
                traction[unknown.cell] += direction * amount;
            }
        }
        self.solved += 1;
        Ok(amounts)
    }

    /// Reduces a contact area without tractions to the cells that the pressures alone keep in contact.
    pub(super) fn press(&mut self, rounds: usize) -> Result<(), DirectError> {
        if self.outcome.traction.iter().flatten().any(|traction| *traction != 0.0) {
            return Ok(());
        }
        for _ in 0..rounds {
            self.displace();
            let touching: Vec<usize> = self.outcome.touching().collect();
            let unknowns: Vec<Unknown> =
                touching.into_iter().map(|cell| self.pressure(cell)).collect();
            self.solve(&unknowns)?;
            if self.drop_tension() == 0.0 {
                break;
            }
        }
        Ok(())
    }

    /// The pressure of a cell in contact, at given tangential tractions.
    pub(super) fn pressure(&self, cell: usize) -> Unknown {
        let right = self.overlap(cell);
        Unknown { cell, direction: AXES[2], test: AXES[2], own: 0.0, right }
    }

    /// The two tractions of a cell that sticks.
    pub(super) fn stick(&self, cell: usize) -> [Unknown; 2] {
        let slip = self.demand.slip(cell, &self.outcome.displacement);
        [0, 1].map(|axis| {
            let (direction, test, right) = (AXES[axis], AXES[axis], -slip[axis]);
            Unknown { cell, direction, test, own: 0.0, right }
        })
    }

    /// The component of the traction of a slipping cell perpendicular to its direction: (12.21)
    /// over 1 + E1^2.
    pub(super) fn turn(&self, cell: usize, limit: f64) -> Unknown {
        let [n_x, n_y] = self.outcome.direction(cell);
        let slip = self.demand.slip(cell, &self.outcome.displacement);
        let across = [-n_y, n_x, 0.0];
        let along = slip[0] * n_x + slip[1] * n_y;
        let own = (-along).max(0.0) / limit;
        let right = slip[0] * n_y - slip[1] * n_x;
        Unknown { cell, direction: across, test: across, own, right }
    }

    /// Indices and friction limits of all cells in contact with friction.
    pub(super) fn limits(&self) -> Vec<(usize, f64)> {
        let limit = |cell| self.demand.limit(cell, self.outcome.traction[2][cell]);
        self.outcome.touching().map(|cell| (cell, limit(cell))).collect()
    }

    pub(super) fn slips(&self, cell: usize) -> bool {
        self.outcome.cells[cell] == CellState::Slip
    }

    /// Removes cells in tension from the contact; returns their number.
    pub(super) fn drop_tension(&mut self) -> f64 {
        let pulled: Vec<usize> =
            self.outcome.touching().filter(|&i| self.outcome.traction[2][i] <= 0.0).collect();
        pulled.iter().for_each(|&cell| self.outcome.release(cell));
        pulled.len() as f64
    }

    /// Adds cells that overlap to the contact; returns their number.
    pub(super) fn add_overlap(&mut self) -> f64 {
        let least = ROUNDING * self.demand.depth();
        let outside = |i: &usize| self.outcome.cells[*i] == CellState::Exterior;
        let cells = 0..self.outcome.cells.len();
        let overlapping: Vec<usize> =
            cells.filter(|i| outside(i) && self.overlap(*i) > least).collect();
        overlapping.iter().for_each(|&cell| self.outcome.cells[cell] = CellState::Stick);
        overlapping.len() as f64
    }

    /// Makes cells slip whose traction exceeds the limit; returns their number.
    pub(super) fn let_slip(&mut self) -> f64 {
        let mut count = 0.0;
        for (cell, limit) in self.limits() {
            let [x, y] = self.outcome.tangent(cell);
            if !self.slips(cell) && x.hypot(y) > limit * (1.0 + ROUNDING) {
                let direction = self.outcome.direction(cell);
                self.outcome.pull(cell, limit, direction);
                self.outcome.cells[cell] = CellState::Slip;
                count += 1.0;
            }
        }
        count
    }

    /// Makes cells stick that slip in the direction of their traction; returns their number.
    pub(super) fn let_stick(&mut self) -> f64 {
        let mut count = 0.0;
        let least = ROUNDING * self.demand.depth();
        for (cell, limit) in self.limits() {
            let slip = self.demand.slip(cell, &self.outcome.displacement);
            let [x, y] = self.outcome.direction(cell);
            if self.slips(cell) && limit > 0.0 && slip[0] * x + slip[1] * y > least {
                self.outcome.cells[cell] = CellState::Stick;
                count += 1.0;
            }
        }
        count
    }

    /// Makes all cells in contact stick.
    pub(super) fn let_all_stick(&mut self) {
        for cell in &mut self.outcome.cells {
            if *cell == CellState::Slip {
                *cell = CellState::Stick;
            }
        }
    }

    /// Makes cells in contact without friction slip, with zero traction.
    pub(super) fn let_the_smooth_slip(&mut self) {
        for (cell, _) in self.limits() {
            if self.demand.friction[cell] == 0.0 {
                self.outcome.pull(cell, 0.0, [1.0, 0.0]);
                self.outcome.cells[cell] = CellState::Slip;
            }
        }
    }
}
