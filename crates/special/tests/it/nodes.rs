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

#[test]
fn nodes_of_an_interval_ascend_from_its_lower_end() {
    for (lower, upper) in [(2.0, 5.0), (-1.0, 0.5)] {
        let rule = GaussLegendre::new(7).unwrap();
        let nodes: Vec<_> = rule.on(lower, upper).collect();
        assert!(nodes.windows(2).all(|pair| pair[0].position < pair[1].position));
        assert!(nodes[0].position > lower && nodes[6].position < upper);
        // The same interval from its other end: the nodes in the other order.
        let back: Vec<_> = rule.on(upper, lower).collect();
        for (node, back) in nodes.iter().zip(back.iter().rev()) {
            assert!((node.position - back.position).abs() < 1e-15);
            assert!((node.weight + back.weight).abs() < 1e-15);
        }
    }
}
