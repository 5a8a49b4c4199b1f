//! Attitudes, contact frames and mobility against geometry and rigid-body mechanics.

mod random;

use carom_impact::{
    Attitude, ContactFrame, Encounter, EncounterError, FrameError, Inertia, Lever, Mobility,
    Motion, Outcome, PlacedBody, SearchError, Surface, SurfaceError,
};
use carom_laws::curvature::{CurvatureError, PrincipalRadii};
use carom_laws::friction::Friction;
use nalgebra::{Matrix3, Vector3};
use random::{Numbers, steel};

#[test]
fn quaternion_and_three_angles_are_one_attitude() {
    let mut numbers = Numbers(4);
    for _ in 0..50 {
        let [alpha, beta, gamma] = [(); 3].map(|()| numbers.between(-3.0, 3.0));
        let half = |angle: f64| (0.5 * angle).sin_cos();
        let ((sa, ca), (sb, cb), (sg, cg)) = (half(alpha), half(beta), half(gamma));
        // Product of the quaternions of turns about z, the new y, the newest x.
        let quaternion = [
            cg * cb * ca + sg * sb * sa,
            cg * cb * sa - sg * sb * ca,
            cg * sb * ca + sg * cb * sa,
            sg * cb * ca - cg * sb * sa,
        ];
        let by_quaternion = Attitude::from_quaternion(quaternion).unwrap();
        let by_angles = Attitude::from_angles(alpha, beta, gamma).unwrap();
        assert!((by_quaternion.matrix() - by_angles.matrix()).amax() < 2e-15);
        // e_a in space is the first row of (8.5).
        let e_a = by_angles.to_space(&Vector3::x());
        let expected =
            Vector3::new(beta.cos() * gamma.cos(), beta.cos() * gamma.sin(), -beta.sin());
        assert!((e_a - expected).norm() < 1e-15);
    }
}

#[test]
fn umbilic_points_of_a_triaxial_ellipsoid() {
    let [a, b, c] = [3.0_f64, 2.0, 1.5];
    let egg = Surface::ellipsoid([a, b, c]).unwrap();
    let share = |p: f64, q: f64| (p * p - q * q) / (a * a - c * c);
    for (s, t) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let point = Vector3::new(s * a * share(a, b).sqrt(), 0.0, t * c * share(b, c).sqrt());
        let local = egg.local(&point).unwrap();
        let [k_1, k_2] = local.curvatures();
        // There k = ac/b^3 in every direction.
        assert!((k_1 - a * c / b.powi(3)).abs() < 1e-14 && k_1 - k_2 < 1e-14 && k_1 >= k_2);
        assert!(local.is_umbilic());
        assert!(local.direction().dot(&local.normal()).abs() < 1e-15);
        // Next to it the directions part, and stay at right angles.
        let beside = (point + Vector3::new(0.01, 0.02, 0.0)).component_div(&Vector3::new(a, b, c));
        let beside = beside.normalize().component_mul(&Vector3::new(a, b, c));
        let beside = egg.local(&beside).unwrap();
        assert!(!beside.is_umbilic());
        assert!(beside.direction().dot(&beside.direction_across()).abs() < 1e-15);
    }
    assert!(
        Surface::sphere(2.0).unwrap().local(&Vector3::new(0.0, 2.0, 0.0)).unwrap().is_umbilic()
    );
}

// Height of an ellipsoid over its tangent plane at the origin, on the line through `across` along
// z, on the side of its body (sign).
fn height(semi_axes: [f64; 3], body: &PlacedBody, across: &Vector3<f64>, z: &Vector3<f64>) -> f64 {
    let axes = Vector3::from(semi_axes);
    let scaled = |v: &Vector3<f64>| body.attitude().to_body(v).component_div(&axes);
    let (p, d) = (scaled(&(across - body.centre())), scaled(z));
    // |p + t d|^2 = 1: the root next to zero.
    let (half, rest) = (p.dot(&d), p.norm_squared() - 1.0);
    let root = (half * half - d.norm_squared() * rest).sqrt();
    rest / (-half + if half < 0.0 { root } else { -root })
}

