//! FASTSIM: tractions by springs under given pressures.

use super::case::ContactCase;
use super::springs::Fastsim;
use carom_laws::creep::CreepCoefficients;
use carom_rolling::{Creepage, Springs, Way};
use carom_solver::ContactState;
use carom_special::RangeError;
use std::f64::consts::PI;

impl Fastsim {
    /// Tractions at creepages CKSI and CETA under the pressures of a state, and the friction heat per distance rolled.
    pub(super) fn roll(
        &self,
        case: &ContactCase,
        [x, y]: [f64; 2],
        way: &Way,
        force: f64,
        state: &mut ContactState,
    ) -> Result<f64, RangeError> {
        let velocity = case.motion.rolling().map_or(0.0, |rolling| rolling.veloc);
        let sliding = velocity * libm::hypot(x, y);
        let friction = |row: usize| match case.falling {
            Some(falling) => falling.at(sliding),
            None => case.friction[row.min(case.friction.len() - 1)],
        };
        let rows = state.pressure.grid().ny();
        let mean = (0..rows).map(friction).sum::<f64>() / rows as f64;
        let whole = Whole { case, creepage: [x, y, case.drive.spin], force };
        let springs = match (self.flexibility, case.ellipse) {
            (Some(flexibility), _) => Springs::alike(flexibility)?,
            (None, Some(ellipse)) => whole.springs(ellipse.semi_axes)?,
            (None, None) => whole.springs(equivalent(state))?,
        };
        let factor = self.stiffness(&whole, equivalent(state), mean)?;
        let soft = Springs::new(springs.flexibilities().map(|own| own / factor))?;
        let middle = case.of_middle();
        let creepage =
            Creepage { along: -(x + middle[0]), across: -(y + middle[1]), spin: case.drive.spin };
        soft.roll(way, creepage, friction, state)
    }

    /// By how much the springs are stiffer at this creepage, after Spiryagin and others (2013).
    fn stiffness(
        &self,
        whole: &Whole<'_>,
        [a, b]: [f64; 2],
        friction: f64,
    ) -> Result<f64, RangeError> {
        let ([k0, alfa, beta], [along, across, spin]) = (self.slope, whole.creepage);
        if alfa == 1.0 || beta == 0.0 {
            return Ok(k0);
        }
        let turned = across + spin * a;
        let across = if turned.abs() < across.abs() { across } else { turned };
        let materials = whole.case.materials;
        let c11 = CreepCoefficients::by_table(a / b, whole.poisson())?.c11;
        let modulus = 2.0 * materials.shear_modulus();
        let slope = 0.25 * PI * a * b * modulus * k0 * c11 * libm::hypot(along, across)
            / (friction * whole.force);
        Ok(k0 * (alfa + (1.0 - alfa) / (1.0 + beta * slope)))
    }
}

/// A contact as a whole: its creepages of body 1 against body 2, and FN.
struct Whole<'a> {
    case: &'a ContactCase,
    creepage: [f64; 3],
    force: f64,
}

impl Whole<'_> {
    /// That of the pair as CONTACT has it.
    fn poisson(&self) -> f64 {
        let materials = self.case.materials;
        let [one, two] = [materials.body_1(), materials.body_2()];
        let part = |g: f64, other: f64| other / (g + other);
        let (g, h) = (one.shear_modulus(), two.shear_modulus());
        part(g, h) * one.poisson() + part(h, g) * two.poisson()
    }

    /// Kalker's three flexibilities, which CONTACT blends into one as creepages grow: one for which the sum of the squared motions
    /// over the flexibilities stays the same.
    fn springs(&self, [a, b]: [f64; 2]) -> Result<Springs, RangeError> {
        let modulus = 2.0 * self.case.materials.shear_modulus();
        let c = CreepCoefficients::by_table(a / b, self.poisson())?;
        let own = Springs::of_ellipse([a, b], modulus, &c)?.flexibilities();
        let size = libm::sqrt(a * b);
        let unit = self.case.friction[0] * self.force / (modulus * size * size);
        let units = [unit / c.c11, unit / c.c22, unit / (size * c.c23)];
        let length = |parts: [f64; 3]| libm::sqrt(parts.iter().map(|part| part * part).sum());
        let weight = (length(self.creepage) / length(units) / 3.0).min(1.0);
        let [x, y, spin] = self.creepage;
        // The mean traction of a spin over that of a creepage.
        let motions = [x, y, spin * 3.0 * PI * a / 32.0].map(|motion| motion * motion);
        let sum: f64 = motions.iter().sum();
        if sum == 0.0 {
            return Springs::new(own);
        }
        let stiff: f64 = motions.iter().zip(own).map(|(motion, own)| motion / own).sum();
        Springs::new(own.map(|own| (1.0 - weight) * own + weight * sum / stiff))
    }
}

/// The semi-axes of an ellipse as large as the contact, and with its proportions.
fn equivalent(state: &ContactState) -> [f64; 2] {
    let grid = state.pressure.grid();
    let mut ends = [[usize::MAX, 0], [usize::MAX, 0]];
    let mut count = 0.0_f64;
    let pressed =
        state.pressure.values().iter().enumerate().filter(|(_, pressure)| **pressure > 0.0);
    for (cell, _) in pressed {
        count += 1.0;
        for (end, place) in ends.iter_mut().zip([cell % grid.nx(), cell / grid.nx()]) {
            *end = [end[0].min(place), end[1].max(place)];
        }
    }
    let side =
        |[first, last]: [usize; 2], width: f64| width * (last.saturating_sub(first) + 1) as f64;
    let (long, wide) = (side(ends[0], grid.dx()), side(ends[1], grid.dy()));
    let radius = libm::sqrt(count.max(1.0) * grid.cell_area() / PI);
    [radius * libm::sqrt(long / wide), radius * libm::sqrt(wide / long)]
}
