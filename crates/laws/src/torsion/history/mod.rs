//! Load histories of twist and normal load of a circular contact: a stack of Lubkin's solutions.
//!
//! In the units of [`TwistHistory`] the state is a density b(s): the adhesive twists of discs of
//! radius s. Twist, torque and traction are `bh = int b ds`, `mu = int s^3 b ds`, `sigma ~ rho
//! int_rho b/sqrt(s^2 - rho^2) ds`. A contact that slides at the radius al has `b = (2/pi)
//! E(k)/k'`, `k' = s/al`. A step finds the stick radius c; inside it the density is kept, outside
//! it the sliding density replaces it (10.25).

mod pack;
mod pieces;
mod stored;

pub use pack::packed_numbers;
pub(in crate::torsion) use pieces::Pieces;
pub(in crate::torsion) use stored::StoredHistory;

use carom_special::RangeError;
use carom_special::quadrature::FixedRule;

use crate::torsion::mesh;
use crate::torsion::segment::{Density, Segment};
pub use crate::torsion::sliding::sliding_limit;
use crate::torsion::sliding::{sliding_torque, sliding_twist};
use crate::torsion::steady::SteadyAnnulus;

/// A slip annulus narrower than this fraction of the radius is left out, and its twist stays at the
/// edge. The relative error of the torque is the square of this.
const NEGLIGIBLE_WIDTH: f64 = 1e-9;

/// Ratio of radii of the panels for the stored energy, as a logarithm, and number of panels that
/// matter.
const PANEL: f64 = 0.4;
const PANELS: usize = 14;

static RULE: FixedRule<16> = FixedRule::fixed();

/// The kind of a path on which the pattern of slip is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::torsion) enum SlipPath {
    /// Growth in complete adhesion.
    Adhere,
    /// One slip annulus from the edge inwards, over the existing densities.
    FromRim,
    /// The slip annulus, of this sign, continues inwards.
    Inward(f64),
    /// Growth with a slip annulus of this sign whose inner radius moves outwards with the contact.
    Outward { sign: f64, annulus: SteadyAnnulus },
}

/// The load history of a circular contact, given by contact radius and twist.
///
/// Units, with the effective radius R = 1/(2A) and combined moduli: radius `al = a/R`, twist `bh =
/// beta (1 - nu)/f`, torque `mu = 3 M_z (1 - nu)/(16 G f R^3)`; complete sliding is `mu = (3 pi/32)
/// al^4`.
///
/// The solution is exact for steps of any size at constant load (Deresiewicz), for growth with
/// adhesion and with slip, and for a receding contact whose twist continues or reverses slowly. In
/// other cases two disjoint slip annuli may occur: after receding while the twist reverses at 1 to
/// `1/k'` times the speed of the edge (more exactly from a threshold between 1 and 1.1023), or over
/// older slip. Most of these steps have one annulus, as bounds of the densities show; that of the others is
/// checked against the friction law on rings, and if it fails the rings are solved
/// ([`TwistHistory::with_ring_width`], [`TwistHistory::ring_steps`]). For 200 random paths, one step and a hundred steps differed by at
/// most 4e-4 of the sliding torque; for 300 paths just above the threshold, where the outer annulus
/// is thin, one step and a thousand differed by at most 1e-3. Such a step takes 0.02 to
/// 0.2 ms for each fortieth of the radius, a check 0.01 to 0.03 ms; all others take 0.5 us.
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
    pub(in crate::torsion) radius: f64,
    pub(in crate::torsion) twist: f64,
    pub(in crate::torsion) torque: f64,
    pub(in crate::torsion) stick: f64,
    pub(in crate::torsion) segments: Pieces,
    pub(in crate::torsion) ring_steps: u32,
    /// The level of the ring width at the edge.
    pub(in crate::torsion) level: usize,
    /// The radius from which the edges of rings are counted.
    pub(in crate::torsion) unit: f64,
}

