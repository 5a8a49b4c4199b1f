//! Places where a ball touches a surface of triangles, compared with the distances of all triangles, closed forms, rigid
//! motions and copies.

use crate::random::{attitude, direction};
use carom_drawn::{Draw as _, Splitmix};
use carom_geometry::mesh::{MeshError, Part, Place, Search, TriangleMesh};
use nalgebra::Vector3;

type Triangle = [[f64; 3]; 3];

const FREE: [f64; 3] = [0.0; 3];
const SMOOTH: f64 = 0.17;

fn point(numbers: &mut Splitmix) -> Vector3<f64> {
    Vector3::from_fn(|_, _| numbers.signed())
}

fn triangle(corners: [Vector3<f64>; 3]) -> Triangle {
    corners.map(Into::into)
}

/// Triangles anywhere in a cube.
fn soup(count: usize, numbers: &mut Splitmix) -> Vec<Triangle> {
    (0..count).map(|_| triangle([(); 3].map(|()| point(numbers)))).collect()
}

/// A sheet over a grid, two triangles for each of its cells.
fn sheet(places: &[f64], height: impl Fn(usize, usize) -> f64) -> Vec<Triangle> {
    let at = |i, k| Vector3::new(places[i], places[k], height(i, k));
    let cells = (1..places.len()).flat_map(|i| (1..places.len()).map(move |k| (i, k)));
    let two = |(i, k): (usize, usize)| {
        let [a, b, c, d] = [at(i - 1, k - 1), at(i, k - 1), at(i, k), at(i - 1, k)];
        [triangle([a, b, c]), triangle([a, c, d])]
    };
    cells.flat_map(two).collect()
}

fn box_of(half: f64) -> Vec<Triangle> {
    let side = |axis: usize, at: f64| {
        let corner = |u: f64, v: f64| {
            let mut corner = Vector3::repeat(at * half);
            (corner[(axis + 1) % 3], corner[(axis + 2) % 3]) = (u * half, v * half);
            corner
        };
        let [a, b, c, d] =
            [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(u, v)| corner(u, v));
        [triangle([a, b, c]), triangle([a, c, d])]
    };
    (0..3).flat_map(|axis| [side(axis, -1.0), side(axis, 1.0)]).flatten().collect()
}

fn made(triangles: &[Triangle]) -> TriangleMesh {
    TriangleMesh::new(triangles, SMOOTH, FREE).unwrap()
}

fn places(mesh: &TriangleMesh, center: Vector3<f64>, reach: f64) -> Vec<Place> {
    mesh.places(center, reach, &mut Search::default()).unwrap().to_vec()
}

