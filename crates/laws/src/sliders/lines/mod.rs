//! Coulomb friction in two directions: a line of anchors that slips annulus by annulus.
//!
//! The annulus that came into contact at the approach s carries the traction f c_z (X - W(s)), with
//! the shift `X = C x/(f c_z)` and its anchor W(s), the shift of zero traction. It satisfies `|X -
//! W(s)| <= zeta - s`; an annulus at this limit slips in the direction of its traction in the
//! physical plane. Between vertices W is linear in s. Vertices are the edge after every step, so
//! that adhesion on a straight path is exact, the depths at which slip begins, and those between
//! which tractions rotate. A vertex is kept only if leaving it out would change the force; a slip
//! annulus may therefore be thinner than any fixed spacing of annuli.

mod drag;
mod vertex;
mod watch;

use carom_special::RangeError;

use self::drag::Drag;
use self::vertex::{Resolution, Vertex, length};
use self::watch::Watch;
use super::ring::SlipStep;
use crate::friction::Friction;
use crate::law::{ContactLaw, ContactLoad, ImpactLaw, Shift};
use crate::memory::MemoryRegime as Regime;
use crate::stiffness::ContactStiffness;

/// Directions of tractions are computed at least to this angle, radians.
const FINEST: f64 = 1e-6;

/// Coulomb's law on a piecewise linear line of anchors, for contacts with equal or different
/// stiffness along x and y.
///
/// ```
/// use carom_laws::sliders::SlipLines;
/// use carom_laws::law::{ContactLaw, Shift};
/// use carom_laws::stiffness::ContactStiffness;
/// let stiffness = ContactStiffness::new(0.9, 0.7, 1.1)?;
/// let mut law = SlipLines::new(stiffness, 0.3, 1e-6)?;
/// law.advance(Shift { zeta: 1.0, ..Shift::default() })?;
/// let load = law.advance(Shift { zeta: 1.0, xi: 9.0, ..Shift::default() })?;
/// assert!((load.f_x - 0.3 * load.f_z).abs() < 1e-14);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone)]
pub struct SlipLines {
    stiffness: ContactStiffness,
    /// f c_z.
    limit: f64,
    /// Error allowed by leaving out annuli, relative to the greatest force.
    tolerance: f64,
    resolution: Resolution,
    shift: Shift,
    /// X and the anchors are measured from an origin that moves along in gross sliding.
    at: [f64; 2],
    vertices: Vec<Vertex>,
    watch: Watch,
    /// The integral of the anchors over the radius.
    integral: [f64; 2],
    /// The accumulated decrease of the distance of all annuli from their limits, since first
    /// contact.
    approached: f64,
    regime: Regime,
    force: [f64; 2],
    /// Annuli that a step drags, their replacement, and the number dragged.
    slipping: Vec<usize>,
    fresh: Vec<Vertex>,
    moved: usize,
}

impl SlipLines {
    /// A law in its initial state, for friction that is neither zero nor infinite. An annulus is
    /// left out of the line if that changes the force by at most `tolerance` times the greatest
    /// force since first contact.
    ///
    /// # Errors
    /// [`RangeError`] unless friction and tolerance are finite and positive.
    pub fn new(
        stiffness: ContactStiffness,
        friction: f64,
        tolerance: f64,
    ) -> Result<Self, RangeError> {
        Friction::new(RangeError::positive("friction", friction)?)?;
        RangeError::positive("tolerance", tolerance)?;
        Ok(Self {
            stiffness,
            limit: friction * stiffness.c_z,
            tolerance,
            resolution: Resolution { area: 0.0 },
            shift: Shift::default(),
            at: [0.0; 2],
            vertices: Vec::new(),
            watch: Watch::default(),
            integral: [0.0; 2],
            approached: 0.0,
            regime: Regime::Separated,
            force: [0.0; 2],
            slipping: Vec::new(),
            fresh: Vec::new(),
            moved: 0,
        })
    }

