//! The state of a contact on rings and its step, in normalised units.
//!
//! Units are such that the approach is a^2. Shifts and displacements are divided by f, tractions by f times
//! the modulus (1 - nu)/G = 1, so that Hertz's pressure `(4/pi) sqrt(a^2 - r^2)` is the friction limit.
//! Vectors have a radial and a circumferential component. Twists are counter-clockwise.

use super::centre;
use super::pair::{HERTZ, Pair};
use super::solve::{Share, Tractions};
use super::symmetry::Symmetry;
use super::transform::Field;
use crate::slip_lag::SlipLag;

/// Largest ratio of two step lengths at which slip is extrapolated.
const FARTHEST: f64 = 2.0;
/// If the radius shrinks below this fraction, the history is dropped: what is left of it is rounding.
const FORGOTTEN: f64 = 1e-7;
/// Largest angle by which slip near the centre is carried in a step.
const LARGEST_TURN: f64 = 0.3;
/// Longest tangential path of a step relative to the approach; a longer one only adds sliding.
const LONGEST: f64 = 1e3;

/// The state of a contact since it began.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contact<const N: usize, const H: usize> {
    /// The contact radius; 0 for bodies that just touch.
    pub(super) radius: f64,
    /// The centre, moved by coupling.
    pub(super) centre: [f64; 2],
    /// Accumulated slip at each place, relative to the present rigid shift and twist.
    pub(super) slip: Field<N, H>,
    /// Accumulated slip at the rim.
    pub(super) rim: [[f64; 2]; H],
    pub(super) tractions: Tractions<N, H>,
    /// Length of the last step.
    pub(super) length: f64,
    /// How slip lags behind it.
    pub(super) lag: SlipLag,
}

/// A step in normalised units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Step {
    pub(super) approach: f64,
    pub(super) approached: f64,
    pub(super) shifted: [f64; 2],
    pub(super) twisted: f64,
    /// What the path bends: shifts and twist.
    pub(super) bent: [f64; 3],
    /// How slip lags at its end.
    pub(super) lag: SlipLag,
}

/// The result of a step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Done {
    pub(super) iterations: usize,
    /// Heat, in the unit of energy.
    pub(super) heat: f64,
}

/// Loads and energy in normalised units; tangential loads are divided by f.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Sums {
    pub(super) force: [f64; 2],
    pub(super) torque: f64,
    pub(super) normal: f64,
    /// Energy stored by the tangential tractions.
    pub(super) stored: f64,
}

impl<const N: usize, const H: usize> Default for Contact<N, H> {
    fn default() -> Self {
        let slip = [[[0.0; N]; 2]; H];
        let (tractions, rim) = (Tractions::default(), [[0.0; 2]; H]);
        let (centre, lag) = ([0.0; 2], SlipLag::NONE);
        Self { radius: 0.0, centre, slip, rim, tractions, length: 0.0, lag }
    }
}

impl Sums {
    /// Of bodies that just touch: Hertz's force at an approach too small for tractions.
    pub(super) fn just_touching(zeta: f64) -> Self {
        let zeta = zeta.max(0.0);
        Self { normal: HERTZ * (zeta * zeta.sqrt()), ..Self::default() }
    }
}

impl Step {
    /// The tangential displacement of the step at the rim of a contact of this radius.
    fn way(&self, radius: f64) -> f64 {
        let [x, y] = self.shifted;
        libm::hypot(libm::hypot(x, y), radius * self.twisted)
    }

    /// A step in the same direction, of this fraction.
    fn shortened(&self, part: f64) -> Self {
        let (shifted, twisted) = (self.shifted.map(|x| part * x), part * self.twisted);
        Self { shifted, twisted, ..*self }
    }

    /// The step about a centre.
    fn about(&self, [x, y]: [f64; 2]) -> Self {
        let (turn, [along, across]) = (self.twisted, self.shifted);
        let approach = centre::square([x, y], self.approach);
        Self { approach, shifted: [along - turn * y, across + turn * x], ..*self }
    }
}

