//! Histories of twist and normal load of a circular contact: the stack of Lubkin's solutions.
//!
//! In the units of [`TwistHistory`] the state is a density b(s): the adhesive twists that the
//! discs of radius s carry. Twist, torque and traction are
//! `bh = int b ds`, `mu = int s^3 b ds`, `sigma ~ rho int_rho b/sqrt(s^2 - rho^2) ds`; a
//! contact that slides at the radius al has `b = (2/pi) E(k)/k'`, `k' = s/al`. A step finds the
//! stick radius c below which the density is kept, and puts the sliding one above it (10.25).

use std::sync::LazyLock;

use carom_special::RangeError;
use carom_special::quadrature::GaussLegendre;

use super::recede::InnerRing;
use super::rings;
use super::segment::{Density, Segment};
pub use super::sliding::sliding_limit;
use super::sliding::{sliding_torque, sliding_twist};
use crate::bounds::in_contact;

/// The part of the radius that a receding step leaves at least while old rings lie outside it.
const SHORTEST_STEP: f64 = 0.96;

static RULE: LazyLock<GaussLegendre> =
    LazyLock::new(|| GaussLegendre::new(16).unwrap_or_else(|_| unreachable!("16 is an order")));

/// A circular contact under a history of contact radius and twist.
///
/// Units, with the effective radius R = 1/(2A) and combined moduli: radius `al = a/R`, twist
/// `bh = beta (1 - nu)/f`, torque `mu = 3 M_z (1 - nu)/(16 G f R^3)`; sliding is
/// `mu = (3 pi/32) al^4`.
///
/// Exact at constant load (Deresiewicz), in adhesive growth, when the contact recedes with the
/// twist going on or turning back slowly, and, as steps become small, in growth with slip. When it
/// recedes while the twist turns back at 1 to `1/k'` times the speed of the edge (more exactly from
/// a threshold between 1 and 1.1023), two slip rings form. Such steps are solved by rings, within
/// 5e-4 of the sliding torque ([`TwistHistory::with_ring_width`]), and counted by
/// [`TwistHistory::ring_steps`]; from 4 times the speed on their effect is smaller, and the stack
/// is used. They take 0.03 to 0.3 ms, the smaller the stick area the longer; all others 0.5 us.
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
#[derive(Debug, Clone, PartialEq)]
pub struct TwistHistory {
    pub(super) radius: f64,
    pub(super) twist: f64,
    pub(super) torque: f64,
    pub(super) stick: f64,
    pub(super) segments: Vec<Segment>,
    pub(super) inner_ring: Option<InnerRing>,
    pub(super) ring_steps: u32,
    /// The level of the width of rings.
    pub(super) level: usize,
}

impl Default for TwistHistory {
    fn default() -> Self {
        Self::at_level(rings::USUAL_LEVEL)
    }
}

impl TwistHistory {
    /// Two bodies that just touch, untwisted.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// As [`TwistHistory::new`], with rings of a given width where two slip rings form: the
    /// greatest of 1/256, 1/128 and so on that is not above `width`, as a part of the radius.
    ///
    /// The usual width is 1/64. Against a converged solution the torque was then within 4.5e-4 of
    /// that of sliding, 9e-4 where the stick area is small; with 1/256 within 1.3e-4; the cost
    /// falls as the square of the width.
    ///
    /// # Errors
    /// [`RangeError`] for a width outside 1/256 to 1/4.
    pub fn with_ring_width(width: f64) -> Result<Self, RangeError> {
        let holds = (rings::FINEST..=0.25).contains(&width);
        RangeError::check("width", width, holds, "from 1/256 to 1/4")?;
        Ok(Self::at_level((width / rings::FINEST).log2() as usize))
    }

    const fn at_level(level: usize) -> Self {
        Self {
            radius: 0.0,
            twist: 0.0,
            torque: 0.0,
            stick: 0.0,
            segments: Vec::new(),
            inner_ring: None,
            ring_steps: 0,
            level,
        }
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
        match self.segment_at(s) {
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
    /// [`RangeError`] for a radius that is negative and a value above 1e60 in size or not a number;
    /// the state is then unchanged.
    pub fn advance(&mut self, radius: f64, twist: f64) -> Result<f64, RangeError> {
        RangeError::non_negative("radius", radius)?;
        in_contact("radius", radius)?;
        in_contact("twist", twist)?;
        if radius == 0.0 {
            *self = Self { twist, ring_steps: self.ring_steps, ..Self::at_level(self.level) };
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
                && before.by_rings(radius, twist, self.stick)
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
        self.inner_ring = None;
    }

    fn slip(&mut self, radius: f64, twist: f64) {
        let shared = radius.min(self.radius);
        if radius < self.radius && self.recede(radius, twist) {
            return;
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

    /// Solves for the stick radius not above `highest` and puts the sliding density outside it.
    pub(super) fn cut(&mut self, radius: f64, twist: f64, sign: f64, highest: f64) {
        self.inner_ring = None;
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
    pub(super) fn truncate(&mut self, radius: f64) {
        while self.segments.len() > 1
            && self.segments.last().is_some_and(|last| last.from >= radius)
        {
            self.segments.pop();
        }
    }

    pub(super) fn twist_below(&self, s: f64) -> f64 {
        self.segment_at(s).map_or(0.0, |segment| segment.twist_to(s))
    }

    pub(super) fn torque_below(&self, s: f64) -> f64 {
        self.segment_at(s).map_or(0.0, |segment| segment.torque_to(s))
    }

    fn segment_at(&self, s: f64) -> Option<&Segment> {
        self.segments.iter().rev().find(|segment| segment.from <= s)
    }
}
