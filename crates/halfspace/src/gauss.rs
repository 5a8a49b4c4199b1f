//! Selects the shortest Gauss rule that is accurate to rounding for the coefficients of a cell.

use carom_special::quadrature::{FixedRule, Node};

/// Smallest |w| (distance of the nearest singularity from the centre, in half-widths) at which
/// the rule of 2, 3, ... points is accurate to rounding.
///
/// The error falls as rho^(-2n) with rho = |w| + sqrt(w^2 - 1); the bounds are rho^(2n) = 1e17.
const REACH: [f64; 11] = [8900.0, 341.0, 66.7, 25.1, 13.1, 8.24, 5.82, 4.46, 3.62, 3.05, 2.65];

/// The distance |w| from which some tabulated rule is accurate to rounding.
pub(crate) const NEAREST: f64 = REACH[REACH.len() - 1];

/// The shortest rule that is accurate to rounding for a singularity at distance `w` >= [`NEAREST`].
pub(crate) fn rule(w: f64) -> &'static [Node] {
    let index = REACH.iter().position(|&reach| w >= reach).unwrap_or(REACH.len() - 1);
    RULES[index]
}

static RULES: [&[Node]; 11] = [
    &FixedRule::<2>::fixed().into_nodes(),
    &FixedRule::<3>::fixed().into_nodes(),
    &FixedRule::<4>::fixed().into_nodes(),
    &FixedRule::<5>::fixed().into_nodes(),
    &FixedRule::<6>::fixed().into_nodes(),
    &FixedRule::<7>::fixed().into_nodes(),
    &FixedRule::<8>::fixed().into_nodes(),
    &FixedRule::<9>::fixed().into_nodes(),
    &FixedRule::<10>::fixed().into_nodes(),
    &FixedRule::<11>::fixed().into_nodes(),
    &FixedRule::<12>::fixed().into_nodes(),
];

#[cfg(test)]
mod tests {
    use super::*;

    const FIRST: usize = 2;

    #[test]
    fn rules_are_exact_to_their_degree() {
        for (index, rule) in RULES.iter().enumerate() {
            let points = index + FIRST;
            assert_eq!(rule.len(), points);
            for degree in 0..2 * points {
                let sum: f64 = rule.iter().map(|n| n.weight * n.position.powi(degree as i32)).sum();
                let exact = if degree % 2 == 0 { 2.0 / (degree as f64 + 1.0) } else { 0.0 };
                approx::assert_abs_diff_eq!(sum, exact, epsilon = 1e-15);
            }
        }
    }

    #[test]
    fn reach_follows_from_the_geometric_error_bound() {
        for (index, &w) in REACH.iter().enumerate() {
            let rho = w + (w * w - 1.0).sqrt();
            let digits = 2.0 * (index + FIRST) as f64 * rho.log10();
            assert!((digits - 17.0).abs() < 0.05, "{} points: {digits}", index + FIRST);
        }
    }
}
