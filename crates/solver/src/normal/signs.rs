//! Violations of the inequalities: tension, and overlap.

use super::active_set::ActiveSet;
use super::iteration_state::IterationState;
use super::task::NormalTask;
use crate::lanes;
use crate::parts::{fold, sum};

/// What is seen of a solution in one pass over its cells.
#[derive(Clone, Copy, Default)]
pub(super) struct Seen {
    /// The greatest violation, as a gap; NaN if any value is NaN.
    pub(super) greatest: f64,
    /// A bound on the error of the gap by rough products.
    pub(super) roughness: f64,
    /// The greatest displacement of cells that touch.
    pub(super) scale: f64,
    /// The norm of the violations, tension inside the set and overlap outside, as pressures.
    pub(super) violation: f64,
    /// The number of cells with pressure.
    pub(super) touching: usize,
    /// The sum of the pressures.
    pub(super) sum: f64,
}

impl Seen {
    /// The greatest violation that there may be, relative to the greatest displacement; NaN if any value is NaN.
    pub(super) fn normal(&self) -> f64 {
        let greatest = self.greatest + self.roughness;
        if self.scale > 0.0 { greatest / self.scale } else { greatest }
    }
}

impl ActiveSet {
    /// Lowers all gaps, and sees what they and the pressures violate.
    pub(super) fn see(&mut self, task: &NormalTask<'_>, lift: f64) -> Seen {
        let (own, approach) = (self.own, task.approach);
        let parts = (&mut self.gap[..], &*task.pressure, &self.active[..], task.heights);
        let seen = fold(
            self.threads,
            parts,
            &|(gaps, pressures, actives, heights)| {
                lower(gaps, lift);
                let (greatest, scale) =
                    misfit((gaps, pressures, actives), heights, (own, approach));
                let violation = square_of_violations(gaps, pressures, actives, own);
                let touching = pressures.iter().filter(|pressure| **pressure > 0.0).count();
                let sum = lanes::total(pressures);
                Seen { greatest, roughness: 0.0, scale, violation, touching, sum }
            },
            &|one: Seen, other: Seen| Seen {
                greatest: greater(one.greatest, other.greatest),
                roughness: 0.0,
                scale: one.scale.max(other.scale),
                violation: one.violation + other.violation,
                touching: one.touching + other.touching,
                sum: one.sum + other.sum,
            },
        );
        Seen { violation: seen.violation.sqrt(), ..seen }
    }

    pub(super) fn is_converged(
        &self,
        task: &NormalTask<'_>,
        (seen, state): (&Seen, &IterationState),
        change: f64,
    ) -> bool {
        if change == 0.0 {
            return false;
        }
        let squares = |pressures: &[f64]| lanes::product(pressures, pressures);
        let norm = change * sum(self.threads, &*task.pressure, &squares).sqrt();
        state.step < norm && seen.violation < norm
    }
}

/// Lowers gaps.
pub(super) fn lower(gaps: &mut [f64], lift: f64) {
    if lift != 0.0 {
        gaps.iter_mut().for_each(|gap| *gap -= lift);
    }
}

/// The greatest violation, NaN if any gap is NaN, and the greatest displacement of active cells.
fn misfit(
    (gaps, pressures, actives): (&[f64], &[f64], &[bool]),
    heights: &[f64],
    (own, approach): (f64, f64),
) -> (f64, f64) {
    let (mut greatest, mut scale, mut is_nan) = (0.0_f64, 0.0_f64, false);
    for (((gap, pressure), active), height) in gaps.iter().zip(pressures).zip(actives).zip(heights)
    {
        let inside = gap.abs().max(-pressure * own);
        let (wrong, moved) =
            if *active { (inside, (gap + approach - height).abs()) } else { (-gap, 0.0) };
        is_nan |= gap.is_nan() | pressure.is_nan();
        greatest = greatest.max(wrong);
        scale = scale.max(moved);
    }
    (if is_nan { f64::NAN } else { greatest }, scale)
}

/// The sum of the squares of tensions inside the set and overlaps outside, as pressures.
fn square_of_violations(gaps: &[f64], pressures: &[f64], actives: &[bool], own: f64) -> f64 {
    let mut square = 0.0;
    for ((gap, pressure), active) in gaps.iter().zip(pressures).zip(actives) {
        let wrong = if *active { pressure.min(0.0) } else { gap.min(0.0) / own };
        square += wrong * wrong;
    }
    square
}

/// The greater value; NaN if any is NaN.
pub(super) const fn greater(one: f64, other: f64) -> f64 {
    if one.is_nan() {
        one
    } else if other.is_nan() || other > one {
        other
    } else {
        one
    }
}
