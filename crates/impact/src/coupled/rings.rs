//! Coulomb's friction in two directions: rings in parallel, each with its own slip.
//!
//! The ring of radius r = sqrt(s) touches at the approach s. Its traction follows the shift with
//! stiffness C = diag(c_x, c_y) up to the limit f c_z (zeta - s); beyond, it slips along its
//! traction in the physical plane. `F_t = int t dr` over 0 < r < sqrt(zeta), `F_z` likewise.
//! In one direction this is Cattaneo and Mindlin's memory (chapter 6); where c_x = c_y and the
//! direction is constant it is the thesis's law of chapter 7.

use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, ContactLoad, Energies, Shift};
use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;
use nalgebra::Vector3;

/// The vector law of Coulomb friction on rings at equal distances.
///
/// Between rings the traction is linear in r^2, so that sliding is exact and |F_t| <= f F_z
/// always; otherwise the error falls with the square of the distance.
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
    touching: usize,
    slipping: usize,
    force: [f64; 2],
    dissipated: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Ring {
    depth: f64,
    weight: f64,
    traction: [f64; 2],
}

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
            touching: 0,
            slipping: 0,
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
        let h = self.spacing;
        let mut j = self.rings.len() as f64;
        while (h * j) * (h * j) < zeta {
            let before = if j == 0.0 { 0.0 } else { (3.0 * j - 2.0) / (3.0 * (2.0 * j - 1.0)) };
            let after = (3.0 * j + 2.0) / (3.0 * (2.0 * j + 1.0));
            let weight = h * (before + after);
            self.rings.push(Ring { depth: (h * j) * (h * j), weight, traction: [0.0; 2] });
            j += 1.0;
        }
    }

    // Integral of a traction linear in r^2 between rings, zero at the edge of the contact.
    fn total(&self, zeta: f64) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for (j, ring) in self.rings[..self.touching].iter().enumerate() {
            let weight =
                if j + 1 == self.touching { self.last_weight(j, zeta) } else { ring.weight };
            sum[0] += weight * ring.traction[0];
            sum[1] += weight * ring.traction[1];
        }
        sum
    }

    fn last_weight(&self, j: usize, zeta: f64) -> f64 {
        let (h, k) = (self.spacing, j as f64);
        let before = if j == 0 { 0.0 } else { h * (3.0 * k - 2.0) / (3.0 * (2.0 * k - 1.0)) };
        let (inner, edge) = (h * k, zeta.sqrt());
        before + (edge - inner) * (2.0 * edge + inner) / (3.0 * (edge + inner))
    }
}

impl ContactLaw for CoulombRings {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        shift.check_finite()?;
        let (from, to) = (self.shift.zeta.max(0.0), shift.zeta.max(0.0));
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
        let (mut touching, mut slipping, mut heat) = (0, 0, 0.0);
        for ring in &mut self.rings {
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
            }
        }
        (self.touching, self.slipping) = (touching, slipping);
        self.dissipated += heat;
        self.shift = shift;
        self.force = self.total(to);
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
        let mut sum = 4.0 / 15.0 * self.stiffness.c_z * (zeta * zeta * zeta.sqrt());
        for (j, ring) in self.rings[..self.touching].iter().enumerate() {
            let weight =
                if j + 1 == self.touching { self.last_weight(j, zeta) } else { ring.weight };
            let [x, y] = ring.traction;
            sum += 0.5 * weight * (x * x / self.stiffness.c_x + y * y / self.stiffness.c_y);
        }
        sum
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
        let onset = self.onset(ring.traction, start, growth);
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
        let turned = self.turn(direction, length, growth);
        ring.traction = [bound * turned[0], bound * turned[1]];
    }

    // The part of the step after which |t + s pull| = start + s growth.
    fn onset(&self, [x, y]: [f64; 2], start: f64, growth: f64) -> f64 {
        let [p, q] = self.pull;
        let room = start * start - x * x - y * y;
        if room <= 1e-14 * start * start {
            return 0.0;
        }
        // a s^2 + 2 b s - room = 0, its first root; at the end a + 2 b > room.
        let a = p * p + q * q - growth * growth;
        let b = x * p + y * q - start * growth;
        let root = (b * b + a * room).max(0.0).sqrt();
        let s = if b >= 0.0 { room / (b + root) } else { (root - b) / a };
        s.clamp(0.0, 1.0)
    }

    // The traction turns towards the direction of steady sliding (8.58):
    // dtheta/dq = G(theta) = (c_x c_y e'.x + (c_y - c_x) e_x e_y L')/(e.C e), dq = ds/L, with
    // e' = (-e_y, e_x). Exponential steps of second order neither ring nor overshoot at the rim,
    // where L is small.
    fn turn(&self, mut e: [f64; 2], length: f64, growth: f64) -> [f64; 2] {
        const LARGEST: f64 = 0.15;
        const MAX_TURNS: usize = 200;
        let [c_x, c_y] = self.stiffness;
        let [x, y] = self.shift;
        let mut left = length;
        for _ in 0..MAX_TURNS {
            let [cos, sin] = e;
            let (product, skew) = (c_x * c_y, c_y - c_x);
            let along = c_x * cos * cos + c_y * sin * sin;
            let rate = (product * (cos * y - sin * x) + skew * cos * sin * growth) / along;
            let slope = (skew * (cos * cos - sin * sin) * growth
                - product * (cos * x + sin * y)
                - 2.0 * rate * skew * cos * sin)
                / along;
            let mut part = if slope * left > 1.0 { 1.0 / slope } else { left };
            let mut angle = rate * part * growth_mean(slope * part);
            if angle.abs() > LARGEST {
                part = part.min(LARGEST / rate.abs());
                angle = rate * part * growth_mean(slope * part);
            }
            e = rotated(e, angle.clamp(-2.0 * LARGEST, 2.0 * LARGEST));
            left -= part;
            if left <= 0.0 {
                break;
            }
        }
        e
    }
}

// Mean of 1/L for L linear from `low` to `high`.
fn inverse_mean(low: f64, high: f64) -> f64 {
    let (sum, difference) = (high + low, high - low);
    let u = difference / sum;
    if u.abs() > 0.1 {
        return libm::log(high / low) / difference;
    }
    let square = u * u;
    let series = 1.0 / 5.0 + square * (1.0 / 7.0 + square / 9.0);
    2.0 / sum * (1.0 + square * (1.0 / 3.0 + square * series))
}

// (exp(x) - 1)/x.
fn growth_mean(x: f64) -> f64 {
    if x.abs() > 0.05 {
        return libm::expm1(x) / x;
    }
    1.0 + x * (0.5 + x * (1.0 / 6.0 + x * (1.0 / 24.0 + x * (1.0 / 120.0 + x / 720.0))))
}

// By an angle of at most 0.3, through the tangent of its half.
fn rotated([cos, sin]: [f64; 2], angle: f64) -> [f64; 2] {
    let h = 0.5 * angle;
    let square = h * h;
    let t = h * (1.0 + square * (1.0 / 3.0 + square * (2.0 / 15.0 + square * 17.0 / 315.0)));
    let scale = 1.0 / (1.0 + t * t);
    let (c, s) = ((1.0 - t * t) * scale, 2.0 * t * scale);
    [c * cos - s * sin, s * cos + c * sin]
}
