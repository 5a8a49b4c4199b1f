//! Histories of twist and normal load of a circular contact: the stack of Lubkin's solutions.
//!
//! In the units of [`TwistHistory`] the state is a density b(s): the adhesive twists that the
//! discs of radius s carry. Twist, torque and traction are
//! `bh = int b ds`, `mu = int s^3 b ds`, `sigma ~ rho int_rho b/sqrt(s^2 - rho^2) ds`; a
//! contact that slides at the radius al has `b = (2/pi) E(k)/k'`, `k' = s/al`. A step finds the
//! stick radius c below which the density is kept, and puts the sliding one above it (10.25).

use std::f64::consts::{FRAC_2_PI, PI};
use std::sync::LazyLock;

use carom_special::elliptic::complete;
use carom_special::quadrature::GaussLegendre;
use carom_special::{AxisRatio, RangeError};

use super::lubkin::torque_of_stick;
use super::rings;

/// Beyond this rate of back-twist, relative to the receding edge, one outer ring of the new sign
/// is left and the stack alone is used again.
const RINGS_END: f64 = 2.5;

/// [`threshold`] stays below this.
const GREATEST_THRESHOLD: f64 = 1.103;

/// The part of the radius that a receding step leaves at least while old rings lie outside it.
const SHORTEST_STEP: f64 = 0.96;

static RULE: LazyLock<GaussLegendre> =
    LazyLock::new(|| GaussLegendre::new(16).unwrap_or_else(|_| unreachable!("16 is an order")));

/// The density on a range of radii.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Density {
    /// Laid down in adhesion, or found by rings: constant.
    Stick(f64),
    /// Laid down in sliding of this sign, when the contact radius was this.
    Slip { sign: f64, radius: f64 },
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Segment {
    from: f64,
    density: Density,
    /// Twist and torque of all that lies below `from`; on a slip segment with the sliding ones
    /// outside `from` added, from which those outside another radius are taken.
    twist: f64,
    torque: f64,
}

/// A circular contact under a history of contact radius and twist.
///
/// Units, with the effective radius R = 1/(2A) and combined moduli: radius `al = a/R`, twist
/// `bh = beta (1 - nu)/f`, torque `mu = 3 M_z (1 - nu)/(16 G f R^3)`; sliding is
/// `mu = (3 pi/32) al^4`.
///
/// Exact at constant load (Deresiewicz), in adhesive growth, when the contact recedes with the
/// twist going on or turning back slowly, and, as steps become small, in growth with slip. When it
/// recedes while the twist turns back somewhat faster than the edge, two slip rings form; such
/// steps are solved by rings and [`TwistHistory::ring_steps`] counts them.
///
/// ```
/// use carom_laws::torsion::history::TwistHistory;
/// let mut history = TwistHistory::new();
/// history.advance(1.0, 0.0)?; // press
/// history.advance(1.0, 0.6)?; // twist
/// assert!((history.torque() - 0.264_049_818_448_975_7).abs() < 1e-15);
/// history.advance(1.0, -0.6)?;
/// assert!((history.torque() + 0.264_049_818_448_975_7).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TwistHistory {
    radius: f64,
    twist: f64,
    torque: f64,
    stick: f64,
    segments: Vec<Segment>,
    ring_steps: u32,
}

impl TwistHistory {
    /// Two bodies that just touch, untwisted.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The contact radius al.
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// The twist bh.
    #[must_use]
    pub const fn twist(&self) -> f64 {
        self.twist
    }

    /// The torque mu.
    #[must_use]
    pub const fn torque(&self) -> f64 {
        self.torque
    }

    /// The radius of the stick area, in the units of al.
    #[must_use]
    pub const fn stick_radius(&self) -> f64 {
        self.stick
    }

    /// The tangent of the torque at constant load, `dmu/dbh = c^3` with c the stick radius.
    #[must_use]
    pub fn tangent(&self) -> f64 {
        self.stick * self.stick * self.stick
    }

