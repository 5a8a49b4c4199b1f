//! A piece of the stack of [`super::history`]: the density between two radii.

use std::f64::consts::FRAC_2_PI;

use carom_special::RangeError;
use carom_special::elliptic::complete;

use super::sliding::{
    Sloped, sliding_torque, sliding_twist, sliding_twist_and_density, sliding_twist_and_torque,
    twist_of_depth, with_ratio,
};
use crate::bounds::in_contact;
use crate::stored::Fields;

/// Depth ln(al/c) beyond which the stick radius counts as zero.
const DEEPEST: f64 = 690.0;
/// The greatest torque inside a piece: that of sliding at the greatest radius, 1e60.
const LARGEST_TORQUE: f64 = 1e240;

/// The density on a range of radii.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Density {
    /// Constant: formed in adhesion, or by a ring solve.
    Stick(f64),
    /// Formed in sliding of this sign, at this contact radius.
    Slip { sign: f64, radius: f64 },
}

impl Density {
    pub(super) fn at(self, s: f64) -> f64 {
        match self {
            Self::Stick(density) => density,
            Self::Slip { sign, radius } => {
                sign * FRAC_2_PI * with_ratio(s / radius, complete::e) * radius / s
            }
        }
    }
}

/// The torque `int s^3 b ds` of a constant density between two radii.
pub(super) fn stuck_torque(density: f64, from: f64, to: f64) -> f64 {
    let (a, b) = (to * to, from * from);
    0.25 * density * (a - b) * (a + b)
}

/// A density from a radius outwards: six numbers, which may be kept as bytes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub(super) struct Segment {
    pub(super) from: f64,
    /// The contact radius in which a density slid; 0 for a constant one, since no contact slides at a radius of zero.
    pub(super) slid: f64,
    /// The sign of the slip, or the constant.
    pub(super) value: f64,
    /// Twist and torque of everything inside `from`. On a slip segment the sliding ones outside
    /// `from` are added, from which those outside another radius are subtracted.
    pub(super) twist: f64,
    pub(super) torque: f64,
    /// A contact radius at which the sliding density bounds the densities here and inside: `|b| <=
    /// bF(s; demand)` for all s. Their traction is then within friction at this and all greater
    /// radii.
    pub(super) demand: f64,
}

/// The greatest depth at which a root may be: that of the inner end of a segment, by a logarithm that few searches need.
struct Deepest {
    /// The inner end over the contact radius.
    from: f64,
    shallowest: f64,
    known: Option<f64>,
}

impl Deepest {
    fn get(&mut self) -> f64 {
        let Self { from, shallowest, .. } = *self;
        let find = || if from > 0.0 { -libm::log(from) } else { shallowest + DEEPEST };
        *self.known.get_or_insert_with(find)
    }

    fn is_above(&mut self, depth: f64) -> bool {
        // -ln x >= 1 - x.
        (self.known.is_none() && depth < 1.0 - self.from) || depth < self.get()
    }
}

impl Segment {
    /// Number of its numbers.
    pub(super) const NUMBERS: usize = size_of::<Self>() / size_of::<f64>();

    /// A density from a radius outwards, with its [`Segment::twist`], [`Segment::torque`] and [`Segment::demand`].
    pub(super) const fn new(
        from: f64,
        density: Density,
        [twist, torque]: [f64; 2],
        demand: f64,
    ) -> Self {
        let (slid, value) = match density {
            Density::Stick(density) => (0.0, density),
            Density::Slip { sign, radius } => (radius, sign),
        };
        Self { from, slid, value, twist, torque, demand }
    }

    pub(super) fn density(&self) -> Density {
        match self.slid {
            0.0 => Density::Stick(self.value),
            radius => Density::Slip { sign: self.value, radius },
        }
    }

    /// Passes over its numbers, each within its own range.
    pub(super) fn stored(&mut self, fields: &mut impl Fields) -> Result<(), RangeError> {
        fields.number("piece", &mut self.from, in_contact)?;
        fields.number("slip radius", &mut self.slid, in_contact)?;
        // At the centre of a contact that slid completely, a density may have any magnitude.
        fields.number("density", &mut self.value, RangeError::finite)?;
        fields.number("twist", &mut self.twist, in_contact)?;
        fields.number("torque", &mut self.torque, |field, torque| {
            let holds = torque.abs() <= LARGEST_TORQUE;
            RangeError::check(field, torque, holds, "at most 1e240 in magnitude")
        })?;
        fields.number("demand", &mut self.demand, in_contact)
    }

