//! Coulomb's friction in two directions: rings in parallel, each with its own slip.
//!
//! The ring of radius r = sqrt(s) touches at the approach s. Its traction follows the shift with
//! stiffness C = diag(c_x, c_y) up to the limit f c_z (zeta - s); beyond, it slips along its
//! traction in the physical plane. `F_t = int t dr` over 0 < r < sqrt(zeta), `F_z` likewise.
//! In one direction this is Cattaneo and Mindlin's memory (chapter 6); where c_x = c_y and the
//! direction is constant it is the thesis's law of chapter 7.

use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, ContactLoad, Energies, ImpactLaw, Shift};
use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;
use nalgebra::Vector3;

use super::turning::{Pull, inverse_mean, onset, turned};

/// The vector law of Coulomb friction on rings at equal distances.
///
/// Between rings the traction is linear in r^2, with a bend where slip begins and a ring of its own
/// where the edge turned back, so that sliding is exact and |F_t| <= f F_z always; otherwise the
/// error falls with the square of the distance.
///
/// ```
/// use carom_impact::coupled::CoulombRings;
/// use carom_laws::law::{ContactLaw, Shift};
/// use carom_laws::stiffness::ContactStiffness;
/// let stiffness = ContactStiffness::new(0.9, 0.7, 1.1)?;
/// let mut law = CoulombRings::new(stiffness, 0.3, 0.05)?;
/// law.advance(Shift { zeta: 1.0, ..Shift::default() })?;
/// let load = law.advance(Shift { zeta: 1.0, xi: 9.0, ..Shift::default() })?;
/// assert!((load.f_x - 0.3 * load.f_z).abs() < 1e-14);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CoulombRings {
    stiffness: ContactStiffness,
    limit: f64,
    spacing: f64,
    shift: Shift,
    rings: Vec<Ring>,
    /// How many of them are at equal distances.
    regular: usize,
    touching: usize,
    slipping: usize,
    /// The outermost ring that did not slip.
    stuck: Option<usize>,
    core: Core,
    receding: bool,
    force: [f64; 2],
    dissipated: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Ring {
    depth: f64,
    radius: f64,
    /// Share in the integral over r, the outer half that of an even spacing.
    weight: f64,
    traction: [f64; 2],
}

/// The innermost rings, which adhere far from their limits: what they have in common is added to
/// all of them at once.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Core {
    rings: usize,
    /// What the traction of each has gained.
    gain: [f64; 2],
    /// What the limit leaves to the one nearest to it.
    room: f64,
    weight: f64,
    /// Integral of the tractions without the gain.
    sum: [f64; 2],
}

/// Steps as large as the last that a core is to last for.
const LASTING: f64 = 64.0;

/// The straight step all rings share.
#[derive(Debug, Clone, Copy)]
struct Step {
    from: f64,
    to: f64,
    /// C times the shift.
    pull: [f64; 2],
    shift: [f64; 2],
    stiffness: [f64; 2],
    limit: f64,
}

impl CoulombRings {
    /// A law at rest with rings at radii 0, spacing, 2 spacing, .. (lengths^(1/2): the radius of a
    /// ring is the square root of the approach at which it touches).
    ///
    /// # Errors
    /// [`RangeError`] unless friction and spacing are finite and positive.
    pub fn new(
        stiffness: ContactStiffness,
        friction: f64,
        spacing: f64,
    ) -> Result<Self, RangeError> {
        Friction::new(RangeError::positive("friction", friction)?)?;
        RangeError::positive("ring spacing", spacing)?;
        Ok(Self {
            stiffness,
            limit: friction * stiffness.c_z,
            spacing,
            shift: Shift::default(),
            rings: Vec::new(),
            regular: 0,
            touching: 0,
            slipping: 0,
            stuck: None,
            core: Core::default(),
            receding: false,
            force: [0.0; 2],
            dissipated: 0.0,
        })
    }

    /// How many rings touch.
    #[must_use]
    pub fn touching(&self) -> usize {
        self.touching
    }

