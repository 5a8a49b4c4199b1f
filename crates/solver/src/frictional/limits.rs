//! The traction bounds of the cells: Coulomb's cone, or a smaller coefficient with a cohesion.
//!
//! With friction coefficient f and coupling parameter gamma, a small change of pressure makes a
//! large change of the bounds if f gamma is large, and the alternation diverges. A smaller
//! coefficient f' and a cohesion c with `|t| <= c + f' p` have the same solution as Coulomb's law
//! if `c = (1 - f'/f) |t|`. To take c from the last solution is an implicit step towards that
//! solution; it converges where plain alternation would cycle. With infinite friction f' stays
//! finite.

use carom_halfspace::Field;

use crate::state::ContactState;

/// The greatest factor by which a step of the cohesion is extrapolated.
const LARGEST_EXTRAPOLATION: f64 = 30.0;

/// The bounds are raised until they hold this many times the prescribed loads, if friction can hold
/// them.
const RESERVE: f64 = 1.05;

/// The traction bounds of a step, cell by cell.
#[derive(Clone)]
pub(crate) struct FrictionLimits {
    /// Friction coefficients.
    pub(crate) friction: Vec<f64>,
    /// The traction bounds.
    pub(crate) values: Vec<f64>,
    /// The smaller coefficients with cohesion, while they replace Coulomb's law.
    cone: Option<Cone>,
}

/// A smaller friction coefficient with a cohesion.
#[derive(Clone)]
struct Cone {
    /// The coefficients in use.
    blunt: Vec<f64>,
    cohesion: Vec<f64>,
    /// The error of the cohesion in the last pass, and the factor of the last extrapolation.
    off: Vec<f64>,
    times: f64,
}

impl FrictionLimits {
    pub(crate) fn new(cells: usize) -> Self {
        Self { friction: vec![0.0; cells], values: vec![0.0; cells], cone: None }
    }

    pub(crate) fn greatest_friction(&self) -> f64 {
        self.friction.iter().copied().fold(0.0, f64::max)
    }

    /// Returns to Coulomb's law with the full coefficient.
    pub(crate) fn sharpen(&mut self) {
        self.cone = None;
    }

    /// Whether Coulomb's law is used with the full coefficient.
    pub(crate) const fn is_sharp(&self) -> bool {
        self.cone.is_none()
    }

    /// Uses at most this coefficient, with a cohesion for the difference.
    pub(crate) fn blunt(&mut self, most: f64) {
        let zero = vec![0.0; self.friction.len()];
        let new = || Cone { blunt: zero.clone(), cohesion: zero.clone(), off: zero, times: 1.0 };
        let cone = self.cone.get_or_insert_with(new);
        for (blunt, friction) in cone.blunt.iter_mut().zip(&self.friction) {
            *blunt = friction.min(most);
        }
    }

    /// The bounds for these pressures. The cohesion ends where a gap opens, as if the gap were a
    /// tension.
    pub(crate) fn follow(&mut self, pressure: &Field, gaps: &[f64], own: f64) {
        let Some(Cone { blunt, cohesion, .. }) = &self.cone else {
            let friction = self.friction.iter().zip(pressure.values());
            for (value, (friction, &pressure)) in self.values.iter_mut().zip(friction) {
                *value = if pressure > 0.0 { friction * pressure } else { 0.0 };
            }
            return;
        };
        for (i, (value, &pressure)) in self.values.iter_mut().zip(pressure.values()).enumerate() {
            let (blunt, cohesion) = (blunt[i], cohesion[i]);
            *value = if pressure > 0.0 {
                cohesion + blunt * pressure
            } else if cohesion > 0.0 {
                (cohesion - blunt * gaps[i].max(0.0) / own).max(0.0)
            } else {
                0.0
            };
        }
    }

    /// Raises the cohesion in proportion to the pressures if the prescribed loads use too great a part of the
    /// bounds, so that they hold a force; a torque may need more. Returns whether it raised it.
    pub(crate) fn hold(&mut self, pressure: &[f64], part: f64) -> bool {
        let Some(cone) = &mut self.cone else { return false };
        let missing = (RESERVE * part - 1.0) * self.values.iter().sum::<f64>();
        let all: f64 = pressure.iter().filter(|p| **p > 0.0).sum();
        if missing.is_nan() || missing <= 0.0 || all <= 0.0 {
            return false;
        }
        for (i, (value, pressure)) in self.values.iter_mut().zip(pressure).enumerate() {
            if *pressure > 0.0 {
                let raised = *value + missing / all * pressure;
                let raised = raised.min(self.friction[i] * pressure).max(*value);
                cone.cohesion[i] += raised - *value;
                *value = raised;
            }
        }
        true
    }

    /// Updates the cohesion towards the value that makes the bounds f p. Returns its error relative
    /// to the greatest traction.
    pub(crate) fn open(&mut self, state: &ContactState) -> f64 {
        let Some(cone) = &mut self.cone else { return 0.0 };
        let (x, y) = (state.traction_x.values(), state.traction_y.values());
        let (mut change, mut most) = (0.0_f64, 0.0_f64);
        let [mut same, mut now, mut then] = [0.0; 3];
        for (i, last) in cone.off.iter_mut().enumerate() {
            let (size, friction) = (x[i].hypot(y[i]), self.friction[i]);
            let part = if friction > 0.0 { cone.blunt[i] / friction } else { 1.0 };
            let off = (1.0 - part) * size - cone.cohesion[i];
            (change, most) = (change.max(off.abs()), most.max(size));
            (same, now, then) = (same + off * *last, now + off * off, then + *last * *last);
            *last = off;
        }
        // A steady change indicates that the cohesion is still far from its limit.
        let even = same > 0.9 * (now * then).sqrt();
        cone.times = if even { (1.5 * cone.times).min(LARGEST_EXTRAPOLATION) } else { 1.0 };
        for (cohesion, off) in cone.cohesion.iter_mut().zip(&cone.off) {
            *cohesion = (*cohesion + cone.times * off).max(0.0);
        }
        if most > 0.0 { change / most } else { change }
    }
}

#[cfg(test)]
mod tests {
    use carom_halfspace::Grid;

    use super::*;

    /// Bounds of a smaller coefficient rise in proportion to the pressures until they hold a load and a twentieth
    /// more, but never above friction.
    #[test]
    fn bounds_rise_in_proportion_to_the_pressures_up_to_friction() {
        let grid = Grid::new(3, 1, 1.0, 1.0).unwrap();
        let pressure = Field::new(grid, vec![1.0, 2.0, 4.0]).unwrap();
        let mut limits = FrictionLimits::new(3);
        limits.friction = vec![0.5, 0.5, 0.25];
        limits.blunt(0.1);
        limits.follow(&pressure, &[0.0; 3], 1.0);
        let near = |values: &[f64], expected: [f64; 3]| {
            let off = values.iter().zip(expected).map(|(value, expected)| (value - expected).abs());
            assert!(off.fold(0.0, f64::max) < 1e-15, "{values:?}");
        };
        near(&limits.values, [0.1, 0.2, 0.4]);
        assert!(!limits.hold(pressure.values(), 0.9));
        assert!(limits.hold(pressure.values(), 2.0));
        near(&limits.values, [0.21, 0.42, 0.84]);
        for _ in 0..2 {
            assert!(limits.hold(pressure.values(), 100.0));
            near(&limits.values, [0.5, 1.0, 1.0]);
        }
        // They stay there when the pressures are followed again.
        limits.follow(&pressure, &[0.0; 3], 1.0);
        near(&limits.values, [0.5, 1.0, 1.0]);
    }
}
