//! Decides which steps have a single slip annulus, and divides the others into substeps.

use carom_special::RangeError;

use super::heat::{Meter, Unmetered};
use super::history::{SlipPath, TwistHistory};
use super::sliding::{sliding_limit, sliding_twist, threshold};
use super::within::{Annulus, Kept};

/// An upper bound of [`threshold`].
const GREATEST_THRESHOLD: f64 = 1.103;

/// The rate of twist per growth up to which new area sticks: 1, with an allowance for rounding.
const LARGEST_ADHESION_RATE: f64 = 1.0 + 1e-12;

/// The greatest relative change of radius in a substep for which a single slip annulus is not
/// guaranteed.
const LARGEST_SUBSTEP: f64 = 1.0 / 40.0;

/// Greatest number of halvings of a substep whose ring solve does not converge; none was needed in
/// 6000 random paths.
const HALVINGS: u32 = 10;

impl TwistHistory {
    /// Advances on a straight path to a new radius and twist.
    ///
    /// # Errors
    /// [`RangeError`] if the ring solve does not converge for any substep; the state is then
    /// unchanged.
    pub(super) fn travel<M: Meter>(
        &mut self,
        radius: f64,
        twist: f64,
        meter: &mut M,
    ) -> Result<(), RangeError> {
        self.travel_by([radius, twist], meter, Self::make_substep)
    }

    /// The same by any substeps, which return `None` if they do not converge.
    fn travel_by<M: Meter>(
        &mut self,
        [radius, twist]: [f64; 2],
        meter: &mut M,
        mut substep: impl FnMut(&mut Self, f64, f64, &mut M) -> Option<bool>,
    ) -> Result<(), RangeError> {
        let mut start = None;
        let mut apart = false;
        while radius != self.radius || twist != self.twist {
            if self.try_single_annulus(radius, twist, meter) {
                break;
            }
            start.get_or_insert_with(|| self.clone());
            let Some(rings) = substep(self, radius, twist, meter) else {
                *self = start.unwrap_or_default();
                return RangeError::check(
                    "twist",
                    twist,
                    false,
                    "for which the ring solve converges",
                )
                .map(|_| ());
            };
            apart |= rings;
        }
        self.ring_steps = self.ring_steps.saturating_add(u32::from(apart));
        Ok(())
    }

    /// Makes the next substep, which is shorter the more difficult it is. Returns whether several
    /// slip annuli occurred.
    fn make_substep(&mut self, radius: f64, twist: f64, meter: &mut impl Meter) -> Option<bool> {
        let [mut radius, mut twist] = self.part_of(radius, twist);
        for _ in 0..HALVINGS {
            if self.try_single_annulus(radius, twist, meter) {
                return Some(false);
            }
            if let Some(rings) = self.try_substep(radius, twist, meter) {
                return Some(rings);
            }
            radius = 0.5 * (self.radius + radius);
            twist = 0.5 * (self.twist + twist);
        }
        None
    }

    /// Makes a step if it is known to have a single slip annulus. Returns whether it was made.
    pub(super) fn try_single_annulus(
        &mut self,
        radius: f64,
        twist: f64,
        meter: &mut impl Meter,
    ) -> bool {
        let (grown, turned) = (radius - self.radius, twist - self.twist);
        if grown > 0.0 && turned.abs() <= LARGEST_ADHESION_RATE * grown {
            self.metered(SlipPath::Adhere, radius, twist, meter);
            return true;
        }
        if grown > 0.0 {
            return self.try_growth(radius, twist, meter);
        }
        let way = if grown < 0.0 {
            self.single_annulus_back(radius, twist)
        } else {
            (self.demand() <= radius).then_some(SlipPath::FromRim)
        };
        if let Some(way) = way {
            self.metered(way, radius, twist, meter);
        }
        way.is_some()
    }

