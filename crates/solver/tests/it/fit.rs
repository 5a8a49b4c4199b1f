//! Windows and cells chosen for a required accuracy: known contacts have this accuracy.

use carom_halfspace::operator::OperatorError;
use carom_halfspace::{Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_laws::torsion::lubkin::Lubkin;
use carom_solver::{
    Accuracy, ContactProblem, Drive, Driven, Fit, FitError, Frictional, FrictionalError, Outline,
    Shape, Side, Window,
};

/// A shape with its origin at a given point, between two bodies of shear modulus 2.
fn fit(
    shape: &Shape,
    at: [f64; 2],
    friction: f64,
    start: f64,
    accuracy: f64,
    drives: &[Drive],
) -> Result<Fit<Frictional>, FitError<FrictionalError>> {
    let body = Material::from_shear(2.0, 0.0).unwrap();
    let pair = MaterialPair::new(body, body).unwrap();
    let make = |window: &Window| {
        let gap = window.gap(|x, y| shape.height(x - at[0], y - at[1]));
        let friction = Friction::new(friction).unwrap();
        ContactProblem::of_half_spaces(gap.map_err(OperatorError::from)?, pair, friction)
    };
    Accuracy::new(accuracy).unwrap().fit(Frictional::default(), make, [start; 2], drives)
}

fn by_force(force: f64) -> Drive {
    Drive { normal: Driven::Load(force), ..Drive::default() }
}

const BALL: Shape = Shape::Paraboloid { radii: [1.0, 1.0] };

#[test]
fn a_ball_is_found_from_any_start_and_solved_as_asked() {
    // E* = 2 and R = 1: F = (8/3) zeta^1.5.
    for (accuracy, zeta) in [(1e-2, 1e-8), (1e-3, 1e-4), (1e-4, 1.0)] {
        for start in [1e-3, 1.0, 1e4] {
            let drive = by_force(8.0 / 3.0 * f64::powf(zeta, 1.5));
            let fit = fit(&BALL, [0.0; 2], 0.0, start, accuracy, &[drive]).unwrap();
            let error = fit.history.state().shift.zeta / zeta - 1.0;
            println!(
                "{accuracy}: {} cells, {error:.1e}, estimate {:.1e}",
                fit.window.grid().nx(),
                fit.error
            );
            assert!(error.abs() < accuracy && fit.error <= accuracy, "{error}");
            // The window is little larger than the contact.
            let side = fit.window.grid().nx() as f64 * fit.window.grid().dx();
            assert!(side < 2.6 * zeta.sqrt(), "{side}");
        }
    }
}

#[test]
fn a_shifted_ball_of_a_history_is_solved_as_asked() {
    // Cattaneo: f = 0.4, kappa = 1, down to half of the stick radius, and pulled back.
    let to = |xi| Drive::by_shift(Shift { zeta: 0.01, xi, ..Shift::default() });
    let limit = 0.4 * 8.0 / 3.0 * 1e-3;
    let drives = [to(0.0), to(0.003), to(0.0)];
    for accuracy in [1e-2, 1e-3, 1e-4] {
        let fit = fit(&BALL, [0.0; 2], 0.4, 1.0, accuracy, &drives).unwrap();
        // Pulled back by 0.003, with twice the friction from the turn.
        let back = limit * (0.875 - 2.0 * (1.0 - f64::powf(1.0 - 0.375, 1.5)));
        let most = 0.875 * limit;
        for (estimates, exact) in fit.estimates.iter().zip([0.0, most, back]) {
            let error = (estimates.f_x.value - exact) / most;
            println!(
                "{accuracy}: {} cells, {error:.1e}, estimate {:.1e}",
                fit.window.grid().nx(),
                estimates.f_x.error / most
            );
            assert!(error.abs() < accuracy, "{error}");
        }
    }
}

#[test]
fn slender_and_distant_contacts_get_windows_of_their_own() {
    // Radii 1 and 100: the ellipse is 20 times as long as wide.
    let slender = Shape::Paraboloid { radii: [1.0, 100.0] };
    let found = fit(&slender, [0.0; 2], 0.0, 1.0, 1e-3, &[by_force(1e-3)]).unwrap();
    let grid = found.window.grid();
    let ratio = grid.dy() / grid.dx();
    assert!(ratio > 10.0 && ratio < 40.0, "{ratio}");
    // A ball away from the origin.
    let found = fit(&BALL, [0.3, -0.2], 0.0, 1.0, 1e-3, &[by_force(1e-3)]).unwrap();
    let [x, y] = found.window.middle();
    assert!((x - 0.3).abs() < 0.01 && (y + 0.2).abs() < 0.01, "{x} {y}");
    // Twisted: torques are taken about the origin, which stays at the centre.
    let twist = Drive { twist: Driven::Shift(0.001), ..by_force(1e-3) };
    let found = fit(&BALL, [0.03, 0.0], 0.5, 1.0, 1e-2, &[twist]).unwrap();
    assert_eq!(found.window.middle(), [0.0, 0.0]);
}

#[test]
fn a_punch_fills_its_window() {
    // F = 2 E* a zeta with E* = 2.
    let punch = Shape::Punch(Outline::Disc { radius: 0.5 });
    let pressed = Drive::by_shift(Shift { zeta: 0.01, ..Shift::default() });
    let found = fit(&punch, [0.0; 2], 0.0, 1.0, 1e-2, &[pressed]).unwrap();
    let error = found.history.state().load().f_z / 0.02 - 1.0;
    assert!(error.abs() < 1e-2, "{error}");
}

#[test]
fn what_no_window_fits_says_so() {
    let error = |result: Result<Fit<Frictional>, _>| result.err().unwrap();
    let cylinder = Shape::Cylinder { radius: 1.0 };
    let endless = error(fit(&cylinder, [0.0; 2], 0.0, 0.1, 1e-2, &[by_force(1e-3)]));
    assert!(matches!(endless, FitError::Endless { side: Side::Bottom | Side::Top }), "{endless}");
    // An edge that cells cannot resolve, for an accuracy that cannot be reached.
    let punch = Shape::Punch(Outline::Disc { radius: 0.5 });
    let pressed = Drive::by_shift(Shift { zeta: 0.01, ..Shift::default() });
    let error_now = error(fit(&punch, [0.0; 2], 0.0, 1.0, 1e-6, &[pressed]));
    assert!(matches!(error_now, FitError::Unreached { .. }), "{error_now}");
    assert!(error_now.to_string().contains("above 1.0e-6"), "{error_now}");
    // Two grids tell it, and name an accuracy that is reached.
    let FitError::Unreached { cells, possible, .. } = error_now else { panic!("{error_now}") };
    assert!(cells <= 192, "{cells} cells");
    assert!(fit(&punch, [0.0; 2], 0.0, 1.0, possible, &[pressed]).is_ok(), "{possible}");
    // Sliding on any grid.
    let slides = Drive { x: Driven::Load(1.0), ..by_force(1.0) };
    let slides = error(fit(&BALL, [0.0; 2], 0.5, 1.0, 1e-2, &[by_force(1.0), slides]));
    assert!(matches!(slides, FitError::Method(FrictionalError::Slides { .. })), "{slides}");
    // Any window fits separated bodies.
    let apart = Drive::by_shift(Shift { zeta: -1.0, ..Shift::default() });
    assert_eq!(fit(&BALL, [0.0; 2], 0.5, 1.0, 1e-2, &[apart]).unwrap().error, 0.0);
    assert_eq!(Accuracy::new(0.5).unwrap_err().field, "accuracy");
}

#[test]
fn cones_and_twisted_balls_are_solved_as_asked() {
    // F = (2/pi) E* zeta^2/slope with E* = 2: the pressure has no bound, the force has.
    for (slope, zeta) in [(0.1, 1e-3), (0.02, 3.0)] {
        let pressed = Drive::by_shift(Shift { zeta, ..Shift::default() });
        let cone = Shape::Cone { slope };
        let found = fit(&cone, [0.0; 2], 0.0, 1.0, 1e-3, &[pressed]).unwrap();
        let exact = 4.0 / std::f64::consts::PI * zeta * zeta / slope;
        let error = found.history.state().load().f_z / exact - 1.0;
        println!("cone: {} cells, {error:.1e}, {:.1e}", found.window.grid().nx(), found.error);
        assert!(error.abs() < 1e-3, "{error}");
    }
    // Lubkin's twist to a stick radius of 0.8 a; G = 1 of both together.
    let (friction, zeta) = (0.3, 0.04);
    let lubkin = Lubkin::at_stick_radius(0.8).unwrap();
    let (force, a) = (8.0 / 3.0 * f64::powf(zeta, 1.5), f64::sqrt(zeta));
    let omega = lubkin.twist() * friction * force / (a * a);
    let drive = |omega| Drive::by_shift(Shift { zeta, omega, ..Shift::default() });
    for accuracy in [1e-2, 1e-3] {
        let drives = [drive(0.0), drive(omega)];
        let found = fit(&BALL, [0.0; 2], friction, 1.0, accuracy, &drives).unwrap();
        let exact = lubkin.torque() * friction * force * a;
        let error = found.history.state().load().m_z / exact - 1.0;
        println!("twist: {} cells, {error:.1e}, {:.1e}", found.window.grid().nx(), found.error);
        assert!(error.abs() < accuracy, "{error}");
    }
}

/// The first cells are so wide that no centre lies in the contact: it is looked for near the lowest one.
#[test]
fn a_small_contact_away_from_the_origin_is_found() {
    let zeta = 1e-7;
    let pressed = Drive::by_shift(Shift { zeta, ..Shift::default() });
    for at in [[0.31, -0.22], [-0.13, 0.42]] {
        let found = fit(&BALL, at, 0.0, 1.0, 1e-2, &[pressed]).unwrap();
        let force = 8.0 / 3.0 * f64::powf(zeta, 1.5);
        assert!((found.history.state().load().f_z / force - 1.0).abs() < 1e-2);
        let [x, y] = found.window.middle();
        assert!((x - at[0]).hypot(y - at[1]) < 0.2 * zeta.sqrt(), "{x} {y}");
    }
}