    /// How many steps needed rings, because two slip rings lay apart.
    #[must_use]
    pub const fn ring_steps(&self) -> u32 {
        self.ring_steps
    }

    /// The density b at a radius; zero outside.
    #[must_use]
    pub fn density(&self, s: f64) -> f64 {
        match self.segments.iter().rev().find(|segment| segment.from <= s) {
            Some(segment) if s < self.radius => segment.density.at(s),
            _ => 0.0,
        }
    }

    /// The elastic energy, conjugate to mu and bh: `(3/2) int s^2 (bh - int_0^s b)^2 ds`.
    #[must_use]
    pub fn stored_energy(&self) -> f64 {
        let mut sum = 0.0;
        for (i, segment) in self.segments.iter().enumerate() {
            let to = self.segments.get(i + 1).map_or(self.radius, |next| next.from);
            sum += RULE.integrate(segment.from, to, |s| {
                let rest = self.twist - segment.twist_to(s);
                s * s * rest * rest
            });
        }
        1.5 * sum
    }

    /// Goes straight to a new contact radius and twist and returns the torque.
    ///
    /// A radius of zero separates the bodies and forgets their past.
    ///
    /// # Errors
    /// [`RangeError`] for a radius that is negative or a value that is not finite; the state is
    /// then unchanged.
    pub fn advance(&mut self, radius: f64, twist: f64) -> Result<f64, RangeError> {
        RangeError::non_negative("radius", radius)?;
        RangeError::finite("twist", twist)?;
        if radius == 0.0 {
            *self = Self { twist, ring_steps: self.ring_steps, ..Self::default() };
            return Ok(0.0);
        }
        // A long step back passes old rings one after the other.
        while radius < self.stick && radius < SHORTEST_STEP * self.radius {
            let part = (1.0 - SHORTEST_STEP) * self.radius / (self.radius - radius);
            let between = self.twist + part * (twist - self.twist);
            self.straight_to(SHORTEST_STEP * self.radius, between);
        }
        self.straight_to(radius, twist);
        Ok(self.torque)
    }

    fn straight_to(&mut self, radius: f64, twist: f64) {
        let (grown, turned) = (radius - self.radius, twist - self.twist);
        if grown > 0.0 && turned.abs() <= grown {
            self.adhere(radius, turned / grown);
        } else if grown != 0.0 || turned != 0.0 {
            let before = (grown < 0.0 && self.segments.len() > 2).then(|| self.clone());
            self.slip(radius, twist);
            if let Some(mut before) = before.filter(|_| !self.is_admissible(radius))
                && before.by_rings(radius, twist)
            {
                *self = before;
            }
        }
        (self.radius, self.twist) = (radius, twist);
    }

    /// New area laid down in complete adhesion.
    fn adhere(&mut self, radius: f64, density: f64) {
        let segment = Segment {
            from: self.radius,
            density: Density::Stick(density),
            twist: self.twist,
            torque: self.torque,
        };
        let same = self.segments.last().is_some_and(|last| last.density == segment.density);
        if !same {
            self.segments.push(segment);
        }
        self.torque = segment.torque_to(radius);
        self.stick = radius;
    }

    fn slip(&mut self, radius: f64, twist: f64) {
        let shared = radius.min(self.radius);
        let receding = self.radius - radius;
        if let (true, Some(sign)) = (receding > 0.0, self.slip_sign()) {
            let back = -sign * (twist - self.twist) / receding;
            let near = back > 1.0 && back < GREATEST_THRESHOLD;
            let limit = if near { threshold(self.stick / self.radius) } else { 1.0 };
            let highest = shared.min(self.stick);
            let excess =
                sign * (twist - self.twist_below(highest)) - sliding_twist(highest, radius);
            // A long step may lose the ring itself: then what lies below decides.
            if back <= limit && excess > 0.0 {
                self.cut(radius, twist, sign, highest);
                return;
            }
            if back > limit && back < RINGS_END && self.by_rings(radius, twist) {
                return;
            }
        }
        let rest = twist - self.twist_below(shared);
        if rest == 0.0 {
            self.truncate(shared);
            self.torque = self.segments.last().map_or(0.0, |last| last.torque_to(shared));
            self.stick = radius;
            return;
        }
        self.cut(radius, twist, 1.0_f64.copysign(rest), shared);
    }

