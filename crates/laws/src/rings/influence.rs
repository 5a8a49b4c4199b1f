//! Influence coefficients that do not depend on materials: displacements of each ring by tractions on each
//! ring, by harmonics.

use std::any::Any;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock};

use super::centre::Centre;
use super::dense::{Rows, inverse};
use super::kernel::{at_radius, between_rings};
use super::layout::Layout;

/// Bounds of the search for the radius of the rim condition, outside the contact, in widths of the outermost
/// ring.
const NEAR_RIM: [f64; 2] = [0.01, 0.2];
const ROOT_STEPS: usize = 40;
/// Relative accuracy with which the force in adhesion is matched.
const CLOSE: f64 = 1e-12;

/// The influence coefficients of harmonic k, averaged over rings.
#[derive(Debug, Clone)]
pub(super) struct Harmonic {
    /// W(k+1, k+1) and W(|k-1|, |k-1|): tractions to displacements of the harmonics k and -k; for k = 0
    /// radial and circumferential.
    pub(super) own: [Rows; 2],
    /// W(k+1, |k-1|) and its reverse.
    pub(super) other: [Rows; 2],
    /// The inverse of W(k, k), pressures to normal displacements.
    pub(super) normal_inverse: Rows,
    /// W(k+1, k) and W(|k-1|, k): pressures to tangential displacements of the harmonics k and -k.
    pub(super) spread: [Rows; 2],
    /// W(k, k+1) and W(k, |k-1|): tractions to normal displacements.
    pub(super) lift: [Rows; 2],
}

/// All harmonics from 0 to half the number of angles; for the rim one row each.
#[derive(Debug)]
pub(super) struct Influence<const N: usize> {
    pub(super) layout: Layout<N>,
    /// The radius at which the rim condition is applied.
    pub(super) rim_radius: f64,
    pub(super) rings: Vec<Harmonic>,
    /// As `rings`, for displacements at the rim; `normal_inverse` and `lift` are those of the rings.
    pub(super) rim: Vec<Harmonic>,
    /// The centre of a contact that slips.
    pub(super) centre: Centre,
}

impl<const N: usize> Influence<N> {
    fn new(angles: usize) -> Self {
        let layout = Layout::<N>::new();
        let (rim_radius, twist_radius) = (rim_radius(&layout, 0), rim_radius(&layout, 1));
        let mut kept: BTreeMap<([usize; 2], bool), Rows> = BTreeMap::new();
        let mut of = |m: usize, n: usize, at_rim: bool| {
            let make = || match at_rim {
                true => vec![at_radius([m, n], rim_radius, &layout.edges)],
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
                        normal_inverse: inverse(&of(k, k, false)),
                        spread: [of(up, k, at_rim), of(down, k, at_rim)],
                        lift: [of(k, up, false), of(k, down, false)],
                    }
                })
                .collect()
        };
        let (rings, mut rim) = (harmonics(false), harmonics(true));
        rim[0].own[1] = vec![at_radius([1, 1], twist_radius, &layout.edges)];
        let centre = Centre::new(&rings[1].normal_inverse, &layout);
        Self { layout, rim_radius, rings, rim, centre }
    }

    /// The coefficients for this many angles, computed once per process.
    pub(super) fn shared(angles: usize) -> Arc<Self> {
        type Kept = BTreeMap<(usize, usize), Arc<dyn Any + Send + Sync>>;
        static KEPT: OnceLock<Mutex<Kept>> = OnceLock::new();
        let kept = KEPT.get_or_init(Mutex::default);
        // A thread that panicked with the lock held has left complete entries only.
        let mut kept = kept.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let entry = kept.entry((N, angles)).or_insert_with(|| Arc::new(Self::new(angles)));
        // The entry for (N, ..) has type Influence<N>.
        Arc::clone(entry).downcast().unwrap_or_else(|_| Arc::new(Self::new(angles)))
    }
}

/// The radius, just outside the contact, at which the rim condition is applied. It is chosen such that two
/// similar bodies that stick from first contact, while approach and shift (or twist) grow in proportion, have
/// their exact load: 2/3 (or 2/5) of that of the final stiffness.
///
/// At radius 1 itself the condition would be empty, since a displacement that grows as r^2 (r^3) satisfies it
/// for any value.
fn rim_radius<const N: usize>(layout: &Layout<N>, order: usize) -> f64 {
    let inverse = inverse(&between_rings([order, order], &layout.edges));
    let by = |u: &dyn Fn(usize) -> f64| -> Vec<f64> {
        inverse.iter().map(|row| row.iter().enumerate().map(|(i, x)| x * u(i)).sum()).collect()
    };
    let arm = |i: usize| if order == 1 { layout.radius[i] } else { 1.0 };
    let want = if order == 1 { 0.4 * 16.0 / 3.0 } else { 8.0 / 3.0 };
    let load = |q: &[f64]| (0..N).map(|i| arm(i) * q[i] * layout.area[i]).sum::<f64>();
    let steady = by(&|i| arm(i) * (1.0 - layout.square[i]));
    let growing = by(&|i| arm(i) * layout.square[i]);
    let excess = |r: f64| {
        let row = at_radius([order, order], r, &layout.edges);
        let seen = |q: &[f64]| q.iter().zip(&row).map(|(q, x)| q * x).sum::<f64>();
        let of_rim = seen(&steady) / (1.0 - seen(&growing));
        load(&steady) + of_rim * load(&growing) - want
    };
    let width = 1.0 - layout.edges[N - 1];
    let [mut low, mut high] = NEAR_RIM.map(|part| 1.0 + part * width);
    let [mut of_low, mut of_high] = [excess(low), excess(high)];
    // Regula falsi with the Illinois modification.
    for _ in 0..ROOT_STEPS {
        let middle = (low * of_high - high * of_low) / (of_high - of_low);
        let here = excess(middle);
        if here * of_high > 0.0 {
            (high, of_high) = (middle, here);
            of_low *= 0.5;
        } else {
            (low, of_low) = (high, of_high);
            (high, of_high) = (middle, here);
        }
        if here.abs() < CLOSE {
            return middle;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Distance of the rim condition from the contact for shifts and twists, in widths of the outermost ring.
    fn rim<const N: usize>() -> [f64; 2] {
        let layout = Layout::<N>::new();
        let width = 1.0 - layout.edges[N - 1];
        [0, 1].map(|order| (rim_radius(&layout, order) - 1.0) / width)
    }

    #[test]
    fn the_rim_lies_just_outside_and_the_nearer_the_finer_the_rings() {
        let found = [rim::<4>(), rim::<6>(), rim::<8>(), rim::<12>(), rim::<16>(), rim::<24>()];
        for pair in found.windows(2) {
            for (coarse, fine) in pair[0].into_iter().zip(pair[1]) {
                assert!(fine > 0.0 && fine < coarse && coarse < 0.15, "{found:?}");
            }
        }
    }

    #[test]
    fn influences_are_computed_once() {
        let [one, two] = [0, 1].map(|_| Influence::<6>::shared(8));
        assert!(Arc::ptr_eq(&one, &two));
        assert_eq!(Influence::<6>::shared(16).rings.len(), 9);
    }
}
