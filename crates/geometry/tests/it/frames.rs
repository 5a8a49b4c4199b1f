//! Attitudes and contact frames compared with elementary geometry.

use crate::random::{attitude, direction};
use carom_drawn::{Draw as _, Splitmix};
use carom_geometry::curvature::{CurvatureError, PrincipalRadii};
use carom_geometry::{
    Attitude, ContactFrame, ContactPoint, FrameError, Inertia, Placed, SearchError, Surface,
    SurfaceError,
};
use nalgebra::{Matrix3, Vector3};

#[test]
fn quaternion_and_three_angles_are_one_attitude() {
    let mut numbers = Splitmix(4);
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
fn height(semi_axes: [f64; 3], body: &Placed, across: &Vector3<f64>, z: &Vector3<f64>) -> f64 {
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
    let mut numbers = Splitmix(5);
    for _ in 0..40 {
        let axes = [(); 2].map(|()| [(); 3].map(|()| numbers.between(0.5, 2.0)));
        let normal = direction(&mut numbers);
        let place = |axes: [f64; 3], outward: Vector3<f64>, turn: Attitude| {
            let scaled = Vector3::from(axes).component_mul(&turn.to_body(&outward));
            let support =
                turn.to_space(&Vector3::from(axes).component_mul(&scaled)) / scaled.norm();
            let surface = Surface::ellipsoid(axes).unwrap();
            Placed::new(surface).turned(turn).at((-support).into()).unwrap()
        };
        let one = place(axes[0], -normal, attitude(&mut numbers));
        let two = place(axes[1], normal, attitude(&mut numbers));
        let contact = ContactPoint::at(&one, &two, [0.0; 3]).unwrap();
        let frame = contact.frame();
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
    let lifted = Placed::new(sphere).at([0.0, 0.0, 1.5]).unwrap();
    let plane = Placed::new(Surface::plane());
    let apart = ContactPoint::find(&lifted, &plane).unwrap_err();
    assert_eq!(apart, SearchError::NotTouching { gap: 0.5, allowed: 1e-6 });
    let off = ContactPoint::at(&lifted, &plane, [0.0, 0.0, 0.5]).unwrap_err();
    assert!(matches!(
        off,
        SearchError::Surface { body: 2, source: SurfaceError::OffSurface { distance: 0.5, .. } }
    ));
}

/// Normals may deviate from opposite ones by 1e-5: two spheres whose points of contact are tilted by less and by more,
/// in every direction, whichever is named first.
#[test]
fn normals_that_are_not_opposite_are_refused_from_the_stated_angle_on() {
    let ball = Surface::sphere(2.0).unwrap();
    let at = |direction: Vector3<f64>| ball.local(&(2.0 * direction.normalize())).unwrap();
    for turn in 0..8 {
        let (sine, cosine) = (0.8 * f64::from(turn)).sin_cos();
        for (tilt, is_refused) in [(0.5e-5, false), (0.99e-5, false), (1.01e-5, true), (2e-5, true)]
        {
            let (one, two) = (at(Vector3::z()), at(Vector3::new(tilt * cosine, tilt * sine, -1.0)));
            for frame in [ContactFrame::new(&one, &two), ContactFrame::new(&two, &one)] {
                match frame {
                    Ok(_) => assert!(!is_refused, "{tilt}"),
                    Err(FrameError::NotOpposed { angle }) => {
                        assert!(is_refused && (angle / tilt - 1.0).abs() < 1e-3, "{tilt} {angle}");
                    }
                    Err(other) => panic!("{other}"),
                }
            }
        }
    }
}

/// The way along a line through the centre is the distance less the radius, as far as twice the size of the body.
#[test]
fn a_line_meets_a_sphere_at_its_distance_less_its_radius() {
    let (radius, direction) = (0.7, Vector3::new(2.0, -1.0, 2.0) / 3.0);
    let ball = Placed::new(Surface::sphere(radius).unwrap()).at([1.0, 2.0, 3.0]).unwrap();
    let from = |gap: f64| Vector3::new(1.0, 2.0, 3.0) - (radius + gap) * direction;
    for part in [-0.9, -0.2, 0.01, 0.3, 0.6, 1.0, 1.5, 1.9] {
        let way = ball.entry(&from(part * radius), &direction).unwrap();
        assert!((way - part * radius).abs() < 1e-14, "{part}: {way}");
    }
    assert!(ball.entry(&from(9.0 * radius), &direction).is_none());
}

/// A ball comes along a line to a ball anywhere in space: they touch on the line of their centres, as far from each as its
/// radius.
#[test]
fn what_approaches_touches_where_both_bodies_are() {
    let ball = |radius, centre: [f64; 3]| {
        Placed::new(Surface::sphere(radius).unwrap()).at(centre).unwrap()
    };
    let (one, two) = (ball(1.0, [3.0, -5.0, 7.8]), ball(2.0, [3.0, -5.0, 2.0]));
    let (moved, touch) =
        ContactPoint::approaching(&one, &two, &Vector3::new(0.0, 0.0, -0.3)).unwrap();
    for (found, wanted) in [
        (moved.centre(), Vector3::new(3.0, -5.0, 5.0)),
        (touch.point(), Vector3::new(3.0, -5.0, 4.0)),
        (touch.arms()[0], Vector3::new(0.0, 0.0, -1.0)),
        (touch.arms()[1], Vector3::new(0.0, 0.0, 2.0)),
    ] {
        assert!((found - wanted).norm() < 1e-9, "{found} {wanted}");
    }
}
