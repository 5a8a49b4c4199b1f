//! `carom impact --animate`: the animation agrees with the impact.

use crate::common::{example, fresh, json, refusal, stdout};

type Frames = Vec<Vec<[f64; 2]>>;

/// The frames of the moving elements of a kind, in pixels.
fn moving(svg: &str, element: &str) -> Vec<Frames> {
    let numbers = |text: &str| -> Vec<[f64; 2]> {
        let point = |pair: &str| {
            let (x, y) = pair.split_once(',').unwrap();
            [x.parse().unwrap(), y.parse().unwrap()]
        };
        text.split(' ').map(point).collect()
    };
    let of_element =
        |line: &str| line.starts_with(&format!("<{element} ")) && line.contains("<animate ");
    let frames = |line: &str| -> Frames {
        let values = line.split("values=\"").nth(1).unwrap().split('"').next().unwrap();
        values.split(';').map(numbers).collect()
    };
    svg.lines().filter(|line| of_element(line)).map(frames).collect()
}

fn animated(name: &str) -> String {
    let file = fresh(&format!("animated_{name}.svg"));
    let file = file.to_str().unwrap();
    stdout(&["impact", &example(&format!("{name}.toml")), "--animate", file]);
    std::fs::read_to_string(file).unwrap()
}

fn middle(points: &[[f64; 2]]) -> [f64; 2] {
    let count = points.len() as f64;
    [0, 1].map(|i| points.iter().map(|point| point[i]).sum::<f64>() / count)
}

#[test]
fn bodies_of_every_shape_touch_and_part() {
    for name in ["dissimilar_balls", "ellipsoid_on_plane", "spinning_torus", "crossed_capsules"] {
        let outlines = moving(&animated(name), "polygon");
        let [one, two] = [&outlines[0], &outlines[1]];
        let gap = |frame: usize| {
            let low = one[frame].iter().map(|at| at[1]).fold(f64::MIN, f64::max);
            let high = two[frame].iter().map(|at| at[1]).fold(f64::MAX, f64::min);
            high - low
        };
        let (touch, last) = (16, one.len() - 1);
        assert!(gap(touch).abs() < 1.0, "{name}: {} pixels at touch", gap(touch));
        assert!(gap(0) > 5.0 && gap(last) > 5.0, "{name}: {} and {}", gap(0), gap(last));
    }
}

#[test]
fn a_plane_is_wider_than_the_ball_and_lies_below_it() {
    let outlines = moving(&animated("rubber_on_table"), "polygon");
    let [ball, plane] = [0, 1].map(|body: usize| &outlines[body][16]);
    let ends = |points: &[[f64; 2]], axis: usize| {
        let of = || points.iter().map(|point| point[axis]);
        [of().fold(f64::MAX, f64::min), of().fold(f64::MIN, f64::max)]
    };
    let ([left, right], [_, low]) = (ends(ball, 0), ends(ball, 1));
    let ([from, to], [top, bottom]) = (ends(plane, 0), ends(plane, 1));
    assert!(from < left && to > right, "{from} {left} {right} {to}");
    assert!((top - low).abs() < 1.0 && bottom > top + 5.0, "{top} {bottom} {low}");
    let level = plane.iter().filter(|point| (point[1] - top).abs() < 0.1).count();
    assert!(level >= plane.len() - 3, "{level} of {}", plane.len());
}

/// The spinning ring is seen along its axis: twice around, outside with 50 mm and inside with 10 mm.
#[test]
fn a_torus_has_its_hole() {
    let ring = &moving(&animated("spinning_torus"), "polygon")[0][16];
    let (outer, inner) = ring.split_at(ring.len() / 2);
    let centre = middle(&outer[1..]);
    let radius = |at: &[f64; 2]| (at[0] - centre[0]).hypot(at[1] - centre[1]);
    let rim = radius(&outer[0]);
    assert!(outer.iter().all(|at| (radius(at) / rim - 1.0).abs() < 0.02));
    assert!(inner.iter().all(|at| (radius(at) / rim - 0.2).abs() < 0.01), "{inner:?}");
    // The other way around, so that the hole is empty.
    let turn = |points: &[[f64; 2]]| -> f64 {
        let arm = |at: &[f64; 2]| [at[0] - centre[0], at[1] - centre[1]];
        let crossed = |pair: &[[f64; 2]]| {
            let ([a, b], [c, d]) = (arm(&pair[0]), arm(&pair[1]));
            a * d - b * c
        };
        points.windows(2).map(crossed).sum()
    };
    assert!(turn(outer) * turn(inner) < 0.0);
}

#[test]
fn a_ball_goes_as_fast_as_the_outcome_says() {
    let outcome = json(&["impact", &example("rubber_on_table.toml")]);
    let number = |what: &str, i: usize| outcome[format!("body_1_{what}")][i].as_f64().unwrap();
    let ball = &moving(&animated("rubber_on_table"), "polygon")[0];
    let pace = |from: usize, to: usize| {
        let (from, to, frames) = (middle(&ball[from]), middle(&ball[to]), (to - from) as f64);
        [(to[0] - from[0]) / frames, (from[1] - to[1]) / frames]
    };
    let (come, gone) = (pace(0, 16), pace(76, ball.len() - 1));
    // It came with (1, 0, -1) m/s.
    for (i, speed) in [number("velocity", 0), number("velocity", 2)].into_iter().enumerate() {
        let expected = come[i].abs() * speed;
        assert!((gone[i] - expected).abs() < 0.01, "{gone:?}, before {come:?}, {speed}");
    }
    // It turns by the spin that friction gave it, clockwise with z up and x to the right.
    let last = ball.len() - 1;
    let (centre, rim) = (middle(&ball[last]), ball[last][0]);
    let arm = [rim[0] - centre[0], rim[1] - centre[1]];
    let metre = arm[0].hypot(arm[1]) / 0.022;
    let time = gone[0] * (last - 76) as f64 / (number("velocity", 0) * metre);
    let (angle, expected) = (arm[1].atan2(arm[0]), number("spin", 1) * time);
    assert!((angle - expected).sin().abs() < 0.01, "{angle} is not {expected}");
}

#[test]
fn a_sweep_and_a_picture_beside_it_are_refused() {
    let file = fresh("animated_sweep.svg");
    let file = file.to_str().unwrap();
    for arguments in [
        vec!["impact", &example("alumina_on_plane.toml"), "--animate", file],
        vec!["impact", &example("glass_scatter.toml"), "--animate", file],
        vec!["impact", &example("steel_balls.toml"), "--animate", file, "--plot", "x.svg"],
    ] {
        refusal(&arguments);
        assert!(!std::path::Path::new(file).exists());
    }
}
