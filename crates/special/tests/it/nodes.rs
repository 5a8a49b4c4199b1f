//! Gauss nodes on an interval: in ascending order, each with its own weight.

use carom_special::quadrature::GaussLegendre;

#[test]
fn nodes_of_an_interval_ascend_in_its_direction() {
    for order in [2, 5, 8] {
        let rule = GaussLegendre::new(order).unwrap();
        for (lower, upper) in [(0.0, 1.0), (-3.0, 2.0), (2.0, -1.0)] {
            let nodes: Vec<_> = rule.on(lower, upper).collect();
            let way: f64 = upper - lower;
            assert_eq!(nodes.len(), order);
            let mut last = lower;
            for node in &nodes {
                assert!((node.position - last) * way > 0.0, "{lower} {upper}: {node:?}");
                assert!(node.weight * way > 0.0);
                last = node.position;
            }
            assert!((upper - last) * way > 0.0);
            // Powers below twice the order, exactly.
            for power in 0..2 * order as i32 {
                let sum: f64 = nodes.iter().map(|n| n.weight * n.position.powi(power)).sum();
                let n = f64::from(power + 1);
                let exact = (upper.powi(power + 1) - lower.powi(power + 1)) / n;
                let size = upper.abs().max(lower.abs()).powi(power + 1);
                assert!((sum - exact).abs() < 1e-14 * size.max(1.0), "{order} {power}");
            }
        }
    }
}
