//! A coloured field: positions of its cells, its contour lines and the ticks of its colour bar.

use carom_plot::{Axis, Field, Panel, render};

fn panel(field: Field) -> String {
    render("", &[Panel::new(Axis::linear("x"), Axis::linear("y")).over(field)]).unwrap()
}

/// The axes lie at 78 and 34 pixels, 440 wide and 310 high: x from the left, y from below.
fn pixel(x: f64, y: f64) -> [f64; 2] {
    [78.0 + 440.0 * x, 34.0 + 310.0 * (1.0 - y)]
}

fn attribute<'a>(line: &'a str, name: &str) -> &'a str {
    line.split_once(&format!(" {name}=\"")).unwrap().1.split('"').next().unwrap()
}

/// All points of the lines of equal value.
fn contours(svg: &str) -> Vec<Vec<[f64; 2]>> {
    let group = svg.split("fill=\"none\" stroke=\"#222\">").nth(1).unwrap();
    let group = group.split("</g>").next().unwrap();
    let lines = group.lines().filter(|line| line.starts_with("<path"));
    let points = |line: &str| {
        let path = attribute(line, "d").split(['M', 'L']).filter(|pair| !pair.is_empty());
        let point = |pair: &str| {
            let (x, y) = pair.split_once(',').unwrap();
            [x.parse().unwrap(), y.parse().unwrap()]
        };
        path.map(point).collect()
    };
    lines.map(points).collect()
}

/// Over x from 0 to 1 and y from 0 to 4: what rises along y has lines that lie, what rises along x
/// lines that stand, at the values of the ticks of the bar.
#[test]
fn lines_of_equal_value_stand_at_their_values() {
    let (x, y) = (vec![0.0, 0.3, 1.0], vec![0.0, 0.5, 2.5, 4.0]);
    let along_y: Vec<f64> = y.iter().flat_map(|y| [*y; 3]).collect();
    let along_x: Vec<f64> = y.iter().flat_map(|_| x.clone()).collect();
    let of = |values| contours(&panel(Field::new("q", x.clone(), y.clone(), values).unwrap()));
    let mut found = 0;
    for (value, line) in (0..=4).map(f64::from).zip(of(along_y)) {
        for point in line {
            assert!((point[1] - pixel(0.0, value / 4.0)[1]).abs() < 0.06, "{value}: {point:?}");
            found += 1;
        }
    }
    for (value, line) in (0..=5).map(|i| 0.2 * f64::from(i)).zip(of(along_x)) {
        for point in line {
            assert!((point[0] - pixel(value, 0.0)[0]).abs() < 0.06, "{value}: {point:?}");
            found += 1;
        }
    }
    assert!(found > 20, "{found}");
}

/// The bar: rising upwards, each tick at its part, blue below zero and brown above.
#[test]
fn the_bar_rises_upwards_with_its_ticks() {
    let values = vec![-1.0, 0.0, 0.5, 1.0];
    let svg = panel(Field::new("q", vec![0.0, 1.0], vec![0.0, 1.0], values).unwrap());
    let bar = 78.0 + 440.0 + 14.0;
    let texts = svg.lines().filter(|line| line.starts_with("<text "));
    let number = |line: &str, name: &str| attribute(line, name).parse::<f64>().unwrap();
    let mut ticks = 0;
    for line in texts.filter(|line| (number(line, "x") - bar - 21.0).abs() < 0.1) {
        let label = line.split_once('>').unwrap().1.split('<').next().unwrap();
        let value: f64 = label.replace('−', "-").parse().unwrap();
        let expected = pixel(0.0, 0.5 * (value + 1.0))[1] + 4.5;
        assert!((number(line, "y") - expected).abs() < 0.02, "{line}");
        ticks += 1;
    }
    assert!(ticks >= 5, "{ticks}");
    let place = format!("<rect x=\"{bar}\"");
    let at = |line: &&str| line.starts_with(&place);
    let cells: Vec<&str> = svg.lines().filter(at).filter(|l| l.contains("fill=\"#")).collect();
    assert!(cells.len() > 50);
    let mut heights: Vec<(f64, &str)> =
        cells.iter().map(|line| (number(line, "y"), attribute(line, "fill"))).collect();
    heights.sort_by(|a, b| b.0.total_cmp(&a.0));
    assert!(
        (heights[0].0 - 344.0).abs() < 4.0 && (heights[heights.len() - 1].0 - 34.0).abs() < 4.0
    );
    // Blue has more of blue than of red; brown less.
    let part = |colour: &str, at: usize| i32::from_str_radix(&colour[at..at + 2], 16).unwrap();
    let warmth = |colour: &str| part(colour, 1) - part(colour, 5);
    let warmths: Vec<i32> = heights.iter().map(|(_, colour)| warmth(colour)).collect();
    assert!(warmths[0] < -100 && warmths[warmths.len() - 1] > 100, "{warmths:?}");
    assert!(warmths[warmths.len() / 2].abs() < 12);
}

