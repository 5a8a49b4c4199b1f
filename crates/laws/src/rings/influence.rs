//! What is the same for all materials: displacements of each ring by tractions on each, by harmonics.

use std::any::Any;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock};

use super::dense::Rows;
use super::kernel::{at_radius, between_rings};
use super::layout::Layout;

/// The influences of one harmonic k, of means over rings.
#[derive(Debug, Clone)]
pub(super) struct Harmonic {
    /// W(k+1, k+1) and W(|k-1|, |k-1|): traction to displacement of the harmonics k and -k.
    pub(super) own: [Rows; 2],
    /// W(k+1, |k-1|) and back.
    pub(super) other: [Rows; 2],
    /// W(k, k): pressure to normal displacement, inverted.
    pub(super) normal_inverse: Rows,
    /// W(k+1, k) and W(|k-1|, k): pressure to the displacements k and -k.
    pub(super) spread: [Rows; 2],
    /// W(k, k+1) and W(k, |k-1|): tractions to normal displacement.
    pub(super) lift: [Rows; 2],
}

/// All harmonics from 0 to half of the angles; for the rim, one row each in place of the rings.
#[derive(Debug)]
pub(super) struct Influence<const N: usize> {
    pub(super) layout: Layout<N>,
    pub(super) rings: Vec<Harmonic>,
    /// As `rings`, of displacements at the rim: `normal_inverse` and `lift` are those of the rings.
    pub(super) rim: Vec<Harmonic>,
}

impl<const N: usize> Influence<N> {
    fn new(angles: usize) -> Self {
        let layout = Layout::<N>::new();
        let mut kept: BTreeMap<([usize; 2], bool), Rows> = BTreeMap::new();
        let mut of = |m: usize, n: usize, at_rim: bool| {
            let make = || match at_rim {
                true => vec![at_radius([m, n], layout.rim, &layout.edges)],
                false => between_rings([m, n], &layout.edges),
            };
            kept.entry(([m, n], at_rim)).or_insert_with(make).clone()
        };
        let mut harmonics = |at_rim: bool| -> Vec<Harmonic> {
            (0..=angles / 2)
                .map(|k| {
                    let (up, down) = (k + 1, k.abs_diff(1));
                    Harmonic {
                        own: [of(up, up, at_rim), of(down, down, at_rim)],
                        other: [of(up, down, at_rim), of(down, up, at_rim)],
                        normal_inverse: super::dense::inverse(&of(k, k, false)),
                        spread: [of(up, k, at_rim), of(down, k, at_rim)],
                        lift: [of(k, up, false), of(k, down, false)],
                    }
                })
                .collect()
        };
        let (rings, rim) = (harmonics(false), harmonics(true));
        Self { layout, rings, rim }
    }

    /// That of so many angles, computed once per process.
    pub(super) fn shared(angles: usize) -> Arc<Self> {
        type Kept = BTreeMap<(usize, usize), Arc<dyn Any + Send + Sync>>;
        static KEPT: OnceLock<Mutex<Kept>> = OnceLock::new();
        let kept = KEPT.get_or_init(Mutex::default);
        // A thread that panicked while it held the lock has left whole entries only.
        let mut kept = kept.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let entry = kept.entry((N, angles)).or_insert_with(|| Arc::new(Self::new(angles)));
        // The entry of (N, ..) is an Influence<N>.
        Arc::clone(entry).downcast().unwrap_or_else(|_| Arc::new(Self::new(angles)))
    }
}
