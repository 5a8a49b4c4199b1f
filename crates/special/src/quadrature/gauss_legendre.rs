//! Gauss-Legendre rules of any order.

use crate::RangeError;
use std::f64::consts::PI;

use super::twofold::Twofold;

/// A node of a rule on (-1, 1) with its weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// The position.
    pub position: f64,
    /// The weight.
    pub weight: f64,
}

/// The Gauss-Legendre rule of n nodes: exact for polynomials of degree 2n - 1.
///
/// ```text
/// int_(-1)^1 f(x) dx = sum w_i f(x_i),   P_n(x_i) = 0,   w_i = 2 / ((1 - x_i^2) P_n'(x_i)^2)
/// ```
///
/// The nodes are found by Newton's method in `1 - x`, so that nodes and weights are accurate close
/// to the ends: errors are at most 2e-16 for positions and, up to 200 nodes, 3e-15 relative for
/// weights.
/// Source: DLMF 3.5(v).
///
/// ```
/// use carom_special::quadrature::GaussLegendre;
/// let rule = GaussLegendre::new(20)?;
/// let e = rule.integrate(0.0, 1.0, f64::exp) + 1.0;
/// assert!((e - std::f64::consts::E).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct GaussLegendre<S = Vec<Node>> {
    nodes: S,
}

/// A [`GaussLegendre`] rule of `N` nodes computed at compile time, for `N` from 1 to 200. Nodes and
/// weights are the exact ones rounded to double precision.
///
/// ```
/// use carom_special::quadrature::FixedRule;
/// const RULE: FixedRule<8> = FixedRule::fixed();
/// assert!((RULE.integrate(0.0, 1.0, |x| x.powi(15)) - 1.0 / 16.0).abs() < 1e-16);
/// ```
pub type FixedRule<const N: usize> = GaussLegendre<[Node; N]>;

impl GaussLegendre {
    /// The greatest order: the work to compute a rule grows with its square.
    pub const MOST_NODES: usize = 20_000;

    /// The rule of `order` nodes.
    ///
    /// # Errors
    /// [`RangeError`] unless `order` is from 1 to [`Self::MOST_NODES`].
    pub fn new(order: usize) -> Result<Self, RangeError> {
        let holds = (1..=Self::MOST_NODES).contains(&order);
        RangeError::check("order", order as f64, holds, "from 1 to 20000")?;
        let mut nodes = vec![Node { position: 0.0, weight: 0.0 }; order];
        for i in 0..order.div_ceil(2) {
            let Gap { from_one, weight } = nth_from_above(order, i);
            nodes[i] = Node { position: from_one - 1.0, weight };
            nodes[order - 1 - i] = Node { position: 1.0 - from_one, weight };
        }
        Ok(Self { nodes })
    }
}

impl<const N: usize> FixedRule<N> {
    /// The rule.
    #[must_use]
    pub const fn fixed() -> Self {
        let mut nodes = [Node { position: 0.0, weight: 0.0 }; N];
        let mut i = 0;
        while i < N.div_ceil(2) {
            let Exact { from_one, weight } = nth_from_above(N, i).exact(N);
            let position = Twofold::new(1.0).minus(from_one).high;
            nodes[i] = Node { position: -position, weight: weight.high };
            nodes[N - 1 - i] = Node { position, weight: weight.high };
            i += 1;
        }
        Self { nodes }
    }

    /// The nodes on (-1, 1), ascending.
    #[must_use]
    pub const fn into_nodes(self) -> [Node; N] {
        self.nodes
    }

    /// Positions and weights on (0, 1), ascending.
    #[must_use]
    pub const fn parts() -> [(f64, f64); N] {
        let mut parts = [(0.0, 0.0); N];
        let mut i = 0;
        while i < N.div_ceil(2) {
            let Exact { from_one, weight } = nth_from_above(N, i).exact(N);
            let half = Twofold::new(0.5).times(from_one);
            parts[i] = (half.high, 0.5 * weight.high);
            parts[N - 1 - i] = (Twofold::new(1.0).minus(half).high, 0.5 * weight.high);
            i += 1;
        }
        parts
    }
}

