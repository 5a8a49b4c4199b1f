//! The state of each cell, chosen from its tractions, gap and slip.

use carom_halfspace::operator::SurfaceOperator;

use super::system::System;
use super::task::CoupledTask;
use crate::convergence::Residuals;
use crate::friction::finite_coefficient;
use crate::state::CellState;
use crate::tangential::{half_diagonal, project_to_disc};

/// The greatest stiffness for turning the traction of a slipping cell, relative to the influence of a cell on
/// itself. Without friction it is infinite: no traction remains.
const STIFFEST: f64 = 1e6;

/// The states of the cells, and the cone rays of those that slip.
#[derive(Clone)]
pub(super) struct Cells {
    /// Influences of a cell on itself: normal, and the mean of both tangential ones.
    pub(super) own: [f64; 2],
    /// Damping of the traction along the rays of slipping cells, relative to the influence of a cell on
    /// itself. With damping cells that come into contact slip first.
    pub(super) damping: f64,
    pub(super) states: Vec<CellState>,
    /// The cells that stick or slip, in order.
    pub(super) active: Vec<usize>,
    /// Directions of the tangential tractions of slipping cells.
    pub(super) rim: [Vec<f64>; 2],
    /// Slip over traction in slipping cells: the stiffness term for turning the traction.
    pub(super) bend: Vec<f64>,
    /// (cos, sin) of the half angle of the friction cone, from the normal to its rays.
    pub(super) ray: Vec<[f64; 2]>,
}

/// Which cells take the state that they should have.
#[derive(Clone, Copy)]
pub(super) enum Changes {
    All,
    /// The half of them with the greatest violation.
    GreaterHalf,
}

/// The state that a cell should have.
#[derive(Clone, Copy)]
struct Wanted {
    state: CellState,
    rim: [f64; 2],
    /// Traction along the ray of the cone.
    length: f64,
    bend: f64,
}

impl Wanted {
    /// A cell that does not slip.
    const fn of(state: CellState) -> Self {
        Self { state, rim: [0.0; 2], length: 0.0, bend: 0.0 }
    }
}

impl Cells {
    pub(super) fn new(operator: &dyn SurfaceOperator) -> Self {
        let (own, cells) = (operator.coefficients(0, 0).rows, operator.grid().cells());
        Self {
            own: [own[2][2], 0.5 * (own[0][0] + own[1][1])],
            damping: 0.0,
            states: vec![CellState::Exterior; cells],
            active: Vec::new(),
            rim: [vec![0.0; cells], vec![0.0; cells]],
            bend: vec![0.0; cells],
            ray: vec![[1.0, 0.0]; cells],
        }
    }

    /// The rays of the initial tractions. Pressed cells without friction slip; the tangential solver counts
    /// them as separated.
    pub(super) fn begin(&mut self, task: &mut CoupledTask<'_>) {
        for i in 0..task.cells.len() {
            if task.cells[i] == CellState::Exterior && task.pressure[i] > 0.0 {
                task.cells[i] = CellState::Slip;
            }
            let at = [task.traction[0][i], task.traction[1][i]];
            let size = at[0].hypot(at[1]);
            let rim = if size > 0.0 { at.map(|t| t / size) } else { [1.0, 0.0] };
            (self.rim[0][i], self.rim[1][i]) = (rim[0], rim[1]);
        }
    }

    /// The residuals: the normal one relative to the greatest displacement, the tangential one
    /// relative to the greatest limit, or to the greatest pressure or traction if these are
    /// smaller. The normal one is infinite if no cell is in contact.
    pub(super) fn residuals(&self, task: &CoupledTask<'_>, system: &System) -> Residuals {
        let [mut normal, mut tangential] = self.unbalance(task, system);
        let (mut depth, mut most, mut reached) = (0.0_f64, 0.0_f64, 0.0_f64);
        for (i, &pressure) in task.pressure.iter().enumerate() {
            let (off, distance) = self.violations(task, system, i);
            if off.is_nan() || distance.is_nan() {
                return Residuals { normal: f64::NAN, tangential: f64::NAN };
            }
            (normal, tangential) = (normal.max(off), tangential.max(distance));
            if pressure > 0.0 {
                depth = depth.max((system.gap[i] + task.approach - task.heights[i]).abs());
                most = most.max(finite_coefficient(task.friction[i]) * pressure);
                let size = task.traction[0][i].hypot(task.traction[1][i]);
                reached = reached.max(pressure).max(size);
            }
        }
        let over = |value: f64, scale: f64| if scale > 0.0 { value / scale } else { value };
        let nothing = depth == 0.0;
        Residuals {
            normal: if nothing { f64::INFINITY } else { over(normal, depth) },
            tangential: over(tangential, most.min(reached)),
        }
    }

