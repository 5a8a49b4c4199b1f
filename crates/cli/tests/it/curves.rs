//! Curves in pictures are computed, not interpolated linearly between the given values.

use crate::common::{case, example, fresh, stdout};

/// The points of all lines of a picture, in its units, and the middles of its dots.
fn drawn(arguments: &[&str]) -> (Vec<Vec<[f64; 2]>>, Vec<[f64; 2]>) {
    let file = fresh(&format!("curve-{}.svg", arguments[0]));
    stdout(&[arguments, &["--plot", file.to_str().unwrap()]].concat());
    let svg = std::fs::read_to_string(&file).unwrap();
    let value = |line: &str, name: &str| -> f64 {
        let (_, rest) = line.split_once(&format!(" {name}=\"")).unwrap();
        rest.split('"').next().unwrap().parse().unwrap()
    };
    let points = |line: &str| {
        let list = line.split("points=\"").nth(1).unwrap().split('"').next().unwrap();
        let point = |pair: &str| {
            let (x, y) = pair.split_once(',').unwrap();
            [x.parse().unwrap(), y.parse().unwrap()]
        };
        list.split_whitespace().map(point).collect::<Vec<_>>()
    };
    // Samples in the legend have two points.
    let lines = svg.lines().filter(|line| line.starts_with("<polyline")).map(points);
    let dots = svg.lines().filter(|line| line.starts_with("<circle"));
    let dots = dots.map(|line| [value(line, "cx"), value(line, "cy")]).collect();
    (lines.filter(|line| line.len() > 2).collect(), dots)
}

/// y over x to this power is one number along the curve from its first point.
fn is_power(curve: &[[f64; 2]], power: f64) {
    let [x_0, y_0] = curve[0];
    let [x_1, y_1] = curve[curve.len() - 1];
    for [x, y] in curve {
        let expected = (y_1 - y_0) * ((x - x_0) / (x_1 - x_0)).powf(power);
        // Pixels are rounded to hundredths, and the root is steep at the start.
        let slope = power * ((x - x_0).max(0.01) / (x_1 - x_0)).powf(power - 1.0) * 310.0 / 400.0;
        assert!((y - y_0 - expected).abs() < 0.02 + 0.02 * slope, "{x} {y} {expected}");
    }
}

fn lies_on_a_line(dots: &[[f64; 2]], lines: &[Vec<[f64; 2]>]) {
    for [x, y] in dots {
        let mut points = lines.iter().flatten();
        assert!(points.any(|point| (point[0] - x).hypot(point[1] - y) < 0.4), "{x} {y}");
    }
}

#[test]
fn hertz_draws_powers_of_the_approach_through_its_loads() {
    let (lines, dots) = drawn(&["hertz", &example("hertz_crossed_cylinders.toml")]);
    assert_eq!((lines.len(), dots.len()), (2, 8));
    assert!(lines.iter().all(|line| line.len() > 100));
    is_power(&lines[0], 1.5);
    is_power(&lines[1], 0.5);
    lies_on_a_line(&dots, &lines);
}

#[test]
fn a_history_is_drawn_between_its_steps() {
    let (lines, dots) = drawn(&["history", &example("history_loop.toml"), "--panels", "all"]);
    // Three forces, two loops, two radii, two energies at nine steps.
    assert_eq!((lines.len(), dots.len()), (9, 9 * 9));
    lies_on_a_line(&dots, &lines);
    // Under normal load alone, in one step, the force is the power 3/2 of the approach.
    let text = std::fs::read_to_string(example("history_loop.toml")).unwrap();
    let (head, _) = text.split_once("steps = [").unwrap();
    let press = case("press.toml", &format!("{head}steps = [[1e-6, 0, 0]]\n"));
    let (lines, _) = drawn(&["history", &press, "--panels", "all"]);
    // Those that rise: the radii of contact and stick, the force, the stored energy.
    let rising = |line: &&Vec<[f64; 2]>| (line[0][1] - line[line.len() - 1][1]).abs() > 100.0;
    let rising: Vec<_> = lines.iter().filter(rising).collect();
    assert_eq!(rising.len(), 4);
    is_power(rising[2], 1.5);
}

#[test]
fn a_sweep_is_drawn_between_its_angles() {
    let (lines, dots) = drawn(&["impact", &example("alumina_on_plane.toml")]);
    assert_eq!((lines.len(), dots.len()), (3, 3 * 17));
    assert!(lines.iter().all(|line| line.len() > 100));
    lies_on_a_line(&dots, &lines);
}

#[test]
fn restitution_is_drawn_between_its_values() {
    // In sliding R_x = -1 + 7/lambda: a straight side from 7 to 70 would be far off.
    let (lines, dots) = drawn(&["restitution", "--kappa", "1", "--lambda", "7,14,70"]);
    assert_eq!((lines.len(), dots.len()), (1, 3));
    let [x_0, y_0] = lines[0][0];
    let [x_1, y_1] = lines[0][lines[0].len() - 1];
    for [x, y] in &lines[0] {
        let lambda = 7.0 + 63.0 * (x - x_0) / (x_1 - x_0);
        let expected = y_0 + (y_1 - y_0) * (1.0 - 7.0 / lambda) / 0.9;
        assert!((y - expected).abs() < 0.2, "{lambda} {y} {expected}");
    }
}
