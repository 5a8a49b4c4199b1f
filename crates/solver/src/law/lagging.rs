//! Slip that lags, in a viscous material: a step begins with the true slip ([`SlipLag`]).

use carom_halfspace::Grid;
use carom_laws::ellipse::ContactEllipse;
use carom_laws::law::Shift;
use carom_laws::slip_lag::SlipLag;

use super::ahead::Slip;
use crate::state::{CellState, ContactState};

/// What of the slip of the last step is still to come.
pub(super) struct ToCome<'a> {
    /// The contact after that step, and its edge.
    pub(super) last: &'a ContactState,
    pub(super) ellipse: ContactEllipse,
    pub(super) slip: &'a Slip,
    pub(super) lag: SlipLag,
}

impl ToCome<'_> {
    /// Takes it off the displacements with which a step begins.
    pub(super) fn take_off(&self, from: &mut ContactState) {
        let (grid, mean) = (from.pressure.grid(), self.mean());
        let (u, v) = (from.displacement_x.values_mut(), from.displacement_y.values_mut());
        for (i, (x, y)) in grid.centres().enumerate() {
            let [by_x, by_y] = self.at([x, y], mean);
            u[i] += by_x;
            v[i] += by_y;
        }
    }

    /// That at a place. One that has not touched yet follows the field of those that have: its mean, and in proportion to
    /// the radius what differs from it. Beyond places that stick it is that of the twist alone.
    fn at(&self, place @ [x, y]: [f64; 2], mean: [f64; 2]) -> [f64; 2] {
        if self.sticks(place) {
            return [0.0; 2];
        }
        let part = self.lag.part();
        let (radius, edge) = (self.radius(place), self.edge());
        if radius <= edge {
            return self.slipped(place).map(|by| part * by);
        }
        let inner = place.map(|x| x * edge / radius);
        if self.sticks(inner) {
            let turned = self.lag.turned();
            return [turned * (y - inner[1]), -turned * (x - inner[0])]; // (12.2)
        }
        let by = self.slipped(inner);
        [0, 1].map(|k| part * (mean[k] + (by[k] - mean[k]) * radius / edge))
    }

    /// The radius of the true contact over that of the effective one, at least a cell.
    fn edge(&self) -> f64 {
        let grid = self.last.pressure.grid();
        self.lag.within().max(self.radius([grid.dx(), 0.0]).max(self.radius([0.0, grid.dy()])))
    }

    fn radius(&self, [x, y]: [f64; 2]) -> f64 {
        self.ellipse.radius_squared(x, y).sqrt()
    }

    fn sticks(&self, place: [f64; 2]) -> bool {
        let grid = self.last.pressure.grid();
        let cell = Place::of(grid, place).cell(grid);
        cell.is_some_and(|cell| self.last.cells.values()[cell] == CellState::Stick)
    }

    fn slipped(&self, place: [f64; 2]) -> [f64; 2] {
        let grid = self.last.pressure.grid();
        let place = Place::of(grid, place);
        [0, 1].map(|k| place.between(grid, &self.slip.by[k]))
    }

    /// The mean slip of the cells that have touched.
    fn mean(&self) -> [f64; 2] {
        let (edge, mut sum, mut count) = (self.edge(), [0.0; 2], 0.0);
        for (i, (x, y)) in self.last.pressure.grid().centres().enumerate() {
            if self.radius([x, y]) <= edge {
                count += 1.0;
                sum = [0, 1].map(|k| sum[k] + self.slip.by[k][i]);
            }
        }
        sum.map(|sum| if count > 0.0 { sum / count } else { 0.0 })
    }
}

/// What the slip of cells that have not touched yet will be when they touch changes as the path bends. `ellipse` is the
/// edge of the contact after the step.
pub(super) fn bend(from: &mut ContactState, ellipse: &ContactEllipse, lag: SlipLag) {
    let (grid, Shift { xi, eta, omega, .. }) = (from.pressure.grid(), lag.bent());
    let (u, v) = (from.displacement_x.values_mut(), from.displacement_y.values_mut());
    for (i, (x, y)) in grid.centres().enumerate() {
        if from.pressure.values()[i] > 0.0 {
            let part = lag.bent_at(ellipse.radius_squared(x, y).sqrt());
            u[i] -= part * (xi + y * omega); // (12.2)
            v[i] -= part * (eta - x * omega);
        }
    }
}

/// A place on a grid, in cells from the centre of the first one.
struct Place([f64; 2]);

impl Place {
    fn of(grid: Grid, [x, y]: [f64; 2]) -> Self {
        Self([(x - grid.centred_x(0)) / grid.dx(), (y - grid.centred_y(0)) / grid.dy()])
    }

    /// The cell in which it lies.
    fn cell(&self, grid: Grid) -> Option<usize> {
        index(grid, self.0.map(f64::round))
    }

    /// The value there, linear between the centres of cells; zero beyond the grid.
    fn between(&self, grid: Grid, values: &[f64]) -> f64 {
        let low = self.0.map(f64::floor);
        let high = [0, 1].map(|k| self.0[k] - low[k]);
        let weighted = |[right, up]: [usize; 2]| {
            let weight = |k: usize, by: usize| if by == 1 { high[k] } else { 1.0 - high[k] };
            let cell = index(grid, [low[0] + right as f64, low[1] + up as f64]);
            weight(0, right) * weight(1, up) * cell.map_or(0.0, |cell| values[cell])
        };
        [[0, 0], [0, 1], [1, 0], [1, 1]].map(weighted).iter().sum()
    }
}

fn index(grid: Grid, [x, y]: [f64; 2]) -> Option<usize> {
    let within = |at: f64, count: usize| (at >= 0.0 && at < count as f64).then_some(at as usize);
    Some(grid.index(within(x, grid.nx())?, within(y, grid.ny())?))
}