impl<const N: usize, const H: usize> Contact<N, H> {
    /// Advances straight to a positive approach.
    pub(super) fn advance<S: Symmetry<H>>(
        &mut self,
        pair: &Pair<N, H, S>,
        tolerance: f64,
        step: &Step,
    ) -> Done {
        let radius = step.approach.sqrt();
        if radius < FORGOTTEN * self.radius {
            *self = Self::default();
            let still = Step { shifted: [0.0; 2], twisted: 0.0, ..*step };
            return self.go(pair, tolerance, radius, &still);
        }
        let way = step.way(radius);
        let longest = LONGEST * step.approach;
        if pair.slips && way > longest {
            let part = longest / way;
            let done = self.go(pair, tolerance, radius, &step.shortened(part));
            // The rest of the path is complete sliding.
            let sums = self.sums(pair);
            let [x, y] = sums.force;
            let along = x * step.shifted[0] + y * step.shifted[1] + sums.torque * step.twisted;
            return Done { heat: done.heat + ((1.0 - part) * along).max(0.0), ..done };
        }
        self.go(pair, tolerance, radius, step)
    }

    fn go<S: Symmetry<H>>(
        &mut self,
        pair: &Pair<N, H, S>,
        tolerance: f64,
        radius: f64,
        step: &Step,
    ) -> Done {
        // The tractions before the step tell where its centre is.
        let centre = self.tractions.way.map(|way| way * radius);
        let length = libm::hypot(step.way(radius), step.approached);
        let step = &step.about(centre);
        let square = step.approach;
        let radius = square.sqrt();
        let factor = self.radius / radius;
        if self.lag != SlipLag::NONE {
            self.fall_back(pair);
        }
        let [by, further] = self.ahead(length).map(|by| by * factor * factor);
        let ahead = self.tractions.y.map(|parts| parts.map(|ring| ring.map(|y| by * y)));
        // The first guess continues the slip at its rate.
        self.tractions.y =
            self.tractions.y.map(|parts| parts.map(|ring| ring.map(|y| further * y)));
        let share = Self::share(pair, factor);
        let enters = share.of_rim[N - 1] > 0.0;
        let mut before = self.carried(pair, radius, centre);
        if step.bent != [0.0; 3] {
            bend(pair, (radius, &share), step, &mut before);
        }
        self.move_along(pair, (radius, &share), step, &mut before);
        let mut c = before;
        for [radial, around] in &mut c {
            for i in 0..N {
                radial[i] = pair.spread * pair.layout.spread[i] - radial[i] / square;
                around[i] = -around[i] / square;
            }
        }
        let share_of = enters.then_some(&share);
        let iterations = pair.solve(&c, &ahead, share_of, tolerance, &mut self.tractions);
        let mut heat = self.settle(pair, (square, &share), &before);
        (self.radius, self.centre, self.length) = (radius, centre, length);
        self.lag = step.lag.kept();
        if self.lag != SlipLag::NONE {
            heat -= self.heat_to_come(pair);
        }
        Done { iterations, heat: heat * radius * square * square / S::ANGLES as f64 }
    }

    /// The slip before the step, on the rings of a contact of this radius about this centre.
    #[inline(always)]
    fn carried<S: Symmetry<H>>(
        &self,
        pair: &Pair<N, H, S>,
        radius: f64,
        centre: [f64; 2],
    ) -> Field<N, H> {
        if centre != self.centre && self.radius > 0.0 {
            let moved = [0, 1].map(|d| (centre[d] - self.centre[d]) / self.radius);
            return self.moved(pair, radius / self.radius, moved);
        }
        if radius == self.radius {
            return self.slip;
        }
        // For bodies that just touched all rings lie outside the old rim.
        let factor = radius / self.radius.max(f64::MIN_POSITIVE);
        pair.nodes.carried::<H, S>(&self.slip, &self.rim, factor, None)
    }

    /// The slip on rings whose radii have changed by a factor, about a centre that moved by this much, over the old
    /// radius. Along the radius it is interpolated, across by its derivative; the axes turn by the same angle.
    #[inline(never)]
    fn moved<S: Symmetry<H>>(
        &self,
        pair: &Pair<N, H, S>,
        factor: f64,
        [x, y]: [f64; 2],
    ) -> Field<N, H> {
        let outwards = pair.directions.map(|[c, s]| c * x + s * y);
        let along = pair.nodes.carried::<H, S>(&self.slip, &self.rim, factor, Some(&outwards));
        let mut out = along;
        for (j, [c, s]) in pair.directions.iter().enumerate() {
            let across = c * y - s * x;
            let mut slopes = [[0.0; N]; 2];
            for (l, from) in along.iter().enumerate() {
                for d in 0..2 {
                    let weight = pair.slopes[d][j][l];
                    for (slope, from) in slopes[d].iter_mut().zip(&from[d]) {
                        *slope += weight * from;
                    }
                }
            }
            for i in 0..N {
                let angle = across / (factor * pair.layout.radius[i]);
                let angle = angle.clamp(-LARGEST_TURN, LARGEST_TURN);
                out[j][0][i] += angle * (slopes[0][i] - along[j][1][i]);
                out[j][1][i] += angle * (slopes[1][i] + along[j][0][i]);
            }
        }
        out
    }

