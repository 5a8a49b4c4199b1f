//! Surfaces, frames, mobility and whole encounters of bodies of any shape.

use carom_geometry::{
    Attitude, BodySide, ContactFrame, FrameError, Height, Inertia, SearchError, Surface,
    SurfaceError, angle_matrix,
};
use carom_halfspace::Material;
use carom_impact::{Body, Collision, CollisionError, Lever, Mobility, Motion};
use carom_laws::curvature::{CurvatureError, PrincipalRadii};
use carom_laws::friction::Friction;
use nalgebra::{Matrix3, Vector3};

use crate::data::{matrix, numbers, public, rows, vector};

fn steel() -> Material {
    Material::from_shear(80e9, 0.3).unwrap()
}

fn friction(f: f64) -> Friction {
    Friction::new(f).unwrap()
}

#[test]
fn ellipsoid_frames() {
    for row in rows("ellipsoid_frames") {
        let number = |key: &str| row[key].as_f64().unwrap();
        let axes: [f64; 3] = numbers(&row["semiaxes"]).try_into().unwrap();
        let point = Vector3::new(number("a"), number("b"), number("c"));
        let derivatives = numbers(&row["derivs_ca_cb_caa_cbb_cab"]);
        let implicit = Surface::ellipsoid(axes).unwrap().local(&point).unwrap();
        let height = Height {
            c: point.z,
            c_a: derivatives[0],
            c_b: derivatives[1],
            c_aa: derivatives[2],
            c_bb: derivatives[3],
            c_ab: derivatives[4],
        };
        let explicit = Surface::explicit_with(3.0, BodySide::Above, move |_| height).unwrap();
        let explicit = explicit.local(&point).unwrap();
        let numeric = move |a: f64, b: f64| {
            let rest = 1.0 - (a / axes[0]).powi(2) - (b / axes[1]).powi(2);
            -axes[2] * rest.sqrt()
        };
        let numeric =
            Surface::explicit(1.0, BodySide::Above, numeric).unwrap().local(&point).unwrap();
        let pi = matrix(&row["Pi"]);
        for (local, tolerance) in [(implicit, 1e-14), (explicit, 1e-14), (numeric, 1e-8)] {
            let [k_x, k_y] = local.curvatures();
            assert!((k_x - number("kx")).abs() < tolerance, "{k_x}");
            assert!((k_y - number("ky")).abs() < tolerance, "{k_y}");
            // z points inward.
            assert!((local.normal() + pi.column(2)).norm() < tolerance);
            let along = local.direction().dot(&pi.column(0)).abs();
            assert!((along - 1.0).abs() < tolerance, "{along}");
            assert!(!local.is_umbilic());
        }
        let angles = angle_matrix(number("alpha"), number("beta"), number("gamma"));
        assert!((angles - pi).amax() < 1e-15, "{}", angles - pi);
        // On a plane the frame is that of the ellipsoid.
        let attitude = Attitude::from_matrix(pi).unwrap();
        let placed = implicit.placed(&Vector3::zeros(), &attitude);
        let table = Surface::plane().local(&Vector3::zeros()).unwrap();
        let frame = ContactFrame::new(
            &implicit,
            &table.placed(&Vector3::zeros(), &Attitude::from_matrix(pi.transpose()).unwrap()),
        );
        let frame = frame.unwrap();
        assert!((frame.z() - pi.column(2)).norm() < 1e-15);
        assert!(frame.x().dot(&pi.column(0)).abs() > 1.0 - 1e-14);
        assert!((2.0 * frame.relative_curvature().a() - number("kx")).abs() < 1e-14);
        assert!((2.0 * frame.relative_curvature().b() - number("ky")).abs() < 1e-14);
        assert!(placed.curvatures() == implicit.curvatures());
    }
}

#[test]
fn mobility_matrices() {
    for row in rows("D_matrices") {
        let lever = |i: usize| {
            let key = |name: &str| format!("{name}{i}");
            let mass = row[key("m")].as_f64();
            let theta: [f64; 3] = numbers(&row[key("theta")]).try_into().unwrap();
            let inertia = mass.map_or(Inertia::FIXED, |mass| Inertia::new(mass, theta).unwrap());
            // Space is the contact frame: Pi turns its components into those of the body.
            let attitude = Attitude::from_matrix(matrix(&row[key("Pi")])).unwrap();
            let arm = attitude.to_space(&vector(&row[format!("R{i}_body")]));
            Lever::new(inertia, &attitude, arm).unwrap()
        };
        let levers = [lever(1), lever(2)];
        let d = Mobility::new(&levers, &Matrix3::identity()).unwrap();
        let expected = matrix(&row["D"]);
        assert!((d.matrix() - expected).amax() < 4e-15 * expected.amax(), "{}", row["name"]);
        // (8.43): D = [R]^T E + 1/m, summed over the bodies.
        let mut sum = Matrix3::zeros();
        for (i, lever) in levers.iter().enumerate() {
            let inverse = row[format!("m{}", i + 1)].as_f64().map_or(0.0, |m| 1.0 / m);
            sum += lever.arm().cross_matrix().transpose() * lever.turning()
                + Matrix3::identity() * inverse;
        }
        assert!((sum - expected).amax() < 4e-15 * expected.amax());
    }
}

