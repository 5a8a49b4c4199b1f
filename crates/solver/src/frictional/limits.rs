//! The greatest tangential tractions: Coulomb's cone, or a blunter one with cohesion on the way there.
//!
//! Where f gamma is large a small pressure makes a large limit, and pressures and tractions found in
//! turn do not settle. A smaller coefficient f' and a cohesion c, with `|t| <= c + f' p`, have the
//! solution of Coulomb's law for `c = (1 - f'/f) |t|`; to take the c of the last solution for the
//! next one is an implicit step towards it, which settles where tractions and pressures would
//! circle. With infinite friction f' stays finite.

use carom_halfspace::Field;

use crate::state::ContactState;

/// Most times the way to the next cohesion that is gone at once.
const FARTHEST: f64 = 30.0;

/// Limits hold this many times a given force, if friction does.
const HOLDS: f64 = 1.05;

/// The limits of a step, cell by cell.
#[derive(Clone)]
pub(crate) struct FrictionLimits {
    /// Coefficients of friction.
    pub(crate) friction: Vec<f64>,
    /// The limits.
    pub(crate) values: Vec<f64>,
    /// Instead of friction as it is.
    cone: Option<Cone>,
}

/// A blunter cone with cohesion.
#[derive(Clone)]
struct Cone {
    /// Coefficients in use.
    blunt: Vec<f64>,
    cohesion: Vec<f64>,
    /// How far cohesion was off in the last round, and how many times that it goes.
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

    /// Friction as it is.
    pub(crate) fn sharpen(&mut self) {
        self.cone = None;
    }

    /// Whether friction is as it is.
    pub(crate) const fn is_sharp(&self) -> bool {
        self.cone.is_none()
    }

    /// Friction no greater than this beside cohesion.
    pub(crate) fn blunt(&mut self, most: f64) {
        let zero = vec![0.0; self.friction.len()];
        let new = || Cone { blunt: zero.clone(), cohesion: zero.clone(), off: zero, times: 1.0 };
        let cone = self.cone.get_or_insert_with(new);
        for (blunt, friction) in cone.blunt.iter_mut().zip(&self.friction) {
            *blunt = friction.min(most);
        }
    }

    /// The limits under these pressures; cohesion ends where a gap opens, as if it were tension.
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

    /// Raises the limits of a blunter cone in proportion to the pressures where they would not hold a
    /// force.
    pub(crate) fn hold(&mut self, pressure: &[f64], force: f64) {
        if self.cone.is_none() {
            return;
        }
        let missing = HOLDS * force - self.values.iter().sum::<f64>();
        let all: f64 = pressure.iter().filter(|p| **p > 0.0).sum();
        if missing <= 0.0 || all <= 0.0 {
            return;
        }
        for ((value, pressure), friction) in
            self.values.iter_mut().zip(pressure).zip(&self.friction)
        {
            if *pressure > 0.0 {
                let raised = *value + missing / all * pressure;
                *value = raised.min(friction * pressure).max(*value);
            }
        }
    }

    /// Takes cohesion to what makes the limits f p; how far off it was, over the greatest traction.
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
        // What goes on evenly has a long way to go.
        let even = same > 0.9 * (now * then).sqrt();
        cone.times = if even { (1.5 * cone.times).min(FARTHEST) } else { 1.0 };
        for (cohesion, off) in cone.cohesion.iter_mut().zip(&cone.off) {
            *cohesion = (*cohesion + cone.times * off).max(0.0);
        }
        if most > 0.0 { change / most } else { change }
    }
}