    /// The errors of the loads for each cell in contact, as a displacement (normal) and as a traction
    /// (tangential).
    fn unbalance(&self, task: &CoupledTask<'_>, system: &System) -> [f64; 2] {
        let (missing, arm) = (system.missing(task), half_diagonal(task.operator.grid()));
        let touching = task.pressure.iter().filter(|p| **p > 0.0).count().max(1) as f64;
        let tangential = missing[1].abs().max(missing[2].abs()).max(missing[3].abs() / arm);
        [self.own[1] * missing[0].abs() / touching, tangential / touching]
    }

    /// The norm of all violations, as displacements.
    pub(super) fn violation(&self, task: &CoupledTask<'_>, system: &System) -> f64 {
        let square = |i: usize| {
            let (off, distance) = self.violations(task, system, i);
            off * off + (self.own[1] * distance).powi(2)
        };
        (0..task.cells.len()).map(square).sum::<f64>().sqrt()
    }

    /// By how much a cell violates the normal conditions, as a displacement, and the friction law, as a
    /// traction.
    fn violations(&self, task: &CoupledTask<'_>, system: &System, i: usize) -> (f64, f64) {
        let (pressure, gap) = (task.pressure[i], system.gap[i]);
        let off =
            if pressure > 0.0 { gap.abs() } else { (-gap).max(-pressure * self.own[0]).max(0.0) };
        let at = [task.traction[0][i], task.traction[1][i]];
        let limit = finite_coefficient(task.friction[i]) * pressure.max(0.0);
        let to = project_to_disc(self.pulled(task, system, i), limit);
        (off, (at[0] - to[0]).hypot(at[1] - to[1]))
    }

    /// Sets the states and projects the tractions onto what the states admit.
    pub(super) fn choose(&mut self, task: &mut CoupledTask<'_>, system: &System, changes: Changes) {
        let wanted: Vec<Wanted> =
            (0..task.cells.len()).map(|i| self.wanted(task, system, i)).collect();
        let bar = match changes {
            Changes::All => 0.0,
            Changes::GreaterHalf => self.middle(task, system, &wanted),
        };
        for (i, wanted) in wanted.iter().enumerate() {
            let changes = wanted.state != task.cells[i];
            if changes && self.pressing(task, system, i) < bar {
                continue;
            }
            task.cells[i] = wanted.state;
            self.bend[i] = wanted.bend;
            let (pressure, traction) = match wanted.state {
                CellState::Exterior => (0.0, [0.0; 2]),
                CellState::Stick => (task.pressure[i], [task.traction[0][i], task.traction[1][i]]),
                CellState::Slip => {
                    let [cos, sin] = ray(task.friction[i]);
                    (self.rim[0][i], self.rim[1][i]) = (wanted.rim[0], wanted.rim[1]);
                    (cos * wanted.length, wanted.rim.map(|e| sin * wanted.length * e))
                }
            };
            task.pressure[i] = pressure;
            (task.traction[0][i], task.traction[1][i]) = (traction[0], traction[1]);
        }
        self.active.clear();
        for (i, state) in task.cells.iter().enumerate() {
            self.ray[i] = ray(task.friction[i]);
            self.states[i] = *state;
            if *state != CellState::Exterior {
                self.active.push(i);
            }
        }
    }

    /// Projects tractions that violate their cone within the tolerance onto it.
    pub(super) fn finish(&self, task: &mut CoupledTask<'_>) {
        for i in 0..task.cells.len() {
            let pressure = task.pressure[i].max(0.0);
            task.pressure[i] = pressure;
            let at = [task.traction[0][i], task.traction[1][i]];
            let [x, y] = project_to_disc(at, finite_coefficient(task.friction[i]) * pressure);
            (task.traction[0][i], task.traction[1][i]) = (x, y);
            if pressure == 0.0 {
                task.cells[i] = CellState::Exterior;
            }
        }
    }

    /// How far a cell is from its conditions, as a displacement.
    fn pressing(&self, task: &CoupledTask<'_>, system: &System, i: usize) -> f64 {
        match task.cells[i] {
            CellState::Exterior => (-system.gap[i]).max(0.0),
            CellState::Stick => {
                let [cos, sin] = ray(task.friction[i]);
                let size = task.traction[0][i].hypot(task.traction[1][i]);
                (self.own[0] * (cos * size - sin * task.pressure[i])).max(0.0)
            }
            CellState::Slip => {
                let along = dot(system.slip(i), self.rim(i));
                along.max(-self.own[0] * self.length(task, i)).max(0.0)
            }
        }
    }