impl<S: AsRef<[Node]>> GaussLegendre<S> {
    /// The nodes on (-1, 1), ascending.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        self.nodes.as_ref()
    }

    /// The nodes and weights of the interval from `lower` to `upper`, ascending in that direction.
    pub fn on(&self, lower: f64, upper: f64) -> impl Iterator<Item = Node> + '_ {
        let (middle, half) = (0.5 * (lower + upper), 0.5 * (upper - lower));
        self.nodes().iter().map(move |node| Node {
            position: middle + half * node.position,
            weight: half * node.weight,
        })
    }

    /// The integral of `function` from `lower` to `upper`.
    #[must_use]
    pub fn integrate(&self, lower: f64, upper: f64, mut function: impl FnMut(f64) -> f64) -> f64 {
        self.on(lower, upper).map(|node| node.weight * function(node.position)).sum()
    }
}

/// A node, given by its distance from 1.
struct Gap {
    from_one: f64,
    weight: f64,
}

/// The same in double-double precision.
struct Exact {
    from_one: Twofold,
    weight: Twofold,
}

impl Gap {
    /// Refined by one more Newton step.
    const fn exact(&self, order: usize) -> Exact {
        let [one, two, n] = [Twofold::new(1.0), Twofold::new(2.0), Twofold::new(order as f64)];
        let mut y = Twofold::new(self.from_one);
        let mut steps = 0;
        loop {
            // The recurrence of [`Legendre::at`].
            let (mut value, mut before) = (one.minus(y), one);
            let mut difference = value.minus(one);
            let mut k = 1;
            while k < order {
                let (low, high) = (Twofold::new(k as f64), Twofold::new(k as f64 + 1.0));
                let change = low.plus(high).times(y).times(value);
                difference = low.times(difference).minus(change).over(high);
                before = value;
                value = value.plus(difference);
                k += 1;
            }
            // (1 - x^2) P_n' = n fall
            let fall = before.minus(value).plus(y.times(value));
            let square = y.times(two.minus(y)); // 1 - x^2
            if steps == 1 {
                let slope = n.times(fall);
                return Exact { from_one: y, weight: two.times(square).over(slope.times(slope)) };
            }
            y = y.plus(value.times(square).over(n.times(fall)));
            steps += 1;
        }
    }
}

/// The node number `i` counted from 1 downwards, in the upper half.
const fn nth_from_above(order: usize, i: usize) -> Gap {
    let n = order as f64;
    let is_middle = 2 * i + 1 == order;
    let mut y = if is_middle {
        1.0
    } else {
        // Tricomi's estimate, with an error of O(n^-4).
        let half_angle = 0.5 * PI * (4.0 * i as f64 + 3.0) / (4.0 * n + 2.0);
        let half = sine(half_angle);
        let shrink = (n - 1.0) / (8.0 * n * n * n);
        2.0 * half * half + shrink * (1.0 - 2.0 * half * half)
    };
    let mut legendre = Legendre::at(order, y);
    let mut steps = 0;
    while steps < 8 && !is_middle {
        let step = legendre.value / legendre.slope;
        y += step;
        legendre = Legendre::at(order, y);
        if step.abs() < 1e-10 * y {
            break;
        }
        steps += 1;
    }
    // One more step changes y only by the rounding error of the derivative.
    let slope = legendre.slope;
    Gap { from_one: y, weight: 2.0 / (y * (2.0 - y) * slope * slope) }
}

/// sin x for x in [0, pi/4] by its series: libm's is not available at compile time.
const fn sine(x: f64) -> f64 {
    let (mut sum, mut k) = (1.0, 8.0);
    while k > 0.0 {
        sum = 1.0 - x * x / (2.0 * k * (2.0 * k + 1.0)) * sum;
        k -= 1.0;
    }
    x * sum
}