    /// A law of the same contact in its initial state, with the tolerance divided by `times`.
    #[must_use]
    pub fn refined(&self, times: usize) -> Self {
        let mut law = self.clone();
        law.separate();
        law.shift = Shift::default();
        law.resolution.area = 0.0;
        law.tolerance /= times as f64;
        law
    }

    /// The contact state after the last step; an overlay is not distinguished from slip.
    #[must_use]
    pub const fn regime(&self) -> Regime {
        self.regime
    }

    fn separate(&mut self) {
        self.vertices.clear();
        self.watch.clear();
        self.regime = Regime::Separated;
        self.force = [0.0; 2];
    }

    // The first annulus, at the shift of first contact.
    fn touch(&mut self) {
        self.at = [0.0; 2];
        self.approached = 0.0;
        self.integral = [0.0; 2];
        self.push(Vertex::new(0.0, [0.0; 2]), 0.0);
    }

    fn add(&mut self, part: [f64; 2], sign: f64) {
        self.integral[0] += sign * part[0];
        self.integral[1] += sign * part[1];
    }

    fn push(&mut self, vertex: Vertex, safe: f64) {
        if let Some(last) = self.vertices.last() {
            self.add(last.integral(&vertex), 1.0);
        }
        self.vertices.push(vertex);
        self.watch.push(safe);
    }

    fn pop(&mut self) -> Option<Vertex> {
        let last = self.vertices.pop()?;
        self.watch.pop();
        if let Some(below) = self.vertices.last() {
            self.add(below.integral(&last), -1.0);
        }
        Some(last)
    }

    // The edge of a receding contact.
    fn recede(&mut self, zeta: f64) {
        let mut outer = None;
        while self.vertices.last().is_some_and(|last| last.depth >= zeta) {
            outer = self.pop();
        }
        if let (Some(inner), Some(outer)) = (self.vertices.last(), outer) {
            let edge = inner.between(&outer, zeta);
            self.push(edge, f64::NEG_INFINITY);
        }
    }

    // The edge of a growing contact.
    fn grow(&mut self, edge: Vertex) {
        if let [.., a, b] = &self.vertices[..]
            && self.resolution.spares(a, b, &edge)
        {
            self.pop();
        }
        self.push(edge, self.approached);
    }

    // Annuli beyond their limits slip.
    fn slip(&mut self, step: &SlipStep, to: [f64; 2]) {
        let (vertices, zeta) = (&self.vertices, step.to);
        let excess = |i: usize| {
            let vertex: &Vertex = &vertices[i];
            length(vertex.stretch(to)) - (zeta - vertex.depth)
        };
        let sticks = self.watch.find(self.approached, excess, &mut self.slipping);
        self.regime = match (self.slipping.is_empty(), sticks) {
            (true, _) => Regime::Adhesion,
            (false, true) => Regime::Slip,
            (false, false) => Regime::Sliding,
        };
        let slipping = std::mem::take(&mut self.slipping);
        // From the edge inwards, run by run.
        let mut rest = &slipping[..];
        while let Some(&last) = rest.first() {
            let run = rest.iter().enumerate().take_while(|(k, i)| **i + k == last).count();
            self.drag(last + 1 - run..last + 1, step, to);
            rest = &rest[run..];
        }
        self.slipping = slipping;
    }

    fn drag(&mut self, run: std::ops::Range<usize>, step: &SlipStep, to: [f64; 2]) {
        let mut fresh = std::mem::take(&mut self.fresh);
        let drag = Drag { step, from: self.at, to, resolution: self.resolution };
        self.moved += drag.lay(&self.vertices, run.clone(), &mut fresh);
        self.replace(run, &fresh);
        self.fresh = fresh;
    }

