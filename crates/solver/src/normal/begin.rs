//! The start of a solve: the set and the gap of a given pressure.

use carom_halfspace::operator::{
    DisplacementField, OperatorError, ROUGHNESS, SurfaceOperator, TractionField,
};

use super::active_set::{ActiveSet, farthest};
use super::iteration_state::IterationState;
use super::task::{Limits, NormalTask};
use crate::drive::Driven;
use crate::lanes::{self, product, product_where};
use crate::parts::{each, fold, sum};

/// The gap of a start is found by a rough product if the tolerance is at least so many times its error.
const COARSE: f64 = 10.0;

impl ActiveSet {
    /// Sets up active set and gap. The initial pressure is scaled for the best fit. Returns by how much the approach is to
    /// be raised.
    pub(super) fn begin(
        &mut self,
        task: &mut NormalTask<'_>,
        limits: Limits,
        state: &mut IterationState,
    ) -> Result<f64, OperatorError> {
        let parts = (&mut *task.pressure, &mut self.active[..]);
        let pressed = sum(self.threads, parts, &|(pressures, actives)| {
            for (active, pressure) in actives.iter_mut().zip(pressures.iter_mut()) {
                *pressure = pressure.max(0.0);
                *active = *pressure > 0.0;
            }
            lanes::total(pressures)
        });
        self.displace(task, limits, state)?;
        let factor = match task.driven {
            Driven::Load(force) => force / (task.operator.grid().cell_area() * pressed),
            Driven::Shift(approach) => self.best_factor(task, approach),
        };
        state.roughness *= factor.abs();
        let approach = task.approach;
        let parts = ((&mut *task.pressure, &self.active[..]), &mut self.gap[..], task.heights);
        let gaps = sum(self.threads, parts, &|((pressures, actives), gaps, heights)| {
            pressures.iter_mut().for_each(|pressure| *pressure *= factor);
            for (gap, height) in gaps.iter_mut().zip(heights) {
                *gap = factor * *gap + height - approach;
            }
            product_where(pressures, gaps, actives)
        });
        Ok(match (task.driven, self.only_cell()) {
            // Heights may be far above the indentation: the rounding of a mean counts.
            (Driven::Load(_), Some(cell)) => self.gap[cell],
            (Driven::Load(_), None) => gaps / (factor * pressed),
            (Driven::Shift(_), _) => 0.0,
        })
    }

    /// The cell of a set of one.
    fn only_cell(&self) -> Option<usize> {
        let mut cells = self.active.iter().enumerate().filter(|(_, active)| **active);
        let (first, other) = (cells.next(), cells.next());
        first.filter(|_| other.is_none()).map(|(cell, _)| cell)
    }

    /// The displacements of the pressures, as gaps.
    fn displace(
        &mut self,
        task: &NormalTask<'_>,
        limits: Limits,
        state: &mut IterationState,
    ) -> Result<(), OperatorError> {
        state.products.normal += 1.0;
        let tractions = TractionField::normal(task.pressure);
        let displacements = DisplacementField::normal(&mut self.gap);
        let is_coarse = limits.change > 0.0 || limits.tolerance >= COARSE * ROUGHNESS;
        if !(self.rough && is_coarse) {
            task.operator.apply(tractions, displacements, &mut self.workspace)?;
            self.give_back_exact();
            return Ok(());
        }
        task.operator.apply_roughly(tractions, displacements, &mut self.workspace)?;
        let parts = (&*task.pressure, &self.gap[..]);
        let (square, far) = fold(
            self.threads,
            parts,
            &|(pressures, images)| (product(pressures, pressures), farthest(images)),
            &|one, other| (one.0 + other.0, f64::max(one.1, other.1)),
        );
        state.roughness = ROUGHNESS * (far + self.own * square.sqrt());
        Ok(())
    }

    /// The factor of the pressures whose displacement, in `gap`, comes closest to an approach.
    fn best_factor(&self, task: &NormalTask<'_>, approach: f64) -> f64 {
        let parts = (&*task.pressure, &self.gap[..], task.heights);
        let [wanted, got] = fold(
            self.threads,
            parts,
            &|(pressures, images, heights)| {
                let (mut wanted, mut got) = (0.0, 0.0);
                for ((pressure, image), height) in pressures.iter().zip(images).zip(heights) {
                    if *pressure > 0.0 {
                        wanted += pressure * (approach - height);
                        got += pressure * image;
                    }
                }
                [wanted, got]
            },
            &|one: [f64; 2], other| [one[0] + other[0], one[1] + other[1]],
        );
        if wanted > 0.0 && got > 0.0 { wanted / got } else { 1.0 }
    }

    /// The gap by a product without the errors of rough ones.
    pub(super) fn compute_gap(
        &mut self,
        (operator, heights): (&dyn SurfaceOperator, &[f64]),
        pressure: &[f64],
        approach: f64,
    ) -> Result<(), OperatorError> {
        let displacements = DisplacementField::normal(&mut self.gap);
        operator.apply(TractionField::normal(pressure), displacements, &mut self.workspace)?;
        each(self.threads, (&mut self.gap[..], heights), &|(gaps, heights)| {
            gaps.iter_mut().zip(heights).for_each(|(gap, height)| *gap += height - approach);
        });
        Ok(())
    }

    /// Restarts from the lowest cell alone, with cautious changes of the set. This is needed in two
    /// cases. If the heights are far above the indentation, the tension dropped is far above the
    /// force, and rounding loses the force. If the cells of a periodic surface are slender, a
    /// damped step may overshoot: each row of close cells responds to a uniform displacement like a
    /// spot far from all others.
    pub(super) fn rescue(
        &mut self,
        task: &mut NormalTask<'_>,
        limits: Limits,
        state: &mut IterationState,
    ) -> Result<f64, OperatorError> {
        *state = IterationState::rescue(state.products, state.patient);
        task.pressure.fill(0.0);
        let lowest = task.heights.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
        if let Some((cell, _)) = lowest {
            task.pressure[cell] = 1.0;
        }
        if matches!(task.driven, Driven::Load(_)) {
            task.approach = 0.0;
        }
        self.begin(task, limits, state)
    }
}
