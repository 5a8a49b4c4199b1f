//! Points are drawn at the positions given by the ticks of the axes.

use carom_plot::{Arrow, Axis, Marker, Panel, Point, Series, render};

/// The numbers of an attribute in all elements of a name whose text holds `with`.
fn numbers(svg: &str, element: &str, attribute: &str, with: &str) -> Vec<f64> {
    let head = format!("<{element} ");
    let of = |line: &str| {
        let rest = line.split_once(&format!(" {attribute}=\""))?.1;
        rest.split_once('"')?.0.parse().ok()
    };
    let lines = svg.lines().filter(|line| line.contains(&head) && line.contains(with));
    lines.filter_map(of).collect()
}

/// Lines of the grid: those that stand, and those that lie.
fn grid(svg: &str) -> [Vec<f64>; 2] {
    let of = |name: &str| numbers(svg, "line", name, "#e4e4e4");
    let (x, y) = ([of("x1"), of("x2")], [of("y1"), of("y2")]);
    let stand = x[0].iter().zip(&x[1]).filter(|(a, b)| a == b).map(|(a, _)| *a).collect();
    let lie = y[0].iter().zip(&y[1]).filter(|(a, b)| a == b).map(|(a, _)| *a).collect();
    [stand, lie]
}

fn near(got: &[f64], expected: &[f64]) {
    assert_eq!(got.len(), expected.len(), "{got:?} {expected:?}");
    for (got, expected) in got.iter().zip(expected) {
        assert!((got - expected).abs() < 0.011, "{got:?} {expected:?}");
    }
}

/// x and y of all markers.
fn markers(panel: Panel) -> (Vec<f64>, Vec<f64>, [Vec<f64>; 2]) {
    let svg = render("", &[panel]).unwrap();
    let of = |name: &str| numbers(&svg, "circle", name, "");
    (of("cx"), of("cy"), grid(&svg))
}

#[test]
fn points_stand_at_the_ticks_of_linear_and_logarithmic_axes() {
    let decades = [0.01, 0.1, 1.0, 10.0, 100.0];
    let even = [0.0, 1.0, 2.0, 3.0, 4.0];
    let log = || Axis::log("").between(0.01, 100.0);
    let linear = || Axis::linear("").between(0.0, 4.0);
    for (x, y, at) in [
        (log(), log(), [decades, decades]),
        (log(), linear(), [decades, even]),
        (linear(), log(), [even, decades]),
        (linear(), linear(), [even, even]),
    ] {
        let mut panel = Panel::new(x, y);
        let points = (0..5).map(|i| (at[0][i], at[1][4 - i]));
        panel.add(Series::markers("", Marker::Dot, points));
        let (cx, cy, [mut stand, lie]) = markers(panel);
        // The lower end of y is the greatest pixel; ticks between are left out.
        let even = |lines: &[f64]| lines.iter().step_by((lines.len() - 1) / 4).copied().collect();
        stand = even(&stand);
        let mut lie: Vec<f64> = even(&lie);
        near(&cx, &stand);
        lie.reverse();
        near(&cy, &lie);
        // Both axes are divided evenly.
        near(&[stand[1] - stand[0], stand[3] - stand[0]], &[110.0, 330.0]);
        near(&[lie[1] - lie[0], lie[4] - lie[0]], &[77.5, 310.0]);
    }
}

#[test]
fn a_value_between_two_ticks_stands_by_its_logarithm() {
    let mut panel = Panel::new(Axis::log("").between(1.0, 1e4), Axis::log("").between(1.0, 16.0));
    panel.add(Series::markers("", Marker::Dot, [(10.0, 2.0), (1e3, 8.0), (1e2, 4.0)]));
    let (cx, cy, [stand, _]) = markers(panel);
    let (left, bottom) = (stand[0], cy[0] + 77.5);
    near(&cx, &[left + 110.0, left + 330.0, left + 220.0]);
    near(&cy, &[bottom - 77.5, bottom - 232.5, bottom - 155.0]);
}

