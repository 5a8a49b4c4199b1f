//! Gauss-Legendre rules of low order, fixed at compile time for the coefficients of a cell.

/// One node of a rule on (-1, 1).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Node {
    pub(crate) at: f64,
    pub(crate) weight: f64,
}

/// Smallest |w| (distance of the nearest singularity from the centre, in half-widths) at which
/// the rule of 2, 3, ... points is accurate to rounding.
///
/// The error falls as rho^(-2n) with rho = |w| + sqrt(w^2 - 1); the bounds are rho^(2n) = 1e17.
const REACH: [f64; 11] = [8900.0, 341.0, 66.7, 25.1, 13.1, 8.24, 5.82, 4.46, 3.62, 3.05, 2.65];

/// The distance |w| from which on some tabulated rule is accurate to rounding.
pub(crate) const NEAREST: f64 = REACH[REACH.len() - 1];

/// The shortest rule that is accurate to rounding for a singularity at distance `w` >= [`NEAREST`].
pub(crate) fn rule(w: f64) -> &'static [Node] {
    let index = REACH.iter().position(|&reach| w >= reach).unwrap_or(REACH.len() - 1);
    RULES[index]
}

const RULES: [&[Node]; 11] = [
    // 2 points
    &[
        Node { at: -0.57735026918962576451, weight: 1.0 },
        Node { at: 0.57735026918962576451, weight: 1.0 },
    ],
    // 3 points
    &[
        Node { at: -0.77459666924148337704, weight: 0.55555555555555555556 },
        Node { at: 0.0, weight: 0.88888888888888888889 },
        Node { at: 0.77459666924148337704, weight: 0.55555555555555555556 },
    ],
    // 4 points
    &[
        Node { at: -0.86113631159405257522, weight: 0.34785484513745385737 },
        Node { at: -0.3399810435848562648, weight: 0.65214515486254614263 },
        Node { at: 0.3399810435848562648, weight: 0.65214515486254614263 },
        Node { at: 0.86113631159405257522, weight: 0.34785484513745385737 },
    ],
    // 5 points
    &[
        Node { at: -0.9061798459386639928, weight: 0.23692688505618908751 },
        Node { at: -0.53846931010568309104, weight: 0.47862867049936646804 },
        Node { at: 0.0, weight: 0.56888888888888888889 },
        Node { at: 0.53846931010568309104, weight: 0.47862867049936646804 },
        Node { at: 0.9061798459386639928, weight: 0.23692688505618908751 },
    ],
    // 6 points
    &[
        Node { at: -0.93246951420315202781, weight: 0.17132449237917034504 },
        Node { at: -0.66120938646626451366, weight: 0.36076157304813860757 },
        Node { at: -0.23861918608319690863, weight: 0.46791393457269104739 },
        Node { at: 0.23861918608319690863, weight: 0.46791393457269104739 },
        Node { at: 0.66120938646626451366, weight: 0.36076157304813860757 },
        Node { at: 0.93246951420315202781, weight: 0.17132449237917034504 },
    ],
    // 7 points
    &[
        Node { at: -0.94910791234275852453, weight: 0.12948496616886969327 },
        Node { at: -0.74153118559939443986, weight: 0.2797053914892766679 },
        Node { at: -0.40584515137739716691, weight: 0.38183005050511894495 },
        Node { at: 0.0, weight: 0.41795918367346938776 },
        Node { at: 0.40584515137739716691, weight: 0.38183005050511894495 },
        Node { at: 0.74153118559939443986, weight: 0.2797053914892766679 },
        Node { at: 0.94910791234275852453, weight: 0.12948496616886969327 },
    ],
    // 8 points
    &[
        Node { at: -0.96028985649753623168, weight: 0.10122853629037625915 },
        Node { at: -0.79666647741362673959, weight: 0.22238103445337447054 },
        Node { at: -0.52553240991632898582, weight: 0.31370664587788728734 },
        Node { at: -0.18343464249564980494, weight: 0.36268378337836198297 },
        Node { at: 0.18343464249564980494, weight: 0.36268378337836198297 },
        Node { at: 0.52553240991632898582, weight: 0.31370664587788728734 },
        Node { at: 0.79666647741362673959, weight: 0.22238103445337447054 },
        Node { at: 0.96028985649753623168, weight: 0.10122853629037625915 },
    ],
    // 9 points
    &[
        Node { at: -0.96816023950762608984, weight: 0.081274388361574411972 },
        Node { at: -0.8360311073266357943, weight: 0.18064816069485740406 },
        Node { at: -0.61337143270059039731, weight: 0.26061069640293546232 },
        Node { at: -0.32425342340380892904, weight: 0.31234707704000284007 },
        Node { at: 0.0, weight: 0.33023935500125976316 },
        Node { at: 0.32425342340380892904, weight: 0.31234707704000284007 },
        Node { at: 0.61337143270059039731, weight: 0.26061069640293546232 },
        Node { at: 0.8360311073266357943, weight: 0.18064816069485740406 },
        Node { at: 0.96816023950762608984, weight: 0.081274388361574411972 },
    ],
    // 10 points
    &[
        Node { at: -0.97390652851717172008, weight: 0.066671344308688137594 },
        Node { at: -0.86506336668898451073, weight: 0.14945134915058059315 },
        Node { at: -0.67940956829902440623, weight: 0.219086362515982044 },
        Node { at: -0.4333953941292471908, weight: 0.26926671930999635509 },
        Node { at: -0.14887433898163121088, weight: 0.29552422471475287017 },
        Node { at: 0.14887433898163121088, weight: 0.29552422471475287017 },
        Node { at: 0.4333953941292471908, weight: 0.26926671930999635509 },
        Node { at: 0.67940956829902440623, weight: 0.219086362515982044 },
        Node { at: 0.86506336668898451073, weight: 0.14945134915058059315 },
        Node { at: 0.97390652851717172008, weight: 0.066671344308688137594 },
    ],
    // 11 points
    &[
        Node { at: -0.9782286581460569928, weight: 0.055668567116173666483 },
        Node { at: -0.88706259976809529908, weight: 0.12558036946490462463 },
        Node { at: -0.73015200557404932409, weight: 0.18629021092773425143 },
        Node { at: -0.51909612920681181593, weight: 0.23319376459199047992 },
        Node { at: -0.26954315595234497233, weight: 0.26280454451024666218 },
        Node { at: 0.0, weight: 0.27292508677790063071 },
        Node { at: 0.26954315595234497233, weight: 0.26280454451024666218 },
        Node { at: 0.51909612920681181593, weight: 0.23319376459199047992 },
        Node { at: 0.73015200557404932409, weight: 0.18629021092773425143 },
        Node { at: 0.88706259976809529908, weight: 0.12558036946490462463 },
        Node { at: 0.9782286581460569928, weight: 0.055668567116173666483 },
    ],
    // 12 points
    &[
        Node { at: -0.98156063424671925069, weight: 0.047175336386511827195 },
        Node { at: -0.90411725637047485668, weight: 0.10693932599531843096 },
        Node { at: -0.76990267419430468704, weight: 0.16007832854334622633 },
        Node { at: -0.5873179542866174473, weight: 0.20316742672306592175 },
        Node { at: -0.36783149899818019375, weight: 0.23349253653835480876 },
        Node { at: -0.12523340851146891547, weight: 0.249147045813402785 },
        Node { at: 0.12523340851146891547, weight: 0.249147045813402785 },
        Node { at: 0.36783149899818019375, weight: 0.23349253653835480876 },
        Node { at: 0.5873179542866174473, weight: 0.20316742672306592175 },
        Node { at: 0.76990267419430468704, weight: 0.16007832854334622633 },
        Node { at: 0.90411725637047485668, weight: 0.10693932599531843096 },
        Node { at: 0.98156063424671925069, weight: 0.047175336386511827195 },
    ],
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
                let sum: f64 = rule.iter().map(|n| n.weight * n.at.powi(degree as i32)).sum();
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