    /// The path of a receding step with a single slip annulus; `None` if that is not guaranteed.
    fn single_annulus_back(&self, radius: f64, twist: f64) -> Option<SlipPath> {
        let Some(sign) = self.slip_sign() else {
            let short = radius >= self.next_rim();
            return (short && self.demand() <= radius).then_some(SlipPath::FromRim);
        };
        if self.annulus_vanishes(radius, twist, sign) {
            return Some(SlipPath::FromRim);
        }
        let back = -sign * (twist - self.twist) / (self.radius - radius);
        if back < GREATEST_THRESHOLD {
            let sure = back <= lowest_rate(back, self.stick / self.radius)
                && self.goes_on_slipping(radius, twist, sign)
                && self.stays_within_friction(radius, twist, sign)
                && (back <= 1.0 || {
                    let mut after = self.clone();
                    after.follow(SlipPath::Inward(sign), radius, twist);
                    back <= lowest_rate(back, after.stick / radius)
                });
            return sure.then_some(SlipPath::Inward(sign));
        }
        // If the whole contact stuck, its traction would decrease as back * rho/sqrt(al^2 - rho^2)
        // and its limit as al/sqrt(al^2 - rho^2): the annulus would continue to slip only inside
        // al/back.
        let sticks = back * self.stick >= self.radius && radius >= self.stick;
        let kept = self.kept(self.stick);
        let sure = sticks
            && kept.below_sliding(0.0, radius, sign)
            && kept.below_sliding(0.0, radius, -sign);
        sure.then_some(SlipPath::FromRim)
    }

    /// Whether a receding edge passes the annulus of the present sign while the contact twists back more slowly than
    /// the edge recedes. An annulus of the other sign then begins at the edge, where the constant density
    /// is below the rate of the twist.
    fn annulus_vanishes(&self, radius: f64, twist: f64, sign: f64) -> bool {
        let back = -sign * (twist - self.twist) / (self.radius - radius);
        let kept = self.kept(radius);
        let slow = radius < self.stick && (0.0..=1.0).contains(&back);
        slow && kept.ends_in_stick()
            && !self.goes_on_slipping(radius, twist, sign)
            && [1.0, -1.0].iter().all(|sign| kept.below_sliding(0.0, radius, *sign))
    }

    /// Whether the contact inside the annulus of the present sign stays within friction while it recedes.
    fn stays_within_friction(&self, radius: f64, twist: f64, sign: f64) -> bool {
        let kept = self.kept(radius.min(self.stick));
        let calm = [sign, -sign].map(|sign| kept.below_sliding(0.0, radius, sign));
        if calm == [true; 2] {
            return true;
        }
        let mut after = self.clone();
        after.follow(SlipPath::Inward(sign), radius, twist);
        (calm[0] || self.slips_over(&after, kept, radius, sign))
            && (calm[1] || self.annulus_balances(&after, sign))
    }

    /// Whether the annulus of a receding contact balances densities above the sliding one in the other
    /// direction. Its width is a concave function of time while it spreads over one piece, since twists are convex
    /// functions of both radii; the excess of density increases linearly. Both ends of a short step
    /// therefore suffice.
    fn annulus_balances(&self, after: &Self, sign: f64) -> bool {
        if after.radius < (1.0 - LARGEST_SUBSTEP) * self.radius {
            return false;
        }
        let kept = self.kept(self.stick);
        let balances = |state: &Self, width: f64| {
            let annulus = Annulus { width, radius: self.radius };
            kept.with_annulus(annulus).balance(state.radius, -sign)
        };
        if after.kept(after.stick).len() == kept.len() && kept.twist_is_convex(sign) {
            return [self, after].iter().all(|state| balances(state, state.radius - state.stick));
        }
        balances(after, (after.radius - self.stick).max(0.0))
    }

    /// Makes a step of a growing contact that slips if it is known to have a single slip annulus. Returns whether it
    /// was made.
    fn try_growth<M: Meter>(&mut self, radius: f64, twist: f64, meter: &mut M) -> bool {
        let sign = 1.0_f64.copysign(twist - self.twist);
        if self.demand() > self.radius {
            // Sliding densities increase, and densities in the other direction decrease where an annulus spreads over
            // what is below the sliding one: there the contact stays within friction.
            let slips = self.slip_sign().is_some();
            let kept = self.kept(if slips { self.stick } else { self.radius });
            if !kept.below_sliding(0.0, self.radius, sign) {
                let mut after = self.clone();
                after.grow(radius, twist, &mut Unmetered);
                if !self.slips_over(&after, kept, self.radius, sign) {
                    return false;
                }
                if !M::LOOKS {
                    *self = after;
                    return true;
                }
            }
        }
        self.grow(radius, twist, meter);
        true
    }