impl Default for TwistHistory {
    fn default() -> Self {
        Self::at_level(mesh::USUAL_LEVEL)
    }
}

impl TwistHistory {
    /// Two bodies at first contact, without twist.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// As [`TwistHistory::new`], with a given width of the rings that are used where two slip
    /// annuli may occur. Near the edge the width is the greatest of 1/256, 1/128, ... that is at
    /// most `width`, relative to the radius; at the edge itself rings are four times narrower,
    /// further inside wider.
    ///
    /// The default width is 1/128. The torque then agreed with an independent solver to 5e-4 of the
    /// sliding torque; with 1/64 to 1e-3. On drawn paths of few great steps other places of the
    /// rings change it by up to 3e-3. The cost is inversely proportional to the square of the width.
    ///
    /// # Errors
    /// [`RangeError`] for a width outside 1/256 to 1/4.
    pub fn with_ring_width(width: f64) -> Result<Self, RangeError> {
        let holds = (mesh::NARROWEST..=0.25).contains(&width);
        RangeError::check("width", width, holds, "from 1/256 to 1/4")?;
        Ok(Self::at_level((width / mesh::NARROWEST).log2() as usize))
    }

    fn at_level(level: usize) -> Self {
        Self {
            radius: 0.0,
            twist: 0.0,
            torque: 0.0,
            stick: 0.0,
            segments: Pieces::default(),
            ring_steps: 0,
            level,
            unit: 1.0,
        }
    }