    /// The slip relative to the shift and twist after the step. A ring that enters the contact starts with
    /// its share of the slip of the rim by Hertz's pressure.
    #[inline(always)]
    fn move_along<S: Symmetry<H>>(
        &self,
        pair: &Pair<N, H, S>,
        (radius, share): (f64, &Share<N>),
        step: &Step,
        slip: &mut Field<N, H>,
    ) {
        let rim = pair.spread * step.approach * pair.spread_at_rim;
        let [x, y] = step.shifted;
        // The twist of the old rim, which continues in proportion to the radius.
        let twist = mean_around::<H, S>(&self.rim);
        let outside = |i: usize| match share.of_rim[i] > 0.0 && self.radius > 0.0 {
            true => twist * (pair.layout.radius[i] * radius / self.radius - 1.0),
            false => 0.0,
        };
        let outside: [f64; N] = std::array::from_fn(outside);
        for ([radial, around], [cosine, sine]) in slip.iter_mut().zip(&pair.directions) {
            let along = [x * cosine + y * sine, y * cosine - x * sine];
            for i in 0..N {
                let keeps = 1.0 - share.of_rim[i];
                let turned = step.twisted * radius * pair.layout.radius[i];
                radial[i] = keeps * (radial[i] - along[0]) + share.of_rim[i] * rim;
                around[i] = keeps * (around[i] + outside[i] - along[1] - turned);
            }
        }
    }

    /// The part of the slip of the last step that is still to come, over the square of the radius. Places that have not
    /// touched yet follow the field of those that have: its mean, and in proportion to the radius what differs from it.
    fn still_to_come<S: Symmetry<H>>(&self, pair: &Pair<N, H, S>) -> Field<N, H> {
        let (y, layout) = (&self.tractions.y, &pair.layout);
        let last = layout.radius.iter().take_while(|r| **r <= self.lag.within()).count();
        let last = last.saturating_sub(1);
        let at_last = |j: usize| [0, 1].map(|d| pair.sigma[last] * y[j][d][last]);
        let mut mean = [0.0; 2];
        for (j, [cosine, sine]) in pair.directions.iter().enumerate() {
            let [radial, around] = at_last(j);
            let weight = S::weight(j) / S::ANGLES as f64;
            mean[0] += weight * (cosine * radial - sine * around);
            if !S::MIRRORED {
                mean[1] += weight * (sine * radial + cosine * around);
            }
        }
        let part = self.lag.part();
        std::array::from_fn(|j| {
            let ([cosine, sine], of) = (pair.directions[j], at_last(j));
            let mean = [cosine * mean[0] + sine * mean[1], cosine * mean[1] - sine * mean[0]];
            let slips = |i: usize| y[j][0][i] != 0.0 || y[j][1][i] != 0.0;
            let turn = self.lag.turned / (self.radius * part);
            let of = |d: usize, i: usize| match (i > last && slips(i), slips(last)) {
                (true, true) => {
                    mean[d] + (of[d] - mean[d]) * (layout.radius[i] / layout.radius[last])
                }
                (true, false) if d == 1 => turn * (layout.radius[i] - layout.radius[last]),
                (true, false) => 0.0,
                _ => pair.sigma[i] * y[j][d][i],
            };
            std::array::from_fn(|d| std::array::from_fn(|i| part * of(d, i)))
        })
    }

    /// Takes off what of the slip of the last step is still to come.
    #[inline(never)]
    fn fall_back<S: Symmetry<H>>(&mut self, pair: &Pair<N, H, S>) {
        let square = self.radius * self.radius;
        for (j, to_come) in self.still_to_come(pair).iter().enumerate() {
            for (d, to_come) in to_come.iter().enumerate() {
                for (slip, to_come) in self.slip[j][d].iter_mut().zip(to_come) {
                    *slip -= square * to_come;
                }
                self.rim[j][d] -= square * to_come[N - 1];
            }
        }
    }