    /// Whether torque and rim of a solution at the given radius stay within friction.
    fn is_admissible(&self, radius: f64) -> bool {
        let rim = self.segments.last().map_or(0.0, |last| last.density.at(radius));
        let sticks = self.stick >= radius;
        self.torque.abs() <= sliding_limit(radius) && !(sticks && rim.abs() > 1.0)
    }

    /// The sign of the outermost slip ring, if the contact slips there.
    fn slip_sign(&self) -> Option<f64> {
        match self.segments.last()?.density {
            Density::Slip { sign, radius } if radius == self.radius => Some(sign),
            _ => None,
        }
    }

    /// Solves for the stick radius not above `highest` and puts the sliding density outside it.
    fn cut(&mut self, radius: f64, twist: f64, sign: f64, highest: f64) {
        self.grow_to(radius);
        let top = if highest < self.radius.min(radius) { highest } else { radius };
        let mut i = self.segments.len();
        let mut upper = top;
        // From the outside in, the first segment at whose lower end sliding needs more twist.
        let (segment, stick) = loop {
            i -= 1;
            let segment = self.segments[i];
            if segment.from < upper {
                let excess = sign * (twist - segment.twist_to(segment.from))
                    - sliding_twist(segment.from, radius);
                if excess <= 0.0 || i == 0 {
                    break (segment, segment.stick_radius(radius, twist, sign, upper));
                }
                upper = segment.from;
            }
        };
        self.segments.truncate(i + 1);
        let torque = segment.torque_to(stick) + sign * sliding_torque(stick, radius);
        self.torque = torque;
        self.stick = stick;
        if stick < radius {
            let density = Density::Slip { sign, radius };
            if stick <= segment.from {
                self.segments.truncate(i);
            }
            self.segments.push(Segment { from: stick, density, twist, torque });
        }
    }

    /// Area that is new in this step carries nothing before it slips.
    fn grow_to(&mut self, radius: f64) {
        if radius > self.radius {
            self.segments.push(Segment {
                from: self.radius,
                density: Density::Stick(0.0),
                twist: self.twist,
                torque: self.torque,
            });
        }
    }

    /// Forgets what lies outside a radius.
    fn truncate(&mut self, radius: f64) {
        while self.segments.len() > 1
            && self.segments.last().is_some_and(|last| last.from >= radius)
        {
            self.segments.pop();
        }
    }

    fn twist_below(&self, s: f64) -> f64 {
        self.segments
            .iter()
            .rev()
            .find(|segment| segment.from <= s)
            .map_or(0.0, |segment| segment.twist_to(s))
    }

    /// Solves a receding step with rings of any pattern of slip. Whether it converged.
    fn by_rings(&mut self, radius: f64, twist: f64) -> bool {
        let before = |s: f64| self.twist_below(s);
        let twists = [self.twist, twist];
        let Some(solution) = rings::recede(self.radius, radius, twists, before) else {
            return false;
        };
        self.segments.clear();
        let (mut sum, mut torque) = (0.0, 0.0);
        for (from, to, density) in solution.cells {
            let density = Density::Stick(density);
            let segment = Segment { from, density, twist: sum, torque };
            (sum, torque) = (segment.twist_to(to), segment.torque_to(to));
            self.segments.push(segment);
        }
        self.torque = torque;
        self.stick = solution.stick_radius;
        self.ring_steps = self.ring_steps.saturating_add(1);
        true
    }
}

impl Density {
    fn at(self, s: f64) -> f64 {
        match self {
            Self::Stick(density) => density,
            Self::Slip { sign, radius } => {
                sign * FRAC_2_PI * with_ratio(s / radius, complete::e) * radius / s
            }
        }
    }
}

