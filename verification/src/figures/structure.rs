//! Nassi-Shneiderman charts, drawn from the blocks that a method executes.

use crate::{Axis, Panel, Series};
use carom_classic::{Block, Step, Trace};

/// Widths in units of a line's height.
const WIDTH: f64 = 16.0;
const INDENT: f64 = 0.9;

/// The chart of a program.
pub(super) fn chart<S: Step>(title: &str, blocks: &[Block<S>]) -> Panel {
    let height = lines(blocks) as f64;
    let mut panel = Panel::new(
        Axis::bare("").between(-0.4, WIDTH + 0.4),
        Axis::bare("").between(-height - 0.4, 0.4),
    )
    .titled(title);
    Drawing { panel: &mut panel, drop: 0.5 + 0.028 * height }.blocks(blocks, 0.0, 0.0);
    panel
}

/// Number of lines of the parts: one each, and one for the condition of a loop.
fn lines<S: Step>(blocks: &[Block<S>]) -> usize {
    let of = |block: &Block<S>| match block {
        Block::Do(_) => 1,
        Block::Until { body, .. } => 1 + lines(body),
    };
    blocks.iter().map(of).sum()
}

/// A chart on its panel.
struct Drawing<'a> {
    panel: &'a mut Panel,
    /// Distance of the text from the top of a line; it has one size in all charts.
    drop: f64,
}

impl Drawing<'_> {
    /// Draws parts downwards from a height; returns the height of their end.
    fn blocks<S: Step>(&mut self, blocks: &[Block<S>], left: f64, mut top: f64) -> f64 {
        for block in blocks {
            let (words, line) = match block {
                Block::Do(step) => (step.to_string(), top),
                Block::Until { body, done } => {
                    (format!("until {done}"), self.blocks(body, left + INDENT, top))
                }
            };
            let corners =
                [(left, top), (WIDTH, top), (WIDTH, line - 1.0), (left, line - 1.0), (left, top)];
            self.panel.add(Series::line("", corners).coloured(0));
            self.panel.add(Series::note(words, (left + 0.1, line - self.drop)).coloured(6));
            top = line - 1.0;
        }
        top
    }
}

/// Steps and conditions of a trace, in order of first appearance, with their counts and amounts.
pub(super) fn counts<S: Step>(trace: &Trace<S>) -> Vec<(S, usize, f64)> {
    let mut seen: Vec<(S, usize, f64)> = Vec::new();
    for entry in trace.entries() {
        if !seen.iter().any(|(step, ..)| *step == entry.step) {
            seen.push((entry.step, trace.count(entry.step), trace.total(entry.step)));
        }
    }
    seen
}
