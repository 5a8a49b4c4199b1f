//! Computes entries of the table by rings.

use carom_laws::friction::Friction;

use super::nodes::{ENTRIES, KAPPAS, LAMBDAS, Node, RATIOS, SPREADS, SQUARES};
use crate::rings::{Filling, RingImpactError};

/// One entry.
pub(super) fn entry(index: usize) -> Result<f64, RingImpactError> {
    let node = Node::of(index);
    let filling = Filling::new(node.kappa, node.lambda, node.ratio)?;
    value(&filling, &node)
}

fn value(filling: &Filling, node: &Node) -> Result<f64, RingImpactError> {
    match node.friction {
        None => Ok(filling.exact()),
        Some(f) => filling.restitution(node.gamma, Friction::new(f)?),
    }
}

/// All entries, one after the other; `progress` is told how many of how many groups are done.
pub(super) fn entries(mut progress: impl FnMut(usize, usize)) -> Result<Vec<f32>, RingImpactError> {
    let mut entries = vec![0.0; ENTRIES];
    let groups = KAPPAS * RATIOS * LAMBDAS;
    for group in 0..groups {
        let (kappa, rest) = (group % KAPPAS, group / KAPPAS);
        let (ratio, lambda) = (rest % RATIOS, rest / RATIOS);
        let index = |spread: usize, square: usize| {
            (((spread * LAMBDAS + lambda) * RATIOS + ratio) * KAPPAS + kappa) * SQUARES + square
        };
        let first = Node::of(index(0, 0));
        let filling = Filling::new(first.kappa, first.lambda, first.ratio)?;
        for spread in 0..SPREADS {
            for square in 0..SQUARES {
                let at = index(spread, square);
                entries[at] = value(&filling, &Node::of(at))? as f32;
            }
        }
        progress(group + 1, groups);
    }
    Ok(entries)
}
