//! `carom stress`: compared with Hertz's closed form and the surface traction; invalid cases.

use std::path::Path;

use crate::common::{carom, case, example, json, refusal, stdout};
use serde_json::Value;

fn with(name: &str, force: [f64; 2], points: &str) -> String {
    let body = |name: &str, radii: &str| {
        format!(
            "[{name}]\nradii = {radii}\nmaterial = {{ young_modulus = 208e9, poisson = 0.3 }}\n"
        )
    };
    let (one, two) = (body("body_1", "0.01"), body("body_2", "inf"));
    let [x, y] = force;
    let rest = format!(
        "[contact]\nangle = 0\nfriction = 0.3\n[load]\nforce = 100\nforce_x = {x}\nforce_y = {y}\n\
         [points]\n{points}\n"
    );
    case(name, &(one + &two + &rest))
}

fn numbers(found: &Value, column: &str) -> Vec<f64> {
    let points = found["points"].as_array().unwrap();
    points.iter().map(|point| point[column].as_f64().unwrap()).collect()
}

#[test]
fn below_the_middle_it_is_the_closed_form() {
    let points =
        "inside = \"body 2\"\nx = 0\ny = 0\ndepth = { start = 0, stop = 4e-4, count = 81 }";
    let found = json(&["stress", &with("stress_axis.toml", [0.0; 2], points)]);
    let a = found["contact"]["semi_axis_a"].as_f64().unwrap();
    let pressure = found["contact"]["peak_pressure"].as_f64().unwrap();
    let (depth, normal) = (numbers(&found, "depth"), numbers(&found, "s_zz"));
    for (z, s_zz) in depth.iter().zip(&normal) {
        let expected = -pressure / (1.0 + (z / a).powi(2));
        assert!((s_zz / expected - 1.0).abs() < 1e-12, "{s_zz} is not {expected}");
    }
    // Well known for a Poisson's ratio of .3: .310 p_0 at .48 a.
    let shear = numbers(&found, "maximum_shear");
    let (at, most) = shear.iter().enumerate().max_by(|one, two| one.1.total_cmp(two.1)).unwrap();
    assert!((most / pressure - 0.310).abs() < 1e-3 && (depth[at] / a - 0.48).abs() < 0.03);
}

/// Below a ball it lies at .48 a, where Mises' stress is .62 p_0; the places asked for are coarse.
#[test]
fn the_greatest_stress_is_searched_between_the_points() {
    let points = "inside = \"body 2\"\nx = [-2e-4, 1e-5, 2e-4]\ny = 0\ndepth = [0, 1e-4, 4e-4]";
    let found = json(&["stress", &with("stress_greatest.toml", [0.0; 2], points)]);
    let of = |part: &str, column: &str| found[part][column].as_f64().unwrap();
    let (a, pressure) = (of("contact", "semi_axis_a"), of("contact", "peak_pressure"));
    assert!(of("greatest", "x").abs() < 1e-4 * a);
    assert!((of("greatest", "depth") / a - 0.4809).abs() < 1e-3);
    assert!((of("greatest", "von_mises") / pressure - 0.620_0).abs() < 5e-4);
    let most = numbers(&found, "von_mises").into_iter().fold(0.0, f64::max);
    assert!(of("greatest", "von_mises") > 1.001 * most);
    // Where all of it slides under much friction, it lies on the rear edge.
    let edge = json(&["stress", &example("stress_sliding_rail.toml")]);
    let at = edge["greatest"]["y"].as_f64().unwrap();
    assert!((at / edge["contact"]["semi_axis_b"].as_f64().unwrap() - 1.0).abs() < 1e-3);
}

#[test]
fn both_bodies_feel_the_same_traction() {
    let inside = |body: &str, force| {
        let points = format!("inside = \"{body}\"\nx = [-4e-5, 0, 6e-5]\ny = 3e-5\ndepth = 0");
        json(&["stress", &with(&format!("stress_{}.toml", &body[5..]), force, &points)])
    };
    for force in [[18.0, 24.0], [9.0, -12.0]] {
        let (one, two) = (inside("body 1", force), inside("body 2", force));
        let pressure = one["contact"]["peak_pressure"].as_f64().unwrap();
        for column in ["s_zz", "s_zx", "s_yz"] {
            for (one, two) in numbers(&one, column).iter().zip(numbers(&two, column)) {
                assert!((one - two).abs() < 1e-12 * pressure, "{column}: {one} and {two}");
            }
        }
    }
    // Where all slides, the traction on body 1 is f p along the force.
    let found = inside("body 1", [18.0, 24.0]);
    let (normal, x, y) =
        (numbers(&found, "s_zz"), numbers(&found, "s_zx"), numbers(&found, "s_yz"));
    for i in 0..3 {
        let limit = 0.3 * normal[i];
        assert!((x[i] - 0.6 * limit).abs() < 1e-9 * limit.abs(), "{} and {limit}", x[i]);
        assert!((y[i] - 0.8 * limit).abs() < 1e-9 * limit.abs(), "{} and {limit}", y[i]);
    }
}

