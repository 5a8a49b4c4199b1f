//! Computes entries of the table by rings.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::channel;
use std::thread;

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

/// All entries, by all threads; `progress` is told how many of how many groups are done.
pub(super) fn entries(mut progress: impl FnMut(usize, usize)) -> Result<Vec<f32>, RingImpactError> {
    let mut entries = vec![0.0; ENTRIES];
    let groups = KAPPAS * RATIOS * LAMBDAS;
    let (next, (sender, receiver)) = (AtomicUsize::new(0), channel());
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            let (next, sender) = (&next, sender.clone());
            scope.spawn(move || {
                let own = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|own| *own < groups);
                // Who no longer listens has failed.
                while own().is_some_and(|own| sender.send(of_group(own)).is_ok()) {}
            });
        }
        drop(sender);
        for (done, found) in receiver.into_iter().enumerate() {
            found?.into_iter().for_each(|(at, value)| entries[at] = value);
            progress(done + 1, groups);
        }
        Ok(entries)
    })
}

/// The entries that share kappa, lambda and the ratio of moduli, with their places.
fn of_group(group: usize) -> Result<Vec<(usize, f32)>, RingImpactError> {
    let (kappa, rest) = (group % KAPPAS, group / KAPPAS);
    let (ratio, lambda) = (rest % RATIOS, rest / RATIOS);
    let index = |spread: usize, square: usize| {
        (((spread * LAMBDAS + lambda) * RATIOS + ratio) * KAPPAS + kappa) * SQUARES + square
    };
    let first = Node::of(index(0, 0));
    let filling = Filling::new(first.kappa, first.lambda, first.ratio)?;
    let places = (0..SPREADS).flat_map(|spread| (0..SQUARES).map(move |square| (spread, square)));
    let places = places.map(|(spread, square)| index(spread, square));
    places.map(|at| Ok((at, value(&filling, &Node::of(at))? as f32))).collect()
}