impl Segment {
    /// Twist of all that lies below a radius in this segment.
    fn twist_to(&self, s: f64) -> f64 {
        match self.density {
            Density::Stick(density) => self.twist + density * (s - self.from),
            Density::Slip { sign, radius } => self.twist - sign * sliding_twist(s, radius),
        }
    }

    /// Torque of all that lies below a radius in this segment.
    fn torque_to(&self, s: f64) -> f64 {
        match self.density {
            Density::Stick(density) => {
                let (a, b) = (s * s, self.from * self.from);
                self.torque + 0.25 * density * (a - b) * (a + b)
            }
            Density::Slip { sign, radius } => self.torque - sign * sliding_torque(s, radius),
        }
    }

    /// The root c of `sign (bh - twist_to(c)) = B(c; radius)` between `from` and `upper`, by
    /// Newton's method in ln c kept inside its bracket.
    fn stick_radius(&self, radius: f64, twist: f64, sign: f64, upper: f64) -> f64 {
        let excess = |c: f64| {
            let slope = FRAC_2_PI * radius * with_ratio(c / radius, complete::e);
            let value = sign * (twist - self.twist_to(c)) - sliding_twist(c, radius);
            (value, slope - sign * c * self.density.at(c))
        };
        if excess(upper).0 <= 0.0 {
            return upper;
        }
        let (mut low, mut high) = (self.from.max(upper * 1e-300), upper);
        let mut c = upper;
        for _ in 0..200 {
            let (value, slope) = excess(c);
            if value > 0.0 {
                high = c
            } else {
                low = c
            }
            let next = c * libm::exp(-value / slope);
            let inside = next > low && next < high;
            let next = if inside { next } else { low.max(upper * 1e-300).sqrt() * high.sqrt() };
            if (next - c).abs() <= 2e-16 * c || high <= low {
                return next.min(upper);
            }
            c = next;
        }
        c.min(upper)
    }
}

fn with_ratio(ratio: f64, integral: fn(AxisRatio) -> f64) -> f64 {
    // Ratios here lie in (0, 1] but for round-off.
    AxisRatio::new(ratio.clamp(f64::MIN_POSITIVE, 1.0)).map_or(0.0, integral)
}

/// `B(c; al) = (2/pi) al (K - E)` (5.39); infinite at the centre.
fn sliding_twist(c: f64, radius: f64) -> f64 {
    let ratio = c / radius;
    if ratio >= 1.0 {
        return 0.0;
    }
    if ratio <= 0.0 {
        return f64::INFINITY;
    }
    FRAC_2_PI * radius * (1.0 - ratio) * (1.0 + ratio) * with_ratio(ratio, complete::d)
}

/// `al^4 m(c/al)/2`, the torque of the sliding density outside c.
fn sliding_torque(c: f64, radius: f64) -> f64 {
    let ratio = c / radius;
    if ratio >= 1.0 {
        return 0.0;
    }
    0.5 * radius.powi(4) * torque_of_stick(ratio.max(0.0))
}

/// The greatest rate of back-twist, relative to the receding edge, at which the slip ring keeps
/// its sign: from 1 at the rim to 1.1023 at the centre. Found from no slip at the rim.
fn threshold(stick: f64) -> f64 {
    let weight = |x: f64| 1.0 - FRAC_2_PI * (libm::asin(x) - x * ((1.0 - x) * (1.0 + x)).sqrt());
    let w_stick = weight(stick);
    if w_stick <= 1e-12 {
        return 1.0;
    }
    let integral = RULE.integrate(stick, 1.0, |s| {
        // (E - s^2 K)/(1 - s^2) is the integral B.
        FRAC_2_PI * with_ratio(s, complete::b) / s * weight(s)
    });
    FRAC_2_PI * with_ratio(stick, complete::k) - integral / w_stick
}

/// The torque of complete sliding, `(3 pi/32) al^4`.
#[must_use]
pub fn sliding_limit(radius: f64) -> f64 {
    3.0 * PI / 32.0 * radius.powi(4)
}