    /// The least violation in the greater half of the cells that should change.
    fn middle(&self, task: &CoupledTask<'_>, system: &System, wanted: &[Wanted]) -> f64 {
        let changing = wanted.iter().enumerate().filter(|(i, w)| w.state != task.cells[*i]);
        let mut sizes: Vec<f64> = changing.map(|(i, _)| self.pressing(task, system, i)).collect();
        sizes.sort_by(f64::total_cmp);
        sizes.get(sizes.len().div_ceil(2)).copied().unwrap_or(0.0)
    }

    /// The component of a cell's traction along its ray.
    fn length(&self, task: &CoupledTask<'_>, i: usize) -> f64 {
        let [cos, sin] = ray(task.friction[i]);
        let along = dot([task.traction[0][i], task.traction[1][i]], self.rim(i));
        cos * task.pressure[i] + sin * along
    }

    fn wanted(&self, task: &CoupledTask<'_>, system: &System, i: usize) -> Wanted {
        let friction = finite_coefficient(task.friction[i]);
        if friction == 0.0 {
            return self.wanted_without_friction(task, system, i);
        }
        let [cos, sin] = ray(friction);
        let at = [task.traction[0][i], task.traction[1][i]];
        let pressure = task.pressure[i];
        let slips = |length, limit| self.slipping(task, system, i, [length, limit]);
        let [x, y] = self.pulled(task, system, i);
        let size = x.hypot(y);
        match task.cells[i] {
            CellState::Exterior => {
                let pushed = -system.gap[i] / self.own[0];
                if pushed.is_nan() || pushed <= 0.0 {
                    Wanted::of(CellState::Exterior)
                } else if size <= friction * pushed && self.damping == 0.0 {
                    Wanted::of(CellState::Stick)
                } else {
                    slips(0.0, friction * pushed)
                }
            }
            CellState::Stick => {
                let size_now = at[0].hypot(at[1]);
                if size_now <= friction * pressure {
                    return Wanted::of(CellState::Stick);
                }
                let length = cos * pressure + sin * size_now;
                if length > 0.0 {
                    slips(length, sin * length)
                } else {
                    Wanted::of(CellState::Exterior)
                }
            }
            CellState::Slip => {
                let length = self.length(task, i);
                let along = dot(system.slip(i), self.rim(i));
                if length <= 0.0 {
                    Wanted::of(CellState::Exterior)
                } else if along > 0.0 || size == 0.0 {
                    Wanted::of(CellState::Stick)
                } else {
                    slips(length, sin * length)
                }
            }
        }
    }

    /// A cell without friction slips while it is pressed.
    fn wanted_without_friction(&self, task: &CoupledTask<'_>, system: &System, i: usize) -> Wanted {
        let enters = task.cells[i] == CellState::Exterior;
        let (length, pressed) =
            if enters { (0.0, -system.gap[i]) } else { (task.pressure[i], task.pressure[i]) };
        if pressed > 0.0 {
            self.slipping(task, system, i, [length, 0.0])
        } else {
            Wanted::of(CellState::Exterior)
        }
    }

    /// Slip with this traction along the ray and this friction limit.
    fn slipping(
        &self,
        task: &CoupledTask<'_>,
        system: &System,
        i: usize,
        [length, limit]: [f64; 2],
    ) -> Wanted {
        let pulled = self.pulled(task, system, i);
        let size = pulled[0].hypot(pulled[1]);
        let rim = if size > 0.0 { pulled.map(|t| t / size) } else { self.rim(i) };
        let slip = (-dot(system.slip(i), rim)).max(0.0);
        let stiffest = STIFFEST * self.own[1];
        let bend = if slip < stiffest * limit { slip / limit } else { stiffest };
        Wanted { state: CellState::Slip, rim, length, bend }
    }

    /// The traction that a cell would have if it stuck and no other traction changed.
    fn pulled(&self, task: &CoupledTask<'_>, system: &System, i: usize) -> [f64; 2] {
        [0, 1].map(|axis| task.traction[axis][i] - system.slip[axis][i] / self.own[1])
    }

    fn rim(&self, i: usize) -> [f64; 2] {
        [self.rim[0][i], self.rim[1][i]]
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// (cos, sin) of the half angle of Coulomb's cone.
fn ray(friction: f64) -> [f64; 2] {
    let friction = finite_coefficient(friction);
    let over = (1.0 + friction * friction).sqrt();
    [1.0 / over, friction / over]
}
