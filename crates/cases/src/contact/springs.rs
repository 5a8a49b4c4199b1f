//! What an input says of FASTSIM: BOUND = 0, 2 and 3 with MATER = 2 and 3.

use super::fault::Fault;
use super::lines::Lines;
use super::potential::Ellipse;
use carom_halfspace::Grid;
use carom_solver::ContactState;
use std::f64::consts::PI;

/// Particles with springs of their own instead of elastic bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fastsim {
    /// FLX; none for the three flexibilities of Kalker.
    pub(super) flexibility: Option<f64>,
    /// K0_MF, ALFAMF and BETAMF: how springs soften with creepage.
    pub(super) slope: [f64; 3],
}

/// The pressures of a case: BOUND.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// Solved for.
    Solved,
    /// Ellipsoidal over the ellipse of Hertz.
    Ellipsoidal(Ellipse),
    /// Paraboloidal over it.
    Paraboloidal(Ellipse),
}

impl Bound {
    /// The pressures that are given, in the cells of an area about this middle.
    pub(super) fn given(&self, grid: Grid, [at_x, at_y]: [f64; 2]) -> Option<ContactState> {
        let (ellipse, power) = match self {
            Self::Solved => return None,
            Self::Ellipsoidal(ellipse) => (ellipse, 0.5),
            Self::Paraboloidal(ellipse) => (ellipse, 1.0),
        };
        let [a, b] = ellipse.semi_axes;
        let highest = (1.0 + power) * ellipse.force / (PI * a * b);
        let mut state = ContactState::apart(grid);
        for (own, (x, y)) in state.pressure.values_mut().iter_mut().zip(grid.centres()) {
            let (x, y) = ((x + at_x) / a, (y + at_y) / b);
            *own = highest * libm::pow((1.0 - x * x - y * y).max(0.0), power);
        }
        state.shift.zeta = ellipse.approach;
        Some(state)
    }
}

impl Fastsim {
    /// MATER.
    pub(super) const fn mater(&self) -> u8 {
        if self.flexibility.is_some() { 2 } else { 3 }
    }

    /// Reads what MATER = 2 or 3 adds to the materials.
    pub(super) fn read(lines: &mut Lines<'_>, mater: u8) -> Result<Self, Fault> {
        let (flexibility, [k0, alfa, beta]) = if mater == 2 {
            let [flx, k0, alfa, beta] = lines.numbers(["FLX", "K0_MF", "ALFAMF", "BETAMF"])?;
            let allowed = "from 1e-10 to 1e20";
            let flx = flx.checked(|value| (1e-10..=1e20).contains(&value), allowed)?;
            (Some(flx), [k0, alfa, beta])
        } else {
            (None, lines.numbers(["K0_MF", "ALFAMF", "BETAMF"])?)
        };
        let slope = [
            k0.checked(|value| (1e-10..=1.0).contains(&value), "from 1e-10 to 1")?,
            alfa.checked(|value| (0.0..=1.0).contains(&value), "from 0 to 1")?,
            beta.checked(|value| (0.0..=1e20).contains(&value), "from 0 to 1e20")?,
        ];
        Ok(Self { flexibility, slope })
    }
}