    /// Whether an annulus spread only over densities below the sliding one in its own direction, of those
    /// of `kept`, and what is above inside is balanced.
    fn slips_over(&self, after: &Self, kept: Kept<'_>, radius: f64, sign: f64) -> bool {
        let inside = after.kept(after.stick).inside_front();
        kept.below_sliding(inside.swept_from(), radius, sign) && inside.balance(radius, sign)
    }

    /// Whether the annulus of the present sign continues to slip inwards.
    pub(super) fn goes_on_slipping(&self, radius: f64, twist: f64, sign: f64) -> bool {
        let highest = radius.min(self.stick);
        sign * (twist - self.twist_below(highest)) > sliding_twist(highest, radius)
    }

    /// The end of a substep in which the radius changes little.
    fn part_of(&self, radius: f64, twist: f64) -> [f64; 2] {
        let next = if radius > self.radius {
            self.radius * (1.0 + LARGEST_SUBSTEP)
        } else {
            self.next_rim()
        };
        let whole = if radius > self.radius { radius <= next } else { radius >= next };
        if whole || self.radius == 0.0 {
            return [radius, twist];
        }
        let part = (next - self.radius) / (radius - self.radius);
        [next, self.twist + part * (twist - self.twist)]
    }

    /// The radius to which a substep may recede: not beyond the segment at the edge.
    fn next_rim(&self) -> f64 {
        let least = (1.0 - LARGEST_SUBSTEP) * self.radius;
        match self.segments.last() {
            Some(last) if self.slip_sign().is_none() && last.from < self.radius => {
                least.max(last.from)
            }
            _ => least,
        }
    }

    /// Follows a path and reports it to the meter.
    pub(super) fn metered<M: Meter>(
        &mut self,
        way: SlipPath,
        radius: f64,
        twist: f64,
        meter: &mut M,
    ) {
        let before = M::LOOKS.then(|| self.clone());
        self.follow(way, radius, twist);
        if let Some(before) = before {
            meter.follows(&before, self, way);
        }
    }

    /// Whether torque and outer density of a solution are within friction.
    pub(super) fn is_admissible(&self) -> bool {
        let rim = self.segments.last().map_or(0.0, |last| last.density().at(self.radius));
        let sticks = self.stick >= self.radius;
        self.torque.abs() <= sliding_limit(self.radius) && !(sticks && rim.abs() > 1.0)
    }
}

