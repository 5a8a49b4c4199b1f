//! How far the table may be off.

use super::groups::DissimilarGroups;

/// Gamma at which coupling counts most between entries.
const STRONGEST: f64 = 0.6;
/// What interpolation misses there at any lambda.
const BETWEEN: f64 = 6e-3;
/// What is missed there besides where lambda is small.
const AT_SMALL: f64 = 1.6e-2;
/// lambda at which half of that is left.
const SMALL: f64 = 0.04;
/// What the rings of the entries miss where Gamma is large.
const BY_RINGS: f64 = 2e-3;
/// The same at strong coupling, over the square of gamma f.
const BY_STRENGTH: f64 = 0.4;
/// lambda at which half of that is left.
const REACHED: f64 = 0.1;

/// How far the table may be off the finest rings.
///
/// The form and its numbers were fitted to 4700 drawn impacts (materials of Poisson's ratios from 0 to 1/2, f from
/// 0.01 to 1, lambda from 0 to 8, D_xx/D_zz from 1 to 6) against the finest rings: it covers 98 of 100 of them and is
/// 7 times the difference in the median. It was 4 times too small in the worst.
pub(super) fn of_table(groups: &DissimilarGroups) -> f64 {
    let (spread, lambda) = (groups.spread(), groups.lambda);
    let square = spread * spread;
    let coupled = 2.0 * STRONGEST * spread / (square + STRONGEST * STRONGEST);
    let strength = groups.gamma * groups.friction.get();
    coupled * (BETWEEN + AT_SMALL * SMALL / (lambda + SMALL))
        + BY_RINGS * square / (1.0 + square)
        + BY_STRENGTH * strength * strength * REACHED / (lambda + REACHED)
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_laws::friction::Friction;

    #[test]
    fn stronger_coupling_leaves_a_greater_error() {
        // gamma/f and lambda alike: the error by gamma f is what differs.
        let of = |size: f64| {
            let friction = Friction::new(size).unwrap();
            of_table(&DissimilarGroups::of_spheres(1.0, size, friction, 0.5).unwrap())
        };
        assert!(of(0.1) < of(0.25) && of(0.25) < of(0.4));
    }
}
