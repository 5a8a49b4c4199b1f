//! Gauss-Legendre rules of any order.

use crate::RangeError;
use std::f64::consts::PI;

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
/// The nodes are found by Newton's method in `1 - x`, so that they and their weights keep all digits
/// next to the ends: positions within 2e-16, weights within 3e-15 relative up to 200 nodes.
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
pub struct GaussLegendre {
    nodes: Vec<Node>,
}

impl GaussLegendre {
    /// The largest order: the work to make a rule grows as its square.
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

    /// The nodes on (-1, 1), ascending.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The nodes and weights of the interval from `lower` to `upper`, ascending in that direction.
    pub fn on(&self, lower: f64, upper: f64) -> impl Iterator<Item = Node> + '_ {
        let (middle, half) = (0.5 * (lower + upper), 0.5 * (upper - lower));
        self.nodes.iter().map(move |node| Node {
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

/// A node by its distance from 1.
struct Gap {
    from_one: f64,
    weight: f64,
}

/// The node number `i` counted from 1 downwards, in the upper half.
fn nth_from_above(order: usize, i: usize) -> Gap {
    let n = order as f64;
    let mut y = if 2 * i + 1 == order {
        1.0
    } else {
        // Tricomi's estimate, off by O(n^-4).
        let angle = PI * (4.0 * i as f64 + 3.0) / (4.0 * n + 2.0);
        let half = libm::sin(0.5 * angle);
        let shrink = (n - 1.0) / (8.0 * n * n * n);
        2.0 * half * half + shrink * libm::cos(angle)
    };
    let mut legendre = Legendre::at(order, y);
    for _ in 0..8 {
        let step = legendre.value / legendre.slope;
        if 2 * i + 1 == order {
            break;
        }
        y += step;
        legendre = Legendre::at(order, y);
        if step.abs() < 1e-10 * y {
            break;
        }
    }
    // One step further changes nothing in y but what rounding leaves in the slope.
    let slope = legendre.slope;
    Gap { from_one: y, weight: 2.0 / (y * (2.0 - y) * slope * slope) }
}

/// P_n and dP_n/dx at `x = 1 - y`.
struct Legendre {
    value: f64,
    slope: f64,
}

impl Legendre {
    /// By the recurrence of the differences `P_(k+1) - P_k`, which loses nothing for small `y`.
    fn at(order: usize, y: f64) -> Self {
        let (mut value, mut before) = (1.0 - y, 1.0);
        let mut difference = -y;
        for k in 1..order {
            let k = k as f64;
            difference = (k * difference - (2.0 * k + 1.0) * y * value) / (k + 1.0);
            before = value;
            value += difference;
        }
        // (1 - x^2) P_n' = n (P_(n-1) - x P_n)
        let slope = order as f64 * (before - value + y * value) / (y * (2.0 - y));
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