/// The rate of reverse twist above which an annulus may change its sign, for comparison with
/// `back`.
pub(super) fn lowest_rate(back: f64, stick: f64) -> f64 {
    if back > 1.0 && back < GREATEST_THRESHOLD { threshold(stick) } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::torsion::segment::{Density, Segment};

    /// A contact that grew in adhesion has traction up to its edge: the twist of the edge may not exceed its growth.
    #[test]
    fn a_contact_that_sticks_everywhere_has_no_more_than_friction_at_its_edge() {
        let mut history = TwistHistory::new();
        history.advance(1.0, 0.9).expect("in range");
        assert_eq!(history.stick_radius(), 1.0);
        for (density, holds) in [(0.9, true), (1.0, true), (1.01, false), (-1.01, false)] {
            history.segments.replace(0, Segment::new(0.0, Density::Stick(density), [0.0; 2], 1.0));
            assert_eq!(history.is_admissible(), holds, "{density}");
        }
    }

    /// A contact twisted one way and back, whose densities inside its annulus slid in the other direction.
    fn twisted_back(twist: f64, back: f64) -> TwistHistory {
        let mut history = TwistHistory::new();
        for twist in [0.0, -twist, back - twist] {
            history.advance(1.0, twist).expect("in range");
        }
        assert_eq!(history.slip_sign(), Some(1.0));
        history
    }

    #[test]
    fn a_substep_that_fails_leaves_no_trace_of_those_before() {
        let mut history = twisted_back(1.0, 0.3);
        let before = history.clone();
        let mut made = 0;
        let end = [0.5, history.twist() - 0.6];
        let gone = history.travel_by(end, &mut Unmetered, |history, radius, twist, meter| {
            made += 1;
            (made < 4).then(|| history.make_substep(radius, twist, meter)).flatten()
        });
        assert!(gone.expect_err("does not converge").to_string().starts_with("twist"));
        assert_eq!((made, history), (4, before));
    }

    /// A receding contact that slips back has densities above the sliding one in the other direction, which its
    /// annulus balances up to some width. A step that is known to have this annulus alone is the same in parts that
    /// are checked on rings. Only short steps are known: the bounds are those of their ends.
    #[test]
    fn an_annulus_balances_what_slid_in_the_other_direction() {
        let parts = [0.01, 0.03, 0.1, 0.3, 0.9];
        let twists =
            [0.2, 0.5, 1.0, 2.5].into_iter().flat_map(|twist| parts.map(|part| [twist, part]));
        let losts = [0.002, 0.01, 0.02, 0.0249, 0.03, 0.2];
        let ways =
            losts.into_iter().flat_map(|lost| [-0.5, 0.0, 0.3, 0.6, 0.9].map(|rate| [lost, rate]));
        let mut balanced = 0;
        for ([twist, part], looped) in twists.flat_map(|twist| [(twist, false), (twist, true)]) {
            let mut before = twisted_back(twist, part * twist);
            if looped {
                // The annulus almost reaches what slid before this loop.
                for turn in [-0.1, 0.094] {
                    before.advance(1.0, before.twist + turn * part * twist).expect("in range");
                }
            }
            for [lost, rate] in ways.clone() {
                let (radius, end) = (1.0 - lost, before.twist - rate * lost);
                let calm = before.kept(radius.min(before.stick)).below_sliding(0.0, radius, -1.0);
                let mut after = before.clone();
                if calm || !after.try_single_annulus(radius, end, &mut Unmetered) {
                    continue;
                }
                let (mut parts, mut rings) = (before.clone(), false);
                for part in (1..=16).map(|part| f64::from(part) / 16.0) {
                    let there = before.twist + part * (end - before.twist);
                    let made = parts.try_substep(1.0 - part * lost, there, &mut Unmetered);
                    rings |= made.expect("converges");
                }
                let off = (after.torque - parts.torque).abs() / sliding_limit(radius);
                let step = format!("{twist} {part} {looped}: {lost} {rate}");
                assert!(lost < LARGEST_SUBSTEP && !rings && off < 1e-9, "{step}: {off:e}");
                balanced += 1;
            }
        }
        assert!(balanced > 150, "{balanced}");
    }

    /// What slid in the other direction before the contact receded stays within friction while it grows, whether its
    /// annulus continues or turns back.
    #[test]
    fn no_second_annulus_forms_in_a_contact_that_grows() {
        let mut known = [0; 2];
        let parts = [0.03, 0.1, 0.3, 0.9];
        for [twist, part] in
            [0.2, 0.5, 1.0, 2.5].into_iter().flat_map(|twist| parts.map(|part| [twist, part]))
        {
            for lost in [0.005, 0.02, 0.1] {
                let mut before = twisted_back(twist, part * twist);
                before.advance(1.0 - lost, before.twist + 0.5 * lost).expect("in range");
                let ways = [0.003, 0.02, 0.1, 0.3].into_iter();
                for [gained, rate] in
                    ways.flat_map(|gained| [-3.0, -1.2, 1.05, 1.5, 4.0].map(|rate| [gained, rate]))
                {
                    let (start, way) = (before.radius, [gained, rate * gained]);
                    if before.ring_steps > 0 || before.demand() <= start {
                        continue;
                    }
                    let mut after = before.clone();
                    if !after.try_single_annulus(
                        start + way[0],
                        before.twist + way[1],
                        &mut Unmetered,
                    ) {
                        continue;
                    }
                    let mut parts = before.clone();
                    for part in (1..=16).map(|part| f64::from(part) / 16.0) {
                        let there = [start + part * way[0], before.twist + part * way[1]];
                        let made = parts.try_substep(there[0], there[1], &mut Unmetered);
                        assert_eq!(made, Some(false), "{twist} {part} {lost}: {way:?}");
                    }
                    let off = (after.torque - parts.torque).abs() / sliding_limit(after.radius);
                    assert!(off < 1e-9, "{twist} {part} {lost}: {way:?}, {off:e}");
                    known[usize::from(rate > 0.0)] += 1;
                }
            }
        }
        assert!(known[0] > 100 && known[1] > 300, "{known:?}");
    }
}