#[test]
fn crossed_cylinders_touch_like_a_sphere_on_a_plane() {
    let cylinder = || Surface::cylinder(0.01, 0.06).unwrap();
    let inertia = cylinder().solid(0.14796901398407927).unwrap();
    let quarter = std::f64::consts::FRAC_PI_2;
    let body = |attitude, z: f64| {
        Body::new(cylinder(), steel(), inertia).turned(attitude).at([0.0, 0.0, z]).unwrap()
    };
    let along_x = Attitude::about([0.0, 1.0, 0.0], quarter).unwrap();
    let along_y = Attitude::about([1.0, 0.0, 0.0], quarter).unwrap();
    let upper = body(along_x, 0.02).moving(Motion::new([-0.8, -0.3, -1.0], [0.0; 3]).unwrap());
    let encounter = Collision::touching(upper, body(along_y, 0.0), friction(0.25)).unwrap();
    let gap = encounter.frame().relative_curvature();
    assert!((gap.a() - 50.0).abs() < 1e-10 && (gap.b() - 50.0).abs() < 1e-10);
    let case = &public("coupled_spring_solutions")["crossed_cylinders"];
    assert!((encounter.mobility().matrix() - matrix(&case["D"])).amax() < 1e-12);
    let outcome = encounter.solve().unwrap();
    let after = outcome.rebound().unwrap().contact_velocity_after;
    assert!((after - vector(&case["results"]["coulomb"]["v_end"])).norm() < 1e-8, "{after}");
}

#[test]
fn what_cannot_touch_says_why() {
    let ball = |z: f64| {
        let surface = Surface::sphere(1.0).unwrap();
        let inertia = surface.solid(1.0).unwrap();
        Body::new(surface, steel(), inertia).at([0.0, 0.0, z]).unwrap()
    };
    let plane = || Body::plane(steel());
    let none = Friction::NONE;
    let apart = Collision::touching(ball(1.01), plane(), none).unwrap_err();
    let gap = |error| match error {
        CollisionError::Search(SearchError::NotTouching { gap, .. }) => gap,
        other => panic!("{other}"),
    };
    assert!((gap(apart) - 0.01).abs() < 1e-15);
    assert!((gap(Collision::touching(ball(0.9), plane(), none).unwrap_err()) + 0.1).abs() < 1e-15);
    let off = Collision::at(ball(1.0), plane(), [0.1, 0.0, 0.0], none).unwrap_err();
    assert!(matches!(
        off,
        CollisionError::Search(SearchError::Surface {
            body: 1,
            source: SurfaceError::OffSurface { distance, .. }
        }) if (distance - (1.01_f64.sqrt() - 1.0)).abs() < 1e-15
    ));
    // A corner of a box on a ball.
    let cube = Surface::cuboid([1.0, 1.0, 1.0]).unwrap();
    let solid = cube.solid(1.0).unwrap();
    let cube = Body::new(cube, steel(), solid);
    let diagonal = 1.0 / 3.0_f64.sqrt();
    let at = 0.5 + diagonal;
    let corner = Collision::touching(
        Body::new(Surface::sphere(1.0).unwrap(), steel(), solid).at([at, at, at]).unwrap(),
        cube.clone(),
        none,
    );
    let part = |error| match error {
        CollisionError::Search(SearchError::Surface { source, .. }) => match source {
            SurfaceError::Edge { part } | SurfaceError::Seam { part } => part,
            other => panic!("{other}"),
        },
        other => panic!("{other}"),
    };
    assert_eq!(part(corner.unwrap_err()), "the corner of a box");
    let side = half_turned([0.5 + 0.5_f64.sqrt(), 0.5 + 0.5_f64.sqrt(), 0.1], solid);
    assert_eq!(
        part(Collision::touching(side, cube.clone(), none).unwrap_err()),
        "the edge of a box"
    );
    let top = half_turned([0.1, 0.2, 1.5], solid);
    assert!(Collision::touching(top, cube, none).is_ok());
    // Parallel cylinders.
    let rod = |z: f64| {
        let surface = Surface::capsule(0.5, 2.0).unwrap();
        let inertia = surface.solid(1.0).unwrap();
        Body::new(surface, steel(), inertia)
            .turned(Attitude::about([0.0, 1.0, 0.0], std::f64::consts::FRAC_PI_2).unwrap())
            .at([0.0, 0.0, z])
            .unwrap()
    };
    let line = Collision::touching(rod(1.0), rod(0.0), none).unwrap_err();
    assert!(
        matches!(
            line,
            CollisionError::Search(SearchError::Frame(FrameError::Curvature(
                CurvatureError::LineContact { .. }
            )))
        ),
        "{line}"
    );
    // A ball in a socket of its own radius.
    let radii = PrincipalRadii::sphere(-1.0).unwrap();
    let socket = Surface::given([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], radii).unwrap();
    let socket = Body::new(socket, steel(), Inertia::FIXED);
    let fit = Collision::at(ball(1.0), socket, [0.0; 3], none).unwrap_err();
    assert!(
        matches!(fit, CollisionError::Search(SearchError::Frame(FrameError::Curvature(_)))),
        "{fit}"
    );
    let held = Body::new(Surface::sphere(1.0).unwrap(), steel(), Inertia::FIXED);
    let held = Collision::touching(held.at([0.0, 0.0, 1.0]).unwrap(), plane(), none).unwrap_err();
    assert_eq!(held, CollisionError::BothHeldFast);
    let same_side = Collision::at(ball(-1.0), plane(), [0.0; 3], none).unwrap_err();
    assert!(matches!(
        same_side,
        CollisionError::Search(SearchError::Frame(FrameError::NotOpposed { .. }))
    ));
}