fn from_base64(text: &str) -> Vec<u8> {
    let letters = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let digit = |letter: u8| letters.iter().position(|own| *own == letter).unwrap() as u32;
    let digits: Vec<u32> = text.bytes().filter(|letter| *letter != b'=').map(digit).collect();
    let mut bytes = Vec::new();
    for four in digits.chunks(4) {
        let bits = four.iter().fold(0, |bits, digit| (bits << 6) | digit) << (6 * (4 - four.len()));
        bytes.extend((0..four.len() - 1).map(|i| (bits >> (16 - 8 * i)) as u8));
    }
    bytes
}

/// Around each node a cell of its colour, which ends half-way to the next one; the first row lies below.
#[test]
fn cells_end_half_way_between_the_nodes() {
    let (x, y) = (vec![0.0, 1.0, 4.0], vec![0.0, 3.0, 4.0]);
    let values: Vec<f64> = (0..9).map(f64::from).collect();
    let svg = panel(Field::new("q", x, y, values).unwrap());
    let data = svg.split_once("base64,").unwrap().1.split('"').next().unwrap();
    let mut decoder = png::Decoder::new(std::io::Cursor::new(from_base64(data)));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let (width, height) = (info.width as usize, info.height as usize);
    let colour = |i: usize, j: usize| {
        let at = 3 * (j * width + i);
        [pixels[at], pixels[at + 1], pixels[at + 2]]
    };
    // Places from the left and from below at which the colour changes.
    let changes = |count: usize, at: &dyn Fn(usize) -> [u8; 3]| -> Vec<f64> {
        (1..count).filter(|i| at(*i) != at(i - 1)).map(|i| i as f64 / count as f64).collect()
    };
    let across = changes(width, &|i| colour(i, height - 1));
    let up = changes(height, &|j| colour(0, height - 1 - j));
    for (found, expected) in [(across, [0.125, 0.625]), (up, [0.375, 0.875])] {
        assert_eq!(found.len(), 2, "{found:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 0.01, "{found} {expected}");
        }
    }
    // Rising along x within the first row, and more from row to row.
    let red = |i: usize, j: usize| i32::from(colour(i, j)[0]) - i32::from(colour(i, j)[2]);
    assert!(red(0, height - 1) < red(width - 1, height - 1));
    assert!(red(width - 1, height - 1) < red(0, 0));
}

/// A map of kinds: whole cells, also the outer ones, within the axes, and a legend instead of a bar.
#[test]
fn cells_of_kinds_lie_whole_within_the_axes() {
    let nodes = vec![0.5, 1.5, 2.5, 3.5];
    let kinds = (0..16).map(|i| Some(i % 2)).collect();
    let map = Field::of_kinds(["stick", "slip"], nodes.clone(), nodes, kinds).unwrap();
    let svg = panel(map);
    let image = svg.lines().find(|line| line.starts_with("<image ")).unwrap();
    let [x, y, width, height] =
        ["x", "y", "width", "height"].map(|name| attribute(image, name).parse::<f64>().unwrap());
    let ([left, top], [right, bottom]) = (pixel(0.0, 1.0), pixel(1.0, 0.0));
    assert!(x > left + 5.0 && x + width < right - 5.0, "{image}");
    assert!(y > top + 5.0 && y + height < bottom - 5.0, "{image}");
    // The ticks of the axes tell where the cells end: at 0 and 4.
    let ticks = svg.lines().filter(|line| line.starts_with("<line ") && line.contains("#e4e4e4"));
    let stand: Vec<f64> = ticks
        .filter(|line| attribute(line, "x1") == attribute(line, "x2"))
        .map(|line| attribute(line, "x1").parse().unwrap())
        .collect();
    let (first, last) = (stand[0], stand[stand.len() - 1]);
    assert!((x - first).abs() < 0.02 && (x + width - last).abs() < 0.02, "{stand:?} {image}");
    assert!(svg.contains(">stick<") && svg.contains(">slip<"));
    assert!(!svg.contains("fill=\"none\" stroke=\"#222\""), "no lines of equal value");
}
