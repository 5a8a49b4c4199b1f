//! Reduces the size of pictures without visible change: a report contains a hundred of them.

use std::fmt::Write as _;

/// Points closer than this (pixels) to the line without them are omitted.
const MAX_DISTANCE: f64 = 0.08;

/// The picture with fewer points on its curves.
pub(crate) fn slim(svg: &str) -> String {
    let mut slim = String::with_capacity(svg.len());
    for line in svg.lines() {
        match curve(line) {
            Some(curve) => slim.push_str(&curve),
            None => slim.push_str(line),
        }
        slim.push('\n');
    }
    slim
}

/// A curve, `<polyline points="..." .../>`, with fewer points; `None` for other elements.
fn curve(line: &str) -> Option<String> {
    let (list, look) = line.strip_prefix("<polyline points=\"")?.split_once('"')?;
    let points: Option<Vec<[f64; 2]>> = list.split_whitespace().map(point).collect();
    let mut slim = "<polyline points=\"".to_owned();
    for (i, [x, y]) in thinned(&points?).into_iter().enumerate() {
        let _ = write!(slim, "{}{},{}", if i > 0 { " " } else { "" }, tenths(x), tenths(y));
    }
    Some(slim + "\"" + look)
}

fn point(pair: &str) -> Option<[f64; 2]> {
    let (x, y) = pair.split_once(',')?;
    Some([x.parse().ok()?, y.parse().ok()?])
}

fn tenths(value: f64) -> f64 {
    (10.0 * value).round() / 10.0
}

/// Douglas and Peucker's algorithm: the ends, and the points between that are needed.
fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut keep = vec![false; points.len()];
    if let [first, .., last] = keep.as_mut_slice() {
        (*first, *last) = (true, true);
    }
    let mut pieces = vec![(0, points.len().saturating_sub(1))];
    while let Some((from, to)) = pieces.pop() {
        let distance = |i: usize| distance_to_segment(points[i], points[from], points[to]);
        let farthest = (from + 1..to).max_by(|i, j| distance(*i).total_cmp(&distance(*j)));
        if let Some(middle) = farthest.filter(|i| distance(*i) > MAX_DISTANCE) {
            keep[middle] = true;
            pieces.extend([(from, middle), (middle, to)]);
        }
    }
    let kept = points.iter().zip(&keep).filter(|(_, keep)| **keep).map(|(point, _)| *point);
    if points.len() < 3 { points.to_vec() } else { kept.collect() }
}

/// Distance of a point from a line segment.
fn distance_to_segment(point: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let reach = [point[0] - from[0], point[1] - from[1]];
    let square = along[0] * along[0] + along[1] * along[1];
    let part = if square > 0.0 {
        ((reach[0] * along[0] + reach[1] * along[1]) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    libm::hypot(reach[0] - part * along[0], reach[1] - part * along[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_out_lies_on_what_stays() {
        let wave: Vec<[f64; 2]> =
            (0..=400).map(|i| [f64::from(i), 50.0 * libm::sin(f64::from(i) / 20.0)]).collect();
        let kept = thinned(&wave);
        assert!(2 * kept.len() < wave.len() && kept[0] == wave[0] && kept.last() == wave.last());
        for point in &wave {
            let nearest = kept.windows(2).map(|ends| distance_to_segment(*point, ends[0], ends[1]));
            assert!(nearest.fold(f64::INFINITY, f64::min) <= MAX_DISTANCE, "{point:?}");
        }
    }

    #[test]
    fn a_loop_that_closes_keeps_its_shape() {
        let square = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0], [0.0, 0.0]];
        assert_eq!(thinned(&square), square);
    }

    #[test]
    fn only_curves_are_touched() {
        let svg = "<svg>\n<polyline points=\"0,0 5,0.01 10.26,0 \" stroke=\"#000\"/>\n<rect x=\"0.123\"/>\n</svg>\n";
        let expected = "<svg>\n<polyline points=\"0,0 10.3,0\" stroke=\"#000\"/>\n<rect x=\"0.123\"/>\n</svg>\n";
        assert_eq!(slim(svg), expected);
    }
}