    fn replace(&mut self, run: std::ops::Range<usize>, fresh: &[Vertex]) {
        let around = |vertices: &[Vertex], run: &std::ops::Range<usize>| {
            let (first, last) = (run.start.saturating_sub(1), (run.end + 1).min(vertices.len()));
            vertices[first..last].windows(2).fold([0.0; 2], |sum, pair| {
                let [x, y] = pair[0].integral(&pair[1]);
                [sum[0] + x, sum[1] + y]
            })
        };
        let before = around(&self.vertices, &run);
        let now = run.start..run.start + fresh.len();
        if fresh.len() == run.len() {
            self.vertices[run.clone()].copy_from_slice(fresh);
        } else {
            self.vertices.splice(run.clone(), fresh.iter().copied());
        }
        self.watch.replace(run, fresh.len(), self.approached);
        let after = around(&self.vertices, &now);
        self.add(after, 1.0);
        self.add(before, -1.0);
    }

    // Anchors are measured from the present shift: long sliding loses no digits.
    fn move_origin(&mut self) {
        let by = std::mem::take(&mut self.at);
        for vertex in &mut self.vertices {
            vertex.anchor = [vertex.anchor[0] - by[0], vertex.anchor[1] - by[1]];
        }
        let pairs = self.vertices.windows(2);
        self.integral = pairs.fold([0.0; 2], |sum, pair| {
            let [x, y] = pair[0].integral(&pair[1]);
            [sum[0] + x, sum[1] + y]
        });
    }

    fn go(&mut self, from: f64, to: f64, by: [f64; 2]) {
        if self.vertices.is_empty() {
            self.touch();
        }
        self.moved = 0;
        let growth = to - from;
        let moves = length(by);
        let at = [self.at[0] + by[0], self.at[1] + by[1]];
        self.approached += moves - growth;
        if growth < 0.0 {
            self.recede(to);
        }
        if moves <= growth {
            self.regime = Regime::Adhesion;
        } else {
            let ContactStiffness { c_x, c_y, .. } = self.stiffness;
            // An annulus with the limit L is about L/(2 sqrt(zeta)) wide.
            let accuracy = 2.0 * to.sqrt() * self.resolution.area;
            self.slip(
                &SlipStep { from, to, by, stiffness: [c_x, c_y], accuracy, finest: FINEST },
                at,
            );
        }
        if growth > 0.0 {
            self.grow(Vertex::new(to, at));
        }
        self.at = at;
        if self.regime == Regime::Sliding {
            self.move_origin();
        }
        let root = to.sqrt();
        let force = [0, 1].map(|k| self.at[k] * root - self.integral[k]);
        self.resolution.area = self.resolution.area.max(self.tolerance * length(force));
        // |F| <= f F_z to the last digit.
        let bound = 2.0 / 3.0 * to * root;
        let held = (bound / length(force)).min(1.0);
        self.force = force.map(|force| self.limit * held * force);
    }
}

impl ContactLaw for SlipLines {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        shift.check_finite()?;
        let (from, to) = (self.shift.zeta, shift.zeta);
        if to <= 0.0 {
            self.separate();
        } else {
            let part = if from < 0.0 { to / (to - from) } else { 1.0 };
            let by = [
                part * self.stiffness.c_x / self.limit * (shift.xi - self.shift.xi),
                part * self.stiffness.c_y / self.limit * (shift.eta - self.shift.eta),
            ];
            self.go(from.max(0.0), to, by);
        }
        self.shift = shift;
        Ok(self.load())
    }

    fn shift(&self) -> Shift {
        self.shift
    }

    fn load(&self) -> ContactLoad {
        let zeta = self.shift.zeta.max(0.0);
        let f_z = 2.0 / 3.0 * self.stiffness.c_z * (zeta * zeta.sqrt());
        ContactLoad { f_x: self.force[0], f_y: self.force[1], f_z, m_z: 0.0 }
    }
}

impl ImpactLaw for SlipLines {
    // Those that the last step moved, as a measure of its work.
    fn rings(&self) -> Option<usize> {
        Some(self.moved)
    }
}
