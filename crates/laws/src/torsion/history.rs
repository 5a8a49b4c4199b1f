//! Histories of twist and normal load of a circular contact: the stack of Lubkin's solutions.
//!
//! In the units of [`TwistHistory`] the state is a density b(s): the adhesive twists that the
//! discs of radius s carry. Twist, torque and traction are
//! `bh = int b ds`, `mu = int s^3 b ds`, `sigma ~ rho int_rho b/sqrt(s^2 - rho^2) ds`; a
//! contact that slides at the radius al has `b = (2/pi) E(k)/k'`, `k' = s/al`. A step finds the
//! stick radius c below which the density is kept, and puts the sliding one above it (10.25).

use carom_special::RangeError;
use carom_special::quadrature::FixedRule;

use super::heat::{Heat, Unmetered};
pub use super::pack::packed_numbers;
use super::rings;
use super::segment::{Density, Segment};
pub use super::sliding::sliding_limit;
use super::sliding::{sliding_torque, sliding_twist};
use crate::bounds::in_contact;

/// The parts of the radius from which on a contact that separates is taken to release what it stores, where
/// rings are needed and where not: its work is below a fifth of their fifth power.
const LAST_TOUCH: [f64; 2] = [0.3, 1e-2];

/// A slip ring of less than this part of the radius is left out: the twist that it would carry stays at the
/// rim. The torque is then off by the square of it.
const THIN: f64 = 1e-9;

/// Panels of the stored energy by their ratio of radii, and how many matter.
const PANEL: f64 = 0.4;
const PANELS: usize = 14;

static RULE: FixedRule<16> = FixedRule::fixed();

/// A way on which the pattern of slip is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Way {
    /// Growth in complete adhesion.
    Adhere,
    /// One slip ring from the rim inwards, over what lay there.
    FromRim,
    /// The slip ring, of this sign, goes on inwards.
    Inward(f64),
    /// Growth with a slip ring of this sign whose inner edge moves out at a constant depth
    /// `ln(al/c)`.
    Outward { sign: f64, depth: f64 },
}