    /// The heat of the slip that is still to come, as [`Contact::settle`].
    #[inline(never)]
    fn heat_to_come<S: Symmetry<H>>(&self, pair: &Pair<N, H, S>) -> f64 {
        let to_come = self.still_to_come(pair);
        let of_angle = |j: usize| -> f64 {
            let (z, to_come) = (&self.tractions.z[j], &to_come[j]);
            let of = |i: usize| z[0][i] * to_come[0][i] + z[1][i] * to_come[1][i];
            S::weight(j) * (0..N).map(|i| pair.layout.area[i] * of(i)).sum::<f64>()
        };
        (0..H).map(of_angle).sum()
    }

    /// The slip after the step, on the rings and at the rim; returns the heat over a^5/M.
    #[inline(always)]
    fn settle<S: Symmetry<H>>(
        &mut self,
        pair: &Pair<N, H, S>,
        (square, share): (f64, &Share<N>),
        before: &Field<N, H>,
    ) -> f64 {
        let now = &self.tractions;
        let twist = mean_around::<H, S>(&now.rim);
        let mut heat = 0.0;
        let all = self.slip.iter_mut().zip(before).zip(now.z.iter().zip(&now.y)).zip(&now.rim);
        for (j, (((slip, before), (z, y)), rim)) in all.enumerate() {
            let mut warmed = 0.0;
            for d in 0..2 {
                for i in 0..N {
                    let slipped = pair.sigma[i] * y[d][i];
                    warmed += pair.layout.area[i] * z[d][i] * slipped;
                    let mut of_rim = share.of_rim[i] * rim[d];
                    if d == 1 {
                        of_rim += (share.of_twist[i] - share.of_rim[i]) * twist;
                    }
                    slip[d][i] = before[d][i] + square * (slipped - of_rim);
                }
            }
            heat += S::weight(j) * warmed;
        }
        self.rim = self.at_rim(pair, square);
        heat
    }

    /// The slip of the rim: the radial displacement by pressure, less the elastic displacement by tractions.
    pub(super) fn at_rim<S: Symmetry<H>>(
        &self,
        pair: &Pair<N, H, S>,
        square: f64,
    ) -> [[f64; 2]; H] {
        let spread = pair.spread * pair.spread_at_rim;
        self.tractions.rim.map(|[radial, around]| [square * (spread - radial), -square * around])
    }

    /// The share of the rim's slip that each ring takes; `old` is the old radius over the new one.
    #[inline]
    fn share<S: Symmetry<H>>(pair: &Pair<N, H, S>, old: f64) -> Share<N> {
        let square = old * old;
        let of_rim: [f64; N] = std::array::from_fn(|i| {
            if pair.layout.radius[i] <= old {
                return 0.0;
            }
            ((pair.layout.square[i] - square) / (1.0 - square)).clamp(0.0, 1.0)
        });
        let of_twist = std::array::from_fn(|i| of_rim[i] * pair.layout.radius[i]);
        Share { of_rim, of_twist }
    }

    /// The fraction of the last slip that extrapolates to this step (a second-order backward difference), and
    /// the length of this step over that of the last.
    #[inline]
    fn ahead(&self, length: f64) -> [f64; 2] {
        if self.length == 0.0 {
            return [0.0; 2];
        }
        let ratio = (length / self.length).min(FARTHEST);
        [ratio * ratio / (1.0 + 2.0 * ratio), ratio]
    }

    /// The elastic displacement at a place, over f.
    #[inline(always)]
    pub(super) fn stretch<S: Symmetry<H>>(
        &self,
        pair: &Pair<N, H, S>,
        j: usize,
        i: usize,
    ) -> [f64; 2] {
        let spread = pair.spread * self.radius * self.radius * pair.layout.spread[i];
        [spread - self.slip[j][0][i], -self.slip[j][1][i]]
    }

    /// The normal force of a contact of radius 1 by the pressures at its places.
    pub(super) fn normal_by_pressures<S: Symmetry<H>>(&self, pair: &Pair<N, H, S>) -> f64 {
        let of = |limit: &[f64; N]| -> f64 {
            limit.iter().zip(&pair.layout.area).map(|(p, area)| p * area).sum()
        };
        let limits = self.tractions.limit.iter().enumerate();
        limits.map(|(j, limit)| S::weight(j) * of(limit)).sum::<f64>() / S::ANGLES as f64
    }