#[test]
fn the_gap_is_a_x_squared_plus_b_y_squared() {
    let mut numbers = Numbers(5);
    for _ in 0..40 {
        let axes = [(); 2].map(|()| [(); 3].map(|()| numbers.between(0.5, 2.0)));
        let normal = numbers.direction();
        let place = |axes: [f64; 3], outward: Vector3<f64>, turn: Attitude| {
            let scaled = Vector3::from(axes).component_mul(&turn.to_body(&outward));
            let support =
                turn.to_space(&Vector3::from(axes).component_mul(&scaled)) / scaled.norm();
            let surface = Surface::ellipsoid(axes).unwrap();
            let inertia = surface.solid(1.0).unwrap();
            PlacedBody::new(surface, steel(), inertia).turned(turn).at((-support).into()).unwrap()
        };
        let one = place(axes[0], -normal, numbers.attitude());
        let two = place(axes[1], normal, numbers.attitude());
        let encounter = Encounter::at(one.clone(), two.clone(), [0.0; 3], Friction::NONE).unwrap();
        let frame = encounter.frame();
        let gap = frame.relative_curvature();
        assert!(gap.a() >= gap.b() && gap.b() > 0.0);
        assert!((frame.axes() * frame.axes().transpose() - Matrix3::identity()).amax() < 1e-15);
        assert!(frame.axes().determinant() > 0.0 && (frame.z() - normal).norm() < 1e-14);
        // At a tenth of the way the odd terms vanish in the mean of both sides.
        let at = |x: f64, y: f64| {
            let across = frame.x() * x + frame.y() * y;
            height(axes[0], &one, &across, &frame.z()) - height(axes[1], &two, &across, &frame.z())
        };
        let mean = |x: f64, y: f64| 0.5 * (at(x, y) + at(-x, -y));
        let h = 1e-3;
        let scale = gap.a() * h * h;
        assert!((mean(h, 0.0) / scale - 1.0).abs() < 1e-4);
        assert!((mean(0.0, h) - gap.b() * h * h).abs() < 1e-4 * scale);
        // No xy term.
        let twist = mean(h, h) - mean(h, -h);
        assert!(twist.abs() < 1e-4 * scale, "{:e}", twist / scale);
    }
}

#[test]
fn levers_follow_newton_and_euler() {
    let mut numbers = Numbers(6);
    for _ in 0..50 {
        let inertia =
            Inertia::new(numbers.between(0.1, 5.0), [(); 3].map(|()| numbers.between(1.0, 1.9)))
                .unwrap();
        let (attitude, arm) = (numbers.attitude(), numbers.direction() * numbers.between(0.1, 3.0));
        let impulse = numbers.direction() * numbers.between(0.1, 3.0);
        let lever = Lever::new(inertia, &attitude, arm).unwrap();
        let moments = Matrix3::from_diagonal(&Vector3::from(inertia.moments()));
        let tensor = attitude.matrix() * moments * attitude.matrix().transpose();
        let spin = tensor.lu().solve(&arm.cross(&impulse)).unwrap();
        // (8.36), (8.43): E J; (8.31): the velocity of the point.
        assert!((lever.turning() * impulse - spin).norm() < 1e-14 * (1.0 + spin.norm()));
        let velocity = impulse / inertia.mass() + spin.cross(&arm);
        assert!((lever.mobility() * impulse - velocity).norm() < 1e-13 * (1.0 + velocity.norm()));
    }
}

#[test]
fn a_body_on_a_pivot_turns_and_a_guided_one_does_not() {
    // Infinite mass with finite moments, and the other way round.
    let (far, free) = (f64::INFINITY, [0.5, 0.6, 0.7]);
    let arm = Vector3::new(0.0, 0.8, -0.5);
    let push = Vector3::new(0.3, -0.2, 1.0);
    let at = |inertia| Lever::new(inertia, &Attitude::ALIGNED, arm).unwrap();
    let pivot = at(Inertia::new(far, free).unwrap());
    let spin = arm.cross(&push).component_div(&Vector3::from(free));
    assert!((pivot.turning() * push - spin).norm() < 1e-15);
    assert!((pivot.mobility() * push - spin.cross(&arm)).norm() < 1e-15);
    // Nothing moves along the arm: alone it has no mobility, with a free body it has.
    let held = at(Inertia::FIXED);
    assert_eq!(held.mobility(), Matrix3::zeros());
    let axes = Matrix3::identity();
    assert_eq!(Mobility::new(&[held, held], &axes).unwrap_err().field, "determinant of mobility D");
    let guided = at(Inertia::new(2.0, [far; 3]).unwrap());
    assert_eq!(guided.mobility(), Matrix3::identity() * 0.5);
    assert_eq!(guided.turning(), Matrix3::zeros());
    assert!(Mobility::new(&[pivot, guided], &axes).is_ok());
    // A whole encounter: a pivoted ellipsoid hit off its centre by a ball.
    let egg = Surface::ellipsoid([1.0, 0.8, 0.6]).unwrap();
    let point = Vector3::new(0.5, 0.0, 0.6 * 0.75_f64.sqrt());
    let normal = egg.local(&point).unwrap().normal();
    let swing = PlacedBody::new(egg, steel(), Inertia::new(far, free).unwrap());
    let ball = Surface::sphere(0.3).unwrap();
    let inertia = ball.solid(0.1).unwrap();
    let ball = PlacedBody::new(ball, steel(), inertia)
        .at((point + normal * 0.3).into())
        .unwrap()
        .moving(Motion::new((-normal).into(), [0.0; 3]).unwrap());
    let encounter = Encounter::find(ball, swing, Friction::new(0.3).unwrap()).unwrap();
    let Outcome::Rebound(rebound) = encounter.solve().unwrap() else { panic!("no impact") };
    assert_eq!(rebound.motions[1].velocity, Vector3::zeros());

    let spin = point.cross(&-rebound.impulse).component_div(&Vector3::from(free));
    assert!((rebound.motions[1].spin - spin).norm() < 1e-13 * spin.norm());
    assert!(spin.norm() > 0.01);
    let kept = rebound.energy.after + rebound.energy.dissipated;
    assert!((kept / rebound.energy.before - 1.0).abs() < 1e-14);
}

