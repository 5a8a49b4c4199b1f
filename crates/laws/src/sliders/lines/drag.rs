//! The annuli of the line that slip in one step.

use std::ops::Range;

use super::super::ring::SlipStep;
use super::vertex::{Resolution, Slipped, Vertex, front};

/// Greatest number of halvings of the interval between two annuli in one step.
const MOST_HALVINGS: u32 = 6;
/// An annulus is removed only if the loss is below this fraction of the loss that would insert it.
/// Otherwise annuli would be inserted and removed repeatedly, each time with a small error.
const REMOVAL_FRACTION: f64 = 1.0 / 8.0;

/// A straight step between two shifts in which annuli slip.
pub(super) struct Drag<'a> {
    pub(super) step: &'a SlipStep,
    pub(super) from: [f64; 2],
    pub(super) to: [f64; 2],
    pub(super) resolution: Resolution,
}

/// Two neighbouring annuli before and after the step; between them the line before the step is
/// straight.
struct Between<'a> {
    before: [&'a Vertex; 2],
    after: [&'a Slipped; 2],
}

impl Drag<'_> {
    /// The replacement of a run of slipping annuli of the line, from the inside outwards, and the
    /// number of annuli dragged for it.
    pub(super) fn lay(&self, line: &[Vertex], run: Range<usize>, fresh: &mut Vec<Vertex>) -> usize {
        fresh.clear();
        let mut laid =
            Laid { fresh, below: run.start.checked_sub(1).map(|i| &line[i]), dragged: 0 };
        let mut last: Option<(&Vertex, Slipped)> = None;
        if let Some(below) = laid.below
            && let Some(front) = front(below, &line[run.start], self.step.to, self.to)
        {
            laid.fresh.push(front);
            last = Some((below, Slipped::at(front, self.step, self.to)));
        }
        for vertex in &line[run.clone()] {
            let now = self.dragged(vertex, &mut laid);
            if let Some((before, last)) = last {
                let between = Between { before: [before, vertex], after: [&last, &now] };
                self.fill(&between, MOST_HALVINGS, &mut laid);
            }
            self.put(now.after, &mut laid);
            last = Some((vertex, now));
        }
        if let (Some(above), Some((before, last))) = (line.get(run.end), last)
            && let Some(front) = front(above, before, self.step.to, self.to)
        {
            let now = Slipped::at(front, self.step, self.to);
            let between = Between { before: [before, above], after: [&last, &now] };
            self.fill(&between, MOST_HALVINGS, &mut laid);
            self.put(front, &mut laid);
        }
        laid.dragged
    }

    fn dragged(&self, vertex: &Vertex, laid: &mut Laid<'_>) -> Slipped {
        laid.dragged += 1;
        Slipped::dragged(vertex, self.step, self.from, self.to)
    }

    // The previous annulus is left out if the line is as accurate without it.
    fn put(&self, vertex: Vertex, laid: &mut Laid<'_>) {
        let fresh = &mut laid.fresh;
        let before = fresh.len().checked_sub(2).map_or(laid.below, |i| Some(&fresh[i]));
        if let (Some(before), Some(last)) = (before, fresh.last())
            && self.resolution.finer(REMOVAL_FRACTION).spares(before, last, &vertex)
        {
            fresh.pop();
        }
        fresh.push(vertex);
    }

    // Annuli between two whose tractions rotated differently.
    fn fill(&self, between: &Between<'_>, left: u32, laid: &mut Laid<'_>) {
        let Between { before, after: [a, b] } = *between;
        if left == 0 || !self.resolution.bends(a, b) {
            return;
        }
        let middle = before[0].between(before[1], 0.5 * (a.after.depth + b.after.depth));
        let middle = self.dragged(&middle, laid);
        self.fill(&Between { before, after: [a, &middle] }, left - 1, laid);
        self.put(middle.after, laid);
        self.fill(&Between { before, after: [&middle, b] }, left - 1, laid);
    }
}

/// The part of the line that is complete.
struct Laid<'a> {
    fresh: &'a mut Vec<Vertex>,
    /// The annulus that sticks, inside the run.
    below: Option<&'a Vertex>,
    dragged: usize,
}