    /// How many of them slipped in the last step.
    #[must_use]
    pub fn slipping(&self) -> usize {
        self.slipping
    }

    // Rings up to the approach; those not yet touched carry no traction.
    fn provide(&mut self, zeta: f64) {
        loop {
            let radius = self.spacing * self.regular as f64;
            if radius * radius >= zeta {
                break;
            }
            self.regular += 1;
            let ring = Ring { depth: radius * radius, radius, weight: 0.0, traction: [0.0; 2] };
            match self.rings.last() {
                Some(last) if last.radius >= radius => {
                    let at = self.rings.partition_point(|other| other.radius < radius);
                    self.insert(at, ring);
                }
                _ => self.insert(self.rings.len(), ring),
            }
        }
    }

    fn insert(&mut self, at: usize, ring: Ring) {
        if self.rings.get(at).is_some_and(|other| other.radius == ring.radius) {
            return;
        }
        self.rings.insert(at, ring);
        for i in at.saturating_sub(1)..(at + 2).min(self.rings.len()) {
            let radius = self.rings[i].radius;
            let inner = if i > 0 { span(self.rings[i - 1].radius, radius)[1] } else { 0.0 };
            let outer = self.rings.get(i + 1).map_or(0.0, |next| span(radius, next.radius)[0]);
            self.rings[i].weight = inner + outer;
        }
    }

    // Every ring on its own.
    fn dissolve(&mut self) {
        let [x, y] = self.core.gain;
        for ring in &mut self.rings[..self.core.rings] {
            ring.traction[0] += x;
            ring.traction[1] += y;
        }
        self.core = Core::default();
    }

    // The inner rings whose limits leave this room.
    fn condense(&mut self, zeta: f64, least: f64) {
        let mut core = Core { room: f64::INFINITY, ..Core::default() };
        // The outermost weighs by the edge.
        for ring in &self.rings[..self.touching.saturating_sub(1)] {
            let [x, y] = ring.traction;
            let bound = self.limit * (zeta - ring.depth);
            let room = (bound - (x * x + y * y).sqrt()) * (1.0 - 1e-12);
            if room.is_nan() || room <= least {
                break;
            }
            core.room = core.room.min(room);
            core.weight += ring.weight;
            core.sum[0] += ring.weight * x;
            core.sum[1] += ring.weight * y;
            core.rings += 1;
        }
        if core.rings > 0 {
            self.core = core;
        }
    }

    fn traction(&self, i: usize) -> [f64; 2] {
        let [x, y] = self.rings[i].traction;
        if i < self.core.rings { [x + self.core.gain[0], y + self.core.gain[1]] } else { [x, y] }
    }

    // The integral of the traction.
    fn pulled(&self, zeta: f64) -> [f64; 2] {
        let Core { rings, gain, weight, sum, .. } = self.core;
        let outer = self.total(zeta, rings, |traction| traction);
        [0, 1].map(|i| sum[i] + weight * gain[i] + outer[i])
    }

    // A ring at the edge where it turns back, and one where slip begins.
    fn mark(&mut self) {
        let zeta = self.shift.zeta;
        let edge = Ring { depth: zeta, radius: zeta.sqrt(), weight: 0.0, traction: [0.0; 2] };
        let bend = self.bend(zeta);
        let at = self.rings.partition_point(|ring| ring.depth < zeta);
        self.insert(at, edge);
        if let Some((inner, bend)) = bend {
            self.insert(inner + 1, bend);
        }
    }