#[test]
fn more_than_friction_can_hold_is_refused() {
    let points = "inside = \"body 1\"\nx = 0\ny = 0\ndepth = 0";
    for (force, field) in
        [([30.1, 0.0], "force_x"), ([0.0, -31.0], "force_y"), ([25.0, 25.0], "force_x")]
    {
        let told = refusal(&["stress", &with("stress_too_much.toml", force, points)]);
        assert!(told.contains(field) && told.contains("at most friction"), "{told}");
    }
    let many = "inside = \"body 1\"\nx = { start = 0, stop = 1, count = 2000 }\n\
                y = { start = 0, stop = 1, count = 2000 }\ndepth = 0";
    refusal(&["stress", &with("stress_many.toml", [0.0; 2], many)]);
    let rigid = std::fs::read_to_string(example("stress_ball.toml")).unwrap();
    let rigid = rigid.replacen("{ young_modulus = 208e9, poisson = 0.3 }", "{ rigid = true }", 1);
    let output = carom(&["stress", &case("stress_rigid.toml", &rigid)]);
    assert!(!output.status.success());
}

/// A block of a VTK file: `count` numbers, the high byte first, behind a line.
fn block(file: &[u8], head: &str, count: usize) -> Vec<f64> {
    let at =
        file.windows(head.len()).position(|bytes| bytes == head.as_bytes()).unwrap() + head.len();
    let numbers = file[at..at + 8 * count].chunks_exact(8);
    assert_eq!(file[at + 8 * count], b'\n');
    numbers.map(|bytes| f64::from_be_bytes(bytes.try_into().unwrap())).collect()
}

#[test]
fn a_field_goes_to_other_programs() {
    let points = "inside = \"body 2\"\nx = [-4e-5, 0, 6e-5]\ny = [1e-5, 3e-5]\ndepth = [0, 2e-5, 5e-5, 9e-5]";
    let case = with("stress_field.toml", [9.0, -12.0], points);
    let folder = Path::new(&case).parent().unwrap();
    let [vtk, npz] = ["field.vtk", "field.NPZ"].map(|name| folder.join(name));
    let csv = stdout(&["stress", &case, "--format", "csv", "--field", vtk.to_str().unwrap()]);
    let numbers = |column: &str| -> Vec<f64> {
        let (heads, rows) = csv.split_once('\n').unwrap();
        let place = heads.split(',').position(|head| head == column).unwrap();
        rows.lines().map(|row| row.split(',').nth(place).unwrap().parse().unwrap()).collect()
    };
    let (count, file) = (24, std::fs::read(&vtk).unwrap());
    let places = block(&file, "DIMENSIONS 3 2 4\nPOINTS 24 double\n", 3 * count);
    let tensors = block(&file, "TENSORS stress double\n", 9 * count);
    let worst = block(&file, "SCALARS von_mises double 1\nLOOKUP_TABLE default\n", count);
    assert_eq!(worst, numbers("von_mises"));
    for (i, at) in [("x", 0), ("y", 1)] {
        let along: Vec<f64> = places.iter().skip(at).step_by(3).copied().collect();
        assert_eq!(along, numbers(i));
    }
    // Body 2 lies below.
    assert!(numbers("depth").iter().zip(places.chunks(3)).all(|(z, at)| at[2] == -z));
    for (name, [one, other]) in
        [("s_xx", [0, 0]), ("s_xy", [1, 3]), ("s_yz", [5, 7]), ("s_zx", [2, 6])]
    {
        let part = |at| tensors.iter().skip(at).step_by(9).copied().collect::<Vec<_>>();
        assert_eq!(part(one), numbers(name));
        assert_eq!(part(other), numbers(name));
    }
    assert!(carom(&["stress", &case, "--field", npz.to_str().unwrap()]).status.success());
    let file = std::fs::read(&npz).unwrap();
    let bytes: Vec<u8> = numbers("s_yz").iter().flat_map(|s| s.to_le_bytes()).collect();
    let at = file.windows(bytes.len()).position(|there| there == bytes).unwrap();
    let head = String::from_utf8_lossy(&file[at - 140..at]);
    assert!(head.contains("s_yz.npy") && head.contains("'shape': (4, 2, 3,)"), "{head}");
    for (name, code) in [("field.vtu", 2), ("nowhere/field.vtk", 1)] {
        let output = carom(&["stress", &case, "--field", folder.join(name).to_str().unwrap()]);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(code), 0));
    }
}