/// A circular contact under a history of contact radius and twist.
///
/// Units, with the effective radius R = 1/(2A) and combined moduli: radius `al = a/R`, twist
/// `bh = beta (1 - nu)/f`, torque `mu = 3 M_z (1 - nu)/(16 G f R^3)`; sliding is
/// `mu = (3 pi/32) al^4`.
///
/// Exact in any steps at constant load (Deresiewicz), in growth with adhesion and with slip, and
/// when the contact recedes with the twist going on or turning back slowly. Where two slip rings
/// may lie apart (after receding while the twist turns back at 1 to `1/k'` times the speed of the
/// edge, more exactly from a threshold between 1 and 1.1023, or over older slip) the stack's
/// solution is held against the friction law on rings, and where that fails the rings are solved
/// ([`TwistHistory::with_ring_width`], [`TwistHistory::ring_steps`]): of 200 random paths, one step
/// and a hundred were within 4e-4 of the sliding torque of each other; of 300 just above the
/// threshold, where the outer ring is thin, one and a thousand within 1e-3. Such a step takes some 0.2 ms for
/// each fortieth of the radius; all others 0.5 us.
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
    pub(super) ring_steps: u32,
    /// The level of the width of rings at the rim.
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

    /// As [`TwistHistory::new`], with rings of a given width where two slip rings may form: near
    /// the rim, the greatest of 1/256, 1/128 and so on that is not above `width`, as a part of the
    /// radius; at the rim itself they are four times narrower, further in wider.
    ///
    /// The usual width is 1/128. Against an independent solver the torque was then within 5e-4 of
    /// that of sliding, with 1/64 within 1e-3; the cost falls as the square of the width.
    ///
    /// # Errors
    /// [`RangeError`] for a width outside 1/256 to 1/4.
    pub fn with_ring_width(width: f64) -> Result<Self, RangeError> {
        let holds = (rings::NARROWEST..=0.25).contains(&width);
        RangeError::check("width", width, holds, "from 1/256 to 1/4")?;
        Ok(Self::at_level((width / rings::NARROWEST).log2() as usize))
    }

    const fn at_level(level: usize) -> Self {
        Self {
            radius: 0.0,
            twist: 0.0,
            torque: 0.0,
            stick: 0.0,
            segments: Vec::new(),
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
            let mut to = self.segments.get(i + 1).map_or(self.radius, |next| next.from);
            // The twist of a slip segment grows as the logarithm towards the centre.
            for panel in 0..PANELS {
                let last = panel + 1 == PANELS || matches!(segment.density, Density::Stick(_));
                let from = if last { segment.from } else { segment.from.max(PANEL * to) };
                sum += RULE.integrate(from, to, |s| {
                    let rest = self.twist - segment.twist_to(s);
                    s * s * rest * rest
                });
                to = from;
                if from <= segment.from {
                    break;
                }
            }
        }
        1.5 * sum
    }

    /// The energy that the straight step to a new radius and twist would turn into heat, conjugate
    /// to mu and bh: the work of the torque on that way without what is then stored. Nothing moves.
    ///
    /// It is an integral over the way that [`TwistHistory::advance`] goes, exactly 0 where nothing slips
    /// and never negative. Its error is below 1e-9 of the torque of sliding times the step,
    /// `(3 pi/32) max(al)^4 (|dal| + |dbh|)`, and the rounding of the twist. Where rings are needed or slip
    /// rings may lie apart it is as good as their solution: of 240 steps of random paths one was off by
    /// 0.04 of the torque of sliding times the greater of radius and step; work and heat of whole paths
    /// in small steps agree to 1e-3. A radius of zero separates the bodies: what they store becomes heat.
    ///
    /// Arguments that [`TwistHistory::advance`] refuses give zero.
    #[must_use]
    pub fn dissipation(&self, radius: f64, twist: f64) -> f64 {
        self.clone().advance_with_heat(radius, twist).unwrap_or(0.0)
    }

    /// Goes to a new radius and twist, as [`TwistHistory::advance`], and returns the heat.
    ///
    /// # Errors
    /// As [`TwistHistory::advance`].
    pub(super) fn advance_with_heat(&mut self, radius: f64, twist: f64) -> Result<f64, RangeError> {
        check(radius, twist)?;
        let mut heat = Heat::default();
        if radius > 0.0 {
            self.travel(radius, twist, &mut heat)?;
            return Ok(heat.0);
        }
        let turned = twist - self.twist;
        if self.radius > 0.0 && turned != 0.0 {
            let mut last = self.clone();
            for part in LAST_TOUCH {
                let twist = self.twist + (1.0 - part) * turned;
                last.travel(part * self.radius, twist, &mut heat)?;
                if last.ring_steps != self.ring_steps {
                    break;
                }
            }
            // The torque of sliding falls as the fourth power.
            let work = 0.2 * last.torque * (twist - last.twist);
            heat.0 += (last.stored_energy() + work).max(0.0);
        } else {
            heat.0 = self.stored_energy();
        }
        self.separate(twist);
        Ok(heat.0)
    }

    /// Goes straight to a new contact radius and twist and returns the torque.
    ///
    /// A radius of zero separates the bodies and forgets their past.
    ///
    /// # Errors
    /// [`RangeError`] for a radius that is negative and a value above 1e60 in size or not a number,
    /// and should rings of slip not settle, of which no case is known; the state is then unchanged.
    pub fn advance(&mut self, radius: f64, twist: f64) -> Result<f64, RangeError> {
        check(radius, twist)?;
        if radius == 0.0 {
            self.separate(twist);
            return Ok(0.0);
        }
        self.travel(radius, twist, &mut Unmetered)?;
        Ok(self.torque)
    }

    /// Forgets the past of the contact.
    pub(super) fn separate(&mut self, twist: f64) {
        *self = Self { twist, ring_steps: self.ring_steps, ..Self::at_level(self.level) };
    }

    /// One piece of a step of which the pattern of slip is known.
    pub(super) fn follow(&mut self, way: Way, radius: f64, twist: f64) {
        match way {
            Way::Adhere => self.adhere(radius, twist),
            Way::FromRim => self.slip_from_rim(radius, twist),
            Way::Inward(sign) => self.cut(radius, twist, sign, radius.min(self.stick)),
            Way::Outward { sign, depth } => self.lay_out(radius, twist, sign, depth),
        }
        (self.radius, self.twist) = (radius, twist);
    }

    fn slip_from_rim(&mut self, radius: f64, twist: f64) {
        let shared = radius.min(self.radius);
        let rest = twist - self.twist_below(shared);
        if rest != 0.0 {
            return self.cut(radius, twist, 1.0_f64.copysign(rest), shared);
        }
        self.truncate(shared);
        self.torque = self.segments.last().map_or(0.0, |last| last.torque_to(shared));
        self.stick = radius;
    }

    /// Solves for the stick radius not above `highest` and puts the sliding density outside it.
    pub(super) fn cut(&mut self, radius: f64, twist: f64, sign: f64, highest: f64) {
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
        if stick > (1.0 - THIN) * radius {
            let rest = twist - segment.twist_to(radius);
            self.set_torque(segment.torque_to(radius) + radius * radius * radius * rest, radius);
            self.stick = radius;
            return;
        }
        let torque = segment.torque_to(stick) + sign * sliding_torque(stick, radius);
        self.set_torque(torque, radius);
        self.stick = stick;
        if stick <= segment.from {
            self.segments.truncate(i);
        }
        let density = Density::Slip { sign, radius };
        self.push(Segment { from: stick, density, twist, torque, demand: radius });
    }

    /// The torque; rounding and the width of rings do not lift it above that of sliding.
    pub(super) fn set_torque(&mut self, torque: f64, radius: f64) {
        let limit = sliding_limit(radius);
        self.torque = torque.clamp(-limit, limit);
    }

    /// Puts a segment on the stack.
    pub(super) fn push(&mut self, mut segment: Segment) {
        segment.demand = segment.demand.max(self.demand());
        self.segments.push(segment);
    }

    /// The contact radius from which on all densities are within that of sliding.
    pub(super) fn demand(&self) -> f64 {
        self.segments.last().map_or(0.0, |last| last.demand)
    }

    /// The sign of the outermost slip ring, if the contact slips there.
    pub(super) fn slip_sign(&self) -> Option<f64> {
        match self.segments.last()?.density {
            Density::Slip { sign, radius } if radius == self.radius => Some(sign),
            _ => None,
        }
    }

    /// Area that is new in this step carries nothing before it slips.
    fn grow_to(&mut self, radius: f64) {
        if radius > self.radius {
            self.push(Segment {
                from: self.radius,
                density: Density::Stick(0.0),
                twist: self.twist,
                torque: self.torque,
                demand: 0.0,
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

    /// The twist of all discs up to a radius, which may lie outside the contact.
    pub(super) fn twist_up_to(&self, s: f64) -> f64 {
        if s >= self.radius { self.twist } else { self.twist_below(s) }
    }

    fn segment_at(&self, s: f64) -> Option<&Segment> {
        self.segments.iter().rev().find(|segment| segment.from <= s)
    }
}

/// Whether a step may go there.
fn check(radius: f64, twist: f64) -> Result<(), RangeError> {
    RangeError::non_negative("radius", radius)?;
    in_contact("radius", radius)?;
    in_contact("twist", twist)?;
    Ok(())
}