    // Integral over r of what is linear in r^2 between rings and bend, zero at the edge, without the
    // first rings.
    fn total<const N: usize>(
        &self,
        zeta: f64,
        first: usize,
        of: impl Fn([f64; 2]) -> [f64; N],
    ) -> [f64; N] {
        let mut sum = [0.0; N];
        let Some(last) = self.touching.checked_sub(1) else { return sum };
        let mut add = |value: [f64; N], weight: f64| {
            for i in 0..N {
                sum[i] += weight * value[i];
            }
        };
        for i in first..last {
            add(of(self.traction(i)), self.rings[i].weight);
        }
        let radius = self.rings[last].radius;
        let inner = last.checked_sub(1).map_or(0.0, |i| span(self.rings[i].radius, radius)[1]);
        add(of(self.traction(last)), inner + span(radius, zeta.sqrt())[0]);
        // A bend between two places moves the value there from the line between them.
        if let Some((i, bend)) = self.bend(zeta) {
            let ring = &self.rings[i];
            let (outer, far) = if i < last {
                (self.rings[i + 1].radius, of(self.traction(i + 1)))
            } else {
                (zeta.sqrt(), [0.0; N])
            };
            let near = of(self.traction(i));
            let share = (bend.depth - ring.depth) / (outer * outer - ring.depth);
            let weight = span(ring.radius, bend.radius)[1] + span(bend.radius, outer)[0];
            add(of(bend.traction), weight);
            add(near, -weight * (1.0 - share));
            add(far, -weight * share);
        }
        sum
    }

    // Where the traction, continued from the rings that stick, meets the limit.
    fn bend(&self, zeta: f64) -> Option<(usize, Ring)> {
        let last = self.touching.checked_sub(1)?;
        let stuck = self.stuck?;
        if stuck == last && !self.receding {
            return None;
        }
        let (depth, [x, y]) = (self.rings[stuck].depth, self.traction(stuck));
        let (end, left) = if stuck == last {
            (zeta, 0.0)
        } else {
            let next = self.rings[stuck + 1].depth;
            (next, self.limit * (zeta - next))
        };
        let start = self.limit * (zeta - depth);
        let [p, q] = self.slope(stuck).map(|slope| slope * (end - depth));
        let growth = left - start;
        // |t + s g| = start + s growth, its first root.
        let room = start * start - x * x - y * y;
        let a = p * p + q * q - growth * growth;
        let b = x * p + y * q - start * growth;
        let meets = libm::hypot(x + p, y + q) > left;
        if room <= 1e-14 * start * start || !meets {
            return None;
        }
        let root = (b * b + a * room).max(0.0).sqrt();
        let s = if b >= 0.0 { room / (b + root) } else { (root - b) / a };
        let depth = depth + s.clamp(0.0, 1.0) * (end - depth);
        let traction = [x + s * p, y + s * q];
        Some((stuck, Ring { depth, radius: depth.sqrt(), weight: 0.0, traction }))
    }

    // The lesser of the last two slopes of the traction over depth.
    fn slope(&self, ring: usize) -> [f64; 2] {
        let between = |i: usize| {
            let depth = self.rings[i].depth - self.rings[i - 1].depth;
            let (near, far) = (self.traction(i - 1), self.traction(i));
            [0, 1].map(|k| (far[k] - near[k]) / depth)
        };
        match ring {
            0 => return [0.0; 2],
            1 => return between(1),
            _ => {}
        }
        let (last, before) = (between(ring), between(ring - 1));
        let square = |s: &[f64; 2]| s[0] * s[0] + s[1] * s[1];
        match (last[0] * before[0] + last[1] * before[1] > 0.0, square(&last) < square(&before)) {
            (false, _) => [0.0; 2],
            (true, true) => last,
            (true, false) => before,
        }
    }
}

// Integrals over r of what is linear in r^2 and one at the inner radius, zero at the outer, and the
// other way round.
fn span(inner: f64, outer: f64) -> [f64; 2] {
    let sum = outer + inner;
    if sum <= 0.0 {
        return [0.0; 2];
    }
    let unit = (outer - inner) / (3.0 * sum);
    [unit * (2.0 * outer + inner), unit * (outer + 2.0 * inner)]
}