/// The distance of a triangle by its barycentric coordinates, or that of the nearest side.
fn distance(of: &Triangle, from: Vector3<f64>) -> f64 {
    let [a, b, c] = of.map(Vector3::from);
    let (u, v, w) = (b - a, c - a, from - a);
    let normal = u.cross(&v);
    let square = normal.norm_squared();
    let (second, third) = (w.cross(&v).dot(&normal) / square, u.cross(&w).dot(&normal) / square);
    if second >= 0.0 && third >= 0.0 && second + third <= 1.0 {
        return w.dot(&normal).abs() / square.sqrt();
    }
    let side = |from_1: Vector3<f64>, to: Vector3<f64>| {
        let along = to - from_1;
        let part = ((from - from_1).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
        (from - from_1 - part * along).norm()
    };
    side(a, b).min(side(b, c)).min(side(c, a))
}

fn least(triangles: &[Triangle], from: Vector3<f64>) -> f64 {
    triangles.iter().map(|of| distance(of, from)).fold(f64::INFINITY, f64::min)
}

#[test]
fn the_nearest_place_has_the_least_distance_of_all_triangles() {
    let (mut numbers, mut touched) = (Splitmix(11), 0);
    let mut search = Search::default();
    for count in [1, 2, 5, 40, 300] {
        let mut triangles = soup(count, &mut numbers);
        triangles.extend(sheet(&[-1.0, -0.3, 0.1, 0.7, 1.0], |i, k| 0.1 * (i * k % 3) as f64));
        let mesh = made(&triangles);
        for _ in 0..400 {
            let (center, reach) = (1.5 * point(&mut numbers), numbers.log_between(0.01, 1.0));
            let exact = least(&triangles, center);
            let found = mesh.places(center, reach, &mut search).unwrap();
            let nearest = found.iter().map(|place| place.distance).fold(f64::INFINITY, f64::min);
            assert_eq!(exact <= reach, nearest <= reach, "{exact} {nearest} {reach}");
            assert!(exact > reach || (nearest - exact).abs() < 1e-12, "{exact} {nearest}");
            for (i, place) in found.iter().enumerate() {
                touched += 1;
                assert!(place.distance <= reach && (place.normal.norm() - 1.0).abs() < 1e-14);
                assert!((place.point + place.distance * place.normal - center).norm() < 1e-12);
                assert!(least(&triangles, place.point) < 1e-12, "on the surface");
                // The triangles that the point lies on are no nearer.
                let its = triangles.iter().filter(|of| distance(of, place.point) < 1e-12);
                assert!(its.map(|of| distance(of, center)).all(|off| off > place.distance - 1e-12));
                let others = &found[..i];
                assert!(others.iter().all(|one| one.normal.angle(&place.normal) > 0.999 * SMOOTH));
            }
        }
    }
    assert!(touched > 2000, "{touched}");
}

#[test]
fn a_ball_outside_a_box_touches_where_its_coordinates_leave_it() {
    let (mut numbers, mesh) = (Splitmix(12), made(&box_of(0.5)));
    for _ in 0..2000 {
        let center = 2.0 * point(&mut numbers);
        let nearest = center.map(|x| x.clamp(-0.5, 0.5));
        let outside = (0..3).filter(|k| nearest[*k] != center[*k]).count();
        if outside == 0 {
            continue;
        }
        let [place] = places(&mesh, center, 1.001 * (center - nearest).norm())[..] else {
            panic!("more or less than one place at {center}")
        };
        let parts = [Part::Face, Part::Edge, Part::Corner];
        assert_eq!((place.part, place.is_sharp), (parts[outside - 1], outside > 1));
        assert!((place.point - nearest).norm() < 1e-15);
        assert!((place.normal - (center - nearest).normalize()).norm() < 1e-14);
        let [one, two] = mesh.ends(&place);
        let off = [(place.point - one).norm(), (place.point - two).norm(), (two - one).norm()];
        assert!(outside != 2 || (off[0] + off[1] - off[2]).abs() < 1e-15 && off[2] == 1.0);
        assert!(outside != 3 || off == [0.0; 3]);
    }
    let inside = places(&mesh, Vector3::new(0.3, -0.35, 0.1), 0.3);
    assert_eq!(inside.iter().map(|place| place.normal).collect::<Vec<_>>().len(), 2);
    assert!(inside.iter().all(|place| place.part == Part::Face));
}

#[test]
fn a_plane_of_many_triangles_is_one_plane() {
    let mut numbers = Splitmix(13);
    let mut at = -1.0;
    let knots: Vec<f64> = (0..20)
        .map(|_| {
            at += numbers.between(0.05, 0.15);
            at
        })
        .collect();
    let turn = attitude(&mut numbers);
    let turned = |of: Triangle| of.map(|corner| turn.to_space(&corner.into()).into());
    let mesh = made(&sheet(&knots, |_, _| 0.0).into_iter().map(turned).collect::<Vec<_>>());
    let normal = turn.to_space(&Vector3::z());
    let (low, high) = (knots[0] + 0.01, knots[19] - 0.01);
    let mut fixed = None;
    for _ in 0..500 {
        // Anywhere, or over an edge or a corner of the triangles.
        let [x, y] = [(); 2].map(|()| match numbers.below(2) {
            0 => numbers.between(low, high),
            _ => knots[1 + numbers.below(18)],
        });
        let height = numbers.sign() * numbers.between(0.001, 0.3);
        let center = turn.to_space(&Vector3::new(x, y, height));
        let [place] = places(&mesh, center, 0.3)[..] else { panic!("not one place") };
        assert_eq!((place.part, place.is_sharp), (Part::Face, false));
        assert!((place.distance - height.abs()).abs() < 1e-14);
        assert!((place.normal - height.signum() * normal).norm() < 1e-14);
        // The same bits wherever it touches.
        let same = (mesh.ends(&place), height.signum() * place.normal);
        assert_eq!(*fixed.get_or_insert(same), same);
    }
}

/// An octahedron whose triangles were divided by four so many times, on the unit sphere.
fn sphere(times: u32) -> Vec<Triangle> {
    let sides = [-1.0, 1.0];
    let eighth = |x: f64, y: f64, z: f64| [x * Vector3::x(), y * Vector3::y(), z * Vector3::z()];
    let mut all: Vec<_> = sides
        .iter()
        .flat_map(|x| sides.iter().flat_map(move |y| sides.map(|z| eighth(*x, *y, z))))
        .collect();
    for _ in 0..times {
        let four = |[a, b, c]: [Vector3<f64>; 3]| {
            let [d, e, f] = [a + b, b + c, c + a].map(|middle| middle.normalize());
            [[a, d, f], [d, b, e], [f, e, c], [d, e, f]]
        };
        all = all.into_iter().flat_map(four).collect();
    }
    all.into_iter().map(triangle).collect()
}

#[test]
fn a_fine_sphere_is_touched_at_one_place() {
    let (mut numbers, triangles) = (Splitmix(14), sphere(4));
    let (mesh, deepest) = (made(&triangles), 1.0 - least(&triangles, Vector3::zeros()));
    for _ in 0..1000 {
        let way = direction(&mut numbers);
        // From outside, and from inside with a smaller ball.
        for (center, normal) in [(1.1 * way, way), (0.8 * way, -way)] {
            let [place] = places(&mesh, center, 0.21)[..] else { panic!("not one place") };
            assert!(place.normal.angle(&normal) < SMOOTH && !place.is_sharp);
            assert!((place.distance - (center.norm() - 1.0).abs()).abs() < deepest + 1e-12);
        }
    }
}

/// The places in an order of their own, which no order of triangles decides.
fn sorted(
    mut places: Vec<Place>,
    back: impl Fn(&Vector3<f64>) -> Vector3<f64>,
) -> Vec<(Part, [f64; 7], bool)> {
    let told = |place: Place| {
        let (point, normal) = (back(&place.point), back(&place.normal));
        let [x, y, z] = point.into();
        let [a, b, c] = normal.into();
        (place.part, [place.distance, x, y, z, a, b, c], place.is_sharp)
    };
    places.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    places.into_iter().map(told).collect()
}

#[track_caller]
fn assert_same(one: &[(Part, [f64; 7], bool)], two: &[(Part, [f64; 7], bool)]) {
    assert_eq!(one.len(), two.len(), "{one:?} {two:?}");
    for (a, b) in one.iter().zip(two) {
        let off = a.1.iter().zip(&b.1).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        assert!((a.0, a.2) == (b.0, b.2) && off < 1e-10, "{a:?} {b:?}");
    }
}

#[test]
fn turned_mirrored_and_permuted_triangles_have_the_same_places() {
    let (mut numbers, mut touched) = (Splitmix(15), 0);
    for _ in 0..20 {
        let mut triangles = soup(30, &mut numbers);
        let mut heights = || 0.2 * numbers.part();
        let heights: Vec<f64> = (0..16).map(|_| heights()).collect();
        triangles.extend(sheet(&[-0.9, -0.2, 0.3, 0.8], |i, k| heights[4 * i + k]));
        let turn = attitude(&mut numbers);
        let mirror = |x: &Vector3<f64>| Vector3::new(-x.x, x.y, x.z);
        let moved = |of: &Triangle| of.map(|at| turn.to_space(&mirror(&at.into())).into());
        let mut other: Vec<Triangle> = triangles.iter().map(moved).collect();
        for n in 0..other.len() {
            let (with, by) = (numbers.below(other.len()), numbers.below(3));
            other.swap(n, with);
            other[n].rotate_left(by);
        }
        let (mesh, other) = (made(&triangles), made(&other));
        for _ in 0..200 {
            let (center, reach) = (point(&mut numbers), numbers.between(0.05, 0.4));
            let one = sorted(places(&mesh, center, reach), |x| *x);
            let center = turn.to_space(&mirror(&center));
            let two = sorted(places(&other, center, reach), |x| mirror(&turn.to_body(x)));
            assert_same(&one, &two);
            touched += one.len();
        }
    }
    assert!(touched > 2000, "{touched}");
}

#[test]
fn a_surface_that_repeats_itself_is_that_of_nine_copies() {
    let mut numbers = Splitmix(16);
    // Sums of the coordinates of copies are exact.
    let knots: Vec<f64> = (0..=8).map(|k| f64::from(k) / 8.0).collect();
    let heights: Vec<f64> = (0..64).map(|_| numbers.below(12) as f64 / 64.0).collect();
    let own = sheet(&knots, |i, k| heights[8 * (i % 8) + k % 8]);
    let copy = |x: f64, y: f64| {
        own.iter().map(move |of| of.map(|[a, b, c]| [a + x, b + y, c])).collect::<Vec<_>>()
    };
    let ways = [-1.0, 0.0, 1.0];
    let copies: Vec<_> = ways.iter().flat_map(|x| ways.iter().flat_map(|y| copy(*x, *y))).collect();
    let (mesh, copies) = (TriangleMesh::new(&own, SMOOTH, [1.0, 1.0, 0.0]).unwrap(), made(&copies));
    let mut across = 0;
    for _ in 0..2000 {
        let center = Vector3::new(numbers.part(), numbers.part(), numbers.between(-0.2, 0.4));
        let reach = numbers.between(0.02, 0.3);
        let (one, two) = (places(&mesh, center, reach), places(&copies, center, reach));
        across += one.iter().filter(|place| place.shift != Vector3::zeros()).count();
        assert_same(&sorted(one, |x| *x), &sorted(two, |x| *x));
        let away = Vector3::new(-3.0, 7.0, 0.0);
        let far = places(&mesh, center + away, reach);
        assert_same(
            &sorted(far, |x| *x),
            &sorted(places(&mesh, center, reach), |x| *x)
                .into_iter()
                .map(|(part, mut its, sharp)| {
                    (its[1], its[2]) = (its[1] + away.x, its[2] + away.y);
                    (part, its, sharp)
                })
                .collect::<Vec<_>>(),
        );
    }
    assert!(across > 200, "{across}");
}

/// Corners off a plane by less than its tolerance, 2e-7 of its size, lie in it, and the largest triangle says where it is.
#[test]
fn a_plane_within_the_tolerance_is_that_of_its_largest_triangle() {
    let mut numbers = Splitmix(31);
    for (off, is_one) in [(1e-7, true), (8e-7, false)] {
        let mesh = made(&sheet(&[0.0, 0.9, 0.95, 1.0], |i, _| if i == 2 { off } else { 0.0 }));
        let mut is_plane = |_| {
            let center = Vector3::new(numbers.part(), numbers.part(), 0.05);
            places(&mesh, center, 0.2).iter().all(|place| place.normal == Vector3::z())
        };
        assert_eq!((0..300).all(&mut is_plane), is_one, "{off}");
    }
}

/// Sides that meet where a surface repeats itself are one within the tolerance.
#[test]
fn a_seam_is_closed_within_the_tolerance() {
    let knots: Vec<f64> = (0..=8).map(|k| f64::from(k) / 8.0).collect();
    let mut own = sheet(&knots, |_, _| 0.0);
    for [x, y, _] in own.iter_mut().flatten().filter(|corner| corner[0] == 0.0) {
        *x = 5e-8 * (std::f64::consts::PI * *y).sin();
    }
    let (mesh, mut numbers) =
        (TriangleMesh::new(&own, SMOOTH, [1.0, 1.0, 0.0]).unwrap(), Splitmix(37));
    for _ in 0..300 {
        let center = Vector3::new(numbers.between(-0.05, 0.05), numbers.part(), 0.1);
        let [place] = places(&mesh, center, 0.2)[..] else { panic!("not one place") };
        assert_eq!((place.part, place.is_sharp), (Part::Face, false));
    }
}

/// A ridge is sharp up to a seam and blunt beyond: their common corner is sharp.
#[test]
fn a_corner_at_a_seam_is_sharp_if_an_edge_of_either_side_is() {
    let knots: Vec<f64> = (0..=8).map(|k| f64::from(k) / 8.0).collect();
    let ridge = |i, k| if (i, k) == (7, 4) { -0.0125 } else { -0.1 * (knots[k] - 0.5).abs() };
    let mesh = TriangleMesh::new(&sheet(&knots, ridge), SMOOTH, [1.0, 0.0, 0.0]).unwrap();
    for x in [-0.01, 0.99] {
        let [place] = places(&mesh, Vector3::new(x, 0.5, 0.2), 0.21)[..] else { panic!("{x}") };
        assert_eq!((place.part, place.is_sharp), (Part::Corner, true), "{x}");
    }
}

#[test]
fn a_ridge_is_sharp_above_the_smooth_angle() {
    for (half, is_sharp) in [(0.45 * SMOOTH, false), (0.55 * SMOOTH, true)] {
        let (sine, cosine) = half.sin_cos();
        let ridge = [Vector3::zeros(), Vector3::y()];
        let side = |x: f64| triangle([ridge[0], ridge[1], Vector3::new(x * cosine, 0.5, -sine)]);
        let mesh = made(&[side(-1.0), side(1.0)]);
        let [place] = places(&mesh, Vector3::new(0.0, 0.5, 0.1), 0.2)[..] else { panic!() };
        assert_eq!((place.part, place.is_sharp), (Part::Edge, is_sharp));
        assert_eq!((place.point, place.distance), (Vector3::new(0.0, 0.5, 0.0), 0.1));
    }
}

#[test]
fn what_is_no_mesh_is_named() {
    let [good, far] = [box_of(1.0), box_of(1e51)];
    let new = |triangles: &[Triangle], smooth, period| {
        TriangleMesh::new(triangles, smooth, period).unwrap_err()
    };
    let mut bad = good.clone();
    bad[3][1] = bad[3][0];
    assert_eq!(new(&bad, SMOOTH, FREE), MeshError::NoArea { number: 4 });
    bad[2][1][1] = f64::INFINITY;
    assert_eq!(new(&bad, SMOOTH, FREE), MeshError::NotFinite { number: 3 });
    assert_eq!(new(&far, SMOOTH, FREE), MeshError::NotFinite { number: 1 });
    assert_eq!(new(&box_of(1e-51), SMOOTH, FREE), MeshError::NoArea { number: 1 });
    let long = MeshError::TooLong { axis: 1, length: 2.0, period: 1.9 };
    assert_eq!(new(&good, SMOOTH, [0.0, 1.9, 0.0]), long);
    for (triangles, smooth, period, field) in [
        (&good[..], 0.81, FREE, "smooth"),
        (&good[..], f64::NAN, FREE, "smooth"),
        (&[][..], SMOOTH, FREE, "triangles"),
        (&good[..], SMOOTH, [-1.0, 0.0, 0.0], "period"),
    ] {
        let told = new(triangles, smooth, period);
        assert!(matches!(told, MeshError::Range(error) if error.field == field), "{told}");
    }
    let mesh = TriangleMesh::new(&good, SMOOTH, [2.0, 0.0, 0.0]).unwrap();
    for (center, reach, field) in [
        (Vector3::repeat(f64::NAN), 1.0, "center"),
        (Vector3::repeat(3e9), 1.0, "center"),
        (Vector3::zeros(), 0.0, "reach"),
        (Vector3::zeros(), 21.0, "reach"),
    ] {
        let told = mesh.places(center, reach, &mut Search::default()).unwrap_err();
        assert_eq!(told.field, field);
    }
}
