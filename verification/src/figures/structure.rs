//! Nassi-Shneiderman charts, drawn from the blocks that a method carries out.

use crate::{Axis, Panel, Series};
use carom_solver::{Block, Step, Trace};

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
    draw(&mut panel, blocks, 0.0, 0.0);
    panel
}

/// How many lines the parts take: one each, and one for the question of a loop.
fn lines<S: Step>(blocks: &[Block<S>]) -> usize {
    let of = |block: &Block<S>| match block {
        Block::Do(_) => 1,
        Block::Until { body, .. } => 1 + lines(body),
    };
    blocks.iter().map(of).sum()
}

/// Draws parts from a height downwards; where they end.
fn draw<S: Step>(panel: &mut Panel, blocks: &[Block<S>], left: f64, mut top: f64) -> f64 {
    for block in blocks {
        match block {
            Block::Do(step) => {
                frame(panel, left, top, top - 1.0);
                words(panel, step.to_string(), left, top);
                top -= 1.0;
            }
            Block::Until { body, done } => {
                let end = draw(panel, body, left + INDENT, top);
                frame(panel, left, top, end - 1.0);
                words(panel, format!("until {done}"), left, end);
                top = end - 1.0;
            }
        }
    }
    top
}

fn frame(panel: &mut Panel, left: f64, top: f64, bottom: f64) {
    let corners = [(left, top), (WIDTH, top), (WIDTH, bottom), (left, bottom), (left, top)];
    panel.add(Series::line("", corners).coloured(0));
}

fn words(panel: &mut Panel, words: String, left: f64, top: f64) {
    panel.add(Series::note(words, (left + 0.1, top - 0.72)).coloured(6));
}

/// Steps and questions of a trace, in order of first appearance, with how often and how much.
pub(super) fn counts<S: Step>(trace: &Trace<S>) -> Vec<(S, usize, f64)> {
    let mut seen: Vec<(S, usize, f64)> = Vec::new();
    for entry in trace.entries() {
        if !seen.iter().any(|(step, ..)| *step == entry.step) {
            seen.push((entry.step, trace.count(entry.step), trace.total(entry.step)));
        }
    }
    seen
}