/// Lines, arrows and areas stand where markers of the same points do.
#[test]
fn all_styles_stand_at_the_same_places() {
    let points = [(1.0, 20.0), (30.0, 3.0), (200.0, 500.0)];
    let axes = || Panel::new(Axis::log("").between(0.5, 500.0), Axis::log("").between(1.0, 1e3));
    let mut panel = axes();
    panel.add(Series::markers("", Marker::Dot, points));
    let (cx, cy, _) = markers(panel);
    let pairs: Vec<[f64; 2]> = cx.into_iter().zip(cy).map(|(x, y)| [x, y]).collect();
    let [tail, head] = [points[0], points[1]].map(|(x, y)| Point::new(x, y));
    for (series, count) in [
        (Series::line("", points), 3),
        (Series::dashed("", points), 3),
        (Series::dotted("", points), 3),
        (Series::area("", points), 3),
        (Series::arrows("", [Arrow { tail, head }]), 2),
    ] {
        let style = series.style;
        let mut panel = axes();
        panel.add(series);
        let svg = render("", &[panel]).unwrap();
        // Whatever the element: its numbers hold those of the points.
        let inside = svg.rsplit_once("clip-path=").unwrap().1;
        let all: Vec<f64> = inside
            .split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'))
            .filter_map(|word| word.parse().ok())
            .collect();
        for [x, y] in &pairs[..count] {
            // Arrows are written to a tenth of a pixel.
            let found =
                all.windows(2).any(|two| (two[0] - x).abs() < 0.06 && (two[1] - y).abs() < 0.06);
            assert!(found, "{style:?}: {x} {y} not in {inside}");
        }
    }
}

/// Panels stand side by side and below each other, row by row, a short last row in the middle, and do not overlap.
#[test]
fn panels_are_laid_out_row_by_row() {
    for (count, columns) in [(1, 1), (2, 2), (3, 2), (4, 2), (5, 3), (7, 3)] {
        let panels: Vec<Panel> = (0..count)
            .map(|i| {
                let mut panel = Panel::new("", "").titled(format!("panel {i}"));
                panel.add(Series::line("", [(0.0, 0.0), (1.0, 1.0)]));
                panel
            })
            .collect();
        let svg = render("heading", &panels).unwrap();
        let corner = |line: &str| {
            let rect = line.split_once("<rect").unwrap().1;
            let of = |name: &str| {
                let rest = rect.split_once(&format!(" {name}=\"")).unwrap().1;
                rest.split('"').next().unwrap().parse::<f64>().unwrap()
            };
            [of("x"), of("y")]
        };
        let corners: Vec<[f64; 2]> =
            svg.lines().filter(|line| line.starts_with("<clipPath")).map(corner).collect();
        assert_eq!(corners.len(), count);
        for (i, [x, y]) in corners.iter().enumerate() {
            let (row, column) = (i / columns, i % columns);
            // A cell is 540 by 400 pixels, its axes 78 and 34 from its corner, below a heading of 30.
            // A short last row stands in the middle.
            let missing = (columns * (row + 1)).saturating_sub(count);
            let along = column as f64 + 0.5 * missing as f64;
            let expected = [78.0 + 540.0 * along, 64.0 + 400.0 * row as f64];
            assert!((x - expected[0]).abs() < 0.1 && (y - expected[1]).abs() < 0.1, "{i}: {x} {y}");
        }
    }
}

