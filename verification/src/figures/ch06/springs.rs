//! A bed of independent springs with friction, which solves the same problem without a stored history of
//! reversals.
//!
//! The spring at depth s touches when the approach exceeds s. Friction limits its deflection to `zeta - s`;
//! beyond that it slides. With the density `(3/4) s^(-1/2)` the bed carries the normal force `zeta^(3/2)` and
//! has the stiffness of a Hertz contact. It follows any path by small steps, without stick areas and points
//! of instantaneous adhesion.

const SPRINGS: usize = 2000;
const STEPS: usize = 1000;

/// Approach and shift, in units of f kappa zeta_1.
pub(super) type Place = (f64, f64);

pub(super) struct Springs {
    depths: Vec<f64>,
    anchors: Vec<f64>,
    spacing: f64,
    place: Place,
    heat: f64,
}

impl Springs {
    /// A bed for approaches up to `deepest`.
    pub(super) fn new(deepest: f64) -> Self {
        let spacing = deepest.sqrt() / SPRINGS as f64;
        let depth = |i: usize| {
            let root = (i as f64 + 0.5) * spacing;
            root * root
        };
        Self {
            depths: (0..SPRINGS).map(depth).collect(),
            anchors: vec![0.0; SPRINGS],
            spacing,
            place: (0.0, 0.0),
            heat: 0.0,
        }
    }

    /// Moves straight to a new approach and shift, and returns the tangential force.
    pub(super) fn advance(&mut self, (zeta, shift): Place) -> f64 {
        let (from_zeta, from_shift) = self.place;
        for step in 1..=STEPS {
            let part = step as f64 / STEPS as f64;
            let here =
                (from_zeta + part * (zeta - from_zeta), from_shift + part * (shift - from_shift));
            self.relax(here);
        }
        self.place = (zeta, shift);
        self.force()
    }

    fn relax(&mut self, (zeta, shift): Place) {
        let mut slid = 0.0;
        for (&depth, anchor) in self.depths.iter().zip(&mut self.anchors) {
            let reach = (zeta - depth).max(0.0);
            let before = *anchor;
            *anchor = anchor.clamp(shift - reach, shift + reach);
            slid += reach * (*anchor - before).abs();
        }
        self.heat += 1.5 * self.spacing * slid;
        self.place = (zeta, shift);
    }

    /// `int (3/4) u s^(-1/2) ds`, by the midpoint rule in sqrt(s).
    fn force(&self) -> f64 {
        let (zeta, shift) = self.place;
        let touching = self.depths.iter().zip(&self.anchors).filter(|(depth, _)| **depth < zeta);
        1.5 * self.spacing * touching.map(|(_, anchor)| shift - anchor).sum::<f64>()
    }

    /// `int (3/8) u^2 s^(-1/2) ds`, the energy stored by the springs.
    pub(super) fn energy(&self) -> f64 {
        let (zeta, shift) = self.place;
        let touching = self.depths.iter().zip(&self.anchors).filter(|(depth, _)| **depth < zeta);
        let squares = touching.map(|(_, anchor)| (shift - anchor) * (shift - anchor));
        0.75 * self.spacing * squares.sum::<f64>()
    }

    /// Friction times slip of every spring, summed over all steps.
    pub(super) const fn heat(&self) -> f64 {
        self.heat
    }
}
