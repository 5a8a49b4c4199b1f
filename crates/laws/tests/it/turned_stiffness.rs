//! The stiffness in a rotated frame compared with shifts and forces rotated separately.

use approx::assert_relative_eq;
use carom_laws::shift::turned_stiffness;
use carom_laws::stiffness::ContactStiffness;

#[test]
fn turned_stiffness_answers_as_the_turned_vectors() {
    let stiffness = ContactStiffness::new(0.8, 0.5, 1.0).unwrap();
    for angle in [0.3_f64, 1.1, -0.7, 2.5] {
        let (s, c) = angle.sin_cos();
        let turned = turned_stiffness(&stiffness, angle);
        // A shift along x of the turned frame, in the axes of the ellipse, and its force there.
        let force = [0.8 * c, 0.5 * s];
        assert_relative_eq!(turned[0][0], c * force[0] + s * force[1], max_relative = 1e-14);
        assert_relative_eq!(turned[1][0], c * force[1] - s * force[0], max_relative = 1e-13);
        assert_eq!(turned[0][1], turned[1][0]);
    }
}