    /// The same with edges of rings counted from this radius, so that they do not depend on the unit of length.
    pub(in crate::torsion) fn counted_from(self, unit: f64) -> Self {
        Self { unit, ..self }
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

    /// The radius of the stick area, in the unit of al.
    #[must_use]
    pub const fn stick_radius(&self) -> f64 {
        self.stick
    }

    /// The tangent of the torque at constant load, `dmu/dbh = c^3` with c the stick radius.
    #[must_use]
    pub fn tangent(&self) -> f64 {
        self.stick * self.stick * self.stick
    }

    /// Number of steps that needed rings, because of two disjoint slip annuli.
    #[must_use]
    pub const fn ring_steps(&self) -> u32 {
        self.ring_steps
    }

    /// The density b at a radius; zero outside.
    #[must_use]
    pub fn density(&self, s: f64) -> f64 {
        match self.segment_at(s) {
            Some(segment) if s < self.radius => segment.density().at(s),
            _ => 0.0,
        }
    }

    /// The elastic energy, conjugate to mu and bh: `(3/2) int s^2 (bh - int_0^s b)^2 ds`.
    #[must_use]
    pub fn stored_energy(&self) -> f64 {
        let mut sum = 0.0;
        for (i, segment) in self.segments.iter().enumerate() {
            let mut to = self.segments.get(i + 1).map_or(self.radius, |next| next.from);
            // The twist of a slip segment grows logarithmically towards the centre.
            for panel in 0..PANELS {
                let last = panel + 1 == PANELS || matches!(segment.density(), Density::Stick(_));
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

    /// Clears the history of the contact.
    pub(in crate::torsion) fn separate(&mut self, twist: f64) {
        let &mut Self { ring_steps, level, unit, .. } = self;
        *self = Self { twist, ring_steps, unit, ..Self::at_level(level) };
    }

    /// A substep whose pattern of slip is known.
    pub(in crate::torsion) fn follow(&mut self, way: SlipPath, radius: f64, twist: f64) {
        match way {
            SlipPath::Adhere => self.adhere(radius, twist),
            SlipPath::FromRim => self.slip_from_rim(radius, twist),
            SlipPath::Inward(sign) => self.cut(radius, twist, sign, radius.min(self.stick)),
            SlipPath::Outward { sign, annulus } => {
                self.move_outwards(radius, twist, sign, annulus);
            }
        }
        (self.radius, self.twist) = (radius, twist);
    }

    fn slip_from_rim(&mut self, radius: f64, twist: f64) {
        let shared = radius.min(self.radius);
        // Bodies that just touch have no densities yet.
        let below = if self.radius == 0.0 { self.twist } else { self.twist_below(shared) };
        let rest = twist - below;
        if rest != 0.0 {
            return self.cut(radius, twist, 1.0_f64.copysign(rest), shared);
        }
        self.truncate(shared);
        let torque = self.segments.last().map_or(0.0, |last| last.torque_to(shared));
        self.set_torque(torque, radius);
        self.stick = radius;
    }

    /// Solves for the stick radius, at most `highest`, and sets the sliding density outside it.
    pub(in crate::torsion) fn cut(&mut self, radius: f64, twist: f64, sign: f64, highest: f64) {
        self.grow_to(radius);
        let top = if highest < self.radius.min(radius) { highest } else { radius };
        let mut i = self.segments.len();
        let mut upper = top;
        // From the outside inwards, the first segment at whose lower end sliding needs more twist.
        let (segment, stick) = loop {
            i -= 1;
            let segment = self.segments[i];
            if segment.from < upper || i == 0 {
                let excess = sign * (twist - segment.twist_to(segment.from))
                    - sliding_twist(segment.from, radius);
                if excess <= 0.0 || i == 0 {
                    break (segment, segment.stick_radius(radius, twist, sign, upper));
                }
                upper = segment.from;
            }
        };
        self.segments.truncate(i + 1);
        if stick > (1.0 - NEGLIGIBLE_WIDTH) * radius {
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
        self.push(Segment::new(stick, density, [twist, torque], radius));
    }

    /// Sets the torque, limited to the sliding torque against rounding and the width of rings.
    pub(in crate::torsion) fn set_torque(&mut self, torque: f64, radius: f64) {
        let limit = sliding_limit(radius);
        self.torque = torque.clamp(-limit, limit);
    }

    /// Adds a segment on top of the stack.
    pub(in crate::torsion) fn push(&mut self, mut segment: Segment) {
        segment.demand = segment.demand.max(self.demand());
        self.segments.push(segment);
    }

    /// The contact radius from which all densities are within those of sliding.
    pub(in crate::torsion) fn demand(&self) -> f64 {
        self.segments.last().map_or(0.0, |last| last.demand)
    }

    /// The sign of the outermost slip annulus, if the contact slips there.
    pub(in crate::torsion) fn slip_sign(&self) -> Option<f64> {
        match self.segments.last()?.density() {
            Density::Slip { sign, radius } if radius == self.radius => Some(sign),
            _ => None,
        }
    }

    /// New area in this step carries no traction before it slips.
    fn grow_to(&mut self, radius: f64) {
        if radius > self.radius {
            let below = [self.twist, self.torque];
            self.push(Segment::new(self.radius, Density::Stick(0.0), below, 0.0));
        }
    }

    /// Removes everything outside a radius.
    pub(in crate::torsion) fn truncate(&mut self, radius: f64) {
        let inside = self.segments.iter().rposition(|segment| segment.from < radius);
        self.segments.truncate(inside.map_or(1, |last| last + 1));
    }

    pub(in crate::torsion) fn twist_below(&self, s: f64) -> f64 {
        self.segment_at(s).map_or(0.0, |segment| segment.twist_to(s))
    }

    pub(in crate::torsion) fn torque_below(&self, s: f64) -> f64 {
        self.segment_at(s).map_or(0.0, |segment| segment.torque_to(s))
    }

    /// The twist of all discs up to a radius, which may lie outside the contact.
    pub(in crate::torsion) fn twist_up_to(&self, s: f64) -> f64 {
        if s >= self.radius { self.twist } else { self.twist_below(s) }
    }

    fn segment_at(&self, s: f64) -> Option<&Segment> {
        self.segments.iter().rev().find(|segment| segment.from <= s)
    }
}
