//! The law of sliders compared with closed forms: within one annulus, and in steady sliding.

use approx::assert_relative_eq;
use carom_laws::sliders::SliderLaw;

#[test]
fn the_outermost_spring_counts_for_its_part_that_touches() {
    // Springs equally stiff in the radius: what sticks is stretched alike up to the edge.
    for edge in [0.76_f64, 0.78, 0.8] {
        let mut law = SliderLaw::new(10, 1.0, 1.0).unwrap();
        law.advance(edge * edge, [0.0, 0.0]).unwrap();
        let force = law.advance(edge * edge, [1e-4, 0.0]).unwrap();
        assert_relative_eq!(force[0], 1.5 * edge * 1e-4, max_relative = 1e-12);
    }
}

#[test]
fn steady_sliding_pulls_along_the_velocity_in_the_plane() {
    // The stiffness along x is g times that along y: a path along (g p, q) in normalised shifts
    // is one along (p, q) in the plane, and so is the force of friction in the end.
    for (g, [p, q]) in [(1.6, [0.6_f64, 0.8]), (0.5, [0.8, -0.6])] {
        let mut law = SliderLaw::new(20, 1.0, g).unwrap();
        law.advance(1.0, [0.0, 0.0]).unwrap();
        let mut force = [0.0; 2];
        for step in 1..=80 {
            let way = 0.3 * f64::from(step);
            force = law.advance(1.0, [g * p * way, q * way]).unwrap();
        }
        assert_relative_eq!(force[0] * q, force[1] * p, max_relative = 1e-6);
        assert_relative_eq!(force[0].hypot(force[1]), 1.0, max_relative = 1e-3);
    }
}