/// P_n and dP_n/dx at `x = 1 - y`.
struct Legendre {
    value: f64,
    slope: f64,
}

impl Legendre {
    /// By the recurrence of the differences `P_(k+1) - P_k`, which is accurate for small `y`.
    const fn at(order: usize, y: f64) -> Self {
        let (mut value, mut before) = (1.0 - y, 1.0);
        let mut difference = -y;
        let (mut k, last) = (1.0, order as f64);
        while k < last {
            difference = (k * difference - (2.0 * k + 1.0) * y * value) / (k + 1.0);
            before = value;
            value += difference;
            k += 1.0;
        }
        // (1 - x^2) P_n' = n (P_(n-1) - x P_n)
        let slope = last * (before - value + y * value) / (y * (2.0 - y));
        Self { value, slope }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_rules() {
        let rule = GaussLegendre::new(5).expect("order");
        let inner = (5.0 - 2.0 * (10.0_f64 / 7.0).sqrt()).sqrt() / 3.0;
        let outer = (5.0 + 2.0 * (10.0_f64 / 7.0).sqrt()).sqrt() / 3.0;
        let exact = [-outer, -inner, 0.0, inner, outer];
        for (node, position) in rule.nodes().iter().zip(exact) {
            assert!((node.position - position).abs() < 3e-16);
        }
        assert!((rule.nodes()[2].weight - 128.0 / 225.0).abs() < 3e-16);
        assert_eq!(GaussLegendre::new(1).expect("order").nodes()[0].weight, 2.0);
    }

    #[test]
    fn rules_fixed_when_compiled_are_the_same() {
        const RULE: FixedRule<24> = FixedRule::fixed();
        const PARTS: [(f64, f64); 24] = FixedRule::parts();
        let rule = GaussLegendre::new(24).expect("order");
        for ((fixed, node), part) in RULE.nodes().iter().zip(rule.nodes()).zip(PARTS) {
            assert!((fixed.position - node.position).abs() < 3e-16);
            assert!((fixed.weight / node.weight - 1.0).abs() < 2e-15);
            assert!((part.0 - 0.5 * (1.0 + fixed.position)).abs() < 2e-16);
            assert_eq!(part.1, 0.5 * fixed.weight);
        }
    }

    #[test]
    fn fixed_rules_are_rounded_from_20_digits() {
        // Tabulated with 20 digits.
        let upper = [
            (0.12523340851146891547, 0.249147045813402785),
            (0.36783149899818019375, 0.23349253653835480876),
            (0.5873179542866174473, 0.20316742672306592175),
            (0.76990267419430468704, 0.16007832854334622633),
            (0.90411725637047485668, 0.10693932599531843096),
            (0.98156063424671925069, 0.047175336386511827195),
        ];
        for (node, exact) in FixedRule::<12>::fixed().nodes()[6..].iter().zip(upper) {
            assert_eq!((node.position, node.weight), exact);
        }
        let [(low, weight), middle, _] = FixedRule::<3>::parts();
        assert_eq!((low, weight, middle), (0.112_701_665_379_258_31, 5.0 / 18.0, (0.5, 4.0 / 9.0)));
    }

    #[test]
    fn moments_are_exact() {
        for order in [1, 2, 3, 7, 20, 64, 101, 500] {
            let rule = GaussLegendre::new(order).expect("order");
            for degree in (0..2 * order).step_by(1 + order / 5) {
                let exact = 1.0 / (degree as f64 + 1.0);
                let value = rule.integrate(0.0, 1.0, |x| libm::pow(x, degree as f64));
                assert!((value / exact - 1.0).abs() < 4e-15, "{order} {degree} {value}");
            }
        }
    }

    #[test]
    fn order_out_of_range_is_an_error() {
        assert_eq!(GaussLegendre::new(0).unwrap_err().field, "order");
        assert!(GaussLegendre::new(20_001).is_err());
    }
}