    /// Twist of everything inside a radius in this segment.
    pub(super) fn twist_to(&self, s: f64) -> f64 {
        match self.density() {
            Density::Stick(density) => self.twist + density * (s - self.from),
            Density::Slip { sign, radius } => self.twist - sign * sliding_twist(s, radius),
        }
    }

    /// Twist of everything inside a radius, and the density there to the accuracy of a step of Newton.
    pub(super) fn twist_and_density(&self, s: f64) -> Sloped {
        match self.density() {
            Density::Stick(density) => Sloped { value: self.twist_to(s), slope: density },
            Density::Slip { sign, radius } => {
                let Sloped { value, slope } = sliding_twist_and_density(s, radius);
                Sloped { value: self.twist - sign * value, slope: sign * slope }
            }
        }
    }

    /// Torque of everything inside a radius in this segment.
    pub(super) fn torque_to(&self, s: f64) -> f64 {
        match self.density() {
            Density::Stick(density) => self.torque + stuck_torque(density, self.from, s),
            Density::Slip { sign, radius } => self.torque - sign * sliding_torque(s, radius),
        }
    }

    /// Twist and torque of everything inside a radius in this segment.
    pub(super) fn inside(&self, s: f64) -> (f64, f64) {
        match self.density() {
            Density::Stick(_) => (self.twist_to(s), self.torque_to(s)),
            Density::Slip { sign, radius } => {
                let (twist, torque) = sliding_twist_and_torque(s, radius);
                (self.twist - sign * twist, self.torque - sign * torque)
            }
        }
    }

    /// The root c of `sign (bh - twist_to(c)) = B(c; radius)` between `from` and `upper`, by
    /// Newton's method in the depth `ln(radius/c)` with bracketing.
    pub(super) fn stick_radius(&self, radius: f64, twist: f64, sign: f64, upper: f64) -> f64 {
        let excess = self.excess(radius, sign * twist, sign);
        let mut low = libm::log(radius / upper).max(0.0);
        let start = excess(low);
        if start.value <= 0.0 {
            return upper;
        }
        let mut high = Deepest { from: self.from / radius, shallowest: low, known: None };
        let mut v = low;
        let mut at = start;
        for _ in 0..200 {
            let next = v - at.value / at.slope;
            if (next - v).abs() <= 1e-9 {
                // Newton's error after this step is of the order of the square of the step.
                v = next;
                break;
            }
            v = if next > low && high.is_above(next) { next } else { 0.5 * (low + high.get()) };
            if !high.is_above(low) {
                break;
            }
            at = excess(v);
            if at.value > 0.0 { low = v } else { high.known = Some(v) }
        }
        // Never exactly the centre, where the sliding density has infinite twist.
        (radius * libm::exp(-v)).max(f64::MIN_POSITIVE).clamp(self.from, upper)
    }

    /// The deficit of the twist `target = sign bh` if everything outside the depth v slides: `sign
    /// (bh - twist_to(c)) - B(c; radius)`.
    fn excess(&self, radius: f64, target: f64, sign: f64) -> impl Fn(f64) -> Sloped {
        let rest = target - sign * self.twist;
        let other = match self.density() {
            Density::Slip { sign: before, radius } => Some((sign * before, radius)),
            Density::Stick(_) => None,
        };
        let shift = other.map_or(0.0, |(_, before)| libm::log(before / radius));
        let (density, from) = (self.density(), self.from);
        move |v| {
            let sliding = twist_of_depth(v);
            let scale = FRAC_2_PI * radius;
            let (value, slope) = (rest - scale * sliding.value, -scale * sliding.slope);
            match (density, other) {
                (Density::Stick(density), _) => {
                    let c = radius * libm::exp(-v);
                    let density = sign * density;
                    Sloped { value: value - density * (c - from), slope: slope + density * c }
                }
                (_, Some((relative, before))) => {
                    let laid =
                        if shift == 0.0 { sliding } else { twist_of_depth((v + shift).max(0.0)) };
                    let scale = relative * FRAC_2_PI * before;
                    Sloped { value: value + scale * laid.value, slope: slope + scale * laid.slope }
                }
                (_, None) => Sloped { value, slope },
            }
        }
    }
}
