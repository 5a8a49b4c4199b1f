//! The heat of twist steps against independent values and against many small steps on the same way.

use carom_laws::torsion::history::{TwistHistory, sliding_limit};

/// A contact pressed to the radius 1 and twisted to `twist`.
fn pressed_and_twisted(twist: f64) -> TwistHistory {
    let mut history = TwistHistory::new();
    history.advance(1.0, 0.0).unwrap();
    history.advance(1.0, twist).unwrap();
    history
}

/// `int_0^1 s^n G(s) K(s) ds` and `int_0^1 s^n G(s) ds` times the constants of the heat of a contact
/// that slides and grows: from `3 int s^2 u (dbh - du) ds` with `u = B(s; al)`.
const BY_TWIST: f64 = 0.294_524_311_274_043_1;
const BY_GROWTH: f64 = 0.396_944_474_156_869_1;

#[test]
fn growth_after_a_long_slide_dissipates_what_sliding_friction_takes() {
    // Twist, radius and twist at the end. The stick area is below 1e-6 throughout: the friction
    // does the work al^4 (3 pi/32 dbh - g dal), g = 0.3969.
    for (slide, radius, twist) in
        [(100.0, 1.4, 130.0), (100.0, 1.2, 120.0), (100.0, 1.4, 120.0), (100.0, 1.4, 200.0)]
    {
        let history = pressed_and_twisted(slide);
        let heat = history.dissipation(radius, twist);
        let mean = (radius.powi(5) - 1.0) / 5.0;
        let want = mean * (BY_TWIST * (twist - slide) / (radius - 1.0) - BY_GROWTH);
        let step = (radius - 1.0) + (twist - slide);
        let error = (heat - want).abs() / (sliding_limit(radius) * step);
        assert!(error < 1e-12, "{slide} to {radius}, {twist}: {heat} for {want}");
    }
}