    /// Loads, and the energy stored by the tangential tractions.
    pub(super) fn sums<S: Symmetry<H>>(&self, pair: &Pair<N, H, S>) -> Sums {
        let mut sums = Sums::default();
        let (a, layout) = (self.radius, &pair.layout);
        for (j, [cosine, sine]) in pair.directions.iter().enumerate() {
            let [radial, around] = &self.tractions.z[j];
            let (weight, mut of) = (S::weight(j), [0.0; 2]);
            let mut here = Sums::default();
            for i in 0..N {
                let area = layout.area[i];
                of[0] += area * radial[i];
                of[1] += area * around[i];
                here.torque += area * layout.radius[i] * around[i];
                here.normal += area * self.tractions.limit[j][i];
                let stretch = self.stretch(pair, j, i);
                here.stored += area * (radial[i] * stretch[0] + around[i] * stretch[1]);
            }
            sums.force[0] += weight * (cosine * of[0] - sine * of[1]);
            sums.normal += weight * here.normal;
            sums.stored += weight * here.stored;
            if !S::MIRRORED {
                sums.force[1] += sine * of[0] + cosine * of[1];
                sums.torque += here.torque;
            }
        }
        let part = a * a * a / S::ANGLES as f64;
        sums.force = sums.force.map(|f| part * f);
        let [x, y] = self.centre;
        sums.torque = part * a * sums.torque + (x * sums.force[1] - y * sums.force[0]);
        sums.normal =
            if pair.slips { part * sums.normal } else { a * a * a * pair.normal_without_slip };
        sums.stored = (0.5 * part * sums.stored).max(0.0);
        sums
    }
}

/// What the slip of places that have not touched yet will be when they touch changes as the path bends.
#[inline(never)]
fn bend<const N: usize, const H: usize, S: Symmetry<H>>(
    pair: &Pair<N, H, S>,
    (radius, share): (f64, &Share<N>),
    step: &Step,
    slip: &mut Field<N, H>,
) {
    let [x, y, turn] = step.bent;
    let bent: [f64; N] = std::array::from_fn(|i| step.lag.bent_at(pair.layout.radius[i]));
    for ([radial, around], [cosine, sine]) in slip.iter_mut().zip(&pair.directions) {
        for i in 0..N {
            let part = (1.0 - share.of_rim[i]) * bent[i];
            radial[i] += part * (x * cosine + y * sine);
            around[i] += part * (y * cosine - x * sine + turn * radius * pair.layout.radius[i]);
        }
    }
}

/// The mean circumferential component over the angles.
#[inline(always)]
fn mean_around<const H: usize, S: Symmetry<H>>(of: &[[f64; 2]; H]) -> f64 {
    if S::MIRRORED {
        return 0.0;
    }
    of.iter().map(|[_, around]| around).sum::<f64>() / H as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rings::symmetry::{Plane, Whole};

    /// A smooth field is carried to a centre that moved, up to the square of its way.
    fn check<const H: usize, S: Symmetry<H>>(moved: [f64; 2]) {
        let pair = Pair::<12, H, S>::new(1.1, 0.3, 0.5);
        let at = |[x, y]: [f64; 2], [c, s]: [f64; 2]| {
            let (u, v) = (0.3 + x + 0.5 * x * x * x - y * y, y * x + 0.4 * y);
            [c * u + s * v, c * v - s * u]
        };
        let field = |factor: f64, [x, y]: [f64; 2]| -> Field<12, H> {
            std::array::from_fn(|j| {
                let [c, s] = pair.directions[j];
                let value = |i: usize| {
                    let r = factor * pair.layout.radius[i];
                    at([r * c + x, r * s + y], [c, s])
                };
                [0, 1].map(|d| std::array::from_fn(|i| value(i)[d]))
            })
        };
        let rim = pair.directions.map(|along| at(along, along));
        let slip = field(1.0, [0.0; 2]);
        let contact = Contact::<12, H> { radius: 1.0, slip, rim, ..Contact::default() };
        let (got, want) = (contact.moved(&pair, 0.9, moved), field(0.9, moved));
        for (got, want) in got.as_flattened().iter().zip(want.as_flattened()) {
            let off = |i: usize| (got[i] - want[i]).abs();
            assert!((0..12).all(|i| off(i) < 1e-4), "{got:?} {want:?}");
        }
    }

    #[test]
    fn slip_stays_where_it_is_when_the_centre_moves() {
        check::<9, Plane>([2e-3, 0.0]);
        check::<16, Whole>([1e-3, 2e-3]);
    }
}