fn half_turned(centre: [f64; 3], inertia: Inertia) -> Body {
    Body::new(Surface::sphere(1.0).unwrap(), steel(), inertia).at(centre).unwrap()
}

#[test]
fn shapes_rest_on_a_plane_where_they_should() {
    let tilt = Attitude::about([1.0, 0.3, 0.0], 0.7).unwrap();
    let squashed =
        |p: &Vector3<f64>| (p.x / 3.0).powi(2) + (p.y / 2.0).powi(2) + (p.z / 1.5).powi(2) - 1.0;
    let egg = Surface::ellipsoid([3.0, 2.0, 1.5]).unwrap();
    let own_egg = Surface::implicit(2.0, squashed).unwrap();
    let mut points = Vec::new();
    for surface in [egg, own_egg] {
        let normal = tilt.to_body(&Vector3::z());
        // h = |(A n_a, B n_b, C n_c)| is the height of the centre.
        let height = Vector3::new(3.0 * normal.x, 2.0 * normal.y, 1.5 * normal.z).norm();
        let inertia = Inertia::new(1.0, [1.25, 2.25, 2.6]).unwrap();
        let body =
            Body::new(surface, steel(), inertia).turned(tilt).at([0.0, 0.0, height]).unwrap();
        let encounter = Collision::touching(body, Body::plane(steel()), Friction::NONE).unwrap();
        assert!(encounter.point().z.abs() < 1e-9);
        let curvature = encounter.frame().relative_curvature();
        points.push((encounter.point(), curvature.a(), curvature.b()));
    }
    assert!((points[0].0 - points[1].0).norm() < 1e-8);
    assert!((points[0].1 / points[1].1 - 1.0).abs() < 1e-8);
    assert!((points[0].2 / points[1].2 - 1.0).abs() < 1e-8);
    // A capsule and a torus.
    let capsule = Surface::capsule(0.5, 2.0).unwrap();
    let inertia = capsule.shell(1.0).unwrap();
    let down = tilt.to_space(&Vector3::z()).z;
    let body = Body::new(capsule, steel(), inertia).turned(tilt);
    let body = body.at([0.0, 0.0, 0.5 + down.abs()]).unwrap();
    let encounter = Collision::touching(body, Body::plane(steel()), Friction::NONE).unwrap();
    assert!((encounter.frame().relative_curvature().a() - 1.0).abs() < 1e-14);
    let torus = Surface::torus(2.0, 0.5).unwrap();
    let inertia = torus.solid(1.0).unwrap();
    let sin = tilt.to_body(&Vector3::z()).xy().norm();
    let body = Body::new(torus, steel(), inertia).turned(tilt);
    let body = body.at([0.0, 0.0, 0.5 + 2.0 * sin]).unwrap();
    let encounter = Collision::touching(body, Body::plane(steel()), Friction::NONE).unwrap();
    let curvature = encounter.frame().relative_curvature();
    assert!((2.0 * curvature.a() - 2.0).abs() < 1e-13);
    assert!((2.0 * curvature.b() - sin / (2.0 + 0.5 * sin)).abs() < 1e-13);
}