impl ContactLaw for CoulombRings {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        shift.check_finite()?;
        let (from, to) = (self.shift.zeta.max(0.0), shift.zeta.max(0.0));
        if self.receding && to > from && from > 0.0 {
            self.dissolve();
            self.mark();
        }
        self.provide(to);
        let moved = [shift.xi - self.shift.xi, shift.eta - self.shift.eta];
        let stiffness = [self.stiffness.c_x, self.stiffness.c_y];
        let pull = [stiffness[0] * moved[0], stiffness[1] * moved[1]];
        // The part of a step in which the bodies are apart moves nothing: every ring begins with
        // its own touch.
        let step = Step {
            from: self.shift.zeta,
            to: shift.zeta,
            pull,
            shift: moved,
            stiffness,
            limit: self.limit,
        };
        let moves = libm::hypot(pull[0], pull[1]) + self.limit * (from - to).max(0.0);
        self.core.room -= moves;
        if self.core.room >= 0.0 {
            self.core.gain[0] += pull[0];
            self.core.gain[1] += pull[1];
        } else {
            self.dissolve();
        }
        let whole = self.core.rings == 0;
        let mut touching = self.core.rings;
        let mut stuck = touching.checked_sub(1);
        let (mut slipping, mut heat) = (0, 0.0);
        for (i, ring) in self.rings.iter_mut().enumerate().skip(touching) {
            if ring.depth >= from && ring.depth >= to {
                break;
            }
            if ring.depth >= to {
                ring.traction = [0.0; 2];
                continue;
            }
            touching += 1;
            if let Some(loss) = step.advance(ring) {
                slipping += 1;
                heat += ring.weight * loss;
            } else {
                stuck = Some(i);
            }
        }
        (self.touching, self.slipping, self.stuck) = (touching, slipping, stuck);
        if to != from {
            self.receding = to < from;
        }
        self.dissipated += heat;
        self.shift = shift;
        if self.core.rings == touching {
            // The outermost weighs by the edge.
            self.dissolve();
        }
        if whole {
            self.condense(to, LASTING * moves);
        }
        self.force = self.pulled(to);
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

impl Energies for CoulombRings {
    fn stored_energy(&self) -> f64 {
        let zeta = self.shift.zeta.max(0.0);
        let normal = 4.0 / 15.0 * self.stiffness.c_z * (zeta * zeta * zeta.sqrt());
        let ContactStiffness { c_x, c_y, .. } = self.stiffness;
        let [tangential] = self.total(zeta, 0, |[x, y]| [0.5 * (x * x / c_x + y * y / c_y)]);
        normal + tangential
    }