#[test]
fn bad_input_is_named_with_its_value() {
    let norm = Attitude::from_quaternion([1.0, 0.5, 0.5, 0.5]).unwrap_err();
    assert_eq!((norm.field, norm.value), ("quaternion norm", 1.75_f64.sqrt()));
    // No mass distribution has 3 > 1 + 1.9.
    let triangle = Inertia::new(1.0, [1.0, 3.0, 1.9]).unwrap_err();
    assert_eq!((triangle.field, triangle.value), ("moment of inertia", 3.0));
    assert!(triangle.allowed.contains("sum of the other two"));
    assert!(Inertia::new(1.0, [1.0, 2.9, 1.9]).is_ok());
    let field = |mass, moments| Inertia::new(mass, moments).unwrap_err().field;
    assert_eq!(field(0.0, [1.0; 3]), "mass");
    assert_eq!(field(f64::NAN, [1.0; 3]), "mass");
    assert_eq!(field(1.0, [1.0, -1.0, 1.0]), "moment of inertia");
    assert_eq!(field(1.0, [1.0, f64::INFINITY, 1.0]), "moment of inertia");
    // Off the surface by 0.25, and where a gradient vanishes.
    let egg = Surface::ellipsoid([1.0, 1.0, 0.5]).unwrap();
    match egg.local(&Vector3::new(0.0, 0.0, 0.50001)) {
        Err(SurfaceError::OffSurface { point, distance, allowed }) => {
            assert_eq!(point, [0.0, 0.0, 0.50001]);
            assert!((distance - 1e-5).abs() < 1e-9 && allowed == 1e-6);
        }
        other => panic!("{other:?}"),
    }
    let cone = Surface::implicit(1.0, |p| p.xy().norm_squared() - p.z * p.z).unwrap();
    let tip = cone.local(&Vector3::zeros()).unwrap_err();
    assert!(matches!(tip, SurfaceError::Singular { .. }), "{tip}");
    // A ball in a tighter socket: B = (1/R_1 - 1/R_2)/2 < 0.
    let ball = Surface::sphere(1.0).unwrap().local(&-Vector3::z()).unwrap();
    let socket = |radius: f64| {
        let radii = PrincipalRadii::sphere(-radius).unwrap();
        let surface = Surface::given([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], radii).unwrap();
        surface.local(&Vector3::zeros()).unwrap()
    };
    match ContactFrame::new(&ball, &socket(0.8)) {
        Err(FrameError::Curvature(CurvatureError::Conforming { a, b })) => {
            assert!((a + 0.125).abs() < 1e-15 && (b + 0.125).abs() < 1e-15);
        }
        other => panic!("{other:?}"),
    }
    assert!(ContactFrame::new(&ball, &socket(1.25)).is_ok());
    // Apart, with the gap; at a point off both, with the body's number.
    let sphere = Surface::sphere(1.0).unwrap();
    let inertia = sphere.solid(1.0).unwrap();
    let lifted = PlacedBody::new(sphere, steel(), inertia).at([0.0, 0.0, 1.5]).unwrap();
    let plane = PlacedBody::plane(steel());
    let apart = Encounter::find(lifted.clone(), plane.clone(), Friction::NONE).unwrap_err();
    assert_eq!(apart, EncounterError::Search(SearchError::NotTouching { gap: 0.5, allowed: 1e-6 }));
    let off = Encounter::at(lifted, plane, [0.0, 0.0, 0.5], Friction::NONE).unwrap_err();
    assert!(matches!(
        off,
        EncounterError::Search(SearchError::Surface {
            body: 2,
            source: SurfaceError::OffSurface { distance: 0.5, .. }
        })
    ));
}