/// The barbs of an arrow lie on both sides of its shaft, behind its head.
#[test]
fn barbs_lie_on_both_sides_of_an_arrow() {
    let axes = || Axis::linear("").between(0.0, 1.0);
    for (dx, dy) in [(0.5, 0.1), (-0.3, 0.4), (0.05, -0.4), (-0.4, -0.3)] {
        let mut panel = Panel::new(axes(), axes());
        let [tail, head] = [Point::new(0.5, 0.5), Point::new(0.5 + dx, 0.5 + dy)];
        panel.add(Series::arrows("", [Arrow { tail, head }]));
        let svg = render("", &[panel]).unwrap();
        let line = svg.lines().find(|line| line.starts_with("<path ")).unwrap();
        let data = line.split_once(" d=\"").unwrap().1.split('"').next().unwrap();
        let points: Vec<[f64; 2]> = data
            .split(['M', 'L'])
            .filter_map(|pair| pair.split_once(','))
            .map(|(x, y)| [x.parse().unwrap(), y.parse().unwrap()])
            .collect();
        let [tail, head, one, tip, other] = points[..] else { panic!("{points:?}") };
        assert_eq!(head, tip);
        let from = |a: [f64; 2], b: [f64; 2]| [b[0] - a[0], b[1] - a[1]];
        let (shaft, barbs) = (from(tail, head), [from(head, one), from(head, other)]);
        let length = shaft[0].hypot(shaft[1]);
        let along = barbs.map(|b| (b[0] * shaft[0] + b[1] * shaft[1]) / length);
        let across = barbs.map(|b| (b[0] * shaft[1] - b[1] * shaft[0]) / length);
        assert!(along.iter().all(|way| (way + 6.0).abs() < 0.2), "{along:?}");
        assert!((across[0] + across[1]).abs() < 0.2 && across[0].abs() > 2.5, "{across:?}");
    }
}

/// A map has the same unit along both axes, whichever of the two is the longer.
#[test]
fn a_unit_is_as_long_on_both_axes_of_a_map() {
    for corner in [(10.0, 1.0), (1.0, 10.0), (4.4, 3.1)] {
        let mut panel = Panel::new("", "").equal_aspect();
        let points = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), corner];
        panel.add(Series::markers("", Marker::Dot, points));
        let (cx, cy, _) = markers(panel);
        assert_eq!(cx.len(), 4, "{corner:?}");
        let (right, up) = (cx[1] - cx[0], cy[0] - cy[2]);
        assert!(right > 10.0 && (right - up).abs() < 0.03, "{corner:?}: {right} {up}");
        // All of it lies between the axes.
        assert!(cx[3] < 518.1 && cy[3] > 33.9, "{cx:?} {cy:?}");
    }
}

/// Words beside a point stay within the axes: near their right end they stand before it.
#[test]
fn words_at_the_right_end_stand_before_their_point() {
    for (x, anchor) in [(0.1, "start"), (0.5, "start"), (0.95, "end")] {
        let axes = || Axis::linear("").between(0.0, 1.0);
        let mut panel = Panel::new(axes(), axes());
        panel.add(Series::note("words", (x, 0.5)));
        let svg = render("", &[panel]).unwrap();
        let line = svg.lines().find(|line| line.contains(">words<")).unwrap();
        assert!(line.contains(&format!("text-anchor=\"{anchor}\"")), "{x}: {line}");
    }
}

#[test]
fn equal_axes_show_a_circle_as_a_circle_whichever_way_the_data_are_long() {
    for [x, y] in [[1.0, 0.2], [0.2, 1.0], [1.0, 1.0]] {
        let mut panel = Panel::new(Axis::linear(""), Axis::linear("")).equal_aspect();
        let corners = [(-x, -y), (x, y), (-0.1, 0.0), (0.1, 0.0), (0.0, -0.1), (0.0, 0.1)];
        panel.add(Series::markers("", Marker::Dot, corners));
        let (cx, cy, _) = markers(panel);
        near(&[(cx[3] - cx[2]).abs()], &[(cy[5] - cy[4]).abs()]);
        near(&[(cx[1] - cx[0]).abs() * y], &[(cy[1] - cy[0]).abs() * x]);
        // Nothing stands outside of the axes, and one of them is filled.
        assert!(cx.iter().all(|at| *at >= 0.0) && cy.iter().all(|at| *at >= 0.0));
        assert!((cx[1] - cx[0]).abs() > 200.0 || (cy[1] - cy[0]).abs() > 200.0);
    }
}