    /// By the mean traction of every step: accurate to the square of the step and the spacing.
    fn dissipated(&self) -> f64 {
        self.dissipated
    }
}

/// The direction of the traction on body 1 when the impact begins with sliding: the root of
/// `y' cos - x' sin + f z' sin cos (c_z/c_x - c_z/c_y) = 0` (8.58), corrected, with the velocity
/// (x', y', z') of body 2 against body 1 at touch. None if it begins with adhesion (8.50).
///
/// ```
/// use carom_impact::coupled::sliding_direction;
/// use carom_laws::stiffness::ContactStiffness;
/// use nalgebra::Vector3;
/// let stiffness = ContactStiffness::new(0.9, 0.7, 1.0)?;
/// let velocity = Vector3::new(0.8, 0.5, 1.0);
/// let [cos, sin] = sliding_direction(&stiffness, 0.3, &velocity).expect("slides");
/// let residue = 0.5 * cos - 0.8 * sin + 0.3 * sin * cos * (1.0 / 0.9 - 1.0 / 0.7);
/// assert!(residue.abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[must_use]
pub fn sliding_direction(
    stiffness: &ContactStiffness,
    friction: f64,
    velocity: &Vector3<f64>,
) -> Option<[f64; 2]> {
    let pull = [stiffness.c_x * velocity.x, stiffness.c_y * velocity.y];
    let limit = friction * stiffness.c_z;
    let bound = limit * velocity.z;
    if bound.is_nan() || bound <= 0.0 || libm::hypot(pull[0], pull[1]) <= bound {
        return None;
    }
    let step = Step {
        from: 0.0,
        to: velocity.z,
        pull,
        shift: [velocity.x, velocity.y],
        stiffness: [stiffness.c_x, stiffness.c_y],
        limit,
    };
    let [x, y] = step.touched_on_the_way(1.0, bound);
    Some([x / bound, y / bound])
}

impl Step {
    /// One ring through the step; the friction loss per weight if it slipped.
    fn advance(&self, ring: &mut Ring) -> Option<f64> {
        // A ring that touches on the way begins without traction.
        let share = if self.from < ring.depth {
            ring.traction = [0.0; 2];
            (self.to - ring.depth) / (self.to - self.from)
        } else {
            1.0
        };
        let bound = self.limit * (self.to - ring.depth);
        let [x, y] = ring.traction;
        let trial = [x + share * self.pull[0], y + share * self.pull[1]];
        if trial[0] * trial[0] + trial[1] * trial[1] <= bound * bound {
            ring.traction = trial;
            return None;
        }
        let before = ring.traction;
        if self.from <= ring.depth {
            ring.traction = self.touched_on_the_way(share, bound);
        } else {
            self.slip(ring, bound);
        }
        let [x, y] = ring.traction;
        let slip = [
            share * self.shift[0] - (x - before[0]) / self.stiffness[0],
            share * self.shift[1] - (y - before[1]) / self.stiffness[1],
        ];
        let mean = [0.5 * (x + before[0]), 0.5 * (y + before[1])];
        Some((mean[0] * slip[0] + mean[1] * slip[1]).max(0.0))
    }

    // From no traction on a straight path the direction is constant (8.58):
    // t = C (x - l e), t = L e, so that e ~ (C^-1 L + l)^-1 x.
    fn touched_on_the_way(&self, share: f64, bound: f64) -> [f64; 2] {
        let [c_x, c_y] = self.stiffness;
        let (x, y) = (share * self.shift[0], share * self.shift[1]);
        let mut slip = 0.0;
        // 1/|e| is concave and growing in l: Newton's iteration rises to the root.
        for _ in 0..40 {
            let (d_x, d_y) = (bound / c_x + slip, bound / c_y + slip);
            let (e_x, e_y) = (x / d_x, y / d_y);
            let square = e_x * e_x + e_y * e_y;
            let rate = e_x * e_x / d_x + e_y * e_y / d_y;
            let change = (square.sqrt() - 1.0) * square / rate;
            slip += change;
            if change.abs() <= 1e-15 * (slip + bound / c_x) {
                break;
            }
        }
        let (e_x, e_y) = (x / (bound / c_x + slip), y / (bound / c_y + slip));
        let norm = libm::hypot(e_x, e_y);
        [bound * e_x / norm, bound * e_y / norm]
    }

    // Adheres up to the limit, then turns along it.
    fn slip(&self, ring: &mut Ring, bound: f64) {
        let start = self.limit * (self.from - ring.depth);
        let growth = self.limit * (self.to - self.from);
        let onset = onset(ring.traction, self.pull, start, growth);
        let [x, y] = ring.traction;
        let at = [x + onset * self.pull[0], y + onset * self.pull[1]];
        let norm = (at[0] * at[0] + at[1] * at[1]).sqrt();
        let direction = if norm > 0.0 {
            [at[0] / norm, at[1] / norm]
        } else {
            let pull = libm::hypot(self.pull[0], self.pull[1]);
            [self.pull[0] / pull, self.pull[1] / pull]
        };
        let length = (1.0 - onset) * inverse_mean(start + onset * growth, bound);
        let pull = Pull { stiffness: self.stiffness, by: self.pull, growth };
        let turned = turned(direction, length, &pull, 1e-6);
        ring.traction = [bound * turned[0], bound * turned[1]];
    }
}

impl ImpactLaw for CoulombRings {
    fn rings(&self) -> Option<usize> {
        Some(self.touching())
    }
}