/// Axes fitted to their points leave as much space at one end as at the other, also where they are logarithmic.
#[test]
fn fitted_axes_leave_equal_space_at_both_ends() {
    for (x, y) in [(Axis::log(""), Axis::linear("")), (Axis::linear(""), Axis::log(""))] {
        let mut panel = Panel::new(x, y);
        panel.add(Series::markers("", Marker::Dot, [(0.3, 0.02), (5.0, 70.0)]));
        let (cx, cy, _) = markers(panel);
        for [low, high] in [[cx[0] - 78.0, 518.0 - cx[1]], [344.0 - cy[0], cy[1] - 34.0]] {
            assert!(low > 5.0 && (low - high).abs() < 0.03, "{low} {high}");
        }
    }
}

/// The legend names the series from above in the order in which they were added.
#[test]
fn the_legend_keeps_the_order_of_the_series() {
    let mut panel = Panel::new("", "");
    let labels = ["stick", "slip", "all"];
    for (i, label) in labels.into_iter().enumerate() {
        panel.add(Series::line(label, [(0.0, 0.1 * i as f64), (1.0, 0.0)]));
    }
    let svg = render("", &[panel]).unwrap();
    let places = labels.map(|label| {
        let line = svg.lines().find(|line| line.contains(&format!(">{label}<"))).unwrap();
        numbers(line, "text", "y", "")[0]
    });
    assert!(places[0] < places[1] && places[1] < places[2], "{places:?}");
}

/// Widths of the letters of Helvetica, in thousandths of its size.
fn helvetica(letter: char) -> f64 {
    match letter {
        'i' | 'j' | 'l' => 222.0,
        'f' | 't' | ' ' => 278.0,
        'r' | '-' => 333.0,
        'c' | 'k' | 's' | 'v' | 'x' | 'y' | 'z' => 500.0,
        'D' | 'w' => 722.0,
        'm' => 833.0,
        _ => 556.0,
    }
}

/// Names stand below their values, and all of them lie within the picture.
#[test]
fn names_stand_below_their_values() {
    let names = ["soda-lime glass", "cellulose acetate on aluminium", "Delrin", "steel", "zinc"];
    let mut panel = Panel::new(Axis::named("material", names), "β");
    panel.add(Series::markers("", Marker::Dot, (1..=5).map(|i| (f64::from(i), 0.0))));
    let svg = render("", &[panel]).unwrap();
    let size = |name: &str| numbers(&svg, "svg", name, "")[0];
    let (width, height) = (size("width"), size("height"));
    let cx = numbers(&svg, "circle", "cx", "");
    for (name, x) in names.into_iter().zip(cx) {
        let line = svg.lines().find(|line| line.contains(&format!(">{name}<"))).unwrap();
        let of = |attribute: &str| numbers(line, "text", attribute, "")[0];
        assert!((of("x") - x - 4.0).abs() < 0.02 && line.contains("text-anchor=\"end\""), "{line}");
        let angle: f64 =
            line.split_once("rotate(").unwrap().1.split(' ').next().unwrap().parse().unwrap();
        let length = 14.0 * name.chars().map(helvetica).sum::<f64>() / 1000.0;
        let (across, down) =
            (length * angle.to_radians().cos(), -length * angle.to_radians().sin());
        assert!(of("x") - across > 0.0 && of("x") < width, "{line}");
        assert!(of("y") + down < height - 16.0, "{line}: {height}");
    }
}

/// A map has one power of ten, that of the greater numbers, along whichever axis they lie.
#[test]
fn both_axes_of_a_map_have_the_power_of_the_greater_numbers() {
    for corner in [(1e6, 1.0), (1.0, 1e6)] {
        let mut panel = Panel::new("across", "up").equal_aspect();
        panel.add(Series::markers("", Marker::Dot, [corner, (corner.0 + 2.0, corner.1 + 2.0)]));
        let svg = render("", &[panel]).unwrap();
        for label in ["across", "up"] {
            let line = svg.lines().find(|line| line.contains(&format!(">{label}"))).unwrap();
            assert!(line.contains("(× 10⁶)"), "{corner:?}: {line}");
        }
    }
}
